//! The twelve functions of Glaisher's notation: pq(u) = pr(u)/qr(u), of any real u and any real m, over lanes.
//!
//! Method: Neville's theta functions as hi + lo (functions.rs), and pq = theta_p/theta_q: no rounded value is divided, and next
//! to a zero or a pole the digits are those of the reduced argument. At m = 1 all are hyperbolic functions.
//! Source: DLMF 22.2.10, 22.2.11; A&S 16.36.

use super::functions::{Jacobi, NevilleIndex, NevilleValues, TANH_IS_ONE, TINY};
use crate::elliptic::parameter::ParameterRange;
use crate::float::Dd;
use crate::float::elementary::{quotient, saturated_sinh_cosh, sech};
use crate::lanes::{Columns, Evaluation, Formula, Lane, Once};

/// The twelve: pq is the function with the zeros of ps and the poles of qs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Glaisher {
    /// sn u
    Sn,
    /// cn u
    Cn,
    /// dn u
    Dn,
    /// 1/sn u
    Ns,
    /// 1/cn u
    Nc,
    /// 1/dn u
    Nd,
    /// sn u/cn u
    Sc,
    /// cn u/sn u
    Cs,
    /// sn u/dn u
    Sd,
    /// dn u/sn u
    Ds,
    /// cn u/dn u
    Cd,
    /// dn u/cn u
    Dc,
}

/// Each with its name, and p and q of pq = theta_p/theta_q.
const TABLE: [(Glaisher, &str, [NevilleIndex; 2]); 12] = [
    (Glaisher::Sn, "sn", [NevilleIndex::S, NevilleIndex::N]),
    (Glaisher::Cn, "cn", [NevilleIndex::C, NevilleIndex::N]),
    (Glaisher::Dn, "dn", [NevilleIndex::D, NevilleIndex::N]),
    (Glaisher::Ns, "ns", [NevilleIndex::N, NevilleIndex::S]),
    (Glaisher::Nc, "nc", [NevilleIndex::N, NevilleIndex::C]),
    (Glaisher::Nd, "nd", [NevilleIndex::N, NevilleIndex::D]),
    (Glaisher::Sc, "sc", [NevilleIndex::S, NevilleIndex::C]),
    (Glaisher::Cs, "cs", [NevilleIndex::C, NevilleIndex::S]),
    (Glaisher::Sd, "sd", [NevilleIndex::S, NevilleIndex::D]),
    (Glaisher::Ds, "ds", [NevilleIndex::D, NevilleIndex::S]),
    (Glaisher::Cd, "cd", [NevilleIndex::C, NevilleIndex::D]),
    (Glaisher::Dc, "dc", [NevilleIndex::D, NevilleIndex::C]),
];

impl Glaisher {
    /// All of them.
    pub const ALL: [Glaisher; 12] = {
        let mut all = [Glaisher::Sn; 12];
        let mut i = 0;
        while i < all.len() {
            all[i] = TABLE[i].0;
            i += 1;
        }
        all
    };
    /// Its name of two letters, p and q.
    #[must_use]
    pub const fn name(self) -> &'static str {
        TABLE[self as usize].1
    }
    /// p and q of pq = theta_p/theta_q.
    pub(crate) const fn pq(self) -> [NevilleIndex; 2] {
        TABLE[self as usize].2
    }
    /// The other two of the four theta functions: those of the derivative, DLMF 22.13(i).
    pub(crate) fn others(self) -> [NevilleIndex; 2] {
        use NevilleIndex::{C, D, N, S};
        let (mut others, mut found) = ([S; 2], 0);
        for index in [S, C, D, N] {
            if !self.pq().contains(&index) {
                others[found] = index;
                found += 1;
            }
        }
        others
    }
}

impl Jacobi {
    /// pq(u) for p, q among s, c, d, n.
    ///
    /// | argument | domain |
    /// |---|---|
    /// | `which` | the function |
    /// | `u` | any; infinite u gives the limits at m = 1, NaN elsewhere, as more than 2^100 half periods do |
    ///
    /// At an exact pole the infinity of 1/+-0: ns(-0) = -inf.
    ///
    /// **Error** at most 3 ulp (plus 2^-100 of the condition in u), also next to zeros and poles.
    ///
    /// **Source** DLMF 22.2.10.
    ///
    /// ```
    /// use libration::{Glaisher, Jacobi, Parameter};
    /// let jacobi = Jacobi::new(Parameter::from_m(0.5));
    /// assert_eq!(format!("{:.12}", jacobi.glaisher(Glaisher::Sc, 1.0)), "1.347371471385");
    /// ```
    #[must_use]
    pub fn glaisher(&self, which: Glaisher, u: f64) -> f64 {
        let [value] = self.evaluate_glaisher(which, Once([u]));
        value
    }

    /// [`Jacobi::glaisher`] of every u, bit for bit, on the widest lanes.
    ///
    /// # Panics
    /// Where the lengths differ.
    pub fn glaisher_into(&self, which: Glaisher, u: &[f64], out: &mut [f64]) {
        self.evaluate_glaisher(which, Columns::new([u], [out]));
    }

    /// Chooses the formula.
    fn evaluate_glaisher<E: Evaluation<1, 1>>(&self, which: Glaisher, evaluation: E) -> E::Output {
        let pq = which.pq();
        if self.range == ParameterRange::One {
            evaluation.of(&HyperbolicQuotient(pq))
        } else if self.neville.hyperbolic() {
            evaluation.of(&NevilleQuotient::<true>(self, pq))
        } else {
            evaluation.of(&NevilleQuotient::<false>(self, pq))
        }
    }
}

/// Next to 0 the odd functions are u or 1/u, also where the phase would be subnormal.
#[inline(always)]
fn odd<L: Lane>([p, q]: [NevilleIndex; 2], u: L, value: L) -> L {
    let tiny = u.abs().less(L::splat(TINY));
    if p == NevilleIndex::S {
        L::select(tiny, u, value)
    } else if q == NevilleIndex::S {
        L::select(tiny, L::splat(1.0) / u, value)
    } else {
        value
    }
}

/// theta_p/theta_q, next to 0, too; NaN where the parameter is.
#[inline(always)]
pub(super) fn quotient_at<L: Lane>(pq: [NevilleIndex; 2], u: L, values: &NevilleValues<Dd<L>, L>) -> L {
    let unit = values.n.hi;
    L::select(unit.equal(unit), odd(pq, u, values.quotient(pq)), unit)
}

/// m < 1 or m > 1.
struct NevilleQuotient<'a, const HYPERBOLIC: bool>(&'a Jacobi, [NevilleIndex; 2]);

impl<const HYPERBOLIC: bool> Formula<1, 1> for NevilleQuotient<'_, HYPERBOLIC> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [u]: [L; 1]) -> [L; 1] {
        let (_, values) = self.0.neville_values::<HYPERBOLIC, L>(u);
        [quotient_at(self.1, u, &values)]
    }
}

/// m = 1.
pub(super) struct HyperbolicQuotient(pub [NevilleIndex; 2]);

impl Formula<1, 1> for HyperbolicQuotient {
    type Place = Self;
    /// tanh, sech and their quotients: from sinh and cosh where both matter, from e^-u where the range ends.
    #[inline(always)]
    fn at<L: Lane>(&self, [u]: [L; 1]) -> [L; 1] {
        use NevilleIndex::{C, D, N, S};
        let sign = L::splat(1.0).copysign(u);
        let y = Dd::from_double(u.abs());
        let one = L::splat(1.0);
        let near = y.hi.less(L::splat(TANH_IS_ONE));
        let (sinh, cosh) = saturated_sinh_cosh(y);
        let unit = Dd::from_double(one);
        let (factor, power) = sech(y);
        let falling = factor.value() * power;
        let growing = quotient(unit, factor).value() / power;
        let value = match self.0 {
            [S, N] => quotient(sinh, cosh).value() * sign,
            [N, S] => quotient(cosh, sinh).value() * sign,
            [C | D, N] => falling,
            [N, C | D] => growing,
            [S, C | D] => L::select(near, sinh.value(), growing) * sign,
            [C | D, S] => L::select(near, quotient(unit, sinh).value(), falling) * sign,
            _ => L::select(u.equal(u), one, u),
        };
        [odd(self.0, u, value)]
    }
}

//! The twelve functions of Glaisher's notation: pq(u) = pr(u)/qr(u), of any real u and any real m, over lanes.
//!
//! Method: sn : cn : dn : 1 are four theta functions as hi + lo (jacobi.rs), and pq is the quotient of two of them: no
//! rounded value is divided, and next to a zero or a pole the digits are those of the reduced argument.
//! At m = 1 all are hyperbolic functions. Source: DLMF 22.2.10, 22.2.11.

use super::functions::{Jacobi, Range, Ratio, TINY};
use crate::float::Dd;
use crate::float::elementary::{quotient, saturated_sinh_cosh, sech};
use crate::lanes::{Formula, Lane, tabulate};

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

/// sn, cn, dn and 1: what stands above and below.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Letter {
    S,
    C,
    D,
    N,
}

impl Glaisher {
    /// All of them.
    pub const ALL: [Glaisher; 12] = [
        Glaisher::Sn,
        Glaisher::Cn,
        Glaisher::Dn,
        Glaisher::Ns,
        Glaisher::Nc,
        Glaisher::Nd,
        Glaisher::Sc,
        Glaisher::Cs,
        Glaisher::Sd,
        Glaisher::Ds,
        Glaisher::Cd,
        Glaisher::Dc,
    ];
    /// Its two letters.
    pub const fn name(self) -> &'static str {
        match self {
            Glaisher::Sn => "sn",
            Glaisher::Cn => "cn",
            Glaisher::Dn => "dn",
            Glaisher::Ns => "ns",
            Glaisher::Nc => "nc",
            Glaisher::Nd => "nd",
            Glaisher::Sc => "sc",
            Glaisher::Cs => "cs",
            Glaisher::Sd => "sd",
            Glaisher::Ds => "ds",
            Glaisher::Cd => "cd",
            Glaisher::Dc => "dc",
        }
    }
    pub(crate) const fn letters(self) -> [Letter; 2] {
        use Letter::{C, D, N, S};
        match self {
            Glaisher::Sn => [S, N],
            Glaisher::Cn => [C, N],
            Glaisher::Dn => [D, N],
            Glaisher::Ns => [N, S],
            Glaisher::Nc => [N, C],
            Glaisher::Nd => [N, D],
            Glaisher::Sc => [S, C],
            Glaisher::Cs => [C, S],
            Glaisher::Sd => [S, D],
            Glaisher::Ds => [D, S],
            Glaisher::Cd => [C, D],
            Glaisher::Dc => [D, C],
        }
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
    pub fn glaisher(&self, which: Glaisher, u: f64) -> f64 {
        let mut value = [0.0];
        Fill { jacobi: self, which, u: &[u], result: &mut value }.run::<false>();
        value[0]
    }

    /// [`Jacobi::glaisher`] of every u, bit for bit, on the widest lanes; panics where the lengths differ.
    pub fn glaisher_into(&self, which: Glaisher, u: &[f64], out: &mut [f64]) {
        assert!(out.len() == u.len(), "results of another length than the arguments");
        Fill { jacobi: self, which, u, result: out }.run::<true>();
    }
}

/// Next to 0 the odd functions are u or 1/u, also where the phase would be subnormal.
#[inline(always)]
fn odd<L: Lane>([above, below]: [Letter; 2], u: L, value: L) -> L {
    let tiny = u.abs().less(L::splat(TINY));
    if above == Letter::S {
        L::select(tiny, u, value)
    } else if below == Letter::S {
        L::select(tiny, L::splat(1.0) / u, value)
    } else {
        value
    }
}

struct Doubly<'a, const HYPERBOLIC: bool>(&'a Jacobi, [Letter; 2]);

impl<const HYPERBOLIC: bool> Formula<1, 1> for Doubly<'_, HYPERBOLIC> {
    #[inline(always)]
    fn at<L: Lane>(&self, [u]: [L; 1]) -> [L; 1] {
        let (_, ratio) = self.0.ratio::<HYPERBOLIC, L>(u);
        let (above, above_sign) = part(&ratio, self.1[0]);
        let (below, below_sign) = part(&ratio, self.1[1]);
        let value = quotient(above, below).value();
        // An exact zero below: the quotient's remainder would be infinity minus infinity.
        let value = L::select(below.hi.equal(L::splat(0.0)), above.hi / below.hi, value);
        [odd(self.1, u, value * (above_sign * below_sign))]
    }
}

#[inline(always)]
fn part<L: Lane>(ratio: &Ratio<L>, letter: Letter) -> (Dd<L>, L) {
    match letter {
        Letter::S => (ratio.sn, ratio.signs[0]),
        Letter::C => (ratio.cn, ratio.signs[1]),
        Letter::D => (ratio.dn, ratio.signs[2]),
        Letter::N => (ratio.one, L::splat(1.0)),
    }
}

struct Singly([Letter; 2]);

/// Where tanh is 1 to a double-double, and sinh is cosh.
const LEVEL: f64 = 40.0;

impl Formula<1, 1> for Singly {
    /// tanh, sech and their quotients: from sinh and cosh where both matter, from e^-u where the range ends.
    #[inline(always)]
    fn at<L: Lane>(&self, [u]: [L; 1]) -> [L; 1] {
        use Letter::{C, D, N, S};
        let sign = L::splat(1.0).copysign(u);
        let y = Dd::from_double(u.abs());
        let one = L::splat(1.0);
        let near = y.hi.less(L::splat(LEVEL));
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

/// Arguments into a slice of results of the same length.
struct Fill<'a, 'b> {
    jacobi: &'a Jacobi,
    which: Glaisher,
    u: &'a [f64],
    result: &'b mut [f64],
}

impl Fill<'_, '_> {
    fn run<const WIDE: bool>(self) {
        let Fill { jacobi, which, u, result } = self;
        let letters = which.letters();
        if jacobi.range == Range::One {
            tabulate::<WIDE, _, _, _, _>(&Singly(letters), [u], &mut [result]);
        } else if jacobi.lattice.hyperbolic() {
            tabulate::<WIDE, _, _, _, _>(&Doubly::<true>(jacobi, letters), [u], &mut [result]);
        } else {
            tabulate::<WIDE, _, _, _, _>(&Doubly::<false>(jacobi, letters), [u], &mut [result]);
        }
    }
}

//! Jacobi's sn, cn, dn and the unwrapped amplitude am, together, for any real u and any real m.
//!
//! Method: quotients of Neville's theta functions of a parameter in [0, 1], as hi + lo. For m < 0 the parameter is
//! -m/(1 - m): theta3 and theta4 change places, A becomes k' A and k' its inverse. For m > 1 it is 1/m: cn and dn change
//! places. Source: DLMF 22.2, 22.16(i), 22.17; A&S 16.36.

use crate::elliptic::parameter::{Parameter, ParameterRange, Unit};
use crate::elliptic::phase::Phase;
use crate::elliptic::theta::neville::{NevilleTheta, Thetas};
use crate::float::elementary::{arctangent, quotient, saturated_sinh_cosh, sech};
use crate::float::series::long_sinh_cosh;
use crate::float::{Dd, PI, Scaled};
use crate::lanes::{Columns, Evaluation, Formula, Lane, Once};
use core::ops::Mul;

/// sn, cn, dn, am of one parameter, set up once.
///
/// ```
/// use libration::{Jacobi, JacobiValues, Parameter};
/// let JacobiValues { sn, cn, dn, am, .. } = Jacobi::new(Parameter::from_m(0.5)).values(1.0);
/// assert_eq!(format!("{sn:.12} {cn:.12} {dn:.12} {am:.12}"),
///            "0.803001824896 0.595976567672 0.823161001632 0.932315079884");
/// ```
#[derive(Clone, Debug)]
pub struct Jacobi {
    pub(super) range: ParameterRange,
    pub(crate) neville: NevilleTheta,
    pub(crate) phase: Phase,
    /// The factor of theta1 in theta_s, and in theta_c counted from K.
    theta1_factors: [Dd; 2],
    /// The factor of theta_d counted from K: the complementary modulus.
    kc: Dd,
    /// Modulus of the parameter in [0, 1]: 1/k of the given one for m > 1.
    unit_modulus: Dd,
    /// sn u / u at 0.
    slope: Dd,
}

/// The values of Jacobi's functions at one u.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct JacobiValues {
    /// sn(u | m)
    pub sn: f64,
    /// cn(u | m)
    pub cn: f64,
    /// dn(u | m)
    pub dn: f64,
    /// The amplitude am(u | m).
    pub am: f64,
}

/// An index of Neville's theta functions: each of Glaisher's functions is pq = theta_p/theta_q.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum NevilleIndex {
    S,
    C,
    D,
    N,
}

/// Neville's theta functions at one argument up to a common factor: |sn| : |cn| : |dn| : 1 = s : c : d : n. The signs of
/// the first three stand apart.
pub(crate) struct NevilleValues<T, S> {
    pub s: T,
    pub c: T,
    pub d: T,
    pub n: T,
    pub signs: [S; 3],
}

impl<L: Lane> NevilleValues<Dd<L>, L> {
    /// One of them and its sign.
    #[inline(always)]
    pub fn theta(&self, index: NevilleIndex) -> (Dd<L>, L) {
        match index {
            NevilleIndex::S => (self.s, self.signs[0]),
            NevilleIndex::C => (self.c, self.signs[1]),
            NevilleIndex::D => (self.d, self.signs[2]),
            NevilleIndex::N => (self.n, L::splat(1.0)),
        }
    }
    /// pq = theta_p/theta_q.
    #[inline(always)]
    pub fn quotient(&self, [p, q]: [NevilleIndex; 2]) -> L {
        let ((above, above_sign), (below, below_sign)) = (self.theta(p), self.theta(q));
        let value = quotient(above, below).value();
        // An exact zero below: the quotient's remainder would be infinity minus infinity.
        let value = L::select(below.hi.equal(L::splat(0.0)), above.hi / below.hi, value);
        value * (above_sign * below_sign)
    }
}

impl Jacobi {
    /// Sets up one parameter.
    #[must_use]
    pub fn new(parameter: Parameter) -> Jacobi {
        Jacobi::with_range(parameter.range(), parameter.unit(), parameter.argument_factor())
    }

    /// The functions of factor * u with a parameter in [0, 1], as they are.
    pub(crate) fn of_unit(unit: Unit, factor: Dd) -> Jacobi {
        let range = if unit.mc.hi == 0.0 { ParameterRange::One } else { ParameterRange::BelowOne };
        Jacobi { slope: factor, ..Jacobi::with_range(range, unit, factor) }
    }

    /// Half periods per unit of u: the factor times 1/2K.
    fn with_range(range: ParameterRange, unit: Unit, factor: Dd) -> Jacobi {
        let unit = if range == ParameterRange::One { Unit::ZERO } else { unit };
        let neville = NevilleTheta::new(unit);
        let (a, kc) = match range {
            ParameterRange::Negative => (neville.theta1_factor * unit.kc, Dd::ONE / unit.kc),
            _ => (neville.theta1_factor, unit.kc),
        };
        let rate = (factor / neville.quarter).scale(0.5);
        let phase = Phase { rate, start: Dd::ZERO };
        let theta1_factors = [a, a * kc];
        Jacobi { range, neville, phase, theta1_factors, kc, unit_modulus: unit.k, slope: Dd::ONE }
    }

    /// sn, cn, dn and am at u.
    ///
    /// am = int_0^u dn: it grows by pi per 2K for m < 1, is the Gudermannian function at m = 1, and stays within its turning
    /// points for m > 1.
    ///
    /// | argument | domain |
    /// |---|---|
    /// | `u` | any; infinite u gives the limits at m = 1, NaN elsewhere, as more than 2^100 half periods do |
    ///
    /// **Error** at most 3 ulp (plus 2^-100 of the condition in u).
    ///
    /// **Source** DLMF 22.2.4 to 22.2.8, 22.16.1, 22.17.
    #[must_use]
    pub fn values(&self, u: f64) -> JacobiValues {
        let [sn, cn, dn, am] = self.evaluate(Once([u]));
        JacobiValues { sn, cn, dn, am }
    }

    /// [`Jacobi::values`] of every u, bit for bit, on the widest lanes, into sn, cn, dn and am.
    ///
    /// # Panics
    /// Where the lengths differ.
    pub fn values_into(&self, u: &[f64], results: [&mut [f64]; 4]) {
        self.evaluate(Columns::new([u], results));
    }

    /// Chooses the formula.
    fn evaluate<E: Evaluation<1, 4>>(&self, evaluation: E) -> E::Output {
        if self.range == ParameterRange::One {
            evaluation.of(&HyperbolicLimit)
        } else if self.neville.by_hyperbolic() {
            evaluation.of(&DoublyPeriodic::<true>(self))
        } else {
            evaluation.of(&DoublyPeriodic::<false>(self))
        }
    }

    /// The nearest whole number of half periods, and Neville's theta functions at u.
    #[inline(always)]
    pub(crate) fn neville_values<const HYPERBOLIC: bool, L: Lane>(
        &self,
        u: L,
    ) -> (Dd<L>, NevilleValues<Dd<L>, L>) {
        let at = self.phase.spread::<L>().reduce(u);
        let thetas = self.neville.thetas_on::<HYPERBOLIC, L>(at.f);
        let folded = thetas.folded;
        let [t1, t2, t3, t4] = thetas.theta;
        let (t3, t4) = if self.range == ParameterRange::Negative { (t4, t3) } else { (t3, t4) };
        let s = Dd::select(folded, t2, t1 * Dd::splat(self.theta1_factors[0]));
        let c = Dd::select(folded, t1 * Dd::splat(self.theta1_factors[1]), t2);
        let d = Dd::select(folded, t4 * Dd::splat(self.kc), t3);
        let n = Dd::select(folded, t3, t4);
        let signs = [at.parity * at.sign, at.parity, L::splat(1.0)];
        (at.n, self.arranged([s, c, d, n], Dd::splat(self.unit_modulus), signs))
    }

    /// Theta functions of the parameter in [0, 1], with the modulus of that, as those of the given one.
    #[inline(always)]
    fn arranged<T: Mul<Output = T>, S>(
        &self,
        [s, c, d, n]: [T; 4],
        unit_modulus: T,
        [odd, parity, positive]: [S; 3],
    ) -> NevilleValues<T, S> {
        if self.range == ParameterRange::AboveOne {
            NevilleValues { s: s * unit_modulus, c: d, d: c, n, signs: [odd, positive, parity] }
        } else {
            NevilleValues { s, c, d, n, signs: [odd, parity, positive] }
        }
    }
}

/// Where e^-2u no longer counts beside 1 in a double-double: tanh is 1, and sinh is cosh.
pub(super) const TANH_IS_ONE: f64 = 40.0;

impl Jacobi {
    /// The nearest whole number of half periods, and Neville's theta functions at u to 2^-60 and of any size, for what must not
    /// round on the way.
    pub(super) fn scaled_neville_values(&self, u: f64) -> (Dd, NevilleValues<Scaled, f64>) {
        let sign = f64::copysign(1.0, u);
        if u.abs() < TINY {
            let s = Scaled::from(self.slope) * u.abs();
            let one = Scaled::ONE;
            return (Dd::ZERO, NevilleValues { s, c: one, d: one, n: one, signs: [sign, 1.0, 1.0] });
        }
        if self.range == ParameterRange::One {
            let y = self.slope * u.abs();
            let (s, c, n) = if y.hi < TANH_IS_ONE {
                let (sinh, cosh) = long_sinh_cosh(y);
                (sinh.into(), Scaled::ONE, cosh.into())
            } else {
                (Scaled::ONE, Scaled::exp(-y).shift(1), Scaled::ONE)
            };
            return (Dd::ZERO, NevilleValues { s, c, d: c, n, signs: [sign, 1.0, 1.0] });
        }
        let mut at = self.phase.reduce(u);
        let beyond = at.f - Dd::from(0.5);
        if beyond.hi > 0.0 {
            // The rest may pass 1/2 by a rounding error: counted from the other side cn is not negative.
            at.n = at.n + Dd::from(at.sign);
            at.f = Dd::from(0.5) - beyond;
            (at.sign, at.parity) = (-at.sign, -at.parity);
        }
        let Thetas { theta: [t1, t2, t3, t4], folded } = self.neville.long_thetas(at.f);
        let (t3, t4) = if self.range == ParameterRange::Negative { (t4, t3) } else { (t3, t4) };
        let theta = if folded {
            [t2, t1 * self.theta1_factors[1], t4 * self.kc, t3]
        } else {
            [t1 * self.theta1_factors[0], t2, t3, t4]
        };
        let signs = [at.parity * at.sign, at.parity, 1.0];
        (at.n, self.arranged(theta.map(Scaled::from), self.unit_modulus.into(), signs))
    }
}

/// Below, sn and am are u for every finite m, to a double-double.
pub(super) const TINY: f64 = 1e-290;

/// Where u^2 counts no more sn and am are u, down to the sign of zero; NaN stays NaN.
#[inline(always)]
pub(super) fn odd<L: Lane>(u: L, [sn, cn, dn, am]: [L; 4]) -> [L; 4] {
    let tiny = u.abs().less(L::splat(TINY));
    let zero = L::splat(0.0);
    // No closure: it would be compiled without the instruction set.
    let (of_sn, of_am) = (u - sn.abs() * zero, u - am.abs() * zero);
    [L::select(tiny, of_sn, sn), cn, dn, L::select(tiny, of_am, am)]
}

/// m < 1 or m > 1.
struct DoublyPeriodic<'a, const HYPERBOLIC: bool>(&'a Jacobi);

impl<const HYPERBOLIC: bool> Formula<1, 4> for DoublyPeriodic<'_, HYPERBOLIC> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [u]: [L; 1]) -> [L; 4] {
        let jacobi = self.0;
        let (half_periods, NevilleValues { s, c, d, n, signs }) = jacobi.neville_values::<HYPERBOLIC, L>(u);
        let am = if jacobi.range == ParameterRange::AboveOne {
            arctangent(s, c).value() * signs[0]
        } else {
            // The sign of the rest: that of sn without the parity, which is the sign of cn.
            let within = arctangent(s, c).scale(signs[0] * signs[1]);
            let turned = half_periods * Dd::splat(PI);
            (turned + within).value()
        };
        let sn = quotient(s, n).value() * signs[0];
        let cn = quotient(c, n).value() * signs[1];
        let dn = quotient(d, n).value() * signs[2];
        odd(u, [sn, cn, dn, am])
    }
}

/// m = 1.
pub(super) struct HyperbolicLimit;

impl Formula<1, 4> for HyperbolicLimit {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [u]: [L; 1]) -> [L; 4] {
        let sign = L::splat(1.0).copysign(u);
        let y = Dd::from_double(u.abs());
        let (sinh, cosh) = saturated_sinh_cosh(y);
        let (factor, power) = sech(y);
        let falling = factor.value() * power;
        let am = arctangent(sinh, Dd::from_double(L::splat(1.0)));
        odd(u, [quotient(sinh, cosh).value() * sign, falling, falling, am.value() * sign])
    }
}

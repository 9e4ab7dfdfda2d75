//! Pi, complete and incomplete, and Heuman's lambda over lanes, for 0 < mc <= 1e60 (lambda: 0 <= m < 1).
//!
//! Method: the formulas of third_kind.rs and heuman_lambda.rs, by one R_F and one R_J of the same x, y, z and, for n < 0, one
//! R_C, every term to two words. With s, c the sine and cosine of the reduced amplitude Pi is
//!   s (first R_F(c^2, d, 1) + third s^2 R_J(c^2, d, 1, c^2 + weight s^2)/3 + last c R_C(d, ...)), and complete at s = 1, c = 0.
//! NaN where it does not hold: n s^2 beyond 7/8 for n > 1 (complete: n = 1), arguments of R_J next to 0 or beyond 1e60.

use super::duplication_lanes::{LARGEST, LEAST};
use super::incomplete_lanes::{Amplitude, delta_square, gathered, inside, only_where};
use super::rc_lanes::rc;
use super::rj_lanes::rf_and_rj;
use crate::float::Dd;
use crate::float::constants::TWO_OVER_PI;
use crate::float::elementary::quotient;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Formula, Lane};

/// The factors of one characteristic.
struct Factors<L: Lane> {
    negative: L::Mask,
    nc: Dd<L>,
    first: Dd<L>,
    third: Dd<L>,
    last: Dd<L>,
    weight: Dd<L>,
}

impl<L: Lane> Factors<L> {
    /// For n < 0 first = 1/(1 - n), last = -n/(1 - n), weight = mc/(1 - n), third = last weight; for n >= 0 they are 1, 0,
    /// 1 - n, n.
    #[inline(always)]
    fn new(n: L, mc: Dd<L>) -> Self {
        let (zero, one) = (Dd::from_double(L::splat(0.0)), Dd::from_double(L::splat(1.0)));
        let nc = Dd::sum(one.hi, -n);
        let negative = n.less(zero.hi);
        let mut factors =
            Factors { negative, nc, first: one, third: Dd::from_double(n), last: zero, weight: nc };
        if L::any(negative) {
            let first = quotient(one, nc);
            let (last, weight) = (first * -n, first * mc);
            factors.first = Dd::select(negative, first, factors.first);
            factors.third = Dd::select(negative, last * weight, factors.third);
            factors.last = Dd::select(negative, last, zero);
            factors.weight = Dd::select(negative, weight, factors.weight);
        }
        factors
    }
    /// The sum at s^2, c, c^2 and d = 1 - m s^2, over s.
    #[inline(always)]
    fn over_sine(&self, square: Dd<L>, cosine: Dd<L>, x: Dd<L>, d: Dd<L>) -> Dd<L> {
        let mut p = delta_square(self.weight, square, x);
        p.hi = only_where(L::splat(LEAST).less(p.hi), only_where(p.hi.less(L::splat(LARGEST)), p.hi));
        let (first, third) = rf_and_rj([x, d, Dd::from_double(L::splat(1.0))], p);
        let sum = (self.first * first).plain_sum(self.third * square * third);
        if !L::any(self.negative) {
            return sum;
        }
        let other = delta_square(self.nc, square, x) * p;
        let elementary = self.last * (cosine * rc(d, Dd::select(self.negative, other, d)));
        Dd::select(self.negative, sum.plain_sum(elementary), sum)
    }
}

/// mc within the bounds, else NaN.
#[inline(always)]
fn bounded<L: Lane>(mc: Dd<L>) -> Dd<L> {
    let hi = only_where(mc.hi.less(L::splat(LARGEST)), mc.hi);
    Dd::new(only_where(L::splat(LEAST).less(hi), hi), mc.lo)
}

/// Pi of n, m.hi, m.lo, mc.hi, mc.lo.
pub(crate) struct CompletePi;

impl Formula<5, 1> for CompletePi {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [n, m, m_rest, mc, mc_rest]: [L; 5]) -> [L; 1] {
        let (zero, one) = (Dd::from_double(L::splat(0.0)), Dd::from_double(L::splat(1.0)));
        let mc = bounded(Dd::new(mc, mc_rest));
        let mut factors = Factors::new(only_where(n.abs().less(L::splat(LARGEST)), n), mc);
        let large = one.hi.less(n);
        if L::any(large) {
            // -m/n R_J(0, mc, 1, (n - m)/n)/3 with n - m = mc - (1 - n); of an m next to 0 nothing is left.
            let inverse = quotient(one, Dd::from_double(n));
            let m = Dd::new(only_where(L::splat(1e-250).less(m.abs()), m), m_rest);
            factors.first = Dd::select(large, zero, factors.first);
            factors.third = Dd::select(large, -(m * inverse), factors.third);
            let weight = (mc - factors.nc) * inverse;
            factors.weight = Dd::select(large, weight, factors.weight);
        }
        [factors.over_sine(one, zero, zero, mc).value()]
    }
}

/// Pi of n, phi, m.hi, m.lo, mc.hi, mc.lo.
pub(crate) struct IncompletePi;

impl Formula<6, 1> for IncompletePi {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [n, phi, _, _, mc, mc_rest]: [L; 6]) -> [L; 1] {
        let (zero, one) = (Dd::from_double(L::splat(0.0)), Dd::from_double(L::splat(1.0)));
        let mc = Dd::new(only_where(L::splat(-1e-300).less(mc), mc), mc_rest);
        let factors = Factors::new(only_where(n.abs().less(L::splat(LARGEST)), n), mc);
        let amplitude = Amplitude::new(inside(phi, mc.hi));
        let (mut sine, mut cosine) = (amplitude.sine, amplitude.cosine);
        let (mut square, mut x) = (sine.square(), cosine.square());
        // For n > 1 the sum 1 - n s^2 may cancel.
        let cancels = delta_square(factors.nc, square, x).hi.less(L::splat(0.125));
        let cancels = L::select(one.hi.less(n), L::select(cancels, one.hi, zero.hi), zero.hi);
        sine.hi = only_where(cancels.equal(zero.hi), sine.hi);
        let mut d = delta_square(mc, square, x);
        let around = zero.hi.less(amplitude.j);
        let mut values = [zero; 2];
        let mut pass = 0;
        loop {
            values[pass] = sine * factors.over_sine(square, cosine, x, d);
            if pass == 1 || !L::any(around) {
                break;
            }
            let end = only_where(L::splat(LEAST).less(mc.hi), only_where(n.less(one.hi), mc.hi));
            (sine, cosine, square, x) = (one, zero, one, zero);
            d = Dd::select(around, Dd::new(end, mc.lo), one);
            pass = 1;
        }
        [gathered(phi, &amplitude, values[0], values[1])]
    }
}

/// Heuman's lambda of phi, m.hi, m.lo, mc.hi, mc.lo.
pub(crate) struct HeumanLambda;

impl Formula<5, 1> for HeumanLambda {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [phi, m, m_rest, mc, mc_rest]: [L; 5]) -> [L; 1] {
        let (zero, one) = (Dd::from_double(L::splat(0.0)), Dd::from_double(L::splat(1.0)));
        let m = Dd::new(only_where(L::splat(-1e-300).less(m), m), m_rest);
        let mc = bounded(Dd::new(mc, mc_rest));
        let amplitude = Amplitude::new(inside(phi, mc.hi));
        let (mut sine, cosine) = (amplitude.sine, amplitude.cosine);
        // Its products with mc keep their errors.
        sine.hi = only_where(L::splat(1e-200).less(sine.hi), sine.hi);
        let square = cosine.square();
        let e = delta_square(m, sine.square(), square);
        let inverse = quotient(one, e);
        let root = Unnormalised::from(e).root().tight();
        let (first, third) = rf_and_rj([zero, mc, one], mc * square * inverse);
        let sum = first.plain_sum(m * inverse * third);
        let factor = Dd::splat(TWO_OVER_PI) * mc * quotient(sine * cosine, root);
        [gathered(phi, &amplitude, factor * sum, one)]
    }
}

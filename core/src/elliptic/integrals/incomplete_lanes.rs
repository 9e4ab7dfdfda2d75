//! F(phi | m) and E(phi | m) over lanes.
//!
//! Method: |phi| = j pi + r; with s, c the sine and cosine of r, x = c^2 and y = c^2 + mc s^2, the integral up to r is
//! s R_F(x, y, 1); for 0 <= m <= 1 s (mc (R_F + m s^2/3 R_D(x, 1, y)) + m c/sqrt y), for m < 0 s (R_F - m s^2/3 R_D(x, y, 1)).
//! Every term is positive and carries what its rounding left. The j half turns add 2 j K or 2 j E, the same formula at pi/2.
//! NaN where it does not hold: m > 1 but for F where y is not next to 0, mc beyond 1e60, and next to 0 beyond pi/2.
//! Source: DLMF 19.25.5, 19.25.9, 19.25.10.

use super::duplication_lanes::{LARGEST, LEAST, rf, rf_and_rd};
use crate::float::angle_reduction::{FAR, half_turns};
use crate::float::double_double::two_sum;
use crate::float::elementary::sin_cos;
use crate::float::{Dd, HALF_PI};
use crate::lanes::{Formula, Lane};

/// |phi| = j pi + sign r, 0 <= r <= pi/2, with the sine and cosine of r.
pub(crate) struct Amplitude<L> {
    pub j: L,
    pub sign: L,
    pub sine: Dd<L>,
    pub cosine: Dd<L>,
}

impl<L: Lane> Amplitude<L> {
    /// Of |phi| below FAR.
    #[inline(always)]
    pub fn new(phi: L) -> Self {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let (j, rest) = half_turns(phi.abs());
        let sign = one.copysign(rest.hi);
        let r = rest.scale(sign);
        let steep = L::splat(core::f64::consts::FRAC_PI_4).less(r.hi);
        let (hi, error) = two_sum(L::splat(HALF_PI.hi), -r.hi);
        let other = Dd::ordered_sum(hi, error + (L::splat(HALF_PI.lo) - r.lo));
        // r may be a rounding error beyond pi/2: then it is pi less it, and a half turn more.
        let beyond = other.hi.less(zero);
        let other = Dd::select(beyond, -other, other);
        let (sine, cosine) = sin_cos(Dd::select(steep, other, r));
        Amplitude {
            j: L::select(beyond, j + sign, j),
            sign: L::select(beyond, -sign, sign),
            sine: Dd::select(steep, cosine, sine),
            cosine: Dd::select(steep, sine, cosine),
        }
    }
}

/// The part up to r and j times twice the complete integral, with the sign of phi.
#[inline(always)]
pub(crate) fn gathered<L: Lane>(phi: L, amplitude: &Amplitude<L>, part: Dd<L>, complete: Dd<L>) -> L {
    let part = part.scale(amplitude.sign);
    let twice = amplitude.j + amplitude.j;
    let (turns, turns_error) = complete.hi.two_product_in_range(twice);
    let (hi, error) = two_sum(turns, part.hi);
    let value = hi + (error + (part.lo + complete.lo.mul_add(twice, turns_error)));
    value.abs().copysign(phi)
}

/// `value` where the mask holds, else NaN.
#[inline(always)]
pub(crate) fn only_where<L: Lane>(mask: L::Mask, value: L) -> L {
    L::select(mask, value, L::splat(f64::NAN))
}

/// 1 - m s^2 as c^2 + mc s^2.
#[inline(always)]
pub(crate) fn delta_square<L: Lane>(mc: Dd<L>, sine_square: Dd<L>, cosine_square: Dd<L>) -> Dd<L> {
    cosine_square.plain_sum(mc * sine_square)
}

/// phi where F or E holds there.
#[inline(always)]
pub(crate) fn inside<L: Lane>(phi: L, mc: L) -> L {
    let phi = only_where(phi.abs().less(L::splat(FAR)), phi);
    only_where(mc.abs().less(L::splat(LARGEST)), phi)
}

/// F of phi, m.hi, m.lo, mc.hi, mc.lo.
pub(crate) struct IncompleteF;

impl Formula<5, 1> for IncompleteF {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [phi, _, _, mc, mc_rest]: [L; 5]) -> [L; 1] {
        let (zero, one) = (Dd::from_double(L::splat(0.0)), Dd::from_double(L::splat(1.0)));
        let mc = Dd::new(mc, mc_rest);
        let amplitude = Amplitude::new(inside(phi, mc.hi));
        let mut x = amplitude.cosine.square();
        let mut y = delta_square(mc, amplitude.sine.square(), x);
        // For m > 1 the sum may cancel.
        y.hi = only_where((x.hi * L::splat(0.125)).less(y.hi), y.hi);
        let mut factor = amplitude.sine;
        let around = L::splat(0.0).less(amplitude.j);
        let mut values = [zero; 2];
        let mut pass = 0;
        loop {
            values[pass] = rf([x, y, one]) * factor;
            if pass == 1 || !L::any(around) {
                break;
            }
            // The complete integral, of the rows that have half turns.
            let end = only_where(L::splat(LEAST).less(mc.hi), mc.hi);
            x = zero;
            y = Dd::select(around, Dd::new(end, mc.lo), one);
            factor = one;
            pass = 1;
        }
        [gathered(phi, &amplitude, values[0], values[1])]
    }
}

/// E of phi, m.hi, m.lo, mc.hi, mc.lo.
pub(crate) struct IncompleteE;

impl Formula<5, 1> for IncompleteE {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [phi, m, m_rest, mc, mc_rest]: [L; 5]) -> [L; 1] {
        let (zero, one) = (Dd::from_double(L::splat(0.0)), Dd::from_double(L::splat(1.0)));
        let (m, mc) = (Dd::new(m, m_rest), Dd::new(mc, mc_rest));
        let negative = m.hi.less(L::splat(0.0));
        let held = only_where(m.hi.less(L::splat(1.0 + f64::EPSILON)), inside(phi, mc.hi));
        let amplitude = Amplitude::new(only_where(L::splat(-1e-300).less(mc.hi), held));
        let (mut sine, mut cosine) = (amplitude.sine, amplitude.cosine);
        let (mut square, mut x) = (sine.square(), cosine.square());
        let mut y = delta_square(mc, square, x);
        let around = L::splat(0.0).less(amplitude.j);
        let mut values = [zero; 2];
        let mut pass = 0;
        loop {
            let (first, third) = rf_and_rd([x, Dd::select(negative, y, one), Dd::select(negative, one, y)]);
            // |m| s^2 R_D/3.
            let weight = m * square;
            let weight = Dd::select(negative, -weight, weight);
            let sum = first.plain_sum(weight * third);
            // c/sqrt y.
            let root = y.hi.sqrt();
            let inverse = L::splat(1.0) / root;
            let ratio = cosine.hi * inverse;
            let root_rest = (y.hi.remainder(root, root) + y.lo) * (inverse * L::splat(0.5));
            let rest = (cosine.hi.remainder(ratio, root) + (cosine.lo - ratio * root_rest)) * inverse;
            let last = (m * Dd::new(ratio, rest)).plain_sum(mc * sum);
            values[pass] = Dd::select(negative, sum, last) * sine;
            if pass == 1 || !L::any(around) {
                break;
            }
            let end = only_where(L::splat(LEAST).less(mc.hi), mc.hi);
            (sine, cosine, square, x) = (one, zero, one, zero);
            y = Dd::select(around, Dd::new(end, mc.lo), one);
            pass = 1;
        }
        [gathered(phi, &amplitude, values[0], values[1])]
    }
}

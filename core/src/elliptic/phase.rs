//! The phase of a motion in half periods, reduced to its nearest whole number.
//!
//! f = t rate + start with rate and start in double-double: the fraction keeps 2^-104 of the count, so a
//! billion periods cost no digits; at 2^100 half periods none are left, and the answer is NaN.
//! Source: the two-product form of Cody & Waite's reduction.

use crate::float::Dd;
use crate::float::double_double::two_sum;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::Lane;

/// Half periods per unit of the argument, and at its zero.
#[derive(Clone, Copy, Debug)]
pub struct Phase<L = f64> {
    /// Half periods per unit.
    pub rate: Dd<L>,
    /// Half periods at zero.
    pub start: Dd<L>,
}

/// n + sign * f half periods.
pub struct ReducedPhase<L: Lane> {
    /// Nearest whole number of half periods.
    pub n: Dd<L>,
    /// +1 or -1: the sign of the rest.
    pub sign: L,
    /// Size of the rest, in [0, 1/2].
    pub f: Dd<L>,
    /// (-1)^n.
    pub parity: L,
}

/// 2^53 half periods: beyond, doubles are further apart than a motion repeats.
pub(crate) const LAST_HALF_PERIOD: f64 = 9_007_199_254_740_992.0;

/// 2^32: up to this count the sum with the start has 20 digits after the point.
pub(crate) const NEAR: f64 = 4_294_967_296.0;

/// Beyond this argument every hyperbolic function has its limit.
const FAR: f64 = 1e6;

/// 2^100.
const END: f64 = 1.267_650_600_228_229_4e30;

/// (-1)^n for a whole n.
#[inline(always)]
pub(crate) fn alternating<L: Lane>(n: L) -> L {
    let half = n * L::splat(0.5);
    L::select(half.equal(half.round()), L::splat(1.0), L::splat(-1.0))
}

impl Phase {
    /// The same in every place.
    #[inline(always)]
    pub fn spread<L: Lane>(&self) -> Phase<L> {
        Phase { rate: Dd::splat(self.rate), start: Dd::splat(self.start) }
    }

    /// t rate + start, without reduction.
    #[inline(always)]
    pub(crate) fn counted<L: Lane>(&self, t: L) -> Dd<L> {
        let (passed, error) = t.two_product(L::splat(self.rate.hi));
        let error = t.mul_add(L::splat(self.rate.lo), error);
        let (y, rest) = two_sum(passed, L::splat(self.start.hi));
        Dd::ordered_sum(y, rest + (error + L::splat(self.start.lo)))
    }

    /// The same as the argument of hyperbolic functions, held where they have their limits; infinite times too.
    #[inline(always)]
    pub(crate) fn held<L: Lane>(&self, t: L) -> Dd<L> {
        let y = self.counted(t);
        let passed = t * L::splat(self.rate.hi);
        let near = passed.abs().less(L::splat(FAR));
        let far = L::select(t.equal(t), L::splat(FAR).copysign(passed), t);
        Dd::select(near, y, Dd::from_double(far))
    }
}

/// t rate in half periods, as the nearest whole number and the signed rest, in [-1/2, 1/2] up to a rounding error.
#[inline(always)]
pub(crate) fn turned<L: Lane>(t: L, rate: Unnormalised<L>) -> (L, Dd<L>) {
    let (turned, error) = t.two_product(rate.hi);
    let whole = turned.round();
    // Exact: the difference is a multiple of the last place of the product, and the rest a few of those.
    (whole, Dd::ordered_sum(turned - whole, t.mul_add(rate.lo, error)))
}

/// t rate modulo a period of its own in every lane: the nearest whole number of periods and the signed rest, good to 2^-103
/// of the product; a NaN for the rest from 2^40 periods, where the number of periods may round to a neighbour.
#[inline(always)]
pub(crate) fn modulo<L: Lane>(t: L, rate: Unnormalised<L>, period: Unnormalised<L>) -> (L, Dd<L>) {
    let (passed, error) = t.two_product_in_range(rate.hi);
    let n = (passed / period.hi).round();
    let (whole, whole_error) = n.two_product_in_range(period.hi);
    // What is left next to a whole number is of the order of the errors: every one of the large terms keeps its own.
    let (near, near_error) = two_sum(passed, -whole);
    let (nearer, nearer_error) = two_sum(near, -whole_error);
    let small = (-n).mul_add(period.lo, t.mul_add(rate.lo, error));
    let (hi, hi_error) = two_sum(nearer, small);
    let rest = Dd::ordered_sum(hi, hi_error + (nearer_error + near_error));
    (n, within(n, MANY, rest))
}

/// 2^40: below, the rest is at most 2^-12 of a period beyond half of one.
const MANY: f64 = 1_099_511_627_776.0;

impl<L: Lane> Phase<L> {
    /// t rate, rounded; its nearest whole number, what that lacks once the start is added, and the signed rest.
    #[inline(always)]
    fn rounded(&self, t: L) -> (L, [L; 2], Dd<L>) {
        let (turned, error) = t.two_product(self.rate.hi);
        let error = t.mul_add(self.rate.lo, error);
        let whole = turned.round();
        let (part, part_error) = two_sum(turned - whole, self.start.hi);
        let (part, rest) = two_sum(part, error);
        let carry = part.round();
        (turned, [whole, carry], Dd::ordered_sum(part - carry, rest + (part_error + self.start.lo)))
    }

    /// The nearest whole number and the signed rest, in [-1/2, 1/2] but for 2^-20, while the whole number is below `end` (at most
    /// 2^53); a NaN for the rest from there.
    #[inline(always)]
    pub fn count(&self, t: L, end: f64) -> (L, Dd<L>) {
        // Where t leaves the range of the product, the count is beyond every end.
        let (turned, error) = t.two_product_in_range(self.rate.hi);
        let (sum, rest) = two_sum(turned, self.start.hi);
        let n = sum.round();
        let rest = rest + (error + t.mul_add(self.rate.lo, self.start.lo));
        // Exact: the difference is a multiple of the last place of the sum.
        let f = Dd::ordered_sum(sum - n, rest);
        let far = L::splat(NEAR).less(n.abs());
        if L::any(far) {
            let (n_far, f_far) = counted_far(n, sum, rest, end);
            return (L::select(far, n_far, n), Dd::select(far, f_far, f));
        }
        (n, f)
    }

    /// [`Phase::count`] with the whole number as one of the same parity, to which 1.5 2^52 is added: the `rounder`, or 1 more where
    /// the parity is to be the other one.
    #[inline(always)]
    pub fn parity(&self, t: L, rounder: f64, end: f64) -> (L, Dd<L>) {
        let rounder = L::splat(rounder);
        let (turned, error) = t.two_product_in_range(self.rate.hi);
        let (sum, rest) = two_sum(turned, self.start.hi);
        let shifted = sum + rounder;
        let n = shifted - rounder;
        let rest = rest + (error + t.mul_add(self.rate.lo, self.start.lo));
        // Exact as in `count`, also where the whole number was rounded to a neighbour.
        let f = Dd::ordered_sum(sum - n, rest);
        let far = L::splat(NEAR).less(n.abs());
        if L::any(far) {
            let (whole, f_far) = counted_far(n, sum, rest, end);
            let half = whole * L::splat(0.5);
            let pairs = half.round();
            let odd = whole - (pairs + pairs);
            return (L::select(far, odd + rounder, shifted), Dd::select(far, f_far, f));
        }
        (shifted, f)
    }

    /// The reduced phase at t.
    #[inline(always)]
    pub fn reduce(&self, t: L) -> ReducedPhase<L> {
        let (turned, [whole, carry], f) = self.rounded(t);
        let f = within(turned, END, f);
        let sign = L::splat(1.0).copysign(f.hi);
        let parity = alternating(whole) * alternating(carry);
        ReducedPhase { n: Dd::sum(whole, carry), sign, f: f.scale(sign), parity }
    }
}

/// The same where the sum has so few digits after the point that the rest may be of the size of 1, and carry. The rounding of the
/// rest is 2^-106 of the sum.
#[inline(always)]
fn counted_far<L: Lane>(n: L, sum: L, rest: L, end: f64) -> (L, Dd<L>) {
    let carry = ((sum - n) + rest).round();
    let whole = n + carry;
    // Exact: the part is a whole number of last places of the sum, and at most 1. The rest is less than two of them, so the part is
    // 0 or its exponent is not the smaller one.
    (whole, within(whole, end, Dd::ordered_sum((sum - n) - carry, rest)))
}

/// f where |count| is below the end, else a NaN.
#[inline(always)]
fn within<L: Lane>(count: L, end: f64, f: Dd<L>) -> Dd<L> {
    Dd::new(L::select(count.abs().less(L::splat(end)), f.hi, L::splat(f64::NAN)), f.lo)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::float::exponent::exp2;
    use crate::lanes::ROUNDER;

    /// The count is that of the careful reduction, on both sides of [`NEAR`]; also where a half is left, and the low words go on.
    #[test]
    fn few_and_many_half_periods_are_counted_alike() {
        let mut beyond_half = 0;
        for power in [3, 20, 26, 27, 31, 32, 33, 40, 50] {
            for i in 0..400 {
                let whole = (exp2(power) * (1.0 + f64::from(i) / 401.0)).floor();
                for (rest, low) in [(0.25, 1e-17), (0.5, exp2(-54)), (0.5, -exp2(-54))] {
                    let (t, phase) = (whole + rest, Phase { rate: Dd::new(1.0, low), start: Dd::ZERO });
                    let (n, f) = phase.count(t, LAST_HALF_PERIOD);
                    let at = phase.reduce(t);
                    let error = (Dd::from(n) + f) - (at.n + at.f.scale(at.sign));
                    assert!(error.hi.abs() <= t * exp2(-103), "{t} {low:e} {error:?}");
                    let most = if n <= NEAR { 0.5 + exp2(-20) } else { 0.5 };
                    assert!(f.hi.abs() <= most, "{t} {low:e} {f:?}");
                    beyond_half += u32::from(f.hi.abs() > 0.5);
                    let (shifted, same) = phase.parity(t, ROUNDER, LAST_HALF_PERIOD);
                    assert!(same == f && 1f64.alternated(shifted) == alternating(n), "{t} {low:e}");
                }
            }
        }
        assert!(beyond_half > 100, "{beyond_half}");
    }
}

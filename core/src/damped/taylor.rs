//! What all Taylor series of the motion share: their length, the inverses of whole numbers, and words of double-doubles.

use crate::float::Dd;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::Lane;

/// Highest power of time. For a tolerance of 2^-70 the rule of Jorba & Zou, ceil(-ln(tolerance)/2) + 1 = 26, takes a step to cost the
/// square of its order. Here it costs a fixed part besides, and the products come four at a time: 32 coefficients fill lanes.
pub(super) const ORDER: usize = 31;
/// How many coefficients of the lowest orders are double-doubles.
pub(super) const LONG: usize = 9;

/// The coefficients of one function of time.
pub(super) type Series = [f64; ORDER + 1];

/// 1/k in double-double, 0 for k = 0.
pub(super) const INVERSE: [Dd; ORDER + 2] = inverses();

const fn inverses() -> [Dd; ORDER + 2] {
    let mut all = [Dd::ZERO; ORDER + 2];
    let mut k = 1;
    while k < ORDER + 2 {
        let whole = k as f64;
        let hi = 1.0 / whole;
        // hi = n/2^s exactly: the rest 1 - k hi fits into 2^-52, and its exact value is formed in integers.
        let bits = hi.to_bits();
        let mantissa = ((bits & ((1 << 52) - 1)) | (1 << 52)) as i128;
        let scale = 1075 - (bits >> 52) as u32;
        let rest = (1i128 << scale) - mantissa * k as i128;
        let mut lo = rest as f64 / whole;
        let mut left = scale;
        while left > 0 {
            lo *= 0.5;
            left -= 1;
        }
        all[k] = Dd::new(hi, lo);
        k += 1;
    }
    all
}

/// Four numbers of a row.
#[inline(always)]
pub(super) fn places<L: Lane>(row: L) -> [f64; 4] {
    let mut places = [0.0; 4];
    row.store(&mut places);
    places
}

/// A double, exactly.
#[inline(always)]
pub(super) fn double<L: Lane>(value: f64) -> Unnormalised<L> {
    Unnormalised::from_double(L::splat(value))
}

/// One number out of a lane.
#[inline(always)]
pub(super) fn number<L: Lane>(value: Unnormalised<L>) -> Dd {
    let value = value.tight();
    Dd::new(value.hi.first(), value.lo.first())
}

/// Sine and cosine put back on the circle after a step: their errors along it are those of the step.
#[inline(always)]
pub(super) fn on_circle<L: Lane>(s: &mut Unnormalised<L>, c: &mut Unnormalised<L>) {
    let (first, first_error) = s.hi.two_product_in_range(s.hi);
    let (second, second_error) = c.hi.two_product_in_range(c.hi);
    let cross = s.hi.mul_add(s.lo, c.hi * c.lo);
    // The larger square is above 0.49: so 1 is taken from it exactly, and the rest is as small as the excess.
    let swapped = first.less(second);
    let (larger, smaller) = (L::select(swapped, second, first), L::select(swapped, first, second));
    let small = (first_error + second_error) + (cross + cross);
    let half = (((larger - L::splat(1.0)) + smaller) + small) * L::splat(-0.5);
    (s.lo, c.lo) = (s.hi.mul_add(half, s.lo), c.hi.mul_add(half, c.lo));
}

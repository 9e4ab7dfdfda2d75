//! The lane of width one without fused multiplication: a plain double, on every processor.

use super::lane::{COMPACT, Lane, PIECES, ROUNDER};

/// Factors above 2^990 are scaled by 2^-56 so that splitting does not overflow, and their product back by 2^56.
pub(super) const HUGE: f64 = 1.046_336_793_293_362_4e298;
pub(super) const DOWN: f64 = 1.387_778_780_781_445_7e-17;
pub(super) const UP: f64 = 72_057_594_037_927_936.0;

/// 2^52: an integer below stands in the low bits of its mantissa.
pub(super) const FIELD: f64 = 4_503_599_627_370_496.0;

impl Lane for f64 {
    type Mask = bool;
    const WIDTH: usize = 1;
    const APART: bool = COMPACT;

    #[inline(always)]
    fn load(from: &[f64]) -> f64 {
        from[0]
    }
    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        to[0] = self;
    }

    #[inline(always)]
    fn splat(value: f64) -> f64 {
        value
    }
    #[inline(always)]
    fn mul_add(self, factor: f64, term: f64) -> f64 {
        self * factor + term
    }
    /// Long, and everywhere in set-ups: the compiler decides where it pays.
    #[inline]
    fn two_product(self, factor: f64) -> (f64, f64) {
        if f64::abs(self) > HUGE || f64::abs(factor) > HUGE {
            return product_of_huge(self, factor);
        }
        let product = self * factor;
        (product, host_product_error(self, factor, product))
    }
    #[inline]
    fn two_product_in_range(self, factor: f64) -> (f64, f64) {
        let product = self * factor;
        (product, host_product_error(self, factor, product))
    }
    #[inline(always)]
    fn round(self) -> f64 {
        if f64::abs(self) < 2_251_799_813_685_248.0 { (self + ROUNDER) - ROUNDER } else { round_large(self) }
    }
    #[inline(always)]
    fn sqrt(self) -> f64 {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn abs(self) -> f64 {
        f64::abs(self)
    }
    #[inline(always)]
    fn copysign(self, sign: f64) -> f64 {
        f64::copysign(self, sign)
    }
    #[inline(always)]
    fn exp2_integer(self) -> f64 {
        f64::from_bits(((self + (ROUNDER + 1023.0)).to_bits()) << 52)
    }
    #[inline(always)]
    fn exponent(self) -> f64 {
        f64::from_bits((self.to_bits() >> 52) | FIELD.to_bits()) - (FIELD + 1023.0)
    }
    #[inline(always)]
    fn any(mask: bool) -> bool {
        mask
    }
    #[inline(always)]
    fn lookup(self, table: &[f64; PIECES]) -> f64 {
        table[(self.to_bits() >> 49) as usize % PIECES]
    }
    #[inline(always)]
    fn less(self, other: f64) -> bool {
        self < other
    }
    #[inline(always)]
    fn equal(self, other: f64) -> bool {
        self == other
    }
    #[inline(always)]
    fn select(mask: bool, yes: f64, no: f64) -> f64 {
        if mask { yes } else { no }
    }
}

/// Of plain doubles. On a page the bytes count: there it is compiled once.
#[cfg_attr(target_arch = "wasm32", inline(never))]
#[cfg_attr(not(target_arch = "wasm32"), inline(always))]
fn host_product_error(a: f64, b: f64, product: f64) -> f64 {
    product_error(a, b, product)
}

/// Product and error of factors of which one or both are too large to be split.
#[cold]
#[inline(never)]
fn product_of_huge(a: f64, b: f64) -> (f64, f64) {
    let down = |factor: f64| if f64::abs(factor) > HUGE { (factor * DOWN, UP) } else { (factor, 1.0) };
    let ((small_a, up_a), (small_b, up_b)) = (down(a), down(b));
    (a * b, product_error(small_a, small_b, small_a * small_b) * up_a * up_b)
}

/// Dekker's: the exact error of the product of two factors up to 2^990.
#[inline(always)]
pub(super) fn product_error<L: Lane>(a: L, b: L, product: L) -> L {
    product_error_of_parts(split(a), split(b), product)
}

/// The same of factors in parts of 26 bits.
#[inline(always)]
pub(super) fn product_error_of_parts<L: Lane>((a_hi, a_lo): (L, L), (b_hi, b_lo): (L, L), product: L) -> L {
    ((a_hi * b_hi - product) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo
}

/// Veltkamp's splitting into 26 + 26 bits.
#[inline(always)]
fn split<L: Lane>(value: L) -> (L, L) {
    let scaled = L::splat(134_217_729.0) * value;
    let hi = scaled - (scaled - value);
    (hi, value - hi)
}

/// Between 2^51 and 2^52 a half is left; above, every double is an integer.
fn round_large(value: f64) -> f64 {
    if f64::abs(value) < 4_503_599_627_370_496.0 {
        let whole = (f64::abs(value) + 4_503_599_627_370_496.0) - 4_503_599_627_370_496.0;
        f64::copysign(whole, value)
    } else {
        value
    }
}

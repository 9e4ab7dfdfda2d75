//! Sums of products of doubles without any rounding, for signs that decide what a motion does, and for what is left
//! of them when they cancel.
//!
//! Method: fixed point, so wide that every product of eight doubles fits: integers cannot err, whatever the sizes.

use super::double_double::Dd;
use super::exponent::{exponent, mantissa};
use super::scaled::Scaled;

/// 64-bit words of the sum; and the place of the binary point.
const WORDS: usize = 272;
const POINT: i32 = 9024;
/// Most factors of a product, and the words of their mantissas.
const FACTORS: usize = 8;
const PRODUCT: usize = 7;
/// Bits of a mantissa after its first.
const BITS: i32 = 52;

/// The sum of products, each of at most eight doubles, rounded once: zero only if it is exactly zero.
pub(crate) fn sum_of_products(products: &[&[f64]]) -> Scaled {
    let mut sum = [0u64; WORDS];
    for factors in products {
        add(&mut sum, factors);
    }
    let negative = sum[WORDS - 1] >> 63 == 1;
    if negative {
        negate(&mut sum);
    }
    let Some(top) = sum.iter().rposition(|word| *word != 0) else { return Scaled::ZERO };
    // Three words hold at least 129 bits.
    let mut value = Dd::ZERO;
    let lowest = top.saturating_sub(2);
    for word in sum[lowest..=top].iter().rev() {
        for half in [word >> 32, word & 0xffff_ffff] {
            value = value.scale(4_294_967_296.0) + Dd::from(half as f64);
        }
    }
    let value = Scaled::new(value, 64 * lowest as i32 - POINT);
    if negative { -value } else { value }
}

fn negate(words: &mut [u64]) {
    let mut carry = true;
    for word in words {
        (*word, carry) = (!*word).overflowing_add(u64::from(carry));
    }
}

/// Adds one product; none where a factor is zero.
fn add(sum: &mut [u64; WORDS], factors: &[f64]) {
    debug_assert!(factors.len() <= FACTORS);
    if factors.contains(&0.0) {
        return;
    }
    let mut product = [0u64; PRODUCT + 1];
    product[0] = 1;
    let mut place = POINT;
    let mut negative = false;
    for factor in factors {
        negative ^= *factor < 0.0;
        place += exponent(*factor) - BITS;
        multiply(&mut product, (mantissa(*factor) * 4_503_599_627_370_496.0) as u64);
    }
    let (word, bit) = ((place / 64) as usize, (place % 64) as u32);
    if bit > 0 {
        let mut carry = 0;
        for digit in &mut product {
            (*digit, carry) = (*digit << bit | carry, *digit >> (64 - bit));
        }
    }
    let mut carry = false;
    for (i, place) in sum[word..].iter_mut().enumerate() {
        let digit = product.get(i).copied().unwrap_or(0);
        if i >= product.len() && !carry {
            break;
        }
        let (one, first, second);
        if negative {
            (one, first) = place.overflowing_sub(digit);
            (*place, second) = one.overflowing_sub(u64::from(carry));
        } else {
            (one, first) = place.overflowing_add(digit);
            (*place, second) = one.overflowing_add(u64::from(carry));
        }
        carry = first | second;
    }
}

fn multiply(digits: &mut [u64], factor: u64) {
    let mut carry = 0u128;
    for digit in digits {
        let product = u128::from(*digit) * u128::from(factor) + carry;
        (*digit, carry) = (product as u64, product >> 64);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_lost() {
        let sum = |products: &[&[f64]]| sum_of_products(products).value();
        assert_eq!(sum(&[&[3.0, 0.5], &[-1.5]]), 0.0);
        assert_eq!(
            sum(&[&[1e300; 8], &[5e-324], &[-1e300, 1e300, 1e300, 1e300, 1e300, 1e300, 1e300, 1e300]]),
            5e-324
        );
        assert_eq!(sum(&[&[-0.1, 10.0], &[1.0]]), -f64::EPSILON / 4.0);
        assert_eq!(sum(&[&[5e-324; 8], &[-5e-324, 3.0]]), -1.5e-323);
        assert_eq!(sum(&[&[-7.25, 2.0]]), -14.5);
        assert_eq!(sum(&[&[0.0, 1.0], &[]]), 1.0);
        let (a, b) = (1.0 + f64::EPSILON, 1.0 - f64::EPSILON);
        assert_eq!(sum(&[&[a, b], &[-1.0]]), -f64::EPSILON * f64::EPSILON);
        let least = sum_of_products(&[&[5e-324; 8]]);
        assert_eq!((least.power(), least.part().hi), (-1074 * 8, 1.0));
    }
}

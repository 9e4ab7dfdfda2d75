//! Whole numbers of any length times a power of two: sums and products of doubles without any rounding, for the signs that
//! decide a regime (the discriminant has terms of sixteen factors) and for what is left where they cancel.

use crate::float::Dd;
use crate::float::exponent::{exponent, ldexp, mantissa};
use crate::float::scaled::Scaled;
use core::ops::{Add, Mul, Neg, Sub};

/// digits * 2^power, least significant word first, without zeros at either end.
#[derive(Clone, Debug)]
pub(super) struct Exact {
    negative: bool,
    digits: Vec<u64>,
    power: i32,
}

/// Bits of a mantissa after its first.
const BITS: i32 = 52;

impl Exact {
    /// Without zero words at either end.
    fn trimmed(negative: bool, mut digits: Vec<u64>, power: i32) -> Exact {
        while digits.last() == Some(&0) {
            digits.pop();
        }
        let low = digits.iter().position(|word| *word != 0).unwrap_or(0);
        digits.drain(..low);
        Exact { negative, power: power + 64 * low as i32, digits }
    }
    /// +1, 0 or -1.
    pub fn sign(&self) -> i32 {
        match (self.digits.is_empty(), self.negative) {
            (true, _) => 0,
            (_, true) => -1,
            _ => 1,
        }
    }
    /// Rounded once, to a double-double of any range.
    pub fn to_wide(&self) -> Scaled {
        // Three words hold at least 129 bits.
        let low = self.digits.len().saturating_sub(3);
        let mut value = Dd::ZERO;
        for word in self.digits[low..].iter().rev() {
            for half in [word >> 32, word & 0xffff_ffff] {
                value = value.scale(4_294_967_296.0) + Dd::from(half as f64);
            }
        }
        let value = Scaled::new(value, self.power + 64 * low as i32);
        if self.negative { -value } else { value }
    }
    /// The square.
    pub fn square(&self) -> Exact {
        self * self
    }
    /// The digits moved up by `shift` bits.
    fn raised(&self, shift: i32) -> Vec<u64> {
        let (words, bits) = ((shift / 64) as usize, shift % 64);
        let mut digits = vec![0; words];
        let mut carry = 0;
        for word in &self.digits {
            digits.push(word << bits | carry);
            carry = if bits == 0 { 0 } else { word >> (64 - bits) };
        }
        digits.push(carry);
        digits
    }
}

impl From<f64> for Exact {
    fn from(value: f64) -> Exact {
        if value == 0.0 {
            return Exact { negative: false, digits: Vec::new(), power: 0 };
        }
        let digits = ldexp(mantissa(value), BITS) as u64;
        let spare = digits.trailing_zeros();
        let power = exponent(value) - BITS + spare as i32;
        Exact { negative: value < 0.0, digits: vec![digits >> spare], power }
    }
}

impl Mul for &Exact {
    type Output = Exact;
    fn mul(self, other: &Exact) -> Exact {
        let mut digits = vec![0u64; self.digits.len() + other.digits.len()];
        for (i, a) in self.digits.iter().enumerate() {
            let mut carry = 0u128;
            for (digit, b) in digits[i..].iter_mut().zip(&other.digits) {
                let sum = u128::from(*a) * u128::from(*b) + u128::from(*digit) + carry;
                (*digit, carry) = (sum as u64, sum >> 64);
            }
            digits[i + other.digits.len()] = carry as u64;
        }
        Exact::trimmed(self.negative != other.negative, digits, self.power + other.power)
    }
}

impl Mul<f64> for &Exact {
    type Output = Exact;
    fn mul(self, factor: f64) -> Exact {
        self * &Exact::from(factor)
    }
}

impl Neg for &Exact {
    type Output = Exact;
    fn neg(self) -> Exact {
        Exact { negative: !self.negative, ..self.clone() }
    }
}

impl Add for &Exact {
    type Output = Exact;
    fn add(self, other: &Exact) -> Exact {
        if self.sign() == 0 {
            return other.clone();
        }
        if other.sign() == 0 {
            return self.clone();
        }
        let power = self.power.min(other.power);
        let mut large = self.raised(self.power - power);
        let mut small = other.raised(other.power - power);
        let length = large.len().max(small.len()) + 1;
        large.resize(length, 0);
        small.resize(length, 0);
        let mut negative = self.negative;
        let apart = self.negative != other.negative;
        if apart && large.iter().rev().lt(small.iter().rev()) {
            (large, small, negative) = (small, large, other.negative);
        }
        let mut carry = false;
        for (digit, word) in large.iter_mut().zip(&small) {
            let (one, first, second);
            if apart {
                (one, first) = digit.overflowing_sub(*word);
                (*digit, second) = one.overflowing_sub(u64::from(carry));
            } else {
                (one, first) = digit.overflowing_add(*word);
                (*digit, second) = one.overflowing_add(u64::from(carry));
            }
            carry = first | second;
        }
        Exact::trimmed(negative, large, power)
    }
}

impl Sub for &Exact {
    type Output = Exact;
    fn sub(self, other: &Exact) -> Exact {
        self + &-other
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_lost() {
        let [a, b, tiny, huge] = [1.0 + f64::EPSILON, 1.0 - f64::EPSILON, 5e-324, f64::MAX].map(Exact::from);
        let rest = &(&a * &b) - &Exact::from(1.0);
        assert_eq!(rest.to_wide().value(), -f64::EPSILON * f64::EPSILON);
        let sum = &(&huge.square() + &tiny) - &huge.square();
        assert_eq!(sum.to_wide().value(), 5e-324);
        assert_eq!((&sum - &tiny).sign(), 0);
        assert_eq!((&Exact::from(-7.25) * 2.0).to_wide().value(), -14.5);
        assert_eq!((&Exact::from(3.0) - &Exact::from(5.0)).to_wide().value(), -2.0);
        assert_eq!((&Exact::from(0.0) + &Exact::from(-0.75)).sign(), -1);
        let long = &(&(&a * &a) * &a).square() * 3.0;
        assert_eq!((&long - &(&long * 1.0)).sign(), 0);
        assert_eq!((&(&long + &tiny) - &long).to_wide().value(), 5e-324);
    }
}

//! Double-doubles whose words may overlap by a few bits: products and sums leave out the last normalisation, half of
//! their work, for the long chains of a set-up per lane.
//!
//! |lo| stays below 2^-50 |hi| (after a cancellation: of the terms), and every operation adds an error of about
//! 2^-103 of its terms.

use super::double_double::{Dd, fast_two_sum, two_sum};
use crate::lanes::Lane;
use core::ops::{Add, Mul, Neg, Sub};

/// hi + lo, not normalised.
#[derive(Clone, Copy)]
pub(crate) struct Unnormalised<L: Lane> {
    pub hi: L,
    pub lo: L,
}

impl<L: Lane> From<Dd<L>> for Unnormalised<L> {
    #[inline(always)]
    fn from(value: Dd<L>) -> Self {
        Unnormalised::new(value.hi, value.lo)
    }
}

impl<L: Lane> Unnormalised<L> {
    #[inline(always)]
    pub fn new(hi: L, lo: L) -> Self {
        Unnormalised { hi, lo }
    }
    /// A double, exactly.
    #[inline(always)]
    pub fn from_double(value: L) -> Self {
        Unnormalised::new(value, L::splat(0.0))
    }
    /// A constant in every place.
    #[inline(always)]
    pub fn splat(value: Dd) -> Self {
        Dd::splat(value).into()
    }
    /// Normalised, whatever its words.
    #[inline(always)]
    pub fn tight(self) -> Dd<L> {
        Dd::sum(self.hi, self.lo)
    }
    /// Normalised, of words that are in order.
    #[inline(always)]
    pub fn ordered(self) -> Dd<L> {
        Dd::ordered_sum(self.hi, self.lo)
    }
    /// Times a power of two.
    #[inline(always)]
    pub fn scale(self, power: L) -> Self {
        Unnormalised::new(self.hi * power, self.lo * power)
    }
    #[inline(always)]
    pub fn square(self) -> Self {
        let (hi, error) = self.hi.two_product_in_range(self.hi);
        Unnormalised::new(hi, (self.hi + self.hi).mul_add(self.lo, error))
    }
    /// Sum with one that is not larger.
    #[inline(always)]
    pub fn plus_smaller(self, other: Self) -> Self {
        let (hi, error) = fast_two_sum(self.hi, other.hi);
        Unnormalised::new(hi, error + (self.lo + other.lo))
    }
    /// Difference to one that is not larger.
    #[inline(always)]
    pub fn minus_smaller(self, other: Self) -> Self {
        let hi = self.hi - other.hi;
        Unnormalised::new(hi, ((self.hi - hi) - other.hi) + (self.lo - other.lo))
    }
    /// Square root of a number in [1e-200, 1e300].
    #[inline(always)]
    pub fn root(self) -> Self {
        let root = self.hi.sqrt();
        self.near_root(root, L::splat(0.5) / root)
    }
    /// Square roots of two numbers likewise, from doubles that are they but for a few roundings, by one division.
    #[inline(always)]
    pub fn two_near_roots(self, other: Self, [first, second]: [L; 2]) -> [Self; 2] {
        let inverse = L::splat(0.5) / (first * second);
        [self.near_root(first, inverse * second), other.near_root(second, inverse * first)]
    }
    /// Square root from a double that is it but for a few roundings, and half the inverse of that.
    #[inline(always)]
    pub fn near_root(self, root: L, half_inverse: L) -> Self {
        let rest = self.hi.remainder(root, root) + self.lo;
        Unnormalised::new(root, rest * half_inverse)
    }
    /// Root and inverse, by one division.
    #[inline(always)]
    pub fn root_and_inverse(self) -> [Self; 2] {
        let inverse = self.inverse();
        let root = self.hi.sqrt();
        [self.near_root(root, L::splat(0.5) * root * inverse.hi), inverse]
    }
    /// Quotient.
    #[inline(always)]
    pub fn over(self, divisor: Self) -> Self {
        self.over_by(divisor, L::splat(1.0) / divisor.hi)
    }
    /// Quotient from the inverse of the divisor but for a few roundings.
    #[inline(always)]
    pub fn over_by(self, divisor: Self, inverse: L) -> Self {
        let first = self.hi * inverse;
        let rest = self.hi.remainder(first, divisor.hi) + (self.lo - first * divisor.lo);
        Unnormalised::new(first, rest * inverse)
    }
    /// 1/self, not below 1e-300.
    #[inline(always)]
    pub fn inverse(self) -> Self {
        let one = L::splat(1.0);
        let first = one / self.hi;
        // What the inverse lacks of itself.
        let rest = one.remainder(first, self.hi) - first * self.lo;
        Unnormalised::new(first, first * rest)
    }
    /// 1/sqrt self, not far below 1e-200.
    #[inline(always)]
    pub fn inverse_root(self) -> Self {
        let one = L::splat(1.0);
        let first = one / self.hi.sqrt();
        let (square, error) = first.two_product_in_range(first);
        let (whole, whole_error) = square.two_product_in_range(self.hi);
        // What self first^2 lacks of 1: half of that is what the root lacks.
        let rest = (one - whole) - (whole_error + square.mul_add(self.lo, error * self.hi));
        Unnormalised::new(first, first * L::splat(0.5) * rest)
    }
    /// `yes` where the mask holds, `no` elsewhere.
    #[inline(always)]
    pub fn select(mask: L::Mask, yes: Self, no: Self) -> Self {
        Unnormalised::new(L::select(mask, yes.hi, no.hi), L::select(mask, yes.lo, no.lo))
    }
}

impl<L: Lane> Neg for Unnormalised<L> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Unnormalised::new(-self.hi, -self.lo)
    }
}

impl<L: Lane> Add for Unnormalised<L> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let (hi, error) = two_sum(self.hi, other.hi);
        Unnormalised::new(hi, error + (self.lo + other.lo))
    }
}

impl<L: Lane> Sub for Unnormalised<L> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        // two_sum of a difference, without a negation.
        let hi = self.hi - other.hi;
        let part = self.hi - hi;
        let error = (self.hi - (hi + part)) + (part - other.hi);
        Unnormalised::new(hi, error + (self.lo - other.lo))
    }
}

impl<L: Lane> Mul for Unnormalised<L> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let (hi, error) = self.hi.two_product_in_range(other.hi);
        Unnormalised::new(hi, self.hi.mul_add(other.lo, self.lo.mul_add(other.hi, error)))
    }
}

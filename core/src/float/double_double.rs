//! Double-double arithmetic: an unevaluated sum hi + lo of two doubles, |lo| <= ulp(hi)/2.
//!
//! Relative errors in units of 2^-106: sum 3, product 5, quotient 10, square root 4.
//! Source: Joldes, Muller & Popescu, ACM TOMS 44 (2017) 15.

use super::exponent::{exp2, ldexp};
use crate::lanes::{Lane, compiled_once};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// hi + lo.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dd<L = f64> {
    /// The value rounded to double.
    pub hi: L,
    /// What that rounding lost, rounded to double.
    pub lo: L,
}

/// Sum and its exact error.
#[inline(always)]
pub fn two_sum<L: Lane>(a: L, b: L) -> (L, L) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}

/// Sum and its exact error, for |a| >= |b| or a = 0.
#[inline(always)]
pub fn fast_two_sum<L: Lane>(a: L, b: L) -> (L, L) {
    let sum = a + b;
    (sum, b - (sum - a))
}

impl<L: Lane> Dd<L> {
    /// hi + lo, already normalised.
    #[inline(always)]
    pub const fn new(hi: L, lo: L) -> Self {
        Dd { hi, lo }
    }
    /// A double, exactly.
    #[inline(always)]
    pub fn from_double(value: L) -> Self {
        Dd::new(value, L::splat(0.0))
    }
    /// A constant in every place.
    #[inline(always)]
    pub fn splat(value: Dd<f64>) -> Self {
        Dd::new(L::splat(value.hi), L::splat(value.lo))
    }
    /// a + b, exactly.
    #[inline(always)]
    pub fn sum(a: L, b: L) -> Self {
        let (hi, lo) = two_sum(a, b);
        Dd::new(hi, lo)
    }
    /// a + b, exactly, for |a| >= |b|.
    #[inline(always)]
    pub fn ordered_sum(a: L, b: L) -> Self {
        let (hi, lo) = fast_two_sum(a, b);
        Dd::new(hi, lo)
    }
    /// a * b, exactly.
    #[inline(always)]
    pub fn product(a: L, b: L) -> Self {
        let (hi, lo) = a.two_product(b);
        Dd::new(hi, lo)
    }
    /// The nearest double.
    #[inline(always)]
    pub fn value(self) -> L {
        self.hi + self.lo
    }
    /// Times a power of two, exactly.
    #[inline(always)]
    pub fn scale(self, power: L) -> Self {
        Dd::new(self.hi * power, self.lo * power)
    }
    /// The product with a double, where an infinity or a NaN serves as well for factors beyond 2^990.
    #[inline(always)]
    pub fn times_in_range(self, factor: L) -> Self {
        let (hi, error) = self.hi.two_product_in_range(factor);
        Dd::ordered_sum(hi, self.lo.mul_add(factor, error))
    }
    /// The square.
    #[inline(always)]
    pub fn square(self) -> Self {
        self * self
    }
    /// `yes` where the mask holds, `no` elsewhere.
    #[inline(always)]
    pub fn select(mask: L::Mask, yes: Self, no: Self) -> Self {
        Dd::new(L::select(mask, yes.hi, no.hi), L::select(mask, yes.lo, no.lo))
    }
    /// Sum of two that do not cancel.
    #[inline(always)]
    pub fn plain_sum(self, other: Self) -> Self {
        let (hi, error) = two_sum(self.hi, other.hi);
        Dd::ordered_sum(hi, error + (self.lo + other.lo))
    }
    /// Sum with one that is not larger and does not cancel.
    #[inline(always)]
    pub fn plus_smaller(self, other: Self) -> Self {
        let (hi, error) = fast_two_sum(self.hi, other.hi);
        Dd::ordered_sum(hi, error + (self.lo + other.lo))
    }
    /// self * (1 + change) for a small change known in double.
    #[inline(always)]
    pub fn nudge(self, change: L) -> Self {
        Dd::ordered_sum(self.hi, self.hi.mul_add(change, self.lo))
    }
}

impl<L: Lane> Neg for Dd<L> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Dd::new(-self.hi, -self.lo)
    }
}

impl<L: Lane> Add for Dd<L> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        sum_of(self, other)
    }
}

impl<L: Lane> Sub for Dd<L> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<L: Lane> Mul for Dd<L> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        product_of(self, other)
    }
}

impl<L: Lane> Mul<L> for Dd<L> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: L) -> Self {
        multiple_of(self, factor)
    }
}

impl<L: Lane> Div for Dd<L> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        quotient_of(self, other)
    }
}

compiled_once! {
    /// The sum of two.
    fn sum_of<L: Lane>(a: Dd<L>, b: Dd<L>) -> Dd<L> {
        let (hi, hi_error) = two_sum(a.hi, b.hi);
        let (lo, lo_error) = two_sum(a.lo, b.lo);
        let (hi, rest) = fast_two_sum(hi, hi_error + lo);
        let (hi, lo) = fast_two_sum(hi, rest + lo_error);
        Dd::new(hi, lo)
    }
}

compiled_once! {
    /// The product of two.
    fn product_of<L: Lane>(a: Dd<L>, b: Dd<L>) -> Dd<L> {
        let (hi, error) = a.hi.two_product(b.hi);
        let cross = a.hi.mul_add(b.lo, a.lo * b.hi);
        Dd::ordered_sum(hi, error + cross)
    }
}

compiled_once! {
    /// The product with a double.
    fn multiple_of<L: Lane>(a: Dd<L>, factor: L) -> Dd<L> {
        let (hi, error) = a.hi.two_product(factor);
        Dd::ordered_sum(hi, a.lo.mul_add(factor, error))
    }
}

compiled_once! {
    /// The quotient of two.
    fn quotient_of<L: Lane>(a: Dd<L>, b: Dd<L>) -> Dd<L> {
        let first = a.hi / b.hi;
        let rest = a - b * first;
        let second = rest.hi / b.hi;
        let rest = rest - b * second;
        let third = rest.hi / b.hi;
        let (hi, lo) = fast_two_sum(first, second);
        Dd::ordered_sum(hi, lo + third)
    }
}

impl Dd<f64> {
    /// Zero.
    pub const ZERO: Dd = Dd::new(0.0, 0.0);
    /// One.
    pub const ONE: Dd = Dd::new(1.0, 0.0);

    /// Half of it, exactly (for constants).
    pub const fn half(self) -> Dd {
        Dd::new(0.5 * self.hi, 0.5 * self.lo)
    }
    /// Square root; zero for zero, NaN below.
    pub fn sqrt(self) -> Dd {
        if self.hi == 0.0 {
            return Dd::ZERO;
        }
        // The error of the root's square must stay in range, and so must the square. One call deep: the scaled number lies
        // between the bounds.
        if self.hi > 0.0 && self.hi < 1e-200 {
            return self.scale(exp2(800)).sqrt().scale(exp2(-400));
        }
        if self.hi > 1e300 && self.hi.is_finite() {
            return self.scale(exp2(-400)).sqrt().scale(exp2(200));
        }
        let root = f64::sqrt(self.hi);
        let rest = self - Dd::product(root, root);
        Dd::ordered_sum(root, rest.hi / (2.0 * root))
    }
    /// Times 2^power, each word rounded once where it leaves the normal numbers.
    pub fn ldexp(self, power: i32) -> Dd {
        Dd::new(ldexp(self.hi, power), ldexp(self.lo, power))
    }
    /// Absolute value.
    pub fn abs(self) -> Dd {
        if self.hi < 0.0 { -self } else { self }
    }
}

impl From<f64> for Dd<f64> {
    fn from(value: f64) -> Dd {
        Dd::from_double(value)
    }
}

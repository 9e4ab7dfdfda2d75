//! Triple-double arithmetic, hi + mid + lo, about 155 bits: only for the set-up quantities that decide
//! the regime and the period a rounding error from the separatrix.
//!
//! Source: Priest's expansions as in Hida, Li & Bailey, ARITH 15 (2001), cut to three components.

use super::double_double::{Dd, fast_two_sum, two_sum};
use crate::lanes::Lane;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// hi + mid + lo.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Td {
    /// The value rounded to double.
    pub hi: f64,
    /// The rest rounded to double.
    pub mid: f64,
    /// What is left.
    pub lo: f64,
}

impl Td {
    /// Zero.
    pub const ZERO: Td = Td::new(0.0, 0.0, 0.0);
    /// One.
    pub const ONE: Td = Td::new(1.0, 0.0, 0.0);

    /// Three components, already normalised.
    pub const fn new(hi: f64, mid: f64, lo: f64) -> Td {
        Td { hi, mid, lo }
    }
    /// Three overlapping components of falling size.
    pub fn normalised(hi: f64, mid: f64, lo: f64) -> Td {
        let (mid, lo) = two_sum(mid, lo);
        let (hi, mid) = two_sum(hi, mid);
        let (mid, lo) = two_sum(mid, lo);
        let (hi, mid) = fast_two_sum(hi, mid);
        Td { hi, mid, lo }
    }
    /// The product of two doubles, exactly.
    pub fn product(a: f64, b: f64) -> Td {
        Dd::product(a, b).into()
    }
    /// The nearest double-double.
    pub fn to_dd(self) -> Dd {
        let (mid, lo) = fast_two_sum(self.mid, self.lo);
        let (hi, mid) = fast_two_sum(self.hi, mid);
        Dd::new(hi, mid + lo)
    }
    /// Times a power of two, exactly.
    pub fn scale(self, power: f64) -> Td {
        Td::new(self.hi * power, self.mid * power, self.lo * power)
    }
    /// The square.
    pub fn square(self) -> Td {
        self * self
    }
    /// Square root of a positive number: Newton's correction of the double-double root.
    pub fn sqrt(self) -> Td {
        if self.hi == 0.0 {
            return Td::ZERO;
        }
        let root = Td::from(self.to_dd().sqrt());
        root + Td::from((self - root.square()).hi / (2.0 * root.hi))
    }
    /// Absolute value.
    pub fn abs(self) -> Td {
        if self.hi < 0.0 { -self } else { self }
    }
}

impl From<f64> for Td {
    fn from(value: f64) -> Td {
        Td::new(value, 0.0, 0.0)
    }
}

impl From<Dd> for Td {
    fn from(value: Dd) -> Td {
        Td::new(value.hi, value.lo, 0.0)
    }
}

impl Neg for Td {
    type Output = Td;
    fn neg(self) -> Td {
        Td::new(-self.hi, -self.mid, -self.lo)
    }
}

impl Add for Td {
    type Output = Td;
    fn add(self, other: Td) -> Td {
        let (hi, hi_error) = two_sum(self.hi, other.hi);
        let (mid, mid_error) = two_sum(self.mid, other.mid);
        let (mid, carry) = two_sum(mid, hi_error);
        let (lo, lo_error) = two_sum(self.lo, other.lo);
        let (lo, rest) = two_sum(lo, mid_error);
        let (lo, last) = two_sum(lo, carry);
        // After cancellation the low words become the leading ones, so their errors are kept.
        let (mid, lo) = two_sum(mid, lo);
        let (hi, mid) = two_sum(hi, mid);
        Td::normalised(hi, mid, lo + (lo_error + rest + last))
    }
}

impl Sub for Td {
    type Output = Td;
    fn sub(self, other: Td) -> Td {
        self + -other
    }
}

impl Mul for Td {
    type Output = Td;
    fn mul(self, other: Td) -> Td {
        let (hi, hi_error) = self.hi.two_product(other.hi);
        let (left, left_error) = self.hi.two_product(other.mid);
        let (right, right_error) = self.mid.two_product(other.hi);
        let (cross, cross_error) = two_sum(left, right);
        let (mid, mid_error) = two_sum(cross, hi_error);
        let lo = self.hi * other.lo + self.lo * other.hi + self.mid * other.mid;
        Td::normalised(hi, mid, lo + (left_error + right_error) + (cross_error + mid_error))
    }
}

impl Mul<f64> for Td {
    type Output = Td;
    fn mul(self, factor: f64) -> Td {
        let (hi, hi_error) = self.hi.two_product(factor);
        let (mid, mid_error) = self.mid.two_product(factor);
        let (mid, carry) = two_sum(mid, hi_error);
        Td::normalised(hi, mid, self.lo * factor + mid_error + carry)
    }
}

impl Div for Td {
    type Output = Td;
    fn div(self, other: Td) -> Td {
        let first = self.hi / other.hi;
        let rest = self - other * first;
        let second = rest.hi / other.hi;
        let rest = rest - other * second;
        Td::normalised(first, second, rest.hi / other.hi)
    }
}

/// The sum of six doubles, zero only if it is exactly zero: error-free passes leave the exact sum spread over the
/// terms, and six passes over six terms order them, so no rounding comes before the last line.
pub fn exact_sum(mut terms: [f64; 6]) -> Td {
    for _ in 0..terms.len() {
        for i in 1..terms.len() {
            let (sum, error) = two_sum(terms[i], terms[i - 1]);
            terms[i] = sum;
            terms[i - 1] = error;
        }
    }
    Td::normalised(terms[5], terms[4], terms[3] + (terms[2] + (terms[1] + terms[0])))
}

//! A double-double times a power of two, so that squares, cubes and quotients of any doubles stay in range: for set-ups
//! and integrals whose result is a double although the steps to it are not.
//!
//! Relative errors are those of [`Dd`]. The part is in [1, 2) (its sign apart); zero, infinity and NaN have power 0.

use super::constants::{INVERSE_LN_2, LN_2};
use super::double_double::Dd;
use super::exponent::{carried, exp2, exponent, ldexp};
use super::series;
use super::triple_double::Td;
use crate::lanes::Lane;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// part * 2^power.
#[derive(Clone, Copy, Debug)]
pub struct Scaled {
    part: Dd,
    power: i32,
}

/// Arguments of the exponential: powers of results stay far from the range of i32, also after sums and products of some.
const END: f64 = 1e8;

/// Below, a term no longer counts in the sum.
const FAR: i32 = 240;

impl Scaled {
    /// Zero.
    pub const ZERO: Scaled = Scaled { part: Dd::ZERO, power: 0 };
    /// One.
    pub const ONE: Scaled = Scaled { part: Dd::ONE, power: 0 };

    /// Infinity.
    pub const INFINITY: Scaled = Scaled { part: Dd::new(f64::INFINITY, 0.0), power: 0 };
    /// Minus infinity.
    pub const MINUS_INFINITY: Scaled = Scaled { part: Dd::new(f64::NEG_INFINITY, 0.0), power: 0 };
    /// Not a number.
    pub const NAN: Scaled = Scaled { part: Dd::new(f64::NAN, 0.0), power: 0 };

    /// e^y of any y: 0 or infinite far beyond the range of every use.
    pub fn exp(y: Dd) -> Scaled {
        Scaled::exponentials(y)[0]
    }
    /// e^y and e^-y.
    fn exponentials(y: Dd) -> [Scaled; 2] {
        if y.hi.abs() >= END || y.hi.is_nan() {
            let beyond = |y: f64| if y > 0.0 { f64::INFINITY } else { y * 0.0 };
            return [y.hi, -y.hi].map(|y| Scaled::from(beyond(y)));
        }
        let k = Lane::round(y.hi * INVERSE_LN_2);
        let (sine, cosine) = series::sinh_cosh(Td::from(y) - LN_2 * k);
        [Scaled::new((cosine + sine).to_dd(), k as i32), Scaled::new((cosine - sine).to_dd(), -k as i32)]
    }
    /// sinh and cosh.
    pub fn sinh_cosh(self) -> (Scaled, Scaled) {
        let size = self.abs();
        if size.power() < -60 || size.is_zero() {
            return (self, Scaled::ONE + self.square().shift(-1));
        }
        let (sine, cosine) = if size.power() < -1 {
            let (sine, cosine) = series::sinh_cosh(Td::from(size.to_dd()));
            (Scaled::from(sine.to_dd()), Scaled::from(cosine.to_dd()))
        } else {
            let [grown, shrunk] = Scaled::exponentials(size.to_dd());
            ((grown - shrunk).shift(-1), (grown + shrunk).shift(-1))
        };
        (sine.signed(self.sign()), cosine)
    }
    /// part * 2^power of any part.
    #[inline]
    pub fn new(part: Dd, power: i32) -> Scaled {
        if part.hi == 0.0 || !part.hi.is_finite() {
            return Scaled { part: Dd::from(part.hi), power: 0 };
        }
        let e = exponent(part.hi);
        let part = if e.abs() <= 1000 { part.scale(exp2(-e)) } else { part.ldexp(-e) };
        Scaled { part, power: power + e }
    }
    /// The nearest double, rounded once more among the subnormal numbers.
    pub fn value(self) -> f64 {
        if self.part.hi == 0.0 { self.part.hi } else { ldexp(self.part.value(), self.power) }
    }
    /// As a double-double, each word rounded once where it leaves the normal numbers.
    pub fn to_dd(self) -> Dd {
        self.part.ldexp(self.power)
    }
    /// A rate in the range that a double-double carries, and the power of two that times take for it.
    pub fn carried(self) -> (Dd, f64) {
        let (_, time) = carried(self.power);
        (self.shift(-time).to_dd(), ldexp(1.0, time))
    }
    /// Times 2^power, exactly.
    pub fn shift(self, power: i32) -> Scaled {
        if self.is_zero() || !self.is_finite() {
            return self;
        }
        Scaled { part: self.part, power: self.power + power }
    }
    /// Exponent of the value.
    pub fn power(self) -> i32 {
        self.power
    }
    /// Absolute value.
    pub fn abs(self) -> Scaled {
        Scaled { part: self.part.abs(), power: self.power }
    }
    /// Whether it is zero.
    pub fn is_zero(self) -> bool {
        self.part.hi == 0.0
    }
    /// Whether it is below zero.
    pub fn is_negative(self) -> bool {
        self.part.hi < 0.0
    }
    /// Whether it is above zero.
    pub fn is_positive(self) -> bool {
        self.part.hi > 0.0
    }
    /// Whether it is neither infinite nor NaN.
    pub fn is_finite(self) -> bool {
        self.part.hi.is_finite()
    }
    /// Whether it is NaN.
    pub fn is_nan(self) -> bool {
        self.part.hi.is_nan()
    }
    /// Square root; NaN below zero.
    pub fn sqrt(self) -> Scaled {
        if self.is_zero() || !self.is_finite() {
            return Scaled { part: Dd::from(f64::sqrt(self.part.hi)), power: 0 };
        }
        let odd = self.power & 1;
        let part = if odd == 1 { self.part.scale(2.0) } else { self.part };
        Scaled::new(part.sqrt(), (self.power - odd) / 2)
    }
    /// The square.
    pub fn square(self) -> Scaled {
        self * self
    }
    /// -ln of a positive value.
    pub fn minus_ln(self) -> Dd {
        LN_2.to_dd() * f64::from(-self.power) - Dd::ln(self.part.hi) - Dd::from(self.part.lo / self.part.hi)
    }
    /// -1 below zero, else +1.
    pub fn sign(self) -> f64 {
        if self.is_negative() { -1.0 } else { 1.0 }
    }
    /// Times the sign of a number; that of zero and NaN is +.
    pub fn signed(self, sign: f64) -> Scaled {
        if sign < 0.0 { -self } else { self }
    }
}

/// Most powers of two that a factor of doubles can take.
const LARGEST_POWER: i32 = 1000;

/// Values over a common power of two, and that power as far as a double holds it.
pub fn over_common_power<const N: usize>(values: [Scaled; N]) -> ([Dd; N], f64) {
    let powers = values.iter().filter(|value| !value.is_zero()).map(|value| value.power());
    let power = powers.max().unwrap_or(0).clamp(-LARGEST_POWER, LARGEST_POWER);
    (values.map(|value| value.shift(-power).to_dd()), exp2(power))
}

impl Dd {
    /// ln x of a finite x > 0, to all digits also next to 1.
    pub fn ln(x: f64) -> Dd {
        let power = exponent(x);
        let mantissa = ldexp(x, -power);
        let (power, mantissa) = if mantissa > core::f64::consts::SQRT_2 {
            (power + 1, 0.5 * mantissa)
        } else {
            (power, mantissa)
        };
        // 2 artanh s, s = (x - 1)/(x + 1): s^2 < 0.0295, so that 22 terms reach 2^-112.
        let s = Dd::sum(mantissa, -1.0) / Dd::sum(mantissa, 1.0);
        let square = s.square();
        let mut sum = Dd::ZERO;
        for k in (0..22).rev() {
            sum = sum * square + Dd::ONE / Dd::from(f64::from(2 * k + 1));
        }
        LN_2.to_dd() * f64::from(power) + (s * sum).scale(2.0)
    }
}

impl From<Dd> for Scaled {
    fn from(value: Dd) -> Scaled {
        Scaled::new(value, 0)
    }
}

impl From<f64> for Scaled {
    fn from(value: f64) -> Scaled {
        Scaled::new(Dd::from(value), 0)
    }
}

impl Neg for Scaled {
    type Output = Scaled;
    fn neg(self) -> Scaled {
        Scaled { part: -self.part, power: self.power }
    }
}

impl Add for Scaled {
    type Output = Scaled;
    #[inline]
    fn add(self, other: Scaled) -> Scaled {
        if !self.is_finite() || !other.is_finite() {
            return Scaled::from(self.part.hi + other.part.hi);
        }
        let (large, small) = if other.is_zero() || (!self.is_zero() && self.power >= other.power) {
            (self, other)
        } else {
            (other, self)
        };
        let apart = large.power - small.power;
        if small.is_zero() || apart > FAR {
            return large;
        }
        Scaled::new(large.part + small.part.scale(exp2(-apart)), large.power)
    }
}

impl Sub for Scaled {
    type Output = Scaled;
    fn sub(self, other: Scaled) -> Scaled {
        self + -other
    }
}

impl Mul for Scaled {
    type Output = Scaled;
    #[inline]
    fn mul(self, other: Scaled) -> Scaled {
        let lead = self.part.hi * other.part.hi;
        if lead == 0.0 || !lead.is_finite() {
            return Scaled::from(lead);
        }
        // Parts below 2 need no test of their range.
        let (a, b) = (self.part, other.part);
        let (hi, error) = a.hi.two_product_in_range(b.hi);
        let part = Dd::ordered_sum(hi, error + (a.hi * b.lo + a.lo * b.hi));
        Scaled::new(part, self.power + other.power)
    }
}

impl Mul<f64> for Scaled {
    type Output = Scaled;
    fn mul(self, factor: f64) -> Scaled {
        self * Scaled::from(factor)
    }
}

impl Div for Scaled {
    type Output = Scaled;
    #[inline]
    fn div(self, other: Scaled) -> Scaled {
        let lead = self.part.hi / other.part.hi;
        if lead == 0.0 || !lead.is_finite() || !other.is_finite() {
            return Scaled::from(lead);
        }
        // Two quotients of doubles: what they leave is below 2^-104.
        let (first, part) = (lead, other.part);
        let rest = self.part - part.times_in_range(first);
        Scaled::new(Dd::ordered_sum(first, rest.hi / part.hi), self.power - other.power)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn range_is_no_limit() {
        let tiny = Scaled::from(5e-324);
        assert_eq!((tiny * tiny * tiny).sqrt().value(), 0.0);
        assert_eq!((tiny * tiny * tiny / (tiny * tiny)).value(), 5e-324);
        assert_eq!((Scaled::from(1e300).square().sqrt()).value(), 1e300);
        assert_eq!((Scaled::from(3.0) + Scaled::from(1e-300) - Scaled::from(3.0)).value(), 0.0);
        assert_eq!((Scaled::from(0.75) - Scaled::from(1.0)).value(), -0.25);
        assert!(
            (Scaled::ZERO / Scaled::ZERO).is_nan() && (Scaled::ONE / Scaled::ZERO).value() == f64::INFINITY
        );
        assert!((Scaled::ZERO + Scaled::from(2.0)).value() == 2.0 && (-Scaled::ONE).sqrt().is_nan());
    }
}

//! Exponential and logarithm to triple-double, for set-ups.
//!
//! Methods: e^y = 2^k (cosh r + sinh r) with |r| <= ln 2 / 2; ln(1 + x) = 2 artanh(x/(2 + x)) by its series, after a
//! power of two where |x| is not small: relative digits also next to 1.

use super::constants::{INVERSE_LN_2, LN_2};
use super::exponent::{exp2, exponent};
use super::series;
use super::triple_double::Td;
use crate::lanes::Lane;

/// Terms of artanh: |s| <= 0.2, so that s^68 < 2^-157.
const TERMS: i32 = 34;

impl Td {
    /// e^self for |self| <= 700.
    #[must_use]
    pub fn exp(self) -> Td {
        let k = Lane::round(self.hi * INVERSE_LN_2);
        let (sine, cosine) = series::sinh_cosh(self - LN_2 * k);
        (cosine + sine).scale(exp2(k as i32))
    }

    /// Natural logarithm of a normal number > 0.
    #[must_use]
    pub fn ln(self) -> Td {
        let power = exponent(self.hi);
        let mantissa = self.scale(exp2(-power));
        let (power, mantissa) = if mantissa.hi > core::f64::consts::SQRT_2 {
            (power + 1, mantissa.scale(0.5))
        } else {
            (power, mantissa)
        };
        LN_2 * f64::from(power) + near_one(mantissa - Td::ONE)
    }

    /// ln(1 + self) above -1, to all digits also next to 0.
    #[must_use]
    pub fn ln_one_plus(self) -> Td {
        if self.hi > -0.3 && self.hi < 0.45 { near_one(self) } else { (Td::ONE + self).ln() }
    }
}

/// ln(1 + x) for x in [-0.33, 0.5].
fn near_one(x: Td) -> Td {
    let s = x / (x + Td::from(2.0));
    let square = s.square();
    let mut sum = Td::ZERO;
    for k in (0..TERMS).rev() {
        sum = sum * square + Td::ONE / Td::from(f64::from(2 * k + 1));
    }
    (s * sum).scale(2.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_undoes_the_other() {
        for i in -3000..=3000 {
            let y = Td::from(f64::from(i) * 0.0123) + Td::from(f64::from(i) * 1e-19);
            let back = y.exp().ln() - y;
            assert!(back.hi.abs() < 1e-45 * (1.0 + y.hi.abs()), "{i} {back:?}");
            let x = y.scale(1.0 / 128.0);
            let back = x.ln_one_plus().exp() - Td::ONE - x;
            assert!(x.hi < -0.9 || back.hi.abs() < 1e-45, "{i} {back:?}");
        }
    }

    #[test]
    fn next_to_one_the_logarithm_keeps_its_digits() {
        for x in [1e-12, -1e-12, 3e-90, -1e-120] {
            let x = Td::from(x);
            let first = x - x.square().scale(0.5);
            let rest = (x.ln_one_plus() - first).hi - x.hi * x.hi * x.hi / 3.0;
            assert!(rest.abs() <= 1e-36 * x.hi.abs(), "{rest:e}");
        }
    }
}

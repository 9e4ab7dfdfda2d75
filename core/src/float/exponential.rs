//! Exponential and logarithm to triple-double, for set-ups.
//!
//! Methods: e^y = 2^k (cosh r + sinh r) with |r| <= ln 2 / 2; ln(1 + x) = 2 artanh(x/(2 + x)) by its series, after a
//! power of two where |x| is not small: relative digits also next to 1.

use super::exponent::{exp2, exponent};
use super::triple_double::Td;
use super::{LN_2, series};
use crate::lanes::Lane;

const INVERSE_LN_2: f64 = 1.4426950408889634;

/// Terms of artanh: |s| <= 0.2, so that s^68 < 2^-157.
const TERMS: i32 = 34;

/// e^y for |y| <= 700.
pub fn exp(y: Td) -> Td {
    let k = Lane::round(y.hi * INVERSE_LN_2);
    let (sine, cosine) = series::sinh_cosh(y - LN_2 * k);
    (cosine + sine).scale(exp2(k as i32))
}

/// ln x for a normal x > 0.
pub fn ln(x: Td) -> Td {
    let power = exponent(x.hi);
    let mantissa = x.scale(exp2(-power));
    let (power, mantissa) = if mantissa.hi > core::f64::consts::SQRT_2 {
        (power + 1, mantissa.scale(0.5))
    } else {
        (power, mantissa)
    };
    LN_2 * f64::from(power) + near_one(mantissa - Td::ONE)
}

/// ln(1 + x) for x > -1, to all digits also for small x.
pub fn ln_one_plus(x: Td) -> Td {
    if x.hi > -0.3 && x.hi < 0.45 { near_one(x) } else { ln(Td::ONE + x) }
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
            let back = ln(exp(y)) - y;
            assert!(back.hi.abs() < 1e-45 * (1.0 + y.hi.abs()), "{i} {back:?}");
            let x = y.scale(1.0 / 128.0);
            let back = exp(ln_one_plus(x)) - Td::ONE - x;
            assert!(x.hi < -0.9 || back.hi.abs() < 1e-45, "{i} {back:?}");
        }
    }

    #[test]
    fn next_to_one_the_logarithm_keeps_its_digits() {
        for x in [1e-12, -1e-12, 3e-90, -1e-120] {
            let x = Td::from(x);
            let first = x - x.square().scale(0.5);
            let rest = (ln_one_plus(x) - first).hi - x.hi * x.hi * x.hi / 3.0;
            assert!(rest.abs() <= 1e-36 * x.hi.abs(), "{rest:e}");
        }
    }
}

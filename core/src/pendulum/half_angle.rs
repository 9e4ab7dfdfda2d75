//! Sine and cosine of half an angle from the stable equilibrium in triple-double, with the digits of the nearer equilibrium and
//! beyond the range of squares: a power of two is taken out of a tiny sine.

use crate::float::Td;
use crate::float::angle_reduction::ReducedAngle;
use crate::float::exponent::{exponent, ldexp};
use crate::float::series;

/// Below 2^-200 the sine is the angle and the cosine 1, to triple-double.
const TINY: f64 = 6.2e-61;
/// Sine (over 2^power) and cosine of half the distance from the stable equilibrium, both >= 0.
pub(super) fn half_angle(reduced: &ReducedAngle, upside_down: bool, x_power: i32) -> (Td, Td, i32) {
    let (low, high) = (reduced.from_bottom, reduced.from_top);
    let near = if low.hi < high.hi { low } else { high };
    let near_stable = (low.hi < high.hi) != upside_down;
    // Half of the smallest double is still an angle: it decides the regime.
    let least = if near.hi > 0.0 { f64::from_bits(1) } else { 0.0 };
    let half = |angle: Td| Td::new((0.5 * angle.hi).max(least), 0.5 * angle.mid, 0.5 * angle.lo);
    let (small, large) = if near.hi < TINY { (half(near), Td::ONE) } else { series::sin_cos(half(near)) };
    if !near_stable {
        return (large, small, 0);
    }
    // Take the power of two out of a tiny sine, or that of x where x is larger.
    let power = if near.hi == 0.0 { x_power } else { x_power.max(exponent(near.hi) - 1) };
    if near.hi < TINY && power < -300 {
        return (Td::from(ldexp(near.hi, -1 - power)), Td::ONE, power);
    }
    (small, large, 0)
}

/// Times a power of two, with one rounding of each word.
pub(super) fn scaled(value: Td, power: i32) -> Td {
    Td::new(ldexp(value.hi, power), ldexp(value.mid, power), ldexp(value.lo, power))
}

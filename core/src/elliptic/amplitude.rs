//! An amplitude phi modulo pi, for every finite phi: the half turns as a double-double, the rest as a triple-double.

use super::phase::alternating;
use crate::float::elementary::sin_cos;
use crate::float::{Dd, HALF_PI, Td, angle_reduction, series};

/// phi = n pi + side * r, 0 <= r <= pi/2.
pub(crate) struct ReducedAmplitude {
    /// Exact up to 2^106, beyond to 2^-106 of itself.
    pub n: Dd,
    /// Whether n is odd, also beyond 2^106.
    pub odd: bool,
    /// The sign of the remainder.
    pub side: f64,
    pub r: Td,
    /// pi/2 - r.
    pub rest: Td,
}

impl ReducedAmplitude {
    /// Of a finite phi.
    pub fn new(phi: f64) -> ReducedAmplitude {
        let full = angle_reduction::reduce(phi);
        let odd = full.from_top.hi < full.from_bottom.hi;
        let even_half_turns = full.turns.scale(2.0);
        let (n, side, r, other) = if odd {
            (even_half_turns + Dd::from(full.side), -full.side, full.from_top, full.from_bottom)
        } else {
            (even_half_turns, full.side, full.from_bottom, full.from_top)
        };
        // pi/2 - r, half the difference of r and pi - r.
        let rest = (other - r).scale(0.5);
        ReducedAmplitude { n, odd, side, r, rest }
    }
}

/// Below, the sine is the angle and the cosine 1 to a double-double.
const TINY: f64 = 1e-18;

/// Sine and cosine of r in [0, pi/2] with rest = pi/2 - r.
pub(crate) fn sines(r: Td, rest: Td) -> (Dd, Dd) {
    if r.hi < TINY {
        return (r.to_dd(), Dd::ONE);
    }
    let (sine, cosine) = series::quarter_turn(r, rest);
    (sine.to_dd(), cosine.to_dd())
}

/// Sine and cosine of any finite angle.
pub(crate) fn sine_cosine(theta: f64) -> (Dd, Dd) {
    let ReducedAmplitude { odd, side, r, rest, .. } = ReducedAmplitude::new(theta);
    let parity = if odd { -1.0 } else { 1.0 };
    let (sine, cosine) = sines(r, rest);
    (sine.scale(side * parity), cosine.scale(parity))
}

/// Sine of an angle, where a correction in double is enough: to 2^-57 of itself, and quickly while |theta| is below
/// [`angle_reduction::FAR`]. NaN where it is not finite.
pub(crate) fn short_sine(theta: f64) -> Dd {
    if !theta.is_finite() {
        return Dd::from(f64::NAN);
    }
    if theta.abs() >= angle_reduction::FAR {
        return sine_cosine(theta).0;
    }
    let (half_turns, rest) = angle_reduction::half_turns(theta);
    let size = rest.abs();
    let sine =
        if size.hi > core::f64::consts::FRAC_PI_4 { sin_cos(HALF_PI - size).1 } else { sin_cos(size).0 };
    sine.scale(1f64.copysign(rest.hi) * alternating(half_turns))
}

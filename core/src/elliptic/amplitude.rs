//! An amplitude phi modulo pi, for every finite phi: the half turns as a double-double, the rest as a triple-double.

use crate::float::{Dd, Td, angle_reduction, series};

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

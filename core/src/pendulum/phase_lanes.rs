//! The phase of rows of (theta, velocity, omega0), each a state of its own: over lanes, in double.
//!
//! With s, c = sine and cosine of half the distance from the bottom, x = |velocity|/2 omega0, m = s^2 + x^2 and
//! R = R_F(x^2/m, c^2, 1):
//!   libration  pi s R/(2 sqrt(m) K(m)) going up, that from pi (on the side of s) going down,
//!   rotation   2 pi times the whole turns, and pi s R/K(1/m).
//! What the lanes leave out is asked of an [`Orbit`]. Source: as action.rs; DLMF 22.15(ii), 19.25.31.

use super::action_lanes::{LEAST, Ratio, column};
use super::orbit::Orbit;
use crate::elliptic::integrals::duplication_lanes::rf;
use crate::float::unnormalised::Unnormalised;
use crate::float::{Dd, PI};
use crate::lanes::{Formula, Lane};

/// The phase.
struct PhaseOfState;

impl Formula<3, 1> for PhaseOfState {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [theta, velocity, omega]: [L; 3]) -> [L; 1] {
        let (zero, one, nan) = (L::splat(0.0), L::splat(1.0), L::splat(f64::NAN));
        let Ratio { state, complement, rotation, valid, .. } = Ratio::new([theta, velocity, omega]);
        let m = state.m.hi;
        let valid = L::select(m.less(L::splat(LEAST)), nan, valid);
        // The nearest even number of half turns, and the sine of half of what is left.
        let even = zero.less(state.parity);
        let below = state.sine.hi.less(zero);
        let step = L::select(below, -one, one);
        let turns = L::select(even, state.half_turns, state.half_turns + step);
        let s = Unnormalised::select(even, state.sine, state.high.root().scale(-step));
        // What is left out must not keep the others waiting: a NaN is near.
        let along = Dd::from_double(state.x_square.hi / m * valid);
        let arc = rf([along, Dd::from_double(state.c_square.hi), Dd::from_double(one)]);
        let k = complement.k();
        let divisor = state.m.root() * Unnormalised::from_double(k + k);
        let divisor = Unnormalised::select(rotation, Unnormalised::from_double(k), divisor);
        let phase = (s * Unnormalised::from(arc) * Unnormalised::splat(PI)).over(divisor);
        let phase = phase.hi + phase.lo;
        let (base, error) = turns.two_product(L::splat(PI.hi));
        let turned = base + (turns.mul_add(L::splat(PI.lo), error) + phase);
        let down = L::select(s.hi.less(zero), L::splat(-PI.hi), L::splat(PI.hi)) - phase;
        let swung = L::select(velocity.less(zero), down, phase);
        [L::select(rotation, turned, swung) * valid]
    }
}

/// Phase of rows of (theta, velocity, omega0), in (-pi, pi] in libration, along with the angle in rotation: every row an orbit
/// of its own.
///
/// NaN on the separatrix and where an argument is out of the domain of [`Orbit`]; panics where the lengths differ. **Error**
/// and source of [`Orbit::phase`].
///
/// ```
/// let mut phase = [0.0; 3];
/// libration::pendulum::phase_into([&[1.0, -1.0, 7.0], &[0.0, 0.0, 3.0], &[1.0; 3]], &mut phase);
/// assert_eq!(phase.map(|phase| format!("{phase:.6}")), ["1.570796", "-1.570796", "6.916943"]);
/// ```
pub fn phase_into(states: [&[f64]; 3], phase: &mut [f64]) {
    column(&PhaseOfState, states, phase, |orbit: &Orbit| orbit.phase(0.0));
}

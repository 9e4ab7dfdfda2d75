//! kappa^2 and 1 - kappa^2 of rows of (theta, velocity, omega0), each a state of its own: over lanes, rounded from double-doubles.
//!
//! 1 - kappa^2 is cos^2(theta/2) - (velocity/2 omega0)^2, never 1 less kappa^2. What is next to the separatrix, at the ends of the
//! range or not finite is asked of an [`Orbit`]. Source: as state.rs.

use super::action_lanes::{LEAST, Ratio, column};
use super::orbit::Orbit;
use crate::lanes::{Formula, Lane};

/// kappa^2.
struct RatioOfState;

impl Formula<3, 1> for RatioOfState {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, arguments: [L; 3]) -> [L; 1] {
        let Ratio { state, valid, .. } = Ratio::new(arguments);
        let kept = L::select(state.m.hi.less(L::splat(LEAST)), L::splat(f64::NAN), valid);
        [(state.m.hi + state.m.lo) * kept]
    }
}

/// 1 - kappa^2.
struct ComplementOfState;

impl Formula<3, 1> for ComplementOfState {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, arguments: [L; 3]) -> [L; 1] {
        let Ratio { state, valid, .. } = Ratio::new(arguments);
        [(state.mc.hi + state.mc.lo) * valid]
    }
}

/// Energy over that at the top of rows of (theta, velocity, omega0): every row an orbit of its own.
///
/// NaN where an argument is out of the domain of [`Orbit`]; panics where the lengths differ. **Error** and source of
/// [`Orbit::energy_ratio`].
///
/// ```
/// let mut ratio = [0.0; 2];
/// libration::pendulum::energy_ratio_into([&[0.0; 2], &[1.0, -3.0], &[1.0; 2]], &mut ratio);
/// assert_eq!(ratio, [0.25, 2.25]);
/// ```
pub fn energy_ratio_into(states: [&[f64]; 3], ratio: &mut [f64]) {
    column(&RatioOfState, states, ratio, Orbit::energy_ratio);
}

/// 1 less the energy over that at the top of rows of (theta, velocity, omega0), negative in rotation: every row an orbit of its own.
///
/// NaN where an argument is out of the domain of [`Orbit`]; panics where the lengths differ. **Error** and source of
/// [`Orbit::energy_ratio_c`].
///
/// ```
/// let mut rest = [0.0; 2];
/// libration::pendulum::energy_ratio_c_into([&[0.0; 2], &[1.0, -3.0], &[1.0; 2]], &mut rest);
/// assert_eq!(rest, [0.75, -1.25]);
/// ```
pub fn energy_ratio_c_into(states: [&[f64]; 3], rest: &mut [f64]) {
    column(&ComplementOfState, states, rest, Orbit::energy_ratio_c);
}

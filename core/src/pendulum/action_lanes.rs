//! Frequency, period and action of rows of (theta, velocity, omega0), each a state of its own: over lanes, in double.
//!
//! With kappa^2 = m and y = 1 - m in libration, y = (m - 1)/m in rotation, both from m and 1 - m without cancellation:
//!   libration  frequency = pi omega0/2 K(y),       J = (8 omega0/pi) m B(y),
//!   rotation   frequency = pi kappa omega0/K(y),   J = (4 omega0/pi) kappa E(y).
//! All integrals are sums of one sign (complete_lanes.rs). What is next to the separatrix, at the ends of the range or not
//! finite is asked of an [`Orbit`]. Source: as action.rs.

use super::frequency::Frequency;
use super::orbit::Orbit;
use super::state_lanes::StateLanes;
use crate::elliptic::integrals::complete_lanes::Complement;
use crate::float::angle_reduction::FAR;
use crate::float::unnormalised::Unnormalised;
use crate::float::{Dd, PI};
use crate::lanes::{Columns, Evaluation, Formula, Lane};

/// Least |1 - kappa^2|: of it, as the difference of two double-doubles, 2^-60 of itself is lost here.
const LEAST_COMPLEMENT: f64 = 1e-12;
/// omega0 and velocity/2 omega0 within which no square leaves the range.
const SMALL: f64 = 1e-100;
const LARGE: f64 = 1e100;
/// Least kappa^2 and action: of smaller ones the errors of products are below the range.
pub(super) const LEAST: f64 = 1e-280;

/// kappa^2 and what the integrals take.
pub(super) struct Ratio<L: Lane> {
    pub state: StateLanes<L>,
    /// kappa in rotation, 1 in libration.
    pub k: Unnormalised<L>,
    pub complement: Complement<L>,
    pub rotation: L::Mask,
    /// 1 where the formulas hold, NaN elsewhere.
    pub valid: L,
}

impl<L: Lane> Ratio<L> {
    #[inline(always)]
    pub fn new([theta, velocity, omega]: [L; 3]) -> Self {
        let (one, nan) = (L::splat(1.0), L::splat(f64::NAN));
        let state = StateLanes::new(theta, velocity, Unnormalised::from_double(omega));
        let (m, mc) = (state.m.hi + state.m.lo, state.mc.hi + state.mc.lo);
        let rotation = mc.less(L::splat(0.0));
        let y = L::select(rotation, -mc / m, mc);
        let k = Unnormalised::select(rotation, state.m, Unnormalised::from_double(one)).root();
        // Every comparison is false for NaN.
        let valid = L::select(L::splat(LEAST_COMPLEMENT).less(mc.abs()), one, nan);
        let valid = L::select(theta.abs().less(L::splat(FAR)), valid, nan);
        let valid = L::select(state.x.hi.abs().less(L::splat(LARGE)), valid, nan);
        let valid = L::select(L::splat(SMALL).less(omega), valid, nan);
        let valid = L::select(omega.less(L::splat(LARGE)), valid, nan);
        Ratio { complement: Complement::new(y), state, k, rotation, valid }
    }
}

/// 4/pi.
const FOUR_OVER_PI: Dd = Dd::new(1.2732395447351628, -7.871470670072994e-17);

/// The mean angular frequency.
struct FrequencyOfState;

impl Formula<3, 1> for FrequencyOfState {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [theta, velocity, omega]: [L; 3]) -> [L; 1] {
        let Ratio { k, complement, rotation, valid, .. } = Ratio::new([theta, velocity, omega]);
        let part = L::select(rotation, L::splat(1.0).copysign(velocity), L::splat(0.5));
        let rate = k * Unnormalised::from_double(omega * part) * Unnormalised::splat(PI);
        let frequency = rate.over(Unnormalised::from_double(complement.k()));
        [(frequency.hi + frequency.lo) * valid]
    }
}

/// The period.
struct PeriodOfState;

impl Formula<3, 1> for PeriodOfState {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, arguments: [L; 3]) -> [L; 1] {
        let Ratio { k, complement, rotation, valid, .. } = Ratio::new(arguments);
        let quarters = complement.k() * L::select(rotation, L::splat(2.0), L::splat(4.0));
        let speed = k * Unnormalised::from_double(arguments[2]);
        let period = Unnormalised::from_double(quarters).over(speed);
        [(period.hi + period.lo) * valid]
    }
}

/// The action.
struct ActionOfState;

impl Formula<3, 1> for ActionOfState {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, arguments: [L; 3]) -> [L; 1] {
        let Ratio { state, k, complement, rotation, valid } = Ratio::new(arguments);
        let integral = L::select(rotation, complement.e(), complement.b() + complement.b());
        let share = Unnormalised::select(rotation, k, state.m) * Unnormalised::from_double(integral);
        let action = share * Unnormalised::from_double(arguments[2]) * Unnormalised::splat(FOUR_OVER_PI);
        let action = action.hi + action.lo;
        let kept = L::select(state.m.hi.less(L::splat(LEAST)), L::splat(f64::NAN), valid);
        let kept = L::select(action.less(L::splat(LEAST)), L::splat(f64::NAN), kept);
        [action * kept]
    }
}

/// A function of each row of (theta, velocity, omega0); what the lanes leave out by `careful`.
pub(super) fn column(
    formula: &impl Formula<3, 1>,
    states: [&[f64]; 3],
    values: &mut [f64],
    careful: impl Fn(&Orbit) -> f64,
) {
    Columns::new(states, [&mut *values]).of(formula);
    for (row, value) in values.iter_mut().enumerate() {
        if value.is_nan() {
            let [theta, velocity, omega0] = states.map(|column| column[row]);
            let orbit = Frequency::from_omega0(omega0).and_then(|omega0| Orbit::new(theta, velocity, omega0));
            *value = orbit.map_or(f64::NAN, |orbit| careful(&orbit));
        }
    }
}

/// Mean angular frequency of rows of (theta, velocity, omega0), negative in rotation downwards: every row an orbit of its own.
///
/// NaN where an argument is out of the domain of [`Orbit`]; panics where the lengths differ. **Error** and source of
/// [`Orbit::frequency`].
///
/// ```
/// let mut frequency = [0.0; 2];
/// libration::pendulum::frequency_into([&[0.0; 2], &[1.0, -3.0], &[1.0; 2]], &mut frequency);
/// assert_eq!(format!("{:.9} {:.9}", frequency[0], frequency[1]), "0.931808392 -2.604008191");
/// ```
pub fn frequency_into(states: [&[f64]; 3], frequency: &mut [f64]) {
    column(&FrequencyOfState, states, frequency, Orbit::frequency);
}

/// Period of rows of (theta, velocity, omega0), of one turn in rotation: every row an orbit of its own.
///
/// NaN where an argument is out of the domain of [`Orbit`]; panics where the lengths differ. **Error** and source of
/// [`Orbit::period`].
///
/// ```
/// let mut period = [0.0; 2];
/// libration::pendulum::period_into([&[2.0, 0.0], &[0.0, 3.0], &[1.0; 2]], &mut period);
/// assert_eq!(format!("{:.9} {:.9}", period[0], period[1]), "8.349752927 2.412889994");
/// ```
pub fn period_into(states: [&[f64]; 3], period: &mut [f64]) {
    column(&PeriodOfState, states, period, Orbit::period);
}

/// Action of rows of (theta, velocity, omega0): every row an orbit of its own.
///
/// NaN where an argument is out of the domain of [`Orbit`]; panics where the lengths differ. **Error** and source of
/// [`Orbit::action`].
///
/// ```
/// let mut action = [0.0; 2];
/// libration::pendulum::action_into([&[0.0; 2], &[1.0, 3.0], &[1.0; 2]], &mut action);
/// assert_eq!(format!("{:.9} {:.9}", action[0], action[1]), "0.517315809 2.631984646");
/// ```
pub fn action_into(states: [&[f64]; 3], action: &mut [f64]) {
    column(&ActionOfState, states, action, Orbit::action);
}

//! The ufuncs of the pendulum: which function of the core answers a row, and what is set up once for it.
//!
//! Two paths. `orbit_*` takes an orbit by its exact factors and is meant for one orbit and many times; `state_*` and
//! `advance` take rows with states of their own. The elliptic functions are in elliptic.rs, the springs in oscillator.rs.

use libration::pendulum;
use libration::{Frequency, Orbit, Sensitivity, Turns};
use pyo3::prelude::*;

use crate::ufunc::{add, each, nothing, whole};

/// Adds the ufuncs of the pendulum.
pub fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    add(
        module,
        "factors",
        frequency,
        each(|frequency: &Frequency, []| <[f64; 3]>::from(frequency.factors())),
    )?;

    add(module, "orbit_theta", orbit, whole::<[f64; 1], _>(theta))?;
    add(module, "orbit_velocity", orbit, whole::<[f64; 1], _>(velocity))?;
    add(module, "orbit_motion", orbit, whole::<[f64; 2], _>(motion))?;
    add(module, "turns", orbit, each(turns))?;
    add(module, "orbit_phase", orbit, each(|orbit: &Orbit, [t]| [orbit.phase(t)]))?;
    add(
        module,
        "orbit_sensitivities",
        |of| Some(Sensitivity::new(&orbit(of)?)),
        whole::<[f64; 6], _>(slopes),
    )?;
    add(module, "orbit_second_sensitivities", orbit, each(second_slopes))?;

    add(module, "state_theta", nothing, whole::<[f64; 1], _>(state_theta))?;
    add(module, "state_velocity", nothing, whole::<[f64; 1], _>(state_velocity))?;
    add(module, "state_motion", nothing, whole::<[f64; 2], _>(state_motion))?;
    add(module, "state_sensitivities", nothing, whole::<[f64; 6], _>(state_slopes))?;
    add(module, "advance", nothing, whole::<[f64; 2], _>(advance))?;

    add(module, "action", nothing, whole::<[f64; 1], _>(action))?;
    add(module, "frequency", nothing, whole::<[f64; 1], _>(mean_frequency))?;
    add(module, "phase", nothing, whole::<[f64; 1], _>(phase))?;
    add(module, "from_action_phase", nothing, whole::<[f64; 2], _>(from_action_phase))?;
    add(module, "harmonic_distortion", nothing, whole::<[f64; 1], _>(harmonic_distortion))
}

fn theta(orbit: &Orbit, [t]: [&[f64]; 1], _: usize, [theta]: [&mut [f64]; 1]) {
    orbit.theta_into(t, theta);
}

fn velocity(orbit: &Orbit, [t]: [&[f64]; 1], _: usize, [velocity]: [&mut [f64]; 1]) {
    orbit.velocity_into(t, velocity);
}

fn motion(orbit: &Orbit, [t]: [&[f64]; 1], _: usize, [theta, velocity]: [&mut [f64]; 2]) {
    orbit.motion_into(t, theta, velocity);
}

fn state_theta((): &(), operands: [&[f64]; 4], rows: usize, [theta]: [&mut [f64]; 1]) {
    pendulum::motion_into(operands, [theta, &mut vec![0.0; rows]]);
}

fn state_velocity((): &(), operands: [&[f64]; 4], rows: usize, [velocity]: [&mut [f64]; 1]) {
    pendulum::motion_into(operands, [&mut vec![0.0; rows], velocity]);
}

fn state_motion((): &(), operands: [&[f64]; 4], _: usize, columns: [&mut [f64]; 2]) {
    pendulum::motion_into(operands, columns);
}

fn advance((): &(), states: [&[f64]; 4], _: usize, columns: [&mut [f64]; 2]) {
    libration::advance_into(states, columns);
}

fn action((): &(), states: [&[f64]; 3], _: usize, [action]: [&mut [f64]; 1]) {
    pendulum::action_into(states, action);
}

fn mean_frequency((): &(), states: [&[f64]; 3], _: usize, [frequency]: [&mut [f64]; 1]) {
    pendulum::frequency_into(states, frequency);
}

fn phase((): &(), states: [&[f64]; 3], _: usize, [phase]: [&mut [f64]; 1]) {
    pendulum::phase_into(states, phase);
}

fn from_action_phase((): &(), rows: [&[f64]; 4], _: usize, columns: [&mut [f64]; 2]) {
    pendulum::state_of_into(rows, columns);
}

fn state_slopes((): &(), rows: [&[f64]; 4], _: usize, columns: [&mut [f64]; 6]) {
    pendulum::sensitivities_into(rows, columns);
}

fn harmonic_distortion((): &(), [theta_max]: [&[f64]; 1], _: usize, [distortion]: [&mut [f64]; 1]) {
    pendulum::harmonic_distortion_into(theta_max, distortion);
}

/// One orbit, its frequency by the exact factors.
fn orbit([theta0, velocity0, a, b, c]: [f64; 5]) -> Option<Orbit> {
    Orbit::new(theta0, velocity0, Frequency::from_factors(a, b, c).ok()?).ok()
}

/// Whole turns and the rest of the angle.
fn turns(orbit: &Orbit, [t]: [f64; 1]) -> (i64, f64) {
    let Turns { count, angle } = orbit.turns(t);
    (count, angle)
}

/// Row by row of the matrix.
fn slopes(of: &Sensitivity, [t]: [&[f64]; 1], _: usize, columns: [&mut [f64]; 6]) {
    of.at_into(t, columns);
}

/// The upper halves of the symmetric matrices, row by row.
fn second_slopes(orbit: &Orbit, [t]: [f64; 1]) -> [f64; 12] {
    let [angle, velocity] =
        orbit.second_sensitivities(t).matrices().map(|[[a, b, c], [_, d, e], [_, _, f]]| [a, b, c, d, e, f]);
    let mut halves = [0.0; 12];
    halves[..6].copy_from_slice(&angle);
    halves[6..].copy_from_slice(&velocity);
    halves
}

/// The frequency of a row.
fn frequency([omega0]: [f64; 1]) -> Option<Frequency> {
    Frequency::from_omega0(omega0).ok()
}

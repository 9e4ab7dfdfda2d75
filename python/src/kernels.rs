//! The ufuncs of the pendulum: which function of the core answers a row, and what is set up once for it.
//!
//! Two paths. `orbit_*` takes an orbit by its start and its exact factors: one orbit and many times, or rows that are stated
//! otherwise than by angle, velocity and omega0; `state_*` and `advance` take rows with states of their own. The elliptic functions are in elliptic.rs, the springs in oscillator.rs.

use libration::pendulum;
use libration::pendulum::action::state_of;
use libration::{Frequency, Orbit, OrbitStart, Regime, Sensitivity, Turns};
use pyo3::prelude::*;

use crate::ufunc::{add, each, nothing, whole};

/// Adds the ufuncs of the pendulum.
pub fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    let factors = |frequency: &Frequency, []: [f64; 0]| <[f64; 3]>::from(frequency.factors());
    add(module, "factors", frequency, each(factors))?;
    add(module, "factors_omega2", |[omega2]| Frequency::from_omega2(omega2).ok(), each(factors))?;
    let of_length = |[length, gravity]: [f64; 2]| Frequency::from_gravity_length(gravity, length).ok();
    add(module, "factors_length", of_length, each(factors))?;

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
    add(module, "orbit_next_crossing", orbit, each(next_crossing))?;
    constants(module)?;

    add(module, "state_theta", nothing, whole::<[f64; 1], _>(state_theta))?;
    add(module, "state_velocity", nothing, whole::<[f64; 1], _>(state_velocity))?;
    add(module, "state_motion", nothing, whole::<[f64; 2], _>(state_motion))?;
    add(module, "state_sensitivities", nothing, whole::<[f64; 6], _>(state_slopes))?;
    add(module, "advance", nothing, whole::<[f64; 2], _>(advance))?;

    let by_factors = |[a, b, c]: [f64; 3]| Frequency::from_factors(a, b, c).ok();
    add(module, "orbit_from_action_phase", by_factors, each(state_of_row))?;
    add(module, "orbit_advance", by_factors, each(advance_row))?;
    add(module, "action", nothing, whole::<[f64; 1], _>(action))?;
    add(module, "frequency", nothing, whole::<[f64; 1], _>(mean_frequency))?;
    add(module, "period", nothing, whole::<[f64; 1], _>(period))?;
    add(module, "phase", nothing, whole::<[f64; 1], _>(phase))?;
    add(module, "energy_ratio", nothing, whole::<[f64; 1], _>(energy_ratio))?;
    add(module, "energy_ratio_c", nothing, whole::<[f64; 1], _>(energy_ratio_c))?;
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

fn period((): &(), states: [&[f64]; 3], _: usize, [period]: [&mut [f64]; 1]) {
    pendulum::period_into(states, period);
}

fn phase((): &(), states: [&[f64]; 3], _: usize, [phase]: [&mut [f64]; 1]) {
    pendulum::phase_into(states, phase);
}

fn energy_ratio((): &(), states: [&[f64]; 3], _: usize, [ratio]: [&mut [f64]; 1]) {
    pendulum::energy_ratio_into(states, ratio);
}

fn energy_ratio_c((): &(), states: [&[f64]; 3], _: usize, [rest]: [&mut [f64]; 1]) {
    pendulum::energy_ratio_c_into(states, rest);
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

/// A number that an orbit keeps.
type Kept = fn(&Orbit) -> f64;

/// What an orbit keeps: nothing but the orbit goes into them.
fn constants(module: &Bound<'_, PyModule>) -> PyResult<()> {
    let kept = |value: &f64, []: [f64; 0]| [*value];
    let named: [(&str, Kept); 8] = [
        ("orbit_period", Orbit::period),
        ("orbit_theta_max", Orbit::theta_max),
        ("orbit_energy_ratio", Orbit::energy_ratio),
        ("orbit_energy_ratio_c", Orbit::energy_ratio_c),
        ("orbit_energy", Orbit::energy),
        ("orbit_action", Orbit::action),
        ("orbit_frequency", Orbit::frequency),
        ("orbit_regime", |orbit| match orbit.regime() {
            Regime::Rest => 0.0,
            Regime::Libration => 1.0,
            Regime::Separatrix => 2.0,
            Regime::Rotation => 3.0,
        }),
    ];
    for (name, value) in named {
        add(module, name, move |of| Some(value(&orbit(of)?)), each(kept))?;
    }
    Ok(())
}

/// One orbit by its start, its frequency by the exact factors.
fn orbit([angle, value, direction, kind, a, b, c]: [f64; 7]) -> Option<Orbit> {
    let start = OrbitStart::from_operands([angle, value, direction, kind])?;
    Orbit::from_start(start, Frequency::from_factors(a, b, c).ok()?).ok()
}

/// The first time from the second operand on; NaN where the angle is not passed.
fn next_crossing(orbit: &Orbit, [theta, after]: [f64; 2]) -> [f64; 1] {
    [orbit.next_time(theta, after).ok().flatten().unwrap_or(f64::NAN)]
}

/// The state of an action and a phase; the direction is one of 0, 1 and -1.
fn state_of_row(frequency: &Frequency, [action, phase, direction]: [f64; 3]) -> [f64; 2] {
    state_of(action, phase, direction, *frequency).map_or([f64::NAN; 2], <[f64; 2]>::from)
}

/// A state a step later.
fn advance_row(frequency: &Frequency, [theta, velocity, dt]: [f64; 3]) -> [f64; 2] {
    libration::advance(theta, velocity, dt, *frequency).into()
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

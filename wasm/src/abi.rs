//! The functions that JavaScript calls. `unsafe` stands in this file and abi/ only: in the attribute that gives a function its name
//! outside. No pointer is read.
//!
//! Column 0 holds arguments, the next ones results. A function that makes an object returns its number, one that leaves
//! a list its length, one that can refuse 1; where it refuses it returns 0 (a list: -1), and the text holds the refused
//! argument, its value and what is allowed, each on a line. The text that a function reads is the name of a formula.

use crate::objects::{Objects, ask, drop};
use crate::workspace::{ROWS, leave, say, with_columns, with_text};
use exchange::{both, each, frequency, listed, made, refuse};
use libration::STANDARD_GRAVITY;
use libration::approx::{
    ANGLES, AngleApproximation, AngleFormula, Entry, NUMERICALS, NumericalFormula, NumericalSolution,
};
use libration::{Orbit, Regime, Turns, VERSION};
use std::cell::RefCell;

thread_local! {
    static ORBITS: RefCell<Objects<Orbit>> = const { RefCell::new(Objects::new()) };
    static NUMERICAL_SOLUTIONS: RefCell<Objects<NumericalSolution>> = const { RefCell::new(Objects::new()) };
    static ANGLE_APPROXIMATIONS: RefCell<Objects<AngleApproximation>> = const { RefCell::new(Objects::new()) };
}

/// Leaves the version of the core in the text.
#[unsafe(no_mangle)]
pub extern "C" fn version() {
    say(VERSION.to_string());
}

// ------------------------------------------------------------------------------------------------ one orbit

/// An orbit. Of the last four arguments those count whose bit is set in `given`: 1, 2, 4, 8 in their order.
#[unsafe(no_mangle)]
pub extern "C" fn orbit_new(
    theta0: f64,
    velocity0: f64,
    omega0: f64,
    omega2: f64,
    length: f64,
    gravity: f64,
    given: u32,
) -> u32 {
    let orbit = frequency([omega0, omega2, length, gravity], given)
        .and_then(|frequency| Orbit::new(theta0, velocity0, frequency));
    made(&ORBITS, orbit)
}

/// Drops an orbit.
#[unsafe(no_mangle)]
pub extern "C" fn orbit_drop(orbit: u32) {
    drop(&ORBITS, orbit);
}

/// Column 0: omega0, omega2, period, theta_max, energy_ratio, energy_ratio_c, energy, lowest and highest angle, standard gravity. Returns
/// the regime: rest, libration, separatrix, rotation from 0 on.
#[unsafe(no_mangle)]
pub extern "C" fn orbit_facts(orbit: u32) -> u32 {
    let regime = ask(&ORBITS, orbit, |orbit| {
        let extremes = orbit.extremes();
        let facts = [
            orbit.omega0(),
            orbit.omega2(),
            orbit.period(),
            orbit.theta_max(),
            orbit.energy_ratio(),
            orbit.energy_ratio_c(),
            orbit.energy(),
            extremes.lowest,
            extremes.highest,
            STANDARD_GRAVITY,
        ];
        with_columns(|columns| columns[0][..facts.len()].copy_from_slice(&facts));
        match orbit.regime() {
            Regime::Rest => 0,
            Regime::Libration => 1,
            Regime::Separatrix => 2,
            Regime::Rotation => 3,
        }
    });
    regime.unwrap_or(0)
}

/// t to theta and velocity.
#[unsafe(no_mangle)]
pub extern "C" fn orbit_motion(orbit: u32, rows: usize) {
    ask(&ORBITS, orbit, |orbit| {
        with_columns(|[t, theta, velocity, ..]| {
            orbit.motion_into(&t[..rows], &mut theta[..rows], &mut velocity[..rows]);
        });
    });
}

/// t to theta.
#[unsafe(no_mangle)]
pub extern "C" fn orbit_theta(orbit: u32, rows: usize) {
    ask(&ORBITS, orbit, |orbit| {
        with_columns(|[t, theta, ..]| orbit.theta_into(&t[..rows], &mut theta[..rows]));
    });
}

/// theta and, in the last column, velocity to kinetic and potential energy.
#[unsafe(no_mangle)]
pub extern "C" fn orbit_energies(orbit: u32, rows: usize) {
    ask(&ORBITS, orbit, |orbit| {
        with_columns(|[theta, kinetic, potential, .., velocity]| {
            for (row, velocity) in velocity.iter().enumerate().take(rows) {
                (kinetic[row], potential[row]) =
                    (orbit.kinetic_energy(*velocity), orbit.potential_energy(theta[row]));
            }
        });
    });
}

/// Angles to the speed on the separatrix.
#[unsafe(no_mangle)]
pub extern "C" fn orbit_separatrix_velocity(orbit: u32, rows: usize) {
    ask(&ORBITS, orbit, |orbit| each(rows, |theta| orbit.separatrix_velocity(theta)));
}

/// t to whole turns and the rest of the angle.
#[unsafe(no_mangle)]
pub extern "C" fn orbit_turns(orbit: u32, rows: usize) {
    ask(&ORBITS, orbit, |orbit| {
        with_columns(|[t, count, angle, ..]| {
            for ((t, count), angle) in t.iter().zip(count).zip(angle).take(rows) {
                let turns: Turns = orbit.turns(*t);
                (*count, *angle) = (turns.count as f64, turns.angle);
            }
        });
    });
}

/// The times at which an angle is passed, as the list.
#[unsafe(no_mangle)]
pub extern "C" fn orbit_times(orbit: u32, theta: f64, start: f64, stop: f64) -> i32 {
    ask(&ORBITS, orbit, |orbit| listed(orbit.times(theta, start, stop))).unwrap_or(0)
}

/// The first time from one on at which an angle is passed, as a list of one or none.
#[unsafe(no_mangle)]
pub extern "C" fn orbit_next_time(orbit: u32, theta: f64, after: f64) -> i32 {
    let next =
        |orbit: &mut Orbit| listed(orbit.next_time(theta, after).map(|time| time.into_iter().collect()));
    ask(&ORBITS, orbit, next).unwrap_or(0)
}

/// The times at which the motion turns back, as the list.
#[unsafe(no_mangle)]
pub extern "C" fn orbit_turning_times(orbit: u32, start: f64, stop: f64) -> i32 {
    ask(&ORBITS, orbit, |orbit| listed(orbit.turning_times(start, stop))).unwrap_or(0)
}

// ------------------------------------------------------------------------------------------------ formulas by name

/// The entries of a registry, one a line, cells parted by tabs: pattern, formula, source, stated range in words, where
/// undefined. Columns 0 and 1: the stated range. Columns 2, 3, 4: the least N, the most, the step; 0 where there is none.
/// Of a numerical solution that takes a step the least N is 1. Registries: angle, period, numerical from 0 on; the period's is in
/// the second module. Returns how many entries.
#[unsafe(no_mangle)]
pub extern "C" fn registry(kind: u32) -> usize {
    let entries: &[Entry] = match kind {
        0 => &ANGLES,
        #[cfg(feature = "whole")]
        1 => &libration::approx::PERIODS,
        _ => &NUMERICALS,
    };
    with_columns(|[low, high, least, most, step, _]| {
        for (i, entry) in entries.iter().enumerate().take(ROWS) {
            [low[i], high[i]] = entry.stated_range.unwrap_or([f64::NAN; 2]);
            let orders = entry.orders.map(|orders| [orders.least, orders.most, orders.step]);
            let none = [u32::from(kind == 2 && NumericalFormula::takes_step(entry)), 0, 0];
            [least[i], most[i], step[i]] = orders.unwrap_or(none).map(f64::from);
        }
    });
    let line = |entry: &Entry| {
        [entry.pattern().as_str(), entry.formula, entry.source, entry.stated, entry.undefined].join("\t")
    };
    say(entries.iter().map(line).collect::<Vec<_>>().join("\n"));
    entries.len()
}

/// The formula of the angle named by the text, for an orbit.
#[unsafe(no_mangle)]
pub extern "C" fn angle_new(orbit: u32) -> u32 {
    let formula = with_text(AngleFormula::named);
    let made_for =
        |orbit: &mut Orbit| made(&ANGLE_APPROXIMATIONS, formula.and_then(|formula| formula.of(orbit)));
    ask(&ORBITS, orbit, made_for).unwrap_or(0)
}

/// 1 if the text names a formula of the angle.
#[unsafe(no_mangle)]
pub extern "C" fn angle_named() -> u32 {
    with_text(AngleFormula::named).map_or_else(|domain| (refuse(&domain), 0).1, |_| 1)
}

/// Drops an approximation.
#[unsafe(no_mangle)]
pub extern "C" fn angle_drop(approximation: u32) {
    drop(&ANGLE_APPROXIMATIONS, approximation);
}

/// t to the approximate angle.
#[unsafe(no_mangle)]
pub extern "C" fn angle_theta(approximation: u32, rows: usize) {
    ask(&ANGLE_APPROXIMATIONS, approximation, |approximation| {
        with_columns(|[t, theta, ..]| approximation.theta_into(&t[..rows], &mut theta[..rows]));
    });
}

/// t to the approximate minus the exact angle.
#[unsafe(no_mangle)]
pub extern "C" fn angle_difference(approximation: u32, rows: usize) {
    ask(&ANGLE_APPROXIMATIONS, approximation, |approximation| each(rows, |t| approximation.difference(t)));
}

/// Period of an approximation.
#[unsafe(no_mangle)]
pub extern "C" fn angle_period(approximation: u32) -> f64 {
    ask(&ANGLE_APPROXIMATIONS, approximation, |approximation| approximation.period()).unwrap_or(f64::NAN)
}

/// Column 0: the largest difference over some periods, when it is reached, since when there is no value.
#[unsafe(no_mangle)]
pub extern "C" fn angle_largest_error(approximation: u32, periods: f64) -> u32 {
    let found =
        ask(&ANGLE_APPROXIMATIONS, approximation, |approximation| approximation.largest_error(periods));
    match found {
        None => 0,
        Some(Err(domain)) => (refuse(&domain), 0).1,
        Some(Ok(error)) => {
            let facts = [error.difference, error.t, error.undefined_from];
            with_columns(|columns| columns[0][..facts.len()].copy_from_slice(&facts));
            1
        }
    }
}

/// The solution from 0 to a time by the scheme named by the text, with a step or (NaN) without, for an orbit.
#[unsafe(no_mangle)]
pub extern "C" fn numerical_new(orbit: u32, step: f64, until: f64) -> u32 {
    let formula = with_text(|name| NumericalFormula::named(name, (!step.is_nan()).then_some(step)));
    let solved =
        |orbit: &mut Orbit| made(&NUMERICAL_SOLUTIONS, formula.and_then(|formula| formula.of(orbit, until)));
    ask(&ORBITS, orbit, solved).unwrap_or(0)
}

/// 1 if the text names a scheme that takes this step, or (NaN) none.
#[unsafe(no_mangle)]
pub extern "C" fn numerical_named(step: f64) -> u32 {
    let formula = with_text(|name| NumericalFormula::named(name, (!step.is_nan()).then_some(step)));
    formula.map_or_else(|domain| (refuse(&domain), 0).1, |_| 1)
}

/// Drops a solution.
#[unsafe(no_mangle)]
pub extern "C" fn numerical_drop(solution: u32) {
    drop(&NUMERICAL_SOLUTIONS, solution);
}

/// t to theta and velocity.
#[unsafe(no_mangle)]
pub extern "C" fn numerical_motion(solution: u32, rows: usize) {
    ask(&NUMERICAL_SOLUTIONS, solution, |solution| both(rows, |t| solution.motion(t).into()));
}

/// When a solution goes over the top.
#[unsafe(no_mangle)]
pub extern "C" fn numerical_over_the_top(solution: u32) -> f64 {
    ask(&NUMERICAL_SOLUTIONS, solution, |solution| solution.over_the_top()).unwrap_or(f64::NAN)
}

/// The ends of all steps as the list: t, theta and velocity of each.
#[unsafe(no_mangle)]
pub extern "C" fn numerical_steps(solution: u32) -> i32 {
    let ends = |solution: &mut NumericalSolution| {
        let ends = (0..=solution.count()).filter_map(|i| solution.end_of_step(i));
        leave(ends.flat_map(<[f64; 3]>::from).collect())
    };
    ask(&NUMERICAL_SOLUTIONS, solution, ends).unwrap_or(0)
}

mod exchange;
#[cfg(feature = "whole")]
mod whole;

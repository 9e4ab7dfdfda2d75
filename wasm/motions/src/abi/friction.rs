//! The pendulum with friction and torque: its trajectory is integrated as far as it is asked for.

use super::exchange::{self, both, each, listed, made};
use crate::objects::{Objects, ask, drop};
use crate::workspace::with_columns;
use libration::damped::{LazyTrajectory, averaged_turning_angle};
use libration::{DampedPendulum, Domain, Friction, Torque};
use std::cell::RefCell;

thread_local! {
    static DAMPED: RefCell<Objects<LazyTrajectory>> = const { RefCell::new(Objects::new()) };
}

/// A pendulum with friction and torque. Of omega0, omega2, length and gravity those count whose bit is set in `given`: 1, 2, 4, 8.
#[unsafe(no_mangle)]
pub extern "C" fn damped_new(
    theta0: f64,
    velocity0: f64,
    omega0: f64,
    omega2: f64,
    length: f64,
    gravity: f64,
    given: u32,
    linear: f64,
    quadratic: f64,
    dry: f64,
    presliding: f64,
    constant: f64,
    amplitude: f64,
    frequency: f64,
    phase: f64,
) -> u32 {
    let pendulum = || {
        let force = exchange::frequency([omega0, omega2, length, gravity], given)?;
        let friction = Friction::new(linear, quadratic, dry, presliding)?;
        let torque = Torque::new(constant, amplitude, frequency, phase)?;
        DampedPendulum::new(theta0, velocity0, force, friction, torque)
    };
    made(&DAMPED, pendulum().map(LazyTrajectory::new))
}

/// Drops a pendulum.
#[unsafe(no_mangle)]
pub extern "C" fn damped_drop(damped: u32) {
    drop(&DAMPED, damped);
}

/// How far a motion goes that is asked for until a time: to it, or to where it takes too many steps.
#[unsafe(no_mangle)]
pub extern "C" fn damped_reach(damped: u32, until: f64) -> f64 {
    ask(&DAMPED, damped, |damped| damped.reaching(&[until]).interval().1).unwrap_or(f64::NAN)
}

/// t to theta and velocity.
#[unsafe(no_mangle)]
pub extern "C" fn damped_motion(damped: u32, rows: usize) {
    ask(&DAMPED, damped, |damped| {
        let trajectory = with_columns(|columns| damped.reaching(&columns[0][..rows]));
        both(rows, |t| trajectory.motion(t).into());
    });
}

/// t to the energy.
#[unsafe(no_mangle)]
pub extern "C" fn damped_energy(damped: u32, rows: usize) {
    ask(&DAMPED, damped, |damped| {
        let trajectory = with_columns(|columns| damped.reaching(&columns[0][..rows]));
        each(rows, |t| trajectory.energy(t));
    });
}

/// t to whole turns and the rest of the angle.
#[unsafe(no_mangle)]
pub extern "C" fn damped_turns(damped: u32, rows: usize) {
    ask(&DAMPED, damped, |damped| {
        let trajectory = with_columns(|columns| damped.reaching(&columns[0][..rows]));
        both(rows, |t| {
            let turns = trajectory.turns(t);
            [turns.count as f64, turns.angle]
        });
    });
}

/// The times at which the motion turns back, as the list.
#[unsafe(no_mangle)]
pub extern "C" fn damped_turning_times(damped: u32, start: f64, stop: f64) -> i32 {
    let times = |damped: &mut LazyTrajectory| damped.over(start, stop)?.turning_times(start, stop);
    ask(&DAMPED, damped, |damped| listed(times(damped))).unwrap_or(0)
}

/// Where dry friction holds it between two times, as the list: from and to of each.
#[unsafe(no_mangle)]
pub extern "C" fn damped_rests(damped: u32, start: f64, stop: f64) -> i32 {
    let rests = |damped: &mut LazyTrajectory| -> Result<Vec<f64>, Domain> {
        let held = damped.over(start, stop)?.rests_within(start, stop);
        Ok(held.into_iter().flat_map(|(from, to)| [from, to]).collect())
    };
    ask(&DAMPED, damped, |damped| listed(rests(damped))).unwrap_or(0)
}

/// t to the turning angle by the law of the mean loss, from a turning angle at t = 0.
#[unsafe(no_mangle)]
pub extern "C" fn damped_averaged(damped: u32, theta_max: f64, rows: usize) {
    ask(&DAMPED, damped, |damped| {
        let pendulum = damped.pendulum();
        let (frequency, friction) = (pendulum.frequency(), pendulum.friction());
        each(rows, |t| averaged_turning_angle(theta_max, t, frequency, friction));
    });
}

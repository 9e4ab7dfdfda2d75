//! Steps of many pendulums one after the other, each exact: what a state becomes between two looks at it.

use super::turns::wrap_into;
use crate::pendulum::advance_into;

/// Rows that go through all steps together: their columns stay in the cache.
pub const ROWS: usize = 2048;

/// What the steps are: a number of each for every step.
#[derive(Clone, Copy, Debug)]
pub struct Steps<'a> {
    /// Times in s.
    pub dt: &'a [f64],
    /// Angular frequencies of small swings.
    pub omega0: &'a [f64],
    /// Angles of the bottom.
    pub phase: &'a [f64],
}

/// Moves states by all the steps in place; after each, whole turns are taken from the angles ([`wrap_into`]). `stop` is asked after so many
/// rows and steps whether to give up, and then not all is done. Panics where the lengths differ.
///
/// ```
/// use libration::ensemble::{Steps, steps_into};
/// let (mut theta, mut velocity, mut turns) = ([0.0], [3.0], [0]);
/// let steps = Steps { dt: &[0.1; 100], omega0: &[1.0; 100], phase: &[0.0; 100] };
/// steps_into(&mut theta, &mut velocity, &mut turns, steps, |_| false);
/// assert_eq!(format!("{:.6} {turns:?}", theta[0]), "1.025388 [4]");
/// ```
pub fn steps_into(
    theta: &mut [f64],
    velocity: &mut [f64],
    turns: &mut [i64],
    steps: Steps<'_>,
    stop: impl Fn(usize) -> bool,
) {
    let Steps { dt, omega0, phase } = steps;
    assert!(theta.len() == velocity.len() && theta.len() == turns.len(), "columns of different lengths");
    assert!(dt.len() == omega0.len() && dt.len() == phase.len(), "steps of different lengths");
    let mut columns = [[0.0; ROWS]; 4];
    for ((theta, velocity), turns) in
        theta.chunks_mut(ROWS).zip(velocity.chunks_mut(ROWS)).zip(turns.chunks_mut(ROWS))
    {
        let rows = theta.len();
        let [times, frequencies, angles, velocities] = columns.each_mut().map(|column| &mut column[..rows]);
        for ((dt, omega0), phase) in dt.iter().zip(omega0).zip(phase) {
            times.fill(*dt);
            frequencies.fill(*omega0);
            // Never the other sign of a zero.
            if *phase != 0.0 {
                theta.iter_mut().for_each(|angle| *angle -= phase);
            }
            advance_into([theta, velocity, times, frequencies], [&mut *angles, &mut *velocities]);
            theta.copy_from_slice(angles);
            velocity.copy_from_slice(velocities);
            if *phase != 0.0 {
                theta.iter_mut().for_each(|angle| *angle += phase);
            }
            wrap_into(theta, turns);
            if stop(rows) {
                return;
            }
        }
    }
}

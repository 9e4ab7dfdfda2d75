//! The least-squares problem of one record: residuals and their exact Jacobian, both from the core.
//!
//! Residual i is offset + scale q(t_i) - measured_i, q the angle or velocity of a damped pendulum with a free state at t = 0.

use super::data::{self, Measured};
pub(super) use super::loss::Loss;
use super::loss::soft;
pub(super) use super::samples::Samples;
use super::search::LeastSquares;
pub(super) use super::values::*;
use core::{cell::Cell, f64::consts::PI};
use libration::damped::{ASKED_EVERY, Tolerance};
use libration::{DampedPendulum, DampedSensitivity, Frequency, Friction, Torque, Trajectory};
use nalgebra::{DMatrix, DVector};

/// How many times are handed to the core at once: the derivatives of all of a long record would not fit into memory.
const CHUNK: usize = 4096;

/// A record, a model, and where the search stands.
#[derive(Clone, Debug)]
pub(super) struct Problem<'a> {
    samples: &'a Samples,
    measured: Measured,
    free: Vec<usize>,
    loss: Loss,
    values: Values,
    tolerance: Tolerance,
    state: Option<(Trajectory, Vec<f64>)>,
    /// What a residual is where there is no motion: so large that the step is taken back.
    rejected: f64,
}

/// Over which angle dry friction changes sign, at least: below it the time of the integration would grow. The small swing's frequency
/// changes with the root of this angle.
const LEAST_PRESLIDING: f64 = 1e-4;

/// Logarithms of the angle above its least one; beyond, nothing changes, so a search may lean on these bounds.
pub(super) const PRESLIDING_RANGE: (f64, f64) = (-12.0, 1.0);

/// Below this logarithm, which is that of twice the least angle, a search counts as one that has gone to its bound.
pub(super) const PRESLIDING_HELD: f64 = -9.21;

/// The angle over which dry friction changes sign; 0 where it does so at once.
pub(super) fn presliding(values: &Values) -> f64 {
    let above = values[PRESLIDING].clamp(PRESLIDING_RANGE.0, PRESLIDING_RANGE.1);
    if values[PRESLIDING] == 0.0 { 0.0 } else { LEAST_PRESLIDING + libm::exp(above) }
}

/// Whether a motion is one of a pendulum in a laboratory. Beyond these bounds a search that has gone astray would integrate
/// millions of turns.
fn bounded(values: &Values, span: f64) -> bool {
    let omega0 = values[OMEGA2].sqrt();
    values[OMEGA2] > 0.0
        && values[VELOCITY].abs() <= 40.0 * omega0
        && span * omega0.max(values[VELOCITY].abs()) <= 1e5
        && values[LINEAR] <= omega0
        && values[QUADRATIC] <= 1e4
        && values[DRY] <= values[OMEGA2]
}

/// The least linear friction: with less, all friction together would drive the pendulum at some velocity v, where
/// dry + 2 linear v + quadratic v^2 < 0. Below 0 it is dry friction that falls with the velocity, as Stribeck found.
pub(super) fn least_linear(values: &Values) -> f64 {
    -(values[QUADRATIC].max(0.0) * values[DRY].max(0.0)).sqrt()
}

/// How linear friction below its bound changes with quadratic and with dry friction.
fn by_least_linear(values: &Values) -> [f64; 2] {
    let least = least_linear(values);
    if values[LINEAR] < least && least < 0.0 {
        [0.5 * least / values[QUADRATIC], 0.5 * least / values[DRY]]
    } else {
        [0.0; 2]
    }
}

/// Whether a friction term is below its bound, where it counts as if it stood there.
pub(super) fn below_bound(values: &Values, term: usize) -> bool {
    match term {
        LINEAR => values[LINEAR] < least_linear(values),
        QUADRATIC | DRY => values[term] < 0.0,
        _ => false,
    }
}

/// The motion of a set of values over an interval around its state; none where the values are out of their domain.
///
/// Friction below its bound counts as at it, so that a search may lean on the bound without being stopped there.
pub(super) fn trajectory(values: &Values, from: f64, to: f64) -> Option<Trajectory> {
    followed(values, from, to, Tolerance::Tight)
}

/// [`trajectory`] with a tolerance of its own.
fn followed(values: &Values, from: f64, to: f64, tolerance: Tolerance) -> Option<Trajectory> {
    if values.iter().any(|value| !value.is_finite()) || !bounded(values, to - from) {
        return None;
    }
    let frequency = Frequency::from_omega2(values[OMEGA2]).ok()?;
    let presliding = presliding(values);
    let linear = values[LINEAR].max(least_linear(values));
    let (quadratic, dry) = (values[QUADRATIC].max(0.0), values[DRY].max(0.0));
    let friction = Friction::new(linear, quadratic, dry, presliding).ok()?;
    let pendulum =
        DampedPendulum::new(values[THETA], values[VELOCITY], frequency, friction, Torque::NONE).ok()?;
    let (from, to) = (from.min(0.0), to.max(0.0));
    // A motion of so many small periods takes some fifteen steps in each. Far more are a search that has gone astray, into
    // presliding over an angle that is next to nothing, and each step of it would cost as much as one of a motion that counts.
    let fastest = values[OMEGA2].sqrt().max(values[VELOCITY].abs());
    let most = (STEPS_PER_RADIAN * (to - from) * fastest) as usize + LEAST_STEPS;
    let asked = Cell::new(0);
    let gone_astray = || {
        asked.set(asked.get() + 1);
        asked.get() * ASKED_EVERY > most
    };
    let trajectory = pendulum.integrated_unless(from, to, tolerance, &gone_astray);
    let whole = asked.get() * ASKED_EVERY <= most && trajectory.interval() == (from, to);
    whole.then_some(trajectory)
}

/// The steps that a motion may take: so many for each radian that it turns at its fastest, and so many besides.
const STEPS_PER_RADIAN: f64 = 10.0;
const LEAST_STEPS: usize = 2000;

fn difference(values: &Values) -> f64 {
    if values[OMEGA2] > 0.0 { 5e-4 / values[OMEGA2].sqrt() } else { 0.0 }
}

/// Times a little before and after: the acceleration is the difference of velocities over 1e-3 of the small swing's unit of time,
/// which leaves out 4e-8 of it.
fn neighbours(t: &[f64], (from, to): (f64, f64), values: &Values) -> [Vec<f64>; 2] {
    let step = difference(values);
    [-step, step].map(|step| t.iter().map(|t| data::bounded(t + step, from, to)).collect())
}

/// What is free in every model of a record.
pub(super) fn always_free(measured: Measured) -> Vec<usize> {
    let mut free = vec![THETA, VELOCITY, OMEGA2, OFFSET];
    if measured == Measured::Acceleration {
        free.push(SCALE);
    }
    free
}

/// What a record would show of a motion.
pub(super) fn predicted(trajectory: &Trajectory, measured: Measured, values: &Values, t: &[f64]) -> Vec<f64> {
    let (mut theta, mut velocity) = (vec![0.0; t.len()], vec![0.0; t.len()]);
    trajectory.motion_into(t, &mut theta, &mut velocity);
    let shown = match measured {
        Measured::Angle => theta,
        Measured::Velocity => velocity,
        Measured::Acceleration => {
            let [before, after] = neighbours(t, trajectory.interval(), values);
            let mut next = vec![0.0; t.len()];
            trajectory.motion_into(&before, &mut theta, &mut velocity);
            trajectory.motion_into(&after, &mut theta, &mut next);
            (0..t.len()).map(|i| (next[i] - velocity[i]) / (after[i] - before[i])).collect()
        }
    };
    shown.into_iter().map(|q| values[OFFSET] + values[SCALE] * q).collect()
}

impl<'a> Problem<'a> {
    pub fn new(
        samples: &'a Samples,
        measured: Measured,
        free: &[usize],
        loss: Loss,
        values: Values,
    ) -> Problem<'a> {
        Problem::within(samples, measured, free, loss, values, Tolerance::Tight)
    }
    /// With the tolerance of its motions.
    pub fn within(
        samples: &'a Samples,
        measured: Measured,
        free: &[usize],
        loss: Loss,
        values: Values,
        tolerance: Tolerance,
    ) -> Problem<'a> {
        let size = samples.y.iter().fold(0.0f64, |size, y| size.max(y.abs()));
        let free = free.to_vec();
        let mut problem = Problem {
            samples,
            measured,
            free,
            loss,
            values,
            tolerance,
            state: None,
            rejected: 1e6 * (size + 1.0),
        };
        problem.evaluate();
        problem
    }
    /// The same motion with other values free, or another loss.
    pub fn with(&mut self, free: &[usize], loss: Loss) {
        (self.free, self.loss) = (free.to_vec(), loss);
    }
    pub fn free(&self) -> &[usize] {
        &self.free
    }
    pub fn loss(&self) -> Loss {
        self.loss
    }
    /// The motion of other values.
    pub fn place(&mut self, values: Values) {
        self.values = values;
        self.evaluate();
    }
    pub fn values(&self) -> &Values {
        &self.values
    }
    /// Predicted less measured; empty where there is no motion.
    pub fn plain(&self) -> &[f64] {
        self.state.as_ref().map_or(&[], |(_, residuals)| residuals)
    }
    pub fn sum_of_squares(&self) -> f64 {
        if self.state.is_none() {
            return f64::INFINITY;
        }
        self.plain().iter().map(|r| r * r).sum()
    }

    fn evaluate(&mut self) {
        if self.samples.stop.is_some_and(|stop| stop()) {
            self.state = None;
            return;
        }
        let t = &self.samples.t;
        let (first, last) = (t.first().copied().unwrap_or(0.0), t.last().copied().unwrap_or(0.0));
        // Room for the differences of velocities; presliding has no time before its state.
        let room = if self.measured == Measured::Acceleration { difference(&self.values) } else { 0.0 };
        let before = if self.values[PRESLIDING] == 0.0 { room } else { 0.0 };
        // More small periods than samples are a search that has gone astray.
        let fastest = self.values[OMEGA2].abs().sqrt().max(self.values[VELOCITY].abs());
        if (last - first) * fastest > 2.0 * PI * (t.len() as f64).max(100.0) {
            self.state = None;
            return;
        }
        self.state =
            followed(&self.values, first - before, last + room, self.tolerance).and_then(|trajectory| {
                let shown = predicted(&trajectory, self.measured, &self.values, t);
                let residuals: Vec<f64> = shown.iter().zip(&self.samples.y).map(|(q, y)| q - y).collect();
                residuals.iter().all(|r| r.is_finite()).then_some((trajectory, residuals))
            });
    }

    /// d residual/d value for every free value, a column each, without the loss.
    pub fn derivatives(&self) -> Option<DMatrix<f64>> {
        let (trajectory, _) = self.state.as_ref()?;
        let last_of_core = self.free.iter().filter(|value| **value <= PRESLIDING).max();
        let sensitivity =
            DampedSensitivity::first(trajectory, last_of_core.map_or(1, |last| last + 1)).ok()?;
        let t = &self.samples.t;
        let mut matrix = DMatrix::zeros(t.len(), self.free.len());
        let mut columns = vec![vec![0.0; CHUNK.min(t.len())]; 22];
        let mut earlier = if self.measured == Measured::Acceleration { columns.clone() } else { Vec::new() };
        for start in (0..t.len()).step_by(CHUNK) {
            let part = &t[start..(start + CHUNK).min(t.len())];
            if self.measured == Measured::Acceleration {
                let [before, after] = neighbours(part, trajectory.interval(), &self.values);
                fill(&sensitivity, &before, &mut earlier);
                fill(&sensitivity, &after, &mut columns);
                for (column, early) in columns.iter_mut().zip(&earlier) {
                    for row in 0..part.len() {
                        column[row] = (column[row] - early[row]) / (after[row] - before[row]);
                    }
                }
            } else {
                fill(&sensitivity, part, &mut columns);
            }
            let shown = match self.measured {
                Measured::Angle => &columns[..11],
                Measured::Velocity | Measured::Acceleration => &columns[11..],
            };
            let (with_linear, scale) = (by_least_linear(&self.values), self.values[SCALE]);
            for (column, value) in self.free.iter().enumerate() {
                for row in 0..part.len() {
                    matrix[(start + row, column)] = match *value {
                        OFFSET => 1.0,
                        LINEAR | QUADRATIC | DRY if below_bound(&self.values, *value) => 0.0,
                        // Linear friction on its bound goes with the two that give it.
                        QUADRATIC | DRY => {
                            scale * (shown[*value][row] + with_linear[value - QUADRATIC] * shown[LINEAR][row])
                        }
                        PRESLIDING if self.values[PRESLIDING] < PRESLIDING_RANGE.0 => 0.0,
                        PRESLIDING if self.values[PRESLIDING] > PRESLIDING_RANGE.1 => 0.0,
                        SCALE => {
                            (self.plain()[start + row] + self.samples.y[start + row] - self.values[OFFSET])
                                / scale
                        }
                        PRESLIDING => scale * shown[PRESLIDING][row] * libm::exp(self.values[PRESLIDING]),
                        value => scale * shown[value][row],
                    };
                }
            }
        }
        matrix.iter().all(|entry| entry.is_finite()).then_some(matrix)
    }
}

/// The core's derivatives of angle and velocity at some times, a column each.
fn fill(sensitivity: &DampedSensitivity, t: &[f64], columns: &mut [Vec<f64>]) {
    let mut slices = columns.iter_mut();
    sensitivity
        .at_into(t, core::array::from_fn(|_| slices.next().map_or(&mut [][..], |c| &mut c[..t.len()])));
}

impl LeastSquares for Problem<'_> {
    fn assume(&mut self, values: &DVector<f64>) {
        for (place, value) in self.free.iter().zip(values.iter()) {
            self.values[*place] = *value;
        }
        self.evaluate();
    }
    fn assumed(&self) -> DVector<f64> {
        DVector::from_iterator(self.free.len(), self.free.iter().map(|place| self.values[*place]))
    }
    fn residuals(&self) -> Option<DVector<f64>> {
        if self.state.is_none() {
            return Some(DVector::from_element(self.samples.len(), self.rejected));
        }
        let reduced = |r: f64| match self.loss {
            Loss::Squares => r,
            Loss::Soft(f) => f * soft(r / f).0,
        };
        Some(DVector::from_iterator(self.samples.len(), self.plain().iter().map(|r| reduced(*r))))
    }
    fn jacobian(&self) -> Option<DMatrix<f64>> {
        let mut matrix = self.derivatives()?;
        if let Loss::Soft(f) = self.loss {
            for (row, r) in self.plain().iter().enumerate() {
                let slope = soft(r / f).1;
                matrix.row_mut(row).scale_mut(slope);
            }
        }
        Some(matrix)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Largest difference of the Jacobian from central differences, over the largest entry of its column.
    fn off(measured: Measured, values: Values, free: &[usize], spoil: f64) -> f64 {
        let t: Vec<f64> = (0..400).map(|i| 0.05 * f64::from(i)).collect();
        let samples = Samples { y: vec![0.0; t.len()], t, stop: None };
        let matrix = Problem::new(&samples, measured, free, Loss::Squares, values).derivatives().unwrap();
        let mut worst = 0.0f64;
        for (column, place) in free.iter().enumerate() {
            let step = 1e-5 * values[*place].abs().max(0.05);
            let shifted = |side: f64| {
                let mut values = values;
                values[*place] += side * step;
                Problem::new(&samples, measured, free, Loss::Squares, values).plain().to_vec()
            };
            let (before, after) = (shifted(-1.0), shifted(1.0));
            let size = matrix.column(column).amax();
            for row in 0..samples.len() {
                let difference = (after[row] - before[row]) / (2.0 * step);
                worst = worst.max((spoil * matrix[(row, column)] - difference).abs() / size);
            }
        }
        worst
    }

    #[test]
    fn the_jacobian_is_that_of_the_residuals_for_every_model() {
        let terms = [LINEAR, QUADRATIC, DRY, PRESLIDING];
        let acting = [0.02, 0.03, 0.2, -3.0];
        for count in 0..=terms.len() {
            let mut values = [0.1, 4.0, 12.0, 0.0, 0.0, 0.0, 0.0, 0.01, 1.1];
            for (term, value) in terms.iter().zip(acting).take(count) {
                values[*term] = value;
            }
            let free = [&[THETA, VELOCITY, OMEGA2, OFFSET, SCALE], &terms[..count]].concat();
            // Where dry friction turns, an acceleration jumps.
            let measured = [Measured::Angle, Measured::Velocity, Measured::Acceleration];
            for measured in &measured[..if count < 3 { 3 } else { 2 }] {
                let worst = off(*measured, values, &free, 1.0);
                assert!(worst < 1e-6, "{measured:?} with {count} terms: {worst:e}");
            }
            // The spoiled sibling.
            assert!(off(Measured::Angle, values, &free, 1.0001) > 1e-5);
        }
    }
}

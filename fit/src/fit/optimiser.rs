//! From start values of a motion to the nearest minimum.

use super::data::Measured;
use super::problem::{Loss, Problem, Samples, Values};
use super::search::descend;
use levenberg_marquardt::LevenbergMarquardt;
use libration::damped::Tolerance;

/// Where a search has ended.
#[derive(Clone, Debug)]
pub(super) struct Outcome {
    pub values: Values,
    pub sum_of_squares: f64,
    /// Predicted less measured; empty where no motion was found.
    pub residuals: Vec<f64>,
}

impl Outcome {
    pub fn rms(&self) -> f64 {
        (self.sum_of_squares / self.residuals.len().max(1) as f64).sqrt()
    }
}

/// How far a search goes: relative changes of cost and values at which it ends, and what its motions may leave out.
#[derive(Clone, Copy, Debug)]
pub(super) struct Patience {
    pub tolerance: f64,
    pub evaluations: usize,
    pub motions: Tolerance,
}

/// A rough place, on the way.
pub(super) const ROUGH: Patience = Patience { tolerance: 1e-5, evaluations: 12, motions: Tolerance::Loose };
/// Near enough to compare rungs.
pub(super) const CLOSE: Patience = Patience { tolerance: 1e-8, evaluations: 30, motions: Tolerance::Tight };
/// The minimum itself.
pub(super) const FINE: Patience = Patience { tolerance: 1e-13, evaluations: 60, motions: Tolerance::Tight };

/// From start values to the nearest minimum.
pub(super) fn minimum(
    samples: &Samples,
    measured: Measured,
    free: &[usize],
    loss: Loss,
    start: Values,
    patience: Patience,
) -> Outcome {
    let mut problem = Problem::within(samples, measured, free, loss, start, patience.motions);
    settle(&mut problem, patience);
    outcome(&problem)
}

/// Leaves a problem at the minimum nearest to its values.
pub(super) fn settle(problem: &mut Problem, patience: Patience) {
    let (start, before) = (*problem.values(), problem.sum_of_squares());
    let method = LevenbergMarquardt::new()
        .with_ftol(patience.tolerance)
        .with_xtol(patience.tolerance)
        .with_gtol(1e-15)
        .with_patience(patience.evaluations.div_ceil(problem.free().len() + 1).max(2));
    descend(problem, method);
    let after = problem.sum_of_squares();
    if problem.loss() == Loss::Squares && (after.is_nan() || after > before) {
        problem.place(start);
    }
}

/// Where a problem is.
pub(super) fn outcome(problem: &Problem) -> Outcome {
    Outcome {
        values: *problem.values(),
        sum_of_squares: problem.sum_of_squares(),
        residuals: problem.plain().to_vec(),
    }
}

//! Levenberg and Marquardt's method as MINPACK has it, from the crate `levenberg-marquardt`.

use super::data::Measured;
use super::problem::{Loss, Problem, Samples, Values};
use levenberg_marquardt::LevenbergMarquardt;

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

/// How far a search goes: relative changes of cost and values at which it ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Patience {
    pub tolerance: f64,
    pub evaluations: usize,
}

/// A rough place, on the way.
pub(super) const ROUGH: Patience = Patience { tolerance: 1e-5, evaluations: 12 };
/// Near enough to compare rungs.
pub(super) const CLOSE: Patience = Patience { tolerance: 1e-8, evaluations: 30 };
/// The minimum itself.
pub(super) const FINE: Patience = Patience { tolerance: 1e-13, evaluations: 60 };

/// From start values to the nearest minimum.
pub(super) fn minimum(
    samples: &Samples,
    measured: Measured,
    free: &[usize],
    loss: Loss,
    start: Values,
    patience: Patience,
) -> Outcome {
    let problem = Problem::new(samples, measured, free, loss, start);
    let method = LevenbergMarquardt::new()
        .with_ftol(patience.tolerance)
        .with_xtol(patience.tolerance)
        .with_gtol(1e-15)
        .with_patience(patience.evaluations.div_ceil(free.len() + 1).max(2))
        // The first steps stay where the linear form of the problem holds.
        .with_stepbound(1.0);
    let before = problem.sum_of_squares();
    let (found, _) = method.minimize(problem);
    let after = found.sum_of_squares();
    if loss == Loss::Squares && (after.is_nan() || after > before) {
        let problem = Problem::new(samples, measured, free, loss, start);
        return outcome(&problem);
    }
    outcome(&found)
}

fn outcome(problem: &Problem) -> Outcome {
    Outcome {
        values: *problem.values(),
        sum_of_squares: problem.sum_of_squares(),
        residuals: problem.plain().to_vec(),
    }
}

//! The ladder of friction models and the choice of a rung by information criteria on the effective sample size.

use super::covariance::effective_size;
use super::data::Measured;
use super::optimiser::{FINE, Outcome, ROUGH, minimum};
use super::options::Model;
use super::problem::{
    DRY, LINEAR, Loss, OFFSET, OMEGA2, PRESLIDING, QUADRATIC, SCALE, Samples, THETA, VELOCITY, Values,
    trajectory,
};

/// A model at its minimum.
#[derive(Clone, Debug)]
pub(super) struct Rung {
    pub model: Model,
    pub outcome: Outcome,
    /// The places of the free values.
    pub free: Vec<usize>,
    /// Terms that wanted to be negative and were held at 0.
    pub wanted_negative: Vec<usize>,
    pub aicc: f64,
    pub bic: f64,
}

/// The friction terms of a model.
pub(super) fn terms(model: Model) -> &'static [usize] {
    const ALL: [usize; 4] = [LINEAR, QUADRATIC, DRY, PRESLIDING];
    match model {
        Model::None => &ALL[..0],
        Model::Linear => &ALL[..1],
        Model::Quadratic => &ALL[..2],
        Model::Dry => &ALL[..3],
        Model::Presliding => &ALL,
    }
}

/// Angles over which dry friction may change sign, to start from.
const PRESLIDING_STARTS: [f64; 3] = [0.003, 0.02, 0.1];

/// A model at its minimum, from the values of a neighbour; negative friction is held at 0 and remembered.
pub(super) fn rung(
    samples: &Samples,
    measured: Measured,
    model: Model,
    start: &Values,
    free_scale: bool,
) -> Rung {
    let mut values = *start;
    let acting = terms(model);
    for term in [LINEAR, QUADRATIC, DRY, PRESLIDING] {
        if !acting.contains(&term) {
            values[term] = 0.0;
        }
    }
    let mut free = vec![THETA, VELOCITY, OMEGA2, OFFSET];
    free.extend(acting);
    if free_scale {
        free.push(SCALE);
    }
    let search =
        |free: &[usize], values: Values| minimum(samples, measured, free, Loss::Squares, values, FINE);
    let mut outcome = if model == Model::Presliding && values[PRESLIDING] == 0.0 {
        let tried = PRESLIDING_STARTS.map(|angle| {
            let mut values = values;
            values[PRESLIDING] = f64::ln(angle);
            values[DRY] = values[DRY].max(1e-4 * values[OMEGA2]);
            minimum(samples, measured, &free, Loss::Squares, values, ROUGH)
        });
        let best = tried.into_iter().min_by(|a, b| a.sum_of_squares.total_cmp(&b.sum_of_squares));
        search(&free, best.map_or(values, |outcome| outcome.values))
    } else {
        search(&free, values)
    };
    let mut wanted_negative = Vec::new();
    while let Some(term) =
        free.iter().copied().find(|term| [LINEAR, QUADRATIC].contains(term) && outcome.values[*term] < 0.0)
    {
        wanted_negative.push(term);
        free.retain(|place| *place != term);
        let mut values = outcome.values;
        values[term] = 0.0;
        outcome = search(&free, values);
    }
    Rung { model, outcome, free, wanted_negative, aicc: f64::NAN, bic: f64::NAN }
}

/// Both criteria of every rung, on the effective size that the richest one's residuals have.
pub(super) fn criteria(rungs: &mut [Rung]) -> f64 {
    let Some(richest) = rungs.iter().min_by(|a, b| a.outcome.rms().total_cmp(&b.outcome.rms())) else {
        return 0.0;
    };
    let n = effective_size(&richest.outcome.residuals);
    for rung in rungs {
        let mean = rung.outcome.sum_of_squares / rung.outcome.residuals.len() as f64;
        // With the variance, which is estimated too.
        let k = rung.free.len() as f64 + 1.0;
        let spare = (n - k - 1.0).max(1.0);
        rung.aicc = n * mean.ln() + 2.0 * k + 2.0 * k * (k + 1.0) / spare;
        rung.bic = n * mean.ln() + k * n.ln();
    }
    n
}

/// The rung with the least AICc; of rungs within 2 of it the simplest.
pub(super) fn chosen(rungs: &[Rung]) -> usize {
    let least = rungs.iter().map(|rung| rung.aicc).fold(f64::INFINITY, f64::min);
    rungs.iter().position(|rung| rung.aicc <= least + 2.0).unwrap_or(0)
}

/// The same motion with its state at another time: values for samples whose times are later by `shift`.
pub(super) fn moved(values: &Values, shift: f64) -> Option<Values> {
    let along = trajectory(values, shift.min(0.0), shift.max(0.0))?;
    let mut moved = *values;
    (moved[THETA], moved[VELOCITY]) = along.motion(shift);
    Some(moved)
}

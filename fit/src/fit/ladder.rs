//! The ladder of friction models and the choice of a rung by information criteria on the effective sample size.

use super::covariance::effective_size;
use super::data::Measured;
use super::optimiser::{Outcome, Patience, minimum};
use super::options::Model;
use super::problem::{
    DRY, LINEAR, Loss, OMEGA2, PRESLIDING, PRESLIDING_HELD, QUADRATIC, SCALE, Samples, THETA, VELOCITY,
    Values, always_free, trajectory,
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
    /// Of the residuals; that of presliding as if it had been fitted to the samples of the others.
    pub mean_square: f64,
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

/// The best of some angles over which dry friction may change sign, each with the values that it shifts most set free.
fn best_presliding(samples: &Samples, measured: Measured, values: &Values) -> f64 {
    let few = samples.thinned(f64::NEG_INFINITY, f64::INFINITY, 1500);
    let quick = Patience { tolerance: 1e-3, evaluations: 5 };
    let tried = [0.003, 0.01, 0.03, 0.1].map(|angle| {
        let mut values = *values;
        values[PRESLIDING] = libm::log(angle);
        minimum(&few, measured, &[THETA, VELOCITY, OMEGA2, DRY], Loss::Squares, values, quick)
    });
    let best = tried.into_iter().min_by(|a, b| a.sum_of_squares.total_cmp(&b.sum_of_squares));
    best.map_or(libm::log(0.01), |best| best.values[PRESLIDING])
}

/// A model at its minimum, from the values of a neighbour; negative friction is held at 0 and remembered.
pub(super) fn rung(
    samples: &Samples,
    measured: Measured,
    model: Model,
    start: &Values,
    free_scale: bool,
    patience: Patience,
) -> Rung {
    let mut values = *start;
    let acting = terms(model);
    for term in [LINEAR, QUADRATIC, DRY, PRESLIDING] {
        if !acting.contains(&term) {
            values[term] = 0.0;
        }
    }
    let mut free = always_free(measured);
    free.extend(acting);
    if free_scale && !free.contains(&SCALE) {
        free.push(SCALE);
    }
    let search =
        |free: &[usize], values: Values| minimum(samples, measured, free, Loss::Squares, values, patience);
    if model == Model::Presliding && values[PRESLIDING] == 0.0 {
        values[DRY] = values[DRY].max(1e-4 * values[OMEGA2]);
        values[PRESLIDING] = best_presliding(samples, measured, &values);
    }
    let begin = values;
    let mut outcome = search(&free, begin);
    let mut wanted_negative = Vec::new();
    let negative = |free: &[usize], values: &Values| {
        free.iter().copied().find(|term| [LINEAR, QUADRATIC, DRY].contains(term) && values[*term] < 0.0)
    };
    while let Some(term) = negative(&free, &outcome.values) {
        wanted_negative.push(term);
        let mut values = outcome.values;
        values[term] = 0.0;
        free.retain(|place| *place != term);
        if term == DRY && free.contains(&PRESLIDING) {
            values[PRESLIDING] = 0.0;
            free.retain(|place| *place != PRESLIDING);
        }
        outcome = search(&free, values);
        // Where the others stood with a negative term may be far from where they stand without it.
        let mut begun = begin;
        for held in &wanted_negative {
            begun[*held] = 0.0;
        }
        if !free.contains(&PRESLIDING) {
            begun[PRESLIDING] = 0.0;
        }
        let other = search(&free, begun);
        if other.sum_of_squares < outcome.sum_of_squares {
            outcome = other;
        }
    }
    // The bound is an angle of 0: dry friction alone.
    if free.contains(&PRESLIDING) && outcome.values[PRESLIDING] < PRESLIDING_HELD {
        wanted_negative.push(PRESLIDING);
        free.retain(|place| *place != PRESLIDING);
        let mut values = outcome.values;
        values[PRESLIDING] = 0.0;
        outcome = search(&free, values);
    }
    let mean_square = outcome.sum_of_squares / outcome.residuals.len().max(1) as f64;
    Rung { model, outcome, free, wanted_negative, mean_square, aicc: f64::NAN, bic: f64::NAN }
}

impl Rung {
    /// What the choice and the weights of rungs go by.
    pub fn worth(&self) -> f64 {
        self.aicc + if self.model == Model::Presliding { 8.0 } else { 0.0 }
    }
    /// A richer model never fits worse: where its search ended above the minimum of the poorer one, that minimum is its own, with
    /// the new term at its bound.
    pub fn not_above(&mut self, poorer: &Rung) {
        let own = self.outcome.sum_of_squares;
        if own.is_nan() || own > poorer.outcome.sum_of_squares {
            self.outcome = poorer.outcome.clone();
            self.mean_square = poorer.mean_square;
            self.wanted_negative.clone_from(&poorer.wanted_negative);
            let added = terms(self.model)[terms(poorer.model).len()..].iter();
            self.wanted_negative.extend(added);
            self.free.clone_from(&poorer.free);
        }
    }
}

/// Both criteria of every rung on one effective sample size: the share of the samples that those of the best rung's residuals are
/// worth.
pub(super) fn criteria(rungs: &mut [Rung], per_period: f64) -> f64 {
    let best = rungs.iter().min_by(|a, b| a.mean_square.total_cmp(&b.mean_square));
    let Some(best) = best.filter(|best| !best.outcome.residuals.is_empty()) else { return 0.0 };
    let share = effective_size(&best.outcome.residuals, per_period) / best.outcome.residuals.len() as f64;
    let n = share * rungs.iter().map(|rung| rung.outcome.residuals.len()).max().unwrap_or(0) as f64;
    // A slow drift of the residuals leaves few of them; the criteria need more than there are values.
    let n = n.max(33.0);
    for rung in rungs {
        // With the variance, which is estimated too.
        let k = rung.free.len() as f64 + 1.0;
        let spare = (n - k - 1.0).max(1.0);
        rung.aicc = n * libm::log(rung.mean_square) + 2.0 * k + 2.0 * k * (k + 1.0) / spare;
        rung.bic = n * libm::log(rung.mean_square) + k * libm::log(n);
    }
    n
}

/// Up the ladder as long as both criteria ask for it, AICc by more than 2. Presliding, for which samples before the first passage
/// are given up, must be better by 8 more.
pub(super) fn chosen(rungs: &[Rung]) -> usize {
    let mut best = 0;
    for (place, rung) in rungs.iter().enumerate().skip(1) {
        let least = &rungs[best];
        let handicap = rung.worth() - rung.aicc;
        if rung.worth() < least.worth() - 2.0 && rung.bic + handicap < least.bic {
            best = place;
        }
    }
    best
}

/// The same motion with its state at another time: values for samples whose times are later by `shift`.
pub(super) fn moved(values: &Values, shift: f64) -> Option<Values> {
    let along = trajectory(values, shift.min(0.0), shift.max(0.0))?;
    let mut moved = *values;
    (moved[THETA], moved[VELOCITY]) = along.motion(shift);
    Some(moved)
}

//! The ladder of friction models and the choice of a rung by information criteria on the effective sample size.

use super::covariance::effective_size;
use super::data::Measured;
use super::optimiser::{FINE, Outcome, Patience, minimum};
use super::options::Model;
use super::problem::{
    DRY, LINEAR, Loss, OMEGA2, PRESLIDING, PRESLIDING_HELD, PRESLIDING_RANGE, Problem, QUADRATIC, SCALE,
    Samples, THETA, VELOCITY, Values, always_free, below_bound, least_linear, trajectory,
};
use libration::damped::Tolerance;
use nalgebra::DVector;

/// A model at its minimum.
#[derive(Clone, Debug)]
pub(super) struct Rung {
    pub model: Model,
    pub outcome: Outcome,
    /// The places of the free values.
    pub free: Vec<usize>,
    /// Terms that leant on their bound and were held at 0.
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
    let quick = Patience { tolerance: 1e-3, evaluations: 5, motions: Tolerance::Tight };
    let tried = [0.003, 0.01, 0.03, 0.1].map(|angle| {
        let mut values = *values;
        values[PRESLIDING] = libm::log(angle);
        minimum(&few, measured, &[THETA, VELOCITY, OMEGA2, DRY], Loss::Squares, values, quick)
    });
    let best = tried.into_iter().min_by(|a, b| a.sum_of_squares.total_cmp(&b.sum_of_squares));
    best.map_or(libm::log(0.01), |best| best.values[PRESLIDING])
}

/// Of the terms that are held at 0 one whose rise would lower the cost: the search leant on its bound too early.
fn wants_back(
    samples: &Samples,
    measured: Measured,
    held: &[usize],
    released: &[usize],
    outcome: &Outcome,
) -> Option<usize> {
    let asked: Vec<usize> = held
        .iter()
        .copied()
        .filter(|term| [LINEAR, QUADRATIC, DRY].contains(term) && !released.contains(term))
        .collect();
    if asked.is_empty() {
        return None;
    }
    let mut values = outcome.values;
    values[LINEAR] = values[LINEAR].max(least_linear(&values));
    let problem = Problem::new(samples, measured, &asked, Loss::Squares, values);
    let columns = problem.derivatives()?;
    let residuals = DVector::from_column_slice(problem.plain());
    // A cosine below it is what a search that has ended leaves.
    const ENDED: f64 = 1e-4;
    let place = (0..asked.len()).find(|place| {
        let column = columns.column(*place);
        column.dot(&residuals) < -ENDED * column.norm() * residuals.norm()
    })?;
    Some(asked[place])
}

/// A model at its minimum, from the values of a neighbour.
pub(super) fn rung(
    samples: &Samples,
    measured: Measured,
    model: Model,
    start: &Values,
    free_scale: bool,
    patience: Patience,
) -> Rung {
    let search = |start: &Values, patience| searched(samples, measured, model, start, free_scale, patience);
    let found = search(start, patience);
    // Without dry friction the linear one has no room below 0, and without that dry friction may have no use: each holds the other. A
    // search that begins there, with both free and with more patience, leads away where a lower cost is near.
    let both = [LINEAR, DRY].iter().all(|term| found.wanted_negative.contains(term));
    if !both || found.outcome.values[QUADRATIC] <= 0.0 {
        return found;
    }
    let other = search(&found.outcome.values, FINE);
    if other.outcome.sum_of_squares < found.outcome.sum_of_squares { other } else { found }
}

/// A model at the minimum that a search from these values reaches; a term that leans on its bound is held at 0 and remembered.
fn searched(
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
    if model == Model::Presliding && values[PRESLIDING] == 0.0 {
        values[DRY] = values[DRY].max(1e-4 * values[OMEGA2]);
        values[PRESLIDING] = best_presliding(samples, measured, &values);
    }
    let free_without = |held: &[usize]| {
        let mut free = always_free(measured);
        free.extend(acting.iter().filter(|term| !held.contains(term)));
        if free_scale && !free.contains(&SCALE) {
            free.push(SCALE);
        }
        free
    };
    let search =
        |free: &[usize], values: Values| minimum(samples, measured, free, Loss::Squares, values, patience);
    let mut held: Vec<usize> = Vec::new();
    let mut released: Vec<usize> = Vec::new();
    let mut free = free_without(&held);
    let mut outcome = search(&free, values);
    loop {
        let leaning: Vec<usize> =
            free.iter().copied().filter(|term| below_bound(&outcome.values, *term)).collect();
        if let Some(term) =
            wants_back(samples, measured, &held, &released, &outcome).filter(|_| leaning.is_empty())
        {
            held.retain(|place| *place != term);
            released.push(term);
            outcome.values[LINEAR] = outcome.values[LINEAR].max(least_linear(&outcome.values));
        } else if leaning.is_empty() {
            break;
        }
        for term in leaning {
            // That of linear friction moves with the others, so it stays where it counts as at its bound.
            outcome.values[term] = if term == LINEAR { -outcome.values[OMEGA2].sqrt() } else { 0.0 };
            held.push(term);
            if term == DRY && free.contains(&PRESLIDING) {
                outcome.values[PRESLIDING] = 0.0;
                held.push(PRESLIDING);
            }
        }
        free = free_without(&held);
        outcome = search(&free, outcome.values);
    }
    outcome.values[LINEAR] = outcome.values[LINEAR].max(least_linear(&outcome.values));
    let mut wanted_negative = held;
    // The bound is an angle of 0: dry friction alone. Beyond the largest angle it is a spring, which no swing tells from gravity.
    let spring = outcome.values[PRESLIDING] > PRESLIDING_RANGE.1;
    if free.contains(&PRESLIDING) && (spring || outcome.values[PRESLIDING] < PRESLIDING_HELD) {
        let mut values = if spring { *start } else { outcome.values };
        for term in wanted_negative.iter().filter(|_| spring) {
            values[*term] = 0.0;
        }
        wanted_negative.push(PRESLIDING);
        free.retain(|place| *place != PRESLIDING);
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

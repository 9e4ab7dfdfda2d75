//! A search over a horizon that grows around the anchor, so that the phase never slips by a swing.
//!
//! Friction is held at what the loss of energy says while the horizon is short: what a short record cannot tell apart would lead
//! the search astray.

use super::data::{Measured, robust_deviation};
use super::optimiser::{Outcome, ROUGH, outcome, settle};
use super::problem::{DRY, LINEAR, Loss, Problem, QUADRATIC, Samples, Values, always_free};
use super::start::Start;

/// Half widths of the horizon in periods, and how many friction terms are free there.
const STAGES: [(f64, usize); 7] =
    [(1.2, 0), (3.0, 1), (8.0, 1), (20.0, 2), (50.0, 3), (150.0, 3), (f64::INFINITY, 3)];
/// Samples of a stage: more do not lead the search better.
const MOST: usize = 2000;

/// What a model with the first so many of linear, quadratic and dry friction reaches over the whole of the samples.
pub(super) fn grown(
    samples: &Samples,
    measured: Measured,
    start: &Start,
    terms: usize,
    noise: f64,
) -> Outcome {
    let mut values = start.values;
    if terms > 0 {
        let friction = start.friction[terms - 1];
        (values[LINEAR], values[QUADRATIC], values[DRY]) = (friction[0], friction[1], friction[2]);
    }
    let mut scale = noise.max(1e-9);
    let (first, last) = (samples.t[0], samples.t[samples.len() - 1]);
    let whole = first.abs().max(last.abs());
    let mut reached = None;
    for (periods, most) in STAGES {
        let reach = (periods * start.period).min(whole);
        let part = samples.thinned(-reach, reach, MOST);
        if part.len() < 8 {
            continue;
        }
        // The last stage frees every term, however short the record is.
        let free = if reach >= whole { terms } else { most.min(terms) };
        let outcome = stage(&part, measured, &[LINEAR, QUADRATIC, DRY][..free], scale, values);
        values = outcome.values;
        scale = robust_deviation(&outcome.residuals).max(noise);
        reached = Some(outcome);
        if reach >= whole {
            break;
        }
    }
    reached.unwrap_or(Outcome { values, sum_of_squares: f64::INFINITY, residuals: Vec::new() })
}

fn stage(samples: &Samples, measured: Measured, friction: &[usize], scale: f64, values: Values) -> Outcome {
    let mut free = always_free(measured);
    let mut problem = Problem::within(samples, measured, &free, Loss::Squares, values, ROUGH.motions);
    settle(&mut problem, ROUGH);
    if !friction.is_empty() {
        free.extend(friction);
        problem.with(&free, Loss::Squares);
        settle(&mut problem, ROUGH);
    }
    let wide = robust_deviation(problem.plain()).max(3.0 * scale);
    if wide.is_finite() {
        problem.with(&free, Loss::Soft(wide));
        settle(&mut problem, ROUGH);
    }
    let mut outcome = outcome(&problem);
    // A term below 0 drives the pendulum, which helps no longer horizon.
    for term in [LINEAR, QUADRATIC, DRY] {
        outcome.values[term] = outcome.values[term].max(0.0);
    }
    outcome
}

//! A search over a horizon that grows around the anchor, so that the phase never slips by a swing.
//!
//! Friction terms come in as the horizon grows: what a short record cannot tell apart would lead the search astray.

use super::data::{Measured, robust_deviation};
use super::optimiser::{Outcome, ROUGH, minimum};
use super::problem::{DRY, LINEAR, Loss, OFFSET, OMEGA2, QUADRATIC, Samples, THETA, VELOCITY, Values};
use super::start::Start;

/// Half widths of the horizon in periods, and the friction that is free there.
const STAGES: [(f64, &[usize]); 6] = [
    (1.2, &[]),
    (3.0, &[LINEAR]),
    (8.0, &[LINEAR, QUADRATIC]),
    (20.0, &[LINEAR, QUADRATIC]),
    (50.0, &[LINEAR, QUADRATIC, DRY]),
    (150.0, &[LINEAR, QUADRATIC, DRY]),
];
/// Samples of a stage: more do not lead the search better.
const MOST: usize = 3000;

/// What was reached, over the whole of the samples.
pub(super) fn grown(samples: &Samples, measured: Measured, start: &Start, noise: f64) -> Outcome {
    let mut values = start.values;
    let mut scale = noise.max(1e-9);
    let (first, last) = (samples.t[0], samples.t[samples.len() - 1]);
    let whole = first.abs().max(last.abs());
    for (periods, friction) in STAGES {
        let reach = periods * start.period;
        let part = samples.thinned(-reach, reach, MOST);
        if part.len() < 8 {
            continue;
        }
        let outcome = stage(&part, measured, friction, scale, values);
        values = outcome.values;
        scale = robust_deviation(&outcome.residuals).max(noise);
        if reach >= whole {
            break;
        }
    }
    let part = samples.thinned(first, last, MOST);
    stage(&part, measured, &[LINEAR, QUADRATIC, DRY], scale, values)
}

fn stage(samples: &Samples, measured: Measured, friction: &[usize], scale: f64, values: Values) -> Outcome {
    let mut free = vec![THETA, VELOCITY, OMEGA2, OFFSET];
    free.extend(friction);
    // First with a wide scale: near the start every residual is large.
    let mut outcome = minimum(samples, measured, &free, Loss::Squares, values, ROUGH);
    let wide = robust_deviation(&outcome.residuals).max(3.0 * scale);
    if wide.is_finite() {
        outcome = minimum(samples, measured, &free, Loss::Soft(wide), outcome.values, ROUGH);
    }
    // A term below 0 drives the pendulum, which helps no longer horizon.
    for term in [LINEAR, QUADRATIC] {
        outcome.values[term] = outcome.values[term].max(0.0);
    }
    outcome
}

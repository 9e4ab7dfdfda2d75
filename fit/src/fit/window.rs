//! From the release to the stop: which samples of a record are the free motion.

use super::data::{Measured, robust_deviation};
use super::problem::{Samples, Values, predicted, trajectory};

/// A residual beyond this many deviations is no longer the motion.
const BEYOND: f64 = 6.0;
/// So many of them in a row.
const IN_A_ROW: usize = 4;

/// The first time back to which a motion still describes the record, from `from` on: all times are since the anchor.
pub(super) fn earliest(all: &Samples, measured: Measured, values: &Values, from: f64, noise: f64) -> f64 {
    reached(all, measured, values, from, noise, -1.0)
}

/// The last such time.
pub(super) fn latest(all: &Samples, measured: Measured, values: &Values, from: f64, noise: f64) -> f64 {
    reached(all, measured, values, from, noise, 1.0)
}

fn reached(all: &Samples, measured: Measured, values: &Values, from: f64, noise: f64, sense: f64) -> f64 {
    let end = if sense < 0.0 { all.t[0] } else { all.t[all.len() - 1] };
    // Friction that drives the motion backward may let it grow without bound: as far as it goes.
    let mut to = end;
    let mut along = None;
    for _ in 0..12 {
        along = trajectory(values, to.min(from), to.max(from));
        if along.is_some() {
            break;
        }
        to = 0.5 * (to + from);
    }
    let Some(along) = along else { return from };
    let residuals = |part: &Samples| -> Vec<f64> {
        let shown = predicted(&along, measured, values, &part.t);
        shown.iter().zip(&part.y).map(|(q, y)| q - y).collect()
    };
    // The neighbourhood inside says how well the motion fits here.
    let span = (to - from).abs().max((from).abs());
    let near = all.only(|i| {
        let inward = (from - all.t[i]) * sense;
        (0.0..=span.max(1e-9)).contains(&inward)
    });
    let usual = robust_deviation(&residuals(&near)).max(noise);
    let beyond = all.only(|i| (all.t[i] - from) * sense > 0.0 && (to - all.t[i]) * sense >= 0.0);
    let outside = residuals(&beyond);
    let order: Vec<usize> =
        if sense < 0.0 { (0..beyond.len()).rev().collect() } else { (0..beyond.len()).collect() };
    let (mut last, mut row) = (from, 0);
    for i in order {
        if !(outside[i].abs() <= BEYOND * usual) {
            row += 1;
            if row >= IN_A_ROW {
                break;
            }
        } else {
            row = 0;
            last = beyond.t[i];
        }
    }
    last
}

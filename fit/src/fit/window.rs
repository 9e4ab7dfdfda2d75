//! From the release to the stop: which samples of a record are the free motion.

use super::data::Measured;
use super::problem::{Samples, Values, predicted, trajectory};

/// So many of them in a row.
const IN_A_ROW: usize = 4;

/// The last time, in one sense from `from`, to which a motion describes the record within `bound`. Times are since the anchor.
pub(super) fn reached(
    all: &Samples,
    measured: Measured,
    values: &Values,
    from: f64,
    bound: f64,
    sense: f64,
) -> f64 {
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
    let beyond = all.only(|i| (all.t[i] - from) * sense > 0.0 && (to - all.t[i]) * sense >= 0.0);
    let outside = residuals(&beyond);
    let order: Vec<usize> =
        if sense < 0.0 { (0..beyond.len()).rev().collect() } else { (0..beyond.len()).collect() };
    let (mut last, mut row) = (from, 0);
    for i in order {
        if !(outside[i].abs() <= bound) {
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

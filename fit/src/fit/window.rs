//! From the release to the stop: which samples of a record are the free motion.

use super::data::{Measured, median};
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
        if outside[i].is_nan() || outside[i].abs() > bound {
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

/// From the first to the last sample between which a motion describes the record within `bound`: each end is cut where, counted from
/// it, more samples lie beyond than within, by the most. There a hand still leads the pendulum, or catches it.
pub(super) fn described(samples: &Samples, residuals: &[f64], bound: f64) -> (f64, f64) {
    let cut = |rows: &mut dyn Iterator<Item = usize>| {
        let (mut score, mut most, mut count) = (0, IN_A_ROW as i64 - 1, 0);
        for (number, row) in rows.enumerate() {
            score += if residuals[row].abs() > bound { 1 } else { -1 };
            if score > most {
                (most, count) = (score, number + 1);
            }
        }
        count
    };
    let (first, last) = (cut(&mut (0..residuals.len())), cut(&mut (0..residuals.len()).rev()));
    let last = residuals.len() - 1 - last.min(residuals.len() - 1);
    (samples.t[first.min(last)], samples.t[last])
}

/// The end of the last period in which the record moves: after it dry friction holds the pendulum.
pub(super) fn last_motion(all: &Samples, period: f64, noise: f64) -> f64 {
    let (first, last) = (all.t[0], all.t[all.len() - 1]);
    if period * (all.len() as f64) < 10.0 * (last - first) {
        return last;
    }
    let mut end = all.len();
    while end > 0 {
        let to = all.t[end - 1];
        let begin = all.t.partition_point(|t| *t < to - period);
        let part = &all.y[begin..end];
        let mean = part.iter().sum::<f64>() / part.len() as f64;
        let deviation = (part.iter().map(|y| (y - mean).powi(2)).sum::<f64>() / part.len() as f64).sqrt();
        // Noise alone stays below with some ten samples or more; rounding to neighbours has 1.5.
        if deviation > 1.6 * noise || begin == 0 {
            return to;
        }
        end = begin;
    }
    first
}

/// Where something stops the pendulum: from there on the residuals (predicted less measured) are large, half period by half period,
/// and the record moves much less or much more than it should. A motion whose phase alone has slipped is not stopped.
pub(super) fn caught(samples: &Samples, residuals: &[f64], rest: f64, period: f64, noise: f64) -> f64 {
    let mut begins: Vec<usize> = Vec::new();
    for i in 0..residuals.len() {
        if begins.last().is_none_or(|begin| samples.t[i] - samples.t[*begin] >= 0.5 * period) {
            begins.push(i);
        }
    }
    let end = |half: usize| begins.get(half + 1).copied().unwrap_or(residuals.len());
    let mean = |part: &[f64]| part.iter().map(|r| r * r).sum::<f64>() / part.len() as f64;
    let sizes: Vec<f64> =
        (0..begins.len()).map(|half| mean(&residuals[begins[half]..end(half)]).sqrt()).collect();
    let bound = 5.0 * median(&sizes).max(noise);
    for (half, size) in sizes.iter().enumerate() {
        let follows = sizes.get(half + 1).is_none_or(|size| *size > bound);
        if *size <= bound || !follows || mean(&sizes[half..]) <= bound * bound {
            continue;
        }
        let measured: Vec<f64> = samples.y[begins[half]..].iter().map(|y| (y - rest).abs()).collect();
        let later = residuals[begins[half]..].iter().zip(&samples.y[begins[half]..]);
        let predicted: Vec<f64> = later.map(|(r, y)| (y + r - rest).abs()).collect();
        let ratio = median(&measured) / median(&predicted);
        if !(0.5..=2.0).contains(&ratio) {
            return samples.t[begins[half]];
        }
    }
    f64::INFINITY
}

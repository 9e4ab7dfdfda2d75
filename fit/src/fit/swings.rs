//! Turning points of a record and the passages between them, without a model.
//!
//! A turn is an extreme from which the record comes back by a threshold above noise and rounding. The rest lies in the middle of
//! two turns on one side and the one between; a passage of it is a straight line through the samples around it.

use super::data::{bounded, extent, median, robust_deviation};
use crate::order::ranked;

/// An extreme of the record.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Turn {
    pub row: usize,
    pub t: f64,
    pub y: f64,
}

/// A half period between two neighbouring turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Passage {
    pub t: f64,
    /// Slope of the record there.
    pub slope: f64,
    /// Mean distance of the two turns from the rest.
    pub swing: f64,
}

/// All turns of a record.
#[derive(Clone, Debug)]
pub(super) struct Swings {
    pub turns: Vec<Turn>,
    /// passages[k] lies between turns[k] and turns[k + 1].
    pub passages: Vec<Passage>,
    /// Where the record rests.
    pub centre: f64,
    /// How much noise may change a swing.
    pub slack: f64,
}

/// Noise and rounding of a record, from its fourth differences, which a smooth motion leaves small.
pub(super) fn noise(y: &[f64]) -> f64 {
    let fourth: Vec<f64> =
        y.windows(5).map(|w| (w[0] - 4.0 * w[1] + 6.0 * w[2] - 4.0 * w[3] + w[4]) / 70f64.sqrt()).collect();
    let mut steps: Vec<f64> = y.windows(2).map(|w| (w[1] - w[0]).abs()).filter(|step| *step > 0.0).collect();
    // A rounded record repeats its least step.
    let place = steps.len() / 20;
    let quantum = if steps.is_empty() { 0.0 } else { ranked(&mut steps, place) };
    let repeated = y.windows(2).filter(|w| w[0] == w[1]).count() * 50 > y.len();
    robust_deviation(&fourth).max(if repeated { quantum / 3.0 } else { 0.0 })
}

/// The median of five neighbours: single wrong samples vanish.
fn filtered(y: &[f64]) -> Vec<f64> {
    let n = y.len();
    (0..n)
        .map(|i| {
            let reach = 2.min(i).min(n - 1 - i);
            median(&y[i - reach..=i + reach])
        })
        .collect()
}

/// Extremes from which the record comes back by `threshold`.
fn turns(t: &[f64], y: &[f64], threshold: f64) -> Vec<Turn> {
    let mut found = Vec::new();
    let (mut low, mut high) = (0, 0);
    let mut rising: Option<bool> = None;
    for i in 1..y.len() {
        if y[i] > y[high] {
            high = i;
        }
        if y[i] < y[low] {
            low = i;
        }
        if rising != Some(false) && y[i] < y[high] - threshold {
            found.push(high);
            rising = Some(false);
            low = i;
        } else if rising != Some(true) && y[i] > y[low] + threshold {
            found.push(low);
            rising = Some(true);
            high = i;
        }
    }
    found.into_iter().map(|row| Turn { row, t: t[row], y: y[row] }).collect()
}

impl Swings {
    pub fn of(t: &[f64], y: &[f64]) -> Swings {
        let (low, high) = extent(y);
        let range = high - low;
        let threshold = bounded(6.0 * noise(y), 0.01 * range, 0.15 * range);
        let mut turning = turns(t, y, threshold);
        let dense = turning.len() > 2 && y.len() / turning.len() > 12;
        let smooth = if dense { filtered(y) } else { y.to_vec() };
        if dense {
            let (low, high) = extent(&smooth);
            let threshold = bounded(6.0 * noise(&smooth), 0.005 * (high - low), 0.15 * (high - low));
            turning = turns(t, &smooth, threshold);
        }
        let middles: Vec<f64> = turning.windows(3).map(|w| 0.25 * (w[0].y + 2.0 * w[1].y + w[2].y)).collect();
        // The later half swings less, so friction shifts its middles less.
        let centre = match middles.len() {
            0 => 0.5 * (low + high),
            n => median(&middles[n / 2..]),
        };
        let passages = turning.windows(2).map(|pair| passage(t, &smooth, pair, centre)).collect();
        let slack = 3.0 * noise(&smooth).min(0.05 * range);
        Swings { turns: turning, passages, centre, slack }
    }
}

/// Where the record passes its rest between two turns.
fn passage(t: &[f64], y: &[f64], pair: &[Turn], centre: f64) -> Passage {
    let (a, b) = (pair[0], pair[1]);
    let swing = 0.5 * ((a.y - centre).abs() + (b.y - centre).abs());
    let between = centre > a.y.min(b.y) && centre < a.y.max(b.y);
    let level = if between { centre } else { 0.5 * (a.y + b.y) };
    let rises = b.y > a.y;
    let beyond = |i: usize| if rises { y[i] >= level } else { y[i] <= level };
    let after = (a.row + 1..=b.row).find(|i| beyond(*i)).unwrap_or(b.row);
    // A straight line over the middle third of the swing, or the two neighbours where it has fewer samples.
    let near = |i: usize| (y[i] - level).abs() < 0.35 * swing;
    let (mut from, mut to) = (after - 1, after);
    while from > a.row && near(from - 1) {
        from -= 1;
    }
    while to < b.row && near(to + 1) {
        to += 1;
    }
    let n = (to - from + 1) as f64;
    let (mean_t, mean_y) = (t[from..=to].iter().sum::<f64>() / n, y[from..=to].iter().sum::<f64>() / n);
    let (mut tt, mut ty) = (0.0, 0.0);
    for i in from..=to {
        tt += (t[i] - mean_t).powi(2);
        ty += (t[i] - mean_t) * (y[i] - mean_y);
    }
    let slope = if tt > 0.0 { ty / tt } else { 0.0 };
    let time = if slope == 0.0 { t[after] } else { mean_t + (level - mean_y) / slope };
    Passage { t: bounded(time, a.t, b.t), slope, swing }
}

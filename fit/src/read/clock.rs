//! Instants as a clock wrote them: counters that wrap, recordings that follow each other, stamps out of order, twice, or
//! rounded. Values are only unwrapped, put in order or rebuilt where the stamps prove it; nothing is resampled.

use super::profile::median;
use crate::order::sorted;

/// Periods of counters: 16 and 32 bits in ticks, 32 bits of ms and of us in s, a day in s.
const WRAPS: [f64; 5] = [65536.0, 4294967296.0, 4294967.296, 4294.967296, 86400.0];
/// A fall by more steps than this is no fault of one clock: another recording begins.
const FEW: f64 = 8.0;

/// The rows of a column of instants, one recording after the other.
#[derive(Debug, Default)]
pub(super) struct Recordings {
    /// Rows and instants of each recording, in the order of the file.
    pub runs: Vec<Vec<(usize, f64)>>,
    /// How often a counter wrapped, and at what.
    pub wraps: Vec<f64>,
    /// Rows whose stamp is far from those on both sides.
    pub strays: Vec<usize>,
}

/// The recordings in a column. `restarts` are rows above which the header stands again.
pub(super) fn recordings(stamps: &[(usize, f64)], restarts: &[usize]) -> Recordings {
    let mut rises: Vec<f64> =
        stamps.windows(2).map(|pair| pair[1].1 - pair[0].1).filter(|rise| *rise > 0.0).collect();
    let step = median(&mut rises).unwrap_or(0.0);
    let mut found = Recordings::default();
    let mut run: Vec<(usize, f64)> = Vec::new();
    let (mut offset, mut restart) = (0.0, restarts.iter().copied().peekable());
    for (k, &(row, raw)) in stamps.iter().enumerate() {
        let mut again = false;
        while restart.next_if(|at| *at <= row).is_some() {
            again = true;
        }
        let Some(&(_, before)) = run.last() else {
            run.push((row, raw));
            continue;
        };
        let time = raw + offset;
        let fall = before - time;
        if !again && fall > 0.0 {
            let next = stamps.get(k + 1).map(|next| next.1 + offset);
            let earlier = run.len().checked_sub(2).map(|at| run[at].1);
            let follows = |from: f64, to: f64| to > from && to - from <= 4.0 * step;
            let wrap = |period: &&f64| follows_wrap(before - offset, raw, **period, step);
            if let Some(period) = WRAPS.iter().find(wrap) {
                offset += period;
                found.wraps.push(*period);
                run.push((row, raw + offset));
                continue;
            }
            if earlier.is_some_and(|earlier| before - earlier > FEW * step && follows(earlier, time)) {
                // The stamp before was far ahead.
                found.strays.extend(run.pop().map(|stray| stray.0));
            } else if next.is_some_and(|next| follows(before, next) && next - time > 4.0 * step) {
                found.strays.push(row);
                continue;
            } else {
                again = fall > FEW * step || time <= run[0].1 + 0.5 * step;
            }
        }
        if again && fall >= 0.0 {
            found.runs.push(core::mem::take(&mut run));
            offset = 0.0;
            run.push((row, raw));
        } else {
            run.push((row, time));
        }
    }
    found.runs.push(run);
    found.runs.retain(|run| !run.is_empty());
    found
}

/// Whether a counter of this period wrapped between two stamps.
fn follows_wrap(before: f64, after: f64, period: f64, step: f64) -> bool {
    let rise = after + period - before;
    before < period && before > 0.9 * period && after >= 0.0 && rise > 0.0 && rise <= 20.0 * step
}

/// What was done to put the stamps of one recording in order.
#[derive(Debug, Default)]
pub(super) struct Order {
    /// Rows that were moved to their place.
    pub moved: usize,
    /// Rows with the stamp of another one.
    pub twice: Vec<usize>,
    /// Indices of the first stamp after a step back of the clock.
    pub breaks: Vec<usize>,
}

/// Sorts the stamps where those out of order fill holes; otherwise keeps their order and tells where the clock fell.
pub(super) fn ordered(stamps: &mut Vec<(usize, f64)>, rounded: bool) -> Order {
    let mut order = Order::default();
    let falls: Vec<usize> = (1..stamps.len()).filter(|k| stamps[*k].1 < stamps[k - 1].1).collect();
    if !falls.is_empty() {
        let sorted = sorted(stamps, |a, b| a.1.total_cmp(&b.1));
        let mut rises: Vec<f64> =
            sorted.windows(2).map(|pair| pair[1].1 - pair[0].1).filter(|rise| *rise > 0.0).collect();
        let step = median(&mut rises).unwrap_or(0.0);
        let out_of_place = |k: usize| sorted[k].0 != stamps[k].0;
        let crowded = |k: usize| {
            let rise = sorted[k].1 - sorted[k - 1].1;
            rise > 0.0 && rise < 0.6 * step && (out_of_place(k) || out_of_place(k - 1))
        };
        if (1..sorted.len()).any(crowded) {
            order.breaks = falls;
        } else {
            order.moved = falls.len();
            *stamps = sorted;
        }
    }
    if !rounded && order.breaks.is_empty() {
        let mut last = f64::NAN;
        stamps.retain(|(row, time)| {
            let twice = *time == last;
            last = *time;
            if twice {
                order.twice.push(*row);
            }
            !twice
        });
    }
    order
}

/// Rates of cameras and sensors, in samples a second, the usual ones first.
const RATES: [f64; 17] = [
    30.0, 60.0, 25.0, 50.0, 100.0, 24.0, 120.0, 240.0, 15.0, 20.0, 10.0, 200.0, 1000.0, 29.97002997002997,
    59.94005994005994, 119.88011988011988, 23.976023976023978,
];

/// Even instants in place of stamps so rounded that several are equal: first instant and rate, if every stamp is the
/// rounding of one. `digits` is the place value of the last digit of each.
pub(super) fn rebuilt(stamps: &[f64], digits: &[f64]) -> Option<(f64, f64)> {
    let last = stamps.len().checked_sub(1).filter(|last| *last > 1)?;
    // Half of the last place, and a little for decimal stamps that are no doubles.
    let half = |k: usize| 0.5001 * digits[k] + 1e-12 * stamps[k].abs();
    let holds =
        |start: f64, step: f64| (0..=last).all(|k| (start + step * k as f64 - stamps[k]).abs() <= half(k));
    // The start must leave room for every stamp: an interval for each step.
    let start = |step: f64| -> Option<f64> {
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        for (k, stamp) in stamps.iter().enumerate() {
            let from = stamp - step * k as f64;
            low = low.max(from - half(k));
            high = high.min(from + half(k));
        }
        (low <= high)
            .then(|| if low <= stamps[0] && stamps[0] <= high { stamps[0] } else { 0.5 * (low + high) })
    };
    let usual = RATES.iter().find_map(|rate| start(1.0 / rate).map(|start| (start, *rate)));
    if let Some((start, rate)) = usual.filter(|(start, rate)| holds(*start, 1.0 / rate)) {
        return Some((start, rate));
    }
    // Otherwise least squares with the digits as weights.
    let (mut w, mut wk, mut wt, mut wkk, mut wkt) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for (k, stamp) in stamps.iter().enumerate() {
        let (n, weight) = (k as f64, 1.0 / (half(k) * half(k)).max(1e-300));
        w += weight;
        wk += weight * n;
        wt += weight * stamp;
        wkk += weight * n * n;
        wkt += weight * n * stamp;
    }
    let step = (w * wkt - wk * wt) / (w * wkk - wk * wk);
    let from = (wt - step * wk) / w;
    (step > 0.0 && step.is_finite() && holds(from, step)).then_some((from, 1.0 / step))
}

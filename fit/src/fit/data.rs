//! What is fitted: plain columns in SI units.

use super::refusal::FitRefusal;
use crate::digits::Shown;
use crate::order::ranked;

/// What the second column of a record holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measured {
    /// An angle in rad, continuous through turns; its zero is free.
    Angle,
    /// An angular velocity in rad/s; its zero is free.
    Velocity,
    /// An acceleration along the path in m/s^2 with gravity taken out, R theta''; R and the zero are free.
    Acceleration,
}

/// The measurements of one pendulum.
#[derive(Clone, Debug, PartialEq)]
pub enum Data {
    /// Samples in time.
    Record {
        /// What `values` are.
        measured: Measured,
        /// Times in s, in rising order.
        t: Vec<f64>,
        /// One for each time; those that are not finite are left out and listed.
        values: Vec<f64>,
    },
    /// Durations of swings between passages of a light gate at the bottom.
    Gate {
        /// The middle of each duration, in s.
        t: Vec<f64>,
        /// Full periods in s (twice a half period).
        periods: Vec<f64>,
        /// How long a flag darkened the gate then, in s: the speed at the bottom is some width over it.
        transits: Option<Vec<f64>>,
    },
    /// Periods of swings of a known size.
    Table {
        /// Turning angles in rad, of either sign.
        swings: Vec<f64>,
        /// Periods in s.
        periods: Vec<f64>,
    },
}

impl Data {
    /// How many rows there are.
    #[must_use]
    pub fn rows(&self) -> usize {
        match self {
            Data::Record { t, .. } => t.len(),
            Data::Gate { periods, .. } | Data::Table { periods, .. } => periods.len(),
        }
    }

    /// The columns beside the first have its length.
    pub(super) fn check(&self) -> Result<(), FitRefusal> {
        let lengths: Vec<usize> = match self {
            Data::Record { t, values, .. } => vec![t.len(), values.len()],
            Data::Gate { t, periods, transits } => {
                vec![t.len(), periods.len(), transits.as_ref().map_or(t.len(), Vec::len)]
            }
            Data::Table { swings, periods } => vec![swings.len(), periods.len()],
        };
        if lengths.iter().any(|length| *length != lengths[0]) {
            return Err(FitRefusal::new(format!(
                "columns of {lengths:?} rows: all must have the same length"
            )));
        }
        Ok(())
    }
}

/// A record with its faulty rows taken out.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Clean {
    pub t: Vec<f64>,
    pub y: Vec<f64>,
    /// The rows of the input that are left.
    pub rows: Vec<usize>,
    /// What was taken out, in words.
    pub dropped: Vec<(usize, &'static str)>,
}

/// In rad, rad/s or m/s^2: far below what any sensor tells from rest.
const LEAST_RANGE: f64 = 1e-12;

/// Rows without a number are left out; a clock that falls throughout is refused.
pub(super) fn clean(t: &[f64], values: &[f64]) -> Result<Clean, FitRefusal> {
    let mut kept = Clean { t: Vec::new(), y: Vec::new(), rows: Vec::new(), dropped: Vec::new() };
    let mut falls = 0;
    for (row, (time, value)) in t.iter().zip(values).enumerate() {
        if !time.is_finite() || !value.is_finite() {
            kept.dropped.push((row, "no number"));
            continue;
        }
        if kept.t.last().is_some_and(|last| time < last) {
            falls += 1;
            kept.dropped.push((row, "its time is before that of the row above"));
            continue;
        }
        kept.t.push(*time);
        kept.y.push(*value);
        kept.rows.push(row);
    }
    if falls * 2 > t.len() {
        return Err(FitRefusal::new(format!("the time falls in {falls} of {} rows: it must rise", t.len())));
    }
    if kept.t.len() < 8 {
        let few = if kept.t.len() == 1 { "row" } else { "rows" };
        return Err(FitRefusal::new(format!(
            "{} {few} with numbers: a record needs at least 8",
            kept.t.len()
        )));
    }
    let (low, high) = extent(&kept.y);
    if low == high {
        return Err(FitRefusal::new(format!(
            "every value is {}: a pendulum that moves is needed",
            Shown(low)
        )));
    }
    if high - low < LEAST_RANGE {
        return Err(FitRefusal::new(format!(
            "the values lie within {:.1e} of each other: a motion of at least 1e-12 is needed",
            Shown(high - low)
        )));
    }
    if kept.t[0] == kept.t[kept.t.len() - 1] {
        return Err(FitRefusal::new(format!("every time is {}: times must rise", Shown(kept.t[0]))));
    }
    Ok(kept)
}

/// A value between two bounds: `f64::clamp` without its panic, which would bring Rust's digits into a page.
pub(super) fn bounded(value: f64, low: f64, high: f64) -> f64 {
    value.max(low).min(high)
}

/// Least and largest.
pub(super) fn extent(values: &[f64]) -> (f64, f64) {
    values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), y| (low.min(*y), high.max(*y)))
}

/// The median; NaN of nothing.
pub(super) fn median(values: &[f64]) -> f64 {
    let mut values: Vec<f64> = values.to_vec();
    let middle = values.len() / 2;
    let upper = ranked(&mut values, middle);
    if values.len() % 2 == 1 { upper } else { 0.5 * (ranked(&mut values, middle.wrapping_sub(1)) + upper) }
}

/// The standard deviation that a normal distribution with this median of |value| has.
pub(super) fn robust_deviation(values: &[f64]) -> f64 {
    let sizes: Vec<f64> = values.iter().map(|value| value.abs()).collect();
    1.4826 * median(&sizes)
}

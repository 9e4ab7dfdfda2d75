//! Times for which a gate was dark, read on a clock of a coarse step, as a smooth curve of the time.
//!
//! A step q rounds a duration between two instants by a triangular error of deviation q/sqrt(6). A swing read from such times draws
//! the curve of the period flat, and g comes out too small (errors in variables: Fuller, Measurement Error Models (1987), 1.1). In
//! a free decay they grow smoothly: a polynomial, of a degree by Akaike's criterion, leaves the rounding out. It is taken where
//! what it leaves is no more than rounding.

use super::curve::{CurveFit, nearest};
use super::data::median;
use super::result::{Grade, Verdict};
use crate::order::sorted;
use libration::{Frequency, Orbit};
use nalgebra::{DMatrix, DVector};

/// The largest degree of the polynomial.
const MOST_DEGREE: usize = 4;
/// Fewer rows hold no curve beside their rounding.
const LEAST_ROWS: usize = 20;
/// Deviation from the curve, in steps, up to which it is rounding: 1/sqrt(6) with its scatter in some twenty rows.
const MOST_DEVIATION: f64 = 0.6;

/// Fewer different times in the dark tell no curve through them from a straight line.
const LEAST_VALUES: usize = 4;

/// Times of few values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Coarse {
    /// How many different values there are.
    pub values: usize,
    /// The least difference of two, in s; infinite where all are alike.
    pub step: f64,
}

/// The values that finite times take; none where most rows have a value of their own.
pub(super) fn coarse(dark: &[f64]) -> Option<Coarse> {
    let finite: Vec<f64> = dark.iter().copied().filter(|dark| dark.is_finite()).collect();
    let sorted = sorted(&finite, f64::total_cmp);
    // Differences of rounded instants repeat but for the last digits of a double.
    let same = 1e-6 * median(&sorted).abs();
    let steps = sorted.windows(2).map(|pair| pair[1] - pair[0]).filter(|step| *step > same);
    let values = 1 + steps.clone().count();
    (sorted.len() > 2 && 2 * values <= sorted.len())
        .then(|| Coarse { values, step: steps.fold(f64::INFINITY, f64::min) })
}

impl Coarse {
    /// The share by which rounding draws the width of the flag to nothing, where each time is taken as it is.
    fn dilution(&self, dark: &[f64]) -> f64 {
        let n = dark.len() as f64;
        let mean = dark.iter().sum::<f64>() / n;
        let variance = dark.iter().map(|dark| (dark - mean).powi(2)).sum::<f64>() / n;
        // The period goes with the square of the width.
        0.5 * self.step * self.step / 6.0 / variance
    }
    /// What a coarse clock does to a swing read from times in the dark.
    pub fn verdict(&self, dark: &[f64], best: &CurveFit, smooth: bool) -> Option<Verdict> {
        let count = self.values;
        if smooth && count >= LEAST_VALUES {
            return Some(Verdict::new(
                Grade::Note,
                format!(
                    "the times in the dark have only {count} different values: the swing was read from a smooth curve through them"
                ),
            ));
        }
        let matters = smooth || self.dilution(dark) > best.u(1) / best.values[1].abs();
        matters.then(|| {
            Verdict::new(
                Grade::Warning,
                format!(
                    "the swing was read from dark times of only {count} different values; use a finer clock or state the swing"
                ),
            )
        })
    }
}

/// A curve through the times.
pub(super) struct Smooth {
    /// Its value at each row.
    pub dark: Vec<f64>,
    /// Independent errors of it, one standard uncertainty each.
    pub errors: Vec<Vec<f64>>,
}

impl Smooth {
    /// Adds to the covariance what the errors of the curve make of the values.
    pub fn add_errors(&self, best: &mut CurveFit, measured: &[f64]) {
        let count = best.values.len();
        for error in &self.errors {
            let dark: Vec<f64> = self.dark.iter().zip(error).map(|(dark, error)| dark + error).collect();
            let moved = nearest(&|values| by_transits(&dark, values), measured, &best.values, 0);
            // Without a minimum there the uncertainty is not known.
            let shift = |place: usize| {
                moved.as_ref().map_or(f64::NAN, |moved| moved.values[place] - best.values[place])
            };
            for i in 0..count {
                for j in 0..count {
                    best.covariance.matrix[(i, j)] += shift(i) * shift(j);
                }
            }
        }
    }
}

fn period_of_velocity(velocity: f64, omega0: f64) -> Option<f64> {
    if velocity.abs() >= 2.0 * omega0 {
        return None;
    }
    Some(Orbit::new(0.0, velocity, Frequency::from_omega0(omega0).ok()?).ok()?.period())
}

/// Periods of passages whose speed is a width, values[1], over the time that the flag takes.
pub(super) fn by_transits(dark: &[f64], values: &[f64]) -> Option<Vec<f64>> {
    dark.iter().map(|dark| period_of_velocity(values[1] / dark, values[0])).collect()
}

/// The curve; none where the times leave more than rounding beside it.
pub(super) fn smooth(t: &[f64], dark: &[f64], coarse: Coarse) -> Option<Smooth> {
    let n = dark.len();
    if n < LEAST_ROWS {
        return None;
    }
    let (first, last) = (t[0], t[n - 1]);
    let place = |row: usize| 2.0 * (t[row] - first) / (last - first) - 1.0;
    let measured = DVector::from_column_slice(dark);
    let mut best: Option<(f64, f64, DMatrix<f64>)> = None;
    for degree in 1..=MOST_DEGREE {
        let powers = DMatrix::from_fn(n, degree + 1, |row, column| place(row).powi(column as i32));
        let base = powers.qr().q();
        let left = (&measured - &base * base.tr_mul(&measured)).norm_squared();
        let (rows, k) = (n as f64, degree as f64 + 2.0);
        let aicc = rows * libm::log(left.max(f64::MIN_POSITIVE) / rows)
            + 2.0 * k
            + 2.0 * k * (k + 1.0) / (rows - k - 1.0);
        if best.as_ref().is_none_or(|(least, ..)| aicc < *least) {
            best = Some((aicc, (left / (rows - k + 1.0)).sqrt(), base));
        }
    }
    let (_, deviation, base) = best?;
    let curve = &base * base.tr_mul(&measured);
    // Written so that NaN, of times that do not rise, is no curve.
    let holds = deviation <= MOST_DEVIATION * coarse.step && curve.iter().all(|dark| *dark > 0.0);
    holds.then(|| Smooth {
        dark: curve.iter().copied().collect(),
        errors: base.column_iter().map(|column| (column * deviation).iter().copied().collect()).collect(),
    })
}

//! Least squares of a curve with few values that the core gives at every row, without an integration.
//!
//! Derivatives are central differences: the core's period is right to half a unit in the last place, so they keep ten digits.

use super::covariance::Covariance;
use super::data::robust_deviation;
use super::search::{LeastSquares, descend};
use levenberg_marquardt::LevenbergMarquardt;
use nalgebra::{DMatrix, DVector};

/// What a curve shows at every row for some values; none where they are out of its domain.
pub(super) type Curve<'a> = dyn Fn(&[f64]) -> Option<Vec<f64>> + 'a;

struct CurveProblem<'a> {
    curve: &'a Curve<'a>,
    measured: &'a [f64],
    values: Vec<f64>,
}

/// A curve at its minimum.
#[derive(Clone, Debug)]
pub(super) struct CurveFit {
    pub values: Vec<f64>,
    /// Measured less fitted.
    pub residuals: Vec<f64>,
    pub covariance: Covariance,
}

impl CurveFit {
    pub fn rms(&self) -> f64 {
        (self.residuals.iter().map(|r| r * r).sum::<f64>() / self.residuals.len() as f64).sqrt()
    }
    pub fn u(&self, place: usize) -> f64 {
        self.covariance.matrix[(place, place)].sqrt()
    }
    /// Akaike's criterion with its correction.
    pub fn aicc(&self) -> f64 {
        let (n, k) = (self.residuals.len() as f64, self.values.len() as f64 + 1.0);
        n * libm::log(self.rms().powi(2)) + 2.0 * k + 2.0 * k * (k + 1.0) / (n - k - 1.0).max(1.0)
    }
}

impl CurveProblem<'_> {
    fn derivatives(&self) -> Option<DMatrix<f64>> {
        let mut matrix = DMatrix::zeros(self.measured.len(), self.values.len());
        for column in 0..self.values.len() {
            let step = 6e-6 * self.values[column].abs().max(1e-4);
            let shifted = |side: f64| {
                let mut values = self.values.clone();
                values[column] += side * step;
                (self.curve)(&values)
            };
            let (before, after) = (shifted(-1.0)?, shifted(1.0)?);
            for row in 0..self.measured.len() {
                matrix[(row, column)] = (after[row] - before[row]) / (2.0 * step);
            }
        }
        matrix.iter().all(|entry| entry.is_finite()).then_some(matrix)
    }
    fn plain(&self) -> Option<DVector<f64>> {
        let shown = (self.curve)(&self.values)?;
        let residuals =
            DVector::from_iterator(shown.len(), shown.iter().zip(self.measured).map(|(a, b)| a - b));
        residuals.iter().all(|r| r.is_finite()).then_some(residuals)
    }
}

impl LeastSquares for CurveProblem<'_> {
    fn assume(&mut self, values: &DVector<f64>) {
        self.values = values.iter().copied().collect();
    }
    fn assumed(&self) -> DVector<f64> {
        DVector::from_column_slice(&self.values)
    }
    fn residuals(&self) -> Option<DVector<f64>> {
        // So large that a step out of the domain is taken back.
        Some(self.plain().unwrap_or_else(|| DVector::from_element(self.measured.len(), 1e9)))
    }
    fn jacobian(&self) -> Option<DMatrix<f64>> {
        self.derivatives()
    }
}

/// The minimum near `start`.
pub(super) fn nearest(curve: &Curve, measured: &[f64], start: &[f64], lags: usize) -> Option<CurveFit> {
    let mut found = CurveProblem { curve, measured, values: start.to_vec() };
    found.plain()?;
    descend(&mut found, LevenbergMarquardt::new().with_patience(60));
    let residuals: Vec<f64> = found.plain()?.iter().map(|r| -r).collect();
    let covariance = Covariance::of(&found.derivatives()?, &residuals, lags)?;
    Some(CurveFit { values: found.values, residuals, covariance })
}

/// The rows that lie within six deviations of their median.
pub(super) fn inside(residuals: &[f64]) -> Vec<bool> {
    let bound = 6.0 * robust_deviation(residuals);
    residuals.iter().map(|r| bound == 0.0 || r.abs() <= bound).collect()
}

//! Statistical uncertainty of a minimum whose residuals may be correlated in time.
//!
//! Cov = (J'J)^-1 S (J'J)^-1 with S = J' Omega J. Omega comes from an autoregressive model of the residuals, its order by BIC (den
//! Haan & Levin, NBER Technical Working Paper 197 (1996)), corrected for what the minimum has taken of the noise, and beside it S from
//! Newey & West's weights (Econometrica 55 (1987) 703) over three periods; the larger variance of the two is taken.

use nalgebra::{DMatrix, DVector};

/// The largest order of the autoregressive model.
const MOST: usize = 12;

fn most_lags(n: usize) -> usize {
    MOST.min(n / 8)
}

/// An autoregressive model of residuals.
#[derive(Clone, Debug)]
pub(super) struct Autoregression {
    pub coefficients: Vec<f64>,
}

/// Sample autocorrelations at lags 0 to `most`.
pub(super) fn autocorrelations(residuals: &[f64], most: usize) -> Vec<f64> {
    let at =
        |lag: usize| residuals.iter().zip(&residuals[lag.min(residuals.len())..]).map(|(a, b)| a * b).sum();
    let zero: f64 = at(0);
    (0..=most).map(|lag| if zero > 0.0 { at(lag) / zero } else { f64::from(u8::from(lag == 0)) }).collect()
}

impl Autoregression {
    pub fn of(residuals: &[f64]) -> Autoregression {
        Autoregression::through(&autocorrelations(residuals, most_lags(residuals.len())), residuals.len())
    }
    /// Durbin and Levinson's recursion for autocorrelations of n numbers; the order with the least BIC.
    fn through(rho: &[f64], n: usize) -> Autoregression {
        let (n, most) = (n as f64, rho.len() - 1);
        let (mut coefficients, mut variance): (Vec<f64>, f64) = (Vec::new(), 1.0);
        let (mut best, mut least) = (coefficients.clone(), 0.0);
        for order in 1..=most {
            let known: f64 = coefficients.iter().enumerate().map(|(i, a)| a * rho[order - 1 - i]).sum();
            let reflection = ((rho[order] - known) / variance).clamp(-0.9999, 0.9999);
            let before = coefficients.clone();
            for (i, a) in coefficients.iter_mut().enumerate() {
                *a -= reflection * before[order - 2 - i];
            }
            coefficients.push(reflection);
            variance *= 1.0 - reflection * reflection;
            let bic = n * libm::log(variance) + order as f64 * libm::log(n);
            if bic < least {
                (best, least) = (coefficients.clone(), bic);
            }
        }
        Autoregression { coefficients: best }
    }

    /// Autocorrelations of the model, from lag 0 until they have died away, at most `most`.
    pub fn correlations(&self, most: usize) -> Vec<f64> {
        let p = self.coefficients.len();
        if p == 0 {
            return vec![1.0];
        }
        // The Yule-Walker equations give the first p.
        let matrix = DMatrix::from_fn(p, p, |row, column| {
            let lag = row + 1;
            let mut entry = if row == column { 1.0 } else { 0.0 };
            for (i, a) in self.coefficients.iter().enumerate() {
                if lag.abs_diff(i + 1) == column + 1 {
                    entry -= a;
                }
            }
            entry
        });
        let right = DVector::from_fn(p, |row, _| self.coefficients[row]);
        let Some(first) = matrix.lu().solve(&right) else { return vec![1.0] };
        let mut rho = vec![1.0];
        rho.extend(first.iter());
        while rho.len() <= most {
            let lag = rho.len();
            let next: f64 = self.coefficients.iter().enumerate().map(|(i, a)| a * rho[lag - 1 - i]).sum();
            rho.push(next);
            if rho[lag.saturating_sub(p)..].iter().all(|r| r.abs() < 1e-4) {
                break;
            }
        }
        rho
    }
}

/// n over the time that the residuals remember: how many independent samples hold as much. What the values of a pendulum need is
/// the noise at the frequency of the swing, and for the rest that at frequency 0; the larger of the two memories counts.
pub(super) fn effective_size(residuals: &[f64], per_period: f64) -> f64 {
    let n = residuals.len() as f64;
    let rho = Autoregression::of(residuals).correlations(residuals.len() / 2);
    let turn = core::f64::consts::TAU / per_period.max(2.0);
    let memory = |turn: f64| -> f64 {
        let part = |(k, r): (usize, &f64)| {
            let lag = (k + 1) as f64;
            r * (1.0 - lag / n) * libm::cos(turn * lag)
        };
        1.0 + 2.0 * rho[1..].iter().enumerate().map(part).sum::<f64>()
    };
    (n / memory(0.0).max(memory(turn)).max(1.0)).max(2.0)
}

/// What a minimum's Jacobian and residuals say about its values.
#[derive(Clone, Debug)]
pub(super) struct Covariance {
    /// Of the free values; robust to correlation.
    pub matrix: DMatrix<f64>,
    /// As if the residuals were independent.
    pub naive: DMatrix<f64>,
    /// (J'J)^-1.
    pub inverse: DMatrix<f64>,
    /// Of J with every column scaled to length 1.
    pub condition: f64,
}

impl Covariance {
    /// None where the Jacobian is singular.
    pub fn of(
        jacobian: &DMatrix<f64>,
        residuals: &[f64],
        lags_of_three_periods: usize,
    ) -> Option<Covariance> {
        let (n, p) = jacobian.shape();
        if n <= p {
            return None;
        }
        let norms: Vec<f64> = jacobian.column_iter().map(|column| column.norm()).collect();
        if norms.iter().any(|norm| norm.is_nan() || *norm <= 0.0) {
            return None;
        }
        let mut scaled = jacobian.clone();
        for (mut column, norm) in scaled.column_iter_mut().zip(&norms) {
            column.unscale_mut(*norm);
        }
        let triangle = scaled.clone().qr().r();
        let mut half = DMatrix::identity(p, p);
        if !triangle.solve_upper_triangular_mut(&mut half) {
            return None;
        }
        // The largest singular values of the triangle and of its inverse: roots of eigenvalues, which are right where they are largest.
        let largest = |matrix: DMatrix<f64>| matrix.symmetric_eigen().eigenvalues.max();
        let condition = (largest(triangle.tr_mul(&triangle)) * largest(half.tr_mul(&half))).sqrt();
        // Columns of an orthonormal base: the sums below then lose nothing to the condition.
        let base = &scaled * &half;
        let corrected = autocorrelations_of_noise(&base, residuals);
        let rho = Autoregression::through(&corrected, n).correlations((n / 2).max(1));
        let identity = DMatrix::identity(p, p);
        let meat = base.tr_mul(&weighted(&base, &rho));
        let sum: f64 = residuals.iter().map(|r| r * r).sum();
        let spare = spare(n, &meat);
        let parametric = &meat * (sum / spare);
        let naive = identity * (sum / (n - p) as f64);
        let mut larger = parametric.clone();
        if rho.len() > 1 {
            let other = newey_west(&base, residuals, lags_of_three_periods.min(n / 6)) * (n as f64 / spare);
            for i in 0..p {
                for j in 0..p {
                    let both = (other[(i, i)] / parametric[(i, i)]).max(1.0)
                        * (other[(j, j)] / parametric[(j, j)]).max(1.0);
                    larger[(i, j)] *= both.sqrt();
                }
            }
        }
        let back = |meat: &DMatrix<f64>| {
            let mut matrix = &half * meat * half.transpose();
            for i in 0..p {
                for j in 0..p {
                    matrix[(i, j)] /= norms[i] * norms[j];
                }
            }
            matrix
        };
        Some(Covariance {
            matrix: back(&larger),
            naive: back(&naive),
            inverse: back(&DMatrix::identity(p, p)),
            condition,
        })
    }
}

/// The mean of the sum of squares of the residuals over the variance of the noise: n - trace.
fn spare(n: usize, meat: &DMatrix<f64>) -> f64 {
    (n as f64 - meat.trace()).max(0.1 * n as f64).min((n - meat.nrows()) as f64)
}

/// Autocorrelations of the noise, of which the residuals are what the minimum has left: r = (1 - B B') e with the base B. What it has
/// taken of their products, by an autoregressive model of the residuals, is given back. Without it, long memory is found too short.
fn autocorrelations_of_noise(base: &DMatrix<f64>, residuals: &[f64]) -> Vec<f64> {
    let (n, most) = (residuals.len(), most_lags(residuals.len()));
    let rho = Autoregression::of(residuals).correlations((n / 2).max(1));
    let correlated = weighted(base, &rho);
    let meat = base.tr_mul(&correlated);
    let sum: f64 = residuals.iter().map(|r| r * r).sum();
    let variance = sum / spare(n, &meat);
    // E r_t r_(t+k) = sigma^2 (Omega - B B' Omega - Omega B B' + B B' Omega B B').
    let less = &correlated - 0.5 * base * &meat;
    let taken = |lag: usize| -> f64 {
        let products = |a: &DMatrix<f64>, b: &DMatrix<f64>| a.rows(0, n - lag).dot(&b.rows(lag, n - lag));
        products(base, &less) + products(&less, base)
    };
    let plain = autocorrelations(residuals, most);
    let whole: Vec<f64> = (0..=most).map(|lag| sum * plain[lag] + variance * taken(lag)).collect();
    whole.iter().map(|product| if whole[0] > 0.0 { product / whole[0] } else { 0.0 }).collect()
}

/// Omega B for correlations rho of the rows.
fn weighted(base: &DMatrix<f64>, rho: &[f64]) -> DMatrix<f64> {
    let n = base.nrows();
    let mut found = base.clone();
    for (mut column, of) in found.column_iter_mut().zip(base.column_iter()) {
        let (column, of) = (column.as_mut_slice(), of.as_slice());
        for (lag, r) in rho.iter().enumerate().take(n).skip(1) {
            for (to, from) in column[..n - lag].iter_mut().zip(&of[lag..]) {
                *to += r * from;
            }
            for (to, from) in column[lag..].iter_mut().zip(&of[..n - lag]) {
                *to += r * from;
            }
        }
    }
    found
}

/// Sum over lags with falling weights of the products of scores.
fn newey_west(base: &DMatrix<f64>, residuals: &[f64], lags: usize) -> DMatrix<f64> {
    let mut scores = base.clone();
    for (row, r) in residuals.iter().enumerate() {
        scores.row_mut(row).scale_mut(*r);
    }
    // Bartlett's weights are those of sums over blocks of lags + 1 samples, of which one starts at each sample.
    let (n, p) = scores.shape();
    let width = lags + 1;
    let mut sum = DVector::<f64>::zeros(p);
    let mut total = DMatrix::<f64>::zeros(p, p);
    for end in 0..n + lags {
        if end < n {
            sum += scores.row(end).transpose();
        }
        if end >= width {
            sum -= scores.row(end - width).transpose();
        }
        total += &sum * sum.transpose();
    }
    total / width as f64
}

#[cfg(test)]
mod tests {
    use super::super::random::Stream;
    use super::*;

    #[test]
    fn noise_is_found_with_the_memory_that_the_minimum_has_shortened() {
        // Residuals of noise with memory 0.7 from eight slow waves, which take most where the memory is.
        let (n, p, memory) = (400, 8, 0.7);
        let wave = |row: usize, column: usize| {
            let turns = (column / 2 + 1) as f64 * (row as f64 + 0.5) / n as f64;
            let phase = if column.is_multiple_of(2) { 0.0 } else { core::f64::consts::FRAC_PI_2 };
            (2.0 / n as f64).sqrt() * libm::sin(core::f64::consts::TAU * turns + phase)
        };
        let base = DMatrix::from_fn(n, p, wave);
        let (mut plain, mut corrected) = (0.0, 0.0);
        let replicas = 60;
        for replica in 0..replicas {
            let noise = DVector::from_vec(Stream::new(replica).noise(memory, n));
            let left = &noise - &base * base.tr_mul(&noise);
            plain += autocorrelations(left.as_slice(), 1)[1] / replicas as f64;
            corrected += autocorrelations_of_noise(&base, left.as_slice())[1] / replicas as f64;
        }
        assert!((corrected - memory).abs() < 0.02, "{corrected}");
        assert!(plain < memory - 0.03, "{plain}");
    }
}

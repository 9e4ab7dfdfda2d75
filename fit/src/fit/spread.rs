//! What the choice of a model, and what every model leaves out, do to omega0: beyond what noise explains.

use super::covariance::Covariance;
use super::data::Measured;
use super::ladder::{Rung, moved};
use super::optimiser::{CLOSE, minimum};
use super::problem::{Loss, OMEGA2, Problem, Samples, Values, always_free};

/// Windows of the jackknife.
const WINDOWS: usize = 5;

/// omega0^2 of each of five windows, with its own statistical uncertainty. Friction is held.
pub(super) fn windows(
    samples: &Samples,
    measured: Measured,
    values: &Values,
    period: f64,
) -> Vec<(f64, f64)> {
    let (first, last) = (samples.t[0], samples.t[samples.len() - 1]);
    let width = (last - first) / WINDOWS as f64;
    if width < 1.5 * period {
        return Vec::new();
    }
    let slide = super::problem::PRESLIDING;
    let mut found = Vec::new();
    for window in 0..WINDOWS {
        let from = first + width * window as f64;
        // Presliding is integrated forward alone, so its state stands at the first sample.
        let shift = if values[slide] == 0.0 { from + 0.5 * width } else { from };
        let Some(start) = moved(values, shift) else { continue };
        let inside = samples.only(|i| (from..=from + width).contains(&samples.t[i]));
        let stride = inside.len().div_ceil(3000).max(1);
        let part = Samples {
            t: inside.t.iter().step_by(stride).map(|t| t - shift).collect(),
            y: inside.y.iter().step_by(stride).copied().collect(),
            stop: inside.stop,
        };
        let part = if values[slide] == 0.0 { part } else { part.only(|i| part.t[i] >= 0.0) };
        let free = always_free(measured);
        if part.len() < 12 {
            continue;
        }
        let outcome = minimum(&part, measured, &free, Loss::Squares, start, CLOSE);
        let problem = Problem::new(&part, measured, &free, Loss::Squares, outcome.values);
        let lags = (3.0 * period / width * part.len() as f64) as usize;
        let covariance =
            problem.derivatives().and_then(|jacobian| Covariance::of(&jacobian, problem.plain(), lags));
        if let Some(covariance) = covariance {
            found.push((outcome.values[OMEGA2], covariance.matrix[(2, 2)].sqrt()));
        }
    }
    found.retain(|w| w.0.is_finite() && w.1.is_finite() && w.1 > 0.0);
    found
}

/// The scatter of windows as that of their weighted mean, and the part of it that their own uncertainties leave unexplained.
pub(super) fn scatter(windows: &[(f64, f64)]) -> Option<(f64, f64)> {
    if windows.len() < 4 {
        return None;
    }
    let weight = |w: &(f64, f64)| 1.0 / (w.1 * w.1);
    let sum: f64 = windows.iter().map(weight).sum();
    let mean = windows.iter().map(|w| w.0 * weight(w)).sum::<f64>() / sum;
    let chi: f64 = windows.iter().map(|w| (w.0 - mean).powi(2) * weight(w)).sum();
    let ratio = chi / (windows.len() - 1) as f64;
    // With five windows noise alone gives more than three times what is expected in 2 % of records.
    Some(((ratio / sum).sqrt(), ((ratio - 3.0).max(0.0) / sum).sqrt()))
}

/// Spread of a value between rungs, weighted by Akaike's weights, beyond what noise does between nested models (Hausman,
/// Econometrica 46 (1978) 1251): the variance of a difference is at most that of the richer estimate.
pub(super) fn between(rungs: &[Rung], chosen: usize, place: usize, variance: f64) -> f64 {
    let least = rungs.iter().map(|rung| rung.worth()).fold(f64::INFINITY, f64::min);
    let weight = |rung: &Rung| libm::exp(-0.5 * (rung.worth() - least));
    let total: f64 = rungs.iter().map(weight).sum();
    let own = rungs[chosen].outcome.values[place];
    let spread: f64 = rungs
        .iter()
        .map(|rung| weight(rung) / total * ((rung.outcome.values[place] - own).powi(2) - variance).max(0.0))
        .sum();
    spread.max(0.0).sqrt()
}

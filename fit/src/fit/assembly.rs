//! From a fitted record to the result: uncertainties, diagnosis, verdicts.

use super::bootstrap::block_bootstrap;
use super::covariance::Covariance;
use super::data::{Measured, clean, extent};
use super::diagnosis::{ScaleFound, of_residuals, scale, swing};
use super::held::{by_presliding, held, presliding_held, with_bounds, without_held};
use super::monte_carlo::interval;
use super::options::{DRAWS, FitOptions, Model};
use super::problem::{
    DRY, LINEAR, Loss, NAMES, OFFSET, OMEGA2, PRESLIDING, Problem, QUADRATIC, SCALE, THETA, VELOCITY,
    presliding,
};
use super::quote::{Quote, quoted};
use super::record::{Fitted, fitted};
use super::refusal::FitRefusal;
use super::result::{
    BudgetRow, Correlation, Diagnostics, Dropped, Estimate, Fit, FrictionEstimates, Grade, Residuals,
    RungSummary, Verdict,
};
use super::spread::{between, scatter, windows};
use super::verdicts::{Evidence, verdicts};
use crate::digits::Shown;
use nalgebra::DVector;

pub(super) fn record(
    measured: Measured,
    t: &[f64],
    values: &[f64],
    options: &FitOptions,
) -> Result<Fit, FitRefusal> {
    let clean = clean(t, values)?;
    let fitted = fitted(&clean, measured, options)?;
    options.tell("uncertainty");
    let Fitted { rungs, chosen, samples, rows, anchor, period, .. } = &fitted;
    let rung = &rungs[*chosen];
    let found = &rung.outcome.values;
    // Terms on their bound count as free.
    let mut varied = [rung.free.clone(), held(rung)].concat();
    // With the scale beside, whose effect on every other value is wanted.
    let mut widened = varied.clone();
    if !widened.contains(&SCALE) {
        widened.push(SCALE);
    }
    let problem = Problem::new(samples, measured, &widened, Loss::Squares, *found);
    let singular = || FitRefusal::new("the record does not determine the motion: its Jacobian is singular");
    let all = problem.derivatives().ok_or_else(singular)?;
    let mut jacobian = all.columns(0, varied.len()).into_owned();
    let scale_column = all.column(widened.len() - 1);
    if let Some(column) = by_presliding(samples, measured, rung) {
        jacobian = jacobian.insert_column(varied.len(), 0.0);
        jacobian.set_column(varied.len(), &column);
        varied.push(PRESLIDING);
    }
    let span = samples.t[samples.len() - 1] - samples.t[0];
    let per_period = samples.len() as f64 * period / span;
    let lags = (3.0 * per_period) as usize;
    let mut known = Covariance::of(&jacobian, problem.plain(), lags);
    if known.is_none() {
        varied.truncate(rung.free.len());
        jacobian = jacobian.columns(0, varied.len()).into_owned();
        known = Covariance::of(&jacobian, problem.plain(), lags);
    }
    let mut covariance = known.ok_or_else(singular)?;
    let inverse = &covariance.inverse;
    let step = -(inverse * jacobian.tr_mul(&DVector::from_column_slice(problem.plain())));
    let by_scale: DVector<f64> = if varied.contains(&SCALE) {
        DVector::zeros(varied.len())
    } else {
        without_held(inverse, &-(inverse * jacobian.tr_mul(&scale_column)), rung.free.len())
    };
    // Of terms on their bound those that lean on it by more than noise would make them.
    let leans = |i: &usize| -step[*i] > 3.0 * covariance.matrix[(*i, *i)].sqrt();
    let wanted_negative = (rung.free.len()..varied.len()).filter(leans).count();
    covariance.matrix = with_bounds(&covariance.matrix, &varied, rung, &step);
    let (low, high) = extent(&samples.y);
    let reach = 0.5 * (high - low);
    let place = |value: usize| varied.iter().position(|free| *free == value);
    let pieces = windows(samples, measured, found, *period);
    let scattered = scatter(&pieces);
    let of_residuals = of_residuals(samples, found, problem.plain());
    let mut asked = ScaleFound::default();
    if measured != Measured::Acceleration {
        let doubtful = !fitted.isochronous && rung.outcome.rms() > 5e-3 * reach && of_residuals.lag1 > 0.3;
        asked = scale(samples, measured, rung.model, found, *period, doubtful);
    }
    // Rates of the clock enter every value by its power of time.
    let clock = |value: usize| match value {
        OMEGA2 | DRY => 2.0,
        VELOCITY | LINEAR => 1.0,
        _ => 0.0,
    };
    let estimate = |value: usize| {
        let Some(i) = place(value) else { return Estimate::new(found[value], 0.0, 0.0, 0.0) };
        let variance = covariance.matrix[(i, i)];
        // The other rungs have no angle of presliding.
        let mut model = if value == PRESLIDING { 0.0 } else { between(rungs, *chosen, value, variance) };
        if value == OMEGA2 {
            model = libm::hypot(model, scattered.map_or(0.0, |s| s.1));
            // A scale that is wanted and not given says that something of the model is wrong, and by how much that counts.
            if asked.is_wanted(rung.outcome.rms()) && place(SCALE).is_none() {
                model = libm::hypot(model, asked.omega2 - found[OMEGA2]);
            }
        }
        let calibration =
            libm::hypot(by_scale[i] * options.scale_u, clock(value) * found[value] * options.clock_u);
        Estimate::new(found[value], variance.sqrt(), model, calibration)
    };
    let squared = estimate(OMEGA2);
    let half = 0.5 / squared.value.sqrt();
    let omega0 = Estimate::new(
        squared.value.sqrt(),
        half * squared.statistical,
        half * squared.model,
        half * squared.calibration,
    );
    let Quote { g, length, corrections, mut budget } = quoted(omega0, options)?;
    let mut diagnostics = Diagnostics {
        effective_size: fitted.effective,
        condition: covariance.condition,
        samples_per_period: per_period,
        omega0_u_naive: place(OMEGA2).map_or(0.0, |i| half * covariance.naive[(i, i)].sqrt()),
        omega0_u_windows: scattered.map(|s| half * s.0),
        omega0_u_bootstrap: (DRAWS && options.bootstrap > 0)
            .then(|| {
                let block = lags.max(1).min(samples.len() / 4);
                block_bootstrap(&jacobian, &covariance.inverse, problem.plain(), block, options)
            })
            .and_then(|variances| place(OMEGA2).map(|i| half * variances[i].sqrt())),
        ..of_residuals
    };
    if measured != Measured::Acceleration {
        (diagnostics.scale, diagnostics.scale_u, diagnostics.scale_rms) = (asked.scale, asked.u, asked.rms);
    }
    diagnostics.linear_equation_rms = fitted.linear_equation_rms;
    budget.push(BudgetRow {
        source: "as if residuals were independent".into(),
        u: budget_of(&budget, omega0, diagnostics.omega0_u_naive),
    });
    let term = |value: usize| place(value).map(|_| estimate(value));
    let mut dropped: Vec<Dropped> = clean
        .dropped
        .iter()
        .map(|(row, reason)| Dropped { row: *row, reason: (*reason).to_string() })
        .collect();
    dropped.extend(fitted.dropped.iter().map(|(row, reason)| Dropped { row: *row, reason: reason.clone() }));
    let mut fit = Fit {
        model: rung.model,
        rms: rung.outcome.rms(),
        rms_deg: Some(rung.outcome.rms().to_degrees()),
        omega0,
        g,
        length,
        length_given: options.length.is_some() || !options.parts.is_empty(),
        offset: Some(estimate(OFFSET)),
        offset_deg: Some(scaled(estimate(OFFSET), 1f64.to_degrees())),
        scale: place(SCALE).map(|_| estimate(SCALE)),
        friction: FrictionEstimates {
            linear: term(LINEAR),
            quadratic: term(QUADRATIC),
            dry: term(DRY),
            presliding: term(PRESLIDING).map(|e| {
                if !rung.free.contains(&PRESLIDING) {
                    return presliding_held(found, e.statistical);
                }
                let angle = libm::exp(e.value);
                Estimate { value: presliding(found), ..scaled(e, angle) }
            }),
        },
        swing: largest_swing(found, samples),
        verdicts: Vec::new(),
        dropped,
        window: fitted.window,
        window_reason: fitted.window_reason.clone(),
        samples: samples.len(),
        ladder: rungs
            .iter()
            .map(|rung| RungSummary {
                model: rung.model,
                rms: rung.mean_square.sqrt(),
                aicc: rung.aicc,
                bic: rung.bic,
                omega0: rung.outcome.values[OMEGA2].sqrt(),
                wanted_negative: rung.wanted_negative.iter().map(|place| NAMES[*place]).collect(),
            })
            .collect(),
        correlation: correlation(&varied, &covariance),
        corrections,
        monte_carlo: interval(omega0, options),
        budget,
        diagnostics,
        residuals: Residuals {
            t: rows.iter().map(|row| t[*row]).collect(),
            measured: samples.y.clone(),
            residual: problem.plain().iter().map(|r| -r).collect(),
            ..Residuals::default()
        },
        state: (found[THETA], found[VELOCITY], *anchor),
    };
    let plain = rungs.iter().filter(|rung| rung.model < Model::Presliding);
    let without_presliding = if fit.model == Model::Presliding {
        plain.map(|rung| rung.mean_square.sqrt()).fold(f64::INFINITY, f64::min)
    } else {
        fit.rms
    };
    fit.verdicts = verdicts(
        &fit,
        &Evidence {
            reach,
            wanted_negative,
            rms_without_presliding: without_presliding,
            window_spread: scattered.map_or(0.0, |s| s.0 * (pieces.len() as f64).sqrt() / squared.value),
            periods: span / period,
            angles: measured == Measured::Angle,
        },
    );
    if fitted.driven {
        fit.verdicts.push(Verdict::new(
            Grade::Note,
            format!(
                "the swing stays the same until {:.2} s and falls only then: something drives the pendulum before, so only what follows is fitted",
                Shown(fitted.window.0)
            ),
        ));
    }
    Ok(fit)
}

/// A line of the budget in proportion to the fit's.
fn budget_of(budget: &[BudgetRow], omega0: Estimate, u: f64) -> f64 {
    budget.first().map_or(0.0, |row| row.u * u / omega0.statistical.max(f64::MIN_POSITIVE))
}

fn scaled(e: Estimate, factor: f64) -> Estimate {
    Estimate::new(e.value * factor, e.statistical * factor, e.model * factor, e.calibration * factor)
}

/// The turning angle at the start of the samples.
fn largest_swing(values: &super::problem::Values, samples: &super::problem::Samples) -> f64 {
    let first = samples.t[0];
    let along = super::problem::trajectory(values, first, 0.0);
    let (theta, velocity) =
        along.map_or((values[THETA], values[VELOCITY]), |along| along.motion(first.min(0.0)));
    swing(theta, velocity, values[OMEGA2])
}

fn correlation(free: &[usize], covariance: &Covariance) -> Correlation {
    let matrix = &covariance.matrix;
    let entry = |i: usize, j: usize| matrix[(i, j)] / (matrix[(i, i)] * matrix[(j, j)]).sqrt();
    Correlation {
        names: free.iter().map(|place| NAMES[*place]).collect(),
        rows: (0..free.len()).map(|i| (0..free.len()).map(|j| entry(i, j)).collect()).collect(),
    }
}

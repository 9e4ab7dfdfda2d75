//! The one entry: data and options in, a result or a refusal out.

use super::covariance::{Covariance, autocorrelations};
use super::data::{Data, Measured, clean};
use super::options::{FitOptions, Measure};
use super::problem::{
    DRY, LINEAR, Loss, NAMES, OFFSET, OMEGA2, PRESLIDING, Problem, QUADRATIC, SCALE, THETA, VELOCITY, Values,
};
use super::record::{Fitted, fitted};
use super::refusal::FitRefusal;
use super::result::{
    BudgetRow, Correlation, Diagnostics, Dropped, Estimate, Fit, FrictionEstimates, Residuals, RungSummary,
};

/// Fits a pendulum with friction to data.
///
/// # Errors
/// Where the data hold no motion, or the options contradict each other.
pub fn fit(data: &Data, options: &FitOptions) -> Result<Fit, FitRefusal> {
    data.check()?;
    options.check()?;
    match data {
        Data::Record { measured, t, values } => record(*measured, t, values, options),
        Data::Gate { .. } | Data::Table { .. } => Err(FitRefusal::new("not yet")),
    }
}

fn record(measured: Measured, t: &[f64], values: &[f64], options: &FitOptions) -> Result<Fit, FitRefusal> {
    let clean = clean(t, values)?;
    let fitted = fitted(&clean, measured, options)?;
    let Fitted { rungs, chosen, samples, rows, anchor, .. } = &fitted;
    let rung = &rungs[*chosen];
    let problem = Problem::new(samples, measured, &rung.free, Loss::Squares, rung.outcome.values);
    let singular = || FitRefusal::new("the record does not determine the motion: its Jacobian is singular");
    let jacobian = problem.derivatives().ok_or_else(singular)?;
    let span = samples.t[samples.len() - 1] - samples.t[0];
    let per_period = samples.len() as f64 * fitted.period / span;
    let covariance =
        Covariance::of(&jacobian, problem.plain(), (3.0 * per_period) as usize).ok_or_else(singular)?;
    let found = &rung.outcome.values;
    let place = |value: usize| rung.free.iter().position(|free| *free == value);
    let deviation = |value: usize| place(value).map_or(0.0, |i| covariance.matrix[(i, i)].sqrt());
    let estimate = |value: usize| Estimate::new(found[value], deviation(value), 0.0, 0.0);
    let omega0 = found[OMEGA2].sqrt();
    let u_omega0 = 0.5 * deviation(OMEGA2) / omega0;
    let omega0 = Estimate::new(omega0, u_omega0, 0.0, options.clock_u * omega0);
    let (g, length, budget) = quoted(omega0, options);
    let rho = autocorrelations(problem.plain(), 1);
    let names: Vec<&str> = rung.free.iter().map(|place| NAMES[*place]).collect();
    let size = rung.free.len();
    let matrix = &covariance.matrix;
    let correlation = |i: usize, j: usize| matrix[(i, j)] / (matrix[(i, i)] * matrix[(j, j)]).sqrt();
    let term = |value: usize| place(value).map(|_| estimate(value));
    let degrees = |e: Estimate| {
        Estimate::new(
            e.value.to_degrees(),
            e.statistical.to_degrees(),
            e.model.to_degrees(),
            e.calibration.to_degrees(),
        )
    };
    let diagnostics = Diagnostics {
        lag1: rho[1],
        effective_size: fitted.effective,
        condition: covariance.condition,
        samples_per_period: per_period,
        omega0_u_naive: place(OMEGA2).map_or(0.0, |i| 0.5 * covariance.naive[(i, i)].sqrt() / omega0.value),
        ..Diagnostics::default()
    };
    let mut dropped: Vec<Dropped> = clean
        .dropped
        .iter()
        .map(|(row, reason)| Dropped { row: *row, reason: (*reason).to_string() })
        .collect();
    dropped.extend(fitted.dropped.iter().map(|(row, reason)| Dropped { row: *row, reason: reason.clone() }));
    Ok(Fit {
        model: rung.model,
        rms: rung.outcome.rms(),
        rms_deg: Some(rung.outcome.rms().to_degrees()),
        omega0,
        g,
        length,
        offset: Some(estimate(OFFSET)),
        offset_deg: Some(degrees(estimate(OFFSET))),
        scale: options.free_scale.then(|| estimate(SCALE)),
        friction: FrictionEstimates {
            linear: term(LINEAR),
            quadratic: term(QUADRATIC),
            dry: term(DRY),
            presliding: term(PRESLIDING).map(|e| {
                let angle = e.value.exp();
                Estimate::new(angle, angle * e.statistical, angle * e.model, angle * e.calibration)
            }),
        },
        swing: swing(found),
        verdicts: Vec::new(),
        dropped,
        window: fitted.window,
        window_reason: fitted.window_reason.clone(),
        samples: samples.len(),
        ladder: rungs
            .iter()
            .map(|rung| RungSummary {
                model: rung.model,
                rms: rung.outcome.rms(),
                aicc: rung.aicc,
                bic: rung.bic,
                omega0: rung.outcome.values[OMEGA2].sqrt(),
                wanted_negative: rung.wanted_negative.iter().map(|place| NAMES[*place]).collect(),
            })
            .collect(),
        correlation: Correlation {
            names,
            rows: (0..size).map(|i| (0..size).map(|j| correlation(i, j)).collect()).collect(),
        },
        budget,
        diagnostics,
        residuals: Residuals {
            t: rows.iter().map(|row| t[*row]).collect(),
            measured: samples.y.clone(),
            residual: problem.plain().iter().map(|r| -r).collect(),
        },
        state: (found[THETA], found[VELOCITY], *anchor),
    })
}

/// The turning angle of the state.
fn swing(values: &Values) -> f64 {
    let frequency = libration::Frequency::from_omega2(values[OMEGA2]);
    let orbit =
        frequency.and_then(|frequency| libration::Orbit::new(values[THETA], values[VELOCITY], frequency));
    orbit.map_or(f64::NAN, |orbit| orbit.theta_max())
}

/// g from a length, the length from g, and the budget of what is quoted.
fn quoted(omega0: Estimate, options: &FitOptions) -> (Option<Estimate>, Option<Estimate>, Vec<BudgetRow>) {
    let row = |source: &str, u: f64| BudgetRow { source: source.to_string(), u };
    let relative = |part: f64| 2.0 * part / omega0.value;
    let omega2 = omega0.value * omega0.value;
    match (options.length, options.gravity) {
        (Some(Measure { value: length, u }), _) => {
            let g = omega2 * length;
            let of = |part: f64| g * relative(part);
            let by_length = g * u / length;
            let calibration = of(omega0.calibration).hypot(by_length);
            let estimate = Estimate::new(g, of(omega0.statistical), of(omega0.model), calibration);
            let budget = vec![
                row("fit", of(omega0.statistical)),
                row("model", of(omega0.model)),
                row("length", by_length),
                row("scale and clock", of(omega0.calibration)),
            ];
            (Some(estimate), Some(Estimate::new(length, 0.0, 0.0, u)), budget)
        }
        (None, Some(Measure { value: gravity, u })) => {
            let length = gravity / omega2;
            let of = |part: f64| length * relative(part);
            let by_gravity = length * u / gravity;
            let calibration = of(omega0.calibration).hypot(by_gravity);
            let estimate = Estimate::new(length, of(omega0.statistical), of(omega0.model), calibration);
            let budget = vec![
                row("fit", of(omega0.statistical)),
                row("model", of(omega0.model)),
                row("gravity", by_gravity),
                row("scale and clock", of(omega0.calibration)),
            ];
            (Some(Estimate::new(gravity, 0.0, 0.0, u)), Some(estimate), budget)
        }
        (None, None) => {
            let budget = vec![
                row("fit", omega0.statistical),
                row("model", omega0.model),
                row("scale and clock", omega0.calibration),
            ];
            (None, None, budget)
        }
    }
}

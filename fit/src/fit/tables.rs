//! Gate and table data: periods alone, fitted by the core's period without an integration.

use super::covariance::autocorrelations;
use super::curve::{CurveFit, inside, nearest};
use super::dark::{by_transits, coarse, smooth};
use super::data::{extent, median};
use super::monte_carlo::interval;
use super::options::{FitOptions, Model};
use super::quote::{Quote, quoted};
use super::refusal::FitRefusal;
use super::result::{
    Correlation, Diagnostics, Dropped, Estimate, Fit, FrictionEstimates, Grade, Residuals, Verdict,
};
use super::spread::scatter;
use super::verdicts::{gravest_first, of_correlation, of_length};
use crate::digits::Shown;
use libration::damped::averaged_turning_angle;
use libration::{Frequency, Friction, Orbit};

/// A relative uncertainty of omega0 beyond this says that the rows hold no more than the mean period of an unknown swing.
const MOST_SPREAD: f64 = 0.05;

const UNKNOWN_SWING: &str = "the periods do not determine the swing, so g is not known";

/// Rows that can be used, and what was left out.
struct Rows {
    kept: Vec<usize>,
    dropped: Vec<Dropped>,
}

fn period_of_angle(theta_max: f64, omega0: f64) -> Option<f64> {
    let theta_max = theta_max.abs();
    if theta_max >= core::f64::consts::PI {
        return None;
    }
    Some(Orbit::new(theta_max, 0.0, Frequency::from_omega0(omega0).ok()?).ok()?.period())
}

fn swing_of_velocity(velocity: f64, omega0: f64) -> f64 {
    let orbit = Frequency::from_omega0(omega0).and_then(|frequency| Orbit::new(0.0, velocity, frequency));
    orbit.map_or(f64::NAN, |orbit| orbit.theta_max())
}

/// Periods that are numbers, positive, and no multiples of the usual one by a missed passage.
fn usable(columns: &[&[f64]], periods: &[f64]) -> Result<Rows, FitRefusal> {
    let finite = |row: usize| columns.iter().all(|column| column[row].is_finite()) && periods[row] > 0.0;
    let good: Vec<f64> = (0..periods.len()).filter(|row| finite(*row)).map(|row| periods[row]).collect();
    let usual = median(&good);
    let mut rows = Rows { kept: Vec::new(), dropped: Vec::new() };
    for row in 0..periods.len() {
        let reason = if !finite(row) {
            "no number, or a period that is not positive"
        } else if !(0.3..1.7).contains(&(periods[row] / usual)) && periods.len() > 10 {
            "a passage was missed or counted twice"
        } else {
            rows.kept.push(row);
            continue;
        };
        rows.dropped.push(Dropped { row, reason: reason.to_string() });
    }
    if rows.kept.len() < 3 {
        return Err(FitRefusal::new(format!("{} rows with periods: at least 3 are needed", rows.kept.len())));
    }
    Ok(rows)
}

/// omega0 of the smallest swings, to start from.
fn omega0_start(periods: &[f64]) -> f64 {
    let unit = period_of_angle(0.1, 1.0).unwrap_or(core::f64::consts::TAU);
    unit / extent(periods).0
}

/// Periods of known swings: omega0 and, where the rows determine it, an offset of the angle.
pub(super) fn table(swings: &[f64], periods: &[f64], options: &FitOptions) -> Result<Fit, FitRefusal> {
    let rows = usable(&[swings, periods], periods)?;
    let a: Vec<f64> = rows.kept.iter().map(|row| swings[*row]).collect();
    let measured: Vec<f64> = rows.kept.iter().map(|row| periods[*row]).collect();
    if let Some(wide) = a.iter().find(|a| a.abs() >= core::f64::consts::PI) {
        return Err(FitRefusal::new(format!(
            "swing = {:?} rad: must lie below pi; are the swings in degrees?",
            Shown(*wide)
        )));
    }
    let plain =
        |values: &[f64]| -> Option<Vec<f64>> { a.iter().map(|a| period_of_angle(*a, values[0])).collect() };
    let shifted = |values: &[f64]| -> Option<Vec<f64>> {
        a.iter().map(|a| period_of_angle(a - values[1], values[0])).collect()
    };
    let start = omega0_start(&measured);
    let failed = || FitRefusal::new("the table does not determine omega0");
    let one = nearest(&plain, &measured, &[start], 0).ok_or_else(failed)?;
    let both_sides = a.iter().any(|a| *a > 0.0) && a.iter().any(|a| *a < 0.0);
    let two = if both_sides && a.len() > 4 {
        nearest(&shifted, &measured, &[one.values[0], 1e-3], 0)
    } else {
        None
    };
    // An offset stays where the rows ask for it.
    let (first, aicc) = (one.values[0], one.aicc());
    let (best, other) = match two {
        Some(two) if two.aicc() < aicc - 2.0 => (two, Some((first, aicc))),
        Some(two) => (one, Some((two.values[0], two.aicc()))),
        None => (one, None),
    };
    // The other model by its weight, beyond what noise does between nested models (spread.rs).
    let model = other.map_or(0.0, |(omega0, aicc)| {
        let weight = 1.0 / (1.0 + libm::exp((0.5 * (aicc - best.aicc())).clamp(-700.0, 700.0)));
        (weight * ((omega0 - best.values[0]).powi(2) - best.u(0).powi(2)).max(0.0)).sqrt()
    });
    let offset = best.values.get(1).map(|value| Estimate::new(*value, best.u(1), 0.0, 0.0));
    let swing = a.iter().fold(0.0f64, |most, a| most.max(a.abs()));
    let mut fit = of_periods(&best, model, options, rows, swing, &measured)?;
    fit.offset = offset;
    fit.offset_deg = offset.map(|e| Estimate::new(e.value.to_degrees(), e.u.to_degrees(), 0.0, 0.0));
    let middle = best.values.get(1).copied().unwrap_or(0.0);
    fit.residuals.swings = a.iter().map(|a| (a - middle).abs()).collect();
    fit.residuals.t = a;
    Ok(fit)
}

/// Periods at a light gate: the swing follows from the time that a flag takes, with its width free, or from the decay of the period
/// itself.
pub(super) fn gate(
    t: &[f64],
    periods: &[f64],
    transits: Option<&[f64]>,
    options: &FitOptions,
) -> Result<Fit, FitRefusal> {
    let few = transits.and_then(coarse);
    if few.is_some_and(|few| few.values == 1) {
        usable(&[t, periods], periods)?;
        let mut fit = gate(t, periods, None, options).map_err(|_| FitRefusal::new(UNKNOWN_SWING))?;
        fit.verdicts.push(Verdict::new(
            Grade::Note,
            "every passage is dark for the same time: the swing was read from the decay of the periods",
        ));
        return Ok(fit);
    }
    let columns: Vec<&[f64]> = [Some(t), Some(periods), transits].into_iter().flatten().collect();
    let mut rows = usable(&columns, periods)?;
    let failed = || {
        let count = periods.len();
        FitRefusal::new(format!("{count} periods do not determine omega0 beside an unknown swing"))
    };
    // Once for the outliers, once without them.
    for _ in 0..2 {
        let best = gate_once(t, periods, transits, &rows.kept).ok_or_else(failed)?;
        let keep = inside(&best.0.residuals);
        let out: Vec<usize> = (0..keep.len()).filter(|i| !keep[*i]).collect();
        if out.is_empty() || out.len() * 10 > keep.len() {
            break;
        }
        for i in &out {
            rows.dropped.push(Dropped { row: rows.kept[*i], reason: "outlier: beyond 6 deviations".into() });
        }
        rows.kept = (0..keep.len()).filter(|i| keep[*i]).map(|i| rows.kept[i]).collect();
    }
    let times: Vec<f64> = rows.kept.iter().map(|row| t[*row]).collect();
    let curve = transits.zip(few).and_then(|(dark, few)| {
        let dark: Vec<f64> = rows.kept.iter().map(|row| dark[*row]).collect();
        smooth(&times, &dark, few)
    });
    let smoothed = transits.zip(curve.as_ref()).map(|(dark, curve)| {
        let mut all = dark.to_vec();
        rows.kept.iter().zip(&curve.dark).for_each(|(row, dark)| all[*row] = *dark);
        all
    });
    let transits = smoothed.as_deref().or(transits);
    let (mut best, swing, linear) = gate_once(t, periods, transits, &rows.kept).ok_or_else(failed)?;
    if let Some(curve) = &curve {
        let measured: Vec<f64> = rows.kept.iter().map(|row| periods[*row]).collect();
        curve.add_errors(&mut best, &measured);
    }
    // An uncertainty that is NaN knows none.
    let determined = best.u(0) <= MOST_SPREAD * best.values[0];
    let undetermined = if linear.is_none() && !(determined && best.u(1) <= best.values[1].abs()) {
        Some(FitRefusal::new(UNKNOWN_SWING))
    } else {
        (!determined).then(|| {
            FitRefusal::new(format!(
                "{} periods do not determine omega0 beside an unknown swing: give more of them, or a table of periods against swings",
                rows.kept.len()
            ))
        })
    };
    let measured: Vec<f64> = rows.kept.iter().map(|row| periods[*row]).collect();
    let said = transits.zip(few).and_then(|(dark, few)| {
        let dark: Vec<f64> = rows.kept.iter().map(|row| dark[*row]).collect();
        few.verdict(&dark, &best, curve.is_some())
    });
    let model = model_of_gate(&best, t, periods, transits, &rows.kept);
    let swings = match transits {
        Some(dark) => {
            let of = |row: &usize| swing_of_velocity(best.values[1] / dark[*row], best.values[0]);
            rows.kept.iter().map(of).collect()
        }
        None => swings_of_decay(times.iter().map(|t| t - times[0]), &best.values).unwrap_or_default(),
    };
    let mut fit = of_periods(&best, model, options, rows, swing, &measured)?;
    fit.residuals.swings = swings;
    fit.residuals.t = times;
    fit.window = extent(&fit.residuals.t);
    fit.diagnostics.lag1 = autocorrelations(&best.residuals, 1)[1];
    if let Some(place) = linear {
        fit.model = Model::Linear;
        let known_swing = best.values[1] >= 2.0 * best.u(1);
        fit.friction.linear = Some(Estimate::new(best.values[place], best.u(place), 0.0, 0.0));
        if !known_swing {
            fit.verdicts.push(Verdict::new(
                Grade::Warning,
                "the periods do not determine the swing: omega0 holds for small swings only",
            ));
        }
    }
    fit.verdicts.extend(said);
    fit.verdicts.extend(of_correlation(&fit));
    // A verdict that the record is no pendulum's says more.
    undetermined.filter(|_| fit.stands()).map_or(Ok(fit), Err)
}

/// The swings while linear friction, values[2], makes them smaller from values[1].
fn swings_of_decay(times: impl Iterator<Item = f64>, values: &[f64]) -> Option<Vec<f64>> {
    let frequency = Frequency::from_omega0(values[0]).ok()?;
    let friction = Friction::new(values[2], 0.0, 0.0, 0.0).ok()?;
    Some(times.map(|t| averaged_turning_angle(values[1], t, frequency, friction)).collect())
}

/// Periods of these swings, by the frequency of small ones with the friction: sqrt(omega0^2 - linear^2).
fn by_decay(times: &[f64], values: &[f64]) -> Option<Vec<f64>> {
    let swings = swings_of_decay(times.iter().copied(), values)?;
    let damped = ((values[0] - values[2]) * (values[0] + values[2])).sqrt();
    swings.into_iter().map(|swing| period_of_angle(swing, damped)).collect()
}

/// What the model leaves out of omega0: the scatter between five parts of the rows, each with its own omega0, beyond what their
/// noise explains.
fn model_of_gate(
    best: &CurveFit,
    t: &[f64],
    periods: &[f64],
    transits: Option<&[f64]>,
    kept: &[usize],
) -> f64 {
    let parts = kept.chunks(kept.len().div_ceil(5)).filter(|part| part.len() >= 8);
    let each = |part: &[usize]| {
        let of = |column: &[f64]| -> Vec<f64> { part.iter().map(|row| column[*row]).collect() };
        let (times, measured) =
            (of(t).iter().map(|time| time - t[kept[0]]).collect::<Vec<f64>>(), of(periods));
        let dark = transits.map(of);
        let curve = |omega0: &[f64]| {
            let mut values = best.values.clone();
            values[0] = omega0[0];
            match &dark {
                Some(dark) => by_transits(dark, &values),
                None => by_decay(&times, &values),
            }
        };
        let found = nearest(&curve, &measured, &best.values[..1], (part.len() / 8).min(30))?;
        Some((found.values[0], found.u(0))).filter(|(_, u)| *u > 0.0)
    };
    let found: Vec<(f64, f64)> = parts.filter_map(each).collect();
    scatter(&found).map_or(0.0, |(_, beyond)| beyond)
}

/// The fit, the largest swing, and the place of the linear friction if it is among the values.
fn gate_once(
    t: &[f64],
    periods: &[f64],
    transits: Option<&[f64]>,
    kept: &[usize],
) -> Option<(CurveFit, f64, Option<usize>)> {
    let measured: Vec<f64> = kept.iter().map(|row| periods[*row]).collect();
    let start = omega0_start(&measured);
    let lags = (kept.len() / 8).min(30);
    if let Some(transits) = transits {
        let dark: Vec<f64> = kept.iter().map(|row| transits[*row]).collect();
        let shortest = extent(&dark).0;
        let curve = |values: &[f64]| by_transits(&dark, values);
        // A width that gives the fastest passage this share of the separatrix's speed.
        let tried = [0.1, 0.3, 0.6]
            .map(|share| nearest(&curve, &measured, &[start, share * 2.0 * start * shortest], lags));
        let best = tried.into_iter().flatten().min_by(|a, b| a.rms().total_cmp(&b.rms()))?;
        let swing = swing_of_velocity(best.values[1] / shortest, best.values[0]);
        return Some((best, swing, None));
    }
    let first = t[kept[0]];
    let times: Vec<f64> = kept.iter().map(|row| t[*row] - first).collect();
    let span = extent(&times).1.max(f64::MIN_POSITIVE);
    let curve = |values: &[f64]| by_decay(&times, values);
    let mut tried = Vec::new();
    for swing in [0.2, 0.8] {
        for decay in [0.1, 1.0] {
            tried.extend(nearest(&curve, &measured, &[start, swing, decay / span], lags));
        }
    }
    let best = tried.into_iter().min_by(|a, b| a.rms().total_cmp(&b.rms()))?;
    let swing = best.values[1];
    Some((best, swing, Some(2)))
}

/// The result of periods alone.
fn of_periods(
    best: &CurveFit,
    model: f64,
    options: &FitOptions,
    rows: Rows,
    swing: f64,
    measured: &[f64],
) -> Result<Fit, FitRefusal> {
    let value = best.values[0];
    let omega0 = Estimate::new(value, best.u(0), model, options.clock_u * value);
    let Quote { g, length, corrections, budget } = quoted(omega0, options)?;
    let n = measured.len() as f64;
    let mean = measured.iter().sum::<f64>() / n;
    let constant = (measured.iter().map(|t| (t - mean).powi(2)).sum::<f64>() / n).sqrt();
    let rms = best.rms();
    let mut verdicts = Vec::new();
    let expected =
        period_of_angle(swing, value).unwrap_or(mean) / period_of_angle(0.0, value).unwrap_or(mean) - 1.0;
    if rms > 0.01 * mean && constant > 0.01 * mean && rms > 0.6 * constant {
        verdicts.push(Verdict::new(
            Grade::Refuted,
            format!(
                "periods scatter by {:.1} %: more than one mode moves, or passages were missed",
                Shown(100.0 * rms / mean)
            ),
        ));
    } else if expected > 0.02 && constant < 0.5 * rms {
        verdicts.push(Verdict::new(
            Grade::Refuted,
            "the period does not depend on the swing: this is no angle of a pendulum",
        ));
    }
    let names = &["omega0", "second value", "linear"][..best.values.len()];
    let matrix = &best.covariance.matrix;
    let entry = |i: usize, j: usize| matrix[(i, j)] / (matrix[(i, i)] * matrix[(j, j)]).sqrt();
    let mut fit = Fit {
        model: Model::None,
        rms,
        rms_deg: None,
        omega0,
        g,
        length,
        length_given: options.length.is_some() || !options.parts.is_empty(),
        corrections,
        monte_carlo: interval(omega0, options),
        offset: None,
        offset_deg: None,
        scale: None,
        friction: FrictionEstimates::default(),
        swing,
        verdicts,
        dropped: rows.dropped,
        window: (0.0, 0.0),
        window_reason: "all rows".to_string(),
        samples: measured.len(),
        ladder: Vec::new(),
        correlation: Correlation {
            names: names.to_vec(),
            rows: (0..names.len()).map(|i| (0..names.len()).map(|j| entry(i, j)).collect()).collect(),
        },
        budget,
        diagnostics: Diagnostics {
            condition: best.covariance.condition,
            omega0_u_naive: best.covariance.naive[(0, 0)].sqrt(),
            effective_size: n,
            ..Diagnostics::default()
        },
        residuals: Residuals {
            measured: measured.to_vec(),
            residual: best.residuals.clone(),
            ..Residuals::default()
        },
        state: (swing, 0.0, 0.0),
    };
    fit.verdicts.extend(of_length(&fit));
    fit.verdicts = gravest_first(fit.verdicts);
    Ok(fit)
}

//! A record in time: window, search, ladder, uncertainty.

use super::data::{Clean, Measured, bounded, extent, robust_deviation};
use super::diagnosis::{isochronous, linear_equation};
use super::horizon::grown;
use super::ladder::{Rung, chosen, criteria, moved, rung, terms};
use super::optimiser::{CLOSE, FINE, ROUGH, minimum};
use super::options::{FitOptions, Model, Stop};
use super::problem::{LINEAR, Loss, OFFSET, PRESLIDING, Samples, Values, always_free};
use super::refusal::FitRefusal;
use super::start::{Start, driven, free_decay, rotation, starts};
use super::swings::{Passage, Swings, noise};
use super::window::{caught, described, last_motion, reached};
use crate::digits::Shown;

/// A record at the minimum of every rung.
#[derive(Clone, Debug)]
pub(super) struct Fitted {
    pub rungs: Vec<Rung>,
    pub chosen: usize,
    /// Samples of the chosen rung, with times since `anchor`.
    pub samples: Samples,
    /// Their rows of the input.
    pub rows: Vec<usize>,
    pub anchor: f64,
    pub period: f64,
    pub window: (f64, f64),
    pub window_reason: String,
    pub effective: f64,
    pub dropped: Vec<(usize, String)>,
    /// rms of the linear equation with the friction of the chosen rung.
    pub linear_equation_rms: f64,
    /// Whether it describes the record far better than the pendulum's.
    pub isochronous: bool,
    /// Whether the swing is constant before the window, by a drive.
    pub driven: bool,
}

/// Samples of the ladder; the chosen rung then takes all.
const MOST: usize = 8000;

pub(super) fn fitted(clean: &Clean, measured: Measured, options: &FitOptions) -> Result<Fitted, FitRefusal> {
    options.tell("start");
    let inside = |t: f64| options.window.is_none_or(|(from, to)| (from..=to).contains(&t));
    let kept: Vec<usize> = (0..clean.t.len()).filter(|i| inside(clean.t[*i])).collect();
    if kept.len() < 8 {
        let few = if kept.len() == 1 { "sample" } else { "samples" };
        return Err(FitRefusal::new(format!("{} {few} in the window: at least 8 are needed", kept.len())));
    }
    let t: Vec<f64> = kept.iter().map(|i| clean.t[*i]).collect();
    let y: Vec<f64> = kept.iter().map(|i| clean.y[*i]).collect();
    let swings = Swings::of(&t, &y);
    let mut decay = free_decay(&swings, y.len());
    let drive = driven(&swings.passages[decay.clone()], swings.slack);
    decay.start += drive;
    let sensor = noise(&y);
    let mut starts = starts(&swings, &decay, measured);
    let mut turns_over = false;
    if measured == Measured::Angle && starts.is_empty() {
        starts.extend(rotation(&t, &y));
        turns_over = !starts.is_empty();
    }
    let Some(start) = nearest_start(&t, &y, measured, &starts, sensor, options.stop) else {
        let turns = swings.turns.len();
        let points = if turns == 1 { "turning point" } else { "turning points" };
        return Err(FitRefusal::new(format!(
            "{turns} {points} in the record: at least one whole swing is needed"
        )));
    };
    if measured == Measured::Angle && start.last > 1.1 * core::f64::consts::PI {
        return Err(FitRefusal::new(format!(
            "the last swing turns back {} rad from the rest: a pendulum turns back below pi; are these degrees or counts?",
            if start.last < 1e6 {
                format!("{:.4}", Shown(start.last))
            } else {
                format!("{:.3e}", Shown(start.last))
            }
        )));
    }
    // With two samples in a period omega0 is pi over the step, and a swing passes its rest at less than 2 omega0.
    let step = (t[t.len() - 1] - t[0]) / (t.len() - 1) as f64;
    if measured == Measured::Velocity && start.reach * step > 3.0 * core::f64::consts::PI {
        return Err(FitRefusal::new(format!(
            "a velocity of {:.1e} rad/s at steps of {:.1e} s: a swing turns by less than {:.0} rad from one sample to the next",
            Shown(start.reach),
            Shown(step),
            Shown(3.0 * core::f64::consts::PI)
        )));
    }
    let all = Samples { t: t.iter().map(|t| t - start.anchor).collect(), y, stop: options.stop };
    let (mut from, mut to) = (all.t[0], all.t[all.len() - 1]);
    let mut reason = "as stated";
    if options.window.is_none() {
        reason = "from the release to the stop";
        if drive > 0 {
            reason = "from the end of the drive to the stop";
        }
        // A pendulum that only turns over the top has no turning points.
        if !turns_over {
            from = swings.turns[decay.start].t - start.anchor;
            to = (swings.turns[decay.end].t - start.anchor + 0.5 * start.period).min(to);
        }
    }
    options.tell("window");
    let part = |from: f64, to: f64| all.only(|i| (from..=to).contains(&all.t[i]));
    let first = grown(&part(from.max(-0.3 * start.period), to), measured, &start, 3, sensor);
    let values = first.values;
    if options.window.is_none() {
        (from, to) = extended(&all, measured, &start, &values, sensor, to, &swings.passages[decay.clone()]);
    }
    let mut samples = part(from, to);
    let mut thin = samples.thinned(from, to, MOST);
    let linear_equation_rms = linear_equation(&thin, measured, values[OFFSET], first.rms());
    let linear_does =
        |rms: f64| measured == Measured::Angle && isochronous(linear_equation_rms, rms, start.reach);
    let mut rungs = climbed(&thin, measured, options, &values, &start, sensor, &linear_does);
    if options.window.is_none()
        && let Some(inner) = ends(&thin, &rungs, sensor.max(HAND * start.reach / OUTLIER))
    {
        (from, to) = inner;
        samples = part(from, to);
        thin = samples.thinned(from, to, MOST);
        rungs = climbed(&thin, measured, options, &values, &start, sensor, &linear_does);
    }
    let mut rows: Vec<usize> =
        (0..all.len()).filter(|i| (from..=to).contains(&all.t[*i])).map(|i| clean.rows[kept[i]]).collect();
    let is_isochronous = linear_does(rungs[chosen(&rungs)].outcome.rms());
    let mut anchor = start.anchor;
    let per_period = thin.len() as f64 * start.period / (to - from);
    let mut effective = criteria(&mut rungs, per_period);
    let wanted = !is_isochronous && options.model.is_none_or(|model| model == Model::Presliding);
    let moves = |rung: &Rung| rung.outcome.rms() < 0.05 * (extent(&thin.y).1 - extent(&thin.y).0);
    if wanted
        && let Some(dry) =
            rungs.iter().find(|rung| rung.model == Model::Dry).filter(|rung| moves(rung)).cloned()
    {
        options.tell("presliding");
        // Presliding has a state of its own that no later one determines: the search starts at the first passage.
        let first = swings.passages[decay.clone()].iter().map(|p| p.t - anchor).find(|t| *t >= from);
        let shift = first.unwrap_or(0.0);
        if let Some(values) = moved(&dry.outcome.values, shift) {
            let later = |samples: &Samples| Samples {
                t: samples.t.iter().filter(|t| **t >= shift).map(|t| t - shift).collect(),
                y: (0..samples.len()).filter(|i| samples.t[*i] >= shift).map(|i| samples.y[i]).collect(),
                stop: samples.stop,
            };
            let thin = later(&thin);
            let plain = rung(&thin, measured, Model::Dry, &values, options.free_scale, CLOSE);
            let mut slid =
                rung(&thin, measured, Model::Presliding, &plain.outcome.values, options.free_scale, CLOSE);
            slid.not_above(&plain);
            // A few samples fewer: the ratio of what dry friction leaves stays near 1.
            slid.mean_square *= (dry.mean_square / plain.mean_square).clamp(0.95, 1.25);
            rungs.push(slid);
            effective = criteria(&mut rungs, per_period);
            let last = rungs.len() - 1;
            if options.model == Some(Model::Presliding) || (options.model.is_none() && chosen(&rungs) == last)
            {
                rows.drain(..samples.t.iter().filter(|t| **t < shift).count());
                samples = later(&samples);
                anchor += shift;
                from = 0.0;
                to -= shift;
                for rung in &mut rungs[..last] {
                    if let Some(values) = moved(&rung.outcome.values, shift) {
                        rung.outcome.values = values;
                    }
                }
            }
        }
    }
    let chosen = match options.model {
        Some(model) => rungs.iter().position(|rung| rung.model == model).unwrap_or(0),
        None => chosen(&rungs),
    };
    let mut dropped = Vec::new();
    options.tell("all samples");
    finish(&mut rungs[chosen], &mut samples, &mut rows, measured, options, sensor, &mut dropped);
    Ok(Fitted {
        chosen,
        rows,
        anchor,
        period: start.period,
        window: (from + anchor, to + anchor),
        window_reason: reason.to_string(),
        effective,
        dropped,
        samples,
        rungs,
        linear_equation_rms,
        isochronous: is_isochronous,
        driven: drive > 0 && options.window.is_none(),
    })
}

/// Of several starts the one whose search over a short horizon ends best.
fn nearest_start(
    t: &[f64],
    y: &[f64],
    measured: Measured,
    starts: &[Start],
    noise: f64,
    stop: Stop,
) -> Option<Start> {
    if starts.len() < 2 {
        return starts.first().copied();
    }
    let tried = starts.iter().map(|start| {
        let all = Samples { t: t.iter().map(|t| t - start.anchor).collect(), y: y.to_vec(), stop };
        let part = all.thinned(-0.3 * start.period, 12.0 * start.period, 1500);
        let outcome = grown(&part, measured, start, 1, noise);
        (outcome.sum_of_squares, Start { values: outcome.values, ..*start })
    });
    tried.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, start)| start)
}

/// The window, widened to all that the motion describes and cut where it does not.
fn extended(
    all: &Samples,
    measured: Measured,
    start: &Start,
    values: &Values,
    noise: f64,
    mut to: f64,
    passages: &[Passage],
) -> (f64, f64) {
    let swing = start.reach;
    // The neighbourhood of the release alone: friction of a later time must not decide. At first a wide bound, because the motion
    // before the anchor is extrapolated.
    let (mut begin, mut local) = (-0.2 * start.period, *values);
    for share in [0.03, 0.02, 0.01, 0.01] {
        let near = all.thinned(begin, (2.5 * start.period).min(to), 3000);
        let mut free = always_free(measured);
        free.push(LINEAR);
        let outcome = minimum(&near, measured, &free, Loss::Squares, local, ROUGH);
        local = outcome.values;
        let usual = robust_deviation(&outcome.residuals).max(noise);
        let bound = bounded(6.0 * usual, share * swing, 0.1 * swing);
        let next = reached(all, measured, &local, begin, bound, -1.0);
        // What was taken in wrongly is given back.
        let inner = reached(all, measured, &local, -0.1 * start.period, bound, -1.0);
        begin = next.max(inner);
    }
    let from = begin.min(-0.1 * start.period).max(all.t[0]);
    let near = all.thinned(from, to, 3000);
    let along = super::problem::Problem::new(&near, measured, &[], Loss::Squares, *values);
    let usual = robust_deviation(along.plain()).max(noise);
    // What is beyond a bound of the size of the last swing says nothing.
    to = to.max(reached(
        all,
        measured,
        values,
        to,
        (6.0 * usual).min((0.3 * start.last).max(4.0 * noise)),
        1.0,
    ));
    let stop = caught(&near, along.plain(), values[OFFSET], start.period, noise);
    // Swings that go on in their own rhythm beyond it say that the search has gone astray there, not the pendulum.
    let after = |p: &&Passage| p.t - start.anchor > stop;
    let before = passages.iter().rev().find(|p| !after(p)).map_or(0.0, |p| p.swing);
    let goes_on = passages.iter().filter(after).filter(|p| p.swing > 0.5 * before).count() > 2;
    if !goes_on {
        to = to.min(stop);
    }
    to = to.min(last_motion(all, start.period, noise) + 0.1 * start.period);
    (from, to)
}

/// A hand moves a pendulum away from its free motion by such a share of the swing; by less, it is the friction law that fails.
const HAND: f64 = 0.05;

/// What a hand at the ends leaves of a window, where it moves so few samples that they would be outliers of the chosen rung: then every
/// rung is better without them.
fn ends(samples: &Samples, rungs: &[Rung], noise: f64) -> Option<(f64, f64)> {
    let whole = |rung: &&Rung| rung.outcome.residuals.len() == samples.len();
    let best = rungs.iter().filter(whole).min_by(|a, b| a.mean_square.total_cmp(&b.mean_square))?;
    let residuals = &best.outcome.residuals;
    let (from, to) = described(samples, residuals, OUTLIER * robust_deviation(residuals).max(noise));
    let left = samples.t.iter().filter(|t| (from..=to).contains(t)).count();
    let lost = samples.len() - left;
    (lost > 0 && few(lost, samples.len())).then_some((from, to))
}

/// An outlier is so many deviations from the fit.
const OUTLIER: f64 = 6.0;

/// Many are no outliers but the model's failure, which must stay in sight.
fn few(count: usize, samples: usize) -> bool {
    count * 50 <= samples
}

/// The rungs below presliding, each from what its own growing horizon has reached; `values` are those of the richest. Two do for a
/// record that the linear equation describes.
fn climbed(
    samples: &Samples,
    measured: Measured,
    options: &FitOptions,
    values: &Values,
    start: &Start,
    noise: f64,
    linear_does: &dyn Fn(f64) -> bool,
) -> Vec<Rung> {
    let models: Vec<Model> = match options.model {
        None => vec![Model::None, Model::Linear, Model::Quadratic, Model::Dry],
        Some(Model::Presliding) => vec![Model::Dry],
        Some(model) => vec![model],
    };
    let mut rungs: Vec<Rung> = Vec::new();
    for model in models {
        if rungs.len() == 2 && rungs.iter().all(|rung| linear_does(rung.outcome.rms())) {
            break;
        }
        options.tell(model.name());
        let own = match model {
            Model::None | Model::Dry => *values,
            _ => grown(samples, measured, start, terms(model).len().min(3), noise).values,
        };
        // Without friction a long record is far from the minimum anyway: a part of the samples is enough.
        let few = samples.thinned(f64::NEG_INFINITY, f64::INFINITY, 1000);
        let alone = model == Model::None && options.model.is_none();
        let (used, patience) = if alone { (&few, ROUGH) } else { (samples, CLOSE) };
        let mut next = rung(used, measured, model, &own, options.free_scale, patience);
        if let Some(poorer) = rungs.last().filter(|poorer| poorer.outcome.residuals.len() == used.len()) {
            if next.outcome.sum_of_squares > poorer.outcome.sum_of_squares {
                let other = rung(used, measured, model, &poorer.outcome.values, options.free_scale, CLOSE);
                if other.outcome.sum_of_squares < next.outcome.sum_of_squares {
                    next = other;
                }
            }
            next.not_above(poorer);
        }
        rungs.push(next);
    }
    rungs
}

/// The chosen rung on all samples without those that lie far outside.
fn finish(
    rung_chosen: &mut Rung,
    samples: &mut Samples,
    rows: &mut Vec<usize>,
    measured: Measured,
    options: &FitOptions,
    noise: f64,
    dropped: &mut Vec<(usize, String)>,
) {
    let again = |samples: &Samples, rung_chosen: &Rung| {
        let start = &rung_chosen.outcome.values;
        // Presliding that is held stays so: a new search for it would begin far from its bound.
        let slides = rung_chosen.free.contains(&PRESLIDING);
        let held = rung_chosen.model == Model::Presliding && !slides;
        let acting = if held { Model::Dry } else { rung_chosen.model };
        let mut next = rung(samples, measured, acting, start, options.free_scale, FINE);
        if held {
            next.model = Model::Presliding;
            next.wanted_negative.push(PRESLIDING);
        }
        (next.aicc, next.bic, next.mean_square) =
            (rung_chosen.aicc, rung_chosen.bic, rung_chosen.mean_square);
        next
    };
    *rung_chosen = again(samples, rung_chosen);
    let residuals = &rung_chosen.outcome.residuals;
    let bound = OUTLIER * robust_deviation(residuals).max(noise);
    let outside: Vec<bool> = residuals.iter().map(|r| r.abs() > bound).collect();
    let count = outside.iter().filter(|outside| **outside).count();
    if count > 0 && few(count, samples.len()) && extent(residuals).1 > 0.0 {
        for (i, row) in rows.iter().enumerate().filter(|(i, _)| outside[*i]) {
            dropped.push((
                *row,
                format!(
                    "outlier: {:.1} deviations from the fit",
                    Shown(OUTLIER * residuals[i].abs() / bound)
                ),
            ));
        }
        *rows = rows.iter().zip(&outside).filter(|(_, outside)| !**outside).map(|(row, _)| *row).collect();
        *samples = samples.only(|i| !outside[i]);
        *rung_chosen = again(samples, rung_chosen);
    }
}

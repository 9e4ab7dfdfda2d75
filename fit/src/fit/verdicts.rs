//! Findings in words: what a person with experience would say of the record and the fit.

use super::diagnosis::{ScaleFound, isochronous};
use super::result::{Fit, Grade, Verdict};
use crate::digits::{Shown, plain};
use crate::order::sorted;

/// What verdicts need beside the result.
#[derive(Clone, Copy, Debug)]
pub(super) struct Evidence {
    /// The largest distance from the rest, in the unit of the record.
    pub reach: f64,
    /// Terms of the chosen model that wanted to be negative by more than noise explains.
    pub wanted_negative: usize,
    /// rms of the best model without presliding, whose two terms can imitate another waveform.
    pub rms_without_presliding: f64,
    /// The relative scatter of omega0^2 between windows.
    pub window_spread: f64,
    /// Periods in the window.
    pub periods: f64,
    /// Whether the record is of angles.
    pub angles: bool,
}

/// g on the surface of the Earth, pole to equator with mountains, in m/s^2.
pub(super) const GRAVITY_ON_EARTH: (f64, f64) = (9.763, 9.834);

/// g this many times that of the Earth, or less by as much, is a wrong unit or power of ten: g of the Moon is 6 times less.
const OTHER_UNIT: f64 = 8.0;

/// Of equally grave ones the first stays first.
pub(super) fn gravest_first(verdicts: Vec<Verdict>) -> Vec<Verdict> {
    sorted(&verdicts, |a, b| b.grade.cmp(&a.grade))
}

/// Three digits, without an exponent where the number is not too long for it.
fn short(value: f64) -> String {
    // What is rounded to 1e-4, and to 1e7.
    if (9.995e-5..9.995e6).contains(&value) { plain(value, 2) } else { format!("{:.2e}", Shown(value)) }
}

/// What a stated length says where g would be none of the Earth.
pub(super) fn of_length(fit: &Fit) -> Option<Verdict> {
    let (Some(g), Some(length), true) = (fit.g, fit.length, fit.length_given) else { return None };
    let (low, high) = GRAVITY_ON_EARTH;
    if (low - 3.0 * g.u..=high + 3.0 * g.u).contains(&g.value) {
        return None;
    }
    let middle = 0.5 * (low + high);
    let times = g.value / middle;
    if !(1.0 / OTHER_UNIT..OTHER_UNIT).contains(&times) {
        return Some(Verdict::new(
            Grade::Refuted,
            format!(
                "the unit of the length or of the times is wrong: g would be {} m/s^2, {} times that of the Earth",
                short(g.value),
                short(times)
            ),
        ));
    }
    Some(Verdict::new(
        Grade::Warning,
        format!(
            "the stated length is off by {:.1} %: g would be {:.3} m/s^2, and with g = {:.2} the length is {:.4} m",
            Shown(100.0 * (times - 1.0).abs()),
            Shown(g.value),
            Shown(middle),
            Shown(length.value / times)
        ),
    ))
}

/// What residuals that follow each other say.
pub(super) fn of_correlation(fit: &Fit) -> Option<Verdict> {
    let diagnostics = &fit.diagnostics;
    if diagnostics.lag1.is_nan() || diagnostics.lag1 <= 0.5 {
        return None;
    }
    let ratio = fit.omega0.u / diagnostics.omega0_u_naive;
    if !ratio.is_finite() {
        return None;
    }
    Some(Verdict::new(
        Grade::Note,
        format!(
            "residuals follow each other (correlation {:.2}): an uncertainty that takes them as independent would be {:.0} times too small",
            Shown(diagnostics.lag1),
            Shown(ratio)
        ),
    ))
}

pub(super) fn verdicts(fit: &Fit, evidence: &Evidence) -> Vec<Verdict> {
    let mut found = Vec::new();
    let mut say = |grade: Grade, sentence: String| found.push(Verdict::new(grade, sentence));
    let diagnostics = &fit.diagnostics;
    let share = fit.rms / evidence.reach;
    let linear = diagnostics.linear_equation_rms;
    let degrees = fit.swing.to_degrees();
    let isochronous = evidence.angles && isochronous(linear, fit.rms, fit.swing);
    if isochronous && linear < 1e-4 * evidence.reach {
        say(
            Grade::Refuted,
            format!(
                "too good: this is a linear cosine, computed and not measured (the linear equation leaves {:.1e} of the swing, the pendulum's {:.1e})",
                Shown(linear / evidence.reach),
                Shown(share)
            ),
        );
    } else if isochronous {
        say(
            Grade::Refuted,
            format!(
                "the period does not depend on the swing: this is no angle of a pendulum (the linear equation leaves {:.2} deg rms, the pendulum's {:.2} deg)",
                Shown(linear.to_degrees()),
                Shown(fit.rms.to_degrees())
            ),
        );
    } else if share < 3e-6 {
        say(
            Grade::Warning,
            format!("too good: residuals of {:.1e} of the swing are below any sensor's noise", Shown(share)),
        );
    }
    let s = diagnostics.scale;
    let gain = fit.rms / diagnostics.scale_rms;
    let asked =
        ScaleFound { scale: s, u: diagnostics.scale_u, rms: diagnostics.scale_rms, ..ScaleFound::default() };
    let asks = asked.is_wanted(fit.rms) && !isochronous && degrees > 10.0;
    let waveform =
        asks && evidence.rms_without_presliding > 2.0 * diagnostics.scale_rms && (s - 1.0).abs() > 0.1;
    let in_degrees = libm::log(s / 1f64.to_radians()).abs() < 0.1;
    let in_radians = libm::log(s * 1f64.to_radians()).abs() < 0.1;
    if s > 0.0 && gain > 1.1 && evidence.angles && !isochronous && (in_degrees || in_radians) {
        let (given, meant) = if in_degrees { ("degrees", "radians") } else { ("radians", "degrees") };
        say(
            Grade::Refuted,
            format!(
                "the unit is wrong: a scale of {:.4} says that values read as {given} are {meant}",
                Shown(s)
            ),
        );
    } else if waveform {
        say(
            Grade::Refuted,
            format!(
                "the waveform is not a rigid pendulum's: with a scale of {:.3} of the angle the rms falls by a factor of {:.1}",
                Shown(s),
                Shown(evidence.rms_without_presliding / diagnostics.scale_rms)
            ),
        );
    } else if asks && (s - 1.0).abs() > 0.01 {
        say(
            Grade::Warning,
            format!(
                "the record asks for a scale of {:.3} of its angle: with it the rms falls by a factor of {:.2}",
                Shown(s),
                Shown(gain)
            ),
        );
    }
    let falling = fit.friction.linear.is_some_and(|linear| linear.value < -2.0 * linear.u);
    if share > 0.25 {
        say(
            Grade::Refuted,
            format!(
                "no motion of a pendulum describes the record: {:.0} % of the swing is left",
                Shown(100.0 * share)
            ),
        );
    } else if share > 8e-3
        && diagnostics.lag1 > 0.9
        && (falling || evidence.wanted_negative > 0 || evidence.window_spread > 0.01 || share > 0.05)
        && !isochronous
        && !waveform
    {
        say(
            Grade::Refuted,
            format!(
                "the base moves or the friction law is wrong: {:.1} % of the swing is left, from one sample to the next with a correlation of {:.2}",
                Shown(100.0 * share),
                Shown(diagnostics.lag1)
            ),
        );
    } else if falling {
        say(
            Grade::Warning,
            "the linear friction is below 0: the dry friction falls while the velocity rises, by a law that is not quite that of the models".to_string(),
        );
    } else if evidence.wanted_negative > 0 {
        say(
            Grade::Warning,
            "a friction term wants to be negative and was held at 0: the friction law is not quite that of the models".to_string(),
        );
    }
    if evidence.window_spread > 3e-3 && evidence.periods > 10.0 {
        say(
            Grade::Warning,
            format!(
                "omega0 is not constant: five windows of the record scatter by {:.2} %",
                Shown(50.0 * evidence.window_spread)
            ),
        );
    }
    if share <= 0.25
        && let Some(verdict) = of_length(fit)
    {
        say(verdict.grade, verdict.sentence);
    }
    let per_period = diagnostics.samples_per_period;
    if per_period > 0.0 && per_period < 4.0 {
        let word = if per_period < 2.6 { "two" } else { "three" };
        say(
            Grade::Warning,
            format!(
                "{word} points per swing ({:.1} samples in a period): another frequency may fit as well",
                Shown(per_period)
            ),
        );
    }
    if evidence.periods > 0.0 && evidence.periods < 2.0 {
        say(
            Grade::Warning,
            format!(
                "the record holds {:.1} periods: friction and rest are hardly determined",
                Shown(evidence.periods)
            ),
        );
    }
    if diagnostics.condition > 1e6 {
        say(
            Grade::Warning,
            format!(
                "the values depend on each other (condition {:.0e}): only their combination is known",
                Shown(diagnostics.condition)
            ),
        );
    }
    if let Some(verdict) = of_correlation(fit) {
        say(verdict.grade, verdict.sentence);
    }
    let clock = diagnostics.against_velocity.abs();
    if clock > 0.3 && diagnostics.effective_size > 20.0 {
        say(
            Grade::Note,
            format!("residuals follow the velocity (correlation {:.2}): the clock has faults", Shown(clock)),
        );
    }
    gravest_first(found)
}

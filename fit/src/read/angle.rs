//! Angles as tools write them: their unit by size where the header has none, unwrapped, with rest near zero where rest is a
//! right angle or a half turn away.

use super::profile::{Profile, median};
use super::refusal::{Refusal, quoted};
use super::stamps;

pub(super) const DEGREE: f64 = 0.017453292519943295;
const TURN: f64 = 6.283185307179586;

/// The factor to rad of a column without a unit, and the guess in words.
pub(super) fn factor_by_size(name: &str, values: &[f64]) -> Result<(f64, String), Refusal> {
    let profile = Profile::of(values.iter().copied());
    let largest = profile.most.abs().max(profile.least.abs());
    if profile.whole && profile.range() > 720.0 {
        let question = format!(
            "in which unit is column {}? It holds whole numbers from {} to {}",
            quoted(name),
            profile.least,
            profile.most
        );
        return Err(Refusal::question(
            question + ":",
            vec!["deg".into(), "rad".into(), "counts of a turn".into()],
            "--unit angle=deg, =rad or =4000/turn",
        ));
    }
    // An angle of a turn or less in rad; wrapped ones jump by most of a turn.
    let jumps = values.windows(2).any(|pair| (pair[1] - pair[0]).abs() > 0.75 * TURN);
    let degrees = largest > 7.0 || largest > 3.3 && !jumps;
    let (factor, unit, why) =
        if degrees { (DEGREE, "degrees", "exceeds") } else { (1.0, "rad", "does not exceed") };
    let than = if degrees { 3.3 } else { 7.0 };
    let than = if !degrees && largest <= 3.3 { 3.3 } else { than };
    let guess = format!(
        "Column {} has no unit: taken as {unit} by its size (the largest, {}, {why} {than}); \
         --unit angle=deg or =rad says otherwise.",
        quoted(name),
        stamps::short(largest)
    );
    Ok((factor, guess))
}

/// Adds whole turns where an angle, kept within one turn, jumps by more than half of it. How many jumps there were.
pub(super) fn unwrap(values: &mut [f64]) -> usize {
    let profile = Profile::of(values.iter().copied());
    if profile.range() > 1.05 * TURN || profile.range() < 0.5 * TURN {
        return 0;
    }
    let (mut turns, mut jumps, mut before) = (0.0, 0, f64::NAN);
    for value in values.iter_mut() {
        let step = *value - before;
        before = *value;
        if step > 0.5 * TURN {
            (turns, jumps) = (turns - 1.0, jumps + 1);
        } else if step < -0.5 * TURN {
            (turns, jumps) = (turns + 1.0, jumps + 1);
        }
        *value += turns * TURN;
    }
    jumps
}

/// The angle about which the motion ends: the middle of neighbouring turning points, over the later half of them.
pub(super) fn rest(values: &[f64]) -> Option<f64> {
    let profile = Profile::of(values.iter().copied());
    // A turning point stands out by a twentieth of the largest swing from the noise.
    let margin = 0.05 * profile.range();
    let mut turning: Vec<f64> = Vec::new();
    let (mut low, mut high, mut up) = (f64::INFINITY, f64::NEG_INFINITY, None);
    for &value in values {
        (low, high) = (low.min(value), high.max(value));
        match up {
            Some(true) if value < high - margin => {
                turning.push(high);
                (low, up) = (value, Some(false));
            }
            Some(false) if value > low + margin => {
                turning.push(low);
                (high, up) = (value, Some(true));
            }
            None if high - low > margin => {
                up = Some(value == high);
                (low, high) = (value, value);
            }
            _ => {}
        }
    }
    let mut middles: Vec<f64> =
        turning.windows(2).skip(turning.len() / 2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
    if turning.len() < 4 { None } else { median(&mut middles) }
}

/// The multiple of a right angle to take from an angle whose rest is within 10 degrees of it; zero if none.
pub(super) fn right_angles(values: &[f64], rest: Option<f64>) -> f64 {
    let quarter = 0.25 * TURN;
    match rest {
        Some(rest) => {
            let whole = (rest / quarter).round();
            if (rest - whole * quarter).abs() <= 10.0 * DEGREE { whole * quarter } else { 0.0 }
        }
        // Too short to tell: only a half turn that lies inside the values.
        None => {
            let profile = Profile::of(values.iter().copied());
            let whole = (0.5 * (profile.least + profile.most) / (2.0 * quarter)).round() * 2.0 * quarter;
            if profile.least < whole && whole < profile.most { whole } else { 0.0 }
        }
    }
}

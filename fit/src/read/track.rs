//! From the places of a tracked point to angles: the pivot is the centre of their circle or the origin of the axes, whichever
//! the track can prove; at a stated length only where it proves neither, because a length is first one of the pendulum.

use super::circle::{Circle, Down, circle};
use super::record::Pivot;
use super::refusal::Refusal;

/// A pivot within this part of its radius of the origin is the origin.
const AT_ORIGIN: f64 = 0.02;

/// Angles of a track, its pivot (in the unit of the coordinates), and what was guessed.
pub(super) struct Swing {
    pub angles: Vec<f64>,
    pub pivot: Pivot,
    pub understood: Vec<String>,
}

/// The angles about the pivot. `length` is in the unit of the coordinates.
pub(super) fn swing(x: &[f64], y: &[f64], length: Option<f64>, metres: bool) -> Result<Swing, Refusal> {
    let (at, how) = match (free(x, y, circle(x, y, None), about(x, y, 0.0, 0.0)), length) {
        (Ok(proven), _) => proven,
        (Err(question), None) => return Err(question),
        (Err(question), Some(length)) => {
            let across = spread(x).max(spread(y));
            if across > 2.0 * length {
                let reason = format!(
                    "--length = {length}: cannot be the distance of the pivot from a track that is {across:.4} wide; \
                     give it in the unit of the track"
                );
                return Err(Refusal::fault(None, reason));
            }
            let found = circle(x, y, Some(length)).ok_or(question)?;
            (found, format!("at the stated length {length} (the arc is too short for a circle)"))
        }
    };
    let pivot = (at.x, at.y);
    let down = Down::of(x, y, pivot);
    let unit = if metres { " m" } else { "" };
    let said = format!(
        "The pivot is {how}: ({:.4}, {:.4}), {:.4}{unit} from the track, which is {:.2} % of that off its circle; down is {}.",
        at.x,
        at.y,
        at.radius,
        100.0 * at.rms / at.radius,
        down.words()
    );
    Ok(Swing {
        angles: down.angles(x, y, pivot),
        pivot: Pivot { x: at.x, y: at.y, radius: at.radius, metres },
        understood: vec![said],
    })
}

/// The pivot that the track itself proves.
fn free(x: &[f64], y: &[f64], found: Option<Circle>, origin: Circle) -> Result<(Circle, String), Refusal> {
    let proven = found.filter(|found| {
        // The arc must stand out from its chord by more than the points scatter, with a radius known to some per cent
        // even where errors of neighbouring points are alike.
        let across = spread(x).max(spread(y));
        let sagitta = across * across / (8.0 * found.radius);
        let short = across < found.radius;
        (!short || sagitta > 4.0 * found.rms)
            && 4.0 * found.radius_error < 0.1 * found.radius
            && across > 0.02 * found.radius
    });
    let scatter = origin.rms / origin.radius;
    match proven {
        Some(found) => {
            let off = (found.x * found.x + found.y * found.y).sqrt();
            let origin_as_good = origin.rms <= (2.0 * found.rms).max(1e-3 * origin.radius);
            // A circle goes through any three points: a few more prove little.
            let few = x.len() < 10 && scatter < 5e-3;
            if few || off <= AT_ORIGIN * found.radius && origin_as_good {
                Ok((origin, "the origin of the axes".into()))
            } else {
                Ok((found, "the centre of the track's circle".into()))
            }
        }
        None if scatter < 0.02 && spread(x).max(spread(y)) > 0.02 * origin.radius => {
            Ok((origin, "the origin of the axes (the arc is too short for a circle)".into()))
        }
        None => Err(Refusal::question(
            "how far is the tracked point from the pivot? The arc is too short to tell:",
            Vec::new(),
            "--length 0.500m",
        )),
    }
}

/// The circle about a given centre.
fn about(x: &[f64], y: &[f64], cx: f64, cy: f64) -> Circle {
    let n = x.len().max(1) as f64;
    let distances = || x.iter().zip(y).map(|(x, y)| ((x - cx) * (x - cx) + (y - cy) * (y - cy)).sqrt());
    let radius = distances().sum::<f64>() / n;
    let rms = (distances().map(|each| (each - radius) * (each - radius)).sum::<f64>() / n).sqrt();
    Circle { x: cx, y: cy, radius, rms, radius_error: rms / n.sqrt() }
}

fn spread(values: &[f64]) -> f64 {
    let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    most - values.iter().copied().fold(f64::INFINITY, f64::min)
}

//! g from a period that was timed, and the normal g of a place, as `libration gravity` has them.
//!
//! | name | value |
//! |---|---|
//! | `period`, `length`, `swing`, `end` | value and standard uncertainty with a blank between, in s, m and rad: `end` is the swing at the end of the count, where it decays |
//! | `latitude`, `height` | a number, in rad and m |

use crate::json::json;
use crate::lines::{refused, statements};
use crate::quantities::{measure, number};
use libration_fit::fit::Measure;
use libration_fit::{PeriodGravity, gravity_of_decay, gravity_of_period, normal_gravity};
use serde::Serialize;

#[derive(Default)]
struct Timed {
    period: Option<Measure>,
    length: Option<Measure>,
    swing: Option<Measure>,
    end: Option<Measure>,
    latitude: Option<f64>,
    height: Option<f64>,
}

#[derive(Serialize)]
struct Answer {
    /// Where period and length are stated.
    found: Option<PeriodGravity>,
    /// Where a latitude is.
    normal: Option<f64>,
}

/// The answer in JSON to what is stated, or a refusal of one line.
pub fn gravity(text: &str) -> Result<String, String> {
    let mut timed = Timed::default();
    for (name, value) in statements(text) {
        match name {
            "period" => timed.period = Some(measure(name, value)?),
            "length" => timed.length = Some(measure(name, value)?),
            "swing" => timed.swing = Some(measure(name, value)?),
            "end" => timed.end = Some(measure(name, value)?),
            "latitude" => timed.latitude = Some(number(name, value)?),
            "height" => timed.height = Some(number(name, value)?),
            _ => return Err(refused("name", name)),
        }
    }
    let small = Measure { value: 0.0, u: 0.0 };
    let found = timed.period.zip(timed.length).map(|(period, length)| match (timed.swing, timed.end) {
        (swing, Some(end)) => gravity_of_decay(period, length, swing.unwrap_or(small), end),
        (swing, None) => gravity_of_period(period, length, swing.unwrap_or(small)),
    });
    let normal = timed.latitude.map(|latitude| normal_gravity(latitude, timed.height.unwrap_or_default()));
    let answer = Answer {
        found: found.transpose().map_err(|refusal| refusal.to_string())?,
        normal: normal.transpose().map_err(|refusal| refusal.to_string())?,
    };
    Ok(json(&answer))
}

//! Units as headers write them, with their factor to SI.

use crate::decimal;
use crate::letters::lower;

/// What a unit measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Dimension {
    Time,
    Angle,
    AngularVelocity,
    AngularAcceleration,
    LinearAcceleration,
    Length,
    /// Pixels, counts, arbitrary units: a scale the file does not know.
    Arbitrary,
    /// Anything that is no coordinate of a swing: velocity, force, voltage, temperature, frequency.
    Other,
}

/// A unit with its factor to SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Unit {
    pub dimension: Dimension,
    pub factor: f64,
}

const DEGREE: f64 = 0.017453292519943295;
const TURN: f64 = 6.283185307179586;
const GRAVITY: f64 = 9.80665;

/// The unit that a text names, whatever its case and blanks.
pub(super) fn unit(text: &str) -> Option<Unit> {
    use Dimension::*;
    let text = text.trim();
    if text.is_empty() || text.len() > 40 {
        return None;
    }
    let plain = plain(text);
    let of = |dimension, factor| Some(Unit { dimension, factor });
    match plain.as_str() {
        "s" | "sec" | "secs" | "second" | "seconds" | "sek" | "sekunde" | "sekunden" | "seg" | "segundo"
        | "segundos" | "seconde" | "secondes" | "secondi" => of(Time, 1.0),
        "ms" | "msec" | "millis" | "millisecond" | "milliseconds" | "millisekunden" | "milisegundos" => {
            of(Time, 1e-3)
        }
        "us" | "µs" | "usec" | "micros" | "microsecond" | "microseconds" | "mikrosekunden" => of(Time, 1e-6),
        "ns" | "nanosecond" | "nanoseconds" => of(Time, 1e-9),
        "min" | "minute" | "minutes" | "minuten" => of(Time, 60.0),
        "h" | "hr" | "hour" | "hours" | "stunden" => of(Time, 3600.0),
        "rad" | "rads" | "radian" | "radians" | "radiant" | "radianti" | "radianes" | "radianos"
        | "radiani" => of(Angle, 1.0),
        "mrad" => of(Angle, 1e-3),
        "deg" | "degs" | "°" | "º" | "degree" | "degrees" | "grad" | "grade" | "gradi" | "grados"
        | "graus" | "degre" | "degres" | "degré" | "degrés" => of(Angle, DEGREE),
        "turn" | "turns" | "rev" | "revs" | "revolutions" => of(Angle, TURN),
        "rad/s" | "rads-1" | "rad*s-1" | "rad_s" | "rad/sec" | "radians/s" | "radian/s" | "radians/sec"
        | "1/s" => of(AngularVelocity, 1.0),
        "deg/s" | "deg/sec" | "°/s" | "º/s" | "deg_s" | "degs-1" | "degrees/s" | "degrees/sec" | "dps"
        | "grad/s" | "graus/s" | "gradi/s" => of(AngularVelocity, DEGREE),
        "rpm" => of(AngularVelocity, TURN / 60.0),
        "rad/s2" | "rad/s/s" | "rads-2" | "rad*s-2" | "rad_s2" | "radians/s2" => of(AngularAcceleration, 1.0),
        "deg/s2" | "°/s2" | "º/s2" | "deg/s/s" | "degs-2" | "deg_s2" | "degrees/s2" => {
            of(AngularAcceleration, DEGREE)
        }
        "m/s2" | "m/s/s" | "ms-2" | "m*s-2" | "m_s2" => of(LinearAcceleration, 1.0),
        "cm/s2" => of(LinearAcceleration, 1e-2),
        "g" => of(LinearAcceleration, GRAVITY),
        "mg" | "milli-g" | "millig" => of(LinearAcceleration, GRAVITY * 1e-3),
        "m" | "meter" | "meters" | "metre" | "metres" | "metri" | "metros" => of(Length, 1.0),
        "cm" => of(Length, 1e-2),
        "mm" => of(Length, 1e-3),
        "in" | "inch" | "inches" => of(Length, 0.0254),
        "ft" => of(Length, 0.3048),
        "px" | "pixel" | "pixels" | "pix" | "au" | "a.u." | "arb.unit" | "arb.units" | "arbitrary"
        | "counts" | "count" | "ticks" | "steps" | "adc" | "raw" | "lsb" => of(Arbitrary, 1.0),
        "m/s" | "cm/s" | "mm/s" | "m_s" | "n" | "mn" | "v" | "mv" | "a" | "hz" | "khz" | "j" | "w" | "nm"
        | "c" | "°c" | "k" | "kg" | "%" | "state" | "lux" | "lx" | "ut" | "µt" | "hpa" | "db" | "px/s"
        | "m/s3" => of(Other, 1.0),
        _ => None,
    }
}

/// Lower case, one way to write powers, products and the micro sign, no blanks.
fn plain(text: &str) -> String {
    let lower = lower(text);
    let joined: String = lower
        .chars()
        .filter(|each| !each.is_whitespace() && !matches!(each, '^' | '{' | '}' | '\u{a0}'))
        .map(|each| match each {
            'μ' => 'µ',
            '²' => '2',
            '³' => '3',
            '⁻' | '−' => '-',
            '¹' => '1',
            '·' | '⋅' => '*',
            _ => each,
        })
        .collect();
    joined.replace("**", "")
}

/// `4000/turn`: counts of an encoder.
pub(super) fn counts_per_turn(text: &str) -> Option<Unit> {
    let (count, word) = text.split_once('/')?;
    let count = decimal::number(count.trim())?;
    let turn = unit(word)? == unit("turn")?;
    (turn && count.is_finite() && count > 0.0)
        .then_some(Unit { dimension: Dimension::Angle, factor: TURN / count })
}

//! Column names: what they say in the languages of the tools, and what a unit, a run or a clock adds to them.

use crate::letters::lower;

/// What a name says a column is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Meaning {
    Time,
    Angle,
    Velocity,
    AngularAcceleration,
    LinearAcceleration,
    X,
    Y,
    Period,
    Transit,
    /// A light gate's state: 1 while dark.
    State,
    /// An uncertainty of another column.
    Uncertainty,
    /// A modulus such as phyphox's `Absolute`: it has no sign.
    Absolute,
    /// A row or frame number.
    Index,
    /// The number or name of a run, a remark.
    Label,
    /// Computed by a tool from a record: an autocorrelation, a spectrum.
    Computed,
    /// A quantity of another kind: a force, a mass, a velocity along the path.
    Other,
}

/// Letters without accents, in lower case; all that is no letter or digit is one blank.
pub(super) fn words(name: &str) -> String {
    let mut words = String::with_capacity(name.len());
    for each in lower(name).chars() {
        let plain = match each {
            'á' | 'à' | 'â' | 'ä' | 'ã' => 'a',
            'é' | 'è' | 'ê' | 'ë' => 'e',
            'í' | 'ì' | 'î' | 'ï' => 'i',
            'ó' | 'ò' | 'ô' | 'ö' | 'õ' => 'o',
            'ú' | 'ù' | 'û' | 'ü' => 'u',
            'ç' => 'c',
            'ñ' => 'n',
            _ => each,
        };
        if plain.is_alphanumeric() {
            words.push(plain);
        } else if !words.ends_with(' ') {
            words.push(' ');
        }
    }
    words.trim().to_owned()
}

/// What a name says; `None` if it says nothing.
pub(super) fn meaning(name: &str) -> Option<Meaning> {
    use Meaning::*;
    let words = words(name);
    let has = |parts: &[&str]| parts.iter().any(|part| words.contains(part));
    let is = |each: &[&str]| each.contains(&words.as_str());
    let word = |each: &[&str]| words.split(' ').any(|part| each.contains(&part));
    if has(&[
        "autocorrelation", "autokorrelation", "time shift", "zeitverschiebung", "rel amplitude", "spectrum",
        "fft",
    ]) || is(&["frequency", "frequenz", "frequenza", "frecuencia"])
    {
        return Some(Computed);
    }
    if has(&["uncert", "unsicherheit", "incert", "error", "fehler", "stdev", "stddev", "sigma"])
        || word(&["err", "std", "sd", "unc"])
        || is(&["dx", "dy", "dt", "dtheta", "delta t", "delta theta", "u t", "u theta", "dθ", "δt", "δθ"])
    {
        return Some(Uncertainty);
    }
    if has(&["absolut", "betrag", "magnitude", "modul"]) || is(&["abs", "norm", "tgf"]) {
        return Some(Absolute);
    }
    if has(&["unnamed", "packet", "frame"])
        || is(&["index", "idx", "n", "i", "step", "sample", "samples", "row", "id", "nr", "no"])
    {
        return Some(Index);
    }
    if has(&["comment", "kommentar", "remark"]) || word(&["run", "serie", "series", "trial", "number"]) {
        return Some(Label);
    }
    if has(&["transit", "dunkel", "dark", "verdunk", "blocked"]) {
        return Some(Transit);
    }
    if has(&["period", "schwingungsdauer"]) || is(&["half swing"]) || name.trim() == "T" {
        return Some(Period);
    }
    if has(&["state", "zustand", "gate"]) {
        return Some(State);
    }
    let angular = has(&["angul", "winkel", "rotation", "gyro", "angol"]);
    if has(&["accel", "beschleunig", "acel", "acceler"])
        || is(&["ax", "ay", "az", "acc x", "acc y", "acc z", "accx", "accy", "accz", "gfx", "gfy", "gfz"])
    {
        return Some(if angular { AngularAcceleration } else { LinearAcceleration });
    }
    // Newton's dots as combining characters.
    if name.contains('\u{307}') {
        return Some(Velocity);
    }
    if name.contains('\u{308}') || is(&["alpha", "α"]) || has(&["ddot", "dot dot"]) {
        return Some(AngularAcceleration);
    }
    if has(&["velocity", "geschwindigkeit", "velocid", "vitesse", "speed"]) {
        return Some(if angular { Velocity } else { Other });
    }
    if has(&["gyro", "omega", "ω", "thetadot", "theta dot", "angvel", "ang vel", "drehrate"])
        || words.starts_with("rotation")
        || is(&["gx", "gy", "gz", "wx", "wy", "wz", "w", "dtheta dt", "theta punkt"])
    {
        return Some(Velocity);
    }
    if has(&[
        "angle", "winkel", "angulo", "angolo", "theta", "θ", "phi", "φ", "ϕ", "pitch", "roll", "ausschlag",
        "displacement angle",
    ]) || is(&[
        "deg", "rad", "degrees", "radians", "ang", "pos", "th", "angular position", "pendpos", "encoder",
    ]) {
        return Some(Angle);
    }
    if has(&[
        "time", "zeit", "tempo", "temps", "tiempo", "millis", "micros", "timestamp", "elapsed", "sekunde",
        "second",
    ]) || is(&["t", "ms", "us", "s", "sec", "tid", "tijd"])
    {
        return Some(Time);
    }
    if is(&[
        "x", "pos x", "x pos", "position x", "x position", "posx", "xpos", "cx", "x coordinate", "coord x",
    ]) {
        return Some(X);
    }
    if is(&[
        "y", "pos y", "y pos", "position y", "y position", "posy", "ypos", "cy", "y coordinate", "coord y",
    ]) {
        return Some(Y);
    }
    if has(&[
        "force", "kraft", "voltage", "spannung", "temperat", "energy", "energie", "mass", "current", "light",
        "pressure",
    ]) || words.starts_with("v ") && is(&["v x", "v y"])
        || is(&["vx", "vy", "v", "r", "ek", "ep", "u"])
    {
        return Some(Other);
    }
    None
}

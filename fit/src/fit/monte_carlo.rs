//! The quoted quantity's distribution by Monte Carlo, after Supplement 1 to the GUM (JCGM 101:2008).

use super::options::{DRAWS, FitOptions};
use super::quote::{DOUBT, ideal, quoted};
use super::random::Stream;
use super::result::Estimate;
use crate::order::ranked;

/// Numbers of one draw: omega0, length, g and four corrections.
const DRAWN: u64 = 7;

/// The interval that holds 95 % of the draws of g, of the length or of omega0; none where no draws are asked for.
///
/// Drawn are omega0 with all its parts, what is given beside it and how much of each correction is true, each normal; the formula is
/// not made linear.
pub(super) fn interval(omega0: Estimate, options: &FitOptions) -> Option<(f64, f64)> {
    if !DRAWS || options.monte_carlo < 40 {
        return None;
    }
    let stream = Stream::new(options.seed ^ 0x4d43);
    let length = match options.length {
        None if !options.parts.is_empty() => super::known::length_of_parts(&options.parts).ok(),
        length => length,
    };
    let mut drawn: Vec<f64> = Vec::with_capacity(options.monte_carlo);
    for draw in 0..options.monte_carlo as u64 {
        let normal = |number: u64| stream.normal(DRAWN * draw + number);
        let value = omega0.value + omega0.u * normal(0);
        let once = |measure: Option<super::measure::Measure>, number: u64| {
            measure.map(|m| super::measure::Measure { value: m.value + m.u * normal(number), u: 0.0 })
        };
        let changed = FitOptions {
            length: once(length, 1),
            gravity: once(options.gravity, 2),
            parts: Vec::new(),
            ..options.clone()
        };
        let quote = quoted(Estimate::new(value, 0.0, 0.0, 0.0), &changed).ok()?;
        let corrected = ideal(&quote.corrections, |row| 1.0 + DOUBT * normal(3 + row as u64));
        let ratio = corrected / ideal(&quote.corrections, |_| 1.0);
        let of_length = quote.length.map(|length| length.value / ratio);
        let found = if changed.length.is_some() { quote.g.map(|g| g.value * ratio) } else { of_length };
        drawn.push(found.unwrap_or(value));
    }
    let count = drawn.len();
    let mut at = |share: f64| ranked(&mut drawn, ((share * count as f64) as usize).min(count - 1));
    Some((at(0.025), at(0.975)))
}

//! Numbers and measured values among what is stated.

use crate::abi::number::number_of;
use crate::lines::refused;
use libration_fit::fit::Measure;

/// A value and its standard uncertainty with a blank between; without one, it is exact.
pub fn measure(name: &str, text: &str) -> Result<Measure, String> {
    let (value, u) = text.split_once(' ').unwrap_or((text, "0"));
    Ok(Measure { value: number(name, value)?, u: number(name, u)? })
}

/// A number.
pub fn number(name: &str, text: &str) -> Result<f64, String> {
    number_of(text).ok_or_else(|| refused(name, text))
}

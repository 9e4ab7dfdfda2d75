//! A quantity that was measured.

use serde::Serialize;

/// A value with its standard uncertainty.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Measure {
    /// The value.
    pub value: f64,
    /// Its standard uncertainty, not negative.
    pub u: f64,
}

//! The one error of a fit.

use core::fmt;

/// Why there is no fit, in one line: what, which value, what is allowed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FitRefusal {
    reason: String,
}

impl FitRefusal {
    pub(crate) fn new(reason: impl Into<String>) -> FitRefusal {
        FitRefusal { reason: reason.into() }
    }
}

impl fmt::Display for FitRefusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.reason)
    }
}

impl core::error::Error for FitRefusal {}

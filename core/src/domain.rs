//! The one error of the constructors: which argument, which value, what is allowed.

use core::fmt;
use std::borrow::Cow;

/// A rejected argument.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Domain {
    /// Name of the argument.
    pub argument: &'static str,
    /// The value as given.
    pub given: String,
    /// What is allowed, to be read after "must be".
    pub allowed: Cow<'static, str>,
}

impl Domain {
    /// The value, where `holds`; otherwise the error that names it.
    pub(crate) fn check(
        argument: &'static str,
        value: f64,
        holds: bool,
        allowed: &'static str,
    ) -> Result<f64, Domain> {
        if holds { Ok(value) } else { Err(Domain::new(argument, format!("{value:?}"), allowed)) }
    }

    /// The error of a value as it was given.
    pub(crate) fn new(
        argument: &'static str,
        given: String,
        allowed: impl Into<Cow<'static, str>>,
    ) -> Domain {
        Domain { argument, given, allowed: allowed.into() }
    }
}

impl fmt::Display for Domain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} = {}: must be {}", self.argument, self.given, self.allowed)
    }
}

impl core::error::Error for Domain {}

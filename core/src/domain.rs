//! The one error of the constructors: which argument, which value, what is allowed.

use crate::lanes::COMPACT;
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
        if holds { Ok(value) } else { Err(Domain::new(argument, shown(value), allowed)) }
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

/// Begins a number in a message that a page is to write out: its bits, in 16 hexadecimal digits, follow.
const NUMBER: char = '\u{1}';

/// A number as it is written in a message. On a page JavaScript writes it: Rust's digits are 18 kB of code.
pub(crate) fn shown(value: f64) -> String {
    if COMPACT { format!("{NUMBER}{:016x}", value.to_bits()) } else { format!("{value:?}") }
}

/// A whole number as it is written in a message, however large.
pub(crate) fn shown_count(count: f64) -> String {
    if count < 1e16 { (count as u64).to_string() } else { shown(count) }
}

impl fmt::Display for Domain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} = {}: must be {}", self.argument, self.given, self.allowed)
    }
}

impl core::error::Error for Domain {}

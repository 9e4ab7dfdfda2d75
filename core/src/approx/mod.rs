//! Approximations of the pendulum by name: of its angle over time, of its period, of the sine of its force.
//!
//! Each kind is a table of entries (entry.rs) that every door lists alike.

pub mod entry;
pub mod period;
mod period_rules;
mod search;
mod swing;

pub use entry::{Entry, Named};
pub use period::{PERIODS, PeriodFormula};

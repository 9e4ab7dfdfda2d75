//! Approximations of the pendulum by name: of its angle over time, of its period, of the sine of its force.
//!
//! Each kind is a table of entries (entry.rs) that every door lists alike.

pub mod entry;
pub mod steps;

pub use entry::{Entry, Named};
pub use steps::Scheme;

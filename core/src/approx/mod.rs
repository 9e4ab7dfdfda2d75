//! Approximations of the pendulum by name: of its angle over time, of its period, of the sine of its force.
//!
//! Each kind is a table of entries (entry.rs) that every binding lists alike.

pub mod angle;
mod angle_columns;
mod angle_entries;
mod angle_oscillator;
mod angle_phase;
mod angle_ranges;
mod angle_series;
#[cfg(feature = "all-formulas")]
mod angle_small;
#[cfg(not(feature = "all-formulas"))]
mod angle_small_absent;
mod angle_taylor;
mod dormand_prince;
pub mod entry;
pub mod measure;
pub mod numerical;
pub mod period;
mod period_formulas;
mod remez;
mod salas;
mod search;
pub mod sine;
#[cfg(feature = "all-formulas")]
mod sine_model;
#[cfg(not(feature = "all-formulas"))]
mod sine_model_absent;
mod steps;
mod turning;

pub use angle::{AngleApproximation, AngleFormula};
pub use angle_entries::ANGLES;
pub use entry::{Entry, Named, Orders};
pub use measure::LargestError;
pub use numerical::{NUMERICALS, NumericalFormula, NumericalSolution};
pub use period::{PERIODS, PeriodFormula};
pub use sine::{SINES, SineError, SineFormula};

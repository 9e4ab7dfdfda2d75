//! Least squares of a pendulum with friction: from columns to omega0, g or length, with a budget of uncertainty.

mod assembly;
mod bootstrap;
mod covariance;
mod curve;
mod dark;
mod data;
mod diagnosis;
mod entry;
mod held;
mod horizon;
mod known;
mod ladder;
mod loss;
mod measure;
mod monte_carlo;
mod one_sided;
mod optimiser;
mod options;
mod problem;
mod quote;
mod random;
mod record;
mod refusal;
mod result;
mod reversible;
mod samples;
mod search;
mod spread;
mod start;
mod swings;
mod tables;
mod together;
mod values;
mod verdicts;
mod window;

pub use data::{Data, Measured};
pub use entry::fit;
pub use known::{CorrectionRow, Corrections, MeasuredPart, length_of_parts};
pub use measure::Measure;
pub use options::{FitOptions, Model, Stop, Told};
pub use random::Stream;
pub use refusal::FitRefusal;
pub use result::{
    BudgetRow, Correlation, Diagnostics, Dropped, Estimate, Fit, FrictionEstimates, Grade, Residuals,
    RungSummary, Verdict,
};
pub use reversible::{Reversible, reversible, reversible_between};
pub use together::{Together, fit_lengths, fit_runs};

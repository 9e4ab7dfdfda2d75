//! Least squares of a pendulum with friction: from columns to omega0, g or length, with a budget of uncertainty.

mod assembly;
mod bootstrap;
mod covariance;
mod curve;
mod data;
mod diagnosis;
mod entry;
mod horizon;
mod ladder;
mod optimiser;
mod options;
mod problem;
mod quote;
mod random;
mod record;
mod refusal;
mod result;
mod spread;
mod start;
mod swings;
mod tables;
mod verdicts;
mod window;

pub use data::{Data, Measured};
pub use entry::fit;
pub use options::{FitOptions, Measure, Model};
pub use refusal::FitRefusal;
pub use result::{
    BudgetRow, Correlation, Diagnostics, Dropped, Estimate, Fit, FrictionEstimates, Grade, Residuals,
    RungSummary, Verdict,
};

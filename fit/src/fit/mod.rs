//! Least squares of a pendulum with friction: from columns to omega0, g or length, with a budget of uncertainty.

mod covariance;
mod data;
mod entry;
mod horizon;
mod ladder;
mod optimiser;
mod options;
mod problem;
mod record;
mod refusal;
mod result;
mod start;
mod swings;
mod window;

pub use data::{Data, Measured};
pub use entry::fit;
pub use options::{FitOptions, Measure, Model};
pub use refusal::FitRefusal;
pub use result::{
    BudgetRow, Correlation, Diagnostics, Dropped, Estimate, Fit, FrictionEstimates, Grade, Residuals,
    RungSummary, Verdict,
};

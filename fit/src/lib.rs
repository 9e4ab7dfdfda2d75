//! From measurements of a pendulum to g with an honest uncertainty.
//!
//! [`fit()`](fit::fit) takes columns of a record and what is known beside it; it gives a [`Fit`](fit::Fit), or a
//! [`FitRefusal`](fit::FitRefusal) of one line.

pub mod fit;

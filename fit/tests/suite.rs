//! All tests of the crate in one program.

mod fit_apparatus;
mod fit_record;
mod fit_verdicts;

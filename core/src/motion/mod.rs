//! What every exact motion shares: its interpolants, and the times of its passages.

pub(crate) mod bounded;
mod chebyshev;
pub(crate) mod escape;
pub(crate) mod interpolant;
pub mod passages;
pub(crate) mod pieces;
pub(crate) mod samples;

//! What the quotient of theta functions that u is is made from.

use super::pq_quotient::Pq;
use super::root_quotient::Squares;
use crate::float::scaled::Scaled;

/// What a quotient is made from.
#[derive(Clone, Debug)]
pub(super) enum QuotientFactors {
    Root(Squares),
    /// The quotient and its amplitude, the parameter and its complement.
    Pq((Pq, Scaled), [Scaled; 2]),
}

impl QuotientFactors {
    /// The parameter and its complement.
    pub fn parameter(&self) -> [Scaled; 2] {
        match self {
            QuotientFactors::Root(squares) => [squares.m, squares.mc],
            QuotientFactors::Pq(_, parameter) => *parameter,
        }
    }
}

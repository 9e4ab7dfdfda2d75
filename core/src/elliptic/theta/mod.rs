//! Theta functions: Jacobi's four, and Neville's, whose quotients are Jacobi's elliptic functions.
//! Source: DLMF chapter 20, Abramowitz & Stegun 16.36.

pub(crate) mod columns;
pub(crate) mod functions;
pub(crate) mod functions_lanes;
pub(crate) mod neville;
pub(crate) mod neville_lanes;

pub use columns::{theta_into, theta_of_nome_into};
pub use functions::{Theta, ThetaFunction};

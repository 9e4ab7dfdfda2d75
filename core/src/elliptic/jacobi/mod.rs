//! Jacobi's elliptic functions of real and complex argument, their inverses, epsilon and zeta. Source: DLMF chapter 22.

pub(crate) mod columns;
pub(crate) mod complex;
pub(crate) mod epsilon_lanes;
pub(crate) mod epsilon_zeta;
pub(crate) mod functions;
pub(crate) mod functions_lanes;
pub(crate) mod glaisher;
pub(crate) mod inverse;
pub(crate) mod inverse_lanes;
pub(crate) mod zeta_lanes;

pub use columns::{glaisher_into, jacobi_epsilon_into, jacobi_into, jacobi_zeta_into};
pub use complex::{Complex, JacobiComplex, JacobiComplexValues};
pub use epsilon_zeta::SecondKind;
pub use functions::{Jacobi, JacobiValues};
pub use glaisher::Glaisher;
pub use inverse::{inverse_jacobi, inverse_jacobi_into};

//! Jacobi's elliptic functions of real and complex argument, their inverses, epsilon and zeta. Source: DLMF chapter 22.

pub mod complex;
pub mod epsilon_zeta;
pub mod functions;
pub mod glaisher;
pub mod inverse;

pub use complex::{Complex, JacobiComplex, JacobiComplexValues};
pub use epsilon_zeta::SecondKind;
pub use functions::{Jacobi, JacobiValues};
pub use glaisher::Glaisher;
pub use inverse::inverse_jacobi;

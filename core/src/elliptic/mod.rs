//! Legendre's integrals and Jacobi's functions of a parameter m carried with its complement mc = 1 - m.

pub mod agm;
pub(crate) mod arc;
pub mod carlson;
pub mod complete;
pub mod complex;
pub mod glaisher;
pub mod heuman;
pub mod incomplete;
pub(crate) mod instants;
pub mod inverse;
pub mod jacobi;
pub(crate) mod lattices;
pub mod nome;
pub mod parameter;
pub mod phase;
pub mod second_kind;
pub mod symmetric;
pub mod theta;
pub mod theta_functions;
pub mod third_kind;

pub use complete::{complete_e, complete_k};
pub use complex::JacobiComplex;
pub use glaisher::Glaisher;
pub use heuman::heuman_lambda;
pub use incomplete::{incomplete_e, incomplete_f};
pub use inverse::inverse_jacobi;
pub use jacobi::Jacobi;
pub use nome::nome;
pub use parameter::Parameter;
pub use second_kind::SecondKind;
pub use symmetric::{carlson_rc, carlson_rd, carlson_rf, carlson_rj};
pub use theta_functions::Theta;
pub use third_kind::{complete_pi, incomplete_pi};

//! Legendre's integrals and Jacobi's functions of a parameter m carried with its complement mc = 1 - m.

pub mod agm;
pub mod carlson;
pub mod complete;
pub mod glaisher;
pub mod incomplete;
pub mod jacobi;
pub(crate) mod lattices;
pub mod nome;
pub mod parameter;
pub mod phase;
pub mod symmetric;
pub mod theta;

pub use complete::{complete_e, complete_k};
pub use glaisher::Glaisher;
pub use incomplete::{incomplete_e, incomplete_f};
pub use jacobi::Jacobi;
pub use nome::nome;
pub use parameter::Parameter;
pub use symmetric::{carlson_rc, carlson_rd, carlson_rf, carlson_rj};

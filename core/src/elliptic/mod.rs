//! Legendre's integrals and Jacobi's functions of a parameter m carried with its complement mc = 1 - m.
//!
//! By chapter of the DLMF: integrals/ (19), theta/ (20), jacobi/ (22).

pub(crate) mod agm;
pub(crate) mod amplitude;
pub(crate) mod given;
pub(crate) mod integrals;
pub(crate) mod jacobi;
pub(crate) mod nome;
pub(crate) mod nome_lanes;
pub(crate) mod parameter;
pub(crate) mod parameter_lanes;
pub(crate) mod phase;
#[cfg(test)]
mod row_tests;
pub(crate) mod rows;
pub(crate) mod theta;

pub use given::Given;
pub use integrals::{
    carlson_rc, carlson_rc_into, carlson_rd, carlson_rd_into, carlson_rf, carlson_rf_into, carlson_rj,
    carlson_rj_into, complete_e, complete_e_into, complete_k, complete_k_into, complete_pi, complete_pi_into,
    heuman_lambda, heuman_lambda_into, incomplete_e, incomplete_e_into, incomplete_f, incomplete_f_into,
    incomplete_pi, incomplete_pi_into,
};
pub use jacobi::{
    Complex, Glaisher, Jacobi, JacobiComplex, JacobiComplexValues, JacobiValues, SecondKind, glaisher_into,
    inverse_jacobi, inverse_jacobi_into, jacobi_epsilon_into, jacobi_into, jacobi_zeta_into,
};
pub use nome::{nome, nome_into, parameter_of_nome};
pub use parameter::Parameter;
pub use theta::{Theta, ThetaFunction, theta_into, theta_of_nome_into};

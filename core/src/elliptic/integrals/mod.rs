//! Elliptic integrals: Carlson's symmetric ones, Legendre's complete and incomplete ones. Source: DLMF chapter 19.

pub(crate) mod carlson;
pub(crate) mod carlson_duplication;
pub(crate) mod carlson_lanes;
pub(crate) mod complete;
pub(crate) mod complete_lanes;
pub(crate) mod duplication_lanes;
pub(crate) mod heuman_lambda;
pub(crate) mod incomplete;
pub(crate) mod incomplete_lanes;
pub(crate) mod rc_lanes;
pub(crate) mod rj_lanes;
pub(crate) mod series_lanes;
pub(crate) mod third_kind;

pub use carlson::{
    carlson_rc, carlson_rc_into, carlson_rd, carlson_rd_into, carlson_rf, carlson_rf_into, carlson_rj,
    carlson_rj_into,
};
pub use complete::{complete_e, complete_e_into, complete_k, complete_k_into};
pub use heuman_lambda::heuman_lambda;
pub use incomplete::{incomplete_e, incomplete_e_into, incomplete_f, incomplete_f_into};
pub use third_kind::{complete_pi, incomplete_pi};

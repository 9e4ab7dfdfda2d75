//! Elliptic integrals: Carlson's symmetric ones, Legendre's complete and incomplete ones. Source: DLMF chapter 19.

pub(crate) mod carlson;
pub(crate) mod carlson_duplication;
pub(crate) mod complete;
pub(crate) mod complete_lanes;
pub(crate) mod short_duplication;
pub(crate) mod heuman_lambda;
pub(crate) mod incomplete;
pub(crate) mod third_kind;

pub use carlson::{carlson_rc, carlson_rd, carlson_rf, carlson_rj};
pub use complete::{complete_e, complete_e_into, complete_k, complete_k_into};
pub use heuman_lambda::heuman_lambda;
pub use incomplete::{incomplete_e, incomplete_f};
pub use third_kind::{complete_pi, incomplete_pi};

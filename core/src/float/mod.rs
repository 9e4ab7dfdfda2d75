//! Arithmetic beyond one double, and the only way to sine, cosine, exponential, arctangent.

pub mod angle_reduction;
pub(crate) mod constants;
pub mod double_double;
pub(crate) mod dyadic;
pub mod elementary;
pub mod exponent;
pub mod exponential;
pub mod logarithm;
pub mod scaled;
pub mod series;
pub mod triple_double;
pub(crate) mod unnormalised;

pub use constants::{HALF_PI, LN_2, PI, TWO_PI, TWO_PI_LONG};
pub use double_double::Dd;
pub use scaled::Scaled;
pub use triple_double::Td;

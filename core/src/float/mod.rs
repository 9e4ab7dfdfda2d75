//! Arithmetic beyond one double, and the only door to sine, cosine, exponential, arctangent.

pub mod angle_reduction;
pub mod double_double;
pub(crate) mod dyadic;
pub mod elementary;
pub mod exponent;
pub mod exponential;
pub mod scaled;
pub mod series;
pub mod triple_double;
pub(crate) mod unnormalised;

pub use double_double::Dd;
pub use scaled::Scaled;
pub use triple_double::Td;

/// pi to a double-double.
pub const PI: Dd = TWO_PI.half();
/// 2 pi.
pub const TWO_PI: Dd = Dd::new(TWO_PI_LONG.hi, TWO_PI_LONG.mid);
/// pi / 2.
pub const HALF_PI: Dd = PI.half();
/// 2 pi to a triple-double.
pub const TWO_PI_LONG: Td = Td::new(6.283185307179586, 2.4492935982947064e-16, -5.989539619436679e-33);
/// ln 2 to a triple-double.
pub const LN_2: Td = Td::new(0.6931471805599453, 2.3190468138462996e-17, 5.707708438416212e-34);

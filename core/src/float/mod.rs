//! Arithmetic beyond one double, and the only door to sine, cosine, exponential, arctangent.

pub mod circle;
pub mod double_double;
pub mod elementary;
pub mod scaling;
pub mod triple_double;

pub use double_double::Dd;
pub use triple_double::Td;

/// pi, its double and its multiples, to the digits that double-double holds.
pub const PI: Dd = Dd::new(core::f64::consts::PI, 1.2246467991473532e-16);
/// 2 pi.
pub const TWO_PI: Dd = Dd::new(2.0 * core::f64::consts::PI, 2.4492935982947064e-16);
/// pi / 2.
pub const HALF_PI: Dd = Dd::new(core::f64::consts::FRAC_PI_2, 6.123233995736766e-17);

//! pi and ln 2 beyond double.

use super::double_double::Dd;
use super::triple_double::Td;

/// pi to a double-double.
pub const PI: Dd = TWO_PI.half();
/// 2 pi.
pub const TWO_PI: Dd = Dd::new(TWO_PI_LONG.hi, TWO_PI_LONG.mid);
/// pi / 2.
pub const HALF_PI: Dd = PI.half();
/// 2/pi.
pub const TWO_OVER_PI: Dd = Dd::new(0.6366197723675814, -3.935735335036497e-17);
/// 2 pi to a triple-double.
pub const TWO_PI_LONG: Td = Td::new(6.283185307179586, 2.4492935982947064e-16, -5.989539619436679e-33);
/// ln 2 to a triple-double.
pub const LN_2: Td = Td::new(0.6931471805599453, 2.3190468138462996e-17, 5.707708438416212e-34);
/// 1/ln 2.
pub const INVERSE_LN_2: f64 = 1.4426950408889634;

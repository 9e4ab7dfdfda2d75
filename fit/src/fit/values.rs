//! The numbers that a fit may vary, by place.

/// What a fit may vary, the first seven in the order of the core's derivatives; presliding as the logarithm above its least value.
pub(super) const NAMES: [&str; 9] =
    ["theta", "velocity", "omega2", "linear", "quadratic", "dry", "ln presliding", "offset", "scale"];
pub(super) const THETA: usize = 0;
pub(super) const VELOCITY: usize = 1;
pub(super) const OMEGA2: usize = 2;
pub(super) const LINEAR: usize = 3;
pub(super) const QUADRATIC: usize = 4;
pub(super) const DRY: usize = 5;
pub(super) const PRESLIDING: usize = 6;
pub(super) const OFFSET: usize = 7;
pub(super) const SCALE: usize = 8;

pub(super) type Values = [f64; NAMES.len()];

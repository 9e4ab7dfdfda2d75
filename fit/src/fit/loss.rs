//! What a residual costs: its square, or less where it is an outlier.

/// What a residual costs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Loss {
    /// Its square.
    Squares,
    /// 2 f^2 (sqrt(1 + r^2/f^2) - 1): a square below f, linear above.
    Soft(f64),
}

/// The number whose square is the soft loss, and its derivative.
pub(super) fn soft(z: f64) -> (f64, f64) {
    let root = libm::hypot(z, 1.0);
    // 2 (root - 1) = 2 z^2/(root + 1), without cancellation.
    let reduced = z * (2.0 / (root + 1.0)).sqrt();
    let slope = if reduced == 0.0 { 1.0 } else { z / (root * reduced) };
    (reduced, slope)
}

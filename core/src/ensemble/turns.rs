//! Whole turns of angles, taken out and counted.

use crate::float::TWO_PI;
use core::f64::consts::PI;

/// Angles beyond this have no whole turn to count.
const FARTHEST: f64 = 4_503_599_627_370_496.0;

/// Angles looked at together.
const GROUP: usize = 16;

/// Takes whole turns from angles, which then are in [-pi, pi], and adds them to `turns`; what is beyond 2^52 rad or not finite is NaN,
/// without a turn. The double nearest to pi is below pi, so that the angles are in [-pi, pi). Panics where the lengths differ.
///
/// ```
/// let (mut theta, mut turns) = ([1.0, 7.0, -10.0], [0, 0, 5]);
/// libration::ensemble::wrap_into(&mut theta, &mut turns);
/// assert_eq!(format!("{:.6} {:.6} {turns:?}", theta[1], theta[2]), "0.716815 2.566371 [0, 1, 3]");
/// ```
pub fn wrap_into(theta: &mut [f64], turns: &mut [i64]) {
    assert!(theta.len() == turns.len(), "columns of different lengths");
    for (angles, counts) in theta.chunks_mut(GROUP).zip(turns.chunks_mut(GROUP)) {
        // Without a way out, so that it takes several at a time.
        let near = angles.iter().fold(true, |near, angle| near & (angle.abs() <= PI));
        if !near {
            angles.iter_mut().zip(counts).for_each(|(angle, count)| *count += wrapped(angle));
        }
    }
}

/// The turns of one angle, which are taken from it.
fn wrapped(angle: &mut f64) -> i64 {
    if angle.abs() <= PI {
        return 0;
    }
    // Every comparison is false for NaN.
    let near = angle.abs() < FARTHEST;
    if !near {
        *angle = f64::NAN;
        return 0;
    }
    let whole = (*angle / TWO_PI.hi + 0.5).floor();
    // Both products are rounded by less than a rounding of the angle itself.
    let rest = (*angle - whole * TWO_PI.hi) - whole * TWO_PI.lo;
    // The quotient is rounded, so that the rest may be a rounding past an end.
    let over = f64::from(i8::from(rest > PI) - i8::from(rest < -PI));
    *angle = rest - over * TWO_PI.hi;
    (whole + over) as i64
}

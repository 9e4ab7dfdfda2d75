//! Sine and cosine of a double-double angle of any size, to double-double.

use crate::float::series::sin_cos;
use crate::float::{Dd, TWO_PI, TWO_PI_LONG, Td, angle_reduction};

/// Sine and cosine of a double, of any size.
pub(super) fn of_double(angle: f64) -> (Dd, Dd) {
    let reduced = angle_reduction::reduce(angle);
    of_half_turn(reduced.from_bottom * reduced.side)
}

/// Sine and cosine of hi + lo, with an absolute error of 2^-100 and 2^-106 of the angle.
pub(super) fn circular(angle: Dd) -> (Dd, Dd) {
    if angle.lo == 0.0 || angle.hi.abs() > 1e15 {
        return of_double(angle.value());
    }
    let turns = (angle.hi / TWO_PI.hi).round();
    of_half_turn(Td::from(angle) - TWO_PI_LONG * turns)
}

/// Sine and cosine of an angle in [-pi, pi] (a little beyond does no harm).
fn of_half_turn(angle: Td) -> (Dd, Dd) {
    use core::f64::consts::FRAC_PI_4;
    let side = if angle.hi < 0.0 { -1.0 } else { 1.0 };
    let size = angle * side;
    // series::sin_cos serves [0, pi/4]: the sign of a rest that leaves it downward is taken out.
    let of_rest = |rest: Td| {
        let (sine, cosine) = sin_cos(rest.abs());
        (sine.to_dd().scale(if rest.hi < 0.0 { -1.0 } else { 1.0 }), cosine.to_dd())
    };
    let (sine, cosine) = if size.hi <= FRAC_PI_4 {
        of_rest(size)
    } else if size.hi <= 3.0 * FRAC_PI_4 {
        let (cosine, sine) = of_rest(TWO_PI_LONG.scale(0.25) - size);
        (sine, cosine)
    } else {
        let (sine, cosine) = of_rest(TWO_PI_LONG.scale(0.5) - size);
        (sine, -cosine)
    };
    (sine.scale(side), cosine)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_keep_the_addition_theorem() {
        for i in -400..400 {
            let (a, b) = (Dd::new(f64::from(i) * 0.0371, 1e-18), Dd::new(f64::from(i * i) * 0.113, -3e-17));
            let ((sin_a, cos_a), (sin_b, cos_b)) = (circular(a), circular(b));
            let (sine, cosine) = circular(a + b);
            let slack = 1e-28 * (1.0 + b.hi);
            assert!((sine - (sin_a * cos_b + cos_a * sin_b)).hi.abs() < slack, "{i}");
            assert!((cosine - (cos_a * cos_b - sin_a * sin_b)).hi.abs() < slack, "{i}");
        }
    }
}

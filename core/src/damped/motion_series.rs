//! The Taylor coefficients of a motion that its derivatives are multiplied by, again from those of the angle: in double, and as far as
//! the columns of variational.rs go. The recurrences are those of jet.rs.

use super::segment::Segment;
use super::taylor::{INVERSE, places};
use crate::lanes::Lane;

/// Highest power of time in the columns. They have the singularities of the motion, a derivative by whose place brings a factor k to
/// the coefficient k: with a step of 0.21 of the radius what is left out is below 28 0.21^28/0.79 = 2^-58 of a column.
pub(super) const LAST: usize = 27;

/// Coefficients of the motion as far as those of the columns go.
pub(super) type Short = [f64; LAST + 1];

/// The series of the motion that the columns are multiplied by.
pub(super) struct MotionSeries {
    pub v: Short,
    pub s: Short,
    pub c: Short,
    pub u: Short,
    /// v^2, u v.
    pub square: Short,
    pub slipping: Short,
}

impl MotionSeries {
    #[inline(always)]
    pub fn new<L: Lane, const N: usize>(segment: &Segment, slip: f64) -> MotionSeries {
        let none = [0.0; LAST + 1];
        let mut motion = MotionSeries { v: none, s: none, c: none, u: none, square: none, slipping: none };
        for (k, (v, slope)) in motion.v.iter_mut().zip(&segment.slopes).enumerate() {
            *v = slope * (k + 1) as f64;
        }
        (motion.s[0], motion.c[0], motion.u[0]) = (segment.sine, segment.cosine, segment.slip);
        let mut factors = [L::splat(0.0); LAST + 1];
        let mut begun = L::splat(0.0);
        let mut k = 0;
        while k < LAST {
            factors[k] = L::load(&[motion.c[k], -motion.s[k], motion.u[k], motion.v[k]]);
            // Two orders in one pass, as in `products`.
            let mut sum = factors[k].mul_add(L::splat(motion.v[0]), begun);
            if k.is_multiple_of(2) {
                (sum, begun) = (L::splat(0.0), L::splat(0.0));
                let series = motion.v[..=k].iter().rev().zip(motion.v[1..=k + 1].iter().rev());
                for ((v, after), factor) in series.zip(&factors[..=k]) {
                    sum = factor.mul_add(L::splat(*v), sum);
                    begun = factor.mul_add(L::splat(*after), begun);
                }
            }
            let inverse = INVERSE[k + 1].hi;
            let [sine, cosine, slipping, square] = places(sum);
            (motion.s[k + 1], motion.c[k + 1]) = (sine * inverse, cosine * inverse);
            if N > 1 {
                motion.u[k + 1] = -(slip * slipping * inverse);
                (motion.slipping[k], motion.square[k]) = (slipping, square);
            }
            k += 1;
        }
        motion
    }
}

//! Gauss's arithmetic-geometric mean in double-double, and with it K = pi / (2 agm(1, k')).
//!
//! Source: DLMF 19.8.1, 19.8.5. Converges quadratically for any k' > 0; no cancellation.

use crate::float::elementary::horner;
use crate::float::unnormalised::Unnormalised;
use crate::float::{Dd, HALF_PI};
use crate::lanes::Lane;

/// Most steps of [`agm`]. A step makes b/a at least its square root, so that 11 bring 2^-1074 above 1/2; from there the
/// distance 1 - b/a is squared, and 5 more leave it below 2^-52.
const STEPS: usize = 16;

/// agm(1, b) for 0 < b <= 1.
pub fn agm(b: Dd) -> Dd {
    // The mean of 1 and 0 would only halve.
    if b.hi == 0.0 {
        return Dd::ZERO;
    }
    let (mut a, mut b) = (Dd::ONE, b);
    for _ in 0..STEPS {
        let apart = (a.hi - b.hi).abs() > 2e-16 * a.hi;
        // After one more step the two means differ by (a - b)^2 / 8a, below 2^-108 of a: the mean is the limit. A NaN is
        // not apart.
        if !apart {
            break;
        }
        (a, b) = ((a + b).scale(0.5), (a * b).sqrt());
    }
    (a + b).scale(0.5)
}

/// The arithmetic-geometric mean of 1 and b over lanes, for b^2 in [1/2, 1], and what else its first steps give.
pub(crate) struct NearMean<L: Lane> {
    pub b: Unnormalised<L>,
    /// sqrt b.
    pub root: Unnormalised<L>,
    pub mean: Unnormalised<L>,
    /// From which the nome of 1 - b^2 follows.
    pub lambda: Unnormalised<L>,
    /// The inverse of another number to a few roundings.
    pub inverse: L,
}

impl<L: Lane> NearMean<L> {
    /// From b^2 and 1 - b^2; and the inverse of another number, by the same division.
    ///
    /// With t = (1 - sqrt b)/(1 + sqrt b) = 2 lambda, the means after two steps are (1 + sqrt b)^2/4 times 1 +- t^2.
    #[inline(always)]
    pub fn new(square: Unnormalised<L>, one_minus_square: Unnormalised<L>, other: L) -> Self {
        let (one, half, quarter) = (L::splat(1.0), L::splat(0.5), L::splat(0.25));
        let b = square.hi.sqrt();
        let root = b.sqrt();
        let sum = one + root;
        let divisor = (one + b) * (sum * sum);
        let product = root * divisor;
        let all = one / (product * other);
        let (inverse, both) = (all * product, all * other);
        let (of_root, of_divisor) = (both * divisor, both * root);
        let half_of_root = half * of_root;
        let b = square.near_root(b, half_of_root * of_root);
        let root = b.near_root(root, half_of_root);
        let one = Unnormalised::from_double(one);
        let square = one.plus_smaller(root).square();
        let t = one_minus_square.over_by(one.plus_smaller(b) * square, of_divisor);
        let mean = square.scale(quarter) * agm_of_pair(t.square());
        NearMean { b, root, mean, lambda: t.scale(half), inverse }
    }
}

/// agm(1 + x, 1 - x) for |x| <= 0.02, to 2^-100.
#[inline(always)]
fn agm_of_pair<L: Lane>(x: Unnormalised<L>) -> Unnormalised<L> {
    let square = x.square();
    let exact = |numerator: f64, power: f64| Unnormalised::from_double(L::splat(numerator / power));
    let tail = horner(&[11.0 / 256.0, 469.0 / 16384.0, 1379.0 / 65536.0, 17223.0 / 1_048_576.0], square.hi);
    let inner = exact(5.0, 64.0).plus_smaller(square * Unnormalised::from_double(tail));
    let outer = exact(1.0, 4.0).plus_smaller(square * inner);
    exact(1.0, 1.0).minus_smaller(square * outer)
}

/// K from the complementary modulus k' in (0, 1].
pub fn quarter_period(kc: Dd) -> Dd {
    HALF_PI / agm(kc)
}

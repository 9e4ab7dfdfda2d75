//! Means of angle and velocity, and the sums of products of what is left, over some particles.
//!
//! Eight sums side by side, added in one order: the same bits on every instruction set. Two passes, so that a large mean takes no digit
//! from a variance. Source: Chan, Golub & LeVeque, Am. Stat. 37 (1983), 242.

/// Sums side by side.
const SIDE: usize = 8;

/// Of some particles: means of angle and velocity, and the sums over (angle, angle), (angle, velocity) and (velocity, velocity) of
/// products of what these leave.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moments {
    /// Means.
    pub mean: [f64; 2],
    /// Sums of products.
    pub products: [f64; 3],
}

/// The moments of angles and velocities, or `None` where one of them is not finite; of nothing, zeros. Panics where the lengths differ.
///
/// ```
/// let found = libration::ensemble::moments(&[1.0, 2.0, 6.0], &[0.0, 0.0, 3.0]).unwrap();
/// assert_eq!((found.mean, found.products), ([3.0, 1.0], [14.0, 9.0, 6.0]));
/// ```
#[must_use]
pub fn moments(theta: &[f64], velocity: &[f64]) -> Option<Moments> {
    assert!(theta.len() == velocity.len(), "columns of different lengths");
    // A product with 0 is NaN for what is not finite, and so is a sum with that.
    let [bad] = summed(theta, velocity, |a, b| [a * 0.0 + b * 0.0]);
    if bad.is_nan() {
        return None;
    }
    let many = theta.len().max(1) as f64;
    let mean = summed(theta, velocity, |a, b| [a, b]).map(|sum| sum / many);
    let products = summed(theta, velocity, |a, b| {
        let (a, b) = (a - mean[0], b - mean[1]);
        [a * a, a * b, b * b]
    });
    Some(Moments { mean, products })
}

/// Sums over all particles, by eights.
#[inline(always)]
#[allow(clippy::needless_range_loop)] // by places, so that it takes several at a time
fn summed<const N: usize>(a: &[f64], b: &[f64], terms: impl Fn(f64, f64) -> [f64; N]) -> [f64; N] {
    let mut sums = [[0.0; SIDE]; N];
    let (mut first, mut second) = (a.chunks_exact(SIDE), b.chunks_exact(SIDE));
    for (a, b) in (&mut first).zip(&mut second) {
        for i in 0..SIDE {
            let terms = terms(a[i], b[i]);
            for n in 0..N {
                sums[n][i] += terms[n];
            }
        }
    }
    for (i, (a, b)) in first.remainder().iter().zip(second.remainder()).enumerate() {
        for (sum, term) in sums.iter_mut().zip(terms(*a, *b)) {
            sum[i] += term;
        }
    }
    sums.map(|[a, b, c, d, e, f, g, h]| ((a + b) + (c + d)) + ((e + f) + (g + h)))
}

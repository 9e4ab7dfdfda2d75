//! Numbers of an exponential density, up to an end, from uniform ones: the actions of a Gaussian bunch.

use crate::float::logarithm::ln;
use crate::lanes::{Columns, Evaluation, Formula, Lane};

/// -ln(1 + lost u) of every u.
struct Inverse {
    lost: f64,
}

impl Formula<1, 1> for Inverse {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [u]: [L; 1]) -> [L; 1] {
        let one = L::splat(1.0);
        let x = L::splat(self.lost) * u;
        let y = one + x;
        // ln(y + rest) = ln y + rest/y: a small number keeps its digits.
        let rest = x - (y - one);
        [-(ln(y) + rest / y)]
    }
}

/// x with 1 - e^-x = u (1 - e^-X), for u in (0, 1) and lost = e^-X - 1, in [-1, 0): what a part u of the density e^-x on [0, X] is
/// below. Panics where the lengths differ.
///
/// ```
/// let mut x = [0.0; 2];
/// libration::ensemble::exponential_into(&[0.5, 1e-9], -1.0, &mut x);
/// assert_eq!(format!("{:.6} {:.6e}", x[0], x[1]), "0.693147 1.000000e-9");
/// ```
pub fn exponential_into(u: &[f64], lost: f64, x: &mut [f64]) {
    Columns::new([u], [x]).of(&Inverse { lost });
}

//! Where the poles of a bounded motion with even powers are, and from where its polynomials are counted.
//!
//! u is infinite where wp - e1 = -R, the weight of the mean (mean.rs). With three real roots these points are above a turning point, or on
//! the line i K'; with a complex pair there are some above each turning point. Two digits of their places are enough.
//! Source: as singularities.rs; DLMF 19.25(v), 23.6.

use crate::elliptic::carlson_rf;
use crate::elliptic::theta::neville::NevilleTheta;
use crate::motion::interpolant::Interpolant;

/// Where the motion is counted from, and what is removed.
#[derive(Clone, Copy, Debug)]
pub(super) struct EvenBounded {
    /// Whether the origin is the base of the mean, not its other end.
    pub at_base: bool,
    /// a^2 of the pole above the origin.
    pub pole: Option<f64>,
    /// Of the singularities that are left, the nearest two.
    pub left: [[f64; 2]; 2],
}

impl EvenBounded {
    /// Of the weight over the square of the rate.
    pub fn new(ratio: f64, mc: f64, three: bool, neville: &NevilleTheta) -> EvenBounded {
        let (k, aspect) = (neville.quarter.hi, neville.aspect);
        if !three {
            // cn of twice the argument is (r + 1)/(r - 1): 1/cn(v | mc) above the base for r > 1, above the other end else.
            let cosine = ((ratio - 1.0) / (ratio + 1.0)).abs();
            let square = 1.0 - cosine * cosine;
            let v = square.sqrt() * carlson_rf(cosine * cosine, 1.0 - mc * square, 1.0);
            let height = v / (4.0 * k);
            let left = [[0.5, 0.5 * aspect - height], [0.0, aspect - height]];
            return EvenBounded { at_base: ratio > 1.0, pole: Some(height * height), left };
        }
        let above = |r: f64| carlson_rf(r, r - mc, r - 1.0) / (2.0 * k);
        if ratio > 1.0 || ratio < mc {
            let height = above(if ratio > 1.0 { ratio } else { mc / ratio });
            let left = [[0.0, aspect - height], [0.5, aspect]];
            return EvenBounded { at_base: ratio > 1.0, pole: Some(height * height), left };
        }
        // At a distance from the base along the line i K'.
        let z = ((1.0 - mc) / (1.0 - ratio)).max(1.0);
        let part = if z.is_finite() { carlson_rf(z - 1.0, z - 1.0 + mc, z) / (2.0 * k) } else { 0.0 };
        let at_base = part > 0.25;
        let far = if at_base { part } else { 0.5 - part };
        EvenBounded { at_base, pole: None, left: [[far, 0.5 * aspect]; 2] }
    }
}

/// The polynomials of a motion.
#[derive(Clone, Debug)]
pub(super) struct EvenPolynomials {
    pub bounded: EvenBounded,
    pub interpolant: Interpolant,
}

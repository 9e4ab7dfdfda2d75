//! Carlson's symmetric integrals R_F, R_D, R_C and R_J in double-double, for arguments >= 0, at most one of them 0
//! (not the last of R_D, R_C and R_J).
//!
//! Method: duplication until the arguments agree to 2^-14, then the series in their elementary symmetric
//! functions. All terms are positive. Squares and cubes of the arguments must stay in range; carlson.rs takes any arguments.
//! Source: DLMF 19.26.18, 19.26.22, 19.36.1, 19.36.2; Carlson, Numer. Algorithms 10 (1995) 13.

use crate::elliptic::agm::quarter_period;
use crate::float::Dd;

/// The next term of the series is of eighth order: 2^-112.
const CLOSE: f64 = 6.1e-5;

/// Most duplications. A step leaves of d powers of two between the arguments at most d/2 + 2 (carlson.rs has the proof), so
/// that 12 bring 2200 powers below 5, and from there 9 steps, each of which divides the spread by 4, make them close.
/// A NaN never is.
const STEPS: usize = 24;

/// The same of R_J, whose p may lie 2^110 above x, y and z and comes nearer by a factor of 4 a step.
const STEPS_OF_RJ: usize = 55 + STEPS;

pub(crate) const THIRD: Dd = Dd::new(0.3333333333333333, 1.850371707708594e-17);
const FIFTH: Dd = Dd::new(0.2, -1.1102230246251566e-17);
const TENTH: Dd = Dd::new(0.1, -5.551115123125783e-18);
const FOURTEENTH: Dd = Dd::new(0.07142857142857142, 3.965082230804129e-18);
const SIXTH: Dd = Dd::new(0.16666666666666666, 9.25185853854297e-18);

/// Largest distance from the mean.
fn spread(mean: Dd, x: Dd, y: Dd, z: Dd) -> f64 {
    let from = |value: Dd| (mean.hi - value.hi).abs();
    from(x).max(from(y)).max(from(z))
}

/// R_F(x, y, z) = 1/2 int_0^inf dt / sqrt((t + x)(t + y)(t + z)).
pub fn rf(x: Dd, y: Dd, z: Dd) -> Dd {
    if x.hi + y.hi == 0.0 || y.hi + z.hi == 0.0 || z.hi + x.hi == 0.0 {
        return Dd::from(f64::INFINITY);
    }
    let (mut x, mut y, mut z) = (x, y, z);
    for _ in 0..STEPS {
        let mean = (x + y + z) * THIRD;
        let spread = spread(mean, x, y, z);
        if spread < CLOSE * mean.hi {
            let dx = (mean - x) / mean;
            let dy = (mean - y) / mean;
            let dz = -(dx + dy);
            let e2 = dx * dy - dz * dz;
            let e3 = dx * dy * dz;
            let (s, c) = (e2.hi, e3.hi);
            let small = s * s / 24.0 - 3.0 / 44.0 * s * c - 5.0 / 208.0 * s * s * s
                + 3.0 / 104.0 * c * c
                + s * s * c / 16.0;
            let series = Dd::ONE - e2 * TENTH + e3 * FOURTEENTH + Dd::from(small);
            return series / mean.sqrt();
        }
        if spread.is_nan() {
            break;
        }
        let (rx, ry, rz) = (x.sqrt(), y.sqrt(), z.sqrt());
        let shift = rx * (ry + rz) + ry * rz;
        x = (x + shift).scale(0.25);
        y = (y + shift).scale(0.25);
        z = (z + shift).scale(0.25);
    }
    Dd::from(f64::NAN)
}

/// R_F(x^2, y^2, 1) from the roots, whose squares may be below the range: one duplication by hand, or, where
/// both are tiny, ln(4/(x + y)) as a complete integral (DLMF 19.27.1).
pub fn rf_of_roots(x: Dd, y: Dd) -> Dd {
    let sum = x + y;
    if sum.hi < 1e-100 {
        return quarter_period(sum);
    }
    let shift = x * (y + Dd::ONE) + y;
    let next = |root: Dd| (root.square() + shift).scale(0.25);
    rf(next(x), next(y), next(Dd::ONE))
}

/// The series of R_J, and of R_D as its case of two equal arguments, in the elementary symmetric functions.
fn series_of_five(e2: Dd, e3: Dd, e4: f64, e5: f64) -> Dd {
    let (s, c) = (e2.hi, e3.hi);
    let small = 9.0 / 88.0 * s * s - 3.0 / 22.0 * e4 - 9.0 / 52.0 * s * c + 3.0 / 26.0 * e5
        - s * s * s / 16.0
        + 3.0 / 40.0 * c * c
        + 3.0 / 20.0 * s * e4
        + 45.0 / 272.0 * s * s * c
        - 9.0 / 68.0 * (c * e4 + s * e5);
    Dd::ONE - e2 * 3.0 * FOURTEENTH + e3 * SIXTH + Dd::from(small)
}

/// R_D(x, y, z) = 3/2 int_0^inf dt / ((t + z) sqrt((t + x)(t + y)(t + z))).
pub fn rd(x: Dd, y: Dd, z: Dd) -> Dd {
    if x.hi + y.hi == 0.0 || z.hi == 0.0 {
        return Dd::from(f64::INFINITY);
    }
    let (mut x, mut y, mut z) = (x, y, z);
    let mut sum = Dd::ZERO;
    let mut power = 1.0;
    for _ in 0..STEPS {
        let mean = (x + y + z * 3.0) * FIFTH;
        let spread = spread(mean, x, y, z);
        if spread < CLOSE * mean.hi {
            let dx = (mean - x) / mean;
            let dy = (mean - y) / mean;
            let dz = -(dx + dy) * THIRD;
            let xy = dx * dy;
            let zz = dz * dz;
            let e2 = xy - zz * 6.0;
            let e3 = (xy * 3.0 - zz * 8.0) * dz;
            let e4 = (xy - zz).hi * 3.0 * zz.hi;
            let e5 = xy.hi * zz.hi * dz.hi;
            let series = series_of_five(e2, e3, e4, e5);
            return sum * 3.0 + series.scale(power) / (mean * mean.sqrt());
        }
        if spread.is_nan() {
            break;
        }
        let (rx, ry, rz) = (x.sqrt(), y.sqrt(), z.sqrt());
        let shift = rx * (ry + rz) + ry * rz;
        sum = sum + Dd::from(power) / (rz * (z + shift));
        power *= 0.25;
        x = (x + shift).scale(0.25);
        y = (y + shift).scale(0.25);
        z = (z + shift).scale(0.25);
    }
    Dd::from(f64::NAN)
}

/// R_C(x, y) = R_F(x, y, y), y > 0.
pub fn rc(x: Dd, y: Dd) -> Dd {
    let (mut x, mut y) = (x, y);
    for _ in 0..STEPS {
        let mean = (x + y.scale(2.0)) * THIRD;
        let apart = y - mean;
        if apart.hi.abs() < CLOSE * mean.hi {
            let s = apart / mean;
            let square = s.square();
            let e = s.hi;
            let small =
                e * e * e * e * (3.0 / 8.0 + e * (9.0 / 22.0 + e * (159.0 / 208.0 + e * (9.0 / 8.0))));
            let inner = TENTH * 3.0 + s * FOURTEENTH.scale(2.0);
            return (Dd::ONE + (square * inner + Dd::from(small))) / mean.sqrt();
        }
        if !mean.hi.is_finite() || mean.hi <= 0.0 {
            break;
        }
        let shift = (x.sqrt() * y.sqrt()).scale(2.0) + y;
        x = (x + shift).scale(0.25);
        y = (y + shift).scale(0.25);
    }
    Dd::from(f64::NAN)
}

/// R_J(x, y, z, p) = 3/2 int_0^inf dt / ((t + p) sqrt((t + x)(t + y)(t + z))), p > 0.
///
/// R_J(x, y, z, p) = 1/4 R_J of a duplication + 3 R_C(a^2, b^2): the older form, in which nothing is subtracted.
pub fn rj(x: Dd, y: Dd, z: Dd, p: Dd) -> Dd {
    let (mut x, mut y, mut z, mut p) = (x, y, z, p);
    let mut sum = Dd::ZERO;
    let mut power = 1.0;
    for _ in 0..STEPS_OF_RJ {
        let mean = (x + y + z + p.scale(2.0)) * FIFTH;
        let spread = spread(mean, x, y, z).max((mean.hi - p.hi).abs());
        if spread < CLOSE * mean.hi {
            let dx = (mean - x) / mean;
            let dy = (mean - y) / mean;
            let dz = (mean - z) / mean;
            let dp = -(dx + dy + dz).scale(0.5);
            let (xyz, pp) = (dx * dy * dz, dp.square());
            let e2 = dx * dy + dz * (dx + dy) - pp * 3.0;
            let e3 = xyz + (e2 + pp.scale(2.0)) * dp.scale(2.0);
            let e4 = (2.0 * xyz.hi + (e2.hi + 3.0 * pp.hi) * dp.hi) * dp.hi;
            let e5 = xyz.hi * pp.hi;
            let series = series_of_five(e2, e3, e4, e5);
            return sum * 3.0 + series.scale(power) / (mean * mean.sqrt());
        }
        if spread.is_nan() || p.hi <= 0.0 {
            break;
        }
        let (rx, ry, rz) = (x.sqrt(), y.sqrt(), z.sqrt());
        let shift = rx * (ry + rz) + ry * rz;
        let a = p * (rx + ry + rz) + rx * ry * rz;
        let b_square = p * (p + shift).square();
        sum = sum + rc(a.square(), b_square).scale(power);
        power *= 0.25;
        x = (x + shift).scale(0.25);
        y = (y + shift).scale(0.25);
        z = (z + shift).scale(0.25);
        p = (p + shift).scale(0.25);
    }
    Dd::from(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Both sides of the seam of [`rf_of_roots`]: halving both roots adds ln 2, up to their squares.
    #[test]
    fn tiny_roots_have_no_seam() {
        for (x, y) in [(0.0, 1.9e-100), (1.3e-100, 0.6e-100), (0.95e-100, 0.95e-100)] {
            let [above, below] = [1.0, 0.5].map(|k| rf_of_roots(Dd::from(k * x), Dd::from(k * y)));
            let step = (below - above).value();
            assert!((step - core::f64::consts::LN_2).abs() < 1e-15, "{x} {y} {step}");
        }
    }
}

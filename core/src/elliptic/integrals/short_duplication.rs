//! Carlson's R_F over lanes in double: at most 3 ulp, for arguments >= 0 between 1e-150 and 1e150, at most one of them 0.
//!
//! Method: duplication until the arguments agree to 9 per cent, then the series in their elementary symmetric functions to the
//! thirteenth degree: a duplication costs as much as thirty of its terms. A lane that has come near is left as it is while
//! others go on, so that a value depends on its arguments alone. Source: DLMF 19.26.18, 19.36.1 continued by 19.19.7.

use crate::float::elementary::horner;
use crate::lanes::Lane;

/// Largest distance from the mean, over the mean.
const NEAR: f64 = 0.09;

/// Of E2^a E3^b in the series, a row for each b, without the 1 of the first:
/// (-1)^(a + b + N) (1/2)_(a + b)/(a! b! (2 N + 1)) with N = 2 a + 3 b <= 13.
const FIRST: [f64; 6] = [
    -0.1, 0.041666666666666664, -0.02403846153846154, 0.01608455882352941, -0.01171875, 0.0090234375,
];
const SECOND: [f64; 6] = [
    0.07142857142857142, -0.06818181818181818, 0.0625, -0.05756578947368421, 0.053498641304347824,
    -0.050130208333333336,
];
const THIRD: [f64; 4] = [0.028846153846153848, -0.05514705882352941, 0.078125, -0.0984375];
const FOURTH: [f64; 3] = [0.01644736842105263, -0.04755434782608696, 0.09114583333333333];
const FIFTH: f64 = 0.0109375;

/// Larger of two.
#[inline(always)]
fn larger<L: Lane>(a: L, b: L) -> L {
    L::select(a.less(b), b, a)
}

/// R_F(x, y, z).
#[inline(always)]
pub(crate) fn short_rf<L: Lane>(mut x: L, mut y: L, mut z: L) -> L {
    let (three, quarter) = (L::splat(-3.0), L::splat(0.25));
    loop {
        let sum = (x + y) + z;
        let (dx, dy, dz) = (x.mul_add(three, sum), y.mul_add(three, sum), z.mul_add(three, sum));
        let far = larger(larger(dx.abs(), dy.abs()), dz.abs());
        let further = (sum * L::splat(NEAR)).less(far);
        if !L::any(further) {
            let inverse = L::splat(1.0) / sum;
            let (dx, dy) = (dx * inverse, dy * inverse);
            let dz = -(dx + dy);
            let e2 = dx.mul_add(dy, -(dz * dz));
            let e3 = dx * dy * dz;
            let series = L::splat(FIFTH).mul_add(e3, horner(&FOURTH, e2));
            let series = series.mul_add(e3, horner(&THIRD, e2));
            let series = series.mul_add(e3, horner(&SECOND, e2));
            let series = series.mul_add(e3, e2 * horner(&FIRST, e2));
            // sqrt 3 over the root of the sum: that of the mean.
            let lead = (L::splat(3.0) / sum).sqrt();
            return lead.mul_add(series, lead);
        }
        let (rx, ry, rz) = (x.sqrt(), y.sqrt(), z.sqrt());
        let shift = rx.mul_add(ry, rz * (rx + ry));
        x = L::select(further, (x + shift) * quarter, x);
        y = L::select(further, (y + shift) * quarter, y);
        z = L::select(further, (z + shift) * quarter, z);
    }
}

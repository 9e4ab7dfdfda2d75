//! Sine and cosine, hyperbolic sine and cosine, exponential and arctangent of double-double arguments,
//! over lanes: each result is a lead carried as hi + lo plus a correction in double, good to about 2^-57
//! of itself (well under a tenth of an ulp before the final rounding).
//!
//! Polynomials: near-minimax (Chebyshev interpolation at 60 digits), errors noted beside them.

use super::constants::{HALF_PI, INVERSE_LN_2};
use super::double_double::{Dd, fast_two_sum, two_sum};
use crate::lanes::{Lane, compiled_once};

/// c[0] + x (c[1] + x (c[2] + ...)).
#[inline(always)]
pub fn horner<L: Lane, const N: usize>(coefficients: &[f64; N], x: L) -> L {
    let mut sum = L::splat(coefficients[N - 1]);
    for c in coefficients[..N - 1].iter().rev() {
        sum = sum.mul_add(x, L::splat(*c));
    }
    sum
}

/// (sin z - z)/z^3 in z^2 <= 0.617, error 2^-67.
const SINE: [f64; 7] = [
    -0.16666666666666666, 0.008333333333333331, -0.0001984126984126506, 2.755731921933466e-06,
    -2.505210623088241e-08, 1.6058531370931902e-10, -7.586682497157786e-13,
];
/// (cos z - 1 + z^2/2)/z^4 in z^2 <= 0.617, error 2^-72.
const COSINE: [f64; 7] = [
    0.041666666666666664, -0.0013888888888888887, 2.4801587301584642e-05, -2.755731922140032e-07,
    2.0876755790210228e-09, -1.1470460749696862e-11, 4.7458637732829623e-14,
];
/// (sinh r - r)/r^3 in r^2 <= 0.1205, error 2^-73.
const HYPERBOLIC_SINE: [f64; 6] = [
    0.16666666666666666, 0.008333333333333333, 0.0001984126984126322, 2.755731924742989e-06,
    2.505207086864797e-08, 1.6086711308915347e-10,
];
/// (cosh r - 1 - r^2/2)/r^4 in r^2 <= 0.1205, error 2^-67.
const HYPERBOLIC_COSINE: [f64; 5] = [
    0.041666666666666664, 0.0013888888888886524, 2.4801587317285895e-05, 2.7557282750180006e-07,
    2.091134081735977e-09,
];
/// (atan r - r)/r^3 in r^2 <= 0.056, error 2^-63.
const ARCTANGENT: [f64; 9] = [
    -0.3333333333333333, 0.19999999999999546, -0.14285714285497547, 0.11111111071254176,
    -0.09090905412391087, 0.0769211644851936, -0.06660798672457148, 0.0577644799252066, -0.04208920724718158,
];

compiled_once! {
    /// Sine and cosine of z in [0, pi/4] (a little beyond does no harm).
    pub fn sin_cos<L: Lane>(z: Dd<L>) -> (Dd<L>, Dd<L>) {
        let (square, square_error) = z.hi.two_product(z.hi);
        let half = L::splat(0.5);
        let cube = square * z.hi;
        // cos: 1 - z^2/2 without rounding, then the small rest.
        let (lead, lead_error) = fast_two_sum(L::splat(1.0), -(square * half));
        let rest = (square * square).mul_add(horner(&COSINE, square), lead_error);
        let rest = rest - z.hi.mul_add(z.lo, square_error * half);
        let cosine = Dd::ordered_sum(lead, rest);
        let sine = Dd::ordered_sum(z.hi, cube.mul_add(horner(&SINE, square), z.lo * cosine.hi));
        (sine, cosine)
    }
}

/// Sine of |z| <= pi/4 (a little beyond does no harm), in double.
#[inline(always)]
pub fn sine<L: Lane>(z: L) -> L {
    let square = z * z;
    (square * z).mul_add(horner(&SINE, square), z)
}

/// ln 2 as 42 bits (so that small multiples are exact) and the rest.
const LN_2_HEAD: f64 = 0.6931471805598903;
const LN_2_TAIL: f64 = 5.497923018708371e-14;

compiled_once! {
    /// y = k ln 2 + r: k, and cosh r, sinh r for |r| <= 0.347.
    fn hyperbolic_reduced<L: Lane>(y: Dd<L>) -> (L, Dd<L>, Dd<L>) {
        let k = (y.hi * L::splat(INVERSE_LN_2)).round();
        // Exact: k has few bits, and the difference is small.
        let head = y.hi - k * L::splat(LN_2_HEAD);
        let (tail, tail_error) = k.two_product(L::splat(LN_2_TAIL));
        let (r, r_error) = two_sum(head, -tail);
        let r = Dd::ordered_sum(r, r_error + (y.lo - tail_error));
        let (square, square_error) = r.hi.two_product(r.hi);
        let half = L::splat(0.5);
        let (lead, lead_error) = fast_two_sum(L::splat(1.0), square * half);
        let rest = (square * square).mul_add(horner(&HYPERBOLIC_COSINE, square), lead_error);
        let rest = rest + r.hi.mul_add(r.lo, square_error * half);
        let cosine = Dd::ordered_sum(lead, rest);
        let cube = square * r.hi;
        let sine = Dd::ordered_sum(r.hi, cube.mul_add(horner(&HYPERBOLIC_SINE, square), r.lo * cosine.hi));
        (k, cosine, sine)
    }
}

compiled_once! {
    /// Hyperbolic sine and cosine of y in [0, 700].
    pub fn sinh_cosh<L: Lane>(y: Dd<L>) -> (Dd<L>, Dd<L>) {
        let (k, cosine, sine) = hyperbolic_reduced(y);
        let one = L::splat(1.0);
        let grown = cosine.plus_smaller(sine).scale((k - one).exp2_integer());
        // e^-y no longer counts beyond 2^-1000 of e^y; the bound keeps the exponent in range.
        let shrunk = cosine.plus_smaller(-sine).scale((-k - one).exp2_integer());
        let far = grown.plus_smaller(-shrunk);
        let near = L::equal(k, L::splat(0.0));
        (Dd::select(near, sine, far), grown.plus_smaller(shrunk))
    }
}

/// Beyond the first sech is 0 in double whatever multiplies it; up to the second sinh is in range, and beyond it no
/// sum with pi or 1 tells the difference.
const SECH_END: f64 = 1400.0;
const SINH_END: f64 = 700.0;

/// Smaller of y and a bound; NaN stays.
#[inline(always)]
fn at_most<L: Lane>(y: Dd<L>, bound: f64) -> Dd<L> {
    let beyond = L::splat(bound).less(y.hi);
    Dd::select(beyond, Dd::from_double(L::splat(bound)), y)
}

compiled_once! {
    /// 1/cosh y for any y >= 0, into the subnormal numbers, as factor and power of two: their product.
    pub fn sech<L: Lane>(y: Dd<L>) -> (Dd<L>, L) {
        let (k, cosine, sine) = hyperbolic_reduced(at_most(y, SECH_END));
        let shrunk = cosine.plain_sum(-sine);
        // The power of two of e^-y in two steps: the second may be subnormal.
        let head = L::select(k.less(L::splat(1000.0)), -k, L::splat(-1000.0));
        let falling = shrunk.scale(head.exp2_integer());
        let denominator = Dd::from_double(L::splat(1.0)).plain_sum(falling.square());
        (quotient(falling.scale(L::splat(2.0)), denominator), (-k - head).exp2_integer())
    }
}

compiled_once! {
    /// sinh y and cosh y for any y >= 0, held at the end of their range.
    pub fn saturated_sinh_cosh<L: Lane>(y: Dd<L>) -> (Dd<L>, Dd<L>) {
        sinh_cosh(at_most(y, SINH_END))
    }
}

compiled_once! {
    /// e^y for |y| <= 700.
    pub fn exp<L: Lane>(y: Dd<L>) -> Dd<L> {
        let (k, cosine, sine) = hyperbolic_reduced(y);
        cosine.plain_sum(sine).scale(k.exp2_integer())
    }
}

/// Arctangent of 1/2, and of 1.
const ATAN_HALF: Dd = Dd::new(0.4636476090008061, 2.2698777452961687e-17);
const ATAN_ONE: Dd = Dd::new(0.7853981633974483, 3.061616997868383e-17);

compiled_once! {
    /// Angle in [0, pi/2] of the point (x, y) = (`adjacent`, `opposite`), both >= 0 and not both 0.
    ///
    /// With t = smaller/larger <= 1 and c the nearest of 0, 1/2, 1 to it on the circle,
    /// atan t = atan c + atan((t - c)/(1 + c t)): one division, of double-doubles, and |r| <= 0.2362.
    pub fn arctangent<L: Lane>(opposite: Dd<L>, adjacent: Dd<L>) -> Dd<L> {
        let steep = adjacent.hi.less(opposite.hi);
        let small = Dd::select(steep, adjacent, opposite);
        let large = Dd::select(steep, opposite, adjacent);
        let above_low = (large.hi * L::splat(0.2361)).less(small.hi);
        let above_high = (large.hi * L::splat(0.7208)).less(small.hi);
        let pick = |zero: f64, half: f64, one: f64| {
            L::select(above_high, L::splat(one), L::select(above_low, L::splat(half), L::splat(zero)))
        };
        let c = pick(0.0, 0.5, 1.0);
        // c is a power of two or zero: the products are exact.
        let (top, top_error) = two_sum(small.hi, -(c * large.hi));
        let top_rest = top_error + (small.lo - c * large.lo);
        let (bottom, bottom_error) = fast_two_sum(large.hi, c * small.hi);
        let bottom_rest = bottom_error + (large.lo + c * small.lo);
        let inverse = L::splat(1.0) / bottom;
        let r = top * inverse;
        let (back, back_error) = r.two_product(bottom);
        let rest = ((top - back) - back_error) + (top_rest - r * bottom_rest);
        let r_rest = rest * inverse;
        let square = r * r;
        let correction = (square * r).mul_add(horner(&ARCTANGENT, square), r_rest);
        let base = Dd::new(pick(0.0, ATAN_HALF.hi, ATAN_ONE.hi), pick(0.0, ATAN_HALF.lo, ATAN_ONE.lo));
        let (hi, error) = fast_two_sum(base.hi, r);
        let shallow = Dd::ordered_sum(hi, error + (base.lo + correction));
        let (hi, error) = fast_two_sum(L::splat(HALF_PI.hi), -shallow.hi);
        let complement = Dd::ordered_sum(hi, error + (L::splat(HALF_PI.lo) - shallow.lo));
        Dd::select(steep, complement, shallow)
    }
}

compiled_once! {
    /// numerator / denominator as hi + lo, one division.
    pub fn quotient<L: Lane>(numerator: Dd<L>, denominator: Dd<L>) -> Dd<L> {
        let inverse = L::splat(1.0) / denominator.hi;
        let first = numerator.hi * inverse;
        let (back, back_error) = first.two_product(denominator.hi);
        let rest = ((numerator.hi - back) - back_error) + (numerator.lo - first * denominator.lo);
        Dd::ordered_sum(first, rest * inverse)
    }
}

/// numerator / denominator rounded, of numbers up to 2^990.
#[inline(always)]
pub fn rounded_quotient<L: Lane>(numerator: Dd<L>, denominator: Dd<L>) -> L {
    let inverse = L::splat(1.0) / denominator.hi;
    let first = numerator.hi * inverse;
    let rest = numerator.hi.remainder(first, denominator.hi) + (numerator.lo - first * denominator.lo);
    rest.mul_add(inverse, first)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Identities at the seams of the reductions; the vectors of the elliptic functions hold the values.
    #[test]
    fn seams_are_invisible() {
        for i in 0..2000 {
            let y = Dd::from(f64::from(i) * 0.001 * core::f64::consts::LN_2);
            let (sinh, cosh) = sinh_cosh::<f64>(y);
            let e = exp::<f64>(y);
            let difference = cosh + sinh - e;
            assert!(difference.hi.abs() < 4e-17 * e.hi, "{i} {difference:?}");
            let unit = cosh.square() - sinh.square() - Dd::ONE;
            assert!(unit.hi.abs() < 4e-17 * cosh.hi * cosh.hi, "{i} {unit:?}");
        }
        for i in 0..=2000 {
            let z = Dd::from(f64::from(i) / 2000.0 * core::f64::consts::FRAC_PI_4);
            let (sine, cosine) = sin_cos::<f64>(z);
            let back = arctangent(sine, cosine) - z;
            assert!(back.hi.abs() < 4e-17 * z.hi.max(1e-300), "{i} {back:?}");
            let far = arctangent(cosine, sine) + z - HALF_PI;
            assert!(far.hi.abs() < 6e-17, "{i} {far:?}");
        }
    }
}

//! The natural logarithm over lanes, in double and as a double-double.
//!
//! x = 2^e f with f in [1/sqrt 2, sqrt 2), and ln f = 2 artanh s = 2 s + 2 s^3/3 + ... with s = (f - 1)/(f + 1), |s| <= 0.1716.
//! Polynomials: near-minimax (reference/coefficients.py), errors noted beside them.

use super::constants::LN_2;
use super::double_double::{Dd, two_sum};
use super::elementary::{horner, quotient};
use crate::lanes::Lane;

/// ln 2 as 32 bits, so that its products with an exponent are exact, and the rest.
const LN_2_HEAD: f64 = 0.693147180369123816490;
const LN_2_TAIL: f64 = 1.90821492927058770002e-10;

/// (2 artanh s - 2 s)/s^3 in s^2 <= 0.02944, error 2^-64 of 2 artanh s.
const ARTANH: [f64; 8] = [
    0.6666666666666666, 0.4000000000000088, 0.2857142857080285, 0.22222222391887064, 0.18181795621632782,
    0.15386240708969665, 0.13268746195596595, 0.13086907887965027,
];
/// (2 artanh s - 2 s - 2 s^3/3 - 2 s^5/5)/s^7 in s^2 <= 0.02944, error 2^-75 of 2 artanh s.
const LONG_ARTANH: [f64; 8] = [
    0.2857142857142857, 0.22222222222222948, 0.18181818181300352, 0.1538461552502006, 0.1333331466491488,
    0.11766050701460716, 0.10472884260628228, 0.1061726096944523,
];
const TWO_THIRDS: Dd = Dd::new(0.66666666666666663, 3.7007434154171886e-17);
const TWO_FIFTHS: Dd = Dd::new(0.40000000000000002, -2.2204460492503132e-17);

/// e and f of x = 2^e f, both exact, for a normal x below 2^1023.
#[inline(always)]
fn parts<L: Lane>(x: L) -> (L, L) {
    let e = x.exponent();
    let f = x * (-e).exp2_integer();
    let large = L::splat(core::f64::consts::SQRT_2).less(f);
    let one = L::splat(1.0);
    (L::select(large, e + one, e), L::select(large, f * L::splat(0.5), f))
}

/// ln x for a positive normal number below 2^1023: at most 1 ulp.
#[inline(always)]
pub fn ln<L: Lane>(x: L) -> L {
    let (e, f) = parts(x);
    // Exact by Sterbenz.
    let r = f - L::splat(1.0);
    let s = r / (L::splat(2.0) + r);
    let square = s * s;
    let half = L::splat(0.5) * r * r;
    // 2 s = r - s r, and s r = s (half - s r ...): ln f = r - (half - s (half + tail)), so that s errs only beyond r.
    let tail = square * horner(&ARTANH, square);
    let small = e.mul_add(L::splat(LN_2_TAIL), s * (half + tail));
    e.mul_add(L::splat(LN_2_HEAD), r - (half - small))
}

/// ln x likewise, of a double-double: good to 2^-70 of itself.
#[inline(always)]
pub fn long_ln<L: Lane>(x: Dd<L>) -> Dd<L> {
    let (e, f) = parts(x.hi);
    let r = f - L::splat(1.0);
    let (bottom, bottom_error) = two_sum(f, L::splat(1.0));
    let s = quotient(Dd::from_double(r), Dd::new(bottom, bottom_error));
    let square = s.square();
    let rest = square.hi * square.hi * square.hi * horner(&LONG_ARTANH, square.hi);
    let bracket = Dd::splat(TWO_FIFTHS) * square;
    let bracket = Dd::splat(TWO_THIRDS).plus_smaller(bracket) * square;
    let bracket = Dd::splat(Dd::new(2.0, 0.0)).plus_smaller(Dd::new(bracket.hi, bracket.lo + rest));
    let whole = Dd::splat(Dd::new(LN_2.hi, LN_2.mid)) * e;
    let sum = whole + bracket * s;
    // ln(hi + lo) = ln hi + lo/hi, short by the square of that.
    Dd::ordered_sum(sum.hi, sum.lo + x.lo / x.hi)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::float::elementary::exp;

    /// The exponential takes it back, at the seams and at the ends of the range.
    #[test]
    fn inverse_of_the_exponential() {
        for i in -700..=700 {
            let y = Dd::new(f64::from(i) + 0.3, 1e-17);
            let rest = long_ln(exp::<f64>(y)) - y;
            // The exponential is good to 2^-57 of itself.
            assert!(rest.hi.abs() < 1e-17, "{i} {rest:?}");
        }
        for (x, known) in [(f64::MIN_POSITIVE, -708.3964185322641), (8.9e307, 709.0796748259101), (1.0, 0.0)]
        {
            assert!((ln::<f64>(x) - known).abs() <= 2e-13, "{x}");
            assert!((long_ln(Dd::from(x)).hi - known).abs() <= 2e-13, "{x}");
        }
        for i in 1..4000 {
            let x = f64::from(i) / 1000.0;
            let long = long_ln(Dd::from(x));
            let error = (ln::<f64>(x) - long.hi - long.lo).abs();
            assert!(error <= 1.0 * f64::EPSILON * long.hi.abs(), "{x} {error}");
        }
    }
}

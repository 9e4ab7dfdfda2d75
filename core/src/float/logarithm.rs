//! The natural logarithm over lanes, in double and as a double-double.
//!
//! x = 2^e f with f in [1/sqrt 2, sqrt 2), and ln f = 2 artanh s = 2 s + 2 s^3/3 + ... with s = (f - 1)/(f + 1), |s| <= 0.1716.
//! Polynomials: near-minimax (reference/coefficients.py), errors noted beside them.

use super::constants::LN_2;
use super::double_double::{Dd, two_sum};
use super::elementary::horner;
use super::unnormalised::Unnormalised;
use crate::lanes::Lane;

/// ln 2 as 32 bits, so that its products with an exponent are exact, and the rest.
const LN_2_HEAD: f64 = 0.693147180369123816490;
const LN_2_TAIL: f64 = 1.90821492927058770002e-10;

/// (2 artanh s - 2 s)/s^3 in s^2 <= 0.02944, error 2^-64 of 2 artanh s.
const ARTANH: [f64; 8] = [
    0.6666666666666666, 0.4000000000000088, 0.2857142857080285, 0.22222222391887064, 0.18181795621632782,
    0.15386240708969665, 0.13268746195596595, 0.13086907887965027,
];
/// 2 artanh s without its first nine terms, over s^19, in s^2 <= 0.02944, error 2^-106 of 2 artanh s.
const LONG_ARTANH: [f64; 8] = [
    0.10526315789473684, 0.09523809523810003, 0.08695652173571712, 0.08000000092543302, 0.07407395103911595,
    0.06897437889596408, 0.06416414317507152, 0.06780504811249378,
];
/// Those nine: 2/(2 i + 1).
const FIRST: [Dd; 9] = [
    Dd::new(2.0, 0.0),
    Dd::new(0.6666666666666666, 3.700743415417188e-17),
    Dd::new(0.4, -2.2204460492503132e-17),
    Dd::new(0.2857142857142857, 1.586032892321652e-17),
    Dd::new(0.2222222222222222, 1.2335811384723961e-17),
    Dd::new(0.18181818181818182, -5.046468293750712e-18),
    Dd::new(0.15384615384615385, -8.540177112501205e-18),
    Dd::new(0.13333333333333333, 1.8503717077085942e-18),
    Dd::new(0.11764705882352941, 1.6326809185664067e-18),
];

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

/// ln x likewise, of a double-double: good to 2^-101 of itself.
#[inline(always)]
pub fn long_ln<L: Lane>(x: Dd<L>) -> Dd<L> {
    let (e, f) = parts(x.hi);
    let one = L::splat(1.0);
    // Both exact: f is within a factor of two of 1.
    let (top, (bottom, bottom_error)) = (f - one, two_sum(f, one));
    let s = Unnormalised::from_double(top).over(Unnormalised::new(bottom, bottom_error));
    let square = s.square();
    // No iterator's closure: it would be compiled without the instruction set.
    let mut sum = Unnormalised::from_double(horner(&LONG_ARTANH, square.hi));
    let mut i = FIRST.len();
    while i > 0 {
        i -= 1;
        sum = Unnormalised::splat(FIRST[i]).plus_smaller(square * sum);
    }
    let whole = Unnormalised::splat(Dd::new(LN_2.hi, LN_2.mid)) * Unnormalised::from_double(e);
    let sum = whole + sum * s;
    // ln(hi + lo) = ln hi + lo/hi, short by half the square of that.
    Dd::sum(sum.hi, sum.lo + x.lo / x.hi)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::float::Td;

    /// Against the triple-double logarithm, at the seams, next to 1 and at the ends of the range.
    #[test]
    fn double_double_digits() {
        let near = |x: Dd| {
            let (long, known) = (long_ln(x), Td::from(x).ln());
            let error = Td::from(long) - known;
            assert!(error.hi.abs() <= 4e-31 * known.hi.abs(), "{x:?} {error:?}");
        };
        for i in -1000..=1000 {
            let x = 2f64.powi(i) * (1.0 + f64::from(i.abs() % 41) / 41.0);
            near(Dd::new(x, x * 1e-17 * f64::from(i % 5)));
            near(Dd::from(1.0 + f64::from(i) * 1e-13));
            near(Dd::from(1.0 + f64::from(i) * 4e-4));
        }
    }

    #[test]
    fn ends_of_the_range() {
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

//! R_C over lanes, of x >= 0 and y > 0.
//!
//! Method: duplication of R_C(1, v), 0 < v <= 2: with w = sqrt v it is 2/(1 + w) R_C(1, 2 w/(1 + w)), and e = v - 1 becomes
//! e/(1 + w)^2, so that v and e keep their own relative digits; |e| <= 0.172 ends it by a polynomial in e.
//! R_C(x, y) = 2/(a + b) R_C(1, 2 b/(a + b)) with the roots a, b of x, y: the first duplication.
//! Source: DLMF 19.2.17, 19.26.27; polynomial: reference/coefficients.py.

use crate::float::Dd;
use crate::float::double_double::two_sum;
use crate::float::elementary::horner;
use crate::lanes::Lane;

/// Where the polynomial ends.
const NEAR: f64 = 0.172;

/// (R_C(1, 1 + e) - 1)/e in |e| <= 0.172, error 2^-59 of R_C.
const SERIES: [f64; 15] = [
    -0.3333333333333333, 0.20000000000000062, -0.14285714285714343, 0.11111111111034425,
    -0.09090909090836741, 0.07692307720254628, -0.06666666693032612, 0.05882348456709424,
    -0.052631536640414145, 0.04762273358849231, -0.04348173814195654, 0.03983841512197805,
    -0.0368846097029557, 0.038053933898915704, -0.035626447888871114,
];

/// R_C(1, v) as hi + lo, from v in (0, 2] and e = v - 1, each with its relative digits.
#[inline(always)]
pub(crate) fn unit_rc<L: Lane>(mut v: Dd<L>, mut e: L) -> Dd<L> {
    let (one, half) = (L::splat(1.0), L::splat(0.5));
    let mut factor = Dd::from_double(one);
    loop {
        let further = L::splat(NEAR).less(e.abs());
        if !L::any(further) {
            let small = e * horner(&SERIES, e);
            return Dd::new(factor.hi, factor.hi.mul_add(small, factor.lo));
        }
        let w = v.hi.sqrt();
        let (sum, sum_error) = two_sum(one, w);
        // 1/w and 1/(1 + w) by one division.
        let both = one / (w * sum);
        let inverse = both * w;
        let w_rest = (v.hi.remainder(w, w) + v.lo) * (both * sum * half);
        let inverse_rest = inverse * (one.remainder(inverse, sum) - (sum_error + w_rest) * inverse);
        let inverse = Dd::new(inverse, inverse_rest).scale(L::splat(2.0));
        v = Dd::select(further, inverse * Dd::new(w, w_rest), v);
        e = L::select(further, e * (inverse.hi * inverse.hi) * L::splat(0.25), e);
        factor = Dd::select(further, factor * inverse, factor);
    }
}

/// R_C as hi + lo, of x in [0, 1e60], y in [1e-60, 1e60].
#[inline(always)]
pub(crate) fn rc<L: Lane>(x: Dd<L>, y: Dd<L>) -> Dd<L> {
    let (one, half) = (L::splat(1.0), L::splat(0.5));
    let (a, b) = (x.hi.sqrt(), y.hi.sqrt());
    let (sum, sum_error) = two_sum(a, b);
    // What is added counts only for a root so small that its rest does not.
    let shifted = a + b * L::splat(1e-60);
    let all = one / (shifted * (b * sum));
    let (inverse_a, inverse_b, inverse) = (all * (b * sum), all * (shifted * sum), all * (shifted * b));
    let a_rest = (x.hi.remainder(a, a) + x.lo) * (inverse_a * half);
    let b_rest = (y.hi.remainder(b, b) + y.lo) * (inverse_b * half);
    let rest = inverse * (one.remainder(inverse, sum) - (sum_error + (a_rest + b_rest)) * inverse);
    let twice = Dd::new(inverse, rest).scale(L::splat(2.0));
    let e = ((y.hi - x.hi) + (y.lo - x.lo)) * (inverse * inverse);
    twice * unit_rc(twice * Dd::new(b, b_rest), e)
}

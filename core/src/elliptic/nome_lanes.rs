//! The nome over lanes, from m and mc.
//!
//! Method: for 0.02 <= mc <= 50 the series in lambda = m/2 / ((1 + k')(1 + sqrt k')^2), DLMF 19.5.5, both roots and the
//! quotient to two words; it is odd in lambda, so m < 0 needs nothing of its own. Beyond, ln q ln q1 = pi^2 with the
//! complementary nome q1, whose series is short there: the exponent is above -1.4. NaN where m or mc is next to 0.
//! Series: reference/coefficients.py.

use crate::float::Dd;
use crate::float::double_double::two_sum;
use crate::float::elementary::{exp, horner, quotient};
use crate::float::logarithm::long_ln;
use crate::lanes::{Formula, Lane};

/// q = lambda (1 + 2 l + 15 l^2 + ...) in l = lambda^4, less 1 and over l; the next is below 2^-60 for l <= 0.0027.
const SERIES: [f64; 12] = [
    2.0, 15.0, 150.0, 1707.0, 20910.0, 268616.0, 3567400.0, 48555069.0, 673458874.0, 9481557398.0,
    135119529972.0, 1944997539623.0,
];

/// Where the complementary nome takes over.
const FAR: f64 = 0.02;

/// The smallest m and mc, and the inverse of the largest.
const LEAST: f64 = 1e-290;

const PI_SQUARE: Dd = Dd::new(9.869604401089358, 6.265295508739711e-16);

/// q/lambda - 1.
#[inline(always)]
fn beyond<L: Lane>(lambda: L) -> L {
    let square = lambda * lambda;
    let fourth = square * square;
    fourth * horner(&SERIES, fourth)
}

/// The nome by the series in lambda, where m and mc are in range, else NaN; and the flags of the rows that ask for
/// [`by_complement`].
#[inline(always)]
fn by_series<L: Lane>([m, m_rest, mc, mc_rest]: [L; 4]) -> (L, L::Mask) {
    let (one, half) = (L::splat(1.0), L::splat(0.5));
    let (m, mc) = (in_range(m), positive_in_range(mc));
    let k = mc.sqrt();
    let root = k.sqrt();
    // (1 + k')(1 + sqrt k')^2 = (1 + k')((1 + k') + 2 sqrt k') from both roots as doubles; 1/sqrt k' and its inverse by one
    // division.
    let (sum, sum_error) = two_sum(one, k);
    let (second, second_error) = two_sum(sum, root + root);
    let (product, product_error) = sum.two_product_in_range(second);
    let both = one / (root * product);
    let (inverse_root, inverse) = (both * product, both * root);
    let k_rest = (mc.remainder(k, k) + mc_rest) * (half * inverse_root * inverse_root);
    let root_rest = (k.remainder(root, root) + k_rest) * (half * inverse_root);
    let sum_rest = sum_error + k_rest;
    let second_rest = second_error + (sum_rest + (root_rest + root_rest));
    let product_rest = sum.mul_add(second_rest, second.mul_add(sum_rest, product_error));
    let lambda = m * half * inverse;
    let rest = (m * half).remainder(lambda, product) + m_rest.mul_add(half, -(lambda * product_rest));
    let near = lambda + rest.mul_add(inverse, lambda * beyond(lambda));
    let (small, large) = ordered(mc);
    (near, (small / large).less(L::splat(FAR)))
}

/// The nome by that of the complement, or 1/2 to the power of something where the flags do not hold.
#[inline(always)]
fn by_complement<L: Lane>(far: L::Mask, m: L, mc: L) -> L {
    let (one, half) = (L::splat(1.0), L::splat(0.5));
    let (m, (small, large)) = (in_range(m), ordered(positive_in_range(mc)));
    // The complement is mc or 1/mc, the parameter m or -m/mc.
    let ratio = m.abs() / large;
    let k = ratio.sqrt();
    let sum = one + k;
    let root = k.sqrt();
    let lambda = (half * (small / large)) / (sum * (sum + (root + root)));
    let q = lambda + lambda * beyond(lambda);
    // Rows that are not far have a number below 1 too.
    let log = long_ln(Dd::from_double(L::select(far, q, half)));
    exp(quotient(Dd::splat(PI_SQUARE), log)).value().copysign(m)
}

/// m where it is not next to 0 and not huge, else NaN.
#[inline(always)]
fn in_range<L: Lane>(m: L) -> L {
    let nan = L::splat(f64::NAN);
    let m = L::select(L::splat(LEAST).less(m.abs()), m, nan);
    L::select(m.abs().less(L::splat(1.0 / LEAST)), m, nan)
}

/// mc where it is not next to 0, else NaN.
#[inline(always)]
fn positive_in_range<L: Lane>(mc: L) -> L {
    L::select(L::splat(LEAST).less(mc), mc, L::splat(f64::NAN))
}

/// mc and 1, the smaller first.
#[inline(always)]
fn ordered<L: Lane>(mc: L) -> (L, L) {
    let one = L::splat(1.0);
    let above = one.less(mc);
    (L::select(above, one, mc), L::select(above, mc, one))
}

/// The nome of m.hi, m.lo, mc.hi, mc.lo.
pub(crate) struct NomeOfParameter;

impl Formula<4, 1> for NomeOfParameter {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, arguments: [L; 4]) -> [L; 1] {
        let (near, far) = by_series(arguments);
        if !L::any(far) {
            return [near];
        }
        let [m, _, mc, _] = arguments;
        [L::select(far, by_complement(far, m, mc), near)]
    }
}

/// The same where it is by the series; and 1 where it is not, else 0.
pub(crate) struct NomeBySeries;

impl Formula<4, 2> for NomeBySeries {
    type Place = NomeOfParameter;
    #[inline(always)]
    fn at<L: Lane>(&self, arguments: [L; 4]) -> [L; 2] {
        let (near, far) = by_series(arguments);
        [near, L::select(far, L::splat(1.0), L::splat(0.0))]
    }
}

/// The same where it is not.
pub(crate) struct NomeByComplement;

impl Formula<4, 1> for NomeByComplement {
    type Place = NomeOfParameter;
    #[inline(always)]
    fn at<L: Lane>(&self, [m, _, mc, _]: [L; 4]) -> [L; 1] {
        [by_complement(L::splat(0.0).equal(L::splat(0.0)), m, mc)]
    }
}

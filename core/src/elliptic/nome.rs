//! The nome q = exp(-pi K'/K).
//!
//! Method: for m <= 1/2 the series in lambda, DLMF 19.5.5, where q <= e^-pi and five terms reach 2^-100;
//! above, the complementary nome q1 of mc by the same series is what the theta functions need, and q itself
//! follows from ln q ln q1 = pi^2. For m < 0, q(m) = -q(-m/(1 - m)) continues the series.

use super::agm::agm;
use super::parameter::Parameter;
use crate::float::elementary::horner;
use crate::float::logarithm::long_ln;
use crate::float::unnormalised::Unnormalised;
use crate::float::{Dd, PI, elementary};
use crate::lanes::Lane;

/// The nome of 0 <= m <= 1/2, from m and the complementary modulus k'.
pub(crate) fn small_nome(m: Dd, kc: Dd) -> Dd {
    let root = kc.sqrt();
    // (1 - sqrt k')/(2 (1 + sqrt k')) without the subtraction.
    let lambda = m / ((Dd::ONE + kc) * (Dd::ONE + root).square()).scale(2.0);
    lambda + lambda * beyond_lambda(lambda.hi)
}

/// The nome over lanes, in double, from lambda.
#[inline(always)]
pub(crate) fn short_nome<L: Lane>(lambda: L) -> L {
    lambda + lambda * beyond_lambda(lambda)
}

/// q/lambda - 1 = 2 l^4 + 15 l^8 + 150 l^12 + 1707 l^16 + 20910 l^20; the next is below 2^-104 of the sum.
#[inline(always)]
fn beyond_lambda<L: Lane>(lambda: L) -> L {
    let square = lambda * lambda;
    let fourth = square * square;
    fourth * horner(&[2.0, 15.0, 150.0, 1707.0, 20910.0], fourth)
}

/// -ln q over lanes, as a double-double, from lambda of 0 < m <= 1/2.
///
/// ln(q/lambda) = 2 l + 13 l^2 + ... in l = lambda^4 <= 3.5e-6, the logarithm of DLMF 19.5.5; the next term is below 2^-104.
#[inline(always)]
pub(crate) fn minus_log_short_nome<L: Lane>(lambda: Unnormalised<L>) -> Unnormalised<L> {
    let fourth = lambda.square().square();
    let l = fourth.hi;
    let tail = l * horner(&[368.0 / 3.0, 1350.5, 16182.4, 204_573.333_333_333_33], l);
    let series = Unnormalised::from_double(L::splat(13.0)).plus_smaller(Unnormalised::from_double(tail));
    let series = Unnormalised::from_double(L::splat(2.0)).plus_smaller(fourth * series);
    let log = Unnormalised::from(long_ln(lambda.tight()));
    (-log).minus_smaller(fourth * series)
}

/// -ln q = pi K'/K, from k and k'.
pub(crate) fn minus_log_nome(k: Dd, kc: Dd) -> Dd {
    PI * agm(kc) / agm(k)
}

/// The nome q = exp(-pi K'/K), for m < 0 its analytic continuation -q(-m/(1 - m)).
///
/// | argument | domain |
/// |---|---|
/// | `parameter` | m <= 1, else NaN; 1 at m = 1 |
///
/// **Error** at most 3 ulp.
///
/// **Source** DLMF 22.2.1, 19.5.5.
///
/// ```
/// use libration::{Parameter, nome};
/// assert_eq!(format!("{:.12}", nome(Parameter::from_m(0.5))), "0.043213918264");
/// ```
#[must_use]
pub fn nome(parameter: Parameter) -> f64 {
    let Parameter { m, mc, .. } = parameter;
    if mc.hi == 0.0 {
        return 1.0;
    }
    if mc.hi.is_nan() || mc.hi < 0.0 {
        return f64::NAN;
    }
    let unit = parameter.unit();
    let size = if unit.m.hi <= 0.5 {
        small_nome(unit.m, unit.kc).value()
    } else {
        elementary::exp(-minus_log_nome(unit.k, unit.kc)).value()
    };
    if m.hi < 0.0 { -size } else { size }
}

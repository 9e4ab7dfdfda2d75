//! The nome q = exp(-pi K'/K).
//!
//! Over lanes in nome_lanes.rs; and row by row for every parameter:
//!
//! Method: for m <= 1/2 the series in lambda, DLMF 19.5.5, where q <= e^-pi and five terms reach 2^-100;
//! above, the complementary nome q1 of mc by the same series is what the theta functions need, and q itself
//! follows from ln q ln q1 = pi^2. For m < 0, q(m) = -q(-m/(1 - m)) continues the series.
//! Back by the quotients of theta functions, DLMF 22.2.2: m = (theta_2/theta_3)^4 and 1 - m = (theta_4/theta_3)^4 at 0,
//! of q or, with m and 1 - m exchanged, of the complementary nome, so that q <= e^-pi and nothing cancels.

use super::agm::agm;
use super::given::Given;
use super::nome_lanes::{NomeByComplement, NomeBySeries, NomeOfParameter};
use super::parameter::Parameter;
use super::rows::{column_of_parameter, one_of_parameter};
use crate::float::elementary::horner;
use crate::float::logarithm::long_ln;
use crate::float::unnormalised::Unnormalised;
use crate::float::{Dd, PI, Scaled, elementary};
use crate::lanes::{BLOCK, COMPACT, Classes, Columns, Evaluation, Lane};

/// The nome of 0 <= m <= 1/2, from m and the complementary modulus k'.
pub(crate) fn small_nome(m: Dd, kc: Dd) -> Dd {
    let root = kc.sqrt();
    // (1 - sqrt k')/(2 (1 + sqrt k')) without the subtraction.
    let lambda = m / ((Dd::ONE + kc) * (Dd::ONE + root).square()).scale(2.0);
    lambda + lambda * beyond_lambda(lambda.hi)
}

/// The nome over lanes, with the low word of lambda.
#[inline(always)]
pub(crate) fn short_nome<L: Lane>(lambda: Unnormalised<L>) -> Dd<L> {
    Dd::ordered_sum(lambda.hi, lambda.hi.mul_add(beyond_lambda(lambda.hi), lambda.lo))
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
    one_of_parameter(&NomeOfParameter, [], parameter, careful_nome)
}

/// The nome of a column of parameters.
///
/// **Error**, domain and source of [`nome`], value by value the same. Panics where the lengths differ.
///
/// ```
/// use libration::elliptic::{Given, nome_into};
/// let mut q = [0.0; 2];
/// nome_into(Given::Mc, &[0.5, 1e-20], &mut q);
/// assert_eq!(format!("{:.10} {:.10}", q[0], q[1]), "0.0432139183 0.8169761535");
/// ```
pub fn nome_into(given: Given, parameters: &[f64], q: &mut [f64]) {
    if COMPACT {
        return column_of_parameter(&NomeOfParameter, [], (given, parameters), q, careful_nome);
    }
    assert!(parameters.len() == q.len(), "columns of different lengths");
    let (mut rare, mut codes) = (Classes::<4, 1, 2>::new(), [0.0; BLOCK]);
    given.blocks(parameters, |parts, rows| {
        let (q, codes) = (&mut q[rows.clone()], &mut codes[..rows.len()]);
        Columns::new(parts, [&mut *q, &mut *codes]).of(&NomeBySeries);
        // The exponential is long, and few ask for it: side by side.
        rare.only(1, codes, parts, &mut [&mut *q], |_, columns| columns.of(&NomeByComplement));
        for (value, parameter) in q.iter_mut().zip(&parameters[rows]) {
            if value.is_nan() {
                *value = careful_nome([], given.parameter(*parameter));
            }
        }
    });
}

pub(crate) fn careful_nome([]: [f64; 0], parameter: Parameter) -> f64 {
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

/// Below, the complement is next to the subnormal numbers, and its digits as a double-double are not all there.
const LEAST_COMPLEMENT: i32 = -960;

impl Parameter {
    /// From the nome q, -0.985 <= q <= 0.985, else NaN: beyond, 1 - m or its inverse has no room among the doubles for all
    /// its digits.
    ///
    /// **Source** DLMF 22.2.2, 20.7.3.
    ///
    /// ```
    /// use libration::{Parameter, complete_k};
    /// assert_eq!(format!("{:.12}", complete_k(Parameter::from_nome(0.1))), "2.262700763194");
    /// ```
    #[must_use]
    pub fn from_nome(q: f64) -> Parameter {
        let [m, mc] = parameter_of_nome_scaled(q);
        let inside = mc.power().abs() <= -LEAST_COMPLEMENT && !mc.is_nan() && !mc.is_zero();
        if inside { Parameter::new(m.to_dd(), mc.to_dd()) } else { Parameter::from_m(f64::NAN) }
    }
}

/// The parameter m and its complement 1 - m of the nome q: the inverse of [`nome`], each rounded once.
///
/// | argument | domain |
/// |---|---|
/// | `q` | -1 < q <= 1, else NaN; m < 0 for q < 0, and infinite where it leaves the doubles |
///
/// **Error** of each at most 1 ulp, plus 2^-100 of its condition.
///
/// **Source** DLMF 22.2.2, 20.7.3.
///
/// ```
/// let (m, mc) = libration::parameter_of_nome(0.1);
/// assert_eq!(format!("{m:.12} {mc:.12}"), "0.802403298218 0.197596701782");
/// ```
#[must_use]
pub fn parameter_of_nome(q: f64) -> (f64, f64) {
    let [m, mc] = parameter_of_nome_scaled(q);
    (m.value(), mc.value())
}

/// m and 1 - m of a nome, beyond the range too.
fn parameter_of_nome_scaled(q: f64) -> [Scaled; 2] {
    let size = q.abs();
    if q == 1.0 {
        return [Scaled::ONE, Scaled::ZERO];
    }
    if size.is_nan() || size >= 1.0 {
        return [Scaled::NAN; 2];
    }
    let [m, mc] = if size <= LARGEST_SMALL_NOME {
        of_small_nome(Scaled::from(size))
    } else {
        let [mc, m] = of_small_nome(Scaled::exp(-(PI.square() / -Dd::ln(size))));
        [m, mc]
    };
    if q < 0.0 { [-(m / mc), Scaled::ONE / mc] } else { [m, mc] }
}

/// e^-pi, rounded up: the nome of m = 1/2.
const LARGEST_SMALL_NOME: f64 = 0.044;

/// m and 1 - m of a nome up to e^-pi: the terms left out are below 2^-104.
fn of_small_nome(q: Scaled) -> [Scaled; 2] {
    let x = q.to_dd();
    let square = x.square();
    let fourth = square.square();
    let ninth = fourth.square() * x;
    let sixteenth = fourth.square().square();
    let twice = |sum: Dd| sum.scale(2.0);
    let even = Dd::ONE + twice(fourth + sixteenth);
    let odd = twice(x + ninth + sixteenth * ninth);
    let second = Dd::ONE + square + fourth * square + fourth * fourth * fourth + sixteenth * fourth;
    let third = even + odd;
    let fourth_power = |quotient: Dd| Scaled::from(quotient.square().square());
    [q.shift(4) * fourth_power(second / third), fourth_power((even - odd) / third)]
}

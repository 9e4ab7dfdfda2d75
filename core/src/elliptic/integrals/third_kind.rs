//! The integral of the third kind Pi, complete and incomplete, of any real characteristic n.
//!
//! Over lanes in third_kind_lanes.rs; and row by row for every argument:
//!
//! Method: for each range of n the combination of R_F, R_J and R_C in which every term has one sign: for n < 0
//! by n' = (m - n)/(1 - n), for n > 1 by n' = m/n, whose remaining integrals are one R_J. With s, c the sine and cosine of
//! the reduced amplitude and d = 1 - m s^2:
//!   0 <= n s^2 < 1:  s R_F(c^2, d, 1) + n/3 s^3 R_J(c^2, d, 1, 1 - n s^2)
//!   n < 0:           s/(1 - n) R_F - n/(1 - n) (s c R_C(d, (1 - n s^2) p) + mc/(1 - n) s^3/3 R_J(c^2, d, 1, p)), p = 1 - n' s^2
//!   n s^2 > 1:       s R_C(c^2 d, (1 - n s^2) p) - n'/3 s^3 R_J(c^2, d, 1, p), p = 1 - n' s^2
//! Source: DLMF 19.2.7, 19.7.8, 19.7.9, 19.25.2, 19.25.14; n < 0 < m - 1 through 1/m, DLMF 19.7.4.

use super::carlson::{rc, rc_principal, rf, rj};
use super::complete::complete_k_dd;
use super::incomplete::delta_square;
use super::third_kind_lanes::{CompletePi, IncompletePi};
use crate::elliptic::amplitude::{ReducedAmplitude, sines};
use crate::elliptic::given::Given;
use crate::elliptic::parameter::Parameter;
use crate::elliptic::rows::{column_of_parameter, one_of_parameter};
use crate::float::{Dd, Scaled};

/// m, mc, n and 1 - n.
#[derive(Clone, Copy)]
struct Characteristic {
    m: Scaled,
    mc: Scaled,
    n: Scaled,
    nc: Scaled,
}

impl Characteristic {
    fn new(n: f64, parameter: Parameter) -> Characteristic {
        let nc = Scaled::from(Dd::sum(1.0, -n));
        Characteristic { m: parameter.long_m(), mc: parameter.mc.into(), n: n.into(), nc }
    }
}

const THREE: f64 = 3.0;

/// Pi(n | m) for mc > 0 and n not 1.
fn complete(given: Characteristic, parameter: Parameter) -> Scaled {
    let Characteristic { m, mc, n, nc } = given;
    let one = Scaled::ONE;
    if nc.is_negative() {
        // n - m = (n - 1) + mc.
        let rest = mc - nc;
        return -(m / (n * THREE)) * rj(Scaled::ZERO, mc, one, rest / n);
    }
    let quarter = Scaled::from(complete_k_dd(parameter));
    if n.is_negative() {
        let inner = mc / nc;
        return quarter / nc - n / nc * inner * rj(Scaled::ZERO, mc, one, inner) / Scaled::from(THREE);
    }
    quarter + n * rj(Scaled::ZERO, mc, one, nc) / Scaled::from(THREE)
}

/// The integral over the reduced amplitude.
fn partial(given: Characteristic, sine: Scaled, cosine: Scaled) -> Scaled {
    let Characteristic { m, mc, n, nc } = given;
    let one = Scaled::ONE;
    let (square, c) = (sine.square(), cosine.square());
    let d = delta_square(m, mc, square, c);
    let third = sine * square / Scaled::from(THREE);
    // 1 - n s^2
    let below = delta_square(n, nc, square, c);
    if n.is_negative() {
        if mc.is_negative() {
            let rest = m - n;
            let p = d - mc * square * m / rest;
            let first = sine * m / rest * rf(c, d, one);
            let second = sine * d.sqrt() * rc(c, below * p);
            let third = mc * m / rest * third * rj(c, d, one, p);
            return first - n / rest * (second - third);
        }
        let p = c + mc / nc * square;
        let first = sine / nc * rf(c, d, one);
        let second = sine * cosine * rc(d, below * p) + mc / nc * third * rj(c, d, one, p);
        return first - n / nc * second;
    }
    if !below.is_negative() {
        return sine * rf(c, d, one) + n * third * rj(c, d, one, below);
    }
    // 1 - n' = (n - m)/n, and n - m = (n - 1) + mc.
    let inner = m / n;
    let p = delta_square(inner, (mc - nc) / n, square, c);
    sine * rc_principal(c * d, below * p) - inner * third * rj(c, d, one, p)
}

/// Pi(n | m) = int_0^(pi/2) dt / ((1 - n sin^2 t) sqrt(1 - m sin^2 t)), for n > 1 Cauchy's principal value.
///
/// | argument | domain |
/// |---|---|
/// | `n` | any; inf at n = 1 |
/// | `parameter` | m < 1; at m = 1 inf for n <= 1 and -inf above, NaN for m > 1 |
///
/// **Error** at most 3 ulp.
///
/// **Source** DLMF 19.2.8, 19.6.5, 19.25.2.
///
/// ```
/// use libration::{Parameter, complete_pi};
/// assert_eq!(format!("{:.12}", complete_pi(0.5, Parameter::from_m(0.5))), "2.701287762095");
/// ```
#[must_use]
pub fn complete_pi(n: f64, parameter: Parameter) -> f64 {
    one_of_parameter(&CompletePi, [n], parameter, careful_complete_pi)
}

/// Pi of a column of characteristics, each with a parameter of its own.
///
/// **Error**, domain and source of [`complete_pi`], value by value the same. Panics where the lengths differ.
pub fn complete_pi_into(n: &[f64], given: Given, parameters: &[f64], values: &mut [f64]) {
    column_of_parameter(&CompletePi, [n], (given, parameters), values, careful_complete_pi);
}

pub(crate) fn careful_complete_pi([n]: [f64; 1], parameter: Parameter) -> f64 {
    let mc = parameter.mc.hi;
    if n.is_nan() || mc.is_nan() || mc < 0.0 {
        return f64::NAN;
    }
    if n.is_infinite() {
        return if mc > 0.0 { 0.0 } else { f64::NAN };
    }
    if mc == 0.0 {
        return if n > 1.0 { f64::NEG_INFINITY } else { f64::INFINITY };
    }
    if n == 1.0 {
        return f64::INFINITY;
    }
    complete(Characteristic::new(n, parameter), parameter).value()
}

/// Pi(n; phi | m) = int_0^phi dt / ((1 - n sin^2 t) sqrt(1 - m sin^2 t)), Cauchy's principal value where
/// n sin^2 t passes 1.
///
/// | argument | domain |
/// |---|---|
/// | `n` | any; infinite beyond pi/2 at n = 1 |
/// | `phi` | any; infinite phi gives its infinity for m <= 1 and n < 1, else NaN |
/// | `parameter` | m sin^2 t <= 1 on the way, else NaN; at m = 1 infinite beyond pi/2 |
///
/// **Error** at most 3 ulp, plus 2^-98 of the condition in all arguments.
///
/// **Source** DLMF 19.2.7, 19.25.14, 19.7.8, 19.7.9.
///
/// ```
/// use libration::{Parameter, incomplete_pi};
/// assert_eq!(format!("{:.12}", incomplete_pi(0.5, 1.0, Parameter::from_m(0.5))), "1.288978174245");
/// ```
#[must_use]
pub fn incomplete_pi(n: f64, phi: f64, parameter: Parameter) -> f64 {
    one_of_parameter(&IncompletePi, [n, phi], parameter, careful_incomplete_pi)
}

/// Pi of columns of characteristics and amplitudes, each with a parameter of its own.
///
/// **Error**, domain and source of [`incomplete_pi`], value by value the same. Panics where the lengths differ.
pub fn incomplete_pi_into([n, phi]: [&[f64]; 2], given: Given, parameters: &[f64], values: &mut [f64]) {
    column_of_parameter(&IncompletePi, [n, phi], (given, parameters), values, careful_incomplete_pi);
}

pub(crate) fn careful_incomplete_pi([n, phi]: [f64; 2], parameter: Parameter) -> f64 {
    let mc = parameter.mc.hi;
    if n.is_nan() || phi.is_nan() || mc.is_nan() {
        return f64::NAN;
    }
    if phi == 0.0 && n.is_finite() {
        return phi;
    }
    if n.is_infinite() {
        return f64::NAN;
    }
    if phi.is_infinite() {
        return if mc < 0.0 || n > 1.0 { f64::NAN } else { phi };
    }
    let ReducedAmplitude { n: half_turns, side, r, rest, .. } = ReducedAmplitude::new(phi);
    let (sine, cosine) = sines(r, rest);
    let given = Characteristic::new(n, parameter);
    if mc < 0.0
        && (half_turns.hi != 0.0 || (Scaled::ONE - given.m * Scaled::from(sine).square()).is_negative())
    {
        return f64::NAN;
    }
    let within = partial(given, sine.into(), cosine.into()) * side;
    if half_turns.hi == 0.0 {
        return within.value();
    }
    if mc == 0.0 || n == 1.0 {
        let infinity = f64::INFINITY.copysign(phi);
        return if n > 1.0 { -infinity } else { infinity };
    }
    (complete(given, parameter) * Scaled::from(half_turns).shift(1) + within).value()
}

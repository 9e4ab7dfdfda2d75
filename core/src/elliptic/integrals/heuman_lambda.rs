//! Heuman's lambda function.
//!
//! Over lanes in third_kind_lanes.rs; and row by row for every argument:
//!
//! Method: with s, c the sine and cosine of the reduced amplitude and e = c^2 + m s^2,
//!   Lambda0 = 2/pi mc s c/sqrt(e) (R_F(0, mc, 1) + m/(3 e) R_J(0, mc, 1, mc c^2/e)),
//! whose terms are all positive, and Lambda0(phi + pi) = Lambda0(phi) + 2.
//! Source: Byrd & Friedman 150.03; Carlson, Numer. Math. 33 (1979) 1.

use super::carlson::{rf, rj};
use super::third_kind_lanes::HeumanLambda;
use crate::elliptic::amplitude::{ReducedAmplitude, sines};
use crate::elliptic::given::Given;
use crate::elliptic::parameter::Parameter;
use crate::elliptic::rows::{column_of_parameter, one_of_parameter};
use crate::float::Scaled;
use crate::float::constants::TWO_OVER_PI;

/// Lambda0(phi, k) = (F(phi, k')/K' + 2/pi K Z(phi, k')): grows by 2 with every pi.
///
/// | argument | domain |
/// |---|---|
/// | `phi` | any; its infinity at infinity |
/// | `parameter` | 0 <= m <= 1, else NaN; sin(phi) on [-pi/2, pi/2] at m = 0, 2 phi/pi at m = 1 |
///
/// **Error** at most 3 ulp.
///
/// **Source** Byrd & Friedman 150.03; Carlson, Numer. Math. 33 (1979) 1; DLMF 19.25.1, 19.25.2.
///
/// ```
/// use libration::{Parameter, heuman_lambda};
/// assert_eq!(format!("{:.12}", heuman_lambda(0.5, Parameter::from_m(0.5))), "0.414660142135");
/// ```
#[must_use]
pub fn heuman_lambda(phi: f64, parameter: Parameter) -> f64 {
    one_of_parameter(&HeumanLambda, [phi], parameter, careful_lambda)
}

/// Lambda0 of a column of amplitudes, each with a parameter of its own.
///
/// **Error**, domain and source of [`heuman_lambda`], value by value the same. Panics where the lengths differ.
pub fn heuman_lambda_into(phi: &[f64], given: Given, parameters: &[f64], values: &mut [f64]) {
    column_of_parameter(&HeumanLambda, [phi], (given, parameters), values, careful_lambda);
}

pub(crate) fn careful_lambda([phi]: [f64; 1], parameter: Parameter) -> f64 {
    let Parameter { m, mc, .. } = parameter;
    if m.hi.is_nan() || m.hi < 0.0 || mc.hi < 0.0 || phi.is_nan() {
        return f64::NAN;
    }
    if phi == 0.0 || phi.is_infinite() {
        return phi;
    }
    let scale = Scaled::from(TWO_OVER_PI);
    if mc.hi == 0.0 {
        return (scale * phi).value();
    }
    let ReducedAmplitude { n, side, r, rest, .. } = ReducedAmplitude::new(phi);
    let (sine, cosine) = sines(r, rest);
    let (m, mc) = (Scaled::from(m), Scaled::from(mc));
    let (sine, cosine) = (Scaled::from(sine), Scaled::from(cosine));
    let c = cosine.square();
    let e = c + m * sine.square();
    let first = rf(Scaled::ZERO, mc, Scaled::ONE);
    let second = m / (e * 3.0) * rj(Scaled::ZERO, mc, Scaled::ONE, mc * c / e);
    let within = scale * mc * sine * cosine / e.sqrt() * (first + second);
    (Scaled::from(n).shift(1) + within * side).value()
}

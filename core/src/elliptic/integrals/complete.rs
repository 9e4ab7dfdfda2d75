//! The complete integrals K and E of any real m <= 1.
//!
//! As doubles over lanes (complete_lanes.rs). As double-doubles, and at the ends of the range: K by the
//! arithmetic-geometric mean; E by Carlson's R_D in the form whose terms are all positive, DLMF 19.25.1. For m < 0 both
//! follow from -m/(1 - m), DLMF 19.7.5.

use super::carlson_duplication::{THIRD, rd};
use super::complete_lanes::{CompleteE, CompleteK};
use crate::elliptic::agm::quarter_period;
use crate::elliptic::given::Given;
use crate::elliptic::parameter::{Parameter, Unit};
use crate::elliptic::rows::{column_of_parameter, one_of_parameter};
use crate::float::Dd;

/// K for mc > 0, as a double-double.
pub(crate) fn complete_k_dd(parameter: Parameter) -> Dd {
    let kc = parameter.unit().kc;
    if parameter.m.hi < 0.0 { kc * quarter_period(kc) } else { quarter_period(kc) }
}

/// E for mc > 0, as a double-double.
pub(crate) fn complete_e_dd(parameter: Parameter) -> Dd {
    let Unit { mc, kc, .. } = parameter.unit();
    if mc.hi < 1e-200 {
        // E - 1 is of the order of mc ln mc.
        return if parameter.m.hi < 0.0 { Dd::ONE / kc } else { Dd::ONE };
    }
    let sum = rd(Dd::ZERO, mc, Dd::ONE) + rd(Dd::ZERO, Dd::ONE, mc);
    let inner = mc * sum * THIRD;
    if parameter.m.hi < 0.0 { inner / kc } else { inner }
}

/// E - mc K = m int_0^K cn^2 for 0 <= m <= 1, whose terms cancel: m mc R_D(0, 1, mc)/3 has none.
pub(crate) fn complete_difference_dd(Parameter { m, mc, .. }: Parameter) -> Dd {
    if mc.hi < 1e-200 { Dd::ONE } else { m * (mc * rd(Dd::ZERO, Dd::ONE, mc)) * THIRD }
}

/// K(m) = int_0^(pi/2) dphi / sqrt(1 - m sin^2 phi).
///
/// | argument | domain |
/// |---|---|
/// | `parameter` | m < 1; inf at m = 1, NaN above |
///
/// **Error** at most 3 ulp.
///
/// **Source** DLMF 19.2.8, 19.8.5.
///
/// ```
/// use libration::{Parameter, complete_k};
/// assert_eq!(format!("{:.12}", complete_k(Parameter::from_m(0.5))), "1.854074677301");
/// ```
#[must_use]
pub fn complete_k(parameter: Parameter) -> f64 {
    one_of_parameter(&CompleteK, [], parameter, careful_k)
}

/// K of a column of parameters.
///
/// **Error**, domain and source of [`complete_k`], value by value the same. Panics where the lengths differ.
///
/// ```
/// use libration::elliptic::{Given, complete_k_into};
/// let mut k = [0.0; 2];
/// complete_k_into(Given::Mc, &[0.5, 1e-20], &mut k);
/// assert_eq!(format!("{:.10} {:.10}", k[0], k[1]), "1.8540746773 24.4121452911");
/// ```
pub fn complete_k_into(given: Given, parameters: &[f64], k: &mut [f64]) {
    column_of_parameter(&CompleteK, [], (given, parameters), k, careful_k);
}

fn careful_k([]: [f64; 0], parameter: Parameter) -> f64 {
    match parameter.mc.hi {
        mc if mc > 0.0 => complete_k_dd(parameter).value(),
        0.0 => f64::INFINITY,
        _ => f64::NAN,
    }
}

/// E(m) = int_0^(pi/2) sqrt(1 - m sin^2 phi) dphi.
///
/// | argument | domain |
/// |---|---|
/// | `parameter` | m <= 1, else NaN |
///
/// **Error** at most 3 ulp.
///
/// **Source** DLMF 19.2.8, 19.7.5, 19.25.1.
///
/// ```
/// use libration::{Parameter, complete_e};
/// assert_eq!(format!("{:.12}", complete_e(Parameter::from_m(0.5))), "1.350643881048");
/// ```
#[must_use]
pub fn complete_e(parameter: Parameter) -> f64 {
    one_of_parameter(&CompleteE, [], parameter, careful_e)
}

/// E of a column of parameters.
///
/// **Error**, domain and source of [`complete_e`], value by value the same. Panics where the lengths differ.
pub fn complete_e_into(given: Given, parameters: &[f64], e: &mut [f64]) {
    column_of_parameter(&CompleteE, [], (given, parameters), e, careful_e);
}

fn careful_e([]: [f64; 0], parameter: Parameter) -> f64 {
    match parameter.mc.hi {
        mc if mc > 0.0 => complete_e_dd(parameter).value(),
        0.0 => 1.0,
        _ => f64::NAN,
    }
}

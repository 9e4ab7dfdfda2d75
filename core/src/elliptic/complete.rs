//! The complete integrals K and E of any real m <= 1.
//!
//! K by the arithmetic-geometric mean; E by Carlson's R_D in the form whose terms are all positive, DLMF
//! 19.25.1. For m < 0 both follow from -m/(1 - m), DLMF 19.7.5.

use super::agm::quarter_period;
use super::carlson::rd;
use super::parameter::Parameter;
use crate::float::Dd;

/// K for mc > 0, as a double-double.
pub(crate) fn complete_k_dd(parameter: Parameter) -> Dd {
    if parameter.m.hi < 0.0 {
        let inner = parameter.imaginary_modulus();
        let kc = inner.mc.sqrt();
        return kc * quarter_period(kc);
    }
    quarter_period(parameter.mc.sqrt())
}

/// E for mc > 0, as a double-double.
pub(crate) fn complete_e_dd(parameter: Parameter) -> Dd {
    if parameter.m.hi < 0.0 {
        let inner = parameter.imaginary_modulus();
        return complete_e_dd(inner) / inner.mc.sqrt();
    }
    let mc = parameter.mc;
    mc * (rd(Dd::ZERO, mc, Dd::ONE) + rd(Dd::ZERO, Dd::ONE, mc)) / Dd::from(3.0)
}

/// K(m) = int_0^(pi/2) dphi / sqrt(1 - m sin^2 phi); inf at m = 1, NaN for m > 1.
///
/// **Error** at most 3 ulp.
pub fn complete_k(parameter: Parameter) -> f64 {
    match parameter.mc.hi {
        mc if mc > 0.0 => complete_k_dd(parameter).value(),
        0.0 => f64::INFINITY,
        _ => f64::NAN,
    }
}

/// E(m) = int_0^(pi/2) sqrt(1 - m sin^2 phi) dphi; 1 at m = 1, NaN for m > 1.
///
/// **Error** at most 3 ulp.
pub fn complete_e(parameter: Parameter) -> f64 {
    match parameter.mc.hi {
        mc if mc > 0.0 => complete_e_dd(parameter).value(),
        0.0 => 1.0,
        _ => f64::NAN,
    }
}

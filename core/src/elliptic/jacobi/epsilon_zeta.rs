//! Jacobi's epsilon and zeta functions of any real u.
//!
//! Method: u = 2 n K + r, reduced in double-double; sn, cn, dn of r to 2^-60, and then
//!   epsilon = 2 n E + E(am r), by the R_F and R_D whose terms are all positive for the given m,
//!   zeta = m/(3 K) sn cn dn R_J(0, mc, 1, dn^2), one product: nothing is subtracted from epsilon.
//! Source: DLMF 22.16.17, 22.16.20, 22.16.32, 19.25.9 to 19.25.11; Carlson, Numer. Math. 33 (1979) 1.

use super::functions::{Jacobi, NevilleValues};
use super::inverse::real_quarter;
use crate::elliptic::integrals::carlson::rj;
use crate::elliptic::integrals::complete::{complete_e_dd, complete_k_dd};
use crate::elliptic::integrals::incomplete::second_kind;
use crate::elliptic::parameter::Parameter;
use crate::float::Scaled;

/// Epsilon and zeta of one parameter, set up once.
///
/// ```
/// use libration::{Parameter, SecondKind};
/// let second = SecondKind::new(Parameter::from_m(0.5));
/// assert_eq!(format!("{:.12} {:.12}", second.epsilon(1.0), second.zeta(1.0)), "0.872275277021 0.143801986499");
/// ```
#[derive(Clone, Debug)]
pub struct SecondKind {
    jacobi: Jacobi,
    m: Scaled,
    mc: Scaled,
    /// Half the real period of dn, and epsilon there.
    quarter: Scaled,
    second: Scaled,
}

impl SecondKind {
    /// Sets up one parameter.
    #[must_use]
    pub fn new(parameter: Parameter) -> SecondKind {
        let (m, mc) = (Scaled::from(parameter.m), Scaled::from(parameter.mc));
        let (quarter, second) = if mc.is_positive() {
            (complete_k_dd(parameter), Scaled::from(complete_e_dd(parameter)))
        } else {
            let unit = parameter.unit();
            let end = [unit.k.into(), unit.kc.into(), Scaled::ZERO];
            let second = if mc.is_zero() { Scaled::ONE } else { second_kind(m, mc, end) };
            (real_quarter(parameter), second)
        };
        SecondKind { jacobi: Jacobi::new(parameter), m, mc, quarter: quarter.into(), second }
    }

    /// epsilon(u | m) = int_0^u dn^2(t | m) dt, for any real m.
    ///
    /// Where u is beyond 2^100 half periods, its mean growth u E/K, which is all that counts; so at infinity its
    /// infinity, but +-1 at m = 1.
    ///
    /// **Error** at most 3 ulp (plus 2^-100 of the condition).
    ///
    /// **Source** DLMF 22.16.17, 22.16.20.
    #[must_use]
    pub fn epsilon(&self, u: f64) -> f64 {
        if u == 0.0 && !self.m.is_nan() {
            return u;
        }
        let (half_periods, NevilleValues { s, c, d, n, signs }) = self.jacobi.scaled_neville_values(u);
        let inverse = Scaled::ONE / n;
        let values = [s, c, d].map(|theta| theta * inverse);
        let rest = second_kind(self.m, self.mc, values) * (signs[0] * signs[1] * signs[2]);
        if rest.is_nan() {
            return (self.second / self.quarter * u).value();
        }
        (Scaled::from(half_periods) * self.second.shift(1) + rest).value()
    }

    /// zeta(u | m) = epsilon(u | m) - u E/K for m <= 1, of period 2K; tanh u at m = 1, NaN for m > 1.
    ///
    /// NaN where u is beyond 2^100 half periods, but +-1 for infinite u at m = 1.
    ///
    /// **Error** at most 3 ulp (plus 2^-100 of the condition), also next to the zeros.
    ///
    /// **Source** DLMF 22.16.32; Carlson, Numer. Math. 33 (1979) 1.
    #[must_use]
    pub fn zeta(&self, u: f64) -> f64 {
        if self.mc.is_negative() || self.mc.is_nan() {
            return f64::NAN;
        }
        if u == 0.0 || (self.m.is_zero() && u.is_finite()) {
            return f64::copysign(0.0, u);
        }
        let (_, NevilleValues { s, c, d, n, signs }) = self.jacobi.scaled_neville_values(u);
        if self.mc.is_zero() {
            return (s / n * signs[0]).value();
        }
        let dn = d / n;
        let product = s * c / n.square() * dn * (signs[0] * signs[1] * signs[2]);
        let integral = rj(Scaled::ZERO, self.mc, Scaled::ONE, dn.square());
        (self.m * product * integral / (self.quarter * 3.0)).value()
    }
}

//! sn, cn, dn of a complex argument x + iy, for any real m.
//!
//! Method: for a parameter m in [0, 1], with s : c : d : n = sn : cn : dn : 1 at x and s1 : c1 : d1 : n1 those at y of
//! the parameter 1 - m, Jacobi's imaginary transformation and the addition theorems give
//!   den = n^2 c1^2 + m s^2 s1^2
//!   sn = (s n d1 n1 + i c d s1 c1)/den
//!   cn = (c n c1 n1 - i s d s1 d1)/den
//!   dn = (d n c1 d1 - i m s c s1 n1)/den
//! and of their quotients, for the parameter -m/(1 - m) of a negative one,
//!   dem = d^2 c1^2 + m c^2 s1^2
//!   sd = (s d c1 n1 + i c n s1 d1)/dem
//!   cd = (c d d1 n1 - i mc s n s1 c1)/dem
//!   nd = (n d c1 d1 + i m s c s1 n1)/dem
//! Every part is one product over a sum of positive terms, so none loses a digit. For m > 1 the parameter is 1/m; cn and dn
//! change places. Source: DLMF 22.6.22, 22.8.1 to 22.8.3, 22.17.

use super::functions::{Jacobi, NevilleValues};
use crate::elliptic::parameter::{Parameter, ParameterRange, Unit};
use crate::float::Scaled;

/// sn, cn, dn of x + iy for one parameter, set up once.
///
/// ```
/// use libration::{JacobiComplex, Parameter};
/// let sn = JacobiComplex::new(Parameter::from_m(0.5)).values(0.5, 0.5).sn;
/// assert_eq!(format!("{:.12} {:.12}", sn.re, sn.im), "0.552843250984 0.430329864836");
/// ```
#[derive(Clone, Debug)]
pub struct JacobiComplex {
    real: Jacobi,
    imaginary: Jacobi,
    m: Scaled,
    mc: Scaled,
    argument_factor: Scaled,
    range: ParameterRange,
}

/// A complex number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Complex {
    /// The real part.
    pub re: f64,
    /// The imaginary part.
    pub im: f64,
}

/// The values of Jacobi's functions at one complex u.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct JacobiComplexValues {
    /// sn(u | m)
    pub sn: Complex,
    /// cn(u | m)
    pub cn: Complex,
    /// dn(u | m)
    pub dn: Complex,
}

impl JacobiComplex {
    /// Sets up one parameter.
    #[must_use]
    pub fn new(parameter: Parameter) -> JacobiComplex {
        let factor = parameter.argument_factor();
        let unit = parameter.unit();
        let complement = Unit { m: unit.mc, mc: unit.m, k: unit.kc, kc: unit.k };
        JacobiComplex {
            real: Jacobi::of_unit(unit, factor),
            imaginary: Jacobi::of_unit(complement, factor),
            m: Scaled::from(unit.k).square(),
            mc: Scaled::from(unit.kc).square(),
            argument_factor: factor.into(),
            range: parameter.range(),
        }
    }

    /// sn, cn, dn at re + i im.
    ///
    /// | argument | domain |
    /// |---|---|
    /// | `re`, `im` | finite, up to 2^100 half periods, else NaN |
    ///
    /// An exact pole gives inf in the real part and NaN in the imaginary part.
    ///
    /// **Error** of each part at most 3 ulp (plus 2^-100 of the condition in re and im).
    ///
    /// **Source** DLMF 22.6.22, 22.8.1 to 22.8.3, 22.17.
    #[must_use]
    pub fn values(&self, re: f64, im: f64) -> JacobiComplexValues {
        if !re.is_finite() || !im.is_finite() {
            let nan = Complex { re: f64::NAN, im: f64::NAN };
            return JacobiComplexValues { sn: nan, cn: nan, dn: nan };
        }
        let [sn, cn, dn] = self.parts(re, im);
        JacobiComplexValues { sn, cn, dn }
    }

    /// sn, cn and dn.
    fn parts(&self, re: f64, im: f64) -> [Complex; 3] {
        let (_, NevilleValues { s, c, d, n, signs }) = self.real.scaled_neville_values(re);
        let (s, c, d) = (s * signs[0], c * signs[1], d * signs[2]);
        let (_, NevilleValues { s: s1, c: c1, d: d1, n: n1, signs }) =
            self.imaginary.scaled_neville_values(im);
        let (s1, c1, d1) = (s1 * signs[0], c1 * signs[1], d1 * signs[2]);
        let (m, mc) = (self.m, self.mc);
        let (ss1, cs1) = (s * s1, c * s1);
        let (dc1, n_c1) = (d * c1, n * c1);
        if self.range == ParameterRange::Negative {
            let below = dc1.square() + m * cs1.square();
            let sd = [s * dc1 * n1, cs1 * n * d1].map(|part| part / self.argument_factor);
            let cd = [c * d * d1 * n1, -(mc * ss1 * n_c1)];
            let nd = [n * dc1 * d1, m * s * cs1 * n1];
            return [sd, cd, nd].map(|parts| over(parts, below));
        }
        let below = n_c1.square() + m * ss1.square();
        let sn = [s * n * d1 * n1, cs1 * dc1];
        let cn = [c * n_c1 * n1, -(ss1 * d * d1)];
        let dn = [dc1 * n * d1, -(m * c * ss1 * n1)];
        if self.range == ParameterRange::AboveOne {
            let sn = sn.map(|part| part / self.argument_factor);
            return [sn, dn, cn].map(|parts| over(parts, below));
        }
        [sn, cn, dn].map(|parts| over(parts, below))
    }
}

fn over(parts: [Scaled; 2], below: Scaled) -> Complex {
    if below.is_zero() {
        return Complex { re: f64::INFINITY, im: f64::NAN };
    }
    let [re, im] = parts.map(|part| (part / below).value());
    Complex { re, im }
}

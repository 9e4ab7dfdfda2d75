//! Jacobi's twelve functions of a complex argument x + iy, for any real m.
//!
//! Method: for a parameter m in [0, 1], with s : c : d : n = sn : cn : dn : 1 at x and s1 : c1 : d1 : n1 those at y of
//! the parameter mc = 1 - m, Jacobi's imaginary transformation and the addition theorems give pq over
//!   N = n^2 c1^2 + m s^2 s1^2,  D = d^2 c1^2 + m c^2 s1^2,  C = c^2 c1^2 + d^2 s1^2,  S = s^2 c1^2 + n^2 s1^2,
//! the letter of q:
//!   sn = (s n d1 n1 + i c d s1 c1)/N   cn = (c n c1 n1 - i s d s1 d1)/N   dn = (d n c1 d1 - i m s c s1 n1)/N
//!   sd = (s d c1 n1 + i c n s1 d1)/D   cd = (c d d1 n1 - i mc s n s1 c1)/D   nd = (n d c1 d1 + i m s c s1 n1)/D
//!   sc = (s c c1 d1 + i d n s1 n1)/C   dc = (c d d1 n1 + i mc s n s1 c1)/C   nc = (c n c1 n1 + i s d s1 d1)/C
//!   ns = (s n d1 n1 - i c d s1 c1)/S   ds = (s d c1 n1 - i c n s1 d1)/S   cs = (s c c1 d1 - i d n s1 n1)/S:
//! the last two lines are the first two a quarter period on, DLMF 22.4.3, and pq and qp are conjugate over their
//! denominators. Every part is one product over a sum of positive terms, so none loses a digit. For m < 0 the parameter is
//! -m/(1 - m), and d and n change places; for m > 1 it is 1/m, and c and d do. Source: DLMF 22.6.22, 22.8.1 to 22.8.3, 22.17.

use super::functions::{Jacobi, NevilleIndex, NevilleValues};
use super::glaisher::Glaisher;
use crate::elliptic::parameter::{Parameter, ParameterRange, Unit};
use crate::float::Scaled;

/// Jacobi's functions of x + iy for one parameter, set up once.
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
        let at = self.products(re, im);
        let [sn, cn, dn] = [Glaisher::Sn, Glaisher::Cn, Glaisher::Dn].map(|which| self.quotient(which, &at));
        JacobiComplexValues { sn, cn, dn }
    }

    /// pq(re + i im) for p, q among s, c, d, n.
    ///
    /// | argument | domain |
    /// |---|---|
    /// | `which` | the function |
    /// | `re`, `im` | finite, up to 2^100 half periods, else NaN |
    ///
    /// An exact pole gives inf in the real part and NaN in the imaginary part.
    ///
    /// **Error** of each part at most 3 ulp (plus 2^-100 of the condition in re and im).
    ///
    /// **Source** DLMF 22.6.22, 22.8.1 to 22.8.3, 22.17.
    ///
    /// ```
    /// use libration::{Glaisher, JacobiComplex, Parameter};
    /// let sc = JacobiComplex::new(Parameter::from_m(0.5)).glaisher(Glaisher::Sc, 0.5, 0.5);
    /// assert_eq!(format!("{:.12} {:.12}", sc.re, sc.im), "0.430329864836 0.552843250984");
    /// ```
    #[must_use]
    pub fn glaisher(&self, which: Glaisher, re: f64, im: f64) -> Complex {
        if !re.is_finite() || !im.is_finite() {
            return Complex { re: f64::NAN, im: f64::NAN };
        }
        self.quotient(which, &self.products(re, im))
    }

    /// The theta functions of both parts, and their products that more than one formula takes.
    fn products(&self, re: f64, im: f64) -> Products {
        let (_, NevilleValues { s, c, d, n, signs }) = self.real.scaled_neville_values(re);
        let (s, c, d) = (s * signs[0], c * signs[1], d * signs[2]);
        let (_, NevilleValues { s: s1, c: c1, d: d1, n: n1, signs }) =
            self.imaginary.scaled_neville_values(im);
        let (s1, c1, d1) = (s1 * signs[0], c1 * signs[1], d1 * signs[2]);
        Products { real: [s, c, d, n], imaginary: [s1, c1, d1, n1] }
    }

    /// One function of the parameter that was given.
    fn quotient(&self, which: Glaisher, at: &Products) -> Complex {
        use NevilleIndex::{C, D, N, S};
        // The letters of the function of the parameter in [0, 1].
        let carried = |index| match (self.range, index) {
            (ParameterRange::Negative, D) => N,
            (ParameterRange::Negative, N) => D,
            (ParameterRange::AboveOne, C) => D,
            (ParameterRange::AboveOne, D) => C,
            (_, index) => index,
        };
        let pq = which.pq();
        let ([re, im], below) = self.of_unit(pq.map(carried), at);
        let parts = [re, im].map(|part| match pq {
            [S, _] => part / self.argument_factor,
            [_, S] => part * self.argument_factor,
            _ => part,
        });
        over(parts, below)
    }

    /// Numerator and denominator of one function of the parameter in [0, 1].
    fn of_unit(&self, [p, q]: [NevilleIndex; 2], at: &Products) -> ([Scaled; 2], Scaled) {
        use NevilleIndex::{C, D, N, S};
        let Products { real: [s, c, d, n], imaginary: [s1, c1, d1, n1] } = *at;
        let (m, mc) = (self.m, self.mc);
        let [re, im] = match [p, q] {
            [S, N] | [N, S] => [s * n * d1 * n1, c * s1 * (d * c1)],
            [C, N] | [N, C] => [c * (n * c1) * n1, -(s * s1 * d * d1)],
            [D, N] | [N, D] => [d * c1 * n * d1, -(m * c * (s * s1) * n1)],
            [S, D] | [D, S] => [s * (d * c1) * n1, c * s1 * n * d1],
            [C, D] | [D, C] => [c * d * d1 * n1, -(mc * (s * s1) * (n * c1))],
            _ => [s * c * c1 * d1, d * n * s1 * n1],
        };
        // Of the two conjugate functions the first named is the one of the formula.
        let inverse = matches!([p, q], [N, _] | [D | C, S] | [D, C]);
        let below = match q {
            N => (n * c1).square() + m * (s * s1).square(),
            D => (d * c1).square() + m * (c * s1).square(),
            C => (c * c1).square() + (d * s1).square(),
            S => (s * c1).square() + (n * s1).square(),
        };
        ([re, if inverse { -im } else { im }], below)
    }
}

/// s, c, d, n of the real part, and of the imaginary part for the complementary parameter, with their signs.
struct Products {
    real: [Scaled; 4],
    imaginary: [Scaled; 4],
}

fn over(parts: [Scaled; 2], below: Scaled) -> Complex {
    if below.is_zero() {
        return Complex { re: f64::INFINITY, im: f64::NAN };
    }
    let [re, im] = parts.map(|part| (part / below).value());
    Complex { re, im }
}

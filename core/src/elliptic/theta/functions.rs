//! Jacobi's theta functions theta_1 ... theta_4 of real z and real nome q.
//!
//! Method: z = n pi + r, reduced in triple-double. For q <= e^-pi the series in q, as polynomials in sin^2 r; above, Jacobi's
//! imaginary transformation: with t = -ln q/pi and q' = e^(-pi/t) <= e^-pi
//!   theta_3 = t^(-1/2) sum exp(-(r - j pi)^2/(pi t)),
//!   theta_1 = t^(-1/2) sum (-1)^j exp(-(r - (j + 1/2) pi)^2/(pi t)) = t^(-1/2) exp(-(pi/2 - r)^2/(pi t)) (1 - e^(-2r/t)) (1 - ...),
//! and theta_2, theta_4 are theta_1, theta_3 at pi/2 - r, whose digits the reduction keeps. The leads are double-double.
//! Source: DLMF 20.2(i), 20.7.30 to 20.7.33; Whittaker & Watson 21.51.

use crate::elliptic::amplitude::{ReducedAmplitude, sines};
use crate::elliptic::nome::{minus_log_nome, small_nome};
use crate::elliptic::parameter::Parameter;
use crate::float::series::long_sinh_cosh;
use crate::float::{Dd, HALF_PI, PI, Scaled, Td};

/// Below, the nome is m/16 to a double-double.
const TINY_PARAMETER: f64 = 1e-200;
/// Where the two series take the same number of terms.
const SMALL: f64 = 0.0432;

/// Which of Jacobi's theta functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ThetaFunction {
    /// theta_1(z, q), odd.
    One,
    /// theta_2(z, q) = theta_1(z + pi/2, q).
    Two,
    /// theta_3(z, q).
    Three,
    /// theta_4(z, q) = theta_3(z + pi/2, q).
    Four,
}

impl ThetaFunction {
    /// All of them, in order.
    pub const ALL: [ThetaFunction; 4] =
        [ThetaFunction::One, ThetaFunction::Two, ThetaFunction::Three, ThetaFunction::Four];
}

/// The four functions of one nome, set up once.
///
/// ```
/// use libration::{Theta, ThetaFunction};
/// let theta = Theta::from_nome(0.1);
/// let values = [ThetaFunction::One, ThetaFunction::Three].map(|which| theta.value(which, 0.5));
/// assert_eq!(format!("{:.12} {:.12}", values[0], values[1]), "0.527983605456 1.107977229826");
/// ```
#[derive(Clone, Debug)]
pub struct Theta {
    expansion: Expansion,
    /// theta_3 and theta_4 change places, and the others are not real.
    negative: bool,
}

#[derive(Clone, Debug)]
enum Expansion {
    /// The series in q, with 2 q^(1/4).
    Nome {
        q: Dd,
        lead: Scaled,
    },
    /// The sum of Gaussian functions: pi t = -ln q, and t^(-1/2).
    Gaussian {
        t: Dd,
        log: Dd,
        lead: Scaled,
    },
    None,
}

impl Theta {
    /// From the nome, 0 <= q < 1; for -1 < q < 0 theta_3 and theta_4 are real.
    #[must_use]
    pub fn from_nome(q: f64) -> Theta {
        let size = q.abs();
        let expansion = if size.is_nan() || size >= 1.0 {
            Expansion::None
        } else if size <= SMALL {
            Expansion::in_nome(size.into())
        } else {
            Expansion::in_gaussians(-Dd::ln(size))
        };
        Theta { expansion, negative: q < 0.0 }
    }

    /// From the parameter m < 1 whose nome it is: negative for m < 0.
    #[must_use]
    pub fn from_parameter(parameter: Parameter) -> Theta {
        let Parameter { m, mc, .. } = parameter;
        let expansion = if mc.hi.is_nan() || mc.hi <= 0.0 {
            Expansion::None
        } else {
            let unit = parameter.unit();
            if unit.m.hi < TINY_PARAMETER {
                Expansion::in_nome(Scaled::from(unit.k).square().shift(-4))
            } else if unit.m.hi <= 0.5 {
                Expansion::in_nome(small_nome(unit.m, unit.kc).into())
            } else {
                Expansion::in_gaussians(minus_log_nome(unit.k, unit.kc))
            }
        };
        Theta { expansion, negative: m.hi < 0.0 }
    }

    /// theta_j(z, q).
    ///
    /// | argument | domain |
    /// |---|---|
    /// | `which` | the function, j = 1, 2, 3, 4 |
    /// | `z` | finite, else NaN |
    ///
    /// NaN for |q| >= 1, and for theta_1 and theta_2 of q < 0.
    ///
    /// **Error** at most 3 ulp (plus 2^-98 of the condition in z and q), also next to the zeros and where the value is
    /// next to the end of the range.
    ///
    /// **Source** DLMF 20.2.1 to 20.2.4, 20.7.30 to 20.7.33.
    #[must_use]
    pub fn value(&self, which: ThetaFunction, z: f64) -> f64 {
        use ThetaFunction::{Four, One, Three, Two};
        if !z.is_finite() {
            return f64::NAN;
        }
        let which = match (which, self.negative) {
            (One | Two, true) => return f64::NAN,
            (Three, true) => Four,
            (Four, true) => Three,
            (which, false) => which,
        };
        let ReducedAmplitude { odd, side, r, rest, .. } = ReducedAmplitude::new(z);
        let parity = if odd { -1.0 } else { 1.0 };
        // theta_2 and theta_4 are theta_1 and theta_3 at pi/2 - r.
        let (vanishing, sign, r, rest) = match which {
            One => (true, parity * side, r, rest),
            Two => (true, parity, rest, r),
            Three => (false, 1.0, r, rest),
            Four => (false, 1.0, rest, r),
        };
        let value = match &self.expansion {
            Expansion::Nome { q, lead } => {
                let sine = sine(r, rest);
                if vanishing { *lead * sine * first(*q, sine.to_dd()) } else { third(*q, sine.to_dd()) }
            }
            Expansion::Gaussian { t, log, lead } => {
                let value = if vanishing {
                    gauss_difference(*t, *log, r, rest)
                } else {
                    gauss_sum(*t, *log, r, rest)
                };
                *lead * value
            }
            Expansion::None => Scaled::NAN,
        };
        (value * sign).value()
    }
}

impl Expansion {
    fn in_nome(q: Scaled) -> Expansion {
        Expansion::Nome { q: q.to_dd(), lead: q.sqrt().sqrt().shift(1) }
    }
    fn in_gaussians(log: Dd) -> Expansion {
        let t = log / PI;
        Expansion::Gaussian { t, log, lead: Scaled::ONE / Scaled::from(t).sqrt() }
    }
}

fn sine(r: Td, rest: Td) -> Scaled {
    sines(r, rest).0.into()
}

/// theta_1/(2 q^(1/4) sin r) in sin r.
fn first(q: Dd, sine: Dd) -> Scaled {
    let (x, square) = (sine.square(), q.square());
    let (y, sixth) = (x.hi, (square * square * square).hi);
    let second = square * (x.scale(4.0) - Dd::from(3.0));
    let third = sixth * (5.0 + y * (-20.0 + y * 16.0));
    let fourth = sixth * sixth * (-7.0 + y * (56.0 + y * (-112.0 + y * 64.0)));
    (Dd::ONE + (second + Dd::from(third + fourth))).into()
}

/// theta_3 in sin r.
fn third(q: Dd, sine: Dd) -> Scaled {
    let x = sine.square();
    let (y, fourth) = (x.hi, q.square().square().hi);
    let second = (q - q * x.scale(2.0)).scale(2.0);
    let third = 2.0 * fourth * (1.0 + y * (-8.0 + y * 8.0));
    let ninth = 2.0 * fourth * fourth * q.hi * (1.0 + y * (-18.0 + y * (48.0 - y * 32.0)));
    (Dd::ONE + (second + Dd::from(third + ninth))).into()
}

/// sum exp(-(r - j pi)^2/(pi t)): the first is taken out, j = 1 may be as large, the others are below 0.05 of it.
fn gauss_sum(t: Dd, log: Dd, r: Td, rest: Td) -> Scaled {
    let (r, rest) = (r.to_dd(), rest.to_dd());
    let p = Scaled::exp(-(PI / t).scale(2.0)).value();
    let right = Scaled::exp(-(rest / t).scale(2.0));
    let left = Scaled::exp(-((HALF_PI + r) / t).scale(2.0));
    let (w, v) = (right.value(), left.value());
    let squares = w * w + v * v;
    let small = p * (squares + p * p * (w * w * w + v * v * v + p * p * p * w * w * w * w));
    Scaled::exp(-(r.square() / log)) * (Scaled::ONE + right + (left + Scaled::from(small)))
}

/// sum (-1)^j exp(-(r - (j + 1/2) pi)^2/(pi t)): the two largest by their exact difference, the others below 0.05 of
/// them.
fn gauss_difference(t: Dd, log: Dd, r: Td, rest: Td) -> Scaled {
    let (r, rest) = (r.to_dd(), rest.to_dd());
    let x = r / t;
    // 1 - e^(-2x)
    let difference = if x.hi < LINEAR {
        Scaled::from(x).shift(1)
    } else if x.hi < 1.0 {
        let (sinh, cosh) = long_sinh_cosh(x);
        Scaled::from(sinh * (cosh - sinh)).shift(1)
    } else {
        Scaled::ONE - Scaled::exp(x.scale(-2.0))
    };
    let p = Scaled::exp(-(PI / t).scale(2.0)).value();
    let a = Scaled::exp(-((PI - r) / t).scale(2.0)).value();
    let b = Scaled::exp(-((PI + r) / t).scale(2.0)).value();
    let (one, two, three) = (a + b, a * a + b * b, a * a * a + b * b * b);
    let second = p + one;
    let third = p * (p * (p + one) + two);
    let fourth = p * p * p * (p * (p * (p + one) + two) + three);
    Scaled::exp(-(rest.square() / log)) * difference * Scaled::from(Dd::sum(1.0, third - second - fourth))
}

/// Below, 1 - e^(-2x) is 2x in double.
const LINEAR: f64 = 1e-18;

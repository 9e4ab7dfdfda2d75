//! The incomplete integrals F(phi | m) and E(phi | m) for every real phi, and every real m for which the
//! integrand stays real.
//!
//! Over lanes in incomplete_lanes.rs; and for every argument, row by row, in double-doubles:
//!
//! Method: phi = n pi + r with r in triple-double. The integral up to r is the one of DLMF 19.25.5, 19.25.9 to 19.25.11 whose
//! terms are all positive for the given m. Added are 2 n K or 2 n E.

use super::carlson;
use super::carlson_duplication::THIRD;
use super::complete::{complete_e_dd, complete_k_dd};
use super::incomplete_lanes::{IncompleteE, IncompleteF};
use crate::elliptic::amplitude::{ReducedAmplitude, sines};
use crate::elliptic::given::Given;
use crate::elliptic::parameter::Parameter;
use crate::elliptic::rows::{column_of_parameter, one_of_parameter};
use crate::float::{Dd, Scaled};

/// 1 - m s^2 from mc = 1 - m and the squares of the sine s and the cosine. It subtracts only for m > 1, and then the smaller
/// terms: next to m = 1 those of c^2 + mc s^2.
pub(crate) fn delta_square(m: Scaled, mc: Scaled, sine_square: Scaled, cosine_square: Scaled) -> Scaled {
    if !mc.is_zero() && mc.power() >= 0 {
        Scaled::ONE - m * sine_square
    } else {
        cosine_square + mc * sine_square
    }
}

/// E of the reduced amplitude from s = sin r, c = cos r and d = sqrt(1 - m s^2), for any m, into the ends of the range.
pub(crate) fn second_kind(m: Scaled, mc: Scaled, [s, c, d]: [Scaled; 3]) -> Scaled {
    let (square, c2, d2) = (s.square(), c.square(), d.square());
    let third = s * square * Scaled::from(THIRD);
    if mc.is_zero() {
        s
    } else if mc.is_negative() {
        // 19.25.11
        d * s / c - mc * third * carlson::rd(d2, Scaled::ONE, c2)
    } else if m.is_positive() {
        // 19.25.10
        let first = s * carlson::rf(c2, d2, Scaled::ONE) + m * third * carlson::rd(c2, Scaled::ONE, d2);
        mc * first + m * s * c / d
    } else {
        // 19.25.9
        s * carlson::rf(c2, d2, Scaled::ONE) - m * third * carlson::rd(c2, d2, Scaled::ONE)
    }
}

/// Which of the two integrals.
#[derive(Clone, Copy, PartialEq)]
enum Integral {
    First,
    Second,
}

/// The integral from 0 to the reduced amplitude; NaN where 1 - m sin^2 is negative there.
fn reduced_integral(integral: Integral, Parameter { m, mc, .. }: Parameter, sine: Dd, cosine: Dd) -> Scaled {
    let [m, mc, s, c] = [m, mc, sine, cosine].map(Scaled::from);
    let square = delta_square(m, mc, s.square(), c.square());
    match integral {
        _ if square.is_negative() => Scaled::NAN,
        Integral::First => s * carlson::rf(c.square(), square, Scaled::ONE),
        Integral::Second => second_kind(m, mc, [s, c, square.sqrt()]),
    }
}

fn incomplete(integral: Integral, phi: f64, parameter: Parameter) -> f64 {
    let mc = parameter.mc;
    if phi == 0.0 && mc.hi.is_finite() {
        return phi;
    }
    if phi.is_nan() || mc.hi.is_nan() || (phi.is_infinite() && mc.hi < 0.0) {
        return f64::NAN;
    }
    if phi.is_infinite() {
        return phi;
    }
    let ReducedAmplitude { n, side, r, rest, .. } = ReducedAmplitude::new(phi);
    let (sine, cosine) = sines(r, rest);
    let within = reduced_integral(integral, parameter, sine, cosine).signed(side);
    if n.hi == 0.0 {
        return within.value();
    }
    let half_turn = match integral {
        _ if mc.hi < 0.0 => return f64::NAN,
        Integral::First if mc.hi == 0.0 => return f64::INFINITY.copysign(phi),
        Integral::First => complete_k_dd(parameter),
        Integral::Second if mc.hi == 0.0 => Dd::ONE,
        Integral::Second => complete_e_dd(parameter),
    };
    (Scaled::from(half_turn) * Scaled::from(n).shift(1) + within).value()
}

/// F in double-doubles, for every argument.
pub(crate) fn careful_f([phi]: [f64; 1], parameter: Parameter) -> f64 {
    incomplete(Integral::First, phi, parameter)
}

/// E likewise.
pub(crate) fn careful_e([phi]: [f64; 1], parameter: Parameter) -> f64 {
    incomplete(Integral::Second, phi, parameter)
}

/// F(phi | m) = int_0^phi dt / sqrt(1 - m sin^2 t).
///
/// | argument | domain |
/// |---|---|
/// | `phi` | any; infinite phi gives its infinity for m <= 1 |
/// | `parameter` | m sin^2 t <= 1 on the way, else NaN; at m = 1 infinite beyond pi/2 |
///
/// **Error** at most 3 ulp.
///
/// **Source** DLMF 19.2.4, 19.25.5.
///
/// ```
/// use libration::{Parameter, incomplete_f};
/// assert_eq!(format!("{:.12}", incomplete_f(1.0, Parameter::from_m(0.5))), "1.083216772845");
/// ```
#[must_use]
pub fn incomplete_f(phi: f64, parameter: Parameter) -> f64 {
    one_of_parameter(&IncompleteF, [phi], parameter, careful_f)
}

/// F of a column of amplitudes, each with a parameter of its own.
///
/// **Error**, domain and source of [`incomplete_f`], value by value the same. Panics where the lengths differ.
///
/// ```
/// use libration::elliptic::{Given, incomplete_f_into};
/// let mut f = [0.0; 2];
/// incomplete_f_into([1.0, 1.5].as_slice(), Given::M, &[0.5, 0.9], &mut f);
/// assert_eq!(format!("{:.10} {:.10}", f[0], f[1]), "1.0832167728 2.3558627384");
/// ```
pub fn incomplete_f_into(phi: &[f64], given: Given, parameters: &[f64], f: &mut [f64]) {
    column_of_parameter(&IncompleteF, [phi], (given, parameters), f, careful_f);
}

/// E(phi | m) = int_0^phi sqrt(1 - m sin^2 t) dt.
///
/// | argument | domain |
/// |---|---|
/// | `phi` | any; infinite phi gives its infinity for m <= 1 |
/// | `parameter` | m sin^2 t <= 1 on the way, else NaN |
///
/// **Error** at most 3 ulp.
///
/// **Source** DLMF 19.2.5, 19.25.9 to 19.25.11.
///
/// ```
/// use libration::{Parameter, incomplete_e};
/// assert_eq!(format!("{:.12}", incomplete_e(1.0, Parameter::from_m(0.5))), "0.927329883624");
/// ```
#[must_use]
pub fn incomplete_e(phi: f64, parameter: Parameter) -> f64 {
    one_of_parameter(&IncompleteE, [phi], parameter, careful_e)
}

/// E of a column of amplitudes, each with a parameter of its own.
///
/// **Error**, domain and source of [`incomplete_e`], value by value the same. Panics where the lengths differ.
pub fn incomplete_e_into(phi: &[f64], given: Given, parameters: &[f64], e: &mut [f64]) {
    column_of_parameter(&IncompleteE, [phi], (given, parameters), e, careful_e);
}

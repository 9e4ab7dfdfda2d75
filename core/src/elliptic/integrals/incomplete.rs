//! The incomplete integrals F(phi | m) and E(phi | m) for every real phi, and every real m for which the
//! integrand stays real.
//!
//! Method: phi = n pi + r with r reduced in triple-double, then Carlson's integrals in the one of DLMF
//! 19.25.5, 19.25.9 to 19.25.11 whose terms are all positive for the given m, plus 2 n K or 2 n E.

use super::carlson_duplication::{THIRD, rd, rf};
use super::complete::{complete_e_dd, complete_k_dd};
use crate::elliptic::parameter::Parameter;
use crate::float::{Dd, Td, angle_reduction, series};

/// phi = n pi + side * r, 0 <= r <= pi/2.
pub(crate) struct HalfTurns {
    pub n: f64,
    /// Whether n is odd, also beyond 2^53.
    pub odd: bool,
    pub side: f64,
    pub r: Td,
    /// pi/2 - r.
    pub rest: Td,
}

/// phi modulo pi, for finite phi.
pub(crate) fn half_turns(phi: f64) -> HalfTurns {
    let full = angle_reduction::reduce(phi);
    let odd = full.from_top.hi < full.from_bottom.hi;
    let (n, side, r, other) = if odd {
        (2.0 * full.turns + full.side, -full.side, full.from_top, full.from_bottom)
    } else {
        (2.0 * full.turns, full.side, full.from_bottom, full.from_top)
    };
    // pi/2 - r, half the difference of r and pi - r.
    let rest = (other - r).scale(0.5);
    HalfTurns { n, odd, side, r, rest }
}

/// Below, the sine is the angle and the cosine 1 to a double-double.
const TINY: f64 = 1e-18;

/// sin r and cos r.
pub(crate) fn sines(r: Td, rest: Td) -> (Dd, Dd) {
    if r.hi < TINY {
        return (r.to_dd(), Dd::ONE);
    }
    let (sine, cosine) = if r.hi <= rest.hi {
        series::sin_cos(r)
    } else {
        let (cosine, sine) = series::sin_cos(rest);
        (sine, cosine)
    };
    (sine.to_dd(), cosine.to_dd())
}

/// phi = n pi + side * r, with the sine and cosine of r.
pub(crate) struct ReducedAmplitude {
    pub n: f64,
    pub side: f64,
    pub sine: Dd,
    pub cosine: Dd,
}

pub(crate) fn reduce(phi: f64) -> ReducedAmplitude {
    let HalfTurns { n, side, r, rest, .. } = half_turns(phi);
    let (sine, cosine) = sines(r, rest);
    ReducedAmplitude { n, side, sine, cosine }
}

/// Which of the two integrals.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    First,
    Second,
}

/// The integral from 0 to the reduced amplitude, from c = cos^2 r and d = 1 - m sin^2 r.
fn reduced(kind: Kind, parameter: Parameter, sine: Dd, cosine: Dd, d: Dd) -> Dd {
    let Parameter { m, mc } = parameter;
    let c = cosine.square();
    if kind == Kind::First {
        return sine * rf(c, d, Dd::ONE);
    }
    if m.hi < 0.0 {
        // 19.25.9, with R_D scaled by d so that it stays in range for m to -1e300.
        let inverse = Dd::ONE / d;
        let scaled = rd(c * inverse, Dd::ONE, inverse);
        return sine * rf(c, d, Dd::ONE)
            - m * inverse * sine.square() * (sine * inverse.sqrt()) * scaled * THIRD;
    }
    if mc.hi < 0.0 {
        // 19.25.11
        let part = mc * sine.square() * sine * rd(d, Dd::ONE, c) * THIRD;
        return d.sqrt() * sine / cosine - part;
    }
    if mc.hi == 0.0 {
        return sine;
    }
    // 19.25.10
    let first = mc * rf(c, d, Dd::ONE) + m * mc * sine.square() * rd(c, Dd::ONE, d) * THIRD;
    sine * first + m * sine * cosine / d.sqrt()
}

fn incomplete(kind: Kind, phi: f64, parameter: Parameter) -> f64 {
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
    let ReducedAmplitude { n, side, sine, cosine } = reduce(phi);
    let d = cosine.square() + mc * sine.square();
    if mc.hi < 0.0 && (n != 0.0 || d.hi < 0.0) {
        return f64::NAN;
    }
    let half_turn = match kind {
        _ if n == 0.0 => Dd::ZERO,
        Kind::First if mc.hi == 0.0 => return f64::INFINITY.copysign(phi),
        Kind::First => complete_k_dd(parameter),
        Kind::Second if mc.hi == 0.0 => Dd::ONE,
        Kind::Second => complete_e_dd(parameter),
    };
    (half_turn * (2.0 * n) + reduced(kind, parameter, sine, cosine, d) * side).value()
}

/// F(phi | m) = int_0^phi dt / sqrt(1 - m sin^2 t).
///
/// Infinite phi gives its infinity for m <= 1. For m > 1 real only while m sin^2 t <= 1 on the way, NaN beyond; at m = 1 infinite beyond pi/2.
/// **Error** at most 3 ulp.
pub fn incomplete_f(phi: f64, parameter: Parameter) -> f64 {
    incomplete(Kind::First, phi, parameter)
}

/// E(phi | m) = int_0^phi sqrt(1 - m sin^2 t) dt, with the domain of [`incomplete_f`].
///
/// **Error** at most 3 ulp.
pub fn incomplete_e(phi: f64, parameter: Parameter) -> f64 {
    incomplete(Kind::Second, phi, parameter)
}

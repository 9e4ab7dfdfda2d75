//! Which formula an orbit follows, with its factors and the phase of its start.

use super::cubic_arc::drawing;
use super::cubic_limits::{separatrix, unbounded_linear};
use super::cubic_phase::{Canonical, escape_phase, half_periods, minus_ln, sign, signed};
use super::duffing::{Constants, Place};
use super::regime::Regime;
use crate::elliptic::phase::Phase;
use crate::elliptic::theta::neville::NevilleTheta;
use crate::float::exponent::ldexp;
use crate::float::scaled::Scaled;
use crate::float::{Dd, TWO_PI};
use crate::motion::samples::Drawing;

/// The quotients of theta functions that u can be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Shape {
    /// A k' sd, from the upward zero: the libration of a hardening spring, A cn.
    Cn,
    /// A sn, from the upward zero: the libration of a softening spring.
    Sn,
    /// A dn, from the outer turning point.
    Dn,
    /// A nc, from the turning point or a pole.
    Nc,
    /// A dc, likewise.
    Dc,
    /// A sc, from the zero or a pole.
    Sc,
    /// A sn dn/cn, likewise.
    SdOverC,
}

/// The motions that hyperbolic functions or none describe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Plain {
    Sech,
    Tanh,
    Csch,
    Coth,
    /// 1/y.
    Inverse,
    Cosh,
    Sinh,
    /// e^y.
    Exp,
}

/// The powers of two that the double-double factors of u and u' and the rate of the phase leave outside.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scales {
    /// Of u and of u'.
    pub u: f64,
    pub velocity: f64,
    pub time: f64,
}

/// A motion by theta functions.
#[derive(Clone, Debug)]
pub(super) struct Elliptic {
    pub shape: Shape,
    pub lattice: NevilleTheta,
    /// Half periods 2K.
    pub phase: Phase,
    /// Whether the phase counts from a pole.
    pub from_pole: bool,
    /// Factors of u and u' where the argument is counted from 0 and from K (the other way round with `from_pole`).
    pub u: [Dd; 2],
    pub velocity: [Dd; 2],
    /// For [`Shape::SdOverC`]: roots of what sn^4 takes in the velocity where dn^4 takes those in `velocity`; and the
    /// factor of both.
    pub other: [Dd; 2],
    pub slope: Dd,
    pub scales: Scales,
    /// The polynomials of the motion.
    pub drawing: Drawing,
}

/// A motion by hyperbolic functions of y = start + rate t.
#[derive(Clone, Debug)]
pub(super) struct Simple {
    pub plain: Plain,
    pub phase: Phase,
    pub u: Dd,
    pub velocity: Dd,
    pub scales: Scales,
}

#[derive(Clone, Debug)]
pub(super) enum Course {
    Still,
    /// u0 + velocity0 t.
    Straight,
    Elliptic(Box<Elliptic>),
    Simple(Simple),
}

/// All that does not depend on time.
pub(super) struct SetUp {
    pub course: Course,
    pub regime: Regime,
    pub period: Scaled,
    pub range: [Scaled; 2],
    /// Backward and forward.
    pub escapes: [Scaled; 2],
}

/// Powers of two that a double-double can carry beside its digits, and those a factor can.
pub(super) const CARRIED: i32 = 300;
const OUTSIDE: i32 = 1000;

/// The parts that a factor of two values shares: the values over 2^power, and 2^power as far as a double holds it.
pub(super) fn factors<const N: usize>(values: [Scaled; N]) -> ([Dd; N], f64) {
    let power = values.iter().filter(|value| !value.is_zero()).map(|value| value.power()).max().unwrap_or(0);
    let outside = power.clamp(-OUTSIDE, OUTSIDE);
    (values.map(|value| value.shift(-outside).to_dd()), ldexp(1.0, outside))
}

/// Rate and start of a phase, and the power of two that times take.
pub(super) fn phase(rate: Scaled, start: Scaled) -> (Phase, f64) {
    let outside = rate.power() - rate.power().clamp(-CARRIED, CARRIED);
    (Phase { rate: rate.shift(-outside).to_dd(), start: start.to_dd() }, ldexp(1.0, outside))
}

/// Where k' leaves the range of its inverse: K is ln(4/k') long before.
const LEAST: i32 = -900;

/// Of any m and 1 - m.
pub(super) fn lattice(m: Scaled, mc: Scaled) -> NevilleTheta {
    let kc = mc.sqrt();
    if kc.power() < LEAST {
        let mut limit = NevilleTheta::new(Dd::ONE, Dd::ZERO, Dd::ONE, Dd::from(ldexp(1.0, LEAST)));
        let quarter = minus_ln(kc.shift(-2));
        limit.angle = limit.angle * quarter / limit.quarter;
        (limit.quarter, limit.kc) = (quarter, kc.to_dd());
        return limit;
    }
    NevilleTheta::new(m.to_dd(), mc.to_dd(), m.sqrt().to_dd(), kc.to_dd())
}

/// Factors of u, of the velocity, and of sn^4, counted from 0 and from K; with the signs of u and of the velocity.
fn quotient_factors(canonical: &Canonical, lattice: &NevilleTheta, sides: [f64; 2]) -> [[Scaled; 2]; 3] {
    let Canonical { shape, m, mc, .. } = *canonical;
    let [a, w] = sides.map(|side| signed(canonical.amplitude, side));
    let w = w * canonical.rate;
    let t = Scaled::from(lattice.theta1_factor);
    let kc = mc.sqrt();
    let none = [Scaled::ZERO; 2];
    match shape {
        Shape::Cn => [[a * kc * t, a], [w * kc, w * t], none],
        Shape::Sn => [[a * t, a], [w, w * mc * t], none],
        Shape::Dn => [[a, a * kc], [-w * m * t, -w * m * kc * t], none],
        Shape::Nc => [[a, a / (kc * t)], [w * t, w / (kc * t.square())], none],
        Shape::Dc => [[a, a / t], [w * mc * t, w / t.square()], none],
        Shape::Sc => [[a * t, a / (kc * t)], [w, w / (kc * t.square())], none],
        Shape::SdOverC => {
            // Roots of what dn^4 and sn^4 take: the fourth powers themselves may leave the range.
            let root = m.sqrt();
            [[a * t, a / t], [Scaled::ONE, kc / t], [root * kc * t.square(), root / t]]
        }
    }
}

fn reversed<T: Copy>([a, b]: [T; 2], yes: bool) -> [T; 2] {
    if yes { [b, a] } else { [a, b] }
}

/// Lowest and highest of two values, on the side of a sign.
pub(super) fn on_side(inner: Scaled, outer: Scaled, side: f64) -> [Scaled; 2] {
    if side < 0.0 { [-outer, -inner] } else { [inner, outer] }
}

fn elliptic(c: &Constants, start: &Place, shape: Shape) -> SetUp {
    let canonical = c.canonical(shape);
    let lattice = lattice(canonical.m, canonical.mc);
    let side = match shape {
        // The canonical motion goes upwards, or is above 0.
        Shape::Cn | Shape::Sn | Shape::Sc | Shape::SdOverC => sign(start.velocity),
        Shape::Dn | Shape::Nc | Shape::Dc => sign(start.u),
    };
    let per = Scaled::from(lattice.quarter).shift(1);
    let rate = canonical.rate / per;
    let infinite = Scaled::from(f64::INFINITY);
    let mut set_up = SetUp {
        course: Course::Still,
        regime: Regime::Escape,
        period: infinite,
        range: [-infinite, infinite],
        escapes: [-infinite, infinite],
    };
    let (mut signed_rate, mut from_pole) = (rate, false);
    let from;
    let a = canonical.amplitude;
    match shape {
        Shape::Cn | Shape::Sn => {
            let canonical_start = Place { u: signed(start.u, side), ..*start };
            from = half_periods(c, &canonical, &lattice, &canonical_start);
            set_up.regime = if c.q.is_zero() { Regime::Linear } else { Regime::Libration };
            set_up.period = Scaled::from(2.0) / rate;
            set_up.range = [-a, a];
        }
        Shape::Dn => {
            from = half_periods(c, &canonical, &lattice, start);
            set_up.regime = Regime::Well;
            set_up.period = Scaled::ONE / rate;
            set_up.range = on_side(a * canonical.mc.sqrt(), a, side);
        }
        _ => {
            (from, from_pole) = escape_phase(c, &canonical, &lattice, start);
            let moving_out = sign(start.u) == sign(start.velocity) || start.velocity.is_zero();
            let rest = |whole: f64| Scaled::from(whole) - from;
            set_up.escapes = if !from_pole {
                [-(from + Scaled::from(0.5)) / rate, rest(0.5) / rate]
            } else if moving_out {
                signed_rate = -rate;
                [-rest(1.0) / rate, from / rate]
            } else {
                [-from / rate, rest(1.0) / rate]
            };
            if matches!(shape, Shape::Nc | Shape::Dc) {
                set_up.range = on_side(a, infinite, side);
            }
        }
    }
    // A phase that counts from a pole starts on the leg of the start.
    let sides = if from_pole { [sign(start.u), sign(start.velocity)] } else { [side; 2] };
    let [u, velocity, other] = quotient_factors(&canonical, &lattice, sides);
    let [u, velocity, other] = [u, velocity, other].map(|pair| reversed(pair, from_pole));
    let (u, u_scale) = factors(u);
    let slope = signed(a * canonical.rate, sides[1]);
    let (velocity, slope, velocity_scale) = if shape == Shape::SdOverC {
        let ([slope], scale) = factors([slope]);
        (velocity.map(Scaled::to_dd), slope, scale)
    } else {
        let (velocity, scale) = factors(velocity);
        (velocity, Dd::ONE, scale)
    };
    let (phase, time) = phase(signed_rate, from);
    let scales = Scales { u: u_scale, velocity: velocity_scale, time };
    let drawing = drawing(shape, &lattice, phase, from_pole, scales);
    set_up.course = Course::Elliptic(Box::new(Elliptic {
        shape,
        lattice,
        phase,
        from_pole,
        u,
        velocity,
        other: other.map(Scaled::to_dd),
        slope,
        scales,
        drawing,
    }));
    set_up
}

fn rest(c: &Constants, start: &Place) -> SetUp {
    let infinite = Scaled::from(f64::INFINITY);
    // The stiffness of small oscillations: p at 0, -2p at the equilibria of p + q u^2 = 0.
    let square = if start.u.is_zero() || c.q.is_zero() { c.p } else { -c.p.shift(1) };
    let period = if square.is_positive() { Scaled::from(TWO_PI) / square.sqrt() } else { infinite };
    SetUp {
        course: Course::Still,
        regime: Regime::Rest,
        period,
        range: [start.u; 2],
        escapes: [-infinite, infinite],
    }
}

/// The regime by exact signs, and the formula it asks for.
pub(super) fn course(c: &Constants, start: &Place) -> SetUp {
    let Place { u, velocity, stiffness, .. } = *start;
    if velocity.is_zero() && (u.is_zero() || stiffness.is_zero()) {
        return rest(c, start);
    }
    if c.q.is_zero() {
        return if c.p.is_positive() { elliptic(c, start, Shape::Sn) } else { unbounded_linear(c, start) };
    }
    if c.q.is_positive() {
        return if c.energy.is_positive() {
            elliptic(c, start, Shape::Cn)
        } else if c.energy.is_zero() {
            separatrix(c, start, Regime::Homoclinic)
        } else {
            elliptic(c, start, Shape::Dn)
        };
    }
    if c.delta.is_negative() {
        return elliptic(c, start, Shape::SdOverC);
    }
    if c.p.is_positive() && stiffness.is_positive() {
        return if c.delta.is_zero() {
            separatrix(c, start, Regime::Heteroclinic)
        } else {
            elliptic(c, start, Shape::Sn)
        };
    }
    let on_top = c.p.is_positive() && c.delta.is_zero();
    if on_top || c.energy.is_zero() && !c.p.is_positive() {
        return separatrix(c, start, Regime::Escape);
    }
    if c.energy.is_negative() {
        elliptic(c, start, Shape::Nc)
    } else if c.p.is_positive() {
        elliptic(c, start, Shape::Dc)
    } else {
        elliptic(c, start, Shape::Sc)
    }
}

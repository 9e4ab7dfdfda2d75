//! The courses without theta functions: separatrices, what escapes from them, and the linear oscillator that escapes.

use super::cubic_course::{Course, Plain, Scales, SetUp, Simple, factors, on_side, phase};
use super::cubic_phase::{artanh, sign, signed};
use super::duffing::{Constants, Place};
use super::regime::Regime;
use crate::float::scaled::Scaled;

/// A motion by hyperbolic functions: amplitude with its sign, rate with its sign, phase of the start.
fn simple(plain: Plain, amplitude: Scaled, rate: Scaled, from: Scaled) -> Course {
    let ([u], u_scale) = factors([amplitude]);
    let ([velocity], velocity_scale) = factors([amplitude * rate]);
    let (phase, time) = phase(rate, from);
    Course::Simple(Simple {
        plain,
        phase,
        u,
        velocity,
        scales: Scales { u: u_scale, velocity: velocity_scale, time },
    })
}

pub(super) fn separatrix(c: &Constants, start: &Place, regime: Regime) -> SetUp {
    let infinite = Scaled::from(f64::INFINITY);
    let (u, velocity) = (start.u, start.velocity);
    let mut set_up = SetUp {
        course: Course::Still,
        regime,
        period: infinite,
        range: [Scaled::ZERO; 2],
        escapes: [-infinite, infinite],
    };
    let side = sign(u);
    let inwards = sign(u) != sign(velocity);
    match regime {
        Regime::Homoclinic => {
            let rate = (-c.p).sqrt();
            let a = (-c.p.shift(1) / c.q).sqrt();
            let tanh = velocity.abs() / (rate * u.abs());
            // Falling from the top before 0, after it.
            let from = signed(artanh(tanh, u.abs() / a), if inwards { 1.0 } else { -1.0 });
            set_up.course = simple(Plain::Sech, signed(a, side), rate, from);
            set_up.range = on_side(Scaled::ZERO, a, side);
        }
        Regime::Heteroclinic => {
            let rate = c.p.shift(-1).sqrt();
            let a = (c.p / c.q.abs()).sqrt();
            let way = sign(velocity);
            let from = signed(artanh(u.abs() / a, (start.stiffness / c.p).sqrt()), way * side);
            set_up.course = simple(Plain::Tanh, signed(a, way), rate, from);
            set_up.range = [-a, a];
        }
        _ => {
            // The pole is the one that the motion comes from or goes to; it reaches the equilibrium on the other way.
            let time = c.until_pole(start);
            let (plain, rate, a) = if c.p.is_negative() {
                let rate = (-c.p).sqrt();
                (Plain::Csch, rate, (-c.p.shift(1) / c.q.abs()).sqrt())
            } else if c.p.is_positive() {
                (Plain::Coth, c.p.shift(-1).sqrt(), (c.p / c.q.abs()).sqrt())
            } else {
                (Plain::Inverse, Scaled::ONE / time, (Scaled::ONE.shift(1) / c.q.abs()).sqrt() / time)
            };
            let away = if inwards { 1.0 } else { -1.0 };
            set_up.course = simple(plain, signed(a, side), signed(rate, away), rate * time);
            set_up.escapes = if inwards { [-time, infinite] } else { [-infinite, time] };
            let inner = if plain == Plain::Coth { a } else { Scaled::ZERO };
            set_up.range = on_side(inner, infinite, side);
        }
    }
    set_up
}

/// q = 0 and p < 0, or no force at all.
pub(super) fn unbounded_linear(c: &Constants, start: &Place) -> SetUp {
    let infinite = Scaled::from(f64::INFINITY);
    let (u, velocity) = (start.u, start.velocity);
    let mut set_up = SetUp {
        course: Course::Straight,
        regime: Regime::Linear,
        period: infinite,
        range: [-infinite, infinite],
        escapes: [-infinite, infinite],
    };
    if c.p.is_zero() {
        return set_up;
    }
    let rate = (-c.p).sqrt();
    let a = (c.energy.abs().shift(-1) / c.p.abs()).sqrt();
    let along = sign(u) * sign(velocity);
    let speed = velocity.abs() / rate;
    if c.energy.is_zero() {
        set_up.course = simple(Plain::Exp, u, signed(rate, along), Scaled::ZERO);
        set_up.range = on_side(Scaled::ZERO, infinite, sign(u));
    } else if c.energy.is_negative() {
        // u = A cosh y: tanh y = u'/(w u), 1/cosh y = A/u.
        let from = artanh(speed / u.abs(), a / u.abs());
        set_up.course = simple(Plain::Cosh, signed(a, sign(u)), rate, signed(from, along));
        set_up.range = on_side(a, infinite, sign(u));
    } else {
        let from = artanh(u.abs() / speed, a / speed);
        set_up.course = simple(Plain::Sinh, signed(a, sign(velocity)), rate, signed(from, along));
    }
    set_up
}

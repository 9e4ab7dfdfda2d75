//! An initial state, formed without cancellation: what decides the regime and the period.
//!
//! With theta0 = 2 pi n + r, |r| <= pi, and the sign of the velocity taken out,
//!   s = sin(r/2), c = cos(r/2), x = |velocity0|/(2 omega0), m = s^2 + x^2, 1 - m = (c - x)(c + x).
//! All in triple-double, c from the distance to the top, and 1 - x^2 exactly where it decides. Where m and 1 - m are given
//! (energy_ratio.rs), x^2 is m - s^2 near the bottom and c^2 - (1 - m) near the top.
//! Source: Salas 2019 (23); docs/decisions/0001.

use super::energy_ratio::EnergyRatio;
use super::frequency::Frequency;
use super::half_angle::{half_angle, scaled};
use super::regime::Regime;
use super::start::Placed;
use crate::elliptic::parameter::Unit;
use crate::float::angle_reduction::ReducedAngle;
use crate::float::elementary::arctangent;
use crate::float::exponent::{exponent, ldexp, mantissa};
use crate::float::triple_double::exact_sum;
use crate::float::{Dd, Td};
use crate::lanes::Lane;

/// Where the motion is counted from: theta = base + pi half_turn + side * (canonical angle).
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// 2 pi turns.
    pub base: Dd,
    /// Whole turns nearest to the start.
    pub turns: Dd,
    /// Its half turn: 0, or +1 or -1 when the pendulum hangs from the other side.
    pub half_turn: f64,
    /// Direction in which the canonical motion goes upwards through 0: the sign of the velocity.
    pub side: f64,
}

impl Frame {
    /// Of a motion that is counted from its start.
    pub fn of_start(theta0: f64) -> Frame {
        Frame { base: Dd::from(theta0), turns: Dd::ZERO, half_turn: 0.0, side: 1.0 }
    }

    /// Whether the canonical angle is not the angle itself, but for its side.
    #[inline(always)]
    pub fn shifted(&self) -> bool {
        self.base.hi != 0.0 || self.half_turn != 0.0
    }
}

/// The canonical state, in units of omega0 = 1.
#[derive(Clone, Copy, Debug)]
pub struct State {
    /// Regime.
    pub regime: Regime,
    /// Frame of the canonical angle.
    pub frame: Frame,
    /// sin(r/2) / 2^power, signed so that the velocity is >= 0.
    pub s: Dd,
    /// cos(r/2) >= 0.
    pub c: Dd,
    /// velocity/(2 omega0) / 2^power >= 0.
    pub x: Dd,
    /// kappa = sqrt(m) / 2^power.
    pub k: Dd,
    /// m / 4^power.
    pub m: Dd,
    /// Power of two taken out of s, x and k: not 0 only for tiny amplitudes.
    pub power: i32,
    /// 1 - m (negative in rotation).
    pub mc: Dd,
    /// sqrt(|1 - m|), also where its square is below the range.
    pub kc: Dd,
    /// omega0 / 2^omega_power.
    pub omega: Dd,
    /// Power of two of omega0.
    pub omega_power: i32,
    /// m / 4^power and 1 - m where they were given.
    pub given: Option<[Td; 2]>,
}

/// x above 2^100: the force changes no digit.
const FAST: i32 = 100;

impl State {
    /// From finite theta and velocity. `None` where the force shapes no motion: at rest at the stable equilibrium,
    /// without a force, and for a velocity 2^100 times what the force could change.
    pub fn new(theta: f64, velocity: f64, frequency: Frequency) -> Option<State> {
        State::with_velocity(&Placed::new(theta), velocity, frequency)
    }

    /// From an angle and a finite velocity, as [`State::new`].
    pub(super) fn with_velocity(placed: &Placed, velocity: f64, frequency: Frequency) -> Option<State> {
        let (omega, omega_power) = frequency.root()?;
        let Placed { ref reduced, base, .. } = *placed;
        let x_power = if velocity == 0.0 { i32::MIN / 2 } else { exponent(velocity) - 1 - omega_power };
        if x_power > FAST {
            return None;
        }
        let upside_down = frequency.upside_down();
        let (sine, cosine, power) = half_angle(reduced, upside_down, x_power);
        let x = if velocity == 0.0 {
            Td::ZERO
        } else {
            let mantissa = Td::from(mantissa(velocity)) / omega;
            let shift = x_power - power;
            let least = f64::from_bits(1); // a velocity at the very top is never none
            Td::new(
                ldexp(mantissa.hi, shift).max(least),
                ldexp(mantissa.mid, shift),
                ldexp(mantissa.lo, shift),
            )
        };
        if sine.hi == 0.0 && x.hi == 0.0 {
            return None;
        }
        let (regime, mc, kc) = complement(velocity, frequency, x_power, sine, cosine, x, power);
        let side = if velocity < 0.0 { -1.0 } else { 1.0 };
        let start_side = if upside_down { -reduced.side } else { reduced.side };
        let s = sine.to_dd() * (side * start_side);
        let m = (sine.square() + x.square()).to_dd();
        Some(State {
            regime,
            frame: frame(base, reduced, upside_down, side),
            s,
            c: cosine.to_dd(),
            x: x.to_dd(),
            k: m.sqrt(),
            m,
            power,
            mc,
            kc,
            omega: omega.to_dd(),
            omega_power,
            given: None,
        })
    }

    /// From an angle and an energy above 0 and below 4^100 of that of the top, under a force. `Err` where the energy does
    /// not reach the angle. A turning angle may be given as it rounds to a double.
    pub(super) fn with_energy(
        placed: &Placed,
        energy: &EnergyRatio,
        direction: f64,
        frequency: Frequency,
    ) -> Result<State, f64> {
        let (omega, omega_power) = frequency.root().unwrap_or((Td::ONE, 0));
        let EnergyRatio { regime, mc, kc, power: own_power, .. } = *energy;
        let Placed { ref reduced, base, .. } = *placed;
        let upside_down = frequency.upside_down();
        let (sine, cosine, power) = half_angle(reduced, upside_down, own_power);
        let shift = own_power - power;
        let m = scaled(energy.m, 2 * shift);
        let k = scaled(energy.root(), shift);
        // The difference of the smaller terms; both are right to triple-double.
        let square = if power != 0 || sine.hi < 0.7 { m - sine.square() } else { cosine.square() - mc };
        let start_side = if upside_down { -reduced.side } else { reduced.side };
        let sign = direction * start_side;
        let (s, c, x) = if square.hi >= 0.0 {
            (sine.to_dd() * sign, cosine.to_dd(), square.sqrt().to_dd())
        } else {
            let theta_max = turning_angle(k.to_dd().ldexp(power), kc);
            let distance = if upside_down { reduced.from_top } else { reduced.from_bottom };
            if regime == Regime::Rotation || distance.to_dd().value() != theta_max {
                return Err(theta_max);
            }
            (k.to_dd() * sign, kc, Dd::ZERO)
        };
        Ok(State {
            regime,
            frame: frame(base, reduced, upside_down, direction),
            s,
            c,
            x,
            k: k.to_dd(),
            m: m.to_dd(),
            power,
            mc: mc.to_dd(),
            kc,
            omega: omega.to_dd(),
            omega_power,
            given: Some([m, mc]),
        })
    }
}

/// The turning angle of a libration, rounded.
pub(super) fn turning_angle(kappa: Dd, kc: Dd) -> f64 {
    ldexp(arctangent(kappa, kc).value(), 1)
}

impl State {
    /// The parameter of the theta functions: kappa^2 in libration, 1/kappa^2 in rotation.
    pub(crate) fn unit(&self) -> Unit {
        let State { regime, k, kc, m, mc, power, .. } = *self;
        if regime == Regime::Rotation {
            Unit { m: Dd::ONE / m, mc: -mc / m, k: Dd::ONE / k, kc: kc / k }
        } else {
            Unit { m: m.ldexp(2 * power), mc, k: k.ldexp(power), kc }
        }
    }

    /// sn, cn, dn of that parameter at the phase of the start, counted from the bottom.
    pub(super) fn jacobi(&self) -> [Dd; 3] {
        let State { regime, s, c, x, k, .. } = *self;
        if regime == Regime::Rotation { [s, c, x / k] } else { [s / k, x / k, c] }
    }
}

fn frame(base: Dd, reduced: &ReducedAngle, upside_down: bool, side: f64) -> Frame {
    let half_turn = if upside_down { reduced.side } else { 0.0 };
    Frame { base, turns: reduced.turns, half_turn, side }
}

/// Regime, 1 - m and the square root of its size.
fn complement(
    velocity: f64,
    frequency: Frequency,
    x_power: i32,
    sine: Td,
    cosine: Td,
    x: Td,
    power: i32,
) -> (Regime, Dd, Dd) {
    if power != 0 {
        return (Regime::Libration, Dd::ONE, Dd::ONE);
    }
    // Near x = 1 with a small sine, c - x would lose the sine: there 1 - x^2 = (a b - v^2 c/4)/(a b) exactly.
    if sine.hi < 0.5 && (-2..=1).contains(&x_power) {
        let one_minus_square = exact_complement(velocity, frequency);
        let mc = (one_minus_square - sine.square()).to_dd();
        if one_minus_square.hi == 0.0 {
            let regime = if sine.hi == 0.0 { Regime::Separatrix } else { Regime::Rotation };
            return (regime, mc, sine.to_dd());
        }
        return (regime_of(mc.hi), mc, mc.abs().sqrt());
    }
    let (minus, plus) = ((cosine - x).to_dd(), (cosine + x).to_dd());
    (regime_of(minus.hi), minus * plus, minus.abs().sqrt() * plus.sqrt())
}

/// The regime from a quantity of the sign of 1 - m.
fn regime_of(sign: f64) -> Regime {
    if sign > 0.0 {
        Regime::Libration
    } else if sign < 0.0 {
        Regime::Rotation
    } else {
        Regime::Separatrix
    }
}

/// 1 - velocity^2/(4 omega0^2), where it is near 0 exactly up to one division.
fn exact_complement(velocity: f64, frequency: Frequency) -> Td {
    let (a, b, c) = frequency.factors();
    let powers = exponent(a) + exponent(b) - exponent(c);
    let (a, b, c, v) = (mantissa(a), mantissa(b), mantissa(c), mantissa(velocity));
    let scale = -ldexp(1.0, 2 * exponent(velocity) - 2 - powers);
    let (force, force_error) = a.two_product(b);
    let (square, square_error) = v.two_product(v);
    let (head, head_error) = square.two_product(c * scale);
    let (tail, tail_error) = square_error.two_product(c * scale);
    let difference = exact_sum([tail_error, head_error, tail, head, force_error, force]);
    difference / Td::product(a, b)
}

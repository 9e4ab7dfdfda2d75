//! The state a time dt after a given one, without any inverse elliptic function.
//!
//! With S, C, D = sn, cn, dn(omega0 dt | m) and the state as s = sin(r/2), c = cos(r/2), x = velocity/2 omega0,
//!   s' = s C D + x c S,  c' = c D - s x S C,  x' = (x C - s c S D)/d,  d = c^2 + s^2 C^2,
//! in every regime (the addition theorem); theta' = 2 atan2(s', c') and turns. Carried in double-double and
//! rounded once, so the error of many steps grows slowly. Source: Salas 2019 (23) with its denominator kept.

use super::batch::{fill, row};
use super::frequency::Frequency;
use super::orbit::Orbit;
use super::regime::Regime;
use super::state::State;
use crate::elliptic::phase::{LAST_HALF_PERIOD, Phase};
use crate::elliptic::theta::neville::NevilleTheta;
use crate::float::elementary::{arctangent, saturated_sinh_cosh, sech};
use crate::float::exponent::{carried, ldexp};
use crate::float::{Dd, PI, TWO_PI};

/// (theta, velocity) a time dt after the state (theta, velocity); theta is continuous with the input.
///
/// Domain as for [`Orbit`]: NaN for states that are not finite and for steps beyond 2^53 half periods.
/// **Error** at most 8 ulp of the largest angle and velocity of the orbit. Source: Salas 2019 (23), DLMF 22.8.
///
/// ```
/// use libration::{Frequency, advance};
/// let (theta, velocity) = advance(1.0, 0.0, 2.0, Frequency::from_omega0(1.0)?);
/// assert_eq!(format!("{theta:.9} {velocity:.9}"), "-0.306200958 -0.909047105");
/// # Ok::<(), libration::Domain>(())
/// ```
#[must_use]
pub fn advance(theta: f64, velocity: f64, dt: f64, frequency: Frequency) -> (f64, f64) {
    let by_lanes = frequency.downward_root().and_then(|omega| row([theta, velocity, dt, omega.hi], omega.lo));
    match by_lanes {
        Some([theta, velocity]) if !(theta.is_nan() || velocity.is_nan()) => (theta, velocity),
        _ => accurate(theta, velocity, dt, frequency),
    }
}

/// [`advance`] of every row of (theta, velocity, dt, omega0), bit for bit, on the widest lanes. NaN also where omega0 is
/// negative or not finite; panics where the lengths differ.
pub fn advance_into(rows: [&[f64]; 4], [theta, velocity]: [&mut [f64]; 2]) {
    fill(rows, [theta, velocity], |[theta, velocity, dt, omega0]| {
        Frequency::from_omega0(omega0)
            .map_or((f64::NAN, f64::NAN), |frequency| accurate(theta, velocity, dt, frequency))
    });
}

/// sn, cn, dn of the step, and the mean advance of a rotation in turns.
struct Step {
    sn: Dd,
    cn: Dd,
    dn: Dd,
    turns: f64,
}

/// A step to double-double throughout, for the rows that the lanes leave out.
fn accurate(theta: f64, velocity: f64, dt: f64, frequency: Frequency) -> (f64, f64) {
    if !(theta.is_finite() && velocity.is_finite()) || dt.is_nan() {
        return (f64::NAN, f64::NAN);
    }
    if dt == 0.0 {
        return (theta, velocity);
    }
    let Some(state) = State::new(theta, velocity, frequency) else {
        return Orbit::new(theta, velocity, frequency).map_or((f64::NAN, f64::NAN), |orbit| orbit.motion(dt));
    };
    let State { s, c, x, power, frame, omega, omega_power, .. } = state;
    let Step { sn, cn, dn, turns } = step(&state, dt);
    let tiny = ldexp(1.0, 2 * power);
    let square = s.square().scale(tiny);
    let next_s = s * cn * dn + x * c * sn;
    let next_c = c * dn - (s * x).scale(tiny) * sn * cn;
    let next_x = (x * cn - s * c * sn * dn) / (c.square() + square * cn.square());
    // The point (c', s') turns by half of theta: its angle is known modulo 4 pi of theta.
    let sign = |value: Dd| 1f64.copysign(value.hi);
    let quadrant = arctangent(next_s.ldexp(power).abs(), next_c.abs());
    let half = if next_c.hi < 0.0 { PI - quadrant } else { quadrant };
    let local = half.scale(2.0 * sign(next_s));
    let start = arctangent(s.ldexp(power).abs(), c).scale(2.0 * sign(s));
    // Two whole turns at a time; the mean motion is never wrong by one.
    let mean = turns + (start - local).hi / TWO_PI.hi;
    let pairs = if state.regime == Regime::Rotation { (0.5 * mean).round() } else { 0.0 };
    let canonical = local + TWO_PI * (2.0 * pairs);
    let offset = frame.base + PI * frame.half_turn;
    let theta = (offset + canonical * frame.side).value();
    let speed = (next_x * omega).scale(2.0 * frame.side).value();
    (theta, ldexp(speed, power + omega_power))
}

fn step(state: &State, dt: f64) -> Step {
    let State { c, x, k, omega, omega_power, regime, .. } = *state;
    let (rate_power, time_power) = carried(omega_power);
    let dt = ldexp(dt, time_power);
    let omega = omega.ldexp(rate_power);
    if regime == Regime::Separatrix {
        let bounded = if c.hi == 0.0 && x.hi == 0.0 {
            Dd::ZERO
        } else if (omega.hi * dt).abs() < 800.0 {
            omega * dt
        } else {
            Dd::from(800f64.copysign(dt))
        };
        let sign = 1f64.copysign(bounded.hi);
        let (sinh, cosh) = saturated_sinh_cosh(bounded.abs());
        let (falling, exponent) = sech(bounded.abs());
        let falling = falling.scale(exponent);
        return Step { sn: (sinh / cosh).scale(sign), cn: falling, dn: falling, turns: 0.0 };
    }
    let rotation = regime == Regime::Rotation;
    let lattice = NevilleTheta::new(state.unit());
    let stretch = if rotation { omega * k } else { omega };
    let phase = Phase { rate: stretch / lattice.quarter.scale(2.0), start: Dd::ZERO };
    let at = phase.reduce(dt);
    let half_periods = if rotation { 2.0 * at.n.hi } else { at.n.hi };
    if half_periods.abs() >= LAST_HALF_PERIOD {
        let nan = Dd::from(f64::NAN);
        return Step { sn: nan, cn: nan, dn: nan, turns: f64::NAN };
    }
    let [sn, cn, dn] = lattice.long_values(&at);
    if rotation {
        Step { sn: sn / k, cn: dn, dn: cn, turns: at.n.hi + at.sign * at.f.hi }
    } else {
        Step { sn, cn, dn, turns: 0.0 }
    }
}

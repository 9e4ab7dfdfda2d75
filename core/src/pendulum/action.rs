//! Action and angle: J = (1/2 pi) closed integral of velocity dtheta per unit inertia, and its phase, linear in time.
//!
//!   libration   J = (8 omega0/pi) (E(m) - (1 - m) K(m)),    m = kappa^2,
//!   rotation    J = (4 omega0/pi) kappa E(1/kappa^2), of one turn,
//!   separatrix  8 omega0/pi as the limit of librations; half of it, 4 omega0/pi, as the limit of rotations.
//! dJ/dE = 1/|frequency|. The phase is 0 at the bottom going up; a rotation's grows by 2 pi a turn with its angle.
//! Back by Newton's method in 1 - m, from which both integrals follow without cancellation.
//! Source: Landau & Lifshitz, Mechanics, sections 11, 49; DLMF 19.4.1, 19.4.2.

use super::frequency::Frequency;
use super::orbit::{Orbit, Solution};
use super::state::State;
use crate::domain::Domain;
use crate::elliptic::amplitude::ReducedAmplitude;
use crate::elliptic::integrals::complete::{complete_difference_dd, complete_e_dd, complete_k_dd};
use crate::elliptic::parameter::{Parameter, Unit};
use crate::elliptic::phase::ReducedPhase;
use crate::elliptic::theta::neville::NevilleTheta;
use crate::float::elementary::arctangent;
use crate::float::exponent::{exponent, ldexp, mantissa};
use crate::float::{Dd, HALF_PI, PI, Scaled, TWO_PI, angle_reduction};

/// pi/8.
const EIGHTH_PI: Dd = PI.half().half().half();

impl Orbit {
    /// Action in rad^2/s, never negative; 8 omega0/pi on the separatrix (as the limit of librations).
    ///
    /// **Error** at most 4 ulp, plus 2^-100 of its condition. Source: Landau & Lifshitz, Mechanics, section 49; DLMF 19.2.8.
    ///
    /// ```
    /// use libration::{Frequency, Orbit};
    /// let orbit = Orbit::new(2.0, 0.0, Frequency::from_omega0(1.0)?)?;
    /// let (action, frequency, phase) = (orbit.action(), orbit.frequency(), orbit.phase(1.0));
    /// assert_eq!(format!("{action:.9} {frequency:.9} {phase:.9}"), "1.597822727 0.752499548 2.323295875");
    /// # Ok::<(), libration::Domain>(())
    /// ```
    #[must_use]
    pub fn action(&self) -> f64 {
        let Some(state) = self.state else { return self.velocity0.abs() };
        let State { k, m, power, omega, omega_power, .. } = state;
        let (ratio, more) = match self.solution {
            // E - (1 - m) K = pi m/4 (1 + m/8 + ...), and m is too small here for the second term to count.
            Solution::Libration(_) if power != 0 => (m * PI.scale(0.25), 2 * power),
            Solution::Libration(_) => (complete_difference_dd(state.unit().parameter()), 0),
            Solution::Rotation(_) => ((k * complete_e_dd(state.unit().parameter())).scale(0.5), 0),
            _ => (Dd::ONE, 0),
        };
        ldexp((omega * ratio / EIGHTH_PI).value(), omega_power + more)
    }

    /// Mean angular frequency in rad/s, 2 pi over the period: negative in rotation downwards, 0 on the separatrix,
    /// omega0 at rest.
    ///
    /// **Error** at most 4 ulp, plus 2^-100 of its condition. Source: 2 pi over [`Orbit::period`].
    #[must_use]
    pub fn frequency(&self) -> f64 {
        self.mean_frequency().value()
    }

    /// [`Orbit::frequency`] in double-double and beyond the range.
    pub(super) fn mean_frequency(&self) -> Scaled {
        match &self.solution {
            Solution::Libration(elliptic) => Scaled::from(elliptic.phase.rate * PI) * self.time_scale,
            Solution::Rotation(elliptic) => {
                Scaled::from(elliptic.phase.rate * TWO_PI) * (self.time_scale * self.frame.side)
            }
            Solution::ForceFree => Scaled::from(self.velocity0),
            Solution::Equilibrium if self.period().is_finite() => Scaled::from(self.omega0()),
            Solution::Equilibrium | Solution::Separatrix(_) => Scaled::ZERO,
        }
    }

    /// Phase in rad at t (in s), continuous and linear in time with the slope [`Orbit::frequency`]: 0 where a libration goes
    /// up through the bottom, and in (-pi, pi] at t = 0; in rotation the multiple of 2 pi that theta passes with it. NaN
    /// on the separatrix; at rest omega0 t.
    ///
    /// **Error** at most 4 ulp of the larger of the phase and pi. Source: DLMF 22.19.2, 22.19.3, the argument of the theta
    /// functions in units of pi.
    #[must_use]
    #[inline]
    pub fn phase(&self, t: f64) -> f64 {
        let (frame, passed) = (&self.frame, t * self.time_scale);
        match &self.solution {
            Solution::Libration(elliptic) => {
                let start = elliptic.phase.start;
                let start = match (frame.side < 0.0, start.hi > 0.0) {
                    (false, _) => start,
                    (true, true) => start - Dd::ONE,
                    (true, false) => start + Dd::ONE,
                };
                ((elliptic.phase.rate * passed + start) * PI).value()
            }
            Solution::Rotation(elliptic) => {
                let turned = (elliptic.phase.rate * passed + elliptic.phase.start) * TWO_PI;
                (frame.base + PI * frame.half_turn + turned * frame.side).value()
            }
            Solution::ForceFree => self.theta(t),
            Solution::Equilibrium if t.is_finite() && self.period().is_finite() => self.omega0() * t,
            Solution::Equilibrium => 0.0 * t,
            Solution::Separatrix(_) => f64::NAN,
        }
    }

    /// The orbit with this action (in rad^2/s) and this phase (in rad) at t = 0; `direction` 0 is a libration, +1 and -1
    /// are rotations upwards and downwards.
    ///
    /// The action of a libration is at least 0 and below 8 omega0/pi, that of a rotation above 4 omega0/pi.
    ///
    /// **Error** as for [`state_of`]. The state is rounded to doubles, and [`Orbit::action`] and [`Orbit::phase`] give back
    /// what the rounding leaves. With u for half a unit in the last place of theta0, the action changes by up to
    /// omega0^2 (|sin theta0| u + u^2/2)/|frequency|, besides some units of its own last place. Where omega2 is negative
    /// the stable equilibrium is at pi, and u is 2.2e-16 there: theta0 cannot hold a narrower libration, and an action
    /// below 2.5e-32 omega0 is lost.
    ///
    /// # Errors
    /// For an action or a phase that is not finite, an action out of the range of its motion, a direction that is none of
    /// the three, and a velocity beyond the doubles.
    ///
    /// ```
    /// use libration::{Frequency, Orbit};
    /// let orbit = Orbit::from_action_phase(1.0, 0.5, 0.0, Frequency::from_omega0(1.0)?)?;
    /// assert_eq!(format!("{:.9} {:.9}", orbit.action(), orbit.phase(0.0)), "1.000000000 0.500000000");
    /// # Ok::<(), libration::Domain>(())
    /// ```
    pub fn from_action_phase(
        action: f64,
        phase: f64,
        direction: f64,
        frequency: Frequency,
    ) -> Result<Orbit, Domain> {
        let (theta, velocity) = state_of(action, phase, direction, frequency)?;
        Orbit::new(theta, velocity, frequency)
    }
}

/// Angle and velocity of an action and a phase, as [`Orbit::from_action_phase`] takes them.
///
/// **Error** at most 4 ulp of the largest angle and velocity, plus what the last place of the action makes of them; the
/// largest angle is pi + theta_max where the stable equilibrium is at pi. Source: Newton's method on DLMF 19.4.1, 19.4.2.
///
/// # Errors
/// As for [`Orbit::from_action_phase`].
///
/// ```
/// use libration::{Frequency, pendulum::action::state_of};
/// let (theta, velocity) = state_of(1.0, 0.5, 0.0, Frequency::from_omega0(1.0)?)?;
/// assert_eq!(format!("{theta:.9} {velocity:.9}"), "0.751444104 1.151972454");
/// # Ok::<(), libration::Domain>(())
/// ```
pub fn state_of(action: f64, phase: f64, direction: f64, frequency: Frequency) -> Result<(f64, f64), Domain> {
    let (theta, velocity) = unchecked_state_of(action, phase, direction, frequency)?;
    let allowed = "such that the velocity stays in the range of doubles";
    Domain::check("action", action, velocity.is_finite(), allowed)?;
    Ok((theta, velocity))
}

/// The velocity may be infinite.
fn unchecked_state_of(
    action: f64,
    phase: f64,
    direction: f64,
    frequency: Frequency,
) -> Result<(f64, f64), Domain> {
    Domain::check("phase", phase, phase.is_finite(), "finite")?;
    Domain::check("direction", direction, [0.0, 1.0, -1.0].contains(&direction), "0, 1 or -1")?;
    let rotation = direction != 0.0;
    let allowed = if rotation { "finite and positive in rotation" } else { "finite and not negative" };
    let possible = action.is_finite() && (action > 0.0 || action == 0.0 && !rotation);
    Domain::check("action", action, possible, allowed)?;
    let upside_down = frequency.upside_down();
    let force_free = (phase, direction * action);
    let Some((omega, omega_power)) = frequency.root() else {
        Domain::check("action", action, rotation || action == 0.0, "0 in libration without force")?;
        return Ok(force_free);
    };
    if action == 0.0 {
        return Ok((if upside_down { PI.hi } else { 0.0 }, 0.0));
    }
    let omega = omega.to_dd();
    // J/omega0, beside a power of two.
    let ratio = Dd::from(mantissa(action)) / omega;
    let power = exponent(action) - omega_power;
    let share = (ratio * EIGHTH_PI).ldexp(power);
    if !rotation {
        Domain::check("action", action, (share - Dd::ONE).hi < 0.0, "below 8 omega0/pi in libration")?;
        let (local, k_cn, more) = libration_state(share, ratio, power, half_periods(phase));
        let theta = if upside_down { (PI + local).value() } else { local.value() };
        return Ok((theta, ldexp((omega * k_cn).scale(2.0).value(), omega_power + more)));
    }
    let share = share.scale(2.0);
    if share.hi > FREE {
        return Ok(force_free);
    }
    Domain::check("action", action, (share - Dd::ONE).hi > 0.0, "above 4 omega0/pi in rotation")?;
    let (base, at) = turns(phase, upside_down);
    let (local, k_dn) = rotation_state(share, at);
    let velocity = ldexp((omega * k_dn).scale(2.0 * direction).value(), omega_power);
    Ok(((base + local).value(), velocity))
}

/// Angle, and velocity/2 omega0 over a power of two, of a libration with J pi/8 omega0 = `share`.
fn libration_state(share: Dd, ratio: Dd, power: i32, at: ReducedPhase<f64>) -> (Dd, Dd, i32) {
    if share.hi < TINY {
        // kappa^2 = J/2 omega0, beside an even power of two.
        let odd = power.rem_euclid(2);
        let k = ratio.scale(if odd == 1 { 1.0 } else { 0.5 }).sqrt();
        let power = (power - odd) / 2;
        let lattice = NevilleTheta::new(Unit::ZERO);
        let [sine, cosine, _] = lattice.long_values(&at);
        return ((k * sine).scale(2.0).ldexp(power), k * cosine, power);
    }
    let unit = parameter_of_libration(share).unit();
    let [sn, cn, dn] = NevilleTheta::new(unit).long_values(&at);
    (arctangent((unit.k * sn).abs(), dn).scale(2f64.copysign(sn.hi)), unit.k * cn, 0)
}

/// Angle and |velocity|/2 omega0 of a rotation with J pi/4 omega0 = `share`.
fn rotation_state(share: Dd, at: ReducedPhase<f64>) -> (Dd, Dd) {
    let (m, inner) = parameter_of_rotation(share);
    let [sn, cn, dn] = NevilleTheta::new(inner.unit()).long_values(&at);
    (arctangent(sn.abs(), cn).scale(2f64.copysign(sn.hi)), m.sqrt() * dn)
}

/// J pi/8 omega0 of a libration that is linear to double-double.
const TINY: f64 = 1e-60;
/// J pi/4 omega0 of a rotation that the force no longer shapes; infinite where it leaves the range.
const FREE: f64 = 1.3e30;

/// A phase in half periods of a libration, pi each.
fn half_periods(phase: f64) -> ReducedPhase<f64> {
    let ReducedAmplitude { odd, side, r, .. } = ReducedAmplitude::new(phase);
    ReducedPhase { n: Dd::ZERO, sign: side, f: r.to_dd() / PI, parity: if odd { -1.0 } else { 1.0 } }
}

/// A phase in half periods of a rotation, 2 pi each, counted from its stable equilibrium: what its angle counts from.
fn turns(phase: f64, upside_down: bool) -> (Dd, ReducedPhase<f64>) {
    let angle_reduction::ReducedAngle { side, from_bottom, from_top, .. } = angle_reduction::reduce(phase);
    let (rest, sign) = if upside_down { (from_top, -side) } else { (from_bottom, side) };
    let rest = rest.to_dd();
    let base = Dd::from(phase) - rest * sign;
    let base = if base.hi.abs() < 1.0 { Dd::ZERO } else { base };
    (base, ReducedPhase { n: Dd::ZERO, sign, f: rest / TWO_PI, parity: 1.0 })
}

/// Newton's steps for an increasing function of x > 0 with this excess over its target and this slope. A step never takes
/// more than 7/8 of x away, so x stays positive. 100 steps are a bound that is never reached: from the starts given, a
/// few steps come within the range of quadratic convergence, and six more end it, below 2^-100 of x.
fn root(mut x: Dd, excess_and_slope: impl Fn(Dd) -> (Dd, Dd)) -> Dd {
    for _ in 0..100 {
        let (excess, slope) = excess_and_slope(x);
        let next = x - excess / slope;
        let next = if next.hi > 0.125 * x.hi { next } else { x.scale(0.125) };
        let settled = (next - x).hi.abs() <= 1e-30 * x.hi;
        x = next;
        if settled {
            break;
        }
    }
    x
}

/// m with E(m) - (1 - m) K(m) = share, for 0 < share < 1: its slope in m is K/2.
fn parameter_of_libration(share: Dd) -> Parameter {
    if share.hi < 0.6 {
        let m = root(share / PI.scale(0.25), |m| {
            let parameter = Parameter::new(m, Dd::ONE - m);
            (complete_difference_dd(parameter) - share, complete_k_dd(parameter).scale(0.5))
        });
        return Parameter::new(m, Dd::ONE - m);
    }
    // 1 - share = mc (ln(16/mc) + 1)/4 + ...: for all that doubles can tell from 1 the start is below the root.
    let rest = Dd::ONE - share;
    let mc = root(rest.scale(0.05), |mc| {
        let parameter = Parameter::new(Dd::ONE - mc, mc);
        (Dd::ONE - complete_difference_dd(parameter) - rest, complete_k_dd(parameter).scale(0.5))
    });
    Parameter::new(Dd::ONE - mc, mc)
}

/// m with sqrt(m) E(1/m) = share > 1, and 1/m as a parameter: its slope in m is K(1/m)/2 sqrt(m).
fn parameter_of_rotation(share: Dd) -> (Dd, Parameter) {
    let inner = |beyond: Dd| {
        let m = Dd::ONE + beyond;
        Parameter::new(Dd::ONE / m, beyond / m)
    };
    let far = share.square() / HALF_PI.square();
    let start = if share.hi > 2.0 { far } else { (share - Dd::ONE).scale(0.05) };
    let beyond = root(start, |beyond| {
        let (parameter, k) = (inner(beyond), (Dd::ONE + beyond).sqrt());
        (k * complete_e_dd(parameter) - share, complete_k_dd(parameter) / k.scale(2.0))
    });
    (Dd::ONE + beyond, inner(beyond))
}

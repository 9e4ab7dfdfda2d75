//! How an orbit may be stated: the angle it starts at, and its velocity there or what is known of its energy.
//!
//! The angle counts from theta = 0, from the top, or is the bottom; the energy is given by itself, as kappa^2 or 1 - kappa^2, by
//! the turning angle or by the period. What is given stays as it is: an orbit is set up from it in triple-double
//! (energy_ratio.rs), so that nothing is rounded to a velocity next to the separatrix, where 1 - kappa^2 would be lost.

use super::energy_ratio::EnergyRatio;
use super::frequency::Frequency;
use super::period_inverse;
use crate::domain::{Domain, shown};
use crate::float::angle_reduction::{ReducedAngle, reduce};
use crate::float::{Dd, Scaled, TWO_PI, TWO_PI_LONG, Td};

/// Where an orbit starts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StartAngle {
    /// theta0 in rad.
    Theta(f64),
    /// theta0 - pi in rad where omega0^2 is positive; where it is negative theta counts from the top already.
    FromTop(f64),
    /// The stable equilibrium: theta0 = 0, and exactly pi where omega0^2 is negative.
    Bottom,
}

/// What is known of the motion besides the angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StartMotion {
    /// The initial angular velocity in rad/s.
    Velocity(f64),
    /// kappa^2: the energy over that of the top.
    EnergyRatio(f64),
    /// 1 - kappa^2, negative in rotation.
    EnergyRatioC(f64),
    /// Energy per unit inertia in rad^2/s^2, 0 at the stable equilibrium.
    Energy(f64),
    /// Turning angle in rad, counted from the stable equilibrium, 0 to pi.
    ThetaMax(f64),
    /// pi less the turning angle, in rad, 0 to pi.
    ThetaMaxFromTop(f64),
    /// Period of a libration in s; infinite on the separatrix.
    Period(f64),
    /// Time of one turn of a rotation in s; infinite on the separatrix.
    PeriodOfRotation(f64),
}

const NOT_NEGATIVE: &str = "finite and not negative";

impl StartMotion {
    /// The energy under a force; `None` for a velocity.
    pub(super) fn energy(self, frequency: Frequency) -> Result<Option<EnergyRatio>, Domain> {
        Ok(Some(match self {
            StartMotion::Velocity(_) => return Ok(None),
            StartMotion::EnergyRatio(ratio) => {
                Domain::check("energy_ratio", ratio, ratio.is_finite() && ratio >= 0.0, NOT_NEGATIVE)?;
                EnergyRatio::new(Td::from(ratio), 0, Dd::sum(1.0, -ratio).into())
            }
            StartMotion::EnergyRatioC(rest) => {
                Domain::check(
                    "energy_ratio_c",
                    rest,
                    rest.is_finite() && rest <= 1.0,
                    "finite and at most 1",
                )?;
                EnergyRatio::new(Dd::sum(1.0, -rest).into(), 0, Td::from(rest))
            }
            StartMotion::Energy(energy) => {
                Domain::check("energy", energy, energy.is_finite() && energy >= 0.0, NOT_NEGATIVE)?;
                EnergyRatio::of_energy(energy, frequency)
            }
            StartMotion::ThetaMax(angle) => {
                EnergyRatio::of_turning_angle(checked_turning_angle("theta_max", angle)?, false)
            }
            StartMotion::ThetaMaxFromTop(angle) => {
                EnergyRatio::of_turning_angle(checked_turning_angle("theta_max_from_top", angle)?, true)
            }
            StartMotion::Period(period) => period_inverse::libration(period, frequency)?,
            StartMotion::PeriodOfRotation(period) => period_inverse::rotation(period, frequency)?,
        }))
    }

    /// The name of the argument.
    pub(super) fn name(self) -> &'static str {
        match self {
            StartMotion::Velocity(_) => "velocity0",
            StartMotion::EnergyRatio(_) => "energy_ratio",
            StartMotion::EnergyRatioC(_) => "energy_ratio_c",
            StartMotion::Energy(_) => "energy",
            StartMotion::ThetaMax(_) => "theta_max",
            StartMotion::ThetaMaxFromTop(_) => "theta_max_from_top",
            StartMotion::Period(_) | StartMotion::PeriodOfRotation(_) => "period",
        }
    }
}

/// The start of an orbit.
///
/// ```
/// use libration::{Frequency, Orbit, OrbitStart, StartAngle, StartMotion};
/// let start = OrbitStart::new(StartAngle::Bottom, StartMotion::EnergyRatioC(-1e-20), 1.0);
/// let orbit = Orbit::from_start(start, Frequency::from_omega0(1.0)?)?;
/// assert_eq!(format!("{:.12}", orbit.period()), "48.824290582121");
/// # Ok::<(), libration::Domain>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrbitStart {
    pub(super) angle: StartAngle,
    pub(super) motion: StartMotion,
    pub(super) direction: f64,
}

impl OrbitStart {
    /// From the angle, the motion and its direction, 1 or -1 for upwards and downwards, which does not count beside a
    /// velocity. What the values must be depends on the force: [`super::orbit::Orbit::from_start`] says it.
    #[must_use]
    pub fn new(angle: StartAngle, motion: StartMotion, direction: f64) -> OrbitStart {
        OrbitStart { angle, motion, direction }
    }

    /// Of a state.
    #[must_use]
    pub fn of_state(theta0: f64, velocity0: f64) -> OrbitStart {
        OrbitStart::new(StartAngle::Theta(theta0), StartMotion::Velocity(velocity0), 1.0)
    }

    /// As four doubles: the angle, what is known of the motion, the direction, and a whole number that says which they are.
    #[must_use]
    pub fn operands(&self) -> [f64; 4] {
        let (angle, counted) = match self.angle {
            StartAngle::Theta(angle) => (angle, 0.0),
            StartAngle::FromTop(angle) => (angle, 1.0),
            StartAngle::Bottom => (0.0, 2.0),
        };
        let (value, known) = match self.motion {
            StartMotion::Velocity(value) => (value, 0.0),
            StartMotion::EnergyRatio(value) => (value, 1.0),
            StartMotion::EnergyRatioC(value) => (value, 2.0),
            StartMotion::Energy(value) => (value, 3.0),
            StartMotion::ThetaMax(value) => (value, 4.0),
            StartMotion::ThetaMaxFromTop(value) => (value, 5.0),
            StartMotion::Period(value) => (value, 6.0),
            StartMotion::PeriodOfRotation(value) => (value, 7.0),
        };
        [angle, value, self.direction, 3.0 * known + counted]
    }

    /// From the operands, as [`OrbitStart::operands`] gives them; `None` for another number at the end.
    #[must_use]
    pub fn from_operands([angle, value, direction, kind]: [f64; 4]) -> Option<OrbitStart> {
        if !(0.0..24.0).contains(&kind) || kind.fract() != 0.0 {
            return None;
        }
        let angle = match kind % 3.0 {
            0.0 => StartAngle::Theta(angle),
            1.0 => StartAngle::FromTop(angle),
            _ => StartAngle::Bottom,
        };
        let motion = match (kind / 3.0) as u8 {
            0 => StartMotion::Velocity(value),
            1 => StartMotion::EnergyRatio(value),
            2 => StartMotion::EnergyRatioC(value),
            3 => StartMotion::Energy(value),
            4 => StartMotion::ThetaMax(value),
            5 => StartMotion::ThetaMaxFromTop(value),
            6 => StartMotion::Period(value),
            _ => StartMotion::PeriodOfRotation(value),
        };
        Some(OrbitStart { angle, motion, direction })
    }

    /// The velocity without a force: of an energy, or of the period of a rotation.
    pub(super) fn force_free_velocity(&self) -> Result<f64, Domain> {
        let [_, value, direction, _] = self.operands();
        let name = self.motion.name();
        match self.motion {
            StartMotion::Velocity(velocity) => Ok(velocity),
            StartMotion::Energy(energy) => {
                Domain::check(name, energy, energy.is_finite() && energy >= 0.0, NOT_NEGATIVE)?;
                // 2 E may be beyond the doubles.
                Ok(direction * (Scaled::from(energy).shift(1)).sqrt().value())
            }
            StartMotion::PeriodOfRotation(period) => {
                let velocity = (Scaled::from(TWO_PI) / Scaled::from(period)).value();
                let holds = period > 0.0 && velocity.is_finite();
                Domain::check(
                    name,
                    period,
                    holds,
                    "positive, and not below what a velocity in doubles turns in",
                )?;
                Ok(direction * velocity)
            }
            _ => {
                let allowed = "given with a force; without one give the energy, or the period of a rotation";
                Err(Domain::new(name, shown(value), allowed))
            }
        }
    }

    /// The error of an angle beyond the turning angle.
    pub(super) fn not_reached(&self, placed: &Placed, theta_max: f64) -> Domain {
        let (name, given) = match self.angle {
            StartAngle::FromTop(beyond) => ("theta0_from_top", beyond),
            _ => ("theta0", placed.theta),
        };
        let allowed =
            format!("an angle that the energy reaches, at most {} from the bottom", shown(theta_max));
        Domain::new(name, shown(given), allowed)
    }

    /// The angle on the circle, where it is finite and the direction is one.
    pub(super) fn placed(&self, frequency: Frequency) -> Result<Placed, Domain> {
        let OrbitStart { angle, direction, .. } = *self;
        Domain::check("direction", direction, [1.0, -1.0].contains(&direction), "1 or -1")?;
        let upside_down = frequency.upside_down();
        match angle {
            StartAngle::Theta(theta0) => {
                Domain::check("theta0", theta0, theta0.is_finite(), "finite")?;
                Ok(Placed::new(theta0))
            }
            StartAngle::FromTop(beyond) => {
                Domain::check("theta0_from_top", beyond, beyond.is_finite(), "finite")?;
                Ok(if upside_down { Placed::new(beyond) } else { Placed::beyond_half_turn(beyond) })
            }
            StartAngle::Bottom => {
                Ok(if upside_down { Placed::beyond_half_turn(0.0) } else { Placed::new(0.0) })
            }
        }
    }
}

/// An angle on the circle, without a rounding.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placed {
    /// Rounded.
    pub theta: f64,
    /// 2 pi turns.
    pub base: Dd,
    pub reduced: ReducedAngle,
}

impl Placed {
    pub fn new(theta: f64) -> Placed {
        let reduced = reduce(theta);
        let distance = reduced.from_bottom * reduced.side;
        let base = if reduced.turns.hi == 0.0 { Dd::ZERO } else { (Td::from(theta) - distance).to_dd() };
        Placed { theta, base, reduced }
    }

    /// pi + `beyond`.
    fn beyond_half_turn(beyond: f64) -> Placed {
        let ReducedAngle { turns, side, from_bottom, from_top } = reduce(beyond);
        let whole = if turns.hi == 0.0 { Td::ZERO } else { Td::from(beyond) - from_bottom * side };
        // pi + r is beyond the half turn for r >= 0: one turn on, on the other side.
        let (turns, base) = if side > 0.0 { (turns + Dd::ONE, whole + TWO_PI_LONG) } else { (turns, whole) };
        Placed {
            theta: (TWO_PI_LONG.scale(0.5) + Td::from(beyond)).to_dd().value(),
            base: base.to_dd(),
            reduced: ReducedAngle { turns, side: -side, from_bottom: from_top, from_top: from_bottom },
        }
    }
}

fn checked_turning_angle(name: &'static str, angle: f64) -> Result<f64, Domain> {
    Domain::check(name, angle, (0.0..=core::f64::consts::PI).contains(&angle), "from 0 to pi")
}

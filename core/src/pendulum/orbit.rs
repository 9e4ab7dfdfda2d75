//! One orbit, set up once: everything that does not depend on time, in double-double.
//!
//! The canonical angle goes upwards through 0 at phase 0 (see state.rs for the frame). Its phase at the start is
//!   omega0 t = s R_F(x^2, m c^2, m), the time since the bottom, one formula for all regimes,
//! and the phase at t is start + rate t in half periods (libration, rotation) or in units of 1/omega0
//! (separatrix). Source: Salas 2019 (23)-(25), corrected; DLMF 19.25.5, 22.15.

use super::frequency::Frequency;
use super::regime::Regime;
use super::separatrix::Separatrix;
use super::start::{OrbitStart, Placed, StartMotion};
use super::state::{Frame, State, turning_angle};
use super::theta_quotients::Elliptic;
use crate::domain::Domain;
use crate::elliptic::integrals::carlson_duplication::rf_of_roots;
use crate::elliptic::phase::Phase;
use crate::elliptic::theta::neville::NevilleTheta;
use crate::float::exponent::{carried, exponent, ldexp, mantissa};
use crate::float::{Dd, Scaled, TWO_PI};
use crate::lanes::COMPACT;
use crate::motion::interpolant::ConformalMap;
use crate::motion::pieces::{LONGEST_QUARTER, Pieces};
use crate::motion::samples::LazyInterpolant;
use std::sync::{Arc, OnceLock};

/// The formula of the motion.
#[derive(Clone, Debug)]
pub(crate) enum Solution {
    /// At rest, at either equilibrium or without a force.
    Equilibrium,
    /// theta0 + velocity0 t.
    ForceFree,
    Libration(Elliptic),
    Rotation(Elliptic),
    Separatrix(Separatrix),
}

/// One orbit of theta'' + omega0^2 sin theta = 0, set up once for many times.
///
/// ```
/// use libration::{Frequency, Orbit};
/// let orbit = Orbit::new(3.0, 0.0, Frequency::from_gravity_length(9.8, 1.0)?)?;
/// assert_eq!(format!("{:.9} {:.9}", orbit.period(), orbit.theta(1.0)), "5.160697750 1.604458520");
/// # Ok::<(), libration::Domain>(())
/// ```
#[derive(Clone, Debug)]
pub struct Orbit {
    pub(crate) theta0: f64,
    pub(crate) velocity0: f64,
    pub(super) placed: Placed,
    pub(crate) frame: Frame,
    pub(crate) solution: Solution,
    pub(super) interpolant: LazyInterpolant<Option<ConformalMap>>,
    /// `None` where they do not serve.
    pub(super) pieces: Option<OnceLock<Arc<Pieces>>>,
    /// The start in units of omega0, where the force shapes the motion.
    pub(crate) state: Option<State>,
    /// Factor that brings t into the range where the phase is formed: a power of two, 1 for ordinary omega0.
    pub(crate) time_scale: f64,
    /// Factor of the velocity: its side, and the powers of two that its other factors cannot carry.
    pub(crate) velocity_scale: f64,
    regime: Regime,
    period: f64,
    theta_max: f64,
    energy_ratio: f64,
    energy_ratio_c: f64,
    energy: f64,
    pub(crate) force: Frequency,
}

/// Power of two of kappa from which on the force changes no digit.
const MOST_POWER: i32 = 100;

/// k' as a divisor whose inverse stays in range: an angle of 1e-290 from the top is as good as none.
fn divisor(kc: Dd) -> Dd {
    if kc.hi < 1e-290 { Dd::from(1e-290) } else { kc }
}

impl Orbit {
    /// Sets up the orbit of an initial angle in rad (any turn) and angular velocity in rad/s.
    ///
    /// Source: Salas 2019 (23); docs/decisions/0001 for the regime.
    ///
    /// # Errors
    /// Where the angle or the velocity is not finite.
    pub fn new(theta0: f64, velocity0: f64, frequency: Frequency) -> Result<Orbit, Domain> {
        Domain::check("theta0", theta0, theta0.is_finite(), "finite")?;
        Orbit::with_velocity(Placed::new(theta0), velocity0, frequency)
    }

    fn with_velocity(placed: Placed, velocity0: f64, frequency: Frequency) -> Result<Orbit, Domain> {
        Domain::check("velocity0", velocity0, velocity0.is_finite(), "finite")?;
        Ok(match State::with_velocity(&placed, velocity0, frequency) {
            Some(state) => Orbit::shaped(placed, velocity0, frequency, state),
            None => Orbit::not_shaped(placed, velocity0, frequency),
        })
    }

    /// Sets up the orbit of a start that is stated in any of the ways of [`OrbitStart`]: by a velocity, an energy, a turning
    /// angle or a period. Angle and velocity at t = 0 are those of the start, rounded; everything else is of the start as
    /// given, so that no digit is lost next to the separatrix.
    ///
    /// | stated by | domain |
    /// |---|---|
    /// | energy ratio | finite, from 0; 1 is the separatrix |
    /// | its complement | finite, up to 1; 0 is the separatrix, below is rotation |
    /// | energy | finite, from 0 |
    /// | turning angle, its distance to pi | from 0 to pi |
    /// | period of a libration | from 2 pi/omega0 to 2676/omega0, or infinite for the separatrix |
    /// | time of a turn | positive, up to 1338/omega0, or infinite |
    ///
    /// **Error** as for an orbit from a state. Source: Salas 2019 (23); DLMF 22.19(i).
    ///
    /// # Errors
    /// For values out of these ranges, an angle that is not finite or that the energy does not reach (the rounded turning
    /// angle is reached), a direction other than 1 and -1, and an energy beyond that of any velocity in doubles. Without a
    /// force there is an energy and a period of a rotation, and none of the others.
    ///
    /// ```
    /// use libration::{Frequency, Orbit, OrbitStart, StartAngle, StartMotion};
    /// let of = |angle, motion| {
    ///     let start = OrbitStart::new(angle, motion, 1.0);
    ///     Orbit::from_start(start, Frequency::from_omega0(1.0).unwrap()).unwrap()
    /// };
    /// // A pencil on its tip, and the swing whose period is 1.25 times that of small ones.
    /// let pencil = of(StartAngle::FromTop(1e-17), StartMotion::Velocity(0.0));
    /// let swing = of(StartAngle::Bottom, StartMotion::Period(2.5 * core::f64::consts::PI));
    /// assert_eq!(format!("{:.9} {:.9}", pencil.period(), swing.theta_max()), "164.893552490 1.798085155");
    /// ```
    pub fn from_start(start: OrbitStart, frequency: Frequency) -> Result<Orbit, Domain> {
        let placed = start.placed(frequency)?;
        if let StartMotion::Velocity(velocity0) = start.motion {
            return Orbit::with_velocity(placed, velocity0, frequency);
        }
        let Some((omega, omega_power)) = frequency.root() else {
            let velocity0 = start.force_free_velocity()?;
            return Orbit::with_velocity(placed, velocity0, frequency);
        };
        let Some(energy) = start.motion.energy(frequency)? else {
            return Orbit::with_velocity(placed, 0.0, frequency);
        };
        let velocity = |x: Dd, power: i32| {
            ldexp((x * omega.to_dd()).scale(2.0 * start.direction).value(), power + omega_power)
        };
        if energy.power > MOST_POWER {
            let velocity0 = velocity(energy.root().to_dd(), energy.power);
            let [_, value, ..] = start.operands();
            let allowed = "such that the velocity stays in the range of doubles";
            Domain::check(start.motion.name(), value, velocity0.is_finite(), allowed)?;
            return Orbit::with_velocity(placed, velocity0, frequency);
        }
        let state = if energy.m.hi == 0.0 {
            match State::with_velocity(&placed, 0.0, frequency) {
                None => return Ok(Orbit::not_shaped(placed, 0.0, frequency)),
                Some(_) => Err(0.0),
            }
        } else {
            State::with_energy(&placed, &energy, start.direction, frequency)
        };
        let state = state.map_err(|theta_max| start.not_reached(&placed, theta_max))?;
        Ok(Orbit::shaped(placed, velocity(state.x, state.power), frequency, state))
    }

    /// At rest, or theta0 + velocity0 t.
    fn not_shaped(placed: Placed, velocity0: f64, frequency: Frequency) -> Orbit {
        let theta0 = placed.theta;
        let omega = frequency.root();
        let moving = velocity0 != 0.0;
        let (energy_ratio, energy_ratio_c) = match omega {
            Some((root, power)) if moving => {
                let x = Dd::from(mantissa(velocity0)) / root.to_dd();
                let square = ldexp(x.square().value(), 2 * (exponent(velocity0) - 1 - power));
                (square, -square)
            }
            None if moving => (f64::INFINITY, f64::NEG_INFINITY),
            _ => (0.0, 1.0),
        };
        let of_small_swings =
            omega.map_or(f64::INFINITY, |(root, power)| ldexp((TWO_PI / root.to_dd()).value(), -power));
        Orbit {
            theta0,
            velocity0,
            placed,
            frame: Frame::of_start(theta0),
            solution: if moving { Solution::ForceFree } else { Solution::Equilibrium },
            interpolant: LazyInterpolant::new(None),
            pieces: None,
            state: None,
            time_scale: 1.0,
            velocity_scale: 1.0,
            regime: if moving { Regime::Rotation } else { Regime::Rest },
            period: if moving { TWO_PI.hi / velocity0.abs() } else { of_small_swings },
            theta_max: if moving { f64::NAN } else { 0.0 },
            energy_ratio,
            energy_ratio_c,
            energy: 0.5 * velocity0 * velocity0,
            force: frequency,
        }
    }

    fn shaped(placed: Placed, velocity0: f64, frequency: Frequency, state: State) -> Orbit {
        let theta0 = placed.theta;
        let State { s, c, x, k, kc, m, mc, omega, power, omega_power, regime, frame, .. } = state;
        let (rate, time_scale) = Scaled::new(omega, omega_power).carried();
        let (speed_power, velocity_power) = carried(power + omega_power);
        // s/k and x/k are sine and cosine of the amplitude; R_F takes their roots.
        let start = || (s / k) * rf_of_roots(x / k, c);
        let (solution, period, theta_max) = match regime {
            Regime::Libration => {
                let lattice = NevilleTheta::new(state.unit());
                let halves = lattice.quarter.scale(2.0);
                let start = if x.hi == 0.0 { Dd::from(f64::copysign(0.5, s.hi)) } else { start() / halves };
                let rate = rate / halves;
                let tangent = k * lattice.theta1_factor;
                let speed = (omega * k).scale(2.0);
                let elliptic = Elliptic {
                    phase: Phase { rate, start },
                    tangent: [tangent.ldexp(power), (k / divisor(kc)).ldexp(power)],
                    velocity: [speed, speed * kc * lattice.theta1_factor].map(|v| v.ldexp(speed_power)),
                    lattice,
                };
                let period = ldexp((halves.scale(2.0) / omega).value(), -omega_power);
                let theta_max = turning_angle(k.ldexp(power), kc);
                (Solution::Libration(elliptic), period, theta_max)
            }
            Regime::Rotation => {
                let lattice = NevilleTheta::new(state.unit());
                let halves = lattice.quarter.scale(2.0);
                let rate = rate * k / halves;
                let speed = (omega * k).scale(2.0);
                let elliptic = Elliptic {
                    phase: Phase { rate, start: k * start() / halves },
                    tangent: [lattice.theta1_factor, Dd::ONE / (divisor(lattice.kc) * lattice.theta1_factor)],
                    velocity: [speed, speed * lattice.kc].map(|v| v.ldexp(speed_power)),
                    lattice,
                };
                let period = ldexp((halves / (omega * k)).value(), -omega_power);
                (Solution::Rotation(elliptic), period, f64::NAN)
            }
            _ if c.hi == 0.0 && x.hi == 0.0 => (Solution::Equilibrium, f64::INFINITY, core::f64::consts::PI),
            _ => {
                let phase = Phase { rate, start: start() };
                let speed = omega.scale(2.0).ldexp(speed_power);
                (Solution::Separatrix(Separatrix { phase, speed }), f64::INFINITY, core::f64::consts::PI)
            }
        };
        // Polynomials give the angle from the near equilibrium with an absolute error: tiny amplitudes, and small angles
        // from the other equilibrium, are accurate by theta functions only.
        let (map, pieces) = match &solution {
            Solution::Libration(elliptic) | Solution::Rotation(elliptic)
                if frame.half_turn == 0.0 && power == 0 =>
            {
                let lattice = &elliptic.lattice;
                let near = lattice.hyperbolic() && lattice.quarter.hi <= LONGEST_QUARTER;
                (ConformalMap::of(lattice), near && !COMPACT)
            }
            _ => (None, false),
        };
        let at_equilibrium = matches!(solution, Solution::Equilibrium);
        let frame = if at_equilibrium { Frame::of_start(theta0) } else { frame };
        let energy = ldexp((omega.square() * m).value(), 2 * (omega_power + power) + 1);
        Orbit {
            theta0,
            velocity0,
            placed,
            frame,
            solution,
            interpolant: LazyInterpolant::new(map),
            pieces: pieces.then(OnceLock::new),
            state: Some(state),
            time_scale,
            velocity_scale: ldexp(frame.side, velocity_power),
            regime,
            period,
            theta_max,
            energy_ratio: ldexp(m.value(), 2 * power),
            energy_ratio_c: mc.value(),
            energy,
            force: frequency,
        }
    }

    /// Regime, decided without cancellation.
    ///
    /// Source: the sign of 1 - kappa^2; docs/decisions/0001.
    ///
    /// ```
    /// use libration::{Frequency, Orbit, Regime};
    /// let of = |velocity0| Orbit::new(0.0, velocity0, Frequency::from_omega0(1.0).unwrap()).unwrap().regime();
    /// assert_eq!([of(1.9), of(2.0), of(2.1)], [Regime::Libration, Regime::Separatrix, Regime::Rotation]);
    /// ```
    #[must_use]
    pub fn regime(&self) -> Regime {
        self.regime
    }
    /// Period in s: of the full swing, of one turn in rotation, of small swings at rest, infinite on the
    /// separatrix. **Error** at most 4 ulp (plus 2^-100 of its condition near the separatrix).
    ///
    /// Source: 4 K(kappa^2)/omega0 and 2 K(1/kappa^2)/(kappa omega0), DLMF 22.19(i).
    ///
    /// ```
    /// use libration::{Frequency, Orbit};
    /// let orbit = Orbit::new(2.0, 0.0, Frequency::from_omega0(1.0)?)?;
    /// assert_eq!(format!("{:.9}", orbit.period()), "8.349752927");
    /// # Ok::<(), libration::Domain>(())
    /// ```
    #[must_use]
    pub fn period(&self) -> f64 {
        self.period
    }
    /// Turning angle in rad, counted from the stable equilibrium: pi on the separatrix, NaN in rotation. **Error** at
    /// most 4 ulp. Source: sin(theta_max/2) = kappa.
    #[must_use]
    pub fn theta_max(&self) -> f64 {
        self.theta_max
    }
    /// kappa^2 = sin^2(theta0/2) + (velocity0/2 omega0)^2: below 1 libration, above 1 rotation. Where the force
    /// is negative, here and in the energies and angles below, theta0 counts from the equilibrium that is stable.
    /// **Error** at most 4 ulp. Source: Salas 2019 (23).
    ///
    /// ```
    /// use libration::{Frequency, Orbit};
    /// let orbit = Orbit::new(2.0, 0.0, Frequency::from_omega0(1.0)?)?;
    /// let (ratio, rest) = (orbit.energy_ratio(), orbit.energy_ratio_c());
    /// assert_eq!(format!("{ratio:.9} {rest:.9} {:.9}", orbit.energy()), "0.708073418 0.291926582 1.416146837");
    /// # Ok::<(), libration::Domain>(())
    /// ```
    #[must_use]
    pub fn energy_ratio(&self) -> f64 {
        self.energy_ratio
    }
    /// 1 - kappa^2, formed without cancellation. **Error** at most 4 ulp, plus 2^-150 of its condition.
    #[must_use]
    pub fn energy_ratio_c(&self) -> f64 {
        self.energy_ratio_c
    }
    /// Energy per unit inertia, velocity^2/2 + omega0^2 (1 - cos theta), 0 at the stable equilibrium. **Error** at
    /// most 4 ulp.
    #[must_use]
    pub fn energy(&self) -> f64 {
        self.energy
    }
    /// Angle at t = 0 in rad, rounded where it was counted from the top.
    #[must_use]
    pub fn theta0(&self) -> f64 {
        self.theta0
    }
    /// Angular velocity at t = 0 in rad/s, rounded where the energy was given.
    #[must_use]
    pub fn velocity0(&self) -> f64 {
        self.velocity0
    }
    /// Angular frequency of small swings, sqrt|omega0^2|, in rad/s.
    #[must_use]
    pub fn omega0(&self) -> f64 {
        self.force.omega0()
    }
    /// omega0^2, negative where the pendulum hangs from the other side.
    #[must_use]
    pub fn omega2(&self) -> f64 {
        self.force.omega2()
    }
}

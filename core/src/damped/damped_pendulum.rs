//! A pendulum with friction and torque, and its start.

use super::equation::Equation;
use super::friction::Friction;
use super::integrator::integrate;
use super::torque::Torque;
use super::trajectory::{Branch, Trajectory};
use crate::domain::Domain;
use crate::pendulum::{Frequency, Orbit};

/// theta'' + 2 gamma theta' + beta |theta'| theta' + mu z + omega0^2 sin theta = torque(t), from an initial state.
///
/// [`Friction`] says what z is: the sign of theta', or what presliding makes of it. At t = 0 presliding has settled
/// (z = sgn velocity0), or the pendulum is at rest and z = 0.
///
/// ```
/// use libration::{DampedPendulum, Frequency, Friction, Torque};
/// let friction = Friction::new(0.01, 0.02, 0.003, 0.0)?;
/// let pendulum = DampedPendulum::new(2.0, 0.0, Frequency::from_omega0(3.0)?, friction, Torque::NONE)?;
/// let trajectory = pendulum.trajectory(0.0, 60.0)?;
/// assert_eq!(format!("{:.9}", trajectory.theta(10.0)), "0.0");
/// # Ok::<(), libration::Domain>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct DampedPendulum {
    pub(super) theta0: f64,
    pub(super) velocity0: f64,
    pub(super) frequency: Frequency,
    pub(super) friction: Friction,
    pub(super) torque: Torque,
}

impl DampedPendulum {
    /// From an initial angle in rad and angular velocity in rad/s at t = 0.
    ///
    /// # Errors
    /// Where the angle or the velocity is not finite, and where samples of the torque do not hold t = 0.
    pub fn new(
        theta0: f64,
        velocity0: f64,
        frequency: Frequency,
        friction: Friction,
        torque: Torque,
    ) -> Result<DampedPendulum, Domain> {
        Domain::check("theta0", theta0, theta0.is_finite(), "finite")?;
        Domain::check("velocity0", velocity0, velocity0.is_finite(), "finite")?;
        let pendulum = DampedPendulum { theta0, velocity0, frequency, friction, torque };
        pendulum.within_samples("first torque time", 0.0)?;
        Ok(pendulum)
    }
    /// The angle at t = 0.
    #[must_use]
    pub fn theta0(&self) -> f64 {
        self.theta0
    }
    /// The angular velocity at t = 0.
    #[must_use]
    pub fn velocity0(&self) -> f64 {
        self.velocity0
    }
    /// The force.
    #[must_use]
    pub fn frequency(&self) -> Frequency {
        self.frequency
    }
    /// The friction.
    #[must_use]
    pub fn friction(&self) -> Friction {
        self.friction
    }
    /// The torque.
    #[must_use]
    pub fn torque(&self) -> &Torque {
        &self.torque
    }

    /// The motion from `start` <= 0 to `stop` >= 0, both in s; it may be evaluated there.
    ///
    /// Without friction and torque it is the exact [`Orbit`], bit for bit. Otherwise it is integrated by Taylor series of order
    /// 24 whose steps leave out less than 2^-66 of the motion, in at most [`MOST_SEGMENTS`](super::MOST_SEGMENTS) steps in each
    /// direction (some twenty in a period). **Error** of angle and velocity at most 1e-12 of the largest over 100 periods, plus
    /// 2^-60 of the condition: what a change of the state and of the constants by one part does after the same time.
    /// Source: Jorba & Zou, Exp. Math. 14 (2005) 99.
    ///
    /// # Errors
    /// Where the interval does not hold 0, is not finite, or leaves the samples of the torque; where the motion takes too many
    /// steps, or grows without bound because friction drives it; and for a `start` before 0 with presliding, whose earlier
    /// state no later one determines.
    pub fn trajectory(&self, start: f64, stop: f64) -> Result<Trajectory, Domain> {
        Domain::check("start", start, start.is_finite() && start <= 0.0, "finite and not above 0")?;
        Domain::check("stop", stop, stop.is_finite() && stop >= 0.0, "finite and not below 0")?;
        self.within_samples("start", start)?;
        self.within_samples("stop", stop)?;
        if self.friction.dry() != 0.0 && self.friction.presliding() != 0.0 {
            Domain::check("start", start, start == 0.0, "0 with presliding")?;
        }
        if self.friction.is_none() && self.torque.is_none() {
            let orbit = Orbit::new(self.theta0, self.velocity0, self.frequency)?;
            return Ok(Trajectory::exact(self.clone(), orbit, [start, stop]));
        }
        let [backward, forward] = self.branches(start, stop)?;
        Ok(Trajectory::integrated(self.clone(), [backward, forward], [start, stop]))
    }

    /// The integration in both senses of time.
    pub(super) fn branches(&self, start: f64, stop: f64) -> Result<[Branch; 2], Domain> {
        let branch = |sense: f64, end: f64| {
            let equation = Equation::new(self.velocity0, self.frequency, self.friction, &self.torque, sense);
            let segments = integrate(&equation, self.theta0, self.velocity0, equation.time(end))?;
            Ok(Branch { equation, segments })
        };
        Ok([branch(-1.0, start)?, branch(1.0, stop)?])
    }

    /// An error where samples of the torque do not hold a time.
    fn within_samples(&self, argument: &'static str, t: f64) -> Result<(), Domain> {
        let Some(samples) = &self.torque.samples else { return Ok(()) };
        let (first, last) = (samples.times[0], samples.times[samples.times.len() - 1]);
        if (first..=last).contains(&t) {
            return Ok(());
        }
        if argument == "first torque time" {
            let given = format!("{first:?} (the last is {last:?})");
            return Err(Domain::new(argument, given, "such that t = 0 lies between the first and the last"));
        }
        Err(Domain::new(
            argument,
            format!("{t:?}"),
            format!("between the torque samples, {first:?} to {last:?}"),
        ))
    }
}

//! A pendulum with friction and torque, and its start.

use super::friction::Friction;
use super::torque::{TORQUES, Torque};
use crate::domain::{Domain, shown};
use crate::pendulum::Frequency;

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
/// assert_eq!(format!("{:.9}", trajectory.theta(10.0)), "1.094168838");
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

    /// An error where samples of the torque do not hold a time.
    pub(super) fn within_samples(&self, argument: &'static str, t: f64) -> Result<(), Domain> {
        let Some(samples) = self.torque.samples.as_ref().filter(|_| TORQUES) else { return Ok(()) };
        let (first, last) = (samples.times[0], samples.times[samples.times.len() - 1]);
        if (first..=last).contains(&t) {
            return Ok(());
        }
        if argument == "first torque time" {
            let given = format!("{} (the last is {})", shown(first), shown(last));
            return Err(Domain::new(argument, given, "such that t = 0 lies between the first and the last"));
        }
        Err(Domain::new(
            argument,
            shown(t),
            format!("between the torque samples, {} to {}", shown(first), shown(last)),
        ))
    }
}

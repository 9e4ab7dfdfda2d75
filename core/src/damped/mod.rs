//! The pendulum with friction and torque: theta'' + 2 gamma theta' + beta |theta'| theta' + mu z + omega0^2 sin theta = torque(t).

mod circular;
mod damped_pendulum;
mod damped_sensitivity;
mod equation;
mod friction;
mod integrator;
mod jet;
mod roots;
mod segment;
mod torque;
mod trajectory;
mod variational;

pub use damped_pendulum::DampedPendulum;
pub use damped_sensitivity::{DampedJacobian, DampedSensitivity};
pub use friction::Friction;
pub use integrator::MOST_SEGMENTS;
pub use torque::{Interpolation, Torque};
pub use trajectory::Trajectory;
pub use variational::PARAMETERS;

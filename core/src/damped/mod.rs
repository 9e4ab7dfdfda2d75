//! The pendulum with friction and torque: theta'' + 2 gamma theta' + beta |theta'| theta' + mu z + omega0^2 sin theta = torque(t).

mod averaged;
mod averaged_decay;
mod branch;
mod circular;
mod damped_pendulum;
mod damped_sensitivity;
mod equation;
mod exact;
mod friction;
mod half_swing;
mod integrator;
mod jet;
mod jet_sum;
mod lazy_trajectory;
mod motion_series;
mod roots;
mod segment;
mod taylor;
mod torque;
mod torque_jet;
mod trajectory;
mod variational;

pub use averaged::{averaged_energy_loss, averaged_turning_rate};
pub use averaged_decay::averaged_turning_angle;
pub use damped_pendulum::DampedPendulum;
pub use damped_sensitivity::{DampedJacobian, DampedSensitivity};
pub use friction::Friction;
pub use half_swing::half_swing;
pub use integrator::{ASKED_EVERY, MOST_SEGMENTS};
pub use lazy_trajectory::LazyTrajectory;
pub use segment::Tolerance;
pub use torque::{Interpolation, Torque};
pub use trajectory::Trajectory;
pub use variational::PARAMETERS;

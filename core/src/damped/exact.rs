//! The motion without friction and torque, as a trajectory asks for it.

use crate::pendulum::Orbit;

/// What a trajectory asks an exact motion for its values. Behind a trait, so that a program that integrates every motion holds none of
/// its code.
pub(super) trait Exact: Send + Sync {
    fn orbit(&self) -> &Orbit;
    fn at(&self, t: f64) -> (f64, f64);
    fn at_into(&self, t: &[f64], theta: &mut [f64], velocity: &mut [f64]);
}

impl core::fmt::Debug for dyn Exact {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("an exact motion")
    }
}

impl Exact for Orbit {
    fn orbit(&self) -> &Orbit {
        self
    }
    fn at(&self, t: f64) -> (f64, f64) {
        self.motion(t)
    }
    fn at_into(&self, t: &[f64], theta: &mut [f64], velocity: &mut [f64]) {
        self.motion_into(t, theta, velocity);
    }
}

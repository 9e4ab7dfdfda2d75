//! In place of sine_model.rs where the feature `all-formulas` is left out: none can be made, so the room oscillator/, which is
//! as large as all the rest, is not linked.

use crate::domain::{Domain, shown};
use crate::pendulum::Orbit;

/// There is none.
#[derive(Clone, Debug)]
pub(super) enum NoSineModel {}

impl NoSineModel {
    /// Refused before (angle.rs).
    pub fn new(orbit: &Orbit, _: [[f64; 2]; 2]) -> Result<NoSineModel, Domain> {
        Err(Domain::new("formula", shown(orbit.theta0), "loaded"))
    }

    pub fn theta(&self, _: f64) -> f64 {
        match *self {}
    }

    pub fn period(&self) -> f64 {
        match *self {}
    }

    /// When it is infinite.
    pub fn escape_time(&self) -> f64 {
        match *self {}
    }
}

//! In place of sine_model.rs where the feature `sine-models` is left out: none can be made, so the room oscillator/, which is
//! as large as all the rest, is not linked.

use crate::domain::Domain;
use crate::pendulum::Orbit;

/// There is none.
#[derive(Clone, Debug)]
pub(super) enum NoSineModel {}

impl NoSineModel {
    /// Refused.
    pub fn new(_: &Orbit, _: [[f64; 2]; 2]) -> Result<NoSineModel, Domain> {
        let allowed = "any but cubic and cubic-quintic, until the whole core is loaded";
        Err(Domain::new("formula", "a polynomial in place of the sine".into(), allowed))
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

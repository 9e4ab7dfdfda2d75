//! The motion of a polynomial in place of the sine, solved exactly: theta - 40 theta^3/243, and with theta^5/131.
//!
//! Source: Salas 2019 (2), (3), (29).

use crate::domain::Domain;
use crate::float::Scaled;
use crate::oscillator::CubicQuintic;
use crate::pendulum::Orbit;

/// A motion of the room oscillator/.
#[derive(Clone, Debug)]
pub(super) struct SineModel(Box<CubicQuintic>);

/// omega0^2 times a number, rounded once.
fn coefficient(orbit: &Orbit, [above, below]: [f64; 2]) -> f64 {
    let (a, b, c) = orbit.force.factors();
    (Scaled::from(a) * b * above / (Scaled::from(c) * below)).value()
}

impl SineModel {
    /// With these coefficients of theta^3 and theta^5.
    pub fn new(orbit: &Orbit, [cubic, quintic]: [[f64; 2]; 2]) -> Result<SineModel, Domain> {
        let [p, q, s] = [[1.0; 2], cubic, quintic].map(|quotient| coefficient(orbit, quotient));
        let model = CubicQuintic::new(orbit.theta0, orbit.velocity0, p, q, s)?;
        Ok(SineModel(Box::new(model)))
    }

    pub fn theta(&self, t: f64) -> f64 {
        self.0.u(t)
    }

    pub fn period(&self) -> f64 {
        self.0.period()
    }

    /// When it is infinite.
    pub fn escape_time(&self) -> f64 {
        self.0.escape_time()
    }
}

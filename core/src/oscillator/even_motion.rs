//! Samples of a motion with even powers, and what an orbit is asked for.

use super::even_powers::EvenPowers;
use super::regime::OscillatorRegime;
use crate::float::scaled::Scaled;

impl EvenPowers {
    pub fn regime(&self) -> OscillatorRegime {
        self.regime
    }
    pub fn period(&self) -> f64 {
        self.period.value()
    }
    pub fn range(&self) -> (f64, f64) {
        self.range.map(Scaled::value).into()
    }
    pub fn escape_time(&self) -> f64 {
        self.escapes[1].value()
    }
    pub fn escape_time_backward(&self) -> f64 {
        self.escapes[0].value()
    }
    pub fn u0(&self) -> f64 {
        self.u0
    }
    pub fn velocity0(&self) -> f64 {
        self.velocity0
    }
    pub fn u_into(&self, t: &[f64], u: &mut [f64]) {
        for (t, u) in t.iter().zip(u) {
            *u = self.motion(*t).0;
        }
    }
    pub fn velocity_into(&self, t: &[f64], velocity: &mut [f64]) {
        for (t, velocity) in t.iter().zip(velocity) {
            *velocity = self.motion(*t).1;
        }
    }
    pub fn motion_into(&self, t: &[f64], u: &mut [f64], velocity: &mut [f64]) {
        for ((t, u), velocity) in t.iter().zip(u).zip(velocity) {
            (*u, *velocity) = self.motion(*t);
        }
    }
}

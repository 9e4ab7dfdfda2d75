//! Samples of a motion with even powers, and what an orbit is asked for.

use super::even_interpolant::MeanByInterpolant;
use super::even_lanes::{MeanFormula, ProductFormula};
use super::even_powers::{EvenLanes, EvenPowers, EvenSolution};
use super::regime::OscillatorRegime;
use crate::float::scaled::Scaled;
use crate::lanes::{Columns, Evaluation, Formula, Lane, Once, Second, WIDEST};
use crate::motion::samples::FromStart;

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

    /// The evaluation of the formula that serves this orbit.
    fn evaluate<E: Evaluation<1, 2>>(&self, evaluation: E) -> E::Output {
        let start = [self.u0, self.velocity0];
        match (&self.lanes, &self.solution) {
            (Some(EvenLanes::Mean(lanes)), EvenSolution::Mean(mean)) => {
                let Some(neville) = mean.curve.neville() else { return evaluation.of(&Careful(self)) };
                if let Some(polynomials) = lanes.by_polynomials(neville) {
                    let formula = MeanByInterpolant(lanes, polynomials);
                    return evaluation.of(&FromStart { formula, start });
                }
                if neville.by_hyperbolic() {
                    evaluation.of(&FromStart { formula: MeanFormula::<true>(lanes, neville), start })
                } else {
                    evaluation.of(&FromStart { formula: MeanFormula::<false>(lanes, neville), start })
                }
            }
            (Some(EvenLanes::Product(lanes)), EvenSolution::Product(product)) => {
                match product.curve.neville() {
                    Some(neville) if neville.hyperbolic() => {
                        evaluation.of(&FromStart { formula: ProductFormula::<true>(lanes, neville), start })
                    }
                    Some(neville) => {
                        evaluation.of(&FromStart { formula: ProductFormula::<false>(lanes, neville), start })
                    }
                    None => evaluation.of(&Careful(self)),
                }
            }
            _ => evaluation.of(&Careful(self)),
        }
    }

    pub fn motion(&self, t: f64) -> (f64, f64) {
        self.evaluate(Once([t])).into()
    }
    pub fn u_into(&self, t: &[f64], u: &mut [f64]) {
        self.evaluate(Columns::new([t], [u]));
    }
    pub fn velocity_into(&self, t: &[f64], velocity: &mut [f64]) {
        self.evaluate(Second(Columns::new([t], [velocity])));
    }
    pub fn motion_into(&self, t: &[f64], u: &mut [f64], velocity: &mut [f64]) {
        self.evaluate(Columns::new([t], [u, velocity]));
    }
}

/// One sample after the other.
struct Careful<'a>(&'a EvenPowers);

impl Formula<1, 2> for Careful<'_> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let (mut u, mut velocity) = ([0.0; WIDEST], [0.0; WIDEST]);
        t.store(&mut u);
        for i in 0..L::WIDTH {
            (u[i], velocity[i]) = self.0.careful_motion(u[i]);
        }
        [L::load(&u), L::load(&velocity)]
    }
}

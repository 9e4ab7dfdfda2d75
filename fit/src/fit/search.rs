//! The search for a minimum: Levenberg and Marquardt's method as MINPACK has it, from the crate `levenberg-marquardt`, compiled once for
//! every problem.

use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::{DMatrix, DVector, Dyn, Owned};

/// What is searched for the values at which its sum of squares is least.
pub(super) trait LeastSquares {
    fn assume(&mut self, values: &DVector<f64>);
    fn assumed(&self) -> DVector<f64>;
    fn residuals(&self) -> Option<DVector<f64>>;
    fn jacobian(&self) -> Option<DMatrix<f64>>;
}

struct Searched<'a>(&'a mut dyn LeastSquares);

impl LeastSquaresProblem<f64, Dyn, Dyn> for Searched<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, params: &DVector<f64>) {
        self.0.assume(params);
    }
    fn params(&self) -> DVector<f64> {
        self.0.assumed()
    }
    fn residuals(&self) -> Option<DVector<f64>> {
        self.0.residuals()
    }
    fn jacobian(&self) -> Option<DMatrix<f64>> {
        self.0.jacobian()
    }
}

/// Leaves a problem at the values that a search from its own reaches.
pub(super) fn descend(problem: &mut dyn LeastSquares, method: LevenbergMarquardt<f64>) {
    // The first steps stay where the linear form of the problem holds.
    method.with_stepbound(1.0).minimize(Searched(problem));
}

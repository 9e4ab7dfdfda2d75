//! The turning angles for which the error of an approximation of the angle stays within a bound: a grid of degrees, and
//! bisection between a good and a bad one.

use super::angle::AngleFormula;
use super::measure::{Ended, LargestError, check_periods};
use super::search::intervals;
use crate::domain::Domain;
use crate::float::PI;
use crate::pendulum::{Frequency, Orbit};
use crate::sorting::sort_numbers;

/// Turning angles in degrees between whole ones, where ranges may end near the bottom and the top.
const ENDS: [f64; 12] =
    [1e-4, 1e-3, 1e-2, 0.1, 0.5, 179.5, 179.9, 179.95, 179.99, 179.999, 179.9999, 179.999_999];

impl AngleFormula {
    /// Whether the error of a release from rest stays within a share of the turning angle; undefined counts as beyond.
    fn within(&self, theta_max: f64, bound: f64, periods: f64, ended: Ended<'_>) -> bool {
        let made = Frequency::from_omega0(1.0)
            .and_then(|one| Orbit::new(theta_max, 0.0, one))
            .and_then(|orbit| self.of(&orbit));
        let Ok(made) = made else { return false };
        let LargestError { difference, undefined_from, .. } = made.largest(periods, bound * theta_max, ended);
        difference <= bound * theta_max && undefined_from.is_nan()
    }

    /// The turning angles in rad, as intervals within (0, pi), for which the largest error over `periods` exact periods of
    /// a release from rest stays at most `bound` times the turning angle.
    ///
    /// Found on a grid of degrees, finer at both ends, and by bisection; an interval that reaches the ends of the grid
    /// (1e-4 degrees, and 1e-6 degrees below the top) is given as reaching 0 or pi.
    pub fn ranges(&self, bound: f64, periods: f64) -> Result<Vec<[f64; 2]>, Domain> {
        self.ranges_unless(bound, periods, &|| false)
    }

    /// [`AngleFormula::ranges`], where `ended` is asked at every step: once it is true, and it must stay so, the search is
    /// cut short and the answer means nothing.
    pub fn ranges_unless(
        &self,
        bound: f64,
        periods: f64,
        ended: &dyn Fn() -> bool,
    ) -> Result<Vec<[f64; 2]>, Domain> {
        Domain::check("bound", bound, bound > 0.0 && bound.is_finite(), "finite and positive")?;
        check_periods(periods)?;
        let mut angles: Vec<f64> =
            (1..180).map(f64::from).chain(ENDS).map(|angle| angle * (PI.hi / 180.0)).collect();
        sort_numbers(&mut angles);
        let angles = angles.into_iter().take_while(|_| !ended());
        Ok(intervals(angles, [0.0, PI.hi], |angle| self.within(angle, bound, periods, ended)))
    }
}

//! How far an approximation of the angle is from the exact one: its largest error over some periods, and the turning
//! angles for which that stays within a bound.
//!
//! A grid fine enough for every harmonic that the difference has; then golden sections about each point that may lead to
//! the largest, and bisections where the approximation begins and ends to be defined.

use super::angle::{AngleApproximation, AngleFormula, Shape};
use super::search::{Point, crossing, maximum};
use crate::domain::Domain;
use crate::float::PI;
use crate::pendulum::{Frequency, Orbit, Regime};

/// The largest difference from the exact angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LargestError {
    /// |approximate - exact| in rad, where the approximation is defined; infinite where it escapes to infinity.
    pub difference: f64,
    /// The first time in s at which it is as large.
    pub t: f64,
    /// The first time in s at which the approximation is undefined; NaN if it is always defined.
    pub undefined_from: f64,
}

/// Most periods of a search.
pub const MOST_PERIODS: f64 = 10_000.0;

/// Points of the grid to the shorter of the exact and the linear period, and to each harmonic of a series.
const TO_A_PERIOD: f64 = 128.0;
const TO_A_HARMONIC: f64 = 16.0;
/// How much faster than the pendulum a model may swing and be followed in every swing.
const FASTEST: f64 = 1000.0;
/// Most points of a grid, and most tops to be looked at again.
const MOST_POINTS: f64 = 1e7;
const MOST_TOPS: usize = 20_000;
/// How much the parabola through three neighbours may miss of a top between them: of a smooth one, and of one next to the
/// end of an arcsine.
const SLACK: f64 = 0.02;
const SLACK_OF_SERIES: f64 = 0.3;
/// Two tops of one height, but for rounding.
const SAME: f64 = 1e-9;

impl AngleApproximation {
    fn size(&self, t: f64) -> f64 {
        self.difference(t).abs()
    }

    /// Whether the difference repeats with the exact motion.
    fn repeats(&self) -> bool {
        matches!(self.shape, Shape::Harmonic(_) | Shape::Arcsine(_) | Shape::Series(_) | Shape::Bounded(_))
    }

    /// How long to search, and the step.
    fn search(&self, periods: f64) -> (f64, f64) {
        let (period, omega0) = (self.orbit.period(), self.orbit.omega0());
        // Released from rest the two halves of each swing mirror each other.
        let mirrored = self.orbit.velocity0 == 0.0 && self.orbit.regime() == Regime::Libration;
        let enough = match (self.repeats(), mirrored) {
            (false, _) => periods,
            (true, false) => periods.min(1.0),
            (true, true) => periods.min(0.25),
        };
        let order = f64::from(self.formula().order());
        let own = self.period();
        let mut shortest = if omega0 > 0.0 { period.min(2.0 * PI.hi / omega0) } else { period };
        shortest = if own < shortest { own.max(shortest / FASTEST) } else { shortest };
        let harmonics = if self.repeats() { TO_A_HARMONIC * (2.0 * order + 3.0) } else { 0.0 };
        // The secular terms make the steps of the arctangent as much narrower as they have grown.
        let grown = if matches!(self.shape, Shape::Secular(_)) {
            1.0 + f64::min(self.orbit.energy_ratio(), 1.0) * omega0 * enough * period
        } else {
            1.0
        };
        let step = (shortest / (TO_A_PERIOD * grown)).min(period / harmonics.max(1.0));
        let points = (enough * period / step).ceil().clamp(1.0, MOST_POINTS);
        (enough * period, enough * period / points)
    }

    /// The largest |difference| over the time from 0 to `periods` (above 0, at most 10 000) exact periods, of one turn in
    /// rotation. Refused on the separatrix, which has no period.
    ///
    /// **Error** relative 1e-9 of the difference found, plus the rounding of [`AngleApproximation::difference`]; more where a
    /// model swings over 1000 times as fast as the pendulum, and of `small-m` where m omega0 t is beyond some 1000.
    pub fn largest_error(&self, periods: f64) -> Result<LargestError, Domain> {
        let allowed = "above 0 and at most 10000";
        Domain::check("periods", periods, periods > 0.0 && periods <= MOST_PERIODS, allowed)?;
        if self.orbit.regime() == Regime::Separatrix {
            let allowed = "libration or rotation for an error over periods";
            return Err(Domain::new("regime", self.orbit.regime().name().into(), allowed));
        }
        Ok(self.largest(periods, f64::INFINITY))
    }

    /// The largest difference; or the first found beyond a limit, or the first undefined with a limit, as soon as it is found.
    fn largest(&self, periods: f64, limit: f64) -> LargestError {
        if matches!(self.shape, Shape::Exact) {
            return LargestError { difference: 0.0, t: 0.0, undefined_from: f64::NAN };
        }
        let (duration, step) = self.search(periods);
        if let Shape::Model(model) = &self.shape {
            let escape = model.escape_time();
            if escape <= duration {
                return LargestError { difference: f64::INFINITY, t: escape, undefined_from: escape };
            }
        }
        let limited = limit < f64::INFINITY;
        let mut best =
            LargestError { difference: 0.0, t: 0.0, undefined_from: self.undefined_from(duration, step) };
        if limited && !best.undefined_from.is_nan() {
            return best;
        }
        let slack = if self.repeats() { SLACK_OF_SERIES } else { SLACK };
        let points = (duration / step).round();
        let mut tops: Vec<[Point; 3]> = Vec::new();
        let mut height = 0.0;
        let at = |i: f64| (step * i, self.size(step * i));
        let mut before = (0.0, f64::NAN);
        let mut here = at(0.0);
        let mut i = 0.0;
        while i <= points {
            let after = if i < points { at(i + 1.0) } else { (duration, f64::NAN) };
            if here.1 > limit || here.1 == f64::INFINITY {
                return LargestError { difference: here.1, t: here.0, ..best };
            }
            // A NaN beside is not larger, and a NaN here not above 0.
            let top = !(before.1 > here.1 || after.1 > here.1);
            if top && here.1 > 0.0 {
                let bracket = self.defined(before, here, after);
                height = f64::max(height, here.1);
                if estimate(&bracket) >= height * (1.0 - slack) {
                    tops.push(bracket);
                }
                if tops.len() > 2 * MOST_TOPS {
                    // The sort is stable: of equal ones the first stay.
                    tops.sort_by(|a, b| estimate(b).total_cmp(&estimate(a)));
                    tops.truncate(MOST_TOPS);
                    tops.sort_by(|a, b| a[1].0.total_cmp(&b[1].0));
                }
            }
            (before, here, i) = (here, after, i + 1.0);
        }
        let height = tops.iter().map(estimate).fold(0.0, f64::max);
        for bracket in tops.iter().filter(|bracket| estimate(bracket) >= height * (1.0 - slack)) {
            let (t, difference) = maximum(bracket, |t| self.size(t));
            if difference > best.difference * (1.0 + SAME) {
                best = LargestError { difference, t, ..best };
            }
        }
        best
    }

    /// Three neighbours of the grid, an undefined one replaced by the last defined point before it.
    fn defined(&self, before: Point, here: Point, after: Point) -> [Point; 3] {
        let [low, high] = [before, after].map(|side| {
            if !side.1.is_nan() || side.0 == here.0 {
                return side;
            }
            let t = crossing(|t| !self.size(t).is_nan(), here.0, side.0);
            (t, self.size(t))
        });
        let [low, high] = [low, high].map(|side| if side.1.is_nan() { here } else { side });
        let [first, last] = if low.0 <= high.0 { [low, high] } else { [high, low] };
        [first, here, last]
    }

    /// The first time at which the approximation is undefined, or NaN.
    fn undefined_from(&self, duration: f64, step: f64) -> f64 {
        let Shape::Arcsine(series) = &self.shape else { return f64::NAN };
        let margin = |t: f64| series.margin(&self.orbit, t);
        let points = (duration / step).round();
        let mut i = 0.0;
        let mut before = (0.0, f64::NAN);
        let mut here = (0.0, margin(0.0));
        while i <= points {
            if here.1 < 0.0 {
                let first = if i == 0.0 { 0.0 } else { crossing(|t| margin(t) < 0.0, here.0, before.0) };
                return first;
            }
            let next = step * (i + 1.0);
            let after = if i < points { (next, margin(next)) } else { (here.0, f64::NAN) };
            // Between the points the margin may go below 0 and come back.
            if i > 0.0 && i < points && here.1 <= before.1 && here.1 <= after.1 {
                let (t, least) =
                    maximum(&[before, here, after].map(|(t, margin)| (t, -margin)), |t| -margin(t));
                if least > 0.0 {
                    return crossing(|t| margin(t) < 0.0, t, before.0);
                }
            }
            (before, here, i) = (here, after, i + 1.0);
        }
        f64::NAN
    }
}

/// The value of a parabola's top through three points, not below the middle one.
fn estimate(&[low, here, high]: &[Point; 3]) -> f64 {
    let (left, right) = (here.1 - low.1, here.1 - high.1);
    let (bend, slope) = (left + right, left - right);
    let above = if bend > 0.0 { slope * slope / (8.0 * bend) } else { 0.0 };
    if above.is_finite() { here.1.max(low.1).max(high.1) + above } else { f64::INFINITY }
}

/// Turning angles in degrees between whole ones, where ranges may end near the bottom and the top.
const ENDS: [f64; 12] =
    [1e-4, 1e-3, 1e-2, 0.1, 0.5, 179.5, 179.9, 179.95, 179.99, 179.999, 179.9999, 179.999_999];

impl AngleFormula {
    /// Whether the error of a release from rest stays within a share of the turning angle; undefined counts as beyond.
    fn within(&self, theta_max: f64, bound: f64, periods: f64) -> bool {
        let made = Frequency::from_omega0(1.0)
            .and_then(|one| Orbit::new(theta_max, 0.0, one))
            .and_then(|orbit| self.of(&orbit));
        let Ok(made) = made else { return false };
        let LargestError { difference, undefined_from, .. } = made.largest(periods, bound * theta_max);
        difference <= bound * theta_max && undefined_from.is_nan()
    }

    /// The turning angles in rad, as intervals within (0, pi), for which the largest error over `periods` exact periods of
    /// a release from rest stays at most `bound` times the turning angle.
    ///
    /// Found on a grid of degrees, finer at both ends, and by bisection; an interval that reaches the ends of the grid
    /// (1e-4 degrees, and 1e-6 degrees below the top) is given as reaching 0 or pi.
    pub fn ranges(&self, bound: f64, periods: f64) -> Result<Vec<[f64; 2]>, Domain> {
        Domain::check("bound", bound, bound > 0.0 && bound.is_finite(), "finite and positive")?;
        let allowed = "above 0 and at most 10000";
        Domain::check("periods", periods, periods > 0.0 && periods <= MOST_PERIODS, allowed)?;
        let mut angles: Vec<f64> =
            (1..180).map(f64::from).chain(ENDS).map(|angle| angle * (PI.hi / 180.0)).collect();
        angles.sort_by(f64::total_cmp);
        let holds = |angle: f64| self.within(angle, bound, periods);
        let mut found: Vec<[f64; 2]> = Vec::new();
        let mut open: Option<f64> = None;
        let mut before = 0.0;
        for angle in &angles {
            let (angle, good) = (*angle, holds(*angle));
            match (open, good) {
                (None, true) => {
                    open = Some(if before == 0.0 { 0.0 } else { crossing(holds, angle, before) });
                }
                (Some(low), false) => {
                    found.push([low, crossing(holds, before, angle)]);
                    open = None;
                }
                _ => {}
            }
            before = angle;
        }
        found.extend(open.map(|low| [low, PI.hi]));
        Ok(found)
    }
}

//! How far an approximation of the angle is from the exact one: its largest error over some periods.
//!
//! A grid fine enough for every harmonic that the difference has; then golden sections about each point that may lead to
//! the largest, and bisections where the approximation begins and ends to be defined. The secular formula turns from
//! -pi to pi the faster the later; there the grid is finer in geometric progression towards each turn, so that the work
//! grows with the time and not with its square.

use super::angle::{AngleApproximation, Shape};
use super::search::{Point, crossing, maximum};
use crate::domain::Domain;
use crate::float::PI;
use crate::pendulum::Regime;
use crate::sorting::sort;

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

/// The caller's answer to whether it has given up; once true, always true.
pub(super) type Ended<'a> = &'a dyn Fn() -> bool;

impl AngleApproximation {
    fn size(&self, t: f64) -> f64 {
        self.difference(t).abs()
    }

    /// The difference's size, and how far on the next point may lie, in s.
    fn look(&self, t: f64) -> (f64, f64) {
        if let Shape::Secular(secular) = &self.shape {
            let (theta, stride) = secular.theta_and_stride(t);
            return ((theta - self.orbit.theta(t)).abs(), stride);
        }
        (self.size(t), f64::INFINITY)
    }

    /// Whether the difference repeats with the exact motion.
    fn repeats(&self) -> bool {
        matches!(self.shape, Shape::Harmonic(_) | Shape::Arcsine(_) | Shape::Series(_) | Shape::Bounded(_))
    }

    /// How long to search, and the largest step.
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
        let step = (shortest / TO_A_PERIOD).min(period / harmonics.max(1.0));
        let points = (enough * period / step).ceil().clamp(1.0, MOST_POINTS);
        (enough * period, enough * period / points)
    }

    /// The largest |difference| over the time from 0 to `periods` (above 0, at most 10 000) exact periods, of one turn in
    /// rotation. Refused on the separatrix, which has no period.
    ///
    /// **Error** relative 1e-9 of the difference found, plus the rounding of [`AngleApproximation::difference`]; more where a
    /// model swings over 1000 times as fast as the pendulum.
    pub fn largest_error(&self, periods: f64) -> Result<LargestError, Domain> {
        self.largest_error_unless(periods, &|| false)
    }

    /// [`AngleApproximation::largest_error`], where `ended` is asked at every step: once it is true, and it must stay so,
    /// the search is cut short and the answer means nothing.
    pub fn largest_error_unless(
        &self,
        periods: f64,
        ended: &dyn Fn() -> bool,
    ) -> Result<LargestError, Domain> {
        check_periods(periods)?;
        if self.orbit.regime() == Regime::Separatrix {
            let allowed = "libration or rotation for an error over periods";
            return Err(Domain::new("regime", self.orbit.regime().name().into(), allowed));
        }
        Ok(self.largest(periods, f64::INFINITY, ended))
    }

    /// The largest difference; or the first found beyond a limit, or the first undefined with a limit, as soon as it is found.
    pub(super) fn largest(&self, periods: f64, limit: f64, ended: Ended<'_>) -> LargestError {
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
        let mut best = LargestError {
            difference: 0.0,
            t: 0.0,
            undefined_from: self.undefined_from(duration, step, ended),
        };
        if limited && !best.undefined_from.is_nan() {
            return best;
        }
        let slack = if self.repeats() { SLACK_OF_SERIES } else { SLACK };
        let mut tops: Vec<[Point; 3]> = Vec::new();
        let mut height = 0.0;
        let mut before = (0.0, f64::NAN);
        let mut grid = Grid { step, points: (duration / step).round(), even: 0.0, between: 0.0 };
        let (size, mut stride) = self.look(0.0);
        let mut here = (0.0, size);
        let mut last = false;
        // Ends: each step is the next of the multiples, or one of those between them, of which there are BETWEEN for each.
        while !last && !ended() {
            let after = match grid.next(here.0, stride) {
                Some(t) => {
                    let (size, next) = self.look(t);
                    stride = next;
                    (t, size)
                }
                None => {
                    last = true;
                    (duration, f64::NAN)
                }
            };
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
                    sort(&mut tops, |a, b| estimate(b).total_cmp(&estimate(a)));
                    tops.truncate(MOST_TOPS);
                    sort(&mut tops, |a, b| a[1].0.total_cmp(&b[1].0));
                }
            }
            (before, here) = (here, after);
        }
        let height = tops.iter().map(estimate).fold(0.0, f64::max);
        for bracket in tops.iter().filter(|bracket| estimate(bracket) >= height * (1.0 - slack)) {
            if ended() {
                break;
            }
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
    fn undefined_from(&self, duration: f64, step: f64, ended: Ended<'_>) -> f64 {
        let Shape::Arcsine(series) = &self.shape else { return f64::NAN };
        let margin = |t: f64| series.margin(&self.orbit, t);
        let points = (duration / step).round();
        let mut i = 0.0;
        let mut before = (0.0, f64::NAN);
        let mut here = (0.0, margin(0.0));
        while i <= points && !ended() {
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

/// The number of periods, where it is one.
pub(super) fn check_periods(periods: f64) -> Result<f64, Domain> {
    let allowed = "above 0 and at most 10000";
    Domain::check("periods", periods, periods > 0.0 && periods <= MOST_PERIODS, allowed)
}

/// Of a step: what is shorter the differences of late times do not hold.
const FINEST: f64 = 1e-7;
/// Most times between two multiples of the step, in the mean and beyond a beginning: the time of a search is that of its
/// multiples. A swing from rest takes three.
const BETWEEN: f64 = 16.0;
const BEGINNING: f64 = 64.0;

/// The times of a search: multiples of a step, so that nothing adds up, and times between where they are asked for.
struct Grid {
    step: f64,
    points: f64,
    /// The last multiple, and how many times there were between.
    even: f64,
    between: f64,
}

impl Grid {
    /// The time after another one, at most a stride later; `None` after the last.
    fn next(&mut self, t: f64, stride: f64) -> Option<f64> {
        let after = (self.even + 1.0) * self.step;
        let stride = stride.max(FINEST * self.step);
        let allowed = BETWEEN * (self.even + BEGINNING);
        if t + stride < after && self.even < self.points && self.between < allowed {
            self.between += 1.0;
            return Some(t + stride);
        }
        self.even += 1.0;
        (self.even <= self.points).then_some(after)
    }
}

/// The value of a parabola's top through three points, not below the middle one.
fn estimate(&[low, here, high]: &[Point; 3]) -> f64 {
    // Where a neighbour is missing the distance of the other one serves.
    let (to_low, to_high) = (here.0 - low.0, high.0 - here.0);
    let before = if to_low > 0.0 { to_low } else { to_high };
    let after = if to_high > 0.0 { to_high } else { to_low };
    let (rise, fall) = ((here.1 - low.1) / before, (here.1 - high.1) / after);
    let (bend, slope) = ((rise + fall) / (before + after), (rise * after - fall * before) / (before + after));
    let above = if bend > 0.0 { slope * slope / (4.0 * bend) } else { 0.0 };
    if above.is_finite() { here.1.max(low.1).max(high.1) + above } else { f64::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::super::angle::AngleFormula;
    use crate::{Frequency, Orbit};

    /// The truth by mpmath at 30 digits from a dense search of Salas's formula for a release from rest, written out.
    #[test]
    fn secular_errors_over_many_periods() {
        let orbit = Orbit::new(2.0, 0.0, Frequency::from_omega0(1.0).unwrap()).unwrap();
        let made = AngleFormula::named("small-m").unwrap().of(&orbit).unwrap();
        let found = made.largest_error(100.0).unwrap();
        assert!((found.difference / 5.132768906092901 - 1.0).abs() < 1e-9, "{found:?}");
        assert!((found.t - 830.801832358).abs() < 1e-4, "{found:?}");
    }

    /// The number of looks grows with the number of periods, not with its square.
    #[test]
    fn the_work_grows_with_the_time() {
        let orbit = Orbit::new(2.0, 0.3, Frequency::from_omega0(1.0).unwrap()).unwrap();
        let made = AngleFormula::named("small-m").unwrap().of(&orbit).unwrap();
        let looks = |periods: f64| {
            let count = core::cell::Cell::new(0u32);
            let ended = || {
                count.set(count.get() + 1);
                false
            };
            made.largest_error_unless(periods, &ended).unwrap();
            f64::from(count.get())
        };
        let [short, long] = [10.0, 160.0].map(looks);
        assert!(long < 2.0 * 16.0 * short, "{short} {long}");
    }

    #[test]
    fn a_search_ends_when_its_caller_gives_up() {
        let orbit = Orbit::new(2.0, 0.0, Frequency::from_omega0(1.0).unwrap()).unwrap();
        let formula = AngleFormula::named("small-m").unwrap();
        let made = formula.of(&orbit).unwrap();
        let count = core::cell::Cell::new(0);
        let ended = || {
            count.set(count.get() + 1);
            count.get() > 100
        };
        made.largest_error_unless(10_000.0, &ended).unwrap();
        formula.ranges_unless(1e-3, 10_000.0, &ended).unwrap();
        assert!(count.get() < 1000, "{}", count.get());
    }
}

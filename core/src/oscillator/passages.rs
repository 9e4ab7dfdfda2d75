//! When a value is passed: the inverse of the motion.
//!
//! With 6 u'^2 at the value from a sum without rounding, its argument is that of a start there (nonzero_energy.rs), so that
//! passages keep their digits at zeros, turning points and next to escapes.

use super::cubic_quintic::CubicQuintic;
use super::nonzero_energy::Argument;
use super::set_up::Solution;
use crate::domain::Domain;
use crate::elliptic::phase::Phase;
use crate::float::Dd;
use crate::float::dyadic::Dyadic;
use crate::float::scaled::Scaled;
use crate::motion::passages::Interval;
use crate::sorting::sort_numbers;

impl CubicQuintic {
    /// The argument of a value, and whether the motion turns there; `None` where it does not get.
    fn argument_of(&self, u: f64) -> Option<(Argument, bool)> {
        let y = Dyadic::from(u).square();
        let (low, high) = self.range();
        let turns = match &self.set_up.solution {
            Solution::Theta(_) => u == low || u == high,
            Solution::Elementary(given, _) => given.turn() == Some(u.abs()),
            Solution::Line(_) | Solution::Equilibrium => false,
        };
        let square_speed = if u.abs() == self.u0.abs() {
            Dyadic::from(self.velocity0).square() * 6.0
        } else if turns {
            Dyadic::ZERO
        } else {
            self.energy.square_speed(&y)
        };
        if square_speed.sign() < 0 || !(low <= u && u <= high) {
            return None;
        }
        let energy_case = self.set_up.energy_case.as_ref()?;
        Some((energy_case.argument(&y, &square_speed), turns || square_speed.sign() == 0))
    }

    /// All times from `start` to `stop` (both included) at which the motion passes `u`, rising.
    ///
    /// | argument | domain |
    /// |---|---|
    /// | `u` | finite; none where the motion does not get, or only in infinite time |
    /// | `start`, `stop` | `start` <= `stop`; with more than 10^7 passages between them, or beyond 2^53 half periods, an error |
    ///
    /// **Error** at most 4 ulp of the largest of the period, |start| and |stop|, plus 2^-100 of the condition.
    /// **Source** DLMF 19.29.4, 22.15(ii).
    ///
    /// # Errors
    /// A [`Domain`] that names the argument, or says that the passages are too many.
    ///
    /// ```
    /// let spring = libration::CubicQuintic::new(1.0, 0.0, 1.0, 1.0, 1.0)?;
    /// assert_eq!(spring.times(0.0, 0.0, 4.0)?.len(), 2);
    /// # Ok::<(), libration::Domain>(())
    /// ```
    pub fn times(&self, u: f64, start: f64, stop: f64) -> Result<Vec<f64>, Domain> {
        self.times_unless(u, start, stop, &|| false)
    }

    /// [`CubicQuintic::times`], where `ended` is asked now and then: once it is true, the times are cut short and mean nothing.
    pub fn times_unless(
        &self,
        u: f64,
        start: f64,
        stop: f64,
        ended: &dyn Fn() -> bool,
    ) -> Result<Vec<f64>, Domain> {
        Domain::check("u", u, u.is_finite(), "finite")?;
        let interval = Interval::new(start, stop, ended)?;
        let Some((argument, turns)) = self.argument_of(u) else { return Ok(Vec::new()) };
        let crosses = self.range().0 < 0.0 && self.range().1 > 0.0;
        let mirrored = u != 0.0 && (u < 0.0) != (self.set_up.orientation.sign < 0.0);
        let mut times = match &self.set_up.solution {
            Solution::Equilibrium => Vec::new(),
            Solution::Theta(theta) if theta.repeats() => {
                let at = theta.in_half_periods(argument).base.to_dd();
                let Phase { rate, start } = theta.clock.phase;
                // The count of repetitions rises with time.
                let falls = rate.hi < 0.0;
                let (rate, start) = if falls { (-rate, -start) } else { (rate, start) };
                let at = if mirrored != falls { -at } else { at };
                // Odd: mirrored about the turning point half a half period on; even: about the base.
                let middle = if falls { -Dd::ONE } else { Dd::ONE };
                let (spacing, other) = if crosses { (2.0, middle - at) } else { (1.0, -at) };
                let phases = [at, other].map(|at| at - start);
                let different = if turns { 1 } else { 2 };
                return interval.repeated(rate, theta.clock.time, &phases[..different], spacing);
            }
            Solution::Theta(theta) => {
                passages(theta.in_half_periods(argument), crosses, mirrored, turns, theta.rates())
            }
            Solution::Elementary(given, _) | Solution::Line(given) => {
                let once = turns || given.turn().is_none();
                passages(argument, crosses, mirrored, once, [given.base, given.rest])
            }
        };
        times.retain(|t| t.is_finite() && interval.holds(*t));
        sort_numbers(&mut times);
        times.dedup();
        Ok(times)
    }
}

/// Times of a motion that does not repeat, `once` where it passes only once; `rates` are the arguments at the start and
/// per time, from the base and to the pole.
fn passages(at: Argument, crosses: bool, mirrored: bool, once: bool, rates: [[Scaled; 2]; 2]) -> Vec<f64> {
    let [[base, base_rate], [rest, rest_rate]] = rates;
    let along = |argument: Scaled| ((argument - base) / base_rate).value();
    // Next to the pole its own count has the digits.
    let near_pole = at.pole.is_positive() && (at.pole - at.base).is_negative();
    let ahead = if near_pole { ((at.pole - rest) / rest_rate).value() } else { along(at.base) };
    match (crosses, mirrored) {
        (true, true) => vec![along(-at.base)],
        (true, false) => vec![ahead],
        _ if once => vec![ahead],
        _ => vec![ahead, along(-at.base)],
    }
}

//! What a motion of the cubic-quintic oscillator keeps: frequency, action, phase, mean and harmonics.
//!
//! Action and harmonics are integrals over half a swing (swing_integrals.rs); the phase counts the periods of the theta functions.

use super::cubic_quintic::CubicQuintic;
use super::regime::OscillatorRegime;
use super::set_up::Solution;
use super::swing_interval::SwingInterval;
use crate::elliptic::phase::Phase;
use crate::float::scaled::Scaled;
use crate::float::{Dd, TWO_PI};

impl CubicQuintic {
    /// The period in double-double; infinite unless the motion repeats.
    pub(super) fn long_period(&self) -> Scaled {
        match &self.set_up.solution {
            Solution::Theta(theta) if theta.repeats() => {
                let half = theta.half_period() / self.omega();
                if self.crosses() { half.shift(1) } else { half }
            }
            Solution::Equilibrium => {
                let stiffness = self.energy.stiffness(self.u0);
                if stiffness.is_positive() {
                    Scaled::from(TWO_PI) / stiffness.sqrt()
                } else {
                    Scaled::INFINITY
                }
            }
            _ => Scaled::INFINITY,
        }
    }

    /// Argument of the theta functions per unit of time.
    fn omega(&self) -> Scaled {
        self.set_up.energy_case.as_ref().map_or(Scaled::NAN, |case| case.outline().omega)
    }

    /// Whether the motion passes u = 0.
    pub(super) fn crosses(&self) -> bool {
        let [low, high] = self.set_up.range;
        low < 0.0 && high > 0.0
    }

    pub(super) fn long_frequency(&self) -> Scaled {
        match self.regime() {
            OscillatorRegime::Homoclinic | OscillatorRegime::Heteroclinic => Scaled::ZERO,
            OscillatorRegime::Rest if !self.period().is_finite() => Scaled::ZERO,
            _ => {
                let period = self.long_period();
                if period.is_finite() { Scaled::from(TWO_PI) / period } else { Scaled::NAN }
            }
        }
    }

    pub(super) fn long_action(&self) -> Scaled {
        if self.regime() == OscillatorRegime::Rest {
            return Scaled::ZERO;
        }
        let repeats = matches!(self.set_up.solution, Solution::Theta(_));
        let stays = self.escape_time() == f64::INFINITY && self.escape_time_backward() == f64::NEG_INFINITY;
        let Some(interval) = self.set_up.energy_case.as_ref().filter(|_| stays).and_then(SwingInterval::new)
        else {
            return Scaled::NAN;
        };
        // There and back, on both sides of u = 0 where the motion crosses.
        let both = if self.crosses() { 2 } else { 1 };
        interval.of_velocity(repeats).shift(both) / Scaled::from(TWO_PI)
    }

    /// Action (1/2 pi) closed integral of u' du of a libration and in a well; 0 at rest; on a separatrix that of the way out and
    /// back (of a heteroclinic one there and back); NaN for a motion that does not stay.
    ///
    /// **Error** at most 4 ulp, plus 2^-100 of its condition. **Source** the trapezoidal rule of an integrand whose analyticity is
    /// known: swing_integrals.rs.
    ///
    /// ```
    /// let spring = libration::CubicQuintic::new(1.0, 0.0, 1.0, 1.0, 1.0)?;
    /// assert_eq!(format!("{:.9} {:.9}", spring.action(), spring.frequency()), "0.720253091 1.523586030");
    /// # Ok::<(), libration::Domain>(())
    /// ```
    #[must_use]
    pub fn action(&self) -> f64 {
        self.long_action().value()
    }

    /// Mean angular frequency, 2 pi over the period; 0 on a separatrix, NaN for a motion that does not stay.
    ///
    /// **Error** at most 4 ulp, plus 2^-100 of its condition. **Source** 2 pi over [`CubicQuintic::period`].
    #[must_use]
    pub fn frequency(&self) -> f64 {
        self.long_frequency().value()
    }

    /// The phase in turns at t = 0 in (-1/2, 1/2], and turns per time over a power of two: 0 at the highest point.
    pub(super) fn phase_turns(&self) -> Option<(Phase, f64)> {
        match &self.set_up.solution {
            Solution::Theta(theta) if theta.repeats() => {
                let Phase { rate, start } = theta.clock.phase;
                let forward = if rate.hi < 0.0 { -1.0 } else { 1.0 };
                let (rate, start) = (rate * forward, start * forward);
                let sign = self.set_up.orientation.sign;
                let (rate, start, of_base) = if self.crosses() {
                    // At u = 0, which rises to the highest point where both signs agree.
                    (rate.half(), start.half(), if sign * forward > 0.0 { -0.25 } else { 0.25 })
                } else {
                    (rate, start, if sign > 0.0 { 0.5 } else { 0.0 })
                };
                let start = start + Dd::from(of_base);
                let start = start - Dd::from(start.hi.round());
                let start = if start.hi <= -0.5 { start + Dd::ONE } else { start };
                Some((Phase { rate, start }, theta.clock.time))
            }
            Solution::Equilibrium if self.period().is_finite() => {
                let (rate, time) = (Scaled::ONE / self.long_period()).carried();
                Some((Phase { rate, start: Dd::ZERO }, time))
            }
            _ => None,
        }
    }

    /// Phase in rad at t, which grows evenly with the slope [`CubicQuintic::frequency`]: 0 at the highest point, and in (-pi, pi]
    /// at t = 0. NaN where the motion does not repeat.
    ///
    /// **Error** at most 4 ulp of the larger of the phase and pi. **Source** DLMF 22.19(i).
    #[must_use]
    pub fn phase(&self, t: f64) -> f64 {
        if self.regime() == OscillatorRegime::Rest && !self.period().is_finite() {
            return 0.0 * t;
        }
        let Some((turns, time)) = self.phase_turns() else { return f64::NAN };
        (turns.counted(t * time) * TWO_PI).value()
    }
}

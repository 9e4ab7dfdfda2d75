//! What a bounded motion with even powers keeps: frequency, action and phase, mean and harmonics.
//!
//! On a separatrix the action is the integral of u'^2 over all times, by the trapezoidal rule, which for such a function converges
//! like e^(-2 pi y/h), y the height of its nearest pole; its terms are all positive.

use super::even_powers::{EvenPowers, EvenSolution};
use super::harmonics::Harmonics;
use super::regime::OscillatorRegime;
use crate::elliptic::phase::Phase;
use crate::float::scaled::Scaled;
use crate::float::{Dd, TWO_PI};

impl EvenPowers {
    /// 2 pi over the period; 0 on a separatrix and on an unstable equilibrium, NaN for a motion that does not stay.
    pub fn frequency(&self) -> Scaled {
        match self.regime {
            OscillatorRegime::Homoclinic | OscillatorRegime::Heteroclinic => Scaled::ZERO,
            OscillatorRegime::Rest if !self.period.is_finite() => Scaled::ZERO,
            _ if self.period.is_finite() => Scaled::from(TWO_PI) / self.period,
            _ => Scaled::NAN,
        }
    }

    /// (1/2 pi) closed integral of u' du.
    pub fn action(&self) -> Scaled {
        match &self.solution {
            EvenSolution::Rest => Scaled::ZERO,
            EvenSolution::Mean(_) => match Harmonics::new(self) {
                Some(series) => (series.omega * series.sum_of_squares(1, true)).shift(-1),
                None => self.trapezoidal(),
            },
            EvenSolution::Square(_) if self.regime == OscillatorRegime::Heteroclinic => {
                self.trapezoidal().shift(1)
            }
            _ => Scaled::NAN,
        }
    }

    /// (1/2 pi) integral of u'^2 over all times.
    fn trapezoidal(&self) -> Scaled {
        let Some((middle, rate, decays)) = self.middle() else { return Scaled::NAN };
        let square = |t: Scaled| self.velocity_at(middle + t / rate).square();
        let sum_from = |start: f64, step: f64| {
            let mut sum = Scaled::ZERO;
            for side in [1.0, -1.0] {
                let mut x = start;
                loop {
                    let term = square(Scaled::from(side * x));
                    if x != 0.0 || side > 0.0 {
                        sum = sum + term;
                    }
                    if x > 1.0 && (term - sum.shift(-70)).is_negative() || x > 400.0 {
                        break;
                    }
                    x += step;
                }
            }
            sum
        };
        if !decays {
            return self.by_substitution(middle, rate);
        }
        let mut step = 0.5;
        let mut sum = sum_from(0.0, step);
        for _ in 0..12 {
            let between = sum_from(0.5 * step, step);
            let finer = sum + between;
            let done = ((sum - between).abs() - finer.shift(-36)).is_negative();
            (sum, step) = (finer, 0.5 * step);
            if done {
                // The error of the finer sum is the square of that of the coarser one.
                break;
            }
        }
        sum * step / rate / Scaled::from(TWO_PI)
    }

    /// The same where u' falls like a power: with t = sinh(x) twice over.
    fn by_substitution(&self, middle: Scaled, rate: Scaled) -> Scaled {
        let term = |x: f64| {
            let inner = Scaled::from(x).sinh_cosh();
            let outer = inner.0.sinh_cosh();
            let slope = outer.1 * inner.1;
            self.velocity_at(middle + outer.0 / rate).square() * slope
        };
        let sum = |count: i32| {
            let step = 5.0 / f64::from(count);
            let all =
                (-count..=count).map(|k| term(step * f64::from(k))).fold(Scaled::ZERO, |sum, x| sum + x);
            all * step
        };
        sum(320) / rate / Scaled::from(TWO_PI)
    }

    /// u' by the careful formula.
    fn velocity_at(&self, t: Scaled) -> Scaled {
        match &self.solution {
            EvenSolution::Mean(mean) => mean.at(t - mean.at_base)[1],
            EvenSolution::Square(riccati) => riccati.at(t)[1],
            _ => Scaled::NAN,
        }
    }

    /// The middle of a separatrix, a rate, and whether it falls exponentially.
    fn middle(&self) -> Option<(Scaled, Scaled, bool)> {
        match &self.solution {
            EvenSolution::Mean(mean) => {
                let power = mean.curve.square.is_zero();
                let rate = if power { mean.weight.sqrt() } else { mean.curve.rate };
                Some((mean.at_base, rate, !power))
            }
            EvenSolution::Square(riccati) => {
                let (at, rate) = riccati.middle();
                Some((at, rate, true))
            }
            _ => None,
        }
    }

    /// The phase in turns at t = 0 in (-1/2, 1/2], and turns per time: 0 at the highest point.
    pub fn phase_turns(&self) -> Option<Phase> {
        match &self.solution {
            EvenSolution::Mean(mean) if mean.curve.period.is_finite() => {
                let start = -(mean.at_base / mean.curve.period).to_dd();
                let start = if mean.way.is_negative() { start } else { start + Dd::from(0.5) };
                let start = start - Dd::from(start.hi.round());
                let start = if start.hi <= -0.5 { start + Dd::ONE } else { start };
                Some(Phase { rate: (Scaled::ONE / mean.curve.period).to_dd(), start })
            }
            EvenSolution::Rest if self.period.is_finite() => {
                Some(Phase { rate: (Scaled::ONE / self.period).to_dd(), start: Dd::ZERO })
            }
            _ => None,
        }
    }

    /// Phase in rad at t.
    pub fn phase(&self, t: f64) -> f64 {
        if self.regime == OscillatorRegime::Rest && !self.period.is_finite() {
            return 0.0 * t;
        }
        let Some(turns) = self.phase_turns() else { return f64::NAN };
        (turns.counted(t) * TWO_PI).value()
    }

    /// The mean of u, and its first n harmonics from the highest point; NaN where it does not repeat.
    pub fn harmonics(&self, n: usize) -> (f64, Vec<f64>) {
        if matches!(self.solution, EvenSolution::Rest) {
            return (self.u0, vec![0.0; n]);
        }
        let Some(series) = Harmonics::new(self) else { return (f64::NAN, vec![f64::NAN; n]) };
        let amplitudes: Vec<f64> = (1..=n as u64).map(|k| series.of_order(k).value()).collect();
        // The highest point is the sum of all.
        let mut mean = self.range[1];
        let mut quiet = 0;
        let mut k = 1;
        while quiet < 6 && k < 1_000_000 {
            let amplitude = series.of_order(k);
            mean = mean - amplitude;
            let small =
                (amplitude.abs() - (self.range[1].abs() + self.range[0].abs()).shift(-75)).is_negative();
            quiet = if small { quiet + 1 } else { 0 };
            k += 1;
        }
        (mean.value(), amplitudes)
    }

    /// The root of the sum of a_n^2 over n >= 2, over |a_1|.
    pub fn distortion(&self) -> f64 {
        if matches!(self.solution, EvenSolution::Rest) {
            return 0.0;
        }
        let Some(series) = Harmonics::new(self) else { return f64::NAN };
        (series.sum_of_squares(2, false).sqrt() / series.of_order(1).abs()).value()
    }
}

//! When a motion with even powers passes a value: by the curve from a turning point, and where there is none from the start by
//! Newton's steps on the way since then, which keeps its digits.

use super::even_powers::{EvenPowers, EvenSolution};
use super::mean::Mean;
use super::product::Product;
use crate::domain::Domain;
use crate::float::scaled::Scaled;
use crate::motion::passages::Interval;
use crate::sorting::sort_numbers;

/// Most steps of [`monotone`]: each that is not Newton's halves the interval.
const STEPS: usize = 1200;

impl EvenPowers {
    /// All times from `start` to `stop` (both included) at which the motion passes `u`, rising; `ended` is asked now and then.
    pub fn times_unless(
        &self,
        u: f64,
        start: f64,
        stop: f64,
        ended: &dyn Fn() -> bool,
    ) -> Result<Vec<f64>, Domain> {
        Domain::check("u", u, u.is_finite(), "finite")?;
        let interval = Interval::new(start, stop, ended)?;
        let mut times = match &self.solution {
            EvenSolution::Rest => Vec::new(),
            EvenSolution::Mean(mean) => {
                let Some(at) = self.times_by_base(mean, u) else { return Ok(Vec::new()) };
                let phases = at.iter();
                if !mean.curve.period.is_finite() {
                    phases.map(|t| t.value()).collect()
                } else {
                    let (rate, scale) = (Scaled::ONE / mean.curve.period).carried();
                    let phases: Vec<_> = phases.map(|t| (*t / mean.curve.period).to_dd()).collect();
                    return interval.repeated(rate, scale, &phases, 1.0);
                }
            }
            EvenSolution::Product(product) => self.of_product(product, u),
            EvenSolution::Square(riccati) => self.once(u, &|t| riccati.at(t)),
            EvenSolution::Linear(unbounded) => self.of_linear(u, &|t| unbounded.at(t)),
        };
        times.retain(|t| t.is_finite() && interval.holds(*t));
        sort_numbers(&mut times);
        times.dedup();
        Ok(times)
    }

    /// The times of a bounded motion next to its base; none where it does not get.
    fn times_by_base(&self, mean: &Mean, u: f64) -> Option<Vec<Scaled>> {
        let base = mean.at_base;
        if u == self.u0 {
            return Some(if self.velocity0 == 0.0 {
                vec![Scaled::ZERO]
            } else {
                vec![Scaled::ZERO, base.shift(1)]
            });
        }
        if u == mean.base.value() {
            return Some(vec![base]);
        }
        if u == mean.other.value() {
            let half = mean.curve.period.shift(-1);
            return half.is_finite().then(|| vec![base + half]);
        }
        let away = mean.time_of(Scaled::from(u))?;
        Some(vec![base + away, base - away])
    }

    /// The times of an escape.
    fn of_product(&self, product: &Product, u: f64) -> Vec<f64> {
        let Some(turn) = product.turn() else { return self.once(u, &|t| product.at(t)) };
        if u == self.u0 {
            return if self.velocity0 == 0.0 { vec![0.0] } else { vec![0.0, turn.shift(1).value()] };
        }
        let up = self.range[1].value() == f64::INFINITY;
        let base = if up { self.range[0] } else { self.range[1] };
        if u == base.value() {
            return vec![turn.value()];
        }
        let way = Scaled::from(u) - base;
        if way.is_negative() == up {
            return Vec::new();
        }
        let slope = self.quartic.slope(base);
        let pole = if (product.poles[0] - turn).is_zero() { product.poles[1] } else { product.poles[0] };
        let [sine, cosine, _] = product.curve.pair(pole - turn);
        let distance = (cosine / sine).square() + slope / way.shift(2);
        let away = product.curve.time_of_distance(distance);
        vec![(turn + away).value(), (turn - away).value()]
    }

    /// The time of a motion that goes one way.
    fn once(&self, u: f64, motion: &dyn Fn(Scaled) -> [Scaled; 2]) -> Vec<f64> {
        let [low, high] = self.range.map(Scaled::value);
        if u == self.u0 {
            return vec![0.0];
        }
        if !(low < u && u < high) {
            return Vec::new();
        }
        let way = Scaled::from(u) - Scaled::from(self.u0);
        let ahead = way.is_negative() == (self.velocity0 < 0.0);
        let end = self.escapes[usize::from(ahead)].value().abs();
        let sign = if ahead { 1.0 } else { -1.0 };
        vec![
            sign * monotone(way, end, (way / Scaled::from(self.velocity0)).value().abs(), &|t| {
                motion(Scaled::from(sign * t))
            }),
        ]
    }

    /// Of a linear force without an equilibrium that holds: on both sides of the turn, if there is one.
    fn of_linear(&self, u: f64, motion: &dyn Fn(Scaled) -> [Scaled; 2]) -> Vec<f64> {
        let (v, f) = (Scaled::from(self.velocity0), self.quartic.force.to_scaled());
        let rate = (-self.quartic.sigma.to_scaled()).sqrt();
        let [low, high] = self.range.map(Scaled::value);
        if low == f64::NEG_INFINITY && high == f64::INFINITY
            || f.is_zero()
            || (v * rate).abs().value() == f.abs().value()
        {
            return self.once(u, motion);
        }
        let up = high == f64::INFINITY;
        let base = if up { low } else { high };
        // tanh of the argument at the turn.
        let ratio = v * rate / f;
        let turn = if rate.is_zero() {
            -v / f
        } else {
            let rest = (f.square() + self.quartic.sigma.to_scaled() * v.square()).abs().sqrt() / f.abs();
            -(crate::elliptic::integrals::carlson::artanh(ratio.abs(), rest) / rate).signed(ratio.sign())
        };
        if u == self.u0 {
            return if turn.is_zero() { vec![0.0] } else { vec![0.0, turn.shift(1).value()] };
        }
        if u == base {
            return vec![turn.value()];
        }
        if (u > base) != up {
            return Vec::new();
        }
        let way = Scaled::from(u) - if up { self.range[0] } else { self.range[1] };
        let from = motion(turn)[0];
        let away = monotone(way, f64::INFINITY, 1.0, &|t| {
            let [x, velocity] = motion(turn + Scaled::from(t));
            [x - from, velocity]
        });
        vec![(turn + Scaled::from(away)).value(), (turn - Scaled::from(away)).value()]
    }
}

/// The time in (0, end) at which a way that grows from 0 has a value.
fn monotone(way: Scaled, end: f64, guess: f64, motion: &dyn Fn(f64) -> [Scaled; 2]) -> f64 {
    let (mut low, mut high) = (0.0, end);
    let mut t = if guess > 0.0 && guess < end {
        guess
    } else if end.is_finite() {
        0.5 * end
    } else {
        1.0
    };
    for _ in 0..STEPS {
        let [x, velocity] = motion(t);
        let rest = way.abs() - x.abs();
        if x.is_nan() || rest.is_negative() {
            high = t;
        } else {
            low = t;
        }
        // Far beyond, the way grows like an exponential or has a pole: halving is faster.
        let far = x.is_nan() || (x.abs() - way.abs().shift(1)).is_positive();
        let next = t + (rest / velocity.abs()).value();
        if !far && next == t {
            return t;
        }
        t = if !far && next > low && next < high {
            next
        } else if high.is_finite() {
            let middle = if low > 0.0 && high > 4.0 * low { (low * high).sqrt() } else { 0.5 * (low + high) };
            if !(low < middle && middle < high) {
                return t;
            }
            middle
        } else {
            2.0 * t
        };
        if !t.is_finite() {
            return t;
        }
    }
    t
}

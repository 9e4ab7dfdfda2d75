//! The Fourier series of the cubic-quintic oscillator in its phase: sums over half a swing (swing_integrals.rs).
//!
//! a_n is the mean of 2 u cos(n phase); u^2 at each place is known without subtraction, and its phase is an integral of the first
//! kind of Carlson's. Places are chosen for blocks of harmonics, so that no amplitude depends on how many are asked for.

use super::cubic_quintic::CubicQuintic;
use super::duffing::OscillatorFourier;
use super::regime::OscillatorRegime;
use super::set_up::Solution;
use super::swing_interval::SwingInterval;
use crate::domain::Domain;
use crate::float::scaled::Scaled;
use crate::float::series::quarter_turn;
use crate::float::triple_double::Td;
use crate::float::{Dd, HALF_PI, PI};

/// Last harmonic of the first block; that of every other is twice the last.
const FIRST_BLOCK: u64 = 32;

/// Most harmonics: the work grows like their square.
const MOST_HARMONICS: i64 = 1000;

/// e^-DIGITS is 2^-108.
const DIGITS: f64 = 75.0;

/// So many amplitudes that are nothing: all later ones are.
const QUIET: u64 = 24;

/// The share of the largest u below which an amplitude is nothing.
const NOTHING: f64 = 1e-32;

/// Places over half a swing: cosine and sine of the phase from the larger end, u over the largest |u|, and the share of the half swing.
struct Places {
    turn: Vec<[Dd; 2]>,
    u: Vec<Dd>,
    share: Vec<Dd>,
}

/// Mean, amplitudes and distortion over the largest |u|, from |u| and counted from the larger end.
struct SwingSeries {
    mean: Dd,
    amplitudes: Vec<Dd>,
    distortion: Dd,
}

impl Places {
    /// For harmonics up to `n`; a quarter of a period where the motion crosses u = 0, else half of one.
    fn new(interval: &SwingInterval, quarter: Scaled, crosses: bool, n: u64) -> Places {
        let turns = if crosses { 0.5 * n as f64 } else { n as f64 };
        let span = if crosses { HALF_PI } else { PI };
        // The share of half a swing by dy: dt = dy/(2 u |u'|), over quarter/omega.
        let unit = interval.omega() / quarter.shift(1);
        let mut places = Places { turn: Vec::new(), u: Vec::new(), share: Vec::new() };
        let mut sum = Scaled::ZERO;
        interval.visit(interval.rule(DIGITS, turns, true), &mut |place, step| {
            let share = unit * place.step * Scaled::from(step) / (place.y * place.square_speed).sqrt();
            sum = sum + share;
            let part = Dd::ONE - (interval.argument(place) / quarter).to_dd();
            places.turn.push(cosine_and_sine(clamped(part) * span));
            places.u.push((place.y / interval.ends[1]).sqrt().to_dd());
            places.share.push(share.to_dd());
            (share - sum.shift(-110)).is_negative()
        });
        places
    }

    fn mean(&self, values: impl Iterator<Item = Dd>) -> Dd {
        self.share.iter().zip(values).fold(Dd::ZERO, |sum, (share, value)| sum + *share * value)
    }

    /// Adds the amplitudes from the next after those that are known up to `last`.
    fn add(&self, amplitudes: &mut Vec<Dd>, last: u64, odd_only: bool) {
        let first = amplitudes.len() as u64 + 1;
        let mut turned: Vec<[Dd; 2]> = self.turn.iter().map(|turn| power(*turn, first)).collect();
        for n in first..=last {
            let amplitude = if odd_only && n.is_multiple_of(2) {
                Dd::ZERO
            } else {
                let terms = self.u.iter().zip(&turned).map(|(u, [cosine, _])| *u * *cosine);
                self.mean(terms).scale(2.0)
            };
            amplitudes.push(amplitude);
            for (turned, turn) in turned.iter_mut().zip(&self.turn) {
                *turned = product(*turned, *turn);
            }
        }
    }
}

/// Into [0, 1], which a rounding error may leave.
fn clamped(part: Dd) -> Dd {
    if part.hi <= 0.0 {
        Dd::ZERO
    } else if part.hi > 1.0 || part.hi == 1.0 && part.lo > 0.0 {
        Dd::ONE
    } else {
        part
    }
}

/// Of an angle in [0, pi].
fn cosine_and_sine(angle: Dd) -> [Dd; 2] {
    let rest = HALF_PI - angle;
    let beyond = rest.hi < 0.0;
    let near = if beyond { PI - angle } else { angle };
    let (sine, cosine) = quarter_turn(Td::from(near), Td::from(rest.abs()));
    [if beyond { -cosine.to_dd() } else { cosine.to_dd() }, sine.to_dd()]
}

fn product([a, b]: [Dd; 2], [c, d]: [Dd; 2]) -> [Dd; 2] {
    [a * c - b * d, a * d + b * c]
}

/// A point of the unit circle to a power.
fn power(turn: [Dd; 2], mut n: u64) -> [Dd; 2] {
    let (mut found, mut square) = ([Dd::ONE, Dd::ZERO], turn);
    while n > 0 {
        if n % 2 == 1 {
            found = product(found, square);
        }
        square = product(square, square);
        n /= 2;
    }
    found
}

impl SwingSeries {
    fn new(interval: &SwingInterval, quarter: Scaled, crosses: bool, n: u64) -> SwingSeries {
        let places = Places::new(interval, quarter, crosses, FIRST_BLOCK);
        let mut amplitudes = Vec::new();
        places.add(&mut amplitudes, FIRST_BLOCK, crosses);
        let mean = if crosses { Dd::ZERO } else { places.mean(places.u.iter().copied()) };
        let first = amplitudes[0];
        // What the mean and the first harmonic leave, which is small where the others are.
        let rest = places.u.iter().zip(&places.turn).map(|(u, [cosine, _])| *u - mean - first * *cosine);
        let square = places.mean(rest.map(Dd::square)).scale(2.0);
        let distortion = square.sqrt() / first.abs();
        let mut last = FIRST_BLOCK;
        while last < n && !quiet(&amplitudes) {
            last *= 2;
            Places::new(interval, quarter, crosses, last).add(&mut amplitudes, last.min(n), crosses);
        }
        amplitudes.resize(n as usize, Dd::ZERO);
        SwingSeries { mean, amplitudes, distortion }
    }
}

/// Whether the last amplitudes are nothing.
fn quiet(amplitudes: &[Dd]) -> bool {
    amplitudes.iter().rev().take(QUIET as usize).all(|a| a.hi.abs() < NOTHING)
}

impl CubicQuintic {
    /// The series over the largest |u| with that, from the larger |u| on; none where the motion does not repeat.
    fn series(&self, n: u64) -> Option<(SwingSeries, Scaled)> {
        let Solution::Theta(theta) = &self.set_up.solution else { return None };
        let interval = SwingInterval::new(self.set_up.energy_case.as_ref()?).filter(|_| theta.repeats())?;
        let quarter = theta.half_period().shift(-1);
        let series = SwingSeries::new(&interval, quarter, self.crosses(), n);
        Some((series, interval.ends[1].sqrt()))
    }

    /// The mean of u and the first n amplitudes of u and u' in the phase, n from 1 to 1000; NaN where the motion does not repeat.
    ///
    /// **Error** at most 4 ulp of each amplitude, plus 2^-96 of the largest |u|. **Source** the definition, by the trapezoidal rule:
    /// swing_integrals.rs.
    ///
    /// # Errors
    /// For another n.
    ///
    /// ```
    /// let series = libration::CubicQuintic::new(1.0, 0.0, 1.0, 1.0, 0.0)?.fourier(3)?;
    /// assert_eq!(series.u.iter().map(|a| format!("{a:.9}")).collect::<Vec<_>>(), ["0.981710616", "0.000000000", "0.017960678"]);
    /// # Ok::<(), libration::Domain>(())
    /// ```
    pub fn fourier(&self, n: i64) -> Result<OscillatorFourier, Domain> {
        if !(1..=MOST_HARMONICS).contains(&n) {
            return Err(Domain::new("n", n.to_string(), "from 1 to 1000"));
        }
        let count = n as usize;
        if self.regime() == OscillatorRegime::Rest {
            return Ok(OscillatorFourier { mean: self.u0, u: vec![0.0; count], velocity: vec![0.0; count] });
        }
        let Some((series, size)) = self.series(n as u64) else {
            let none = vec![f64::NAN; count];
            return Ok(OscillatorFourier { mean: f64::NAN, u: none.clone(), velocity: none });
        };
        // Below 0 the highest point is the end with the smaller |u|, half a turn on.
        let below = !self.crosses() && self.set_up.orientation.sign < 0.0;
        let frequency = self.long_frequency();
        let (mut u, mut velocity) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for (k, amplitude) in series.amplitudes.iter().enumerate() {
            let turned = if below && k % 2 == 1 { -*amplitude } else { *amplitude };
            let amplitude = size * Scaled::from(turned);
            u.push(amplitude.value());
            velocity.push((-frequency * (amplitude * (k + 1) as f64)).value());
        }
        let mean = size * Scaled::from(series.mean);
        Ok(OscillatorFourier { mean: if below { -mean } else { mean }.value(), u, velocity })
    }

    /// The root of the sum of u_n^2 over n >= 2, over |u_1|: 0 at rest, NaN where the motion does not repeat.
    ///
    /// **Error** at most 4 ulp, plus 2^-96. **Source** Parseval's sum of the Fourier series.
    #[must_use]
    pub fn distortion(&self) -> f64 {
        if self.regime() == OscillatorRegime::Rest {
            return 0.0;
        }
        self.series(1).map_or(f64::NAN, |(series, _)| series.distortion.value())
    }
}

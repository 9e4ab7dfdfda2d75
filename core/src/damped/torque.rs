//! The torque that drives a pendulum, per unit inertia: a constant, a sinusoid, and samples in time, added.
//!
//! Between samples the torque is a polynomial of the kind that is named ([`Interpolation`]), so it is defined exactly by the
//! samples. Its coefficients are formed in double-double.

use super::circular::circular;
use crate::domain::Domain;
use crate::float::Dd;
use std::sync::Arc;

/// Whether there are torques at all: without the feature `torques` none can be made, and nothing of them is compiled.
pub(super) const TORQUES: bool = cfg!(feature = "torques");

/// An error where there are none.
fn served() -> Result<(), Domain> {
    let given = String::from("given");
    if TORQUES { Ok(()) } else { Err(Domain::new("torque", given, "none without the feature `torques`")) }
}

const FINITE: &str = "finite";

/// How samples become a torque at every time between the first and the last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpolation {
    /// Each sample holds until the next.
    Steps,
    /// Straight lines.
    Lines,
    /// Cubic polynomials; the slope at a sample is that of the parabola through it and its two neighbours, at the ends that
    /// of the parabola through the three nearest.
    Cubics,
}

/// Times and the polynomial from each to the next.
#[derive(Debug, PartialEq)]
pub(super) struct Samples {
    pub times: Vec<f64>,
    /// Coefficients of the powers of the time since the sample.
    pub pieces: Vec<[Dd; 4]>,
}

/// A torque per unit inertia in rad/s^2: constant + amplitude cos(frequency t + phase) + samples.
#[derive(Clone, Debug, PartialEq)]
pub struct Torque {
    constant: f64,
    amplitude: f64,
    frequency: f64,
    phase: f64,
    pub(super) samples: Option<Arc<Samples>>,
}

impl Torque {
    /// No torque.
    pub const NONE: Torque =
        Torque { constant: 0.0, amplitude: 0.0, frequency: 0.0, phase: 0.0, samples: None };

    /// constant + amplitude cos(frequency t + phase).
    ///
    /// | argument | unit |
    /// |---|---|
    /// | `constant`, `amplitude` | rad/s^2 |
    /// | `frequency` | rad/s |
    /// | `phase` | rad |
    ///
    /// # Errors
    /// For an argument that is not finite.
    ///
    /// ```
    /// use libration::Torque;
    /// assert_eq!(Torque::new(0.5, 2.0, 3.0, 0.0)?.at(0.0), 2.5);
    /// # Ok::<(), libration::Domain>(())
    /// ```
    pub fn new(constant: f64, amplitude: f64, frequency: f64, phase: f64) -> Result<Torque, Domain> {
        served()?;
        Domain::check("constant", constant, constant.is_finite(), FINITE)?;
        Domain::check("amplitude", amplitude, amplitude.is_finite(), FINITE)?;
        Domain::check("frequency", frequency, frequency.is_finite(), FINITE)?;
        Domain::check("phase", phase, phase.is_finite(), FINITE)?;
        Ok(Torque { constant, amplitude, frequency, phase, samples: None })
    }

    /// This torque plus samples: `values` in rad/s^2 at rising `times` in s. A motion must lie between the first and the
    /// last.
    ///
    /// # Errors
    /// For fewer than two samples, different counts, values that are not finite, and times that do not rise.
    ///
    /// ```
    /// use libration::{Interpolation, Torque};
    /// let torque = Torque::NONE.with_samples(&[0.0, 1.0, 3.0], &[0.0, 2.0, 4.0], Interpolation::Lines)?;
    /// assert_eq!(torque.at(2.0), 3.0);
    /// # Ok::<(), libration::Domain>(())
    /// ```
    pub fn with_samples(
        mut self,
        times: &[f64],
        values: &[f64],
        interpolation: Interpolation,
    ) -> Result<Torque, Domain> {
        served()?;
        if times.len() != values.len() {
            let allowed = format!("as many as the times, {}", times.len());
            return Err(Domain::new("number of torque values", values.len().to_string(), allowed));
        }
        if times.len() < 2 {
            return Err(Domain::new("number of torque samples", times.len().to_string(), "at least 2"));
        }
        for (time, value) in times.iter().zip(values) {
            Domain::check("torque time", *time, time.is_finite(), FINITE)?;
            Domain::check("torque value", *value, value.is_finite(), FINITE)?;
        }
        for pair in times.windows(2) {
            Domain::check("torque time", pair[1], pair[0] < pair[1], "later than the one before it")?;
        }
        let pieces: Vec<[Dd; 4]> =
            (0..times.len() - 1).map(|i| piece(times, values, i, interpolation)).collect();
        for (value, piece) in values.iter().zip(&pieces) {
            let finite = piece.iter().all(|c| c.hi.is_finite() && c.lo.is_finite());
            let allowed = "such that the polynomial from it to the next stays in the range of doubles";
            Domain::check("torque value", *value, finite, allowed)?;
        }
        self.samples = Some(Arc::new(Samples { times: times.to_vec(), pieces }));
        Ok(self)
    }

    /// The constant part in rad/s^2.
    #[must_use]
    pub fn constant(&self) -> f64 {
        self.constant
    }
    /// Amplitude of the sinusoid in rad/s^2.
    #[must_use]
    pub fn driving_amplitude(&self) -> f64 {
        self.amplitude
    }
    /// Angular frequency of the sinusoid in rad/s.
    #[must_use]
    pub fn frequency(&self) -> f64 {
        self.frequency
    }
    /// Phase of the sinusoid at t = 0 in rad.
    #[must_use]
    pub fn phase(&self) -> f64 {
        self.phase
    }

    /// The torque at t (in s), in rad/s^2: NaN where t is not finite or outside of the samples.
    #[must_use]
    pub fn at(&self, t: f64) -> f64 {
        if !t.is_finite() {
            return f64::NAN;
        }
        let mut sum = Dd::from(self.constant);
        if self.amplitude != 0.0 {
            let (_, cosine) = circular(Dd::product(self.frequency, t) + Dd::from(self.phase));
            sum = sum + cosine * self.amplitude;
        }
        if let Some(samples) = &self.samples {
            let times = &samples.times;
            if t < times[0] || t > times[times.len() - 1] {
                return f64::NAN;
            }
            // The piece that begins at or before t; at the last sample the piece that ends there, or its own value.
            let i = samples.piece_from(t);
            let [a, b, c, d] = samples.pieces[i];
            let since = Dd::sum(t, -times[i]);
            sum = sum + (a + since * (b + since * (c + since * d)));
        }
        sum.value()
    }

    /// Whether nothing drives.
    pub(super) fn is_none(&self) -> bool {
        self.constant == 0.0 && self.amplitude == 0.0 && self.samples.is_none()
    }
}

impl Samples {
    /// Size of the largest sample but the last.
    pub fn largest(&self) -> f64 {
        self.pieces.iter().fold(0.0, |largest: f64, piece| largest.max(piece[0].hi.abs()))
    }
    /// Index of the piece that begins at or before t, the last one for the end.
    pub fn piece_from(&self, t: f64) -> usize {
        self.times.partition_point(|time| *time <= t).clamp(1, self.pieces.len()) - 1
    }
    /// Index of the piece that ends at or after t, the first one for the beginning.
    pub fn piece_to(&self, t: f64) -> usize {
        self.times.partition_point(|time| *time < t).clamp(1, self.pieces.len()) - 1
    }
}

/// The polynomial from sample i to the next.
fn piece(times: &[f64], values: &[f64], i: usize, interpolation: Interpolation) -> [Dd; 4] {
    let start = Dd::from(values[i]);
    let secant = slope(times, values, i);
    match interpolation {
        Interpolation::Steps => [start, Dd::ZERO, Dd::ZERO, Dd::ZERO],
        Interpolation::Lines => [start, secant, Dd::ZERO, Dd::ZERO],
        Interpolation::Cubics => {
            let width = Dd::sum(times[i + 1], -times[i]);
            let (first, last) = (tangent(times, values, i), tangent(times, values, i + 1));
            let square = (secant * 3.0 - first.scale(2.0) - last) / width;
            let cube = (first + last - secant.scale(2.0)) / width.square();
            [start, first, square, cube]
        }
    }
}

/// Slope of the line from sample i to the next.
fn slope(times: &[f64], values: &[f64], i: usize) -> Dd {
    Dd::sum(values[i + 1], -values[i]) / Dd::sum(times[i + 1], -times[i])
}

/// Slope at sample i of the parabola through it and its neighbours.
fn tangent(times: &[f64], values: &[f64], i: usize) -> Dd {
    let last = times.len() - 1;
    if last == 1 {
        return slope(times, values, 0);
    }
    let middle = i.clamp(1, last - 1);
    let (before, after) = (slope(times, values, middle - 1), slope(times, values, middle));
    let bend = (after - before) / Dd::sum(times[middle + 1], -times[middle - 1]);
    // Newton's form on the three times: slope of the first line, plus the bend times what the derivative of
    // (t - t0)(t - t1) is at the sample.
    let [t0, t1, t] = [times[middle - 1], times[middle], times[i]];
    before + bend * (Dd::sum(t, -t0) + Dd::sum(t, -t1))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cubics through the samples of a parabola are that parabola; lines through those of a line.
    #[test]
    fn polynomials_are_reproduced() {
        let times = [0.0, 0.5, 2.0, 3.0, 7.0];
        let parabola = times.map(|t: f64| 1.0 - 2.0 * t + 0.75 * t * t);
        let torque = Torque::NONE.with_samples(&times, &parabola, Interpolation::Cubics).unwrap();
        for i in 0..=70 {
            let t = 0.1 * f64::from(i);
            assert!((torque.at(t) - (1.0 - 2.0 * t + 0.75 * t * t)).abs() < 1e-14, "{t}");
        }
        assert!(torque.at(-1e-9).is_nan() && torque.at(7.1).is_nan());
        let steps = Torque::NONE.with_samples(&times, &parabola, Interpolation::Steps).unwrap();
        assert_eq!(steps.at(1.9), parabola[1]);
        assert_eq!(steps.at(2.0), parabola[2]);
    }

    #[test]
    fn bad_samples_are_named() {
        let of = |times: &[f64], values: &[f64]| {
            Torque::NONE.with_samples(times, values, Interpolation::Lines).unwrap_err().to_string()
        };
        assert_eq!(of(&[0.0], &[1.0]), "number of torque samples = 1: must be at least 2");
        assert_eq!(of(&[0.0, 1.0], &[1.0]), "number of torque values = 1: must be as many as the times, 2");
        assert_eq!(
            of(&[0.0, 1.0, 1.0], &[1.0; 3]),
            "torque time = 1.0: must be later than the one before it"
        );
        assert_eq!(of(&[0.0, 1.0], &[1.0, f64::NAN]), "torque value = NaN: must be finite");
    }
}

//! The exact Fourier series of angle and velocity in the phase of the motion, and how far from harmonic it is.
//!
//!   libration  theta = sum a_j sin(j phase), j odd,   a_j = (4/j) sech(j pi K'/2K),
//!   rotation   theta = phase + sum a_j sin(j phase),  a_j = (2/j) sech(j pi K'/K), with its direction,
//! and the velocity by their derivative, b_j = j frequency a_j. Parseval: the mean of velocity^2 is action times frequency.
//! Every term is accurate to its last digits, however small. Source: DLMF 22.11.1, 22.11.3 integrated; Chachiyo,
//! arXiv:2504.16816.

use super::frequency::Frequency;
use super::orbit::{Orbit, Solution};
use crate::domain::Domain;
use crate::elliptic::agm::agm;
use crate::elliptic::nome::minus_log_nome;
use crate::elliptic::parameter::Unit;
use crate::float::elementary::sech;
use crate::float::{Dd, HALF_PI, Scaled};

/// Amplitudes of the harmonics j = 1, 2, ... of angle and velocity.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Fourier {
    /// Of sin(j phase) in theta, in rad.
    pub theta: Vec<f64>,
    /// Of cos(j phase) in the velocity, in rad/s.
    pub velocity: Vec<f64>,
}

/// Most harmonics in one answer.
pub const MOST_HARMONICS: i64 = 10_000_000;

/// a_j = (factor/j) sech(j decay) for every `step`-th j from 1.
struct Series {
    factor: f64,
    decay: Dd,
    step: u64,
}

impl Series {
    /// a_j but for a power of two.
    fn harmonic(&self, j: u64) -> (Dd, f64) {
        if j % self.step != 1 % self.step {
            return (Dd::ZERO, 1.0);
        }
        let order = j as f64;
        let (value, power) = sech(self.decay * order);
        (value * self.factor / Dd::from(order), power)
    }

    /// a_j, however small.
    fn coefficient(&self, j: u64) -> Scaled {
        let order = j as f64;
        let argument = self.decay * order;
        if argument.hi > FAR {
            return Scaled::exp(-argument) * (2.0 * self.factor) / Scaled::from(order);
        }
        let (value, power) = self.harmonic(j);
        Scaled::from(value) * Scaled::from(power)
    }
}

/// Beyond, 1 + e^-2y is 1 to 600 digits; up to it sech is a product of two doubles in their range.
const FAR: f64 = 700.0;

impl Orbit {
    /// pi K'/2K of a libration and pi K'/K of a rotation, of its inner parameter, where the motion has a series that is not
    /// a straight line or a single term; and which harmonics it has, every second one or all.
    pub(crate) fn decay(&self) -> Option<(Dd, u32)> {
        let state = self.state?;
        let Unit { k, kc, .. } = state.unit();
        match self.solution {
            Solution::Libration(_) if state.power == 0 => Some((HALF_PI * agm(kc) / agm(k), 2)),
            Solution::Rotation(_) => Some((minus_log_nome(k, kc), 1)),
            _ => None,
        }
    }

    fn series(&self) -> Option<Series> {
        let (decay, step) = self.decay()?;
        Some(Series { factor: if step == 2 { 4.0 } else { 2.0 }, decay, step: u64::from(step) })
    }

    /// The first n amplitudes of angle and velocity, n from 1 to [`MOST_HARMONICS`]; NaN on the separatrix, whose motion
    /// does not repeat. A rotation's angle has its phase, and its velocity its frequency, beside them.
    ///
    /// **Error** at most 4 ulp of each amplitude, plus 2^-100 of its condition. Source: DLMF 22.11.1, 22.11.3 integrated.
    ///
    /// # Errors
    /// For another n.
    ///
    /// ```
    /// use libration::{Frequency, Orbit};
    /// let orbit = Orbit::new(2.0, 0.0, Frequency::from_omega0(1.0)?)?;
    /// let theta = orbit.fourier(3)?.theta.iter().map(|a| format!("{a:.6}")).collect::<Vec<_>>();
    /// assert_eq!(theta, ["2.053795", "0.000000", "0.056240"]);
    /// # Ok::<(), libration::Domain>(())
    /// ```
    pub fn fourier(&self, n: i64) -> Result<Fourier, Domain> {
        if !(1..=MOST_HARMONICS).contains(&n) {
            return Err(Domain::new("n", n.to_string(), "from 1 to 10000000"));
        }
        let (mut theta, mut velocity) = (vec![0.0; n as usize], vec![0.0; n as usize]);
        let frequency = self.mean_frequency();
        let mut put = |j: u64, amplitude: Scaled| {
            let place = (j - 1) as usize;
            theta[place] = amplitude.value();
            velocity[place] =
                if amplitude.is_zero() { 0.0 } else { (amplitude * frequency * j as f64).value() };
            theta[place] != 0.0 || velocity[place] != 0.0
        };
        if let Some(series) = self.series() {
            // A rotation about the other equilibrium has its phase from this one, half a turn away.
            let turned = series.step == 1 && self.frame.half_turn != 0.0;
            for j in (1..=n as u64).step_by(series.step as usize) {
                let side = if turned && j % 2 == 1 { -1.0 } else { 1.0 };
                // a_j and j a_j fall with j: after the first that are below every double all are.
                if !put(j, series.coefficient(j) * side) {
                    break;
                }
            }
            return Ok(Fourier { theta, velocity });
        }
        match self.solution {
            Solution::Libration(_) => {
                // Of a tiny libration a_3 = theta_max^3/192 is the last that a double may hold.
                let first = Scaled::from(self.theta_max());
                put(1, first);
                if n > 2 {
                    put(3, first * self.tiny_distortion());
                }
            }
            Solution::Separatrix(_) => {
                theta.fill(f64::NAN);
                velocity.fill(f64::NAN);
            }
            _ => {}
        }
        Ok(Fourier { theta, velocity })
    }

    /// theta_max^2/192 = kappa^2/48 of a tiny libration.
    fn tiny_distortion(&self) -> f64 {
        self.energy_ratio() / 48.0
    }

    /// Harmonic distortion of the angle: the root of the sum of a_j^2 over j >= 2, over |a_1|. 0 at rest, NaN on
    /// the separatrix; in rotation that of what the angle has beside its phase.
    ///
    /// **Error** at most 4 ulp, plus 2^-100 of its condition. Source: Parseval's sum of DLMF 22.11.1, 22.11.3.
    #[must_use]
    pub fn distortion(&self) -> f64 {
        let Some(series) = self.series() else {
            return match self.solution {
                Solution::Libration(_) => self.tiny_distortion(),
                Solution::Separatrix(_) => f64::NAN,
                _ => 0.0,
            };
        };
        // Beside the largest of the harmonics, whose square may be below the range where it is beside the first.
        let (first, leading) = (series.harmonic(1), series.harmonic(1 + series.step));
        let mut sum = Dd::ZERO;
        let mut j = 1 + series.step;
        loop {
            let (value, power) = series.harmonic(j);
            let ratio = (value / leading.0).scale(power / leading.1);
            let square = ratio.square();
            sum = sum + square;
            // sech falls by e^(-decay step) a term or faster once it falls, and 1/j always: what is left is less than
            // this term over 1 - e^(-2 decay step). That ends the sum after 25/(decay step) terms at most, and decay step is
            // at least pi^2/2 over the largest K, 746: no more than 4000 terms.
            let left = square.hi / least(2.0 * series.decay.hi * series.step as f64);
            if left <= 1e-18 * sum.hi || square.hi == 0.0 {
                return (leading.0 / first.0 * sum.sqrt()).value() * (leading.1 / first.1);
            }
            j += series.step;
        }
    }
}

/// [`Orbit::distortion`] of a libration with this turning angle (in rad), from 0 to pi. NaN outside.
///
/// **Error** at most 4 ulp, plus 2^-100 of its condition.
///
/// ```
/// use libration::pendulum::fourier::harmonic_distortion;
/// assert_eq!(format!("{:.9}", harmonic_distortion(2.0)), "0.027412286");
/// ```
#[must_use]
pub fn harmonic_distortion(theta_max: f64) -> f64 {
    if !(0.0..=core::f64::consts::PI).contains(&theta_max) {
        return f64::NAN;
    }
    let frequency = Frequency::from_omega0(1.0);
    frequency.and_then(|one| Orbit::new(theta_max, 0.0, one)).map_or(f64::NAN, |orbit| orbit.distortion())
}

/// 1 - e^-x from below, for x >= 0.
fn least(x: f64) -> f64 {
    x / (1.0 + x)
}

//! The Fourier series of a bounded motion with even powers in its phase, its action, and how far from harmonic it is.
//!
//! u = a_0 + sum a_n cos(n phase), phase 0 at the highest point. As u is an elliptic function of order two, the a_n follow from its
//! poles: with Omega = 2 pi/T, x = pi K'/K, and eta the height of a pole above a turning point (or xi its distance from it),
//!   q > 0, four real roots   2 Omega/sqrt(q/2) sinh(n Omega (T' - eta))/sinh(n x),
//!   q > 0, two real roots    2 Omega/sqrt(q/2) (e^(-n Omega eta) - (-1)^n e^(-n Omega (T' - eta)))/(1 - (-1)^n e^(-n x)),
//!   q < 0                    2 Omega/sqrt(-q/2) sin(n Omega xi)/sinh(n x),
//!   q = 0                    6 n Omega^2/|r| / sinh(n x),
//! with alternating signs where the pole is above the lowest point. J = (1/2 pi) closed integral of u' du = Omega/2 sum n^2 a_n^2.
//! Source: residues on a period's parallelogram; DLMF 22.11 has the cases without even powers.

use super::curve::{Curve, Gaps};
use super::even_powers::{EvenPowers, EvenSolution};
use super::mean::{Mean, distances};
use crate::elliptic::integrals::carlson::rf_of_roots;
use crate::elliptic::nome::minus_log_nome;
use crate::float::scaled::Scaled;
use crate::float::series::long_sine;
use crate::float::{Dd, HALF_PI, TWO_PI};

/// How the amplitudes fall.
#[derive(Clone, Copy, Debug)]
enum Fall {
    /// One harmonic: a linear force.
    Single,
    /// sinh(n rest)/sinh(n (rest + away)).
    Sinh { away: Scaled, rest: Scaled },
    /// The exponentials; the difference of both is apart.
    Pair { away: Scaled, apart: Scaled, whole: Scaled },
    /// sin(2 pi n part)/sinh(n whole).
    Sine { part: Dd, whole: Scaled },
    /// n/sinh(n whole).
    Double { whole: Scaled },
}

/// The series of a motion, by its amplitudes from the highest point.
#[derive(Clone, Debug)]
pub(super) struct Harmonics {
    fall: Fall,
    factor: Scaled,
    /// Whether signs alternate.
    alternate: bool,
    /// Whether even harmonics vanish.
    odd_only: bool,
    pub omega: Scaled,
}

/// 1 - e^(-2 y).
fn less_than_one(y: Scaled) -> Scaled {
    if y.value() > 60.0 {
        return Scaled::ONE;
    }
    (Scaled::exp(-y.to_dd()) * y.sinh_cosh().0).shift(1)
}

fn exp(y: Scaled) -> Scaled {
    if y.value() < -1e7 { Scaled::ZERO } else { Scaled::exp(y.to_dd()) }
}

impl Harmonics {
    /// Of an orbit that repeats.
    pub fn new(orbit: &EvenPowers) -> Option<Harmonics> {
        let EvenSolution::Mean(mean) = &orbit.solution else { return None };
        let Mean { curve, way, .. } = &**mean;
        if !curve.period.is_finite() {
            return None;
        }
        let omega = Scaled::from(TWO_PI) / curve.period;
        let upper = way.is_negative();
        let quartic = &orbit.quartic;
        if quartic.linear() {
            let factor = way.abs().shift(-1);
            return Some(Harmonics { fall: Fall::Single, factor, alternate: false, odd_only: true, omega });
        }
        // pi K'/K, infinite for m = 0.
        let whole = if curve.m.is_zero() {
            Scaled::INFINITY
        } else {
            Scaled::from(minus_log_nome(curve.m.sqrt().to_dd(), curve.mc.sqrt().to_dd()))
        };
        let q = quartic.q.to_scaled();
        let lead = q.abs().shift(-1);
        let g = quartic.g.sign();
        // Symmetric about the middle, but for a motion beside it.
        let aside = curve.three() && q.is_positive();
        let odd_only = g == 0 && !q.is_zero() && !aside;
        if q.is_zero() {
            let rho = quartic.rho.to_scaled();
            let factor = omega.square() * Scaled::from(6.0) / rho.abs();
            let alternate = rho.is_negative();
            return Some(Harmonics { fall: Fall::Double { whole }, factor, alternate, odd_only, omega });
        }
        let factor = omega.shift(1) / lead.sqrt();
        let point = quartic.infinity();
        let (fall, above_base) = match curve.gaps {
            Gaps::Three(_) if q.is_negative() => {
                let time = curve.time(point, false);
                let near = (g > 0) != upper;
                let half = (time / curve.period).to_dd().half();
                // From the turning point at the base; counted from the highest one below.
                let part = if near { half } else { Dd::from(0.5) - half };
                (Fall::Sine { part, whole }, true)
            }
            Gaps::Three(_) => {
                let roots = distances(curve, point.x, point.product).map(|d| d.abs().sqrt());
                let height = rf_of_roots(roots).shift(-1);
                let away = omega * height;
                let rest = if whole.is_finite() { whole - away } else { whole };
                let right = quartic.right();
                let plus = if right { g > 0 } else { g < 0 };
                let fall = if plus || !whole.is_finite() {
                    Fall::Sinh { away, rest }
                } else {
                    Fall::Sinh { away: rest, rest: away }
                };
                (fall, upper == right)
            }
            Gaps::Pair { q: half, w } => {
                let [d1, pair, leg] = curve.of_pair(point.x, point.product, Some(point.pairs), w);
                let away = omega * height_of_pair(curve, [-d1, pair, -leg], -half, w, whole).shift(-1);
                let apart = whole - away.shift(1);
                (Fall::Pair { away, apart, whole }, g == 0 || (g > 0) == upper)
            }
        };
        // The base's own amplitudes, seen from the highest point: those of the lowest one have other signs for odd n.
        let alternate = above_base != upper;
        Some(Harmonics { fall, factor, alternate, odd_only, omega })
    }

    /// a_n, n >= 1.
    pub fn of_order(&self, n: u64) -> Scaled {
        if self.odd_only && n.is_multiple_of(2) {
            return Scaled::ZERO;
        }
        let order = Scaled::from(n as f64);
        let value = match self.fall {
            Fall::Single => {
                if n == 1 {
                    Scaled::ONE
                } else {
                    Scaled::ZERO
                }
            }
            Fall::Sinh { away, rest } => {
                let whole = order * (away + rest);
                exp(-(order * away)) * less_than_one(order * rest) / less_than_one(whole)
            }
            Fall::Pair { away, apart, whole } => {
                let lead = exp(-(order * away));
                let below = exp(-(order * whole));
                if n % 2 == 1 {
                    lead * (Scaled::ONE + exp(-(order * apart))) / (Scaled::ONE + below)
                } else {
                    lead * less_than_one((order * apart).shift(-1)) / less_than_one((order * whole).shift(-1))
                }
            }
            Fall::Sine { part, whole } => {
                let turns = part * order.value();
                let rest = turns - Dd::from(turns.hi.round());
                let above = Scaled::from(long_sine(TWO_PI * rest));
                (above * exp(-(order * whole))).shift(1) / less_than_one(order * whole)
            }
            Fall::Double { whole } => (order * exp(-(order * whole))).shift(1) / less_than_one(order * whole),
        };
        let signed = if self.alternate && n.is_multiple_of(2) { -value } else { value };
        self.factor * signed
    }

    /// The sum of n^power a_n^2 from the `first` harmonic on.
    pub fn sum_of_squares(&self, first: u64, weighted: bool) -> Scaled {
        let mut sum = Scaled::ZERO;
        let mut quiet = 0;
        let mut n = first;
        while quiet < 6 && n < MOST {
            let amplitude = self.of_order(n);
            let term = if weighted { (amplitude * n as f64).square() } else { amplitude.square() };
            sum = sum + term;
            let small = term.is_zero() && self.skips(n) || (term.abs() - sum.shift(-75)).is_negative();
            quiet = if small { quiet + 1 } else { 0 };
            if matches!(self.fall, Fall::Single) {
                break;
            }
            n += 1;
        }
        sum
    }

    fn skips(&self, n: u64) -> bool {
        self.odd_only && n.is_multiple_of(2)
    }
}

/// More harmonics than any motion has within 2^-75.
const MOST: u64 = 1_000_000;

/// The time on the imaginary axis of a point below e1, with a complex pair: that of [`Curve::time`] for the complement.
fn height_of_pair(
    curve: &Curve,
    [d1, pair, leg]: [Scaled; 3],
    q: Scaled,
    w: Scaled,
    whole: Scaled,
) -> Scaled {
    let h = curve.square;
    let sum = d1 + h;
    let cosine = if q.is_negative() { (leg * (d1 - q) - w.square()) / sum.square() } else { (d1 - h) / sum };
    let near = (d1 * h).sqrt().shift(1) / sum * rf_of_roots([cosine.abs(), pair.sqrt() / sum, Scaled::ONE]);
    // 2 K' = 2 K whole/pi.
    let half = curve.half * whole / Scaled::from(HALF_PI.scale(2.0));
    let argument = if cosine.is_negative() { half - near } else { near };
    argument / curve.rate.shift(1)
}

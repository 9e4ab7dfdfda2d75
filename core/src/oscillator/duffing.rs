//! One orbit of u'' + p u + q u^3 = 0, set up once: regime, period, range, energy and escapes.
//!
//! With a = p + q u0^2, Delta = a^2 + 2 q u0'^2 = p^2 + 4 q E and S = sqrt(Delta), every amplitude, rate, parameter and
//! complement is a quotient of E, S, S + p, S - p, and (S + p)(S - p) = 4 q E gives the one that would cancel.
//! a, Delta and E come from sums without rounding (float/exact.rs), so their signs, which decide the regime, are exact.
//! Source: Salas 2019 (6), (7), the nine forms; the real classification is ours.

use super::cubic_course::{Course, course};
use super::regime::Regime;
use crate::domain::Domain;
use crate::float::exact::sum_of_products;
use crate::float::scaled::Scaled;

/// What the start and the force decide, to a double-double of any range.
#[derive(Clone, Copy, Debug)]
pub(super) struct Constants {
    pub p: Scaled,
    pub q: Scaled,
    /// 4 E = 2 u'^2 + u^2 (2 p + q u^2).
    pub energy: Scaled,
    /// p^2 + 4 q E.
    pub delta: Scaled,
    /// sqrt|Delta|.
    pub s: Scaled,
    /// S + p and S - p, for Delta >= 0.
    pub plus: Scaled,
    pub minus: Scaled,
}

/// A place on the orbit: where, how fast, and what would cancel there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub u: Scaled,
    pub velocity: Scaled,
    /// p + q u^2.
    pub stiffness: Scaled,
    /// 4 E + q u^4.
    pub excess: Scaled,
}

/// One orbit of u'' + p u + q u^3 = 0, set up once for many times.
///
/// ```
/// use libration::Duffing;
/// let spring = Duffing::new(1.0, 0.0, 1.0, 1.0)?;
/// assert_eq!(spring.regime().name(), "libration");
/// assert_eq!(format!("{:.9} {:.9}", spring.period(), spring.u(1.0)), "4.768022029 0.233691791");
/// # Ok::<(), libration::Domain>(())
/// ```
#[derive(Clone, Debug)]
pub struct Duffing {
    pub(super) u0: f64,
    pub(super) velocity0: f64,
    pub(super) p: f64,
    pub(super) q: f64,
    pub(super) constants: Constants,
    pub(super) course: Course,
    regime: Regime,
    period: f64,
    range: (f64, f64),
    escapes: (f64, f64),
}

impl Place {
    /// The place u of the orbit through (u0, velocity0), with the velocity there.
    pub fn new(u: f64, velocity: Scaled, [u0, v0, p, q]: [f64; 4]) -> Place {
        let energy: [&[f64]; 3] = [&[2.0, v0, v0], &[2.0, p, u0, u0], &[q, u0, u0, u0, u0]];
        Place {
            u: Scaled::from(u),
            velocity,
            stiffness: sum_of_products(&[&[p], &[q, u, u]]),
            excess: sum_of_products(&[energy[0], energy[1], energy[2], &[q, u, u, u, u]]),
        }
    }
}

impl Constants {
    fn new(u: f64, v: f64, p: f64, q: f64) -> Constants {
        let energy = sum_of_products(&[&[2.0, v, v], &[2.0, p, u, u], &[q, u, u, u, u]]);
        let delta = sum_of_products(&[&[p, p], &[2.0, p, q, u, u], &[q, q, u, u, u, u], &[2.0, q, v, v]]);
        let s = delta.abs().sqrt();
        let (p, q) = (Scaled::from(p), Scaled::from(q));
        let (plus, minus) = if p.is_negative() {
            let minus = s - p;
            (q * energy / minus, minus)
        } else {
            let plus = s + p;
            (plus, if plus.is_zero() { Scaled::ZERO } else { q * energy / plus })
        };
        Constants { p, q, energy, delta, s, plus, minus }
    }
}

impl Duffing {
    /// Sets up the orbit through u0 with velocity0 at t = 0.
    ///
    /// | argument | domain |
    /// |---|---|
    /// | `u0`, `velocity0` | finite |
    /// | `p`, `q` | finite, of any signs |
    pub fn new(u0: f64, velocity0: f64, p: f64, q: f64) -> Result<Duffing, Domain> {
        for (name, value) in [("u0", u0), ("velocity0", velocity0), ("p", p), ("q", q)] {
            Domain::check(name, value, value.is_finite(), "finite")?;
        }
        let constants = Constants::new(u0, velocity0, p, q);
        let start = Place::new(u0, Scaled::from(velocity0), [u0, velocity0, p, q]);
        let set_up = course(&constants, &start);
        Ok(Duffing {
            u0,
            velocity0,
            p,
            q,
            constants,
            course: set_up.course,
            regime: set_up.regime,
            period: set_up.period.value(),
            range: (set_up.range[0].value(), set_up.range[1].value()),
            escapes: (set_up.escapes[0].value(), set_up.escapes[1].value()),
        })
    }

    /// Regime, decided exactly.
    pub fn regime(&self) -> Regime {
        self.regime
    }
    /// Period of a libration, of a well and of a harmonic oscillator; at rest that of small oscillations about a stable
    /// equilibrium; else infinite. **Error** at most 4 ulp (plus 2^-100 of its condition).
    pub fn period(&self) -> f64 {
        self.period
    }
    /// Lowest and highest u over the whole motion, limits included; infinite where it escapes.
    pub fn range(&self) -> (f64, f64) {
        self.range
    }
    /// u'^2/2 + p u^2/2 + q u^4/4, from a sum without rounding; infinite beyond the range of doubles.
    pub fn energy(&self) -> f64 {
        self.constants.energy.shift(-2).value()
    }
    /// When u becomes infinite: above 0, or infinite if it never does.
    ///
    /// **Error** at most 1e-14 of it, plus 2^-100 of its condition.
    pub fn escape_time(&self) -> f64 {
        self.escapes.1
    }
    /// When u came from infinity: below 0, or minus infinity if it never did. Error as for [`Self::escape_time`].
    pub fn escape_time_backward(&self) -> f64 {
        self.escapes.0
    }
    /// u at t = 0.
    pub fn u0(&self) -> f64 {
        self.u0
    }
    /// u' at t = 0.
    pub fn velocity0(&self) -> f64 {
        self.velocity0
    }
    /// The linear stiffness.
    pub fn p(&self) -> f64 {
        self.p
    }
    /// The cubic stiffness.
    pub fn q(&self) -> f64 {
        self.q
    }
}

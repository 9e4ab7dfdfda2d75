//! One orbit of u'' + p u + q u^3 + s u^5 = 0, set up once: regime, period, range, energy and escapes.
//!
//! With v = 1/u^2, v'^2 = 4 C(v), C(v) = 2E v^3 - p v^2 - q v/2 - s/3: a cubic, so that every motion is an elliptic
//! function of Legendre's kind or, where a root is double or E = 0, an elementary one; u escapes where v = 0 and passes 0
//! where v is infinite. All signs that decide the regime are exact (float/dyadic.rs).
//! Source: derived; Belendez et al., J. Vib. Control 22 (2016) 2914, for motions released at rest about u = 0.

use super::energy::EnergyPolynomial;
use super::regime::OscillatorRegime;
use super::set_up::SetUp;
use crate::domain::Domain;
use crate::float::scaled::Scaled;

/// One orbit of u'' + p u + q u^3 + s u^5 = 0, set up once for many times.
///
/// ```
/// use libration::CubicQuintic;
/// let spring = CubicQuintic::new(1.0, 0.0, 1.0, 1.0, 1.0)?;
/// assert_eq!(spring.regime().name(), "libration");
/// assert_eq!(format!("{:.9} {:.9}", spring.period(), spring.u(1.0)), "4.123945209 0.041948934");
/// # Ok::<(), libration::Domain>(())
/// ```
#[derive(Clone, Debug)]
pub struct CubicQuintic {
    pub(super) u0: f64,
    pub(super) velocity0: f64,
    force: [f64; 3],
    pub(super) energy: EnergyPolynomial,
    pub(super) set_up: SetUp,
}

impl CubicQuintic {
    /// Sets up the orbit through u0 with velocity0 at t = 0.
    ///
    /// | argument | domain |
    /// |---|---|
    /// | `u0`, `velocity0` | finite |
    /// | `p`, `q`, `s` | finite, of any signs |
    ///
    /// # Errors
    /// A [`Domain`] that names the argument which is not finite.
    pub fn new(u0: f64, velocity0: f64, p: f64, q: f64, s: f64) -> Result<CubicQuintic, Domain> {
        let named = [("u0", u0), ("velocity0", velocity0), ("p", p), ("q", q), ("s", s)];
        for (name, value) in named {
            Domain::check(name, value, value.is_finite(), "finite")?;
        }
        let force = [p, q, s];
        let energy = EnergyPolynomial::new(u0, velocity0, force);
        let set_up = SetUp::new(&energy, u0, velocity0, force);
        Ok(CubicQuintic { u0, velocity0, force, energy, set_up })
    }

    /// Regime. Exact signs decide it, so it is right for the numbers that were passed.
    ///
    /// ```
    /// use libration::{CubicQuintic, OscillatorRegime};
    /// let saddle = CubicQuintic::new(1e-200, 0.0, -1.0, 1.0, 0.0)?;
    /// assert_eq!(saddle.regime(), OscillatorRegime::Well);
    /// # Ok::<(), libration::Domain>(())
    /// ```
    #[must_use]
    pub fn regime(&self) -> OscillatorRegime {
        self.set_up.regime
    }
    /// Period of a libration, of a well and of a harmonic oscillator; at rest that of small oscillations about a stable
    /// equilibrium; else infinite.
    ///
    /// **Error** at most 4 ulp, plus 2^-100 of its condition. **Source** DLMF 19.8.5.
    #[must_use]
    pub fn period(&self) -> f64 {
        self.set_up.period
    }
    /// Lowest and highest u over the whole motion, limits included; infinite where it escapes.
    ///
    /// **Error** at most 4 ulp. **Source** the roots of C(v), DLMF 1.11(iii).
    #[must_use]
    pub fn range(&self) -> (f64, f64) {
        self.set_up.range.into()
    }
    /// Energy u'^2/2 + p u^2/2 + q u^4/4 + s u^6/6, from a sum without rounding; infinite beyond the range of
    /// doubles.
    #[must_use]
    pub fn energy(&self) -> f64 {
        (self.energy.a.to_scaled() / Scaled::from(12.0)).value()
    }
    /// When u becomes infinite: above 0, or infinite if it never does.
    ///
    /// **Error** at most 1e-14 of it, plus 2^-100 of its condition. **Source** DLMF 19.29.4.
    ///
    /// ```
    /// let spring = libration::CubicQuintic::new(1.0, 0.0, -1.0, 0.0, -1.0)?;
    /// assert_eq!(format!("{:.9}", spring.escape_time()), "0.987650046");
    /// # Ok::<(), libration::Domain>(())
    /// ```
    #[must_use]
    pub fn escape_time(&self) -> f64 {
        self.set_up.escapes[1]
    }
    /// When u came from infinity: below 0, or minus infinity if it never did. Error as for [`Self::escape_time`].
    #[must_use]
    pub fn escape_time_backward(&self) -> f64 {
        self.set_up.escapes[0]
    }
    /// u at t = 0, as given.
    #[must_use]
    pub fn u0(&self) -> f64 {
        self.u0
    }
    /// u' at t = 0, as given.
    #[must_use]
    pub fn velocity0(&self) -> f64 {
        self.velocity0
    }
    /// The coefficient of u, as given.
    #[must_use]
    pub fn p(&self) -> f64 {
        self.force[0]
    }
    /// The coefficient of u^3, as given.
    #[must_use]
    pub fn q(&self) -> f64 {
        self.force[1]
    }
    /// The coefficient of u^5, as given.
    #[must_use]
    pub fn s(&self) -> f64 {
        self.force[2]
    }
}

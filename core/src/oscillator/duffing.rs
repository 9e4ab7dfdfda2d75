//! One orbit of u'' + p u + r u^2 + q u^3 = c: without even powers the cubic-quintic oscillator without its quintic force, with
//! Salas's names; with them a motion of its own (even_powers.rs).
//!
//! Source: Salas 2019 (6), (7), the nine forms; the real classification is ours (set_up.rs, pq_quotient.rs).

use super::cubic_quintic::CubicQuintic;
use super::even_powers::EvenPowers;
use super::regime::OscillatorRegime;
use crate::domain::Domain;

/// One orbit of u'' + p u + r u^2 + q u^3 = c, set up once for many times.
///
/// ```
/// use libration::Duffing;
/// let spring = Duffing::new(1.0, 0.0, 1.0, 1.0)?;
/// assert_eq!(spring.regime().name(), "libration");
/// assert_eq!(format!("{:.9} {:.9}", spring.period(), spring.u(1.0)), "4.768022029 0.233691791");
/// # Ok::<(), libration::Domain>(())
/// ```
#[derive(Clone, Debug)]
pub struct Duffing(Powers);

/// Without even powers and with them.
#[derive(Clone, Debug)]
enum Powers {
    Odd(CubicQuintic),
    Even(Box<EvenPowers>),
}

/// What both answer.
macro_rules! of_both {
    ($duffing:expr, $orbit:ident => $value:expr) => {
        match &$duffing.0 {
            Powers::Odd($orbit) => $value,
            Powers::Even($orbit) => $value,
        }
    };
}

impl Duffing {
    /// Sets up the orbit of u'' + p u + q u^3 = 0 through u0 with velocity0 at t = 0.
    ///
    /// | argument | domain |
    /// |---|---|
    /// | `u0`, `velocity0` | finite |
    /// | `p`, `q` | finite, of any signs |
    ///
    /// # Errors
    /// A [`Domain`] that names the argument which is not finite.
    pub fn new(u0: f64, velocity0: f64, p: f64, q: f64) -> Result<Duffing, Domain> {
        Duffing::with_even_powers(u0, velocity0, [p, q, 0.0, 0.0])
    }

    /// Sets up the orbit of u'' + p u + r u^2 + q u^3 = c: a quadratic force r and a constant one c besides. Where both are 0 it is
    /// the orbit of [`Duffing::new`], to the last bit.
    ///
    /// | argument | domain |
    /// |---|---|
    /// | `u0`, `velocity0` | finite |
    /// | `[p, q, r, c]` | finite, of any signs |
    ///
    /// **Source** u'^2 is a real quartic: Weierstrass' and Jacobi's functions, DLMF 22, 23; quartic.rs, curve.rs.
    ///
    /// # Errors
    /// A [`Domain`] that names the argument which is not finite.
    ///
    /// ```
    /// use libration::Duffing;
    /// let beam = Duffing::with_even_powers(1.0, 0.0, [1.0, 0.2, 0.5, 0.0])?;
    /// assert_eq!(format!("{:.9} {:.9}", beam.period(), beam.u(1.0)), "6.262978466 0.300026789");
    /// assert_eq!(format!("{:.9}", beam.range().0), "-1.401980262");
    /// # Ok::<(), libration::Domain>(())
    /// ```
    pub fn with_even_powers(u0: f64, velocity0: f64, [p, q, r, c]: [f64; 4]) -> Result<Duffing, Domain> {
        for (name, value) in [("u0", u0), ("velocity0", velocity0), ("p", p), ("q", q), ("r", r), ("c", c)] {
            Domain::check(name, value, value.is_finite(), "finite")?;
        }
        if r == 0.0 && c == 0.0 {
            return Ok(Duffing(Powers::Odd(CubicQuintic::new(u0, velocity0, p, q, 0.0)?)));
        }
        Ok(Duffing(Powers::Even(Box::new(EvenPowers::new(u0, velocity0, [p, q, r, c])))))
    }

    /// The same orbit of a cubic-quintic oscillator without its quintic force; none with even powers.
    #[must_use]
    pub fn as_cubic_quintic(&self) -> Option<&CubicQuintic> {
        match &self.0 {
            Powers::Odd(orbit) => Some(orbit),
            Powers::Even(_) => None,
        }
    }
    /// Regime, decided exactly.
    #[must_use]
    pub fn regime(&self) -> OscillatorRegime {
        of_both!(self, orbit => orbit.regime())
    }
    /// Period: [`CubicQuintic::period`].
    #[must_use]
    pub fn period(&self) -> f64 {
        of_both!(self, orbit => orbit.period())
    }
    /// Lowest and highest u over the whole motion, limits included; infinite where it escapes.
    #[must_use]
    pub fn range(&self) -> (f64, f64) {
        of_both!(self, orbit => orbit.range())
    }
    /// u'^2/2 + p u^2/2 + r u^3/3 + q u^4/4 - c u, from a sum without rounding; infinite beyond the range of doubles.
    #[must_use]
    pub fn energy(&self) -> f64 {
        of_both!(self, orbit => orbit.energy())
    }
    /// When u becomes infinite: [`CubicQuintic::escape_time`].
    #[must_use]
    pub fn escape_time(&self) -> f64 {
        of_both!(self, orbit => orbit.escape_time())
    }
    /// When u came from infinity: [`CubicQuintic::escape_time_backward`].
    #[must_use]
    pub fn escape_time_backward(&self) -> f64 {
        of_both!(self, orbit => orbit.escape_time_backward())
    }
    /// u at t = 0.
    #[must_use]
    pub fn u0(&self) -> f64 {
        of_both!(self, orbit => orbit.u0())
    }
    /// u' at t = 0.
    #[must_use]
    pub fn velocity0(&self) -> f64 {
        of_both!(self, orbit => orbit.velocity0())
    }
    /// p, q, r and c.
    #[must_use]
    pub fn coefficients(&self) -> [f64; 4] {
        match &self.0 {
            Powers::Odd(orbit) => [orbit.p(), orbit.q(), 0.0, 0.0],
            Powers::Even(orbit) => orbit.force,
        }
    }
    /// The linear stiffness.
    #[must_use]
    pub fn p(&self) -> f64 {
        self.coefficients()[0]
    }
    /// The cubic stiffness.
    #[must_use]
    pub fn q(&self) -> f64 {
        self.coefficients()[1]
    }
    /// The quadratic stiffness.
    #[must_use]
    pub fn r(&self) -> f64 {
        self.coefficients()[2]
    }
    /// The constant force.
    #[must_use]
    pub fn c(&self) -> f64 {
        self.coefficients()[3]
    }
    /// u at t: [`CubicQuintic::u`].
    #[must_use]
    pub fn u(&self, t: f64) -> f64 {
        self.motion(t).0
    }
    /// u' at t: [`CubicQuintic::velocity`].
    #[must_use]
    pub fn velocity(&self, t: f64) -> f64 {
        self.motion(t).1
    }
    /// u and u' at t: [`CubicQuintic::motion`].
    #[must_use]
    pub fn motion(&self, t: f64) -> (f64, f64) {
        of_both!(self, orbit => orbit.motion(t))
    }
    /// u at every time: [`CubicQuintic::u_into`].
    pub fn u_into(&self, t: &[f64], u: &mut [f64]) {
        of_both!(self, orbit => orbit.u_into(t, u));
    }
    /// u' at every time: [`CubicQuintic::velocity_into`].
    pub fn velocity_into(&self, t: &[f64], velocity: &mut [f64]) {
        of_both!(self, orbit => orbit.velocity_into(t, velocity));
    }
    /// u and u' at every time: [`CubicQuintic::motion_into`].
    pub fn motion_into(&self, t: &[f64], u: &mut [f64], velocity: &mut [f64]) {
        of_both!(self, orbit => orbit.motion_into(t, u, velocity));
    }
    /// All times at which the motion passes `u`: [`CubicQuintic::times`].
    ///
    /// # Errors
    /// As there.
    pub fn times(&self, u: f64, start: f64, stop: f64) -> Result<Vec<f64>, Domain> {
        self.times_unless(u, start, stop, &|| false)
    }

    /// [`Duffing::times`], where `ended` is asked now and then: once it is true, the times are cut short and mean nothing.
    pub fn times_unless(
        &self,
        u: f64,
        start: f64,
        stop: f64,
        ended: &dyn Fn() -> bool,
    ) -> Result<Vec<f64>, Domain> {
        of_both!(self, orbit => orbit.times_unless(u, start, stop, ended))
    }
}

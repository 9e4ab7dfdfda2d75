//! One orbit of u'' + p u + q u^3 = 0: the cubic-quintic oscillator without its quintic force, with Salas's names.
//!
//! Source: Salas 2019 (6), (7), the nine forms; the real classification is ours (set_up.rs, pq_quotient.rs).

use super::cubic_quintic::CubicQuintic;
use super::regime::OscillatorRegime;
use crate::domain::Domain;

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
pub struct Duffing(CubicQuintic);

impl Duffing {
    /// Sets up the orbit through u0 with velocity0 at t = 0.
    ///
    /// | argument | domain |
    /// |---|---|
    /// | `u0`, `velocity0` | finite |
    /// | `p`, `q` | finite, of any signs |
    ///
    /// # Errors
    /// A [`Domain`] that names the argument which is not finite.
    pub fn new(u0: f64, velocity0: f64, p: f64, q: f64) -> Result<Duffing, Domain> {
        for (name, value) in [("u0", u0), ("velocity0", velocity0), ("p", p), ("q", q)] {
            Domain::check(name, value, value.is_finite(), "finite")?;
        }
        Ok(Duffing(CubicQuintic::new(u0, velocity0, p, q, 0.0)?))
    }

    /// The same orbit with gamma = 0.
    #[must_use]
    pub fn as_cubic_quintic(&self) -> &CubicQuintic {
        &self.0
    }
    /// Regime, decided exactly.
    #[must_use]
    pub fn regime(&self) -> OscillatorRegime {
        self.0.regime()
    }
    /// Period: [`CubicQuintic::period`].
    #[must_use]
    pub fn period(&self) -> f64 {
        self.0.period()
    }
    /// Lowest and highest u over the whole motion, limits included; infinite where it escapes.
    #[must_use]
    pub fn range(&self) -> (f64, f64) {
        self.0.range()
    }
    /// u'^2/2 + p u^2/2 + q u^4/4, from a sum without rounding; infinite beyond the range of doubles.
    #[must_use]
    pub fn energy(&self) -> f64 {
        self.0.energy()
    }
    /// When u becomes infinite: [`CubicQuintic::escape_time`].
    #[must_use]
    pub fn escape_time(&self) -> f64 {
        self.0.escape_time()
    }
    /// When u came from infinity: [`CubicQuintic::escape_time_backward`].
    #[must_use]
    pub fn escape_time_backward(&self) -> f64 {
        self.0.escape_time_backward()
    }
    /// u at t = 0.
    #[must_use]
    pub fn u0(&self) -> f64 {
        self.0.u0()
    }
    /// u' at t = 0.
    #[must_use]
    pub fn velocity0(&self) -> f64 {
        self.0.velocity0()
    }
    /// The linear stiffness.
    #[must_use]
    pub fn p(&self) -> f64 {
        self.0.alpha()
    }
    /// The cubic stiffness.
    #[must_use]
    pub fn q(&self) -> f64 {
        self.0.beta()
    }
    /// u at t: [`CubicQuintic::u`].
    #[must_use]
    pub fn u(&self, t: f64) -> f64 {
        self.0.u(t)
    }
    /// u' at t: [`CubicQuintic::velocity`].
    #[must_use]
    pub fn velocity(&self, t: f64) -> f64 {
        self.0.velocity(t)
    }
    /// u and u' at t: [`CubicQuintic::motion`].
    #[must_use]
    pub fn motion(&self, t: f64) -> (f64, f64) {
        self.0.motion(t)
    }
    /// u at every time: [`CubicQuintic::u_into`].
    pub fn u_into(&self, t: &[f64], u: &mut [f64]) {
        self.0.u_into(t, u);
    }
    /// u' at every time: [`CubicQuintic::velocity_into`].
    pub fn velocity_into(&self, t: &[f64], velocity: &mut [f64]) {
        self.0.velocity_into(t, velocity);
    }
    /// u and u' at every time: [`CubicQuintic::motion_into`].
    pub fn motion_into(&self, t: &[f64], u: &mut [f64], velocity: &mut [f64]) {
        self.0.motion_into(t, u, velocity);
    }
    /// All times at which the motion passes `u`: [`CubicQuintic::times`].
    ///
    /// # Errors
    /// As there.
    pub fn times(&self, u: f64, start: f64, stop: f64) -> Result<Vec<f64>, Domain> {
        self.0.times(u, start, stop)
    }

    /// [`Duffing::times`], where `ended` is asked now and then: once it is true, the times are cut short and mean nothing.
    pub fn times_unless(
        &self,
        u: f64,
        start: f64,
        stop: f64,
        ended: &dyn Fn() -> bool,
    ) -> Result<Vec<f64>, Domain> {
        self.0.times_unless(u, start, stop, ended)
    }
}

//! One orbit of u'' + p u + r u^2 + q u^3 = c: without even powers the cubic-quintic oscillator without its quintic force, with
//! Salas's names; with them a motion of its own (even_powers.rs).
//!
//! Source: Salas 2019 (6), (7), the nine forms; the real classification is ours (set_up.rs, pq_quotient.rs).

use super::cubic_quintic::CubicQuintic;
use super::even_powers::EvenPowers;
use super::regime::OscillatorRegime;
use crate::domain::Domain;
use std::borrow::Cow;

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
    Odd(Box<CubicQuintic>),
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
            let orbit = CubicQuintic::new(u0, velocity0, p, q, 0.0)?;
            return Ok(Duffing(Powers::Odd(Box::new(orbit))));
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

/// The Fourier series of a motion in its phase: u = mean + sum u_n cos(n phase), u' = sum velocity_n sin(n phase).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct OscillatorFourier {
    /// The mean of u over a period.
    pub mean: f64,
    /// Of cos(n phase) in u, n = 1, 2, ...
    pub u: Vec<f64>,
    /// Of sin(n phase) in u'.
    pub velocity: Vec<f64>,
}

impl Duffing {
    /// The orbit by the theory with even powers, of which the other one is a case.
    fn even(&self) -> Cow<'_, EvenPowers> {
        match &self.0 {
            Powers::Even(orbit) => Cow::Borrowed(orbit),
            Powers::Odd(_) => Cow::Owned(EvenPowers::new(self.u0(), self.velocity0(), self.coefficients())),
        }
    }

    /// Action (1/2 pi) closed integral of u' du of a libration and in a well; 0 at rest; on a separatrix that of the way out and
    /// back (of a heteroclinic one there and back); NaN for a motion that does not stay.
    ///
    /// **Error** at most 4 ulp, plus 2^-100 of its condition. **Source** Parseval's sum of the Fourier series.
    ///
    /// ```
    /// let spring = libration::Duffing::new(1.0, 0.0, 1.0, 1.0)?;
    /// assert_eq!(format!("{:.12} {:.9}", spring.action(), spring.frequency()), "0.636921769131 1.317776065");
    /// # Ok::<(), libration::Domain>(())
    /// ```
    #[must_use]
    pub fn action(&self) -> f64 {
        self.even().action().value()
    }
    /// Mean angular frequency, 2 pi over the period; 0 on a separatrix, NaN for a motion that does not stay.
    ///
    /// **Error** at most 4 ulp, plus 2^-100 of its condition. **Source** 2 pi over [`Duffing::period`].
    #[must_use]
    pub fn frequency(&self) -> f64 {
        self.even().frequency().value()
    }
    /// Phase in rad at t, which grows evenly with the slope [`Duffing::frequency`]: 0 at the highest point, and in (-pi, pi] at
    /// t = 0. NaN where the motion does not repeat.
    ///
    /// **Error** at most 4 ulp of the larger of the phase and pi. **Source** DLMF 22.19(i).
    #[must_use]
    pub fn phase(&self, t: f64) -> f64 {
        self.even().phase(t)
    }
    /// The mean of u and the first n amplitudes of u and u', n from 1 to 10^6; NaN where the motion does not repeat.
    ///
    /// **Error** at most 4 ulp of each amplitude, plus 2^-100 of its condition. **Source** residues of an elliptic function of order
    /// two; DLMF 22.11.
    ///
    /// # Errors
    /// For another n.
    ///
    /// ```
    /// let series = libration::Duffing::new(1.0, 0.0, 1.0, 1.0)?.fourier(3)?;
    /// assert_eq!(series.u.iter().map(|a| format!("{a:.9}")).collect::<Vec<_>>(), ["0.981710616", "0.000000000", "0.017960678"]);
    /// # Ok::<(), libration::Domain>(())
    /// ```
    pub fn fourier(&self, n: i64) -> Result<OscillatorFourier, Domain> {
        if !(1..=1_000_000).contains(&n) {
            return Err(Domain::new("n", n.to_string(), "from 1 to 1000000"));
        }
        let orbit = self.even();
        let frequency = orbit.frequency();
        let (mean, u) = orbit.harmonics(n as usize);
        let velocity =
            u.iter().enumerate().map(|(k, a)| (-frequency * ((k + 1) as f64 * a)).value()).collect();
        Ok(OscillatorFourier { mean, u, velocity })
    }
    /// The root of the sum of u_n^2 over n >= 2, over |u_1|: 0 at rest, NaN where the motion does not repeat.
    ///
    /// **Error** at most 4 ulp, plus 2^-100 of its condition. **Source** Parseval's sum of the Fourier series.
    #[must_use]
    pub fn distortion(&self) -> f64 {
        self.even().distortion()
    }
    /// Derivatives of u (first row) and u' at t by u0, velocity0, p, q, r and c; NaN where there is no motion.
    ///
    /// **Error** in each row at most 1e-12 of the largest change, while a disturbance grows by less than 1e10 on the way: next to a
    /// separatrix fewer digits are left. **Source** the variational equations by Taylor series.
    ///
    /// ```
    /// let by = libration::Duffing::new(1.0, 0.0, 1.0, 0.0)?.derivatives(1.0);
    /// assert_eq!(by[0].map(|x| format!("{x:.6}"))[..3], ["0.540302", "0.841471", "-0.420735"]);
    /// # Ok::<(), libration::Domain>(())
    /// ```
    #[must_use]
    pub fn derivatives(&self, t: f64) -> [[f64; 6]; 2] {
        let mut found = [[f64::NAN; 6]; 2];
        self.derivatives_into(&[t], &mut |_, derivatives| found = derivatives);
        found
    }
    /// [`Duffing::derivatives`] of every time: `put` takes the place and the derivatives.
    pub fn derivatives_into(&self, t: &[f64], put: &mut dyn FnMut(usize, [[f64; 6]; 2])) {
        self.even().derivatives_into(t, put);
    }
}

//! When an angle is passed: the inverse of the motion.
//!
//! With s1 = sin of half the angle and x1 = |velocity there|/2 omega0, so that x1^2 = kappa^2 - s1^2, the motion
//! passes upwards at the phase omega0 t = s1 R_F(x1^2, kappa^2 c1^2, kappa^2) and downwards as long before its next
//! bottom. x1^2 is c1^2 - (1 - kappa^2) away from the turning points and x0^2 + s0^2 - s1^2 next to them, in
//! triple-double, so nothing cancels. Source: DLMF 19.25.5, 22.15(ii).

use super::half_angle::{half_angle, scaled};
use super::orbit::{Orbit, Solution};
use super::separatrix::Separatrix;
use super::state::State;
use super::theta_quotients::Elliptic;
use crate::domain::Domain;
use crate::elliptic::integrals::carlson_duplication::{rf, rf_of_roots};
use crate::elliptic::phase::{LAST_HALF_PERIOD, Phase};
use crate::float::angle_reduction::{self, ReducedAngle};
use crate::float::elementary::arctangent;
use crate::float::{Dd, PI, Scaled, TWO_PI, Td};
use crate::motion::passages::Interval;

pub use crate::motion::passages::MOST_TIMES;

/// The angles between which a motion stays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes {
    /// In rad.
    pub lowest: f64,
    /// In rad.
    pub highest: f64,
}

/// An angle in the canonical motion: whole turns, and sine and cosine of its amplitude with the cosine of half of it.
struct Passage {
    turns: f64,
    sine: Dd,
    cosine: Dd,
    half_cosine: Dd,
}

impl Passage {
    /// Time over 1/omega0 since the bottom.
    fn since_bottom(&self) -> Dd {
        self.sine * rf_of_roots(self.cosine, self.half_cosine)
    }
}

/// x1^2 over 4^power, next to a turning point.
fn near_turning(orbit: &Orbit, state: &State, sine: Td, cosine: Td) -> Dd {
    if let Some([m, mc]) = state.given {
        let square = if state.power != 0 || sine.hi < 0.7 { m - sine.square() } else { cosine.square() - mc };
        return square.to_dd();
    }
    let x = Td::from(state.x);
    let difference = if state.power != 0 {
        let start = Td::from(state.s.abs());
        (start - sine) * (start + sine)
    } else {
        let (start, start_cosine, _) = half_angle(&orbit.placed.reduced, orbit.force.upside_down(), 0);
        if sine.hi > 0.7 {
            (cosine - start_cosine) * (cosine + start_cosine)
        } else {
            (start - sine) * (start + sine)
        }
    };
    (x.square() + difference).to_dd()
}

impl Orbit {
    /// Where the canonical motion passes an angle, or `None` where it does not.
    fn passage(&self, state: &State, theta: f64) -> Option<Passage> {
        let State { k, mc, power, frame, .. } = *state;
        let upside_down = self.force.upside_down();
        let reduced: ReducedAngle = angle_reduction::reduce(theta);
        let (sine, cosine, own_power) = half_angle(&reduced, upside_down, i32::MIN / 2);
        let sine = scaled(sine, own_power - power);
        let side = frame.side * if upside_down { -reduced.side } else { reduced.side };
        let half_turns = if upside_down { 0.5 * (reduced.side - frame.half_turn) } else { 0.0 };
        let turns = frame.side * (reduced.turns - frame.turns + Dd::from(half_turns)).value();
        let libration = mc.hi > 0.0;
        let half_cosine = cosine.to_dd();
        let (sine, cosine) = if libration && self.turns_at(theta, &reduced) {
            (Dd::from(side), Dd::ZERO)
        } else if theta == self.theta0 {
            (state.s / k, state.x / k)
        } else {
            let square = half_cosine.square();
            let speed = if libration && square.hi < 2.0 * mc.hi || power != 0 {
                near_turning(self, state, sine, cosine)
            } else {
                square - mc
            };
            if !(speed.hi >= 0.0 && sine.hi.is_finite()) {
                return None;
            }
            (sine.to_dd() * side / k, speed.sqrt() / k)
        };
        Some(Passage { turns, sine, cosine, half_cosine })
    }

    /// Whether an angle is a turning angle as this orbit rounds it.
    fn turns_at(&self, theta: f64, reduced: &ReducedAngle) -> bool {
        let distance = if self.force.upside_down() { reduced.from_top } else { reduced.from_bottom };
        let Extremes { lowest, highest } = self.extremes();
        distance.to_dd().value() == self.theta_max() || theta == lowest || theta == highest
    }

    /// Lowest and highest angle in rad: the turning angles, the limits on the separatrix, infinite in rotation.
    ///
    /// **Error** at most 4 ulp. Source: kappa = sin(theta_max/2), Landau & Lifshitz, Mechanics, section 11.
    ///
    /// ```
    /// use libration::{Frequency, Orbit};
    /// let orbit = Orbit::new(0.0, 1.0, Frequency::from_omega0(1.0)?)?;
    /// let extremes = orbit.extremes();
    /// assert_eq!(format!("{:.9} {:.9}", extremes.lowest, extremes.highest), "-1.047197551 1.047197551");
    /// # Ok::<(), libration::Domain>(())
    /// ```
    #[must_use]
    pub fn extremes(&self) -> Extremes {
        let frame = &self.frame;
        let between = |lowest: f64, highest: f64| Extremes { lowest, highest };
        let around = |reach: Dd| between((frame.base - reach).value(), (frame.base + reach).value());
        match &self.solution {
            Solution::Equilibrium => between(self.theta0, self.theta0),
            Solution::ForceFree | Solution::Rotation(_) => between(f64::NEG_INFINITY, f64::INFINITY),
            Solution::Separatrix(_) if frame.half_turn == 0.0 => around(PI),
            Solution::Libration(_) if !frame.shifted() => between(-self.theta_max(), self.theta_max()),
            Solution::Libration(elliptic) if frame.half_turn == 0.0 => {
                around(arctangent(self.kappa(), elliptic.lattice.kc).scale(2.0))
            }
            solution => {
                // From the other equilibrium the near end is the distance from the top, and the far end a turn on.
                let gap = match solution {
                    Solution::Libration(elliptic) => {
                        arctangent(elliptic.lattice.kc, self.kappa()).scale(2.0 * frame.half_turn)
                    }
                    _ => Dd::ZERO,
                };
                let near = (frame.base + gap).value();
                let far = (frame.base + (TWO_PI * frame.half_turn - gap)).value();
                if near < far { between(near, far) } else { between(far, near) }
            }
        }
    }

    /// kappa of a libration.
    fn kappa(&self) -> Dd {
        self.state.map_or(Dd::ZERO, |state| state.k.ldexp(state.power))
    }

    /// Half periods from the start to the nearest turning point, signed: its quarter period less the time since the
    /// bottom, as cn R_F(mc, mc sn^2, dn^2) at the start, without that difference.
    fn to_turning(&self, elliptic: &Elliptic, &State { s, c, x, k, kc, .. }: &State) -> Dd {
        if elliptic.phase.start.hi.abs() < 0.25 {
            return Dd::from(0.5f64.copysign(s.hi)) - elliptic.phase.start;
        }
        let (cn, ratio) = (x / k, kc / c);
        // Over dn^2, which is as small as mc next to the top.
        let square = ratio.square();
        let time = cn / c * rf(square, square * (s / k).square(), Dd::ONE);
        time / elliptic.lattice.quarter.scale(2.0) * 1f64.copysign(s.hi)
    }

    /// All times from `start` to `stop` (in s, both included) at which the motion passes `theta` (in rad): modulo 2 pi
    /// in libration, the unwrapped angle in rotation and on the separatrix. Rising; a turning angle once a
    /// swing (also as [`Orbit::theta_max`] and [`Orbit::extremes`] round it); none at rest.
    ///
    /// **Error** such that the angle there is `theta` to 4 ulp of the largest angle plus what an ulp of the time makes of
    /// it. Source: DLMF 19.25.5, 22.15(ii).
    ///
    /// # Errors
    /// For arguments that are NaN, a `start` after `stop`, more than [`MOST_TIMES`] passages, and an interval that reaches
    /// beyond 2^53 half periods.
    ///
    /// ```
    /// use libration::{Frequency, Orbit};
    /// let orbit = Orbit::new(2.0, 0.0, Frequency::from_omega0(1.0)?)?;
    /// let times = orbit.times(0.5, 0.0, 10.0)?;
    /// assert_eq!(times.iter().map(|t| format!("{t:.6}")).collect::<Vec<_>>(), ["1.785845", "6.563908"]);
    /// # Ok::<(), libration::Domain>(())
    /// ```
    pub fn times(&self, theta: f64, start: f64, stop: f64) -> Result<Vec<f64>, Domain> {
        self.times_unless(theta, start, stop, &|| false)
    }

    /// [`Orbit::times`], where `ended` is asked now and then: once it is true, the times are cut short and mean nothing.
    ///
    /// # Errors
    /// As for [`Orbit::times`].
    pub fn times_unless(
        &self,
        theta: f64,
        start: f64,
        stop: f64,
        ended: &dyn Fn() -> bool,
    ) -> Result<Vec<f64>, Domain> {
        Domain::check("theta", theta, theta.is_finite(), "finite")?;
        let interval = Interval::new(start, stop, ended)?;
        let Some(state) = self.state else {
            return Ok(match self.solution {
                Solution::ForceFree => within(interval, self.force_free_time(theta)),
                _ => Vec::new(),
            });
        };
        let Some(passage) = self.passage(&state, theta) else { return Ok(Vec::new()) };
        match &self.solution {
            Solution::Libration(elliptic) => {
                let began = elliptic.phase.start;
                if passage.cosine.hi == 0.0 {
                    let nearest = self.to_turning(elliptic, &state);
                    let other = passage.sine.hi.signum() != 1f64.copysign(state.s.hi);
                    let at = if other { nearest + Dd::ONE } else { nearest };
                    return interval.repeated(elliptic.phase.rate, self.time_scale, &[at], 2.0);
                }
                let up = passage.since_bottom() / elliptic.lattice.quarter.scale(2.0);
                interval.repeated(
                    elliptic.phase.rate,
                    self.time_scale,
                    &[up - began, Dd::ONE - up - began],
                    2.0,
                )
            }
            Solution::Rotation(elliptic) => {
                let rest = state.k * passage.since_bottom() / elliptic.lattice.quarter.scale(2.0);
                let far = passage.turns.abs() >= 0.5 * LAST_HALF_PERIOD;
                Domain::check("theta", theta, !far, "within 2^52 turns of theta0")?;
                Ok(within(interval, self.time_of(&elliptic.phase, rest + Dd::from(passage.turns))))
            }
            Solution::Separatrix(Separatrix { phase, .. })
                if passage.turns == 0.0 && passage.half_cosine.hi > 0.0 =>
            {
                Ok(within(interval, self.time_of(phase, passage.since_bottom())))
            }
            _ => Ok(Vec::new()),
        }
    }

    /// [`Orbit::times`] at which the motion passes `theta` in any turn: all tops of a rotation. In libration, which counts
    /// modulo 2 pi already, and at rest the same.
    ///
    /// **Error** and source as for [`Orbit::times`].
    ///
    /// # Errors
    /// As for [`Orbit::times`], in rotation too.
    ///
    /// ```
    /// use libration::{Frequency, Orbit};
    /// let orbit = Orbit::new(0.0, 3.0, Frequency::from_omega0(1.0)?)?;
    /// let tops = orbit.times_of_every_turn(core::f64::consts::PI, 0.0, 7.0)?;
    /// assert_eq!(tops.iter().map(|t| format!("{t:.6}")).collect::<Vec<_>>(), ["1.206445", "3.619335", "6.032225"]);
    /// # Ok::<(), libration::Domain>(())
    /// ```
    pub fn times_of_every_turn(&self, theta: f64, start: f64, stop: f64) -> Result<Vec<f64>, Domain> {
        self.times_of_every_turn_unless(theta, start, stop, &|| false)
    }

    /// [`Orbit::times_of_every_turn`], where `ended` is asked as for [`Orbit::times_unless`].
    ///
    /// # Errors
    /// As for [`Orbit::times`], in rotation too.
    pub fn times_of_every_turn_unless(
        &self,
        theta: f64,
        start: f64,
        stop: f64,
        ended: &dyn Fn() -> bool,
    ) -> Result<Vec<f64>, Domain> {
        Domain::check("theta", theta, theta.is_finite(), "finite")?;
        let interval = Interval::new(start, stop, ended)?;
        match (&self.solution, self.state) {
            (Solution::Rotation(elliptic), Some(state)) => {
                let Some(passage) = self.passage(&state, theta) else { return Ok(Vec::new()) };
                let at = state.k * passage.since_bottom() / elliptic.lattice.quarter.scale(2.0);
                let phase = &elliptic.phase;
                interval.repeated(phase.rate, self.time_scale, &[at - phase.start], 1.0)
            }
            (Solution::Separatrix(Separatrix { phase, .. }), Some(state)) => {
                Ok(match self.passage(&state, theta) {
                    Some(passage) if passage.half_cosine.hi > 0.0 => {
                        within(interval, self.time_of(phase, passage.since_bottom()))
                    }
                    _ => Vec::new(),
                })
            }
            (Solution::ForceFree, _) => {
                let (rate, scale) = (Scaled::from(self.velocity0).abs() / Scaled::from(TWO_PI)).carried();
                let turned = (Scaled::from(theta) - Scaled::from(self.theta0)) / Scaled::from(TWO_PI);
                let at = turned.signed(self.velocity0).to_dd();
                interval.repeated(rate, scale, &[at], 1.0)
            }
            _ => self.times_unless(theta, start, stop, ended),
        }
    }

    /// The first time from `after` on (in s, included) at which the motion passes `theta`; `None` where it does not.
    ///
    /// **Error** and source as for [`Orbit::times`].
    ///
    /// # Errors
    /// As for [`Orbit::times`].
    ///
    /// ```
    /// use libration::{Frequency, Orbit};
    /// let orbit = Orbit::new(2.0, 0.0, Frequency::from_omega0(1.0)?)?;
    /// assert_eq!(orbit.next_time(0.5, 2.0)?.map(|t| format!("{t:.6}")), Some("6.563908".into()));
    /// # Ok::<(), libration::Domain>(())
    /// ```
    pub fn next_time(&self, theta: f64, after: f64) -> Result<Option<f64>, Domain> {
        // A libration passes every angle that it reaches within a period; the other motions pass it once.
        let longest =
            if matches!(self.solution, Solution::Libration(_)) { 1.5 * self.period() } else { f64::MAX };
        Ok(self.times(theta, after, after + longest)?.first().copied())
    }

    /// All times from `start` to `stop` (in s, both included) at which a libration turns back; none in other regimes.
    ///
    /// **Error** and source as for [`Orbit::times`].
    ///
    /// # Errors
    /// As for [`Orbit::times`].
    ///
    /// ```
    /// use libration::{Frequency, Orbit};
    /// let orbit = Orbit::new(2.0, 0.0, Frequency::from_omega0(1.0)?)?;
    /// let times = orbit.turning_times(0.0, 10.0)?;
    /// assert_eq!(times.iter().map(|t| format!("{t:.6}")).collect::<Vec<_>>(), ["0.000000", "4.174876", "8.349753"]);
    /// # Ok::<(), libration::Domain>(())
    /// ```
    pub fn turning_times(&self, start: f64, stop: f64) -> Result<Vec<f64>, Domain> {
        self.turning_times_unless(start, stop, &|| false)
    }

    /// [`Orbit::turning_times`], where `ended` is asked now and then: once it is true, the times are cut short and mean
    /// nothing.
    ///
    /// # Errors
    /// As for [`Orbit::times`].
    pub fn turning_times_unless(
        &self,
        start: f64,
        stop: f64,
        ended: &dyn Fn() -> bool,
    ) -> Result<Vec<f64>, Domain> {
        let interval = Interval::new(start, stop, ended)?;
        match (&self.solution, self.state) {
            (Solution::Libration(elliptic), Some(state)) => interval.repeated(
                elliptic.phase.rate,
                self.time_scale,
                &[self.to_turning(elliptic, &state)],
                1.0,
            ),
            _ => Ok(Vec::new()),
        }
    }

    /// Time of a phase.
    fn time_of(&self, phase: &Phase, at: Dd) -> f64 {
        ((at - phase.start) / phase.rate).value() / self.time_scale
    }

    /// Time of an angle without force.
    fn force_free_time(&self, theta: f64) -> f64 {
        ((Scaled::from(theta) - Scaled::from(self.theta0)) / Scaled::from(self.velocity0)).value()
    }
}

/// The time, if it is in the interval and in the range of doubles.
fn within(interval: Interval<'_>, time: f64) -> Vec<f64> {
    if time.is_finite() && interval.holds(time) { vec![time] } else { Vec::new() }
}

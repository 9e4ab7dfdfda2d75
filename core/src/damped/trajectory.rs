//! The motion of a pendulum with friction over an interval of time: values at any time in it, and times of what happens.

use super::branch::{Branch, since};
use super::circular::of_double;
use super::damped_pendulum::DampedPendulum;
use super::exact::Exact;
use super::segment::{Event, Segment, Tolerance};
use super::torque::TORQUES;
use crate::domain::{Domain, shown};
use crate::float::{Dd, TWO_PI};
use crate::pendulum::{Orbit, Turns, half_open};
use crate::sorting::{sort, sort_numbers};
use std::sync::Arc;

#[derive(Clone, Debug)]
enum Motion {
    Exact(Arc<dyn Exact>),
    /// Backward and forward from t = 0.
    Integrated(Arc<[Branch; 2]>),
}

/// The motion of a [`DampedPendulum`] from a start to a stop.
///
/// ```
/// use libration::{DampedPendulum, Frequency, Friction, Torque};
/// let friction = Friction::new(0.0, 0.0, 0.5, 0.0)?;
/// let pendulum = DampedPendulum::new(1.0, 0.0, Frequency::from_omega0(2.0)?, friction, Torque::NONE)?;
/// let trajectory = pendulum.trajectory(0.0, 20.0)?;
/// let stops: Vec<_> = trajectory.rests().iter().map(|(from, to)| format!("{from:.6} {to}")).collect();
/// assert_eq!(stops, ["6.432369 20"]);
/// # Ok::<(), libration::Domain>(())
/// ```
#[derive(Clone, Debug)]
pub struct Trajectory {
    pendulum: DampedPendulum,
    motion: Motion,
    interval: [f64; 2],
}

impl DampedPendulum {
    /// The motion from `start` <= 0 to `stop` >= 0, both in s; it may be evaluated there.
    ///
    /// Without friction and torque it is the exact [`Orbit`], bit for bit. Otherwise it is integrated by Taylor series of order
    /// 31 whose steps leave out less than 2^-70 of the motion, in at most [`MOST_SEGMENTS`](super::MOST_SEGMENTS) steps in each
    /// direction (some fifteen in a period). **Error** of angle and velocity at most 2 ulp of the largest up to the time, plus 2^-57
    /// of the condition: the sum over the state and the constants of |each times the derivative by it|.
    /// Source: Jorba & Zou, Exp. Math. 14 (2005) 99.
    ///
    /// # Errors
    /// Where the interval does not hold 0, is not finite, or leaves the samples of the torque; where the motion takes too many
    /// steps, or grows without bound because friction drives it; and for a `start` before 0 with presliding, whose earlier
    /// state no later one determines.
    pub fn trajectory(&self, start: f64, stop: f64) -> Result<Trajectory, Domain> {
        Domain::check("start", start, start.is_finite() && start <= 0.0, "finite and not above 0")?;
        Domain::check("stop", stop, stop.is_finite() && stop >= 0.0, "finite and not below 0")?;
        self.within_samples("start", start)?;
        self.within_samples("stop", stop)?;
        if self.remembers() {
            Domain::check("start", start, start == 0.0, "0 with presliding")?;
        }
        match self.over(start, stop, &|| false) {
            (trajectory, None) => Ok(trajectory),
            (_, Some(refused)) => Err(refused),
        }
    }

    /// The motion from `start` to `stop` as far as [`DampedPendulum::trajectory`] would follow it: over a shorter interval where it
    /// would give an error, and from or to 0 where they are on the wrong side of it, or no number.
    #[must_use]
    pub fn reachable(&self, start: f64, stop: f64) -> Trajectory {
        self.reachable_unless(start, stop, &|| false)
    }

    /// [`DampedPendulum::reachable`], where `ended` is asked now and then: once it is true, the trajectory is cut short and means
    /// nothing.
    #[must_use]
    pub fn reachable_unless(&self, start: f64, stop: f64, ended: &dyn Fn() -> bool) -> Trajectory {
        let [start, stop] = self.reached(start, stop);
        self.over(start, stop, ended).0
    }

    /// [`DampedPendulum::reachable_unless`], integrated also where the motion is exact, with the tolerance of the steps. With a loose one
    /// the **error** grows by at most 2^-44 of the motion in each step.
    #[must_use]
    pub fn integrated_unless(
        &self,
        start: f64,
        stop: f64,
        tolerance: Tolerance,
        ended: &dyn Fn() -> bool,
    ) -> Trajectory {
        let [start, stop] = self.reached(start, stop);
        self.integrated(start, stop, tolerance, ended).0
    }

    /// The interval that can be followed.
    fn reached(&self, start: f64, stop: f64) -> [f64; 2] {
        let (first, last) = match self.torque.samples.as_ref().filter(|_| TORQUES) {
            Some(samples) => (samples.times[0], samples.times[samples.times.len() - 1]),
            None => (f64::MIN, f64::MAX),
        };
        let first = if self.remembers() { 0.0 } else { first };
        // max and min take the other number where one is NaN.
        [start.min(0.0).max(first), stop.max(0.0).min(last)]
    }

    /// Whether an earlier state has to be known: that of presliding.
    fn remembers(&self) -> bool {
        self.friction.dry() != 0.0 && self.friction.presliding() != 0.0
    }

    fn over(&self, start: f64, stop: f64, ended: &dyn Fn() -> bool) -> (Trajectory, Option<Domain>) {
        let orbit = Orbit::new(self.theta0, self.velocity0, self.frequency);
        if let (true, Ok(orbit)) = (self.friction.is_none() && self.torque.is_none(), orbit) {
            let motion = Motion::Exact(Arc::new(orbit));
            return (Trajectory { pendulum: self.clone(), motion, interval: [start, stop] }, None);
        }
        self.integrated(start, stop, Tolerance::Tight, ended)
    }

    fn integrated(
        &self,
        start: f64,
        stop: f64,
        tolerance: Tolerance,
        ended: &dyn Fn() -> bool,
    ) -> (Trajectory, Option<Domain>) {
        let (branches, refused) = self.branches(start, stop, tolerance, ended);
        let interval = [start.max(branches[0].end()), stop.min(branches[1].end())];
        (
            Trajectory { pendulum: self.clone(), motion: Motion::Integrated(Arc::new(branches)), interval },
            refused,
        )
    }
}

impl Trajectory {
    /// The pendulum that moves.
    #[must_use]
    pub fn pendulum(&self) -> &DampedPendulum {
        &self.pendulum
    }
    /// Start and stop in s.
    #[must_use]
    pub fn interval(&self) -> (f64, f64) {
        (self.interval[0], self.interval[1])
    }
    /// How many steps the integration took: 0 for an exact motion.
    #[must_use]
    pub fn steps(&self) -> usize {
        match &self.motion {
            Motion::Exact(_) => 0,
            Motion::Integrated(branches) => branches.iter().map(|branch| branch.segments.len()).sum(),
        }
    }
    /// The integration in both senses of time, if there was one.
    pub(super) fn branches(&self) -> Option<&Arc<[Branch; 2]>> {
        match &self.motion {
            Motion::Exact(_) => None,
            Motion::Integrated(branches) => Some(branches),
        }
    }

    /// Whether t is in the interval.
    fn holds(&self, t: f64) -> bool {
        (self.interval[0]..=self.interval[1]).contains(&t)
    }

    /// Angle at t (in s), continuous through turns: NaN outside of the interval. **Error** as for
    /// [`DampedPendulum::trajectory`].
    #[must_use]
    pub fn theta(&self, t: f64) -> f64 {
        self.motion(t).0
    }
    /// Angular velocity at t; domain and error as for [`Trajectory::theta`].
    #[must_use]
    pub fn velocity(&self, t: f64) -> f64 {
        self.motion(t).1
    }
    /// Angle and angular velocity at t, bit for bit those of [`Trajectory::theta`] and [`Trajectory::velocity`].
    #[must_use]
    pub fn motion(&self, t: f64) -> (f64, f64) {
        self.motion_near(t, &mut [0; 2])
    }

    /// [`Trajectory::motion`]; `near` are the segments of both senses of time that were asked for last.
    fn motion_near(&self, t: f64, near: &mut [usize; 2]) -> (f64, f64) {
        if !self.holds(t) {
            return (f64::NAN, f64::NAN);
        }
        if t == 0.0 {
            return (self.pendulum.theta0, self.pendulum.velocity0);
        }
        match &self.motion {
            Motion::Exact(exact) => exact.at(t),
            Motion::Integrated(branches) => {
                let side = usize::from(t > 0.0);
                branches[side].at(t, &mut near[side])
            }
        }
    }
    /// [`Trajectory::motion`] of every time, bit for bit; panics where the lengths differ.
    pub fn motion_into(&self, t: &[f64], theta: &mut [f64], velocity: &mut [f64]) {
        assert!(t.len() == theta.len() && t.len() == velocity.len(), "columns of different lengths");
        if let Motion::Exact(exact) = &self.motion {
            exact.at_into(t, theta, velocity);
            for (row, t) in t.iter().enumerate() {
                if !self.holds(*t) {
                    (theta[row], velocity[row]) = (f64::NAN, f64::NAN);
                }
            }
            return;
        }
        let mut near = [0; 2];
        let mut row = 0;
        while row < t.len() {
            row += match &self.motion {
                Motion::Integrated(branches) if self.holds(t[row]) && t[row] != 0.0 => {
                    let side = usize::from(t[row] > 0.0);
                    let here = |t: f64| self.holds(t) && t != 0.0 && usize::from(t > 0.0) == side;
                    branches[side].run(
                        &t[row..],
                        here,
                        &mut near[side],
                        &mut theta[row..],
                        &mut velocity[row..],
                    )
                }
                _ => {
                    (theta[row], velocity[row]) = self.motion_near(t[row], &mut near);
                    1
                }
            };
        }
    }

    /// The angle at t as whole turns and a rest in [-pi, pi); NaN outside of the interval.
    #[must_use]
    pub fn turns(&self, t: f64) -> Turns {
        let branches = match &self.motion {
            _ if !self.holds(t) => return Turns { count: 0, angle: f64::NAN },
            Motion::Exact(exact) => return exact.orbit().turns(t),
            Motion::Integrated(branches) => branches,
        };
        let branch = &branches[usize::from(t >= 0.0)];
        let time = branch.equation.time(t);
        let segment = branch.segment(time);
        let theta = segment.theta + Dd::from(segment.change(since(segment, time)).0);
        let count = (theta.hi / TWO_PI.hi).round();
        let rest = theta - TWO_PI * count;
        let (shift, angle) = half_open(rest);
        if count.abs() < 9e18 {
            Turns { count: count as i64 + shift, angle }
        } else {
            Turns { count: 0, angle: f64::NAN }
        }
    }

    /// Energy per unit inertia at t, velocity^2/2 + omega0^2 (1 - cos theta): 0 at rest in the stable equilibrium, NaN outside of
    /// the interval. **Error** what that of angle and velocity makes of it.
    #[must_use]
    pub fn energy(&self, t: f64) -> f64 {
        let (theta, velocity) = self.motion(t);
        let omega2 = self.pendulum.frequency.omega2();
        // 1 - cos = 2 sin^2 of half the angle; from the other equilibrium 1 + cos = 2 cos^2.
        let (sine, cosine) = of_double(0.5 * theta);
        let distance = if omega2 < 0.0 { cosine } else { sine };
        0.5 * velocity * velocity + 2.0 * omega2.abs() * distance.square().value()
    }

    /// All times from `start` to `stop` (in s, both included) at which the angle is `theta`, rising; a pendulum that rests there
    /// passes it once. **Error** what that of the angle makes of it.
    ///
    /// # Errors
    /// Where `theta` is not finite, and where start and stop do not lie in the interval in this order.
    pub fn times(&self, theta: f64, start: f64, stop: f64) -> Result<Vec<f64>, Domain> {
        Domain::check("theta", theta, theta.is_finite(), "finite")?;
        self.check_interval(start, stop)?;
        match &self.motion {
            Motion::Exact(exact) => exact.orbit().times(theta, start, stop),
            Motion::Integrated(branches) => {
                Ok(collected(branches, start, stop, |_, segment, next| segment.passage(next, theta)))
            }
        }
    }

    /// All times from `start` to `stop` (in s, both included) at which the velocity changes its sign, and t = 0 where the motion
    /// starts from rest; not those at which dry friction stops it. **Error** and errors as for [`Trajectory::times`].
    ///
    /// # Errors
    /// As for [`Trajectory::times`].
    pub fn turning_times(&self, start: f64, stop: f64) -> Result<Vec<f64>, Domain> {
        self.check_interval(start, stop)?;
        match &self.motion {
            Motion::Exact(exact) => exact.orbit().turning_times(start, stop),
            Motion::Integrated(branches) => Ok(collected(branches, start, stop, |first, segment, _| {
                let turns = match segment.event {
                    Event::Turn => true,
                    Event::Start | Event::Release => first && segment.slopes[0] == 0.0 && segment.moves(),
                    Event::Step | Event::Stop => false,
                };
                turns.then_some(0.0)
            })),
        }
    }

    /// The intervals, in s, over which dry friction holds the pendulum.
    #[must_use]
    pub fn rests(&self) -> Vec<(f64, f64)> {
        let Motion::Integrated(branches) = &self.motion else { return Vec::new() };
        let mut rests: Vec<(f64, f64)> = Vec::new();
        for Branch { equation, segments } in branches.iter() {
            for segment in segments.iter().filter(|segment| segment.side == 0.0 && segment.length > 0.0) {
                let ends = [segment.start.value(), (segment.start + Dd::from(segment.length)).value()];
                // Not `clamp`, whose panic would bring Rust's digits into a page.
                let [first, last] = self.interval;
                let [a, b] = ends.map(|time| equation.seconds(time).max(first).min(last));
                rests.push((a.min(b), a.max(b)));
            }
        }
        rests.retain(|(from, to)| from < to);
        sort(&mut rests, |a, b| a.0.total_cmp(&b.0));
        // Pieces that touch are one rest.
        let mut joined: Vec<(f64, f64)> = Vec::new();
        for rest in rests {
            match joined.last_mut() {
                Some(last) if last.1 >= rest.0 => last.1 = rest.1,
                _ => joined.push(rest),
            }
        }
        joined
    }

    /// [`Trajectory::rests`] between two times, cut there.
    #[must_use]
    pub fn rests_within(&self, start: f64, stop: f64) -> Vec<(f64, f64)> {
        let inside = |(from, to): (f64, f64)| (from.max(start), to.min(stop));
        self.rests().into_iter().map(inside).filter(|(from, to)| from < to).collect()
    }

    /// Logarithmic decrements ln(theta_n/theta_(n+2)) of the turning angles on one side, one period apart, with the time of the
    /// second; NaN where the angles differ in sign or vanish.
    ///
    /// # Errors
    /// As for [`Trajectory::times`].
    pub fn decrements(&self, start: f64, stop: f64) -> Result<Vec<(f64, f64)>, Domain> {
        let turning: Vec<(f64, f64)> =
            self.turning_times(start, stop)?.into_iter().map(|t| (t, self.theta(t))).collect();
        let ratio = |a: f64, b: f64| if a / b > 0.0 { Dd::ln(a / b).value() } else { f64::NAN };
        Ok(turning.windows(3).map(|three| (three[2].0, ratio(three[0].1, three[2].1))).collect())
    }

    fn check_interval(&self, start: f64, stop: f64) -> Result<(), Domain> {
        for (name, t) in [("start", start), ("stop", stop)] {
            if !self.holds(t) {
                let [first, last] = self.interval.map(shown);
                let allowed = format!("in the interval of the trajectory, {first} to {last}");
                return Err(Domain::new(name, shown(t), allowed));
            }
        }
        if stop < start {
            return Err(Domain::new("stop", shown(stop), format!("not before start, {}", shown(start))));
        }
        Ok(())
    }
}

/// The times in an interval that each segment gives, since its start, rising.
fn collected(
    branches: &[Branch; 2],
    start: f64,
    stop: f64,
    of: impl Fn(bool, &Segment, Option<&Segment>) -> Option<f64>,
) -> Vec<f64> {
    let mut times = Vec::new();
    for Branch { equation, segments } in branches {
        for (i, segment) in segments.iter().enumerate() {
            if let Some(since) = of(i == 0, segment, segments.get(i + 1)) {
                let t = equation.seconds((segment.start + Dd::from(since)).value());
                if (start..=stop).contains(&t) {
                    times.push(t);
                }
            }
        }
    }
    sort_numbers(&mut times);
    // The start belongs to both senses of time.
    times.dedup();
    times
}

//! The integration of one pendulum in one sense of time from t = 0.

use super::damped_pendulum::DampedPendulum;
use super::equation::Equation;
use super::integrator::{MOST_SEGMENTS, integrate};
use super::segment::{Segment, Tolerance};
use crate::domain::Domain;
use crate::float::Dd;
use crate::float::exponent::ldexp;

/// One sense of time from t = 0.
#[derive(Clone, Debug)]
pub(super) struct Branch {
    pub equation: Equation,
    pub segments: Vec<Segment>,
}

impl Branch {
    /// Where the integration ends, in s.
    pub fn end(&self) -> f64 {
        let reached = |last: &Segment| (last.start + Dd::from(last.length)).value();
        self.equation.seconds(self.segments.last().map_or(0.0, reached))
    }

    /// The segment that holds a time of the branch.
    pub fn segment(&self, time: f64) -> &Segment {
        &self.segments[self.index(time)]
    }
    /// Its number.
    pub fn index(&self, time: f64) -> usize {
        let begun = |segment: &Segment| since(segment, time) >= 0.0;
        self.segments.partition_point(begun).max(1) - 1
    }

    /// The same, tried near a number first: times often rise.
    pub fn index_near(&self, time: f64, near: usize) -> usize {
        let begun = |i: usize| self.segments.get(i).map(|segment| since(segment, time) >= 0.0);
        let holds = |i: &usize| begun(*i) == Some(true) && begun(i + 1) != Some(true);
        [near, near + 1].into_iter().find(holds).unwrap_or_else(|| self.index(time))
    }

    /// Angle and velocity at t in s; `near` is the number of the segment that was asked for last.
    pub fn at(&self, t: f64, near: &mut usize) -> (f64, f64) {
        let time = self.equation.time(t);
        *near = self.index_near(time, *near);
        let segment = &self.segments[*near];
        let (theta, velocity) = segment.at(since(segment, time));
        (theta, self.equation.sense * ldexp(velocity, self.equation.power))
    }
}

/// The most times that are taken together.
const RUN: usize = 64;

impl Branch {
    /// Angle and velocity at the first of some times and at those after it that are `here` and in the same segment, bit for bit those
    /// of [`Branch::at`]; how many these are.
    pub fn run(
        &self,
        t: &[f64],
        here: impl Fn(f64) -> bool,
        near: &mut usize,
        theta: &mut [f64],
        velocity: &mut [f64],
    ) -> usize {
        let mut place = [0.0; RUN];
        let first = self.equation.time(t[0]);
        *near = self.index_near(first, *near);
        let segment = &self.segments[*near];
        let next = self.segments.get(*near + 1);
        let mut rows = 0;
        for t in t.iter().take(RUN) {
            let time = self.equation.time(*t);
            let since_start = since(segment, time);
            let inside = since_start >= 0.0 && next.is_none_or(|next| since(next, time) < 0.0);
            if rows > 0 && !(inside && here(*t)) {
                break;
            }
            place[rows] = since_start;
            rows += 1;
        }
        segment.at_into(&place[..rows], &mut theta[..rows], &mut velocity[..rows]);
        for velocity in &mut velocity[..rows] {
            *velocity = self.equation.sense * ldexp(*velocity, self.equation.power);
        }
        rows
    }
}

/// Time since the start of a segment.
pub(super) fn since(segment: &Segment, time: f64) -> f64 {
    (time - segment.start.hi) - segment.start.lo
}

impl DampedPendulum {
    /// The integration in both senses of time, and why one does not reach its end, if so.
    pub(super) fn branches(
        &self,
        start: f64,
        stop: f64,
        tolerance: Tolerance,
        ended: &dyn Fn() -> bool,
    ) -> ([Branch; 2], Option<Domain>) {
        let branch = |sense: f64, end: f64| {
            let equation = Equation::new(self.velocity0, self.frequency, self.friction, &self.torque, sense);
            let most = if sense < 0.0 && end == 0.0 { 0 } else { MOST_SEGMENTS };
            let time = equation.time(end);
            let (segments, refused) =
                integrate(&equation, self.theta0, self.velocity0, time, most, tolerance, ended);
            (Branch { equation, segments }, refused.filter(|_| most > 0))
        };
        let ((backward, early), (forward, late)) = (branch(-1.0, start), branch(1.0, stop));
        ([backward, forward], early.or(late))
    }
}

//! The integration of one pendulum in one sense of time from t = 0.

use super::damped_pendulum::DampedPendulum;
use super::equation::Equation;
use super::integrator::{MOST_SEGMENTS, integrate};
use super::segment::Segment;
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

    /// Angle and velocity at t in s.
    pub fn at(&self, t: f64) -> (f64, f64) {
        let time = self.equation.time(t);
        let segment = self.segment(time);
        let (theta, velocity) = segment.at(since(segment, time));
        (theta, self.equation.sense * ldexp(velocity, self.equation.power))
    }
}

/// Time since the start of a segment.
pub(super) fn since(segment: &Segment, time: f64) -> f64 {
    (time - segment.start.hi) - segment.start.lo
}

impl DampedPendulum {
    /// The integration in both senses of time, and why one does not reach its end, if so.
    pub(super) fn branches(&self, start: f64, stop: f64) -> ([Branch; 2], Option<Domain>) {
        let branch = |sense: f64, end: f64| {
            let equation = Equation::new(self.velocity0, self.frequency, self.friction, &self.torque, sense);
            let most = if sense < 0.0 && end == 0.0 { 0 } else { MOST_SEGMENTS };
            let time = equation.time(end);
            let (segments, refused) = integrate(&equation, self.theta0, self.velocity0, time, most);
            (Branch { equation, segments }, refused.filter(|_| most > 0))
        };
        let ((backward, early), (forward, late)) = (branch(-1.0, start), branch(1.0, stop));
        ([backward, forward], early.or(late))
    }
}

//! The motion as segments: steps of the Taylor series, cut where the velocity vanishes, where samples of the torque begin a new
//! polynomial, and where dry friction takes hold or lets go.
//!
//! State, time and the angle are double-doubles; sine and cosine are carried as variables of their own and put back on the
//! circle after every step. With dry friction, at a turn with the pull r = torque - omega2 s the pendulum stays where
//! |r| <= dry, until the torque has changed so that |r| > dry; otherwise it turns back.

use super::circular::of_double;
use super::equation::Equation;
use super::jet::{COSINE, Jet, SINE, SLIP, VELOCITY};
use super::jet_sum::Ahead;
use super::roots::{first_root, value_and_slope};
use super::segment::{Event, Segment, Start, Tolerance, step_length};
use super::taylor::ORDER;
use super::torque::TORQUES;
use super::torque_jet::{TorqueJet, rotated};
use crate::domain::{Domain, shown};
use crate::float::Dd;

/// The largest number of segments of a motion: each takes a third of a kB.
pub const MOST_SEGMENTS: usize = 1_000_000;

/// Segments between two questions to the caller.
pub const ASKED_EVERY: usize = 512;

/// Presliding has settled where what it leaves out of dry friction changes the velocity by less than a step may.
const SETTLED: f64 = 1.0 / (1u128 << 68) as f64;

struct State {
    time: Dd,
    theta: Dd,
    /// s, c, u, v.
    values: [Dd; 4],
    /// Sine and cosine of the phase of the torque.
    sinusoid: [Dd; 2],
    side: f64,
    event: Event,
    /// The sign of the velocity is known although the velocity is 0.
    decided: bool,
    /// Released by a torque that grew: the acceleration is 0.
    at_limit: bool,
    tolerance: Tolerance,
}

/// Segments from time 0 until they go beyond `stop`, at most `most`, and why they do not, if so. Times are in the unit and the
/// sense of the equation. `ended` is asked now and then: once it is true, the segments are too few and mean nothing.
///
/// The last segment is as long as the others, so that segments up to a later stop begin with these.
pub(super) fn integrate(
    equation: &Equation,
    theta0: f64,
    velocity0: f64,
    stop: f64,
    most: usize,
    tolerance: Tolerance,
    ended: &dyn Fn() -> bool,
) -> (Vec<Segment>, Option<Domain>) {
    let mut state = State::new(equation, theta0, velocity0, tolerance);
    let mut segments = Vec::new();
    let mut torque = equation.torque(state.time, state.sinusoid);
    let mut jet = Jet::ZERO;
    while segments.is_empty() || state.time.value() <= stop {
        if segments.len() == most {
            let reached = shown(equation.seconds(state.time.value()));
            let allowed = format!("within {most} steps of the integration, which end at {reached} s");
            return (segments, Some(refused(equation, stop, allowed)));
        }
        if segments.len() % ASKED_EVERY == ASKED_EVERY - 1 && ended() {
            break;
        }
        let knot = equation.next_knot(state.time);
        let (segment, slopes) = if state.side == 0.0 {
            (state.hold(equation, knot, stop), &[0.0; ORDER + 1])
        } else {
            (state.step(equation, knot, stop, &mut torque, &mut jet), &jet.slopes)
        };
        // A release at once leaves no segment behind.
        if segment.side == 0.0 && segment.length == 0.0 && state.side != 0.0 {
            continue;
        }
        // At the stop itself: a series that has no end, or the last of the samples.
        if segment.length == 0.0 && segment.start.value() == stop && !segments.is_empty() {
            break;
        }
        if !(segment.length > 0.0 || stop == 0.0) || !slopes[ORDER].is_finite() {
            let order = if equation.sense > 0.0 { "before" } else { "after" };
            let reached = shown(equation.seconds(segment.start.value()));
            let allowed = format!("{order} {reached} s, where the motion grows without bound");
            if segments.is_empty() {
                // The start is known.
                segments.push(Start { length: 0.0, ..segment }.with(&[0.0; ORDER + 1]));
            }
            return (segments, Some(refused(equation, stop, allowed)));
        }
        segments.push(segment.with(slopes));
    }
    (segments, None)
}

/// The error of the end of an interval.
fn refused(equation: &Equation, end: f64, allowed: String) -> Domain {
    let argument = if equation.sense > 0.0 { "stop" } else { "start" };
    Domain::new(argument, shown(equation.seconds(end)), allowed)
}

impl State {
    fn new(equation: &Equation, theta0: f64, velocity0: f64, tolerance: Tolerance) -> State {
        let (sine, cosine) = of_double(theta0);
        let velocity = equation.sense * crate::float::exponent::ldexp(velocity0, -equation.power);
        let slip = if equation.presliding > 0.0 && velocity == 0.0 { 1.0 } else { 0.0 };
        let (torque_sine, torque_cosine) = equation.sinusoid(Dd::ZERO);
        let mut state = State {
            time: Dd::ZERO,
            theta: Dd::from(theta0),
            values: [sine, cosine, Dd::from(slip), Dd::from(velocity)],
            sinusoid: [torque_sine, torque_cosine],
            side: if velocity < 0.0 { -1.0 } else { 1.0 },
            event: Event::Start,
            decided: velocity != 0.0,
            at_limit: false,
            tolerance,
        };
        if velocity == 0.0 && state.held(equation) {
            state.side = 0.0;
        }
        state
    }

    /// The time left until `end`.
    fn until(&self, end: f64) -> f64 {
        if end.is_finite() { (Dd::from(end) - self.time).value() } else { f64::INFINITY }
    }

    /// Whether dry friction holds the pendulum that is at rest.
    fn held(&self, equation: &Equation) -> bool {
        let dry = equation.dry.abs();
        dry > 0.0
            && equation.presliding == 0.0
            && (equation.pull(self.time, self.sinusoid, self.values[SINE]).abs() - Dd::from(dry)).hi <= 0.0
    }

    /// A segment from here, without its length.
    fn segment(&self) -> Start {
        Start {
            start: self.time,
            length: 0.0,
            theta: self.theta,
            event: self.event,
            side: self.side,
            sine: self.values[SINE].value(),
            cosine: self.values[COSINE].value(),
            slip: self.values[SLIP].value(),
        }
    }

    /// The coefficients ahead, after the sign of the velocity is settled where it is 0; and how long they serve.
    fn fill(&mut self, equation: &Equation, torque: &TorqueJet, jet: &mut Jet) -> f64 {
        let settled = equation.presliding == 0.0 || self.values[SLIP].hi == 0.0;
        loop {
            let piece = equation.piece_of(self.side, settled);
            jet.fill(&self.values, &piece, torque, self.at_limit);
            if self.decided {
                return step_length(jet, &piece, self.tolerance).min(equation.longest());
            }
            // The first coefficient that does not vanish is the same for both signs, but for dry friction, which is smaller
            // than the pull where it does not hold.
            let first = jet.velocity.iter().find(|v| **v != 0.0);
            self.side = if first.is_some_and(|v| *v < 0.0) { -1.0 } else { 1.0 };
            self.decided = true;
        }
    }

    /// The phase of the torque a time later.
    fn turn_phase(&mut self, equation: &Equation, passed: Dd) {
        if TORQUES && equation.amplitude != 0.0 {
            let [sine, cosine] = self.sinusoid;
            self.sinusoid = rotated(sine, cosine, passed * equation.frequency).into();
        }
    }

    /// A step of the series, as far as it converges, but not beyond a knot of the torque; a series that ends serves until `stop`.
    #[inline(always)]
    fn step(
        &mut self,
        equation: &Equation,
        knot: f64,
        stop: f64,
        torque: &mut TorqueJet,
        jet: &mut Jet,
    ) -> Start {
        if equation.varies() {
            *torque = equation.torque(self.time, self.sinusoid);
        }
        let converged = self.fill(equation, torque, jet);
        let mut segment = self.segment();
        let velocity = &jet.velocity;
        let end = if converged.is_finite() { knot } else { knot.min(stop) };
        let left = self.until(end);
        let last = converged >= left;
        let length = if last { left } else { converged };
        let slips = self.values[SLIP].hi != 0.0;
        let mut all = jet.at(length, slips);
        let root = if jet.keeps_side(length, &all) { None } else { first_root(velocity, length) };
        if let Some(root) = root {
            all = jet.at(root, slips);
        }
        let mut passed = root.unwrap_or(length);
        let mut exactly = Dd::from(passed);
        let Ahead { values: mut ahead, change, .. } = all;
        let turns = root.is_some() || ahead[VELOCITY].hi * self.side < 0.0;
        if turns {
            // What the root in double misses; the angle changes only by its square.
            let rest = -ahead[VELOCITY].hi / value_and_slope(velocity, passed).1;
            if rest.abs() < 1e-9 * passed {
                exactly = Dd::sum(passed, rest);
                passed = exactly.value();
            }
            ahead[VELOCITY] = Dd::ZERO;
        }
        segment.length = passed;
        self.turn_phase(equation, exactly);
        let moving = ahead[VELOCITY].hi != 0.0;
        let [sine, cosine, slip, v] = ahead;
        let speed = v.hi.abs().max(velocity[0].abs()).max(velocity[1].abs());
        let settled = slip.hi.abs() * equation.dry.abs() <= SETTLED * speed;
        let slip = if settled { Dd::ZERO } else { slip };
        *self = State {
            time: if last && !turns { Dd::from(end) } else { self.time + exactly },
            theta: self.theta + change,
            values: [sine, cosine, slip, v],
            sinusoid: self.sinusoid,
            side: self.side,
            event: Event::Step,
            // At rest without a torque the sign is asked for again.
            decided: moving || turns,
            at_limit: false,
            tolerance: self.tolerance,
        };
        if turns {
            if self.held(equation) {
                (self.side, self.event) = (0.0, Event::Stop);
            } else {
                (self.side, self.event) = (-self.side, Event::Turn);
                if equation.presliding > 0.0 {
                    self.values[SLIP] = Dd::from(2.0) - slip;
                }
            }
        }
        segment
    }

    /// Rest under dry friction until the pull exceeds it, but not beyond a knot of the torque; under a constant torque until `stop`.
    fn hold(&mut self, equation: &Equation, knot: f64, stop: f64) -> Start {
        let mut segment = self.segment();
        let torque = equation.torque(self.time, self.sinusoid);
        // The series of the sinusoid serves one radian: 1/30! is 2^-107.
        let served = 0.5 * equation.longest();
        let end = if served.is_finite() { knot } else { knot.min(stop) };
        let left = self.until(end);
        let last = served >= left;
        let length = if last { left } else { served };
        let pull = equation.pull(self.time, self.sinusoid, self.values[SINE]);
        let mut released: Option<(f64, f64, f64)> = None;
        for side in [1.0, -1.0] {
            let mut margin = [0.0; ORDER + 1];
            for (margin, torque) in margin[1..].iter_mut().zip(&torque.hi[1..]) {
                *margin = -side * torque;
            }
            margin[0] = (Dd::from(equation.dry.abs()) - pull * side).value();
            let first = margin.iter().find(|c| **c != 0.0);
            let at = match first {
                Some(c) if *c < 0.0 => Some(0.0),
                _ => first_root(&margin, length),
            };
            if let Some(at) = at.filter(|at| released.is_none_or(|(before, ..)| *at < before)) {
                released = Some((at, side, margin[0].abs()));
            }
        }
        self.event = Event::Step;
        if let Some((at, side, margin)) = released {
            segment.length = at;
            self.turn_phase(equation, Dd::from(at));
            self.time = self.time + Dd::from(at);
            (self.side, self.event, self.decided) = (side, Event::Release, true);
            // A torque that jumps starts the motion with an acceleration, one that grows does not.
            self.at_limit = at > 0.0 || margin <= 1e-18 * equation.dry.abs();
        } else {
            segment.length = length;
            self.turn_phase(equation, Dd::from(length));
            self.time = if last { Dd::from(end) } else { self.time + Dd::from(length) };
        }
        segment
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Friction, Torque};
    use super::*;
    use crate::pendulum::Frequency;

    #[test]
    fn too_many_steps_are_refused() {
        let friction = Friction::new(0.01, 0.0, 0.0, 0.0).unwrap();
        let force = Frequency::from_omega0(1.0).unwrap();
        for (sense, argument, stop) in [(1.0, "stop", "100.0"), (-1.0, "start", "-100.0")] {
            let equation = Equation::new(0.0, force, friction, &Torque::NONE, sense);
            let (some, refused) = integrate(&equation, 1.0, 0.0, 100.0, 10, Tolerance::Tight, &|| false);
            let refused = refused.unwrap();
            assert_eq!(some.len(), 10);
            assert_eq!((refused.argument, refused.given.as_str()), (argument, stop));
            let start = "within 10 steps of the integration, which end at ";
            assert!(refused.allowed.starts_with(start), "{}", refused.allowed);
            let (all, refused) = integrate(&equation, 1.0, 0.0, 100.0, 1000, Tolerance::Tight, &|| false);
            assert!(refused.is_none() && all.len() > some.len());
            // Segments do not depend on where they stop.
            let (fewer, _) = integrate(&equation, 1.0, 0.0, 37.3, 1000, Tolerance::Tight, &|| false);
            for (a, b) in all.iter().zip(&fewer) {
                assert_eq!((a.start, a.length, a.theta, a.slopes), (b.start, b.length, b.theta, b.slopes));
            }
        }
    }
}

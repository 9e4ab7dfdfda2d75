//! A piece of the motion on which the angle is one polynomial of time and the velocity has one sign, and the length that the
//! polynomial may have.

use super::jet::{COSINE, Jet, Piece, SINE, SLIP, VELOCITY};
use super::roots::{bracketed, value_and_slope};
use super::taylor::{ORDER, Series};
use crate::float::Dd;

/// How a segment begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Event {
    /// The start of the motion.
    Start,
    /// Only the polynomial changes.
    Step,
    /// The velocity changes its sign.
    Turn,
    /// Dry friction holds the pendulum.
    Stop,
    /// It holds it no longer.
    Release,
}

/// Angle and velocity from a time on, in the unit of time of the equation.
#[derive(Clone, Debug)]
pub(super) struct Segment {
    pub start: Dd,
    pub length: f64,
    pub theta: Dd,
    /// Coefficients of the powers 1, 2, ... of time in the angle.
    pub slopes: Series,
    pub event: Event,
    /// Sign of the velocity; 0 where dry friction holds.
    pub side: f64,
    pub sine: f64,
    pub cosine: f64,
    /// What presliding leaves out of dry friction at the start.
    pub slip: f64,
}

impl Segment {
    /// Angle and velocity a time since the start.
    pub fn at(&self, since: f64) -> (f64, f64) {
        let (change, velocity) = self.change(since);
        (self.theta.hi + (self.theta.lo + change), velocity)
    }

    /// The change of the angle, and the velocity.
    pub fn change(&self, since: f64) -> (f64, f64) {
        let (mut change, mut velocity) = (0.0, 0.0);
        for (k, c) in self.slopes.iter().enumerate().rev() {
            change = change * since + c;
            velocity = velocity * since + (k + 1) as f64 * c;
        }
        (change * since, velocity)
    }

    /// Whether it is not at rest.
    pub fn moves(&self) -> bool {
        self.slopes.iter().any(|slope| *slope != 0.0)
    }

    /// The time since the start at which the angle is `theta`: the start belongs to the segment, the end to the next one. Of a rest
    /// only its beginning counts.
    pub fn passage(&self, next: Option<&Segment>, theta: f64) -> Option<f64> {
        let from = (self.theta - Dd::from(theta)).value();
        if from == 0.0 {
            return (self.moves() || self.event != Event::Step).then_some(0.0);
        }
        let to = next
            .map_or_else(|| from + self.change(self.length).0, |next| (next.theta - Dd::from(theta)).value());
        if (to < 0.0) == (from < 0.0) || (to == 0.0 && next.is_some()) {
            return None;
        }
        let mut polynomial = [from; ORDER + 2];
        polynomial[1..].copy_from_slice(&self.slopes);
        Some(bracketed(&polynomial, self.length))
    }

    /// The acceleration a time since the start.
    pub fn acceleration(&self, since: f64) -> f64 {
        let mut velocity = [0.0; ORDER + 1];
        for (k, (v, c)) in velocity.iter_mut().zip(&self.slopes).enumerate() {
            *v = (k + 1) as f64 * c;
        }
        value_and_slope(&velocity, since).1
    }
}

/// What a step may leave out, of the size of each variable.
const TOLERANCE: f64 = 1.0 / (1u128 << 66) as f64;

/// Length of a step whose terms of the two highest orders are at most 2^-66 of each variable; infinite for a motion that is a
/// polynomial. The terms left out are 0.15 of that, since 2^(-66/24) = 0.15 is the ratio of one term to the next.
pub(super) fn step_length(jet: &Jet, piece: &Piece) -> f64 {
    let row = |k: usize, place: usize| jet.hi[place][k].abs();
    let mut speed = (0..4).map(|k| row(k, VELOCITY)).fold(0.0, f64::max);
    if speed == 0.0 {
        speed = (0..=ORDER).map(|k| row(k, VELOCITY)).fold(0.0, f64::max);
    }
    if speed == 0.0 {
        return f64::INFINITY;
    }
    if !jet.hi[VELOCITY][ORDER].is_finite() {
        return 0.0;
    }
    let circular = f64::min(1.0, f64::max(row(0, SINE), speed));
    let mut shortest = f64::INFINITY;
    for k in [ORDER - 1, ORDER] {
        let mut size = row(k, VELOCITY) / speed;
        if piece.omega2.hi != 0.0 {
            size = size.max(row(k, SINE) / circular).max(row(k, COSINE) / circular);
        }
        if piece.slip != 0.0 {
            size = size.max(row(k, SLIP) * piece.dry.abs() / speed);
        }
        if size != 0.0 {
            shortest = shortest.min(root(TOLERANCE / size, k));
        }
    }
    shortest
}

/// The k-th root to one percent: what the step needs.
fn root(value: f64, k: usize) -> f64 {
    if !(value.is_normal() && value > 0.0) {
        return if value == 0.0 { 0.0 } else { 1.0 };
    }
    let bits = value.to_bits();
    let whole = (bits >> 52) as f64 - 1023.0;
    let part = f64::from_bits(bits & ((1 << 52) - 1) | (1023 << 52)) - 1.0;
    // log2(1 + x) and 2^x on [0, 1] by parabolas.
    let logarithm = (whole + part * (1.35 - 0.35 * part)) / k as f64;
    let floor = logarithm.floor();
    let rest = logarithm - floor;
    (1.0 + rest * (0.66 + 0.34 * rest)) * crate::float::exponent::exp2(floor as i32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_good_enough() {
        for i in -300..300 {
            let value = 10f64.powi(i) * 1.7;
            let ratio = root(value, 24) / value.powf(1.0 / 24.0);
            assert!((ratio - 1.0).abs() < 0.01, "{value} {ratio}");
        }
    }
}

//! A piece of the motion on which the angle is one polynomial of time and the velocity has one sign, and the length that the
//! polynomial may have.

use super::jet::{Jet, Piece};
use super::roots::{bracketed, value_and_slope};
use super::taylor::{INVERSE, ORDER, Series};
use crate::float::{Dd, exponent};
use crate::lanes::{Columns, Evaluation, Formula, Lane, Once};

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

/// The change of the angle and the velocity, from the coefficients of the powers 1, 2, ... in the angle.
struct Polynomial<'a>(&'a Series);

impl Formula<1, 2> for Polynomial<'_> {
    type Place = Segment;
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        // Even and odd powers by themselves, so that the sums need not wait for each other.
        let square = t * t;
        let zero = L::splat(0.0);
        let (mut even, mut odd, mut even_slope, mut odd_slope) = (zero, zero, zero, zero);
        let mut k = ORDER + 1;
        while k > 0 {
            k -= 2;
            let [low, high] = [self.0[k], self.0[k + 1]];
            even = even.mul_add(square, L::splat(low));
            odd = odd.mul_add(square, L::splat(high));
            even_slope = even_slope.mul_add(square, L::splat((k + 1) as f64 * low));
            odd_slope = odd_slope.mul_add(square, L::splat((k + 2) as f64 * high));
        }
        [odd.mul_add(t, even) * t, odd_slope.mul_add(t, even_slope)]
    }
}

/// A segment without its polynomial.
pub(super) struct Start {
    pub start: Dd,
    pub length: f64,
    pub theta: Dd,
    pub event: Event,
    pub side: f64,
    pub sine: f64,
    pub cosine: f64,
    pub slip: f64,
}

impl Start {
    /// The segment with its polynomial.
    #[inline(always)]
    pub fn with(self, slopes: &Series) -> Segment {
        let Start { start, length, theta, event, side, sine, cosine, slip } = self;
        Segment { start, length, theta, slopes: *slopes, event, side, sine, cosine, slip }
    }
}

impl Segment {
    /// Angle and velocity a time since the start.
    pub fn at(&self, since: f64) -> (f64, f64) {
        let (change, velocity) = self.change(since);
        (self.theta.hi + (self.theta.lo + change), velocity)
    }

    /// The change of the angle, and the velocity.
    pub fn change(&self, since: f64) -> (f64, f64) {
        let [change, velocity] = Once([since]).of(&Polynomial(&self.slopes));
        (change, velocity)
    }

    /// Angle and velocity at every time since the start, bit for bit those of [`Segment::at`].
    pub fn at_into(&self, since: &[f64], theta: &mut [f64], velocity: &mut [f64]) {
        Columns::new([since], [&mut *theta, velocity]).of(&Polynomial(&self.slopes));
        for theta in theta {
            *theta = self.theta.hi + (self.theta.lo + *theta);
        }
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
        // Filled up with zeros to a multiple of four.
        let mut polynomial = [0.0; ORDER + 5];
        polynomial[0] = from;
        polynomial[1..ORDER + 2].copy_from_slice(&self.slopes);
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

/// What a step of the integration may leave out, of the size of each variable.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tolerance {
    /// 2^-70: values as [`DampedPendulum::trajectory`](super::DampedPendulum::trajectory) promises them.
    #[default]
    Tight,
    /// 2^-44, with steps 1.8 times as long: for searches, which a motion that is right to 1e-8 after a hundred swings
    /// leads as well.
    Loose,
}

impl Tolerance {
    /// As a power of two.
    fn power(self) -> f64 {
        match self {
            Tolerance::Tight => -70.0,
            Tolerance::Loose => -44.0,
        }
    }
}

/// Length of a step whose terms of the two highest orders are at most the tolerance of each variable; infinite for a motion that is a
/// polynomial. The terms left out are 0.27 of 2^-70, since 2^(-70/31) = 0.21 is the ratio of one term to the next, and 0.6 of 2^-44.
pub(super) fn step_length(jet: &Jet, piece: &Piece, tolerance: Tolerance) -> f64 {
    let larger = |a: f64, b: f64| if a > b { a } else { b };
    let largest = |all: &[f64]| all.iter().fold(0.0, |most: f64, v| larger(v.abs(), most));
    let mut speed = largest(&jet.velocity[..4]);
    if speed == 0.0 {
        speed = largest(&jet.velocity);
    }
    if speed == 0.0 {
        return f64::INFINITY;
    }
    if !jet.velocity[ORDER].is_finite() {
        return 0.0;
    }
    let inverse = 1.0 / speed;
    let sine = jet.sizes(0)[0];
    let circular = if sine < 1.0 && speed < 1.0 { 1.0 / larger(sine, speed) } else { 1.0 };
    let slips = piece.slip != 0.0;
    let mut power = f64::INFINITY;
    for k in [ORDER - 1, ORDER] {
        let [sine, cosine, velocity, slip] = jet.sizes(k);
        let mut size = larger(velocity * inverse, larger(sine, cosine) * circular);
        if slips {
            size = larger(size, slip * piece.dry.abs() * inverse);
        }
        if size != 0.0 {
            let allowed = (tolerance.power() - log2(size)) * INVERSE[k].hi;
            power = if allowed < power { allowed } else { power };
        }
    }
    if power == f64::INFINITY { power } else { exp2(power) }
}

/// The logarithm to base 2 of a positive number, to 0.01: what a step needs of it.
fn log2(value: f64) -> f64 {
    let bits = value.to_bits();
    let part = f64::from_bits(bits & ((1 << 52) - 1) | (1023 << 52)) - 1.0;
    // log2(1 + x) on [0, 1] by a parabola.
    (bits >> 52) as f64 - 1023.0 + part * (1.35 - 0.35 * part)
}

/// 2^value for -1000 < value < 1000, to 1 %; beyond, as there.
fn exp2(value: f64) -> f64 {
    let value = value.clamp(-1000.0, 1000.0);
    let whole = (value + 1024.0) as i32 - 1024;
    let rest = value - f64::from(whole);
    // 2^x on [0, 1] by a parabola.
    (1.0 + rest * (0.66 + 0.34 * rest)) * exponent::exp2(whole)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_good_enough() {
        for i in -300..300 {
            let value = 10f64.powi(i) * 1.7;
            let ratio = exp2(log2(value) / 24.0) / value.powf(1.0 / 24.0);
            assert!((ratio - 1.0).abs() < 0.015, "{value} {ratio}");
        }
    }
}

//! The Fourier series of the angle and of the sine of its half, cut after N terms; and the harmonic motion.
//!
//! With r = e^(-pi K'/2K), so that the nome is r^2, and the phase in half periods:
//!   theta         = sum a_j sin(j pi phase),  a_j = 8 r^j/(j (1 + r^2j)),           j odd,
//!   sin(theta/2)  = sum b_j sin(j pi phase),  b_j = (2 pi/K) r^j/(1 - r^2j),        j odd,
//!   rotation: theta = 2 pi phase + sum a_j sin(2 j pi phase),  a_j = 4 q^j/(j (1 + q^2j)).
//! What is left out is summed from its own terms, so that a difference from the exact angle keeps its digits however small.
//! Source: DLMF 22.11.1, 22.11.3 and their integrals; Lima 2019 (17), (20)-(22).

use super::angle_columns::{AngleBlock, BLOCK, Combination, SineSide, SineSum, Turns, TwiceAngle, ordinary};
use super::angle_phase::{framed, half_turn, turning_angle};
use crate::elliptic::phase::{LAST_HALF_PERIOD, ReducedPhase, alternating};
use crate::float::elementary::arctangent;
use crate::float::{Dd, HALF_PI, Scaled, TWO_PI};
use crate::pendulum::Orbit;
use crate::pendulum::orbit::Solution;
use crate::pendulum::state::State;
use crate::pendulum::theta_quotients::Elliptic;

/// Sine and cosine.
type Turn = (Dd, Dd);

/// The elliptic orbit, in libration or rotation, and the point of its phase: whole half periods, rest, sine and cosine.
struct PhasePoint<'a> {
    elliptic: &'a Elliptic,
    n: f64,
    f: Dd,
    turn: Turn,
}

impl PhasePoint<'_> {
    fn new(orbit: &Orbit, t: f64) -> Option<PhasePoint<'_>> {
        let (elliptic, turn) = match &orbit.solution {
            Solution::Libration(elliptic) => (elliptic, 1.0),
            Solution::Rotation(elliptic) => (elliptic, 2.0),
            _ => return None,
        };
        let (n, f) = elliptic.phase.count(t * orbit.time_scale, LAST_HALF_PERIOD / turn);
        if f.hi.is_nan() {
            return None;
        }
        let (sine, cosine) = half_turn(f);
        if turn == 1.0 {
            let side = alternating(n);
            return Some(PhasePoint { elliptic, n, f, turn: (sine.scale(side), cosine.scale(side)) });
        }
        // Twice the angle: (cosine - sine)(cosine + sine) keeps the digits of both.
        let doubled = (sine * cosine).scale(2.0);
        Some(PhasePoint { elliptic, n, f, turn: (doubled, (cosine - sine) * (cosine + sine)) })
    }

    /// cos(theta/2), never negative in libration.
    fn half_cosine(&self) -> Dd {
        let sign = 1f64.copysign(self.f.hi);
        let at = ReducedPhase { n: Dd::ZERO, sign, f: self.f.scale(sign), parity: alternating(self.n) };
        self.elliptic.lattice.long_values(&at)[2]
    }
}

/// Whether columns carry a factor of an orbit's series.
fn carries(orbit: &Orbit, factor: Scaled) -> bool {
    orbit.state.is_some_and(|state| state.power == 0) && ordinary(factor)
}

/// Sine and cosine of the phase of the first rows, and its angle in rotation.
fn turned(orbit: &Orbit, block: &mut AngleBlock, rows: usize) {
    let (elliptic, turning) = match &orbit.solution {
        Solution::Libration(elliptic) => (elliptic, false),
        Solution::Rotation(elliptic) => (elliptic, true),
        // A series has neither in other motions, and no columns.
        _ => return,
    };
    let end = if turning { 0.5 * LAST_HALF_PERIOD } else { LAST_HALF_PERIOD };
    block.angle = [[0.0; BLOCK]; 2];
    block.through(rows, &Turns { phase: elliptic.phase, time_scale: orbit.time_scale, end, turning });
}

/// scale times the sum of c_i sin(j_i phi) with j_i = first, first + step, ... and c_0 = 1.
#[derive(Clone, Debug)]
struct Sum {
    scale: Scaled,
    coefficients: Vec<Dd>,
    first: u32,
    step: u32,
}

/// Beside 1, no term counts from here on.
const NOTHING: f64 = 1e-33;
/// More terms no series has that doubles can ask for.
const MOST: usize = 20_000;

fn times((s, c): Turn, (sine, cosine): Turn) -> Turn {
    (s * cosine + c * sine, c * cosine - s * sine)
}

/// base^order, by squares.
fn raised<T: Copy>(one: T, base: T, order: u32, times: impl Fn(T, T) -> T) -> T {
    let (mut result, mut square, mut left) = (one, base, order);
    while left > 0 {
        if left & 1 == 1 {
            result = times(result, square);
        }
        square = times(square, square);
        left >>= 1;
    }
    result
}

/// A turn j times, j = `order`.
fn multiple(turn: Turn, order: u32) -> Turn {
    raised((Dd::ZERO, Dd::ONE), turn, order, times)
}

fn power(base: Scaled, order: u32) -> Scaled {
    raised(Scaled::ONE, base, order, |a, b| a * b)
}

impl Sum {
    /// The first terms of a series of positive terms that fall at least like `ratio`, or all from `first` on.
    fn new(first: u32, step: u32, count: usize, ratio: f64, term: impl Fn(u32) -> Scaled) -> Sum {
        let scale = term(first);
        let mut coefficients = Vec::new();
        if scale.is_zero() {
            return Sum { scale, coefficients, first, step };
        }
        let mut j = first;
        let inverse = Scaled::ONE / scale;
        while coefficients.len() < count.min(MOST) {
            let c = (term(j) * inverse).to_dd();
            // What follows is below c/(1 - ratio).
            if c.hi < NOTHING * (1.0 - ratio) {
                break;
            }
            coefficients.push(c);
            j += step;
        }
        Sum { scale, coefficients, first, step }
    }

    fn at(&self, turn: Turn) -> Scaled {
        let step = multiple(turn, self.step);
        let mut here = multiple(turn, self.first);
        let mut sum = Dd::ZERO;
        for c in &self.coefficients {
            sum = sum + *c * here.0;
            here = times(here, step);
        }
        Scaled::from(sum) * self.scale
    }

    /// Its pass over columns, from the first harmonic on.
    fn pass(&self) -> SineSum<'_> {
        SineSum { coefficients: &self.coefficients, scale: self.scale.to_dd(), odd: self.step == 2 }
    }
}

/// e^(-pi K'/2K) of a libration, and the nome of the inner parameter of a rotation; and the step of the harmonics.
fn decay(orbit: &Orbit) -> (Scaled, u32) {
    if let Some((decay, step)) = orbit.decay() {
        return (Scaled::exp(-decay), step);
    }
    match orbit.state {
        // The nome is m/16 to all digits.
        Some(State { k, power, .. }) if power != 0 => (Scaled::new(k, power - 2), 2),
        _ => (Scaled::ZERO, 2),
    }
}

/// a_j of the angle: 8 r^j/(j (1 + r^2j)) in libration, half of it in rotation.
fn angle_term(r: Scaled, step: u32, j: u32) -> Scaled {
    let r = power(r, j);
    let factor = if step == 2 { 8.0 } else { 4.0 };
    r * factor / ((Scaled::ONE + r.square()) * f64::from(j))
}

/// A series cut after N terms, and what is left out; as an approximation, that of theta itself.
#[derive(Clone, Debug)]
pub(super) struct Series {
    head: Sum,
    tail: Sum,
}

impl Series {
    /// The series of theta.
    pub fn new(orbit: &Orbit, order: u32) -> Series {
        let (r, step) = decay(orbit);
        let ratio = power(r, step).value();
        Series::cut(order, step, ratio, |j| angle_term(r, step, j))
    }

    fn cut(order: u32, step: u32, ratio: f64, term: impl Fn(u32) -> Scaled) -> Series {
        Series {
            head: Sum::new(1, step, order as usize, ratio, &term),
            tail: Sum::new(1 + step * order, step, MOST, ratio, &term),
        }
    }

    pub fn theta(&self, orbit: &Orbit, t: f64) -> f64 {
        let Some(point) = PhasePoint::new(orbit, t) else { return f64::NAN };
        let mut angle = self.head.at(point.turn);
        if matches!(orbit.solution, Solution::Rotation(_)) {
            angle = Scaled::from(TWO_PI * point.n + TWO_PI * point.f) + angle;
        }
        framed(&orbit.frame, angle)
    }

    pub fn in_columns(&self, orbit: &Orbit) -> bool {
        carries(orbit, self.head.scale)
    }

    pub fn columns(&self, orbit: &Orbit, block: &mut AngleBlock, rows: usize) {
        turned(orbit, block, rows);
        block.through(rows, &self.head.pass());
    }

    pub fn difference(&self, orbit: &Orbit, t: f64) -> f64 {
        let Some(point) = PhasePoint::new(orbit, t) else { return f64::NAN };
        -(self.tail.at(point.turn) * orbit.frame.side).value()
    }
}

/// theta_max sin(pi phase).
#[derive(Clone, Debug)]
pub(super) struct Harmonic {
    theta_max: Scaled,
    /// All harmonics but the first, and their sum where the phase is 1/2.
    tail: Sum,
    top: Scaled,
}

impl Harmonic {
    pub fn new(orbit: &Orbit) -> Harmonic {
        let tail = Series::new(orbit, 1).tail;
        let top = tail.at((Dd::ONE, Dd::ZERO));
        Harmonic { theta_max: turning_angle(orbit), tail, top }
    }

    pub fn theta(&self, orbit: &Orbit, t: f64) -> f64 {
        let Some(point) = PhasePoint::new(orbit, t) else { return f64::NAN };
        framed(&orbit.frame, self.theta_max * Scaled::from(point.turn.0))
    }

    pub fn in_columns(&self, orbit: &Orbit) -> bool {
        carries(orbit, self.theta_max)
    }

    pub fn columns(&self, orbit: &Orbit, block: &mut AngleBlock, rows: usize) {
        turned(orbit, block, rows);
        block.through(rows, &Combination { along: self.theta_max.to_dd(), across: Dd::ZERO });
    }

    /// theta_max is the sum of all harmonics where the phase is 1/2, the first among them.
    pub fn difference(&self, orbit: &Orbit, t: f64) -> f64 {
        let Some(point) = PhasePoint::new(orbit, t) else { return f64::NAN };
        let left = self.tail.at(point.turn);
        ((self.top * Scaled::from(point.turn.0) - left) * orbit.frame.side).value()
    }
}

/// 2 arcsin of the cut series of sin(theta/2).
#[derive(Clone, Debug)]
pub(super) struct Arcsine {
    sine: Series,
}

impl Arcsine {
    pub fn new(orbit: &Orbit, order: u32) -> Arcsine {
        let (r, step) = decay(orbit);
        let ratio = power(r, step).value();
        let quarter = match &orbit.solution {
            Solution::Libration(elliptic) => elliptic.lattice.quarter,
            _ => HALF_PI,
        };
        let factor = Scaled::from(TWO_PI / quarter);
        let term = |j| {
            let r = power(r, j);
            factor * r / (Scaled::ONE - r.square())
        };
        Arcsine { sine: Series::cut(order, step, ratio, term) }
    }

    /// 1 - |k sn_N|: below 0 the arcsine has no value.
    pub fn margin(&self, orbit: &Orbit, t: f64) -> f64 {
        let Some(point) = PhasePoint::new(orbit, t) else { return f64::NAN };
        (Scaled::ONE - self.sine.head.at(point.turn).abs()).value()
    }

    /// k sn_N and the cosine that belongs to it.
    fn side(&self, point: &PhasePoint) -> Option<(Scaled, Dd)> {
        let sine = self.sine.head.at(point.turn);
        let square = (Scaled::ONE - sine) * (Scaled::ONE + sine);
        if square.is_negative() { None } else { Some((sine, square.sqrt().to_dd())) }
    }

    pub fn theta(&self, orbit: &Orbit, t: f64) -> f64 {
        let Some(point) = PhasePoint::new(orbit, t) else { return f64::NAN };
        let Some((sine, cosine)) = self.side(&point) else { return f64::NAN };
        framed(&orbit.frame, multiple_of_angle(sine, cosine, 1))
    }

    pub fn in_columns(&self, orbit: &Orbit) -> bool {
        self.sine.in_columns(orbit)
    }

    pub fn columns(&self, orbit: &Orbit, block: &mut AngleBlock, rows: usize) {
        self.sine.columns(orbit, block, rows);
        block.through(rows, &SineSide);
        block.through(rows, &TwiceAngle);
    }

    /// tan of a quarter of the difference is (sin a - sin b)/(cos a + cos b) of the halves, and sin a - sin b is what the
    /// series leaves out.
    pub fn difference(&self, orbit: &Orbit, t: f64) -> f64 {
        let Some(point) = PhasePoint::new(orbit, t) else { return f64::NAN };
        let Some((_, cosine)) = self.side(&point) else { return f64::NAN };
        let left = self.sine.tail.at(point.turn);
        let tangent = left / Scaled::from(cosine + point.half_cosine());
        -(multiple_of_angle(tangent, Dd::ONE, 2) * orbit.frame.side).value()
    }
}

/// Below, an angle is its sine and its tangent to all digits.
const TINY: i32 = -300;

/// 2^power times the angle with this sine and this cosine >= 0, or of the point of this height over this width.
fn multiple_of_angle(sine: Scaled, cosine: Dd, power: i32) -> Scaled {
    if sine.is_zero() || sine.power() < TINY {
        return sine.shift(power);
    }
    Scaled::new(arctangent(sine.abs().to_dd(), cosine), power).signed(sine.sign())
}

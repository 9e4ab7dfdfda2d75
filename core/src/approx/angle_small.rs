//! The pendulum to first order in m: Salas's formula, whose error grows with the time, and one whose error does not.
//!
//! In units of omega0 = 1, with s, c = sin, cos(theta0/2) and x = velocity0/2, his formula is
//!   theta = 2 arctan{[n0 d0 + (m/4)(n1 d0 - n0 d1)]/d0^2},    y = u - sin u cos u,    u = omega0 t,
//!   n0 = s c cos u + x sin u,    n1 = s c y sin u - x (2 sin^3 u + y cos u),
//!   d0 = c^2 - x^2 sin^2 u,      d1 = 2 x^2 y sin u cos u.
//! The other one is tan(theta/2) = (s c cn + x dn sn)/(c^2 - x^2 sn^2) (Salas 23 times c^2) with the first harmonics of
//! sn, cn and dn at the exact phase. Source: Salas 2019, (23), (24) and before fig. 6; DLMF 22.10, 22.11.

use super::angle_columns::{AngleBlock, AngleRow, Pass, Turns, TwiceAngle, constant, double, ordinary};
use super::angle_phase::{counted, framed};
use crate::elliptic::phase::{LAST_HALF_PERIOD, Phase};
use crate::float::elementary::arctangent;
use crate::float::exponent::{exp2, ldexp};
use crate::float::unnormalised::Unnormalised;
use crate::float::{Dd, PI, Scaled};
use crate::lanes::Lane;
use crate::pendulum::Orbit;
use crate::pendulum::state::State;
use crate::pendulum::theta_quotients::Elliptic;

/// The start in units of omega0 = 1, with m itself.
fn start_of(orbit: &Orbit) -> Option<State> {
    orbit.state.map(|state| State { m: state.m.ldexp(2 * state.power), ..state })
}

/// The square of a velocity.
fn square_of(start: &State, x: Dd) -> Dd {
    if start.power == 0 { x.square() } else { Dd::ZERO }
}

/// Twice the angle of a point, in the frame of the orbit.
fn twice_angle(start: &State, opposite: Dd, adjacent: Dd) -> f64 {
    if opposite.hi.is_nan() || adjacent.hi.is_nan() || (opposite.hi == 0.0 && adjacent.hi == 0.0) {
        return f64::NAN;
    }
    let half = if start.power != 0 {
        Scaled::new(opposite / adjacent, start.power)
    } else {
        let size = arctangent(opposite.abs(), adjacent.abs());
        let size = if adjacent.hi < 0.0 { PI - size } else { size };
        Scaled::from(if opposite.hi < 0.0 { -size } else { size })
    };
    framed(&start.frame, half.shift(1))
}

/// To first order in m at a fixed time: the argument is omega0 t, and y grows with it.
#[derive(Clone, Debug)]
pub(super) struct Secular {
    start: State,
    phase: Phase,
    power: i32,
}

impl Secular {
    pub fn new(orbit: &Orbit) -> Option<Secular> {
        let (root, power) = orbit.force.root()?;
        let phase = Phase { rate: root.to_dd() / PI, start: Dd::ZERO };
        Some(Secular { start: start_of(orbit)?, phase, power })
    }

    pub fn theta(&self, t: f64) -> f64 {
        self.theta_and_stride(t).0
    }

    pub fn in_columns(&self) -> bool {
        self.start.power == 0 && ordinary(Scaled::new(Dd::ONE, self.power))
    }

    pub fn columns(&self, block: &mut AngleBlock, rows: usize) {
        let (phase, time_scale) = (self.phase, exp2(self.power));
        block.through(rows, &Turns { phase, time_scale, end: LAST_HALF_PERIOD, turning: false });
        block.through(rows, &SecularPoint { start: &self.start, rate: phase.rate * PI, time_scale });
        block.through(rows, &TwiceAngle);
    }

    /// The angle, and a time in s within which it changes by a part of a radian at most.
    ///
    /// tan of half the angle is the quotient of two functions, and by x the sum of their sizes falls by no more than x
    /// times the sum of the largest sizes of their derivatives. Near a turn, where the numerator crosses zero, the time is
    /// a part of that to the crossing, and in its middle a part of the width of the turn.
    pub fn theta_and_stride(&self, t: f64) -> (f64, f64) {
        let State { s, c, x, m, .. } = self.start;
        let passed = ldexp(t, self.power);
        let Some((sine, cosine)) = counted(&self.phase, passed) else { return (f64::NAN, f64::INFINITY) };
        let y = self.phase.rate * PI * passed - sine * cosine;
        let n0 = s * c * cosine + x * sine;
        let n1 = s * c * y * sine - x * (sine * sine.square() * 2.0 + y * cosine);
        let square = square_of(&self.start, x);
        let d0 = c.square() - square * sine.square();
        let d1 = (square * y * sine * cosine).scale(2.0);
        let (above, below) = (n0 * d0 + m.scale(0.25) * (n1 * d0 - n0 * d1), d0.square());
        let part = PART * (above.hi.abs() + below.hi) / self.steepest(y.hi.abs());
        let stride = ldexp(part / (self.phase.rate.hi * PI.hi), -self.power);
        (twice_angle(&self.start, above, below), if self.start.power == 0 { stride } else { f64::INFINITY })
    }

    /// A bound of the derivatives of numerator and denominator by u where |y| is this large, from |sin|, |cos| <= 1,
    /// |y'| <= 2: |n0|, |n0'| <= a = |s c| + |x|; d0 <= b = c^2 + x^2 and |d0'| <= x^2; |n1| <= a (|y| + 2) and
    /// |n1'| <= a (|y| + 8); |d1| <= x^2 |y| and |d1'| <= 2 x^2 (|y| + 1).
    fn steepest(&self, y: f64) -> f64 {
        let State { s, c, x, m, .. } = &self.start;
        let (a, square) = ((s.hi * c.hi).abs() + x.hi.abs(), x.hi * x.hi);
        let b = c.hi * c.hi + square;
        let first = 0.25 * m.hi * (b * (y + 8.0) + square * (4.0 * y + 4.0));
        a * (b + square + first) + 2.0 * b * square
    }
}

/// The point (n/d, 1) of [`Secular`], times d^2.
struct SecularPoint<'a> {
    start: &'a State,
    rate: Dd,
    time_scale: f64,
}

impl Pass for SecularPoint<'_> {
    #[inline(always)]
    fn at<L: Lane>(&self, row: AngleRow<L>) -> AngleRow<L> {
        let State { s, c, x, m, .. } = self.start;
        let (sine, cosine, x, across) = (row.opposite, row.adjacent, constant(*x), constant::<L>(*s * *c));
        let passed = Unnormalised::from_double(row.t * L::splat(self.time_scale));
        let mixed = sine * cosine;
        let y = constant(self.rate) * passed - mixed;
        let (sine_square, square) = (sine.square(), x.square());
        let n0 = across * cosine + x * sine;
        let n1 = across * y * sine - x * ((sine * sine_square).scale(L::splat(2.0)) + y * cosine);
        let d0 = constant(c.square()) - square * sine_square;
        let d1 = (square * y * mixed).scale(L::splat(2.0));
        let above = n0 * d0 + constant(m.scale(0.25)) * (n1 * d0 - n0 * d1);
        AngleRow { opposite: above, adjacent: d0.square(), ..row }
    }
}

/// Of the shortest time in which the quotient may change as much as it is.
const PART: f64 = 0.25;

/// To first order in m at a fixed phase.
#[derive(Clone, Debug)]
pub(super) struct Bounded {
    start: State,
    phase: Phase,
    time_scale: f64,
}

impl Bounded {
    pub fn new(orbit: &Orbit, elliptic: &Elliptic) -> Option<Bounded> {
        let phase = Phase { rate: elliptic.phase.rate, start: Dd::ZERO };
        Some(Bounded { start: start_of(orbit)?, phase, time_scale: orbit.time_scale })
    }

    pub fn theta(&self, t: f64) -> f64 {
        let State { s, c, x, m, .. } = self.start;
        let Some((sine, cosine)) = counted(&self.phase, t * self.time_scale) else { return f64::NAN };
        // sin 3z = sin z (3 - 4 sin^2 z), cos 3z = cos z (1 - 4 sin^2 z), 1 - cos 2z = 2 sin^2 z.
        let square = sine.square();
        let sixteenth = m.scale(0.0625);
        let sn = sine * (Dd::ONE + sixteenth * (Dd::from(4.0) - square.scale(4.0)));
        let cn = cosine * (Dd::ONE - (m * square).scale(0.25));
        let dn = Dd::ONE - (m * square).scale(0.5);
        let opposite = s * c * cn + x * dn * sn;
        twice_angle(&self.start, opposite, c.square() - square_of(&self.start, x) * sn.square())
    }
    pub fn in_columns(&self) -> bool {
        self.start.power == 0
    }

    pub fn columns(&self, block: &mut AngleBlock, rows: usize) {
        let (phase, time_scale) = (self.phase, self.time_scale);
        block.through(rows, &Turns { phase, time_scale, end: LAST_HALF_PERIOD, turning: false });
        block.through(rows, &BoundedPoint(&self.start));
        block.through(rows, &TwiceAngle);
    }
}

/// The point of [`Bounded`].
struct BoundedPoint<'a>(&'a State);

impl Pass for BoundedPoint<'_> {
    #[inline(always)]
    fn at<L: Lane>(&self, row: AngleRow<L>) -> AngleRow<L> {
        let State { s, c, x, m, .. } = self.0;
        let (sine, cosine, x, one) = (row.opposite, row.adjacent, constant(*x), double::<L>(1.0));
        let square = sine.square();
        let part = constant::<L>(*m) * square;
        let sn = sine * (one + constant(m.scale(0.0625)) * (double(4.0) - square.scale(L::splat(4.0))));
        let cn = cosine * (one - part.scale(L::splat(0.25)));
        let dn = one - part.scale(L::splat(0.5));
        let opposite = constant(*s * *c) * cn + x * dn * sn;
        AngleRow { opposite, adjacent: constant(c.square()) - x.square() * sn.square(), ..row }
    }
}

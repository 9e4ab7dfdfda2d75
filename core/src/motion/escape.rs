//! An escape as polynomials of the squared phase (elliptic/arc.rs), with its poles taken out.
//!
//! With f in flights, -1/2 and 1/2 at the poles, e = 1/4 - f^2, and P and R even in f:
//!   a simple pole                     u = P/e,  u' = R/e^2,
//!   a root of one, y = e (e + gap)    u = P/sqrt y,  u' = R/(y sqrt y),
//! where gap + 1/4 is the square of the f of the next real poles, which close in on these where the root goes; times f
//! whichever is odd about the middle.
//!
//! Past a saddle u' nearly vanishes, and complex branch points stand next to the way. Each are four, +-h +- i k in f: a
//! factor (x - c)^2 + s of x = f^2, c = h^2 - k^2 and s = 4 h^2 k^2. That of the branch points goes with y, that of the
//! zeros of u' with u'.

use super::bounded::begun;
use super::interpolant::{Curve, Interpolant, Place, rounded_product};
use crate::elliptic::phase::Phase;
use crate::float::Dd;
use crate::float::double_double::{fast_two_sum, two_sum};
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Formula, Lane};

/// What the poles of u are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Pole {
    Simple,
    /// With the gap.
    Root(Dd),
}

/// The complex branch points of u and zeros of u' next to the way, as c and s of f^2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Beside {
    pub roots: [f64; 2],
    pub zeros: [f64; 2],
}

impl Beside {
    /// From the f of one of each.
    pub fn new(root: [f64; 2], zero: [f64; 2]) -> Beside {
        let of = |[re, im]: [f64; 2]| [(re - im) * (re + im), (2.0 * re * im) * (2.0 * re * im)];
        Beside { roots: of(root), zeros: of(zero) }
    }

    /// The factors of the branch points and of the zeros.
    #[inline(always)]
    fn factors<L: Lane>(&self, f: Unnormalised<L>) -> [Unnormalised<L>; 2] {
        let x = f.square();
        [four(x, &self.roots), four(x, &self.zeros)]
    }
}

/// (x - c)^2 + s.
#[inline(always)]
fn four<L: Lane>(x: Unnormalised<L>, [centre, rest]: &[f64; 2]) -> Unnormalised<L> {
    let distance = x - Unnormalised::from_double(L::splat(*centre));
    distance.square() + Unnormalised::from_double(L::splat(*rest))
}

/// Most that polynomials of a flight may spread: an error of a unit of |u| or two.
pub(crate) const SPREAD: f64 = 2.0;

/// How a flight goes with time, and what its polynomials lack of u and u'.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Flight {
    pub pole: Pole,
    /// What is taken out besides a root.
    pub beside: Option<Beside>,
    /// Whether u is odd about the middle, or u'.
    pub odd: bool,
    /// Flights from the middle, or from the pole next to the start.
    pub phase: Phase,
    pub from_pole: bool,
    /// Power of two that times take.
    pub time: f64,
    /// Factors of u and u', powers of two with signs: on the leg after the middle, or of the start where that is the
    /// pole's.
    pub u: f64,
    pub velocity: f64,
}

/// u and u' between the middle and a pole, but for the factors of its flight.
pub(crate) trait Outwards {
    /// At f and 1/2 - f flights from the middle, in (0, 1/2); `#[inline(always)]`.
    fn at<L: Lane>(&self, f: Unnormalised<L>, rest: Unnormalised<L>) -> [Unnormalised<L>; 2];
}

/// The way out as a curve.
pub(crate) struct Drawn<M> {
    pub way: M,
    pub odd: bool,
    pub pole: Pole,
    pub beside: Option<Beside>,
}

impl<M: Outwards> Curve for Drawn<M> {
    #[inline(always)]
    fn at<L: Lane>(&self, Place { f, to_ends }: Place<L>) -> [Unnormalised<L>; 2] {
        let rest = to_ends.over(f + Unnormalised::from_double(L::splat(0.5)));
        let [u, velocity] = self.way.at(f, rest);
        let (u, velocity) = match self.pole {
            Pole::Simple => (u * to_ends, velocity * (to_ends * to_ends)),
            Pole::Root(gap) => {
                let mut y = to_ends * (to_ends + Unnormalised::splat(gap));
                let mut velocity = velocity;
                if let Some(beside) = &self.beside {
                    let [roots, zeros] = beside.factors(f);
                    (y, velocity) = (y * roots, velocity.over(zeros));
                }
                let root = y.root();
                (u * root, velocity * root * y)
            }
        };
        if self.odd { [u.over(f), velocity] } else { [u, velocity.over(f)] }
    }
}

/// A flight at any time, with its start as it was given; what is wanted first. NaN beyond the poles.
pub(crate) struct Flying<'a, const FIRST: bool> {
    pub flight: &'a Flight,
    pub arc: &'a Interpolant,
    /// u and u' at t = 0.
    pub start: [f64; 2],
}

impl Flight {
    /// Whether the squares of its distances to the poles are in range.
    pub fn starts_in_range(&self) -> bool {
        !self.from_pole || self.phase.start.hi > 1e-60
    }
}

impl<const FIRST: bool> Formula<1, 2> for Flying<'_, FIRST> {
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let Flight { pole, beside, odd, phase, from_pole, time, u: u_scale, velocity: velocity_scale } =
            self.flight;
        let passed = phase.counted(t * L::splat(*time));
        let half = L::splat(0.5);
        let one = L::splat(1.0);
        let f = if *from_pole {
            let (hi, lo) = two_sum(half, -passed.hi);
            Dd::ordered_sum(hi, lo - passed.lo)
        } else {
            passed
        };
        let sign = one.copysign(f.hi);
        let size = f.scale(sign);
        // To the pole on this side: its own count is exact while it is near.
        let (hi, lo) = fast_two_sum(half, -size.hi);
        let rest = Dd::ordered_sum(hi, lo - size.lo);
        let rest = if *from_pole { Dd::select(passed.hi.less(half), passed, rest) } else { rest };
        // False for NaN as well.
        let inside = L::splat(0.0).less(rest.hi);
        let rest = Unnormalised::select(inside, rest.into(), Unnormalised::from_double(half));
        let (other, error) = fast_two_sum(one, -rest.hi);
        let ends = rest * Unnormalised::new(other, error - rest.lo);
        let (p, r) = (self.arc.first(f), self.arc.second(f));
        let along = Unnormalised::from(size);
        let (p, r) = if *odd { (p * along, r) } else { (p, r * along) };
        let (u, velocity) = match pole {
            Pole::Simple => {
                let inverse = ends.inverse();
                (rounded_product(p, inverse), rounded_product(r * inverse, inverse))
            }
            Pole::Root(gap) => {
                let (mut y, mut r) = (ends * (ends + Unnormalised::splat(*gap)), r);
                if let Some(beside) = beside {
                    let [roots, zeros] = beside.factors(along);
                    (y, r) = (y * roots, r * zeros);
                }
                let inverse = y.inverse_root();
                (rounded_product(p, inverse), rounded_product(r * inverse, inverse * inverse))
            }
        };
        let (u_sign, velocity_sign) = if *odd { (sign, one) } else { (one, sign) };
        let u = u * (u_sign * L::splat(*u_scale));
        let velocity = velocity * (velocity_sign * L::splat(*velocity_scale));
        let nan = L::splat(f64::NAN);
        let both = [L::select(inside, u, nan), L::select(inside, velocity, nan)];
        begun::<FIRST, L>(self.start, t, both)
    }
}

//! An escape as polynomials of the squared phase (motion/interpolant.rs), with its poles removed.
//!
//! With f in units of the time from pole to pole, -1/2 and 1/2 at the poles, e = 1/4 - f^2, and P and R even in f:
//!   a simple pole                     u = P/e,  u' = R/e^2,
//!   a branch point, y = e (e + gap)   u = P/sqrt y,  u' = R/(y sqrt y),
//! where gap + 1/4 is the square of the f of the next real branch points. They come together with the poles where the
//! branch point becomes a pole. Of u and u' the one that is odd about the middle has the factor f besides.
//!
//! Near a saddle u' is almost zero, and complex branch points lie near the real axis. There are four of each, +-h +- i k in
//! f: a factor (x - c)^2 + s of x = f^2, c = h^2 - k^2 and s = 4 h^2 k^2. That of the branch points multiplies y, that of
//! the zeros of u' multiplies u'.

use super::interpolant::{EvenFunctions, Interpolant, Node, OneSide, rounded_product};
use crate::elliptic::phase::Phase;
use crate::float::Dd;
use crate::float::double_double::{fast_two_sum, two_sum};
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Formula, Lane};

/// What u has where it escapes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum EscapePole {
    Simple,
    /// With the gap.
    BranchPoint(Dd),
}

/// The complex branch points of u and zeros of u' near the real axis, as c and s of f^2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct NearbyBranchPoints {
    branch_points: [f64; 2],
    zeros: [f64; 2],
}

impl NearbyBranchPoints {
    /// From the f of one of each.
    pub fn new(branch_point: [f64; 2], zero: [f64; 2]) -> NearbyBranchPoints {
        let of = |[re, im]: [f64; 2]| [(re - im) * (re + im), (2.0 * re * im) * (2.0 * re * im)];
        NearbyBranchPoints { branch_points: of(branch_point), zeros: of(zero) }
    }

    /// The factors of the branch points and of the zeros.
    #[inline(always)]
    fn factors<L: Lane>(&self, f: Unnormalised<L>) -> [Unnormalised<L>; 2] {
        let x = f.square();
        [quartet(x, &self.branch_points), quartet(x, &self.zeros)]
    }
}

/// (x - c)^2 + s.
#[inline(always)]
fn quartet<L: Lane>(x: Unnormalised<L>, [c, s]: &[f64; 2]) -> Unnormalised<L> {
    let distance = x - Unnormalised::from_double(L::splat(*c));
    distance.square() + Unnormalised::from_double(L::splat(*s))
}

/// Largest sum of the terms after the first, relative to the least value: an error of a unit of |u| or two.
pub(crate) const CONDITION: f64 = 2.0;

/// The phase of an escape, and the factors of u and u' that its polynomials leave out.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Escape {
    pub pole: EscapePole,
    /// What is removed besides the pole.
    pub nearby: Option<NearbyBranchPoints>,
    /// Whether u is odd about the middle, or u'.
    pub odd: bool,
    /// The phase from the middle, or from the pole next to the start.
    pub phase: Phase,
    pub from_pole: bool,
    /// Power of two that times take.
    pub time: f64,
    /// Factors of u and u', powers of two with signs: on the side after the middle, or on that of the start with
    /// `from_pole`.
    pub scales: [f64; 2],
}

/// The position of a time on an escape.
pub(crate) struct Position<L: Lane> {
    /// From the middle.
    pub f: Dd<L>,
    /// Sign and size of f.
    pub sign: L,
    pub size: Dd<L>,
    /// To the pole on this side; not positive beyond it.
    pub rest: Dd<L>,
}

/// The motion from the middle to a pole as even functions about the middle.
pub(crate) struct EscapeFunctions<'a, P> {
    pub to_pole: P,
    pub escape: &'a Escape,
}

impl<P: OneSide> EvenFunctions for EscapeFunctions<'_, P> {
    #[inline(always)]
    fn at<L: Lane>(&self, Node { f, to_ends }: Node<L>) -> [Unnormalised<L>; 2] {
        let rest = to_ends.over(f + Unnormalised::from_double(L::splat(0.5)));
        let [u, velocity] = self.to_pole.at(f, rest);
        let (u, velocity) = match &self.escape.pole {
            EscapePole::Simple => (u * to_ends, velocity * (to_ends * to_ends)),
            EscapePole::BranchPoint(gap) => {
                let mut y = to_ends * (to_ends + Unnormalised::splat(*gap));
                let mut velocity = velocity;
                if let Some(nearby) = &self.escape.nearby {
                    let [branch_points, zeros] = nearby.factors(f);
                    (y, velocity) = (y * branch_points, velocity.over(zeros));
                }
                let root = y.root();
                (u * root, velocity * root * y)
            }
        };
        if self.escape.odd { [u.over(f), velocity] } else { [u, velocity.over(f)] }
    }
}

impl Escape {
    /// Whether the squares of the distances from the start to the poles are in range.
    pub fn starts_in_range(&self) -> bool {
        !self.from_pole || self.phase.start.hi > 1e-60
    }

    /// The position at the time t.
    #[inline(always)]
    pub fn position<L: Lane>(&self, t: L) -> Position<L> {
        let passed = self.phase.counted(t * L::splat(self.time));
        let half = L::splat(0.5);
        let f = if self.from_pole {
            let (hi, lo) = two_sum(half, -passed.hi);
            Dd::ordered_sum(hi, lo - passed.lo)
        } else {
            passed
        };
        let sign = L::splat(1.0).copysign(f.hi);
        let size = f.scale(sign);
        let (hi, lo) = fast_two_sum(half, -size.hi);
        let rest = Dd::ordered_sum(hi, lo - size.lo);
        // The distance to the pole next to the start is counted from the start, so it keeps its digits.
        let rest = if self.from_pole { Dd::select(passed.hi.less(half), passed, rest) } else { rest };
        Position { f, sign, size, rest }
    }
}

/// An escape by its polynomials, at any time; NaN beyond the poles.
pub(crate) struct EscapeByInterpolant<'a>(pub &'a Escape, pub &'a Interpolant);

impl Formula<1, 2> for EscapeByInterpolant<'_> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let EscapeByInterpolant(escape, interpolant) = self;
        let (half, one) = (L::splat(0.5), L::splat(1.0));
        let Position { f, sign, size, rest } = escape.position(t);
        // False for NaN as well.
        let inside = L::splat(0.0).less(rest.hi);
        let rest = Unnormalised::select(inside, rest.into(), Unnormalised::from_double(half));
        let (other, error) = fast_two_sum(one, -rest.hi);
        let ends = rest * Unnormalised::new(other, error - rest.lo);
        let (p, r) = (interpolant.first(f), interpolant.second(f));
        let along = Unnormalised::from(size);
        let (p, r) = if escape.odd { (p * along, r) } else { (p, r * along) };
        let (u, velocity) = match &escape.pole {
            EscapePole::Simple => {
                let inverse = ends.inverse();
                (rounded_product(p, inverse), rounded_product(r * inverse, inverse))
            }
            EscapePole::BranchPoint(gap) => {
                let (mut y, mut r) = (ends * (ends + Unnormalised::splat(*gap)), r);
                if let Some(nearby) = &escape.nearby {
                    let [branch_points, zeros] = nearby.factors(along);
                    (y, r) = (y * branch_points, r * zeros);
                }
                let inverse = y.inverse_root();
                (rounded_product(p, inverse), rounded_product(r * inverse, inverse * inverse))
            }
        };
        let (u_sign, velocity_sign) = if escape.odd { (sign, one) } else { (one, sign) };
        let u = u * (u_sign * L::splat(escape.scales[0]));
        let velocity = velocity * (velocity_sign * L::splat(escape.scales[1]));
        let nan = L::splat(f64::NAN);
        [L::select(inside, u, nan), L::select(inside, velocity, nan)]
    }
}

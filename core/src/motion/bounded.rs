//! A libration or the motion in a well as polynomials of the squared phase (elliptic/arc.rs).
//!
//! With f in half periods from a base, e = 1/4 - f^2, P and R even in f, and (-1)^n for the whole half periods where
//! the motion crosses 0:
//!
//! | base | u | u' |
//! |---|---|---|
//! | zero | f P | e R |
//! | turning point | e P | f R |
//! | turning point of a well | P | f e R |
//!
//! The base is the one from which the singularities of the motion are furthest. Those on the imaginary axis of f, at i
//! a and i b, are taken out where they are near: with y = (f^2 + a^2)(f^2 + b^2) u takes 1/sqrt y and u' 1/(y sqrt y);
//! with a = b they are poles, and no root is left.

use super::interpolant::{Curve, Interpolant, Place, rounded_product, to_ends};
use crate::elliptic::phase::{LAST_HALF_PERIOD, Phase, alternating};
use crate::float::Dd;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Formula, Lane};

/// Where the phase is counted from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Base {
    Zero,
    Turn,
    Well,
}

/// What is taken out of u, and its cube of u'.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Taken {
    Nothing,
    /// a^2 of a pole.
    Pole(f64),
    /// a^2 and b^2.
    Roots([f64; 2]),
}

/// Most that polynomials of a swing may spread: an error of some units of its least |u| and |u'|.
pub(crate) const SPREAD: f64 = 2.5;

/// How a swing goes with time, and what its polynomials lack of u and u'.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Swing {
    pub base: Base,
    pub taken: Taken,
    /// Half periods from the base.
    pub phase: Phase,
    /// Power of two that times take.
    pub time: f64,
    /// Factors of u and u', powers of two with signs.
    pub u: f64,
    pub velocity: f64,
}

/// u and u' between two bases of a motion by theta functions, but for the factors of its swing.
pub(crate) trait Leg {
    /// At f and 1/2 - f half periods from the base of the theta functions, in (0, 1/2); `#[inline(always)]`.
    fn at<L: Lane>(&self, f: Unnormalised<L>, rest: Unnormalised<L>) -> [Unnormalised<L>; 2];
}

/// A leg as a curve: with the base of the swing, and whether that is the far end of the leg.
pub(crate) struct Drawn<M> {
    pub leg: M,
    pub base: Base,
    pub far: bool,
    pub taken: Taken,
}

impl<M: Leg> Curve for Drawn<M> {
    #[inline(always)]
    fn at<L: Lane>(&self, Place { f, to_ends }: Place<L>) -> [Unnormalised<L>; 2] {
        let rest = to_ends.over(f + Unnormalised::from_double(L::splat(0.5)));
        let [u, velocity] = if self.far { self.leg.at(rest, f) } else { self.leg.at(f, rest) };
        let x = f.square();
        let (u, velocity) = match self.taken {
            Taken::Nothing => (u, velocity),
            Taken::Pole(a) => {
                let y = x + Unnormalised::from_double(L::splat(a));
                (u * y, velocity * y.square())
            }
            Taken::Roots([a, b]) => {
                let y = (x + Unnormalised::from_double(L::splat(a)))
                    * (x + Unnormalised::from_double(L::splat(b)));
                let root = y.root();
                (u * root, velocity * y * root)
            }
        };
        match self.base {
            Base::Zero => [u.over(f), velocity.over(to_ends)],
            Base::Turn => [u.over(to_ends), velocity.over(f)],
            Base::Well => [u, velocity.over(f).over(to_ends)],
        }
    }
}

/// A swing at any time, with its start as it was given; what is wanted first.
pub(crate) struct Swinging<'a, const FIRST: bool> {
    pub swing: &'a Swing,
    pub arc: &'a Interpolant,
    /// u and u' at t = 0.
    pub start: [f64; 2],
}

/// The start as it was given, at t = 0; what is wanted first.
#[inline(always)]
pub(crate) fn begun<const FIRST: bool, L: Lane>(start: [f64; 2], t: L, [u, velocity]: [L; 2]) -> [L; 2] {
    let at_start = t.equal(L::splat(0.0));
    let u = L::select(at_start, L::splat(start[0]), u);
    let velocity = L::select(at_start, L::splat(start[1]), velocity);
    if FIRST { [u, velocity] } else { [velocity, u] }
}

impl<const FIRST: bool> Formula<1, 2> for Swinging<'_, FIRST> {
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let Swing { base, taken, phase, time, u: u_scale, velocity: velocity_scale } = self.swing;
        let (n, f) = phase.spread::<L>().count(t * L::splat(*time), LAST_HALF_PERIOD);
        let (p, r) = (self.arc.first(f), self.arc.second(f));
        let along = Unnormalised::from(f);
        let (p, r) = match taken {
            Taken::Nothing => (p, r),
            Taken::Pole(a) => {
                let inverse = (along.square() + Unnormalised::from_double(L::splat(*a))).inverse();
                (p * inverse, r * (inverse * inverse))
            }
            Taken::Roots([a, b]) => {
                let x = along.square();
                let y = (x + Unnormalised::from_double(L::splat(*a)))
                    * (x + Unnormalised::from_double(L::splat(*b)));
                let root = y.inverse_root();
                (p * root, r * (root * root * root))
            }
        };
        let ends = to_ends(f);
        let (u, velocity) = match base {
            Base::Zero => (rounded_product(p, along), rounded_product(r, ends)),
            Base::Turn => (rounded_product(p, ends), rounded_product(r, along)),
            Base::Well => (p.hi + p.lo, rounded_product(r * along, ends)),
        };
        let side = if *base == Base::Well { L::splat(1.0) } else { alternating(n) };
        let u = u * (side * L::splat(*u_scale));
        let velocity = velocity * (side * L::splat(*velocity_scale));
        begun::<FIRST, L>(self.start, t, [u, velocity])
    }
}

impl Swing {
    /// Counted from the far end of its leg, where the motion turns: there u' has the other sign.
    pub fn counted_from_far_end(self, base: Base) -> Swing {
        let start = self.phase.start - Dd::from(0.5);
        let phase = Phase { start, ..self.phase };
        Swing { base, phase, velocity: -self.velocity, ..self }
    }
}

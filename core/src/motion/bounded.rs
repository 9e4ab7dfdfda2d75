//! A libration or the motion in a well as polynomials of the squared phase (motion/interpolant.rs).
//!
//! With f in half periods from an origin, e = 1/4 - f^2, P and R even in f, and (-1)^n for the whole half periods where
//! the motion crosses 0:
//!
//! | origin | u | u' |
//! |---|---|---|
//! | zero | f P | e R |
//! | turning point | e P | f R |
//! | turning point of a well | P | f e R |
//!
//! The origin is the one from which the singularities of the motion are farthest. Those on the imaginary axis of f, at
//! i a and i b, are removed where they are near: with y = (f^2 + a^2)(f^2 + b^2), u has the factor 1/sqrt y and u' the
//! factor 1/(y sqrt y). With a = b they are poles, and there is no square root.

use super::interpolant::{EvenFunctions, Interpolant, Node, OneSide, rounded_product, to_ends};
use crate::elliptic::phase::{LAST_HALF_PERIOD, Phase, alternating};
use crate::float::Dd;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Formula, Lane};

/// Where the phase is counted from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Origin {
    Zero,
    TurningPoint,
    /// The turning point of a well: u does not change its sign.
    WellTurningPoint,
}

/// The singularities that are removed from u, and their cubes from u'.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Removed {
    Nothing,
    /// a^2 of a pole.
    Pole(f64),
    /// a^2 and b^2 of branch points.
    BranchPoints([f64; 2]),
}

/// Largest sum of the terms after the first, relative to the least value: some units of the least |u| and |u'|.
pub(crate) const CONDITION: f64 = 2.5;

/// The phase of a bounded motion, and the factors of u and u' that its polynomials leave out.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounded {
    pub origin: Origin,
    pub removed: Removed,
    /// Half periods from the origin.
    pub phase: Phase,
    /// Power of two that times take.
    pub time: f64,
    /// Factors of u and u', powers of two with signs.
    pub scales: [f64; 2],
}

/// A quarter period as even functions about the origin.
pub(crate) struct BoundedFunctions<'a, Q> {
    pub quarter: Q,
    pub bounded: &'a Bounded,
}

impl<Q: OneSide> EvenFunctions for BoundedFunctions<'_, Q> {
    #[inline(always)]
    fn at<L: Lane>(&self, Node { f, to_ends }: Node<L>) -> [Unnormalised<L>; 2] {
        let rest = to_ends.over(f + Unnormalised::from_double(L::splat(0.5)));
        let Bounded { origin, removed, .. } = self.bounded;
        let [u, velocity] =
            if *origin == Origin::Zero { self.quarter.at(f, rest) } else { self.quarter.at(rest, f) };
        let x = f.square();
        let (u, velocity) = match removed {
            Removed::Nothing => (u, velocity),
            Removed::Pole(a) => {
                let y = x + Unnormalised::from_double(L::splat(*a));
                (u * y, velocity * y.square())
            }
            Removed::BranchPoints([a, b]) => {
                let y = (x + Unnormalised::from_double(L::splat(*a)))
                    * (x + Unnormalised::from_double(L::splat(*b)));
                let root = y.root();
                (u * root, velocity * y * root)
            }
        };
        match origin {
            Origin::Zero => [u.over(f), velocity.over(to_ends)],
            Origin::TurningPoint => [u.over(to_ends), velocity.over(f)],
            Origin::WellTurningPoint => [u, velocity.over(f).over(to_ends)],
        }
    }
}

/// A bounded motion by its polynomials, at any time.
pub(crate) struct BoundedByInterpolant<'a>(pub &'a Bounded, pub &'a Interpolant);

impl Formula<1, 2> for BoundedByInterpolant<'_> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let BoundedByInterpolant(Bounded { origin, removed, phase, time, scales }, interpolant) = self;
        let (n, f) = phase.spread::<L>().count(t * L::splat(*time), LAST_HALF_PERIOD);
        let (p, r) = (interpolant.first(f), interpolant.second(f));
        let along = Unnormalised::from(f);
        let (p, r) = match removed {
            Removed::Nothing => (p, r),
            Removed::Pole(a) => {
                let inverse = (along.square() + Unnormalised::from_double(L::splat(*a))).inverse();
                (p * inverse, r * (inverse * inverse))
            }
            Removed::BranchPoints([a, b]) => {
                let x = along.square();
                let y = (x + Unnormalised::from_double(L::splat(*a)))
                    * (x + Unnormalised::from_double(L::splat(*b)));
                let root = y.inverse_root();
                (p * root, r * (root * root * root))
            }
        };
        let ends = to_ends(f);
        let (u, velocity) = match origin {
            Origin::Zero => (rounded_product(p, along), rounded_product(r, ends)),
            Origin::TurningPoint => (rounded_product(p, ends), rounded_product(r, along)),
            Origin::WellTurningPoint => (p.hi + p.lo, rounded_product(r * along, ends)),
        };
        let sign = if *origin == Origin::WellTurningPoint { L::splat(1.0) } else { alternating(n) };
        [u * (sign * L::splat(scales[0])), velocity * (sign * L::splat(scales[1]))]
    }
}

impl Bounded {
    /// From the phase and the factors where it is counted from a zero, or from a turning point of a well as its other turning
    /// point: the origin is the far end of that quarter period, where u' has the other sign.
    pub fn new(
        origin: Origin,
        removed: Removed,
        Phase { rate, start }: Phase,
        time: f64,
        [u, velocity]: [f64; 2],
    ) -> Bounded {
        let (start, velocity) =
            if origin == Origin::Zero { (start, velocity) } else { (start - Dd::from(0.5), -velocity) };
        Bounded { origin, removed, phase: Phase { rate, start }, time, scales: [u, velocity] }
    }
}

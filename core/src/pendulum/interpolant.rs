//! Half a period of a libration, or a turn of a rotation, as polynomials (motion/interpolant.rs): no sine, no arctangent.
//!
//! With f in [-1/2, 1/2] half periods from the bottom and x = f^2,
//!   angle = f P,  velocity = (1/4 - x) R in libration and R in rotation.
//! The nearest pole of both is f = i a, a = K'/2K. Near the separatrix R falls off steeply from it; there the polynomial is that
//! of (x + a^2) R, which varies little. Nearer, where one polynomial would need too many terms, they are piecewise
//! (motion/pieces.rs). Method: docs/decisions/0011.

use super::canonical::{Canonical, CanonicalMotion, last_count, turns_and_sign};
use super::orbit::Orbit;
use super::theta_quotients::{Elliptic, speed, tangent};
use crate::elliptic::theta::neville::NevilleTheta;
use crate::float::Dd;
use crate::float::double_double::fast_two_sum;
use crate::float::elementary::arctangent;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{BETWEEN, Lane, ROUNDER};
use crate::motion::interpolant::{EvenFunctions, Interpolant, Node, rounded_product, to_ends};
use crate::motion::pieces::Pieces;
use std::sync::Arc;

/// Up to this count R itself is a polynomial; beyond, it varies too much for one to be accurate.
const MOST_WITH_POLE: usize = 24;

/// a^2 of the pole that is taken out of R at this count.
fn removed(lattice: &NevilleTheta, count: usize) -> Option<f64> {
    (count > MOST_WITH_POLE).then_some(0.25 * lattice.aspect * lattice.aspect)
}

impl Orbit {
    /// The polynomials of its angle and its velocity, where they serve; the first call makes them.
    #[inline]
    pub(super) fn polynomials<const ROTATION: bool>(&self, elliptic: &Elliptic) -> Option<&Interpolant> {
        self.interpolant.or_make(|| {
            let map = self.interpolant.kind?;
            let pole = removed(&elliptic.lattice, map.count());
            Some(if elliptic.lattice.by_hyperbolic() {
                Interpolant::new(map, &EvenParts::<ROTATION, true>(elliptic, pole))
            } else {
                Interpolant::new(map, &EvenParts::<ROTATION, false>(elliptic, pole))
            })
        })
    }

    /// The piecewise polynomials, where they serve; the first call makes them.
    #[inline]
    pub(super) fn pieces<const ROTATION: bool>(&self, elliptic: &Elliptic) -> Option<&Pieces> {
        let pieces = self.pieces.as_ref()?;
        Some(pieces.get_or_init(|| {
            // Next to a separatrix m > 1/2.
            Arc::new(Pieces::new(&EvenParts::<ROTATION, true>(elliptic, None)))
        }))
    }
}

/// P and R on one side of the theta functions, R without the pole at this a^2.
struct EvenParts<'a, const ROTATION: bool, const HYPERBOLIC: bool>(&'a Elliptic, Option<f64>);

impl<const ROTATION: bool, const HYPERBOLIC: bool> EvenFunctions for EvenParts<'_, ROTATION, HYPERBOLIC> {
    #[inline(always)]
    fn at<L: Lane>(&self, Node { f, to_ends }: Node<L>) -> [Unnormalised<L>; 2] {
        let EvenParts(elliptic, pole) = self;
        let thetas = elliptic.lattice.thetas_on::<HYPERBOLIC, L>(f.tight());
        let [opposite, adjacent] = tangent::<ROTATION, L>(elliptic, &thetas);
        let angle = Unnormalised::from(arctangent(opposite, adjacent)).scale(L::splat(2.0)).over(f);
        let [numerator, denominator] = speed::<ROTATION, L>(elliptic, &thetas);
        let velocity = Unnormalised::from(numerator).over(Unnormalised::from(denominator));
        let velocity = if ROTATION { velocity } else { velocity.over(to_ends) };
        let velocity = match pole {
            Some(pole) => velocity * (f.square() + Unnormalised::from_double(L::splat(*pole))),
            None => velocity,
        };
        [angle, velocity]
    }
}

/// A libration or a rotation that is not next to the separatrix, by polynomials; with the side of the frame.
pub(super) struct ByInterpolant<'a, const ROTATION: bool>(pub &'a Elliptic, pub &'a Interpolant, pub f64);

impl<const ROTATION: bool> CanonicalMotion for ByInterpolant<'_, ROTATION> {
    const TURNS: bool = ROTATION;
    const DIRECT: bool = true;
    const DIRECTED: bool = !ROTATION;
    const STEPS: bool = true;
    #[inline(always)]
    fn at<const ANGLE: bool, const VELOCITY: bool, L: Lane>(&self, t: L) -> Canonical<L> {
        self.ended::<ANGLE, VELOCITY, L>(t, self.begun(t))
    }
    #[inline(always)]
    fn begun<L: Lane>(&self, t: L) -> [L; BETWEEN] {
        let (phase, end) = (self.0.phase.spread::<L>(), last_count(ROTATION));
        if ROTATION {
            let (n, f) = phase.count(t, end);
            return [n, f.hi, f.lo, self.1.mapped(f)];
        }
        let (shifted, f) = phase.parity(t, self.rounder(), end);
        // The angle is odd about the bottom.
        [shifted, f.hi.alternated(shifted), f.lo.alternated(shifted), self.1.mapped(f)]
    }
    #[inline(always)]
    fn ended<const ANGLE: bool, const VELOCITY: bool, L: Lane>(
        &self,
        _: L,
        [count, hi, lo, mapped]: [L; BETWEEN],
    ) -> Canonical<L> {
        let (f, zero, one) = (Dd::new(hi, lo), L::splat(0.0), L::splat(1.0));
        let mut motion = Canonical::at_bottom(if ROTATION { count } else { zero }, one);
        if ANGLE {
            motion.opposite = angle_of(self.1.first_at(mapped), f);
        }
        if VELOCITY {
            let speed = self.speed(self.1.second_at(mapped), f);
            motion.velocity = if ROTATION { speed } else { speed.alternated(count) };
        }
        motion
    }
}

impl<const ROTATION: bool> ByInterpolant<'_, ROTATION> {
    /// 1.5 2^52, and 1 more where a libration goes downwards at first: it is one that goes upwards half a period away.
    #[inline(always)]
    pub fn rounder(&self) -> f64 {
        if !ROTATION && self.2 < 0.0 { ROUNDER + 1.0 } else { ROUNDER }
    }

    /// The velocity from R and the rest of the phase, but for its sign.
    #[inline(always)]
    pub fn speed<L: Lane>(&self, r: Unnormalised<L>, f: Dd<L>) -> L {
        let ByInterpolant(elliptic, interpolant, _) = self;
        let pole = removed(&elliptic.lattice, interpolant.count());
        if ROTATION && pole.is_none() {
            return r.hi + r.lo;
        }
        let ends = to_ends(f);
        let speed = if ROTATION { r.hi + r.lo } else { rounded_product(r, ends) };
        let Some(pole) = pole else { return speed };
        // x + a^2 as (1/4 + a^2) - (1/4 - x), which has the rest of the second.
        let (whole, rest) = (0.25 + pole, pole - ((0.25 + pole) - 0.25));
        let (below, error) = fast_two_sum(L::splat(whole), -ends.hi);
        let below_rest = error - ends.lo + L::splat(rest);
        let inverse = L::splat(1.0) / below;
        let quotient = speed * inverse;
        // What the quotient lacks by the rounding of its inverse and of its divisor.
        let (back, back_error) = quotient.two_product_in_range(below);
        let lacking = ((speed - back) - back_error) - quotient * below_rest;
        lacking.mul_add(inverse, quotient)
    }
}

/// f P. As the product of two [`Unnormalised`] whose factors are in range.
#[inline(always)]
fn angle_of<L: Lane>(Unnormalised { hi: p, lo: rest }: Unnormalised<L>, f: Dd<L>) -> Dd<L> {
    let (hi, error) = p.two_product_in_range(f.hi);
    Dd::new(hi, p.mul_add(f.lo, rest.mul_add(f.hi, error)))
}

/// R, or (1/4 - f^2) R.
#[inline(always)]
fn velocity_of<const ROTATION: bool, L: Lane>(r: Unnormalised<L>, f: Dd<L>) -> L {
    if ROTATION { r.hi + r.lo } else { rounded_product(r, to_ends(f)) }
}

/// A libration or a rotation by piecewise polynomials.
pub(super) struct ByPieces<'a, const ROTATION: bool>(pub &'a Elliptic, pub &'a Pieces);

impl<const ROTATION: bool> CanonicalMotion for ByPieces<'_, ROTATION> {
    const TURNS: bool = ROTATION;
    const DIRECT: bool = true;
    #[inline(always)]
    fn at<const ANGLE: bool, const VELOCITY: bool, L: Lane>(&self, t: L) -> Canonical<L> {
        let ByPieces(elliptic, pieces) = self;
        let (n, f) = elliptic.phase.spread::<L>().count(t, last_count(ROTATION));
        let (turns, sign) = turns_and_sign::<ROTATION, L>(n);
        let mut motion = Canonical::at_bottom(turns, sign);
        if ANGLE {
            motion.opposite = angle_of(pieces.first(f), f);
        }
        if VELOCITY {
            motion.velocity = velocity_of::<ROTATION, L>(pieces.second(f), f) * sign;
        }
        motion
    }
}

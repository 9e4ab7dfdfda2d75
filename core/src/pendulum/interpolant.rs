//! Half a period of a libration, or a turn of a rotation, as polynomials (motion/interpolant.rs): no sine, no arctangent.
//!
//! With f in [-1/2, 1/2] half periods from the bottom and x = f^2,
//!   angle = f P,  velocity = (1/4 - x) R in libration and R in rotation.
//! The nearest pole of both is f = i K'/2K. Where it is so near that one polynomial would need too many terms, they are
//! piecewise (motion/pieces.rs). Method: docs/decisions/0011.

use super::canonical::{Canonical, CanonicalMotion, last_count, turns_and_sign};
use super::orbit::Orbit;
use super::theta_quotients::{Elliptic, speed, tangent};
use crate::float::Dd;
use crate::float::elementary::{arctangent, quotient};
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{COMPACT, Lane};
use crate::motion::interpolant::{EvenFunctions, Interpolant, Node, rounded_product, to_ends};
use crate::motion::pieces::Pieces;
use std::sync::Arc;

/// Up to this count the velocity is a polynomial too; beyond, it varies too much for one to be accurate.
const MOST_OF_VELOCITY: usize = 24;

/// Whether the velocity is one polynomial as the angle is.
pub(super) fn by_one(interpolant: &Interpolant) -> bool {
    interpolant.count() <= MOST_OF_VELOCITY
}

impl Orbit {
    /// The polynomials of its angle and its velocity, where they serve; the first call makes them.
    #[inline]
    pub(super) fn polynomials<const ROTATION: bool>(&self, elliptic: &Elliptic) -> Option<&Interpolant> {
        self.interpolant.or_make(|| {
            let map = self.interpolant.kind?;
            Some(if elliptic.lattice.by_hyperbolic() {
                Interpolant::new(map, &EvenParts::<ROTATION, true>(elliptic))
            } else {
                Interpolant::new(map, &EvenParts::<ROTATION, false>(elliptic))
            })
        })
    }
}

impl Orbit {
    /// The piecewise polynomials, where they serve; the first call makes them.
    #[inline]
    pub(super) fn pieces<const ROTATION: bool>(&self, elliptic: &Elliptic) -> Option<&Pieces> {
        let pieces = self.pieces.as_ref()?;
        Some(pieces.get_or_init(|| {
            // Next to a separatrix m > 1/2.
            Arc::new(Pieces::new(&EvenParts::<ROTATION, true>(elliptic)))
        }))
    }
}

/// P and R on one side of the theta functions.
struct EvenParts<'a, const ROTATION: bool, const HYPERBOLIC: bool>(&'a Elliptic);

impl<const ROTATION: bool, const HYPERBOLIC: bool> EvenFunctions for EvenParts<'_, ROTATION, HYPERBOLIC> {
    #[inline(always)]
    fn at<L: Lane>(&self, Node { f, to_ends }: Node<L>) -> [Unnormalised<L>; 2] {
        let EvenParts(elliptic) = self;
        let thetas = elliptic.lattice.thetas_on::<HYPERBOLIC, L>(f.tight());
        let [opposite, adjacent] = tangent::<ROTATION, L>(elliptic, &thetas);
        let angle = Unnormalised::from(arctangent(opposite, adjacent)).scale(L::splat(2.0)).over(f);
        let [numerator, denominator] = speed::<ROTATION, L>(elliptic, &thetas);
        let velocity = Unnormalised::from(numerator).over(Unnormalised::from(denominator));
        [angle, if ROTATION { velocity } else { velocity.over(to_ends) }]
    }
}

/// A libration or a rotation that is not next to the separatrix, by polynomials.
pub(super) struct ByInterpolant<'a, const ROTATION: bool> {
    pub elliptic: &'a Elliptic,
    pub interpolant: &'a Interpolant,
    /// Where the velocity is piecewise.
    pub pieces: Option<&'a Pieces>,
}

impl<const ROTATION: bool> CanonicalMotion for ByInterpolant<'_, ROTATION> {
    const TURNS: bool = ROTATION;
    const DIRECT: bool = true;
    #[inline(always)]
    fn at<const ANGLE: bool, const VELOCITY: bool, L: Lane>(&self, t: L) -> Canonical<L> {
        let (n, f) = self.elliptic.phase.spread::<L>().count(t, last_count(ROTATION));
        self.at_phase::<ANGLE, VELOCITY, L>(n, f)
    }
}

impl<const ROTATION: bool> ByInterpolant<'_, ROTATION> {
    /// Whether the velocity is one polynomial too.
    pub fn whole(&self) -> bool {
        by_one(self.interpolant)
    }

    /// The motion at n + f half periods.
    #[inline(always)]
    fn at_phase<const ANGLE: bool, const VELOCITY: bool, L: Lane>(&self, n: L, f: Dd<L>) -> Canonical<L> {
        let value = if ANGLE { self.interpolant.first(f) } else { Unnormalised::from_double(L::splat(0.0)) };
        self.at_value::<ANGLE, VELOCITY, L>(n, f, value)
    }

    /// The same with the value of P.
    #[inline(always)]
    pub fn at_value<const ANGLE: bool, const VELOCITY: bool, L: Lane>(
        &self,
        n: L,
        f: Dd<L>,
        value: Unnormalised<L>,
    ) -> Canonical<L> {
        let ByInterpolant { elliptic, interpolant, pieces } = self;
        let (turns, sign) = turns_and_sign::<ROTATION, L>(n);
        let mut motion = Canonical::at_bottom(turns, sign);
        if ANGLE {
            motion.opposite = angle_of(value, f);
        }
        if VELOCITY {
            // Rows on vectors are not asked for the other one (columns.rs).
            motion.velocity = if !COMPACT && let Some(pieces) = pieces {
                velocity_of::<ROTATION, L>(pieces.second(f), f) * sign
            } else if !COMPACT || L::WIDTH > 1 || self.whole() {
                velocity_of::<ROTATION, L>(interpolant.second(f), f) * sign
            } else {
                let size = f.scale(L::splat(1.0).copysign(f.hi));
                let thetas = elliptic.lattice.thetas_on::<true, L>(size);
                let [numerator, denominator] = speed::<ROTATION, L>(elliptic, &thetas);
                quotient(numerator, denominator).value() * sign
            };
        }
        motion
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

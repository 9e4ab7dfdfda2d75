//! Half a period of a libration, or a turn of a rotation, as polynomials (elliptic/arc.rs): no sine, no arctangent.
//!
//! With f in [-1/2, 1/2] half periods from the bottom and x = f^2,
//!   angle = f P,  velocity = (1/4 - x) R in libration and R in rotation.
//! The nearest pole of both is f = i K'/2K.

use super::orbit::Elliptic;
use super::theta_quotients::{speed, tangent};
use crate::float::Dd;
use crate::float::elementary::arctangent;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::Lane;
use crate::motion::interpolant::{self, EvenFunctions, Node, rounded_product, to_ends};

pub(crate) use crate::motion::interpolant::ConformalMap;

/// Up to this count the velocity is a polynomial too; beyond, it varies too much for one to keep its digits.
const MOST_OF_VELOCITY: usize = 24;

/// The polynomials of one orbit: of its angle and of its velocity.
#[derive(Clone, Debug)]
pub(crate) struct OrbitInterpolant(interpolant::Interpolant);

impl OrbitInterpolant {
    /// Of an orbit and its layout.
    pub fn new<const ROTATION: bool>(elliptic: &Elliptic, layout: ConformalMap) -> OrbitInterpolant {
        OrbitInterpolant(if elliptic.lattice.hyperbolic() {
            interpolant::Interpolant::new(layout, &Motion::<ROTATION, true>(elliptic))
        } else {
            interpolant::Interpolant::new(layout, &Motion::<ROTATION, false>(elliptic))
        })
    }

    /// Whether the velocity is good as well.
    #[inline(always)]
    pub fn has_velocity(&self) -> bool {
        self.0.count() <= MOST_OF_VELOCITY
    }

    /// The angle.
    #[inline(always)]
    pub fn angle<L: Lane>(&self, f: Dd<L>) -> Dd<L> {
        let Unnormalised { hi, lo } = self.0.first(f) * f.into();
        Dd::new(hi, lo)
    }

    /// The velocity.
    #[inline(always)]
    pub fn velocity<const ROTATION: bool, L: Lane>(&self, f: Dd<L>) -> L {
        let velocity = self.0.second(f);
        if ROTATION { velocity.hi + velocity.lo } else { rounded_product(velocity, to_ends(f)) }
    }
}

/// P and R on one side of the theta functions.
struct Motion<'a, const ROTATION: bool, const HYPERBOLIC: bool>(&'a Elliptic);

impl<const ROTATION: bool, const HYPERBOLIC: bool> EvenFunctions for Motion<'_, ROTATION, HYPERBOLIC> {
    #[inline(always)]
    fn at<L: Lane>(&self, Node { f, to_ends }: Node<L>) -> [Unnormalised<L>; 2] {
        let Motion(elliptic) = self;
        let thetas = elliptic.lattice.thetas_on::<HYPERBOLIC, L>(f.tight());
        let [opposite, adjacent] = tangent::<ROTATION, L>(elliptic, &thetas);
        let angle = Unnormalised::from(arctangent(opposite, adjacent)).scale(L::splat(2.0)).over(f);
        let [numerator, denominator] = speed::<ROTATION, L>(elliptic, &thetas);
        let velocity = Unnormalised::from(numerator).over(Unnormalised::from(denominator));
        [angle, if ROTATION { velocity } else { velocity.over(to_ends) }]
    }
}

//! A bounded motion with even powers as polynomials of the squared phase (motion/interpolant.rs).
//!
//! With f in periods from a turning point b, u = b + f^2 P(f^2)/y and u' = f (1/4 - f^2) R(f^2)/y^2. y = f^2 + a^2 where a pole of u
//! stands above a turning point, at i a: this is the nearest one for q > 0, and the origin is that turning point. Else y = 1, and
//! the origin is the turning point that is farther from the poles (even_poles.rs).
//! Floor: 100 operations and two polynomials; for eight times at two a cycle of 3 GHz 3 ns.

use super::even_lanes::MeanLanes;
use super::even_poles::{EvenBounded, EvenPolynomials};
use crate::elliptic::phase::{LAST_HALF_PERIOD, Phase};
use crate::elliptic::theta::neville::NevilleTheta;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{COMPACT, Formula, Lane};
use crate::motion::bounded::CONDITION;
use crate::motion::interpolant::{ConformalMap, EvenFunctions, Interpolant, Node, to_ends};

/// A motion from base to base on one side of the theta functions.
struct Nodes<'a, const HYPERBOLIC: bool>(&'a MeanLanes, &'a NevilleTheta, EvenBounded);

impl<const HYPERBOLIC: bool> EvenFunctions for Nodes<'_, HYPERBOLIC> {
    #[inline(always)]
    fn at<L: Lane>(&self, Node { f, to_ends }: Node<L>) -> [Unnormalised<L>; 2] {
        let Nodes(mean, neville, EvenBounded { at_base, pole, .. }) = *self;
        let rest = to_ends.over(f + Unnormalised::from_double(L::splat(0.5)));
        let from_base = if at_base { f } else { rest };
        let [near, far, inverse, velocity] = mean.values::<HYPERBOLIC, L>(neville, from_base.tight());
        let way = Unnormalised::splat(mean.way);
        let (way, velocity) = if at_base { (way * far, velocity) } else { (-(way * near), -velocity) };
        let x = f.square();
        let (u, velocity) = (way * inverse, velocity.over(f).over(to_ends));
        match pole {
            None => [u.over(x), velocity],
            Some(a) => {
                let y = x + Unnormalised::from_double(L::splat(a));
                [(u * y).over(x), velocity * y.square()]
            }
        }
    }
}

impl MeanLanes {
    /// The polynomials, where few enough terms serve.
    #[inline(always)]
    pub fn by_polynomials(&self, neville: &NevilleTheta) -> Option<&EvenPolynomials> {
        // As for the motions without even powers: on a page theta functions are fast enough.
        if COMPACT {
            return None;
        }
        let made = self.polynomials.get_or_init(|| {
            if neville.hyperbolic() {
                self.new_polynomials::<true>(neville)
            } else {
                self.new_polynomials::<false>(neville)
            }
        });
        made.as_ref()
    }

    #[cold]
    #[inline(never)]
    fn new_polynomials<const HYPERBOLIC: bool>(&self, neville: &NevilleTheta) -> Option<EvenPolynomials> {
        let bounded = EvenBounded::new(self.ratio, self.mc, self.three, neville);
        let map = ConformalMap::around(&bounded.left)?;
        let nodes = Nodes::<HYPERBOLIC>(self, neville, bounded);
        let interpolant = Interpolant::faithful(map, &nodes, CONDITION)?;
        Some(EvenPolynomials { bounded, interpolant })
    }
}

/// A bounded motion by its polynomials, at any time.
pub(super) struct MeanByInterpolant<'a>(pub &'a MeanLanes, pub &'a EvenPolynomials);

impl Formula<1, 2> for MeanByInterpolant<'_> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let MeanByInterpolant(mean, EvenPolynomials { bounded, interpolant }) = self;
        let EvenBounded { at_base, pole, .. } = *bounded;
        let Phase { rate, start } = mean.phase;
        let (start, origin) = if at_base { (start, mean.base) } else { (mean.start_from_other, mean.other) };
        let phase = Phase { rate, start }.spread::<L>();
        let (_, f) = phase.count(t * L::splat(mean.time), LAST_HALF_PERIOD);
        let (p, r) = (interpolant.first(f), interpolant.second(f));
        let along = Unnormalised::from(f);
        let x = along.square();
        let (p, r) = match pole {
            None => (p, r),
            Some(a) => {
                let inverse = (x + Unnormalised::from_double(L::splat(a))).inverse();
                (p * inverse, r * inverse.square())
            }
        };
        let u = Unnormalised::splat(origin) + x * p;
        let velocity = r * along * to_ends(f);
        [(u.hi + u.lo) * L::splat(mean.u_scale), (velocity.hi + velocity.lo) * L::splat(mean.velocity_scale)]
    }
}

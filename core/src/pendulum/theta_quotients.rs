//! The canonical motion by quotients of theta functions.
//!
//! With theta functions t1 (without its factor A) to t4 at the phase, k and k' of the lattice:
//!   libration: tan(theta/2) = k sn/dn,  velocity = 2 omega0 kappa cn,
//!   rotation:  tan(theta/2) = sn/cn,    velocity = 2 omega0 kappa dn.
//! The tangent is a point of two double-doubles, so the angle is accurate at the turning points and near the top.
//! Source: Salas 2019 (23), with 2 atan2 and turns in place of the arctangent; DLMF 22.2.4 to 22.2.9.

use super::canonical::{Canonical, CanonicalMotion, last_count, turns_and_sign};
use crate::elliptic::phase::Phase;
use crate::elliptic::theta::neville::{NevilleTheta, Thetas};
use crate::float::Dd;
use crate::float::elementary::quotient;
use crate::lanes::Lane;

/// A libration or a rotation in terms of theta functions.
#[derive(Clone, Debug)]
pub(crate) struct Elliptic {
    pub lattice: NevilleTheta,
    pub phase: Phase,
    /// Factors of tan of the half angle, counted from the bottom and from the quarter period.
    pub tangent: [Dd; 2],
    /// Factors of the velocity, likewise.
    pub velocity: [Dd; 2],
}

/// A libration or a rotation by theta functions, on the circular or the hyperbolic side of them.
pub(super) struct ByThetaFunctions<'a, const ROTATION: bool, const HYPERBOLIC: bool>(pub &'a Elliptic);

/// Picks numerator and denominator by fold, and the factor with them.
#[inline(always)]
fn ratio<L: Lane>(folded: L::Mask, plain: [Dd<L>; 2], turned: [Dd<L>; 2], factors: &[Dd; 2]) -> [Dd<L>; 2] {
    let factor = Dd::select(folded, Dd::splat(factors[1]), Dd::splat(factors[0]));
    let numerator = Dd::select(folded, turned[0], plain[0]);
    [numerator * factor, Dd::select(folded, turned[1], plain[1])]
}

/// Opposite and adjacent side of half the angle at theta functions.
#[inline(always)]
pub(super) fn tangent<const ROTATION: bool, L: Lane>(elliptic: &Elliptic, thetas: &Thetas<L>) -> [Dd<L>; 2] {
    let Thetas { theta: [t1, t2, t3, t4], folded } = *thetas;
    let (plain, turned) = if ROTATION { ([t1, t2], [t2, t1]) } else { ([t1, t3], [t2, t4]) };
    ratio(folded, plain, turned, &elliptic.tangent)
}

/// Numerator and denominator of the velocity, but for its sign.
#[inline(always)]
pub(super) fn speed<const ROTATION: bool, L: Lane>(elliptic: &Elliptic, thetas: &Thetas<L>) -> [Dd<L>; 2] {
    let Thetas { theta: [t1, t2, t3, t4], folded } = *thetas;
    let (plain, turned) = if ROTATION { ([t3, t4], [t4, t3]) } else { ([t2, t4], [t1, t3]) };
    ratio(folded, plain, turned, &elliptic.velocity)
}

impl<const ROTATION: bool, const HYPERBOLIC: bool> CanonicalMotion
    for ByThetaFunctions<'_, ROTATION, HYPERBOLIC>
{
    const TURNS: bool = ROTATION;
    #[inline(always)]
    fn at<const ANGLE: bool, const VELOCITY: bool, L: Lane>(&self, t: L) -> Canonical<L> {
        let elliptic = self.0;
        let (n, f) = elliptic.phase.spread::<L>().count(t, last_count(ROTATION));
        let sign = L::splat(1.0).copysign(f.hi);
        let (turns, parity) = turns_and_sign::<ROTATION, L>(n);
        let thetas = elliptic.lattice.thetas_on::<HYPERBOLIC, L>(f.scale(sign));
        let mut motion = Canonical::at_bottom(turns, sign * parity);
        if ANGLE {
            [motion.opposite, motion.adjacent] = tangent::<ROTATION, L>(elliptic, &thetas);
        }
        if VELOCITY {
            let [numerator, denominator] = speed::<ROTATION, L>(elliptic, &thetas);
            motion.velocity = quotient(numerator, denominator).value() * parity;
        }
        motion
    }
}

//! The canonical motion on the separatrix: tan(theta/2) = sinh y, velocity = 2 omega0 sech y, y = omega0 t + start.
//!
//! Source: DLMF 22.5(ii), the limit k = 1 of Salas 2019 (23).

use super::canonical::{Canonical, CanonicalMotion};
use crate::elliptic::phase::Phase;
use crate::float::Dd;
use crate::float::double_double::two_sum;
use crate::float::elementary::{saturated_sinh_cosh, sech};
use crate::lanes::Lane;

/// The hyperbolic phase y, and twice omega0.
#[derive(Clone, Debug)]
pub(crate) struct Separatrix {
    pub phase: Phase,
    pub speed: Dd,
}

/// Beyond this hyperbolic phase the angle is pi and the velocity 0.
const FAR: f64 = 1e6;

impl CanonicalMotion for &Separatrix {
    const TURNS: bool = false;
    #[inline(always)]
    fn at<const ANGLE: bool, const VELOCITY: bool, L: Lane>(&self, t: L) -> Canonical<L> {
        let Separatrix { phase: Phase { rate, start }, speed } = self;
        let (passed, error) = t.two_product(L::splat(rate.hi));
        let error = t.mul_add(L::splat(rate.lo), error);
        let near = passed.abs().less(L::splat(FAR));
        let far = L::select(t.equal(t), L::splat(FAR).copysign(passed), t);
        let passed = L::select(near, passed, far);
        let error = L::select(near, error, L::splat(0.0));
        let (y, rest) = two_sum(passed, L::splat(start.hi));
        let y = Dd::ordered_sum(y, rest + (error + L::splat(start.lo)));
        let sign = L::splat(1.0).copysign(y.hi);
        let y = y.scale(sign);
        let mut motion = Canonical::at_bottom(L::splat(0.0), sign);
        if ANGLE {
            motion.opposite = saturated_sinh_cosh(y).0;
        }
        if VELOCITY {
            let (factor, power) = sech(y);
            motion.velocity = (factor * Dd::splat(*speed)).value() * power;
        }
        motion
    }
}

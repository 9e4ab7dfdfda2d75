//! The canonical motion on the separatrix: tan(theta/2) = sinh y, velocity = 2 omega0 sech y, y = omega0 t + start.
//!
//! Source: DLMF 22.5(ii), the limit k = 1 of Salas 2019 (23).

use super::canonical::{Canonical, CanonicalMotion};
use crate::elliptic::phase::Phase;
use crate::float::Dd;
use crate::float::elementary::{saturated_sinh_cosh, sech};
use crate::lanes::Lane;

/// The hyperbolic phase y, and twice omega0.
#[derive(Clone, Debug)]
pub(crate) struct Separatrix {
    pub phase: Phase,
    pub speed: Dd,
}

impl CanonicalMotion for &Separatrix {
    const TURNS: bool = false;
    #[inline(always)]
    fn at<const ANGLE: bool, const VELOCITY: bool, L: Lane>(&self, t: L) -> Canonical<L> {
        let Separatrix { phase, speed } = self;
        let y = phase.held(t);
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

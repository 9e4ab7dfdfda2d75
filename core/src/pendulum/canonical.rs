//! The canonical motion: upwards through 0 at phase 0, in the units that the orbit has set up.
//!
//! It is evaluated by theta functions (theta_quotients.rs), by polynomials (interpolant.rs), or on the separatrix by
//! hyperbolic functions (separatrix.rs).

use crate::elliptic::phase::{LAST_HALF_PERIOD, alternating};
use crate::float::Dd;
use crate::lanes::{BETWEEN, Lane};

/// The canonical motion at one time: angle 2 pi turns + 2 sign atan2(opposite, adjacent), and velocity.
pub(super) struct Canonical<L: Lane> {
    pub turns: L,
    pub sign: L,
    pub opposite: Dd<L>,
    pub adjacent: Dd<L>,
    pub velocity: L,
}

impl<L: Lane> Canonical<L> {
    /// At the bottom after these turns, without a velocity.
    #[inline(always)]
    pub fn at_bottom(turns: L, sign: L) -> Self {
        let zero = L::splat(0.0);
        let (opposite, adjacent) = (Dd::from_double(zero), Dd::from_double(L::splat(1.0)));
        Canonical { turns, sign, opposite, adjacent, velocity: zero }
    }
}

/// A formula for the canonical motion.
pub(super) trait CanonicalMotion {
    /// Whether it makes whole turns.
    const TURNS: bool;
    /// Whether `opposite` is the angle itself.
    const DIRECT: bool = false;
    /// Whether its direction is that of the frame: the sign of the frame is in its values.
    const DIRECTED: bool = false;
    /// At one lane of times, `#[inline(always)]`. What is not asked for, angle or velocity, may be left at any value: the
    /// compiler does not drop it by itself.
    fn at<const ANGLE: bool, const VELOCITY: bool, L: Lane>(&self, t: L) -> Canonical<L>;
    /// Whether it is evaluated in two steps: [`Formula::STEPS`](crate::lanes::Formula::STEPS).
    const STEPS: bool = false;
    /// The first step, `#[inline(always)]`.
    #[inline(always)]
    fn begun<L: Lane>(&self, _t: L) -> [L; BETWEEN] {
        [L::splat(0.0); BETWEEN]
    }
    /// The second step, of which [`CanonicalMotion::at`] makes use too; `#[inline(always)]`.
    #[inline(always)]
    fn ended<const ANGLE: bool, const VELOCITY: bool, L: Lane>(
        &self,
        t: L,
        _between: [L; BETWEEN],
    ) -> Canonical<L> {
        self.at::<ANGLE, VELOCITY, L>(t)
    }
}

/// Where the count of half periods of a libration, or of turns of a rotation, ends: 2^52 turns are 2^53 half periods.
pub(super) const fn last_count(rotation: bool) -> f64 {
    if rotation { 0.5 * LAST_HALF_PERIOD } else { LAST_HALF_PERIOD }
}

/// Turns and sign of a whole count: turns of a rotation, or the side of a libration.
#[inline(always)]
pub(super) fn turns_and_sign<const ROTATION: bool, L: Lane>(n: L) -> (L, L) {
    if ROTATION { (n, L::splat(1.0)) } else { (L::splat(0.0), alternating(n)) }
}

/// Results of a formula of the motion: the angle; the velocity; and the angle again as whole turns from those of the
/// frame and a rest as hi and lo, in [-pi, pi], or without a force from 0.
pub(super) const RESULTS: usize = 5;

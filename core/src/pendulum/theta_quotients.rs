//! The canonical motion over lanes: upwards through 0 at phase 0, in units that the orbit has set up.
//!
//! With theta functions t1 (without its factor A) to t4 at the phase, k and k' of the lattice:
//!   libration: tan(theta/2) = k sn/dn,  velocity = 2 omega0 kappa cn,
//!   rotation:  tan(theta/2) = sn/cn,    velocity = 2 omega0 kappa dn,
//!   separatrix: tan(theta/2) = sinh,    velocity = 2 omega0 sech,
//! the tangent as a point of two double-doubles, so the angle keeps its digits at the turning points and
//! near the top. Source: Salas 2019 (23), with 2 atan2 and turns in place of the arctangent.

use super::interpolant::OrbitInterpolant;
use super::orbit::Elliptic;
use crate::elliptic::phase::{LAST_HALF_PERIOD, Phase, alternating};
use crate::elliptic::theta::neville::Thetas;
use crate::float::Dd;
use crate::float::double_double::two_sum;
use crate::float::elementary::{quotient, saturated_sinh_cosh, sech};
use crate::lanes::Lane;

/// The canonical motion at one time: angle 2 pi turns + 2 sign atan2(opposite, adjacent), and velocity.
pub(super) struct Canonical<L: Lane> {
    pub turns: L,
    pub sign: L,
    pub opposite: Dd<L>,
    pub adjacent: Dd<L>,
    pub velocity: L,
}

/// What an evaluation may leave out.
pub(super) trait Wanted {
    const ANGLE: bool;
    const VELOCITY: bool;
    /// What is wanted, first.
    #[inline(always)]
    fn first<L: Lane>(theta: L, velocity: L) -> [L; 2] {
        if Self::ANGLE { [theta, velocity] } else { [velocity, theta] }
    }
}
pub(super) struct AngleOnly;
pub(super) struct VelocityOnly;
pub(super) struct Both;
impl Wanted for AngleOnly {
    const ANGLE: bool = true;
    const VELOCITY: bool = false;
}
impl Wanted for VelocityOnly {
    const ANGLE: bool = false;
    const VELOCITY: bool = true;
}
impl Wanted for Both {
    const ANGLE: bool = true;
    const VELOCITY: bool = true;
}

/// A formula for the canonical motion.
pub(super) trait Path {
    /// Whether it makes whole turns.
    const TURNS: bool;
    /// Whether `opposite` is the angle itself.
    const DIRECT: bool = false;
    fn at<W: Wanted, L: Lane>(&self, t: L) -> Canonical<L>;
}

/// Libration, on the circular or the hyperbolic side of the theta functions.
pub(super) struct Swing<'a, const HYPERBOLIC: bool>(pub &'a Elliptic);

/// Rotation, likewise.
pub(super) struct Spin<'a, const HYPERBOLIC: bool>(pub &'a Elliptic);

/// Libration or rotation not next to the separatrix, by polynomials.
pub(super) struct Sway<'a, const ROTATION: bool>(pub &'a Elliptic, pub &'a OrbitInterpolant);

/// The separatrix: hyperbolic phase, and twice omega0.
pub(super) struct Ridge<'a>(pub &'a Phase, pub Dd);

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

/// 2^52 turns are 2^53 half periods.
const fn last_count(rotation: bool) -> f64 {
    if rotation { 0.5 * LAST_HALF_PERIOD } else { LAST_HALF_PERIOD }
}

/// What a whole count means: turns of a rotation, or the side of a libration.
#[inline(always)]
fn split<const ROTATION: bool, L: Lane>(n: L) -> (L, L) {
    if ROTATION { (n, L::splat(1.0)) } else { (L::splat(0.0), alternating(n)) }
}

/// The motion by theta functions, at a whole count and a rest.
#[inline(always)]
fn by_thetas<W: Wanted, const ROTATION: bool, const HYPERBOLIC: bool, L: Lane>(
    elliptic: &Elliptic,
    t: L,
) -> Canonical<L> {
    let (n, f) = elliptic.phase.spread::<L>().count(t, last_count(ROTATION));
    let sign = L::splat(1.0).copysign(f.hi);
    let (turns, parity) = split::<ROTATION, L>(n);
    let thetas = elliptic.lattice.thetas_on::<HYPERBOLIC, L>(f.scale(sign));
    let mut motion = Canonical { turns, ..Canonical::at(sign * parity) };
    if W::ANGLE {
        [motion.opposite, motion.adjacent] = tangent::<ROTATION, L>(elliptic, &thetas);
    }
    if W::VELOCITY {
        let [numerator, denominator] = speed::<ROTATION, L>(elliptic, &thetas);
        motion.velocity = quotient(numerator, denominator).value() * parity;
    }
    motion
}

impl<const HYPERBOLIC: bool> Path for Swing<'_, HYPERBOLIC> {
    const TURNS: bool = false;
    #[inline(always)]
    fn at<W: Wanted, L: Lane>(&self, t: L) -> Canonical<L> {
        by_thetas::<W, false, HYPERBOLIC, L>(self.0, t)
    }
}

impl<const HYPERBOLIC: bool> Path for Spin<'_, HYPERBOLIC> {
    const TURNS: bool = true;
    #[inline(always)]
    fn at<W: Wanted, L: Lane>(&self, t: L) -> Canonical<L> {
        by_thetas::<W, true, HYPERBOLIC, L>(self.0, t)
    }
}

impl<const ROTATION: bool> Path for Sway<'_, ROTATION> {
    const TURNS: bool = ROTATION;
    const DIRECT: bool = true;
    #[inline(always)]
    fn at<W: Wanted, L: Lane>(&self, t: L) -> Canonical<L> {
        let Sway(elliptic, arc) = self;
        let (n, f) = elliptic.phase.spread::<L>().count(t, last_count(ROTATION));
        let (turns, parity) = split::<ROTATION, L>(n);
        let mut motion = Canonical { turns, ..Canonical::at(parity) };
        if W::ANGLE {
            motion.opposite = arc.angle(f);
        }
        if W::VELOCITY {
            motion.velocity = if arc.has_velocity() {
                arc.velocity::<ROTATION, L>(f) * parity
            } else {
                let size = f.scale(L::splat(1.0).copysign(f.hi));
                let thetas = elliptic.lattice.thetas_on::<true, L>(size);
                let [numerator, denominator] = speed::<ROTATION, L>(elliptic, &thetas);
                quotient(numerator, denominator).value() * parity
            };
        }
        motion
    }
}

impl<L: Lane> Canonical<L> {
    #[inline(always)]
    fn at(sign: L) -> Self {
        let zero = L::splat(0.0);
        let (nothing, one) = (Dd::from_double(zero), Dd::from_double(L::splat(1.0)));
        Canonical { turns: zero, sign, opposite: nothing, adjacent: one, velocity: zero }
    }
}

/// Beyond this hyperbolic phase the angle is pi and the velocity 0.
const FAR: f64 = 1e6;

impl Path for Ridge<'_> {
    const TURNS: bool = false;
    #[inline(always)]
    fn at<W: Wanted, L: Lane>(&self, t: L) -> Canonical<L> {
        let Ridge(Phase { rate, start }, speed) = self;
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
        let mut motion = Canonical::at(sign);
        if W::ANGLE {
            motion.opposite = saturated_sinh_cosh(y).0;
        }
        if W::VELOCITY {
            let (factor, power) = sech(y);
            motion.velocity = (factor * Dd::splat(*speed)).value() * power;
        }
        motion
    }
}

//! The canonical motion over lanes: upwards through 0 at phase 0, in units that the orbit has set up.
//!
//! With theta functions t1 (without its factor A) to t4 at the phase, k and k' of the lattice:
//!   libration: tan(theta/2) = k sn/dn,  velocity = 2 omega0 kappa cn,
//!   rotation:  tan(theta/2) = sn/cn,    velocity = 2 omega0 kappa dn,
//!   separatrix: tan(theta/2) = sinh,    velocity = 2 omega0 sech,
//! the tangent as a point of two double-doubles, so the angle keeps its digits at the turning points and
//! near the top. Source: Salas 2019 (23), with 2 atan2 and turns in place of the arctangent.

use super::harmonics::Harmonics;
use super::orbit::Elliptic;
use crate::elliptic::phase::{Phase, Reduced};
use crate::elliptic::theta::{Thetas, fold};
use crate::float::double_double::two_sum;
use crate::float::elementary::{quotient, saturated_sinh_cosh, sech, sin_cos};
use crate::float::{Dd, PI};
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

/// 2^53 half periods: beyond, doubles are further apart than the motion repeats.
pub(super) const LAST_HALF_PERIOD: f64 = 9_007_199_254_740_992.0;

/// The phase while fewer than 2^53 half periods have passed; NaN from there.
#[inline(always)]
fn within_count<L: Lane>(half_periods: L, f: Dd<L>) -> Dd<L> {
    let within = half_periods.abs().less(L::splat(LAST_HALF_PERIOD));
    Dd::new(L::select(within, f.hi, L::splat(f64::NAN)), f.lo)
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

/// Libration of moderate amplitude, its angle by the Fourier series.
pub(super) struct Sway<'a, const HYPERBOLIC: bool>(pub &'a Elliptic, pub &'a Harmonics);

/// Rotation, likewise.
pub(super) struct Spin<'a, const HYPERBOLIC: bool>(pub &'a Elliptic);

/// The separatrix: hyperbolic phase, and twice omega0.
pub(super) struct Ridge<'a>(pub &'a Phase, pub Dd);

/// Picks numerator and denominator by fold, and the factor with them.
#[inline(always)]
fn ratio<L: Lane>(folded: L::Mask, plain: [Dd<L>; 2], turned: [Dd<L>; 2], factors: &[Dd; 2]) -> [Dd<L>; 2] {
    let factor = Dd::select(folded, Dd::splat(factors[1]), Dd::splat(factors[0]));
    let numerator = Dd::select(folded, turned[0], plain[0]);
    [numerator * factor, Dd::select(folded, turned[1], plain[1])]
}

impl<const HYPERBOLIC: bool> Path for Swing<'_, HYPERBOLIC> {
    const TURNS: bool = false;
    #[inline(always)]
    fn at<W: Wanted, L: Lane>(&self, t: L) -> Canonical<L> {
        let Swing(Elliptic { lattice, phase, tangent, velocity, .. }) = self;
        let Reduced { n, sign, f, parity } = phase.spread::<L>().reduce(t);
        let thetas = lattice.thetas_on::<HYPERBOLIC, L>(within_count(n.hi, f));
        let [t1, t2, t3, t4] = thetas.theta;
        let mut motion = Canonical::at(sign * parity);
        if W::ANGLE {
            [motion.opposite, motion.adjacent] = ratio(thetas.folded, [t1, t3], [t2, t4], tangent);
        }
        if W::VELOCITY {
            let [numerator, denominator] = ratio(thetas.folded, [t2, t4], [t1, t3], velocity);
            motion.velocity = quotient(numerator, denominator).value() * parity;
        }
        motion
    }
}

impl<const HYPERBOLIC: bool> Path for Sway<'_, HYPERBOLIC> {
    const TURNS: bool = false;
    const DIRECT: bool = true;
    #[inline(always)]
    fn at<W: Wanted, L: Lane>(&self, t: L) -> Canonical<L> {
        let Sway(Elliptic { lattice, phase, velocity, .. }, harmonics) = self;
        let Reduced { n, sign, f, parity } = phase.spread::<L>().reduce(t);
        let f = within_count(n.hi, f);
        let mut motion = Canonical::at(sign * parity);
        if W::ANGLE {
            let (folded, v) = fold(f);
            let (sine, cosine) = sin_cos(v * Dd::splat(PI));
            motion.opposite = harmonics.at(Dd::select(folded, cosine, sine));
        }
        if W::VELOCITY {
            let Thetas { theta: [t1, t2, t3, t4], folded } = lattice.thetas_on::<HYPERBOLIC, L>(f);
            let [numerator, denominator] = ratio(folded, [t2, t4], [t1, t3], velocity);
            motion.velocity = quotient(numerator, denominator).value() * parity;
        }
        motion
    }
}

impl<const HYPERBOLIC: bool> Path for Spin<'_, HYPERBOLIC> {
    const TURNS: bool = true;
    #[inline(always)]
    fn at<W: Wanted, L: Lane>(&self, t: L) -> Canonical<L> {
        let Spin(Elliptic { lattice, phase, tangent, velocity, .. }) = self;
        let Reduced { n, sign, f, .. } = phase.spread::<L>().reduce(t);
        let thetas = lattice.thetas_on::<HYPERBOLIC, L>(within_count(n.hi + n.hi, f));
        let [t1, t2, t3, t4] = thetas.theta;
        let mut motion = Canonical { turns: n.hi, ..Canonical::at(sign) };
        if W::ANGLE {
            [motion.opposite, motion.adjacent] = ratio(thetas.folded, [t1, t2], [t2, t1], tangent);
        }
        if W::VELOCITY {
            let [numerator, denominator] = ratio(thetas.folded, [t3, t4], [t4, t3], velocity);
            motion.velocity = quotient(numerator, denominator).value();
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

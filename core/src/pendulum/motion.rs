//! Angle and velocity of an orbit at any time, over lanes.
//!
//! With theta functions t1 (without its factor A) to t4 at the phase, k and k' of the lattice:
//!   libration: tan(theta/2) = k sn/dn,  velocity = 2 omega0 kappa cn,
//!   rotation:  tan(theta/2) = sn/cn,    velocity = 2 omega0 kappa dn,
//!   separatrix: tan(theta/2) = sinh,    velocity = 2 omega0 sech,
//! the tangent as a point of two double-doubles, so the angle keeps its digits at the turning points and
//! near the top. Source: Salas 2019 (23), with 2 atan2 and turns in place of the arctangent.

use super::orbit::{Course, Elliptic, Orbit};
use crate::elliptic::phase::{Phase, Reduced};
use crate::float::double_double::two_sum;
use crate::float::elementary::{arctangent, quotient, saturated_sinh_cosh, sech};
use crate::float::{Dd, PI, TWO_PI, circle};
use crate::lanes::{Kernel, Lane, Scalar, dispatch};

/// The canonical motion at one time: angle 2 pi turns + 2 sign atan2(opposite, adjacent), and velocity.
struct Canonical<L: Lane> {
    turns: L,
    sign: L,
    opposite: Dd<L>,
    adjacent: Dd<L>,
    velocity: L,
}

/// An angle 2 pi (frame.turns + turns) + local, with local in [-pi, pi].
struct Angle<L: Lane> {
    turns: L,
    local: Dd<L>,
}

/// What an evaluation may leave out.
trait Wanted {
    const ANGLE: bool;
    const VELOCITY: bool;
}
struct AngleOnly;
struct VelocityOnly;
struct Both;
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
pub(crate) const LAST_HALF_PERIOD: f64 = 9_007_199_254_740_992.0;

/// The phase while fewer than 2^53 half periods have passed; NaN from there.
#[inline(always)]
fn within_count<L: Lane>(half_periods: L, f: Dd<L>) -> Dd<L> {
    let within = half_periods.abs().less(L::splat(LAST_HALF_PERIOD));
    Dd::new(L::select(within, f.hi, L::splat(f64::NAN)), f.lo)
}

impl Elliptic {
    /// Picks numerator and denominator by fold, and the factor with them.
    #[inline(always)]
    fn ratio<L: Lane>(
        folded: L::Mask,
        plain: [Dd<L>; 2],
        turned: [Dd<L>; 2],
        factors: &[Dd; 2],
    ) -> [Dd<L>; 2] {
        let factor = Dd::select(folded, Dd::splat(factors[1]), Dd::splat(factors[0]));
        let numerator = Dd::select(folded, turned[0], plain[0]);
        [numerator * factor, Dd::select(folded, turned[1], plain[1])]
    }

    #[inline(always)]
    fn libration<W: Wanted, L: Lane>(&self, t: L) -> Canonical<L> {
        let Reduced { n, sign, f, parity } = self.phase.reduce(t);
        let thetas = self.lattice.thetas(within_count(n.hi, f));
        let [t1, t2, t3, t4] = thetas.theta;
        let mut motion = Canonical::at(sign * parity);
        if W::ANGLE {
            [motion.opposite, motion.adjacent] =
                Self::ratio(thetas.folded, [t1, t3], [t2, t4], &self.tangent);
        }
        if W::VELOCITY {
            let [numerator, denominator] = Self::ratio(thetas.folded, [t2, t4], [t1, t3], &self.velocity);
            motion.velocity = quotient(numerator, denominator).value() * parity;
        }
        motion
    }

    #[inline(always)]
    fn rotation<W: Wanted, L: Lane>(&self, t: L) -> Canonical<L> {
        let Reduced { n, sign, f, .. } = self.phase.reduce(t);
        let thetas = self.lattice.thetas(within_count(n.hi + n.hi, f));
        let [t1, t2, t3, t4] = thetas.theta;
        let mut motion = Canonical { turns: n.hi, ..Canonical::at(sign) };
        if W::ANGLE {
            [motion.opposite, motion.adjacent] =
                Self::ratio(thetas.folded, [t1, t2], [t2, t1], &self.tangent);
        }
        if W::VELOCITY {
            let [numerator, denominator] = Self::ratio(thetas.folded, [t3, t4], [t4, t3], &self.velocity);
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

#[inline(always)]
fn separatrix<W: Wanted, L: Lane>(phase: &Phase, speed: Dd, t: L) -> Canonical<L> {
    let (passed, error) = t.two_product(L::splat(phase.rate.hi));
    let error = t.mul_add(L::splat(phase.rate.lo), error);
    let near = passed.abs().less(L::splat(FAR));
    let far = L::select(t.equal(t), L::splat(FAR).copysign(passed), t);
    let passed = L::select(near, passed, far);
    let error = L::select(near, error, L::splat(0.0));
    let (y, rest) = two_sum(passed, L::splat(phase.start.hi));
    let y = Dd::ordered_sum(y, rest + (error + L::splat(phase.start.lo)));
    let sign = L::splat(1.0).copysign(y.hi);
    let y = y.scale(sign);
    let mut motion = Canonical::at(sign);
    if W::ANGLE {
        motion.opposite = saturated_sinh_cosh(y).0;
    }
    if W::VELOCITY {
        let (factor, power) = sech(y);
        motion.velocity = (factor * Dd::splat(speed)).value() * power;
    }
    motion
}

impl Orbit {
    /// The angle in the frame of the orbit, and the velocity.
    #[inline(always)]
    fn framed<W: Wanted, L: Lane>(&self, t: L) -> (Angle<L>, L) {
        let scaled = t * L::splat(self.time_scale);
        let motion = match &self.course {
            Course::Libration(elliptic) => elliptic.libration::<W, L>(scaled),
            Course::Rotation(elliptic) => elliptic.rotation::<W, L>(scaled),
            Course::Separatrix(phase, speed) => separatrix::<W, L>(phase, *speed, scaled),
            Course::Still | Course::Free => return self.straight(t),
        };
        let side = L::splat(self.frame.side);
        let (turns, sign) = (motion.turns * side, motion.sign * side);
        let velocity = motion.velocity * L::splat(self.velocity_scale);
        let two = L::splat(2.0);
        let angle = if self.frame.half_turn == 0.0 {
            Angle { turns, local: arctangent(motion.opposite, motion.adjacent).scale(sign * two) }
        } else {
            // Seen from the other equilibrium, half a turn on: whole turns again, and its own small angles.
            let turns = turns + (sign + L::splat(self.frame.half_turn)) * L::splat(0.5);
            Angle { turns, local: arctangent(motion.adjacent, motion.opposite).scale(-sign * two) }
        };
        (angle, velocity)
    }

    /// No force that counts: theta0 + velocity0 t.
    #[inline(always)]
    fn straight<L: Lane>(&self, t: L) -> (Angle<L>, L) {
        let zero = L::splat(0.0);
        let nothing = L::select(t.equal(t), zero, t);
        let local = if matches!(self.course, Course::Still) {
            Dd::from_double(nothing)
        } else {
            let (passed, error) = t.two_product(L::splat(self.velocity0));
            Dd::new(passed, error)
        };
        (Angle { turns: zero, local }, nothing + L::splat(self.velocity0))
    }

    #[inline(always)]
    fn sample<W: Wanted, L: Lane>(&self, t: L) -> (L, L) {
        let (angle, velocity) = self.framed::<W, L>(t);
        let turned = Dd::splat(TWO_PI) * angle.turns;
        let theta = (Dd::splat(self.frame.base) + turned + angle.local).value();
        // The start is returned as it was given.
        let start = t.equal(L::splat(0.0));
        (L::select(start, L::splat(self.theta0), theta), L::select(start, L::splat(self.velocity0), velocity))
    }

    /// Angle at t (in s), continuous through the turns.
    ///
    /// NaN for times that are not finite (but for the separatrix: its limits) or more than 2^53 half periods
    /// away. **Error** at most 4 ulp of max(|theta|, 2^-30 of the largest), plus 2^-100 of the condition.
    pub fn theta(&self, t: f64) -> f64 {
        struct Theta<'a>(&'a Orbit, f64);
        impl Kernel for Theta<'_> {
            type Output = f64;
            #[inline(always)]
            fn run<L: Scalar>(self) -> f64 {
                self.0.sample::<AngleOnly, L>(L::splat(self.1)).0.into()
            }
        }
        dispatch(Theta(self, t))
    }

    /// Angular velocity at t; domain and error as for [`Orbit::theta`].
    pub fn velocity(&self, t: f64) -> f64 {
        struct Velocity<'a>(&'a Orbit, f64);
        impl Kernel for Velocity<'_> {
            type Output = f64;
            #[inline(always)]
            fn run<L: Scalar>(self) -> f64 {
                self.0.sample::<VelocityOnly, L>(L::splat(self.1)).1.into()
            }
        }
        dispatch(Velocity(self, t))
    }

    /// Angle and angular velocity at t, bit for bit those of [`Orbit::theta`] and [`Orbit::velocity`].
    pub fn motion(&self, t: f64) -> (f64, f64) {
        struct Motion<'a>(&'a Orbit, f64);
        impl Kernel for Motion<'_> {
            type Output = (f64, f64);
            #[inline(always)]
            fn run<L: Scalar>(self) -> (f64, f64) {
                let (theta, velocity) = self.0.sample::<Both, L>(L::splat(self.1));
                (theta.into(), velocity.into())
            }
        }
        dispatch(Motion(self, t))
    }

    /// Whole turns n and the angle in [-pi, pi) with theta = 2 pi n + angle.
    ///
    /// Where theta is NaN the angle is NaN and n is 0; n stays within the range of its type.
    pub fn turns(&self, t: f64) -> (i64, f64) {
        struct Turns<'a>(&'a Orbit, f64);
        impl Kernel for Turns<'_> {
            type Output = (f64, Dd);
            #[inline(always)]
            fn run<L: Scalar>(self) -> (f64, Dd) {
                let Angle { turns, local } = self.0.framed::<AngleOnly, L>(L::splat(self.1)).0;
                (turns.into(), Dd::new(local.hi.into(), local.lo.into()))
            }
        }
        let (turns, local) = dispatch(Turns(self, t));
        self.wrapped(turns, local)
    }
    fn wrapped(&self, turns: f64, local: Dd) -> (i64, f64) {
        if local.hi.is_nan() {
            return (0, f64::NAN);
        }
        let (n, angle) = match self.course {
            Course::Still | Course::Free => {
                // Far out the second word has turns of its own.
                let total = self.frame.base + local;
                let [hi, lo] = [total.hi, total.lo].map(circle::reduce);
                let rest = (hi.from_bottom * hi.side + lo.from_bottom * lo.side).to_dd();
                let shift = (rest.hi / TWO_PI.hi).round();
                (hi.turns + lo.turns + shift, rest - TWO_PI * shift)
            }
            _ => (self.frame.turns + turns, local),
        };
        // The half-open interval in doubles: its upper end is the lower end one turn on.
        match angle.value() {
            value if value >= PI.hi => (n as i64 + 1, (angle - TWO_PI).value().max(-PI.hi)),
            value if value < -PI.hi => (n as i64 - 1, (angle + TWO_PI).value()),
            value => (n as i64, value),
        }
    }
}

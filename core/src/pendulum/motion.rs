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
use crate::lanes::{Kernel, Lane, Sampler, single, sweep, wide};
use core::marker::PhantomData;

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

/// A formula for the canonical motion.
trait Path {
    /// Whether it makes whole turns.
    const TURNS: bool;
    fn at<W: Wanted, L: Lane>(&self, t: L) -> Canonical<L>;
}

/// Libration, on the circular or the hyperbolic side of the theta functions.
struct Swing<'a, const HYPERBOLIC: bool>(&'a Elliptic);

/// Rotation, likewise.
struct Spin<'a, const HYPERBOLIC: bool>(&'a Elliptic);

/// The separatrix: hyperbolic phase, and twice omega0.
struct Ridge<'a>(&'a Phase, Dd);

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
        let Swing(Elliptic { lattice, phase, tangent, velocity }) = self;
        let Reduced { n, sign, f, parity } = phase.reduce(t);
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

impl<const HYPERBOLIC: bool> Path for Spin<'_, HYPERBOLIC> {
    const TURNS: bool = true;
    #[inline(always)]
    fn at<W: Wanted, L: Lane>(&self, t: L) -> Canonical<L> {
        let Spin(Elliptic { lattice, phase, tangent, velocity }) = self;
        let Reduced { n, sign, f, .. } = phase.reduce(t);
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

/// An orbit on its path, wanted in part: the samplers that fill slices.
struct Along<'a, P, W>(&'a Orbit, P, PhantomData<W>);

impl<P: Path, W: Wanted> Along<'_, P, W> {
    /// The angle in the frame of the orbit, and the velocity.
    #[inline(always)]
    fn framed<L: Lane>(&self, t: L) -> (Angle<L>, L) {
        let Along(orbit, path, _) = self;
        let frame = &orbit.frame;
        let motion = path.at::<W, L>(t * L::splat(orbit.time_scale));
        let side = L::splat(frame.side);
        let (turns, sign) = (motion.turns * side, motion.sign * side);
        let velocity = motion.velocity * L::splat(orbit.velocity_scale);
        let two = L::splat(2.0);
        if !W::ANGLE {
            return (Angle { turns, local: motion.opposite }, velocity);
        }
        let angle = if frame.half_turn == 0.0 {
            Angle { turns, local: arctangent(motion.opposite, motion.adjacent).scale(sign * two) }
        } else {
            // Seen from the other equilibrium, half a turn on: whole turns again, and its own small angles.
            let turns = turns + (sign + L::splat(frame.half_turn)) * L::splat(0.5);
            Angle { turns, local: arctangent(motion.adjacent, motion.opposite).scale(-sign * two) }
        };
        (angle, velocity)
    }

    #[inline(always)]
    fn sample<L: Lane>(&self, t: L) -> (L, L) {
        let orbit = self.0;
        let (angle, velocity) = self.framed(t);
        let theta = if P::TURNS || orbit.frame.shifted() {
            let turned = Dd::splat(TWO_PI) * angle.turns;
            (Dd::splat(orbit.frame.base) + turned + angle.local).value()
        } else {
            angle.local.value()
        };
        // The start is returned as it was given.
        let start = t.equal(L::splat(0.0));
        (
            L::select(start, L::splat(orbit.theta0), theta),
            L::select(start, L::splat(orbit.velocity0), velocity),
        )
    }
}

impl<P: Path> Sampler<1> for Along<'_, P, AngleOnly> {
    #[inline(always)]
    fn at<L: Lane>(&self, t: L) -> [L; 1] {
        [self.sample(t).0]
    }
}

impl<P: Path> Sampler<1> for Along<'_, P, VelocityOnly> {
    #[inline(always)]
    fn at<L: Lane>(&self, t: L) -> [L; 1] {
        [self.sample(t).1]
    }
}

impl<P: Path> Sampler<2> for Along<'_, P, Both> {
    #[inline(always)]
    fn at<L: Lane>(&self, t: L) -> [L; 2] {
        self.sample(t).into()
    }
}

/// No force that counts: theta0 + velocity0 t.
struct Straight<'a, W>(&'a Orbit, PhantomData<W>);

impl<W> Straight<'_, W> {
    /// What is added to theta0, and the velocity.
    #[inline(always)]
    fn passed<L: Lane>(&self, t: L) -> (Dd<L>, L) {
        let orbit = self.0;
        let zero = L::splat(0.0);
        if matches!(orbit.course, Course::Still) {
            let nothing = L::select(t.equal(t), zero, t);
            return (Dd::from_double(nothing), nothing + L::splat(orbit.velocity0));
        }
        // Zero, and NaN for times that are not finite.
        let nothing = t * zero;
        let (passed, error) = t.two_product(L::splat(orbit.velocity0));
        (Dd::new(passed + nothing, error), nothing + L::splat(orbit.velocity0))
    }

    #[inline(always)]
    fn sample<L: Lane>(&self, t: L) -> (L, L) {
        let (local, velocity) = self.passed(t);
        ((Dd::splat(self.0.frame.base) + local).value(), velocity)
    }
}

impl Sampler<1> for Straight<'_, AngleOnly> {
    #[inline(always)]
    fn at<L: Lane>(&self, t: L) -> [L; 1] {
        [self.sample(t).0]
    }
}

impl Sampler<1> for Straight<'_, VelocityOnly> {
    #[inline(always)]
    fn at<L: Lane>(&self, t: L) -> [L; 1] {
        [self.sample(t).1]
    }
}

impl Sampler<2> for Straight<'_, Both> {
    #[inline(always)]
    fn at<L: Lane>(&self, t: L) -> [L; 2] {
        self.sample(t).into()
    }
}

/// Times into slices of results, each of the length of the times.
struct Fill<'a, 'b, W, const N: usize> {
    orbit: &'a Orbit,
    t: &'a [f64],
    results: [&'b mut [f64]; N],
    wanted: PhantomData<W>,
}

macro_rules! fill {
    ($wanted:ty, $count:literal) => {
        impl Kernel for Fill<'_, '_, $wanted, $count> {
            type Output = ();
            #[inline(always)]
            fn run<L: Lane>(mut self) {
                let (orbit, t, results) = (self.orbit, self.t, &mut self.results);
                const W: PhantomData<$wanted> = PhantomData;
                match &orbit.course {
                    Course::Libration(e) if e.lattice.hyperbolic() => {
                        sweep::<L, $count>(&Along(orbit, Swing::<true>(e), W), t, results);
                    }
                    Course::Libration(e) => {
                        sweep::<L, $count>(&Along(orbit, Swing::<false>(e), W), t, results)
                    }
                    Course::Rotation(e) if e.lattice.hyperbolic() => {
                        sweep::<L, $count>(&Along(orbit, Spin::<true>(e), W), t, results);
                    }
                    Course::Rotation(e) => sweep::<L, $count>(&Along(orbit, Spin::<false>(e), W), t, results),
                    Course::Separatrix(phase, speed) => {
                        sweep::<L, $count>(&Along(orbit, Ridge(phase, *speed), W), t, results);
                    }
                    Course::Still | Course::Free => sweep::<L, $count>(&Straight(orbit, W), t, results),
                }
            }
        }
    };
}
fill!(AngleOnly, 1);
fill!(VelocityOnly, 1);
fill!(Both, 2);

impl Orbit {
    fn fill<'a, 'b, W, const N: usize>(
        &'a self,
        t: &'a [f64],
        results: [&'b mut [f64]; N],
    ) -> Fill<'a, 'b, W, N> {
        assert!(
            results.iter().all(|result| result.len() == t.len()),
            "results of another length than the times"
        );
        Fill { orbit: self, t, results, wanted: PhantomData }
    }

    /// Angle at t (in s), continuous through the turns.
    ///
    /// NaN for times that are not finite (but for the separatrix: its limits) or more than 2^53 half periods
    /// away. **Error** at most 4 ulp of max(|theta|, 2^-30 of the largest), plus 2^-100 of the condition.
    pub fn theta(&self, t: f64) -> f64 {
        let mut theta = [0.0];
        single(self.fill::<AngleOnly, 1>(&[t], [&mut theta]));
        theta[0]
    }

    /// Angular velocity at t; domain and error as for [`Orbit::theta`].
    pub fn velocity(&self, t: f64) -> f64 {
        let mut velocity = [0.0];
        single(self.fill::<VelocityOnly, 1>(&[t], [&mut velocity]));
        velocity[0]
    }

    /// Angle and angular velocity at t, bit for bit those of [`Orbit::theta`] and [`Orbit::velocity`].
    pub fn motion(&self, t: f64) -> (f64, f64) {
        let (mut theta, mut velocity) = ([0.0], [0.0]);
        single(self.fill::<Both, 2>(&[t], [&mut theta, &mut velocity]));
        (theta[0], velocity[0])
    }

    /// [`Orbit::theta`] of every time, bit for bit, on the widest lanes; panics where the lengths differ.
    pub fn theta_into(&self, t: &[f64], theta: &mut [f64]) {
        wide(self.fill::<AngleOnly, 1>(t, [theta]));
    }

    /// [`Orbit::velocity`] of every time, bit for bit, on the widest lanes; panics where the lengths differ.
    pub fn velocity_into(&self, t: &[f64], velocity: &mut [f64]) {
        wide(self.fill::<VelocityOnly, 1>(t, [velocity]));
    }

    /// [`Orbit::motion`] of every time, bit for bit, on the widest lanes; panics where the lengths differ.
    pub fn motion_into(&self, t: &[f64], theta: &mut [f64], velocity: &mut [f64]) {
        wide(self.fill::<Both, 2>(t, [theta, velocity]));
    }

    /// Whole turns n and the angle in [-pi, pi) with theta = 2 pi n + angle.
    ///
    /// The bounds are those of doubles: pi rounded to a double is given as minus itself, one turn on. Where theta is
    /// NaN the angle is NaN and n is 0; n stays within the range of its type.
    pub fn turns(&self, t: f64) -> (i64, f64) {
        struct Turns<'a>(&'a Orbit, f64);
        impl Kernel for Turns<'_> {
            type Output = (f64, Dd);
            #[inline(always)]
            fn run<L: Lane>(self) -> (f64, Dd) {
                let Turns(orbit, t) = self;
                let t = L::splat(t);
                const W: PhantomData<AngleOnly> = PhantomData;
                let Angle { turns, local } = match &orbit.course {
                    Course::Libration(e) if e.lattice.hyperbolic() => {
                        Along(orbit, Swing::<true>(e), W).framed(t).0
                    }
                    Course::Libration(e) => Along(orbit, Swing::<false>(e), W).framed(t).0,
                    Course::Rotation(e) if e.lattice.hyperbolic() => {
                        Along(orbit, Spin::<true>(e), W).framed(t).0
                    }
                    Course::Rotation(e) => Along(orbit, Spin::<false>(e), W).framed(t).0,
                    Course::Separatrix(phase, speed) => Along(orbit, Ridge(phase, *speed), W).framed(t).0,
                    Course::Still | Course::Free => {
                        Angle { turns: L::splat(0.0), local: Straight(orbit, W).passed(t).0 }
                    }
                };
                (turns.first(), Dd::new(local.hi.first(), local.lo.first()))
            }
        }
        let (turns, local) = single(Turns(self, t));
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

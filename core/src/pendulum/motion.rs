//! Angle and velocity of an orbit at any time, over lanes: the canonical motion (canonical.rs) in the frame of the
//! orbit, its side, turns and start.

use super::interpolant::OrbitInterpolant;
use super::orbit::{Course, Orbit};
use super::theta_quotients::{AngleOnly, Both, Path, Ridge, Spin, Sway, Swing, VelocityOnly, Wanted};
use crate::float::elementary::arctangent;
use crate::float::{Dd, PI, TWO_PI, angle_reduction};
use crate::lanes::{Formula, Kernel, Lane, single, tabulate};
use core::marker::PhantomData;

/// An angle 2 pi (frame.turns + turns) + local, with local in [-pi, pi].
struct Angle<L: Lane> {
    turns: L,
    local: Dd<L>,
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
        let angle = if P::DIRECT {
            Angle { turns, local: motion.opposite.scale(sign) }
        } else if frame.half_turn == 0.0 {
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
        let turned = if P::TURNS || orbit.frame.shifted() {
            (Dd::splat(TWO_PI) * angle.turns).plain_sum(angle.local)
        } else {
            angle.local
        };
        let theta = if orbit.frame.base.hi == 0.0 {
            turned.value()
        } else {
            Dd::splat(orbit.frame.base).plain_sum(turned).value()
        };
        // The start is returned as it was given.
        let start = t.equal(L::splat(0.0));
        (
            L::select(start, L::splat(orbit.theta0), theta),
            L::select(start, L::splat(orbit.velocity0), velocity),
        )
    }
}

impl<P: Path, W: Wanted> Formula<1, 2> for Along<'_, P, W> {
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let (theta, velocity) = self.sample(t);
        W::first(theta, velocity)
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

impl<W: Wanted> Formula<1, 2> for Straight<'_, W> {
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let (theta, velocity) = self.sample(t);
        W::first(theta, velocity)
    }
}

/// Times into slices of the R results wanted, each of the length of the times.
struct Fill<'a, 'b, W, const R: usize> {
    orbit: &'a Orbit,
    t: &'a [f64],
    results: [&'b mut [f64]; R],
    wanted: PhantomData<W>,
}

/// Evaluates `$do` with the path of the orbit's course, or `$straight` without one: one compilation for each.
macro_rules! on_path {
    ($orbit:expr, $path:ident => $do:expr, straight => $straight:expr) => {
        match &$orbit.course {
            Course::Libration(e) => match (e.layout, e.lattice.hyperbolic()) {
                (Some(layout), _) => on_path!(layout, e, false, $path => $do),
                (None, true) => on_path!(@ $path, Swing::<true>(e), $do),
                (None, false) => on_path!(@ $path, Swing::<false>(e), $do),
            },
            Course::Rotation(e) => match (e.layout, e.lattice.hyperbolic()) {
                (Some(layout), _) => on_path!(layout, e, true, $path => $do),
                (None, true) => on_path!(@ $path, Spin::<true>(e), $do),
                (None, false) => on_path!(@ $path, Spin::<false>(e), $do),
            },
            Course::Separatrix(phase, speed) => on_path!(@ $path, Ridge(phase, *speed), $do),
            Course::Still | Course::Free => $straight,
        }
    };
    ($layout:ident, $elliptic:ident, $rotation:literal, $path:ident => $do:expr) => {{
        let arc = $elliptic.arc.get_or_init(|| OrbitInterpolant::new::<$rotation>($elliptic, $layout));
        on_path!(@ $path, Sway::<$rotation>($elliptic, arc), $do)
    }};
    (@ $path:ident, $formula:expr, $do:expr) => {{
        let $path = $formula;
        $do
    }};
}

impl<W: Wanted, const R: usize> Fill<'_, '_, W, R> {
    fn run<const WIDE: bool>(mut self) {
        let (orbit, t, results, wanted) = (self.orbit, [self.t], &mut self.results, self.wanted);
        on_path!(orbit,
            path => tabulate::<WIDE, _, _, _, _>(&Along(orbit, path, wanted), t, results),
            straight => tabulate::<WIDE, _, _, _, _>(&Straight(orbit, wanted), t, results)
        )
    }
}

impl Orbit {
    fn fill<'a, 'b, W, const R: usize>(
        &'a self,
        t: &'a [f64],
        results: [&'b mut [f64]; R],
    ) -> Fill<'a, 'b, W, R> {
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
        self.fill::<AngleOnly, 1>(&[t], [&mut theta]).run::<false>();
        theta[0]
    }

    /// Angular velocity at t; domain and error as for [`Orbit::theta`].
    pub fn velocity(&self, t: f64) -> f64 {
        let mut velocity = [0.0];
        self.fill::<VelocityOnly, 1>(&[t], [&mut velocity]).run::<false>();
        velocity[0]
    }

    /// Angle and angular velocity at t, bit for bit those of [`Orbit::theta`] and [`Orbit::velocity`].
    pub fn motion(&self, t: f64) -> (f64, f64) {
        let (mut theta, mut velocity) = ([0.0], [0.0]);
        self.fill::<Both, 2>(&[t], [&mut theta, &mut velocity]).run::<false>();
        (theta[0], velocity[0])
    }

    /// [`Orbit::theta`] of every time, bit for bit, on the widest lanes; panics where the lengths differ.
    pub fn theta_into(&self, t: &[f64], theta: &mut [f64]) {
        self.fill::<AngleOnly, 1>(t, [theta]).run::<true>();
    }

    /// [`Orbit::velocity`] of every time, bit for bit, on the widest lanes; panics where the lengths differ.
    pub fn velocity_into(&self, t: &[f64], velocity: &mut [f64]) {
        self.fill::<VelocityOnly, 1>(t, [velocity]).run::<true>();
    }

    /// [`Orbit::motion`] of every time, bit for bit, on the widest lanes; panics where the lengths differ.
    pub fn motion_into(&self, t: &[f64], theta: &mut [f64], velocity: &mut [f64]) {
        self.fill::<Both, 2>(t, [theta, velocity]).run::<true>();
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
                let Angle { turns, local } = on_path!(orbit,
                    path => Along(orbit, path, W).framed(t).0,
                    straight => Angle { turns: L::splat(0.0), local: Straight(orbit, W).passed(t).0 }
                );
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
                let [hi, lo] = [total.hi, total.lo].map(angle_reduction::reduce);
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

//! Angle and velocity of an orbit at any time: the canonical motion (canonical.rs) in the frame of the orbit.
//!
//! The formula is chosen once, outside of the kernels. It is compiled for the angle, for the velocity and for both.

use super::canonical::{Canonical, CanonicalMotion, RESULTS};
use super::force_free::{AtEquilibrium, ForceFree};
use super::interpolant::{ByInterpolant, ByPieces};
use super::orbit::{Orbit, Solution};
use super::theta_quotients::{ByThetaFunctions, Elliptic};
use crate::float::elementary::arctangent;
use crate::float::{Dd, TWO_PI};
use crate::lanes::{BETWEEN, COMPACT, Columns, Evaluation, Formula, Lane, Once, Second};

/// A canonical motion in the frame of an orbit, asked for the angle, the velocity, or both.
struct InFrame<'a, M, const ANGLE: bool, const VELOCITY: bool>(&'a Orbit, M);

impl<M: CanonicalMotion, const ANGLE: bool, const VELOCITY: bool> Formula<1, RESULTS>
    for InFrame<'_, M, ANGLE, VELOCITY>
{
    type Place = M;
    const STEPS: bool = M::STEPS;
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; RESULTS] {
        let InFrame(orbit, motion) = self;
        let canonical = motion.at::<ANGLE, VELOCITY, L>(t * L::splat(orbit.time_scale));
        orbit.in_frame::<M, ANGLE, L>(t, canonical)
    }
    #[inline(always)]
    fn begun<L: Lane>(&self, [t]: [L; 1]) -> [L; BETWEEN] {
        let InFrame(orbit, motion) = self;
        motion.begun(t * L::splat(orbit.time_scale))
    }
    #[inline(always)]
    fn ended<L: Lane>(&self, [t]: [L; 1], between: [L; BETWEEN]) -> [L; RESULTS] {
        let InFrame(orbit, motion) = self;
        let canonical = motion.ended::<ANGLE, VELOCITY, L>(t * L::splat(orbit.time_scale), between);
        orbit.in_frame::<M, ANGLE, L>(t, canonical)
    }
}

impl Orbit {
    /// A canonical motion at t in the frame.
    #[inline(always)]
    pub(super) fn in_frame<M: CanonicalMotion, const ANGLE: bool, L: Lane>(
        &self,
        t: L,
        canonical: Canonical<L>,
    ) -> [L; RESULTS] {
        let orbit = self;
        let frame = &orbit.frame;
        // The start is returned as it was given.
        let start = t.equal(L::splat(0.0));
        let velocity_scale = if M::DIRECTED { orbit.velocity_scale.abs() } else { orbit.velocity_scale };
        let velocity = canonical.velocity * L::splat(velocity_scale);
        let velocity = L::select(start, L::splat(orbit.velocity0), velocity);
        if !ANGLE {
            return [velocity; RESULTS];
        }
        let (side, two) = (L::splat(frame.side), L::splat(2.0));
        let (turns, sign) = (canonical.turns * side, canonical.sign * side);
        let (turns, local) = if M::DIRECTED {
            (turns, canonical.opposite)
        } else if M::DIRECT {
            (turns, canonical.opposite.scale(sign))
        } else if frame.half_turn == 0.0 {
            (turns, arctangent(canonical.opposite, canonical.adjacent).scale(sign * two))
        } else {
            // Seen from the other equilibrium, half a turn on: whole turns again, and its own small angles.
            let turns = turns + (sign + L::splat(frame.half_turn)) * L::splat(0.5);
            (turns, arctangent(canonical.adjacent, canonical.opposite).scale(-sign * two))
        };
        let turned = if M::TURNS || frame.shifted() {
            Dd::splat(TWO_PI).times_in_range(turns).plain_sum(local)
        } else {
            local
        };
        let theta = if frame.base.hi == 0.0 {
            turned.value()
        } else {
            Dd::splat(frame.base).plain_sum(turned).value()
        };
        let theta = L::select(start, L::splat(orbit.theta0), theta);
        [theta, velocity, turns, local.hi, local.lo]
    }

    /// The angle at t as whole turns from those of the frame, and a rest; without a force no turns are taken out.
    pub(super) fn turned(&self, t: f64) -> (f64, Dd) {
        let [_, _, turns, hi, lo] = self.evaluated::<true, false, _>(Once([t]));
        (turns, Dd::new(hi, lo))
    }

    /// The answer of the formula of this orbit, asked for the angle, the velocity, or both.
    fn evaluated<const ANGLE: bool, const VELOCITY: bool, E: Evaluation<1, RESULTS>>(
        &self,
        evaluation: E,
    ) -> E::Output {
        match &self.solution {
            Solution::Equilibrium => evaluation.of(&AtEquilibrium(self)),
            Solution::ForceFree => evaluation.of(&ForceFree(self)),
            Solution::Libration(elliptic) => self.elliptic::<false, ANGLE, VELOCITY, E>(elliptic, evaluation),
            Solution::Rotation(elliptic) => self.elliptic::<true, ANGLE, VELOCITY, E>(elliptic, evaluation),
            Solution::Separatrix(separatrix) => self.framed::<ANGLE, VELOCITY, _, E>(separatrix, evaluation),
        }
    }

    fn elliptic<const ROTATION: bool, const ANGLE: bool, const VELOCITY: bool, E: Evaluation<1, RESULTS>>(
        &self,
        elliptic: &Elliptic,
        evaluation: E,
    ) -> E::Output {
        // On a page columns.rs has the motion by polynomials, of single times too.
        let polynomials = if COMPACT { None } else { self.polynomials::<ROTATION>(elliptic) };
        if let Some(interpolant) = polynomials {
            self.framed::<ANGLE, VELOCITY, _, E>(
                ByInterpolant::<ROTATION>(elliptic, interpolant, self.frame.side),
                evaluation,
            )
        } else if !COMPACT && let Some(pieces) = self.pieces::<ROTATION>(elliptic) {
            self.framed::<ANGLE, VELOCITY, _, E>(ByPieces::<ROTATION>(elliptic, pieces), evaluation)
        } else if elliptic.lattice.by_hyperbolic() {
            self.framed::<ANGLE, VELOCITY, _, E>(ByThetaFunctions::<ROTATION, true>(elliptic), evaluation)
        } else {
            self.framed::<ANGLE, VELOCITY, _, E>(ByThetaFunctions::<ROTATION, false>(elliptic), evaluation)
        }
    }

    fn framed<const ANGLE: bool, const VELOCITY: bool, M: CanonicalMotion, E: Evaluation<1, RESULTS>>(
        &self,
        motion: M,
        evaluation: E,
    ) -> E::Output {
        if COMPACT && !M::DIRECT {
            return evaluation.of(&InFrame::<M, true, true>(self, motion));
        }
        evaluation.of(&InFrame::<M, ANGLE, VELOCITY>(self, motion))
    }

    /// Angle at t (in s), continuous through the turns.
    ///
    /// NaN for times that are not finite (but for the separatrix: its limits; and at rest: the start) or more than 2^53
    /// half periods away; infinite where the angle is beyond the doubles. **Error** at most 4 ulp of
    /// max(|theta|, 2^-30 of the largest), plus 2^-100 of the condition. Source: Salas 2019 (23); DLMF 22.19.2, 22.19.3.
    ///
    /// ```
    /// use libration::{Frequency, Orbit};
    /// let orbit = Orbit::new(2.0, 0.0, Frequency::from_omega0(1.0)?)?;
    /// assert_eq!(format!("{:.9}", orbit.theta(1.0)), "1.532727506");
    /// # Ok::<(), libration::Domain>(())
    /// ```
    #[must_use]
    pub fn theta(&self, t: f64) -> f64 {
        if COMPACT {
            return self.motion_of_page(t).0;
        }
        self.evaluated::<true, false, _>(Once([t]))[0]
    }

    /// Angular velocity at t; domain and error as for [`Orbit::theta`].
    ///
    /// Source: derivative of DLMF 22.19.2, 22.19.3 by 22.13.2, 22.16.3.
    ///
    /// ```
    /// use libration::{Frequency, Orbit};
    /// let orbit = Orbit::new(2.0, 0.0, Frequency::from_omega0(1.0)?)?;
    /// assert_eq!(format!("{:.9}", orbit.velocity(1.0)), "-0.953106985");
    /// # Ok::<(), libration::Domain>(())
    /// ```
    #[must_use]
    pub fn velocity(&self, t: f64) -> f64 {
        if COMPACT {
            return self.motion_of_page(t).1;
        }
        self.evaluated::<false, true, _>(Once([t]))[1]
    }

    /// Angle and angular velocity at t, bit for bit those of [`Orbit::theta`] and [`Orbit::velocity`].
    ///
    /// ```
    /// use libration::{Frequency, Orbit};
    /// let orbit = Orbit::new(2.0, 0.0, Frequency::from_omega0(1.0)?)?;
    /// let (theta, velocity) = orbit.motion(1.0);
    /// assert_eq!(format!("{theta:.9} {velocity:.9}"), "1.532727506 -0.953106985");
    /// # Ok::<(), libration::Domain>(())
    /// ```
    #[must_use]
    pub fn motion(&self, t: f64) -> (f64, f64) {
        if COMPACT {
            return self.motion_of_page(t);
        }
        self.far_motion(t)
    }

    /// Both by the formula of one time.
    pub(super) fn far_motion(&self, t: f64) -> (f64, f64) {
        let [theta, velocity, ..] = self.evaluated::<true, true, _>(Once([t]));
        (theta, velocity)
    }

    /// Both by columns of one row, where there are any.
    fn motion_of_page(&self, t: f64) -> (f64, f64) {
        let (mut theta, mut velocity) = ([0.0], [0.0]);
        if self.in_blocks(&[t], &mut theta, Some(&mut velocity)) {
            return (theta[0], velocity[0]);
        }
        self.far_motion(t)
    }

    /// [`Orbit::theta`] of every time, bit for bit, on the widest lanes; panics where the lengths differ.
    pub fn theta_into(&self, t: &[f64], theta: &mut [f64]) {
        if COMPACT {
            if !self.in_blocks(t, theta, None) {
                t.iter().zip(theta).for_each(|(t, theta)| *theta = self.theta(*t));
            }
            return;
        }
        self.evaluated::<true, false, _>(Columns::new([t], [theta]));
    }

    /// [`Orbit::velocity`] of every time, bit for bit, on the widest lanes; panics where the lengths differ.
    pub fn velocity_into(&self, t: &[f64], velocity: &mut [f64]) {
        self.evaluated::<false, true, _>(Second(Columns::new([t], [velocity])));
    }

    /// [`Orbit::motion`] of every time, bit for bit, on the widest lanes; panics where the lengths differ.
    pub fn motion_into(&self, t: &[f64], theta: &mut [f64], velocity: &mut [f64]) {
        if COMPACT {
            if !self.in_blocks(t, theta, Some(velocity)) {
                let rows = t.iter().zip(theta).zip(velocity);
                rows.for_each(|((t, theta), velocity)| (*theta, *velocity) = self.motion(*t));
            }
            return;
        }
        self.evaluated::<true, true, _>(Columns::new([t], [theta, velocity]));
    }
}

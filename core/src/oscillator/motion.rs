//! u and u' of an orbit at any time: the formula is chosen here, outside of its kernel.

use super::cubic_quintic::CubicQuintic;
use super::pq_elementary::Line;
use super::pq_quotient::{BoundedFormula, EscapeFormula};
use super::root_quotient::RootFormula;
use super::set_up::{ElementaryLanes, Solution};
use super::theta_motion::{Quotient, ThetaMotion};
use crate::lanes::{Columns, Evaluation, Formula, Lane, Once, Second, WIDEST};
use crate::motion::bounded::BoundedByInterpolant;
use crate::motion::escape::EscapeByInterpolant;
use crate::motion::samples::{FromStart, InterpolantKind};

/// A motion that lanes do not serve: one sample after the other.
struct OneByOne<F>(F);

impl<F: Fn(f64) -> (f64, f64)> Formula<1, 2> for OneByOne<F> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let (mut u, mut velocity) = ([0.0; WIDEST], [0.0; WIDEST]);
        t.store(&mut u);
        for i in 0..L::WIDTH {
            (u[i], velocity[i]) = (self.0)(u[i]);
        }
        [L::load(&u), L::load(&velocity)]
    }
}

impl CubicQuintic {
    /// The evaluation of the formula that serves this orbit.
    fn evaluate<E: Evaluation<1, 2>>(&self, evaluation: E) -> E::Output {
        match &self.set_up.solution {
            Solution::Equilibrium => self.line(evaluation, false),
            Solution::Line(_) => self.line(evaluation, true),
            Solution::Theta(motion) => match &motion.scaled {
                Some(scaled) => self.started(evaluation, OneByOne(|t| scaled.at(t))),
                None => self.theta(motion, evaluation),
            },
            Solution::Elementary(given, None) => self.started(evaluation, OneByOne(|t| given.at(t))),
            Solution::Elementary(_, Some(lanes)) => match &**lanes {
                ElementaryLanes::Pq(formula) => self.started(evaluation, formula),
                ElementaryLanes::Hyperbolic(formula) => self.started(evaluation, formula),
            },
        }
    }

    fn started<E: Evaluation<1, 2>>(&self, evaluation: E, formula: impl Formula<1, 2>) -> E::Output {
        evaluation.of(&FromStart { formula, start: [self.u0, self.velocity0] })
    }

    fn line<E: Evaluation<1, 2>>(&self, evaluation: E, moves: bool) -> E::Output {
        evaluation.of(&Line { u0: self.u0, velocity0: self.velocity0, moves })
    }

    fn theta<E: Evaluation<1, 2>>(&self, motion: &ThetaMotion, evaluation: E) -> E::Output {
        let kind = &motion.interpolant.kind;
        let hyperbolic = motion.neville.hyperbolic();
        let (clock, neville) = (&motion.clock, &motion.neville);
        match (motion.interpolant(), kind, &motion.quotient) {
            (Some(interpolant), InterpolantKind::Bounded(bounded), _) => {
                self.started(evaluation, BoundedByInterpolant(bounded, interpolant))
            }
            (Some(interpolant), InterpolantKind::Escape(escape), _) => {
                self.started(evaluation, EscapeByInterpolant(escape, interpolant))
            }
            (_, InterpolantKind::Bounded(_), Quotient::Pq(quotient)) => {
                if hyperbolic {
                    self.started(evaluation, BoundedFormula::<true> { clock, neville, quotient })
                } else {
                    self.started(evaluation, BoundedFormula::<false> { clock, neville, quotient })
                }
            }
            (_, InterpolantKind::Escape(escape), Quotient::Pq(quotient)) => {
                if hyperbolic {
                    self.started(evaluation, EscapeFormula::<true> { escape, neville, quotient })
                } else {
                    self.started(evaluation, EscapeFormula::<false> { escape, neville, quotient })
                }
            }
            (_, _, Quotient::Root(quotient, _)) => {
                if hyperbolic {
                    self.started(evaluation, RootFormula::<true> { clock, neville, quotient })
                } else {
                    self.started(evaluation, RootFormula::<false> { clock, neville, quotient })
                }
            }
        }
    }

    /// u at t.
    ///
    /// | argument | domain |
    /// |---|---|
    /// | `t` | any; NaN at and beyond an escape, and more than 2^53 half periods away |
    ///
    /// Infinite times give the limit of the motion, or NaN where it has none.
    ///
    /// **Error** at most 4 ulp of the largest |u| of a bounded orbit, of max(|u|, |u0|) else, plus 2^-100 of the condition.
    /// **Source** v'^2 = 4 C(v) by Jacobi's functions: root_quotient.rs, pq_quotient.rs.
    ///
    /// ```
    /// let spring = libration::CubicQuintic::new(1.0, 0.0, 1.0, 1.0, 1.0)?;
    /// assert_eq!(format!("{:.9}", spring.u(1.0)), "0.041948934");
    /// # Ok::<(), libration::Domain>(())
    /// ```
    #[must_use]
    pub fn u(&self, t: f64) -> f64 {
        self.evaluate(Once([t]))[0]
    }

    /// u' at t; domain and error as for [`CubicQuintic::u`].
    #[must_use]
    pub fn velocity(&self, t: f64) -> f64 {
        self.evaluate(Once([t]))[1]
    }

    /// (u, u') at t, bit for bit those of [`CubicQuintic::u`] and [`CubicQuintic::velocity`].
    #[must_use]
    pub fn motion(&self, t: f64) -> (f64, f64) {
        self.evaluate(Once([t])).into()
    }

    /// [`CubicQuintic::u`] of every time, bit for bit, on the widest lanes.
    ///
    /// # Panics
    /// Where the lengths differ.
    pub fn u_into(&self, t: &[f64], u: &mut [f64]) {
        self.evaluate(Columns::new([t], [u]));
    }

    /// [`CubicQuintic::velocity`] of every time, bit for bit, on the widest lanes.
    ///
    /// # Panics
    /// Where the lengths differ.
    pub fn velocity_into(&self, t: &[f64], velocity: &mut [f64]) {
        self.evaluate(Second(Columns::new([t], [velocity])));
    }

    /// [`CubicQuintic::motion`] of every time, bit for bit, on the widest lanes.
    ///
    /// # Panics
    /// Where the lengths differ.
    pub fn motion_into(&self, t: &[f64], u: &mut [f64], velocity: &mut [f64]) {
        self.evaluate(Columns::new([t], [u, velocity]));
    }
}

//! u and u' of an orbit of the cubic-quintic oscillator at any time, over lanes where theta functions serve.

use super::cubic_quintic::CubicQuintic;
use super::elementary::Plain;
use super::elementary_lanes::Along as Hyperbolically;
use super::set_up::{Course, Ordinary};
use super::theta_quotients::Theta;
use super::zero_energy_lanes::Along as Outwards;
use crate::lanes::{Formula, Lane, tabulate};
use crate::motion::bounded::{Swinging, begun};
use crate::motion::escape::Flying;
use crate::motion::samples::Way;

/// What an evaluation returns first; where it returns no more, the rest is not computed.
const U: bool = true;
const VELOCITY: bool = false;

/// A motion on one side of the theta functions.
struct Along<'a, const HYPERBOLIC: bool, const FIRST: bool>(&'a Theta, [f64; 2]);

impl<const HYPERBOLIC: bool, const FIRST: bool> Formula<1, 2> for Along<'_, HYPERBOLIC, FIRST> {
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let Along(theta, start) = self;
        begun::<FIRST, L>(*start, t, theta.at::<HYPERBOLIC, L>(t))
    }
}

/// Times into slices of the R results wanted, each of the length of the times.
struct Fill<'a, 'b, const FIRST: bool, const R: usize> {
    orbit: &'a CubicQuintic,
    t: &'a [f64],
    results: [&'b mut [f64]; R],
}

/// u and u' without theta functions, or without motion.
fn plainly(orbit: &CubicQuintic, plain: Option<&Plain>, t: f64) -> (f64, f64) {
    match plain {
        _ if t == 0.0 => (orbit.u0, orbit.velocity0),
        Some(plain) => plain.at(t),
        None if t.is_nan() => (t, t),
        None => (orbit.u0, orbit.velocity0),
    }
}

impl<const FIRST: bool, const R: usize> Fill<'_, '_, FIRST, R> {
    fn run<const WIDE: bool>(mut self) {
        let (orbit, t, results) = (self.orbit, [self.t], &mut self.results);
        let plain = match &orbit.course {
            Course::Theta(theta) => {
                let start = [orbit.u0, orbit.velocity0];
                return match (theta.arc(), &theta.drawing.way) {
                    (Some(arc), Way::Swing(swing)) => {
                        tabulate::<WIDE, _, _, _, _>(&Swinging::<FIRST> { swing, arc, start }, t, results)
                    }
                    (Some(arc), Way::Flight(flight)) => {
                        tabulate::<WIDE, _, _, _, _>(&Flying::<FIRST> { flight, arc, start }, t, results)
                    }
                    _ if theta.lattice.hyperbolic() => {
                        tabulate::<WIDE, _, _, _, _>(&Along::<true, FIRST>(theta, start), t, results)
                    }
                    _ => tabulate::<WIDE, _, _, _, _>(&Along::<false, FIRST>(theta, start), t, results),
                };
            }
            Course::Plain(_, Some(motion)) => {
                let start = [orbit.u0, orbit.velocity0];
                return match &**motion {
                    Ordinary::Hyperbolic(motion) => {
                        tabulate::<WIDE, _, _, _, _>(&Hyperbolically::<FIRST>(motion, start), t, results)
                    }
                    Ordinary::Edge(motion) => {
                        tabulate::<WIDE, _, _, _, _>(&Outwards::<FIRST>(motion, start), t, results)
                    }
                };
            }
            Course::Plain(plain, None) => Some(&**plain),
            Course::Still => None,
        };
        for (i, t) in self.t.iter().enumerate() {
            let (u, velocity) = plainly(orbit, plain, *t);
            let both = if FIRST { [u, velocity] } else { [velocity, u] };
            for (result, value) in self.results.iter_mut().zip(both) {
                result[i] = value;
            }
        }
    }
}

impl CubicQuintic {
    fn fill<'a, 'b, const FIRST: bool, const R: usize>(
        &'a self,
        t: &'a [f64],
        results: [&'b mut [f64]; R],
    ) -> Fill<'a, 'b, FIRST, R> {
        assert!(
            results.iter().all(|result| result.len() == t.len()),
            "results of another length than the times"
        );
        Fill { orbit: self, t, results }
    }

    /// u at t.
    ///
    /// NaN at and beyond an escape, for times that are not finite (but for motions with a limit there), and more than 2^53
    /// half periods away. **Error** at most 4 ulp of the largest |u| of a bounded orbit, of max(|u|, |u0|) else, plus
    /// 2^-100 of the condition.
    pub fn u(&self, t: f64) -> f64 {
        let mut u = [0.0];
        self.fill::<U, 1>(&[t], [&mut u]).run::<false>();
        u[0]
    }

    /// u' at t; domain and error as for [`CubicQuintic::u`].
    pub fn velocity(&self, t: f64) -> f64 {
        let mut velocity = [0.0];
        self.fill::<VELOCITY, 1>(&[t], [&mut velocity]).run::<false>();
        velocity[0]
    }

    /// u and u' at t, bit for bit those of [`CubicQuintic::u`] and [`CubicQuintic::velocity`].
    pub fn motion(&self, t: f64) -> (f64, f64) {
        let (mut u, mut velocity) = ([0.0], [0.0]);
        self.fill::<U, 2>(&[t], [&mut u, &mut velocity]).run::<false>();
        (u[0], velocity[0])
    }

    /// [`CubicQuintic::u`] of every time, bit for bit, on the widest lanes; panics where the lengths differ.
    pub fn u_into(&self, t: &[f64], u: &mut [f64]) {
        self.fill::<U, 1>(t, [u]).run::<true>();
    }

    /// [`CubicQuintic::velocity`] of every time, bit for bit, on the widest lanes; panics where the lengths differ.
    pub fn velocity_into(&self, t: &[f64], velocity: &mut [f64]) {
        self.fill::<VELOCITY, 1>(t, [velocity]).run::<true>();
    }

    /// [`CubicQuintic::motion`] of every time, bit for bit, on the widest lanes; panics where the lengths differ.
    pub fn motion_into(&self, t: &[f64], u: &mut [f64], velocity: &mut [f64]) {
        self.fill::<U, 2>(t, [u, velocity]).run::<true>();
    }
}

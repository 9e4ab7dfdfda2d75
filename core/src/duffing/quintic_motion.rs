//! u and u' of an orbit of the cubic-quintic oscillator at any time, over lanes where theta functions serve.

use super::cubic_quintic::CubicQuintic;
use super::quintic_course::Course;
use super::quintic_plain::Plain;
use super::quintic_theta::Theta;
use crate::lanes::{Kernel, Lane, Sampler, single, sweep, wide};

/// What an evaluation returns first.
const U: bool = true;
const VELOCITY: bool = false;

/// A motion on one side of the theta functions.
struct Along<'a, const HYPERBOLIC: bool>(&'a CubicQuintic, &'a Theta, bool);

impl<L: Lane, const HYPERBOLIC: bool> Sampler<L, 1, 2> for Along<'_, HYPERBOLIC> {
    #[inline(always)]
    fn at(&self, [t]: [L; 1]) -> [L; 2] {
        let [u, velocity] = self.1.at::<HYPERBOLIC, L>(t);
        // The start as it was given.
        let start = t.equal(L::splat(0.0));
        let u = L::select(start, L::splat(self.0.u0), u);
        let velocity = L::select(start, L::splat(self.0.velocity0), velocity);
        if self.2 == U { [u, velocity] } else { [velocity, u] }
    }
}

/// Times into slices of the R results wanted, each of the length of the times.
struct Fill<'a, 'b, const R: usize> {
    first: bool,
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

impl<const R: usize> Kernel for Fill<'_, '_, R> {
    type Output = ();
    #[inline(always)]
    fn run<L: Lane>(mut self) {
        let (orbit, first, t, results) = (self.orbit, self.first, [self.t], &mut self.results);
        let plain = match &orbit.course {
            Course::Theta(theta) => {
                return if theta.lattice.hyperbolic() {
                    sweep::<L, _, _, _>(&Along::<true>(orbit, theta, first), t, results)
                } else {
                    sweep::<L, _, _, _>(&Along::<false>(orbit, theta, first), t, results)
                };
            }
            Course::Plain(plain) => Some(&**plain),
            Course::Still => None,
        };
        for (i, t) in self.t.iter().enumerate() {
            let (u, velocity) = plainly(orbit, plain, *t);
            let both = if first == U { [u, velocity] } else { [velocity, u] };
            for (result, value) in self.results.iter_mut().zip(both) {
                result[i] = value;
            }
        }
    }
}

impl CubicQuintic {
    fn fill<'a, 'b, const R: usize>(
        &'a self,
        first: bool,
        t: &'a [f64],
        results: [&'b mut [f64]; R],
    ) -> Fill<'a, 'b, R> {
        assert!(
            results.iter().all(|result| result.len() == t.len()),
            "results of another length than the times"
        );
        Fill { first, orbit: self, t, results }
    }

    /// u at t.
    ///
    /// NaN at and beyond an escape, for times that are not finite (but for motions with a limit there), and more than 2^53
    /// half periods away. **Error** at most 4 ulp of the largest |u| of a bounded orbit, of max(|u|, |u0|) else, plus
    /// 2^-100 of the condition.
    pub fn u(&self, t: f64) -> f64 {
        let mut u = [0.0];
        single(self.fill(U, &[t], [&mut u]));
        u[0]
    }

    /// u' at t; domain and error as for [`CubicQuintic::u`].
    pub fn velocity(&self, t: f64) -> f64 {
        let mut velocity = [0.0];
        single(self.fill(VELOCITY, &[t], [&mut velocity]));
        velocity[0]
    }

    /// u and u' at t, bit for bit those of [`CubicQuintic::u`] and [`CubicQuintic::velocity`].
    pub fn motion(&self, t: f64) -> (f64, f64) {
        let (mut u, mut velocity) = ([0.0], [0.0]);
        single(self.fill(U, &[t], [&mut u, &mut velocity]));
        (u[0], velocity[0])
    }

    /// [`CubicQuintic::u`] of every time, bit for bit, on the widest lanes; panics where the lengths differ.
    pub fn u_into(&self, t: &[f64], u: &mut [f64]) {
        wide(self.fill(U, t, [u]));
    }

    /// [`CubicQuintic::velocity`] of every time, bit for bit, on the widest lanes; panics where the lengths differ.
    pub fn velocity_into(&self, t: &[f64], velocity: &mut [f64]) {
        wide(self.fill(VELOCITY, t, [velocity]));
    }

    /// [`CubicQuintic::motion`] of every time, bit for bit, on the widest lanes; panics where the lengths differ.
    pub fn motion_into(&self, t: &[f64], u: &mut [f64], velocity: &mut [f64]) {
        wide(self.fill(U, t, [u, velocity]));
    }
}

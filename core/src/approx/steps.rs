//! The numerical solutions that everyone writes first, step by step: Euler, Euler-Cromer, Verlet, Runge-Kutta of fourth order.
//!
//! For theta' = v, v' = -omega^2 sin theta, in plain doubles, as a student's program has it: they are what the exact
//! solution is compared with. Source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, II.1; Cromer,
//! Am. J. Phys. 49 (1981) 455; Verlet, Phys. Rev. 159 (1967) 98; Hairer, Lubich, Wanner, Acta Numerica 12 (2003) 399.

use super::entry::{Entry, Named, Row, entries, row};
use crate::domain::Domain;
use crate::elliptic::amplitude::sine_cosine;

/// From a state to the next: the step h and omega0^2.
type Step = fn(State, f64, f64) -> State;

const TABLE: &[Row<Step>] = &[
    row(
        Entry::new(
            "euler",
            "theta += h v and v -= h omega^2 sin theta, both from the old state",
            "Euler 1768; order 1",
        ),
        euler,
    ),
    row(
        Entry::new(
            "euler-cromer",
            "v -= h omega^2 sin theta, then theta += h v from the new v",
            "Cromer 1981; order 1, symplectic",
        ),
        euler_cromer,
    ),
    row(
        Entry::new(
            "verlet",
            "half a step of v, a step of theta, half a step of v from the new theta: velocity Verlet, or leapfrog",
            "Verlet 1967; order 2, symplectic",
        ),
        verlet,
    ),
    row(Entry::new("rk4", "the classical Runge-Kutta scheme of four stages", "Kutta 1901; order 4"), rk4),
];

/// The schemes, each of a fixed step.
pub static SCHEMES: [Entry; TABLE.len()] = entries(TABLE);

/// One of [`SCHEMES`].
#[derive(Clone, Copy, Debug)]
pub struct Scheme {
    step: Step,
}

/// Angle and velocity.
#[derive(Clone, Copy, Debug)]
struct State(f64, f64);

/// -omega^2 sin theta, correctly rounded but for the product.
fn pull(theta: f64, omega2: f64) -> f64 {
    if theta.is_finite() { -omega2 * sine_cosine(theta).0.value() } else { f64::NAN }
}

impl State {
    /// The state a time h along a slope.
    fn along(self, slope: State, h: f64) -> State {
        State(self.0 + h * slope.0, self.1 + h * slope.1)
    }

    fn slope(self, omega2: f64) -> State {
        State(self.1, pull(self.0, omega2))
    }
}

fn euler(state: State, h: f64, omega2: f64) -> State {
    state.along(state.slope(omega2), h)
}

fn euler_cromer(State(theta, velocity): State, h: f64, omega2: f64) -> State {
    let velocity = velocity + h * pull(theta, omega2);
    State(theta + h * velocity, velocity)
}

fn verlet(State(theta, velocity): State, h: f64, omega2: f64) -> State {
    let half = velocity + 0.5 * h * pull(theta, omega2);
    let theta = theta + h * half;
    State(theta, half + 0.5 * h * pull(theta, omega2))
}

fn rk4(state: State, h: f64, omega2: f64) -> State {
    let first = state.slope(omega2);
    let second = state.along(first, 0.5 * h).slope(omega2);
    let third = state.along(second, 0.5 * h).slope(omega2);
    let fourth = state.along(third, h).slope(omega2);
    let mean = |a: f64, b: f64, c: f64, d: f64| (a + 2.0 * b + 2.0 * c + d) / 6.0;
    let slope = State(mean(first.0, second.0, third.0, fourth.0), mean(first.1, second.1, third.1, fourth.1));
    state.along(slope, h)
}

impl Scheme {
    /// By its name; the error lists the nearest first.
    pub fn named(name: &str) -> Result<Scheme, Domain> {
        let (_, &step) = Named::find("scheme", TABLE, name)?;
        Ok(Scheme { step })
    }

    /// Angle and velocity at 0, h, 2 h, ... as many as the slices hold, both of one length; the state after the last, from
    /// which the march goes on.
    pub fn march(
        &self,
        start: (f64, f64),
        omega2: f64,
        h: f64,
        theta: &mut [f64],
        velocity: &mut [f64],
    ) -> (f64, f64) {
        let mut state = State(start.0, start.1);
        for (theta, velocity) in theta.iter_mut().zip(velocity) {
            (*theta, *velocity) = (state.0, state.1);
            state = (self.step)(state, h, omega2);
        }
        (state.0, state.1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Frequency, Orbit};

    /// Largest error of the angle over 3 s of a release from 2 rad.
    fn error(name: &str, h: f64) -> f64 {
        let orbit = Orbit::new(2.0, 0.0, Frequency::from_omega0(1.0).unwrap()).unwrap();
        let steps = (3.0 / h) as usize + 1;
        let (mut theta, mut velocity) = (vec![0.0; steps], vec![0.0; steps]);
        Scheme::named(name).unwrap().march((2.0, 0.0), 1.0, h, &mut theta, &mut velocity);
        let far = |(i, theta): (usize, &f64)| (theta - orbit.theta(h * i as f64)).abs();
        theta.iter().enumerate().map(far).fold(0.0, f64::max)
    }

    #[test]
    fn errors_fall_with_the_order_of_the_scheme() {
        for (name, order) in [("euler", 1.0), ("euler-cromer", 1.0), ("verlet", 2.0), ("rk4", 4.0)] {
            let ratio: f64 = error(name, 1.0 / 64.0) / error(name, 1.0 / 128.0);
            let seen = ratio.log2();
            assert!((seen - order).abs() < 0.1, "{name}: order {seen}");
        }
        assert!(error("rk4", 1.0 / 64.0) < 1e-8);
    }

    #[test]
    fn the_pull_is_the_sine_of_any_angle() {
        for theta in [0.0, 1e-300, 0.5, 1.6, 3.0, -3.0, 4.0, -100.0, 1e10] {
            let expected: f64 = -f64::sin(theta);
            assert!((pull(theta, 1.0) - expected).abs() <= 2.0 * f64::EPSILON * expected.abs(), "{theta}");
        }
        assert!(pull(f64::INFINITY, 1.0).is_nan());
    }

    #[test]
    fn unknown_schemes_are_answered() {
        let said = Scheme::named("rk45").unwrap_err().to_string();
        assert_eq!(said, "scheme = \"rk45\": must be one of rk4, euler, verlet, euler-cromer");
    }
}

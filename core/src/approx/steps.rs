//! The numerical solutions that everyone writes first, step by step: Euler, Euler-Cromer, Verlet, Runge-Kutta of fourth order.
//!
//! For theta' = v, v' = -omega^2 sin theta, in plain doubles, as a student's program has it: they are what the exact
//! solution is compared with. Source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, II.1; Cromer,
//! Am. J. Phys. 49 (1981) 455; Verlet, Phys. Rev. 159 (1967) 98; Hairer, Lubich, Wanner, Acta Numerica 12 (2003) 399.

use super::entry::{Entry, Row, row};
use crate::elliptic::amplitude::short_sine;

/// From a state to the next: the step h and omega0^2.
pub(super) type Step = fn(State, f64, f64) -> State;

/// The schemes of a fixed step.
pub(super) const SCHEME_TABLE: &[Row<Step>] = &[
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

/// Angle and velocity.
#[derive(Clone, Copy, Debug)]
pub(super) struct State(pub f64, pub f64);

/// -omega^2 sin theta, the sine rounded within 2^-4 of a unit of correctly.
fn pull(theta: f64, omega2: f64) -> f64 {
    -omega2 * short_sine(theta).value()
}

impl State {
    /// The state a time h along a slope.
    pub fn along(self, slope: State, h: f64) -> State {
        State(self.0 + h * slope.0, self.1 + h * slope.1)
    }

    pub fn slope(self, omega2: f64) -> State {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pull_is_the_sine_of_any_angle() {
        for theta in [0.0, 1e-300, 0.5, 1.6, 3.0, -3.0, 4.0, -100.0, 1e10] {
            let expected: f64 = -f64::sin(theta);
            assert!((pull(theta, 1.0) - expected).abs() <= 2.0 * f64::EPSILON * expected.abs(), "{theta}");
        }
        assert!(pull(f64::INFINITY, 1.0).is_nan());
    }
}

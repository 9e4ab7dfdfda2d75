//! Taylor coefficients of the motion at one time, in double, and what the lowest of them lack.
//!
//! A step is 2^(-70/31) = 0.21 of the radius of convergence: the term of order LONG is below 0.21^9 = 2^-20 of the motion, and its
//! rounding error below 2^-73. A motion that repeats itself rounds alike in every period, so that the errors of N steps may add up to
//! 2^-73 N of the state; so the coefficients below LONG have low words. All coefficients come from those before in double first,
//! because each waits for the last one (jet_orders.rs); the low words follow, and are waited for by nothing but the next low words.
//! Source: Jorba & Zou, Exp. Math. 14 (2005) 99.

use super::jet::{Jet, Piece};
use super::jet_low_words::LowWords;
use super::jet_orders::{Constants, Rows};
use super::taylor::{LONG, ORDER};
use super::torque_jet::TorqueJet;
use crate::float::Dd;
use crate::lanes::{Kernel, Lane, four};

/// Sums that are written out order by order, and lanes of four coefficients.
const _: () = assert!(LONG == 9 && ORDER == 31);

impl Jet {
    /// From the values of s, c, u, v. `at_limit`: the acceleration is 0, as it is when a stuck pendulum is released.
    pub fn fill(&mut self, start: &[Dd; 4], piece: &Piece, torque: &TorqueJet, at_limit: bool) {
        let jet = self;
        if piece.quadratic != 0.0 || piece.slip != 0.0 {
            four(Recurrence::<true> { jet, start, piece, torque, at_limit })
        } else {
            four(Recurrence::<false> { jet, start, piece, torque, at_limit })
        }
    }
}

/// `FULL`: with drag or presliding.
struct Recurrence<'a, const FULL: bool> {
    jet: &'a mut Jet,
    start: &'a [Dd; 4],
    piece: &'a Piece,
    torque: &'a TorqueJet,
    at_limit: bool,
}

impl<const FULL: bool> Kernel for Recurrence<'_, FULL> {
    type Output = ();
    type Place = Jet;
    #[inline(always)]
    fn run<L: Lane>(self) {
        let Recurrence { jet, start, piece, torque, at_limit } = self;
        let constants = Constants::<L>::new(piece, start, at_limit);
        let mut rows = Rows::none();
        // A lane in memory keeps the stack aligned to lanes: without it many of those that wait there would lie across two cache lines.
        let aligned = L::splat(0.0);
        core::hint::black_box(&aligned);
        let mut latest = constants.start(start);
        // Written out, so that the compiler knows the length of every sum.
        macro_rules! orders {
            ($($k:literal)*) => {$(
                rows.keep::<FULL>($k, jet, latest);
                latest = constants.next::<FULL>($k, &mut rows, torque, latest);
            )*};
        }
        orders!(0 1 2 3 4 5 6 7);
        rows.keep::<FULL>(8, jet, latest);
        // While the orders ahead wait for each other.
        LowWords { rows: &rows, start, piece, torque, at_limit }.keep::<FULL>(jet);
        latest = constants.next::<FULL>(8, &mut rows, torque, latest);
        orders!(9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30);
        rows.keep::<FULL>(31, jet, latest);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// s^2 + c^2 = 1 and the equation of v, coefficient by coefficient: of the worst what they miss, with the low words and without.
    fn missing(slip: f64, low: f64) -> f64 {
        let (sine, cosine) = super::super::circular::of_double(1.1);
        let start = [sine, cosine, Dd::new(0.7, 1e-18), Dd::new(0.83, 3e-17)];
        let (omega2, linear, quadratic, dry) = (Dd::new(0.7, 1e-17), 0.0123, 0.21, 0.0031);
        let piece = Piece { omega2, linear, quadratic, dry, slip, rate: 4.0 };
        let mut torque = TorqueJet::ZERO;
        torque.add(0, Dd::new(0.3, 1e-18));
        torque.add(2, Dd::from(-0.1));
        let mut jet = Jet::ZERO;
        jet.fill(&start, &piece, &torque, false);
        let at = |k: usize, place: usize| Dd::sum(jet.rows[k][place], low * jet.low_rows[k][place]);
        let u = |k: usize| Dd::sum(jet.slip[k], low * jet.low_slip[k]);
        let product = |k: usize, a: &dyn Fn(usize) -> Dd, b: &dyn Fn(usize) -> Dd| {
            (0..=k).fold(Dd::ZERO, |sum, j| sum + a(j) * b(k - j))
        };
        let (s, c, v) = (|k| at(k, 0), |k| at(k, 1), |k| at(k, 2));
        let mut worst: f64 = 0.0;
        for k in 0..LONG - 1 {
            let next = k as f64 + 1.0;
            let circle = product(k + 1, &s, &s) + product(k + 1, &c, &c);
            let resting = if k == 0 { Dd::from(dry) } else { Dd::ZERO };
            let force = Dd::new(torque.hi[k], torque.lo[k])
                - omega2 * s(k)
                - v(k) * linear
                - product(k, &v, &v) * quadratic
                - resting
                + u(k) * dry;
            let sliding = product(k, &u, &v) * -slip;
            let angle = at(k, 3) * next - v(k);
            for rest in [circle, v(k + 1) * next - force, u(k + 1) * next - sliding, angle] {
                worst = worst.max(rest.hi.abs());
            }
        }
        worst
    }

    #[test]
    fn coefficients_below_long_keep_the_equations() {
        for slip in [0.0, 3.0] {
            assert!(missing(slip, 1.0) < 1e-27, "{}", missing(slip, 1.0));
            assert!(missing(slip, 0.0) > 1e-18);
        }
    }
}

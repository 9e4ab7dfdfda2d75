//! T/T0 by each formula of the period, to triple-double.
//!
//! Sources: the entries of period.rs. The coefficients of the series follow from Legendre's equation
//!   sin(theta) K'' + cos(theta) K' = sin(theta) K / 4,
//! which T solves as a function of its turning angle; all terms of the recurrence are positive, so none cancel.

use super::turning::{Turning, sine};
use crate::float::exponent::exp2;
use crate::float::triple_double::Td;
use crate::float::{LN_2, TWO_PI_LONG};
use std::sync::OnceLock;

/// The largest power of theta_max that the series is asked for.
pub(super) const MOST: u32 = 200;

/// How a formula is evaluated; the number is N, where it takes one.
pub(super) struct Rule {
    pub ratio: fn(&Turning, u32) -> Td,
    /// Whether it grows without bound towards the top.
    pub diverges: bool,
}

pub(super) const fn finite(ratio: fn(&Turning, u32) -> Td) -> Rule {
    Rule { ratio, diverges: false }
}

pub(super) const fn diverging(ratio: fn(&Turning, u32) -> Td) -> Rule {
    Rule { ratio, diverges: true }
}

/// 2 K / pi = 1/agm(1, a).
pub(super) fn exact(turning: &Turning, _: u32) -> Td {
    let (mut mean, mut b) = (Td::ONE, turning.a);
    loop {
        let next = (mean + b).scale(0.5);
        // After this step the two means differ by (mean - b)^2 / 8 mean, below 1e-50 of it: it is the limit.
        let apart = (mean - b).hi.abs() > 1e-25 * mean.hi;
        if !apart {
            return Td::ONE / next;
        }
        b = (mean * b).sqrt();
        mean = next;
    }
}

/// The arithmetic mean after some steps of the arithmetic-geometric one from 1 and a.
pub(super) fn means(a: Td, steps: u32) -> Td {
    let (mut mean, mut b) = (Td::ONE, a);
    for _ in 0..steps {
        (mean, b) = ((mean + b).scale(0.5), (mean * b).sqrt());
    }
    mean
}

/// The series in theta_max to the power N.
pub(super) fn series(turning: &Turning, power: u32) -> Td {
    let square = turning.theta_max.square();
    let coefficients = &coefficients()[..=(power / 2) as usize];
    coefficients.iter().rev().fold(Td::ZERO, |sum, c| sum * square + *c)
}

/// c_0, c_1, ... of T/T0 = sum of c_k theta_max^(2k).
///
/// With cot theta = 1/theta - sum of b_j theta^(2j - 1), Legendre's equation is 4 k^2 c_k = c_(k-1)/4 + sum of
/// b_j 2(k - j) c_(k-j), and cot' = -1 - cot^2 is (2j + 1) b_j = sum of b_i b_(j-i), but 3 b_1 = 1.
pub(super) fn coefficients() -> &'static [Td] {
    static MADE: OnceLock<Vec<Td>> = OnceLock::new();
    MADE.get_or_init(|| {
        let count = MOST as usize / 2;
        let whole = |n: usize| Td::from(n as f64);
        let mut b = vec![Td::ZERO, Td::ONE / whole(3)];
        let mut c = vec![Td::ONE, Td::from(1.0 / 16.0)];
        for k in 2..=count {
            let products = (1..k).fold(Td::ZERO, |sum, i| sum + b[i] * b[k - i]);
            b.push(products / whole(2 * k + 1));
            let sum = (1..k).fold(c[k - 1].scale(0.25), |sum, j| sum + b[j] * c[k - j] * whole(2 * (k - j)));
            c.push(sum / whole(4 * k * k));
        }
        c
    })
}

/// (sin s / s)^(-1/2) with s = sqrt 3 theta_max/2.
pub(super) fn ganley(turning: &Turning, _: u32) -> Td {
    let s = Td::from(3.0).sqrt() * turning.theta_max.scale(0.5);
    (s / sine(s)).sqrt()
}

/// -ln a/(1 - a).
pub(super) fn lima_arun(turning: &Turning, _: u32) -> Td {
    let rest = turning.one_minus_a();
    if rest.hi < 0.5 { -(-rest).ln_one_plus() / rest } else { -turning.a.ln() / rest }
}

/// 4/a.
pub(super) fn four_over(a: Td) -> Td {
    Td::from(4.0) / a
}

/// (2/(n pi)) ln((4/a)^n + b), where n and b make it exact at rest and, to first order, next to it.
pub(super) fn chachiyo(turning: &Turning, _: u32) -> Td {
    let quarter_turn = TWO_PI_LONG.scale(0.25);
    let ln_4 = LN_2.scale(2.0);
    let n = (ln_4 - quarter_turn.scale(2.0).ln()) / (quarter_turn - ln_4);
    let b = (n * quarter_turn).exp() - (n * ln_4).exp();
    ((n * four_over(turning.a).ln()).exp() + b).ln() / (n * quarter_turn)
}

/// Coefficients of numerator and denominator, rising powers of m.
pub(super) struct Pade<const N: usize>([f64; N], [f64; N]);

pub(super) const SALAS_26: Pade<2> = Pade([-16.0, 5.0], [-16.0, 9.0]);
pub(super) const SALAS_27: Pade<3> = Pade([4864.0, -3984.0, 409.0], [4864.0, -5200.0, 1025.0]);
pub(super) const SALAS_28: Pade<4> = Pade(
    [-24_653_824.0, 32_584_960.0, -10_617_024.0, 540_191.0],
    [-24_653_824.0, 38_748_416.0, -16_837_184.0, 1_708_091.0],
);

pub(super) fn pade<const N: usize>(Pade(top, bottom): &Pade<N>, m: Td) -> Td {
    // Far from 0 in powers of 1/m, so that none leaves the range.
    let far = m.hi < -exp2(40);
    let x = if far { Td::ONE / m } else { m };
    let value = |coefficients: &[f64; N]| {
        (0..N).fold(Td::ZERO, |sum, i| sum * x + Td::from(coefficients[if far { i } else { N - 1 - i }]))
    };
    value(top) / value(bottom)
}

//! The formulas of the period: what is known of each, and T/T0 by it, to triple-double. One row of the table and one
//! function are a formula; all counts follow.
//!
//! Sources: the rows. The coefficients of the series follow from Legendre's equation
//!   sin(theta) K'' + cos(theta) K' = sin(theta) K / 4,
//! which T solves as a function of its turning angle; all terms of the recurrence are positive, so none cancel.

use super::entry::{Entry, Orders, Row, row};
use super::turning::{Turning, sine};
use crate::float::exponent::exp2;
use crate::float::triple_double::Td;
use crate::float::{LN_2, TWO_PI_LONG};
use core::f64::consts::PI;
use std::sync::OnceLock;

/// The largest power of theta_max that the series is asked for.
const MOST: u32 = 200;

/// How a formula is evaluated; the number is N, where it takes one.
pub(super) struct PeriodRule {
    pub ratio: fn(&Turning, u32) -> Td,
    /// Whether it grows without bound towards the top.
    pub diverges: bool,
}

const fn finite(ratio: fn(&Turning, u32) -> Td) -> PeriodRule {
    PeriodRule { ratio, diverges: false }
}

const fn diverging(ratio: fn(&Turning, u32) -> Td) -> PeriodRule {
    PeriodRule { ratio, diverges: true }
}

/// A formula of the angle itself.
const fn of_angle(name: &'static str, formula: &'static str, source: &'static str) -> Entry {
    Entry::new(name, formula, source).but_for("m < 0")
}

pub(super) const TABLE: &[Row<PeriodRule>] = &[
    row(Entry::new("linear", "1", "small swings"), finite(|_, _| Td::ONE)),
    row(of_angle("bernoulli", "1 + θ_max²/16", "Bernoulli"), finite(|turning, _| series(turning, 2))),
    row(
        of_angle(
            "series",
            "1 + θ_max²/16 + 11 θ_max⁴/3072 + … to θ_max^N, N even",
            "Taylor series of 2K/π in θ_max; DLMF 19.5.1",
        )
        .of_order(Orders::every_second([2, MOST])),
        finite(series),
    ),
    row(
        of_angle("denman", "1/(1 − θ_max²/16)", "Denman 1959"),
        finite(|turning, _| Td::ONE / (Td::ONE - turning.theta_max.square().scale(1.0 / 16.0))),
    ),
    row(
        Entry::new("kidd-fogg", "1/√a, a = cos(θ_max/2)", "Kidd & Fogg 2002"),
        diverging(|turning, _| Td::ONE / turning.a.sqrt()),
    ),
    row(
        of_angle("molina", "(sin θ_max/θ_max)^(−3/8)", "Molina 1997"),
        diverging(|turning, _| (turning.cardinal_sine().ln() * -0.375).exp()),
    ),
    row(
        of_angle("ganley-parwani", "√(s/sin s), s = √3 θ_max/2", "Ganley 1985; Parwani 2004")
            .for_range("to 0.001 up to 100 deg, to 5 % up to 160 deg", [0.0, 100.0 / 180.0 * PI]),
        finite(ganley),
    ),
    row(Entry::new("lima-arun", "−ln a/(1 − a), a = cos(θ_max/2)", "Lima & Arun 2006"), diverging(lima_arun)),
    row(
        Entry::new(
            "agm",
            "1/a_N with a₀ = 1, b₀ = cos(θ_max/2), a_(n+1) = (a_n + b_n)/2, b_(n+1) = √(a_n b_n)",
            "N steps of DLMF 19.8.1; N = 1 Carvalhaes & Suppes",
        )
        .of_order(Orders::all([1, 8])),
        finite(|turning, steps| Td::ONE / means(turning.a, steps)),
    ),
    row(
        Entry::new("belendez", "4/(1 + √a)², a = cos(θ_max/2): agm:2", "Beléndez et al. 2009"),
        finite(|turning, _| Td::ONE / means(turning.a, 2)),
    ),
    row(
        Entry {
            stated: "near 180 deg",
            ..Entry::new("cromer", "(2/π) ln(4/a), a = cos(θ_max/2)", "Cromer 1995")
        },
        diverging(|turning, _| four_over(turning.a).ln() / TWO_PI_LONG.scale(0.25)),
    ),
    row(
        Entry::new(
            "chachiyo",
            "(2/(nπ)) ln((4/a)ⁿ + b), a = cos(θ_max/2), n = ln(4/π)/(π/2 − ln 4), b = e^(nπ/2) − 4ⁿ",
            "Chachiyo 2025, arXiv:2505.17159",
        )
        .for_range("all swings", [0.0, PI]),
        diverging(chachiyo),
    ),
    row(
        Entry::new("salas-26", "(5m − 16)/(9m − 16), m = sin²(θ_max/2)", "Salas 2019 (26)")
            .for_range("|m| ≤ 1/3", [0.0, 1.2309594173407747]),
        finite(|turning, _| pade(&SALAS_26, turning.m)),
    ),
    row(
        Entry::new(
            "salas-27",
            "(409m² − 3984m + 4864)/(1025m² − 5200m + 4864), m = sin²(θ_max/2)",
            "Salas 2019 (27)",
        )
        .for_range("|m| ≤ 3/4", [0.0, 2.0 / 3.0 * PI]),
        finite(|turning, _| pade(&SALAS_27, turning.m)),
    ),
    row(
        Entry::new(
            "salas-28",
            "(540191m³ − 10617024m² + 32584960m − 24653824)/(1708091m³ − 16837184m² + 38748416m − 24653824), \
             m = sin²(θ_max/2)",
            "Salas 2019 (28)",
        )
        .for_range("|m| < 1", [0.0, PI]),
        finite(|turning, _| pade(&SALAS_28, turning.m)),
    ),
    row(
        Entry::new(
            "exact",
            "2K(m)/π = 1/agm(1, cos(θ_max/2)), m = sin²(θ_max/2)",
            "Gauss; DLMF 19.8.5; four times Salas 2019 (25)",
        ),
        diverging(exact),
    ),
];

/// 2 K / pi = 1/agm(1, a).
pub(super) fn exact(turning: &Turning, _: u32) -> Td {
    let (mut mean, mut b) = (Td::ONE, turning.a);
    // Ends, on a NaN too: the quotient of the means goes to its root while it is far from 1, and the distance to its square
    // once it is near.
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
fn means(a: Td, steps: u32) -> Td {
    let (mut mean, mut b) = (Td::ONE, a);
    for _ in 0..steps {
        (mean, b) = ((mean + b).scale(0.5), (mean * b).sqrt());
    }
    mean
}

/// The series in theta_max to the power N.
fn series(turning: &Turning, power: u32) -> Td {
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
fn ganley(turning: &Turning, _: u32) -> Td {
    let s = Td::from(3.0).sqrt() * turning.theta_max.scale(0.5);
    (s / sine(s)).sqrt()
}

/// -ln a/(1 - a).
fn lima_arun(turning: &Turning, _: u32) -> Td {
    let rest = turning.one_minus_a();
    if rest.hi < 0.5 { -(-rest).ln_one_plus() / rest } else { -turning.a.ln() / rest }
}

/// 4/a.
fn four_over(a: Td) -> Td {
    Td::from(4.0) / a
}

/// (2/(n pi)) ln((4/a)^n + b), where n and b make it exact at rest and, to first order, next to it.
fn chachiyo(turning: &Turning, _: u32) -> Td {
    let quarter_turn = TWO_PI_LONG.scale(0.25);
    let ln_4 = LN_2.scale(2.0);
    let n = (ln_4 - quarter_turn.scale(2.0).ln()) / (quarter_turn - ln_4);
    let b = (n * quarter_turn).exp() - (n * ln_4).exp();
    ((n * four_over(turning.a).ln()).exp() + b).ln() / (n * quarter_turn)
}

/// Coefficients of numerator and denominator, rising powers of m.
struct Pade<const N: usize>([f64; N], [f64; N]);

const SALAS_26: Pade<2> = Pade([-16.0, 5.0], [-16.0, 9.0]);
const SALAS_27: Pade<3> = Pade([4864.0, -3984.0, 409.0], [4864.0, -5200.0, 1025.0]);
const SALAS_28: Pade<4> = Pade(
    [-24_653_824.0, 32_584_960.0, -10_617_024.0, 540_191.0],
    [-24_653_824.0, 38_748_416.0, -16_837_184.0, 1_708_091.0],
);

fn pade<const N: usize>(Pade(top, bottom): &Pade<N>, m: Td) -> Td {
    // Far from 0 in powers of 1/m, so that none leaves the range.
    let far = m.hi < -exp2(40);
    let x = if far { Td::ONE / m } else { m };
    let value = |coefficients: &[f64; N]| {
        (0..N).fold(Td::ZERO, |sum, i| sum * x + Td::from(coefficients[if far { i } else { N - 1 - i }]))
    };
    value(top) / value(bottom)
}

//! Taylor's polynomial of theta(t) about t = 0: right at first, and then the first to be lost.
//!
//! With a_k, s_k, c_k the coefficients of theta, sin theta and cos theta in omega0 t,
//!   k s_k = sum j a_j c_(k-j),   k c_k = -sum j a_j s_(k-j),   (k + 1)(k + 2) a_(k+2) = -s_k,
//! in units of time short enough for |a_1| <= 1. Source: derivatives of sin theta and cos theta.

use super::angle_columns::{AngleBlock, AngleRow, Pass, constant, double, ordinary};
use crate::elliptic::amplitude::sine_cosine;
use crate::float::exponent::{exp2, ldexp};
use crate::float::unnormalised::Unnormalised;
use crate::float::{Dd, Scaled};
use crate::lanes::Lane;
use crate::pendulum::Orbit;

/// sum a_k (unit t)^k.
#[derive(Clone, Debug)]
pub(super) struct Polynomial {
    coefficients: Vec<Dd>,
    /// 1/s: omega0 times a power of two.
    unit: Scaled,
}

impl Polynomial {
    /// `None` without a force.
    pub fn new(orbit: &Orbit, order: u32) -> Option<Polynomial> {
        let (root, power) = orbit.force.root()?;
        let omega = Scaled::new(root.to_dd(), power);
        let ratio = Scaled::from(orbit.velocity0) / omega;
        let shorter = if ratio.is_zero() { 0 } else { (ratio.power() + 1).max(0) };
        // omega0^2 in units of the square of time, with its sign.
        let force = ldexp(if orbit.force.upside_down() { -1.0 } else { 1.0 }, -2 * shorter);
        let most = order as usize + 1;
        let (sine, cosine) = sine_cosine(orbit.theta0);
        let mut a = vec![Dd::from(orbit.theta0), ratio.shift(-shorter).to_dd()];
        let (mut s, mut c) = (vec![sine], vec![cosine]);
        for k in 0..most {
            if k > 0 {
                let whole = Dd::from(k as f64);
                let against = |other: &[Dd]| {
                    (1..=k).fold(Dd::ZERO, |sum, j| sum + a[j] * (j as f64) * other[k - j]) / whole
                };
                let (next_s, next_c) = (against(&c), -against(&s));
                s.push(next_s);
                c.push(next_c);
            }
            let below = Dd::from(((k + 1) * (k + 2)) as f64);
            a.push(-(s[k] * force) / below);
        }
        a.truncate(most);
        Some(Polynomial { coefficients: a, unit: omega.shift(shorter) })
    }

    pub fn theta(&self, t: f64) -> f64 {
        if !t.is_finite() {
            return f64::NAN;
        }
        let x = self.unit * t;
        self.coefficients.iter().rev().fold(Scaled::ZERO, |sum, a| sum * x + Scaled::from(*a)).value()
    }
    /// Whether the powers of the time may leave the range of doubles.
    pub fn is_far(&self, t: f64) -> bool {
        let most = exp2(MOST_POWER / self.coefficients.len() as i32);
        let size = (self.unit * t).abs().value();
        !(size == 0.0 || (size < most && size > 1.0 / most))
    }

    pub fn in_columns(&self) -> bool {
        ordinary(self.unit)
    }

    pub fn columns(&self, block: &mut AngleBlock, rows: usize) {
        block.through(rows, &Powers { coefficients: &self.coefficients, unit: self.unit.to_dd() });
    }
}

/// Of the terms of a polynomial in columns.
const MOST_POWER: i32 = 800;

/// Horner's scheme.
struct Powers<'a> {
    coefficients: &'a [Dd],
    unit: Dd,
}

impl Pass for Powers<'_> {
    #[inline(always)]
    fn at<L: Lane>(&self, row: AngleRow<L>) -> AngleRow<L> {
        let x = constant(self.unit) * Unnormalised::from_double(row.t);
        let mut sum = double(0.0);
        let mut i = self.coefficients.len();
        while i > 0 {
            i -= 1;
            sum = sum * x + constant(self.coefficients[i]);
        }
        AngleRow { angle: sum, ..row }
    }
}

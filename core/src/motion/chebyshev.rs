//! Polynomials through the Chebyshev points of [-1, 1], in powers of the variable.
//!
//! The matrix from values to coefficients is made once for each count of points, in double-double: its entries grow as
//! 2.4^n, so doubles would lose digits. Powers are used for functions that are analytic well beyond the interval: their
//! coefficients decay faster than 2.4^-k, and each term costs one multiply-add.
//! Source: DLMF 18.3, 3.11(ii).

use crate::float::series::long_sin_cos;
use crate::float::unnormalised::Unnormalised;
use crate::float::{Dd, HALF_PI};
use crate::lanes::{Kernel, Lane, wide};
use std::sync::OnceLock;

/// Points of a piece (pieces.rs).
pub(crate) const PIECE: usize = 18;

/// Counts of points that have a matrix.
#[cfg(not(target_arch = "wasm32"))]
pub(crate) const COUNTS: [usize; 7] = [12, 16, PIECE, 20, 24, 28, 32];
/// Without fused multiplication the theta functions take seven times as long, so more terms serve.
#[cfg(target_arch = "wasm32")]
pub(crate) const COUNTS: [usize; 8] = [12, 16, 20, 24, 28, 32, 36, 40];

/// The largest of them, and half of it: both are whole lanes.
pub(crate) const MOST: usize = COUNTS[COUNTS.len() - 1];
const HALF: usize = MOST / 2;

/// Even powers, then odd ones, each padded to [`HALF`]; high words and low words.
type Row = [[f64; MOST]; 2];

/// The points of one count, and the matrix to the coefficients.
pub(crate) struct Interpolation {
    /// cos(pi (2 j + 1)/2n), falling: high words and low words.
    pub points: [Vec<f64>; 2],
    /// What half the sum (even powers) and half the difference (odd ones) of the values at points j and n - 1 - j
    /// add to each coefficient.
    rows: Vec<Row>,
}

impl Interpolation {
    /// Through that many of [`COUNTS`], or the next.
    pub fn of(count: usize) -> &'static Interpolation {
        static MADE: [OnceLock<Interpolation>; COUNTS.len()] = [const { OnceLock::new() }; COUNTS.len()];
        let place = COUNTS.iter().position(|n| *n >= count).unwrap_or(COUNTS.len() - 1);
        MADE[place].get_or_init(|| Interpolation::new(COUNTS[place]))
    }

    fn new(count: usize) -> Interpolation {
        let cosine = |numerator: usize| cosine(numerator, 2 * count);
        // Powers of Chebyshev polynomials: T_k = 2 t T_(k-1) - T_(k-2), integers below 2^53.
        let mut powers = vec![vec![1.0], vec![0.0, 1.0]];
        for k in 2..count {
            let at = |k: usize, i: usize| powers[k].get(i).copied().unwrap_or(0.0);
            let raised = |i: usize| if i > 0 { 2.0 * at(k - 1, i - 1) } else { 0.0 };
            powers.push((0..=k).map(|i| raised(i) - at(k - 2, i)).collect());
        }
        let row = |j: usize| {
            let weight = |k: usize| {
                let scale = if k == 0 { 1.0 } else { 2.0 };
                cosine(k * (2 * j + 1)) * scale / Dd::from(count as f64)
            };
            let weights: Vec<Dd> = (0..count).map(weight).collect();
            let mut row = [[0.0; MOST]; 2];
            let entry = |i: usize| (i..count).fold(Dd::ZERO, |sum, k| sum + weights[k] * powers[k][i]);
            for (i, entry) in (0..count).map(entry).enumerate() {
                let place = i / 2 + HALF * (i % 2);
                (row[0][place], row[1][place]) = (entry.hi, entry.lo);
            }
            row
        };
        let points: Vec<Dd> = (0..count).map(|j| cosine(2 * j + 1)).collect();
        let words = [points.iter().map(|t| t.hi).collect(), points.iter().map(|t| t.lo).collect()];
        Interpolation { points: words, rows: (0..count / 2).map(row).collect() }
    }

    /// Coefficients of the powers, from the values at the points (high words and low words).
    pub fn coefficients(&self, values: [&[f64]; 2]) -> [Dd; MOST] {
        let [hi, lo] = wide(Product { rows: &self.rows, values });
        let mut coefficients = [Dd::ZERO; MOST];
        for (i, coefficient) in coefficients.iter_mut().enumerate() {
            let place = i / 2 + HALF * (i % 2);
            *coefficient = Dd::sum(hi[place], lo[place]);
        }
        coefficients
    }
}

/// Values through the matrix.
struct Product<'a> {
    rows: &'a [Row],
    values: [&'a [f64]; 2],
}

impl Kernel for Product<'_> {
    type Output = Row;
    type Place = Self;
    #[inline(always)]
    fn run<L: Lane>(self) -> Row {
        let Product { rows, values: [hi, lo] } = self;
        let value = |place: usize| Unnormalised::<f64>::new(hi[place], lo[place]);
        let mut sums = [[0.0; MOST]; 2];
        let mut from = 0;
        while from < MOST {
            let mut sum = Unnormalised::from_double(L::splat(0.0));
            for (j, row) in rows.iter().enumerate() {
                let (near, far) = (value(j), value(2 * rows.len() - 1 - j));
                let part = if from < HALF { near + far } else { near - far };
                let part = Unnormalised::new(L::splat(part.hi), L::splat(part.lo));
                sum = sum + part * Unnormalised::new(L::load(&row[0][from..]), L::load(&row[1][from..]));
            }
            sum.hi.store(&mut sums[0][from..]);
            sum.lo.store(&mut sums[1][from..]);
            from += L::WIDTH;
        }
        sums
    }
}

/// cos(pi numerator/denominator).
fn cosine(numerator: usize, denominator: usize) -> Dd {
    let turned = numerator % (2 * denominator);
    let folded = turned.min(2 * denominator - turned);
    let (sign, eighths) = if 2 * folded > denominator { (-1.0, denominator - folded) } else { (1.0, folded) };
    let angle = |part: usize| HALF_PI * (2 * part) as f64 * (Dd::ONE / Dd::from(denominator as f64));
    let value = if 4 * eighths <= denominator {
        long_sin_cos(angle(eighths)).1
    } else {
        let rest = HALF_PI - angle(eighths);
        long_sin_cos(rest).0
    };
    value.scale(sign)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A polynomial comes back, and a smooth function is followed between the points.
    #[test]
    fn coefficients_are_those_of_the_polynomial() {
        for count in COUNTS {
            let interpolation = Interpolation::of(count);
            let at = |t: Dd| Dd::ONE / (Dd::from(9.0) + t);
            let [hi, lo] = &interpolation.points;
            let values: Vec<Dd> = hi.iter().zip(lo).map(|(hi, lo)| at(Dd::new(*hi, *lo))).collect();
            let words =
                [values.iter().map(|y| y.hi).collect::<Vec<_>>(), values.iter().map(|y| y.lo).collect()];
            let coefficients = interpolation.coefficients([&words[0], &words[1]]);
            for t in [-1.0, -0.3, 0.0, 0.77, 1.0] {
                let t = Dd::from(t);
                let sum = coefficients[..count].iter().rev().fold(Dd::ZERO, |sum, c| sum * t + *c);
                let error = (sum - at(t)).hi.abs();
                assert!(error < 17f64.powi(-(count as i32)) + 1e-21, "{count} {t:?} {error:e}");
            }
        }
    }
}

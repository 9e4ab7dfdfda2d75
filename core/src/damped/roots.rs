//! The first root of a polynomial in an interval, found so that none is passed over.
//!
//! On an interval of width w from a point with Taylor coefficients b_k there is no root where |b_0| > sum |b_k| w^k (k >= 1), and
//! the polynomial is monotone where |b_1| > sum k |b_k| w^(k-1) (k >= 2): then the signs at the ends decide. Otherwise the interval
//! is halved. Where neither can be decided on 2^-30 of the whole, the polynomial and its slope vanish there to rounding: a touch,
//! which counts as a root only if the sign changes.

use super::taylor::{ORDER, places};
use crate::lanes::{Kernel, Lane, four};

const COUNT: usize = ORDER + 1;
/// Least part of the whole interval that is looked at by itself.
const LEAST: f64 = 1.0 / (1u64 << 30) as f64;
/// No polynomial of a step needs more than some ten intervals; beyond, only the signs at the ends are compared.
const MOST_INTERVALS: usize = 1000;

/// Value and slope at x; the number of coefficients is a multiple of four.
pub(super) fn value_and_slope<const N: usize>(c: &[f64; N], x: f64) -> (f64, f64) {
    four(Value::<N, false> { c, x })
}

/// Value and slope at x >= 0 with all coefficients positive.
fn bounds(c: &[f64; COUNT], x: f64) -> (f64, f64) {
    four(Value::<COUNT, true> { c, x })
}

struct Value<'a, const N: usize, const SIZES: bool> {
    c: &'a [f64; N],
    x: f64,
}

impl<const N: usize, const SIZES: bool> Kernel for Value<'_, N, SIZES> {
    type Output = (f64, f64);
    type Place = Self;
    /// The sum of x^i Q_i(x^4), i = 0 to 3, with the four Q_i side by side.
    #[inline(always)]
    fn run<L: Lane>(self) -> (f64, f64) {
        let Value { c, x } = self;
        let (square, cube) = (x * x, x * x * x);
        let fourth = L::splat(square * square);
        let (mut sum, mut slope) = (L::splat(0.0), L::splat(0.0));
        let mut k = N;
        while k > 0 {
            k -= 4;
            let row = L::load(&c[k..]);
            slope = slope.mul_add(fourth, sum);
            sum = sum.mul_add(fourth, if SIZES { row.abs() } else { row });
        }
        let ([a, b, c, d], [p, q, r, s]) = (places(sum), places(slope));
        let inner = (p + q * x) + (r + s * x) * square;
        ((a + b * x) + (c + d * x) * square, (b + 2.0 * c * x) + (3.0 * d * square + 4.0 * cube * inner))
    }
}

/// The least x in (0, end] at which the polynomial changes its sign; the zero at x = 0 of a polynomial without its lowest
/// powers is none.
pub(super) fn first_root(coefficients: &[f64; COUNT], end: f64) -> Option<f64> {
    // Without the powers that vanish at 0.
    let first = coefficients.iter().position(|c| *c != 0.0)?;
    let mut local = [0.0; COUNT];
    local[..COUNT - first].copy_from_slice(&coefficients[first..]);
    let mut at = 0.0;
    let mut shifted = local;
    let mut width = end;
    for _ in 0..MOST_INTERVALS {
        let Some(verdict) = verdict(&shifted, width) else {
            if width > LEAST * end {
                width *= 0.5;
                continue;
            }
            let (left, right) = (shifted[0], value_and_slope(&shifted, width).0);
            if left * right < 0.0 {
                return Some(at + 0.5 * width);
            }
            (at, width) = (at + width, end - at - width);
            if width <= 0.0 {
                return None;
            }
            shifted = shift(&local, at);
            continue;
        };
        if verdict {
            return Some(at + bracketed(&shifted, width));
        }
        at += width;
        width = end - at;
        if width <= 0.0 {
            return None;
        }
        shifted = shift(&local, at);
    }
    let right = value_and_slope(&local, end).0;
    (local[0] * right < 0.0).then(|| bracketed(&local, end))
}

/// Whether there is one root in (0, width], or none; `None` where that is not clear.
fn verdict(b: &[f64; COUNT], width: f64) -> Option<bool> {
    let (all, slopes) = bounds(b, width);
    if b[0].abs() > all - b[0].abs() {
        return Some(false);
    }
    if b[1].abs() <= slopes - b[1].abs() {
        return None;
    }
    let end = value_and_slope(b, width).0;
    Some(b[0] != 0.0 && (end == 0.0 || (end < 0.0) != (b[0] < 0.0)))
}

/// Coefficients of powers of x - by.
fn shift(b: &[f64; COUNT], by: f64) -> [f64; COUNT] {
    let mut shifted = *b;
    for i in 0..COUNT - 1 {
        for k in (i..COUNT - 1).rev() {
            shifted[k] += by * shifted[k + 1];
        }
    }
    shifted
}

/// The root in [0, width], over whose ends the sign changes: Newton's steps from where the chord vanishes, halving where they leave
/// the bracket.
pub(super) fn bracketed<const N: usize>(b: &[f64; N], width: f64) -> f64 {
    let negative = b[0] < 0.0;
    let end = value_and_slope(b, width).0;
    let (mut low, mut high) = (0.0, width);
    let chord = width * (b[0] / (b[0] - end));
    let mut x = if chord >= 0.0 && chord <= width { chord } else { 0.5 * width };
    // A halving gains one bit, a Newton step doubles the digits: 60 suffice for a double.
    for _ in 0..60 {
        let (value, slope) = value_and_slope(b, x);
        if value == 0.0 {
            return x;
        }
        if (value < 0.0) == negative {
            low = x
        } else {
            high = x
        }
        let newton = x - value / slope;
        let inside = newton >= low && newton <= high;
        let next = if inside { newton } else { 0.5 * (low + high) };
        // Where two of Newton's points agree to half of the digits, the second has all.
        if next == x || (inside && (next - x).abs() < 1e-9 * width) {
            return next;
        }
        x = next;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A polynomial from its roots.
    fn of_roots(roots: &[f64]) -> [f64; COUNT] {
        let mut c = [0.0; COUNT];
        c[0] = 1.0;
        for root in roots {
            for k in (0..COUNT).rev() {
                c[k] = -root * c[k] + if k > 0 { c[k - 1] } else { 0.0 };
            }
        }
        c
    }

    #[test]
    fn the_first_root_is_found() {
        let find = |roots: &[f64], end| first_root(&of_roots(roots), end);
        let near = |found: Option<f64>, root: f64| {
            assert!((found.unwrap() - root).abs() < 1e-13, "{found:?} {root}")
        };
        near(find(&[0.3], 1.0), 0.3);
        near(find(&[0.3, 0.31, 0.9], 1.0), 0.3);
        near(find(&[2.0, 3.0, 1e-3], 4.0), 1e-3);
        near(find(&[0.0, 0.5], 1.0), 0.5);
        near(find(&[0.0, 0.0, 0.7, -3.0], 1.0), 0.7);
        near(find(&[-0.1, 0.999], 1.0), 0.999);
        assert_eq!(find(&[0.0, 1.5], 1.0), None);
        assert_eq!(find(&[-0.5, 1.5], 1.0), None);
        assert_eq!(find(&[0.0], 1.0), None);
        // A touch is not a crossing, but the crossing after it is found.
        near(find(&[0.25, 0.25, 0.75], 1.0), 0.75);
        assert_eq!(find(&[0.25, 0.25], 1.0), None);
        assert_eq!(first_root(&[0.0; COUNT], 1.0), None);
    }
}

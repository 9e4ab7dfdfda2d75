//! The first root of a polynomial in an interval, found so that none is passed over.
//!
//! On an interval of width w from a point with Taylor coefficients b_k there is no root where |b_0| > sum |b_k| w^k (k >= 1), and
//! the polynomial is monotone where |b_1| > sum k |b_k| w^(k-1) (k >= 2): then the signs at the ends decide. Otherwise the interval
//! is halved. Where neither can be decided on 2^-30 of the whole, the polynomial and its slope vanish there to rounding: a touch,
//! which counts as a root only if the sign changes.

use super::taylor::ORDER;

const COUNT: usize = ORDER + 1;
/// Least part of the whole interval that is looked at by itself.
const LEAST: f64 = 1.0 / (1u64 << 30) as f64;
/// No polynomial of a step needs more than some ten intervals; beyond, only the signs at the ends are compared.
const MOST_INTERVALS: usize = 1000;

/// Value and slope at x.
pub(super) fn value_and_slope(c: &[f64], x: f64) -> (f64, f64) {
    let (mut value, mut slope) = (0.0, 0.0);
    for c in c.iter().rev() {
        slope = slope * x + value;
        value = value * x + c;
    }
    (value, slope)
}

/// Whether the polynomial is seen at once to have no root in (0, end]: between its ends it is nowhere farther from its chord than
/// end^2/8 times its largest second derivative.
pub(super) fn rootless(coefficients: &[f64; COUNT], end: f64) -> bool {
    // Without the zero at 0, if it has one.
    let c = &coefficients[usize::from(coefficients[0] == 0.0)..];
    let square = end * end;
    // Sums of every other power, so that they need not wait for each other.
    let (mut even, mut odd, mut bend, mut odd_bend) = (0.0, 0.0, 0.0, 0.0);
    for (pair, [first, second]) in c.chunks(2).zip(&SECOND_DERIVATIVE).rev() {
        let next = pair.get(1).copied().unwrap_or(0.0);
        even = even * square + pair[0];
        odd = odd * square + next;
        bend = bend * square + first * pair[0].abs();
        odd_bend = odd_bend * square + second * next.abs();
    }
    let last = odd * end + even;
    // end^2 times the sum of k (k - 1) |c_k| end^(k - 2).
    let bend = odd_bend * end + bend;
    c[0] * last > 0.0 && f64::min(c[0].abs(), last.abs()) > 0.125 * bend
}

/// k (k - 1) for k = 0 and 1, 2 and 3, ...
const SECOND_DERIVATIVE: [[f64; 2]; COUNT.div_ceil(2)] = {
    let mut all = [[0.0; 2]; COUNT.div_ceil(2)];
    let mut i = 0;
    while i < all.len() {
        let k = 2 * i;
        all[i] = [(k * k) as f64 - k as f64, (k * (k + 1)) as f64];
        i += 1;
    }
    all
};

/// The least x in (0, end] at which the polynomial changes its sign; the zero at x = 0 of a polynomial without its lowest
/// powers is none.
pub(super) fn first_root(coefficients: &[f64; COUNT], end: f64) -> Option<f64> {
    // In x/end, without the powers that vanish at 0.
    let mut b = [0.0; COUNT];
    let first = coefficients.iter().position(|c| *c != 0.0)?;
    let mut power = 1.0;
    for (b, c) in b.iter_mut().zip(&coefficients[first..]) {
        *b = c * power;
        power *= end;
    }
    let local = b;
    let mut at = 0.0;
    let mut shifted = local;
    let mut width = 1.0;
    for _ in 0..MOST_INTERVALS {
        let Some(verdict) = verdict(&shifted, width) else {
            if width > LEAST {
                width *= 0.5;
                continue;
            }
            let (left, right) = (shifted[0], value_and_slope(&shifted, width).0);
            if left * right < 0.0 {
                return Some(end * (at + 0.5 * width));
            }
            (at, width) = (at + width, 1.0 - at - width);
            if width <= 0.0 {
                return None;
            }
            shifted = shift(&local, at);
            continue;
        };
        if verdict {
            return Some(end * (at + bracketed(&shifted, width)));
        }
        at += width;
        width = 1.0 - at;
        if width <= 0.0 {
            return None;
        }
        shifted = shift(&local, at);
    }
    let right = value_and_slope(&local, 1.0).0;
    (local[0] * right < 0.0).then(|| end * bracketed(&local, 1.0))
}

/// Whether there is one root in (0, width], or none; `None` where that is not clear.
fn verdict(b: &[f64; COUNT], width: f64) -> Option<bool> {
    let (mut others, mut slopes, mut power) = (0.0, 0.0, 1.0);
    for (k, b) in b.iter().enumerate().skip(1) {
        if k > 1 {
            slopes += k as f64 * b.abs() * power;
        }
        power *= width;
        others += b.abs() * power;
    }
    if b[0].abs() > others {
        return Some(false);
    }
    if b[1].abs() <= slopes {
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

/// The root in [0, width], over whose ends the sign changes: Newton's steps, halving where they leave the bracket.
pub(super) fn bracketed(b: &[f64], width: f64) -> f64 {
    let negative = b[0] < 0.0;
    let (mut low, mut high) = (0.0, width);
    let mut x = 0.5 * width;
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
        let next = if newton >= low && newton <= high { newton } else { 0.5 * (low + high) };
        if next == x {
            return x;
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

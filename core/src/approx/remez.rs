//! The odd polynomial of least largest error to the sine on a symmetric range, by Remez's exchange.
//!
//! What is approximated is the rest of Taylor's series after the wanted degree, over its first term at the end of the
//! range: then nothing cancels, however short the range, and double-doubles do. phi, phi^3, ... are a Chebyshev
//! system on (0, phi_max], so the best sum of n of them is the one whose error has n + 1 equal peaks of alternating
//! sign there.

use super::search::peak;
use super::turning::sine;
use crate::float::{Dd, TWO_PI_LONG, Td};

/// Steps at most; each doubles the right digits once it is near.
const STEPS: usize = 60;
/// By how much of themselves the peaks may differ: the largest error is then the least one to the square of that.
const LEVEL: f64 = 1e-18;
/// Terms of the rest: they are below 2^-106 of it up to twice pi.
const TERMS: usize = 44;
/// Points between which a peak is looked for, for each coefficient.
const DENSITY: usize = 48;

/// What must be added to the `count` coefficients of Taylor's polynomial; `None` where the exchange does not end.
pub(super) fn departures(count: usize, phi_max: f64) -> Option<Vec<Td>> {
    let rest = rest(count, phi_max);
    let quarter_turn = TWO_PI_LONG.scale(0.25);
    let whole = |n: usize| Td::from(n as f64);
    // The peaks of Chebyshev's polynomial, which is the error where the first term of the rest is all of it.
    let start = |i: usize| sine(quarter_turn * whole(2 * i + 1) / whole(2 * count + 1)).hi;
    let mut points: Vec<f64> = (0..=count).map(start).collect();
    for _ in 0..STEPS {
        let fitted = levelled(&points, &rest, count)?;
        let error = [fitted.iter().map(|q| -*q).collect(), rest.clone()].concat();
        let level;
        (points, level) = peaks(&error, count)?;
        if level < LEVEL {
            return Some(unscaled(&fitted, phi_max));
        }
    }
    None
}

/// The rest of Taylor's series of sin(phi_max t), over t^(2 count + 1) and its first term at t = 1: powers of t^2.
fn rest(count: usize, phi_max: f64) -> Vec<Dd> {
    let square = -Dd::product(phi_max, phi_max);
    let mut terms = vec![Dd::ONE];
    for j in 1..TERMS {
        let power = (2 * (count + j) + 1) as f64;
        terms.push(terms[j - 1] * square / Dd::from(power * (power - 1.0)));
    }
    terms
}

/// t (c_0 + c_1 t^2 + ...).
fn odd(coefficients: &[Dd], t: f64) -> Dd {
    let square = Dd::product(t, t);
    coefficients.iter().rev().fold(Dd::ZERO, |sum, c| sum * square + *c) * t
}

/// The coefficients whose error is alike at all points, with alternating signs: Gauss's elimination.
fn levelled(points: &[f64], rest: &[Dd], count: usize) -> Option<Vec<Dd>> {
    let size = count + 1;
    let shifted = [vec![Dd::ZERO; count], rest.to_vec()].concat();
    let row = |(i, t): (usize, &f64)| {
        let square = Dd::product(*t, *t);
        let mut row = vec![Dd::from(*t)];
        for k in 1..count {
            row.push(row[k - 1] * square);
        }
        row.push(Dd::from(if i % 2 == 0 { 1.0 } else { -1.0 }));
        row.push(odd(&shifted, *t));
        row
    };
    let mut rows: Vec<Vec<Dd>> = points.iter().enumerate().map(row).collect();
    for column in 0..size {
        let largest = (column..size)
            .max_by(|a, b| rows[*a][column].hi.abs().total_cmp(&rows[*b][column].hi.abs()))
            .filter(|row| rows[*row][column].hi != 0.0)?;
        rows.swap(column, largest);
        let pivot = rows[column].clone();
        for (i, row) in rows.iter_mut().enumerate() {
            if i != column {
                let factor = row[column] / pivot[column];
                for (entry, above) in row.iter_mut().zip(&pivot).skip(column) {
                    *entry = *entry - factor * *above;
                }
            }
        }
    }
    Some((0..count).map(|k| rows[k][size] / rows[k][k]).collect())
}

/// The `count` + 1 alternating peaks of an error on (0, 1], the largest one among them, and by how much they differ.
fn peaks(error: &[Dd], count: usize) -> Option<(Vec<f64>, f64)> {
    let size = |t: f64| {
        let value = odd(error, t).abs();
        (value.hi, value.lo)
    };
    let steps = DENSITY * (count + 1);
    // Denser towards 1, as the peaks are.
    let points: Vec<f64> = (1..=steps).map(|i| i as f64 / steps as f64).map(|u| u * (2.0 - u)).collect();
    let values: Vec<f64> = points.iter().map(|t| odd(error, *t).hi).collect();
    let mut found: Vec<f64> = Vec::new();
    let mut first = 0;
    for i in 1..=steps {
        if i < steps && values[i] * values[first] > 0.0 {
            continue;
        }
        let top = (first..i).max_by(|a, b| values[*a].abs().total_cmp(&values[*b].abs())).unwrap_or(first);
        let low = if top == 0 { 0.0 } else { points[top - 1] };
        let high = points[usize::min(top + 1, steps - 1)];
        let best = peak(size, low, high);
        found.push(if size(high) > size(best) { high } else { best });
        first = i;
    }
    while found.len() > count + 1 {
        let last = found.len() - 1;
        found.remove(if size(found[0]) < size(found[last]) { 0 } else { last });
    }
    let sizes: Vec<f64> = found.iter().map(|t| size(*t).0).collect();
    let (least, most) =
        sizes.iter().fold((f64::INFINITY, 0.0), |(a, b), x| (f64::min(a, *x), f64::max(b, *x)));
    (found.len() == count + 1 && least > 0.0).then_some((found, most / least - 1.0))
}

/// From t and the first term of the rest to phi.
fn unscaled(fitted: &[Dd], phi_max: f64) -> Vec<Td> {
    let count = fitted.len();
    // phi_max^(2 count + 1)/(2 count + 1)! over phi_max^(2k + 1), with the sign of the first term left out.
    let mut factor = if count % 2 == 0 { Td::ONE } else { -Td::ONE };
    for n in 2..=2 * count + 1 {
        factor = factor / Td::from(n as f64);
    }
    let square = Td::product(phi_max, phi_max);
    let mut departures = vec![Td::ZERO; count];
    for (k, q) in fitted.iter().enumerate().rev() {
        factor = factor * square;
        departures[k] = factor * Td::from(*q);
    }
    departures
}

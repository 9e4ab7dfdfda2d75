//! Motion of rows with states of their own: (t, u0, velocity0, p, q) each. A block of them is sorted by the formula they ask
//! for, and every class is evaluated over lanes by the addition theorem (addition_theorem.rs). Rows that the lanes leave out,
//! next to a separatrix, at rest and at the ends of the range, are answered by a [`Duffing`] of the row.

use super::addition_theorem::{PerRow, SharedStart};
use super::duffing::Duffing;
use crate::lanes::{BLOCK, Classes, Columns, Evaluation, Formula, Lane, LastMade, repeats, wide};

/// The formula that a row asks for, with even powers or without; the roots are e1, e2, e3 with them.
pub(super) mod class {
    /// None of the lanes': next to a separatrix, out of range, not finite, or escaping for certain with even powers.
    pub const FALLBACK: usize = 0;
    /// Real roots, and m <= 1/2.
    pub const CIRCULAR: usize = 1;
    /// Real roots, and m > 1/2.
    pub const HYPERBOLIC: usize = 2;
    /// Two complex roots, and m <= 1/2.
    pub const PAIR_CIRCULAR: usize = 3;
    /// Two complex roots, and m > 1/2.
    pub const PAIR_HYPERBOLIC: usize = 4;
    /// How many.
    pub const COUNT: usize = 5;
}

/// What is not 0 lies between these: products of several, with their errors, stay in range.
const SMALL: f64 = 1e-30;
const LARGE: f64 = 1e30;

/// How much of the terms of the energy and of the discriminant must be left of them.
const LEAST: f64 = 1e-9;

/// The class of u0, velocity0, p, q, from sums of a few roundings.
struct Classify;

impl Formula<4, 1> for Classify {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [u0, velocity0, p, q]: [L; 4]) -> [L; 1] {
        let (zero, half) = (L::splat(0.0), L::splat(0.5));
        let code = |class: usize| L::splat(class as f64);
        let fallback = code(class::FALLBACK);
        let (square, p_size) = (u0 * u0, p.abs());
        let (cubic, q_velocity_square) = (q * square, q * (velocity0 * velocity0));
        let stiffness = p + cubic;
        let discriminant = stiffness.mul_add(stiffness, q_velocity_square + q_velocity_square);
        let minus_e = (q_velocity_square + cubic * cubic.mul_add(half, p)) * half;
        let p_square = p * p;
        let terms = cubic.abs().mul_add(cubic.abs() + p_size, q_velocity_square.abs());
        let root = discriminant.abs().sqrt();
        let large = (root + p_size) * half;
        let small = minus_e.abs() / large;
        let (circular, hyperbolic) = (code(class::CIRCULAR), code(class::HYPERBOLIC));
        let (below, above) = (small.less(root), root.less(small));
        let of_s_over_c = L::select(below, hyperbolic, circular);
        let of_s_over_n = L::select(above, hyperbolic, circular);
        let of_s_over_d = L::select(p.less(zero), hyperbolic, circular);
        let real = L::select(p.less(zero), of_s_over_c, of_s_over_n);
        let real = L::select(zero.less(minus_e), of_s_over_d, real);
        let pair = L::select(zero.less(p), code(class::PAIR_HYPERBOLIC), code(class::PAIR_CIRCULAR));
        let found = L::select(discriminant.less(zero), pair, real);
        // Every comparison is false for NaN.
        let least = L::splat(LEAST);
        let kept = (least * (terms + p_square)).less(discriminant.abs());
        let known = L::select(kept, found, fallback);
        // For q >= 0 the discriminant is a sum of squares.
        let found = L::select(q.less(zero), known, found);
        let found = L::select((least * terms).less(p_square + minus_e.abs()), found, fallback);
        let mut found = found;
        let mut i = 0;
        let given = [u0, velocity0, p, q];
        while i < 4 {
            let size = given[i].abs();
            let size = L::select(size.equal(zero), L::splat(1.0), size);
            let in_range = L::select(size.less(L::splat(LARGE)), found, fallback);
            found = L::select(L::splat(SMALL).less(size), in_range, fallback);
            i += 1;
        }
        [found]
    }
}

/// All rows by the formula of a class that is not the fallback, from the start of the first.
fn from_shared_start(class: usize, start: [f64; 4], t: &[f64], results: [&mut [f64]; 2]) {
    match class {
        class::CIRCULAR => wide(SharedStart::<false, false> { start, t, results }),
        class::HYPERBOLIC => wide(SharedStart::<false, true> { start, t, results }),
        class::PAIR_CIRCULAR => wide(SharedStart::<true, false> { start, t, results }),
        _ => wide(SharedStart::<true, true> { start, t, results }),
    }
}

/// Up to a block of rows, by their classes; NaN for the fallback, infinite beyond an escape.
fn block(sorted: &mut Classes<5, 2, { class::COUNT }>, arguments: [&[f64]; 5], results: [&mut [f64]; 2]) {
    let [t, start @ ..] = arguments;
    let rows = t.len();
    let mut codes = [0.0; BLOCK];
    let codes = &mut codes[..rows];
    Columns::new(start, [&mut *codes]).of(&Classify);
    if codes[0] as usize != class::FALLBACK && repeats(start) {
        return from_shared_start(codes[0] as usize, start.map(|column| column[0]), t, results);
    }
    sorted.filled(codes, arguments, results, |class, columns| match class {
        class::CIRCULAR => columns.of(&PerRow::<false, false>),
        class::HYPERBOLIC => columns.of(&PerRow::<false, true>),
        class::PAIR_CIRCULAR => columns.of(&PerRow::<true, false>),
        class::PAIR_HYPERBOLIC => columns.of(&PerRow::<true, true>),
        _ => columns.fill(f64::NAN),
    });
}

/// Fills u and u' of every row, a block after the other; `one` answers the rows for which `block` has no number, but for those that it
/// tells to be infinite, beyond an escape, which have none.
pub(super) fn in_blocks<const N: usize>(
    arguments: [&[f64]; N],
    [u, velocity]: [&mut [f64]; 2],
    mut block: impl FnMut([&[f64]; N], [&mut [f64]; 2]),
    mut one: impl FnMut([f64; N]) -> Option<(f64, f64)>,
) {
    let rows = arguments[0].len();
    let fits = arguments.iter().all(|column| column.len() == rows);
    assert!(fits && u.len() == rows && velocity.len() == rows, "columns of different lengths");
    for from in (0..rows).step_by(BLOCK) {
        let rows = from..rows.min(from + BLOCK);
        let arguments = arguments.map(|argument| &argument[rows.clone()]);
        block(arguments, [&mut u[rows.clone()], &mut velocity[rows]]);
    }
    for row in 0..rows {
        if u[row].is_finite() && velocity[row].is_finite() {
            continue;
        }
        let given = arguments.map(|column| column[row]);
        let none = u[row].is_infinite() || given[0].is_nan();
        let found = if none { None } else { one(given) };
        (u[row], velocity[row]) = found.unwrap_or((f64::NAN, f64::NAN));
    }
}

/// u and u' of every row: each a motion of its own.
///
/// NaN where an argument is not finite, beyond an escape, and more than 2^53 half periods away; panics where the lengths differ.
/// **Error** as for [`Duffing::u`] and [`Duffing::velocity`], whose digits need not be the same. **Source** Euler's addition
/// theorem, DLMF 22.8.
///
/// ```
/// let (mut u, mut velocity) = ([0.0; 2], [0.0; 2]);
/// let rows = [&[1.0, 1.0], &[1.0, 0.0], &[0.0, 1.0], &[1.0, -1.0], &[1.0, 2.0]].map(|column| column.as_slice());
/// libration::oscillator::duffing_motion_into(rows, [&mut u, &mut velocity]);
/// assert_eq!(format!("{:.9} {:.9}", u[0], velocity[1]), "0.233691791 0.932682266");
/// ```
pub fn duffing_motion_into(arguments: [&[f64]; 5], results: [&mut [f64]; 2]) {
    let mut sorted = Classes::new();
    let mut made = LastMade::new();
    in_blocks(
        arguments,
        results,
        |arguments, results| block(&mut sorted, arguments, results),
        |[t, start @ ..]| {
            let [u0, velocity0, p, q] = start;
            made.of(start, || Duffing::new(u0, velocity0, p, q).ok()).as_ref().map(|orbit| orbit.motion(t))
        },
    );
}

//! Motion of rows with a quintic force and states of their own: (t, u0, velocity0, p, q, s) each. A block of them is sorted by the
//! formula that its rows ask for, and every class is evaluated over lanes (quintic_rows.rs). Rows that the lanes leave out, next
//! to a separatrix or to an escape, and from a barrier of which two roots are complex, are answered by a [`CubicQuintic`] of the row.

use super::batch::{class, in_blocks};
use super::cubic_quintic::CubicQuintic;
use super::quintic_rows::{QuinticPerRow, QuinticSharedStart};
use super::quintic_start::ClassifyQuintic;
use crate::lanes::{BLOCK, Classes, Columns, Evaluation, LastMade, repeats, wide};

/// Blocks sorted by class.
type SortedQuintic = Classes<6, 2, { class::COUNT }>;

/// All rows by the formula of a class that is not the fallback, from the start of the first.
fn from_shared_start(class: usize, start: [f64; 5], t: &[f64], results: [&mut [f64]; 2]) {
    match class {
        class::CIRCULAR => wide(QuinticSharedStart::<false, false> { start, t, results }),
        class::HYPERBOLIC => wide(QuinticSharedStart::<false, true> { start, t, results }),
        class::PAIR_CIRCULAR => wide(QuinticSharedStart::<true, false> { start, t, results }),
        _ => wide(QuinticSharedStart::<true, true> { start, t, results }),
    }
}

/// Up to a block of rows, by their classes; NaN for the fallback, infinite beyond an escape.
fn block(sorted: &mut SortedQuintic, arguments: [&[f64]; 6], results: [&mut [f64]; 2]) {
    let [t, start @ ..] = arguments;
    let mut codes = [0.0; BLOCK];
    let codes = &mut codes[..t.len()];
    Columns::new(start, [&mut *codes]).of(&ClassifyQuintic);
    if codes[0] as usize != class::FALLBACK && repeats(start) {
        return from_shared_start(codes[0] as usize, start.map(|column| column[0]), t, results);
    }
    sorted.filled(codes, arguments, results, |class, columns| match class {
        class::CIRCULAR => columns.of(&QuinticPerRow::<false, false>),
        class::HYPERBOLIC => columns.of(&QuinticPerRow::<false, true>),
        class::PAIR_CIRCULAR => columns.of(&QuinticPerRow::<true, false>),
        class::PAIR_HYPERBOLIC => columns.of(&QuinticPerRow::<true, true>),
        _ => columns.fill(f64::NAN),
    });
}

/// u and u' of every row of t, u0, velocity0, p, q and s: each a motion of its own.
///
/// NaN where an argument is not finite, beyond an escape, and more than 2^53 half periods away; panics where the lengths differ.
/// **Error** as for [`CubicQuintic::u`] and [`CubicQuintic::velocity`], whose digits need not be the same. **Source** Euler's addition
/// theorem, DLMF 22.8.
///
/// ```
/// let (mut u, mut velocity) = ([0.0; 2], [0.0; 2]);
/// let rows = [&[1.0, 1.0], &[0.5, 1.0], &[0.0; 2], &[1.0; 2], &[1.0; 2], &[1.0; 2]].map(|column| column.as_slice());
/// libration::oscillator::cubic_quintic_rows_into(rows, [&mut u, &mut velocity]);
/// assert_eq!(format!("{:.6} {:.9}", u[0], u[1]), "0.217924 0.041948934");
/// ```
pub fn cubic_quintic_rows_into(arguments: [&[f64]; 6], results: [&mut [f64]; 2]) {
    let mut sorted = Classes::new();
    let mut made = LastMade::new();
    in_blocks(
        arguments,
        results,
        |arguments, results| block(&mut sorted, arguments, results),
        |[t, start @ ..]| {
            let [u0, velocity0, p, q, s] = start;
            made.of(start, || CubicQuintic::new(u0, velocity0, p, q, s).ok())
                .as_ref()
                .map(|orbit| orbit.motion(t))
        },
    );
}

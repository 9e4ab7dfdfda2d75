//! Motion of rows with states of their own: (t, u0, velocity0, p, q, r, c) each. Without even powers those of batch.rs; with them a
//! block is sorted by the formula that its rows ask for, and every class is evaluated over lanes (even_rows.rs). Rows that the lanes
//! leave out, escapes, separatrices and what is next to them, are answered by a [`Duffing`] of the row.

use super::batch::{class, duffing_motion_into, in_blocks};
use super::duffing::Duffing;
use super::even_rows::{EvenPerRow, EvenSharedStart};
use super::even_start::ClassifyEven;
use crate::lanes::{BLOCK, Classes, Columns, Evaluation, LastMade, repeats, wide};

/// Blocks sorted by class.
type Sorted = Classes<7, 2, { class::COUNT }>;

/// All rows by the formula of a class that is not the fallback, from the start of the first.
fn from_shared_start(class: usize, start: [f64; 6], t: &[f64], results: [&mut [f64]; 2]) {
    match class {
        class::CIRCULAR => wide(EvenSharedStart::<false, false> { start, t, results }),
        class::HYPERBOLIC => wide(EvenSharedStart::<false, true> { start, t, results }),
        class::PAIR_CIRCULAR => wide(EvenSharedStart::<true, false> { start, t, results }),
        _ => wide(EvenSharedStart::<true, true> { start, t, results }),
    }
}

/// Up to a block of rows with even powers, by their classes; NaN for the fallback.
fn block(sorted: &mut Sorted, arguments: [&[f64]; 7], results: [&mut [f64]; 2]) {
    let [t, start @ ..] = arguments;
    let mut codes = [0.0; BLOCK];
    let codes = &mut codes[..t.len()];
    Columns::new(start, [&mut *codes]).of(&ClassifyEven);
    if codes[0] as usize != class::FALLBACK && repeats(start) {
        return from_shared_start(codes[0] as usize, start.map(|column| column[0]), t, results);
    }
    sorted.filled(codes, arguments, results, |class, columns| match class {
        class::CIRCULAR => columns.of(&EvenPerRow::<false, false>),
        class::HYPERBOLIC => columns.of(&EvenPerRow::<false, true>),
        class::PAIR_CIRCULAR => columns.of(&EvenPerRow::<true, false>),
        class::PAIR_HYPERBOLIC => columns.of(&EvenPerRow::<true, true>),
        _ => columns.fill(f64::NAN),
    });
}

/// Rows of which all have even powers.
fn with_even_powers(sorted: &mut Option<Sorted>, arguments: [&[f64]; 7], results: [&mut [f64]; 2]) {
    let sorted = sorted.get_or_insert_with(Classes::new);
    let mut made = LastMade::new();
    in_blocks(
        arguments,
        results,
        |arguments, results| block(sorted, arguments, results),
        |[t, start @ ..]| {
            let [u0, velocity0, force @ ..] = start;
            let orbit = made.of(start, || Duffing::with_even_powers(u0, velocity0, force).ok());
            orbit.as_ref().map(|orbit| orbit.motion(t))
        },
    );
}

/// u and u' of every row of t, u0, velocity0, p, q, r and c: [`duffing_motion_into`] where r and c are 0, bit for bit, else by the
/// same division of labour.
///
/// NaN and panics as there.
/// **Error** as for [`Duffing::u`] and [`Duffing::velocity`], whose digits need not be the same. **Source** Weierstrass' solution of
/// u'^2 = P(u), Whittaker & Watson 20.6.
///
/// ```
/// let (mut u, mut velocity) = ([0.0; 2], [0.0; 2]);
/// let rows = [&[1.0, 1.0], &[1.0, 1.0], &[0.0; 2], &[1.0; 2], &[1.0, 0.2], &[0.0, 0.5], &[0.0; 2]];
/// libration::oscillator::duffing_rows_into(rows.map(|column| column.as_slice()), [&mut u, &mut velocity]);
/// assert_eq!(format!("{:.9} {:.9}", u[0], u[1]), "0.233691791 0.300026789");
/// ```
pub fn duffing_rows_into(arguments: [&[f64]; 7], [u, velocity]: [&mut [f64]; 2]) {
    let rows = arguments[0].len();
    let fits = arguments.iter().all(|column| column.len() == rows);
    assert!(fits && u.len() == rows && velocity.len() == rows, "columns of different lengths");
    let [t, u0, velocity0, p, q, r, c] = arguments;
    let odd = |row: usize| r[row] == 0.0 && c[row] == 0.0;
    let mut sorted = None;
    let mut from = 0;
    while from < rows {
        let end = (from..rows).find(|row| odd(*row) != odd(from)).unwrap_or(rows);
        let part = from..end;
        let results = [&mut u[part.clone()], &mut velocity[part.clone()]];
        if odd(from) {
            let columns = [t, u0, velocity0, p, q].map(|column| &column[part.clone()]);
            duffing_motion_into(columns, results);
        } else {
            with_even_powers(&mut sorted, arguments.map(|column| &column[part.clone()]), results);
        }
        from = end;
    }
}

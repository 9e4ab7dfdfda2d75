//! Counts of particles by equal bins of some quantities together.

/// Equal bins of [low, high).
#[derive(Clone, Copy, Debug)]
pub struct Bins {
    /// Lower end.
    pub low: f64,
    /// Upper end, above it.
    pub high: f64,
    /// How many, positive.
    pub count: usize,
}

/// Rows placed together.
const GROUP: usize = 256;

/// Adds to `counts` how many rows are in each bin of all quantities together, the last quantity the fastest; the last count is that of
/// the rows that are in none. Panics where the lengths differ.
///
/// ```
/// use libration::ensemble::{Bins, histogram_into};
/// let mut counts = [0; 5];
/// histogram_into(&[&[0.0, 0.3, 0.9, 1.0, 2.0]], &[Bins { low: 0.0, high: 1.0, count: 4 }], &mut counts);
/// assert_eq!(counts, [1, 1, 0, 1, 2]);
/// ```
pub fn histogram_into(columns: &[&[f64]], bins: &[Bins], counts: &mut [i64]) {
    let rows = columns.first().map_or(0, |column| column.len());
    let cells = bins.iter().map(|bins| bins.count).product::<usize>();
    let fits = columns.len() == bins.len() && columns.iter().all(|column| column.len() == rows);
    assert!(fits && counts.len() == cells + 1, "columns of different lengths");
    for from in (0..rows).step_by(GROUP) {
        let to = rows.min(from + GROUP);
        let (mut places, mut inside) = ([0; GROUP], [true; GROUP]);
        for (column, bins) in columns.iter().zip(bins) {
            place(&column[from..to], *bins, &mut places, &mut inside);
        }
        for (place, inside) in places.iter().zip(inside).take(to - from) {
            counts[if inside { *place } else { cells }] += 1;
        }
    }
}

/// Goes from the place among the bins of the quantities before to that with one more.
fn place(values: &[f64], bins: Bins, places: &mut [usize; GROUP], inside: &mut [bool; GROUP]) {
    let Bins { low, high, count } = bins;
    let (width, many) = (high - low, count as f64);
    for ((value, place), inside) in values.iter().zip(places).zip(inside) {
        *inside &= low <= *value && *value < high;
        let number = (value - low) / width * many;
        // What is not in a bin saturates; below the upper end a quotient may still be rounded to the number of bins.
        *place = *place * count + (number as u32 as usize).min(count - 1);
    }
}

//! Rows that ask for different formulas: a block of them is sorted by class, so that each formula has whole lanes.

use super::formula::{Columns, Evaluation, Formula};

/// Rows sorted at a time.
pub const BLOCK: usize = 512;

/// More rows than the widest lane has places: from here on one set-up for all is faster.
const ENOUGH: usize = 16;

/// Whether columns have enough rows, and in all of them the first value, bit for bit: rows that one set-up serves.
pub fn repeats<const N: usize>(columns: [&[f64]; N]) -> bool {
    let same = |column: &[f64]| column.iter().all(|value| value.to_bits() == column[0].to_bits());
    columns[0].len() > ENOUGH && columns.into_iter().all(same)
}

/// The rows of each class in a block, and their columns side by side; made once for many blocks.
pub struct Classes<const A: usize, const R: usize, const COUNT: usize> {
    members: [[u16; BLOCK]; COUNT],
    arguments: [[f64; BLOCK]; A],
    results: [[f64; BLOCK]; R],
}

impl<const A: usize, const R: usize, const COUNT: usize> Classes<A, R, COUNT> {
    /// Empty.
    pub fn new() -> Self {
        Classes { members: [[0; BLOCK]; COUNT], arguments: [[0.0; BLOCK]; A], results: [[0.0; BLOCK]; R] }
    }

    /// Has `fill` fill the columns of each class that occurs; at most [`BLOCK`] rows. `codes` are whole numbers below COUNT.
    pub fn filled(
        &mut self,
        codes: &[f64],
        arguments: [&[f64]; A],
        mut results: [&mut [f64]; R],
        fill: impl Fn(usize, Columns<A, R>),
    ) {
        if codes.iter().all(|code| *code == codes[0]) {
            return fill(codes[0] as usize, Columns::new(arguments, results));
        }
        let mut counts = [0; COUNT];
        for (row, code) in codes.iter().enumerate() {
            let class = *code as usize;
            self.members[class][counts[class]] = row as u16;
            counts[class] += 1;
        }
        for (class, count) in counts.into_iter().enumerate().filter(|(_, count)| *count > 0) {
            let members = &self.members[class][..count];
            for (column, argument) in self.arguments.iter_mut().zip(arguments) {
                for (entry, row) in column.iter_mut().zip(members) {
                    *entry = argument[usize::from(*row)];
                }
            }
            let gathered = self.arguments.each_ref().map(|column| &column[..count]);
            let sorted = self.results.each_mut().map(|column| &mut column[..count]);
            fill(class, Columns::new(gathered, sorted));
            for (result, column) in results.iter_mut().zip(&self.results) {
                for (value, row) in column.iter().zip(members) {
                    result[usize::from(*row)] = *value;
                }
            }
        }
    }
}

/// Rows by the classes that `classify` finds in argument `key` of each: `fill` fills the columns of a class, and `careful`
/// answers the rows where that leaves a NaN that no argument is. Panics where the lengths differ.
pub fn by_class<const A: usize, const R: usize, const COUNT: usize>(
    classify: &impl Formula<1, 1>,
    key: usize,
    arguments: [&[f64]; A],
    mut results: [&mut [f64]; R],
    fill: impl Fn(usize, Columns<A, R>),
    careful: impl Fn([f64; A]) -> [f64; R],
) {
    let rows = arguments[key].len();
    let fits = arguments.iter().all(|argument| argument.len() == rows)
        && results.iter().all(|result| result.len() == rows);
    assert!(fits, "columns of different lengths");
    let mut classes = Classes::<A, R, COUNT>::new();
    let mut codes = [0.0; BLOCK];
    for from in (0..rows).step_by(BLOCK) {
        let block = from..rows.min(from + BLOCK);
        let codes = &mut codes[..block.len()];
        let arguments = arguments.map(|argument| &argument[block.clone()]);
        Columns::new([arguments[key]], [&mut *codes]).of(classify);
        classes.filled(codes, arguments, results.each_mut().map(|result| &mut result[block.clone()]), &fill);
    }
    for row in 0..rows {
        let undefined = arguments.iter().any(|argument| argument[row].is_nan());
        if !undefined && results.iter().any(|result| result[row].is_nan()) {
            let values = careful(arguments.map(|argument| argument[row]));
            for (result, value) in results.iter_mut().zip(values) {
                result[row] = value;
            }
        }
    }
}

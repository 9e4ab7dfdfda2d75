//! Rows that ask for different formulas: a block of them is sorted by class, so that each formula has whole lanes.

use super::formula::Columns;

/// Rows sorted at a time.
pub const BLOCK: usize = 512;

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

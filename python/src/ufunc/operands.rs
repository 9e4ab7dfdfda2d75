//! The operands of a ufunc's loop: where NumPy has them, and which of them may be read or written in place.

use std::array;
use std::ffi::c_char;
use std::slice;

use numpy::npyffi::npy_intp;

/// Operands of the widest ufunc: seven inputs of the set-up, one sample, twelve results.
pub const WIDEST: usize = 20;

/// The operands of a loop: operand `i` of row `j` at `at[i] + j * steps[i]`.
#[derive(Clone, Copy)]
pub struct Operands<const O: usize> {
    /// Addresses of the first row.
    pub at: [*mut c_char; O],
    /// Bytes from a row to the next.
    pub steps: [npy_intp; O],
}

// SAFETY: NumPy lets the loop read and write these addresses until it returns, from whichever thread; the threads of
// one loop have rows of their own.
unsafe impl<const O: usize> Sync for Operands<O> {}

impl<const O: usize> Operands<O> {
    /// The operands from a row on.
    pub fn starting(&self, row: usize) -> Self {
        // SAFETY: the row is inside the loop, so the addresses are inside the operands.
        let at = array::from_fn(|i| unsafe { self.at[i].offset(row as npy_intp * self.steps[i]) });
        Operands { at, steps: self.steps }
    }

    /// Input `i` of a row.
    pub fn read(&self, i: usize, row: usize) -> f64 {
        // SAFETY: an input operand is an aligned, readable float64 in every row of the loop.
        unsafe { self.at[i].offset(row as npy_intp * self.steps[i]).cast::<f64>().read() }
    }

    /// Some rows of input `i` where they lie, if they lie side by side.
    pub fn side_by_side(&self, i: usize, row: usize, rows: usize) -> Option<&[f64]> {
        // SAFETY: as for `read`, row after row; nothing is written while the rows are in use.
        (self.steps[i] == size_of::<f64>() as npy_intp)
            .then(|| unsafe { slice::from_raw_parts(self.at[i].cast::<f64>().add(row), rows) })
    }

    /// First and last byte of an operand.
    fn extent(&self, i: usize, rows: usize) -> (isize, isize) {
        let start = self.at[i] as isize;
        let end = start + self.steps[i] * (rows.max(1) as isize - 1);
        (start.min(end), start.max(end) + 7)
    }

    /// Whether two operands have a byte in common, or the space between their bytes.
    fn meet(&self, i: usize, j: usize, rows: usize) -> bool {
        let ((first, last), (other_first, other_last)) = (self.extent(i, rows), self.extent(j, rows));
        last >= other_first && other_last >= first
    }

    /// Whether a row may be written before another is read: then rows go one by one. NumPy copies overlapping
    /// operands beforehand, but its reductions and accumulations feed results back.
    pub fn fed_back(&self, inputs: usize, outputs: usize, rows: usize) -> bool {
        let feeds = |o: usize, i: usize| {
            let (step, other_step) = (self.steps[o], self.steps[i]);
            let apart = self.at[o] as isize - self.at[i] as isize;
            let same_rows = apart == 0 && step == other_step;
            // Columns of one table: the same step, and never in each other's place.
            let interleaved = step == other_step && step != 0 && {
                let within = apart.rem_euclid(step.abs());
                within >= 8 && within <= step.abs() - 8
            };
            self.meet(o, i, rows) && !same_rows && !interleaved
        };
        rows > 1 && (inputs..inputs + outputs).any(|o| self.steps[o] == 0 || (0..inputs).any(|i| feeds(o, i)))
    }

    /// Whether a kernel may write output `o` in place: side by side, and apart from every other of `count` operands.
    pub fn in_place(&self, o: usize, count: usize, rows: usize) -> bool {
        self.steps[o] == size_of::<f64>() as npy_intp && (0..count).all(|i| i == o || !self.meet(o, i, rows))
    }
}

//! Rows that ask for different formulas: a block of them is sorted by class, so that each formula has whole lanes.

use super::dispatch::wide;
use super::formula::{Columns, Evaluation, Formula};
use super::lane::{Kernel, Lane, WIDEST};

/// Rows sorted at a time.
pub const BLOCK: usize = 512;

/// More rows than the widest lane has places: from here on one set-up for all is faster.
const ENOUGH: usize = 16;

/// Whether columns have enough rows, and in all of them the first value, bit for bit: rows that one set-up serves.
pub fn repeats<const N: usize>(columns: [&[f64]; N]) -> bool {
    let same = |column: &[f64]| column.iter().all(|value| value.to_bits() == column[0].to_bits());
    columns[0].len() > ENOUGH && columns.into_iter().all(same)
}

/// Room for them and for what a vector writes beyond.
const ROOM: usize = BLOCK + WIDEST;

/// The columns of one class of a block side by side; made once for many blocks.
pub struct Classes<const A: usize, const R: usize, const COUNT: usize> {
    arguments: [[f64; ROOM]; A],
    results: [[f64; ROOM]; R],
}

impl<const A: usize, const R: usize, const COUNT: usize> Classes<A, R, COUNT> {
    /// Empty.
    pub fn new() -> Self {
        Classes { arguments: [[0.0; ROOM]; A], results: [[0.0; ROOM]; R] }
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
        for class in 0..COUNT {
            self.only(class, codes, arguments, &mut results, &fill);
        }
    }

    /// Has `fill` fill the columns of one class, if it occurs; the other rows keep their results.
    pub fn only(
        &mut self,
        class: usize,
        codes: &[f64],
        arguments: [&[f64]; A],
        results: &mut [&mut [f64]; R],
        fill: impl Fn(usize, Columns<A, R>),
    ) {
        let code = class as f64;
        let count =
            wide(Members { codes, code, moved: Gathering { arguments, members: &mut self.arguments } });
        if count == 0 {
            return;
        }
        let members = self.arguments.each_ref().map(|column| &column[..count]);
        let sorted = self.results.each_mut().map(|column| &mut column[..count]);
        fill(class, Columns::new(members, sorted));
        wide(Members { codes, code, moved: Scattering { members: &self.results, results } });
    }
}

/// What is done with the rows of one class, whose entries stand side by side in `members`.
trait Move {
    /// With those of a lane of rows from `at` on; `count` were before them. How many they are.
    fn several<L: Lane>(&mut self, mask: L::Mask, at: usize, count: usize) -> usize;
    /// With one.
    fn one(&mut self, at: usize, count: usize);
}

/// From the rows to the members.
struct Gathering<'a, 'b, const A: usize> {
    arguments: [&'a [f64]; A],
    members: &'b mut [[f64; ROOM]; A],
}

/// The way back.
struct Scattering<'a, 'b, 'c, const R: usize> {
    members: &'a [[f64; ROOM]; R],
    results: &'b mut [&'c mut [f64]; R],
}

impl<const A: usize> Move for Gathering<'_, '_, A> {
    #[inline(always)]
    fn several<L: Lane>(&mut self, mask: L::Mask, at: usize, count: usize) -> usize {
        let (mut found, mut i) = (0, 0);
        while i < A {
            found = L::load(&self.arguments[i][at..]).pack(mask, &mut self.members[i][count..]);
            i += 1;
        }
        found
    }
    #[inline(always)]
    fn one(&mut self, at: usize, count: usize) {
        let mut i = 0;
        while i < A {
            self.members[i][count] = self.arguments[i][at];
            i += 1;
        }
    }
}

impl<const R: usize> Move for Scattering<'_, '_, '_, R> {
    #[inline(always)]
    fn several<L: Lane>(&mut self, mask: L::Mask, at: usize, count: usize) -> usize {
        let (mut found, mut i) = (0, 0);
        while i < R {
            let (values, taken) = L::load(&self.results[i][at..]).unpack(mask, &self.members[i][count..]);
            values.store(&mut self.results[i][at..]);
            found = taken;
            i += 1;
        }
        found
    }
    #[inline(always)]
    fn one(&mut self, at: usize, count: usize) {
        let mut i = 0;
        while i < R {
            self.results[i][at] = self.members[i][count];
            i += 1;
        }
    }
}

/// The rows whose code is this one, in order.
struct Members<'a, M> {
    codes: &'a [f64],
    code: f64,
    moved: M,
}

impl<M: Move> Kernel for Members<'_, M> {
    /// How many rows.
    type Output = usize;
    type Place = Self;
    #[inline(always)]
    fn run<L: Lane>(self) -> usize {
        let Members { codes, code, mut moved } = self;
        let (mut count, mut at) = (0, 0);
        while codes.len() - at >= L::WIDTH {
            let mask = L::load(&codes[at..]).equal(L::splat(code));
            if L::any(mask) {
                count += moved.several::<L>(mask, at, count);
            }
            at += L::WIDTH;
        }
        while at < codes.len() {
            if codes[at] == code {
                moved.one(at, count);
                count += 1;
            }
            at += 1;
        }
        count
    }
}

/// Rows by the classes that `classify` finds in argument `key` of each: `fill` fills the columns of a class, and `careful`
/// answers the rows where that leaves a NaN that no argument is. Panics where the lengths differ.
pub fn by_class<const A: usize, const R: usize, const COUNT: usize>(
    classify: &impl Formula<1, 1>,
    key: usize,
    all: [&[f64]; A],
    mut results: [&mut [f64]; R],
    fill: impl Fn(usize, Columns<A, R>),
    careful: impl Fn([f64; A]) -> [f64; R],
) {
    let rows = all[key].len();
    let fits = all.iter().all(|argument| argument.len() == rows)
        && results.iter().all(|result| result.len() == rows);
    assert!(fits, "columns of different lengths");
    let mut classes = Classes::<A, R, COUNT>::new();
    let mut codes = [0.0; BLOCK];
    for from in (0..rows).step_by(BLOCK) {
        let block = from..rows.min(from + BLOCK);
        let codes = &mut codes[..block.len()];
        let arguments = all.map(|argument| &argument[block.clone()]);
        Columns::new([arguments[key]], [&mut *codes]).of(classify);
        classes.filled(codes, arguments, results.each_mut().map(|result| &mut result[block.clone()]), &fill);
        if !results.iter().any(|result| holds_nan(&result[block.clone()])) {
            continue;
        }
        for row in block {
            let values = all.map(|argument| argument[row]);
            if !values.iter().any(|value| value.is_nan()) && results.iter().any(|result| result[row].is_nan())
            {
                for (result, value) in results.iter_mut().zip(careful(values)) {
                    result[row] = value;
                }
            }
        }
    }
}

/// Whether any is a NaN; without a way out, so that it takes several at a time.
fn holds_nan(column: &[f64]) -> bool {
    column.iter().fold(false, |any, value| any | value.is_nan())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::InstructionSet;

    struct Tenfold;

    impl Formula<1, 1> for Tenfold {
        type Place = Self;
        #[inline(always)]
        fn at<L: Lane>(&self, [x]: [L; 1]) -> [L; 1] {
            [x * L::splat(10.0)]
        }
    }

    /// Each class adds itself to its rows; of any length, on every set.
    #[test]
    fn rows_come_back_to_their_places() {
        for set in InstructionSet::available() {
            set.scope(|| {
                for rows in (1..70).chain([BLOCK - 1, BLOCK]) {
                    let row = |i: usize| i as f64;
                    let codes: Vec<f64> = (0..rows).map(|i| f64::from((i * i / 7 % 5 % 3) as u32)).collect();
                    let arguments: Vec<f64> = (0..rows).map(row).collect();
                    let mut results = vec![-1.0; rows];
                    Classes::<1, 1, 4>::new().filled(
                        &codes,
                        [&arguments],
                        [&mut results],
                        |class, columns| {
                            let Columns { arguments: [from], results: [to], .. } = columns;
                            Columns::new([from], [&mut *to]).of(&Tenfold);
                            to.iter_mut().for_each(|value| *value += class as f64);
                        },
                    );
                    for (i, result) in results.into_iter().enumerate() {
                        assert_eq!(result, 10.0 * row(i) + codes[i], "{set:?} {rows} {i}");
                    }
                }
            })
            .unwrap();
        }
    }
}

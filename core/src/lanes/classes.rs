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
            let code = class as f64;
            let count = wide(Gathering { codes, code, arguments, members: &mut self.arguments });
            if count == 0 {
                continue;
            }
            let members = self.arguments.each_ref().map(|column| &column[..count]);
            let sorted = self.results.each_mut().map(|column| &mut column[..count]);
            fill(class, Columns::new(members, sorted));
            wide(Scattering { codes, code, members: &self.results, results: &mut results });
        }
    }
}

/// The rows of one class, side by side.
struct Gathering<'a, 'b, const A: usize> {
    codes: &'a [f64],
    code: f64,
    arguments: [&'a [f64]; A],
    members: &'b mut [[f64; ROOM]; A],
}

/// The way back.
struct Scattering<'a, 'b, 'c, const R: usize> {
    codes: &'a [f64],
    code: f64,
    members: &'a [[f64; ROOM]; R],
    results: &'b mut [&'c mut [f64]; R],
}

/// Where both are compiled.
struct Here;

impl<const A: usize> Kernel for Gathering<'_, '_, A> {
    /// How many rows.
    type Output = usize;
    type Place = Here;
    #[inline(always)]
    fn run<L: Lane>(self) -> usize {
        let Gathering { codes, code, arguments, members } = self;
        let (mut count, mut at) = (0, 0);
        while codes.len() - at >= L::WIDTH {
            let mask = L::load(&codes[at..]).equal(L::splat(code));
            if L::any(mask) {
                let (mut found, mut i) = (0, 0);
                while i < A {
                    found = L::load(&arguments[i][at..]).pack(mask, &mut members[i][count..]);
                    i += 1;
                }
                count += found;
            }
            at += L::WIDTH;
        }
        while at < codes.len() {
            if codes[at] == code {
                let mut i = 0;
                while i < A {
                    members[i][count] = arguments[i][at];
                    i += 1;
                }
                count += 1;
            }
            at += 1;
        }
        count
    }
}

impl<const R: usize> Kernel for Scattering<'_, '_, '_, R> {
    type Output = ();
    type Place = Here;
    #[inline(always)]
    fn run<L: Lane>(self) {
        let Scattering { codes, code, members, results } = self;
        let (mut count, mut at) = (0, 0);
        while codes.len() - at >= L::WIDTH {
            let mask = L::load(&codes[at..]).equal(L::splat(code));
            if L::any(mask) {
                let (mut found, mut i) = (0, 0);
                while i < R {
                    let (values, taken) = L::load(&results[i][at..]).unpack(mask, &members[i][count..]);
                    values.store(&mut results[i][at..]);
                    found = taken;
                    i += 1;
                }
                count += found;
            }
            at += L::WIDTH;
        }
        while at < codes.len() {
            if codes[at] == code {
                let mut i = 0;
                while i < R {
                    results[i][at] = members[i][count];
                    i += 1;
                }
                count += 1;
            }
            at += 1;
        }
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
                            let Columns { arguments: [from], results: [to] } = columns;
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

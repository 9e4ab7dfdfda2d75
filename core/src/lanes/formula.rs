//! How a formula is evaluated: at one point, or at every row of columns on the widest lanes.
//!
//! Both are one kernel each for one formula. A motion chooses its formula outside of the kernel and hands it to an
//! [`Evaluation`]; so a formula is compiled once for every lane type, whatever chooses it.

use super::dispatch::{single, wide};
use super::host;
use super::instruction_set::InstructionSet;
use super::lane::{COMPACT, Kernel, Lane, WIDEST};

/// A function of A numbers with N results that serves every lane.
pub trait Formula<const A: usize, const N: usize> {
    /// The type in whose module its kernels are compiled: itself, unless it wraps another formula.
    type Place;
    /// Whether WebAssembly evaluates columns of it on vectors: [`Kernel::VECTORS`].
    const VECTORS: bool = false;
    /// Whether columns of it are evaluated in two steps, a block of rows each: where the chain of one row is so long that a
    /// processor cannot begin the next ones. Then `at` is the second step of the first.
    const STEPS: bool = false;
    /// The results at one lane of each argument; `#[inline(always)]`.
    fn at<L: Lane>(&self, arguments: [L; A]) -> [L; N];
    /// The first step: what the second one needs; `#[inline(always)]`.
    #[inline(always)]
    fn begun<L: Lane>(&self, _arguments: [L; A]) -> [L; BETWEEN] {
        [L::splat(0.0); BETWEEN]
    }
    /// The second step; `#[inline(always)]`.
    #[inline(always)]
    fn ended<L: Lane>(&self, arguments: [L; A], _between: [L; BETWEEN]) -> [L; N] {
        self.at(arguments)
    }
}

/// How many numbers the first step of a formula leaves to the second.
pub const BETWEEN: usize = 4;

impl<F: Formula<A, N>, const A: usize, const N: usize> Formula<A, N> for &F {
    type Place = F::Place;
    const VECTORS: bool = F::VECTORS;
    const STEPS: bool = F::STEPS;
    #[inline(always)]
    fn at<L: Lane>(&self, arguments: [L; A]) -> [L; N] {
        (**self).at(arguments)
    }
    #[inline(always)]
    fn begun<L: Lane>(&self, arguments: [L; A]) -> [L; BETWEEN] {
        (**self).begun(arguments)
    }
    #[inline(always)]
    fn ended<L: Lane>(&self, arguments: [L; A], between: [L; BETWEEN]) -> [L; N] {
        (**self).ended(arguments, between)
    }
}

/// What is asked of a formula.
pub trait Evaluation<const A: usize, const N: usize> {
    /// What the answer is.
    type Output;
    /// The answer of one formula.
    fn of<F: Formula<A, N>>(self, formula: &F) -> Self::Output;
}

/// The results at one point.
pub struct Once<const A: usize>(pub [f64; A]);

/// The first R results at every row of the arguments, into columns. All have the same length.
pub struct Columns<'a, 'b, const A: usize, const R: usize> {
    pub(super) arguments: [&'a [f64]; A],
    pub(super) results: [&'b mut [f64]; R],
    /// Columns whose rows the memory is asked for meanwhile: what comes next.
    ahead: &'a [*const f64],
}

/// The evaluation with the first two results exchanged.
pub struct Second<E>(pub E);

impl<'a, 'b, const A: usize, const R: usize> Columns<'a, 'b, A, R> {
    /// Panics where the lengths differ.
    pub fn new(arguments: [&'a [f64]; A], results: [&'b mut [f64]; R]) -> Self {
        let rows = arguments[0].len();
        let fits = arguments.iter().all(|argument| argument.len() == rows)
            && results.iter().all(|result| result.len() == rows);
        assert!(fits, "columns of different lengths");
        Columns { arguments, results, ahead: &[] }
    }

    /// How many rows.
    pub fn rows(&self) -> usize {
        self.arguments[0].len()
    }

    /// The same, and the memory is asked for as many rows of these columns meanwhile. Nothing is read, so they may be anything.
    pub fn asking(self, ahead: &'a [*const f64]) -> Self {
        Columns { ahead, ..self }
    }

    /// The same value in every row.
    pub fn fill(self, value: f64) {
        self.results.into_iter().for_each(|result| result.fill(value));
    }
}

impl<const A: usize, const N: usize> Evaluation<A, N> for Once<A> {
    type Output = [f64; N];
    fn of<F: Formula<A, N>>(self, formula: &F) -> [f64; N] {
        if InstructionSet::in_use() == InstructionSet::Plain && !COMPACT {
            // The lanes of width one that columns take: nothing more is compiled.
            let mut results = [[0.0]; N];
            let columns = results.each_mut().map(<[f64; 1]>::as_mut_slice);
            Columns::new(self.0.each_ref().map(core::slice::from_ref), columns).of(formula);
            return results.map(|[result]| result);
        }
        single(Point { formula, arguments: self.0, results: [0.0; N] })
    }
}

impl<const A: usize, const N: usize, const R: usize> Evaluation<A, N> for Columns<'_, '_, A, R> {
    type Output = ();
    fn of<F: Formula<A, N>>(mut self, formula: &F) {
        if COMPACT && !F::VECTORS {
            // By the kernel of one point: nothing more is compiled.
            for row in 0..self.arguments[0].len() {
                let values = Once(self.arguments.map(|argument| argument[row])).of(formula);
                for (result, value) in self.results.iter_mut().zip(values) {
                    result[row] = value;
                }
            }
            return;
        }
        let Columns { arguments, results, ahead } = &mut self;
        wide(Rows::<F, A, N, R> { formula, arguments: *arguments, results, ahead })
    }
}

impl<const A: usize, const N: usize, E: Evaluation<A, N>> Evaluation<A, N> for Second<E> {
    type Output = E::Output;
    fn of<F: Formula<A, N>>(self, formula: &F) -> E::Output {
        self.0.of(&Swapped(formula))
    }
}

/// A formula with its first two results exchanged.
struct Swapped<'a, F>(&'a F);

impl<const A: usize, const N: usize, F: Formula<A, N>> Formula<A, N> for Swapped<'_, F> {
    type Place = F::Place;
    const VECTORS: bool = F::VECTORS;
    const STEPS: bool = F::STEPS;
    #[inline(always)]
    fn at<L: Lane>(&self, arguments: [L; A]) -> [L; N] {
        swapped(self.0.at(arguments))
    }
    #[inline(always)]
    fn begun<L: Lane>(&self, arguments: [L; A]) -> [L; BETWEEN] {
        self.0.begun(arguments)
    }
    #[inline(always)]
    fn ended<L: Lane>(&self, arguments: [L; A], between: [L; BETWEEN]) -> [L; N] {
        swapped(self.0.ended(arguments, between))
    }
}

#[inline(always)]
fn swapped<L: Lane, const N: usize>(results: [L; N]) -> [L; N] {
    let mut swapped = results;
    (swapped[0], swapped[1]) = (results[1], results[0]);
    swapped
}

/// The kernel of one point: no loop, no memory.
struct Point<'s, F, const A: usize, const N: usize> {
    formula: &'s F,
    arguments: [f64; A],
    results: [f64; N],
}

impl<F: Formula<A, N>, const A: usize, const N: usize> Kernel for Point<'_, F, A, N> {
    type Output = [f64; N];
    type Place = F::Place;
    #[inline(always)]
    fn run<L: Lane>(mut self) -> [f64; N] {
        let mut arguments = [L::splat(0.0); A];
        let mut i = 0;
        while i < A {
            arguments[i] = L::splat(self.arguments[i]);
            i += 1;
        }
        let values = self.formula.at(arguments);
        let mut i = 0;
        while i < N {
            self.results[i] = values[i].first();
            i += 1;
        }
        self.results
    }
}

/// The kernel of rows.
struct Rows<'s, 'a, 'b, F, const A: usize, const N: usize, const R: usize> {
    formula: &'s F,
    arguments: [&'a [f64]; A],
    results: &'s mut [&'b mut [f64]; R],
    ahead: &'s [*const f64],
}

impl<F: Formula<A, N>, const A: usize, const N: usize, const R: usize> Kernel
    for Rows<'_, '_, '_, F, A, N, R>
{
    type Output = ();
    type Place = F::Place;
    const VECTORS: bool = F::VECTORS;
    #[inline(always)]
    fn run<L: Lane>(self) {
        if F::STEPS {
            sweep_in_steps::<L, F, A, N, R>(self.formula, self.arguments, self.results)
        } else {
            sweep::<L, A, N, R>(&self.formula, self.arguments, self.results, self.ahead)
        }
    }
}

/// A function of lanes of one width, which may hold what it has prepared for them.
pub trait Sampler<L: Lane, const A: usize, const N: usize> {
    /// The results at one lane of each argument; `#[inline(always)]`.
    fn at(&self, arguments: [L; A]) -> [L; N];
}

impl<L: Lane, F: Formula<A, N>, const A: usize, const N: usize> Sampler<L, A, N> for &F {
    #[inline(always)]
    fn at(&self, arguments: [L; A]) -> [L; N] {
        Formula::at(*self, arguments)
    }
}

/// The sampler at every row of the arguments, its first R results each into a slice; all of the same length. The last
/// block is padded with zeros, so every value comes from the same operations wherever it stands.
#[inline(always)]
pub fn sweep<L: Lane, const A: usize, const N: usize, const R: usize>(
    sampler: &impl Sampler<L, A, N>,
    arguments: [&[f64]; A],
    results: &mut [&mut [f64]; R],
    ahead: &[*const f64],
) {
    // No closures: they are compiled without the instruction set. The sampler is long and is called in one place only.
    let rows = arguments[0].len();
    let mut at = 0;
    while at < rows {
        let mut i = 0;
        while i < ahead.len() {
            prefetch_rows::<L>(ahead[i], at);
            i += 1;
        }
        store_rows(results, at, sampler.at(load_rows(arguments, at)));
        at += L::WIDTH;
    }
}

/// Rows that [`sweep_in_steps`] begins before it ends them, which stay in the nearest cache: whole lanes.
const ROWS_OF_A_STEP: usize = 128;

/// [`sweep`] of a formula in two steps: each is a chain so short that a processor works on several lanes at once.
#[inline(always)]
fn sweep_in_steps<L: Lane, F: Formula<A, N>, const A: usize, const N: usize, const R: usize>(
    formula: &F,
    arguments: [&[f64]; A],
    results: &mut [&mut [f64]; R],
) {
    let rows = arguments[0].len();
    let mut block = [[0.0; ROWS_OF_A_STEP]; BETWEEN];
    let mut from = 0;
    while from < rows {
        let to = if rows - from < ROWS_OF_A_STEP { rows } else { from + ROWS_OF_A_STEP };
        let mut at = from;
        while at < to {
            // The same rows of the next block: this step needs no results, and the other no new arguments, so that the memory has
            // the time of a step.
            let mut i = 0;
            while i < R {
                prefetch_rows::<L>(results[i].as_ptr(), at + ROWS_OF_A_STEP);
                i += 1;
            }
            let between = formula.begun(load_rows::<L, A>(arguments, at));
            i = 0;
            while i < BETWEEN {
                between[i].store(&mut block[i][at - from..]);
                i += 1;
            }
            at += L::WIDTH;
        }
        at = from;
        while at < to {
            let mut i = 0;
            while i < A {
                prefetch_rows::<L>(arguments[i].as_ptr(), at + ROWS_OF_A_STEP);
                i += 1;
            }
            let mut between = [L::splat(0.0); BETWEEN];
            i = 0;
            while i < BETWEEN {
                between[i] = L::load(&block[i][at - from..]);
                i += 1;
            }
            store_rows(results, at, formula.ended(load_rows(arguments, at), between));
            at += L::WIDTH;
        }
        from = to;
    }
}

/// Asks the memory for the rows of a lane in a column, wherever it ends: it may go on in the next call.
#[inline(always)]
fn prefetch_rows<L: Lane>(column: *const f64, at: usize) {
    let mut line = 0;
    while line < L::WIDTH {
        host::prefetch(column.wrapping_add(at + line));
        line += LINE;
    }
}

/// Doubles of a line of a cache.
const LINE: usize = 8;

/// The arguments of the rows of a lane, those beyond the end 0.
#[inline(always)]
fn load_rows<L: Lane, const A: usize>(arguments: [&[f64]; A], at: usize) -> [L; A] {
    let rest = arguments[0].len() - at;
    let mut lanes = [L::splat(0.0); A];
    let mut i = 0;
    while i < A {
        lanes[i] = if rest >= L::WIDTH {
            L::load(&arguments[i][at..])
        } else {
            let mut padded = [0.0; WIDEST];
            padded[..rest].copy_from_slice(&arguments[i][at..]);
            L::load(&padded)
        };
        i += 1;
    }
    lanes
}

/// The first results to the rows of a lane.
#[inline(always)]
fn store_rows<L: Lane, const N: usize, const R: usize>(
    results: &mut [&mut [f64]; R],
    at: usize,
    values: [L; N],
) {
    let mut i = 0;
    while i < R {
        let to = &mut results[i][at..];
        if to.len() >= L::WIDTH {
            values[i].store(to);
        } else {
            let mut padded = [0.0; WIDEST];
            values[i].store(&mut padded);
            to.copy_from_slice(&padded[..to.len()]);
        }
        i += 1;
    }
}

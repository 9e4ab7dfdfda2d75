//! How a formula is evaluated: at one point, or at every row of columns on the widest lanes.
//!
//! Both are one kernel each for one formula. A motion chooses its formula outside of the kernel and hands it to an
//! [`Evaluation`]; so a formula is compiled once for every lane type, whatever chooses it.

use super::dispatch::{single, wide};
use super::instruction_set::InstructionSet;
use super::lane::{COMPACT, Kernel, Lane, WIDEST};

/// A function of A numbers with N results that serves every lane.
pub trait Formula<const A: usize, const N: usize> {
    /// The type in whose module its kernels are compiled: itself, unless it wraps another formula.
    type Place;
    /// Whether WebAssembly evaluates columns of it on vectors: [`Kernel::VECTORS`].
    const VECTORS: bool = false;
    /// The results at one lane of each argument; `#[inline(always)]`.
    fn at<L: Lane>(&self, arguments: [L; A]) -> [L; N];
}

impl<F: Formula<A, N>, const A: usize, const N: usize> Formula<A, N> for &F {
    type Place = F::Place;
    const VECTORS: bool = F::VECTORS;
    #[inline(always)]
    fn at<L: Lane>(&self, arguments: [L; A]) -> [L; N] {
        (**self).at(arguments)
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
        Columns { arguments, results }
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
        wide(Rows::<F, A, N, R> { formula, arguments: self.arguments, results: &mut self.results })
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
    #[inline(always)]
    fn at<L: Lane>(&self, arguments: [L; A]) -> [L; N] {
        let results = self.0.at(arguments);
        let mut swapped = results;
        (swapped[0], swapped[1]) = (results[1], results[0]);
        swapped
    }
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
}

impl<F: Formula<A, N>, const A: usize, const N: usize, const R: usize> Kernel
    for Rows<'_, '_, '_, F, A, N, R>
{
    type Output = ();
    type Place = F::Place;
    const VECTORS: bool = F::VECTORS;
    #[inline(always)]
    fn run<L: Lane>(self) {
        sweep::<L, A, N, R>(&self.formula, self.arguments, self.results)
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
) {
    // No closures: they are compiled without the instruction set. The sampler is long and is called in one place only.
    let rows = arguments[0].len();
    let mut padded = [0.0; WIDEST];
    let mut lanes = [L::splat(0.0); A];
    let mut at = 0;
    while at < rows {
        let rest = rows - at;
        let mut i = 0;
        while i < A {
            lanes[i] = if rest >= L::WIDTH {
                L::load(&arguments[i][at..])
            } else {
                padded[..rest].copy_from_slice(&arguments[i][at..]);
                L::load(&padded)
            };
            i += 1;
        }
        let values = sampler.at(lanes);
        let mut i = 0;
        while i < R {
            if rest >= L::WIDTH {
                values[i].store(&mut results[i][at..]);
            } else {
                values[i].store(&mut padded);
                results[i][at..].copy_from_slice(&padded[..rest]);
            }
            i += 1;
        }
        at += L::WIDTH;
    }
}

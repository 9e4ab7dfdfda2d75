//! A vector of doubles and the run-time choice of the instruction set that carries it.
//!
//! Formulas are written once over [`Lane`]; a scalar is a lane of width one. Every operation here is one
//! IEEE operation (or an error-free pair of them), so all widths of one instruction set give the same bits.
//! Instruction sets differ only in whether `mul_add` is fused.

pub mod formula;
#[cfg(all(any(target_arch = "x86_64", target_arch = "aarch64"), not(one_instruction_set)))]
mod fused;
#[cfg(any(
    all(any(target_arch = "x86_64", target_arch = "aarch64"), not(one_instruction_set)),
    target_feature = "simd128"
))]
mod pair;
mod scalar;
#[cfg(any(
    all(any(target_arch = "x86_64", target_arch = "aarch64"), not(one_instruction_set)),
    target_feature = "simd128"
))]
mod vector;
#[cfg(target_feature = "simd128")]
mod wasm;

#[cfg(all(target_arch = "x86_64", not(one_instruction_set)))]
#[path = "x86.rs"]
mod host;
#[cfg(all(target_arch = "aarch64", not(one_instruction_set)))]
#[path = "neon.rs"]
mod host;
#[cfg(any(one_instruction_set, not(any(target_arch = "x86_64", target_arch = "aarch64"))))]
#[path = "plain.rs"]
mod host;

pub use formula::{Columns, Evaluation, Formula, Once, Sampler, Second, sweep, tabulate};

use crate::domain::Domain;
use core::cell::Cell;
use core::ops::{Add, Div, Mul, Neg, Sub};
use core::sync::atomic::{AtomicUsize, Ordering};

/// Doubles side by side, with the operations the kernels use.
pub trait Lane:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// The answer of a comparison, one flag per double.
    type Mask: Copy;
    /// How many doubles.
    const WIDTH: usize;

    /// The first WIDTH doubles of a slice that has them.
    fn load(from: &[f64]) -> Self;
    /// Into the first WIDTH doubles of a slice that has them.
    fn store(self, to: &mut [f64]);
    /// The first double.
    #[inline(always)]
    fn first(self) -> f64 {
        let mut places = [0.0; WIDEST];
        self.store(&mut places);
        places[0]
    }

    /// The same value in every place.
    fn splat(value: f64) -> Self;
    /// `self * factor + term`, fused where the processor fuses.
    fn mul_add(self, factor: Self, term: Self) -> Self;
    /// Product and its exact error.
    fn two_product(self, factor: Self) -> (Self, Self);
    /// Nearest integer, ties to even.
    fn round(self) -> Self;
    /// Square root.
    fn sqrt(self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// Magnitude of `self`, sign of `sign`.
    fn copysign(self, sign: Self) -> Self;
    /// 2 to the power `self`, an integer in [-1022, 1023].
    fn exp2_integer(self) -> Self;
    /// `self < other`.
    fn less(self, other: Self) -> Self::Mask;
    /// `self == other`.
    fn equal(self, other: Self) -> Self::Mask;
    /// `yes` where the mask holds, `no` elsewhere.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
}

/// A computation over any lane type, handed to [`single`] or [`wide`].
pub trait Kernel {
    /// What it returns.
    type Output;
    /// Runs it on the lane type of the instruction set; `#[inline(always)]`, so that it is compiled for it.
    fn run<L: Lane>(self) -> Self::Output;
}

/// Widest lane.
pub const WIDEST: usize = 16;

/// What a processor can do that changes the last digits or the speed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum InstructionSet {
    /// No fused multiplication: every processor, one lane; WebAssembly, four where it is compiled with simd128.
    Plain = 1,
    /// Fused multiplication: four lanes of AVX2 with FMA on x86-64, two of NEON on aarch64.
    Fused = 2,
    /// Eight lanes of AVX-512; the digits of `Fused`.
    Avx512 = 3,
}

/// How many scopes are open in all threads, times four, plus the best set; that is 0 until it is first asked for. So
/// the value is 1, 2 or 3 unless a thread has chosen a set of its own, and a call reads nothing else.
static IN_USE: AtomicUsize = AtomicUsize::new(0);
const ONE_SCOPE: usize = 4;

thread_local! {
    /// The set that a scope of this thread has chosen.
    static CHOSEN: Cell<Option<InstructionSet>> = const { Cell::new(None) };
}

/// An open scope; closed when it is dropped, also by a panic.
struct Scope {
    outer: Option<InstructionSet>,
}

impl Scope {
    fn open(set: InstructionSet) -> Scope {
        IN_USE.fetch_add(ONE_SCOPE, Ordering::Relaxed);
        Scope { outer: CHOSEN.replace(Some(set)) }
    }
}

impl Drop for Scope {
    fn drop(&mut self) {
        CHOSEN.set(self.outer);
        IN_USE.fetch_sub(ONE_SCOPE, Ordering::Relaxed);
    }
}

impl InstructionSet {
    /// The sets that this processor has, best last.
    pub fn available() -> &'static [InstructionSet] {
        const ALL: [InstructionSet; 3] =
            [InstructionSet::Plain, InstructionSet::Fused, InstructionSet::Avx512];
        &ALL[..host::instruction_sets()]
    }

    /// The set in use on this thread: the best one, unless [`InstructionSet::scope`] has chosen another.
    #[inline]
    pub fn in_use() -> InstructionSet {
        // Relaxed: the only value that a thread must not miss is the one it wrote itself.
        match IN_USE.load(Ordering::Relaxed) {
            1 => InstructionSet::Plain,
            2 => InstructionSet::Fused,
            3 => InstructionSet::Avx512,
            _ => InstructionSet::chosen_or_best(),
        }
    }

    #[cold]
    fn chosen_or_best() -> InstructionSet {
        CHOSEN.get().unwrap_or_else(|| {
            let available = InstructionSet::available();
            let best = available[available.len() - 1];
            IN_USE.fetch_or(best as usize, Ordering::Relaxed);
            best
        })
    }

    /// Runs `work` with this set on this thread and on no other, for tests and benchmarks; refused where the
    /// processor does not have it.
    pub fn scope<T>(self, work: impl FnOnce() -> T) -> Result<T, Domain> {
        let allowed = "an instruction set of this processor";
        if !InstructionSet::available().contains(&self) {
            return Err(Domain::new("instruction set", format!("{self:?}"), allowed));
        }
        let _open = Scope::open(self);
        Ok(work())
    }
}

/// The widest lane of `Plain`. WebAssembly cannot be asked what it has: its lanes are there if compiled for.
#[cfg(target_feature = "simd128")]
type WidePlain = pair::Pair<wasm::F64x2>;
#[cfg(not(target_feature = "simd128"))]
type WidePlain = f64;

/// Runs the kernel without fused multiplication: compiled once where both widths are the same.
#[inline(never)]
fn plain<L: Lane, K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<L>()
}

/// Runs the kernel on lanes of width one of the instruction set in use.
#[inline]
pub fn single<K: Kernel>(kernel: K) -> K::Output {
    match InstructionSet::in_use() {
        InstructionSet::Plain => plain::<f64, K>(kernel),
        InstructionSet::Fused | InstructionSet::Avx512 => host::single_fused(kernel),
    }
}

/// Runs the kernel on the widest lanes of the instruction set in use.
#[inline]
pub fn wide<K: Kernel>(kernel: K) -> K::Output {
    match InstructionSet::in_use() {
        InstructionSet::Plain => plain::<WidePlain, K>(kernel),
        InstructionSet::Fused => host::wide_fused(kernel),
        InstructionSet::Avx512 => host::wide_avx512(kernel),
    }
}

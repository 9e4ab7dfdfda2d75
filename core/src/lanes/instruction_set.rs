//! Which instruction set a thread uses, chosen at run time.

use super::host;
use crate::domain::Domain;
use core::cell::Cell;
use core::sync::atomic::{AtomicUsize, Ordering};

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

//! Processors without lanes of their own here: width one, without fused multiplication, and nothing else is compiled.

use super::lane::Kernel;
use super::pair::Pair;

/// Whether `Plain` is the only set, known when compiled.
pub const ONLY_PLAIN: bool = true;

/// How many of `InstructionSet` this processor has.
pub fn instruction_sets() -> usize {
    1
}

/// Not on this processor.
pub fn single_fused<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<f64>()
}

/// Not on this processor.
pub fn four_fused<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<Pair<Pair<f64>>>()
}

/// Not on this processor.
pub fn four_avx512<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<Pair<Pair<f64>>>()
}

/// Not on this processor.
pub fn wide_fused<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<f64>()
}

/// Not on this processor.
pub fn wide_avx512<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<f64>()
}

/// Not asked for here.
pub fn prefetch(_place: *const f64) {}

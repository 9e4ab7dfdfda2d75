//! Runs a kernel on the lanes of the instruction set in use.

use super::host;
use super::instruction_set::InstructionSet;
use super::lane::{Entry, Kernel};
use super::pair::Pair;
#[cfg(all(any(target_arch = "x86_64", target_arch = "aarch64"), not(one_instruction_set)))]
use super::unfused::Unfused as One;
#[cfg(target_feature = "simd128")]
use super::wasm;
#[cfg(any(one_instruction_set, not(any(target_arch = "x86_64", target_arch = "aarch64"))))]
use core::primitive::f64 as One;

/// The widest lane of `Plain`. WebAssembly cannot be asked what it has: its lanes are there if compiled for.
#[cfg(target_feature = "simd128")]
type WidePlain = Pair<wasm::F64x2>;
#[cfg(not(target_feature = "simd128"))]
type WidePlain = One;

/// The single vector of `Plain`.
#[cfg(target_feature = "simd128")]
type OnePlain = wasm::F64x2;
#[cfg(not(target_feature = "simd128"))]
type OnePlain = One;

/// The lane of four of `Plain`.
#[cfg(target_feature = "simd128")]
type FourPlain = WidePlain;
#[cfg(not(target_feature = "simd128"))]
type FourPlain = Pair<Pair<One>>;

/// Runs the kernel on lanes of width one of the instruction set in use.
#[inline]
pub fn single<K: Kernel>(kernel: K) -> K::Output {
    if host::ONLY_PLAIN {
        return K::Place::enter::<One, K>(kernel);
    }
    match InstructionSet::in_use() {
        InstructionSet::Plain => K::Place::enter::<One, K>(kernel),
        InstructionSet::Fused | InstructionSet::Avx512 => host::single_fused(kernel),
    }
}

/// Runs the kernel on the widest lanes of the instruction set in use.
#[inline]
pub fn wide<K: Kernel>(kernel: K) -> K::Output {
    if host::ONLY_PLAIN {
        return if K::SINGLE_VECTORS {
            K::Place::enter::<OnePlain, K>(kernel)
        } else if K::VECTORS {
            K::Place::enter::<WidePlain, K>(kernel)
        } else {
            K::Place::enter::<One, K>(kernel)
        };
    }
    match InstructionSet::in_use() {
        InstructionSet::Plain => K::Place::enter::<One, K>(kernel),
        InstructionSet::Fused => host::wide_fused(kernel),
        InstructionSet::Avx512 => host::wide_avx512(kernel),
    }
}

/// Runs the kernel on lanes of width four, which hold four numbers of one computation, not of four.
#[inline]
pub fn four<K: Kernel>(kernel: K) -> K::Output {
    if host::ONLY_PLAIN {
        return K::Place::enter::<FourPlain, K>(kernel);
    }
    match InstructionSet::in_use() {
        InstructionSet::Plain => K::Place::enter::<FourPlain, K>(kernel),
        InstructionSet::Fused => host::four_fused(kernel),
        InstructionSet::Avx512 => host::four_avx512(kernel),
    }
}

//! A vector of doubles and the run-time choice of the instruction set that carries it.
//!
//! Formulas are written once over [`Lane`]; a scalar is a lane of width one. Every operation here is one
//! IEEE operation (or an error-free pair of them), so all widths of one instruction set give the same bits.
//! Instruction sets differ only in whether `mul_add` is fused.

mod classes;
mod dispatch;
mod formula;
#[cfg(all(any(target_arch = "x86_64", target_arch = "aarch64"), not(one_instruction_set)))]
mod fused;
mod instruction_set;
mod lane;
mod last_made;
mod pair;
mod scalar;
#[cfg(all(any(target_arch = "x86_64", target_arch = "aarch64"), not(one_instruction_set)))]
mod unfused;
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

pub(crate) use classes::{BLOCK, Classes, by_class, repeats};
pub use dispatch::{four, single, wide};
pub use formula::{BETWEEN, Columns, Evaluation, Formula, Once, Sampler, Second, sweep};
pub use instruction_set::InstructionSet;
pub(crate) use lane::compiled_once;
pub use lane::{COMPACT, Kernel, Lane, PIECES, ROUNDER, WIDEST};
pub(crate) use last_made::LastMade;

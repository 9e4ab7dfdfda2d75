//! The fit for browsers and Node, as a plain C ABI: columns and texts in, columns and texts out.
//!
//! Nothing is computed here. JavaScript writes the columns that the reader has left (wasm/reader) and what is stated about them
//! (stated.rs), calls a function of abi.rs, and reads the answer: JSON with columns (answer.rs), or the one line that a refusal is on
//! the command line.

mod abi;
mod answer;
mod json;
mod lines;
mod quantities;
mod stated;

/// A list of free blocks: a fit asks for a few long lists, again and again of the same lengths.
#[cfg(target_arch = "wasm32")]
#[global_allocator]
static ALLOCATOR: lol_alloc::LockedAllocator<lol_alloc::FreeListAllocator> =
    lol_alloc::LockedAllocator::new(lol_alloc::FreeListAllocator::new());

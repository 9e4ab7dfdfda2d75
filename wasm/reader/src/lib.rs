//! The reader of files for browsers and Node, as a plain C ABI: a module of its own, since a page needs it before it needs the fit.
//!
//! JavaScript writes the bytes of a file and what is stated about it (stated.rs), calls `read_file`, and reads the answer: what was
//! understood, with the columns of numbers that the module of the fit takes, or the one line that a refusal is on the command line.
//! What is exchanged, and how, is that module's (wasm/fit/src).

mod abi;
mod answer;
#[path = "../../fit/src/json.rs"]
mod json;
#[path = "../../fit/src/lines.rs"]
mod lines;
#[path = "../../fit/src/quantities.rs"]
#[allow(dead_code, reason = "nothing has an uncertainty here")]
mod quantities;
mod stated;

/// A list of free blocks: a file is a few long lists.
#[cfg(target_arch = "wasm32")]
#[global_allocator]
static ALLOCATOR: lol_alloc::LockedAllocator<lol_alloc::FreeListAllocator> =
    lol_alloc::LockedAllocator::new(lol_alloc::FreeListAllocator::new());

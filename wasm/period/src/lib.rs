//! g from a period that was timed, for browsers and Node, as a plain C ABI: a module of its own, for who has no record.
//!
//! JavaScript writes what is stated (period.rs), calls `gravity`, and reads the answer: JSON, or the one line that a refusal is on the
//! command line. What is exchanged, and how, is that of the module of the fit (wasm/fit/src).

mod abi;
#[path = "../../fit/src/json.rs"]
mod json;
#[path = "../../fit/src/lines.rs"]
#[allow(dead_code, reason = "no file has a name here")]
mod lines;
mod period;
#[path = "../../fit/src/quantities.rs"]
mod quantities;

/// A list of free blocks: an answer is a few short texts.
#[cfg(target_arch = "wasm32")]
#[global_allocator]
static ALLOCATOR: lol_alloc::LockedAllocator<lol_alloc::FreeListAllocator> =
    lol_alloc::LockedAllocator::new(lol_alloc::FreeListAllocator::new());

//! The core for browsers and Node, as a plain C ABI: numbers in, numbers out, arrays in a workspace that both sides see.
//!
//! Nothing is computed here. JavaScript writes columns of doubles and names into the workspace (workspace.rs), calls a
//! function of abi.rs, and reads the columns, the list or the text that it left. What is set up once is kept under a
//! number (objects.rs). The package in npm/ wraps all of it in classes.

mod abi;
mod objects;
mod workspace;

/// A list of free blocks: what is set up is a few objects and lists.
#[cfg(target_arch = "wasm32")]
#[global_allocator]
static ALLOCATOR: lol_alloc::LockedAllocator<lol_alloc::FreeListAllocator> =
    lol_alloc::LockedAllocator::new(lol_alloc::FreeListAllocator::new());

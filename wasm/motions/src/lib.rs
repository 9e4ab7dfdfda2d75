//! Springs and friction for browsers and Node, as a plain C ABI: a module of its own, for pages that show them.
//!
//! Nothing is computed here. It works as the module of the pendulum does (wasm/src), with the same workspace and the same
//! numbers for what is set up once: these files are those of that crate.

mod abi;
#[path = "../../src/objects.rs"]
mod objects;
#[path = "../../src/workspace.rs"]
#[allow(dead_code, reason = "no function here reads a name")]
mod workspace;

/// A list of free blocks: a trajectory is a few long lists.
#[cfg(target_arch = "wasm32")]
#[global_allocator]
static ALLOCATOR: lol_alloc::LockedAllocator<lol_alloc::FreeListAllocator> =
    lol_alloc::LockedAllocator::new(lol_alloc::FreeListAllocator::new());

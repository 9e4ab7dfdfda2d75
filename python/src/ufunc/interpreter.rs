//! The interpreter for a thread of which PyO3 does not know whether it holds it.

use pyo3::ffi;
use pyo3::prelude::*;

/// Does work with the interpreter in a thread that may have let it go.
///
/// NumPy lets it go without telling PyO3. Where a signal handler, run from here, calls a ufunc, PyO3 takes the interpreter
/// for held and would not ask for it: so it is asked for before.
pub fn with_interpreter<T>(work: impl FnOnce(Python<'_>) -> T) -> T {
    struct Held(ffi::PyGILState_STATE);

    impl Drop for Held {
        fn drop(&mut self) {
            // SAFETY: given back once, by the thread that has it, after all work.
            unsafe { ffi::PyGILState_Release(self.0) };
        }
    }

    // SAFETY: allowed whether or not the thread holds the interpreter, which runs as long as its main thread does.
    let _held = Held(unsafe { ffi::PyGILState_Ensure() });
    Python::attach(work)
}

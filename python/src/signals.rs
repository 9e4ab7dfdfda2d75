//! Long calls end within a moment of Ctrl-C: what a computation asks between its blocks.
//!
//! Python runs its signal handlers on the main thread only, and only when asked. The thread that was called asks every
//! [`INTERVAL`]; it looks at the clock every [`ROWS`] rows, so that short calls pay nothing. The threads of the pool
//! never ask: they read a flag of their call.
//! Source: the Python C API, `PyErr_CheckSignals`, <https://docs.python.org/3/c-api/exceptions.html#signal-handling>.

use std::cell::{Cell, RefCell};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::{Duration, Instant};
use std::{panic, process, thread};

use pyo3::prelude::*;

use crate::ufunc::interpreter::with_interpreter;

/// Time between two questions.
pub const INTERVAL: Duration = Duration::from_millis(50);

/// Rows between two looks at the clock. A row takes 100 microseconds at most, a look some 100 nanoseconds.
const ROWS: usize = 2048;

thread_local! {
    /// Rows since the last look at the clock.
    static COUNTED: Cell<usize> = const { Cell::new(0) };
    /// When this thread asked last.
    static ASKED: Cell<Option<Instant>> = const { Cell::new(None) };
    /// Whether this thread runs signal handlers, in the process that found out.
    static MAIN: Cell<Option<(u32, bool)>> = const { Cell::new(None) };
    /// Whether a ufunc of this thread left an error for NumPy to find.
    static LEFT: Cell<bool> = const { Cell::new(false) };
}

/// A question to a computation's caller, after so many rows: whether to give up.
pub type Stop<'a> = &'a dyn Fn(usize) -> bool;

/// The error of a signal handler, if one has raised; asked after every `rows` rows.
fn after(rows: usize) -> Option<PyErr> {
    let counted = COUNTED.get() + rows;
    COUNTED.set(if counted < ROWS { counted } else { 0 });
    if counted < ROWS { None } else { asked() }
}

/// The same, whatever the number of rows.
#[cold]
pub fn asked() -> Option<PyErr> {
    let now = Instant::now();
    if ASKED.get().is_some_and(|before| now.duration_since(before) < INTERVAL) {
        return None;
    }
    ASKED.set(Some(now));
    // Other threads have no handlers to run; and while the interpreter shuts down they must not wait for it.
    if MAIN.get().is_some_and(|(process, main)| process == process::id() && !main) {
        return None;
    }
    with_interpreter(|py| {
        if MAIN.get().is_none_or(|(process, _)| process != process::id()) {
            MAIN.set(Some((process::id(), is_main(py).unwrap_or(true))));
        }
        py.check_signals().err()
    })
}

/// Whether this is the thread that runs signal handlers.
fn is_main(py: Python<'_>) -> PyResult<bool> {
    let threading = py.import("threading")?;
    let main = threading.call_method0("main_thread")?.getattr("ident")?;
    main.eq(threading.call_method0("get_ident")?)
}

/// Does work of this thread, which may be without the interpreter; the error if a signal ended it.
pub fn watched<T>(work: impl FnOnce(Stop<'_>) -> T) -> PyResult<T> {
    let raised = RefCell::new(None);
    let stop = |rows: usize| {
        let mut raised = raised.borrow_mut();
        if raised.is_none() {
            *raised = after(rows);
        }
        raised.is_some()
    };
    let answer = work(&stop);
    raised.into_inner().map_or(Ok(answer), Err)
}

/// Likewise, of a thread that holds the interpreter and lets it go meanwhile.
pub fn detached<T: Send>(py: Python<'_>, work: impl FnOnce(Stop<'_>) -> T + Send) -> PyResult<T> {
    py.detach(|| watched(work))
}

/// Does work that asks nothing, in a thread of its own; the error if a signal ended the wait. The work then goes on to its end, and
/// its answer is dropped.
pub fn in_thread<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<T> {
    let (sender, receiver) = mpsc::sync_channel(1);
    // The waiting thread may have gone away.
    let worker = thread::Builder::new().spawn(move || drop(sender.send(work())))?;
    py.detach(move || {
        loop {
            match receiver.recv_timeout(INTERVAL) {
                Ok(answer) => return Ok(answer),
                Err(RecvTimeoutError::Timeout) => asked().map_or(Ok(()), Err)?,
                Err(RecvTimeoutError::Disconnected) => break,
            }
        }
        // No answer and no sender: the work panicked, and so does its caller, as it would have done here.
        panic::resume_unwind(worker.join().err().unwrap_or_else(|| Box::new("no answer")))
    })
}

/// Leaves an error where NumPy looks for one after the loops of a ufunc.
pub fn leave(error: PyErr) {
    with_interpreter(|py| error.restore(py));
    LEFT.set(true);
}

/// Whether the error that this thread left still stands: the ufunc is at its end, and its other loops have no work.
pub fn ending() -> bool {
    LEFT.get() && {
        let stands = with_interpreter(PyErr::occurred);
        LEFT.set(stands);
        stands
    }
}

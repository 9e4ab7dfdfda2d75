//! The threads that share long loops: as many as the process has cores, or `LIBRATION_NUM_THREADS` of them.
//!
//! Sections of a loop are the same for any number of threads in what they compute: every value comes from its own row,
//! so results do not depend on how rows are shared out. A signal ends every section at its next block (signals.rs).

use std::env;
use std::process;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Condvar, Mutex, MutexGuard, OnceLock, PoisonError};
use std::thread;

use pyo3::PyResult;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::signals::{self, INTERVAL, Stop};

/// Rows below which a second thread costs more than it gains: a section takes some 20 microseconds at the least.
const WORTHWHILE: usize = 16_384;

/// The pool and the process that made it: its threads do not survive a fork.
static POOL: OnceLock<(u32, Option<ThreadPool>)> = OnceLock::new();

/// What the environment asks for.
pub fn wanted() -> Result<usize, String> {
    let Some(given) = env::var_os("LIBRATION_NUM_THREADS") else {
        return Ok(thread::available_parallelism().map_or(1, usize::from));
    };
    // What is no text is no number either; it is shown with the sign of what cannot be read.
    let text = given.to_string_lossy();
    let text = text.trim();
    if text.is_empty() {
        return Ok(thread::available_parallelism().map_or(1, usize::from));
    }
    match text.parse() {
        Ok(count @ 1..=1024) => Ok(count),
        _ => Err(format!("LIBRATION_NUM_THREADS = {text}: must be a whole number from 1 to 1024")),
    }
}

/// Runs `section(from, rows, stop)` over all rows, in one piece or shared out; what the last section returns, or the
/// error of the signal that ended them all.
pub fn share<T: Send>(
    rows: usize,
    section: impl Fn(usize, usize, Stop<'_>) -> Option<T> + Sync,
) -> PyResult<Option<T>> {
    let pool = if rows < 2 * WORTHWHILE { None } else { pool() };
    let Some(pool) = pool else {
        return signals::watched(|stop| section(0, rows, stop));
    };
    let (pieces, edge) = shares(rows, pool);
    let last = Mutex::new(None);
    spawned(pool, (0..pieces).collect(), |piece, stop| {
        let made = section(edge(piece), edge(piece + 1) - edge(piece), stop);
        if piece + 1 == pieces
            && let Ok(mut last) = last.lock()
        {
            *last = made;
        }
    })?;
    Ok(last.into_inner().unwrap_or(None))
}

/// How many rows a thread takes at a time at the most, so that all threads have work.
pub fn part(rows: usize) -> usize {
    rows.div_ceil(4 * pool().map_or(1, ThreadPool::current_num_threads)).max(1)
}

/// Does work with each of some items, one after the other or shared out; the error of the signal that ended it.
pub fn each_of<T: Send>(items: Vec<T>, work: impl Fn(T, Stop<'_>) + Sync) -> PyResult<()> {
    match pool() {
        Some(pool) if items.len() > 1 => spawned(pool, items, work),
        _ => signals::watched(|stop| items.into_iter().for_each(|item| work(item, stop))),
    }
}

/// Does work with each of some items on the threads of the pool, while this one asks for signals.
fn spawned<T: Send>(pool: &ThreadPool, items: Vec<T>, work: impl Fn(T, Stop<'_>) + Sync) -> PyResult<()> {
    let stopped = AtomicBool::new(false);
    let left = Left::new(items.len());
    let mut raised = None;
    pool.in_place_scope(|scope| {
        for item in items {
            let (work, stopped, left) = (&work, &stopped, &left);
            scope.spawn(move |_| {
                let _one = One(left);
                work(item, &|_| stopped.load(Ordering::Relaxed));
            });
        }
        while raised.is_none() && !left.none_soon() {
            raised = signals::asked();
        }
        // The scope ends when every piece has seen the flag.
        stopped.store(raised.is_some(), Ordering::Relaxed);
    });
    raised.map_or(Ok(()), Err)
}

/// Runs `section(from, rows)` over all rows without a question to the interpreter, for threads that must not wait for it.
pub fn share_alone(rows: usize, section: impl Fn(usize, usize) + Sync) {
    let pool = if rows < 2 * WORTHWHILE { None } else { pool() };
    let Some(pool) = pool else { return section(0, rows) };
    let (pieces, edge) = shares(rows, pool);
    pool.in_place_scope(|scope| {
        for (from, to) in (0..pieces).map(|piece| (edge(piece), edge(piece + 1))) {
            let section = &section;
            scope.spawn(move |_| section(from, to - from));
        }
    });
}

/// How many pieces the threads share, and the first row of each.
fn shares(rows: usize, pool: &ThreadPool) -> (usize, impl Fn(usize) -> usize) {
    let pieces = (rows / WORTHWHILE).min(4 * pool.current_num_threads());
    (pieces, move |piece| (rows as u128 * piece as u128 / pieces as u128) as usize)
}

/// How many pieces are not done.
struct Left {
    pieces: Mutex<usize>,
    changed: Condvar,
}

impl Left {
    fn new(pieces: usize) -> Left {
        Left { pieces: Mutex::new(pieces), changed: Condvar::new() }
    }

    /// The count; a number is whole whatever panicked beside it.
    fn count(&self) -> MutexGuard<'_, usize> {
        self.pieces.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Waits for the end of all pieces, for [`INTERVAL`] at most; whether it came.
    fn none_soon(&self) -> bool {
        let waited = self.changed.wait_timeout_while(self.count(), INTERVAL, |pieces| *pieces > 0);
        *waited.unwrap_or_else(PoisonError::into_inner).0 == 0
    }
}

/// A piece at work; it is done when this is dropped, by a panic too.
struct One<'a>(&'a Left);

impl Drop for One<'_> {
    fn drop(&mut self) {
        let mut pieces = self.0.count();
        *pieces -= 1;
        if *pieces == 0 {
            self.0.changed.notify_all();
        }
    }
}

/// The pool of this process, if it has more than one thread.
fn pool() -> Option<&'static ThreadPool> {
    let (owner, pool) = POOL.get_or_init(|| {
        let count = wanted().unwrap_or(1);
        let build =
            || ThreadPoolBuilder::new().num_threads(count).thread_name(|i| format!("libration-{i}")).build();
        (process::id(), if count > 1 { build().ok() } else { None })
    });
    if *owner == process::id() { pool.as_ref() } else { None }
}

//! The threads that share long loops: as many as the process has cores, or `LIBRATION_NUM_THREADS` of them.
//!
//! Sections of a loop are the same for any number of threads in what they compute: every value comes from its own row,
//! so results do not depend on how rows are shared out.

use std::env;
use std::process;
use std::sync::{Mutex, OnceLock};
use std::thread;

use rayon::{ThreadPool, ThreadPoolBuilder};

/// Rows below which a second thread costs more than it gains: a section takes some 20 microseconds at the least.
const WORTHWHILE: usize = 16_384;

/// The pool and the process that made it: its threads do not survive a fork.
static POOL: OnceLock<(u32, Option<ThreadPool>)> = OnceLock::new();

/// What the environment asks for.
pub fn wanted() -> Result<usize, String> {
    let cores = || thread::available_parallelism().map_or(1, usize::from);
    match env::var("LIBRATION_NUM_THREADS") {
        Err(_) => Ok(cores()),
        Ok(text) if text.trim().is_empty() => Ok(cores()),
        Ok(text) => match text.trim().parse() {
            Ok(count @ 1..=1024) => Ok(count),
            _ => Err(format!("LIBRATION_NUM_THREADS = {text}: must be a whole number from 1 to 1024")),
        },
    }
}

/// Runs `section(from, rows)` over all rows, in one piece or shared out; what the last section returns.
pub fn share<T: Send>(rows: usize, section: impl Fn(usize, usize) -> Option<T> + Sync) -> Option<T> {
    let pool = if rows < 2 * WORTHWHILE { None } else { pool() };
    let Some(pool) = pool else {
        return section(0, rows);
    };
    let pieces = (rows / WORTHWHILE).min(4 * pool.current_num_threads());
    let edge = |piece: usize| (rows as u128 * piece as u128 / pieces as u128) as usize;
    let last = Mutex::new(None);
    pool.in_place_scope(|scope| {
        for piece in 0..pieces {
            let (section, last) = (&section, &last);
            scope.spawn(move |_| {
                let made = section(edge(piece), edge(piece + 1) - edge(piece));
                if piece + 1 == pieces
                    && let Ok(mut last) = last.lock()
                {
                    *last = made;
                }
            });
        }
    });
    last.into_inner().unwrap_or(None)
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

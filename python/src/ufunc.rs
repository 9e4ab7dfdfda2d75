//! Kernels as real NumPy ufuncs; with the files of ufunc/ all `unsafe` of the binding.
//!
//! A kernel is two functions: `set_up` makes of the last operands of a row what belongs to them alone (an orbit, a
//! parameter), and `block` makes of that and of columns of the first operands the columns of results, a block of rows
//! at a time. [`add`] registers the pair as a ufunc of float64 operands; broadcasting, casting, `out=`, `where=` and
//! overlapping memory are NumPy's. Long loops are shared out to the threads of pool.rs and end at a signal: NumPy runs
//! them without the interpreter, and looks for an error when they are done.
//! Source: the NumPy C API, "UFunc API", <https://numpy.org/doc/stable/reference/c-api/ufunc.html>.

pub mod interpreter;
mod operands;
pub mod xla;

use std::array;
use std::cell::Cell;
use std::ffi::{CString, c_char, c_int, c_long, c_void};
use std::marker::PhantomData;
use std::ptr;
use std::slice;
use std::sync::Mutex;

use numpy::npyffi::{NPY_TYPES, PY_UFUNC_API, PyUFuncGenericFunction, npy_intp};
use pyo3::prelude::*;
use pyo3::types::PyCapsule;

use self::operands::{Operands, WIDEST};
use crate::pool;
use crate::signals::{self, Stop};

/// Rows computed at a time: a call of a kernel costs some 100 nanoseconds, and its columns should stay in a near cache.
pub const BLOCK: usize = 2048;

/// NumPy's code of float64.
const FLOAT64: c_char = NPY_TYPES::NPY_DOUBLE as c_char;

/// NumPy's code of int64: the C type that has 64 bits.
const INT64: c_char =
    if size_of::<c_long>() == 8 { NPY_TYPES::NPY_LONG as c_char } else { NPY_TYPES::NPY_LONGLONG as c_char };

/// Place of `PyUFunc_clearfperr` in the table of NumPy's ufunc API.
const CLEAR_SLOT: usize = 27;

/// The results of one row, and the columns of a block of rows. Every result has 64 bits.
pub trait Row: Copy + Send {
    /// NumPy's codes of the results.
    const CODES: &'static [c_char];
    /// The results where the set-up is refused.
    const UNDEFINED: Self;
    /// A column for each result, all of the same length.
    type Columns<'a>;
    /// The columns of some rows where they are to be written.
    ///
    /// # Safety
    /// `at` holds the address of the first row of each column; its rows lie side by side, are aligned, and nothing else
    /// reads or writes them while the columns are in use.
    unsafe fn columns<'a>(at: &[*mut c_char], rows: usize) -> Self::Columns<'a>;
    /// Writes one row of the columns.
    fn put(self, columns: &mut Self::Columns<'_>, row: usize);
}

impl<const N: usize> Row for [f64; N] {
    const CODES: &'static [c_char] = &[FLOAT64; N];
    const UNDEFINED: Self = [f64::NAN; N];
    type Columns<'a> = [&'a mut [f64]; N];

    unsafe fn columns<'a>(at: &[*mut c_char], rows: usize) -> Self::Columns<'a> {
        // SAFETY: the caller's promise.
        array::from_fn(|i| unsafe { slice::from_raw_parts_mut(at[i].cast(), rows) })
    }

    fn put(self, columns: &mut Self::Columns<'_>, row: usize) {
        for (column, value) in columns.iter_mut().zip(self) {
            column[row] = value;
        }
    }
}

impl Row for (i64, f64) {
    const CODES: &'static [c_char] = &[INT64, FLOAT64];
    const UNDEFINED: Self = (0, f64::NAN);
    type Columns<'a> = (&'a mut [i64], &'a mut [f64]);

    unsafe fn columns<'a>(at: &[*mut c_char], rows: usize) -> Self::Columns<'a> {
        // SAFETY: the caller's promise.
        unsafe {
            (slice::from_raw_parts_mut(at[0].cast(), rows), slice::from_raw_parts_mut(at[1].cast(), rows))
        }
    }

    fn put(self, columns: &mut Self::Columns<'_>, row: usize) {
        columns.0[row] = self.0;
        columns.1[row] = self.1;
    }
}

/// A kernel for a block of rows with results `R`.
pub struct Block<R, V> {
    value: V,
    results: PhantomData<fn() -> R>,
}

/// A kernel that takes whole columns.
pub fn whole<R: Row, V>(value: V) -> Block<R, V> {
    Block { value, results: PhantomData }
}

/// A kernel made of a function of one row.
#[allow(clippy::type_complexity)] // the type of a closure has no shorter name
pub fn each<S, R: Row, const X: usize>(
    value: impl Fn(&S, [f64; X]) -> R,
) -> Block<R, impl Fn(&S, [&[f64]; X], usize, R::Columns<'_>)> {
    whole(move |set_up: &S, samples: [&[f64]; X], rows: usize, mut columns: R::Columns<'_>| {
        for row in 0..rows {
            value(set_up, samples.map(|column| column[row])).put(&mut columns, row);
        }
    })
}

/// The set-up of kernels whose rows have none in common.
pub fn nothing([]: [f64; 0]) -> Option<()> {
    Some(())
}

/// The operands of a set-up by their bits, and what was made of them (`None`: refused).
type Last<S, const P: usize> = Option<([u64; P], Option<S>)>;

/// What NumPy hands back to the loop of one ufunc.
struct Kernel<M, V, S, const P: usize> {
    set_up: M,
    block: V,
    /// The last set-up of the last call, for calls that repeat an orbit.
    last: Mutex<Last<S, P>>,
    clear: extern "C" fn(),
}

/// Registers the ufunc `name` of `X` sample operands followed by `P` operands of the set-up.
///
/// A set-up is kept while its operands repeat bitwise, within a call and from call to call. Where `set_up` refuses
/// (`None`), the row is undefined: NaN for that element and for no other.
pub fn add<M, V, S, R, const X: usize, const P: usize>(
    module: &Bound<'_, PyModule>,
    name: &str,
    set_up: M,
    block: Block<R, V>,
) -> PyResult<()>
where
    M: Fn([f64; P]) -> Option<S> + Send + Sync + 'static,
    V: Fn(&S, [&[f64]; X], usize, R::Columns<'_>) + Send + Sync + 'static,
    S: Clone + Send + Sync + 'static,
    R: Row + 'static,
{
    let py = module.py();
    let kernel: Kernel<M, V, S, P> =
        Kernel { set_up, block: block.value, last: Mutex::new(None), clear: clear_status(py)? };
    const { assert!(X + P + R::CODES.len() <= WIDEST, "more operands than the loop has room for") };
    let mut codes = vec![FLOAT64; X + P];
    codes.extend_from_slice(R::CODES);
    let document = format!("Loop of the function of the same name in `libration`: {} operands.", X + P);

    // NumPy keeps every pointer as long as the ufunc, and the ufunc lives as long as the process: all of it is leaked.
    let function: PyUFuncGenericFunction = Some(sweep::<M, V, S, R, X, P>);
    let functions = Box::leak(Box::new([function]));
    let data = Box::leak(Box::new([ptr::from_mut(Box::leak(Box::new(kernel))).cast::<c_void>()]));
    let codes = codes.leak();
    let label = CString::new(name)?.into_raw();
    let document = CString::new(document)?.into_raw();

    const NO_IDENTITY: c_int = -1;
    // SAFETY: the arrays hold one loop, its data and the codes of its operands in order; none is ever freed.
    let ufunc = unsafe {
        let made = PY_UFUNC_API.PyUFunc_FromFuncAndData(
            py,
            functions.as_mut_ptr(),
            data.as_mut_ptr(),
            codes.as_mut_ptr(),
            1,
            (X + P) as c_int,
            R::CODES.len() as c_int,
            NO_IDENTITY,
            label,
            document,
            0,
        );
        Bound::from_owned_ptr_or_err(py, made)?
    };
    module.add(name, ufunc)
}

thread_local! {
    /// Columns of [`BLOCK`] rows for operands that are not side by side; kept from call to call, never cleared.
    static COLUMNS: Cell<Vec<f64>> = const { Cell::new(Vec::new()) };
}

/// The loop: `dimensions[0]` rows.
///
/// # Safety
/// Called by NumPy only, with the data that [`add`] registered and aligned operands of the registered codes.
unsafe extern "C" fn sweep<M, V, S, R, const X: usize, const P: usize>(
    args: *mut *mut c_char,
    dimensions: *mut npy_intp,
    steps: *mut npy_intp,
    data: *mut c_void,
) where
    M: Fn([f64; P]) -> Option<S> + Sync,
    V: Fn(&S, [&[f64]; X], usize, R::Columns<'_>) + Sync,
    S: Clone + Send + Sync,
    R: Row,
{
    let count = X + P + R::CODES.len();
    // SAFETY: `data` is the kernel leaked by `add` for exactly these types; the rest is NumPy's contract.
    let (kernel, rows, operands) = unsafe {
        let at = array::from_fn(|i| if i < count { *args.add(i) } else { ptr::null_mut() });
        let steps = array::from_fn(|i| if i < count { *steps.add(i) } else { 0 });
        (&*data.cast::<Kernel<M, V, S, P>>(), *dimensions as usize, Operands::<WIDEST> { at, steps })
    };
    // NumPy calls the loop for every stretch of an array, also after one that was ended.
    if signals::ending() {
        return;
    }
    let kept = kernel.last.lock().map_or(None, |kept| kept.clone());
    let fed_back = operands.fed_back(X + P, R::CODES.len(), rows);
    let block = if fed_back { 1 } else { BLOCK };
    let section = |from: usize, rows: usize, stop: Stop<'_>| {
        let operands = operands.starting(from);
        section::<M, V, S, R, X, P>(kernel, &operands, rows, block, kept.clone(), stop)
    };
    let done =
        if fed_back { signals::watched(|stop| section(0, rows, stop)) } else { pool::share(rows, section) };
    match done {
        Ok(renewed @ Some(_)) => {
            if let Ok(mut kept) = kernel.last.lock() {
                *kept = renewed;
            }
        }
        Ok(None) => {}
        Err(error) => signals::leave(error),
    }
    // A NaN or an infinity here is a documented result, and intermediate flags mean nothing: no RuntimeWarning.
    (kernel.clear)();
}

/// A set-up counts as so many rows: it takes some microseconds, the slowest a tenth of a millisecond.
const ROWS_OF_A_SET_UP: usize = 64;

/// A section of the rows on one thread, or the start of it where a signal stops it; the last set-up if it is a new one.
fn section<M, V, S, R, const X: usize, const P: usize>(
    kernel: &Kernel<M, V, S, P>,
    operands: &Operands<WIDEST>,
    rows: usize,
    block: usize,
    mut last: Last<S, P>,
    stop: Stop<'_>,
) -> Last<S, P>
where
    M: Fn([f64; P]) -> Option<S>,
    V: Fn(&S, [&[f64]; X], usize, R::Columns<'_>),
    R: Row,
{
    let outputs = R::CODES.len();
    // Taken, not borrowed: a signal handler may call a ufunc on this thread.
    let mut kept_columns = COLUMNS.take();
    if kept_columns.len() < (X + outputs) * BLOCK {
        kept_columns.resize((X + outputs) * BLOCK, f64::NAN);
    }
    let (samples, results) = kept_columns.split_at_mut(X * BLOCK);
    let in_place: [bool; WIDEST] =
        array::from_fn(|o| block > 1 && o < outputs && operands.in_place(X + P + o, X + P + outputs, rows));
    let mut renewed = false;
    // One orbit for the whole loop: nothing to compare row by row.
    let one = operands.steps[X..X + P].iter().all(|step| *step == 0);
    let key_of = |row: usize| array::from_fn::<u64, P, _>(|i| operands.read(X + i, row).to_bits());
    let mut row = 0;
    while row < rows {
        let key = key_of(row);
        let mut work = 0;
        if last.as_ref().is_none_or(|(kept, _)| *kept != key) {
            last = Some((key, (kernel.set_up)(key.map(f64::from_bits))));
            renewed = true;
            work = ROWS_OF_A_SET_UP;
        }
        let most = block.min(rows - row);
        let run = if one { most } else { 1 + (1..most).take_while(|next| key_of(row + next) == key).count() };
        // The whole run is computed before any of it is written where an input may stand.
        let inputs: [Option<&[f64]>; X] = array::from_fn(|i| operands.side_by_side(i, row, run));
        for (i, column) in samples.chunks_exact_mut(BLOCK).enumerate() {
            if inputs[i].is_none() {
                for (next, sample) in column[..run].iter_mut().enumerate() {
                    *sample = operands.read(i, row + next);
                }
            }
        }
        let to = operands.starting(row);
        let (own, theirs) = (results.as_mut_ptr(), &to.at[X + P..]);
        let at: [*mut c_char; WIDEST] = array::from_fn(|o| match o {
            o if o >= outputs => ptr::null_mut(),
            o if in_place[o] => theirs[o],
            o => own.wrapping_add(o * BLOCK).cast(),
        });
        // SAFETY: the columns are ours or the rows of an output that is apart from every other operand.
        let mut columns = unsafe { R::columns(&at, run) };
        match last.as_ref().and_then(|(_, made)| made.as_ref()) {
            Some(made) => {
                let inputs = array::from_fn(|i| inputs[i].unwrap_or(&samples[i * BLOCK..][..run]));
                (kernel.block)(made, inputs, run, columns);
            }
            None => (0..run).for_each(|next| R::UNDEFINED.put(&mut columns, next)),
        }
        for o in (0..outputs).filter(|o| !in_place[*o]) {
            // SAFETY: the outputs follow the inputs, one aligned and writable address of 64 bits per row.
            unsafe { store(at[o].cast(), run, theirs[o], to.steps[X + P + o]) };
        }
        row += run;
        if stop(work + run) {
            break;
        }
    }
    COLUMNS.set(kept_columns);
    if renewed { last } else { None }
}

/// Writes a column of 64-bit values to rows that are `step` bytes apart.
///
/// # Safety
/// The column has so many values, and `at` is the address of the first of as many aligned and writable rows outside it.
unsafe fn store(column: *const u64, rows: usize, at: *mut c_char, step: npy_intp) {
    let at = at.cast::<u64>();
    if step == size_of::<u64>() as npy_intp {
        // SAFETY: the caller's promise.
        return unsafe { ptr::copy_nonoverlapping(column, at, rows) };
    }
    for row in 0..rows {
        // SAFETY: the caller's promise.
        unsafe { at.byte_offset(row as npy_intp * step).write(*column.add(row)) };
    }
}

/// `PyUFunc_clearfperr`, which the loop calls without holding the interpreter.
fn clear_status(py: Python<'_>) -> PyResult<extern "C" fn()> {
    let table =
        py.import("numpy._core._multiarray_umath")?.getattr("_UFUNC_API")?.cast_into::<PyCapsule>()?;
    let table = table.pointer_checked(None)?.cast::<extern "C" fn()>();
    // SAFETY: the capsule is NumPy's own table of function pointers, and this slot has this type.
    Ok(unsafe { table.add(CLEAR_SLOT).read() })
}

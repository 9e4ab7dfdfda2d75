//! Kernels as real NumPy ufuncs; with ufunc/interpreter.rs all `unsafe` of the binding.
//!
//! A kernel is two functions: `set_up` makes of the last operands of a row what belongs to them alone (an orbit, a
//! parameter), and `block` makes of that and of columns of the first operands the columns of results, a block of rows
//! at a time. [`add`] registers the pair as a ufunc of float64 operands; broadcasting, casting, `out=`, `where=` and
//! overlapping memory are NumPy's. Long loops are shared out to the threads of pool.rs and end at a signal: NumPy runs
//! them without the interpreter, and looks for an error when they are done.
//! Source: the NumPy C API, "UFunc API", <https://numpy.org/doc/stable/reference/c-api/ufunc.html>.

pub mod interpreter;

use std::array;
use std::ffi::{CString, c_char, c_int, c_long, c_void};
use std::marker::PhantomData;
use std::ptr;
use std::slice;
use std::sync::Mutex;

use numpy::npyffi::{NPY_TYPES, PY_UFUNC_API, PyUFuncGenericFunction, npy_intp};
use pyo3::prelude::*;
use pyo3::types::PyCapsule;

use crate::pool;
use crate::signals::{self, Stop};

/// Rows computed at a time: their columns stay in the nearest cache.
pub const BLOCK: usize = 512;

/// NumPy's code of float64.
const FLOAT64: c_char = NPY_TYPES::NPY_DOUBLE as c_char;

/// NumPy's code of int64: the C type that has 64 bits.
const INT64: c_char =
    if size_of::<c_long>() == 8 { NPY_TYPES::NPY_LONG as c_char } else { NPY_TYPES::NPY_LONGLONG as c_char };

/// Place of `PyUFunc_clearfperr` in the table of NumPy's ufunc API.
const CLEAR_SLOT: usize = 27;

/// The results of one row, and the columns of a block of rows.
pub trait Row: Copy + Send {
    /// NumPy's codes of the results.
    const CODES: &'static [c_char];
    /// The results where the set-up is refused.
    const UNDEFINED: Self;
    /// Columns of [`BLOCK`] rows.
    type Columns;
    /// Columns to be filled.
    fn columns() -> Self::Columns;
    /// One row of the columns.
    fn put(self, columns: &mut Self::Columns, row: usize);
    /// Writes the first `rows` of the columns, each to its own addresses.
    ///
    /// # Safety
    /// `at` holds the address of the first row of each column, `steps` the bytes to the next; all are aligned and
    /// writable.
    unsafe fn store(columns: &Self::Columns, rows: usize, at: &[*mut c_char], steps: &[npy_intp]);
}

/// Writes the first rows of one column.
///
/// # Safety
/// As for [`Row::store`].
unsafe fn store_column<T: Copy>(column: &[T], at: *mut c_char, step: npy_intp) {
    if step == size_of::<T>() as npy_intp {
        // SAFETY: the caller's promise; the column is ours, so the two are apart.
        unsafe { ptr::copy_nonoverlapping(column.as_ptr(), at.cast::<T>(), column.len()) };
        return;
    }
    for (row, value) in column.iter().enumerate() {
        // SAFETY: the caller's promise.
        unsafe { at.offset(row as npy_intp * step).cast::<T>().write(*value) };
    }
}

impl<const N: usize> Row for [f64; N] {
    const CODES: &'static [c_char] = &[FLOAT64; N];
    const UNDEFINED: Self = [f64::NAN; N];
    type Columns = [[f64; BLOCK]; N];

    fn columns() -> Self::Columns {
        [[f64::NAN; BLOCK]; N]
    }

    fn put(self, columns: &mut Self::Columns, row: usize) {
        for (column, value) in columns.iter_mut().zip(self) {
            column[row] = value;
        }
    }

    unsafe fn store(columns: &Self::Columns, rows: usize, at: &[*mut c_char], steps: &[npy_intp]) {
        for ((column, place), step) in columns.iter().zip(at).zip(steps) {
            // SAFETY: the caller's promise.
            unsafe { store_column(&column[..rows], *place, *step) };
        }
    }
}

impl Row for (i64, f64) {
    const CODES: &'static [c_char] = &[INT64, FLOAT64];
    const UNDEFINED: Self = (0, f64::NAN);
    type Columns = ([i64; BLOCK], [f64; BLOCK]);

    fn columns() -> Self::Columns {
        ([0; BLOCK], [f64::NAN; BLOCK])
    }

    fn put(self, columns: &mut Self::Columns, row: usize) {
        columns.0[row] = self.0;
        columns.1[row] = self.1;
    }

    unsafe fn store(columns: &Self::Columns, rows: usize, at: &[*mut c_char], steps: &[npy_intp]) {
        // SAFETY: the caller's promise.
        unsafe {
            store_column(&columns.0[..rows], at[0], steps[0]);
            store_column(&columns.1[..rows], at[1], steps[1]);
        }
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
) -> Block<R, impl Fn(&S, [&[f64]; X], usize, &mut R::Columns)> {
    whole(move |set_up: &S, samples: [&[f64]; X], rows: usize, columns: &mut R::Columns| {
        for row in 0..rows {
            value(set_up, samples.map(|column| column[row])).put(columns, row);
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
    V: Fn(&S, [&[f64]; X], usize, &mut R::Columns) + Send + Sync + 'static,
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

/// The operands of a loop: operand `i` of row `j` at `at[i] + j * steps[i]`.
#[derive(Clone, Copy)]
struct Operands<const O: usize> {
    at: [*mut c_char; O],
    steps: [npy_intp; O],
}

// SAFETY: NumPy lets the loop read and write these addresses until it returns, from whichever thread; the threads of
// one loop have rows of their own.
unsafe impl<const O: usize> Sync for Operands<O> {}

impl<const O: usize> Operands<O> {
    /// The operands from a row on.
    fn starting(&self, row: usize) -> Self {
        // SAFETY: the row is inside the loop, so the addresses are inside the operands.
        let at = array::from_fn(|i| unsafe { self.at[i].offset(row as npy_intp * self.steps[i]) });
        Operands { at, steps: self.steps }
    }

    /// Input `i` of a row.
    fn read(&self, i: usize, row: usize) -> f64 {
        // SAFETY: an input operand is an aligned, readable float64 in every row of the loop.
        unsafe { self.at[i].offset(row as npy_intp * self.steps[i]).cast::<f64>().read() }
    }

    /// Some rows of input `i` where they lie, if they lie side by side.
    fn side_by_side(&self, i: usize, row: usize, rows: usize) -> Option<&[f64]> {
        // SAFETY: as for `read`, row after row; nothing is written while the rows are in use.
        (self.steps[i] == size_of::<f64>() as npy_intp)
            .then(|| unsafe { slice::from_raw_parts(self.at[i].cast::<f64>().add(row), rows) })
    }

    /// First and last byte of an operand.
    fn extent(&self, i: usize, rows: usize) -> (isize, isize) {
        let start = self.at[i] as isize;
        let end = start + self.steps[i] * (rows.max(1) as isize - 1);
        (start.min(end), start.max(end) + 7)
    }

    /// Whether a row may be written before another is read: then rows go one by one. NumPy copies overlapping
    /// operands beforehand, but its reductions and accumulations feed results back.
    fn fed_back(&self, inputs: usize, outputs: usize, rows: usize) -> bool {
        let feeds = |o: usize, i: usize| {
            let ((first, last), (other_first, other_last)) = (self.extent(o, rows), self.extent(i, rows));
            let (step, other_step) = (self.steps[o], self.steps[i]);
            let apart = self.at[o] as isize - self.at[i] as isize;
            let same_rows = apart == 0 && step == other_step;
            // Columns of one table: the same step, and never in each other's place.
            let interleaved = step == other_step && step != 0 && {
                let within = apart.rem_euclid(step.abs());
                within >= 8 && within <= step.abs() - 8
            };
            last >= other_first && other_last >= first && !same_rows && !interleaved
        };
        rows > 1 && (inputs..inputs + outputs).any(|o| self.steps[o] == 0 || (0..inputs).any(|i| feeds(o, i)))
    }
}

/// Operands of the widest ufunc: five inputs of the set-up, one sample, twelve results.
const WIDEST: usize = 18;

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
    V: Fn(&S, [&[f64]; X], usize, &mut R::Columns) + Sync,
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
    V: Fn(&S, [&[f64]; X], usize, &mut R::Columns),
    R: Row,
{
    let mut samples = [[0.0; BLOCK]; X];
    let mut columns = R::columns();
    let mut renewed = false;
    let outputs = X + P..X + P + R::CODES.len();
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
        // The whole run is computed before any of it is written: an output may be the very array of an input.
        let inputs: [Option<&[f64]>; X] = array::from_fn(|i| operands.side_by_side(i, row, run));
        for (i, column) in samples.iter_mut().enumerate() {
            if inputs[i].is_none() {
                for (next, sample) in column[..run].iter_mut().enumerate() {
                    *sample = operands.read(i, row + next);
                }
            }
        }
        match last.as_ref().and_then(|(_, made)| made.as_ref()) {
            Some(made) => {
                let inputs = array::from_fn(|i| inputs[i].unwrap_or(&samples[i][..run]));
                (kernel.block)(made, inputs, run, &mut columns)
            }
            None => (0..run).for_each(|next| R::UNDEFINED.put(&mut columns, next)),
        }
        let to = operands.starting(row);
        // SAFETY: the outputs follow the inputs, one aligned and writable address per code and row.
        unsafe { R::store(&columns, run, &to.at[outputs.clone()], &to.steps[outputs.clone()]) };
        row += run;
        if stop(work + run) {
            break;
        }
    }
    if renewed { last } else { None }
}

/// `PyUFunc_clearfperr`, which the loop calls without holding the interpreter.
fn clear_status(py: Python<'_>) -> PyResult<extern "C" fn()> {
    let table =
        py.import("numpy._core._multiarray_umath")?.getattr("_UFUNC_API")?.cast_into::<PyCapsule>()?;
    let table = table.pointer_checked(None)?.cast::<extern "C" fn()>();
    // SAFETY: the capsule is NumPy's own table of function pointers, and this slot has this type.
    Ok(unsafe { table.add(CLEAR_SLOT).read() })
}

//! Kernels as real NumPy ufuncs; the only file of the door with `unsafe`.
//!
//! A kernel is two functions: `set_up` makes of the last operands of a row what belongs to them alone (an orbit, a
//! parameter), and `value` makes of that and of the first operands the row's results. [`add`] registers the pair as a
//! ufunc of float64 operands; broadcasting, casting, `out=`, `where=` and overlapping memory are NumPy's.
//! Source: the NumPy C API, "UFunc API", <https://numpy.org/doc/stable/reference/c-api/ufunc.html>.

use std::array;
use std::ffi::{CString, c_char, c_int, c_long, c_void};
use std::ptr;
use std::sync::Mutex;

use numpy::npyffi::{NPY_TYPES, PY_UFUNC_API, PyUFuncGenericFunction, npy_intp};
use pyo3::prelude::*;
use pyo3::types::PyCapsule;

/// NumPy's code of float64.
const FLOAT64: c_char = NPY_TYPES::NPY_DOUBLE as c_char;

/// NumPy's code of int64: the C type that has 64 bits.
const INT64: c_char =
    if size_of::<c_long>() == 8 { NPY_TYPES::NPY_LONG as c_char } else { NPY_TYPES::NPY_LONGLONG as c_char };

/// Place of `PyUFunc_clearfperr` in the table of NumPy's ufunc API.
const CLEAR_SLOT: usize = 27;

/// The results of one row.
pub trait Row {
    /// NumPy's codes of the results.
    const CODES: &'static [c_char];
    /// The results where the set-up is refused.
    const UNDEFINED: Self;
    /// Writes the results, each at its own address.
    ///
    /// # Safety
    /// `at` holds one address per code, aligned and writable.
    unsafe fn store(self, at: &[*mut c_char]);
}

impl<const N: usize> Row for [f64; N] {
    const CODES: &'static [c_char] = &[FLOAT64; N];
    const UNDEFINED: Self = [f64::NAN; N];

    unsafe fn store(self, at: &[*mut c_char]) {
        for (value, place) in self.into_iter().zip(at) {
            // SAFETY: the caller's promise.
            unsafe { place.cast::<f64>().write(value) };
        }
    }
}

impl Row for (i64, f64) {
    const CODES: &'static [c_char] = &[INT64, FLOAT64];
    const UNDEFINED: Self = (0, f64::NAN);

    unsafe fn store(self, at: &[*mut c_char]) {
        // SAFETY: the caller's promise.
        unsafe {
            at[0].cast::<i64>().write(self.0);
            at[1].cast::<f64>().write(self.1);
        }
    }
}

/// The operands of a set-up by their bits, and what was made of them (`None`: refused).
type Last<S, const P: usize> = Option<([u64; P], Option<S>)>;

/// What NumPy hands back to the loop of one ufunc.
struct Kernel<M, V, S, const P: usize> {
    set_up: M,
    value: V,
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
    value: V,
) -> PyResult<()>
where
    M: Fn([f64; P]) -> Option<S> + Send + Sync + 'static,
    V: Fn(&S, [f64; X]) -> R + Send + Sync + 'static,
    S: Clone + Send + 'static,
    R: Row + 'static,
{
    let py = module.py();
    let kernel: Kernel<M, V, S, P> =
        Kernel { set_up, value, last: Mutex::new(None), clear: clear_status(py)? };
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

/// The loop: `dimensions[0]` rows, operand `i` of row `j` at `args[i] + j * steps[i]`.
///
/// # Safety
/// Called by NumPy only, with the data that [`add`] registered and aligned operands of the registered codes.
unsafe extern "C" fn sweep<M, V, S, R, const X: usize, const P: usize>(
    args: *mut *mut c_char,
    dimensions: *mut npy_intp,
    steps: *mut npy_intp,
    data: *mut c_void,
) where
    M: Fn([f64; P]) -> Option<S>,
    V: Fn(&S, [f64; X]) -> R,
    S: Clone,
    R: Row,
{
    // SAFETY: `data` is the kernel leaked by `add` for exactly these types; the rest is NumPy's contract.
    let (kernel, rows) = unsafe { (&*data.cast::<Kernel<M, V, S, P>>(), *dimensions) };
    let operand = |index: usize, row: npy_intp| -> *mut c_char {
        // SAFETY: `index` counts operands, `row` is below the number of rows, so the address is inside the operand.
        unsafe { (*args.add(index)).offset(row * *steps.add(index)) }
    };
    // SAFETY: an input operand is an aligned, readable float64.
    let read = |index: usize, row: npy_intp| unsafe { operand(index, row).cast::<f64>().read() };

    let mut last = kernel.last.lock().map_or(None, |kept| kept.clone());
    let mut renewed = false;
    for row in 0..rows {
        // A whole row is read before any of it is written: an output may be the very array of an input.
        let sample: [f64; X] = array::from_fn(|i| read(i, row));
        let arguments: [f64; P] = array::from_fn(|i| read(X + i, row));
        let outputs: [*mut c_char; 4] =
            array::from_fn(|i| if i < R::CODES.len() { operand(X + P + i, row) } else { ptr::null_mut() });

        let key = arguments.map(f64::to_bits);
        if last.as_ref().is_none_or(|(kept, _)| *kept != key) {
            last = Some((key, (kernel.set_up)(arguments)));
            renewed = true;
        }
        let set_up = last.as_ref().and_then(|(_, made)| made.as_ref());
        let results = set_up.map_or(R::UNDEFINED, |made| (kernel.value)(made, sample));
        // SAFETY: the outputs follow the inputs, one aligned and writable address per code.
        unsafe { results.store(&outputs) };
    }
    if renewed && let Ok(mut kept) = kernel.last.lock() {
        *kept = last;
    }
    // A NaN or an infinity here is a documented result, and intermediate flags mean nothing: no RuntimeWarning.
    (kernel.clear)();
}

/// `PyUFunc_clearfperr`, which the loop calls without holding the interpreter.
fn clear_status(py: Python<'_>) -> PyResult<extern "C" fn()> {
    let table =
        py.import("numpy._core._multiarray_umath")?.getattr("_UFUNC_API")?.cast_into::<PyCapsule>()?;
    let table = table.pointer_checked(None)?.cast::<extern "C" fn()>();
    // SAFETY: the capsule is NumPy's own table of function pointers, and this slot has this type.
    Ok(unsafe { table.add(CLEAR_SLOT).read() })
}

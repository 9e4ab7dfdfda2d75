//! Functions of columns as handlers of XLA's typed foreign functions, for `libration.jax`.
//!
//! XLA calls a handler with a frame of buffers; [`add`] puts the handler's address into a capsule, which JAX registers by
//! name. A handler is asked once for its version of the interface, and is refused by XLA where that is too old or too new.
//! What a later version may add stands behind the fields that are read here; every struct states its size, and a frame of
//! another shape is answered with an error of one line. Handlers never ask for the interpreter: XLA's threads may run
//! while the thread that holds it waits for them.
//! Source: openxla/xla, `xla/ffi/api/c_api.h` of version 0.3 (in the include directory of jaxlib 0.9.1 to 0.11.0).

use std::array;
use std::ffi::{CString, c_char, c_int, c_void};
use std::mem::offset_of;
use std::ptr::{self, NonNull};
use std::slice;

use numpy::npyffi::npy_intp;
use pyo3::prelude::*;
use pyo3::types::PyCapsule;

use super::operands::{Operands, WIDEST};
use super::{BLOCK, Row};
use crate::pool;

/// The version of the interface that the structs below are of.
const VERSION: (c_int, c_int) = (0, 3);
/// XLA's code of float64.
const FLOAT64: c_int = 12;
/// Of a buffer among arguments or results.
const BUFFER: c_int = 1;
/// Of the extension that asks for the version.
const METADATA: c_int = 1;
/// Of the stage in which buffers may be read.
const EXECUTE: c_int = 3;
/// XLA's codes of errors.
const INVALID_ARGUMENT: c_int = 3;
const FAILED_PRECONDITION: c_int = 9;

/// How every struct begins.
#[repr(C)]
struct Head {
    size: usize,
    extension: *mut Extension,
}

#[repr(C)]
struct Extension {
    size: usize,
    kind: c_int,
    next: *mut Extension,
}

#[repr(C)]
struct Version {
    head: Head,
    major: c_int,
    minor: c_int,
}

#[repr(C)]
struct Metadata {
    size: usize,
    version: Version,
    traits: u32,
    state_type: i64,
}

#[repr(C)]
struct MetadataExtension {
    base: Extension,
    metadata: *mut Metadata,
}

/// An error of XLA's, which owns it.
#[repr(C)]
pub struct Error {
    _opaque: [u8; 0],
}

#[repr(C)]
struct ErrorCreate {
    head: Head,
    message: *const c_char,
    code: c_int,
}

#[repr(C)]
struct Api {
    head: Head,
    version: Version,
    internal: *const c_void,
    error_create: unsafe extern "C" fn(*mut ErrorCreate) -> *mut Error,
}

#[repr(C)]
struct Buffer {
    head: Head,
    dtype: c_int,
    data: *mut c_char,
    rank: i64,
    dims: *const i64,
}

/// The arguments, or the results.
#[repr(C)]
struct Buffers {
    head: Head,
    count: i64,
    kinds: *const c_int,
    at: *const *const Buffer,
}

/// A call, up to the last field that is read.
#[repr(C)]
struct Frame {
    head: Head,
    api: *const Api,
    context: *mut c_void,
    stage: c_int,
    arguments: Buffers,
    results: Buffers,
}

/// A function of `X` columns that fills `R` columns of the same length, row by row.
pub trait Columns<const X: usize, const R: usize> {
    /// Fills the columns.
    fn fill(given: [&[f64]; X], found: [&mut [f64]; R]);
}

/// Adds the handler of a function to the module, as a capsule with this name.
pub fn add<F: Columns<X, R>, const X: usize, const R: usize>(
    module: &Bound<'_, PyModule>,
    name: &str,
) -> PyResult<()> {
    const { assert!(X + R <= WIDEST, "more operands than there is room for") };
    let handler: unsafe extern "C" fn(*mut Frame) -> *mut Error = handler::<F, X, R>;
    let Some(address) = NonNull::new(handler as *mut c_void) else { return Ok(()) };
    // SAFETY: a function lives as long as the process.
    let capsule = unsafe { PyCapsule::new_with_pointer(module.py(), address, c"xla._CUSTOM_CALL_TARGET")? };
    module.add(name, capsule)
}

/// What XLA calls.
///
/// # Safety
/// Called by XLA only, with a frame of the shape that its sizes state and buffers that nothing else writes meanwhile.
unsafe extern "C" fn handler<F: Columns<X, R>, const X: usize, const R: usize>(
    frame: *mut Frame,
) -> *mut Error {
    // SAFETY: the sizes are compared before any field that they might not reach; only whole fields of XLA's are read.
    let (api, answer) = unsafe {
        let api = (*frame).api;
        (api, asked_version(frame).unwrap_or_else(|| run::<F, X, R>(frame)))
    };
    match answer {
        Ok(()) => ptr::null_mut(),
        // SAFETY: the interface of the frame, whose head and first function no version has moved.
        Err((code, message)) => unsafe { error(api, code, &message) },
    }
}

type Answer = Result<(), (c_int, String)>;

/// Answers the question for the version, if the frame asks it.
///
/// # Safety
/// As for [`handler`].
unsafe fn asked_version(frame: *mut Frame) -> Option<Answer> {
    // SAFETY: every frame has a head; an extension has at least its base; sizes are compared before the rest is used.
    unsafe {
        let asked = (*frame).head.extension.cast::<MetadataExtension>();
        if asked.is_null() || (*asked).base.kind != METADATA {
            return None;
        }
        let metadata = (*asked).metadata;
        let least = offset_of!(Metadata, traits) + size_of::<u32>();
        if (*asked).base.size < size_of::<MetadataExtension>() || (*metadata).size < least {
            return Some(Err((FAILED_PRECONDITION, other_version("question for the version"))));
        }
        let (major, minor) = VERSION;
        let head = Head { size: size_of::<Version>(), extension: ptr::null_mut() };
        (*metadata).version = Version { head, major, minor };
        (*metadata).traits = 0;
        // A field of version 0.3, which XLA leaves out of the size: 0 for a handler without a state.
        let version = &(*(*frame).api).version;
        if (version.major, version.minor) >= VERSION {
            (*metadata).state_type = 0;
        }
        Some(Ok(()))
    }
}

/// One line on a struct that is not as it was in the version that is known here.
fn other_version(what: &str) -> String {
    let (major, minor) = VERSION;
    format!(
        "libration: the {what} is not that of XLA's foreign functions {major}.{minor}: a newer libration is needed"
    )
}

/// Fills the results of a frame.
///
/// # Safety
/// As for [`handler`].
unsafe fn run<F: Columns<X, R>, const X: usize, const R: usize>(frame: *mut Frame) -> Answer {
    // SAFETY: XLA's contract for frames, args and buffers; sizes come first.
    let (rows, operands) = unsafe {
        let whole = size_of::<Buffers>();
        let known = (*frame).head.size >= size_of::<Frame>()
            && (*frame).arguments.head.size == whole
            && (*frame).results.head.size == whole;
        if !known {
            return Err((FAILED_PRECONDITION, other_version("call")));
        }
        if (*frame).stage != EXECUTE {
            return Err((FAILED_PRECONDITION, format!("libration: no handler of stage {}", (*frame).stage)));
        }
        let given = buffers::<X>(&(*frame).arguments, "arguments")?;
        let found = buffers::<R>(&(*frame).results, "results")?;
        let all = given.iter().chain(&found);
        let Some(&(rows, _)) = all.clone().next() else { return Ok(()) };
        if all.clone().any(|(other, _)| *other != rows) {
            return Err((
                INVALID_ARGUMENT,
                "libration: all arguments and results must have one shape".into(),
            ));
        }
        let mut at = [ptr::null_mut(); WIDEST];
        at.iter_mut().zip(all).for_each(|(at, (_, data))| *at = *data);
        let steps = array::from_fn(|i| if i < X + R { size_of::<f64>() as npy_intp } else { 0 });
        (rows, Operands::<WIDEST> { at, steps })
    };
    pool::share_alone(rows, |from, rows| section::<F, X, R>(&operands, from, rows));
    Ok(())
}

/// Fills some rows, a block at a time.
fn section<F: Columns<X, R>, const X: usize, const R: usize>(
    operands: &Operands<WIDEST>,
    from: usize,
    rows: usize,
) {
    for row in (from..from + rows).step_by(BLOCK) {
        let run = BLOCK.min(from + rows - row);
        let to = operands.starting(row);
        let given: [&[f64]; X] = array::from_fn(|i| operands.side_by_side(i, row, run).unwrap_or(&[]));
        // SAFETY: XLA gives every result a place of its own, and no other section has these rows.
        F::fill(given, unsafe { <[f64; R]>::columns(&to.at[X..], run) });
    }
}

/// The sizes and addresses of `N` buffers of float64.
///
/// # Safety
/// The struct is XLA's, whole.
unsafe fn buffers<const N: usize>(
    of: &Buffers,
    name: &str,
) -> Result<[(usize, *mut c_char); N], (c_int, String)> {
    if of.count != N as i64 {
        return Err((INVALID_ARGUMENT, format!("libration: {} {name}, must be {N}", of.count)));
    }
    let mut found = [(0, ptr::null_mut()); N];
    for (i, place) in found.iter_mut().enumerate() {
        // SAFETY: there are as many kinds and addresses as were counted, and a buffer has as many dimensions as its rank.
        unsafe {
            let buffer = *of.at.add(i);
            if *of.kinds.add(i) != BUFFER || (*buffer).head.size < size_of::<Buffer>() {
                return Err((FAILED_PRECONDITION, other_version("buffer")));
            }
            if (*buffer).dtype != FLOAT64 {
                return Err((INVALID_ARGUMENT, format!("libration: {name} must be float64")));
            }
            let rank = (*buffer).rank as usize;
            let dims = if rank == 0 { &[] } else { slice::from_raw_parts((*buffer).dims, rank) };
            *place = (dims.iter().product::<i64>() as usize, (*buffer).data);
        }
    }
    Ok(found)
}

/// An error of XLA's with a message.
///
/// # Safety
/// The interface is that of a frame.
unsafe fn error(api: *const Api, code: c_int, message: &str) -> *mut Error {
    let message = CString::new(message).unwrap_or_default();
    let head = Head { size: offset_of!(ErrorCreate, code) + size_of::<c_int>(), extension: ptr::null_mut() };
    let mut arguments = ErrorCreate { head, message: message.as_ptr(), code };
    // SAFETY: XLA copies the message before it returns.
    unsafe { ((*api).error_create)(&raw mut arguments) }
}

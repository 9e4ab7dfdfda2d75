//! The reader of files: instants for `--times`.

use numpy::{IntoPyArray, PyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// The instants in a column of a file's bytes, in s, and the column's name. `quoted` shows a text in a message.
///
/// `ValueError(column, reason)`: whether the column asked for is to blame, and what was found and is allowed.
#[pyfunction]
fn instants<'py>(
    py: Python<'py>,
    file: &str,
    data: &[u8],
    column: Option<&str>,
    quoted: &Bound<'py, PyAny>,
) -> PyResult<(Bound<'py, PyArray1<f64>>, String)> {
    let shown = |text: &str| {
        let shown = quoted.call1((text,)).and_then(|shown| shown.extract());
        shown.unwrap_or_else(|_| format!("{text:?}"))
    };
    match libration_fit::instants(file, data, column, &shown) {
        Ok(found) => Ok((found.time.into_pyarray(py), found.name)),
        Err(unread) => Err(PyValueError::new_err((unread.column, unread.reason))),
    }
}

/// Adds what stands here to the module.
pub fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(instants, module)?)
}

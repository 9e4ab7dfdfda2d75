//! The reader of files: one column of numbers, for `--times` and for series that are drawn.

use libration_fit::Wanted;
use numpy::{IntoPyArray, PyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// A column of a file's bytes in the unit of factor 1, and its name.
///
/// `wanted` is the file as a message names it, what the column holds, the names by which it is known, its place if none
/// has such a name, and the sentence on its units; `factor` gives a unit's factor as a decimal text, `quoted` shows a text.
///
/// `ValueError(column, reason)`: whether the column asked for is to blame, and what was found and is allowed.
#[pyfunction]
fn column<'py>(
    py: Python<'py>,
    data: &[u8],
    name: Option<&str>,
    wanted: (String, String, Vec<String>, usize, String),
    factor: &Bound<'py, PyAny>,
    quoted: &Bound<'py, PyAny>,
) -> PyResult<(Bound<'py, PyArray1<f64>>, String)> {
    let (file, plural, names, place, takes) = wanted;
    let wanted = Wanted {
        file: &file,
        plural: &plural,
        names: &names,
        place,
        takes: &takes,
        factor: &|unit| factor.call1((unit,)).and_then(|factor| factor.extract()).ok().flatten(),
        quoted: &|text| {
            let shown = quoted.call1((text,)).and_then(|shown| shown.extract());
            shown.unwrap_or_else(|_| format!("{text:?}"))
        },
    };
    match libration_fit::column(data, name, &wanted) {
        Ok(found) => Ok((found.values.into_pyarray(py), found.name)),
        Err(unread) => Err(PyValueError::new_err((unread.column, unread.reason))),
    }
}

/// Adds what stands here to the module.
pub fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(column, module)?)
}

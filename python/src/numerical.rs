//! The numerical solutions by name, as arrays.

use libration::approx::Scheme;
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;

use crate::orbit::refused;
use crate::signals;
use crate::ufunc::BLOCK;

/// Adds the functions of this file.
pub fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(march, module)?)?;
    module.add_function(wrap_pyfunction!(schemes, module)?)
}

/// Angle and velocity at 0, step, 2 step, ... by a scheme.
#[pyfunction]
fn march<'py>(
    py: Python<'py>,
    scheme: &str,
    start: (f64, f64),
    omega2: f64,
    step: f64,
    count: usize,
) -> PyResult<[Bound<'py, PyArray1<f64>>; 2]> {
    let scheme = Scheme::named(scheme).map_err(refused)?;
    let (mut theta, mut velocity) = (vec![f64::NAN; count], vec![f64::NAN; count]);
    signals::detached(py, |stop| {
        let mut state = start;
        for (theta, velocity) in theta.chunks_mut(BLOCK).zip(velocity.chunks_mut(BLOCK)) {
            state = scheme.march(state, omega2, step, theta, velocity);
            if stop(BLOCK) {
                break;
            }
        }
    })?;
    Ok([theta.into_pyarray(py), velocity.into_pyarray(py)])
}

/// Name, formula and source of every scheme.
#[pyfunction]
fn schemes() -> Vec<[&'static str; 3]> {
    libration::approx::steps::SCHEMES.iter().map(|entry| [entry.name, entry.formula, entry.source]).collect()
}

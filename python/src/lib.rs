//! The Python binding: the module `libration._core`, on which the package `libration` stands.
//!
//! No formula and no arithmetic on doubles: everything is handed to the core.

mod approx;
mod approx_period;
mod damped;
mod duffing_form;
mod elliptic;
mod ensemble;
mod fit;
mod gradients;
mod kernels;
mod least_squares;
mod numerical;
mod orbit;
mod oscillator;
mod pool;
mod signals;
mod ufunc;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// Compiled part of `libration`: the ufuncs and the orbit behind its documented surface.
#[pymodule(gil_used = false)]
fn _core(module: &Bound<'_, PyModule>) -> PyResult<()> {
    pool::wanted().map_err(PyValueError::new_err)?;
    module.add("__version__", libration::VERSION)?;
    module.add_class::<orbit::Orbit>()?;
    approx::add_all(module)?;
    approx_period::add_all(module)?;
    damped::add_all(module)?;
    oscillator::add_all(module)?;
    numerical::add_all(module)?;
    elliptic::add_all(module)?;
    ensemble::add_all(module)?;
    fit::add_all(module)?;
    least_squares::add_all(module)?;
    gradients::add_all(module)?;
    kernels::add_all(module)
}

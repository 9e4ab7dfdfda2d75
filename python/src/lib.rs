//! The Python door: the module `libration._core`, on which the package `libration` stands.
//!
//! No formula and no arithmetic on doubles: everything is handed to the core.

mod kernels;
mod orbit;
mod ufunc;

use pyo3::prelude::*;

/// Compiled part of `libration`: the ufuncs and the orbit behind its documented surface.
#[pymodule(gil_used = false)]
fn _core(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<orbit::Orbit>()?;
    kernels::add_all(module)
}

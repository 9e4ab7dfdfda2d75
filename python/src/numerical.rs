//! The numerical solutions by name, as Python objects.

use libration::approx::{NUMERICALS, NumericalFormula, NumericalSolution as Solution};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::approx::each;
use crate::orbit::{Orbit, refused};
use crate::signals;

/// Adds what is in this file.
pub fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<NumericalSolution>()?;
    module.add_function(wrap_pyfunction!(schemes, module)?)
}

/// What a scheme makes of one orbit: what `libration.approx.NumericalSolution` stands on.
#[pyclass(frozen, weakref, module = "libration._core")]
pub struct NumericalSolution {
    solution: Solution,
}

#[pymethods]
impl NumericalSolution {
    #[new]
    fn new(py: Python<'_>, scheme: &str, step: Option<f64>, orbit: &Orbit, until: f64) -> PyResult<Self> {
        let formula = NumericalFormula::named(scheme, step).map_err(refused)?;
        let solved = signals::detached(py, |stop| formula.of_unless(&orbit.orbit, until, &|| stop(1)))?;
        Ok(Self { solution: solved.map_err(refused)? })
    }

    /// Angle at times from 0 to the end.
    fn theta<'py>(
        &self,
        py: Python<'py>,
        t: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        each(py, &t, |t| self.solution.motion(t).0)
    }

    /// Times, angles and velocities at the ends of all steps.
    fn steps<'py>(&self, py: Python<'py>) -> [Bound<'py, PyArray1<f64>>; 3] {
        let (mut t, mut theta, mut velocity) = (Vec::new(), Vec::new(), Vec::new());
        for end in (0..=self.solution.count()).filter_map(|i| self.solution.end_of_step(i)) {
            t.push(end.0);
            theta.push(end.1);
            velocity.push(end.2);
        }
        [t.into_pyarray(py), theta.into_pyarray(py), velocity.into_pyarray(py)]
    }

    /// When it goes over the top.
    #[getter]
    fn over_the_top(&self) -> f64 {
        self.solution.over_the_top()
    }
}

/// Name, formula and source of every scheme, and whether it takes a step.
#[pyfunction]
fn schemes() -> Vec<(&'static str, &'static str, &'static str, bool)> {
    let row = |entry: &'static libration::approx::Entry| {
        (entry.name, entry.formula, entry.source, NumericalFormula::takes_step(entry))
    };
    NUMERICALS.iter().map(row).collect()
}

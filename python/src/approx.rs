//! The approximations of the angle as Python objects.

use libration::approx::{
    ANGLES, AngleApproximation as Approximation, AngleFormula as Formula, Entry, LargestError,
};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::orbit::{Orbit, refused};
use crate::signals;

/// What an entry says: pattern, formula, source, stated range in words and in rad, and where it is undefined.
pub(crate) type Facts = (String, &'static str, &'static str, &'static str, Option<(f64, f64)>, &'static str);

/// What is known of a formula before it is asked anything.
pub(crate) fn facts(entry: &'static Entry) -> Facts {
    let range = entry.stated_range.map(|[low, high]| (low, high));
    (entry.pattern(), entry.formula, entry.source, entry.stated, range, entry.undefined)
}

/// One answer counts as so many rows of a ufunc: it takes some microseconds, the slowest half a millisecond.
const ROWS: usize = 64;

/// One answer for each argument.
pub(crate) fn each<'py>(
    py: Python<'py>,
    arguments: &PyReadonlyArray1<'py, f64>,
    answer: impl Fn(f64) -> f64 + Send + Sync,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let arguments = arguments.as_slice()?;
    let mut answers = vec![f64::NAN; arguments.len()];
    signals::detached(py, |stop| {
        for (argument, place) in arguments.iter().zip(&mut answers) {
            *place = answer(*argument);
            if stop(ROWS) {
                break;
            }
        }
    })?;
    Ok(answers.into_pyarray(py))
}

/// Pairs as Python's tuples.
pub(crate) fn pairs(ranges: Vec<[f64; 2]>) -> Vec<(f64, f64)> {
    ranges.into_iter().map(|[low, high]| (low, high)).collect()
}

/// A formula for the angle over time: what `libration.approx.AngleFormula` stands on.
#[pyclass(frozen, weakref, module = "libration._core")]
pub struct AngleFormula {
    formula: Formula,
}

#[pymethods]
impl AngleFormula {
    #[new]
    fn new(name: &str) -> PyResult<Self> {
        Ok(Self { formula: Formula::named(name).map_err(refused)? })
    }

    /// The patterns of all names.
    #[staticmethod]
    fn patterns() -> Vec<String> {
        ANGLES.iter().map(Entry::pattern).collect()
    }

    /// The name that finds it again.
    #[getter]
    fn name(&self) -> String {
        self.formula.name()
    }

    /// Pattern, formula, source, stated range in words and in rad, where undefined.
    #[getter]
    fn facts(&self) -> Facts {
        facts(self.formula.entry())
    }

    /// The formula for one orbit.
    fn of(&self, orbit: &Orbit) -> PyResult<AngleApproximation> {
        Ok(AngleApproximation { approximation: self.formula.of(&orbit.orbit).map_err(refused)? })
    }

    /// Turning angles for which the error stays within a share of them.
    fn ranges(&self, py: Python<'_>, bound: f64, periods: f64) -> PyResult<Vec<(f64, f64)>> {
        let found = signals::detached(py, |stop| self.formula.ranges_unless(bound, periods, &|| stop(ROWS)))?;
        Ok(pairs(found.map_err(refused)?))
    }
}

/// A formula for the angle set up for one orbit: what `libration.approx.AngleApproximation` stands on.
#[pyclass(frozen, weakref, module = "libration._core")]
pub struct AngleApproximation {
    approximation: Approximation,
}

#[pymethods]
impl AngleApproximation {
    /// The approximate angle at the times `t`.
    fn theta<'py>(
        &self,
        py: Python<'py>,
        t: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let t = t.as_slice()?;
        let mut theta = vec![f64::NAN; t.len()];
        signals::detached(py, |stop| {
            // On lanes, some at a time: the bits are those of single times.
            for (t, theta) in t.chunks(ROWS).zip(theta.chunks_mut(ROWS)) {
                self.approximation.theta_into(t, theta);
                if stop(ROWS * ROWS) {
                    break;
                }
            }
        })?;
        Ok(theta.into_pyarray(py))
    }

    /// The approximate minus the exact angle at the times `t`.
    fn difference<'py>(
        &self,
        py: Python<'py>,
        t: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        each(py, &t, |t| self.approximation.difference(t))
    }

    /// Period of the approximation.
    #[getter]
    fn period(&self) -> f64 {
        self.approximation.period()
    }

    /// The largest difference, the first time of it, and the first time at which there is none.
    fn largest_error(&self, py: Python<'_>, periods: f64) -> PyResult<(f64, f64, f64)> {
        let found =
            signals::detached(py, |stop| self.approximation.largest_error_unless(periods, &|| stop(ROWS)))?;
        let found = found.map_err(refused)?;
        let LargestError { difference, t, undefined_from } = found;
        Ok((difference, t, undefined_from))
    }
}

/// Adds the classes to the module.
pub(crate) fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<AngleFormula>()?;
    module.add_class::<AngleApproximation>()
}

//! The formulas of the period and the polynomials for the sine as Python objects.

use libration::approx::{Entry, PERIODS, PeriodFormula as Period, SINES, SineError, SineFormula as Sine};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::approx::{Facts, each, facts, pairs};
use crate::orbit::{Orbit, refused};

/// A formula of the period: what `libration.approx.PeriodFormula` stands on.
#[pyclass(frozen, weakref, module = "libration._core")]
pub struct PeriodFormula {
    formula: Period,
}

#[pymethods]
impl PeriodFormula {
    #[new]
    fn new(name: &str) -> PyResult<Self> {
        Ok(Self { formula: Period::named(name).map_err(refused)? })
    }

    /// The patterns of all names.
    #[staticmethod]
    fn patterns() -> Vec<String> {
        PERIODS.iter().map(Entry::pattern).collect()
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

    /// T/T0 at turning angles.
    fn ratio<'py>(
        &self,
        py: Python<'py>,
        theta_max: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        each(py, &theta_max, |theta_max| self.formula.ratio(theta_max))
    }

    /// T/T0 of parameters.
    fn ratio_of_m<'py>(
        &self,
        py: Python<'py>,
        m: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        each(py, &m, |m| self.formula.ratio_of_m(m))
    }

    /// T/T0 of complements of parameters.
    fn ratio_of_mc<'py>(
        &self,
        py: Python<'py>,
        mc: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        each(py, &mc, |mc| self.formula.ratio_of_mc(mc))
    }

    /// Relative error at turning angles.
    fn error<'py>(
        &self,
        py: Python<'py>,
        theta_max: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        each(py, &theta_max, |theta_max| self.formula.error(theta_max))
    }

    /// Relative error of parameters.
    fn error_of_m<'py>(
        &self,
        py: Python<'py>,
        m: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        each(py, &m, |m| self.formula.error_of_m(m))
    }

    /// Relative error of complements of parameters.
    fn error_of_mc<'py>(
        &self,
        py: Python<'py>,
        mc: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        each(py, &mc, |mc| self.formula.error_of_mc(mc))
    }

    /// The period of one orbit.
    fn period(&self, orbit: &Orbit) -> f64 {
        self.formula.period(&orbit.orbit)
    }

    /// A quarter of it.
    fn quarter_period(&self, orbit: &Orbit) -> f64 {
        self.formula.quarter_period(&orbit.orbit)
    }

    /// Turning angles for which the error stays within a bound.
    fn ranges(&self, py: Python<'_>, bound: f64) -> PyResult<Vec<(f64, f64)>> {
        Ok(pairs(py.detach(|| self.formula.ranges(bound)).map_err(refused)?))
    }
}

/// A polynomial for the sine: what `libration.approx.SineFormula` stands on.
#[pyclass(frozen, weakref, module = "libration._core")]
pub struct SineFormula {
    formula: Sine,
}

#[pymethods]
impl SineFormula {
    #[new]
    #[pyo3(signature = (name, phi_max=None))]
    fn new(py: Python<'_>, name: &str, phi_max: Option<f64>) -> PyResult<Self> {
        Ok(Self { formula: py.detach(|| Sine::named(name, phi_max)).map_err(refused)? })
    }

    /// The patterns of all names.
    #[staticmethod]
    fn patterns() -> Vec<String> {
        SINES.iter().map(Entry::pattern).collect()
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

    /// The range that a best polynomial is best on.
    #[getter]
    fn phi_max(&self) -> Option<f64> {
        self.formula.phi_max()
    }

    /// Coefficients of the odd powers.
    fn coefficients<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.formula.coefficients().to_vec().into_pyarray(py)
    }

    /// The polynomial at angles.
    fn value<'py>(
        &self,
        py: Python<'py>,
        phi: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        each(py, &phi, |phi| self.formula.value(phi))
    }

    /// Largest error up to an angle and where, absolute and relative.
    fn largest_error(&self, py: Python<'_>, phi_max: f64) -> PyResult<(f64, f64, f64, f64)> {
        let found = py.detach(|| self.formula.largest_error(phi_max)).map_err(refused)?;
        let SineError { absolute, at, relative, relative_at } = found;
        Ok((absolute, at, relative, relative_at))
    }

    /// Angles up to which the largest absolute error stays within a bound.
    fn ranges(&self, py: Python<'_>, bound: f64) -> PyResult<Vec<(f64, f64)>> {
        Ok(pairs(py.detach(|| self.formula.ranges(bound)).map_err(refused)?))
    }
}

/// Adds the classes to the module.
pub(crate) fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<PeriodFormula>()?;
    module.add_class::<SineFormula>()
}

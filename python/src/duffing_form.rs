//! The twelve forms of Duffing's solutions as Python objects.

use libration::Glaisher;
use libration::oscillator::DuffingForm as Form;
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::orbit::refused;
use crate::signals;
use crate::ufunc::BLOCK;

/// One of the twelve forms by its two letters.
fn glaisher(name: &str) -> PyResult<Glaisher> {
    let found = Glaisher::ALL.into_iter().find(|which| which.name() == name);
    found.ok_or_else(|| {
        let names: Vec<&str> = Glaisher::ALL.iter().map(|which| which.name()).collect();
        PyValueError::new_err(format!("form = {name}: must be one of {}", names.join(", ")))
    })
}

/// An array of results.
pub type Samples<'py> = Bound<'py, PyArray1<f64>>;

/// c1 pq(Omega t + c2 | m): what `libration.DuffingForm` stands on.
#[pyclass(frozen, weakref, module = "libration._core")]
pub struct DuffingForm {
    form: Form,
}

#[pymethods]
impl DuffingForm {
    #[new]
    fn new(form: &str, p: f64, q: f64, c1: f64, c2: f64) -> PyResult<Self> {
        Ok(Self { form: Form::new(glaisher(form)?, p, q, c1, c2).map_err(refused)? })
    }

    /// Omega.
    #[getter]
    fn rate(&self) -> f64 {
        self.form.rate()
    }

    /// The parameter and its complement.
    #[getter]
    fn parameter(&self) -> (f64, f64) {
        let parameter = self.form.parameter();
        (parameter.m(), parameter.mc())
    }

    /// Displacement and velocity at the times `t`.
    fn motion<'py>(
        &self,
        py: Python<'py>,
        t: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<(Samples<'py>, Samples<'py>)> {
        let t = t.as_slice()?;
        let (mut u, mut velocity) = (vec![f64::NAN; t.len()], vec![f64::NAN; t.len()]);
        signals::detached(py, |stop| {
            let columns = u.chunks_mut(BLOCK).zip(velocity.chunks_mut(BLOCK));
            for (t, (u, velocity)) in t.chunks(BLOCK).zip(columns) {
                self.form.motion_into(t, u, velocity);
                if stop(BLOCK) {
                    break;
                }
            }
        })?;
        Ok((u.into_pyarray(py), velocity.into_pyarray(py)))
    }

    /// The regimes that each form serves, by their names.
    #[staticmethod]
    fn table() -> Vec<(&'static str, Vec<&'static str>)> {
        let line = |(which, regimes): (Glaisher, Vec<_>)| {
            (which.name(), regimes.into_iter().map(libration::OscillatorRegime::name).collect())
        };
        Form::table().into_iter().map(line).collect()
    }
}

//! The pendulum with friction and torque as a Python object.

use std::sync::Arc;

use libration::damped::{LazyTrajectory, PARAMETERS};
use libration::{DampedPendulum as Core, Frequency, Friction, Interpolation, Torque, Trajectory};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::orbit::{float64, refused};

/// An array of results.
type Floats<'py> = Bound<'py, PyArray1<f64>>;

/// Friction and torque, as Python gives them.
type Terms = [f64; 4];
type Sampled<'py> = (PyReadonlyArray1<'py, f64>, PyReadonlyArray1<'py, f64>, String);

fn friction_of([linear, quadratic, dry, presliding]: Terms) -> PyResult<Friction> {
    Friction::new(linear, quadratic, dry, presliding).map_err(refused)
}

fn torque_of(
    [constant, amplitude, frequency, phase]: Terms,
    samples: Option<Sampled<'_>>,
) -> PyResult<Torque> {
    let torque = Torque::new(constant, amplitude, frequency, phase).map_err(refused)?;
    let Some((times, values, interpolation)) = samples else { return Ok(torque) };
    let kind = match interpolation.as_str() {
        "steps" => Interpolation::Steps,
        "lines" => Interpolation::Lines,
        "cubics" => Interpolation::Cubics,
        other => {
            let message = format!("interpolation = {other}: must be one of steps, lines, cubics");
            return Err(PyValueError::new_err(message));
        }
    };
    torque.with_samples(times.as_slice()?, values.as_slice()?, kind).map_err(refused)
}

/// Checks the coefficients of friction: linear, quadratic, dry, presliding.
#[pyfunction]
fn check_friction(terms: Terms) -> PyResult<()> {
    friction_of(terms).map(|_| ())
}

/// The torque at the times `t`.
#[pyfunction]
#[pyo3(signature = (terms, samples, t))]
fn torque_at<'py>(
    py: Python<'py>,
    terms: Terms,
    samples: Option<Sampled<'py>>,
    t: PyReadonlyArray1<'py, f64>,
) -> PyResult<Floats<'py>> {
    let torque = torque_of(terms, samples)?;
    let values: Vec<f64> = t.as_slice()?.iter().map(|t| torque.at(*t)).collect();
    Ok(values.into_pyarray(py))
}

/// A pendulum with friction and torque, integrated as far as it is asked for: what `libration.DampedPendulum` stands on.
#[pyclass(frozen, weakref, module = "libration._core")]
pub struct DampedPendulum {
    motion: LazyTrajectory,
}

#[pymethods]
impl DampedPendulum {
    #[new]
    #[pyo3(signature = (theta0, velocity0, friction, torque, samples=None, omega0=None, omega2=None, length=None, gravity=None))]
    #[allow(clippy::too_many_arguments, reason = "the arguments of the class in Python")]
    fn new(
        theta0: f64,
        velocity0: f64,
        friction: Terms,
        torque: Terms,
        samples: Option<Sampled<'_>>,
        omega0: Option<f64>,
        omega2: Option<f64>,
        length: Option<f64>,
        gravity: Option<f64>,
    ) -> PyResult<Self> {
        let frequency = Frequency::from_arguments(omega0, omega2, length, gravity).map_err(refused)?;
        let (friction, torque) = (friction_of(friction)?, torque_of(torque, samples)?);
        let pendulum = Core::new(theta0, velocity0, frequency, friction, torque).map_err(refused)?;
        Ok(Self { motion: LazyTrajectory::new(pendulum) })
    }

    /// Angle and angular velocity at the time `t`, both NumPy float64.
    fn state<'py>(&self, py: Python<'py>, t: f64) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
        let (theta, velocity) = self.along(py, &[t]).motion(t);
        Ok((float64(py, theta)?, float64(py, velocity)?))
    }

    /// Angle and angular velocity at the times `t`.
    fn motion<'py>(&self, py: Python<'py>, t: PyReadonlyArray1<'py, f64>) -> PyResult<[Floats<'py>; 2]> {
        let t = t.as_slice()?;
        let trajectory = self.along(py, t);
        let (mut theta, mut velocity) = (vec![f64::NAN; t.len()], vec![f64::NAN; t.len()]);
        py.detach(|| trajectory.motion_into(t, &mut theta, &mut velocity));
        Ok([theta.into_pyarray(py), velocity.into_pyarray(py)])
    }

    /// Whole turns and the angle in [-pi, pi) at the times `t`.
    fn turns<'py>(
        &self,
        py: Python<'py>,
        t: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<(Bound<'py, PyArray1<i64>>, Floats<'py>)> {
        let t = t.as_slice()?;
        let trajectory = self.along(py, t);
        let turns = || t.iter().map(|t| trajectory.turns(*t)).map(|turns| (turns.count, turns.angle)).unzip();
        let (counts, angles): (Vec<i64>, Vec<f64>) = py.detach(turns);
        Ok((counts.into_pyarray(py), angles.into_pyarray(py)))
    }

    /// Energy per unit inertia at the times `t`.
    fn energy<'py>(&self, py: Python<'py>, t: PyReadonlyArray1<'py, f64>) -> PyResult<Floats<'py>> {
        let t = t.as_slice()?;
        let trajectory = self.along(py, t);
        let energy: Vec<f64> = py.detach(|| t.iter().map(|t| trajectory.energy(*t)).collect());
        Ok(energy.into_pyarray(py))
    }

    /// The derivatives of the angle, then of the velocity, by each parameter, at the times `t`.
    fn sensitivities<'py>(
        &self,
        py: Python<'py>,
        t: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Vec<Floats<'py>>> {
        let t = t.as_slice()?;
        let columns = py.detach(|| {
            let mut columns = [const { Vec::new() }; 2 * PARAMETERS.len()];
            for column in &mut columns {
                column.resize(t.len(), f64::NAN);
            }
            let sensitivity = self.motion.sensitivity(t)?;
            sensitivity.at_into(t, columns.each_mut().map(Vec::as_mut_slice));
            Ok(columns)
        });
        Ok(columns.map_err(refused)?.into_iter().map(|column| column.into_pyarray(py)).collect())
    }

    /// Times from `start` to `stop` at which `theta` is passed.
    fn times<'py>(&self, py: Python<'py>, theta: f64, start: f64, stop: f64) -> PyResult<Floats<'py>> {
        let times = py.detach(|| self.motion.over(start, stop)?.times(theta, start, stop));
        Ok(times.map_err(refused)?.into_pyarray(py))
    }

    /// Times from `start` to `stop` at which the motion turns back.
    fn turning_times<'py>(&self, py: Python<'py>, start: f64, stop: f64) -> PyResult<Floats<'py>> {
        let times = py.detach(|| self.motion.over(start, stop)?.turning_times(start, stop));
        Ok(times.map_err(refused)?.into_pyarray(py))
    }

    /// Intervals from `start` to `stop` over which dry friction holds the pendulum.
    fn rests(&self, py: Python<'_>, start: f64, stop: f64) -> PyResult<Vec<(f64, f64)>> {
        let rests = py.detach(|| Ok(self.motion.over(start, stop)?.rests_within(start, stop)));
        rests.map_err(refused)
    }

    /// Times from `start` to `stop` of turns, and the logarithmic decrements to them from the turns a period before.
    fn decrements<'py>(&self, py: Python<'py>, start: f64, stop: f64) -> PyResult<[Floats<'py>; 2]> {
        let found = py.detach(|| self.motion.over(start, stop)?.decrements(start, stop)).map_err(refused)?;
        let (times, decrements): (Vec<f64>, Vec<f64>) = found.into_iter().unzip();
        Ok([times.into_pyarray(py), decrements.into_pyarray(py)])
    }

    /// Angular frequency of small swings, and its square with its sign.
    #[getter]
    fn frequency(&self) -> (f64, f64) {
        let frequency = self.motion.pendulum().frequency();
        (frequency.omega0(), frequency.omega2())
    }
}

impl DampedPendulum {
    /// The trajectory as far as these times.
    fn along(&self, py: Python<'_>, t: &[f64]) -> Arc<Trajectory> {
        py.detach(|| self.motion.reaching(t))
    }
}

/// Adds all of this file to the module.
pub fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<DampedPendulum>()?;
    module.add_function(wrap_pyfunction!(check_friction, module)?)?;
    module.add_function(wrap_pyfunction!(torque_at, module)?)
}

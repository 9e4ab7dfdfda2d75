//! The pendulum with friction and torque as a Python object.

use libration::damped::{
    LazyTrajectory, PARAMETERS, averaged_energy_loss, averaged_turning_angle, averaged_turning_rate,
};
use libration::{
    DampedPendulum as Core, Domain, Frequency, Friction, Interpolation, Torque, Trajectory, half_swing,
};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::orbit::{ROWS, float64, refused};
use crate::signals;

/// An array of results.
pub(crate) type Floats<'py> = Bound<'py, PyArray1<f64>>;

/// What a value of a law counts for between two questions about Ctrl-C.
const ROWS_OF_A_LAW: usize = 64;

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

/// What law `name` of `libration.damped` gives at each angle or, where it begins at `theta_max`, at each time.
#[pyfunction]
#[pyo3(signature = (name, values, friction, theta_max=0.0, omega0=None, omega2=None, length=None, gravity=None))]
#[allow(clippy::too_many_arguments, reason = "the arguments of the functions in Python")]
fn friction_law<'py>(
    py: Python<'py>,
    name: &str,
    values: PyReadonlyArray1<'py, f64>,
    friction: Terms,
    theta_max: f64,
    omega0: Option<f64>,
    omega2: Option<f64>,
    length: Option<f64>,
    gravity: Option<f64>,
) -> PyResult<Floats<'py>> {
    let frequency = Frequency::from_arguments(omega0, omega2, length, gravity).map_err(refused)?;
    let friction = friction_of(friction)?;
    let law: Box<dyn Fn(f64) -> f64 + Sync> = match name {
        "half_swing" => Box::new(|theta| half_swing(theta, frequency, friction)),
        "averaged_energy_loss" => Box::new(|angle| averaged_energy_loss(angle, frequency, friction)),
        "averaged_turning_rate" => Box::new(|angle| averaged_turning_rate(angle, frequency, friction)),
        "averaged_turning_angle" => Box::new(|t| averaged_turning_angle(theta_max, t, frequency, friction)),
        other => return Err(PyValueError::new_err(format!("law = {other}: is not known"))),
    };
    let values = values.as_slice()?;
    let found = signals::detached(py, |ended| {
        let mut found = Vec::with_capacity(values.len());
        for value in values {
            // A decay may take as long as many rows of a motion.
            if ended(ROWS_OF_A_LAW) {
                break;
            }
            found.push(law(*value));
        }
        found
    })?;
    Ok(found.into_pyarray(py))
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
        let (theta, velocity) = self.along(py, &[t], |trajectory, _| trajectory.motion(t))?;
        Ok((float64(py, theta)?, float64(py, velocity)?))
    }

    /// Angle and angular velocity at the times `t`.
    fn motion<'py>(&self, py: Python<'py>, t: PyReadonlyArray1<'py, f64>) -> PyResult<[Floats<'py>; 2]> {
        let t = t.as_slice()?;
        let (theta, velocity) = self.along(py, t, |trajectory, ended| {
            let (mut theta, mut velocity) = (vec![f64::NAN; t.len()], vec![f64::NAN; t.len()]);
            let blocks = t.chunks(ROWS).zip(theta.chunks_mut(ROWS).zip(velocity.chunks_mut(ROWS)));
            for (t, (theta, velocity)) in blocks {
                if ended(ROWS) {
                    break;
                }
                trajectory.motion_into(t, theta, velocity);
            }
            (theta, velocity)
        })?;
        Ok([theta.into_pyarray(py), velocity.into_pyarray(py)])
    }

    /// Whole turns and the angle in [-pi, pi) at the times `t`.
    fn turns<'py>(
        &self,
        py: Python<'py>,
        t: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<(Bound<'py, PyArray1<i64>>, Floats<'py>)> {
        let t = t.as_slice()?;
        let turns = self.along(py, t, |trajectory, ended| each(t, ended, |t| trajectory.turns(t)))?;
        let (counts, angles): (Vec<i64>, Vec<f64>) =
            turns.into_iter().map(|turns| (turns.count, turns.angle)).unzip();
        Ok((counts.into_pyarray(py), angles.into_pyarray(py)))
    }

    /// Energy per unit inertia at the times `t`.
    fn energy<'py>(&self, py: Python<'py>, t: PyReadonlyArray1<'py, f64>) -> PyResult<Floats<'py>> {
        let t = t.as_slice()?;
        let energy = self.along(py, t, |trajectory, ended| each(t, ended, |t| trajectory.energy(t)))?;
        Ok(energy.into_pyarray(py))
    }

    /// The derivatives of the angle, then of the velocity, by each parameter, at the times `t`.
    fn sensitivities<'py>(
        &self,
        py: Python<'py>,
        t: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Vec<Floats<'py>>> {
        let t = t.as_slice()?;
        let columns = signals::detached(py, |ended| {
            let mut columns = [const { Vec::new() }; 2 * PARAMETERS.len()];
            for column in &mut columns {
                column.resize(t.len(), f64::NAN);
            }
            let sensitivity = self.motion.sensitivity_unless(t, &|| ended(ROWS))?;
            let mut rest = columns.each_mut().map(Vec::as_mut_slice);
            for t in t.chunks(ROWS) {
                if ended(ROWS) {
                    break;
                }
                let parts = rest.map(|column| column.split_at_mut(t.len()));
                let mut block = Vec::with_capacity(parts.len());
                rest = parts.map(|(now, later)| {
                    block.push(now);
                    later
                });
                if let Ok(block) = block.try_into() {
                    sensitivity.at_into(t, block);
                }
            }
            Ok(columns)
        })?;
        Ok(columns.map_err(refused)?.into_iter().map(|column| column.into_pyarray(py)).collect())
    }

    /// Times from `start` to `stop` at which `theta` is passed.
    fn times<'py>(&self, py: Python<'py>, theta: f64, start: f64, stop: f64) -> PyResult<Floats<'py>> {
        let times = self.over(py, start, stop, |trajectory| trajectory.times(theta, start, stop))?;
        Ok(times.into_pyarray(py))
    }

    /// Times from `start` to `stop` at which the motion turns back.
    fn turning_times<'py>(&self, py: Python<'py>, start: f64, stop: f64) -> PyResult<Floats<'py>> {
        let times = self.over(py, start, stop, |trajectory| trajectory.turning_times(start, stop))?;
        Ok(times.into_pyarray(py))
    }

    /// Intervals from `start` to `stop` over which dry friction holds the pendulum.
    fn rests(&self, py: Python<'_>, start: f64, stop: f64) -> PyResult<Vec<(f64, f64)>> {
        self.over(py, start, stop, |trajectory| Ok(trajectory.rests_within(start, stop)))
    }

    /// Times from `start` to `stop` of turns, and the logarithmic decrements to them from the turns a period before.
    fn decrements<'py>(&self, py: Python<'py>, start: f64, stop: f64) -> PyResult<[Floats<'py>; 2]> {
        let found = self.over(py, start, stop, |trajectory| trajectory.decrements(start, stop))?;
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
    /// What `work` makes of the trajectory as far as these times.
    fn along<T: Send>(
        &self,
        py: Python<'_>,
        t: &[f64],
        work: impl Fn(&Trajectory, signals::Stop<'_>) -> T + Sync,
    ) -> PyResult<T> {
        signals::detached(py, |ended| {
            let trajectory = self.motion.reaching_unless(t, &|| ended(ROWS));
            work(&trajectory, ended)
        })
    }

    /// What `work` makes of a trajectory that holds an interval.
    fn over<T: Send>(
        &self,
        py: Python<'_>,
        start: f64,
        stop: f64,
        work: impl Fn(&Trajectory) -> Result<T, Domain> + Sync,
    ) -> PyResult<T> {
        let found = signals::detached(py, |ended| {
            let trajectory = self.motion.over_unless(start, stop, &|| ended(ROWS))?;
            work(&trajectory)
        })?;
        found.map_err(refused)
    }
}

/// One value for each time.
fn each<T>(t: &[f64], ended: signals::Stop<'_>, value: impl Fn(f64) -> T) -> Vec<T> {
    let mut values = Vec::with_capacity(t.len());
    for t in t.chunks(ROWS) {
        if ended(ROWS) {
            break;
        }
        values.extend(t.iter().map(|t| value(*t)));
    }
    values
}

/// Adds all of this file to the module.
pub fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<DampedPendulum>()?;
    module.add_function(wrap_pyfunction!(check_friction, module)?)?;
    module.add_function(wrap_pyfunction!(friction_law, module)?)?;
    module.add_function(wrap_pyfunction!(torque_at, module)?)
}

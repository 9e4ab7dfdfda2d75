//! One orbit as a Python object: built strictly, answering one instant per call without NumPy's machinery.

use libration::{Domain, Extremes, Fourier, Frequency, OrbitStart, Turns};
use numpy::{IntoPyArray, PyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyFloat, PyType};

use crate::signals;

/// A question of a search for times counts as so many rows of a ufunc: it asks after some thousand times.
pub(crate) const ROWS: usize = 512;

/// One orbit, set up once: what `libration.Pendulum` stands on.
///
/// `omega0`, `omega2` and `length` exclude each other; none of them means `omega0 = 1`. `gravity` needs `length`.
#[pyclass(frozen, weakref, module = "libration._core")]
pub struct Orbit {
    pub(crate) orbit: libration::Orbit,
    start: OrbitStart,
    frequency: Frequency,
}

#[pymethods]
impl Orbit {
    #[new]
    #[pyo3(signature = (theta0, velocity0, omega0=None, omega2=None, length=None, gravity=None))]
    fn new(
        theta0: f64,
        velocity0: f64,
        omega0: Option<f64>,
        omega2: Option<f64>,
        length: Option<f64>,
        gravity: Option<f64>,
    ) -> PyResult<Self> {
        let frequency = Frequency::from_arguments(omega0, omega2, length, gravity).map_err(refused)?;
        let orbit = libration::Orbit::new(theta0, velocity0, frequency).map_err(refused)?;
        Ok(Self { orbit, start: OrbitStart::of_state(theta0, velocity0), frequency })
    }

    /// The orbit of a start by its four operands: the angle, what is known of the motion, its direction, and what they are.
    #[staticmethod]
    #[pyo3(signature = (angle, value, direction, kind, omega0=None, omega2=None, length=None, gravity=None))]
    #[allow(clippy::too_many_arguments)] // a start and a frequency, as Python gives them
    fn from_start(
        angle: f64,
        value: f64,
        direction: f64,
        kind: f64,
        omega0: Option<f64>,
        omega2: Option<f64>,
        length: Option<f64>,
        gravity: Option<f64>,
    ) -> PyResult<Self> {
        let frequency = Frequency::from_arguments(omega0, omega2, length, gravity).map_err(refused)?;
        let start = OrbitStart::from_operands([angle, value, direction, kind])
            .ok_or_else(|| PyValueError::new_err("no start has this kind"))?;
        let orbit = libration::Orbit::from_start(start, frequency).map_err(refused)?;
        Ok(Self { orbit, start, frequency })
    }

    /// Angle at the time `t`, a NumPy float64.
    fn theta<'py>(&self, py: Python<'py>, t: f64) -> PyResult<Bound<'py, PyAny>> {
        float64(py, self.orbit.theta(t))
    }

    /// Angular velocity at the time `t`, a NumPy float64.
    fn velocity<'py>(&self, py: Python<'py>, t: f64) -> PyResult<Bound<'py, PyAny>> {
        float64(py, self.orbit.velocity(t))
    }

    /// Angle and angular velocity at the time `t`.
    fn motion<'py>(&self, py: Python<'py>, t: f64) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
        let (theta, velocity) = self.orbit.motion(t);
        Ok((float64(py, theta)?, float64(py, velocity)?))
    }

    /// Whole turns, a NumPy int64, and the angle in [-pi, pi) at the time `t`.
    fn turns<'py>(&self, py: Python<'py>, t: f64) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
        let Turns { count, angle } = self.orbit.turns(t);
        Ok((int64(py, count)?, float64(py, angle)?))
    }

    /// Phase at the time `t`, a NumPy float64.
    fn phase<'py>(&self, py: Python<'py>, t: f64) -> PyResult<Bound<'py, PyAny>> {
        float64(py, self.orbit.phase(t))
    }

    /// Times from `start` to `stop` at which `theta` is passed, in any turn or in its own.
    fn times<'py>(
        &self,
        py: Python<'py>,
        theta: f64,
        start: f64,
        stop: f64,
        every_turn: bool,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let times = signals::detached(py, |ended| {
            let ended = || ended(ROWS);
            if every_turn {
                self.orbit.times_of_every_turn_unless(theta, start, stop, &ended)
            } else {
                self.orbit.times_unless(theta, start, stop, &ended)
            }
        })?;
        Ok(times.map_err(refused)?.into_pyarray(py))
    }

    /// Times from `start` to `stop` at which the motion turns back.
    fn turning_times<'py>(
        &self,
        py: Python<'py>,
        start: f64,
        stop: f64,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let times =
            signals::detached(py, |ended| self.orbit.turning_times_unless(start, stop, &|| ended(ROWS)))?;
        Ok(times.map_err(refused)?.into_pyarray(py))
    }

    /// The first `n` amplitudes of angle and velocity.
    fn fourier<'py>(&self, py: Python<'py>, n: i64) -> PyResult<[Bound<'py, PyArray1<f64>>; 2]> {
        let Fourier { theta, velocity, .. } = py.detach(|| self.orbit.fourier(n)).map_err(refused)?;
        Ok([theta.into_pyarray(py), velocity.into_pyarray(py)])
    }

    /// Angle and velocity with an action and a phase.
    #[staticmethod]
    #[pyo3(signature = (action, phase, direction, omega0=None, omega2=None, length=None, gravity=None))]
    fn state_of(
        action: f64,
        phase: f64,
        direction: f64,
        omega0: Option<f64>,
        omega2: Option<f64>,
        length: Option<f64>,
        gravity: Option<f64>,
    ) -> PyResult<(f64, f64)> {
        let frequency = Frequency::from_arguments(omega0, omega2, length, gravity).map_err(refused)?;
        libration::pendulum::action::state_of(action, phase, direction, frequency).map_err(refused)
    }

    /// Lowest and highest angle.
    #[getter]
    fn extremes(&self) -> (f64, f64) {
        let Extremes { lowest, highest } = self.orbit.extremes();
        (lowest, highest)
    }

    /// Action.
    #[getter]
    fn action(&self) -> f64 {
        self.orbit.action()
    }

    /// Mean angular frequency, with its sign.
    #[getter]
    fn frequency(&self) -> f64 {
        self.orbit.frequency()
    }

    /// Harmonic distortion of the angle.
    #[getter]
    fn distortion(&self) -> f64 {
        self.orbit.distortion()
    }

    /// The seven operands by which a ufunc knows this orbit: those of its start and the factors a, b, c.
    #[getter]
    fn operands(&self) -> (f64, f64, f64, f64, f64, f64, f64) {
        let ([angle, value, direction, kind], (a, b, c)) = (self.start.operands(), self.frequency.factors());
        (angle, value, direction, kind, a, b, c)
    }

    /// Initial angle.
    #[getter]
    fn theta0(&self) -> f64 {
        self.orbit.theta0()
    }

    /// Initial angular velocity.
    #[getter]
    fn velocity0(&self) -> f64 {
        self.orbit.velocity0()
    }

    /// `rest`, `libration`, `separatrix` or `rotation`.
    #[getter]
    fn regime(&self) -> &'static str {
        self.orbit.regime().name()
    }

    /// Period; of one turn in rotation, infinite on the separatrix.
    #[getter]
    fn period(&self) -> f64 {
        self.orbit.period()
    }

    /// Turning angle; NaN in rotation.
    #[getter]
    fn theta_max(&self) -> f64 {
        self.orbit.theta_max()
    }

    /// Energy ratio.
    #[getter]
    fn energy_ratio(&self) -> f64 {
        self.orbit.energy_ratio()
    }

    /// Complement of the energy ratio.
    #[getter]
    fn energy_ratio_c(&self) -> f64 {
        self.orbit.energy_ratio_c()
    }

    /// Energy per unit inertia, zero at the bottom.
    #[getter]
    fn energy(&self) -> f64 {
        self.orbit.energy()
    }

    /// Angular frequency of small swings.
    #[getter]
    fn omega0(&self) -> f64 {
        self.orbit.omega0()
    }

    /// Its square, with its sign.
    #[getter]
    fn omega2(&self) -> f64 {
        self.orbit.omega2()
    }
}

/// A refused argument as Python's `ValueError`, in the words of the core.
pub(crate) fn refused(domain: Domain) -> PyErr {
    PyValueError::new_err(domain.to_string())
}

/// A NumPy float64.
pub(crate) fn float64(py: Python<'_>, value: f64) -> PyResult<Bound<'_, PyAny>> {
    static FLOAT64: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    FLOAT64.import(py, "numpy", "float64")?.call1((PyFloat::new(py, value),))
}

/// A NumPy int64.
fn int64(py: Python<'_>, value: i64) -> PyResult<Bound<'_, PyAny>> {
    static INT64: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    INT64.import(py, "numpy", "int64")?.call1((value,))
}

//! The nonlinear springs as Python objects, and their ufuncs.

use libration::oscillator::{
    Companion, CubicQuintic as Quintic, Duffing as Cubic, DuffingForm as Form, duffing_motion_into,
};
use libration::{Frequency, Glaisher};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::orbit::{ROWS, float64, refused};
use crate::signals;
use crate::ufunc::{BLOCK, add, nothing, whole};

/// The class of one oscillator: its arguments, and the core's type that answers.
macro_rules! oscillator {
    ($name:ident, $core:ident, $document:literal, $($coefficient:ident),+) => {
        #[doc = $document]
        #[pyclass(frozen, weakref, module = "libration._core")]
        pub struct $name {
            oscillator: $core,
            u0: f64,
            velocity0: f64,
            $($coefficient: f64,)+
        }

        #[pymethods]
        impl $name {
            #[new]
            fn new(u0: f64, velocity0: f64, $($coefficient: f64),+) -> PyResult<Self> {
                let oscillator = $core::new(u0, velocity0, $($coefficient),+).map_err(refused)?;
                Ok(Self { oscillator, u0, velocity0, $($coefficient),+ })
            }

            /// Displacement at the time `t`, a NumPy float64.
            fn u<'py>(&self, py: Python<'py>, t: f64) -> PyResult<Bound<'py, PyAny>> {
                float64(py, self.oscillator.u(t))
            }

            /// Velocity at the time `t`, a NumPy float64.
            fn velocity<'py>(&self, py: Python<'py>, t: f64) -> PyResult<Bound<'py, PyAny>> {
                float64(py, self.oscillator.velocity(t))
            }

            /// Displacement and velocity at the time `t`.
            fn motion<'py>(&self, py: Python<'py>, t: f64) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
                let (u, velocity) = self.oscillator.motion(t);
                Ok((float64(py, u)?, float64(py, velocity)?))
            }

            /// Times from `start` to `stop` at which `u` is passed.
            fn times<'py>(
                &self,
                py: Python<'py>,
                u: f64,
                start: f64,
                stop: f64,
            ) -> PyResult<Bound<'py, PyArray1<f64>>> {
                let times = signals::detached(py, |ended| {
                    self.oscillator.times_unless(u, start, stop, &|| ended(ROWS))
                })?;
                Ok(times.map_err(refused)?.into_pyarray(py))
            }

            /// What a ufunc knows this oscillator by.
            #[getter]
            fn operands(&self) -> [f64; 2 + [$(stringify!($coefficient)),+].len()] {
                [self.u0, self.velocity0, $(self.$coefficient),+]
            }

            /// Initial displacement.
            #[getter]
            fn u0(&self) -> f64 {
                self.u0
            }

            /// Initial velocity.
            #[getter]
            fn velocity0(&self) -> f64 {
                self.velocity0
            }

            /// One of the seven regimes by its name.
            #[getter]
            fn regime(&self) -> &'static str {
                self.oscillator.regime().name()
            }

            /// Period.
            #[getter]
            fn period(&self) -> f64 {
                self.oscillator.period()
            }

            /// Lowest and highest displacement.
            #[getter]
            fn range(&self) -> (f64, f64) {
                self.oscillator.range()
            }

            /// Energy per unit mass.
            #[getter]
            fn energy(&self) -> f64 {
                self.oscillator.energy()
            }

            /// Time of the escape ahead.
            #[getter]
            fn escape_time(&self) -> f64 {
                self.oscillator.escape_time()
            }

            /// Time of the escape behind.
            #[getter]
            fn escape_time_backward(&self) -> f64 {
                self.oscillator.escape_time_backward()
            }
        }
    };
}

oscillator!(Duffing, Cubic, "u'' + p u + q u^3 = 0: what `libration.Duffing` stands on.", p, q);
oscillator!(
    CubicQuintic,
    Quintic,
    "u'' + alpha u + beta u^3 + gamma u^5 = 0: what `libration.CubicQuintic` stands on.",
    alpha,
    beta,
    gamma
);

/// u0, velocity0, p and q of u = tan(theta/2) for a pendulum.
#[pyfunction]
#[pyo3(signature = (theta0, velocity0, omega0=None, omega2=None, length=None, gravity=None))]
fn duffing_of_pendulum(
    theta0: f64,
    velocity0: f64,
    omega0: Option<f64>,
    omega2: Option<f64>,
    length: Option<f64>,
    gravity: Option<f64>,
) -> PyResult<(f64, f64, f64, f64)> {
    let frequency = Frequency::from_arguments(omega0, omega2, length, gravity).map_err(refused)?;
    let made = Cubic::of_pendulum(theta0, velocity0, frequency).map_err(refused)?;
    Ok((made.u0(), made.velocity0(), made.p(), made.q()))
}

/// scale, theta0, velocity0 and omega2 of the pendulum that moves like an oscillator, if there is one.
#[pyfunction]
fn pendulum_of_duffing(duffing: &Duffing) -> Option<(f64, f64, f64, f64)> {
    let Companion { scale, theta0, velocity0, omega2 } = duffing.oscillator.companion()?;
    Some((scale, theta0, velocity0, omega2))
}

/// One of the twelve forms by its two letters.
fn glaisher(name: &str) -> PyResult<Glaisher> {
    let found = Glaisher::ALL.into_iter().find(|which| which.name() == name);
    found.ok_or_else(|| {
        let names: Vec<&str> = Glaisher::ALL.iter().map(|which| which.name()).collect();
        PyValueError::new_err(format!("form = {name}: must be one of {}", names.join(", ")))
    })
}

/// An array of results.
type Samples<'py> = Bound<'py, PyArray1<f64>>;

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

/// Adds the ufuncs of one oscillator under its name.
macro_rules! kernels {
    ($module:expr, $name:literal, $core:ident, $set_up:expr) => {{
        add(
            $module,
            concat!($name, "_u"),
            $set_up,
            whole::<[f64; 1], _>(|made: &$core, [t]: [&[f64]; 1], _: usize, [u]: [&mut [f64]; 1]| {
                made.u_into(t, u);
            }),
        )?;
        add(
            $module,
            concat!($name, "_velocity"),
            $set_up,
            whole::<[f64; 1], _>(|made: &$core, [t]: [&[f64]; 1], _: usize, [velocity]: [&mut [f64]; 1]| {
                made.velocity_into(t, velocity);
            }),
        )?;
        add(
            $module,
            concat!($name, "_motion"),
            $set_up,
            whole::<[f64; 2], _>(
                |made: &$core, [t]: [&[f64]; 1], _: usize, [u, velocity]: [&mut [f64]; 2]| {
                    made.motion_into(t, u, velocity);
                },
            ),
        )
    }};
}

/// Rows of t, u0, velocity0, p and q, each a motion of its own.
fn duffing_rows((): &(), rows: [&[f64]; 5], _: usize, columns: [&mut [f64]; 2]) {
    duffing_motion_into(rows, columns);
}

/// Adds the classes and the ufuncs.
pub fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Duffing>()?;
    module.add_class::<CubicQuintic>()?;
    module.add_class::<DuffingForm>()?;
    module.add_function(wrap_pyfunction!(duffing_of_pendulum, module)?)?;
    module.add_function(wrap_pyfunction!(pendulum_of_duffing, module)?)?;
    add(module, "duffing_rows", nothing, whole::<[f64; 2], _>(duffing_rows))?;
    kernels!(module, "duffing", Cubic, |[u0, velocity0, p, q]: [f64; 4]| Cubic::new(u0, velocity0, p, q)
        .ok())?;
    kernels!(module, "cubic_quintic", Quintic, |[u0, velocity0, alpha, beta, gamma]: [f64; 5]| {
        Quintic::new(u0, velocity0, alpha, beta, gamma).ok()
    })
}

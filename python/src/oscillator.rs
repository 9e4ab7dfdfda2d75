//! The nonlinear springs as Python objects, and their ufuncs.

use libration::oscillator::{
    Companion, CubicQuintic as Quintic, Duffing as Cubic, cubic_quintic_rows_into, duffing_rows_into,
};
use libration::{Domain, Frequency};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;

use crate::duffing_form::{DuffingForm, Samples};
use crate::orbit::{ROWS, float64, refused};
use crate::signals;
use crate::ufunc::{add, each, nothing, whole};

/// The class of one oscillator: its arguments, and the core's type that answers.
macro_rules! oscillator {
    ($name:ident, $core:ident, $set_up:expr, $document:literal, $($coefficient:ident),+) => {
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
                let oscillator = $set_up([u0, velocity0, $($coefficient),+]).map_err(refused)?;
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

            /// Action, (1/2 pi) closed integral of the velocity over u.
            #[getter]
            fn action(&self) -> f64 {
                self.oscillator.action()
            }

            /// Mean angular frequency.
            #[getter]
            fn frequency(&self) -> f64 {
                self.oscillator.frequency()
            }

            /// Harmonic distortion.
            #[getter]
            fn distortion(&self) -> f64 {
                self.oscillator.distortion()
            }

            /// Mean, and the first `n` amplitudes of displacement and velocity.
            fn fourier<'py>(&self, py: Python<'py>, n: i64) -> PyResult<(f64, Samples<'py>, Samples<'py>)> {
                let series = self.oscillator.fourier(n).map_err(refused)?;
                Ok((series.mean, series.u.into_pyarray(py), series.velocity.into_pyarray(py)))
            }
        }
    };
}

/// A Duffing oscillator of its six numbers.
fn duffing([u0, velocity0, force @ ..]: [f64; 6]) -> Result<Cubic, Domain> {
    Cubic::with_even_powers(u0, velocity0, force)
}

/// A cubic-quintic oscillator of its five numbers.
fn quintic([u0, velocity0, p, q, s]: [f64; 5]) -> Result<Quintic, Domain> {
    Quintic::new(u0, velocity0, p, q, s)
}

oscillator!(
    Duffing,
    Cubic,
    duffing,
    "u'' + p u + r u^2 + q u^3 = c: what `libration.Duffing` stands on.",
    p,
    q,
    r,
    c
);
oscillator!(
    CubicQuintic,
    Quintic,
    quintic,
    "u'' + p u + q u^3 + s u^5 = 0: what `libration.CubicQuintic` stands on.",
    p,
    q,
    s
);

/// The start of a Duffing oscillator by its energy: u0 and velocity0.
#[pyfunction]
fn duffing_from_energy(energy: f64, u0: f64, direction: f64, force: [f64; 4]) -> PyResult<(f64, f64)> {
    let made = Cubic::from_energy(energy, u0, direction, force).map_err(refused)?;
    Ok((made.u0(), made.velocity0()))
}

/// The start of a Duffing oscillator by its action and phase: u0 and velocity0.
#[pyfunction]
fn duffing_from_action_phase(
    action: f64,
    phase: f64,
    about: Option<f64>,
    force: [f64; 4],
) -> PyResult<(f64, f64)> {
    let made = Cubic::from_action_phase(action, phase, about, force).map_err(refused)?;
    Ok((made.u0(), made.velocity0()))
}

/// The start of a cubic-quintic oscillator by its energy: u0 and velocity0.
#[pyfunction]
fn cubic_quintic_from_energy(energy: f64, u0: f64, direction: f64, force: [f64; 3]) -> PyResult<(f64, f64)> {
    let made = Quintic::from_energy(energy, u0, direction, force).map_err(refused)?;
    Ok((made.u0(), made.velocity0()))
}

/// The start of a cubic-quintic oscillator by its action and phase: u0 and velocity0.
#[pyfunction]
fn cubic_quintic_from_action_phase(
    action: f64,
    phase: f64,
    about: Option<f64>,
    force: [f64; 3],
) -> PyResult<(f64, f64)> {
    let made = Quintic::from_action_phase(action, phase, about, force).map_err(refused)?;
    Ok((made.u0(), made.velocity0()))
}

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
        )?;
        add($module, concat!($name, "_phase"), $set_up, each(|made: &$core, [t]: [f64; 1]| [made.phase(t)]))?;
        add($module, concat!($name, "_period"), $set_up, each(|made: &$core, []: [f64; 0]| [made.period()]))?;
        add(
            $module,
            concat!($name, "_frequency"),
            $set_up,
            each(|made: &$core, []: [f64; 0]| [made.frequency()]),
        )?;
        add($module, concat!($name, "_action"), $set_up, each(|made: &$core, []: [f64; 0]| [made.action()]))?;
        add(
            $module,
            concat!($name, "_regime"),
            $set_up,
            each(|made: &$core, []: [f64; 0]| [f64::from(made.regime() as u8)]),
        )?;
        add(
            $module,
            concat!($name, "_escape_times"),
            $set_up,
            each(|made: &$core, []: [f64; 0]| [made.escape_time_backward(), made.escape_time()]),
        )
    }};
}

/// Rows of t, u0, velocity0, p, q, r and c, each a motion of its own.
fn duffing_rows((): &(), rows: [&[f64]; 7], _: usize, columns: [&mut [f64]; 2]) {
    duffing_rows_into(rows, columns);
}

/// Rows of t, u0, velocity0, p, q and s, each a motion of its own.
fn cubic_quintic_rows((): &(), rows: [&[f64]; 6], _: usize, columns: [&mut [f64]; 2]) {
    cubic_quintic_rows_into(rows, columns);
}

/// Rows of t of one Duffing oscillator: the derivatives of u and of the velocity by u0, velocity0, p, q, r and c.
fn sensitivities(made: &Cubic, [t]: [&[f64]; 1], _: usize, mut columns: [&mut [f64]; 12]) {
    made.derivatives_into(t, &mut |row, derivatives| {
        for (column, value) in columns.iter_mut().zip(derivatives.as_flattened()) {
            column[row] = *value;
        }
    });
}

/// Rows of t of one cubic-quintic oscillator: the derivatives by u0, velocity0, p, q and s.
fn quintic_sensitivities(made: &Quintic, [t]: [&[f64]; 1], _: usize, mut columns: [&mut [f64]; 10]) {
    made.derivatives_into(t, &mut |row, derivatives| {
        for (column, value) in columns.iter_mut().zip(derivatives.as_flattened()) {
            column[row] = *value;
        }
    });
}

/// Adds the classes and the ufuncs.
pub fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Duffing>()?;
    module.add_class::<CubicQuintic>()?;
    module.add_class::<DuffingForm>()?;
    module.add_function(wrap_pyfunction!(duffing_of_pendulum, module)?)?;
    module.add_function(wrap_pyfunction!(pendulum_of_duffing, module)?)?;
    add(module, "duffing_rows", nothing, whole::<[f64; 2], _>(duffing_rows))?;
    add(module, "cubic_quintic_rows", nothing, whole::<[f64; 2], _>(cubic_quintic_rows))?;
    module.add_function(wrap_pyfunction!(duffing_from_energy, module)?)?;
    module.add_function(wrap_pyfunction!(duffing_from_action_phase, module)?)?;
    module.add_function(wrap_pyfunction!(cubic_quintic_from_energy, module)?)?;
    module.add_function(wrap_pyfunction!(cubic_quintic_from_action_phase, module)?)?;
    let set_up = |given: [f64; 6]| duffing(given).ok();
    add(module, "duffing_sensitivities", set_up, whole::<[f64; 12], _>(sensitivities))?;
    kernels!(module, "duffing", Cubic, set_up)?;
    let set_up = |given: [f64; 5]| quintic(given).ok();
    add(module, "cubic_quintic_sensitivities", set_up, whole::<[f64; 10], _>(quintic_sensitivities))?;
    kernels!(module, "cubic_quintic", Quintic, set_up)
}

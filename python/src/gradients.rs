//! The functions of the pendulum that `libration.jax` asks the core for: rows with states of their own, as in kernels.rs.

use libration::pendulum;
use pyo3::prelude::*;

use crate::ufunc::xla::{Columns, add};

/// Adds the handlers.
pub fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    add::<Motion, 4, 2>(module, "xla_motion")?;
    add::<Advance, 4, 2>(module, "xla_advance")?;
    add::<Sensitivities, 4, 6>(module, "xla_sensitivities")?;
    add::<Period, 3, 1>(module, "xla_period")
}

struct Motion;

impl Columns<4, 2> for Motion {
    fn fill(rows: [&[f64]; 4], found: [&mut [f64]; 2]) {
        pendulum::motion_into(rows, found);
    }
}

struct Advance;

impl Columns<4, 2> for Advance {
    fn fill(states: [&[f64]; 4], found: [&mut [f64]; 2]) {
        pendulum::advance_into(states, found);
    }
}

struct Sensitivities;

impl Columns<4, 6> for Sensitivities {
    fn fill(rows: [&[f64]; 4], found: [&mut [f64]; 6]) {
        pendulum::sensitivities_into(rows, found);
    }
}

struct Period;

impl Columns<3, 1> for Period {
    fn fill(states: [&[f64]; 3], [period]: [&mut [f64]; 1]) {
        pendulum::period_into(states, period);
    }
}

//! Columns of many particles: random numbers, whole turns, steps one after the other, moments and histograms.

use libration::ensemble::{self, Bins, Moments, Steps};
use numpy::{PyReadonlyArray1, PyReadwriteArray1};
use pyo3::prelude::*;

use crate::pool;

/// Adds what is in this file.
pub fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(uniforms, module)?)?;
    module.add_function(wrap_pyfunction!(exponential, module)?)?;
    module.add_function(wrap_pyfunction!(wrap, module)?)?;
    module.add_function(wrap_pyfunction!(steps, module)?)?;
    module.add_function(wrap_pyfunction!(moments, module)?)?;
    module.add_function(wrap_pyfunction!(histogram, module)?)
}

/// Particles of a piece of work that a thread takes; fewer where a piece would be all there is.
const ROWS: usize = 2048;
/// Steps of particles below which a second thread costs more than it gains.
const WORTHWHILE: usize = 32_768;

/// Fills both columns with the uniform numbers of the particles from `first` on.
#[pyfunction]
fn uniforms(
    py: Python<'_>,
    seed: u64,
    first: u64,
    mut u: PyReadwriteArray1<'_, f64>,
    mut v: PyReadwriteArray1<'_, f64>,
) -> PyResult<()> {
    let columns = [u.as_slice_mut()?, v.as_slice_mut()?];
    py.detach(|| ensemble::uniforms_into(seed, first, columns));
    Ok(())
}

/// Fills a column with numbers of an exponential density from uniform ones.
#[pyfunction]
fn exponential(
    py: Python<'_>,
    u: PyReadonlyArray1<'_, f64>,
    lost: f64,
    mut x: PyReadwriteArray1<'_, f64>,
) -> PyResult<()> {
    let (u, x) = (u.as_slice()?, x.as_slice_mut()?);
    py.detach(|| ensemble::exponential_into(u, lost, x));
    Ok(())
}

/// Takes whole turns from angles and adds them to the turns.
#[pyfunction]
fn wrap(
    py: Python<'_>,
    mut theta: PyReadwriteArray1<'_, f64>,
    mut turns: PyReadwriteArray1<'_, i64>,
) -> PyResult<()> {
    let (theta, turns) = (theta.as_slice_mut()?, turns.as_slice_mut()?);
    py.detach(|| ensemble::wrap_into(theta, turns));
    Ok(())
}

/// Moves states by all steps in place, shared out to the threads.
#[pyfunction]
fn steps(
    py: Python<'_>,
    mut theta: PyReadwriteArray1<'_, f64>,
    mut velocity: PyReadwriteArray1<'_, f64>,
    mut turns: PyReadwriteArray1<'_, i64>,
    dt: PyReadonlyArray1<'_, f64>,
    omega0: PyReadonlyArray1<'_, f64>,
    phase: PyReadonlyArray1<'_, f64>,
) -> PyResult<()> {
    let (theta, velocity, turns) = (theta.as_slice_mut()?, velocity.as_slice_mut()?, turns.as_slice_mut()?);
    let steps = Steps { dt: dt.as_slice()?, omega0: omega0.as_slice()?, phase: phase.as_slice()? };
    let much = theta.len().saturating_mul(steps.dt.len()) >= WORTHWHILE;
    let rows = if much { pool::part(theta.len()).min(ROWS) } else { theta.len().max(1) };
    let pieces = theta.chunks_mut(rows).zip(velocity.chunks_mut(rows)).zip(turns.chunks_mut(rows));
    let pieces = pieces.collect();
    py.detach(|| {
        pool::each_of(pieces, |((theta, velocity), turns), stop| {
            ensemble::steps_into(theta, velocity, turns, steps, stop);
        })
    })
}

/// Two means and three sums of products, or None where a number is not finite.
#[pyfunction]
fn moments(
    py: Python<'_>,
    theta: PyReadonlyArray1<'_, f64>,
    velocity: PyReadonlyArray1<'_, f64>,
) -> PyResult<Option<([f64; 2], [f64; 3])>> {
    let (theta, velocity) = (theta.as_slice()?, velocity.as_slice()?);
    let found = py.detach(|| ensemble::moments(theta, velocity));
    Ok(found.map(|Moments { mean, products }| (mean, products)))
}

/// Counts rows by their bins, given as lower end, upper end and number.
#[pyfunction]
fn histogram(
    py: Python<'_>,
    columns: Vec<PyReadonlyArray1<'_, f64>>,
    bins: Vec<(f64, f64, usize)>,
    mut counts: PyReadwriteArray1<'_, i64>,
) -> PyResult<()> {
    let columns: Vec<&[f64]> = columns.iter().map(|column| column.as_slice()).collect::<Result<_, _>>()?;
    let bins: Vec<Bins> = bins.into_iter().map(|(low, high, count)| Bins { low, high, count }).collect();
    let counts = counts.as_slice_mut()?;
    py.detach(|| ensemble::histogram_into(&columns, &bins, counts));
    Ok(())
}

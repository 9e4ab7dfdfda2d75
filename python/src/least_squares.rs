//! Fits of one record and of several together, each on a thread of its own, while the thread that was called asks for signals and tells
//! how far it is; and g from a reversible pendulum.

use std::cell::RefCell;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread;

use libration::Shape;
use libration_fit::fit::{
    self, Corrections, Data, Fit, FitOptions, FitRefusal, Grade, MeasuredPart, Model, Verdict, fit_lengths,
    fit_runs, length_of_parts,
};
use numpy::{IntoPyArray, PyReadonlyArray1};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;

use crate::damped::Floats;
use crate::fit::{MEASURED, Pair, measure, refused};
use crate::signals::{self, INTERVAL};
use crate::ufunc::interpreter::with_interpreter;

/// Result in JSON without its residuals; grades of the verdicts; times, values and residuals.
type Fitted<'py> = (String, Vec<&'static str>, [Floats<'py>; 3]);

/// A kind of data and its columns.
type Columns<'py> = (String, Vec<PyReadonlyArray1<'py, f64>>);

/// Shape, and mass, distance of the centre and size, as Python gives them.
type PartGiven = (String, Pair, Pair, Pair);

const SHAPES: [(&str, Shape); 4] =
    [("rod", Shape::Rod), ("ball", Shape::Ball), ("disc", Shape::Disc), ("point", Shape::Point)];

fn parts_of(given: Vec<PartGiven>) -> PyResult<Vec<MeasuredPart>> {
    let part = |(shape, mass, distance, size): PartGiven| {
        let found = SHAPES.iter().find(|(name, _)| *name == shape);
        let (_, shape) = found.ok_or_else(|| {
            PyValueError::new_err(format!("part = {shape}: must be one of rod, ball, disc, point"))
        })?;
        Ok(MeasuredPart {
            shape: *shape,
            mass: measure(mass),
            distance: measure(distance),
            size: measure(size),
        })
    };
    given.into_iter().map(part).collect()
}

/// The equivalent length of a rigid pendulum and its standard uncertainty.
#[pyfunction]
fn equivalent_length(parts: Vec<PartGiven>) -> PyResult<Pair> {
    let found = length_of_parts(&parts_of(parts)?).map_err(refused)?;
    Ok((found.value, found.u))
}

/// What is known beside the records, as a dictionary.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct Known {
    length: Option<Pair>,
    gravity: Option<Pair>,
    parts: Vec<PartGiven>,
    /// Radius in m and mass in kg of the bob, mass of the wire in kg.
    bob: (Option<f64>, Option<f64>, Option<f64>),
    /// Density in kg/m^3 and kinematic viscosity in m^2/s.
    fluid: Pair,
    /// Names of corrections that are not made.
    without: Vec<String>,
    model: Option<String>,
    window: Option<Pair>,
    scale_u: f64,
    clock_u: f64,
    free_scale: bool,
    bootstrap: usize,
    monte_carlo: usize,
    seed: u64,
}

impl Known {
    fn options(self) -> PyResult<FitOptions> {
        let made = |name: &str| !self.without.iter().any(|without| without == name);
        let named = |name: String| Model::LADDER.into_iter().find(|model| model.name() == name);
        Ok(FitOptions {
            length: self.length.map(measure),
            gravity: self.gravity.map(measure),
            corrections: Corrections {
                radius: self.bob.0,
                mass: self.bob.1,
                wire: self.bob.2,
                density: self.fluid.0,
                viscosity: self.fluid.1,
                bob_size: made("bob size"),
                wire_mass: made("wire mass"),
                buoyancy: made("buoyancy"),
                added_mass: made("added mass"),
            },
            parts: parts_of(self.parts)?,
            model: self.model.and_then(named),
            window: self.window,
            scale_u: self.scale_u,
            clock_u: self.clock_u,
            free_scale: self.free_scale,
            bootstrap: self.bootstrap,
            monte_carlo: self.monte_carlo,
            seed: self.seed,
            stop: Some(given_up),
            told: Some(tell),
        })
    }
}

fn data_of((kind, columns): &Columns<'_>) -> PyResult<Data> {
    let mut columns =
        columns.iter().map(|column| Ok(column.as_slice()?.to_vec())).collect::<PyResult<Vec<Vec<f64>>>>()?;
    let third = if columns.len() > 2 { columns.pop() } else { None };
    let (Some(second), Some(first)) = (columns.pop(), columns.pop()) else {
        return Err(PyValueError::new_err("columns: two are needed"));
    };
    Ok(match kind.as_str() {
        "gate" => Data::Gate { t: first, periods: second, transits: third },
        "swings" => Data::Table { swings: first, periods: second },
        other => {
            let found = MEASURED.iter().find(|(name, _)| *name == other);
            let (_, measured) =
                found.ok_or_else(|| PyValueError::new_err(format!("kind = {other}: is not known")))?;
            Data::Record { measured: *measured, t: first, values: second }
        }
    })
}

/// Names of the models, from none to all friction terms.
#[pyfunction]
fn friction_models() -> Vec<&'static str> {
    Model::LADDER.iter().map(|model| model.name()).collect()
}

/// Names of the steps of which `told` is told, in their order.
#[pyfunction]
fn fit_steps() -> Vec<&'static str> {
    FitOptions::STEPS.to_vec()
}

/// The fit of one record. `ValueError` of one line. `told` is called with the name of each step when it begins.
#[pyfunction]
fn fit_columns<'py>(
    py: Python<'py>,
    data: Columns<'py>,
    known: Known,
    told: Option<Py<PyAny>>,
) -> PyResult<Fitted<'py>> {
    let (data, options) = (data_of(&data)?, known.options()?);
    let found = watched(py, told.as_ref(), move || fit::fit(&data, &options))?;
    Ok(fitted(py, found))
}

/// The fit of several records of one pendulum, or of one g where each has its length: what they share in JSON, the grades of its
/// verdicts, and each record's own.
#[pyfunction]
fn fit_records<'py>(
    py: Python<'py>,
    records: Vec<Columns<'py>>,
    lengths: Option<Vec<Pair>>,
    known: Known,
    told: Option<Py<PyAny>>,
) -> PyResult<(String, Vec<&'static str>, Vec<Fitted<'py>>)> {
    let runs = records.iter().map(data_of).collect::<PyResult<Vec<Data>>>()?;
    let options = known.options()?;
    let lengths = lengths.map(|lengths| lengths.into_iter().map(measure).collect::<Vec<_>>());
    let mut found = watched(py, told.as_ref(), move || match lengths {
        Some(lengths) => fit_lengths(&runs, &lengths, &options),
        None => fit_runs(&runs, &options),
    })?;
    let fits = std::mem::take(&mut found.fits);
    let each = fits.into_iter().map(|fit| fitted(py, fit)).collect();
    Ok((found.json(), grades(&found.verdicts), each))
}

/// g from small-swing periods about two pivots. `between` says that the second distance is the one between the pivots, not from the
/// centre of mass. In JSON, with the grades of the verdicts.
#[pyfunction]
fn gravity_of_pivots(
    periods: [Pair; 2],
    distances: [Pair; 2],
    between: bool,
) -> PyResult<(String, Vec<&'static str>)> {
    let (periods, [first, second]) = (periods.map(measure), distances.map(measure));
    let found = if between {
        fit::reversible_between(periods, second, first)
    } else {
        fit::reversible(periods, [first, second])
    };
    let found = found.map_err(refused)?;
    Ok((found.json(), grades(&found.verdicts)))
}

fn fitted(py: Python<'_>, mut fit: Fit) -> Fitted<'_> {
    let residuals = std::mem::take(&mut fit.residuals);
    let arrays = [residuals.t, residuals.measured, residuals.residual].map(|values| values.into_pyarray(py));
    (fit.json(), grades(&fit.verdicts), arrays)
}

fn grades(verdicts: &[Verdict]) -> Vec<&'static str> {
    let name = |verdict: &Verdict| match verdict.grade {
        Grade::Note => "note",
        Grade::Warning => "warning",
        Grade::Refuted => "refuted",
    };
    verdicts.iter().map(name).collect()
}

/// What the thread of a fit shares with the one that waits for it.
struct Watch {
    given_up: Arc<AtomicBool>,
    steps: Sender<&'static str>,
}

thread_local! {
    static WATCH: RefCell<Option<Watch>> = const { RefCell::new(None) };
}

/// Whether the call that waits for the fit of this thread has given up.
fn given_up() -> bool {
    WATCH.with_borrow(|watch| watch.as_ref().is_some_and(|watch| watch.given_up.load(Ordering::Relaxed)))
}

fn tell(step: &'static str) {
    WATCH.with_borrow(|watch| {
        // Nobody listens any more after a signal.
        watch.as_ref().map(|watch| watch.steps.send(step))
    });
}

/// A fit on a thread of its own, while this one asks for signals and tells the steps. After a signal the thread ends at its next
/// evaluation, and what it finds is dropped.
fn watched<T: Send + 'static>(
    py: Python<'_>,
    told: Option<&Py<PyAny>>,
    work: impl FnOnce() -> Result<T, FitRefusal> + Send + 'static,
) -> PyResult<T> {
    let (steps, listened) = mpsc::channel();
    let (sender, receiver) = mpsc::channel();
    let flag = Arc::new(AtomicBool::new(false));
    let watch = Watch { given_up: Arc::clone(&flag), steps };
    thread::Builder::new()
        .name("libration fit".to_owned())
        .spawn(move || {
            WATCH.set(Some(watch));
            // Nobody waits any more after a signal.
            let _ = sender.send(work());
        })
        .map_err(|error| PyRuntimeError::new_err(format!("no thread for the fit: {error}")))?;
    let all_told = move || -> PyResult<()> {
        let steps: Vec<&str> = listened.try_iter().collect();
        match told {
            Some(told) if !steps.is_empty() => {
                with_interpreter(|py| steps.iter().try_for_each(|step| told.call1(py, (*step,)).map(|_| ())))
            }
            _ => Ok(()),
        }
    };
    let answer = signals::detached(py, move |ended| {
        loop {
            let found = receiver.recv_timeout(INTERVAL);
            let stopped = matches!(found, Err(RecvTimeoutError::Timeout)) && ended(usize::MAX / 2);
            let told = if stopped { Ok(()) } else { all_told() };
            if stopped || told.is_err() {
                flag.store(true, Ordering::Relaxed);
            }
            match found {
                _ if told.is_err() => return told.map(|()| None),
                Ok(found) => return Ok(Some(found)),
                Err(RecvTimeoutError::Disconnected) => return Ok(None),
                Err(RecvTimeoutError::Timeout) if stopped => return Ok(None),
                Err(RecvTimeoutError::Timeout) => {}
            }
        }
    })??;
    answer.ok_or_else(|| PyRuntimeError::new_err("the fit ended without an answer"))?.map_err(refused)
}

/// Adds what stands here to the module.
pub fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(equivalent_length, module)?)?;
    module.add_function(wrap_pyfunction!(friction_models, module)?)?;
    module.add_function(wrap_pyfunction!(fit_steps, module)?)?;
    module.add_function(wrap_pyfunction!(fit_columns, module)?)?;
    module.add_function(wrap_pyfunction!(fit_records, module)?)?;
    module.add_function(wrap_pyfunction!(gravity_of_pivots, module)?)
}

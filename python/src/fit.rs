//! Files of measurements, their fit, and g: what `libration fit` and `libration.fit` stand on; and one column of numbers,
//! for `--times` and for series that are drawn.

use std::cell::RefCell;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;

use libration::Shape;
use libration_fit::fit::{
    Corrections, Data, Fit, FitOptions, FitRefusal, Grade, Measure, Measured, MeasuredPart, Model,
    length_of_parts,
};
use libration_fit::{Kind, Options, Wanted};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;

use crate::damped::Floats;
use crate::signals::{self, INTERVAL};

/// A value and its standard uncertainty, as Python gives it.
type Pair = (f64, f64);

/// Result in JSON without its residuals; grades of the verdicts; times, values and residuals.
type Fitted<'py> = (String, Vec<&'static str>, [Floats<'py>; 3]);

/// g with its uncertainty, its budget, and g by the formula of small swings.
type Weighed = (Pair, Vec<(String, f64)>, f64);

fn measure((value, u): Pair) -> Measure {
    Measure { value, u }
}

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

fn refused(refusal: FitRefusal) -> PyErr {
    PyValueError::new_err(refusal.to_string())
}

/// A file of measurements as it was understood.
#[pyclass(frozen, module = "libration._core")]
pub struct Record {
    record: libration_fit::Record,
}

#[pymethods]
impl Record {
    /// Reads the bytes of a file; `columns` and `units` are texts such as `angle=theta`. `ValueError` of one line.
    #[new]
    #[pyo3(signature = (name, data, columns, units, rate=None, run=None, length=None))]
    #[allow(clippy::too_many_arguments, reason = "what is stated about a file, handed over once")]
    fn new(
        py: Python<'_>,
        name: &str,
        data: &[u8],
        columns: Vec<String>,
        units: Vec<String>,
        rate: Option<f64>,
        run: Option<usize>,
        length: Option<f64>,
    ) -> PyResult<Self> {
        let unread = |refusal: libration_fit::Refusal| PyValueError::new_err(refusal.to_string());
        let mut options = Options { rate, run, length, ..Options::default() };
        for column in columns {
            options = options.column(&column).map_err(unread)?;
        }
        for unit in units {
            options = options.unit(&unit).map_err(unread)?;
        }
        let record = py.detach(|| libration_fit::read(name, data, &options)).map_err(unread)?;
        Ok(Self { record })
    }

    /// What it is made of: samples, gate or swings.
    #[getter]
    fn kind(&self) -> &'static str {
        match self.record.kind {
            Kind::Samples => "samples",
            Kind::Gate => "gate",
            Kind::Swings => "swings",
        }
    }

    /// Each guess as one sentence.
    #[getter]
    fn understood(&self) -> Vec<String> {
        self.record.understood.clone()
    }

    /// What was left out: reason, how many rows, the first of their lines, and all as one sentence.
    #[getter]
    fn dropped(&self) -> Vec<(String, usize, Vec<usize>, String)> {
        let each = |dropped: &libration_fit::read::Dropped| {
            (dropped.reason.clone(), dropped.count, dropped.lines.clone(), dropped.to_string())
        };
        self.record.dropped.iter().map(each).collect()
    }

    /// The run that was read, from 1, and how many the file has.
    #[getter]
    fn run(&self) -> (usize, usize) {
        self.record.run
    }

    /// The instants in s.
    #[getter]
    fn time<'py>(&self, py: Python<'py>) -> Floats<'py> {
        self.record.time.clone().into_pyarray(py)
    }

    /// The measured series: what each is, its name in the file, its values in SI units, their stated uncertainty.
    #[getter]
    fn series<'py>(&self, py: Python<'py>) -> Vec<(&'static str, String, Floats<'py>, Option<f64>)> {
        let each = |series: &libration_fit::Series| {
            let values = series.values.clone().into_pyarray(py);
            (series.quantity.words(), series.name.clone(), values, series.uncertainty)
        };
        self.record.series.iter().map(each).collect()
    }

    /// What is fitted of it: the kind and the columns, as `fit_columns` takes them.
    fn columns<'py>(&self, py: Python<'py>) -> PyResult<(&'static str, Vec<Floats<'py>>)> {
        let array = |values: Vec<f64>| values.into_pyarray(py);
        Ok(match libration_fit::data(&self.record).map_err(PyValueError::new_err)? {
            Data::Record { measured, t, values } => (name_of(measured), vec![array(t), array(values)]),
            Data::Gate { t, periods, transits } => {
                let mut columns = vec![array(t), array(periods)];
                columns.extend(transits.map(array));
                ("gate", columns)
            }
            Data::Table { swings, periods } => ("swings", vec![array(swings), array(periods)]),
        })
    }
}

const MEASURED: [(&str, Measured); 3] =
    [("angle", Measured::Angle), ("velocity", Measured::Velocity), ("acceleration", Measured::Acceleration)];

fn name_of(measured: Measured) -> &'static str {
    MEASURED.iter().find(|(_, each)| *each == measured).map_or("", |(name, _)| name)
}

fn data_of(kind: &str, mut columns: Vec<Vec<f64>>) -> PyResult<Data> {
    let third = if columns.len() > 2 { columns.pop() } else { None };
    let (Some(second), Some(first)) = (columns.pop(), columns.pop()) else {
        return Err(PyValueError::new_err("columns: two are needed"));
    };
    Ok(match kind {
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

/// The fit of columns. `ValueError` of one line. `resampled` is bootstrap, draws and seed; `relative` scale and clock.
#[pyfunction]
#[pyo3(signature = (kind, columns, length, gravity, parts, model, window, relative, free_scale, resampled))]
#[allow(clippy::too_many_arguments, reason = "the options of a fit, handed over once")]
fn fit_columns<'py>(
    py: Python<'py>,
    kind: &str,
    columns: Vec<PyReadonlyArray1<'py, f64>>,
    length: Option<Pair>,
    gravity: Option<Pair>,
    parts: Vec<PartGiven>,
    model: Option<&str>,
    window: Option<Pair>,
    relative: Pair,
    free_scale: bool,
    resampled: (usize, usize, u64),
) -> PyResult<Fitted<'py>> {
    let columns = columns.iter().map(|column| Ok(column.as_slice()?.to_vec())).collect::<PyResult<_>>()?;
    let data = data_of(kind, columns)?;
    let model = model.and_then(|name| Model::LADDER.into_iter().find(|model| model.name() == name));
    let options = FitOptions {
        length: length.map(measure),
        gravity: gravity.map(measure),
        parts: parts_of(parts)?,
        corrections: Corrections::default(),
        model,
        window,
        scale_u: relative.0,
        clock_u: relative.1,
        free_scale,
        bootstrap: resampled.0,
        monte_carlo: resampled.1,
        seed: resampled.2,
        stop: Some(given_up),
    };
    let mut fit = interruptible(py, data, options)?;
    let residuals = std::mem::take(&mut fit.residuals);
    let grades = fit.verdicts.iter().map(|verdict| match verdict.grade {
        Grade::Note => "note",
        Grade::Warning => "warning",
        Grade::Refuted => "refuted",
    });
    let arrays = [residuals.t, residuals.measured, residuals.residual].map(|values| values.into_pyarray(py));
    Ok((fit.json(), grades.collect(), arrays))
}

thread_local! {
    /// Whether the call that waits for the fit of this thread has given up.
    static GIVEN_UP: RefCell<Arc<AtomicBool>> = RefCell::default();
}

fn given_up() -> bool {
    GIVEN_UP.with_borrow(|flag| flag.load(Ordering::Relaxed))
}

/// The fit on a thread of its own, while this one asks for signals. After one the thread ends at its next evaluation, and what it
/// finds is dropped.
fn interruptible(py: Python<'_>, data: Data, options: FitOptions) -> PyResult<Fit> {
    let (sender, receiver) = mpsc::channel();
    let flag = Arc::new(AtomicBool::new(false));
    let seen = Arc::clone(&flag);
    thread::Builder::new()
        .name("libration fit".to_owned())
        .spawn(move || {
            GIVEN_UP.set(seen);
            // Nobody waits any more after a signal.
            let _ = sender.send(libration_fit::fit::fit(&data, &options));
        })
        .map_err(|error| PyRuntimeError::new_err(format!("no thread for the fit: {error}")))?;
    let found = signals::detached(py, move |ended| {
        loop {
            match receiver.recv_timeout(INTERVAL) {
                Ok(found) => return Some(found),
                Err(RecvTimeoutError::Disconnected) => return None,
                Err(RecvTimeoutError::Timeout) if ended(usize::MAX / 2) => {
                    flag.store(true, Ordering::Relaxed);
                    return None;
                }
                Err(RecvTimeoutError::Timeout) => {}
            }
        }
    })?;
    found.ok_or_else(|| PyRuntimeError::new_err("the fit ended without an answer"))?.map_err(refused)
}

/// g from period, length and swing with its uncertainty; its budget; and 4 pi^2 length / T^2.
#[pyfunction]
fn gravity_of_period(period: Pair, length: Pair, swing: Pair) -> PyResult<Weighed> {
    let found = libration_fit::gravity_of_period(measure(period), measure(length), measure(swing))
        .map_err(refused)?;
    let budget = found.budget.into_iter().map(|row| (row.source, row.u)).collect();
    Ok(((found.g.value, found.g.u), budget, found.small_swings))
}

/// The normal g of WGS 84 at a latitude in rad and a height in m.
#[pyfunction]
fn normal_gravity(latitude: f64, height: f64) -> PyResult<f64> {
    libration_fit::normal_gravity(latitude, height).map_err(refused)
}

/// A column of a file's bytes in the unit of factor 1, and its name.
///
/// `wanted` is the file as a message names it, what the column holds, the names by which it is known, its place if none
/// has such a name, and the sentence on its units; `factor` gives a unit's factor as a decimal text, `quoted` shows a text.
///
/// `ValueError(column, reason)`: whether the column asked for is to blame, and what was found and is allowed.
#[pyfunction]
fn column<'py>(
    py: Python<'py>,
    data: &[u8],
    name: Option<&str>,
    wanted: (String, String, Vec<String>, usize, String),
    factor: &Bound<'py, PyAny>,
    quoted: &Bound<'py, PyAny>,
) -> PyResult<(Bound<'py, PyArray1<f64>>, String)> {
    let (file, plural, names, place, takes) = wanted;
    let wanted = Wanted {
        file: &file,
        plural: &plural,
        names: &names,
        place,
        takes: &takes,
        factor: &|unit| factor.call1((unit,)).and_then(|factor| factor.extract()).ok().flatten(),
        quoted: &|text| {
            let shown = quoted.call1((text,)).and_then(|shown| shown.extract());
            shown.unwrap_or_else(|_| format!("{text:?}"))
        },
    };
    match libration_fit::column(data, name, &wanted) {
        Ok(found) => Ok((found.values.into_pyarray(py), found.name)),
        Err(unread) => Err(PyValueError::new_err((unread.column, unread.reason))),
    }
}

/// Adds what stands here to the module.
pub fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Record>()?;
    module.add_function(wrap_pyfunction!(friction_models, module)?)?;
    module.add_function(wrap_pyfunction!(fit_columns, module)?)?;
    module.add_function(wrap_pyfunction!(equivalent_length, module)?)?;
    module.add_function(wrap_pyfunction!(gravity_of_period, module)?)?;
    module.add_function(wrap_pyfunction!(normal_gravity, module)?)?;
    module.add_function(wrap_pyfunction!(column, module)?)
}

//! Files of measurements as they were read, and g from one period; and one column of numbers, for `--times` and for series that are
//! drawn.

use libration_fit::fit::{Data, FitRefusal, Measure, Measured};
use libration_fit::{Kind, Options, Wanted};
use numpy::{IntoPyArray, PyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;

use crate::damped::Floats;
use crate::signals;

/// Bytes of a file that takes longer to read, some 50 ms, than a user waits for Ctrl-C.
const LONG: usize = 1 << 20;

/// A value and its standard uncertainty, as Python gives it.
pub type Pair = (f64, f64);

/// g with its uncertainty, its budget, and g by the formula of small swings.
type Weighed = (Pair, Vec<(String, f64)>, f64);

pub fn measure((value, u): Pair) -> Measure {
    Measure { value, u }
}

pub fn refused(refusal: FitRefusal) -> PyErr {
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
        data: PyBackedBytes,
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
        let record = if data.len() < LONG {
            py.detach(|| libration_fit::read(name, &data, &options))
        } else {
            let name = name.to_owned();
            signals::in_thread(py, move || libration_fit::read(&name, &data, &options))?
        };
        Ok(Self { record: record.map_err(unread)? })
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

pub const MEASURED: [(&str, Measured); 3] =
    [("angle", Measured::Angle), ("velocity", Measured::Velocity), ("acceleration", Measured::Acceleration)];

fn name_of(measured: Measured) -> &'static str {
    MEASURED.iter().find(|(_, each)| *each == measured).map_or("", |(name, _)| name)
}

/// g from period, length and swing, at the end too where it decays, with its uncertainty; its budget; and 4 pi^2 length / T^2.
#[pyfunction]
#[pyo3(signature = (period, length, swing, end=None))]
fn gravity_of_period(period: Pair, length: Pair, swing: Pair, end: Option<Pair>) -> PyResult<Weighed> {
    let [period, length, swing] = [period, length, swing].map(measure);
    let found = match end {
        Some(end) => libration_fit::gravity_of_decay(period, length, swing, measure(end)),
        None => libration_fit::gravity_of_period(period, length, swing),
    };
    let found = found.map_err(refused)?;
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
    module.add_function(wrap_pyfunction!(gravity_of_period, module)?)?;
    module.add_function(wrap_pyfunction!(normal_gravity, module)?)?;
    module.add_function(wrap_pyfunction!(column, module)?)
}

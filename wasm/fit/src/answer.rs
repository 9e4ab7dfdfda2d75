//! The answers in JSON, and the refusals as the command line prints them: the name of the file, a colon, what is wrong.

use crate::stated::Stated;
use libration_fit::fit::{Data, Fit, Grade, Measured, Together, Verdict, fit, fit_lengths, fit_runs};
use libration_fit::{Kind, read as read_bytes};
use serde::Serialize;

/// What was understood of a file.
#[derive(Serialize)]
struct Understood<'a> {
    /// samples, gate or swings.
    kind: &'static str,
    /// angle, velocity, acceleration, gate or swings.
    measured: &'static str,
    /// The run that was read, from 1, and how many there are.
    run: (usize, usize),
    /// Each guess as one sentence.
    understood: &'a [String],
    /// What was left out, a sentence each.
    dropped: Vec<String>,
    /// The measured columns.
    columns: Vec<Column<'a>>,
    /// Times in s, or turning angles in rad.
    x: &'a [f64],
    /// What is fitted, in SI units.
    y: &'a [f64],
}

#[derive(Serialize)]
struct Column<'a> {
    what: &'static str,
    name: &'a str,
}

/// A result with the grades of its verdicts, in their order.
#[derive(Serialize)]
struct Fitted<'a> {
    fit: &'a Fit,
    grades: Vec<Grade>,
    stands: bool,
    /// Of periods: the turning angle of each by the fit, in rad.
    swings: &'a [f64],
}

/// Several records together: what they share, and each alone.
#[derive(Serialize)]
struct Joint<'a> {
    together: &'a Together,
    /// Of the verdicts of all.
    grades: Vec<Grade>,
    /// Whether no verdict, of all or of one record, forbids to quote it.
    stands: bool,
    records: Vec<Fitted<'a>>,
}

fn grades(verdicts: &[Verdict]) -> Vec<Grade> {
    verdicts.iter().map(|Verdict { grade, .. }| *grade).collect()
}

impl Fitted<'_> {
    fn of(fit: &Fit) -> Fitted<'_> {
        Fitted { fit, grades: grades(&fit.verdicts), stands: fit.stands(), swings: &fit.residuals.swings }
    }
}

/// The data of a file and what was understood of it.
pub fn read(bytes: &[u8], stated: &Stated) -> Result<(Data, String), String> {
    // No name: the reader would cut a long one.
    let record =
        read_bytes("", bytes, &stated.reading).map_err(|refusal| stated.refusal(&refusal.to_string()))?;
    let data = libration_fit::data(&record).map_err(|reason| stated.refusal(&reason))?;
    let kind = match record.kind {
        Kind::Samples => "samples",
        Kind::Gate => "gate",
        Kind::Swings => "swings",
    };
    let (measured, x, y): (_, &[f64], &[f64]) = match &data {
        Data::Record { measured: Measured::Angle, t, values } => ("angle", t, values),
        Data::Record { measured: Measured::Velocity, t, values } => ("velocity", t, values),
        Data::Record { measured: Measured::Acceleration, t, values } => ("acceleration", t, values),
        Data::Gate { t, periods, .. } => ("gate", t, periods),
        Data::Table { swings, periods } => ("swings", swings, periods),
    };
    let columns = record.series.iter();
    let understood = Understood {
        kind,
        measured,
        run: record.run,
        understood: &record.understood,
        dropped: record.dropped.iter().map(ToString::to_string).collect(),
        columns: columns.map(|each| Column { what: each.quantity.words(), name: &each.name }).collect(),
        x,
        y,
    };
    let json = serde_json::to_string(&understood).unwrap_or_default();
    Ok((data, json))
}

/// The fit of data.
pub fn fitted(data: &Data, stated: &Stated) -> Result<String, String> {
    let found = fit(data, &stated.known).map_err(|refusal| stated.refusal(&refusal.to_string()))?;
    Ok(serde_json::to_string(&Fitted::of(&found)).unwrap_or_default())
}

/// The fit of several records: of one pendulum, or of one g at several lengths.
pub fn together(all: &[Data], stated: &Stated) -> Result<String, String> {
    let found = match &stated.lengths[..] {
        [] | [_] => fit_runs(all, &stated.known),
        lengths => fit_lengths(all, lengths, &stated.known),
    };
    let mut found = found.map_err(|refusal| refusal.to_string())?;
    // Each record stands beside what they share, with its grades.
    let fits = core::mem::take(&mut found.fits);
    let grades = grades(&found.verdicts);
    let stands = !grades.contains(&Grade::Refuted) && fits.iter().all(Fit::stands);
    let records = fits.iter().map(Fitted::of).collect();
    Ok(serde_json::to_string(&Joint { together: &found, grades, stands, records }).unwrap_or_default())
}

impl Stated {
    fn refusal(&self, reason: &str) -> String {
        let reason = reason.strip_prefix(": ").unwrap_or(reason);
        if self.file.is_empty() { reason.to_owned() } else { format!("{}: {reason}", self.file) }
    }
}

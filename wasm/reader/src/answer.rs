//! What was understood of a file, and the refusals as the command line prints them.

use crate::json::json;
use crate::lines::of_file;
use crate::stated::Stated;
use libration_fit::fit::{Data, Measured};
use libration_fit::{Kind, data, read as read_bytes};
use serde::Serialize;

/// What was understood of a file.
#[derive(Serialize)]
struct Understood<'a> {
    /// samples, gate or swings.
    kind: &'static str,
    /// angle, velocity, acceleration, gate or swings: what the columns of the answer are.
    measured: &'static str,
    /// The run that was read, from 1, and how many there are.
    run: (usize, usize),
    /// Each guess as one sentence.
    understood: &'a [String],
    /// What was left out, a sentence each.
    dropped: Vec<String>,
    /// The measured columns.
    columns: Vec<Column<'a>>,
}

#[derive(Serialize)]
struct Column<'a> {
    what: &'static str,
    name: &'a str,
}

/// What was understood of a file, and its numbers in SI units: times or turning angles, what is fitted, and of a light gate how long
/// it was dark, where that is known.
pub fn read(bytes: &[u8], stated: &Stated) -> Result<(String, Vec<Vec<f64>>), String> {
    let refused = |reason: &str| of_file(&stated.file, reason);
    // No name: the reader would cut a long one.
    let record = read_bytes("", bytes, &stated.reading).map_err(|refusal| refused(&refusal.to_string()))?;
    let (measured, numbers) = match data(&record).map_err(|reason| refused(&reason))? {
        Data::Record { measured, t, values } => {
            let name = match measured {
                Measured::Angle => "angle",
                Measured::Velocity => "velocity",
                Measured::Acceleration => "acceleration",
            };
            (name, vec![t, values])
        }
        Data::Gate { t, periods, transits } => ("gate", [t, periods].into_iter().chain(transits).collect()),
        Data::Table { swings, periods } => ("swings", vec![swings, periods]),
    };
    let kind = match record.kind {
        Kind::Samples => "samples",
        Kind::Gate => "gate",
        Kind::Swings => "swings",
    };
    let columns = record.series.iter();
    let understood = Understood {
        kind,
        measured,
        run: record.run,
        understood: &record.understood,
        dropped: record.dropped.iter().map(ToString::to_string).collect(),
        columns: columns.map(|each| Column { what: each.quantity.words(), name: &each.name }).collect(),
    };
    Ok((json(&understood), numbers))
}

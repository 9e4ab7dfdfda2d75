//! Reads what the tools of a laboratory write: text tables of every dialect, spreadsheets, archives, Tracker's projects.
//!
//! | step | file |
//! |---|---|
//! | bytes to text | `encoding`, `archive`, `workbook`, `workbook_xml`, `workbook_binary`, `tracker_project` |
//! | text to columns of numbers | `lines`, `dialect`, `numbers`, `header`, `table` |
//! | what a column is | `heads`, `names`, `units`, `columns`, `groups`, `profile`, `select`, `axes`, `vectors` |
//! | runs and instants | `runs`, `clock`, `stamps` |
//! | one column, strictly | `column` |
//! | the motion | `angle`, `circle`, `track`, `gate`, `scales`, `motion` |
//!
//! Time grows with the bytes, unpacked. Memory stays below 64 times the bytes of the unpacked text and 16 MB, whatever
//! they are; an archive may unpack to 200 times its size and 1 MB.

mod angle;
mod archive;
mod axes;
mod circle;
mod clock;
mod column;
mod columns;
mod dialect;
mod encoding;
mod gate;
mod groups;
mod header;
mod heads;
mod lines;
mod motion;
mod names;
mod numbers;
mod options;
mod profile;
mod record;
mod refusal;
mod runs;
mod scales;
mod select;
mod stamps;
mod table;
mod track;
mod tracker_project;
mod units;
mod vectors;
mod workbook;
mod workbook_binary;
mod workbook_xml;

pub use column::{Unread, Values, Wanted, column};
pub use options::{Options, Role};
pub use record::{Dropped, Kind, Pivot, Quantity, Record, Series};
pub use refusal::Refusal;

use refusal::{listed, plain};
use workbook::Sheet;

/// Bytes of the largest text that is read.
const LARGEST: usize = 1 << 30;

/// Reads a file from its bytes.
///
/// | argument | what |
/// |---|---|
/// | `name` | the file's name, for messages; its ending decides nothing |
/// | `bytes` | the whole file |
/// | `options` | what is stated about it |
///
/// Nothing is resampled, smoothed or filled in. What was guessed stands in [`Record::understood`], what was left out in
/// [`Record::dropped`].
///
/// # Errors
/// A [`Refusal`] of one line: the fault, with line or column, what was found and what is allowed; or the question that only
/// the user can answer.
///
/// # Examples
/// ```
/// use libration_fit::{Options, Quantity, read};
///
/// let text = "Zeit / s;Winkel / Grad\n0,0;20,0\n0,1;18,5\n0,2;14,3\n";
/// let record = read("swing.csv", text.as_bytes(), &Options::default()).unwrap();
/// assert_eq!(record.time, [0.0, 0.1, 0.2]);
/// let angle = record.series(Quantity::Angle).unwrap();
/// assert_eq!(angle.name, "Winkel / Grad");
/// assert!((angle.values[0] - 0.34907).abs() < 1e-5);
/// ```
pub fn read(name: &str, bytes: &[u8], options: &Options) -> Result<Record, Refusal> {
    options.checked().and_then(|options| record(bytes, options)).map_err(|refusal| refusal.of(name))
}

fn record(bytes: &[u8], options: &Options) -> Result<Record, Refusal> {
    if bytes.is_empty() {
        return Err(Refusal::fault(None, "is empty"));
    }
    if bytes.len() > LARGEST {
        return Err(Refusal::fault(None, format!("has {} bytes; at most {LARGEST} are read", bytes.len())));
    }
    if bytes.starts_with(b"PK\x03\x04") {
        return archived(bytes, options);
    }
    if bytes.starts_with(b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1") {
        return of_sheets(workbook_binary::sheets(bytes)?, "sheet", options);
    }
    if bytes.starts_with(b"MATLAB 5.0") || bytes.starts_with(b"\x89HDF") || bytes.starts_with(b"PAR1") {
        let reason = "a MATLAB, HDF or Parquet file; load it and hand over its arrays, or save it as CSV";
        return Err(Refusal::fault(None, reason));
    }
    text_record(bytes, options)
}

/// The record of a text file.
fn text_record(bytes: &[u8], options: &Options) -> Result<Record, Refusal> {
    let (text, note) = encoding::decoded(bytes)?;
    let mut notes: Vec<String> = note.into_iter().collect();
    let mut record = if tracker_project::is_project(&text) {
        let (table, said) = tracker_project::table_of(&text)?;
        notes.extend(said);
        motion::record(&table, options)?
    } else {
        motion::record(&text, options)?
    };
    record.understood.splice(0..0, notes);
    Ok(record)
}

/// The record in an archive: a workbook, or the one table of phyphox that holds a motion.
fn archived(bytes: &[u8], options: &Options) -> Result<Record, Refusal> {
    let mut archive = archive::Archive::of(bytes)?;
    let names = archive.names();
    if names.iter().any(|name| name == "xl/workbook.xml") {
        return of_sheets(workbook_xml::sheets(&mut archive)?, "sheet", options);
    }
    let is_table = |name: &&String| {
        let lower = name.to_lowercase();
        // `meta/` tells of the device and of pauses.
        [".csv", ".txt", ".tsv", ".trk"].iter().any(|end| lower.ends_with(end)) && !lower.contains("meta/")
    };
    let tables: Vec<&String> = names.iter().filter(is_table).take(32).collect();
    if tables.is_empty() {
        let reason =
            format!("a ZIP archive without a table (.csv, .txt, .tsv, .trk); it has {}", listed(&names));
        return Err(Refusal::fault(None, reason));
    }
    let mut found = Vec::new();
    for name in tables {
        let bytes = archive.bytes(name)?;
        found.push((name.clone(), text_record(&bytes, options)));
    }
    one_of(found, "file")
}

/// The record in the sheets of a workbook.
fn of_sheets(sheets: Vec<Sheet>, word: &str, options: &Options) -> Result<Record, Refusal> {
    let filled = sheets
        .into_iter()
        .filter(|sheet| !sheet.text.trim().is_empty() && !sheet.name.starts_with("Metadata"));
    let found: Vec<_> =
        filled.map(|sheet| (sheet.name.clone(), motion::record(&sheet.text, options))).collect();
    if found.is_empty() {
        return Err(Refusal::fault(None, "a workbook without a filled sheet"));
    }
    one_of(found, word)
}

/// Of several tables the one that holds the best quantity: an angle before a velocity before an acceleration.
fn one_of(found: Vec<(String, Result<Record, Refusal>)>, word: &str) -> Result<Record, Refusal> {
    let rank = |record: &Record| match record.series.first().map(|series| series.quantity) {
        Some(Quantity::Angle | Quantity::Theta0 | Quantity::Period) | None => 0,
        Some(Quantity::Velocity) => 1,
        Some(Quantity::AngularAcceleration) => 2,
        Some(_) => 3,
    };
    let several = found.len() > 1;
    let best = found.iter().filter_map(|each| each.1.as_ref().ok()).map(rank).min();
    let equal = |each: &(String, Result<Record, Refusal>)| {
        each.1.as_ref().map_or(best.is_none(), |record| Some(rank(record)) == best)
    };
    let mut left: Vec<_> = found.into_iter().filter(equal).collect();
    if left.len() > 1 && best.is_some() {
        let names = left.into_iter().map(|each| each.0).collect();
        return Err(Refusal::question(
            format!("which {word}?"),
            names,
            "it to a file of its own and give that",
        ));
    }
    let (name, record) = left.swap_remove(0);
    record.map(|mut record| {
        if several {
            record.understood.insert(0, format!("Of the {word}s, {} is read.", plain(&name)));
        }
        record
    })
}

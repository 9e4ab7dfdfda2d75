//! Reads what the tools of a laboratory write: text tables of every dialect, spreadsheets, archives, Tracker's projects.
//!
//! | step | file |
//! |---|---|
//! | bytes to text | `text`, `encoding`, `containers`, `other_formats`, `archive`, `workbook`, `workbook_xml`, `workbook_binary`, `tracker_project` |
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
mod containers;
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
mod other_formats;
mod profile;
mod record;
mod refusal;
mod runs;
mod scales;
mod select;
mod stamps;
mod table;
mod text;
mod track;
mod tracker_project;
mod units;
mod vectors;
mod workbook;
#[cfg(feature = "xls")]
mod workbook_binary;
mod workbook_xml;

pub use column::{Unread, Values, Wanted, column};
pub use options::{Options, Role};
pub use record::{Dropped, Kind, Pivot, Quantity, Record, Series};
pub use refusal::Refusal;

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
    if bytes.starts_with(b"PK\x03\x04") || bytes.starts_with(b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1") {
        return containers::record(bytes, options);
    }
    if let Some(what) = other_formats::named(bytes) {
        return Err(Refusal::fault(None, what));
    }
    text::record(bytes, options)
}

//! The record of a text: a table, or a project of Tracker made into one.

use super::encoding;
use super::motion;
use super::options::Options;
use super::record::Record;
use super::refusal::Refusal;
use super::tracker_project;

/// The record of a text file.
pub(super) fn record(bytes: &[u8], options: &Options) -> Result<Record, Refusal> {
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

//! Columns before any choice: their profiles, a name that only the numbers explain, tables that are no measurement.

use super::heads::Head;
use super::names::{Meaning, words};
use super::profile::Profile;
use super::refusal::{Refusal, quoted};
use super::table::Table;

/// The profile of every column.
pub(super) fn profiles(table: &Table<'_>) -> Vec<Profile> {
    table.columns.iter().map(|column| Profile::of(column.iter().copied())).collect()
}

/// Fewer rows are no record in time.
const LEAST_ROWS: usize = 8;

/// Decides what a column named `T` is: a time if it rises as a clock does, as in Kinovea's files, and else a period. Beside a few
/// angles it is a period: those of wider swings are longer; beside a time too.
pub(super) fn settle(heads: &mut [Head], profiles: &[Profile]) {
    let timed = heads.iter().any(|head| head.name != "T" && head.meaning == Some(Meaning::Time));
    let angles = heads.iter().any(|head| head.meaning == Some(Meaning::Angle));
    for (head, profile) in heads.iter_mut().zip(profiles) {
        let table = timed || angles && profile.count < LEAST_ROWS;
        if head.name == "T" && head.meaning == Some(Meaning::Period) && profile.clock() && !table {
            head.meaning = Some(Meaning::Time);
        }
    }
}

/// Refuses tables that a tool computed from a record.
pub(super) fn refuse_computed(heads: &[Head]) -> Result<(), Refusal> {
    match heads.iter().find(|head| head.meaning == Some(Meaning::Computed)) {
        Some(head) => {
            let what = words(&head.written);
            let what = if what.contains("autoko")
                || what.contains("autoco")
                || what.contains("shift")
                || what.contains("versch")
            {
                "an autocorrelation"
            } else {
                "a spectrum"
            };
            let reason = format!(
                "column {} belongs to {what}, not to a motion; give the file of the raw data",
                quoted(&head.written)
            );
            Err(Refusal::fault(None, reason))
        }
        None => Ok(()),
    }
}

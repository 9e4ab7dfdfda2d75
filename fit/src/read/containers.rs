//! Files that hold several tables: archives and workbooks. Of the tables one is read: that with the best quantity.

use super::archive::Archive;
use super::motion;
use super::options::Options;
use super::record::{Quantity, Record};
use super::refusal::{Refusal, listed, plain};
use super::text;
use super::workbook::Sheet;
#[cfg(feature = "xls")]
use super::workbook_binary;
use super::workbook_xml;
use crate::letters::lower;

/// The record in an archive or a workbook.
pub(super) fn record(bytes: &[u8], options: &Options) -> Result<Record, Refusal> {
    if bytes.starts_with(b"PK") {
        return archived(bytes, options);
    }
    #[cfg(feature = "xls")]
    return of_sheets(workbook_binary::sheets(bytes)?, options);
    #[cfg(not(feature = "xls"))]
    Err(Refusal::fault(None, "an old workbook (XLS); save it as XLSX or CSV and give that"))
}

/// The record in an archive: a workbook, or the one table of phyphox that holds a motion.
fn archived(bytes: &[u8], options: &Options) -> Result<Record, Refusal> {
    let mut archive = Archive::of(bytes)?;
    let names = archive.names();
    if names.iter().any(|name| name == "xl/workbook.xml") {
        return of_sheets(workbook_xml::sheets(&mut archive)?, options);
    }
    let is_table = |name: &&String| {
        let lower = lower(name);
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
        found.push((name.clone(), text::record(&bytes, options)));
    }
    one_of(found, "file")
}

/// The record in the sheets of a workbook.
fn of_sheets(sheets: Vec<Sheet>, options: &Options) -> Result<Record, Refusal> {
    let filled = sheets
        .into_iter()
        .filter(|sheet| !sheet.text.trim().is_empty() && !sheet.name.starts_with("Metadata"));
    let found: Vec<_> =
        filled.map(|sheet| (sheet.name.clone(), motion::record(&sheet.text, options))).collect();
    if found.is_empty() {
        return Err(Refusal::fault(None, "a workbook without a filled sheet"));
    }
    one_of(found, "sheet")
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

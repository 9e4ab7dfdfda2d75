//! All integration tests in one program, so that the crate is linked once: a module per file of this folder.

mod allocations;
mod bounds;
mod clocks;
mod column;
mod containers;
mod fit_apparatus;
mod fit_no_record;
mod fit_record;
mod fit_verdicts;
mod fit_windows;
mod gates;
mod gravity;
mod malformed;
mod more_oddities;
mod oddities;
mod questions;
mod random;
mod tracks;

use libration_fit::{Options, Quantity, Record, Refusal, read};

/// The record of a text without options.
fn record(text: &str) -> Record {
    read("file.csv", text.as_bytes(), &Options::default())
        .unwrap_or_else(|refusal| panic!("{refusal}\n{text}"))
}

/// The refusal of bytes.
fn refusal(bytes: &[u8], options: &Options) -> Refusal {
    match read("file.csv", bytes, options) {
        Ok(record) => panic!("read as {record:?}"),
        Err(refusal) => refusal,
    }
}

/// The angles of a record in degrees.
fn degrees(record: &Record) -> Vec<f64> {
    record.series(Quantity::Angle).expect("no angle").values.iter().map(|angle| angle.to_degrees()).collect()
}

/// Fails unless the lists agree within a tolerance.
#[track_caller]
fn near(found: &[f64], wanted: &[f64], tolerance: f64) {
    assert_eq!(found.len(), wanted.len(), "{found:?} for {wanted:?}");
    for (found, wanted) in found.iter().zip(wanted) {
        assert!((found - wanted).abs() <= tolerance, "{found} for {wanted}");
    }
}

/// Fails unless one of the sentences holds the words.
#[track_caller]
fn says(record: &Record, words: &str) {
    let dropped = record.dropped.iter().map(ToString::to_string);
    let said: Vec<String> = record.understood.iter().cloned().chain(dropped).collect();
    assert!(said.iter().any(|sentence| sentence.contains(words)), "no {words:?} in {said:#?}");
}

/// A file without its `mod` line would never be run.
#[test]
fn every_file_is_a_module() {
    let here = concat!(env!("CARGO_MANIFEST_DIR"), "/tests");
    let mut files = 0;
    for entry in std::fs::read_dir(here).unwrap() {
        let name = entry.unwrap().path().file_stem().unwrap().to_str().unwrap().to_owned();
        if name != "suite" {
            assert!(include_str!("suite.rs").contains(&format!("\nmod {name};\n")), "{name}");
            files += 1;
        }
    }
    assert!(files >= 11);
}

//! Any bytes: `cargo +nightly fuzz run read fit/fuzz/corpus fit/fuzz/seeds -- -max_len=65536 -timeout=5 -malloc_limit_mb=64`.
//! The reader must end with a record that keeps its promises or with one line; libFuzzer counts time and memory.
#![no_main]

use libfuzzer_sys::fuzz_target;
use libration_fit::{Kind, Options, Role, Wanted, column, read};

fuzz_target!(|bytes: &[u8]| {
    // The first byte states some options, or asks for one column.
    let Some((&flags, bytes)) = bytes.split_first() else { return };
    let mut options = Options::default();
    if flags & 1 != 0 {
        options.rate = Some(30.0);
    }
    if flags & 2 != 0 {
        options.run = Some(2);
    }
    if flags & 4 != 0 {
        options.columns.push((Role::Angle, "2".to_owned()));
    }
    if flags & 8 != 0 {
        options.length = Some(0.5);
    }
    if flags & 16 != 0 {
        let factor = |unit: &str| {
            [("ms", "0.001"), ("min", "60")].iter().find(|each| each.0 == unit).map(|each| each.1.into())
        };
        let wanted = Wanted {
            file: "file",
            plural: "instants",
            names: &["t".to_owned()],
            place: usize::from(flags & 2 != 0),
            takes: "times take ms, min",
            factor: &factor,
            quoted: &|text| format!("{text:?}"),
        };
        match column(bytes, (flags & 1 != 0).then_some("t"), &wanted) {
            Ok(found) => {
                assert!(!found.values.is_empty() && found.values.iter().all(|value| !value.is_nan()))
            }
            Err(unread) => assert!(!unread.reason.contains(['\n', '\r', '\x1b'])),
        }
        return;
    }
    match read("file", bytes, &options) {
        Ok(record) => {
            assert!(record.time.iter().all(|time| time.is_finite()));
            for (k, pair) in record.time.windows(2).enumerate() {
                assert!(
                    pair[0] <= pair[1] || record.breaks.contains(&(k + 1)) || record.kind != Kind::Samples
                );
            }
            for series in &record.series {
                assert!(
                    record.kind == Kind::Swings
                        || series.values.len() == record.time.len()
                        || record.time.is_empty()
                );
                assert!(record.kind != Kind::Samples || series.values.iter().all(|value| value.is_finite()));
            }
            assert!(record.understood.iter().all(|sentence| !sentence.contains(['\n', '\r', '\x1b'])));
        }
        Err(refusal) => {
            let line = refusal.to_string();
            assert!(!line.contains(['\n', '\r', '\x1b']) && line.len() < 4000, "{line}");
        }
    }
});

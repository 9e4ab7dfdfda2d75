//! Random bytes, and tables that are nearly right: no panic, one line, and records that keep their promises.

use libration_fit::{Kind, Options, read};
use proptest::prelude::*;

fn holds(bytes: &[u8], options: &Options) {
    match read("file", bytes, options) {
        Ok(record) => {
            assert!(record.time.iter().all(|time| time.is_finite()));
            for (k, pair) in record.time.windows(2).enumerate() {
                assert!(
                    pair[0] <= pair[1] || record.breaks.contains(&(k + 1)) || record.kind != Kind::Samples
                );
            }
            for series in &record.series {
                let samples = record.kind == Kind::Samples;
                assert!(!samples || series.values.len() == record.time.len());
                assert!(!samples || series.values.iter().all(|value| value.is_finite()));
            }
        }
        Err(refusal) => {
            let line = refusal.to_string();
            assert!(!line.contains(|each: char| each.is_control()) && line.len() < 4000, "{line:?}");
        }
    }
}

fn options() -> impl Strategy<Value = Options> {
    let column = prop_oneof![Just("time=1"), Just("angle=2"), Just("x=2"), Just("y=3"), Just("velocity=t")];
    let rate = proptest::option::of(1e-3..1e4f64);
    let run = proptest::option::of(1..4usize);
    (rate, run, proptest::collection::vec(column, 0..3)).prop_map(|(rate, run, columns)| {
        let stated = Options { rate, run, ..Options::default() };
        columns.into_iter().fold(stated, |stated, column| stated.column(column).unwrap())
    })
}

/// A cell as some tool might write it.
fn cell() -> impl Strategy<Value = String> {
    prop_oneof![
        4 => (-1e3..1e3f64).prop_map(|value| format!("{value:.3}")),
        2 => (-1000..1000i32).prop_map(|value| value.to_string()),
        1 => (-1e3..1e3f64).prop_map(|value| format!("{value:.2}").replace('.', ",")),
        1 => (-1e9..1e9f64).prop_map(|value| format!("{value:E}")),
        1 => prop_oneof![Just(""), Just("NaN"), Just("#N/A"), Just("-"), Just("\""), Just("t"), Just("4294967290"), Just("1,000")]
            .prop_map(str::to_owned),
    ]
}

const HEADS: [&str; 13] = [
    "t", "time (s)", "theta", "x", "y", "omega", "Period (s)", "t1", "Run 1: t", "θ [°]", "State at A", "#",
    "frame",
];

const SIGNATURES: [&[u8]; 6] = [
    b"PK\x03\x04",
    b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1",
    b"\xff\xfe",
    b"\xfe\xff",
    b"\xef\xbb\xbf",
    b"<?xml?><object class=\"org.opensourcephysics.cabrillo.tracker.TrackerPanel\">",
];

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_bytes(bytes in proptest::collection::vec(any::<u8>(), 0..600), options in options()) {
        holds(&bytes, &options);
    }

    #[test]
    fn any_bytes_behind_a_signature(
        start in proptest::sample::select(&SIGNATURES[..]),
        bytes in proptest::collection::vec(any::<u8>(), 0..600),
        options in options(),
    ) {
        holds(&[start, &bytes].concat(), &options);
    }

    #[test]
    fn text_of_a_tables_alphabet(text in "[0-9.,;:\t\n\r \"()=EeNa/_#+-]{0,300}", options in options()) {
        holds(text.as_bytes(), &options);
    }

    #[test]
    fn tables_that_are_nearly_right(
        header in proptest::collection::vec(proptest::sample::select(&HEADS[..]), 0..6),
        rows in proptest::collection::vec(proptest::collection::vec(cell(), 0..6), 0..30),
        separator in prop_oneof![Just(","), Just(";"), Just("\t"), Just(" ")],
        options in options(),
    ) {
        let mut text = header.join(separator);
        for row in rows {
            text += "\n";
            text += &row.join(separator);
        }
        holds(text.as_bytes(), &options);
    }

    #[test]
    fn a_good_table_with_one_byte_changed(at in 0..120usize, byte in any::<u8>(), options in options()) {
        let mut text = b"Time (s),Angle (deg),x,y\n0.0,20.0,0.205,-0.564\n0.1,18.5,0.190,-0.569\n0.2,14.3,0.148,-0.581\n0.3,7.9,0.082,-0.594\n".to_vec();
        let at = at.min(text.len() - 1);
        text[at] = byte;
        holds(&text, &options);
    }

    /// A table that is right reads back to the same doubles, however it is written.
    #[test]
    fn what_was_written_is_read(
        values in proptest::collection::vec(-170.0..170.0f64, 5..60),
        separator in prop_oneof![Just(";"), Just("\t")],
        comma in any::<bool>(),
        end in prop_oneof![Just("\n"), Just("\r\n"), Just("\r"), Just("\r\r\n")],
        mark in any::<bool>(),
    ) {
        prop_assume!(values.iter().any(|value| *value != values[0]));
        let mut text = String::from(if mark { "\u{feff}" } else { "" });
        text += &format!("Time (s){separator}omega (rad/s)");
        for (k, value) in values.iter().enumerate() {
            text += end;
            text += &format!("{:?}{separator}{value:?}", k as f64 / 8.0);
        }
        if comma {
            text = text.replace('.', ",");
        }
        let record = read("file", text.as_bytes(), &Options::default()).unwrap();
        prop_assert_eq!(&record.series[0].values, &values);
        prop_assert!(record.time.iter().enumerate().all(|(k, time)| *time == k as f64 / 8.0));
    }
}

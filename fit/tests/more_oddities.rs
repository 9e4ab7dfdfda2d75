//! More of what tools write: lists of periods, positions alone, other orders of name, run and unit, data frames, one column.

use libration_fit::{Kind, Options, Quantity, read};

use super::{degrees, near, record, refusal, says};

#[test]
fn a_list_of_periods() {
    let record = record("n;T (s)\n1;1.602\n2;1.601\n3;1.600\n");
    assert_eq!(record.kind, Kind::Gate);
    near(&record.series(Quantity::Period).unwrap().values, &[1.602, 1.601, 1.6], 0.0);
    near(&record.time, &[0.0, 1.602, 3.203], 1e-12);
    says(&record, "each period begins where the one above ends");
}

#[test]
fn a_period_beside_a_time() {
    for header in ["t (s),T (s)", "t,T", "T (s),t (s)"] {
        let swapped = header.starts_with('T');
        let row = |t: f64, period: f64| {
            if swapped { format!("{period},{t}\n") } else { format!("{t},{period}\n") }
        };
        let rows = [row(0.5, 2.0908), row(2.6, 2.0899), row(4.7, 2.0885)].concat();
        let record = record(&format!("{header}\n{rows}"));
        assert_eq!(record.kind, Kind::Gate, "{header}");
        near(&record.time, &[0.5, 2.6, 4.7], 0.0);
        near(&record.series(Quantity::Period).unwrap().values, &[2.0908, 2.0899, 2.0885], 0.0);
    }
}

#[test]
fn a_position_alone_has_a_period() {
    let record = record("Time (s),Position (m),Velocity (m/s)\n0,0.5,0\n0.1,0.6,0.1\n0.2,0.5,0.0\n");
    assert_eq!(record.series[0].quantity, Quantity::AngleUnscaled);
    assert_eq!(record.series[0].name, "Position (m)");
}

#[test]
fn runs_named_before_the_unit() {
    let text =
        "\"Time (s)\",\"Angle, Run #1 (rad)\",\"Angle, Run #2 (rad)\"\n0,0.1,0.2\n0.1,0.2,0.3\n0.2,0.1,0.1\n";
    let second = read("f", text.as_bytes(), &Options { run: Some(2), ..Options::default() }).unwrap();
    near(&second.series[0].values, &[0.2, 0.3, 0.1], 0.0);
    assert_eq!(second.run, (2, 2));
}

#[test]
fn one_angle_in_two_units() {
    let record = record("t,Angle (deg),Angle (rad)\n0,10,0.174533\n0.1,9,0.15708\n0.2,7,0.122173\n");
    near(&degrees(&record), &[10.0, 9.0, 7.0], 1e-12);
    says(&record, "hold one angle: the first is taken");
}

#[test]
fn a_phone_that_counts_from_1970() {
    let text = "time,seconds_elapsed,z,y,x\n1700000000000000000,0.0,1,2,3\n1700000000010000000,0.01,2,3,4\n1700000000020000000,0.02,1,4,5\n";
    let line = refusal(text.as_bytes(), &Options::default()).to_string();
    assert!(line.contains("what do the three axes hold? x, y, z; write --column velocity=NAME"), "{line}");
    let record = read("f", text.as_bytes(), &Options::default().column("velocity=y").unwrap()).unwrap();
    near(&[record.time[2] - record.time[0]], &[0.02], 1e-6);
    says(&record, "taken as ns since 1970");
}

#[test]
fn columns_that_a_data_frame_renamed() {
    let record = record("Time,Angle,Time.1,Angle.1\n0,10,0,20\n0.1,9,0.1,19\n0.2,7,0.2,17\n,,0.3,15\n");
    assert_eq!((record.run, record.time.len()), ((2, 2), 4));
    near(&degrees(&record), &[20.0, 19.0, 17.0, 15.0], 1e-12);
}

#[test]
fn comments_of_other_programs() {
    for mark in ["#", "%", "//", "# %"] {
        let record =
            record(&format!("{mark} exported\n{mark} t theta\n  0.0  20.0\n  0.1  18.5\n  0.2  14.3\n"));
        near(&record.time, &[0.0, 0.1, 0.2], 0.0);
        assert_eq!(record.series[0].name, "theta");
    }
    let record = record("# sample rate: 100 Hz\ntheta_deg\n20\n18.5\n14.3\n");
    near(&record.time, &[0.0, 0.01, 0.02], 0.0);
    says(&record, "100 samples in a second, as a line above the rows says");
}

#[test]
fn units_beside_every_number() {
    let record = record("t,theta\n0 ms,20.0 deg\n100 ms,18.5 deg\n200 ms,14.3 deg\n");
    near(&record.time, &[0.0, 0.1, 0.2], 0.0);
    near(&degrees(&record), &[20.0, 18.5, 14.3], 1e-12);
    let line = refusal(b"t,theta\n0 ms,20.0 deg\n100 ms,0.3 rad\n200 ms,14.3 deg\n", &Options::default())
        .to_string();
    assert_eq!(
        line,
        "file.csv: line 3: column \"theta\" has values in \"deg\" and in \"rad\"; write one unit"
    );
}

#[test]
fn what_another_run_lacks_is_not_told() {
    let text =
        "Time (s),Angle (rad) Run #1,Angle (rad) Run #2\n0,0.1,0.2\n0.1,0.2,x\n0.2,0.1,0.1\n0.3,0.2,0.3\n";
    let first = record(text);
    assert_eq!((first.run, first.time.len(), first.dropped.len()), ((1, 2), 4, 0));
    let second = read("f", text.as_bytes(), &Options { run: Some(2), ..Options::default() }).unwrap();
    assert_eq!((second.time.len(), second.dropped[0].lines.clone()), (3, vec![3]));
}

#[test]
fn one_column_of_decimal_commas() {
    let rated = Options { rate: Some(10.0), ..Options::default() };
    for head in ["Winkel (°)", "# angle, deg\nangle (deg)", "angle (deg)\n"] {
        let read = read("f", format!("{head}\n20,0\n18,5\n-14,3\n-7,90\n-8\n").as_bytes(), &rated).unwrap();
        near(&read.time, &[0.0, 0.1, 0.2, 0.3, 0.4], 1e-15);
        near(&degrees(&read), &[20.0, 18.5, -14.3, -7.9, -8.0], 1e-12);
        says(&read, "decimal commas");
    }
    // Whole numbers beside a counter, and under two names.
    for text in ["Pendulum\n1,20\n2,18\n3,14\n4,7\n", "n,angle (deg)\n3,20\n2,18\n3,14\n4,7\n"] {
        let options = Options::default().column("angle=2").unwrap().unit("angle=deg").unwrap();
        let read = read("f", text.as_bytes(), &Options { rate: Some(10.0), ..options }).unwrap();
        near(&degrees(&read), &[20.0, 18.0, 14.0, 7.0], 1e-12);
    }
}

#[test]
fn an_empty_line_is_a_missing_sample_where_a_rate_stands_for_times() {
    let rated = Options { rate: Some(10.0), ..Options::default() };
    let time = |text: &str| read("f", text.as_bytes(), &rated).unwrap();
    let record = time("angle (deg)\n\n20.0\n18.5\n\n7.9\n \n\n-14.3\n\n\n");
    near(&record.time, &[0.0, 0.1, 0.3, 0.6], 1e-15);
    says(&record, "are samples that are missing: 3");
    // Remarks are no samples, a row of empty cells and a word are, and double spacing is no gap.
    near(&time("angle (deg)\n20.0\n# here\n18.5\nlost\n7.9\n").time, &[0.0, 0.1, 0.3], 1e-15);
    near(&time("angle (deg),b\n20.0,1\n18.5,1\n,\n7.9,1\n").time, &[0.0, 0.1, 0.3], 1e-15);
    near(&time("angle (deg)\n\n20.0\n\n18.5\n\n\n\n7.9\n").time, &[0.0, 0.1, 0.3], 1e-15);
    // A header that returns begins another recording.
    near(&time("angle,b\n20.0,1\n18.5,1\n\n\nangle,b\n7.9,1\n\n3.0,1\n").time, &[0.0, 0.1, 0.2, 0.4], 1e-15);
}

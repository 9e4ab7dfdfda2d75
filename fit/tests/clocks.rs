//! Instants: ticks, wraps, steps back, rounding, rates, units.

use libration_fit::{Options, Quantity, read};

use super::{near, record, says};

#[test]
fn ticks_are_told_by_their_steps() {
    let milliseconds = record("t theta\n0 10\n20 9\n40 7\n60 4\n");
    near(&milliseconds.time, &[0.0, 0.02, 0.04, 0.06], 0.0);
    says(&milliseconds, "taken as ms");
    let microseconds = record("t theta\n0 10\n20000 9\n40000 7\n60000 4\n");
    near(&microseconds.time, &[0.0, 0.02, 0.04, 0.06], 0.0);
    says(&microseconds, "taken as us");
    let stated =
        read("f", b"t theta\n0 10\n20 9\n40 7\n60 4\n", &Options::default().unit("time=s").unwrap()).unwrap();
    near(&stated.time, &[0.0, 20.0, 40.0, 60.0], 0.0);
}

#[test]
fn microseconds_wrap_after_71_minutes() {
    let record = record("time_us,angle_deg\n4294940000,10\n4294960000,9\n12704,7\n32704,4\n");
    near(&record.time, &[4294.94, 4294.96, 4294.98, 4295.0], 1e-9);
    says(&record, "wraps");
}

#[test]
fn a_step_back_of_the_clock_keeps_the_order() {
    let mut text = String::from("t/ms,theta/deg\n");
    for k in 0..40 {
        let time = if k < 20 { 25 * k } else { 25 * k - 42 };
        text += &format!("{time},{}\n", k % 9);
    }
    let record = record(&text);
    assert_eq!((record.time.len(), record.breaks.clone()), (40, vec![20]));
    near(&record.time[19..21], &[0.475, 0.458], 1e-12);
    says(&record, "The clock steps back 1 times, first from 475 to 458 in line 22");
}

#[test]
fn one_stray_stamp_is_left_out() {
    let record = record("t,theta\n0,1\n0.1,2\n99,3\n0.3,2\n0.4,1\n0.0,0\n0.6,1\n0.7,2\n");
    near(&record.time, &[0.0, 0.1, 0.3, 0.4, 0.6, 0.7], 0.0);
    assert_eq!(record.dropped[0].lines, [4, 7]);
}

#[test]
fn a_stated_rate_stands_for_times() {
    let options = Options { rate: Some(40.0), ..Options::default() };
    let record = read("f", b"# u, th\n0.1, 0.349\n0.2, 0.323\n-0.3, 0.25\n", &options).unwrap();
    near(&record.time, &[0.0, 0.025, 0.05], 0.0);
    assert_eq!(record.series[0].name, "th");
    // A row without a value is a sample that is missing, not a shorter record.
    let holes = read("f", b"theta\n1\nnan\n3\n2\n", &options).unwrap();
    near(&holes.time, &[0.0, 0.05, 0.075], 0.0);
    // Frame numbers count the frames that were passed over.
    let frames = read("f", b"frame,theta\n10,1\n15,2\n20,3\n25,2\n", &options).unwrap();
    near(&frames.time, &[0.0, 0.125, 0.25, 0.375], 0.0);
}

#[test]
fn a_rate_in_the_preamble() {
    let record =
        record("trigger_deg, sample_rate, duration_sec\n135, 1000, 5 \n-135.27\n-135.55\n-135.82\n-136.09\n");
    near(&record.time, &[0.0, 0.001, 0.002, 0.003], 0.0);
    near(&[record.series[0].values[0].to_degrees()], &[-135.27], 1e-9);
    says(&record, "1000 samples in a second");
}

#[test]
fn clocks_on_the_wall() {
    let kinovea = record(
        "#Kinovea Trajectory data export\n#T X Y\n0:00:00:00 3.473 -19.696\n0:00:00:04 10.0 -17.3205\n0:00:00:08 14.863 -13.383\n0:00:00:12 17.976 -8.767\n0:00:00:16 19.696 -3.473\n",
    );
    near(&kinovea.time, &[0.0, 0.04, 0.08, 0.12, 0.16], 1e-12);
    let day = record("time,theta\n23:59:59.8,1\n23:59:59.9,2\n00:00:00.0,3\n00:00:00.1,2\n");
    near(&day.time, &[86399.8, 86399.9, 86400.0, 86400.1], 1e-6);
    let stamp = record(
        "Timestamp;Angle (deg)\n2024-07-19 15:25:54.10;1\n2024-07-19 15:25:54.20;2\n2024-07-19 15:25:54.30;3\n",
    );
    near(&stamp.time, &[55554.1, 55554.2, 55554.3], 1e-9);
}

#[test]
fn nothing_is_resampled() {
    let text = "t,theta\n0,1\n0.1,2\n0.25,3\n0.3,2\n1.7,1\n";
    let record = record(text);
    near(&record.time, &[0.0, 0.1, 0.25, 0.3, 1.7], 0.0);
    says(&record, "A gap of 1.4 s after 0.3 s");
    near(&record.series(Quantity::Angle).unwrap().values, &[1.0, 2.0, 3.0, 2.0, 1.0], 0.0);
}

#[test]
fn rounded_stamps_without_an_even_rate_are_kept() {
    let record = record(
        "t;theta\n1.00E+01;1\n1.00E+01;2\n1.00E+01;3\n1.01E+01;2\n1.09E+01;1\n1.10E+01;0\n1.10E+01;1\n",
    );
    near(&record.time, &[10.0, 10.0, 10.0, 10.1, 10.9, 11.0, 11.0], 0.0);
    says(&record, "no even rate explains them");
}

#[test]
fn one_coordinate_has_a_period_only() {
    let record = record("t,x (m)\n0,0.1\n0.1,0.2\n0.2,0.1\n");
    assert_eq!(record.series[0].quantity, Quantity::AngleUnscaled);
    says(&record, "only the period can be used");
}

#[test]
fn a_clock_that_stands_is_no_rounding() {
    let text: String = (0..60).map(|k| format!("1,{}\n", (f64::from(k) * 0.1).sin())).collect();
    assert!(read("f", format!("t,theta\n{text}").as_bytes(), &Options::default()).is_err());
}

//! What public files of pendulums have been seen to hold, each on an invented file: a swing of about 20 degrees and 1.6 s.

use libration_fit::{Kind, Options, Quantity, read};

use super::{degrees, near, record, refusal, says};

const SWING: [f64; 4] = [20.0, 18.5, 14.3, 7.9];

/// A tab is written as an arrow.
fn tabbed(text: &str) -> String {
    text.replace('→', "\t")
}

#[test]
fn semicolons_decimal_commas_and_a_mark() {
    let text = "\u{feff}Tempo (s);Ângulo (°);Velocidade (°/s)\r\n0,0;20,0;0,0\r\n0,1;18,5;-29,8\r\n0,2;14,3;-54,6\r\n0,3;7,9;-71,2\r\n";
    let record = record(text);
    near(&record.time, &[0.0, 0.1, 0.2, 0.3], 0.0);
    near(&degrees(&record), &SWING, 1e-12);
    assert_eq!(record.series[0].name, "Ângulo (°)");
    says(&record, "decimal commas");
    says(&record, "the time: \"Tempo (s)\"");
}

#[test]
fn the_unit_decides_what_a_column_is() {
    let record = record(&tabbed("t / s→&b_A1 / rad\n0,0→-0,35\n0,1→-0,32\n0,2→-0,25\n0,3→-0,14\n"));
    near(&degrees(&record), &[-20.05, -18.33, -14.32, -8.02], 0.01);
}

#[test]
fn quotes_tell_decimal_commas_from_separators() {
    let record = record("\"t\",\"theta\"\n\"0,00\",\"20,0\"\n\"0,10\",\"18,5\"\n\"0,20\",\"14,3\"\n");
    near(&record.time, &[0.0, 0.1, 0.2], 0.0);
    near(&degrees(&record), &SWING[..3], 1e-12);
    for text in ["t,theta\n0,00,20,0\n0,10,18,5\n0,20,14,3\n", "0,00,20,0\n0,10,18,5\n0,20,14,3\n"] {
        let line = refusal(text.as_bytes(), &Options::default()).to_string();
        assert!(line.contains("decimal comma"), "{line}");
    }
}

#[test]
fn thousands_separators() {
    let record = record("time_ms,angle\n\"800\",-20.0\n\"900\",-18.5\n\"1,000\",-14.3\n\"1,100\",-7.9\n");
    near(&record.time, &[0.8, 0.9, 1.0, 1.1], 0.0);
    says(&record, "thousands separators");
}

#[test]
fn each_column_has_its_own_decimal_mark() {
    let record = record("t;theta\n0,0;20.0\n0,1;18.5\n0,2;14.3\n0,3;7.9\n");
    near(&record.time, &[0.0, 0.1, 0.2, 0.3], 0.0);
    near(&degrees(&record), &SWING, 1e-12);
    says(&record, "Column \"t\" has decimal commas");
}

#[test]
fn logger_pro_text() {
    for format in ["2", "3"] {
        let head = "Unbenannt.cmbl 05.07.2024 13:17:23 ,\nAktuell\nZeit→Winkel\nt→W\ns→rad\n\n";
        let rows = "0→0,349\n0,1→0,323\n0,2→0,250\n";
        let one = tabbed(&format!("\u{feff}Vernier Format {format}\n{head}{rows}"));
        let read = record(&one);
        assert_eq!(read.series[0].name, "Winkel");
        near(&degrees(&read), &[20.0, 18.5, 14.3], 0.03);
        let again = tabbed(&format!("Aktuell\nZeit→Winkel\nt→W\ns→rad\n\n{rows}0,3→0,140\n"));
        let read = record(&format!("{one}{again}"));
        assert_eq!((read.run, read.time.len()), ((1, 2), 3));
        says(&read, "2 data sets in the file: 1 read");
        let zeros = record(&format!("{one}{}", tabbed("0→0\n0→0,262\n0,1→0,242\n0,2→0,188\n")));
        assert_eq!((zeros.run, zeros.time.len()), ((1, 2), 3));
    }
}

#[test]
fn runs_side_by_side() {
    let rows = "0,0.349,0,0.262\n0.1,0.323,0.1,0.242\n0.2,0.250,0.2,0.188\n,,0.3,0.104\n,,0.4,0.006\n";
    for head in [
        "Data Set 1:Time(s),Data Set 1:Angle(rad),Data Set 2:Time(s),Data Set 2:Angle(rad)",
        "Latest: Time (s),Latest: Angle (rad),Run 1: Time (s),Run 1: Angle (rad)",
        "Time (s) Run #1,Angle (rad) Run #1,Time (s) Run #2,Angle (rad) Run #2",
        "t1,theta1,t2,theta2",
        "Time (s),Angle (rad),Time (s),Angle (rad)",
    ] {
        let text = format!("{head}\n{rows}");
        let longest = record(&text);
        assert_eq!((longest.run, longest.time.len()), ((2, 2), 5), "{head}");
        near(&longest.series[0].values, &[0.262, 0.242, 0.188, 0.104, 0.006], 0.0);
        says(&longest, "2 runs in the file: 2");
        assert!(longest.dropped.is_empty(), "{:?}", longest.dropped);
        let first = read("f", text.as_bytes(), &Options { run: Some(1), ..Options::default() }).unwrap();
        near(&first.series[0].values, &[0.349, 0.323, 0.250], 0.0);
    }
}

#[test]
fn channels_of_different_rate() {
    let text = "Time (s) Run #1,Angle (rad) Run #1,Force (N) Run #1\n0.00,0.349,0.98\n0.05,,0.99\n0.10,0.323,1.01\n0.15,,1.03\n0.20,0.250,1.06\n";
    let record = record(text);
    near(&record.time, &[0.0, 0.1, 0.2], 0.0);
    assert_eq!(record.dropped[0].lines, [3, 5]);
}

#[test]
fn a_gyroscope_with_a_pause() {
    let text = "\"Time (s)\",\"Gyroscope x (rad/s)\",\"Gyroscope y (rad/s)\",\"Gyroscope z (rad/s)\",\"Absolute (rad/s)\"\n\
        0.000000000E0,NaN,NaN,NaN,NaN\n1.000000000E-1,-5.200000000E-1,2.000000000E-2,1.000000000E-2,5.205000000E-1\n\
        2.000000000E-1,-9.530000000E-1,3.000000000E-2,2.000000000E-2,9.537000000E-1\n\
        3.140000000E0,1.200000000E-1,1.000000000E-2,0.000000000E0,1.204000000E-1\n";
    let record = record(text);
    assert_eq!(record.series[0].quantity, Quantity::Velocity);
    near(&record.series[0].values, &[-0.52, -0.953, 0.12], 0.0);
    says(&record, "A gap of 2.94 s after 0.2 s (paused?)");
    says(&record, "Gyroscope x");
    assert_eq!(record.dropped[0].lines, [2]);
}

#[test]
fn the_same_tool_in_other_words() {
    let text = "\"Time (s)\";\"Rotation x (rad/s)\";\"Rotation y (rad/s)\";\"Rotation z (rad/s)\"\n\
        0,000000000E0;1,000000000E-2;0,000000000E0;-5,200000000E-1\n1,000000000E-1;2,000000000E-2;1,000000000E-2;-9,530000000E-1\n\
        2,000000000E-1;2,000000000E-2;1,000000000E-2;-1,243000000E0\n";
    let record = record(text);
    assert_eq!(record.series[0].quantity, Quantity::Velocity);
    near(&record.series[0].values, &[-0.52, -0.953, -1.243], 0.0);
}

#[test]
fn computed_tables_are_refused() {
    let autocorrelation = tabbed(
        "\"Time shift (s)\"→\"Autocorrelation of sum\"\n0.0E0→6.787E0\n2.0E-2→6.681E0\n4.0E-2→6.390E0\n",
    );
    let line = refusal(autocorrelation.as_bytes(), &Options::default()).to_string();
    assert!(line.contains("an autocorrelation, not to a motion"), "{line}");
    let spectrum = "\"Frequency (Hz)\",\"Rel. amplitude (a.u.)\"\n0.1,0.2\n0.2,0.3\n0.3,0.1\n";
    let line = refusal(spectrum.as_bytes(), &Options::default()).to_string();
    assert!(line.contains("a spectrum"), "{line}");
}

#[test]
fn tracker_with_a_title_and_empty_cells() {
    let text = "→mass A→→\nt→x→y→\n0.000→→→\n0.033→→→\n0.067→0.205→-0.564→\n0.100→8.80E-2→-0.594→\n0.133→-3.6E-2→-0.599→\n";
    let record = record(&tabbed(text));
    near(&record.time, &[0.067, 0.1, 0.133], 0.0);
    near(&degrees(&record), &[20.0, 8.4, -3.4], 0.1);
    assert_eq!(record.dropped.len(), 1);
    assert_eq!(record.dropped[0].lines, [3, 4]);
}

#[test]
fn no_header_and_a_track() {
    let record = record(
        "0.000000E0,2.052000E-1,-5.638000E-1\n1.668333E-2,2.046000E-1,-5.640000E-1\n3.336667E-2,2.028000E-1,-5.647000E-1\n",
    );
    near(&degrees(&record), &[20.0, 19.94, 19.75], 0.06);
    says(&record, "Time is column \"1\"");
    says(&record, "a position x, y");
    says(&record, "the origin of the axes");
}

#[test]
fn a_camera_on_its_side() {
    let text = "mass_A\nt→x→y→θ→frame\n0.3→-594.3→82.5→172.1→7\n0.4→-600.0→3.1→179.7→9\n0.5→-594.7→-79.4→-172.4→11\n0.6→-581.9→-146.2→-165.9→13\n";
    let text = tabbed(text);
    let record = record(&text);
    near(&degrees(&record), &[-7.9, -0.3, 7.6, 14.1], 1e-9);
    says(&record, "Rest at 180 deg");
    says(&record, "1 jumps of a turn");
    let options = Options::default().column("x=x").unwrap().column("y=y").unwrap();
    let track = read("f", text.as_bytes(), &options).unwrap();
    near(&degrees(&track), &[-7.9, -0.3, 7.6, 14.1], 0.05);
    says(&track, "down is -x");
}

#[test]
fn pixels_with_y_down_and_an_empty_angle() {
    let text = "Unnamed: 0,time,x,y,theta\n1,0.0,505.2,563.8,0.0\n3,0.1,490.4,569.0,0.0\n5,0.2,448.2,581.4,0.0\n7,0.3,382.5,594.3,0.0\n";
    let record = record(text);
    near(&record.time, &[0.0, 0.1, 0.2, 0.3], 0.0);
    near(&degrees(&record), &SWING, 0.2);
    says(&record, "\"theta\" does not move");
    says(&record, "down is +y");
}

#[test]
fn a_header_borrowed_from_another_program() {
    let record = record("x y dx dy\n0.0 20.0 0.017 0.5\n0.1 18.5 0.017 0.5\n0.2 14.3 0.017 0.5\n");
    near(&record.time, &[0.0, 0.1, 0.2], 0.0);
    near(&degrees(&record), &SWING[..3], 1e-12);
    near(&[record.series[0].uncertainty.unwrap().to_degrees()], &[0.5], 1e-12);
}

#[test]
fn prose_in_a_header() {
    let text = "t (seconds)→θ (degrees)→uncertainty t→uncertainty θ (type b, tracker, about +-1 degree, or less)\n0→20.0→0.01→1\n0.1→18.5→0.01→1\n0.2→14.3→0.01→1\n";
    let record = record(&tabbed(text));
    near(&degrees(&record), &SWING[..3], 1e-12);
    near(&[record.series[0].uncertainty.unwrap().to_degrees()], &[1.0], 1e-12);
}

#[test]
fn a_degree_sign_in_latin_1() {
    let text = b"Zeit [s];Winkel [\xb0];Rohwert\n0.0;20.0;1251\n0.1;18.5;1229\n0.2;14.3;1171\n";
    let record = read("f", text, &Options::default()).unwrap();
    near(&degrees(&record), &SWING[..3], 1e-12);
    says(&record, "Latin-1");
}

#[test]
fn a_wrong_unit_is_read_as_written() {
    let record = record("# t theta_degree\n0.0 0.349\n0.1 0.323\n0.2 0.250\n0.3 0.138\n");
    near(&degrees(&record), &[0.349, 0.323, 0.250, 0.138], 1e-15);
}

#[test]
fn a_unit_guessed_by_size_is_printed() {
    let record = record(&tabbed("0.000→57.1\n0.100→52.9\n0.200→40.8\n0.300→22.6\n"));
    near(&degrees(&record), &[57.1, 52.9, 40.8, 22.6], 1e-12);
    says(&record, "taken as degrees by its size");
}

#[test]
fn times_cut_to_three_digits() {
    let text = "t;theta\n9.93E+00;20.0\n9.97E+00;19.8\n1.00E+01;19.3\n1.00E+01;18.5\n1.01E+01;17.3\n1.01E+01;15.9\n1.01E+01;14.3\n1.02E+01;12.4\n";
    let record = record(text);
    let times: Vec<f64> = (0..8).map(|k| 9.93 + k as f64 / 30.0).collect();
    near(&record.time, &times, 0.006);
    near(&[record.time[7] - record.time[0]], &[7.0 / 30.0], 1e-12);
    says(&record, "+ i/30");
    assert!(record.dropped.is_empty());
}

#[test]
fn a_counter_that_wraps() {
    let record = record("4294967100,20.0\n4294967200,18.5\n4,14.3\n104,7.9\n");
    near(&record.time, &[4294967.1, 4294967.2, 4294967.3, 4294967.4], 1e-9);
    near(&degrees(&record), &SWING, 1e-12);
    says(&record, "wraps: 4294967296 is added");
    says(&record, "taken as ms");
}

#[test]
fn recordings_one_after_the_other() {
    let text = "Time/s,Angle/rad\n0.00,0.349\n0.10,0.323\n0.20,0.250\nTime/s,Angle/rad\n0.00,0.262\n0.10,0.242\n0.20,0.188\n0.30,0.104\n";
    for text in [text.to_owned(), text.replacen("Time/s,Angle/rad\n", "", 2)] {
        let text = if text.starts_with('T') { text } else { format!("Time/s,Angle/rad\n{text}") };
        let record = record(&text);
        assert_eq!((record.run, record.time.len()), ((2, 2), 4));
        near(&record.series[0].values, &[0.262, 0.242, 0.188, 0.104], 0.0);
        says(&record, "2 runs in the file: 2 read");
    }
}

#[test]
fn stamps_out_of_order() {
    let record = record(&tabbed(
        "\"Time (s)\"→\"Gyroscope x (rad/s)\"\n1.000→-0.52\n1.020→-0.61\n1.010→-0.57\n1.020→-0.62\n1.030→-0.66\n",
    ));
    near(&record.time, &[1.0, 1.01, 1.02, 1.03], 0.0);
    near(&record.series[0].values, &[-0.52, -0.57, -0.61, -0.66], 0.0);
    says(&record, "1 out of order, 1 duplicate");
    assert_eq!(record.dropped[0].lines, [5]);
}

#[test]
fn two_clocks_in_one_row() {
    let text = "#Creator: eventBuffer\n#Time A→Pos A→Time B→Pos B\n#[s]→[au]→[s]→[au]\n0.025→600→0.050→449\n0.125→588→0.150→449\n0.225→553→0.250→450\n";
    let text = tabbed(text);
    let record = record(&text);
    near(&record.time, &[0.025, 0.125, 0.225], 0.0);
    assert_eq!(record.series[0].quantity, Quantity::AngleUnscaled);
    assert_eq!(record.run, (1, 2));
    says(&record, "only the period can be used");
    let second = read("f", text.as_bytes(), &Options { run: Some(2), ..Options::default() }).unwrap();
    near(&second.time, &[0.05, 0.15, 0.25], 0.0);
}

#[test]
fn a_number_sign_inside_a_cell_and_rest_elsewhere() {
    let head = "serie,run_number,tempo_s,angulo_rad,velocidade_angular_rad_s\n";
    let few = record(&format!(
        "{head}Série #3,3,0.0,-0.486,\nSérie #3,3,0.1,-0.512,-0.49\nSérie #3,3,0.2,-0.585,-0.91\nSérie #3,3,0.3,-0.697,\n"
    ));
    near(&few.series[0].values, &[-0.486, -0.512, -0.585, -0.697], 0.0);
    let mut text = head.to_owned();
    for k in 0..100 {
        let angle = -0.835 + 0.349 * (0.1 * f64::from(k) * 3.927).cos();
        text += &format!("Série #3,3,{:.1},{angle:.4},\n", 0.1 * f64::from(k));
    }
    let long = record(&text);
    near(&[long.rest.unwrap()], &[-0.835], 0.01);
    says(&long, "Rest at -47.");
}

#[test]
fn a_serial_monitor() {
    let text = "3,-0.41\n14:03:07.150 -> MPU6050 ready\n14:03:07.250 -> t=0 ax=-20 ay=936\n14:03:07.350 -> t=100 ax=-18 ay=941\n14:03:07.450 -> t=200 ax=-14 ay=950\n";
    let record = record(text);
    near(&record.time, &[0.0, 0.1, 0.2], 0.0);
    assert_eq!(record.series[0].quantity, Quantity::LinearAcceleration);
    assert_eq!(record.series[0].name, "ax");
    near(&record.series[0].values, &[-0.196133, -0.17652, -0.137293], 1e-5);
    says(&record, "\"ay\" is radial and swings twice");
    assert_eq!((record.dropped[0].count, record.dropped[0].lines.clone()), (2, vec![1, 2]));
}

#[test]
fn vectors_in_cells() {
    let pairs = "\"(505, 564)\",0.0\r\r\n\"(490, 569)\",0.1\r\r\n\"(448, 581)\",0.2\r\r\n\"(383, 594)\",0.3\r\r\n\"(300, 600)\",0.4\r\r\n";
    let track = record(pairs);
    near(&track.time, &[0.0, 0.1, 0.2, 0.3, 0.4], 0.0);
    near(&degrees(&track), &[20.0, 18.5, 14.3, 7.9, 0.0], 0.6);
    let mut lists = String::new();
    for k in 0..20 {
        let rate = 78.0 * (0.4 * f64::from(k)).cos();
        lists += &format!("[-0.02, -1.70, 9.99]; [{rate:.1}, 8.0, 7.3]; {:.1}\n", 0.1 * f64::from(k));
    }
    let gyroscope = record(&lists);
    assert_eq!(gyroscope.series[0].quantity, Quantity::Velocity);
    near(&[gyroscope.series[0].values[0].to_degrees()], &[78.0], 1e-9);
    says(&gyroscope, "taken as deg/s by its size");
    says(&gyroscope, "Columns 1 to 3 are an accelerometer in m/s^2");
}

#[test]
fn events_of_a_light_gate() {
    let text = "Time,Event Time,State at A,State at B,Comment\ns,s,State,State,\n\n0,0.00000,1,0,\n0.025,0.02500,0,0,\n0.800,0.80000,1,0,\n0.824,0.82400,0,0,\n1.600,1.60000,1,0,\n";
    let record = record(text);
    assert_eq!(record.kind, Kind::Gate);
    near(&record.time, &[0.0, 0.8, 1.6], 0.0);
    let (period, dark) =
        (record.series(Quantity::Period).unwrap(), record.series(Quantity::Transit).unwrap());
    near(&period.values[..1], &[1.6], 1e-15);
    near(&dark.values[..2], &[0.025, 0.024], 1e-12);
    assert!(dark.values[2].is_nan() && period.values[1].is_nan());
    says(&record, "the last passage is open".replacen('t', "T", 1).as_str());
}

#[test]
fn a_buffer_of_periods() {
    let rows = "2.243→1.602→0.0269\n3.044→1.601→0.0270\n3.845→1.600→0.0270\n5.446→3.201→0.0271\n6.247→1.599→0.0272\n6.3→0.8→0.0272\n";
    let record =
        record(&tabbed(&format!("#Creator: buffer\n#Time→Period→Transit time\n#[s]→[s]→[s]\n{rows}")));
    assert_eq!(record.kind, Kind::Gate);
    near(&record.series(Quantity::Period).unwrap().values, &[1.602, 1.601, 1.6, 1.599], 0.0);
    near(&record.time, &[2.243, 3.044, 3.845, 6.247], 0.0);
    says(&record, "the period and how long a passage is dark: \"Period\", \"Transit time\"");
    says(&record, "a passage missed");
    says(&record, "a passage too many");
}

#[test]
fn a_table_of_swings() {
    let text = "Theta (rad),Period (s),,\n-1.396,1.428,,m bob =,50 g\n-0.698,1.307,,\n0.175,--,,\n0.698,1.303,,\n1.396,#N/A,,\nMean,1.346,,\n";
    let record = record(text);
    assert_eq!(record.kind, Kind::Swings);
    near(&record.series(Quantity::Theta0).unwrap().values, &[-1.396, -0.698, 0.698], 0.0);
    near(&record.series(Quantity::Period).unwrap().values, &[1.428, 1.307, 1.303], 0.0);
    says(&record, "no value in column \"Period (s)\" (lines 4, 6)");
    says(&record, "no number in column \"Theta (rad)\" (line 7)");
}

#[test]
fn a_short_table_of_periods_is_no_record_in_time() {
    let rows = ["10,2.0112", "20,2.025", "30,2.041", "40,2.062", "50,2.1"];
    for count in 3..=5 {
        let record = record(&format!("theta (deg),T (s)\n{}\n", rows[..count].join("\n")));
        assert_eq!(record.kind, Kind::Swings);
        near(&record.series(Quantity::Period).unwrap().values[..3], &[2.0112, 2.025, 2.041], 0.0);
    }
}

#[test]
fn bars_part_cells() {
    let plain = record("t [s]|theta [deg]\n0|10\n0.1|9\n0.2|7\n0.3|5\n");
    let page =
        record("| t [s] | theta [deg] |\n| --- | --- |\n| 0 | 10 |\n| 0.1 | 9 |\n| 0.2 | 7 |\n| 0.3 | 5 |\n");
    for record in [plain, page] {
        near(&degrees(&record), &[10.0, 9.0, 7.0, 5.0], 1e-12);
        near(&record.time, &[0.0, 0.1, 0.2, 0.3], 1e-15);
    }
}

#[test]
fn the_size_of_an_angle_is_told_to_six_digits() {
    says(&record("t,theta\n0,1.0096729722787197\n0.1,0.9\n0.2,0.7\n"), "(the largest, 1.00967, does");
}

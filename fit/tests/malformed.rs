//! Malformed files, each with its one line: the file, the line or column, what was found, what is allowed.

use libration_fit::{Options, read};

/// Fails unless the file is refused with this line, without options.
#[track_caller]
fn refused(bytes: impl AsRef<[u8]>, line: &str) {
    refused_with(bytes, Options::default(), line);
}

#[track_caller]
fn refused_with(bytes: impl AsRef<[u8]>, options: Options, line: &str) {
    match read("f.csv", bytes.as_ref(), &options) {
        Ok(record) => panic!("read: {record:#?}"),
        Err(refusal) => assert_eq!(refusal.to_string(), line),
    }
}

#[test]
fn files_that_are_no_tables() {
    refused("", "f.csv: is empty");
    for blank in
        ["\n", " \t \n", "\u{feff}", "\u{feff}\r\n\r\n", ";;;;\n;;;;\n", "# only\n# comments\n", "\n\n\n"]
    {
        refused(blank, "f.csv: holds no row of numbers");
    }
    refused("t,theta\n", "f.csv: holds no row of numbers");
    refused("t,theta\ns,rad\n", "f.csv: holds no row of numbers");
    refused("a letter to nobody\nwith two lines\n", "f.csv: holds no row of numbers");
    refused("NaN,NaN\nNaN,NaN\n", "f.csv: holds no row of numbers");
    refused("t,theta\nNaN,NaN\n,\n", "f.csv: holds no row of numbers");
    refused("<html><body>404</body></html>", "f.csv: is a page of HTML; save the table as CSV");
    refused(
        "{\"time\": [], \"theta\": []}",
        "f.csv: is JSON; write a table of text, or give its times and values to libration.fit in Python",
    );
}

#[test]
fn bytes_that_are_no_text() {
    let text = "; allowed is a table of text, or XLSX, XLS, ZIP, TRK";
    refused(b"t,theta\n0,1\x00\n", &format!("f.csv: is not text: byte 11 is 0x00{text}"));
    refused(b"\x89PNG\r\n\x1a\n\x00\x00", &format!("f.csv: is not text: byte 6 is 0x1a{text}"));
    refused(b"%PDF-1.7\n\x01\x02", "f.csv: is a PDF; give the file of the raw data");
    refused(b"\x1f\x8b\x08\x00", "f.csv: is packed by gzip; unpack it first");
    refused(b"0,1\n1,\x7f2\n", &format!("f.csv: is not text: byte 6 is 0x7f{text}"));
    let arrays = "f.csv: a MATLAB, HDF or Parquet file; load it and hand over its arrays, or save it as CSV";
    refused(b"MATLAB 5.0 MAT-file, Platform: PCWIN64", arrays);
    refused(b"\x89HDF\r\n\x1a\n", arrays);
    refused(b"PAR1\x15\x04", arrays);
}

#[test]
fn broken_containers() {
    for bytes in [&b"PK\x03\x04"[..], b"PK\x03\x04 and nothing else", b"PK\x03\x04\x14\x00\x00\x00\x08\x00"] {
        let line = read("f.zip", bytes, &Options::default()).unwrap_err().to_string();
        assert!(line.starts_with("f.zip: a ZIP archive that cannot be unpacked: "), "{line}");
    }
    for bytes in
        [&b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"[..], b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1 and nothing else"]
    {
        let line = read("f.xls", bytes, &Options::default()).unwrap_err().to_string();
        assert!(line.starts_with("f.xls: an XLS workbook that cannot be opened: "), "{line}");
    }
    let start =
        "<?xml version=\"1.0\"?><object class=\"org.opensourcephysics.cabrillo.tracker.TrackerPanel\">";
    refused(start, "f.csv: a Tracker project without the time of a frame (delta_t); give the exported table");
    let line = read("f.trk", format!("{start}\n\n</other>").as_bytes(), &Options::default())
        .unwrap_err()
        .to_string();
    assert!(line.starts_with("f.trk: line 3: no well-formed XML: "), "{line}");
}

#[test]
fn too_few_rows() {
    let least = "a time and a value; at least 3 are needed";
    refused("t,theta\n0,1\n", &format!("f.csv: line 2: only 1 row has {least}"));
    refused("t,theta\n0,1\n1,2\n", &format!("f.csv: line 2: only 2 rows have {least}"));
    refused("t,theta\n0,1\n1,NaN\n2,NaN\n3,2\n", &format!("f.csv: line 2: only 2 rows have {least}"));
    refused("t,theta\nNaN,1\n1,2\nNaN,2\n3,3\n", &format!("f.csv: line 3: only 2 rows have {least}"));
    refused("t,theta\n1,NaN\n2,NaN\n3,NaN\n", "f.csv: column \"theta\" holds no number");
    refused("t,theta\nNaN,1\nNaN,2\nNaN,3\n", "f.csv: line 2: no row has both a time and a value");
}

#[test]
fn columns_that_are_no_motion() {
    refused("t,theta\n0,1\n1,1\n2,1\n", "f.csv: no column moves: theta");
    refused(
        "t\n0\n1\n2\n",
        "f.csv: has no column of an angle, an angular velocity, an acceleration, a position x, y or a period; it has t",
    );
    refused(
        "t,Force (N)\n0,1\n1,2\n2,1\n",
        "f.csv: has no column of an angle, an angular velocity, an acceleration, a position x, y or a period; it has t, Force (N)",
    );
    refused(
        "t,Absolute (rad/s)\n0,1\n1,2\n2,1\n",
        "f.csv: has no column of an angle, an angular velocity, an acceleration, a position x, y or a period; it has t, Absolute (rad/s)",
    );
    refused(
        "Frequency (Hz),Power\n0,1\n1,2\n2,1\n",
        "f.csv: column \"Frequency (Hz)\" belongs to a spectrum, not to a motion; give the file of the raw data",
    );
    refused(
        "Time,State at A\n0,1\n1,0\n2,0\n",
        "f.csv: line 2: column State at A has 1 passages; a period needs three",
    );
}

#[test]
fn clocks_that_cannot_be() {
    refused(
        "t,theta\n3,1\n2,2\n1,3\n0,1\n",
        "f.csv: line 3: time goes backwards in column \"t\"; times must rise",
    );
    refused(
        "t [d],theta\n0,1\n1,2\n2,1\n",
        "f.csv: column \"t [d]\" is in \"d\"; times take s, ms, us, ns, min, h",
    );
    refused(
        "time (furlong),theta\n0,1\n1,2\n2,1\n",
        "f.csv: column \"time (furlong)\" is in \"furlong\"; times take s, ms, us, ns, min, h",
    );
    refused_with(
        "a (V),theta\n0,1\n1,2\n2,1\n",
        Options::default().column("time=a").unwrap(),
        "f.csv: column \"a (V)\" is no time by its unit; times take s, ms, us, ns, min, h",
    );
    refused(
        "theta (deg)\n1\n2\n1\n",
        "f.csv: no column of times: how many samples in a second? write --rate HZ for evenly spaced samples, or --column time=NAME",
    );
    refused(
        "theta (deg),n\n1,1\n2,2\n1,3\n",
        "f.csv: which column is the time? n; write --rate HZ for evenly spaced samples, or --column time=NAME",
    );
}

#[test]
fn decimal_commas_that_cannot_be_told() {
    let line = |number: usize| {
        format!(
            "f.csv: line {number}: a decimal comma and a comma between columns cannot be told apart; \
             separate columns with semicolons or tabs, or put cells in quotes"
        )
    };
    refused("t,theta\n0,00,20,0\n0,10,18,5\n0,20,14,3\n", &line(2));
    refused("0,00,20,0\n0,10,18,5\n0,20,14,3\n", &line(1));
    refused("t,theta,omega\n0,0,20,0,1,5\n0,1,18,5,2,5\n0,2,14,3,0,5\n", &line(2));
}

#[test]
fn rows_that_are_too_long() {
    let long = "1".repeat((1 << 20) + 1);
    refused(
        format!("t,theta\n0,1\n{long},2\n"),
        "f.csv: line 3: has 1048579 bytes; a row of a table has at most 1048576",
    );
    let wide = vec!["1"; 5000].join(",");
    refused(format!("{wide}\n{wide}\n"), "f.csv: line 1: has more than 4096 columns, the most that are read");
    let header: Vec<String> = (0..5000).map(|k| format!("c{k}")).collect();
    refused(
        format!("{}\n0,1\n1,2\n2,1\n", header.join(",")),
        "f.csv: line 1: has more than 4096 columns, the most that are read",
    );
}

#[test]
fn what_is_stated_and_cannot_hold() {
    let text = "t,theta,phi\n0,1,2\n1,2,3\n2,1,2\n";
    let column = |stated: &str| Options::default().column(stated).unwrap();
    refused_with(
        text,
        column("angle=psi"),
        "f.csv: --column angle=psi: is no column; the file has t, theta, phi",
    );
    refused_with(
        text,
        column("angle=4"),
        "f.csv: --column angle=4: is no column; the file has t, theta, phi",
    );
    refused_with(
        text,
        column("angle=0"),
        "f.csv: --column angle=0: is no column; the file has t, theta, phi",
    );
    refused_with(text, column("x=theta"), "f.csv: a track needs both --column x=NAME and --column y=NAME");
    refused_with(
        "t,a,a,b\n0,1,2,3\n1,2,1,2\n2,1,1,1\n",
        column("angle=a"),
        "f.csv: --column angle=a: names several columns; the file has t, a, a, b",
    );
    refused_with(
        text,
        Options { run: Some(2), ..column("angle=phi") },
        "f.csv: --run = 2: the file has one run",
    );
    refused_with(
        text,
        Options { run: Some(0), ..Options::default() },
        "f.csv: --run = 0: must be 1 or greater",
    );
    refused_with(
        "t1,theta1,t2,theta2\n0,1,0,2\n1,2,1,3\n2,1,2,2\n",
        Options { run: Some(3), ..Options::default() },
        "f.csv: --run = 3: the file has 2 runs",
    );
    for (rate, shown) in [(0.0, "0"), (-1.0, "-1"), (f64::NAN, "NaN"), (f64::INFINITY, "inf")] {
        refused_with(
            text,
            Options { rate: Some(rate), ..Options::default() },
            &format!("f.csv: --rate = {shown}: must be finite and greater than 0"),
        );
    }
    refused_with(
        text,
        Options { length: Some(-0.5), ..Options::default() },
        "f.csv: --length = -0.5: must be finite and greater than 0",
    );
    let unit = |stated: &str| column("angle=theta").unit(stated).unwrap();
    refused_with(text, unit("angle=parsec"), "f.csv: --unit angle=parsec: must be rad, deg, turn or N/turn");
    refused_with(text, unit("angle=s"), "f.csv: --unit angle=s: must be rad, deg, turn or N/turn");
    refused_with(text, unit("angle=0/turn"), "f.csv: --unit angle=0/turn: must be rad, deg, turn or N/turn");
    refused_with(text, unit("time=rad"), "f.csv: --unit time=rad: must be one of s, ms, us, ns, min, h");
}

#[test]
fn options_that_are_no_options() {
    let allowed = "where ROLE is one of time, angle, velocity, acceleration, x, y, period";
    for text in ["theta", "bob=theta", "angle=", "=theta", ""] {
        let line = Options::default().column(text).unwrap_err().to_string();
        assert_eq!(line, format!("--column = \"{text}\": must be ROLE=NAME, {allowed}"));
        let line = Options::default().unit(text).unwrap_err().to_string();
        assert_eq!(line, format!("--unit = \"{text}\": must be ROLE=UNIT, {allowed}"));
    }
}

#[test]
fn what_a_message_shows_is_short_and_plain() {
    let name = "\u{202e}a\u{1b}[31m".to_owned() + &"b".repeat(500);
    let line = read(
        "f\n\x1b.csv",
        format!("t,{name},c\n0,1,2\n1,2,5\n2,1,4\n").replace('\x1b', "\u{9b}").as_bytes(),
        &Options::default(),
    )
    .unwrap_err()
    .to_string();
    assert!(
        !line.contains(|each: char| each.is_control() || each == '\u{202e}') && line.len() < 300,
        "{line:?}"
    );
}

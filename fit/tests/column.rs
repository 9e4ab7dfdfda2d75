//! Instants to compute at: one column, read strictly.

use libration_fit::{Unread, Values, Wanted, column};

fn factor(unit: &str) -> Option<String> {
    let known = [
        ("s", "1"),
        ("ms", "0.001"),
        ("min", "60"),
        ("h", "3600"),
        ("\u{3bc}s", "1E-6"),
        ("deg", "0.0174532925199432957692369"),
    ];
    known.iter().find(|each| each.0 == unit).map(|each| each.1.to_owned())
}

fn wanted_at<T>(place: usize, call: impl FnOnce(&Wanted<'_>) -> T) -> T {
    let names = ["t", "time", "times"].map(str::to_owned);
    call(&Wanted {
        file: "f.csv",
        plural: "instants",
        names: &names,
        place,
        takes: "times take s, ms, min, h",
        factor: &factor,
        quoted: &|text| format!("'{text}'"),
    })
}

fn read(bytes: impl AsRef<[u8]>, name: Option<&str>) -> Result<Values, Unread> {
    wanted_at(0, |wanted| column(bytes.as_ref(), name, wanted))
}

#[track_caller]
fn holds(bytes: impl AsRef<[u8]>, column: Option<&str>, values: &[f64], name: &str) {
    assert_eq!(read(bytes, column), Ok(Values { values: values.to_vec(), name: name.to_owned() }));
}

#[track_caller]
fn refused(bytes: impl AsRef<[u8]>, column: Option<&str>, reason: &str) {
    let unread = read(bytes, column).unwrap_err();
    assert!(unread.reason.contains(reason), "{unread:?}");
    assert_eq!(unread.column, reason.contains("column") && column.is_some(), "{unread:?}");
}

#[test]
fn columns() {
    holds("0\n1\n2", None, &[0.0, 1.0, 2.0], "1");
    holds("2\n1\n1\n-3\n", None, &[2.0, 1.0, 1.0, -3.0], "1");
    holds("# a comment\n\n  # another\nt\n0.5\n# inside\n1e-3\n", None, &[0.5, 1e-3], "t");
    holds("theta [rad];t [s]\n9;1\n8;2\n", None, &[1.0, 2.0], "t [s]");
    holds("x\ty\n1\t2\n", Some("y"), &[2.0], "y");
    holds("1,2\n3,4\n", Some("2"), &[2.0, 4.0], "2");
    holds("0,0\n0,1.5\n", None, &[0.0, 0.0], "1");
    holds("Time,x\r\n1,2\r\n3,4\r\n", None, &[1.0, 3.0], "Time");
    holds(b"\xef\xbb\xbft [s]\n1\n", None, &[1.0], "t [s]");
    holds(b"winkel [\xb0],t\n1,2\n", None, &[2.0], "t");
    holds("\"t [s]\",\"a, b\"\n\"1\",\"x\"\n", None, &[1.0], "t [s]");
    holds("x\tt\n\t1\n\t2\n", None, &[1.0, 2.0], "t");
    let wide: Vec<u8> = "t\n1\n2\n3\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    holds([b"\xff\xfe", &wide[..]].concat(), None, &[1.0, 2.0, 3.0], "t");
}

#[test]
fn units_are_scaled_in_decimals() {
    holds("t [ms]\n250\n1.1\n", None, &[0.25, 0.0011], "t [ms]");
    holds("t_min\n1.5\n", None, &[90.0], "t_min");
    holds("time (h)\n0.1\n-2.5e-1\n", None, &[360.0, -900.0], "time (h)");
    holds("t (\u{3bc}s)\n1\n", None, &[1e-6], "t (\u{3bc}s)");
    holds("t_start [s],t_end [ms]\n1,2\n", Some("t_end"), &[0.002], "t_end [ms]");
    // 0.07 min is 4.2 s, and 0.07 * 60 in doubles is not.
    holds("t [min]\n0.07\n1.1\n", None, &[4.2, 66.0], "t [min]");
}

#[test]
fn decimal_commas() {
    holds("0,5;1,5\n-1,25e-1;2\n", None, &[0.5, -0.125], "1");
    holds("t [ms];x\n0,5;1,25\n1;2\n", None, &[0.0005, 0.001], "t [ms]");
    holds("x;t\n1.5;0,5\n2.5;,75\n", None, &[0.5, 0.75], "t");
    refused("t;x\n0,5;1\n1.5;2\n", None, "has decimal commas and decimal points in one column");
    refused(
        "0,0\n0,1\n",
        None,
        "holds only whole numbers and commas: decimal commas? write points; columns? choose one",
    );
    refused("0,5\n-1,25e-1\n", None, "decimal commas?");
    refused("t\n0,5\n", None, "line 2 has 2 cells, and the first row has 1; a decimal comma? write a point");
    refused("\"0,5\"\n\"1,5\"\n", None, "line 1 '0,5' is not a number; write 0.5");
    refused("t;x\n1.234,5;1\n", None, "line 2 '1.234,5' is not a number");
}

#[test]
fn refusals() {
    refused("# only\n#comments\n\n", None, "holds no instants: it is empty, but for comments");
    refused("t [s]\n", None, "holds no instants: no row follows the header in line 1");
    refused("# c\nt,x\n1,2\n3\n", None, "line 4 has 1 cells, and the first row has 2");
    refused("t\n1\ntwo\n", None, "line 3 'two' is not a number");
    refused("t\n1\n1_0\n", None, "line 3 '1_0' is not a number");
    refused("t,x\n1,2\n,3\n", None, "line 3 has an empty cell");
    refused("t\n1\nnan\n", None, "line 3 'nan' is not finite");
    refused("t\n1e400\n", None, "line 2 '1e400' is not finite");
    refused("\u{2212}1\n1\n", None, "line 1 '\u{2212}1' is not a number");
    refused("theta [rad]\n1\n", None, "column 'theta [rad]' is in 'rad'; times take s, ms, min, h");
    refused("t [week]\n1\n", None, "column 't [week]' is in 'week'; times take s, ms, min, h");
    refused("Run 3, May\nt,x\n0,1\n", None, "lines 1 and 2 are both words: is one a title, or one of units?");
    refused(
        "Run 3\nt\n0\n",
        None,
        "line 2 't' is not a number; if the line above is a title, begin it with #",
    );
    refused("Run 3\n0;1\n", None, "line 2 '0;1' is not a number; if the line above is a title");
    refused(b"t\n1\x00\n", None, "is not text: byte 3 is 0x00");
    refused(
        format!("t\n{}", "1".repeat((1 << 20) + 1)),
        None,
        "line 2 has 1048577 characters, more than the 1048576",
    );
    refused("t,x\n1,2\n", Some("z"), "is no column of f.csv; it has 't', 'x'");
    refused("t,t\n1,2\n", Some("t"), "names several columns of f.csv");
    refused("1,2\n", Some("t"), "f.csv has no header; its columns are '1', '2'");
}

#[test]
fn another_place() {
    let second = |text: &str| wanted_at(1, |wanted| column(text.as_bytes(), None, wanted));
    assert_eq!(second("0,1.5\n1,2\n").unwrap(), Values { values: vec![1.5, 2.0], name: "2".into() });
    assert_eq!(second("a,b [deg]\n0,180\n").unwrap().values, [core::f64::consts::PI]);
    assert_eq!(second("1\n2\n").unwrap_err().reason, "has 1 column, and the instants are in a second");
}

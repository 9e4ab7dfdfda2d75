//! Memory in multiples of the input, and work in proportion to it, on inputs made to break both.

use libration_fit::{Options, read};

use super::allocations::most_held;

/// The promise of `read`: 64 times the unpacked bytes and 16 MB.
fn bounded(name: &str, bytes: &[u8]) -> Result<libration_fit::Record, libration_fit::Refusal> {
    let (result, most) = most_held(|| read(name, bytes, &Options::default()));
    let allowed = 64 * bytes.len() + (16 << 20);
    assert!(most <= allowed, "{name}: {most} bytes held for {}", bytes.len());
    if let Err(refusal) = &result {
        assert!(refusal.to_string().len() < 1000 && !refusal.to_string().contains('\n'));
    }
    result
}

#[test]
fn a_hundred_megabytes_of_newlines() {
    for (end, size) in [("\n", 100_000_000), ("\r\n", 10_000_000), ("\r", 10_000_000)] {
        let text = end.repeat(size / end.len());
        let line = bounded("newlines", text.as_bytes()).unwrap_err().to_string();
        assert_eq!(line, "newlines: holds no row of numbers");
    }
}

#[test]
fn rows_between_many_blank_lines() {
    let mut text = String::from("t;theta");
    for k in 0..1000 {
        text += &"\n".repeat(10_000);
        text += &format!("{};{}", k, (k * k) % 17);
    }
    let record = bounded("sparse", text.as_bytes()).unwrap();
    assert_eq!(record.time.len(), 1000);
}

#[test]
fn the_shortest_rows() {
    let text = "1\n".repeat(4_000_000);
    bounded("ones", text.as_bytes()).unwrap_err();
    let mut pairs = String::new();
    for k in 0..1_000_000 {
        pairs += &format!("{}.5,{}\n", k, k % 7);
    }
    assert_eq!(bounded("pairs", pairs.as_bytes()).unwrap().time.len(), 1_000_000);
}

#[test]
fn long_cells_and_long_headers() {
    let digits = "1".repeat(100_000);
    for text in [
        digits.clone(),
        format!("{digits}\n0,1\n1,2\n2,1\n"),
        format!("t,theta\n{digits},1\n1,2\n2,3\n3,1\n"),
        format!("t,\"{digits}\"\n0,1\n1,2\n2,1\n"),
        format!("t,theta\n0,0.{digits}\n1,2\n2,1\n"),
        format!("{digits}:{digits}=1 b=2\n"),
        format!("\"{}\n0,1\n1,2\n", "\"".repeat(100_000)),
        "(".repeat(100_000),
        format!("t ({}\n0 1\n1 2\n2 1\n", "(".repeat(100_000)),
        format!("{}\n0 1\n1 2\n2 1\n", "_s".repeat(50_000)),
        format!("{}\n0 1\n1 2\n2 1\n", "/s".repeat(50_000)),
        format!("a{}b\n0 1\n1 2\n2 1\n", " in".repeat(50_000)),
    ] {
        let _ = bounded("long", text.as_bytes());
    }
    let line = bounded("cell", "a".repeat(3 << 20).as_bytes()).unwrap_err().to_string();
    assert!(line.contains("line 1: has 3145728 bytes"), "{line}");
}

#[test]
fn many_columns() {
    let header: Vec<String> = (0..100_000).map(|k| format!("c{k}")).collect();
    let line =
        bounded("wide", format!("{}\n1,2\n2,3\n3,1\n", header.join(",")).as_bytes()).unwrap_err().to_string();
    assert!(line.contains("columns"), "{line}");
    // One wide row, then a million short ones.
    let wide = vec!["1"; 4000].join(",");
    let mut text = format!("{wide}\n").repeat(250);
    text += &"1\n".repeat(1_000_000);
    let _ = bounded("ragged", text.as_bytes());
    let same = vec!["t"; 4000].join(",");
    let _ = bounded("same", format!("{same}\n{wide}\n{wide}\n{wide}\n").as_bytes());
    let numbered: Vec<String> = (0..4000).map(|k| format!("t{k}")).collect();
    let _ = bounded("numbered", format!("{}\n{wide}\n{wide}\n{wide}\n", numbered.join(",")).as_bytes());
    let runs: Vec<String> = (0..4000).map(|k| format!("Run {k}: t")).collect();
    let _ = bounded("runs", format!("{}\n{wide}\n{wide}\n{wide}\n", runs.join(",")).as_bytes());
}

#[test]
fn many_bad_rows() {
    let mut text = String::from("t,theta\n0,1\n1,2\n2,1\n");
    for k in 0..200_000 {
        text += if k % 2 == 0 { "t,theta\n" } else { "x,1\n" };
    }
    let record = bounded("bad", text.as_bytes()).unwrap();
    assert!(record.dropped.iter().all(|dropped| dropped.lines.len() <= 100));
    // A clock that falls at every row has as many runs as rows.
    let falls: String = (0..200_000).map(|k| if k % 2 == 0 { "5,1\n" } else { "9,2\n" }).collect();
    let _ = bounded("falls", format!("t,theta\n{falls}").as_bytes());
    let seesaw: String = (0..100_000).map(|k| format!("{},{}\n", (k * 7919) % 100_003, k % 5)).collect();
    let _ = bounded("seesaw", format!("t,theta\n{seesaw}").as_bytes());
}

#[test]
fn a_run_for_every_two_rows_of_a_long_name() {
    let name = "theta ".to_owned() + &"long ".repeat(20_000);
    let falls: String = (0..200_000).map(|k| if k % 2 == 0 { "5,1\n" } else { "9,2\n" }).collect();
    let _ = bounded("falls", format!("t,{name}\n{falls}").as_bytes());
}

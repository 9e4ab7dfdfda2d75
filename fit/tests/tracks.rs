//! Angles from places: pivots, short arcs, cameras in every position, units.

use libration_fit::{Options, Quantity, read};

use super::{degrees, near, record, refusal, says};

/// A track of 200 places about a pivot, with errors of a given size that no seed decides.
fn track(pivot: (f64, f64), radius: f64, swing: f64, error: f64, down: f64) -> (String, Vec<f64>) {
    let (mut text, mut angles) = (String::from("t\tx\ty\n"), Vec::new());
    for k in 0..200 {
        let time = f64::from(k) / 30.0;
        let angle = swing.to_radians() * (4.0 * time).cos();
        let off = error * (f64::from(k) * 12.9898).sin();
        let (sine, cosine) = (angle + down).sin_cos();
        text += &format!(
            "{time:.6}\t{:.6}\t{:.6}\n",
            pivot.0 + (radius + off) * sine,
            pivot.1 - (radius + off) * cosine
        );
        angles.push(angle.to_degrees());
    }
    (text, angles)
}

#[test]
fn the_centre_of_the_circle() {
    let (text, angles) = track((0.3, 1.2), 0.65, 40.0, 0.001, 0.0);
    let record = record(&text);
    near(&degrees(&record), &angles, 0.15);
    let pivot = record.pivot.unwrap();
    near(&[pivot.x, pivot.y, pivot.radius], &[0.3, 1.2, 0.65], 0.002);
    says(&record, "the centre of the track's circle");
    assert!(record.series(Quantity::X).is_some() && record.series(Quantity::Y).is_some());
}

#[test]
fn the_origin_of_the_axes() {
    let (text, angles) = track((0.0, 0.0), 0.65, 4.0, 0.0005, 0.0);
    let record = record(&text);
    near(&degrees(&record), &angles, 0.01);
    says(&record, "the origin of the axes");
}

#[test]
fn a_short_arc_needs_a_length() {
    let (text, angles) = track((0.3, 1.2), 0.65, 4.0, 0.002, 0.0);
    let line = refusal(text.as_bytes(), &Options::default()).to_string();
    assert!(line.contains("write --length"), "{line}");
    let options = Options { length: Some(0.65), ..Options::default() };
    let record = read("f", text.as_bytes(), &options).unwrap();
    near(&degrees(&record), &angles, 0.2);
    says(&record, "at the stated length 0.65");
}

#[test]
fn a_camera_in_any_position() {
    for (down, side) in [(0.0, "-y"), (90.0f64, "+x"), (-90.0, "-x")] {
        let (text, angles) = track((100.0, 50.0), 300.0, 30.0, 0.2, down.to_radians());
        let record = record(&text);
        near(&degrees(&record), &angles, 0.3);
        says(&record, &format!("down is {side}"));
    }
}

#[test]
fn centimetres() {
    let (text, angles) = track((30.0, 120.0), 65.0, 40.0, 0.0, 0.0);
    let record = record(&text.replace("x\ty", "x (cm)\ty (cm)"));
    near(&degrees(&record), &angles, 0.01);
    near(&[record.pivot.unwrap().radius], &[0.65], 1e-4);
    assert!(record.pivot.unwrap().metres);
}

#[test]
fn a_tilted_table_is_an_offset_not_a_turn() {
    let (text, angles) = track((0.0, 0.0), 1.0, 30.0, 0.0, 3f64.to_radians());
    let record = record(&text);
    let tilted: Vec<f64> = angles.iter().map(|angle| angle + 3.0).collect();
    near(&degrees(&record), &tilted, 0.01);
    near(&[record.rest.unwrap().to_degrees()], &[3.0], 0.1);
}

#[test]
fn a_stated_length_is_not_the_radius_of_a_track_in_pixels() {
    let (text, angles) = track((100.0, 50.0), 300.0, 30.0, 0.2, 0.0);
    let options = Options { length: Some(0.65), ..Options::default() };
    let record = read("f", text.as_bytes(), &options).unwrap();
    near(&degrees(&record), &angles, 0.3);
    says(&record, "the centre of the track's circle");
    // Where the arc is too short, a length that is less than half of the track is in another unit.
    let (short, _) = track((100.0, 50.0), 300.0, 4.0, 2.0, 0.0);
    let line = refusal(short.as_bytes(), &options).to_string();
    assert!(line.contains("--length = 0.65") && line.contains("unit of the track"), "{line}");
}

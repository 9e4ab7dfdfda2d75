//! Actions, frequencies, phases, Fourier series and derivatives of the cubic-quintic oscillator against the truth, and the starts
//! back: the rows of the Duffing oscillator's files that have odd powers only.

use crate::ruler::{Row, distance, rows, ulp};
use libration::{CubicQuintic, Duffing};

const ACTIONS: &str = include_str!("../../reference/vectors/oscillator_action.csv");
const SLOPES: &str = include_str!("../../reference/vectors/oscillator_slopes.csv");
const STATES: &str = include_str!("../../reference/vectors/oscillator_states.csv");
const ACTION_ROWS: usize = 289;
const SLOPE_ROWS: usize = 187;
const STATE_ROWS: usize = 149;
const HARMONICS: [usize; 13] = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 16, 24];

fn odd<'a>(text: &'static str, count: usize) -> Vec<Row<'a>> {
    rows(text, count).into_iter().filter(|row| row.hex("r") == 0.0 && row.hex("c") == 0.0).collect()
}

fn force(row: &Row) -> [f64; 3] {
    ["p", "q", "s"].map(|name| row.hex(name))
}

fn orbit(row: &Row) -> CubicQuintic {
    let [p, q, s] = force(row);
    CubicQuintic::new(row.hex("u0"), row.hex("velocity0"), p, q, s).unwrap()
}

fn eased(row: &Row, name: &str) -> f64 {
    let condition = row.decimal(&format!("cond_{name}"));
    if condition.is_finite() { condition * 2f64.powi(-100) } else { 0.0 }
}

/// What is the same off by: in ulps and what 2^-100 of the condition adds.
fn own(row: &Row, name: &str, got: f64) -> f64 {
    let truth = row.truth(name);
    let unit = if truth[0].is_finite() { ulp(truth[0]) + eased(row, name) } else { 1.0 };
    distance(got, truth, unit)
}

/// Errors of action, frequency and phase; `spoil` multiplies each.
fn errors(row: &Row, spoil: [f64; 3]) -> [f64; 3] {
    let one = orbit(row);
    let phase = row.truth("phase");
    let unit = ulp(phase[0].abs().max(3.2)) + eased(row, "phase");
    [
        own(row, "action", one.action() * spoil[0]),
        own(row, "frequency", one.frequency() * spoil[1]),
        distance(one.phase(row.hex("t")) * spoil[2], phase, unit),
    ]
}

#[test]
fn action_frequency_and_phase_keep_their_last_digits() {
    let rows = odd(ACTIONS, ACTION_ROWS);
    assert!(rows.len() > 120, "{}", rows.len());
    let mut worst = [0.0_f64; 3];
    for row in &rows {
        let found = errors(row, [1.0; 3]);
        for (worst, (found, name)) in worst.iter_mut().zip(found.iter().zip(["action", "frequency", "phase"]))
        {
            assert!(*found <= 4.0, "{} {} {name}: {found}", row.text("id"), row.text("stratum"));
            *worst = worst.max(*found);
        }
    }
    println!("worst of action, frequency, phase in ulp: {worst:?}");
    for k in 0..3 {
        let mut spoil = [1.0; 3];
        spoil[k] += 5.0 * f64::EPSILON;
        assert!(rows.iter().any(|row| errors(row, spoil)[k] > 4.0), "{k}");
    }
}

/// 4 ulp of each, and 2^-96 of the largest u.
#[test]
fn series_keep_their_digits() {
    let rows = odd(ACTIONS, ACTION_ROWS);
    let of = |row: &Row, spoil: f64| {
        let one = orbit(row);
        let series = one.fourier(24).unwrap();
        let (low, high) = one.range();
        let largest = low.abs().max(high.abs());
        let error = |name: &str, got: f64, size: f64| {
            let truth = row.truth(name);
            if truth[0].is_nan() && got.is_finite() {
                // Too small for the sums of the truth.
                return if got.abs() < 2f64.powi(-96) * size { 0.0 } else { f64::INFINITY };
            }
            let unit = ulp(truth[0]) + 2f64.powi(-98) * size + eased(row, name);
            distance(got, truth, if truth[0].is_finite() { unit } else { 1.0 })
        };
        let mut worst: f64 = error("distortion", one.distortion() * spoil, 1.0);
        worst = worst.max(distance(series.mean, row.truth("mean"), ulp(largest) + eased(row, "mean")));
        for n in HARMONICS {
            worst = worst.max(error(&format!("amplitude_{n}"), series.u[n - 1] * spoil, largest));
        }
        worst
    };
    for row in &rows {
        let worst = of(row, 1.0);
        assert!(worst <= 4.0, "{} {}: {worst}", row.text("id"), row.text("stratum"));
    }
    assert!(rows.iter().any(|row| of(row, 1.0 + 5.0 * f64::EPSILON) > 4.0));
}

/// Rows so near to a separatrix that a disturbance grows by more than 1e10 on the way: double-doubles leave fewer digits there.
const STEEP: [&str; 0] = [];

/// In each row of the matrix 1e-12 of the largest change: of the derivatives times the arguments, and of the scale of the motion.
#[test]
fn derivatives_keep_twelve_digits() {
    let rows: Vec<Row> = odd(SLOPES, SLOPE_ROWS).into_iter().filter(|row| row.hex("s") != 0.0).collect();
    assert!(rows.len() > 60, "{}", rows.len());
    let wrong = |row: &Row, spoil: f64| {
        let one = orbit(row);
        let found = one.derivatives(row.hex("t"));
        let sizes = [one.u0(), one.velocity0(), one.p(), one.q(), one.s()];
        let mut worst: f64 = 0.0;
        for (of, found) in ["du", "dvelocity"].iter().zip(found) {
            let truth = ["du0", "dvelocity0", "dp", "dq", "ds"].map(|by| row.decimal(&format!("{of}_{by}")));
            let largest = truth.iter().zip(sizes).fold(0.0, |most: f64, (d, x)| most.max((d * x).abs()));
            for k in 0..5 {
                let room = if sizes[k] == 0.0 { truth[k].abs() } else { (largest / sizes[k]).abs() };
                let same = truth[k].is_nan() && found[k].is_nan() || truth[k] == found[k];
                if !same {
                    let off = (found[k] * spoil - truth[k]).abs() / room;
                    worst = if off.is_nan() { f64::INFINITY } else { worst.max(off) };
                }
            }
        }
        worst
    };
    for row in rows.iter().filter(|row| !STEEP.contains(&row.text("id"))) {
        let worst = wrong(row, 1.0);
        assert!(worst <= 1e-12, "{} {}: {worst:e}", row.text("id"), row.text("stratum"));
    }
    assert!(rows.iter().any(|row| wrong(row, 1.0 + 1e-11) > 1e-12));
}

/// The action comes back within 1e-13, in the well that was meant.
#[test]
fn starts_have_the_action() {
    let rows = odd(STATES, STATE_ROWS);
    assert!(rows.len() > 70, "{}", rows.len());
    for row in &rows {
        let (action, phase) = (row.hex("action"), row.hex("phase"));
        let [p, q, s] = force(row);
        let near = CubicQuintic::new(row.hex("near"), row.hex("near_velocity"), p, q, s).unwrap();
        let (low, high) = near.range();
        let made =
            CubicQuintic::from_action_phase(action, phase, Some(0.5 * (low + high)), [p, q, s]).unwrap();
        let off = (made.action() / action - 1.0).abs();
        assert!(off <= 1e-13, "{} {} {off:e}", row.text("id"), row.text("stratum"));
        let (low, high) = made.range();
        let scale = low.abs().max(high.abs());
        let room = 16.0 * ulp(scale) + 4.0 * f64::EPSILON * row.decimal("cond_u0").abs();
        assert!(
            distance(made.u0(), row.truth("u0"), 1.0) <= room.max(1e-13 * scale),
            "{} {} {}",
            row.text("id"),
            row.text("stratum"),
            made.u0()
        );
    }
}

/// Without a fifth power it knows what the Duffing oscillator knows, by another way.
#[test]
fn without_a_fifth_power() {
    let rows: Vec<Row> = odd(ACTIONS, ACTION_ROWS).into_iter().filter(|row| row.hex("s") == 0.0).collect();
    assert!(rows.len() > 4, "{}", rows.len());
    for row in &rows {
        let [p, q, _] = force(row);
        let one = orbit(row);
        let cubic = Duffing::new(one.u0(), one.velocity0(), p, q).unwrap();
        let same = |a: f64, b: f64| (a - b).abs() <= 4.0 * f64::EPSILON * b.abs() || a.is_nan() && b.is_nan();
        assert!(same(one.action(), cubic.action()), "{} {} {}", row.text("id"), one.action(), cubic.action());
        assert!(same(one.frequency(), cubic.frequency()), "{}", row.text("id"));
        let (ours, theirs) = (one.fourier(9).unwrap(), cubic.fourier(9).unwrap());
        let (low, high) = one.range();
        let room = 4.0 * f64::EPSILON * low.abs().max(high.abs());
        for (a, b) in ours.u.iter().chain(&ours.velocity).zip(theirs.u.iter().chain(&theirs.velocity)) {
            let room = room * one.frequency().max(1.0) * 9.0;
            assert!((a - b).abs() <= room || a.is_nan() && b.is_nan(), "{} {a} {b}", row.text("id"));
        }
    }
}

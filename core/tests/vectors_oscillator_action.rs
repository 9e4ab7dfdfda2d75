//! Actions, frequencies, phases, Fourier series and derivatives of the Duffing oscillator against the truth, and the starts back.
//! Rows with a fifth power belong to the cubic-quintic oscillator.

use crate::ruler::{Row, distance, rows, ulp};
use libration::Duffing;

const ACTIONS: &str = include_str!("../../reference/vectors/oscillator_action.csv");
const SLOPES: &str = include_str!("../../reference/vectors/oscillator_slopes.csv");
const STATES: &str = include_str!("../../reference/vectors/oscillator_states.csv");
const HARMONICS: [usize; 13] = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 16, 24];

fn duffing<'a>(text: &'static str, count: usize) -> Vec<Row<'a>> {
    rows(text, count).into_iter().filter(|row| row.hex("s") == 0.0).collect()
}

fn force(row: &Row) -> [f64; 4] {
    ["p", "q", "r", "c"].map(|name| row.hex(name))
}

fn orbit(row: &Row) -> Duffing {
    Duffing::with_even_powers(row.hex("u0"), row.hex("velocity0"), force(row)).unwrap()
}

fn eased(row: &Row, name: &str) -> f64 {
    let condition = row.decimal(&format!("cond_{name}"));
    if condition.is_finite() { condition * 2f64.powi(-100) } else { 0.0 }
}

/// Errors in ulps and what 2^-100 of the condition adds: of the action times a factor, and of the rest.
fn worst(row: &Row, spoil: f64) -> f64 {
    let one = orbit(row);
    let own = |name: &str, got: f64| {
        let truth = row.truth(name);
        if truth[0].is_nan() && name.starts_with("amplitude") && got.is_finite() {
            // Too small for the sums of the truth.
            return 0.0;
        }
        let unit = if truth[0].is_finite() { ulp(truth[0]) + eased(row, name) } else { 1.0 };
        distance(got, truth, unit)
    };
    let series = one.fourier(24).unwrap();
    let phase = row.truth("phase");
    let (low, high) = one.range();
    let mut errors = vec![
        own("action", one.action() * spoil),
        own("frequency", one.frequency()),
        distance(one.phase(row.hex("t")), phase, ulp(phase[0].abs().max(3.2)) + eased(row, "phase")),
        distance(series.mean, row.truth("mean"), ulp(low.abs().max(high.abs())) + eased(row, "mean")),
        own("distortion", one.distortion()),
    ];
    errors.extend(HARMONICS.map(|n| own(&format!("amplitude_{n}"), series.u[n - 1])));
    errors.into_iter().fold(0.0, f64::max)
}

#[test]
fn actions_and_series_keep_their_last_digits() {
    let rows = duffing(ACTIONS, 289);
    assert!(rows.len() > 150);
    let mut bad = 0;
    for row in &rows {
        let error = worst(row, 1.0);
        if error > 4.0 {
            println!("{} {} {} {error}", row.text("id"), row.text("stratum"), row.text("regime"));
            bad += 1;
        }
    }
    assert_eq!(bad, 0);
    assert!(rows.iter().any(|row| worst(row, 1.0 + 5.0 * f64::EPSILON) > 4.0));
}

/// Rows so near to a separatrix that a disturbance grows by more than 1e10 on the way: double-doubles leave fewer digits there.
const STEEP: [&str; 3] = ["os-0021", "os-0073", "os-0077"];

/// In each row of the matrix 1e-12 of the largest change: of the derivatives times the arguments, and of the scale of the motion.
#[test]
fn derivatives_keep_twelve_digits() {
    let rows = duffing(SLOPES, 187);
    assert!(rows.len() > 100);
    for row in rows.iter().filter(|row| !STEEP.contains(&row.text("id"))) {
        let one = orbit(row);
        let found = one.derivatives(row.hex("t"));
        let sizes = [one.u0(), one.velocity0(), one.p(), one.q(), one.r(), one.c()];
        for (of, found) in ["du", "dvelocity"].iter().zip(found) {
            let truth =
                ["du0", "dvelocity0", "dp", "dq", "dr", "dc"].map(|by| row.decimal(&format!("{of}_{by}")));
            let largest = truth.iter().zip(sizes).fold(0.0, |most: f64, (d, x)| most.max((d * x).abs()));
            for k in 0..6 {
                let room = if sizes[k] == 0.0 { truth[k].abs() } else { (largest / sizes[k]).abs() };
                let off = (found[k] - truth[k]).abs();
                assert!(
                    off <= 1e-12 * room || truth[k].is_nan() && found[k].is_nan() || truth[k] == found[k],
                    "{} {} {of} {k}: {} {}, {off:e} of {room:e}",
                    row.text("id"),
                    row.text("stratum"),
                    found[k],
                    truth[k]
                );
            }
        }
    }
}

/// The action comes back within 1e-13, in the well that was meant.
#[test]
fn starts_have_the_action() {
    let rows = duffing(STATES, 149);
    assert!(rows.len() > 50);
    for row in &rows {
        let (action, phase) = (row.hex("action"), row.hex("phase"));
        let near = Duffing::with_even_powers(row.hex("near"), row.hex("near_velocity"), force(row)).unwrap();
        let (low, high) = near.range();
        let made = Duffing::from_action_phase(action, phase, Some(0.5 * (low + high)), force(row)).unwrap();
        let off = (made.action() / action - 1.0).abs();
        assert!(off <= 1e-13, "{} {off:e}", row.text("id"));
        let (low, high) = made.range();
        let scale = low.abs().max(high.abs());
        let truth = row.truth("u0");
        let room = 16.0 * ulp(scale) + 4.0 * f64::EPSILON * row.decimal("cond_u0").abs() * action;
        assert!(
            distance(made.u0(), truth, 1.0) <= room.max(1e-13 * scale),
            "{} {}",
            row.text("id"),
            made.u0()
        );
    }
}

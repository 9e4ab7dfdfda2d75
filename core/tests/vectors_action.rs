//! Action, frequency, phase and Fourier amplitudes against the truth, and the spoiled siblings that must go red.

use crate::ruler::{Row, distance, rows, ulp};
use libration::{Frequency, Orbit};
use std::collections::BTreeMap;

const ACTION: &str = include_str!("../../reference/vectors/action.csv");

/// The promise, in ulps eased by 2^-100 of the condition.
const BOUND: f64 = 4.0;

const NAMES: [&str; 8] = [
    "action", "frequency", "phase", "amplitude_1", "amplitude_2", "amplitude_3", "amplitude_10", "distortion",
];

fn values(row: &Row) -> Vec<f64> {
    let force = Frequency::from_omega2(row.hex("omega2")).unwrap();
    let orbit = Orbit::new(row.hex("theta0"), row.hex("velocity0"), force).unwrap();
    assert_eq!(orbit.regime().name(), row.text("regime"), "{}", row.text("id"));
    let amplitudes = orbit.fourier(10).unwrap().theta;
    let mut values = vec![orbit.action(), orbit.frequency(), orbit.phase(row.hex("t"))];
    values.extend([1, 2, 3, 10].map(|j| amplitudes[j - 1]));
    values.push(orbit.distortion());
    values
}

/// Worst error of each output; `told` prints the rows beyond the bound.
fn worst(told: bool, values: impl Fn(&Row) -> Vec<f64>) -> BTreeMap<&'static str, f64> {
    let mut table: BTreeMap<&str, f64> = BTreeMap::new();
    for row in rows(ACTION, 333) {
        for (name, got) in NAMES.iter().zip(values(&row)) {
            let truth = row.truth(name);
            let size = if *name == "phase" { truth[0].abs().max(std::f64::consts::PI) } else { truth[0] };
            let ease = row.decimal(&format!("cond_{name}")) * 2f64.powi(-100);
            let error = distance(got, truth, ulp(size) + ease);
            if told && error > BOUND {
                println!("{} {} {name} {got:e} {:e} {error}", row.text("id"), row.text("stratum"), truth[0]);
            }
            let entry = table.entry(name).or_default();
            *entry = f64::max(*entry, error);
        }
    }
    println!("{table:.2?}");
    table
}

#[test]
fn every_output_keeps_its_last_digits() {
    let table = worst(true, values);
    assert_eq!(table.len(), NAMES.len());
    for (name, error) in table {
        assert!(error <= BOUND, "{name} {error}");
    }
}

#[test]
fn spoiled_outputs_are_found() {
    for (i, name) in NAMES.iter().enumerate() {
        let table = worst(false, |row| {
            let mut values = values(row);
            values[i] *= 1.0 + 2e-15;
            values
        });
        assert!(table[name] > BOUND, "{name}");
    }
}

//! Derivatives against the truth, and the spoiled sibling that must go red.

mod ruler;

use libration::{Frequency, Jacobian, Orbit, Sensitivity};
use ruler::{Row, rows};
use std::collections::BTreeMap;

const PENDULUM: &str = include_str!("../../reference/vectors/pendulum.csv");

/// The promise: of the largest change in a row.
const BOUND: f64 = 1e-12;

/// A derivative as the truth has it: a decimal that may be beyond the doubles.
fn truth(row: &Row, name: &str) -> f64 {
    row.decimal(name)
}

/// The error of a row of three, of the largest of its changes.
fn error(got: [f64; 3], truth: [f64; 3], scales: [f64; 3]) -> f64 {
    let largest = (0..3).map(|i| (truth[i] * scales[i]).abs()).fold(0.0, f64::max);
    let mut worst: f64 = 0.0;
    for i in 0..3 {
        let part = if truth[i].is_infinite() || got[i] == truth[i] {
            if got[i] == truth[i] { 0.0 } else { f64::INFINITY }
        } else {
            (got[i] - truth[i]).abs() * scales[i] / largest
        };
        worst = if part.is_nan() { f64::INFINITY } else { worst.max(part) };
    }
    worst
}

fn worst(rows: &[Row], values: impl Fn(&Orbit, f64) -> Jacobian) -> f64 {
    let mut strata: BTreeMap<&str, f64> = BTreeMap::new();
    for row in rows {
        let omega2 = row.hex("omega2");
        let (theta0, velocity0, t) = (row.hex("theta0"), row.hex("velocity0"), row.hex("t"));
        let orbit = Orbit::new(theta0, velocity0, Frequency::from_omega2(omega2).unwrap()).unwrap();
        let got = values(&orbit, t);
        let omega0 = orbit.omega0();
        let kappa = orbit.energy_ratio().sqrt();
        // The largest angle of a libration; in rotation and on the separatrix there is none, and half a turn stands for it.
        let theta_max = row.hex("theta_max_hi");
        let scales =
            [if theta_max.is_nan() { std::f64::consts::PI } else { theta_max }, 2.0 * omega0 * kappa, omega0];
        let scales = if kappa == 0.0 { [theta_max, 2.0 * omega0 * (theta_max / 2.0), omega0] } else { scales };
        let mut largest = 0.0;
        for (i, name) in ["theta", "velocity"].iter().enumerate() {
            let slope = |by: &str| truth(row, &format!("d{name}_d{by}"));
            let expected = [slope("theta0"), slope("velocity0"), 2.0 * omega0 * slope("omega2")];
            let error = error(got[i], expected, scales);
            if error > BOUND {
                println!("{} {name} {error:e} {:?} {expected:?} {scales:?}", row.text("id"), got[i]);
            }
            largest = f64::max(largest, error);
        }
        let entry = strata.entry(row.text("stratum")).or_default();
        *entry = f64::max(*entry, largest);
    }
    for (stratum, error) in &strata {
        println!("{stratum:18} {error:.2e}");
    }
    strata.into_values().fold(0.0, f64::max)
}

#[test]
fn every_derivative_keeps_its_digits() {
    let rows = rows(PENDULUM, 1998);
    let worst = worst(&rows, |orbit, t| Sensitivity::new(orbit).at(t));
    assert!(worst <= BOUND, "{worst:e}");
}

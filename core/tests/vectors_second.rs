//! Second derivatives against the truth, and the spoiled sibling that must go red.

use crate::ruler::rows;
use libration::{Frequency, Hessians, Orbit};

const SECOND: &str = include_str!("../../reference/vectors/second.csv");

/// The promise: of the largest change of a matrix.
const BOUND: f64 = 1e-12;

fn worst(values: impl Fn(&Orbit, f64) -> Hessians) -> f64 {
    let mut worst: f64 = 0.0;
    for row in rows(SECOND, 180) {
        let force = Frequency::from_omega0(row.hex("omega0")).unwrap();
        let orbit = Orbit::new(row.hex("theta0"), row.hex("velocity0"), force).unwrap();
        let got = values(&orbit, row.hex("t")).matrices();
        let kappa = orbit.energy_ratio().sqrt();
        let theta = if orbit.theta_max().is_nan() { std::f64::consts::PI } else { orbit.theta_max() };
        let scales = [theta, 2.0 * orbit.omega0() * kappa, orbit.omega0()];
        for (of, name) in ["theta", "velocity"].iter().enumerate() {
            let mut errors: f64 = 0.0;
            let mut largest: f64 = 0.0;
            for i in 0..3 {
                for j in 0..3 {
                    let truth = row.decimal(&format!("d2{name}_{}{}", i.min(j), i.max(j)));
                    let scale = scales[i] * scales[j];
                    largest = largest.max((truth * scale).abs());
                    let error = (got[of][i][j] - truth).abs() * scale;
                    errors = if error.is_nan() { f64::INFINITY } else { errors.max(error) };
                }
            }
            if errors > BOUND * largest && worst <= BOUND {
                println!("{} {name} {:e} {:?}", row.text("id"), errors / largest, got[of]);
            }
            worst = worst.max(errors / largest);
        }
    }
    println!("{worst:e}");
    worst
}

#[test]
fn every_second_derivative_keeps_its_digits() {
    assert!(worst(|orbit, t| orbit.second_sensitivities(t)) <= BOUND);
}

#[test]
fn spoiled_second_derivatives_are_found() {
    for (i, j) in [(0, 0), (1, 2), (2, 2)] {
        let spoiled = worst(|orbit, t| {
            let mut matrices = orbit.second_sensitivities(t);
            matrices.velocity[i][j] *= 1.0 + 1e-11;
            matrices.velocity[j][i] = matrices.velocity[i][j];
            matrices
        });
        assert!(spoiled > BOUND, "{i} {j}");
    }
}

#[test]
fn where_there_is_no_closed_form_there_is_no_number() {
    let at = |theta0, velocity0, omega0| {
        Orbit::new(theta0, velocity0, Frequency::from_omega0(omega0).unwrap())
            .unwrap()
            .second_sensitivities(1.0)
    };
    for matrices in
        [at(0.0, 0.0, 1.0), at(1e-6, 0.0, 1.0), at(0.0, 2.0, 1.0), at(0.0, 1.9999999, 1.0), at(1.0, 1.0, 0.0)]
    {
        assert!(matrices.matrices().iter().flatten().flatten().all(|value| value.is_nan()));
    }
}

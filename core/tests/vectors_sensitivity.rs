//! Derivatives against the truth, and the spoiled sibling that must go red.

use crate::on_every_set;
use crate::ruler::{Row, bits, rows};
use libration::{Frequency, Jacobian, Orbit, Sensitivity};
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
        let got = values(&orbit, t).rows();
        let omega0 = orbit.omega0();
        let kappa = orbit.energy_ratio().sqrt();
        // The largest angle of a libration; in rotation and on the separatrix there is none, and half a turn stands for it.
        let theta_max = row.hex("theta_max_hi");
        let scales =
            [if theta_max.is_nan() { std::f64::consts::PI } else { theta_max }, 2.0 * omega0 * kappa, omega0];
        // What underflows in kappa^2 has its scale from the angle, and rest has none: any will do.
        let scales = match (kappa == 0.0, theta_max == 0.0) {
            (true, true) => [1.0, omega0, omega0],
            (true, false) => [theta_max, omega0 * theta_max, omega0],
            _ => scales,
        };
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
    on_every_set(|set| {
        let worst = worst(&rows, |orbit, t| Sensitivity::new(orbit).at(t));
        println!("{set:?} {worst:e}");
        assert!(worst <= BOUND, "{worst:e}");
    });
}

/// One column a little off, a sign, a neglected infinity: each is found.
#[test]
fn spoiled_derivatives_are_found() {
    let rows = rows(PENDULUM, 1998);
    let spoiled = |spoil: fn(&mut Jacobian)| {
        worst(&rows, |orbit, t| {
            let mut slopes = Sensitivity::new(orbit).at(t);
            spoil(&mut slopes);
            slopes
        })
    };
    assert!(spoiled(|slopes| slopes.theta[0] *= 1.0 + 2e-12) > BOUND);
    assert!(spoiled(|slopes| slopes.velocity[2] *= 1.0 + 2e-12) > BOUND);
    assert!(spoiled(|slopes| slopes.theta[1] = -slopes.theta[1]) > BOUND);
    assert!(spoiled(|slopes| slopes.velocity[1] = slopes.velocity[1].min(f64::MAX)) > BOUND);
}

/// The flow keeps areas: the determinant by angle and velocity is 1, to 1e-13 of its two products.
#[test]
fn the_wronskian_is_one() {
    for row in rows(PENDULUM, 1998) {
        let force = Frequency::from_omega2(row.hex("omega2")).unwrap();
        let orbit = Orbit::new(row.hex("theta0"), row.hex("velocity0"), force).unwrap();
        let [[a, b, _], [c, d, _]] = Sensitivity::new(&orbit).at(row.hex("t")).rows();
        let largest = (a * d).abs() + (b * c).abs();
        if largest.is_finite() {
            assert!(
                (a * d - b * c - 1.0).abs() <= 1e-13 * largest.max(1.0),
                "{} {a} {b} {c} {d}",
                row.text("id")
            );
        }
    }
}

/// Derivatives of a motion in two parts: the product of the parts' by angle and velocity, and for omega0 what the first
/// part's end passes on.
#[test]
fn parts_compose() {
    for i in 0..2000 {
        let part = (f64::from(i) * 0.618_033_988_749_894_9).fract();
        let (theta0, velocity0) = (6.0 * part - 3.0, 3.0 * (part * 57.0).sin());
        let force = Frequency::from_omega0(1.5).unwrap();
        let orbit = Orbit::new(theta0, velocity0, force).unwrap();
        if orbit.energy_ratio_c().abs() < 0.05 {
            continue; // there the rounding of the state between weighs more than this test allows
        }
        let (first, second) = (4.0 * (part * 91.0).sin(), 3.0 * (part * 29.0).cos());
        let (theta, velocity) = orbit.motion(first);
        let early = Sensitivity::new(&orbit).at(first).rows();
        let late = Sensitivity::new(&Orbit::new(theta, velocity, force).unwrap()).at(second).rows();
        let whole = Sensitivity::new(&orbit).at(first + second).rows();
        for row in 0..2 {
            for column in 0..3 {
                let own = if column == 2 { late[row][2] } else { 0.0 };
                let composed = late[row][0] * early[0][column] + late[row][1] * early[1][column] + own;
                let largest = (late[row][0] * early[0][column]).abs()
                    + (late[row][1] * early[1][column]).abs()
                    + own.abs();
                // The state between is rounded: its second derivatives are of the size of the square of the first.
                let slack = 1e-13 * largest.max(1.0) * (1.0 + late[row][0].abs() + late[row][1].abs());
                assert!(
                    (composed - whole[row][column]).abs() <= slack,
                    "{theta0} {velocity0} {row} {column}"
                );
            }
        }
    }
}

#[test]
fn corners() {
    let at = |theta0, velocity0, omega2, t| {
        let force = Frequency::from_omega2(omega2).unwrap();
        Sensitivity::new(&Orbit::new(theta0, velocity0, force).unwrap()).at(t).rows()
    };
    let close = |got: [[f64; 3]; 2], expected: [[f64; 3]; 2]| {
        for (got, expected) in got.iter().flatten().zip(expected.iter().flatten()) {
            assert!((got - expected).abs() <= 1e-15 * expected.abs().max(1e-3), "{got} {expected}");
        }
    };
    // At rest a small change swings; upright it grows; without force it moves on.
    let (sine, cosine) = 1.4f64.sin_cos();
    close(at(0.0, 0.0, 4.0, 0.7), [[cosine, sine / 2.0, 0.0], [-2.0 * sine, cosine, 0.0]]);
    let (sinh, cosh) = (1.4f64.sinh(), 1.4f64.cosh());
    close(at(0.0, 0.0, -4.0, 0.7), [[cosh, sinh / 2.0, 0.0], [2.0 * sinh, cosh, 0.0]]);
    close(at(1.0, 2.0, 0.0, 0.7), [[1.0, 0.7, 0.0], [0.0, 1.0, 0.0]]);
    close(at(1.0, 0.0, 0.0, 0.7), [[1.0, 0.7, 0.0], [0.0, 1.0, 0.0]]);
    assert_eq!(at(2.0, 1.0, 1.0, 0.0), [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    assert_eq!(at(0.0, 0.0, -1.0, 1e4)[0][0], f64::INFINITY);
    assert_eq!(at(0.0, 2.0, 1.0, -1e4)[0][1], f64::NEG_INFINITY);
    for t in [1e20, 1e100, 1e300] {
        assert_eq!(at(0.0, 0.0, -1.0, t)[0], [f64::INFINITY, f64::INFINITY, 0.0]);
        assert_eq!(at(0.0, 2.0, 1.0, t)[0][1], f64::INFINITY);
    }
    // Past the top at 1e-300 of it: values of mpmath, in 80 digits.
    let [angle, velocity] = at(1e-300, 2.0, 1.0, 800.0);
    assert!((angle[0] / 3.408e46 - 1.0).abs() < 1e-3 && (velocity[0] / 3.408e46 - 1.0).abs() < 1e-3);
    assert_eq!([angle[1], velocity[1]], [f64::INFINITY; 2]);
    let [angle, _] = at(1e-290, 0.0, -1.0, 1_445.499_353_936_546_4);
    assert!((angle[0] / -1.38773e46 - 1.0).abs() < 1e-5 && (angle[1] / -4.62576e45 - 1.0).abs() < 1e-5);
    for t in [f64::NAN, f64::INFINITY, 1e300] {
        assert!(at(1.0, 0.0, 1.0, t).iter().flatten().all(|slope| slope.is_nan()));
    }
    // Extreme scales: the same motion in other units.
    let scaled = at(1e-300, 0.0, 1.0, 1.0);
    close(scaled, at(0.0, 0.0, 1.0, 1.0));
    let fast = at(1.0, 0.5e100, 1e200, 2e-100);
    let slow = at(1.0, 0.5, 1.0, 2.0);
    for (row, unit) in [(0, 1.0), (1, 1e100)] {
        for (column, scale) in [(0, 1.0), (1, 1e100), (2, 1e100)] {
            let ratio = fast[row][column] * scale / unit / slow[row][column];
            assert!((ratio - 1.0).abs() < 1e-13, "{row} {column} {ratio}");
        }
    }
    // Hanging from the other side at a distance from its top far below the doubles' squares.
    for slope in at(1e-200, 0.0, -1.0, 3.0).iter().flatten() {
        assert!(slope.is_finite());
    }
    assert!((at(1e-200, 0.0, -1.0, 3.0)[0][0] / 3f64.cosh() - 1.0).abs() < 1e-15);
}

/// Slices are their scalars, bit for bit, at every length and in every regime.
#[test]
fn slices_are_their_scalars() {
    let force = Frequency::from_omega0(1.3).unwrap();
    for (theta0, velocity0) in
        [(1.0, 0.2), (3.0, 0.0), (-2.0, -0.4), (0.0, 2.6), (0.5, -3.0), (0.1, 9.0), (3.1415, 0.0), (0.0, 0.0)]
    {
        let sensitivity = Sensitivity::new(&Orbit::new(theta0, velocity0, force).unwrap());
        on_every_set(|_| {
            for length in 0..40 {
                let times: Vec<f64> = (0..length).map(|i| f64::from(i) * 1.7 - 20.0).collect();
                let mut columns = vec![vec![0.0; times.len()]; 6];
                let [a, b, c, d, e, f] = &mut columns[..] else { unreachable!() };
                sensitivity.at_into(&times, [a, b, c, d, e, f]);
                for (row, t) in times.iter().enumerate() {
                    for (column, slope) in columns.iter().zip(sensitivity.at(*t).rows().as_flattened()) {
                        assert_eq!(bits(column[row]), bits(*slope), "{theta0} {velocity0} {t}");
                    }
                }
            }
        });
    }
}

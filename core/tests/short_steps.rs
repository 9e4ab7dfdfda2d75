//! Short steps, which have a series of their own: against the truth, against an orbit each in every regime and at the end of their
//! range, and there and back.

use crate::on_every_set;
use crate::own_states::{corners, orbit, states};
use crate::ruler::{distance, row_count, rows, ulp};
use libration::{Frequency, Orbit, advance, advance_into};
use std::f64::consts::PI;

const PENDULUM: &str = include_str!("../../reference/vectors/pendulum.csv");

/// The promise, in ulps of the largest angle and velocity.
const BOUND: f64 = 8.0;
/// What the steps keep to, and with what an orbit may be off.
const EXPECTED: f64 = 1.0;
const WITH_ORBIT: f64 = EXPECTED + 4.0;
/// The largest omega0 dt of a short step.
const LARGEST: f64 = 0.64;

/// Rows of theta, velocity, dt, omega0 on both sides of the end of short steps and far below.
fn steps(states: &[[f64; 3]]) -> Vec<[f64; 4]> {
    let step = |(i, [theta, velocity, omega]): (usize, &[f64; 3])| {
        let kappa = (0.5 * theta).sin().hypot(0.5 * velocity / omega).max(1.0);
        let part = ((i as f64 + 1.0) * 0.618_033_988_749_895).fract();
        let size = match i % 4 {
            0 => LARGEST * (1.0 - 1e-9 * part),
            1 => LARGEST * (1.0 + 1e-9 * part),
            2 => LARGEST * part,
            _ => LARGEST * 10f64.powf(-12.0 * part),
        };
        [*theta, *velocity, if i % 7 < 3 { -size } else { size } / (kappa * omega), *omega]
    };
    states.iter().enumerate().map(step).collect()
}

fn advanced(rows: &[[f64; 4]]) -> Vec<[f64; 2]> {
    let columns: [Vec<f64>; 4] = [0, 1, 2, 3].map(|i| rows.iter().map(|row| row[i]).collect());
    let (mut theta, mut velocity) = (vec![7.0; rows.len()], vec![7.0; rows.len()]);
    advance_into(columns.each_ref().map(Vec::as_slice), [&mut theta, &mut velocity]);
    theta.into_iter().zip(velocity).map(|(theta, velocity)| [theta, velocity]).collect()
}

/// The largest angle and velocity.
fn scales(orbit: &Orbit, omega: f64, angles: [f64; 2], velocity: f64) -> [f64; 2] {
    let reach = if orbit.theta_max().is_nan() { PI } else { orbit.theta_max() };
    let angle = angles.into_iter().fold(reach, |largest, angle| largest.max(angle.abs()));
    [angle, (2.0 * omega * orbit.energy_ratio().sqrt()).max(velocity.abs())]
}

/// The worst error of the rows of the vectors that are short steps, and how many these are.
fn worst_of_vectors(factor: f64) -> (f64, usize) {
    let (mut worst, mut count) = (0.0, 0);
    for row in rows(PENDULUM, 1998) {
        let [theta, velocity, t, omega2] = ["theta0", "velocity0", "t", "omega2"].map(|name| row.hex(name));
        let (Ok(force), omega) = (Frequency::from_omega2(omega2), omega2.sqrt()) else { continue };
        let kappa = (0.5 * theta).sin().hypot(0.5 * velocity / omega).max(1.0);
        if !(omega2 > 0.0 && (kappa * omega * t).abs() < LARGEST) {
            continue;
        }
        let (angle, speed) = advance(theta, velocity, t * factor, force);
        let (known, fast) = (row.truth("theta"), row.truth("velocity"));
        let orbit = Orbit::new(theta, velocity, force).unwrap();
        let [reach, fastest] = scales(&orbit, omega, [theta, known[0]], fast[0]);
        let errors = [distance(angle, known, ulp(reach)), distance(speed, fast, ulp(fastest))];
        if errors.iter().any(|error| *error > EXPECTED) && factor == 1.0 {
            println!("{} {errors:?}", row.text("id"));
        }
        (worst, count) = (errors.into_iter().fold(worst, f64::max), count + 1);
    }
    (worst, count)
}

#[test]
fn are_the_truth_within_an_ulp() {
    on_every_set(|set| {
        let (worst, count) = worst_of_vectors(1.0);
        println!("{set:?} {worst:.3}");
        assert!(worst <= EXPECTED && count > 90, "{set:?} {worst} {count}");
    });
    assert!(worst_of_vectors(1.0 + 1e-13).0 > BOUND);
}

/// The worst difference from an orbit each, in ulps of the largest angle and velocity; times are `factor` too long.
fn worst(rows: &[[f64; 4]], factor: f64) -> f64 {
    let moved: Vec<_> = rows.iter().map(|[a, b, dt, c]| [*a, *b, dt * factor, *c]).collect();
    let mut worst: f64 = 0.0;
    for (got, [theta, velocity, dt, omega]) in advanced(&moved).iter().zip(rows) {
        let Some(orbit) = orbit([*theta, *velocity, *omega]) else { continue };
        let known = <[f64; 2]>::from(orbit.motion(*dt));
        let scales = scales(&orbit, *omega, [*theta, known[0]], known[1]);
        for i in 0..2 {
            let error = distance(got[i], [known[i], 0.0], ulp(scales[i]));
            if error > WITH_ORBIT && factor == 1.0 {
                println!("{theta:e} {velocity:e} {dt:e} {omega:e}: {got:?} {known:?} {error}");
            }
            worst = worst.max(error);
        }
    }
    worst
}

#[test]
fn are_orbits_within_both_promises() {
    let mut rows = steps(&states(row_count(12_000)));
    let inside = |row: &&[f64; 3]| row[0].abs() < 1e200 && row[1].abs() < 1e200 * row[2] && row[2] > 1e-200;
    rows.extend(steps(&corners().iter().filter(inside).copied().collect::<Vec<_>>()));
    on_every_set(|set| {
        let found = worst(&rows, 1.0);
        println!("{set:?} {found:.3}");
        assert!(found <= WITH_ORBIT, "{set:?} {found}");
    });
    assert!(worst(&rows, 1.0 + 1e-13) > BOUND);
}

/// Nothing of the series leans to one side: there and back a state is where it was, but for rounding, and its energy too.
#[test]
fn there_and_back() {
    // A rounding of a large angle is a large change of what is left of it.
    let near = |row: &[f64; 4]| row[0].abs() < 2.0 * PI;
    for [theta0, velocity0, dt, omega] in steps(&states(600)).into_iter().filter(near) {
        let kappa = (0.5 * theta0).sin().hypot(0.5 * velocity0 / omega).max(1.0);
        let (mut theta, mut velocity) = (theta0, velocity0);
        for step in 0..200 {
            let dt = if step % 2 == 0 { dt } else { -dt };
            [[theta, velocity]] =
                <[[f64; 2]; 1]>::try_from(advanced(&[[theta, velocity, dt, omega]])).unwrap();
        }
        let gap = (theta - theta0).abs() / theta0.abs().max(PI)
            + (velocity - velocity0).abs() / (2.0 * omega * kappa);
        assert!(gap <= 200.0 * 2.0 * f64::EPSILON, "{theta0:e} {velocity0:e} {dt:e} {omega:e} {gap:e}");
    }
}

//! Columns of derivatives of states of their own, and of harmonic distortions: every row is its own value bit for bit, and
//! against an orbit each.

use crate::on_every_set;
use crate::own_states::{corners, orbit, states};
use crate::ruler::{distance, row_count, same, ulp};
use libration::pendulum::fourier::harmonic_distortion;
use libration::pendulum::{harmonic_distortion_into, sensitivities_into};
use libration::{Orbit, Sensitivity};
use std::f64::consts::PI;

/// The promise of the distortion, in ulps.
const BOUND: f64 = 4.0;

/// Rows of a time and a state.
fn timed(rows: &[[f64; 3]]) -> Vec<[f64; 4]> {
    let time = |i: usize| 25.0 * (i as f64 * 0.569_840_290_998_053).fract() - 5.0;
    let mut timed: Vec<_> =
        rows.iter().enumerate().map(|(i, row)| [time(i), row[0], row[1], row[2]]).collect();
    for t in [0.0, -0.0, 1e7, -1e13, f64::NAN, f64::INFINITY] {
        for [theta, velocity, omega] in [[1.0, 0.2, 1.0], [3.0, 0.0, 1.0], [0.5, 2.5, 1.0], [0.0, 9.0, 1.0]] {
            timed.push([t, theta, velocity, omega]);
        }
    }
    timed
}

fn slopes(rows: &[[f64; 4]]) -> Vec<[f64; 6]> {
    let columns: [Vec<f64>; 4] = [0, 1, 2, 3].map(|i| rows.iter().map(|row| row[i]).collect());
    let mut results = [(); 6].map(|()| vec![7.0; rows.len()]);
    let into = results.each_mut().map(Vec::as_mut_slice);
    sensitivities_into(columns.each_ref().map(Vec::as_slice), into);
    (0..rows.len()).map(|row| results.each_ref().map(|column| column[row])).collect()
}

#[test]
fn slopes_are_their_rows_on_every_instruction_set() {
    let mut rows = timed(&states(900));
    rows.extend(timed(&corners()));
    on_every_set(|set| {
        let single: Vec<_> = rows.iter().map(|row| slopes(&[*row])[0]).collect();
        for from in (0..40).chain([200]) {
            for (slopes, row) in slopes(&rows[from..]).iter().zip(from..) {
                let alike = slopes.iter().zip(single[row]).all(|(a, b)| same(*a, b));
                assert!(alike, "{set:?} {:?} {slopes:?} {:?}", rows[row], single[row]);
            }
        }
    });
}

/// The worst error of the derivatives against an orbit each, of the largest change in their row.
fn worst_slope(rows: &[[f64; 4]], known: &[[[f64; 3]; 2]], scales: &[[f64; 3]], spoiled: f64) -> f64 {
    let mut worst: f64 = 0.0;
    for (((got, row), known), scales) in slopes(rows).iter().zip(rows).zip(known).zip(scales) {
        for i in 0..2 {
            let largest = (0..3).map(|j| (known[i][j] * scales[j]).abs()).fold(0.0, f64::max);
            for j in 0..3 {
                let (a, b) = (got[3 * i + j] * if j == 0 { spoiled } else { 1.0 }, known[i][j]);
                let error = if same(a, b) { 0.0 } else { (a - b).abs() * scales[j] / largest };
                if (error.is_nan() || error > 1e-12) && spoiled == 1.0 {
                    println!("{row:?} {i} {j} {a:e} {b:e} {error:e}");
                }
                worst = if error.is_nan() { f64::INFINITY } else { worst.max(error) };
            }
        }
    }
    worst
}

#[test]
fn slopes_are_those_of_orbits() {
    let rows = timed(&states(row_count(2400)));
    let orbits: Vec<Orbit> = rows.iter().map(|row| orbit([row[1], row[2], row[3]]).unwrap()).collect();
    let known: Vec<_> =
        rows.iter().zip(&orbits).map(|(row, orbit)| Sensitivity::new(orbit).at(row[0]).rows()).collect();
    let scales: Vec<_> = rows
        .iter()
        .zip(&orbits)
        .map(|(row, orbit)| {
            let angle = orbit.theta_max();
            let angle = if angle.is_nan() { PI } else { angle };
            [angle, 2.0 * row[3] * orbit.energy_ratio().sqrt(), row[3]]
        })
        .collect();
    on_every_set(|set| {
        let worst = worst_slope(&rows, &known, &scales, 1.0);
        println!("{set:?} {worst:.2e}");
        assert!(worst <= 1e-12, "{set:?} {worst:e}");
    });
    assert!(worst_slope(&rows, &known, &scales, 1.0 + 1e-11) > 1e-12);
}

#[test]
fn distortions_within_the_promise() {
    let mut angles = vec![0.0, -0.0, PI, 3.2, -0.1, f64::NAN, 1e-300, 5e-324, 3.14159];
    angles.extend((0..3000).map(|i| PI * (f64::from(i) * 0.754_877_666_246_693).fract()));
    angles.extend((0..200).map(|i| 10f64.powf(-0.7 * f64::from(i))));
    let known: Vec<f64> = angles.iter().map(|angle| harmonic_distortion(*angle)).collect();
    on_every_set(|set| {
        let mut values = vec![7.0; angles.len()];
        harmonic_distortion_into(&angles, &mut values);
        let mut worst: f64 = 0.0;
        for ((value, known), angle) in values.iter().zip(&known).zip(&angles) {
            let mut single = [7.0];
            harmonic_distortion_into(&[*angle], &mut single);
            assert!(same(*value, single[0]), "{set:?} {angle}");
            worst = worst.max(distance(*value, [*known, 0.0], ulp(*known)));
            let spoiled = distance(value * (1.0 + 2e-15), [*known, 0.0], ulp(*known));
            assert!(spoiled > BOUND || known.is_nan() || *known <= 1e-300, "{angle} {value:e} {spoiled}");
        }
        println!("{set:?} distortion {worst:.2}");
        assert!(worst <= BOUND, "{set:?} {worst}");
    });
}

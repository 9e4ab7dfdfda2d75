//! Columns of states of their own: every row is its own value bit for bit, against the truth, and against an orbit each.

use crate::on_every_set;
use crate::ruler::{Row, distance, rows, same, ulp};
use libration::pendulum::{action_into, frequency_into, period_into};
use libration::{Frequency, Orbit};
use std::f64::consts::PI;

const ACTION: &str = include_str!("../../reference/vectors/action.csv");
const PENDULUM: &str = include_str!("../../reference/vectors/pendulum.csv");

/// The promise of all of them, in ulps.
const BOUND: f64 = 4.0;

type Column = fn([&[f64]; 3], &mut [f64]);

/// A function of states: its name, its column, the same of an orbit, and the least number whose ulp counts.
struct Function {
    name: &'static str,
    column: Column,
    of_orbit: fn(&Orbit) -> f64,
    floor: f64,
}

const FUNCTIONS: [Function; 3] = [
    Function { name: "frequency", column: frequency_into, of_orbit: Orbit::frequency, floor: 0.0 },
    Function { name: "period", column: period_into, of_orbit: Orbit::period, floor: 0.0 },
    Function { name: "action", column: action_into, of_orbit: Orbit::action, floor: 0.0 },
];

/// Rows of theta, velocity and omega0: of every kind and size, next to the separatrix, next to the top, after many turns.
pub fn states(count: u32) -> Vec<[f64; 3]> {
    let mut rows = Vec::new();
    for i in 0..count {
        let part = |ratio: f64| ((f64::from(i) + 1.0) * ratio).fract();
        let [a, b, c, d] =
            [0.754_877_666_246_693, 0.569_840_290_998_053, 0.618_033_988_749_895, 0.414_213_562_373_095]
                .map(part);
        let sign = if part(0.732_050_807_568_877) < 0.5 { 1.0 } else { -1.0 };
        let (theta, omega) = ((2.0 * a - 1.0) * PI, 0.3 + 2.0 * c);
        let (small, large) = (10f64.powf(-11.0 * d), 10f64.powf(8.4 * d));
        let slow = (6.0 * b - 3.0) * omega;
        let (theta, velocity) = match i % 6 {
            0 | 1 => (theta, slow),
            2 => (theta, sign * 2.0 * omega * (0.5 * theta).cos() * (1.0 + (2.0 * b - 1.0).signum() * small)),
            3 => (theta * small.powi(13), (2.0 * b - 1.0) * omega * small.powi(13)),
            4 => (theta * large, if c < 0.5 { slow } else { sign * large.powi(4) }),
            _ => (sign * (PI - small), (2.0 * b - 1.0) * omega * small),
        };
        rows.push([theta, velocity, omega]);
    }
    rows
}

/// Rows that the lanes leave out, and some at the edges of what they take.
fn corners() -> Vec<[f64; 3]> {
    let mut rows = vec![
        [f64::NAN, 1.0, 1.0],
        [1.0, f64::INFINITY, 1.0],
        [1.0, 0.0, -1.0],
        [1.0, 0.0, f64::NAN],
        [1.0, 2.0, 0.0],
        [0.0, 2.0, 1.0],
        [PI, 0.0, 1.0],
        [0.0, 0.0, 1.0],
        [-0.0, -0.0, 1.0],
        [1e300, 0.1, 1.0],
        [1e-320, 0.0, 1.0],
        [0.0, 1e200, 1.0],
        [0.3, 1e-150, 1e-150],
        [0.3, 1e150, 1e150],
    ];
    for theta in [0.0, 1.0, 2.0 * PI, -PI, 1e9, 1e-141, 1e-139] {
        for velocity in [0.0, -0.0, 1.0, -1.0, 1e-12, 2e100, -3e100] {
            rows.push([theta, velocity, 1.0]);
            rows.push([theta, velocity, 1e-100]);
            rows.push([theta, velocity, 1e100]);
        }
    }
    rows
}

fn columns(rows: &[[f64; 3]]) -> [Vec<f64>; 3] {
    [0, 1, 2].map(|i| rows.iter().map(|row| row[i]).collect())
}

fn values(column: Column, rows: &[[f64; 3]]) -> Vec<f64> {
    let states = columns(rows);
    let mut values = vec![7.0; rows.len()];
    column(states.each_ref().map(Vec::as_slice), &mut values);
    values
}

fn orbit([theta, velocity, omega0]: [f64; 3]) -> Option<Orbit> {
    Orbit::new(theta, velocity, Frequency::from_omega0(omega0).ok()?).ok()
}

#[test]
fn columns_are_their_rows_on_every_instruction_set() {
    let mut rows = corners();
    rows.extend(states(1200));
    on_every_set(|set| {
        for Function { name, column, .. } in FUNCTIONS {
            let single: Vec<f64> = rows.iter().map(|row| values(column, &[*row])[0]).collect();
            for from in (0..40).chain([200]) {
                for (value, row) in values(column, &rows[from..]).iter().zip(from..) {
                    assert!(same(*value, single[row]), "{set:?} {name} {:?}", rows[row]);
                }
            }
        }
    });
}

/// The worst distance from an orbit each, in ulps.
fn worst(function: &Function, rows: &[[f64; 3]], orbits: &[Option<Orbit>], spoiled: f64) -> f64 {
    let mut worst: f64 = 0.0;
    for ((value, state), orbit) in values(function.column, rows).iter().zip(rows).zip(orbits) {
        let known = orbit.as_ref().map_or(f64::NAN, function.of_orbit);
        let error = distance(value * spoiled, [known, 0.0], ulp(known.abs().max(function.floor)));
        if error > BOUND && spoiled == 1.0 {
            println!("{} {state:?} {value:e} {known:e} {error}", function.name);
        }
        worst = worst.max(error);
    }
    worst
}

#[test]
fn columns_are_orbits_within_the_promise() {
    let mut rows = states(12_000);
    rows.extend(corners());
    let orbits: Vec<_> = rows.iter().map(|row| orbit(*row)).collect();
    on_every_set(|set| {
        for function in &FUNCTIONS {
            let worst = worst(function, &rows, &orbits, 1.0);
            println!("{set:?} {} {worst:.2}", function.name);
            assert!(worst <= BOUND, "{set:?} {} {worst}", function.name);
        }
    });
}

#[test]
fn spoiled_columns_are_found() {
    let rows = states(600);
    let orbits: Vec<_> = rows.iter().map(|row| orbit(*row)).collect();
    for function in &FUNCTIONS {
        assert!(worst(function, &rows, &orbits, 1.0 + 2e-15) > BOUND, "{}", function.name);
    }
}

/// The rows of a file whose omega0 is a double.
fn stated(file: &'static str, count: usize, kept: usize) -> Vec<(Row<'static>, [f64; 3])> {
    let mut stated = Vec::new();
    for row in rows(file, count) {
        let (omega2, mut omega0) = (row.hex("omega2"), row.hex("omega2").max(0.0).sqrt());
        if omega0.mul_add(omega0, -omega2) != 0.0 {
            omega0 = f64::NAN;
        }
        if omega0.is_finite() {
            let state = [row.hex("theta0"), row.hex("velocity0"), omega0];
            stated.push((row, state));
        }
    }
    assert_eq!(stated.len(), kept);
    stated
}

/// The worst error of a column against its truth; the condition eases it as for an orbit.
fn worst_of_vectors(
    column: Column,
    stated: &[(Row, [f64; 3])],
    unit: impl Fn(&Row) -> f64,
    truth: impl Fn(&Row) -> [f64; 2],
    spoiled: f64,
) -> f64 {
    let states: Vec<[f64; 3]> = stated.iter().map(|(_, state)| *state).collect();
    let mut worst: f64 = 0.0;
    for ((row, _), value) in stated.iter().zip(values(column, &states)) {
        let error = distance(value * spoiled, truth(row), unit(row));
        if error > BOUND && spoiled == 1.0 {
            println!("{} {value:e} {error}", row.text("id"));
        }
        worst = worst.max(error);
    }
    worst
}

fn eased(row: &Row, name: &str) -> f64 {
    ulp(row.truth(name)[0]) + row.decimal(&format!("cond_{name}")) * 2f64.powi(-100)
}

#[test]
fn columns_against_the_truth_on_every_instruction_set() {
    let action = stated(ACTION, 333, 123);
    let pendulum = stated(PENDULUM, 1998, 754);
    for spoiled in [1.0, 1.0 + 2e-15] {
        on_every_set(|set| {
            for (name, column, stated) in [
                ("frequency", frequency_into as Column, &action),
                ("action", action_into, &action),
                ("period", period_into, &pendulum),
            ] {
                let worst =
                    worst_of_vectors(column, stated, |row| eased(row, name), |row| row.truth(name), spoiled);
                println!("{set:?} {name} {worst:.2}");
                assert_eq!(worst <= BOUND, spoiled == 1.0, "{set:?} {name} {worst}");
            }
        });
    }
}

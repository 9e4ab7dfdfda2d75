//! Columns of states of their own: every row is its own value bit for bit, against the truth, and against an orbit each.

use crate::on_every_set;
use crate::ruler::{Row, distance, row_count, rows, same, ulp};
use libration::pendulum::action::state_of;
use libration::pendulum::{
    action_into, energy_ratio_c_into, energy_ratio_into, frequency_into, period_into, phase_into,
    state_of_into,
};
use libration::{Frequency, Orbit, Regime};
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

const FUNCTIONS: [Function; 6] = [
    Function { name: "frequency", column: frequency_into, of_orbit: Orbit::frequency, floor: 0.0 },
    Function { name: "period", column: period_into, of_orbit: Orbit::period, floor: 0.0 },
    Function { name: "action", column: action_into, of_orbit: Orbit::action, floor: 0.0 },
    Function { name: "energy_ratio", column: energy_ratio_into, of_orbit: Orbit::energy_ratio, floor: 0.0 },
    Function {
        name: "energy_ratio_c",
        column: energy_ratio_c_into,
        of_orbit: Orbit::energy_ratio_c,
        floor: 0.0,
    },
    Function { name: "phase", column: phase_into, of_orbit: |orbit| orbit.phase(0.0), floor: PI },
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
pub fn corners() -> Vec<[f64; 3]> {
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

pub fn orbit([theta, velocity, omega0]: [f64; 3]) -> Option<Orbit> {
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
    let mut rows = states(row_count(12_000));
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

/// Actions, phases, directions and omega0 of states, and some that are refused or next to that.
fn actions(rows: &[[f64; 3]]) -> Vec<[f64; 4]> {
    let mut actions = Vec::new();
    for (row, orbit) in rows.iter().filter_map(|row| Some((row, orbit(*row)?))) {
        let rotation = orbit.regime() == Regime::Rotation;
        let direction = if rotation { orbit.frequency().signum() } else { 0.0 };
        actions.push([orbit.action(), orbit.phase(0.0), direction, row[2]]);
    }
    for action in [0.0, -1.0, 1e-300, 1.0, 1.273, 1.2733, 2.5464, 2.5465, 1e120, f64::NAN, f64::INFINITY] {
        for phase in [0.0, -0.0, 1.0, -4.0, 1e9, 1e15, f64::NAN] {
            for direction in [0.0, 1.0, -1.0, 0.5] {
                actions.push([action, phase, direction, 1.0]);
                actions.push([action, phase, direction, 0.0]);
            }
        }
    }
    actions
}

fn states_of(rows: &[[f64; 4]]) -> Vec<[f64; 2]> {
    let columns: [Vec<f64>; 4] = [0, 1, 2, 3].map(|i| rows.iter().map(|row| row[i]).collect());
    let (mut theta, mut velocity) = (vec![7.0; rows.len()], vec![7.0; rows.len()]);
    state_of_into(columns.each_ref().map(Vec::as_slice), [&mut theta, &mut velocity]);
    theta.into_iter().zip(velocity).map(|(theta, velocity)| [theta, velocity]).collect()
}

#[test]
fn states_of_actions_are_their_rows_on_every_instruction_set() {
    let mut rows = actions(&states(700));
    rows.extend(actions(&corners()));
    on_every_set(|set| {
        let single: Vec<_> = rows.iter().map(|row| states_of(&[*row])[0]).collect();
        for from in (0..40).chain([200]) {
            for (state, row) in states_of(&rows[from..]).iter().zip(from..) {
                let alike = same(state[0], single[row][0]) && same(state[1], single[row][1]);
                assert!(alike, "{set:?} {:?} {state:?} {:?}", rows[row], single[row]);
            }
        }
    });
}

/// The worst error of angle and velocity against one row at a time, in ulps of the largest angle and velocity and what two
/// ulps of the action make of the state.
fn worst_state(rows: &[[f64; 4]], spoiled: f64) -> f64 {
    let mut worst: f64 = 0.0;
    for (got, [action, phase, direction, omega0]) in states_of(rows).iter().zip(rows) {
        let at = |action: f64| -> [f64; 2] {
            let frequency = Frequency::from_omega0(*omega0);
            let state = frequency.and_then(|frequency| state_of(action, *phase, *direction, frequency));
            state.map_or([f64::NAN; 2], <[f64; 2]>::from)
        };
        let known = at(*action);
        let slack = [at(action * (1.0 + f64::EPSILON)), at(action * (1.0 - f64::EPSILON))];
        let largest = orbit([known[0], known[1], *omega0]).map_or([0.0; 2], |orbit| {
            let angle = orbit.theta_max();
            let angle = if angle.is_nan() { known[0].abs().max(PI) } else { angle };
            [angle, (2.0 * omega0 * orbit.energy_ratio().sqrt()).max(known[1].abs())]
        });
        for i in 0..2 {
            let moved = slack.map(|state| (state[i] - known[i]).abs()).into_iter().fold(0.0, f64::max);
            let error = distance(got[i] * spoiled, [known[i], 0.0], ulp(largest[i]) + moved);
            if error > BOUND && spoiled == 1.0 {
                println!("{action:e} {phase:e} {direction} {omega0:e} {got:?} {known:?} {error}");
            }
            worst = worst.max(error);
        }
    }
    worst
}

#[test]
fn states_of_actions_within_the_promise() {
    let rows = actions(&states(row_count(1500)));
    on_every_set(|set| {
        let worst = worst_state(&rows, 1.0);
        println!("{set:?} {worst:.2}");
        assert!(worst <= BOUND, "{set:?} {worst}");
    });
    assert!(worst_state(&rows, 1.0 + 2e-15) > BOUND);
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

/// The phase at t less frequency t: the phase at the start, where it keeps its digits, else that of the orbit.
fn phase_at_start(row: &Row) -> [f64; 2] {
    let ([phase, phase_rest], [rate, rate_rest], t) =
        (row.truth("phase"), row.truth("frequency"), row.hex("t"));
    let passed = rate * t;
    let start = phase - passed;
    if !(phase.abs() < 1e10 && passed.abs() < 1e10) || row.truth("phase")[0].is_nan() {
        let force = Frequency::from_omega2(row.hex("omega2")).unwrap();
        let orbit = Orbit::new(row.hex("theta0"), row.hex("velocity0"), force).unwrap();
        return [orbit.phase(0.0), 0.0];
    }
    // Exact as a sum of doubles: the difference of the leads, and what it and the product left.
    let back = start - phase;
    let left = (phase - (start - back)) - (passed + back);
    [start, left + (phase_rest - rate.mul_add(t, -passed) - rate_rest * t)]
}

fn phase_unit(row: &Row) -> f64 {
    ulp(phase_at_start(row)[0].abs().max(PI)) + row.decimal("cond_phase") * 2f64.powi(-100)
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
                ("energy_ratio", energy_ratio_into, &pendulum),
                ("energy_ratio_c", energy_ratio_c_into, &pendulum),
                ("phase", phase_into, &action),
            ] {
                let truth = |row: &Row| row.truth(name);
                let worst = match name {
                    "phase" => worst_of_vectors(column, stated, phase_unit, phase_at_start, spoiled),
                    // What is left of the energy has its digits whatever the condition.
                    "energy_ratio" | "energy_ratio_c" => {
                        worst_of_vectors(column, stated, |row| ulp(truth(row)[0]), truth, spoiled)
                    }
                    _ => worst_of_vectors(column, stated, |row| eased(row, name), truth, spoiled),
                };
                println!("{set:?} {name} {worst:.2}");
                assert_eq!(worst <= BOUND, spoiled == 1.0, "{set:?} {name} {worst}");
            }
        });
    }
}

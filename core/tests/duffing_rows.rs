//! Columns of Duffing motions, each of its own start and coefficients: every row is its own value bit for bit, and within the
//! promise of an orbit each, in every regime.

use crate::on_every_set;
use crate::oscillator::{Spread, rows_keep_their_promise};
use crate::ruler::same;
use libration::Duffing;
use libration::oscillator::duffing_motion_into;

/// Rows of t, u0, velocity0, p, q of every kind, from within half a unit of each regime to next to its edges.
fn mixed(count: usize) -> Vec<[f64; 5]> {
    let mut spread = Spread(16);
    let mut rows = Vec::new();
    for i in 0..count {
        let mut between = |low: f64, high: f64| spread.between(low, high);
        let [t, u, v, p, q] = [100.0, 3.0, 3.0, 3.0, 3.0].map(|end| between(-end, end));
        let (size, part) = (10f64.powf(between(-12.0, 0.0)), between(-1.0, 1.0));
        let sign = 1f64.copysign(between(-1.0, 1.0));
        let (hard, soft) = (p.abs() + 0.01, -q.abs() - 0.01);
        let top = (hard / -soft).sqrt();
        rows.push(match i % 12 {
            0 => [t, u, v, p, q],
            1 => [100.0 * t, u, v, hard, q.abs()],
            2 => [t, top * part, part * hard * top * 0.5, hard, soft],
            3 => [t, u, 0.3 * v, -hard, -soft],
            4 => [t, top * (1.0 + part * size), v * size, -hard, -soft],
            5 => [t, size * u, size * v, hard, q],
            // Next to a separatrix: over the top of the barrier, and through the top between the wells.
            6 => {
                let speed = hard * (1.0 - part * part) * top / 2f64.sqrt();
                [
                    0.1 * t,
                    top * part,
                    sign * speed * hard.sqrt() * (1.0 + part * size) / hard.sqrt(),
                    hard,
                    soft,
                ]
            }
            7 => [
                0.1 * t,
                top * part,
                sign * top * part * (hard * (1.0 - 0.5 * part * part)).sqrt(),
                -hard,
                -soft,
            ],
            8 => [0.02 * t, u, v, p, soft],
            9 => [0.02 * t, 2.0 * top * (1.1 + part.abs()), 0.0, p, soft],
            10 => [t, u, v, 0.0, q],
            _ => [t, u, v, hard, if part < 0.0 { 0.0 } else { q * 1e-13 }],
        });
        // Other units of length and time.
        if i % 5 == 0 {
            let (length, rate) = (10f64.powf(between(-8.0, 8.0)), 10f64.powf(between(-8.0, 8.0)));
            let row = rows.last_mut().unwrap();
            let units = [1.0 / rate, length, length * rate, rate * rate, (rate / length) * (rate / length)];
            for (value, unit) in row.iter_mut().zip(units) {
                *value *= unit;
            }
        }
    }
    rows
}

/// Rows that the lanes leave out, and some at the edges of what they take.
fn corners() -> Vec<[f64; 5]> {
    let mut rows = Vec::new();
    let ends = [0.0, -0.0, 1.0, -1.0, 5e-324, 1e-310, 1e-170, 1e-31, 1e-29, 1e29, 1e31, -1e170, 1e300];
    for (i, a) in ends.into_iter().enumerate() {
        for (j, b) in ends.into_iter().enumerate() {
            let t = [0.7, 0.0, -3.0, 1e-300, 1e5][(i + 2 * j) % 5];
            rows.extend([[t, a, b, 1.0, 1.0], [t, a, 0.3, b, 1.0], [t, a, 0.5, 1.0, b], [t, 0.5, 0.2, a, b]]);
        }
    }
    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for start in [
            [1.0, 0.5, 1.0, 1.0],
            [1.0, 0.5, 1.0, -2.0],
            [0.0; 4],
            [0.0, 0.0, 1.0, 1.0],
            [1.0, 0.0, -1.0, 1.0],
        ] {
            for k in 0..5 {
                let mut row = [0.4, start[0], start[1], start[2], start[3]];
                row[k] = wrong;
                rows.push(row);
            }
        }
    }
    // On a separatrix, at an equilibrium, beyond the last half period, and next to escapes on both sides.
    rows.extend([
        [1.0, -2.0, 0.0, -2.0, 1.0],
        [1.0, 0.0, 1.0, 2.0, -2.0],
        [1.0, 1.0, -1.0, -0.5, -1.0],
        [1.0, 2.0, 0.0, 4.0, -1.0],
        [1e17, 1.0, 0.0, 1.0, 1.0],
        [-1e13, 1.0, 0.0, 1.0, 1.0],
    ]);
    for start in
        [[2.0, 0.0, 1.0, -1.0], [0.1, 1.0, -1.0, -1.0], [-0.3, 2.0, 1.0, -1.0], [3.0, -1.0, 1.0, -2.0]]
    {
        let [u0, velocity0, p, q] = start;
        let orbit = Duffing::new(u0, velocity0, p, q).unwrap();
        for end in [orbit.escape_time(), orbit.escape_time_backward()] {
            for part in [-1e-2, -1e-6, -1e-12, -1e-15, 0.0, 1e-15, 1e-12, 1e-6, 1e-2, 0.5, 1.0, 3.0, 1e300] {
                rows.push([end * (1.0 + part), u0, velocity0, p, q]);
            }
        }
    }
    rows
}

fn motions(rows: &[[f64; 5]]) -> [Vec<f64>; 2] {
    let columns = [0, 1, 2, 3, 4].map(|i| rows.iter().map(|row| row[i]).collect::<Vec<f64>>());
    let (mut u, mut velocity) = (vec![7.0; rows.len()], vec![7.0; rows.len()]);
    duffing_motion_into(columns.each_ref().map(Vec::as_slice), [&mut u, &mut velocity]);
    [u, velocity]
}

fn orbit([_, u0, velocity0, p, q]: [f64; 5]) -> Option<Duffing> {
    Duffing::new(u0, velocity0, p, q).ok()
}

#[test]
fn columns_are_their_rows_on_every_instruction_set() {
    let mut rows = corners();
    rows.extend(mixed(2000));
    // A block of one start, which is set up once.
    rows.extend((0..600).map(|i| [0.37 * f64::from(i), 1.2, 0.3, -1.0, 1.0]));
    rows.extend((0..600).map(|i| [0.01 * f64::from(i), -1.2, 0.3, 1.0, -1.5]));
    on_every_set(|set| {
        let single: Vec<[f64; 2]> = rows.iter().map(|row| motions(&[*row]).map(|column| column[0])).collect();
        for from in (0..40).chain([200, rows.len() - 1200, rows.len() - 600]) {
            let [u, velocity] = motions(&rows[from..]);
            for (i, row) in rows[from..].iter().enumerate() {
                let known = single[from + i];
                assert!(same(u[i], known[0]) && same(velocity[i], known[1]), "{set:?} {row:?}");
            }
        }
    });
}

/// Largest |u| and |u'| of a bounded orbit; of the start and now else. Its greatest speed is at the bottom of a well or at 0.
fn scales(orbit: &Duffing, u: f64, velocity: f64) -> [f64; 2] {
    let (low, high) = orbit.range();
    let (u0, velocity0, p, q) = (orbit.u0(), orbit.velocity0(), orbit.p(), orbit.q());
    if low.is_infinite() || high.is_infinite() {
        return [u.abs().max(u0.abs()), velocity.abs().max(velocity0.abs())];
    }
    let square = if p < 0.0 && q > 0.0 {
        ((p + q * u0 * u0).powi(2) + 2.0 * q * velocity0 * velocity0) / (2.0 * q)
    } else {
        velocity0 * velocity0 + u0 * u0 * (p + 0.5 * q * u0 * u0)
    };
    [low.abs().max(high.abs()), square.sqrt().max(velocity0.abs())]
}

#[test]
fn rows_are_within_the_promise_of_an_orbit_each() {
    rows_keep_their_promise(&mixed(12_000), motions, orbit, scales);
}

/// The start as given, what is not a number, and the ends of the range as an orbit answers them.
#[test]
fn corners_are_those_of_an_orbit() {
    let rows = corners();
    let [u, velocity] = motions(&rows);
    let mut left_out = 0;
    for (i, row) in rows.iter().enumerate() {
        let known = orbit(*row).map_or((f64::NAN, f64::NAN), |orbit| orbit.motion(row[0]));
        let ordinary = row[1..].iter().all(|value| *value == 0.0 || (1e-30..1e30).contains(&value.abs()));
        if !ordinary || known.0.is_nan() || row[0] == 0.0 {
            assert!(same(u[i] + 0.0, known.0 + 0.0) && same(velocity[i] + 0.0, known.1 + 0.0), "{row:?}");
            left_out += 1;
        } else {
            assert!(u[i].is_finite() == known.0.is_finite(), "{row:?} {} {known:?}", u[i]);
        }
    }
    assert!(left_out > 300, "{left_out}");
    assert_eq!([u[0], velocity[0]].map(f64::is_nan), [false; 2]);
}

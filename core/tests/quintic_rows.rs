//! Columns of cubic-quintic motions, each of its own start and coefficients: every row is its own value bit for bit, and within the
//! promise of an orbit each, in every regime.

use crate::on_every_set;
use crate::oscillator::{Spread, rows_keep_their_promise};
use crate::ruler::same;
use libration::CubicQuintic;
use libration::oscillator::cubic_quintic_rows_into;

/// Rows of t, u0, velocity0, p, q, s of every kind, from the middle of each regime to next to its edges.
fn mixed(count: usize) -> Vec<[f64; 6]> {
    let mut spread = Spread(23);
    let mut rows = Vec::new();
    for i in 0..count {
        let mut between = |low: f64, high: f64| spread.between(low, high);
        let [t, u, v, p, q, s] = [100.0, 3.0, 3.0, 3.0, 3.0, 3.0].map(|end| between(-end, end));
        let (size, part) = (10f64.powf(between(-8.0, 0.0)), between(-1.0, 1.0));
        let [stiff, soft, hard] = [p, q, s].map(|value| value.abs() + 0.01);
        let mut row = match i % 16 {
            0 => [t, u, v, p, q, hard],
            1 => [100.0 * t, u, v, stiff, soft, hard],
            // In a well about 0, beside it and over the barriers.
            2 => [t, u, 0.3 * v, stiff, -2.5 * soft, hard],
            3 => [t, 0.5 * u, 0.1 * v, -stiff, q, hard],
            4 => [t, u, 0.0, p, q, hard],
            5 => [t, 0.0, v, p, q, hard],
            // Small swings, about 0 and about another place.
            6 => [t, size * u, size * v, stiff, q, s],
            7 => {
                let place = ((q * q + 4.0 * stiff * hard).sqrt() - q) / (2.0 * hard);
                [t, place.sqrt() * (1.0 + 1e-4 * part * size.sqrt()), size * v, -stiff, q, hard]
            }
            // In a well that motions escape from, and escapes.
            8 => [t, 0.2 * u, 0.2 * v, 1.0 + stiff, q, -0.1 * hard],
            9 => [t, u, v, -stiff, 3.0 * soft, -0.1 * hard],
            10 => [0.01 * t, u, v, p, q, -hard],
            // Over the saddle next to 0, and with nearly no quintic force or none, and with nothing else.
            11 => [0.1 * t, size * part, v * size, -stiff, q, hard],
            12 => [t, u, v, stiff, soft, 1e-9 * s],
            13 => [t, u, v, p, soft, 0.0],
            14 => [t, u, v, 0.0, 0.0, hard],
            _ => [t, u, v, stiff, size * q, size * s],
        };
        // Other units of length and time.
        if i % 5 == 0 {
            let (length, rate) = (10f64.powf(between(-12.0, 12.0)), 10f64.powf(between(-9.0, 9.0)));
            let (square, area) = (rate * rate, length * length);
            let units = [1.0 / rate, length, length * rate, square, square / area, square / (area * area)];
            for (value, unit) in row.iter_mut().zip(units) {
                *value *= unit;
            }
        }
        rows.push(row);
    }
    rows
}

fn motions(rows: &[[f64; 6]]) -> [Vec<f64>; 2] {
    let columns = [0, 1, 2, 3, 4, 5].map(|i| rows.iter().map(|row| row[i]).collect::<Vec<f64>>());
    let (mut u, mut velocity) = (vec![7.0; rows.len()], vec![7.0; rows.len()]);
    cubic_quintic_rows_into(columns.each_ref().map(Vec::as_slice), [&mut u, &mut velocity]);
    [u, velocity]
}

fn orbit([_, u0, velocity0, p, q, s]: [f64; 6]) -> Option<CubicQuintic> {
    CubicQuintic::new(u0, velocity0, p, q, s).ok()
}

#[test]
fn columns_are_their_rows_on_every_instruction_set() {
    let mut rows = mixed(1500);
    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -0.0, 5e-324, 1e-200, 1e200] {
        for k in 0..6 {
            let mut row = [0.4, 1.0, 0.3, 1.0, 0.2, 0.5];
            row[k] = wrong;
            rows.push(row);
        }
    }
    // Blocks of one start, which are set up once.
    rows.extend((0..600).map(|i| [0.37 * f64::from(i), 1.2, 0.3, -1.0, 1.0, 0.1]));
    rows.extend((0..600).map(|i| [0.37 * f64::from(i), 1.2, 0.3, 1.0, 1.0, 0.1]));
    on_every_set(|set| {
        let single: Vec<[f64; 2]> = rows.iter().map(|row| motions(&[*row]).map(|column| column[0])).collect();
        for from in (0..20).chain([200, 1500, rows.len() - 1200, rows.len() - 600]) {
            let [u, velocity] = motions(&rows[from..]);
            for (i, row) in rows[from..].iter().enumerate() {
                let known = single[from + i];
                assert!(same(u[i], known[0]) && same(velocity[i], known[1]), "{set:?} {row:?}");
            }
        }
    });
}

/// Largest |u| of a bounded orbit, of the start and now else; and the greatest speed between the ends, or now and at the start.
fn scales(orbit: &CubicQuintic, u: f64, velocity: f64) -> [f64; 2] {
    let (low, high) = orbit.range();
    let own = [u.abs().max(orbit.u0().abs()), velocity.abs().max(orbit.velocity0().abs())];
    if low.is_infinite() || high.is_infinite() {
        return own;
    }
    let [p, q, s] = [orbit.p(), orbit.q(), orbit.s()];
    let potential = |x: f64| x * x * (p / 2.0 + x * x * (q / 4.0 + x * x * s / 6.0));
    let least = (0..=64).map(|k| potential(low + (high - low) * f64::from(k) / 64.0));
    let fall = potential(high) - least.fold(f64::INFINITY, f64::min);
    [own[0].max(low.abs()).max(high.abs()), own[1].max((2.0 * fall).max(0.0).sqrt())]
}

#[test]
fn rows_are_within_the_promise_of_an_orbit_each() {
    rows_keep_their_promise(&mixed(8000), motions, orbit, scales);
}

//! Columns of Duffing motions with even powers, each of its own start and coefficients: every row is its own value bit for bit, and
//! within the promise of an orbit each, in every regime.

use crate::on_every_set;
use crate::oscillator::{Spread, rows_keep_their_promise};
use crate::ruler::same;
use libration::Duffing;
use libration::oscillator::duffing_rows_into;

/// Rows of t, u0, velocity0, p, q, r, c of every kind, from the middle of each regime to next to its edges.
fn mixed(count: usize) -> Vec<[f64; 7]> {
    let mut spread = Spread(19);
    let mut rows = Vec::new();
    for i in 0..count {
        let mut between = |low: f64, high: f64| spread.between(low, high);
        let [t, u, v, p, q, r, c] = [100.0, 3.0, 3.0, 3.0, 3.0, 1.0, 1.0].map(|end| between(-end, end));
        let (size, part) = (10f64.powf(between(-8.0, 0.0)), between(-1.0, 1.0));
        let (hard, stiff) = (q.abs() + 0.01, p.abs() + 0.01);
        let mut row = match i % 12 {
            0 => [t, u, v, p, hard, r, c],
            1 => [100.0 * t, u, v, stiff, hard, r, 0.0],
            2 => [t, u, 0.3 * v, -stiff, hard, 0.1 * r, 0.1 * c],
            3 => [t, u, v, p, hard, size * r, size * c],
            // Small swings about 0.
            4 => [t, size * u, size * v, stiff, q, r, 0.0],
            // In a well that motions escape from.
            5 => [t, 0.2 * u, 0.1 * v, 2.0 + stiff, -hard, r, 0.1 * c],
            6 => [t, 0.2 * u, 0.1 * v, 2.0 + stiff, 0.0, r, 0.1 * c],
            // Released at rest.
            7 => [t, u, 0.0, p, hard, r, c],
            // Over the saddle next to 0, and next to it.
            8 => [0.1 * t, size * part, v * size, -stiff, hard, 0.1 * r, 0.0],
            // Escapes.
            9 => [0.01 * t, u, v, p, -hard, r, c],
            10 => [0.01 * t, u, v, p, 0.0, r, c],
            _ => [t, u, v, stiff, 1e-9 * hard, r * 1e-3, c],
        };
        // Other units of length and time.
        if i % 5 == 0 {
            let (length, rate) = (10f64.powf(between(-6.0, 6.0)), 10f64.powf(between(-6.0, 6.0)));
            let square = rate * rate;
            let units =
                [1.0 / rate, length, length * rate, square, square / (length * length), square / length];
            for (value, unit) in row.iter_mut().zip(units.into_iter().chain([square * length])) {
                *value *= unit;
            }
        }
        rows.push(row);
    }
    rows
}

fn motions(rows: &[[f64; 7]]) -> [Vec<f64>; 2] {
    let columns = [0, 1, 2, 3, 4, 5, 6].map(|i| rows.iter().map(|row| row[i]).collect::<Vec<f64>>());
    let (mut u, mut velocity) = (vec![7.0; rows.len()], vec![7.0; rows.len()]);
    duffing_rows_into(columns.each_ref().map(Vec::as_slice), [&mut u, &mut velocity]);
    [u, velocity]
}

fn orbit([_, u0, velocity0, force @ ..]: [f64; 7]) -> Option<Duffing> {
    Duffing::with_even_powers(u0, velocity0, force).ok()
}

#[test]
fn columns_are_their_rows_on_every_instruction_set() {
    let mut rows = mixed(1500);
    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -0.0, 5e-324, 1e-200, 1e200] {
        for k in 0..7 {
            let mut row = [0.4, 1.0, 0.3, 1.0, 0.2, 0.5, 0.1];
            row[k] = wrong;
            rows.push(row);
        }
    }
    // Blocks of one start, which are set up once; and rows without even powers between those with them.
    rows.extend((0..600).map(|i| [0.37 * f64::from(i), 1.2, 0.3, -1.0, 1.0, 0.1, 0.0]));
    rows.extend((0..600).map(|i| [0.37 * f64::from(i), 1.2, 0.3, 1.0, 1.0, 0.1, 0.2]));
    rows.extend((0..60).map(|i| [0.37 * f64::from(i), 1.2, 0.3, -1.0, 1.0, f64::from(i / 3 % 2), 0.0]));
    on_every_set(|set| {
        let single: Vec<[f64; 2]> = rows.iter().map(|row| motions(&[*row]).map(|column| column[0])).collect();
        for from in (0..20).chain([200, 1500, rows.len() - 1260, rows.len() - 660, rows.len() - 60]) {
            let [u, velocity] = motions(&rows[from..]);
            for (i, row) in rows[from..].iter().enumerate() {
                let known = single[from + i];
                assert!(same(u[i], known[0]) && same(velocity[i], known[1]), "{set:?} {row:?}");
            }
        }
    });
}

/// Largest |u| of a bounded orbit, of the start and now else; and the greatest speed between the ends, or now and at the start.
fn scales(orbit: &Duffing, u: f64, velocity: f64) -> [f64; 2] {
    let (low, high) = orbit.range();
    let own = [u.abs().max(orbit.u0().abs()), velocity.abs().max(orbit.velocity0().abs())];
    if low.is_infinite() || high.is_infinite() {
        return own;
    }
    let [p, q, r, c] = orbit.coefficients();
    let potential = |x: f64| x * (x * (p / 2.0 + x * (r / 3.0 + x * q / 4.0)) - c);
    let least = (0..=64).map(|k| potential(low + (high - low) * f64::from(k) / 64.0));
    let fall = potential(high) - least.fold(f64::INFINITY, f64::min);
    [own[0].max(low.abs()).max(high.abs()), own[1].max((2.0 * fall).max(0.0).sqrt())]
}

#[test]
fn rows_are_within_the_promise_of_an_orbit_each() {
    rows_keep_their_promise(&mixed(6000), motions, orbit, scales);
}

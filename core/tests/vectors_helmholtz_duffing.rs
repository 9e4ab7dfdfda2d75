//! The Duffing oscillator with even powers against the truth, stratum by stratum, and the spoiled siblings that must go red.

use crate::on_every_set;
use crate::ruler::{Row, distance, rows, summary, ulp};
use libration::Duffing;
use libration::oscillator::duffing_rows_into;
use std::collections::BTreeMap;

const VECTORS: &str = include_str!("../../reference/vectors/helmholtz_duffing.csv");
const ROWS: usize = 1929;
const STRATA: usize = 46;
const NAMES: [&str; 8] = ["u", "velocity", "period", "low", "high", "energy", "escape", "escape_backward"];

/// 2^-100 of a condition.
fn eased(row: &Row, name: &str) -> f64 {
    row.decimal(&format!("cond_{name}")) * 2f64.powi(-100)
}

fn orbit(row: &Row) -> Duffing {
    let [u0, velocity0, p, q, r, c] = ["u0", "velocity0", "p", "q", "r", "c"].map(|name| row.hex(name));
    Duffing::with_even_powers(u0, velocity0, [p, q, r, c]).unwrap()
}

/// In ulps of the scale and what 2^-100 of the condition adds; escapes in units of 1e-14/4.
fn errors(row: &Row, orbit: &Duffing, (u, velocity): (f64, f64)) -> [f64; 8] {
    let of = |name: &str, got: f64, unit: f64| {
        let truth = row.truth(name);
        let unit = if truth[0].is_finite() { unit + eased(row, name) } else { 1.0 };
        distance(got, truth, unit)
    };
    let own = |name: &str| ulp(row.truth(name)[0]);
    let (low, high) = orbit.range();
    let escape = |name: &str| 2.5e-15 * row.truth(name)[0].abs();
    [
        of("u", u, ulp(row.decimal("scale_u"))),
        of("velocity", velocity, ulp(row.decimal("scale_velocity"))),
        of("period", orbit.period(), own("period")),
        of("low", low, own("low")),
        of("high", high, own("high")),
        of("energy", orbit.energy(), own("energy")),
        of("escape", orbit.escape_time(), escape("escape")),
        of("escape_backward", orbit.escape_time_backward(), escape("escape_backward")),
    ]
}

/// Whether all rows keep what is promised: at most 4, half of them at most 0.5 in every stratum, and no wrong regime.
fn holds(rows: &[Row], motion: impl Fn(&Duffing, f64) -> (f64, f64)) -> bool {
    let mut strata: BTreeMap<&str, [Vec<f64>; 8]> = BTreeMap::new();
    let mut good = true;
    for row in rows {
        let orbit = orbit(row);
        if orbit.regime().name() != row.text("regime") {
            println!("regime of {} is {}, not {}", row.text("id"), orbit.regime().name(), row.text("regime"));
            good = false;
        }
        let found = errors(row, &orbit, motion(&orbit, row.hex("t")));
        if found.iter().any(|error| *error > 4.0) {
            println!("{} {} {found:?}", row.text("id"), row.text("stratum"));
            good = false;
        }
        for (list, error) in strata.entry(row.text("stratum")).or_default().iter_mut().zip(found) {
            list.push(error);
        }
    }
    assert_eq!(strata.len(), STRATA);
    for (stratum, lists) in &mut strata {
        print!("{stratum:28} {:4}", lists[0].len());
        for (list, name) in lists.iter_mut().zip(NAMES) {
            let (largest, middle) = summary(list);
            print!("  {name} {largest:6.3}");
            good &= middle <= 0.5;
        }
        println!();
    }
    good
}

#[test]
fn every_stratum_keeps_its_last_digits() {
    let rows = rows(VECTORS, ROWS);
    on_every_set(|set| assert!(holds(&rows, |orbit, t| orbit.motion(t)), "{set:?}"));
}

/// One row by the formula of rows with states of their own.
fn row_alone(orbit: &Duffing, t: f64) -> (f64, f64) {
    let [p, q, r, c] = orbit.coefficients();
    let row = [t, orbit.u0(), orbit.velocity0(), p, q, r, c];
    let (mut u, mut velocity) = ([7.0], [7.0]);
    duffing_rows_into(row.each_ref().map(std::slice::from_ref), [&mut u, &mut velocity]);
    (u[0], velocity[0])
}

#[test]
fn rows_of_their_own_keep_their_last_digits() {
    let rows = rows(VECTORS, ROWS);
    on_every_set(|set| assert!(holds(&rows, row_alone), "{set:?}"));
}

/// Columns and one value agree bit for bit, of an orbit and of rows of their own.
#[test]
fn columns_are_their_values() {
    let rows = rows(VECTORS, ROWS);
    let columns = ["t", "u0", "velocity0", "p", "q", "r", "c"]
        .map(|name| rows.iter().map(|row| row.hex(name)).collect::<Vec<f64>>());
    let (mut u, mut velocity) = (vec![7.0; rows.len()], vec![7.0; rows.len()]);
    duffing_rows_into(columns.each_ref().map(Vec::as_slice), [&mut u, &mut velocity]);
    let same = |a: f64, b: f64| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
    for (i, row) in rows.iter().enumerate() {
        let (orbit, t) = (orbit(row), row.hex("t"));
        let alone = row_alone(&orbit, t);
        assert!(same(alone.0, u[i]) && same(alone.1, velocity[i]), "{}", row.text("id"));
        let times = [0.3 * t, t, -t, t];
        let (mut all, mut speeds) = ([0.0; 4], [0.0; 4]);
        orbit.motion_into(&times, &mut all, &mut speeds);
        assert!(same(speeds[1], orbit.velocity(t)), "{}", row.text("id"));
        assert!(times.iter().zip(all).all(|(t, u)| same(orbit.u(*t), u)), "{}", row.text("id"));
    }
}

/// The motion passes what it is at every time.
#[test]
fn passages_come_back() {
    for row in rows(VECTORS, ROWS).iter().filter(|row| row.text("stratum") != "scales") {
        let (orbit, t) = (orbit(row), row.hex("t"));
        let u = orbit.u(t);
        let (low, high) = orbit.range();
        let room = 1e-6 * (high - low).min(u.abs());
        if !u.is_finite() || t.abs() > 1e6 || orbit.period() == 0.0 || u < low + room || u > high - room {
            continue;
        }
        let near = 1e-3 * t.abs() + 1e-9;
        let times = orbit.times(u, t - near, t + near).unwrap();
        let speed = orbit.velocity(t).abs();
        let scale = if low.is_finite() && high.is_finite() {
            high.abs().max(low.abs())
        } else {
            u.abs().max(orbit.u0().abs())
        };
        let allowed = 1e-14 * t.abs() + 16.0 * ulp(scale) / speed;
        let regime = orbit.regime().name();
        if regime == "rest" || allowed >= 1e-4 * near {
            continue;
        }
        let best = times.iter().map(|found| (found - t).abs()).fold(f64::INFINITY, f64::min);
        assert!(best <= allowed, "{} {regime} {best:e} {allowed:e} {times:?} {t}", row.text("id"));
    }
}

/// Siblings that spoil the function: each must go red.
#[test]
fn spoiled_siblings_are_found() {
    let rows = rows(VECTORS, ROWS);
    let scaled = 1.0 + 5.0 * f64::EPSILON;
    assert!(!holds(&rows, |orbit, t| (orbit.u(t) * scaled, orbit.velocity(t))));
    assert!(!holds(&rows, |orbit, t| (orbit.u(t), -orbit.velocity(t))));
    assert!(!holds(&rows, |orbit, t| {
        let (u, velocity) = orbit.motion(t);
        if u.is_nan() { (f64::INFINITY, velocity) } else { (u, velocity) }
    }));
}

/// The figures of a biased spring with decimal coefficients.
#[test]
fn figures() {
    let spring = Duffing::with_even_powers(1.0, 0.0, [1.0, 0.2, 0.5, 0.0]).unwrap();
    let near = |got: f64, told: f64| assert!((got - told).abs() <= 4.0 * ulp(told), "{got} {told}");
    near(spring.u(1.0), 0.300_026_788_580_601_175_4);
    near(spring.velocity(1.0), -1.154_774_678_854_871_208_6);
    near(spring.period(), 6.262_978_465_688_423_642_6);
    near(spring.range().0, -1.401_980_261_768_904_949_8);
    let plain = Duffing::new(1.0, 0.0, 1.0, 1.0).unwrap();
    near(plain.action(), 0.636_921_769_130_583_572_15);
    let series = plain.fourier(3).unwrap().u;
    near(series[0], 0.981_710_616_281_666_130_84);
    near(series[2], 0.017_960_677_962_689_629_434);
    for (u0, period) in
        [(0.5, 6.225_139_992_418_638_458), (1.0, 6.060_656_736_957_466_768), (2.0, 5.516_851_888_104_294_22)]
    {
        near(Duffing::new(u0, 0.0, 1.0, 0.1).unwrap().period(), period);
    }
}

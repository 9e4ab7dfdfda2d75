//! The cubic-quintic oscillator against the truth, stratum by stratum, and the spoiled siblings that must go red.

use crate::on_every_set;
use crate::ruler::{Row, distance, rows, summary, ulp};
use libration::CubicQuintic;
use libration::oscillator::cubic_quintic_rows_into;
use std::collections::BTreeMap;

const VECTORS: &str = include_str!("../../reference/vectors/cubic_quintic.csv");
const COUNT: usize = 784;
const NAMES: [&str; 8] = ["u", "velocity", "period", "low", "high", "energy", "escape", "escape_backward"];

fn orbit(row: &Row) -> CubicQuintic {
    let [u0, velocity0, alpha, beta, gamma] =
        ["u0", "velocity0", "alpha", "beta", "gamma"].map(|name| row.hex(name));
    CubicQuintic::new(u0, velocity0, alpha, beta, gamma).unwrap()
}

/// What an orbit answers, in the order of the names.
fn answers(orbit: &CubicQuintic, t: f64) -> [f64; 8] {
    let (u, velocity) = orbit.motion(t);
    let (low, high) = orbit.range();
    let escapes = [orbit.escape_time(), orbit.escape_time_backward()];
    [u, velocity, orbit.period(), low, high, orbit.energy(), escapes[0], escapes[1]]
}

/// What spoils the answers of an orbit at a time.
type Spoil<'a> = dyn Fn(&CubicQuintic, f64, [f64; 8]) -> [f64; 8] + 'a;

/// Worst errors by stratum and name, in units of what is promised for each; and how many regimes are wrong.
fn report(
    rows: &[Row],
    answers: impl Fn(&CubicQuintic, f64) -> [f64; 8],
) -> (BTreeMap<String, [Vec<f64>; 8]>, usize) {
    let mut strata: BTreeMap<String, [Vec<f64>; 8]> = BTreeMap::new();
    let mut wrong = 0;
    for row in rows {
        let orbit = orbit(row);
        if orbit.regime().name() != row.text("regime") {
            wrong += 1;
            println!("regime of {} is {}", row.text("id"), orbit.regime().name());
        }
        let got = answers(&orbit, row.hex("t"));
        let lists = strata.entry(row.text("stratum").to_string()).or_default();
        for ((name, got), list) in NAMES.iter().zip(got).zip(lists) {
            let truth = row.truth(name);
            let ease = |column: &str| row.decimal(column) * 2f64.powi(-100);
            let unit = match *name {
                "u" => ulp(row.decimal("scale_u")) + ease("cond_u"),
                "velocity" => ulp(row.decimal("scale_velocity")) + ease("cond_velocity"),
                "period" => ulp(truth[0]) + ease("cond_period"),
                "escape" => ulp(truth[0]) + ease("cond_escape"),
                "escape_backward" => ulp(truth[0]) + ease("cond_escape_backward"),
                _ => ulp(truth[0]),
            };
            let error = distance(got, truth, unit);
            if error > 4.0 {
                println!(
                    "{} {} {name} {got:e} {truth:?} {error:.3e} {}",
                    row.text("id"),
                    row.text("stratum"),
                    row.text("regime")
                );
            }
            list.push(error);
        }
    }
    (strata, wrong)
}

/// Largest error, and largest median.
fn worst(rows: &[Row], answers: impl Fn(&CubicQuintic, f64) -> [f64; 8]) -> (f64, f64) {
    let (strata, wrong) = report(rows, answers);
    let (mut worst, mut median) = (0.0f64, 0.0f64);
    for (stratum, mut lists) in strata {
        let summaries = lists.each_mut().map(|list| summary(list));
        let columns: Vec<String> =
            NAMES.iter().zip(summaries).map(|(name, (most, _))| format!("{name} {most:.2}")).collect();
        println!("{stratum:14} {}", columns.join("  "));
        for (most, middle) in summaries {
            (worst, median) = (worst.max(most), median.max(middle));
        }
    }
    println!("worst {worst:.3}, worst median {median:.3}, wrong regimes {wrong}");
    (if wrong > 0 { f64::INFINITY } else { worst }, median)
}

#[test]
fn every_stratum_keeps_its_last_digits() {
    let rows = rows(VECTORS, COUNT);
    on_every_set(|set| {
        let (worst, median) = worst(&rows, answers);
        assert!(worst <= 4.0 && median <= 0.75, "{set:?}");
    });
}

/// One row by the formula of rows with states of their own.
fn row_alone(orbit: &CubicQuintic, t: f64) -> [f64; 8] {
    let row = [t, orbit.u0(), orbit.velocity0(), orbit.p(), orbit.q(), orbit.s()];
    let (mut u, mut velocity) = ([7.0], [7.0]);
    cubic_quintic_rows_into(row.each_ref().map(std::slice::from_ref), [&mut u, &mut velocity]);
    let mut all = answers(orbit, t);
    [all[0], all[1]] = [u[0], velocity[0]];
    all
}

#[test]
fn rows_of_their_own_keep_their_last_digits() {
    let rows = rows(VECTORS, COUNT);
    on_every_set(|set| {
        let (worst, median) = worst(&rows, row_alone);
        assert!(worst <= 4.0 && median <= 0.75, "{set:?}");
    });
}

/// Siblings that spoil the function: each must go red.
#[test]
fn spoiled_siblings_are_found() {
    let rows = rows(VECTORS, COUNT);
    let spoiled = |spoil: &Spoil<'_>| worst(&rows, |orbit, t| spoil(orbit, t, answers(orbit, t))).0;
    let change = |index: usize, factor: f64| {
        spoiled(&move |_, _, mut all| {
            all[index] *= factor;
            all
        })
    };
    // Ten ulps too high (the largest |u| and |u'| may be far above), a wrong sign, a period twice.
    for index in 0..8 {
        assert!(change(index, 1.0 + 10.0 * f64::EPSILON) > 4.0, "{index}");
        assert!(change(index, -1.0) > 4.0, "{index}");
    }
    assert!(change(2, 2.0) > 4.0);
    // The time reversed, whole periods off by rounding, an answer beyond the escape.
    assert!(spoiled(&|orbit, t, _| answers(orbit, -t)) > 4.0);
    let rest =
        |orbit: &CubicQuintic, t: f64| if orbit.period() < f64::INFINITY { t % orbit.period() } else { t };
    assert!(spoiled(&|orbit, t, _| answers(orbit, rest(orbit, t))) > 4.0);
    // gamma forgotten.
    assert!(
        spoiled(&|orbit, t, _| {
            let [u0, velocity0] = [orbit.u0(), orbit.velocity0()];
            answers(&CubicQuintic::new(u0, velocity0, orbit.p(), orbit.q(), 0.0).unwrap(), t)
        }) > 4.0
    );
}

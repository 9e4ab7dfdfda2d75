//! Pendulum against the truth, stratum by stratum, and the spoiled siblings that must go red.

use crate::on_every_set;
use crate::ruler::{Row, distance, eased, rows, summary, ulp};
use libration::{Frequency, Orbit, advance};
use std::collections::BTreeMap;

const PENDULUM: &str = include_str!("../../reference/vectors/pendulum.csv");
const CORNERS: &str = include_str!("../../reference/vectors/pendulum_corners.csv");

/// Errors of theta, velocity and period by stratum, and how many regimes are wrong.
#[derive(Default)]
struct Report {
    strata: BTreeMap<String, [Vec<f64>; 3]>,
    wrong_regimes: usize,
}

impl Report {
    /// Worst error over all strata, and worst median, printing the table.
    fn worst(&mut self) -> (f64, f64) {
        let (mut worst, mut median) = (0.0, 0.0);
        for (stratum, errors) in &mut self.strata {
            let [t, v, p] = errors.each_mut().map(|list| summary(list));
            println!(
                "{stratum:18} theta {:6.3} {:5.3}  velocity {:6.3} {:5.3}  period {:6.3} {:5.3}",
                t.0, t.1, v.0, v.1, p.0, p.1
            );
            worst = [t.0, v.0, p.0].into_iter().fold(worst, f64::max);
            median = [t.1, v.1, p.1].into_iter().fold(median, f64::max);
        }
        println!("worst {worst:.3}, worst median {median:.3}, wrong regimes {}", self.wrong_regimes);
        (worst, median)
    }
}

fn frequency(row: &Row, corners: bool) -> Frequency {
    if corners {
        let [a, b, c] = ["omega2_a", "omega2_b", "omega2_c"].map(|name| row.hex(name));
        Frequency::from_factors(a, b, c).unwrap()
    } else {
        Frequency::from_omega2(row.hex("omega2")).unwrap()
    }
}

/// Largest |theta| and |velocity| of the orbit.
fn scales(row: &Row, orbit: &Orbit) -> (f64, f64) {
    let theta_max = row.hex("theta_max_hi");
    let kappa = if theta_max.is_nan() { row.hex("energy_ratio_hi").sqrt() } else { (theta_max / 2.0).sin() };
    let turn = (orbit.turns(0.0).count as f64 * std::f64::consts::TAU).abs();
    let theta = if row.text("regime") == "libration" { theta_max + turn } else { std::f64::consts::PI };
    (theta, 2.0 * orbit.omega0() * kappa)
}

fn report(rows: &[Row], corners: bool, motion: impl Fn(&Orbit, f64) -> (f64, f64)) -> Report {
    let mut report = Report::default();
    for row in rows {
        let t = row.hex("t");
        let orbit = Orbit::new(row.hex("theta0"), row.hex("velocity0"), frequency(row, corners)).unwrap();
        if orbit.regime().name() != row.text("regime") {
            report.wrong_regimes += 1;
            println!("regime of {} is {}", row.text("id"), orbit.regime().name());
        }
        let (theta, velocity) = motion(&orbit, t);
        let (theta_scale, velocity_scale) = scales(row, &orbit);
        let floor = 2f64.powi(-30);
        let errors = [
            eased(theta, row.truth("theta"), floor * theta_scale, row.decimal("cond_theta"), theta_scale),
            eased(
                velocity,
                row.truth("velocity"),
                floor * velocity_scale,
                row.decimal("cond_velocity"),
                velocity_scale,
            ),
            {
                let truth = row.truth("period");
                let unit = ulp(truth[0]) + row.decimal("cond_period") * 2f64.powi(-100);
                distance(orbit.period(), truth, unit)
            },
        ];
        if errors.iter().any(|e| *e > 4.0) {
            println!("{} {} {:?} {}", row.text("id"), row.text("stratum"), errors, row.text("regime"));
        }
        let lists = report.strata.entry(row.text("stratum").to_string()).or_default();
        for (list, error) in lists.iter_mut().zip(errors) {
            list.push(error);
        }
    }
    report
}

#[test]
fn every_stratum_keeps_its_last_digits() {
    let rows = rows(PENDULUM, 1998);
    let corners = rows_of_corners();
    on_every_set(|set| {
        let mut report = report(&rows, false, |orbit, t| orbit.motion(t));
        assert_eq!(report.strata.len(), 16);
        let (worst, median) = report.worst();
        assert_eq!(report.wrong_regimes, 0);
        assert!(worst <= 4.0 && median <= 0.5, "{set:?}");

        let mut report = self::report(&corners, true, |orbit, t| orbit.motion(t));
        assert_eq!(report.strata.len(), 10);
        let (worst, median) = report.worst();
        assert_eq!(report.wrong_regimes, 0);
        assert!(worst <= 4.0 && median <= 0.5, "{set:?} in the corners");
    });
}

fn rows_of_corners() -> Vec<Row<'static>> {
    rows(CORNERS, 554)
}

/// Energy ratio, its complement, energy and turning angle: 4 ulp, plus what 2^-150 of the condition makes of the
/// complement, and of the angle through it.
#[test]
fn energies_and_turning_angles() {
    for (rows, corners) in [(rows(PENDULUM, 1998), false), (rows_of_corners(), true)] {
        for row in &rows {
            let (theta0, velocity0) = (row.hex("theta0"), row.hex("velocity0"));
            let orbit = Orbit::new(theta0, velocity0, frequency(row, corners)).unwrap();
            let complement = row.truth("energy_ratio_c");
            let turn = theta0.abs().max(4.0) * 2f64.powi(-150);
            for (name, got, ease) in [
                ("energy_ratio", orbit.energy_ratio(), 0.0),
                ("energy_ratio_c", orbit.energy_ratio_c(), turn * complement[0].abs().sqrt().max(1e-3)),
                ("energy", orbit.energy(), 0.0),
                ("theta_max", orbit.theta_max(), 0.0),
            ] {
                let truth = row.truth(name);
                let error = distance(got, truth, ulp(truth[0]) + ease);
                assert!(error <= 4.0, "{} {name} {got:e} {truth:?} {error}", row.text("id"));
            }
        }
    }
}

/// `advance` of one step against the truth, with the floor at the scale.
fn advanced(rows: &[Row], corners: bool, step: impl Fn(f64, f64, f64, Frequency) -> (f64, f64)) -> f64 {
    let mut worst = 0.0;
    for row in rows {
        let force = frequency(row, corners);
        let (theta0, velocity0, t) = (row.hex("theta0"), row.hex("velocity0"), row.hex("t"));
        let orbit = Orbit::new(theta0, velocity0, force).unwrap();
        let (theta_scale, velocity_scale) = scales(row, &orbit);
        let (theta, velocity) = step(theta0, velocity0, t, force);
        let errors = [
            eased(theta, row.truth("theta"), theta_scale, row.decimal("cond_theta"), theta_scale),
            eased(
                velocity,
                row.truth("velocity"),
                velocity_scale,
                row.decimal("cond_velocity"),
                velocity_scale,
            ),
        ];
        if errors.iter().any(|e| *e > 8.0) {
            println!("{} {} {errors:?}", row.text("id"), row.text("stratum"));
        }
        worst = errors.into_iter().fold(worst, f64::max);
    }
    worst
}

#[test]
fn advance_of_one_step() {
    assert!(advanced(&rows(PENDULUM, 1998), false, advance) <= 8.0);
    assert!(advanced(&rows_of_corners(), true, advance) <= 8.0);
}

/// Siblings that spoil the function: each must go red.
#[test]
fn spoiled_siblings_are_found() {
    let rows = rows(PENDULUM, 1998);
    let worst = |motion: &dyn Fn(&Orbit, f64) -> (f64, f64)| report(&rows, false, motion).worst().0;
    // Five ulps too high, a wrong sign, a turn lost, NaN for an answer, a period in plain double.
    assert!(worst(&|orbit, t| (orbit.theta(t) * (1.0 + 5.0 * f64::EPSILON), orbit.velocity(t))) > 4.0);
    assert!(worst(&|orbit, t| (orbit.theta(t), -orbit.velocity(t))) > 4.0);
    assert!(worst(&|orbit, t| (orbit.turns(t).angle, orbit.velocity(t))) > 4.0);
    assert!(worst(&|orbit, t| (orbit.theta(t), if t > 1e6 { f64::NAN } else { orbit.velocity(t) })) > 4.0);
    assert!(worst(&|orbit, t| orbit.motion(t.rem_euclid(orbit.period()))) > 4.0);
    // One ulp more, everywhere: the median sees it.
    let next = |value: f64| if value == 0.0 { value } else { f64::from_bits(value.to_bits() + 1) };
    let medians = report(&rows, false, |orbit, t| (next(orbit.theta(t)), next(orbit.velocity(t)))).worst();
    assert!(medians.1 > 0.5);
    // A step with the wrong angle, and one that forgets its turns.
    assert!(advanced(&rows, false, |a, b, t, f| advance(a, b, t * (1.0 + 1e-12), f)) > 8.0);
    assert!(
        advanced(&rows, false, |a, b, t, f| (
            advance(a, b, t, f).0 % std::f64::consts::TAU,
            advance(a, b, t, f).1
        )) > 8.0
    );
}

//! The damped motion and its derivatives against the truth, stratum by stratum, and the spoiled siblings that must go red.

use crate::on_every_set;
use crate::ruler::{Row, distance, rows, summary, ulp};
use libration::damped::PARAMETERS;
use libration::{
    DampedJacobian, DampedPendulum, DampedSensitivity, Frequency, Friction, Interpolation, Torque, Trajectory,
};
use std::collections::BTreeMap;

const MOTION: &str = include_str!("../../reference/vectors/damped.csv");
const SLOPES: &str = include_str!("../../reference/vectors/damped_slopes.csv");
const MOTION_ROWS: usize = 350;
const SLOPES_ROWS: usize = 88;

/// The promise of angle and velocity, in ulps of the largest and 2^-57 of the condition.
const MOTION_BOUND: f64 = 2.0;
/// The promise of the derivatives, of the largest change of a row.
const SLOPES_BOUND: f64 = 1e-12;

/// The samples that reference/damped.py makes.
fn samples(kind: &str) -> Torque {
    let interpolation = match kind {
        "" => return Torque::NONE,
        "steps" => Interpolation::Steps,
        "lines" => Interpolation::Lines,
        "cubics" => Interpolation::Cubics,
        _ => panic!("{kind}"),
    };
    let times: Vec<f64> = (0..400).map(|i| 0.375 * f64::from(i) - 3.0).collect();
    let values: Vec<f64> = (0..400).map(|i| f64::from((i * 7) % 11 - 5) / 16.0).collect();
    Torque::NONE.with_samples(&times, &values, interpolation).unwrap()
}

fn pendulum(row: &Row) -> DampedPendulum {
    let of = |name: &str| row.hex(name);
    let friction = Friction::new(of("linear"), of("quadratic"), of("dry"), of("presliding")).unwrap();
    let torque = match row.text("samples") {
        "" => Torque::new(of("constant"), of("amplitude"), of("frequency"), of("phase")).unwrap(),
        kind => samples(kind),
    };
    let force = Frequency::from_omega2(of("omega2")).unwrap();
    DampedPendulum::new(of("theta0"), of("velocity0"), force, friction, torque).unwrap()
}

/// Trajectories of a file: neighbouring rows share one.
fn each(rows: &[Row], mut visit: impl FnMut(&Row, &Trajectory)) {
    let mut last: Option<(DampedPendulum, Trajectory)> = None;
    for (i, row) in rows.iter().enumerate() {
        let now = pendulum(row);
        if last.as_ref().is_none_or(|(before, _)| *before != now) {
            let same = rows[i..].iter().take_while(|later| pendulum(later) == now);
            let stop = same.map(|later| later.hex("t")).fold(0.0, f64::max);
            let trajectory = now.trajectory(0.0, stop).unwrap();
            last = Some((now, trajectory));
        }
        visit(row, &last.as_ref().unwrap().1);
    }
}

fn worst_motion(rows: &[Row], motion: impl Fn(&Trajectory, f64) -> (f64, f64)) -> f64 {
    let mut strata: BTreeMap<String, [Vec<f64>; 2]> = BTreeMap::new();
    each(rows, |row, trajectory| {
        let (theta, velocity) = motion(trajectory, row.hex("t"));
        let errors = strata.entry(row.text("stratum").into()).or_default();
        for (i, (name, got)) in [("theta", theta), ("velocity", velocity)].into_iter().enumerate() {
            let ease = row.decimal(&format!("cond_{name}")) * 2f64.powi(-57);
            let unit = ulp(row.decimal(&format!("scale_{name}"))) + ease;
            let error = distance(got, row.truth(name), unit);
            if error > MOTION_BOUND {
                println!("{} {name} {error} {got:e}", row.text("id"));
            }
            errors[i].push(error);
        }
    });
    let mut worst = 0.0;
    for (stratum, [theta, velocity]) in &mut strata {
        let (theta, velocity) = (summary(theta), summary(velocity));
        println!(
            "{stratum:22} theta {:.3} median {:.3}  velocity {:.3} median {:.3}",
            theta.0, theta.1, velocity.0, velocity.1
        );
        worst = f64::max(worst, theta.0.max(velocity.0));
    }
    worst
}

#[test]
fn motions_keep_their_digits() {
    let rows = rows(MOTION, MOTION_ROWS);
    on_every_set(|set| {
        let worst = worst_motion(&rows, Trajectory::motion);
        println!("{set:?} {worst}");
        assert!(worst <= MOTION_BOUND, "{worst}");
    });
}

/// A time a little late, a sign, an angle one turn off, an ulp of the velocity at rest.
#[test]
fn spoiled_motions_are_found() {
    let rows = rows(MOTION, MOTION_ROWS);
    let spoiled = |spoil: fn((f64, f64)) -> (f64, f64)| {
        worst_motion(&rows, |trajectory, t| spoil(trajectory.motion(t)))
    };
    assert!(spoiled(|(theta, velocity)| (theta + 1e-15 * velocity, velocity)) > MOTION_BOUND);
    assert!(spoiled(|(theta, velocity)| (theta, -velocity)) > MOTION_BOUND);
    assert!(spoiled(|(theta, velocity)| (theta * (1.0 + 1e-15), velocity)) > MOTION_BOUND);
    assert!(
        spoiled(|(theta, velocity)| (theta, if velocity == 0.0 { 1e-15 } else { velocity })) > MOTION_BOUND
    );
}

/// The error of a row of derivatives, of the largest of its changes.
fn slope_error(got: &[f64], truth: &[f64], scales: &[f64]) -> f64 {
    let change = |i: usize| (truth[i] * scales[i]).abs();
    let largest = (0..truth.len()).filter(|i| !truth[*i].is_nan()).map(change).fold(0.0, f64::max);
    let mut worst: f64 = 0.0;
    for i in 0..truth.len() {
        let error = match (truth[i].is_nan(), got[i].is_nan()) {
            (true, true) => 0.0,
            (false, false) if got[i] == truth[i] => 0.0,
            (false, false) => (got[i] - truth[i]).abs() * scales[i] / largest,
            _ => f64::INFINITY,
        };
        worst = worst.max(error);
    }
    worst
}

fn worst_slopes(rows: &[Row], slopes: impl Fn(DampedJacobian) -> DampedJacobian) -> f64 {
    let mut strata: BTreeMap<String, f64> = BTreeMap::new();
    each(rows, |row, trajectory| {
        let sensitivity = DampedSensitivity::new(trajectory).unwrap();
        let got = slopes(sensitivity.at(row.hex("t")));
        let rate = row.hex("omega2").abs().sqrt().max(1.0);
        let square = rate * rate;
        let scales = [1.0, rate, square, rate, 1.0, square, 1.0, square, square, rate, 1.0];
        for (name, got) in [("theta", got.theta), ("velocity", got.velocity)] {
            let truth = PARAMETERS.map(|by| row.decimal(&format!("d{name}_d{by}")));
            let error = slope_error(&got, &truth, &scales);
            if error > SLOPES_BOUND {
                println!("{} {name} {error:e} {got:?} {truth:?}", row.text("id"));
            }
            let worst = strata.entry(row.text("stratum").into()).or_default();
            *worst = worst.max(error);
        }
    });
    for (stratum, error) in &strata {
        println!("{stratum:22} {error:.2e}");
    }
    strata.into_values().fold(0.0, f64::max)
}

#[test]
fn derivatives_keep_their_digits() {
    let rows = rows(SLOPES, SLOPES_ROWS);
    on_every_set(|set| {
        let worst = worst_slopes(&rows, |slopes| slopes);
        println!("{set:?} {worst:e}");
        assert!(worst <= SLOPES_BOUND, "{worst:e}");
    });
}

/// Every column a little off is found, and so is a sign.
#[test]
fn spoiled_derivatives_are_found() {
    let rows = rows(SLOPES, SLOPES_ROWS);
    for (i, name) in PARAMETERS.into_iter().enumerate() {
        let worst = worst_slopes(&rows, |mut slopes| {
            slopes.theta[i] *= 1.0 + 1e-8;
            slopes
        });
        assert!(worst > SLOPES_BOUND, "{name}");
        let worst = worst_slopes(&rows, |mut slopes| {
            slopes.velocity[i] = -slopes.velocity[i];
            slopes
        });
        assert!(worst > SLOPES_BOUND, "{name}");
    }
}

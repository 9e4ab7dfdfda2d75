//! Records that are no swing from a release: a drive before the decay, turns over the top throughout.

use libration::{DampedPendulum, Frequency, Friction, Torque, Trajectory};
use libration_fit::fit::{Data, FitOptions, Measured, Model, Stream, fit};

fn motion(theta0: f64, velocity0: f64, friction: Friction, stop: f64) -> Trajectory {
    let frequency = Frequency::from_omega0(3.0).unwrap();
    let pendulum = DampedPendulum::new(theta0, velocity0, frequency, friction, Torque::NONE).unwrap();
    pendulum.trajectory(0.0, stop).unwrap()
}

/// Errors of size 1, the same on every machine.
fn error(i: usize) -> f64 {
    (12.9898 * i as f64).sin() + (78.233 * i as f64).sin()
}

#[test]
fn a_constant_swing_before_the_decay_is_a_drive() {
    let free = Friction::new(0.05, 0.0, 0.0, 0.0).unwrap();
    let (end, rows, step) = (30.0, 3000, 0.02);
    let steady = motion(0.7, 0.0, Friction::NONE, end);
    let (theta, velocity) = steady.motion(end);
    let decay = motion(theta, velocity, free, step * rows as f64);
    let t: Vec<f64> = (0..rows).map(|i| step * i as f64).collect();
    let values = t.iter().enumerate().map(|(i, t)| {
        let angle = if *t < end { steady.theta(*t) } else { decay.theta(*t - end) };
        angle + 0.002 * error(i)
    });
    let data = Data::Record { measured: Measured::Angle, values: values.collect(), t };
    let found = fit(&data, &FitOptions::default()).unwrap();
    let said: Vec<&str> = found.verdicts.iter().map(|verdict| verdict.sentence.as_str()).collect();
    assert!(found.window.0 > end - 2.0 && found.window.0 < end + 6.0, "{:?} {said:?}", found.window);
    assert!(found.window_reason.contains("end of the drive"), "{}", found.window_reason);
    assert!(said.iter().any(|sentence| sentence.contains("drives the pendulum")), "{said:?}");
    assert!(found.stands(), "{said:?}");
    assert!((found.omega0.value - 3.0).abs() < 4.0 * found.omega0.u, "{:?}", found.omega0);
    let linear = found.friction.linear.unwrap();
    assert!((linear.value - 0.05).abs() < 0.002, "{linear:?}");
}

#[test]
fn a_free_decay_is_no_drive() {
    for friction in [(0.002, 0.0, 0.0), (0.0, 0.01, 0.0), (0.0, 0.0, 0.02)] {
        let friction = Friction::new(friction.0, friction.1, friction.2, 0.0).unwrap();
        let along = motion(1.0, 0.0, friction, 60.0);
        let t: Vec<f64> = (0..1500).map(|i| 0.04 * f64::from(i)).collect();
        let values = t.iter().enumerate().map(|(i, t)| along.theta(*t) + 0.002 * error(i)).collect();
        let found =
            fit(&Data::Record { measured: Measured::Angle, values, t }, &FitOptions::default()).unwrap();
        assert!(found.window.0 < 0.5, "{:?}", found.window);
        assert!(found.window_reason.contains("from the release"), "{}", found.window_reason);
    }
}

#[test]
fn a_pendulum_that_turns_over_the_top_throughout_is_fitted() {
    for sense in [1.0, -1.0] {
        let friction = Friction::new(0.01, 0.0, 0.0, 0.0).unwrap();
        let along = motion(0.4, sense * 14.0, friction, 20.0);
        let t: Vec<f64> = (0..2000).map(|i| 0.01 * f64::from(i)).collect();
        assert!(along.velocity(20.0).abs() > 6.0);
        let values = t.iter().enumerate().map(|(i, t)| along.theta(*t) + 0.005 * error(i)).collect();
        let data = Data::Record { measured: Measured::Angle, values, t };
        let found = fit(&data, &FitOptions { model: Some(Model::Linear), ..FitOptions::default() }).unwrap();
        assert!((found.omega0.value - 3.0).abs() < 5.0 * found.omega0.u.max(1e-4), "{:?}", found.omega0);
        assert!(found.rms < 0.0055, "{}", found.rms);
        assert!(found.stands(), "{:?}", found.verdicts);
    }
}

#[test]
fn a_swing_without_friction_is_fitted_from_its_begin() {
    // Noise makes a swing near the end the largest.
    let frequency = Frequency::from_omega2(9.81 / 0.8).unwrap();
    let pendulum =
        DampedPendulum::new(70f64.to_radians(), 0.0, frequency, Friction::NONE, Torque::NONE).unwrap();
    let along = pendulum.trajectory(0.0, 20.0).unwrap();
    let t: Vec<f64> = (0..600).map(|i| f64::from(i) / 30.0).collect();
    for seed in [23, 43, 62] {
        let noise = Stream::new(seed).noise(0.0, t.len());
        let values = t.iter().zip(noise).map(|(t, e)| along.theta(*t) + 0.01 * e).collect();
        let data = Data::Record { measured: Measured::Angle, t: t.clone(), values };
        let found = fit(&data, &FitOptions { model: Some(Model::None), ..FitOptions::default() }).unwrap();
        assert!(found.window.0 < 0.1 && found.samples > 590, "{seed}: {:?}", found.window);
    }
}

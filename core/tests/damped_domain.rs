//! What is refused, and by which words; what is NaN.

use libration::{DampedPendulum, Domain, Frequency, Friction, Interpolation, Torque};

fn force() -> Frequency {
    Frequency::from_omega0(1.0).unwrap()
}

fn said<T>(result: Result<T, Domain>) -> String {
    match result {
        Ok(_) => "accepted".into(),
        Err(domain) => domain.to_string(),
    }
}

#[test]
fn bad_arguments_are_named() {
    assert_eq!(said(Friction::new(f64::NAN, 0.0, 0.0, 0.0)), "linear = NaN: must be finite");
    assert_eq!(said(Friction::new(0.0, f64::INFINITY, 0.0, 0.0)), "quadratic = inf: must be finite");
    assert_eq!(said(Friction::new(0.0, 0.0, -0.1, 0.0)), "dry = -0.1: must be finite and not negative");
    assert_eq!(
        said(Friction::new(0.0, 0.0, 0.1, 1e-20)),
        "presliding = 1e-20: must be 0, or finite and at least 1e-10"
    );
    assert_eq!(said(Torque::new(0.0, f64::NAN, 0.0, 0.0)), "amplitude = NaN: must be finite");
    let of =
        |theta0, velocity0| DampedPendulum::new(theta0, velocity0, force(), Friction::NONE, Torque::NONE);
    assert_eq!(said(of(f64::NAN, 0.0)), "theta0 = NaN: must be finite");
    assert_eq!(said(of(0.0, f64::INFINITY)), "velocity0 = inf: must be finite");
    let pendulum = of(1.0, 0.0).unwrap();
    assert_eq!(said(pendulum.trajectory(1.0, 2.0)), "start = 1.0: must be finite and not above 0");
    assert_eq!(said(pendulum.trajectory(0.0, f64::INFINITY)), "stop = inf: must be finite and not below 0");
    let trajectory = pendulum.trajectory(0.0, 2.0).unwrap();
    assert_eq!(
        said(trajectory.times(0.5, 0.0, 3.0)),
        "stop = 3.0: must be in the interval of the trajectory, 0.0 to 2.0"
    );
    assert_eq!(said(trajectory.times(f64::NAN, 0.0, 1.0)), "theta = NaN: must be finite");
    assert_eq!(said(trajectory.turning_times(1.5, 1.0)), "stop = 1.0: must be not before start, 1.5");
}

#[test]
fn bad_intervals_are_named() {
    let torque = Torque::NONE.with_samples(&[-1.0, 4.0], &[0.0, 1.0], Interpolation::Lines).unwrap();
    let pendulum = DampedPendulum::new(0.0, 0.0, force(), Friction::NONE, torque).unwrap();
    assert_eq!(
        said(pendulum.trajectory(0.0, 5.0)),
        "stop = 5.0: must be between the torque samples, -1.0 to 4.0"
    );
    let late = Torque::NONE.with_samples(&[1.0, 4.0], &[0.0, 1.0], Interpolation::Lines).unwrap();
    assert_eq!(
        said(DampedPendulum::new(0.0, 0.0, force(), Friction::NONE, late)),
        "first torque time = 1.0 (the last is 4.0): must be such that t = 0 lies between the first and the last"
    );
    let soft = Friction::new(0.0, 0.0, 0.1, 0.01).unwrap();
    let pendulum = DampedPendulum::new(0.0, 1.0, force(), soft, Torque::NONE).unwrap();
    assert_eq!(said(pendulum.trajectory(-1.0, 1.0)), "start = -1.0: must be 0 with presliding");
}

/// Friction that drives: without bound it is refused, not followed.
#[test]
fn unbounded_motions_are_refused() {
    let driving = Friction::new(0.0, -0.5, 0.0, 0.0).unwrap();
    let pendulum =
        DampedPendulum::new(0.0, 3.0, Frequency::from_omega2(0.0).unwrap(), driving, Torque::NONE).unwrap();
    // v = 3/(1 - 1.5 t).
    let before = pendulum.trajectory(0.0, 0.6).unwrap();
    assert!((before.velocity(0.6) - 30.0).abs() < 1e-12);
    let message = said(pendulum.trajectory(0.0, 1.0));
    assert!(message.starts_with("stop = 1.0: must be before 0.666"), "{message}");
    assert!(message.ends_with("s, where the motion grows without bound"), "{message}");
}

#[test]
fn equilibria_stay() {
    let friction = Friction::new(0.1, 0.1, 0.0, 0.0).unwrap();
    for theta0 in [0.0, -0.0] {
        let pendulum = DampedPendulum::new(theta0, 0.0, force(), friction, Torque::NONE).unwrap();
        let trajectory = pendulum.trajectory(-5.0, 100.0).unwrap();
        assert_eq!(trajectory.motion(50.0), (0.0, 0.0));
        assert_eq!(trajectory.motion(-5.0), (0.0, 0.0));
        assert!(trajectory.turning_times(-5.0, 100.0).unwrap().is_empty());
    }
    // A torque that begins later moves it.
    let torque = Torque::NONE
        .with_samples(&[0.0, 1.0, 2.0, 9.0], &[0.0, 0.0, -0.5, -0.5], Interpolation::Lines)
        .unwrap();
    let pendulum = DampedPendulum::new(0.0, 0.0, force(), friction, torque).unwrap();
    let trajectory = pendulum.trajectory(0.0, 9.0).unwrap();
    assert_eq!(trajectory.theta(1.0), 0.0);
    assert!(trajectory.theta(2.0) < -0.01);
}

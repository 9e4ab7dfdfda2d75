//! Where the damped motion meets others: the exact orbit, the half-swing map, the averaged laws, closed forms.

use crate::ruler::{bits, ulp};
use libration::damped::{averaged_energy_loss, averaged_turning_angle, averaged_turning_rate};
use libration::{
    DampedPendulum, Frequency, Friction, Interpolation, Orbit, Sensitivity, Torque, Trajectory, half_swing,
};

fn trajectory(
    theta0: f64,
    velocity0: f64,
    omega2: f64,
    law: [f64; 4],
    torque: Torque,
    stop: f64,
) -> Trajectory {
    let friction = Friction::new(law[0], law[1], law[2], law[3]).unwrap();
    let force = Frequency::from_omega2(omega2).unwrap();
    DampedPendulum::new(theta0, velocity0, force, friction, torque).unwrap().trajectory(0.0, stop).unwrap()
}

/// Nothing takes or gives: the orbit, bit for bit.
#[test]
fn without_friction_it_is_the_orbit() {
    for (theta0, velocity0) in [(1.0, 0.0), (3.1, 0.0), (0.5, 3.0), (0.0, 2.0), (0.0, 0.0)] {
        let free = trajectory(theta0, velocity0, 1.0, [0.0; 4], Torque::NONE, 1000.0);
        let orbit = Orbit::new(theta0, velocity0, Frequency::from_omega2(1.0).unwrap()).unwrap();
        assert_eq!(free.steps(), 0);
        for i in 0..1000 {
            let t = f64::from(i) * 0.997;
            let ((a, v), (b, w)) = (free.motion(t), orbit.motion(t));
            assert_eq!([bits(a), bits(v)], [bits(b), bits(w)]);
        }
        assert_eq!(free.turning_times(0.0, 100.0), orbit.turning_times(0.0, 100.0));
    }
}

/// Friction too small to count: the integration against the exact orbit over 100 periods, with what 2^-57 of the condition is.
#[test]
fn small_friction_is_none() {
    let force = Frequency::from_omega2(1.0).unwrap();
    for theta0 in [5.0f64, 45.0, 90.0, 150.0, 170.0, 179.0, 179.9].map(f64::to_radians) {
        for velocity0 in [0.0, 1e-3, 2.5] {
            let orbit = Orbit::new(theta0, velocity0, force).unwrap();
            let stop = 100.0 * orbit.period();
            let law = [1e-250, 1e-250, 1e-250, 0.0];
            let damped = trajectory(theta0, velocity0, 1.0, law, Torque::NONE, stop);
            let sensitivity = Sensitivity::new(&orbit);
            for i in 0..=500 {
                let t = stop * f64::from(i) / 500.0;
                let ((a, v), (b, w)) = (damped.motion(t), orbit.motion(t));
                let by = sensitivity.at(t);
                let condition: f64 = by.theta.iter().chain(&by.velocity).map(|slope| slope.abs()).sum();
                let slack = |scale: f64| 2.0 * ulp(scale) + 2f64.powi(-57) * condition;
                assert!((a - b).abs() <= slack(a.abs().max(theta0)), "{theta0} {velocity0} {t} {a} {b}");
                assert!((v - w).abs() <= slack(2.0f64.max(velocity0)), "{theta0} {velocity0} {t} {v} {w}");
            }
        }
    }
}

/// Turning angles under quadratic and dry friction.
#[test]
fn turns_follow_the_half_swing_map() {
    for (beta, mu) in [(0.1, 0.0), (0.0, 0.02), (0.05, 0.01), (1e-9, 1e-4), (2.0, 0.3)] {
        for omega2 in [1.0, 9.81] {
            for theta0 in [0.2, 1.0, 3.0, 3.14159] {
                let motion = trajectory(theta0, 0.0, omega2, [0.0, beta, mu, 0.0], Torque::NONE, 40.0);
                let friction = Friction::new(0.0, beta, mu, 0.0).unwrap();
                let force = Frequency::from_omega2(omega2).unwrap();
                let turning = motion.turning_times(0.0, 40.0).unwrap();
                if f64::sin(theta0) <= mu / omega2 {
                    assert!(turning.is_empty());
                    assert_eq!(half_swing(theta0, force, friction), theta0);
                    continue;
                }
                assert!(!turning.is_empty());
                let mut theta = theta0;
                for t in &turning[1..] {
                    theta = half_swing(theta, force, friction);
                    let got = motion.theta(*t);
                    assert!((got - theta).abs() < 1e-14, "{beta} {mu} {theta0} {t} {got} {theta}");
                }
                if let Some((from, _)) = motion.rests().first() {
                    let stopped = half_swing(theta, force, friction);
                    assert!((motion.theta(*from) - stopped).abs() < 1e-14);
                    assert_eq!(half_swing(stopped, force, friction), stopped);
                }
            }
        }
    }
    let force = Frequency::from_omega0(1.0).unwrap();
    assert!(half_swing(1.0, force, Friction::new(0.1, 0.0, 0.0, 0.0).unwrap()).is_nan());
    assert!(half_swing(4.0, force, Friction::NONE).is_nan());
    assert!((half_swing(2.0, force, Friction::NONE) + 2.0).abs() < 1e-15);
}

/// The averaged laws have the error of the second order: halving friction divides it by four.
#[test]
fn averages_are_of_second_order() {
    let force = Frequency::from_omega2(2.0).unwrap();
    for law in [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 0.5, 0.0], [0.0, 0.0, 1.0, 0.05]] {
        let error = |small: f64| {
            let law = [law[0] * small, law[1] * small, law[2] * small, law[3]];
            let motion = trajectory(1.2, 0.0, 2.0, law, Torque::NONE, 20.0);
            // Two whole swings later: presliding has reached its cycle after the first.
            let turning = motion.turning_times(0.0, 20.0).unwrap();
            let [first, last] = [2, 4].map(|i| motion.theta(turning[i]));
            let mean = 0.5 * (first + last);
            let friction = Friction::new(law[0], law[1], law[2], law[3]).unwrap();
            let lost = motion.energy(turning[2]) - motion.energy(turning[4]);
            let slow = averaged_turning_rate(mean, force, friction) * (turning[4] - turning[2]);
            [lost - averaged_energy_loss(mean, force, friction), last - first - slow]
                .map(|part| part.abs() / small)
        };
        let (coarse, fine) = (error(0.02), error(0.01));
        for i in 0..2 {
            assert!(fine[i] < 0.6 * coarse[i] && coarse[i] < 0.1, "{law:?} {coarse:?} {fine:?}");
        }
    }
    // lab: 0.0007 degrees from 60 degrees over 16 periods.
    let motion = trajectory(60f64.to_radians(), 0.0, 1.0, [0.01, 0.0, 0.0, 0.0], Torque::NONE, 110.0);
    let unit = Frequency::from_omega2(1.0).unwrap();
    for t in motion.turning_times(0.0, 110.0).unwrap() {
        let friction = Friction::new(0.01, 0.0, 0.0, 0.0).unwrap();
        let angle = averaged_turning_angle(60f64.to_radians(), t, unit, friction);
        assert!((motion.theta(t).abs() - angle).abs().to_degrees() < 1e-3, "{t}");
    }
}

/// The turning angle in the mean: it has the averaged rate, one decay after another is one decay, and the closed form of linear
/// friction is the limit of the quadrature.
#[test]
fn averaged_decays() {
    let force = Frequency::from_omega2(2.0).unwrap();
    let of = |law: [f64; 4]| Friction::new(law[0], law[1], law[2], law[3]).unwrap();
    let laws =
        [[0.0, 0.05, 0.0, 0.0], [0.0, 0.0, 0.02, 0.0], [0.01, 0.03, 0.005, 0.0], [0.01, 0.0, 0.02, 0.05]];
    for law in laws.map(of) {
        for start in [1e-3, 0.5, 2.0, 3.1, 3.14159] {
            let now = |t: f64| averaged_turning_angle(start, t, force, law);
            assert_eq!(now(0.0), start);
            for t in [0.01, 1.0, 10.0] {
                let angle = now(t);
                if angle == 0.0 {
                    assert!(law.dry() > 0.0 && law.presliding() == 0.0);
                    continue;
                }
                let onward = averaged_turning_angle(angle, 3.0, force, law);
                assert!((onward - now(t + 3.0)).abs() <= 1e-13 * start, "{law:?} {start} {t}");
                // Next to the top a time says little of where it began.
                let back = averaged_turning_angle(angle, -t, force, law);
                let slack = if start < 3.11 { 1e-12 } else { 1e-9 };
                assert!((back - start).abs() <= slack * start, "{law:?} {start} {t} {back}");
                let slope = (now(t + 1e-4) - now(t - 1e-4)) / 2e-4;
                let rate = averaged_turning_rate(angle, force, law);
                if now(t + 1e-4) > 0.0 && start < 3.0 {
                    assert!((slope / rate - 1.0).abs() < 1e-5, "{law:?} {start} {t} {slope} {rate}");
                }
            }
        }
    }
    for start in [1e-3, 0.5, 2.0, 3.1] {
        for t in [-1.0, 0.3, 20.0, 300.0] {
            let closed = averaged_turning_angle(start, t, force, of([0.02, 0.0, 0.0, 0.0]));
            let sum = averaged_turning_angle(start, t, force, of([0.02, 1e-20, 0.0, 0.0]));
            let both = sum.is_nan() && closed.is_nan();
            assert!(both || (sum - closed).abs() <= 1e-14 * closed, "{start} {t} {sum} {closed}");
        }
    }
    // Small swings: 1/a = 1/a0 + 4 beta omega0 t/3 pi, and dry friction takes 2 mu/pi omega0 in the mean.
    let [mut quadratic, mut dry] = [[0.0; 4]; 2];
    (quadratic[1], dry[2]) = (0.1, 1e-9);
    let (beta, omega0, pi) = (0.1, 2f64.sqrt(), core::f64::consts::PI);
    let inverse = 1.0 / averaged_turning_angle(1e-6, 1e8, force, of(quadratic));
    assert!((inverse / (1e6 + 4.0 * beta * omega0 * 1e8 / (3.0 * pi)) - 1.0).abs() < 1e-11);
    let lost = 1e-6 - averaged_turning_angle(1e-6, 500.0, force, of(dry));
    assert!((lost / (2e-9 * 500.0 / (pi * omega0)) - 1.0).abs() < 1e-8);
    let unserved = [[0.01, -0.1, 0.0, 0.0], [-0.01, 0.0, 0.1, 0.0]].map(of);
    assert!(unserved.iter().all(|law| averaged_turning_angle(1.0, 1.0, force, *law).is_nan()));
    for (theta, t) in [(4.0, 1.0), (-0.1, 1.0), (1.0, f64::NAN), (1.0, -1e4)] {
        assert!(averaged_turning_angle(theta, t, force, of([0.0, 0.1, 0.1, 0.0])).is_nan(), "{theta} {t}");
    }
    assert_eq!(averaged_turning_angle(0.0, 5.0, force, of([0.0, 0.1, 0.1, 0.0])), 0.0);
}

/// Small swings under linear friction, and fall under quadratic friction without a force, have closed forms.
#[test]
fn closed_forms() {
    let damped = trajectory(1e-8, 0.0, 1.0, [0.1, 0.0, 0.0, 0.0], Torque::NONE, 50.0);
    let rate = (1.0f64 - 0.01).sqrt();
    for i in 0..500 {
        let t = 0.1 * f64::from(i);
        let exact = 1e-8 * (-0.1 * t).exp() * ((rate * t).cos() + 0.1 / rate * (rate * t).sin());
        assert!((damped.theta(t) - exact).abs() < 1e-22, "{t}");
    }
    let slowing = trajectory(0.0, 2.0, 0.0, [0.0, 0.5, 0.0, 0.0], Torque::NONE, 50.0);
    for i in 0..500 {
        let t = 0.1 * f64::from(i);
        assert!((slowing.theta(t) - 2.0 * (1.0 + t).ln()).abs() < 4e-15, "{t}");
        assert!((slowing.velocity(t) - 2.0 / (1.0 + t)).abs() < 1e-15, "{t}");
    }
    // Sliding to a stop: mu t^2/2.
    let sliding = trajectory(0.0, 1.0, 0.0, [0.0, 0.0, 0.25, 0.0], Torque::NONE, 10.0);
    assert_eq!(sliding.rests(), [(4.0, 10.0)]);
    assert_eq!(sliding.theta(10.0), 2.0);
}

/// Samples of a constant, a line and a cubic are those functions.
#[test]
fn samples_of_a_constant_are_the_constant() {
    let times: Vec<f64> = (0..101).map(|i| 0.5 * f64::from(i)).collect();
    let law = [0.05, 0.0, 0.02, 0.0];
    let constant = trajectory(0.3, 0.0, 1.0, law, Torque::new(0.25, 0.0, 0.0, 0.0).unwrap(), 50.0);
    for kind in [Interpolation::Steps, Interpolation::Lines, Interpolation::Cubics] {
        let torque = Torque::NONE.with_samples(&times, &[0.25; 101], kind).unwrap();
        let sampled = trajectory(0.3, 0.0, 1.0, law, torque, 50.0);
        for i in 0..500 {
            let t = 0.1 * f64::from(i);
            assert!((sampled.theta(t) - constant.theta(t)).abs() < 1e-15, "{kind:?} {t}");
        }
    }
    // A slow sinusoid and its fine cubics.
    let fine: Vec<f64> = (0..5001).map(|i| 0.01 * f64::from(i)).collect();
    let values: Vec<f64> = fine.iter().map(|t| 0.3 * (0.5 * t + 0.2).cos()).collect();
    let torque = Torque::NONE.with_samples(&fine, &values, Interpolation::Cubics).unwrap();
    let sampled = trajectory(0.3, 0.0, 1.0, law, torque, 50.0);
    let driven = trajectory(0.3, 0.0, 1.0, law, Torque::new(0.0, 0.3, 0.5, 0.2).unwrap(), 50.0);
    for i in 0..500 {
        let t = 0.1 * f64::from(i);
        assert!((sampled.theta(t) - driven.theta(t)).abs() < 1e-6, "{t}");
    }
}

/// Presliding over a vanishing angle delta is dry friction: the time in which the angle passes delta after a turn, and so the gap, is
/// of the order of sqrt delta.
#[test]
fn short_presliding_is_dry_friction() {
    let dry = trajectory(1.0, 0.2, 1.0, [0.0, 0.0, 0.05, 0.0], Torque::NONE, 15.0);
    let gap = |delta: f64| {
        let soft = trajectory(1.0, 0.2, 1.0, [0.0, 0.0, 0.05, delta], Torque::NONE, 15.0);
        (0..150)
            .map(|i| (soft.theta(0.1 * f64::from(i)) - dry.theta(0.1 * f64::from(i))).abs())
            .fold(0.0, f64::max)
    };
    let (coarse, fine) = (gap(1e-4), gap(1e-6));
    assert!(coarse < 1e-2 && fine < 0.11 * coarse && fine > 0.05 * coarse, "{coarse} {fine}");
}

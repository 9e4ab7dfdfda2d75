//! Laws of the damped motion: the balance of energy, the equation of motion itself, symmetries, and motions in parts.

use libration::{DampedPendulum, DampedSensitivity, Frequency, Friction, Torque, Trajectory};

fn frequency() -> Frequency {
    Frequency::from_omega2(1.5).unwrap()
}

fn laws() -> Vec<Friction> {
    [
        [0.02, 0.0, 0.0, 0.0],
        [0.0, 0.05, 0.0, 0.0],
        [0.0, 0.0, 0.03, 0.0],
        [0.01, 0.02, 0.02, 0.0],
        [0.01, 0.02, 0.03, 0.05],
    ]
    .map(|[a, b, c, d]| Friction::new(a, b, c, d).unwrap())
    .to_vec()
}

fn trajectory(theta0: f64, velocity0: f64, friction: Friction, torque: Torque, stop: f64) -> Trajectory {
    DampedPendulum::new(theta0, velocity0, frequency(), friction, torque)
        .unwrap()
        .trajectory(0.0, stop)
        .unwrap()
}

/// Nodes and weights of Gauss's rule with five points on [-1, 1].
fn gauss() -> [(f64, f64); 5] {
    let root = (10.0f64 / 7.0).sqrt();
    let (inner, outer) = ((5.0 - 2.0 * root).sqrt() / 3.0, (5.0 + 2.0 * root).sqrt() / 3.0);
    let (near, far) = ((322.0 + 13.0 * 70f64.sqrt()) / 900.0, (322.0 - 13.0 * 70f64.sqrt()) / 900.0);
    [(-outer, far), (-inner, near), (0.0, 128.0 / 225.0), (inner, near), (outer, far)]
}

/// What the torque gives and friction takes is the change of the energy, from turn to turn.
#[test]
fn the_energy_is_balanced() {
    let torque = Torque::new(0.1, 0.3, 1.1, 0.4).unwrap();
    for friction in laws().into_iter().filter(|friction| friction.presliding() == 0.0) {
        for (theta0, velocity0) in [(1.0, 0.0), (3.0, 0.2), (0.0, 4.0)] {
            let trajectory = trajectory(theta0, velocity0, friction, torque.clone(), 60.0);
            let mut ends = vec![0.0];
            ends.extend(trajectory.turning_times(0.0, 60.0).unwrap());
            ends.extend(trajectory.rests().iter().flat_map(|rest| [rest.0, rest.1]));
            ends.push(60.0);
            ends.sort_by(f64::total_cmp);
            for pair in ends.windows(2).filter(|pair| pair[0] < pair[1]) {
                let parts = 40.0 * (pair[1] - pair[0]).ceil();
                let half = 0.5 * (pair[1] - pair[0]) / parts;
                let mut work = 0.0;
                for i in 0..parts as usize {
                    let middle = pair[0] + (2.0 * i as f64 + 1.0) * half;
                    for (node, weight) in gauss() {
                        let t = middle + half * node;
                        let v = trajectory.velocity(t);
                        let drag = 2.0 * friction.linear() * v + friction.quadratic() * v.abs() * v;
                        let dry = if v == 0.0 { 0.0 } else { friction.dry() * v.signum() };
                        work += weight * half * (torque.at(t) - drag - dry) * v;
                    }
                }
                let change = trajectory.energy(pair[1]) - trajectory.energy(pair[0]);
                assert!((work - change).abs() < 1e-12, "{friction:?} {pair:?} {work} {change}");
            }
        }
    }
}

/// Left and right are alike, bit for bit.
#[test]
fn mirrored_motions_are_mirrored() {
    for friction in laws() {
        for (theta0, velocity0) in [(1.0, 0.0), (3.0, 0.2), (0.5, 5.0)] {
            let torque = |side: f64| Torque::new(0.1 * side, 0.3 * side, 1.1, 0.4).unwrap();
            let right = trajectory(theta0, velocity0, friction, torque(1.0), 40.0);
            let left = trajectory(-theta0, -velocity0, friction, torque(-1.0), 40.0);
            for i in 0..=400 {
                let t = 0.1 * f64::from(i);
                let ((a, v), (b, w)) = (right.motion(t), left.motion(t));
                assert_eq!((a, v), (-b, -w), "{friction:?} {t}");
            }
        }
    }
}

/// Other units of time and angle of the same motion: a power of two of the seconds, bit for bit.
#[test]
fn units_of_time_are_free() {
    let friction = Friction::new(0.02, 0.03, 0.05, 0.0).unwrap();
    let slow = trajectory(2.0, 0.3, friction, Torque::NONE, 30.0);
    let friction = Friction::new(0.02 * 256.0, 0.03, 0.05 * 65536.0, 0.0).unwrap();
    let force = Frequency::from_omega2(1.5 * 65536.0).unwrap();
    let pendulum = DampedPendulum::new(2.0, 0.3 * 256.0, force, friction, Torque::NONE).unwrap();
    let fast = pendulum.trajectory(0.0, 30.0 / 256.0).unwrap();
    for i in 0..300 {
        let t = 0.1 * f64::from(i);
        let ((a, v), (b, w)) = (slow.motion(t), fast.motion(t / 256.0));
        assert_eq!((a, v * 256.0), (b, w), "{t}");
    }
}

/// A motion continued from its state in between is the same motion.
#[test]
fn parts_compose() {
    for friction in laws().into_iter().filter(|friction| friction.presliding() == 0.0) {
        let whole = trajectory(2.0, 0.5, friction, Torque::new(0.2, 0.0, 0.0, 0.0).unwrap(), 30.0);
        for middle in [0.7, 3.3, 9.1] {
            let (theta, velocity) = whole.motion(middle);
            let torque = Torque::new(0.2, 0.0, 0.0, 0.0).unwrap();
            let rest = trajectory(theta, velocity, friction, torque, 30.0 - middle);
            for i in 0..200 {
                let t = 0.1 * f64::from(i);
                let ((a, v), (b, w)) = (whole.motion(middle + t), rest.motion(t));
                assert!((a - b).abs() < 3e-14 && (v - w).abs() < 3e-14, "{friction:?} {middle} {t} {a} {b}");
            }
        }
    }
}

/// Backward from a state that moves, through turns, to the start.
#[test]
fn time_runs_backward() {
    for friction in laws().into_iter().filter(|friction| friction.presliding() == 0.0) {
        let forward = trajectory(2.0, 0.5, friction, Torque::NONE, 20.0);
        let (theta, velocity) = forward.motion(20.0);
        let pendulum = DampedPendulum::new(theta, velocity, frequency(), friction, Torque::NONE).unwrap();
        let backward = pendulum.trajectory(-20.0, 5.0).unwrap();
        for i in 0..=200 {
            let t = 0.1 * f64::from(i);
            let ((a, v), (b, w)) = (forward.motion(t), backward.motion(t - 20.0));
            assert!((a - b).abs() < 1e-12 && (v - w).abs() < 1e-12, "{friction:?} {t} {a} {b}");
        }
    }
}

/// The derivative by a later time's state times that by the start is the whole.
#[test]
fn derivatives_compose() {
    for friction in laws().into_iter().filter(|friction| friction.presliding() == 0.0) {
        let whole = trajectory(2.0, 0.5, friction, Torque::NONE, 20.0);
        let (theta, velocity) = whole.motion(7.0);
        let early = DampedSensitivity::new(&whole).unwrap().at(7.0);
        let late = trajectory(theta, velocity, friction, Torque::NONE, 13.0);
        let late = DampedSensitivity::new(&late).unwrap().at(13.0);
        let all = DampedSensitivity::new(&whole).unwrap().at(20.0);
        for i in 0..9 {
            if i == 6 {
                continue; // there is no presliding
            }
            let own = if i < 2 { 0.0 } else { late.theta[i] };
            let composed = late.theta[0] * early.theta[i] + late.theta[1] * early.velocity[i] + own;
            let slack = 1e-11 * (1.0 + all.theta[i].abs());
            assert!((composed - all.theta[i]).abs() < slack, "{friction:?} {i} {composed} {}", all.theta[i]);
        }
    }
}

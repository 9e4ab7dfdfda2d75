//! What a trajectory says about itself agrees: slices and scalars, passages and angles, turns and velocities, rests.

use crate::ruler::bits;
use libration::damped::{LazyTrajectory, Tolerance};
use libration::{
    DampedPendulum, DampedSensitivity, Frequency, Friction, InstructionSet, Interpolation, Orbit, Torque,
    Trajectory,
};

fn force() -> Frequency {
    Frequency::from_omega2(2.0).unwrap()
}

/// Motions of every kind.
fn trajectories() -> Vec<Trajectory> {
    let of = |theta0, velocity0, [linear, quadratic, dry, presliding]: [f64; 4], torque: Torque| {
        let friction = Friction::new(linear, quadratic, dry, presliding).unwrap();
        let pendulum = DampedPendulum::new(theta0, velocity0, force(), friction, torque).unwrap();
        let start = if presliding == 0.0 { -1.5 } else { 0.0 };
        pendulum.trajectory(start, 50.0).unwrap()
    };
    let times: Vec<f64> = (0..60).map(f64::from).map(|i| i - 4.0).collect();
    let values: Vec<f64> = times.iter().map(|t| (1.7 * t).sin()).collect();
    let drive = Torque::new(0.1, 0.75, 0.8, 0.3).unwrap();
    let sampled = |kind| Torque::NONE.with_samples(&times, &values, kind).unwrap();
    vec![
        of(2.5, 0.3, [0.02, 0.0, 0.0, 0.0], Torque::NONE),
        of(-1.0, 0.7, [0.0, 0.1, 0.0, 0.0], Torque::NONE),
        of(2.0, 0.5, [0.0, 0.0, 0.1, 0.0], Torque::NONE),
        of(0.3, 9.0, [0.01, 0.05, 0.05, 0.0], Torque::NONE),
        of(1.5, 0.4, [0.0, 0.0, 0.1, 0.02], Torque::NONE),
        of(0.2, 0.1, [0.1, 0.0, 0.4, 0.0], drive),
        of(0.5, -0.2, [0.05, 0.0, 0.05, 0.0], sampled(Interpolation::Lines)),
        of(0.5, -0.2, [0.05, 0.2, 0.0, 0.0], sampled(Interpolation::Cubics)),
        of(0.5, -0.2, [0.05, 0.0, 0.3, 0.0], sampled(Interpolation::Steps)),
        of(2.0, 1.0, [0.0, 0.0, 0.5, 0.0], Torque::NONE),
        of(2.0, 0.1, [0.0; 4], Torque::NONE),
    ]
}

fn times(trajectory: &Trajectory) -> Vec<f64> {
    let (start, stop) = trajectory.interval();
    (0..=997).map(|i| start + (stop - start) * f64::from(i) / 997.0).collect()
}

#[test]
fn slices_are_their_scalars() {
    for trajectory in trajectories() {
        let mut t = times(&trajectory);
        t.extend([f64::NAN, 51.0, -2.0, 0.0, 50.0]);
        let (mut theta, mut velocity) = (vec![1.0; t.len()], vec![1.0; t.len()]);
        trajectory.motion_into(&t, &mut theta, &mut velocity);
        let sensitivity = DampedSensitivity::new(&trajectory).unwrap();
        let mut columns = vec![vec![0.0; t.len()]; 22];
        let mut slots: Vec<&mut [f64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
        sensitivity.at_into(&t, slots.as_mut_slice().try_into().map_err(|_| ()).map(take).unwrap());
        for (i, t) in t.iter().enumerate() {
            let (a, v) = trajectory.motion(*t);
            assert_eq!([bits(a), bits(v)], [bits(theta[i]), bits(velocity[i])], "{t}");
            assert_eq!(bits(trajectory.theta(*t)), bits(a));
            assert_eq!(bits(trajectory.velocity(*t)), bits(v));
            let slopes = sensitivity.at(*t);
            for (column, slope) in columns.iter().zip(slopes.theta.iter().chain(&slopes.velocity)) {
                assert_eq!(bits(column[i]), bits(*slope), "{t}");
            }
        }
        assert!(theta[998..1001].iter().all(|theta| theta.is_nan()));
        assert!(theta[1001..].iter().all(|theta| !theta.is_nan()));
    }
}

fn take<'a>(slots: &mut [&'a mut [f64]; 22]) -> [&'a mut [f64]; 22] {
    slots.each_mut().map(std::mem::take)
}

/// Steps on other instruction sets are other steps: the motion is the same to rounding.
#[test]
fn instruction_sets_agree() {
    let reference = InstructionSet::Plain.scope(trajectories).unwrap();
    for set in InstructionSet::available() {
        for (a, b) in reference.iter().zip(set.scope(trajectories).unwrap()) {
            for t in times(a) {
                let ((theta, velocity), (other, speed)) = (a.motion(t), b.motion(t));
                let slack = 1e-14 * (1.0 + theta.abs());
                assert!((theta - other).abs() <= slack && (velocity - speed).abs() <= 1e-13, "{set:?} {t}");
            }
        }
    }
}

#[test]
fn passages_are_where_the_angle_is() {
    for trajectory in trajectories() {
        let (start, stop) = trajectory.interval();
        let mut found = 0;
        for i in -8..8 {
            let theta = 0.31 * f64::from(i) + 0.05;
            let times = trajectory.times(theta, start, stop).unwrap();
            for t in &times {
                let (at, velocity) = trajectory.motion(*t);
                assert!((at - theta).abs() <= 1e-14 * (1.0 + velocity.abs() * t.abs()), "{theta} {t} {at}");
            }
            // Between passages the angle stays on one side: as many as sign changes on a fine grid, or more.
            let grid: Vec<f64> =
                (0..=20_000).map(|i| trajectory.theta(start + (stop - start) * f64::from(i) / 2e4)).collect();
            let changes = grid.windows(2).filter(|pair| (pair[0] > theta) != (pair[1] > theta)).count();
            assert!(
                times.len() >= changes && (times.len() - changes) % 2 == 0,
                "{theta} {} {changes}",
                times.len()
            );
            found += times.len();
        }
        assert!(found > 0);
    }
}

#[test]
fn turning_times_are_where_the_velocity_vanishes() {
    for trajectory in trajectories() {
        let (start, stop) = trajectory.interval();
        let turning = trajectory.turning_times(start, stop).unwrap();
        for t in &turning {
            assert!(trajectory.velocity(*t).abs() < 1e-13, "{t} {}", trajectory.velocity(*t));
        }
        let grid: Vec<f64> =
            (0..=20_000).map(|i| trajectory.velocity(start + (stop - start) * f64::from(i) / 2e4)).collect();
        let changes = grid.windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count();
        assert!(turning.len() >= changes && turning.len() <= changes + 3, "{} {changes}", turning.len());
        assert!(turning.windows(2).all(|pair| pair[0] < pair[1]));
    }
}

#[test]
fn rests_are_still() {
    let mut rests = 0;
    for trajectory in trajectories() {
        for (from, to) in trajectory.rests() {
            assert!(from < to);
            rests += 1;
            let theta = trajectory.theta(0.5 * (from + to));
            for part in [0.1, 0.4, 0.9] {
                assert_eq!(trajectory.motion(from + part * (to - from)), (theta, 0.0));
            }
            let pendulum = trajectory.pendulum();
            let pull = pendulum.torque().at(0.5 * (from + to)) - 2.0 * theta.sin();
            assert!(pull.abs() <= pendulum.friction().dry() * (1.0 + 1e-12));
        }
    }
    assert!(rests > 5, "{rests}");
}

#[test]
fn turns_and_angles_agree() {
    for trajectory in trajectories() {
        for t in times(&trajectory) {
            let (theta, turns) = (trajectory.theta(t), trajectory.turns(t));
            assert!(turns.angle.abs() <= std::f64::consts::PI);
            let back = turns.angle + std::f64::consts::TAU * turns.count as f64;
            assert!((back - theta).abs() <= 1e-14 * (1.0 + theta.abs()), "{t}");
        }
    }
}

/// Under linear friction the decrement of small swings is gamma times the period.
#[test]
fn the_decrement_of_small_swings() {
    let friction = Friction::new(0.05, 0.0, 0.0, 0.0).unwrap();
    let frequency = Frequency::from_omega0(2.0).unwrap();
    let pendulum = DampedPendulum::new(1e-5, 0.0, frequency, friction, Torque::NONE).unwrap();
    let decrements = pendulum.trajectory(0.0, 40.0).unwrap().decrements(0.0, 40.0).unwrap();
    let period = std::f64::consts::TAU / (4.0f64 - 0.05 * 0.05).sqrt();
    assert!(decrements.len() > 20);
    for (_, decrement) in decrements {
        assert!((decrement - 0.05 * period).abs() < 1e-9, "{decrement}");
    }
}

/// What was asked before changes no bit, and what is not reached is NaN.
#[test]
fn lazy_trajectories_are_trajectories() {
    for trajectory in trajectories() {
        let lazy = LazyTrajectory::new(trajectory.pendulum().clone());
        for t in times(&trajectory) {
            let ((a, v), (b, w)) = (lazy.reaching(&[t]).motion(t), trajectory.motion(t));
            assert_eq!([bits(a), bits(v)], [bits(b), bits(w)], "{t}");
        }
        let all = times(&trajectory);
        let sensitivity = lazy.sensitivity(&all).unwrap();
        let whole = DampedSensitivity::new(&trajectory).unwrap();
        for t in all {
            let (a, b) = (sensitivity.at(t), whole.at(t));
            assert_eq!(a.theta.map(bits), b.theta.map(bits));
        }
    }
    let driving = Friction::new(0.0, -0.5, 0.0, 0.0).unwrap();
    let free = Frequency::from_omega2(0.0).unwrap();
    let lazy = LazyTrajectory::new(DampedPendulum::new(0.0, 3.0, free, driving, Torque::NONE).unwrap());
    for _ in 0..2 {
        let trajectory = lazy.reaching(&[0.5, 1.0, f64::NAN]);
        assert!((trajectory.velocity(0.5) - 12.0).abs() < 1e-13);
        assert!(trajectory.velocity(1.0).is_nan() && trajectory.velocity(f64::NAN).is_nan());
    }
    let refused = lazy.over(0.0, 1.0).unwrap_err().to_string();
    assert!(refused.starts_with("stop = 1.0: must be before 0.666"), "{refused}");
    assert_eq!(lazy.over(0.0, f64::NAN).unwrap_err().to_string(), "stop = NaN: must be finite");
}

/// So many of the first derivatives as are asked for are those of all, bit for bit; others are not.
#[test]
fn the_first_derivatives_are_those_of_all() {
    for trajectory in trajectories() {
        let whole = DampedSensitivity::new(&trajectory).unwrap();
        for count in [1, 4, 5, 8, 9, 11] {
            let first = DampedSensitivity::first(&trajectory, count).unwrap();
            for t in times(&trajectory) {
                let (a, b) = (first.at(t), whole.at(t));
                assert_eq!(a.theta.map(bits)[..count], b.theta.map(bits)[..count], "{count} at {t}");
                assert_eq!(a.velocity.map(bits)[..count], b.velocity.map(bits)[..count], "{count} at {t}");
            }
        }
    }
    let trajectory = &trajectories()[0];
    let (few, all) =
        (DampedSensitivity::first(trajectory, 4).unwrap(), DampedSensitivity::new(trajectory).unwrap());
    assert_ne!(few.at(20.0).theta.map(bits)[4..], all.at(20.0).theta.map(bits)[4..]);
}

/// Of the same states: the energy of an orbit; also where it hangs from the other side.
#[test]
fn energies_are_those_of_orbits() {
    let mut all = trajectories();
    let friction = Friction::new(0.1, 0.0, 0.0, 0.0).unwrap();
    let upside_down = Frequency::from_omega2(-2.0).unwrap();
    let pendulum = DampedPendulum::new(0.1, 0.0, upside_down, friction, Torque::NONE).unwrap();
    all.push(pendulum.trajectory(0.0, 30.0).unwrap());
    for trajectory in all {
        for t in times(&trajectory) {
            let (theta, velocity) = trajectory.motion(t);
            let orbit = Orbit::new(theta, velocity, trajectory.pendulum().frequency()).unwrap();
            let (energy, truth) = (trajectory.energy(t), orbit.energy());
            assert!((energy - truth).abs() <= 1e-15 * truth.max(1e-300), "{t} {energy} {truth}");
        }
    }
    assert!(trajectories()[0].energy(51.0).is_nan());
}

/// Steps that leave out 2^-44 of the motion are longer; over 110 swings of 9 steps each what they leave out turns the phase by less than
/// 1000 700/2 2^-44 = 2e-8. A motion that has an exact form is integrated where that is asked for.
#[test]
fn loose_steps_are_longer_and_lose_little() {
    for friction in [[0.004, 0.01, 0.02, 0.0], [0.0; 4]] {
        let [linear, quadratic, dry, presliding] = friction;
        let friction = Friction::new(linear, quadratic, dry, presliding).unwrap();
        let pendulum = DampedPendulum::new(1.5, 0.0, force(), friction, Torque::NONE).unwrap();
        let of = |tolerance| pendulum.integrated_unless(0.0, 500.0, tolerance, &|| false);
        let (tight, loose) = (of(Tolerance::Tight), of(Tolerance::Loose));
        assert!(10 * loose.steps() < 7 * tight.steps(), "{} {}", loose.steps(), tight.steps());
        let off = |a: &Trajectory, b: &Trajectory| {
            (0..5000).map(|i| 0.1 * f64::from(i)).map(|t| (a.theta(t) - b.theta(t)).abs()).fold(0.0, f64::max)
        };
        let far = off(&tight, &loose);
        assert!(far > 0.0 && far < 2e-8, "{far:e}");
        let promised = pendulum.trajectory(0.0, 500.0).unwrap();
        assert!(off(&tight, &promised) < 1e-12);
        assert_eq!(promised.steps() == 0, linear == 0.0);
    }
}

/// Where not even the first step is possible, the start is still there.
#[test]
fn a_start_that_goes_nowhere() {
    let driving = Friction::new(0.0, -1e200, 0.0, 0.0).unwrap();
    let pendulum = DampedPendulum::new(1.0, 2.0, force(), driving, Torque::NONE).unwrap();
    let trajectory = pendulum.reachable(0.0, 1e-3);
    assert_eq!(trajectory.motion(0.0), (1.0, 2.0));
    assert_eq!((trajectory.interval(), trajectory.steps()), ((0.0, 0.0), 1));
    assert_eq!(trajectory.turns(0.0).angle, 1.0);
    assert!(trajectory.theta(1e-3).is_nan());
    let _ = DampedSensitivity::new(&trajectory).unwrap().at(0.0);
}

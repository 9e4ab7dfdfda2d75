//! Passages: the angle at each is the angle asked for, and none is missing.

use libration::{Extremes, Frequency, Orbit, Regime, Turns};
use std::f64::consts::{PI, TAU};

use crate::ruler::ulp;

/// Reproducible numbers in [0, 1).
struct Spread(u64);

impl Spread {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

fn unit() -> Frequency {
    Frequency::from_omega0(1.0).unwrap()
}

/// What the angle at t lacks to the one asked for, in the unit of the promise.
fn error(orbit: &Orbit, theta: f64, t: f64) -> f64 {
    let Turns { count, angle } = orbit.turns(t);
    let found = if orbit.regime() == Regime::Libration {
        let difference = angle - theta;
        if difference.abs() < PI { difference } else { difference - TAU * (difference / TAU).round() }
    } else {
        (TAU * (count as f64) - theta) + angle
    };
    let scale = if orbit.regime() == Regime::Libration { orbit.theta_max() } else { theta.abs().max(PI) };
    found.abs() / (4.0 * ulp(scale.max(theta.abs())) + orbit.velocity(t).abs() * ulp(t))
}

#[test]
fn the_motion_is_at_the_angle() {
    let mut spread = Spread(7);
    let mut passages = 0;
    for _ in 0..20_000 {
        let orbit = Orbit::new(spread.between(-3.1, 3.1), spread.between(-3.0, 3.0), unit()).unwrap();
        let reach = if orbit.regime() == Regime::Libration { orbit.theta_max() } else { 20.0 };
        let theta = reach * spread.between(-1.0, 1.0);
        let start = spread.between(-50.0, 50.0);
        for t in orbit.times(theta, start, start + 30.0).unwrap() {
            let error = error(&orbit, theta, t);
            assert!(error <= 1.0, "{orbit:?} {theta} {t}: {error}");
            passages += 1;
        }
    }
    assert!(passages > 50_000, "{passages}");
}

/// The brute force: signs of sin((theta(t) - angle)/2) at many times, for angles that are no turning angles.
fn counted(orbit: &Orbit, theta: f64, start: f64, stop: f64, samples: usize) -> usize {
    let times: Vec<f64> = (0..=samples).map(|i| start + (stop - start) * i as f64 / samples as f64).collect();
    let mut angles = vec![0.0; times.len()];
    orbit.theta_into(&times, &mut angles);
    let above = |angle: f64| angle > theta;
    angles.windows(2).filter(|pair| above(pair[0]) != above(pair[1])).count()
}

#[test]
fn no_passage_is_missing_and_none_too_many() {
    let mut spread = Spread(11);
    let (mut total, mut compared) = (0, 0);
    for _ in 0..101_000 {
        let orbit = Orbit::new(spread.between(-3.1, 3.1), spread.between(-2.5, 2.5), unit()).unwrap();
        let theta = spread.between(-3.1, 3.1);
        let start = spread.between(-30.0, 30.0);
        let stop = start + spread.between(0.0, 25.0);
        let times = orbit.times(theta, start, stop).unwrap();
        assert!(times.windows(2).all(|pair| pair[0] < pair[1]), "{times:?}");
        // A scan cannot see two passages within a step, as there are next to a turning point.
        let turning = orbit.regime() == Regime::Libration && (orbit.theta_max() - theta.abs()).abs() < 1e-7;
        let apart = times.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
        let seen = |samples: usize| !turning && apart > 2.0 * (stop - start) / samples as f64;
        if let Some(samples) = [500, 5_000, 100_000].into_iter().find(|samples| seen(*samples)) {
            let found = counted(&orbit, theta, start, stop, samples);
            assert_eq!(times.len(), found, "{orbit:?} {theta} {start} {stop} {times:?}");
            total += times.len();
            compared += 1;
        }
    }
    assert!(compared >= 100_000 && total > 90_000, "{compared} {total}");
}

#[test]
fn turning_points_count_once() {
    let mut spread = Spread(13);
    for _ in 0..2000 {
        let orbit = Orbit::new(spread.between(-3.0, 3.0), spread.between(-0.3, 0.3), unit()).unwrap();
        if orbit.regime() != Regime::Libration {
            continue;
        }
        let Extremes { lowest, highest } = orbit.extremes();
        assert_eq!(highest, orbit.theta_max());
        let period = orbit.period();
        let (start, stop) = (-3.25 * period, 3.25 * period);
        let turning = orbit.turning_times(start, stop).unwrap();
        assert_eq!(turning.len(), 13);
        let mut both = orbit.times(lowest, start, stop).unwrap();
        both.extend(orbit.times(highest, start, stop).unwrap());
        both.sort_by(f64::total_cmp);
        assert_eq!(both, turning);
        for t in turning {
            assert!(orbit.velocity(t).abs() <= 4.0 * (ulp(highest) + ulp(t)), "{orbit:?} {t}");
        }
        // Within 1e-12 of a turning point: two passages a swing, close to each other, or none.
        for inside in [1e-12, 1e-13, 1e-15] {
            let theta = highest * (1.0 - inside);
            if theta == highest {
                continue;
            }
            let times = orbit
                .times(theta, -0.25 * period + orbit_top(&orbit), 0.25 * period + orbit_top(&orbit))
                .unwrap();
            assert_eq!(times.len(), 2, "{orbit:?} {inside}");
            let expected = (2.0 * (highest - theta) / orbit_pull(highest)).sqrt();
            let half = 0.5 * (times[1] - times[0]);
            assert!(
                (half / expected - 1.0).abs() < 0.3 + 4.0 * ulp(times[1]) / expected,
                "{half} {expected}"
            );
            for t in times {
                assert!(error(&orbit, theta, t) <= 1.0);
            }
            assert!(orbit.times(highest * (1.0 + inside), start, stop).unwrap().is_empty());
        }
    }
}

/// A time at the highest point.
fn orbit_top(orbit: &Orbit) -> f64 {
    orbit.times(orbit.theta_max(), 0.0, orbit.period()).unwrap()[0]
}

fn orbit_pull(theta: f64) -> f64 {
    theta.sin()
}

#[test]
fn the_start_is_a_passage_and_ends_are_included() {
    for (theta0, velocity0) in
        [(1.0, 0.0), (1.0, 0.5), (-2.0, -0.1), (0.0, 1.0), (2.0, 3.0), (0.0, 2.0), (0.5, -4.0)]
    {
        let orbit = Orbit::new(theta0, velocity0, unit()).unwrap();
        assert_eq!(orbit.times(theta0, 0.0, 0.0).unwrap(), [0.0], "{theta0} {velocity0}");
        assert_eq!(orbit.times(theta0, 0.0, 1e-3).unwrap()[0], 0.0);
        assert_eq!(*orbit.times(theta0, -1e-3, 0.0).unwrap().last().unwrap(), 0.0);
    }
    // A rest passes nothing, nor does the unstable one; the separatrix never reaches the top.
    assert!(Orbit::new(0.0, 0.0, unit()).unwrap().times(0.0, 0.0, 1.0).unwrap().is_empty());
    let upright = Orbit::new(0.0, 0.0, Frequency::from_omega2(-1.0).unwrap()).unwrap();
    assert!(upright.times(0.0, 0.0, 1.0).unwrap().is_empty());
    let ridge = Orbit::new(0.0, 2.0, unit()).unwrap();
    let [t] = ridge.times(3.0, 0.0, 10.0).unwrap()[..] else { panic!() };
    assert!((t - 1.5f64.tan().asinh()).abs() < 1e-13, "{t}");
    assert!(ridge.times(4.0, -1e3, 1e3).unwrap().is_empty());
    // Without force; far turns; upside down.
    let free = Orbit::new(1.0, 2.0, Frequency::from_omega0(0.0).unwrap()).unwrap();
    assert_eq!(free.times(9.0, 0.0, 10.0).unwrap(), [4.0]);
    let turning = Orbit::new(1.0, -3.0, unit()).unwrap();
    let [t] = turning.times(-1000.0, 0.0, 1e4).unwrap()[..] else { panic!() };
    assert!((turning.theta(t) + 1000.0).abs() < 1e-11);
    let hanging = Orbit::new(3.0, 0.5, Frequency::from_omega2(-1.0).unwrap()).unwrap();
    for (theta, count) in [(3.0, 2), (3.3, 2), (PI, 2), (-2.9, 2), (0.3, 0)] {
        let times = hanging.times(theta, 0.0, hanging.period() * 0.999).unwrap();
        assert_eq!(times.len(), count, "{theta}");
        assert!(times.iter().all(|t| error(&hanging, theta, *t) <= 1.0), "{theta}");
    }
}

#[test]
fn tiny_swings_and_the_neighbours_of_the_separatrix() {
    for theta0 in [1e-9, 1e-100, 1e-200, 1e-300] {
        let orbit = Orbit::new(theta0, 0.0, unit()).unwrap();
        let times = orbit.times(0.5 * theta0, 0.0, TAU).unwrap();
        assert_eq!(times.len(), 2);
        assert!((times[0] - PI / 3.0).abs() < 1e-15, "{theta0} {times:?}");
        assert!(orbit.times(2.0 * theta0, 0.0, TAU).unwrap().is_empty());
    }
    for velocity0 in [f64::from_bits(2f64.to_bits() - 1), f64::from_bits(2f64.to_bits() + 1)] {
        let orbit = Orbit::new(0.0, velocity0, unit()).unwrap();
        for theta in [0.1, 3.0, 3.14159, PI] {
            let times = orbit.times(theta, 0.0, orbit.period()).unwrap();
            let reached = orbit.regime() == Regime::Rotation || theta < orbit.theta_max();
            assert_eq!(times.is_empty(), !reached, "{velocity0} {theta}");
            for t in times {
                assert!(
                    error(&orbit, theta, t) <= 1.0,
                    "{velocity0} {theta} {t} {}",
                    error(&orbit, theta, t)
                );
            }
        }
    }
}

#[test]
fn bad_intervals_say_what_is_wrong() {
    let orbit = Orbit::new(1.0, 0.0, unit()).unwrap();
    let said = |start, stop| orbit.times(0.5, start, stop).unwrap_err().to_string();
    assert_eq!(said(1.0, 0.0), "stop = 0.0: must be not before start, 1.0");
    assert_eq!(said(f64::NAN, 0.0), "start = NaN: must be a number");
    assert_eq!(said(0.0, f64::INFINITY), "passages from start to stop = inf: must be at most 10000000");
    let many = said(0.0, orbit.period() * 1e9);
    assert_eq!(many, "passages from start to stop = 2000000000: must be at most 10000000");
    assert_eq!(orbit.times(0.5, 0.0, orbit.period() * 5e6 * 0.9999).unwrap().len(), 9_999_000);
    assert!(orbit.times(0.5, 1e17, 1e17 + 64.0).is_err());
    assert!(orbit.times(f64::INFINITY, 0.0, 1.0).is_err());
    assert!(orbit.turning_times(0.0, 1e9).is_err());
}

/// Turning points next to the start keep their digits: the time to them is not a difference of phases.
#[test]
fn turning_points_next_to_the_start() {
    for theta0 in [0.1, 1.0, 2.9, -2.0] {
        for velocity0 in [1e-9, 1e-20, 1e-40, -1e-40, 1e-100] {
            let orbit = Orbit::new(theta0, velocity0, unit()).unwrap();
            // It turns when the pull has used up the velocity: t = velocity0/sin theta0, and on to the third order.
            let expected = velocity0 / theta0.sin();
            let times = orbit.turning_times(-1.0, 1.0).unwrap();
            assert_eq!(times.len(), 1, "{theta0} {velocity0}");
            let higher = 1e-15 + velocity0 * velocity0;
            assert!((times[0] / expected - 1.0).abs() < higher, "{theta0} {velocity0} {times:?} {expected}");
        }
    }
    let orbit = Orbit::new(0.0, 1.0, unit()).unwrap();
    let [top, bottom] = [1.0, -1.0].map(|side| orbit.times(side * orbit.theta_max(), 0.0, 6.0).unwrap());
    assert!(top.len() == 1 && bottom.len() == 1 && top[0] < bottom[0], "{top:?} {bottom:?}");
    // The double of the turning angle is the turning point, even where it is the double of the start.
    let orbit = Orbit::new(1.0, 1e-9, unit()).unwrap();
    assert_eq!(orbit.theta_max(), 1.0);
    assert_eq!(orbit.times(1.0, -1.0, 14.0).unwrap().len(), 3);
}

#[test]
fn extremes_next_to_the_top() {
    for theta0 in [1e-17, 1e-30, 1e-200, -1e-40, 0.1, -3.0] {
        let orbit = Orbit::new(theta0, 0.0, Frequency::from_omega2(-1.0).unwrap()).unwrap();
        let Extremes { lowest, highest } = orbit.extremes();
        let near = if theta0 > 0.0 { lowest } else { highest };
        assert_eq!(near, theta0);
        assert!((highest - lowest - 2.0 * orbit.theta_max()).abs() < 1e-15);
    }
    let far = Orbit::new(1e308, 2.0, Frequency::from_omega0(0.0).unwrap()).unwrap();
    assert_eq!(far.times(-1e308, f64::NEG_INFINITY, f64::INFINITY).unwrap(), [-1e308]);
}

#[test]
fn every_turn_is_passed_once() {
    let pi = std::f64::consts::PI;
    for (theta0, velocity0, omega2) in
        [(0.0, 3.0, 1.0), (20.0, -2.5, 1.0), (1.0, -9.0, -4.0), (0.3, 2.0, 0.0), (-1e3, 2.000_000_1, 1.0)]
    {
        let orbit = Orbit::new(theta0, velocity0, Frequency::from_omega2(omega2).unwrap()).unwrap();
        for theta in [0.0, pi, -2.0, 100.0] {
            let (start, stop) = (-7.0 * orbit.period(), 12.5 * orbit.period());
            let times = orbit.times_of_every_turn(theta, start, stop).unwrap();
            assert!(times.len() == 19 || times.len() == 20, "{theta0} {theta} {}", times.len());
            for (i, time) in times.iter().enumerate() {
                let turned = (orbit.theta(*time) - theta) / (2.0 * pi);
                assert!((turned - turned.round()).abs() < 1e-12, "{theta0} {theta} {time} {turned}");
                if i > 0 {
                    assert!(((time - times[i - 1]) / orbit.period() - 1.0).abs() < 1e-12);
                }
            }
            // The one in its own turn is among them.
            for own in orbit.times(theta, start, stop).unwrap() {
                assert!(times.iter().any(|time| (time - own).abs() < 1e-12 * orbit.period()), "{theta}");
            }
        }
    }
    // Other motions: modulo 2 pi already, once, and never.
    let swing = Orbit::new(2.0, 0.0, unit()).unwrap();
    assert_eq!(swing.times_of_every_turn(7.0, 0.0, 30.0).unwrap(), swing.times(7.0, 0.0, 30.0).unwrap());
    let separatrix = Orbit::new(0.0, 2.0, unit()).unwrap();
    let once = separatrix.times_of_every_turn(2.0 + 4.0 * pi, 0.0, 30.0).unwrap();
    assert!(once.len() == 1 && (separatrix.theta(once[0]) - 2.0).abs() < 1e-14, "{once:?}");
    let rest = Orbit::new(0.0, 0.0, unit()).unwrap();
    assert!(rest.times_of_every_turn(0.0, 0.0, 30.0).unwrap().is_empty());
    let rotation = Orbit::new(0.0, 3.0, unit()).unwrap();
    assert!(
        rotation.times_of_every_turn(0.0, 0.0, 1e9).unwrap_err().to_string().contains("at most 10000000")
    );
    assert!(rotation.times_of_every_turn(f64::NAN, 0.0, 1.0).is_err());
    assert!(rotation.times_of_every_turn(0.0, 1.0, 0.0).is_err());
}

//! What the motion must keep: energy over a billion periods and a million steps, composition, symmetry.

use libration::{Frequency, Orbit, Regime, Turns, advance};
use std::f64::consts::{PI, TAU};

/// Reproducible numbers in [0, 1): the fractional parts of multiples of the golden ratio's inverse.
fn spread(count: u32) -> impl Iterator<Item = f64> {
    (0..count).map(|i| (f64::from(i) * 0.618_033_988_749_894_9).fract())
}

fn unit() -> Frequency {
    Frequency::from_omega0(1.0).unwrap()
}

fn ulp(value: f64) -> f64 {
    f64::from_bits(value.abs().to_bits() + 1) - value.abs()
}

/// kappa^2 of a state with omega0 = 1.
fn energy_ratio(theta: f64, velocity: f64) -> f64 {
    let (s, x) = ((theta / 2.0).sin(), velocity / 2.0);
    s * s + x * x
}

#[test]
fn energy_stays_over_a_billion_periods() {
    for (i, part) in spread(4000).enumerate() {
        let (theta0, velocity0) = (6.2 * part - 3.1, 2.5 * (part * 77.0).sin());
        let orbit = Orbit::new(theta0, velocity0, unit()).unwrap();
        let period = orbit.period();
        let t = period * 10f64.powf(9.0 * (part * 13.0).fract()) * if i % 2 == 0 { 1.0 } else { -1.0 };
        let theta = orbit.turns(t).angle;
        let velocity = orbit.velocity(t);
        let slack = 4.0 * ((theta.sin() / 2.0).abs() * ulp(theta) + (velocity / 2.0).abs() * ulp(velocity));
        let drift = (energy_ratio(theta, velocity) - orbit.energy_ratio()).abs();
        assert!(drift <= slack + ulp(orbit.energy_ratio()), "{theta0} {velocity0} {t}: {drift} {slack}");
    }
}

#[test]
fn a_million_steps_keep_the_energy() {
    for (theta0, velocity0) in [(2.0, 0.0), (0.3, 0.1), (3.1, 0.05), (1.0, 2.5), (-2.0, -4.0)] {
        let (mut theta, mut velocity, mut lost) = (theta0, velocity0, 0.0);
        let start = Orbit::new(theta0, velocity0, unit()).unwrap().energy_ratio();
        for _ in 0..1_000_000 {
            (theta, velocity) = advance(theta, velocity, 0.3, unit());
            // The caller's wrap must not lean to one side: 2 pi rounded to a double would shift the angle by
            // 2.4e-16 the same way in each of 10^5 turns, more than the steps may. What a wrap loses is kept.
            if theta.abs() > PI {
                let turns = (theta / TAU).round();
                let wrapped = theta - TAU * turns;
                let shift = lost - 2.449_293_598_294_706_4e-16 * turns;
                theta = wrapped + shift;
                lost = shift - (theta - wrapped);
            }
        }
        let end = Orbit::new(theta, velocity, unit()).unwrap().energy_ratio();
        assert!((end / start - 1.0).abs() <= 1e-12, "{theta0} {velocity0}: {}", end / start - 1.0);
    }
}

#[test]
fn steps_compose_into_the_orbit_and_keep_their_turns() {
    for (theta0, velocity0) in [(2.0, 0.0), (1.0, 2.5), (-2.0, -4.0), (0.0, 2.0), (40.0, 3.0), (0.5, 1e-9)] {
        let orbit = Orbit::new(theta0, velocity0, unit()).unwrap();
        let (mut theta, mut velocity) = (theta0, velocity0);
        for i in 1..=64 {
            (theta, velocity) = advance(theta, velocity, 0.25, unit());
            let (expected, speed) = orbit.motion(0.25 * f64::from(i));
            assert!(
                (theta - expected).abs() < 1e-9 && (velocity - speed).abs() < 1e-9,
                "{theta0} {velocity0} {i}"
            );
        }
        for dt in [1e-3, 0.7, 3.0, 50.0, 1234.5, -17.0] {
            let (theta, velocity) = advance(theta0, velocity0, dt, unit());
            let (expected, speed) = orbit.motion(dt);
            let scale = expected.abs().max(theta0.abs()).max(PI);
            assert!((theta - expected).abs() < 8.0 * ulp(scale) && (velocity - speed).abs() < 8.0 * ulp(5.0));
        }
    }
}

#[test]
fn steps_that_are_no_steps() {
    for (theta0, velocity0, omega0) in
        [(1.0, 0.0, 1.0), (0.0, 2.0, 1.0), (0.0, 3.0, 1.0), (0.0, 0.0, 1.0), (1.0, 2.0, 0.0)]
    {
        let force = Frequency::from_omega0(omega0).unwrap();
        let orbit = Orbit::new(theta0, velocity0, force).unwrap();
        assert_eq!(advance(theta0, velocity0, 0.0, force), (theta0, velocity0));
        for dt in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300] {
            let (theta, velocity) = advance(theta0, velocity0, dt, force);
            let (expected, speed) = orbit.motion(dt);
            assert!(
                theta == expected || (theta.is_nan() && expected.is_nan()),
                "{theta0} {velocity0} {dt} {theta} {expected}"
            );
            assert!(velocity == speed || (velocity.is_nan() && speed.is_nan()), "{theta0} {velocity0} {dt}");
        }
    }
}

#[test]
fn reversal_reflection_and_whole_turns() {
    for part in spread(500) {
        let (theta0, velocity0, t) = (6.0 * part - 3.0, 5.0 * (part * 31.0).sin(), 40.0 * part);
        let orbit = Orbit::new(theta0, velocity0, unit()).unwrap();
        let mirrored = Orbit::new(-theta0, -velocity0, unit()).unwrap();
        assert_eq!(orbit.theta(t), -mirrored.theta(t));
        assert_eq!(orbit.velocity(t), -mirrored.velocity(t));
        let reversed = Orbit::new(theta0, -velocity0, unit()).unwrap();
        assert!((orbit.theta(t) - reversed.theta(-t)).abs() <= 2.0 * ulp(orbit.theta(t)).max(1e-24));
        let Turns { count, angle } = orbit.turns(t);
        assert!((-PI..PI).contains(&angle));
        assert!(
            (TAU * count as f64 + angle - orbit.theta(t)).abs() <= 4.0 * ulp(orbit.theta(t).abs().max(PI))
        );
    }
}

#[test]
fn the_period_returns_and_the_regimes_meet() {
    let neighbours = |velocity0| Orbit::new(0.0, velocity0, unit()).unwrap();
    let below = neighbours(f64::from_bits(2f64.to_bits() - 1));
    let above = neighbours(f64::from_bits(2f64.to_bits() + 1));
    let on = neighbours(2.0);
    assert_eq!(
        [below.regime(), on.regime(), above.regime()],
        [Regime::Libration, Regime::Separatrix, Regime::Rotation]
    );
    assert!((below.period() - 77.632_484_222_713_9).abs() < 1e-12);
    assert!((above.period() - 38.123_094_930_797).abs() < 1e-12);
    assert_eq!(on.period(), f64::INFINITY);
    let upright = Orbit::new(PI, 0.0, unit()).unwrap();
    assert_eq!(upright.regime(), Regime::Libration);
    assert!((upright.period() - 154.872_602_217_555).abs() < 1e-11);
    assert!(upright.energy_ratio_c() > 3.7493e-33 && upright.energy_ratio_c() < 3.7495e-33);
    // On both sides, and on it, the motion of the first seconds is the same to a rounding error.
    for t in [0.1, 1.0, 5.0, 10.0] {
        for orbit in [&below, &above] {
            assert!((orbit.theta(t) - on.theta(t)).abs() < 1e-15 * t.exp(), "{t}");
        }
    }
}

/// The regime is that of the doubles passed, down to the smallest of them.
#[test]
fn the_smallest_double_decides_the_regime() {
    let least = f64::from_bits(1);
    let of = |theta0, velocity0, omega2| {
        Orbit::new(theta0, velocity0, Frequency::from_omega2(omega2).unwrap()).unwrap()
    };
    for (orbit, regime) in [
        (of(least, 2.0, 1.0), Regime::Rotation),
        (of(least, 0.0, -1.0), Regime::Libration),
        (of(0.0, least, -1.0), Regime::Rotation),
        (of(0.0, 0.0, -1.0), Regime::Separatrix),
        (of(least, 0.0, 1.0), Regime::Libration),
        (of(0.0, least, 1.0), Regime::Libration),
        (of(0.0, 0.0, 1.0), Regime::Rest),
    ] {
        assert_eq!(orbit.regime(), regime);
        assert!(orbit.theta(1.0).is_finite() && orbit.velocity(1.0).is_finite());
        assert_eq!(orbit.period().is_finite(), regime != Regime::Separatrix);
    }
}

#[test]
fn what_has_no_period_has_no_end() {
    let on = Orbit::new(0.0, 2.0, unit()).unwrap();
    assert_eq!((on.theta(1e300), on.velocity(1e300)), (PI, 0.0));
    assert_eq!((on.theta(f64::NEG_INFINITY), on.velocity(f64::INFINITY)), (-PI, 0.0));
    assert!(on.theta(f64::NAN).is_nan() && on.velocity(f64::NAN).is_nan());
    let free = Orbit::new(0.5, 2.0, Frequency::from_omega0(0.0).unwrap()).unwrap();
    assert_eq!(free.theta(1e300), 2e300);
    assert!(free.theta(f64::INFINITY).is_nan() && free.velocity(f64::INFINITY).is_nan());
    assert_eq!(free.turns(f64::NEG_INFINITY).count, 0);
    assert_eq!(Orbit::new(0.0, 2e200, Frequency::from_omega0(1e200).unwrap()).unwrap().velocity(1.0), 0.0);
    let swing = Orbit::new(1.0, 0.0, unit()).unwrap();
    assert!(swing.theta(0.49 * 9e15 * swing.period()).is_finite());
    assert!(swing.theta(0.51 * 2f64.powi(53) * swing.period()).is_nan());
    assert!(swing.theta(f64::INFINITY).is_nan());
}

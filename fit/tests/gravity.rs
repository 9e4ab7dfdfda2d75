//! g from one period, of a swing that stays and of one that decays, and the normal g of a place.

use libration::{DampedPendulum, Frequency, Friction, Orbit, Torque};
use libration_fit::fit::Measure;
use libration_fit::{PeriodGravity, gravity_of_decay, gravity_of_period, normal_gravity};

fn exact(value: f64) -> Measure {
    Measure { value, u: 0.0 }
}

/// Of 1 m and g = 9.81 from 30 degrees.
fn period_of_30_degrees() -> f64 {
    let frequency = Frequency::from_gravity_length(9.81, 1.0).unwrap();
    Orbit::new(30f64.to_radians(), 0.0, frequency).unwrap().period()
}

#[test]
fn thirty_degrees_by_the_formula_of_small_swings_and_by_the_exact_law() {
    let period = period_of_30_degrees();
    let found = gravity_of_period(exact(period), exact(1.0), exact(30f64.to_radians())).unwrap();
    assert_eq!(format!("{:.3} {:.3}", found.g.value, found.small_swings), "9.810 9.477");
    assert!((found.g.value - 9.81).abs() < 1e-13, "{found:?}");
}

/// The share of each cause, and their sum of squares.
#[test]
fn the_budget_of_a_period() {
    let measure = |value, u| Measure { value, u };
    let swing = 30f64.to_radians();
    let found =
        gravity_of_period(measure(period_of_30_degrees(), 1e-3), measure(1.0, 2e-3), measure(swing, 0.02));
    let PeriodGravity { g, budget, .. } = found.unwrap();
    let [period, length, by_swing] = [0, 1, 2].map(|i: usize| budget[i].u);
    assert!((period - 2.0 * 9.81 * 1e-3 / period_of_30_degrees()).abs() < 1e-12);
    assert!((length - 9.81 * 2e-3).abs() < 1e-12);
    // 2 d ln K/d swing at 30 degrees by mpmath.
    assert!((by_swing / (9.81 * 0.132_813_503_295_872 * 0.02) - 1.0).abs() < 1e-4, "{by_swing}");
    assert!((g.u.powi(2) - budget.iter().map(|row| row.u.powi(2)).sum::<f64>()).abs() < 1e-15);
}

#[test]
fn a_swing_that_does_not_decay_is_the_swing() {
    for degrees in [0.5, 30.0, 120.0, 175.0] {
        let swing = exact(f64::to_radians(degrees));
        let alone = gravity_of_period(exact(2.0), exact(1.0), swing).unwrap();
        assert_eq!(gravity_of_decay(exact(2.0), exact(1.0), swing, swing).unwrap().g.value, alone.g.value);
        // And a little decay is near to it, from either side.
        let less = exact(swing.value * (1.0 - 1e-7));
        for (first, last) in [(swing, less), (less, swing)] {
            let near = gravity_of_decay(exact(2.0), exact(1.0), first, last).unwrap().g.value;
            assert!((near / alone.g.value - 1.0).abs() < 1e-5, "{degrees}");
        }
    }
}

/// g less 9.81, over 9.81, from periods that are counted on a trajectory with linear friction: by the integration and its events. And
/// by the first swing alone, and by the mean of the first and the last.
fn errors(degrees: f64, quality: f64) -> [f64; 3] {
    let omega0 = 9.81f64.sqrt();
    let frequency = Frequency::from_omega0(omega0).unwrap();
    let friction = Friction::new(0.5 * omega0 / quality, 0.0, 0.0, 0.0).unwrap();
    let pendulum = DampedPendulum::new(degrees.to_radians(), 0.0, frequency, friction, Torque::NONE).unwrap();
    let swings = 0.2 * quality;
    let trajectory = pendulum.trajectory(0.0, 8.0 * swings).unwrap();
    // Two turning points to a swing; the release is none among them.
    let end = trajectory.turning_times(1e-6, 8.0 * swings).unwrap()[2 * swings as usize - 1];
    let [period, first] = [end / swings, degrees.to_radians()].map(exact);
    let last = exact(trajectory.theta(end).abs());
    let middle = exact(0.5 * (first.value + last.value));
    let by_decay = gravity_of_decay(period, exact(1.0), first, last).unwrap();
    let by = |swing| gravity_of_period(period, exact(1.0), swing).unwrap();
    [by_decay, by(first), by(middle)].map(|found| found.g.value / 9.81 - 1.0)
}

/// What is left is of second order in the friction: it falls to a sixteenth where the friction falls to a fourth. The first swing
/// alone, and the mean of both, are wrong however small the friction.
#[test]
fn the_mean_period_of_a_decay_gives_g() {
    for degrees in [40.0, 80.0, 150.0] {
        let [large, small] = [200.0, 800.0].map(|quality| errors(degrees, quality));
        assert!(
            large[0].abs() < 5e-4 && small[0].abs() < large[0].abs() / 12.0,
            "{degrees}: {large:?} {small:?}"
        );
        for spoiled in [1, 2] {
            assert!(small[spoiled].abs() > 5e-4, "{degrees}: {small:?}");
        }
    }
}

#[test]
fn uncertainties_of_both_angles_count() {
    let g = |first_u: f64, last_u: f64| {
        let measure = |degrees: f64, u: f64| Measure { value: degrees.to_radians(), u };
        gravity_of_decay(exact(2.0), exact(1.0), measure(40.0, first_u), measure(20.0, last_u)).unwrap().g.u
    };
    let [both, first, last] = [g(0.02, 0.01), g(0.02, 0.0), g(0.0, 0.01)];
    assert!(first > 0.0 && last > 0.0);
    assert!((both - first.hypot(last)).abs() < 1e-12);
    assert_eq!(g(0.0, 0.0), 0.0);
}

#[test]
fn what_is_out_of_range_is_named() {
    let refused = |period: f64, first: f64, last: f64| {
        gravity_of_decay(exact(period), exact(1.0), exact(first), exact(last)).unwrap_err().to_string()
    };
    assert!(refused(-2.0, 1.0, 0.5).starts_with("period = -2 s: must be greater than 0"));
    assert!(
        refused(2.0, 4.0, 0.5).starts_with("swing = 4 rad: must be greater than 0 and less than 3.14159")
    );
    assert!(refused(2.0, 1.0, 0.0).starts_with("swing at the end = 0 rad"));
}

/// Londrina: not 9.81.
#[test]
fn the_normal_g_of_a_city() {
    let g = normal_gravity((-23.3f64).to_radians(), 585.0).unwrap();
    assert_eq!(format!("{g:.3}"), "9.787");
}

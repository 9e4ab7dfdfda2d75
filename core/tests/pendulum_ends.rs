//! The pendulum at the ends of the range of doubles: values from mpmath with 700 digits, by the formulas in the comments.

use crate::on_every_set;
use libration::pendulum::action::state_of;
use libration::{Frequency, Orbit, Regime, Sensitivity, Turns, advance};
use std::f64::consts::PI;

fn orbit(theta0: f64, velocity0: f64, omega0: f64) -> Orbit {
    Orbit::new(theta0, velocity0, Frequency::from_omega0(omega0).unwrap()).unwrap()
}

fn force_free(theta0: f64, velocity0: f64) -> Orbit {
    orbit(theta0, velocity0, 0.0)
}

fn close(got: f64, truth: f64) {
    assert!((got - truth).abs() <= 2.0 * f64::EPSILON * truth.abs(), "{got:e} {truth:e}");
}

/// mpf(theta0) + mpf(velocity0)*mpf(t), rounded: infinite only where the sum is beyond the doubles, not its product.
#[test]
fn without_a_force_only_the_angle_itself_overflows() {
    on_every_set(|set| {
        for (theta0, velocity0, t, truth) in [
            (0.0, 1e308, 1e308, f64::INFINITY),
            (0.0, -1e308, 1e308, f64::NEG_INFINITY),
            (-1e308, f64::MAX, f64::MAX, f64::INFINITY),
            (-1e308, 1e300, 2e8, 1.000000000000000094e308),
            (-1.7e308, 1.7e308, 2.0, 1.7e308),
            (1e308, -1e308, 1.5, -5e307),
            (0.0, 1e308, 1e-300, 1e8),
            (0.5, 1e308, 1e-300, 100000000.5),
            (1.0, 5e-324, 1e308, 1.0000000000000004),
            (0.0, 5e-324, f64::MAX, 8.881784197001251e-16),
            (1e-300, 1e-200, 1e-200, 1e-300),
        ] {
            let orbit = force_free(theta0, velocity0);
            for got in [orbit.theta(t), orbit.motion(t).0, orbit.phase(t)] {
                assert_eq!(got, truth, "{set:?} {theta0:e} {velocity0:e} {t:e}");
            }
            let free = Frequency::from_omega0(0.0).unwrap();
            assert_eq!(advance(theta0, velocity0, t, free), (truth, velocity0), "{set:?}");
            let (mut theta, mut velocity) = ([0.0; 17], [0.0; 17]);
            orbit.motion_into(&[t; 17], &mut theta, &mut velocity);
            assert_eq!((theta, velocity), ([truth; 17], [velocity0; 17]), "{set:?}");
        }
        for t in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
            let orbit = force_free(0.5, 1e308);
            assert!(orbit.theta(t).is_nan() && orbit.velocity(t).is_nan() && orbit.phase(t).is_nan());
            // At rest time does not count, but for none at all.
            let rest = force_free(1e308, 0.0);
            assert_eq!(rest.theta(t).is_nan(), t.is_nan());
            assert_eq!(rest.velocity(t).is_nan(), t.is_nan());
        }
    });
}

/// n = nint(theta/(2*pi)), theta - 2*pi*n.
#[test]
fn turns_are_counted_exactly_or_not_at_all() {
    let turned = |orbit: &Orbit, t: f64, count: i64, angle: f64| {
        let got = orbit.turns(t);
        assert_eq!(got.count, count);
        close(got.angle, angle);
    };
    for (theta0, count, angle) in [
        (5e19, 7957747154594766788, 2.7909165747321205474),
        (-5e19, -7957747154594766788, -2.7909165747321205474),
        (5.7e19, 9071831756238034139, -1.0909211136875013803),
    ] {
        turned(&orbit(theta0, 0.0, 1.0), 0.0, count, angle);
        turned(&orbit(theta0, 3.0, 1.0), 0.0, count, angle);
        turned(&force_free(theta0, 0.0), 7.0, count, angle);
        turned(&force_free(0.0, theta0), 1.0, count, angle);
    }
    // 1e18 + 15.5*3e18.
    turned(&force_free(1e18, 3e18), 15.5, 7559859796865028449, 0.13809662312367992923);
    // odefun(theta'' = -sin(theta)) from the rest of 5e19 with velocity 3, at t = 4.
    turned(&orbit(5e19, 3.0, 1.0), 4.0, 7957747154594766791, -2.9987184620027952469);
    // The number of turns leaves its type at 5.795e19.
    for theta0 in [5.8e19, -5.8e19, 8.31e34, 2f64.powi(116), 1e300, -f64::MAX] {
        for orbit in [orbit(theta0, 0.0, 1.0), orbit(theta0, 3.0, 1.0), force_free(theta0, 0.0)] {
            let Turns { count, angle } = orbit.turns(0.0);
            assert!(count == 0 && angle.is_nan(), "{theta0}");
        }
    }
    let Turns { count, angle } = force_free(0.0, 1e308).turns(1e308);
    assert!(count == 0 && angle.is_nan());
}

/// A double below -pi, which one turn on rounds to pi: that is minus itself another turn on, in every regime.
#[test]
fn the_rest_is_never_pi_itself() {
    let below = (-PI).next_down();
    for orbit in [orbit(below, 0.0, 1.0), force_free(below, 0.0)] {
        let Turns { count, angle } = orbit.turns(0.0);
        assert_eq!((count, angle), (0, -PI));
    }
    for theta0 in [below, -PI, PI, PI.next_up(), 3.0 * PI, -3.0 * PI, (-3.0 * PI).next_down()] {
        for orbit in [orbit(theta0, 0.0, 1.0), orbit(theta0, 3.0, 1.0), force_free(theta0, 0.0)] {
            let Turns { count, angle } = orbit.turns(0.0);
            assert!((-PI..PI).contains(&angle), "{theta0:e} {angle:e}");
            assert!((count as f64 * 2.0 * PI + angle - theta0).abs() < 4e-15, "{theta0:e} {count} {angle:e}");
        }
    }
}

/// Far out the angle and the phase of a rotation are the start and a few turns: theta0 + nothing, in doubles.
#[test]
fn rotations_far_out_keep_their_start() {
    for theta0 in [8.31e34, 2f64.powi(116), 1e300] {
        let orbit = orbit(theta0, 3.0, 1.0);
        assert_eq!(orbit.regime(), Regime::Rotation);
        for t in [0.0, 1.0, -20.0] {
            assert_eq!((orbit.theta(t), orbit.phase(t)), (theta0, theta0));
        }
        assert_eq!(orbit.times(theta0, -1.0, 1.0).unwrap(), [0.0]);
        // A double away there are more turns than half periods may pass.
        assert!(orbit.times(theta0 * (1.0 + f64::EPSILON), -1.0, 1.0).is_err());
    }
}

/// (mpf(theta) - theta0)/mpf(velocity0).
#[test]
fn passages_without_a_force_at_the_ends_of_the_range() {
    let (least, always) = (f64::from_bits(1), [f64::NEG_INFINITY, f64::INFINITY]);
    let times = |orbit: Orbit, theta: f64| orbit.times(theta, always[0], always[1]).unwrap();
    assert_eq!(times(force_free(1.0, least), 1.0), [0.0]);
    // 1/5e-324 is beyond the doubles.
    assert!(times(force_free(1.0, least), 2.0).is_empty());
    // 2^-52/2^-1074
    assert_eq!(times(force_free(1.0, least), 1.0 + f64::EPSILON), [2f64.powi(1022)]);
    assert_eq!(times(force_free(-f64::MAX, 2.0), f64::MAX), [f64::MAX]);
    assert_eq!(times(force_free(0.0, f64::MAX), f64::MAX), [1.0]);
}

/// (mpf(velocity0)/(2*omega0))**2 with omega0 = 0.75*2^600.
#[test]
fn the_energy_of_a_motion_without_a_force_that_counts() {
    let orbit = orbit(0.0, 1.7e308, 0.75 * 2f64.powi(600));
    assert_eq!(orbit.regime(), Regime::Rotation);
    close(orbit.energy_ratio(), 7.4596856690971479964e254);
    close(orbit.energy_ratio_c(), -7.4596856690971479964e254);
    assert_eq!(force_free(0.0, 3.0).energy_ratio(), f64::INFINITY);
}

/// The force is less than 2^-100 of the motion: theta0 = phase, velocity0 = action.
#[test]
fn an_action_beyond_the_force() {
    for omega0 in [1e-5, 1e-300, 5e-324] {
        let state = state_of(1e308, 0.5, -1.0, Frequency::from_omega0(omega0).unwrap());
        assert_eq!(state, Ok((0.5, -1e308)));
    }
    // 2 kappa omega0 with E(m) - (1 - m) K(m) = pi J/8 omega0, m = kappa^2, is 1.9418e308.
    let refused = state_of(1.75e308, 0.0, 0.0, Frequency::from_omega0(1.2e308).unwrap()).unwrap_err();
    assert_eq!(
        refused.to_string(),
        "action = 1.75e308: must be such that the velocity stays in the range of doubles"
    );
}

/// A swing next to pi is held by theta0 to half a unit u of its last place: the action changes by no more than
/// omega0^2 (|sin theta0| u + u^2/2)/|frequency|.
#[test]
fn actions_come_back_as_far_as_the_angle_holds_them() {
    let hanging = Frequency::from_omega2(-3.0).unwrap();
    let u = f64::EPSILON; // half a unit in [2, 4), and more than that below
    for action in [1e-157, 1e-40, 1e-33, 1e-20, 1e-10, 1e-3, 1.0, 4.0] {
        for phase in [0.3, PI / 2.0, 2.0, -1.0] {
            let (theta0, velocity0) = state_of(action, phase, 0.0, hanging).unwrap();
            let orbit = Orbit::new(theta0, velocity0, hanging).unwrap();
            assert_eq!(orbit.regime(), Regime::Libration);
            let bound = 3.0 * (theta0.sin().abs() * u + 0.5 * u * u) / orbit.frequency();
            let error = (orbit.action() - action).abs();
            assert!(error <= bound + 8.0 * f64::EPSILON * action, "{action:e} {phase}: {error:e} {bound:e}");
        }
    }
}

/// Derivatives of a motion without a force: 1, t and nothing, until t itself ends.
#[test]
fn derivatives_without_a_force() {
    let of = Sensitivity::new(&force_free(1e308, 1e308));
    assert_eq!(of.at(1e308).rows(), [[1.0, 1e308, 0.0], [0.0, 1.0, 0.0]]);
    assert!(of.at(f64::INFINITY).rows().iter().flatten().all(|value| value.is_nan()));
}

//! Action, phase and frequency: constant, linear, dJ/dE = 1/frequency, and there and back again.

use libration::{
    Frequency, Orbit, Regime, pendulum::action::state_of, pendulum::fourier::harmonic_distortion,
};
use std::f64::consts::{PI, TAU};

use crate::ruler::ulp;

/// Reproducible numbers in [0, 1).
fn spread(count: u32) -> impl Iterator<Item = f64> {
    (0..count).map(|i| (f64::from(i) * 0.618_033_988_749_894_9).fract())
}

fn force(omega0: f64) -> Frequency {
    Frequency::from_omega0(omega0).unwrap()
}

fn orbits(count: u32) -> impl Iterator<Item = Orbit> {
    spread(count).map(|part| {
        let (theta0, velocity0) = (6.2 * part - 3.1, 4.0 * (part * 77.0).sin());
        Orbit::new(theta0, velocity0, force(1.3)).unwrap()
    })
}

/// The action of states along the orbit is that of the orbit: what the rounding of the state makes of it stands beside.
#[test]
fn the_action_is_constant_over_a_billion_periods() {
    for (i, orbit) in orbits(4000).enumerate() {
        let period = orbit.period().min(1e3);
        let t = period * 10f64.powf(9.0 * (i as f64 * 0.37).fract());
        let theta = orbit.turns(t).angle;
        let velocity = orbit.velocity(t);
        let later = Orbit::new(theta, velocity, force(1.3)).unwrap();
        let rounding = (1.69 * theta.sin().abs() * ulp(theta) + velocity.abs() * ulp(velocity))
            / orbit.frequency().abs();
        let error = (later.action() - orbit.action()).abs();
        assert!(error <= 4.0 * ulp(orbit.action()) + 4.0 * rounding, "{orbit:?} {t}: {error}");
    }
}

/// phase(t) = phase(0) + frequency t to the last digits, with the frequency in more digits than a double.
#[test]
fn the_phase_is_linear() {
    for orbit in orbits(2000) {
        let period = orbit.period();
        for count in [1.0, 1e3, 1e6, 1e9] {
            // Phases at t and 2t: the second difference of a line is nothing.
            let t = period * count;
            let (start, middle, end) = (orbit.phase(0.0), orbit.phase(t), orbit.phase(2.0 * t));
            let bend = (end - middle) - (middle - start);
            assert!(bend.abs() <= 4.0 * ulp(end.abs().max(PI)), "{orbit:?} {count} {bend}");
            let slope = (end - start) / (2.0 * t);
            assert!((slope / orbit.frequency() - 1.0).abs() < 1e-14 / count.min(1.0), "{orbit:?}");
        }
        let returned = orbit.phase(0.0);
        if orbit.regime() == Regime::Rotation {
            assert!((returned - orbit.theta(0.0)).abs() < PI);
        } else {
            assert!(returned > -PI && returned <= PI);
        }
    }
}

#[test]
fn the_phase_counts_from_the_bottom_upwards() {
    let phase = |theta0, velocity0| Orbit::new(theta0, velocity0, force(1.0)).unwrap().phase(0.0);
    assert_eq!(phase(0.0, 1.0), 0.0);
    assert_eq!(phase(1.0, 0.0), PI / 2.0);
    assert_eq!(phase(-1.0, 0.0), -PI / 2.0);
    assert_eq!(phase(0.0, -1.0), PI);
    assert!(phase(0.5, -1.0) > PI / 2.0 && phase(-0.5, -1.0) < -PI / 2.0);
    assert_eq!(phase(TAU * 3.0, 3.0), TAU * 3.0);
    assert!(phase(0.0, 2.0).is_nan());
}

/// dJ/dE by central differences of many steps (Richardson), against 1/frequency.
#[test]
fn the_slope_of_the_action_is_the_inverse_frequency() {
    let action = |energy: f64| Orbit::new(0.0, (2.0 * energy).sqrt(), force(1.0)).unwrap();
    for part in spread(400) {
        let energy = 0.05 + 7.0 * part;
        if (energy - 2.0).abs() < 0.2 {
            continue;
        }
        let h = 0.02 * (energy - 2.0).abs().min(energy).min(1.0);
        // Differences of tenth order.
        let weights = [5.0 / 6.0, -5.0 / 21.0, 5.0 / 84.0, -5.0 / 504.0, 1.0 / 1260.0];
        let slope: f64 = (1..=5)
            .map(|i| {
                let step = h * f64::from(i);
                weights[i as usize - 1] * (action(energy + step).action() - action(energy - step).action())
                    / h
            })
            .sum();
        let frequency = action(energy).frequency();
        assert!((slope * frequency - 1.0).abs() < 1e-12, "{energy}: {:e}", slope * frequency - 1.0);
    }
}

#[test]
fn there_and_back() {
    let mut worst: f64 = 0.0;
    for (i, orbit) in orbits(4000).enumerate() {
        let direction = if orbit.regime() == Regime::Rotation { orbit.frequency().signum() } else { 0.0 };
        let t = if i % 2 == 0 { 0.0 } else { 0.7 };
        let (theta, velocity) = orbit.motion(t);
        let (back, speed) = state_of(orbit.action(), orbit.phase(t), direction, force(1.3)).unwrap();
        // An ulp of the action moves the phase's place on the orbit by what the period's slope makes of it.
        let condition = (1.0 / orbit.energy_ratio_c().abs()).max(1.0);
        let scale = 2.6 * orbit.energy_ratio().sqrt().max(0.1);
        let error = (back - theta).abs().max((speed - velocity).abs() / scale);
        worst = worst.max(error / condition);
        assert!(error <= 1e-13 * condition, "{orbit:?} {theta} {velocity} {back} {speed}");
        // And from there: action and phase again.
        let again = Orbit::new(back, speed, force(1.3)).unwrap();
        assert!((again.action() / orbit.action() - 1.0).abs() <= 1e-13 * condition);
    }
    println!("{worst:e}");
}

#[test]
fn corners_of_action_and_phase() {
    let [separatrix, half] = [8.0 / PI, 4.0 / PI];
    let action = |velocity0: f64| Orbit::new(0.0, velocity0, force(1.0)).unwrap().action();
    assert!((action(2.0) - separatrix).abs() <= ulp(separatrix));
    assert!((action(f64::from_bits(2f64.to_bits() - 1)) - separatrix).abs() < 1e-14);
    assert!((action(f64::from_bits(2f64.to_bits() + 1)) - half).abs() < 1e-14);
    assert_eq!(Orbit::new(0.0, 0.0, force(1.0)).unwrap().action(), 0.0);
    assert_eq!(Orbit::new(0.0, 3.0, force(0.0)).unwrap().action(), 3.0);
    for amplitude in [1e-3, 1e-100, 1e-150, 1e-160] {
        let orbit = Orbit::new(amplitude, 0.0, force(1.0)).unwrap();
        assert!((orbit.action() / (amplitude * amplitude / 2.0) - 1.0).abs() < 1e-6, "{amplitude}");
        let (theta, velocity) = state_of(orbit.action(), PI / 2.0, 0.0, force(1.0)).unwrap();
        assert!(
            (theta / amplitude - 1.0).abs() < 1e-4 && velocity.abs() < 1e-15 * amplitude,
            "{amplitude} {theta}"
        );
    }
    for direction in [1.0, -1.0] {
        let (theta, velocity) = state_of(1e200, 7.0, direction, force(1.0)).unwrap();
        assert_eq!((theta, velocity), (7.0, direction * 1e200));
    }
    let refused =
        |action, phase, direction| state_of(action, phase, direction, force(1.0)).unwrap_err().to_string();
    assert_eq!(refused(2.6, 0.0, 0.0), "action = 2.6: must be below 8 omega0/pi in libration");
    assert_eq!(refused(1.2, 0.0, 1.0), "action = 1.2: must be above 4 omega0/pi in rotation");
    assert_eq!(refused(-1.0, 0.0, 0.0), "action = -1.0: must be finite and not negative");
    assert_eq!(refused(1.0, f64::NAN, 0.0), "phase = NaN: must be finite");
    assert_eq!(refused(1.0, 0.0, 2.0), "direction = 2.0: must be 0, 1 or -1");
    // Upside down: the same about the other equilibrium.
    let hanging = Frequency::from_omega2(-1.69).unwrap();
    for (action, phase, direction) in [(1.0, 0.4, 0.0), (1.0, -2.0, 0.0), (3.0, 0.4, 1.0), (5.0, -9.0, -1.0)]
    {
        let orbit = Orbit::from_action_phase(action, phase, direction, hanging).unwrap();
        assert!((orbit.action() / action - 1.0).abs() < 1e-14);
        assert!((orbit.phase(0.0) - phase).abs() < 1e-14, "{} {phase}", orbit.phase(0.0));
    }
}

/// Amplitudes of the velocity where those of the angle, or the frequency, are at the ends of the range.
#[test]
fn amplitudes_at_the_ends_of_the_range() {
    let velocity = |theta0, velocity0, omega0, j: i64| {
        Orbit::new(theta0, velocity0, force(omega0)).unwrap().fourier(j).unwrap().velocity[j as usize - 1]
    };
    assert_eq!(velocity(1.0, 0.0, 1e308, 2), 0.0);
    assert!((velocity(1.0, 0.0, 1e308, 3) / velocity(1.0, 0.0, 1.0, 3) / 1e308 - 1.0).abs() < 1e-15);
    assert_eq!(velocity(0.0, 1.7e308, 1.0, 4), 0.0);
    assert!((velocity(2.0, 1.0, 1e290, 705) / 9.616e-104 - 1.0).abs() < 1e-3);
    assert!((velocity(2.0, 1.0, 1e10, 567) / 1.165_731_9e-306 - 1.0).abs() < 1e-7);
    // An action a rounding error inside of its limit is inside.
    assert!(Orbit::from_action_phase(1.273_239_544_735_162_8, 0.5, 1.0, force(1.0)).is_ok());
    assert!(Orbit::from_action_phase(2.801_126_998_417_358, 0.5, 0.0, force(1.1)).is_ok());
}

/// The series is the motion, and Parseval's sum is action times frequency.
#[test]
fn the_series_is_the_motion() {
    for orbit in orbits(300).filter(|orbit| orbit.energy_ratio_c().abs() > 1e-2) {
        let series = orbit.fourier(200).unwrap();
        let turning = orbit.regime() == Regime::Rotation;
        for t in [0.0, 0.3, 1.7, 4.4] {
            let phase = orbit.phase(t);
            let sum = |amplitudes: &[f64], wave: fn(f64) -> f64| -> f64 {
                amplitudes.iter().zip(1..).map(|(a, j)| a * wave(f64::from(j) * phase)).sum()
            };
            let theta = sum(&series.theta, f64::sin) + if turning { phase } else { 0.0 };
            let velocity = sum(&series.velocity, f64::cos) + if turning { orbit.frequency() } else { 0.0 };
            assert!((theta - orbit.theta(t)).abs() < 2e-14 * theta.abs().max(1.0), "{orbit:?} {t}");
            assert!((velocity - orbit.velocity(t)).abs() < 2e-13, "{orbit:?} {t}");
        }
        let mean = if turning { orbit.frequency().powi(2) } else { 0.0 };
        let parseval = mean + series.velocity.iter().map(|b| b * b / 2.0).sum::<f64>();
        let expected = orbit.action() * orbit.frequency().abs();
        assert!((parseval / expected - 1.0).abs() < 1e-14, "{parseval} {expected}");
        let higher: f64 = series.theta[1..].iter().map(|a| a * a).sum();
        let distortion = higher.sqrt() / series.theta[0].abs();
        assert!((distortion / orbit.distortion() - 1.0).abs() < 1e-14);
    }
}

#[test]
fn loss_of_harmonicity() {
    // Lima's regime: a_3/a_1 is theta_max^2/192 for small swings, and everything is lost at the top, where all
    // odd harmonics are 1/j of the first: sqrt(pi^2/8 - 1).
    assert!((harmonic_distortion(1e-3) / (1e-6 / 192.0) - 1.0).abs() < 1e-6);
    assert_eq!(harmonic_distortion(0.0), 0.0);
    for amplitude in [1e-60, 1e-77, 1e-80, 1e-90, 1e-120] {
        let expected = amplitude * amplitude / 192.0;
        assert!((harmonic_distortion(amplitude) / expected - 1.0).abs() < 1e-15, "{amplitude}");
    }
    let [near, nearer] = [PI - 1e-6, PI].map(harmonic_distortion);
    let limit = (PI * PI / 8.0 - 1.0).sqrt();
    assert!(near < nearer && nearer < limit, "{near} {nearer} {limit}");
    // On the way there, logarithmically: with K from the period and K' = pi/2 at the double next to pi.
    let decay = PI * PI / Orbit::new(PI, 0.0, force(1.0)).unwrap().period();
    let amplitude = |j: i32| (decay * f64::from(j)).cosh().recip() / f64::from(j);
    let sum: f64 = (1..2000).map(|j| (amplitude(2 * j + 1) / amplitude(1)).powi(2)).sum();
    assert!((nearer / sum.sqrt() - 1.0).abs() < 1e-13, "{nearer} {}", sum.sqrt());
    assert!(harmonic_distortion(3.2).is_nan() && harmonic_distortion(-0.1).is_nan());
    assert!(Orbit::new(1.0, 0.0, force(1.0)).unwrap().fourier(0).is_err());
    assert_eq!(
        Orbit::new(1.0, 0.0, force(1.0)).unwrap().fourier(20_000_000).unwrap_err().to_string(),
        "n = 20000000: must be from 1 to 10000000"
    );
}

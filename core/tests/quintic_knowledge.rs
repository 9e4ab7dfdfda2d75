//! What a cubic-quintic oscillator keeps: separatrices in closed form, units, series against motion, dJ/dE.

use core::f64::consts::PI;
use libration::CubicQuintic;

/// u0, velocity0, p, q, s of motions that stay, of every kind of roots.
const BOUNDED: [[f64; 5]; 10] = [
    [0.6, 0.1, 1.0, 1.0, 1.0],
    [0.4, 0.2, 1.0, -2.5, 1.0],
    [1.2, 0.1, 1.0, -2.5, 1.0],
    [-1.3, 0.2, 1.0, -2.5, 1.0],
    [1.9, 0.3, 1.0, -2.5, 1.0],
    [0.3, 0.4, -1.0, 0.5, 1.0],
    [-0.9, 0.1, -1.0, 0.5, 1.0],
    [0.3, -0.2, 1.0, -0.2, -0.1],
    [0.7, 0.0, 0.0, 0.0, 1.0],
    // E = 0 between two positive roots.
    [1.0, 0.5, 1.0, -4.0, 2.25],
];

fn orbit([u0, velocity0, p, q, s]: [f64; 5]) -> CubicQuintic {
    CubicQuintic::new(u0, velocity0, p, q, s).unwrap()
}

/// Integrals of u'^2 = u^2 - u^6, u^2 (1 - u^2)^2, (1 - u^2)^3 and u^4 (1 - u^2), the last two left like powers of the time.
#[test]
fn separatrices() {
    for (given, regime, action) in [
        ([1.0, 0.0, -1.0, 0.0, 3.0], "homoclinic", 0.125),
        ([0.5, 0.375, -1.0, 4.0, -3.0], "heteroclinic", 0.25 / PI),
        ([0.0, 1.0, 3.0, -6.0, 3.0], "heteroclinic", 0.375),
        ([1.0, 0.0, 0.0, -2.0, 3.0], "homoclinic", 0.0625),
    ] {
        let one = orbit(given);
        assert_eq!((one.regime().name(), one.frequency()), (regime, 0.0), "{given:?}");
        assert!((one.action() / action - 1.0).abs() < 3e-16, "{given:?} {}", one.action());
        assert!(one.phase(1.0).is_nan() && one.distortion().is_nan());
        // The limit of the motions beside it, from inside.
        let mut inside = given;
        (inside[0], inside[1]) = if given[0] == 0.0 {
            (0.0, given[1] * (1.0 - 1e-12))
        } else {
            (given[0] * (1.0 - 1e-12), given[1])
        };
        if orbit(inside).frequency() > 0.0 {
            assert!((orbit(inside).action() / action - 1.0).abs() < 1e-7, "{given:?}");
        }
    }
}

/// Powers of two as units change no digit.
#[test]
fn units() {
    for given in BOUNDED {
        let [u0, velocity0, p, q, s] = given;
        let one = orbit(given);
        for (length, rate) in [(100, 0), (-100, 0), (0, 200), (0, -200), (60, -90)] {
            let power = |k: i32| 2f64.powi(k);
            let scaled = orbit([
                u0 * power(length),
                velocity0 * power(length + rate),
                p * power(2 * rate),
                q * power(2 * rate - 2 * length),
                s * power(2 * rate - 4 * length),
            ]);
            assert_eq!(scaled.action(), one.action() * power(2 * length + rate), "{given:?}");
            assert_eq!(scaled.frequency(), one.frequency() * power(rate), "{given:?}");
            assert_eq!(scaled.phase(0.0), one.phase(0.0), "{given:?}");
            assert_eq!(scaled.distortion(), one.distortion(), "{given:?}");
            let [ours, theirs] = [&scaled, &one].map(|each| each.fourier(5).unwrap());
            for (a, b) in ours.u.iter().zip(&theirs.u) {
                assert_eq!(*a, b * power(length), "{given:?}");
            }
        }
    }
}

/// The series is the motion, and its sum the action; dJ/dE is 1/frequency.
#[test]
fn actions_and_series() {
    for given in BOUNDED {
        let one = orbit(given);
        let series = one.fourier(90).unwrap();
        let mut squares = 0.0;
        for k in 0..128 {
            let t = one.period() * f64::from(k) / 128.0;
            let phase = one.phase(t);
            let (mut u, mut velocity) = (series.mean, 0.0);
            for (n, (a, b)) in series.u.iter().zip(&series.velocity).enumerate() {
                let angle = (n + 1) as f64 * phase;
                u += a * angle.cos();
                velocity += b * angle.sin();
            }
            assert!((u - one.u(t)).abs() < 1e-14, "{given:?} {t}");
            assert!((velocity - one.velocity(t)).abs() < 1e-13, "{given:?} {t}");
            squares += one.velocity(t).powi(2) / 128.0;
        }
        let action = squares / one.frequency();
        assert!((one.action() / action - 1.0).abs() < 1e-13, "{given:?} {} {action}", one.action());
        let distortion = series.u[1..].iter().map(|a| a * a).sum::<f64>().sqrt() / series.u[0].abs();
        assert!((one.distortion() - distortion).abs() < 1e-15, "{given:?}");
        // Amplitudes do not depend on how many are asked for.
        assert_eq!(one.fourier(7).unwrap().u[..], series.u[..7]);
        let t = 0.37 * one.period();
        let mut later = given;
        (later[0], later[1]) = one.motion(t);
        assert!((orbit(later).action() / one.action() - 1.0).abs() < 1e-13, "{given:?}");
        let turned = (orbit(later).phase(0.0) - one.phase(t)).rem_euclid(core::f64::consts::TAU);
        assert!(turned.min(core::f64::consts::TAU - turned) < 1e-12, "{given:?} {turned}");
        if given[1] != 0.0 {
            let mut beside = [given; 2];
            beside[0][1] *= 1.0 + 1e-5;
            beside[1][1] *= 1.0 - 1e-5;
            let [up, down] = beside.map(orbit);
            let slope = (up.action() - down.action()) / (up.energy() - down.energy());
            assert!((slope * one.frequency() - 1.0).abs() < 1e-7, "{given:?} {slope}");
        }
    }
}

/// From the bottom of a triple well to over its saddle, whatever the rule of the sum: it rises, and by dE/frequency.
#[test]
fn it_grows_with_the_energy() {
    let mut last: Option<CubicQuintic> = None;
    for k in 1..800 {
        let one = orbit([0.0, 5e-4 * f64::from(k), 1.0, -4.0, 3.0]);
        if let Some(last) = last.filter(|last| last.range().1 < 0.5 && one.range().1 < 0.5) {
            let rise = one.action() - last.action();
            let middle = 0.5 * (1.0 / one.frequency() + 1.0 / last.frequency());
            let told = (one.energy() - last.energy()) * middle;
            assert!((rise / told - 1.0).abs() < 1e-3, "{k} {rise} {told}");
        }
        last = Some(one);
    }
}

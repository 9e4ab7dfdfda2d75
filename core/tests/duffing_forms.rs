//! The twelve forms against the equation, and the oscillator against the pendulum.

use crate::oscillator::{Spread, energy, energy_scale, scales};
use libration::oscillator::OscillatorRegime;
use libration::{Duffing, DuffingForm, Frequency, Glaisher, Orbit};

#[test]
fn each_of_the_twelve_forms_obeys_the_equation() {
    let mut spread = Spread(21);
    let mut tried = std::collections::BTreeMap::new();
    for _ in 0..4000 {
        let [p, q, c1, c2] = spread.state();
        for which in Glaisher::ALL {
            let Ok(form) = DuffingForm::new(which, p, q, c1, c2) else { continue };
            *tried.entry(which.name()).or_insert(0) += 1;
            let t = spread.between(-2.0, 2.0);
            let (u, v) = form.motion(t);
            if u.abs() > 1e3 {
                continue;
            }
            // The same energy everywhere: u'^2 = 2E - p u^2 - q u^4/2 has u'' as its slope.
            let elsewhere = form.motion(spread.between(-2.0, 2.0));
            let size = energy_scale(u, v, p, q).max(energy_scale(elsewhere.0, elsewhere.1, p, q));
            let difference = energy(u, v, p, q) - energy(elsewhere.0, elsewhere.1, p, q);
            assert!(difference.abs() <= 4e-15 * size, "{} {p} {q} {c1} {c2} {t}", which.name());
            let h = 1e-3;
            let samples = [-2.0, -1.0, 1.0, 2.0].map(|k| form.motion(t + k * h));
            if samples.iter().all(|(u, _)| u.abs() < 5.0) {
                let [a, b, d, e] = samples.map(|sample| sample.1);
                let second = ((a - e) + 8.0 * (d - b)) / (12.0 * h);
                assert!(
                    (second + p * u + q * u * u * u).abs() < 1e-5,
                    "{} {p} {q} {c1} {c2} {t}",
                    which.name()
                );
            }
            // And it is the oscillator through the same start, up to the poles.
            let (u0, v0) = form.motion(0.0);
            let orbit = Duffing::new(u0, v0, p, q).unwrap();
            let (other_u, other_v) = orbit.motion(t);
            let far = t > 0.7 * orbit.escape_time() || t < 0.7 * orbit.escape_time_backward();
            if !far && u0.abs() < 10.0 && v0.abs() < 100.0 {
                let [su, sv] = scales(&orbit, u, v);
                assert!(
                    (u - other_u).abs() < 1e-10 * su.max(1.0) && (v - other_v).abs() < 1e-10 * sv.max(1.0),
                    "{} {orbit:?} {t}",
                    which.name()
                );
            }
            let parameter = form.parameter();
            assert!(parameter.m() >= 0.0 && parameter.mc() >= 0.0 && form.rate() > 0.0);
        }
    }
    assert!(tried.len() == 12 && tried.values().all(|count| *count > 100), "{tried:?}");
}

#[test]
fn a_form_out_of_its_domain_is_refused() {
    let refused = |which, p, q| DuffingForm::new(which, p, q, 1.0, 0.0).unwrap_err().to_string();
    assert_eq!(
        refused(Glaisher::Cn, -2.0, 1.0),
        "form = cn, p = -2.0, q = 1.0, c1 = 1.0: must be of q c1^2 >= 0 and q c1^2 + 2p >= 0, and not both 0"
    );
    assert!(DuffingForm::new(Glaisher::Sn, 1.0, -1.0, f64::NAN, 0.0).is_err());
    // The edges of the domains are in them: m = 0 and m = 1.
    for (which, p, q) in [
        (Glaisher::Sn, 1.0, 0.0),
        (Glaisher::Sd, 1.0, 0.0),
        (Glaisher::Sd, -1.0, 0.0),
        (Glaisher::Nd, -1.0, 0.0),
        (Glaisher::Sn, 1.0, -1.0),
        (Glaisher::Cn, -0.5, 1.0),
        (Glaisher::Dn, -0.5, 1.0),
        (Glaisher::Dn, -1.0, 1.0),
        (Glaisher::Sc, -1.0, -1.0),
        (Glaisher::Ds, 0.5, -1.0),
        (Glaisher::Ds, -0.5, -1.0),
        (Glaisher::Ns, 1.0, -1.0),
    ] {
        let form = DuffingForm::new(which, p, q, 1.0, 0.4).unwrap();
        let m = form.parameter().m();
        assert!(m == 0.0 || m == 1.0, "{} {m}", which.name());
        let (u, v) = form.motion(0.0);
        let (then_u, then_v) = form.motion(0.7);
        let kept = energy(u, v, p, q) - energy(then_u, then_v, p, q);
        assert!(kept.abs() < 4e-15 * energy_scale(u, v, p, q).max(energy_scale(then_u, then_v, p, q)));
    }
}

#[test]
fn which_form_serves_which_regime() {
    let lines: Vec<String> = DuffingForm::table()
        .iter()
        .map(|(which, regimes)| {
            let names: Vec<&str> = regimes.iter().map(|regime| regime.name()).collect();
            format!("{} {}", which.name(), names.join(" "))
        })
        .collect();
    println!("{}", lines.join("\n"));
    let expected = [
        "sn linear libration heteroclinic",
        "cn linear libration homoclinic",
        "dn rest well homoclinic",
        "ns escape",
        "nc linear escape",
        "nd rest linear well",
        "sc linear escape",
        "cs escape",
        "sd linear libration",
        "ds escape",
        "cd rest linear libration",
        "dc rest escape",
    ];
    assert_eq!(lines, expected);
}

#[test]
fn pendulum_and_oscillator_are_one_motion() {
    let mut spread = Spread(31);
    let mut there = [0; 2];
    for _ in 0..2000 {
        let (theta0, velocity0, omega2) =
            (spread.between(-3.0, 3.0), spread.between(-3.0, 3.0), spread.between(-2.0, 2.0));
        let force = Frequency::from_omega2(omega2).unwrap();
        let pendulum = Orbit::new(theta0, velocity0, force).unwrap();
        let orbit = Duffing::of_pendulum(theta0, velocity0, force).unwrap();
        let t = spread.between(-1.0, 1.0);
        let (theta, velocity) = pendulum.motion(t);
        if theta.abs() > 2.8 || orbit.u(t).is_nan() || theta0.abs() > 2.8 {
            continue;
        }
        let (u, v) = orbit.motion(t);
        assert!((2.0 * u.atan() - theta).abs() < 1e-13, "{theta0} {velocity0} {omega2} {t}");
        assert!((2.0 * v / (1.0 + u * u) - velocity).abs() < 1e-12);
        there[0] += 1;
    }
    for _ in 0..4000 {
        let [u0, v0, p, q] = spread.state();
        let orbit = Duffing::new(u0, v0, p, q).unwrap();
        let Some(companion) = orbit.companion() else { continue };
        let force = Frequency::from_omega2(companion.omega2).unwrap();
        let pendulum = Orbit::new(companion.theta0, companion.velocity0, force).unwrap();
        let t = spread.between(-1.0, 1.0);
        let (theta, u) = (pendulum.theta(t), orbit.u(t));
        if u.is_nan() || theta.abs() > 2.8 || companion.theta0.abs() > 2.8 {
            continue;
        }
        assert!(
            (companion.scale * (0.5 * theta).tan() - u).abs() < 1e-11 * companion.scale.max(1.0),
            "{orbit:?} {companion:?} {t}"
        );
        there[1] += 1;
    }
    assert!(there[0] > 1000 && there[1] > 1000, "{there:?}");
    // The separatrix of the pendulum is the linear oscillator, and pi is beyond every u.
    let separatrix = Duffing::of_pendulum(0.0, 2.0, Frequency::from_omega0(1.0).unwrap()).unwrap();
    assert_eq!((separatrix.regime(), separatrix.p(), separatrix.q()), (OscillatorRegime::Linear, -1.0, 0.0));
    assert!(separatrix.companion().is_none());
    let top = Duffing::of_pendulum(std::f64::consts::PI, 0.0, Frequency::from_omega0(1.0).unwrap()).unwrap();
    assert!(top.u0() > 1.6e16 && top.u0() < 1.7e16 && top.regime() == OscillatorRegime::Libration);
}

/// omega0^2 = 1.4e310 has no double: there is no companion, as where there is none at all.
#[test]
fn a_companion_beyond_the_range_of_doubles_is_none() {
    assert!(Duffing::new(1e155, 0.0, 1.0, 1.0).unwrap().companion().is_none());
    assert!(Duffing::new(1e153, 0.0, 1.0, 1.0).unwrap().companion().is_some());
}

//! What a fit refuses, and what it says in words.

use libration_fit::fit::{Data, Fit, FitOptions, Grade, Measure, Measured, Stream, fit};

fn angle(t: Vec<f64>, values: Vec<f64>) -> Data {
    Data::Record { measured: Measured::Angle, t, values }
}

fn says(fit: &Fit, words: &str) -> bool {
    fit.verdicts.iter().any(|verdict| verdict.sentence.contains(words))
}

fn times(rows: usize) -> Vec<f64> {
    (0..rows).map(|i| 0.02 * i as f64).collect()
}

/// Noise that repeats on every machine.
fn noise(i: usize) -> f64 {
    Stream::new(17).uniform(i as u64) - 0.5
}

#[test]
fn a_linear_cosine_is_too_good() {
    let t = times(1500);
    let values = t.iter().map(|t| 0.9 * (-0.02 * t).exp() * (4.0 * t).cos()).collect();
    let found = fit(&angle(t, values), &FitOptions::default()).unwrap();
    assert!(says(&found, "too good: this is a linear cosine") && !found.stands(), "{:?}", found.verdicts);
}

#[test]
fn a_torsion_wheel_is_no_pendulum() {
    let t = times(1500);
    let values = t
        .iter()
        .enumerate()
        .map(|(i, t)| 1.5 * (-0.03 * t).exp() * (4.0 * t).cos() + 0.02 * noise(i))
        .collect();
    let found = fit(&angle(t, values), &FitOptions::default()).unwrap();
    assert!(says(&found, "does not depend on the swing") && !found.stands(), "{:?}", found.verdicts);
}

#[test]
fn what_is_no_record_is_refused_in_one_line() {
    let t = times(100);
    let wave: Vec<f64> = t.iter().map(|t| t.sin()).collect();
    let none = FitOptions::default();
    for (data, words) in [
        (angle(t.clone(), vec![0.3; 100]), "every value is 0.3"),
        (angle(t.clone(), vec![f64::NAN; 100]), "0 rows with numbers"),
        (angle(vec![1.0], vec![0.2]), "1 row with numbers"),
        (angle(t.iter().rev().copied().collect(), wave.clone()), "must rise"),
        (angle(vec![2.0; 100], wave.clone()), "every time is 2"),
        (angle(t.clone(), wave[..99].to_vec()), "same length"),
        (angle(t.clone(), t.clone()), "1 turning point in"),
        (
            Data::Gate { t: t[..5].to_vec(), periods: vec![2.0, 2.011, 1.996, 2.008, 2.001], transits: None },
            "5 periods do not",
        ),
    ] {
        let refusal = fit(&data, &none).unwrap_err().to_string();
        assert!(refusal.contains(words) && !refusal.contains('\n'), "{refusal}");
    }
}

#[test]
fn length_and_gravity_together_are_refused() {
    let measure = |value: f64| Some(Measure { value, u: 0.001 });
    let options = FitOptions { length: measure(0.8), gravity: measure(9.81), ..FitOptions::default() };
    let refusal = fit(&angle(times(100), times(100)), &options).unwrap_err().to_string();
    assert!(refusal.contains("g/L alone"), "{refusal}");
}

#[test]
fn tables_and_gates_are_fitted_without_an_integration() {
    let frequency = libration::Frequency::from_gravity_length(9.81, 0.6).unwrap();
    let period = |swing: f64| libration::Orbit::new(swing, 0.0, frequency).unwrap().period();
    let swings: Vec<f64> = (-8..=8).filter(|i| *i != 0).map(|i| 0.17 * f64::from(i)).collect();
    let periods: Vec<f64> =
        swings.iter().enumerate().map(|(i, a)| period(a - 0.03) + 2e-4 * noise(i)).collect();
    let length = Some(Measure { value: 0.6, u: 0.0006 });
    let options = FitOptions { length, ..FitOptions::default() };
    let found = fit(&Data::Table { swings: swings.clone(), periods }, &options).unwrap();
    let g = found.g.unwrap();
    assert!((g.value - 9.81).abs() < 0.01 && (g.calibration - 9.81e-3).abs() < 1e-4, "{g:?}");
    assert!((found.offset.unwrap().value - 0.03).abs() < 0.002, "{:?}", found.offset);
    // The spoiled sibling: a period that is the same for every swing.
    let constant: Vec<f64> = (0..swings.len()).map(|i| 1.5 + 1e-4 * noise(i)).collect();
    let found = fit(&Data::Table { swings, periods: constant }, &options).unwrap();
    assert!(!found.stands() && says(&found, "does not depend on the swing"), "{:?}", found.verdicts);

    let t: Vec<f64> = (0..400).map(|i| 1.6 * f64::from(i)).collect();
    let friction = libration::Friction::new(0.002, 0.0, 0.0, 0.0).unwrap();
    let swing = |t: f64| libration::damped::averaged_turning_angle(0.9, t, frequency, friction);
    let periods: Vec<f64> = t.iter().enumerate().map(|(i, t)| period(swing(*t)) + 1e-4 * noise(i)).collect();
    let transits = t.iter().map(|t| {
        let orbit = libration::Orbit::new(swing(*t), 0.0, frequency).unwrap();
        0.02 / (0.6 * orbit.velocity(0.25 * orbit.period()).abs())
    });
    for transits in [None, Some(transits.collect())] {
        let data = Data::Gate { t: t.clone(), periods: periods.clone(), transits };
        let found = fit(&data, &options).unwrap();
        assert!((found.g.unwrap().value - 9.81).abs() < 0.01, "{:?}", found.g);
        assert!((found.swing - 0.9).abs() < 0.02 && found.stands(), "{} {:?}", found.swing, found.verdicts);
        // Each period with its swing, and the curve of the exact law at the swings goes through what was fitted.
        let rows = &found.residuals;
        for i in 0..rows.t.len() {
            assert!((rows.swings[i] - swing(rows.t[i])).abs() < 0.03, "{} at {}", rows.swings[i], rows.t[i]);
            let damping = found.friction.linear.map_or(0.0, |linear| linear.value);
            let omega2 = found.omega0.value.powi(2) - damping.powi(2);
            let frequency = libration::Frequency::from_omega2(omega2).unwrap();
            let law = libration::Orbit::new(rows.swings[i], 0.0, frequency).unwrap().period();
            assert!((law - (rows.measured[i] - rows.residual[i])).abs() < 1e-12, "{i}");
        }
    }
}

/// Periods between passages of the rest, by the integration: omega0 is that without friction, which makes periods longer by 1/(8 Q^2).
#[test]
fn omega0_of_a_gate_is_that_without_friction() {
    let omega0 = (9.81f64 / 0.8).sqrt();
    let frequency = libration::Frequency::from_omega0(omega0).unwrap();
    for quality in [30.0, 100.0] {
        let friction = libration::Friction::new(0.5 * omega0 / quality, 0.0, 0.0, 0.0).unwrap();
        let none = libration::Torque::NONE;
        let pendulum =
            libration::DampedPendulum::new(60f64.to_radians(), 0.0, frequency, friction, none).unwrap();
        let passed = pendulum.trajectory(0.0, 100.0).unwrap().times(0.0, 0.0, 100.0).unwrap();
        let rows: Vec<&[f64]> = passed.chunks_exact(2).collect();
        let period = |pair: &[&[f64]]| pair[1][0] - pair[0][0];
        let t = rows.windows(2).map(|pair| 0.5 * (pair[1][0] + pair[0][0])).collect();
        let periods = rows.windows(2).map(period).collect();
        let found = fit(&Data::Gate { t, periods, transits: None }, &FitOptions::default()).unwrap();
        let off = found.omega0.value / omega0 - 1.0;
        assert!(off.abs() < 0.02 / (8.0 * quality * quality), "{quality}: {off}");
    }
}

#[test]
fn a_result_serialises_with_the_names_that_are_promised() {
    let t = times(400);
    let values = t.iter().enumerate().map(|(i, t)| 0.2 * (4.0 * t).cos() + 0.01 * noise(i)).collect();
    let found = fit(&angle(t, values), &FitOptions::default()).unwrap();
    let json: serde_json::Value = serde_json::from_str(&found.json()).unwrap();
    for key in [
        "model", "rms_deg", "omega0", "g", "length", "offset_deg", "friction", "verdicts", "dropped",
        "window",
    ] {
        assert!(json.get(key).is_some(), "{key}");
    }
    assert!(json["verdicts"].as_array().unwrap().iter().all(serde_json::Value::is_string));
    assert!(found.verdicts.iter().all(|verdict| verdict.grade <= Grade::Refuted));
}

/// A pendulum of 0.5 m where g is 9.81, released at this angle.
fn swing(theta0: f64, step: f64, rows: usize) -> (Vec<f64>, Vec<f64>) {
    let frequency = libration::Frequency::from_gravity_length(9.81, 0.5).unwrap();
    let friction = libration::Friction::new(0.02, 0.01, 0.0, 0.0).unwrap();
    let pendulum =
        libration::DampedPendulum::new(theta0, 0.0, frequency, friction, libration::Torque::NONE).unwrap();
    let trajectory = pendulum.trajectory(0.0, step * rows as f64).unwrap();
    let t: Vec<f64> = (0..rows).map(|i| step * i as f64).collect();
    let values = t.iter().enumerate().map(|(i, t)| trajectory.theta(*t) + 0.004 * noise(i)).collect();
    (t, values)
}

#[test]
fn a_wrong_length_is_named_with_its_size() {
    let (t, values) = swing(0.8, 0.02, 1000);
    let data = angle(t, values);
    let with = |value: f64| {
        let length = Some(Measure { value, u: 0.001 });
        fit(&data, &FitOptions { length, ..FitOptions::default() }).unwrap()
    };
    assert!(says(&with(0.61), "the stated length is off by 22"), "{:?}", with(0.61).verdicts);
    assert!(!says(&with(0.5), "length"), "{:?}", with(0.5).verdicts);
}

#[test]
fn a_length_or_a_time_in_another_unit_is_not_quoted() {
    let (t, values) = swing(0.8, 0.02, 1000);
    let with = |data: &Data, value: f64| {
        let length = Some(Measure { value, u: 0.001 });
        fit(data, &FitOptions { length, ..FitOptions::default() }).unwrap()
    };
    let unit = "the unit of the length or of the times is wrong: g would be";
    let milliseconds: Vec<f64> = t.iter().map(|t| 1e-3 * t).collect();
    for (data, length) in
        [(angle(t.clone(), values.clone()), 5.0), (angle(milliseconds, values.clone()), 0.5)]
    {
        let found = with(&data, length);
        assert!(says(&found, unit) && !found.stands(), "{:?}", found.verdicts);
    }
    // On the Moon it swings too.
    let moon = with(&angle(t.clone(), values.clone()), 0.5 / 6.0);
    assert!(says(&moon, "the stated length is off by") && moon.stands(), "{:?}", moon.verdicts);
    let table =
        Data::Table { swings: vec![0.2, 0.6, 1.0, 1.4], periods: vec![2.0112, 2.0521, 2.1387, 2.2847] };
    assert!(!says(&with(&table, 1.0), "length"), "{:?}", with(&table, 1.0).verdicts);
    assert!(says(&with(&table, 0.9), "the stated length is off by"), "{:?}", with(&table, 0.9).verdicts);
    assert!(says(&with(&table, 100.0), unit), "{:?}", with(&table, 100.0).verdicts);
}

#[test]
fn what_is_no_pendulum_says_nothing_of_its_length() {
    let t = times(600);
    let values = (0..600).map(|i| 0.3 * noise(i)).collect();
    let length = Some(Measure { value: 0.65, u: 0.01 });
    let found = fit(&angle(t, values), &FitOptions { length, ..FitOptions::default() }).unwrap();
    assert!(!found.stands() && !says(&found, "length"), "{:?}", found.verdicts);
}

#[test]
fn periods_that_the_swing_does_not_explain_say_so() {
    // The width of the flag changes midway, and with it every speed.
    let gate = |change: f64| {
        let swing = |i: usize| 0.3 * (-0.004 * i as f64).exp();
        let speed = |i: usize| 2.0 * 3.0 * (0.5 * swing(i)).sin();
        let t: Vec<f64> = (0..200).map(|i| 2.1 * i as f64).collect();
        let periods = (0..200).map(|i| 2.0944 * (1.0 + swing(i).powi(2) / 16.0) + 2e-5 * noise(i)).collect();
        let dark = (0..200).map(|i| if i < 100 { 0.02 } else { change * 0.02 } / speed(i)).collect();
        fit(&Data::Gate { t, periods, transits: Some(dark) }, &FitOptions::default()).unwrap()
    };
    assert!(says(&gate(1.2), "residuals follow each other"), "{:?}", gate(1.2).verdicts);
    assert!(!says(&gate(1.0), "residuals"), "{:?}", gate(1.0).verdicts);
}

#[test]
fn angles_in_the_wrong_unit_are_named() {
    let (t, values) = swing(1.2, 0.02, 1000);
    let smaller = values.iter().map(|y| y.to_radians()).collect();
    let found = fit(&angle(t.clone(), smaller), &FitOptions::default()).unwrap();
    assert!(
        says(&found, "the unit is wrong") && !found.stands(),
        "{:?} {:?}",
        found.verdicts,
        found.diagnostics
    );
    let right = fit(&angle(t, values), &FitOptions::default()).unwrap();
    assert!(right.stands() && !says(&right, "scale"), "{:?}", right.verdicts);
}

#[test]
fn a_scale_that_a_string_makes_is_named() {
    let (t, values) = swing(0.9, 0.02, 1500);
    let smaller = values.iter().map(|y| 0.71 * y).collect();
    let found = fit(&angle(t, smaller), &FitOptions::default()).unwrap();
    assert!(says(&found, "not a rigid pendulum's"), "{:?} {:?}", found.verdicts, found.diagnostics);
    assert!((found.diagnostics.scale - 0.71).abs() < 0.01, "{:?}", found.diagnostics);
}

#[test]
fn sparse_samples_are_warned_of() {
    let (t, values) = swing(0.8, 0.62, 40);
    let found = fit(&angle(t, values), &FitOptions::default()).unwrap();
    assert!(says(&found, "points per swing"), "{:?}", found.verdicts);
    assert!((found.omega0.value - (9.81f64 / 0.5).sqrt()).abs() < 4.0 * found.omega0.u, "{:?}", found.omega0);
}

#[test]
fn a_frequency_that_changes_is_no_pendulum_with_this_friction() {
    // The base moves: the swing is carried by another of nearly the same frequency.
    let t = times(1500);
    let values = t
        .iter()
        .enumerate()
        .map(|(i, t)| 0.9 * (-0.02 * t).exp() * (4.2 * t + 0.6 * (0.5 * t).sin()).cos() + 0.001 * noise(i))
        .collect();
    let found = fit(&angle(t, values), &FitOptions::default()).unwrap();
    assert!(!found.stands(), "{:?} {}", found.verdicts, found.rms);
}

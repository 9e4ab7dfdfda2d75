//! Fits of records that the tests make from the core.

use libration::{DampedPendulum, Frequency, Friction, Torque};
use libration_fit::fit::{Data, FitOptions, Measure, Measured, Model, Stream, fit};

fn record(
    theta0: f64,
    omega2: f64,
    friction: Friction,
    rows: usize,
    step: f64,
    sigma: f64,
    seed: u64,
) -> Data {
    let frequency = Frequency::from_omega2(omega2).unwrap();
    let pendulum = DampedPendulum::new(theta0, 0.0, frequency, friction, Torque::NONE).unwrap();
    let stop = step * rows as f64;
    let trajectory = pendulum.trajectory(0.0, stop).unwrap();
    let t: Vec<f64> = (0..rows).map(|i| step * i as f64).collect();
    let noise = Stream::new(seed).noise(0.0, rows);
    let values = t.iter().zip(noise).map(|(t, e)| trajectory.theta(*t) + 0.02 + sigma * e).collect();
    Data::Record { measured: Measured::Angle, t, values }
}

#[test]
fn seventy_degrees_give_g_with_its_budget() {
    let friction = Friction::new(0.02, 0.0, 0.0, 0.0).unwrap();
    let data = record(70f64.to_radians(), 9.81 / 0.8, friction, 600, 1.0 / 30.0, 0.01, 7);
    let options = FitOptions { length: Some(Measure { value: 0.8, u: 0.001 }), ..FitOptions::default() };
    let found = fit(&data, &options).unwrap();
    let g = found.g.unwrap();
    println!("{g:?} {:?}", found.budget);
    assert_eq!(found.model, Model::Linear);
    assert!((g.value - 9.81).abs() < 0.005, "{g:?}");
    assert!((0.0121..0.0128).contains(&g.u), "{g:?}");
    assert!((g.calibration - 0.01226).abs() < 1e-4);
    assert!((0.001..0.003).contains(&g.statistical));
}

fn options(model: Option<Model>) -> FitOptions {
    FitOptions { model, ..FitOptions::default() }
}

#[test]
fn each_friction_model_is_found_again() {
    let omega2 = 9.81 / 0.8;
    for (friction, model) in [
        ([0.0, 0.0, 0.0, 0.0], Model::None),
        ([0.02, 0.0, 0.0, 0.0], Model::Linear),
        ([0.01, 0.03, 0.0, 0.0], Model::Quadratic),
        ([0.01, 0.03, 0.08, 0.0], Model::Dry),
    ] {
        let [a, b, c, d] = friction;
        let data = record(1.2, omega2, Friction::new(a, b, c, d).unwrap(), 900, 1.0 / 30.0, 0.004, 11);
        let found = fit(&data, &options(None)).unwrap();
        assert_eq!(found.model, model, "{:?}", found.ladder);
        let off = (found.omega0.value - omega2.sqrt()) / found.omega0.u;
        assert!(off.abs() < 3.5, "{model:?}: {off}");
        assert!(found.stands(), "{:?}", found.verdicts);
        for (term, truth) in
            [(found.friction.linear, a), (found.friction.quadratic, b), (found.friction.dry, c)]
        {
            if let Some(term) = term {
                assert!((term.value - truth).abs() < 4.0 * term.u, "{model:?} {term:?} {truth}");
            }
        }
    }
}

#[test]
fn a_spoiled_record_does_not_give_g() {
    // A clock that is 1 % fast: far beyond the uncertainty.
    let friction = Friction::new(0.02, 0.0, 0.0, 0.0).unwrap();
    let Data::Record { t, values, .. } = record(1.2, 9.81 / 0.8, friction, 600, 1.0 / 30.0, 0.01, 7) else {
        unreachable!()
    };
    let t = t.into_iter().map(|t| 1.01 * t).collect();
    let data = Data::Record { measured: Measured::Angle, t, values };
    let length = Some(Measure { value: 0.8, u: 0.001 });
    let g = fit(&data, &FitOptions { length, ..FitOptions::default() }).unwrap().g.unwrap();
    assert!((g.value - 9.81).abs() > 5.0 * g.u, "{g:?}");
}

#[test]
fn a_release_near_the_top_converges() {
    let friction = Friction::new(0.03, 0.005, 0.0, 0.0).unwrap();
    let data = record(179.6f64.to_radians(), 21.7, friction, 1200, 0.01, 0.002, 5);
    let found = fit(&data, &options(None)).unwrap();
    let off = (found.omega0.value - 21.7f64.sqrt()) / found.omega0.u;
    assert!(off.abs() < 3.5 && found.rms < 0.0025, "{off} {:?}", found.ladder);
    assert!(found.window.0 < 0.05, "{:?}", found.window);
    assert!(found.swing.to_degrees() > 179.0);
}

#[test]
fn a_motion_over_the_top_converges() {
    let frequency = Frequency::from_omega2(21.7).unwrap();
    let friction = Friction::new(0.12, 0.0, 0.0, 0.0).unwrap();
    let pendulum = DampedPendulum::new(-4.0, 9.8, frequency, friction, Torque::NONE).unwrap();
    let trajectory = pendulum.trajectory(0.0, 10.0).unwrap();
    let t: Vec<f64> = (0..1000).map(|i| 0.01 * f64::from(i)).collect();
    let noise = Stream::new(3).noise(0.0, t.len());
    let values: Vec<f64> = t.iter().zip(noise).map(|(t, e)| trajectory.theta(*t) + 0.002 * e).collect();
    assert!(values.iter().fold(0.0f64, |most, y| most.max(*y)) > core::f64::consts::PI, "it turns over");
    let found = fit(&Data::Record { measured: Measured::Angle, t, values }, &options(None)).unwrap();
    let off = (found.omega0.value - 21.7f64.sqrt()) / found.omega0.u;
    assert!(off.abs() < 3.5 && found.rms < 0.0025, "{off} rms {} {:?}", found.rms, found.window);
    assert!(found.window.0 < 0.02, "the rotation belongs to the window: {:?}", found.window);
}

#[test]
fn velocities_and_accelerations_are_fitted() {
    let frequency = Frequency::from_omega2(21.7).unwrap();
    let friction = Friction::new(0.03, 0.0, 0.0, 0.0).unwrap();
    let pendulum = DampedPendulum::new(1.3, 0.0, frequency, friction, Torque::NONE).unwrap();
    let trajectory = pendulum.trajectory(0.0, 21.0).unwrap();
    let t: Vec<f64> = (1..2000).map(|i| 0.01 * f64::from(i)).collect();
    let noise = Stream::new(9).noise(0.0, t.len());
    let velocity: Vec<f64> =
        t.iter().zip(&noise).map(|(t, e)| trajectory.velocity(*t) - 0.07 + 0.01 * e).collect();
    let data = Data::Record { measured: Measured::Velocity, t: t.clone(), values: velocity };
    let found = fit(&data, &options(None)).unwrap();
    let off = (found.omega0.value - 21.7f64.sqrt()) / found.omega0.u;
    assert!(off.abs() < 3.5 && found.model == Model::Linear, "{off} {:?}", found.ladder);
    assert!((found.offset.unwrap().value + 0.07).abs() < 0.003);
    let step = 1e-3;
    let noise = Stream::new(10).noise(0.0, t.len());
    let acceleration = t.iter().zip(noise).map(|(t, e)| {
        let slope = (trajectory.velocity(t + step) - trajectory.velocity(t - step)) / (2.0 * step);
        0.45 * slope + 0.1 + 0.02 * e
    });
    let data =
        Data::Record { measured: Measured::Acceleration, t: t.clone(), values: acceleration.collect() };
    let found = fit(&data, &options(None)).unwrap();
    let off = (found.omega0.value - 21.7f64.sqrt()) / found.omega0.u;
    assert!(off.abs() < 3.5, "{off} {:?}", found.ladder);
    assert!((found.scale.unwrap().value - 0.45).abs() < 0.01, "{:?}", found.scale);
}

#[test]
fn hands_before_the_release_and_the_rest_after_the_stop_are_cut() {
    let friction = Friction::new(0.01, 0.0, 0.3, 0.0).unwrap();
    let Data::Record { t, values, .. } = record(1.0, 20.0, friction, 2400, 0.01, 0.001, 2) else {
        unreachable!()
    };
    // Three seconds of a hand that lifts and holds the pendulum.
    let noise = Stream::new(8).noise(0.0, 300);
    let held = (0..300).zip(noise).map(|(i, e)| (0.02 + (f64::from(i) / 250.0).min(1.0)) + 0.001 * e);
    let shifted: Vec<f64> = (0..300).map(|i| 0.01 * f64::from(i)).chain(t.iter().map(|t| t + 3.0)).collect();
    let values = held.chain(values).collect();
    let data = Data::Record { measured: Measured::Angle, t: shifted, values };
    let found = fit(&data, &options(None)).unwrap();
    assert!((2.9..3.2).contains(&found.window.0), "{:?}", found.window);
    assert!(found.window.1 < 26.0, "{:?}", found.window);
    assert_eq!(found.model, Model::Dry);
    let off = (found.omega0.value - 20f64.sqrt()) / found.omega0.u;
    assert!(off.abs() < 3.5, "{off}");
}

#[test]
fn outliers_are_listed() {
    let friction = Friction::new(0.02, 0.0, 0.0, 0.0).unwrap();
    let Data::Record { measured, t, mut values } = record(1.2, 12.0, friction, 600, 1.0 / 30.0, 0.005, 7)
    else {
        unreachable!()
    };
    values[100] += 0.4;
    values[333] = f64::NAN;
    let found = fit(&Data::Record { measured, t, values }, &options(Some(Model::Linear))).unwrap();
    let rows: Vec<usize> = found.dropped.iter().map(|dropped| dropped.row).collect();
    assert_eq!(rows, [333, 100], "{:?}", found.dropped);
}

/// (found - true)/u of omega0 by its statistical and by its naive uncertainty, over replicas of noise with memory.
fn pulls(
    theta0: f64,
    friction: Friction,
    rows: usize,
    model: Option<Model>,
    memory: f64,
    n: u64,
) -> [Vec<f64>; 2] {
    let omega0 = (9.81f64 / 0.8).sqrt();
    let Data::Record { t, values: exact, .. } =
        record(theta0, 9.81 / 0.8, friction, rows, 1.0 / 30.0, 0.0, 1)
    else {
        unreachable!()
    };
    let mut found = [Vec::new(), Vec::new()];
    for replica in 0..n {
        let noise = Stream::new(replica).noise(memory, rows);
        let values = exact.iter().zip(noise).map(|(y, e)| y + 0.01 * e).collect();
        let data = Data::Record { measured: Measured::Angle, t: t.clone(), values };
        let fit = fit(&data, &options(model)).unwrap();
        found[0].push((fit.omega0.value - omega0) / fit.omega0.u);
        found[1].push((fit.omega0.value - omega0) / fit.diagnostics.omega0_u_naive);
    }
    found
}

fn mean_and_deviation(values: &[f64]) -> (f64, f64) {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    (mean, (values.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / n).sqrt())
}

#[test]
fn pulls_have_deviation_1_also_where_noise_has_memory() {
    let friction = Friction::new(0.02, 0.0, 0.0, 0.0).unwrap();
    for memory in [0.0, 0.7] {
        let [honest, naive] = pulls(1.2, friction, 300, Some(Model::Linear), memory, 24);
        let (mean, deviation) = mean_and_deviation(&honest);
        assert!(mean.abs() < 0.55 && (0.65..1.4).contains(&deviation), "{memory}: {mean} {deviation}");
        // The spoiled sibling: uncertainties of independent residuals are too small where noise has memory.
        assert!((mean_and_deviation(&naive).1 > 1.5) == (memory > 0.0), "{memory} {naive:?}");
    }
}

#[test]
fn omega0_of_q_100_from_100_degrees_lies_within_2_u() {
    let omega0 = (9.81f64 / 0.8).sqrt();
    let friction = Friction::new(omega0 / 200.0, 0.0, 0.0, 0.0).unwrap();
    let [found, _] = pulls(100f64.to_radians(), friction, 750, None, 0.0, 10);
    // 8 of 10 or more with a probability of 99 % where each lies inside with 95 %. The example `replicas` makes 500.
    assert!(found.iter().filter(|pull| pull.abs() < 2.0).count() > 7, "{found:?}");
}

/// Linear friction, and linear with quadratic, each ten times with other noise: the ladder tells them apart in nine of ten or more.
#[test]
fn the_ladder_tells_linear_from_quadratic_friction() {
    for (friction, model) in [([0.0175, 0.0], Model::Linear), ([0.01, 0.03], Model::Quadratic)] {
        let [linear, quadratic] = friction;
        let friction = Friction::new(linear, quadratic, 0.0, 0.0).unwrap();
        let right = (0..10).filter(|seed| {
            let data = record(100f64.to_radians(), 9.81 / 0.8, friction, 500, 1.0 / 20.0, 0.01, 100 + seed);
            fit(&data, &options(None)).unwrap().model == model
        });
        assert!(right.count() >= 9, "{model:?}");
    }
}

#[test]
fn a_term_at_its_bound_leaves_the_others_uncertain() {
    let friction = Friction::new(0.01, 0.02, 0.1, 0.0).unwrap();
    let bound = |model: Model| {
        (1..20).find_map(|seed| {
            let data = record(1.2, 9.81 / 0.8, friction, 600, 1.0 / 30.0, 0.01, seed);
            let found = fit(&data, &options(Some(model))).unwrap();
            (found.friction.presliding.is_none_or(|e| e.value == 0.0)).then_some((data, found))
        })
    };
    let (data, held) = bound(Model::Presliding).unwrap();
    let presliding = held.friction.presliding.unwrap();
    assert!(presliding.value == 0.0 && (1e-5..1e-2).contains(&presliding.u), "{presliding:?}");
    assert_eq!(held.ladder.last().unwrap().wanted_negative.last(), Some(&"ln presliding"));
    // What presliding would change: a frequency whose uncertainty takes it as known is too sure.
    let alone = fit(&data, &options(Some(Model::Dry))).unwrap();
    let ratio = held.omega0.statistical / alone.omega0.statistical;
    assert!((1.3..10.0).contains(&ratio), "{:?} {:?}", held.omega0, alone.omega0);
    assert!((held.omega0.value - alone.omega0.value).abs() < alone.omega0.u);
}

/// Accelerations under dry friction that falls while the velocity rises, with a wave of twice the frequency from a sensor that hangs
/// askew.
fn askew(phase: f64) -> Data {
    let friction = Friction::new(-0.027, 0.0103, 0.081, 0.0).unwrap();
    let frequency = Frequency::from_omega0(6.15).unwrap();
    let pendulum = DampedPendulum::new(0.95, 0.0, frequency, friction, libration::Torque::NONE).unwrap();
    let trajectory = pendulum.trajectory(0.0, 40.0).unwrap();
    let t: Vec<f64> = (0..1000).map(|i| 0.04 * i as f64).collect();
    let noise = Stream::new(17).noise(0.0, t.len());
    let shown = |(t, e): (&f64, f64)| {
        let tangential = -0.27 * 6.15 * 6.15 * trajectory.theta(*t).sin();
        tangential + 0.2 * (12.2 * t + phase).sin() * (-t / 40.0).exp() + 0.03 * e
    };
    let values = t.iter().zip(noise).map(shown).collect();
    Data::Record { measured: Measured::Acceleration, t, values }
}

#[test]
fn dry_friction_and_linear_friction_do_not_hold_each_other_at_0() {
    for phase in [2.0, 3.0] {
        let data = askew(phase);
        let of = |model| fit(&data, &FitOptions { model, ..FitOptions::default() }).unwrap();
        let (all, alone) = (of(None), of(Some(Model::Dry)));
        let among = all.ladder.iter().find(|rung| rung.model == Model::Dry).unwrap();
        let poorer = all.ladder.iter().find(|rung| rung.model == Model::Quadratic).unwrap();
        // One minimum, whatever the search began from.
        for rms in [alone.ladder[0].rms, alone.rms] {
            assert!((among.rms / rms - 1.0).abs() < 1e-4, "{phase}: {} {rms}", among.rms);
        }
        assert!(alone.rms < 0.985 * poorer.rms, "{phase}: {} {}", alone.rms, poorer.rms);
    }
}

#[test]
fn presliding_over_more_than_any_swing_is_no_friction() {
    let found = fit(&askew(0.0), &FitOptions::default()).unwrap();
    assert!((found.omega0.value / 6.15 - 1.0).abs() < 2e-3, "{}", found.omega0.value);
}

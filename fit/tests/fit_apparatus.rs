//! Lengths from parts, corrections, reversible pendulums, records together.

use libration::{DampedPendulum, Frequency, Friction, Shape, Torque};
use libration_fit::fit::{
    Corrections, Data, FitOptions, Measure, Measured, MeasuredPart, Model, Stream, fit, fit_lengths,
    fit_runs, length_of_parts, reversible, reversible_between,
};

fn measure(value: f64, u: f64) -> Measure {
    Measure { value, u }
}

/// A record of a pendulum of this length where g is 9.81, with noise that repeats on every machine.
fn record(length: f64, seed: u64) -> Data {
    let frequency = Frequency::from_gravity_length(9.81, length).unwrap();
    let friction = Friction::new(0.02, 0.0, 0.0, 0.0).unwrap();
    let pendulum = DampedPendulum::new(0.6, 0.0, frequency, friction, Torque::NONE).unwrap();
    let trajectory = pendulum.trajectory(0.0, 20.0).unwrap();
    let t: Vec<f64> = (0..500).map(|i| 0.04 * f64::from(i)).collect();
    let noise = Stream::new(seed).noise(0.0, t.len());
    let values = t.iter().zip(noise).map(|(t, e)| trajectory.theta(*t) + 0.004 * e).collect();
    Data::Record { measured: Measured::Angle, t, values }
}

/// The friction of the records is known, so the ladder need not look for it.
fn known() -> FitOptions {
    FitOptions { model: Some(Model::Linear), ..FitOptions::default() }
}

#[test]
fn parts_give_the_length_and_its_uncertainty() {
    let part = |shape, mass: f64, distance: f64, size: f64| MeasuredPart {
        shape,
        mass: measure(mass, 1e-4),
        distance: measure(distance, 5e-4),
        size: measure(size, 5e-4),
    };
    let parts = vec![part(Shape::Rod, 0.019, 0.2475, 0.495), part(Shape::Ball, 0.031, 0.495, 0.01)];
    let length = length_of_parts(&parts).unwrap();
    assert!((length.value - 0.4564).abs() < 2e-4 && (2e-4..2e-3).contains(&length.u), "{length:?}");
    let found = fit(&record(length.value, 4), &FitOptions { parts, ..known() }).unwrap();
    let g = found.g.unwrap();
    assert!(
        (g.value - 9.81).abs() < 4.0 * g.u && g.calibration > 0.9 * 9.81 * length.u / length.value,
        "{g:?}"
    );
}

#[test]
fn corrections_change_g_and_can_be_switched_off() {
    let bob =
        Corrections { radius: Some(0.02), mass: Some(0.0027), wire: Some(1e-4), ..Corrections::default() };
    let options = |corrections| FitOptions { length: Some(measure(0.5, 0.0)), corrections, ..known() };
    let data = record(0.5, 4);
    let g = |corrections| fit(&data, &options(corrections)).unwrap();
    let with = g(bob);
    let off = Corrections { bob_size: false, wire_mass: false, buoyancy: false, added_mass: false, ..bob };
    let without = g(off);
    let ratio = with.g.unwrap().value / without.g.unwrap().value;
    let product: f64 = with.corrections.iter().map(|row| (1.0 + row.relative_period).powi(2)).product();
    assert!((ratio - product).abs() < 1e-12 && ratio > 1.01, "{ratio} {product}");
    assert_eq!(with.corrections.len(), 4);
    assert!(without.corrections.iter().all(|row| !row.made));
}

#[test]
fn a_symmetric_crossing_of_a_reversible_pendulum_is_flagged() {
    let good =
        reversible([measure(1.638_2, 2e-4); 2], [measure(0.5, 5e-4), measure(1.0 / 6.0, 5e-4)]).unwrap();
    assert!((good.g.value - 9.81).abs() < 4.0 * good.g.u && good.verdicts.is_empty(), "{good:?}");
    let bad = reversible([measure(1.5995, 2e-4); 2], [measure(0.4, 5e-4), measure(0.2503, 5e-4)]).unwrap();
    assert!(!bad.verdicts.is_empty(), "{bad:?}");
    assert!(reversible([measure(1.6, 0.0), measure(1.7, 0.0)], [measure(0.4, 0.0); 2]).is_err());
}

#[test]
fn the_distance_between_pivots_counts_more_than_the_centre_of_mass() {
    let (periods, first) = ([measure(2.0061, 1e-4), measure(2.0063, 1e-4)], measure(0.66, 0.002));
    let both = reversible(periods, [first, measure(0.3401, 0.002)]).unwrap();
    let between = reversible_between(periods, measure(1.0001, 1e-5), first).unwrap();
    assert!((both.g.value - between.g.value).abs() < 1e-12, "{both:?} {between:?}");
    assert!(between.g.u < 0.1 * both.g.u, "{both:?} {between:?}");
    assert!(reversible_between(periods, measure(0.5, 0.0), first).is_err());
}

#[test]
fn impossible_bobs_are_refused() {
    let data = record(0.5, 4);
    let refused = |corrections: Corrections| {
        let options = FitOptions { corrections, ..FitOptions::default() };
        fit(&data, &options).unwrap_err().to_string()
    };
    let known = Corrections { radius: Some(0.02), mass: Some(0.01), ..Corrections::default() };
    assert!(refused(Corrections { radius: Some(-1.0), ..known }).starts_with("bob radius = -1"));
    assert!(refused(Corrections { density: 998.0, ..known }).contains("floats"));
    assert!(refused(Corrections { wire: Some(0.001), mass: None, ..known }).contains("without a bob mass"));
}

#[test]
fn records_together_know_more_than_one() {
    let runs: Vec<Data> = (0..4).map(|i| record(0.5, 100 + i)).collect();
    let options = FitOptions { length: Some(measure(0.5, 0.0)), ..known() };
    let all = fit_runs(&runs, &options).unwrap();
    let one = all.fits[0].g.unwrap();
    let g = all.g.unwrap();
    assert!((g.value - 9.81).abs() < 4.0 * g.u && g.u < 0.75 * one.u, "{g:?} {one:?}");
    // One run of another pendulum does not agree.
    let mut spoiled = runs;
    spoiled[2] = record(0.51, 7);
    assert!(!fit_runs(&spoiled, &options).unwrap().verdicts.is_empty());
}

#[test]
fn several_lengths_show_what_they_leave_out() {
    // Each is measured to the top of a bob whose centre lies 15 mm below.
    let lengths = [0.4, 0.6, 0.8, 1.0];
    let runs: Vec<Data> = lengths.iter().enumerate().map(|(i, l)| record(l + 0.015, 50 + i as u64)).collect();
    let stated: Vec<Measure> = lengths.iter().map(|l| measure(*l, 2e-4)).collect();
    let found = fit_lengths(&runs, &stated, &known()).unwrap();
    let (g, offset) = (found.g.unwrap(), found.length_offset.unwrap());
    assert!((g.value - 9.81).abs() < 4.0 * g.u && g.u < 0.05, "{g:?}");
    assert!((offset.value - 0.015).abs() < 4.0 * offset.u && !found.verdicts.is_empty(), "{offset:?}");
    let sum: f64 = found.budget.iter().map(|row| row.u * row.u).sum();
    assert!((sum.sqrt() / g.u - 1.0).abs() < 1e-12, "{:?}", found.budget);
    assert!(fit_lengths(&runs, &stated[..3], &known()).is_err());
}

#[test]
fn two_lengths_that_miss_the_same_say_so() {
    let sentences = |short: f64| {
        let runs = [record(0.4 + short, 50), record(1.0 + short, 51)];
        let stated = [measure(0.4, 2e-4), measure(1.0, 2e-4)];
        let found = fit_lengths(&runs, &stated, &known()).unwrap();
        assert!(found.length_offset.is_none());
        found.verdicts.into_iter().map(|verdict| verdict.sentence).collect::<Vec<_>>()
    };
    let said = sentences(0.015);
    let numbers = said.iter().find_map(|s| s.strip_prefix("both lengths agree on g = ")).unwrap();
    let number = |after: &str| -> f64 {
        let rest = numbers.split_once(after).map_or(numbers, |cut| cut.1);
        rest.split(' ').next().unwrap().parse().unwrap()
    };
    assert!((number("") - 9.81).abs() < 0.02 && (number("short by ") - 0.015).abs() < 1e-3, "{numbers}");
    assert!(sentences(0.0).is_empty());
}

#[test]
fn monte_carlo_and_bootstrap_agree_with_the_budget() {
    let options =
        FitOptions { length: Some(measure(0.5, 0.001)), monte_carlo: 4000, bootstrap: 400, ..known() };
    let found = fit(&record(0.5, 4), &options).unwrap();
    let (g, (low, high)) = (found.g.unwrap(), found.monte_carlo.unwrap());
    assert!(((high - low) / (2.0 * 1.96 * g.u) - 1.0).abs() < 0.1, "{low} {high} {g:?}");
    let bootstrap = found.diagnostics.omega0_u_bootstrap.unwrap();
    assert!((0.5..1.6).contains(&(bootstrap / found.omega0.statistical)), "{bootstrap} {:?}", found.omega0);
    assert_eq!(found, fit(&record(0.5, 4), &options).unwrap());
}

#[test]
fn monte_carlo_draws_how_much_of_each_correction_is_true() {
    // A table-tennis ball, whose air counts more than the rest.
    let corrections = Corrections { radius: Some(0.02), mass: Some(0.0027), ..Corrections::default() };
    let bob = FitOptions { corrections, monte_carlo: 4000, ..known() };
    let with_length = FitOptions { length: Some(measure(0.5, 0.0)), ..bob.clone() };
    let with_gravity = FitOptions { gravity: Some(measure(9.81, 0.0)), ..bob };
    for options in [with_length, with_gravity] {
        let found = fit(&record(0.5, 4), &options).unwrap();
        let quoted = if options.length.is_some() { found.g } else { found.length }.unwrap();
        let (low, high) = found.monte_carlo.unwrap();
        let by_corrections = found.budget.iter().find(|row| row.source == "corrections").unwrap().u;
        assert!(by_corrections > 0.9 * quoted.u, "{:?}", found.budget);
        assert!(((high - low) / (2.0 * 1.96 * quoted.u) - 1.0).abs() < 0.1, "{low} {high} {quoted:?}");
        assert!((0.5 * (low + high) / quoted.value - 1.0).abs() < 1e-3, "{low} {high} {quoted:?}");
    }
}

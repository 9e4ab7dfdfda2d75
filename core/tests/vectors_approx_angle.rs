//! The approximations of the angle against the truth, formula by formula, and the spoiled siblings that must go red.

mod ruler;

use libration::approx::{ANGLES, AngleApproximation, AngleFormula};
use libration::{Frequency, Orbit};
use ruler::{Row, distance, rows, ulp};
use std::collections::BTreeMap;

const VECTORS: &str = include_str!("../../reference/vectors/approx_angle.csv");
const ROWS: usize = 527;

/// The promise for angles, in ulps of the scale eased by the condition.
const BOUND: f64 = 8.0;
/// The promise for periods, likewise.
const PERIOD: f64 = 4.0;
/// The promise for differences of formulas that know what they leave out: of the difference itself.
const RELATIVE: f64 = 1e-10;

fn made(row: &Row) -> AngleApproximation {
    let force = Frequency::from_omega2(row.hex("omega2")).unwrap();
    let orbit = Orbit::new(row.hex("theta0"), row.hex("velocity0"), force).unwrap();
    AngleFormula::named(row.text("formula")).unwrap().of(&orbit).unwrap()
}

/// What of the condition the answer may bear: coefficients of the sine models are rounded to double.
fn eased(row: &Row, name: &str) -> f64 {
    let rounded = row.text("formula").starts_with("cubic");
    row.decimal(&format!("cond_{name}")) * 2f64.powi(if rounded { -53 } else { -100 })
}

fn knows_its_rest(row: &Row) -> bool {
    row.text("formula") == "harmonic" || row.text("formula").starts_with("fourier")
}

/// Errors over the promise of angle, difference and period.
fn errors(row: &Row, [theta, difference, period]: [f64; 3]) -> [f64; 3] {
    let unit = ulp(row.decimal("scale"));
    let truth = ["theta", "difference", "period"].map(|name| row.truth(name));
    let allowed = if knows_its_rest(row) {
        RELATIVE * truth[1][0].abs() + eased(row, "difference")
    } else {
        // That of both angles.
        BOUND * (unit + ulp(truth[1][0])) + eased(row, "difference")
    };
    [
        distance(theta, truth[0], BOUND * unit + eased(row, "theta")),
        distance(difference, truth[1], allowed),
        distance(period, truth[2], PERIOD * ulp(truth[2][0]) + eased(row, "period")),
    ]
}

fn values(row: &Row) -> [f64; 3] {
    let made = made(row);
    let t = row.hex("t");
    [made.theta(t), made.difference(t), made.period()]
}

/// Worst error over the promise by formula; `told` prints the rows beyond it.
fn worst(told: bool, values: impl Fn(&Row) -> [f64; 3]) -> BTreeMap<String, [f64; 3]> {
    let mut table: BTreeMap<String, [f64; 3]> = BTreeMap::new();
    for row in rows(VECTORS, ROWS) {
        let got = values(&row);
        let errors = errors(&row, got);
        if told && errors.iter().any(|error| *error > 1.0) {
            let [id, stratum, formula] = ["id", "stratum", "formula"].map(|name| row.text(name));
            println!("{id} {stratum} {formula} {errors:?} {got:?}");
        }
        let name = AngleFormula::named(row.text("formula")).unwrap().entry().name.to_string();
        let entry = table.entry(name).or_default();
        for (worst, error) in entry.iter_mut().zip(errors) {
            *worst = f64::max(*worst, error);
        }
    }
    for (name, worst) in &table {
        println!("{name:16} {worst:.3?}");
    }
    table
}

#[test]
fn every_formula_keeps_its_promise() {
    let table = worst(true, values);
    assert_eq!(table.len(), ANGLES.len());
    for (name, errors) in table {
        assert!(errors.iter().all(|error| *error <= 1.0), "{name} {errors:?}");
    }
}

#[test]
fn slices_hold_what_single_instants_do() {
    for row in rows(VECTORS, ROWS).iter().step_by(7) {
        let made = made(row);
        let times = [row.hex("t"), 0.0, -1.5, f64::NAN];
        let (mut theta, mut difference) = ([7.0; 4], [7.0; 4]);
        made.theta_into(&times, &mut theta);
        made.difference_into(&times, &mut difference);
        for (i, t) in times.into_iter().enumerate() {
            assert_eq!(theta[i].to_bits(), made.theta(t).to_bits());
            assert_eq!(difference[i].to_bits(), made.difference(t).to_bits());
        }
        assert!(theta[3].is_nan() && difference[3].is_nan());
    }
}

#[test]
fn spoiled_siblings_are_found() {
    let bad = |spoiled: &dyn Fn(&Row) -> [f64; 3]| {
        worst(false, spoiled).values().filter(|errors| errors.iter().any(|error| *error > 1.0)).count()
    };
    // Some ulps, a plain difference of two angles, a wrong sign, a period in another formula, a clipped arcsine.
    let scaled = 1.0 + 2e-14;
    assert_eq!(bad(&|row| values(row).map(|value| value * scaled)), ANGLES.len());
    let plain = |row: &Row| {
        let made = made(row);
        let force = Frequency::from_omega2(row.hex("omega2")).unwrap();
        let orbit = Orbit::new(row.hex("theta0"), row.hex("velocity0"), force).unwrap();
        let t = row.hex("t");
        [made.theta(t), made.theta(t) - orbit.theta(t), made.period()]
    };
    assert_eq!(bad(&plain), 3);
    let turned = |row: &Row| {
        let [theta, difference, period] = values(row);
        [theta, -difference, period]
    };
    assert_eq!(bad(&turned), ANGLES.len());
    let clipped = |row: &Row| values(row).map(|value| if value.is_nan() { 3.0 } else { value });
    assert!(bad(&clipped) >= 4);
    let approximate = |row: &Row| {
        let [theta, difference, _] = values(row);
        [theta, difference, std::f64::consts::TAU / row.hex("omega2").abs().sqrt()]
    };
    assert!(bad(&approximate) >= 8);
}

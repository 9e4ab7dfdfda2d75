//! The approximations of the angle against the truth, formula by formula, and the spoiled siblings that must go red.

use crate::ruler::{Row, distance, rows, ulp};
use libration::approx::{ANGLES, AngleApproximation, AngleFormula};
use libration::{Frequency, Orbit};
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

fn released(degrees: f64, name: &str) -> AngleApproximation {
    let orbit = Orbit::new(degrees.to_radians(), 0.0, Frequency::from_omega0(1.0).unwrap()).unwrap();
    AngleFormula::named(name).unwrap().of(&orbit).unwrap()
}

/// Lima's percentages: the largest difference over a period, of the turning angle.
#[test]
fn percentages_of_lima() {
    let table = [
        (60.0, "harmonic", "0.9413"),
        (60.0, "fourier:1", "1.9513"),
        (60.0, "fourier:2", "0.0350"),
        (90.0, "harmonic", "2.3289"),
        (90.0, "fourier:2", "0.2269"),
        (144.0, "fourier:3", "0.6069"),
        (157.5, "harmonic", "12.3427"),
        (157.5, "fourier:4", "0.3989"),
        (171.0, "fourier:6", "0.2945"),
    ];
    let percent = |degrees: f64, made: &AngleApproximation| {
        format!("{:.4}", made.largest_error(1.0).unwrap().difference / degrees * 100.0f64.to_degrees())
    };
    for (degrees, name, printed) in table {
        assert_eq!(percent(degrees, &released(degrees, name)), printed, "{degrees} {name}");
        // The sibling: half a degree more.
        assert_ne!(percent(degrees, &released(degrees + 0.5, name)), printed, "{degrees} {name}");
    }
}

/// Whatever the doubles, every formula is refused or answers, and every search ends.
#[test]
fn corners_are_answered() {
    let angles = [0.0, 5e-324, -1e-310, 1e-200, -1e-20, 1.0, std::f64::consts::PI, -3.2, 1e15, 1.7e308];
    let speeds = [0.0, 5e-324, -1e-100, 0.5, -2.0, 1e10, 1e300];
    let forces = [1.0, -3.7, 0.0, 5e-324, 1e-150, 1e308];
    let names = [
        "linear", "harmonic", "fourier:1", "fourier:500", "fourier-theta:2", "trigonometric", "small-m",
        "small-m-bounded", "cubic", "cubic-quintic", "taylor:200",
    ];
    let mut answered = 0;
    for (theta0, velocity0, omega2) in
        angles.iter().flat_map(|a| speeds.iter().flat_map(move |v| forces.map(|f| (*a, *v, f))))
    {
        let orbit = Orbit::new(theta0, velocity0, Frequency::from_omega2(omega2).unwrap()).unwrap();
        for name in names {
            let Ok(made) = AngleFormula::named(name).unwrap().of(&orbit) else { continue };
            for t in [0.0, 1.0, -1e300, f64::INFINITY, f64::NAN, 0.3 * orbit.period()] {
                let (theta, difference) = (made.theta(t), made.difference(t));
                // A line and a polynomial in time go on where the exact angle is no longer known.
                // Of two angles beyond the doubles the difference is not known.
                let exact = orbit.theta(t);
                let none = theta.is_nan()
                    || exact.is_nan()
                    || (theta.is_infinite() && exact.is_infinite() && theta == exact);
                assert_eq!(difference.is_nan(), none, "{name} {theta0} {velocity0} {omega2} {t}: {theta}");
                answered += 1;
            }
            assert!(!made.period().is_infinite());
            if let Ok(found) = made.largest_error(0.01) {
                assert!(found.difference >= 0.0 && found.t >= 0.0, "{name} {orbit:?} {found:?}");
            }
        }
    }
    assert!(answered > 5000, "{answered}");
}

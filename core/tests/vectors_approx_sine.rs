//! The polynomials for the sine against the truth, and the spoiled siblings that must go red.

mod ruler;

use libration::approx::SineFormula;
use ruler::{Row, distance, rows, ulp};
use std::collections::BTreeMap;

const VECTORS: &str = include_str!("../../reference/vectors/approx_sine.csv");
const ROWS: usize = 849;

/// What may be missed of each quantity: ulps, and parts of itself for places.
const ALLOWED: [(&str, f64); 6] = [
    ("absolute", 2.0),
    ("at", 64.0),
    ("coefficient", 1.0),
    ("relative", 2.0),
    ("relative_at", 64.0),
    ("value", 1.0),
];

fn formula(row: &Row) -> SineFormula {
    let range = row.text("range");
    SineFormula::named(row.text("formula"), (!range.is_empty()).then(|| ruler::hex(range))).unwrap()
}

fn measured(row: &Row, formula: &SineFormula) -> f64 {
    let argument = row.hex("argument");
    match row.text("quantity") {
        "coefficient" => formula.coefficients()[argument as usize / 2],
        "value" => formula.value(argument),
        "absolute" => formula.largest_error(argument).unwrap().absolute,
        "at" => formula.largest_error(argument).unwrap().at,
        "relative" => formula.largest_error(argument).unwrap().relative,
        _ => formula.largest_error(argument).unwrap().relative_at,
    }
}

fn holds(rows: &[Row], measured: impl Fn(&Row, &SineFormula) -> f64) -> bool {
    let mut worst = BTreeMap::new();
    let mut made: Option<(String, SineFormula)> = None;
    for row in rows {
        let key = format!("{} {}", row.text("formula"), row.text("range"));
        if made.as_ref().is_none_or(|(of, _)| *of != key) {
            made = Some((key, formula(row)));
        }
        let Some((_, formula)) = &made else { unreachable!() };
        let truth = row.truth("value");
        let found = distance(measured(row, formula), truth, ulp(truth[0]));
        let largest = worst.entry(row.text("quantity")).or_insert(0.0);
        if found > *largest {
            println!("{} {} {} {found:.3}", row.text("quantity"), formula.name(), row.text("argument"));
            *largest = found;
        }
    }
    println!("{worst:.3?}");
    assert_eq!(worst.len(), ALLOWED.len());
    ALLOWED.iter().all(|(quantity, allowed)| worst[quantity] <= *allowed)
}

#[test]
fn every_polynomial_keeps_its_last_digits() {
    assert!(holds(&rows(VECTORS, ROWS), measured));
}

#[test]
fn spoiled_siblings_are_found() {
    let rows = rows(VECTORS, ROWS);
    assert!(!holds(&rows, |row, formula| measured(row, formula) * (1.0 + 3.0 * f64::EPSILON)));
    assert!(!holds(&rows, |row, formula| match row.text("quantity") {
        "at" => measured(row, formula) * (1.0 + 1e-13),
        _ => measured(row, formula),
    }));
    // The value of coefficients already rounded, and a largest error in doubles.
    assert!(!holds(&rows, |row, formula| match row.text("quantity") {
        "value" => {
            let phi = row.hex("argument");
            formula.coefficients().iter().rev().fold(0.0, |sum, c| sum * phi * phi + c) * phi
        }
        _ => measured(row, formula),
    }));
    assert!(!holds(&rows, |row, formula| match row.text("quantity") {
        "absolute" => {
            let at = formula.largest_error(row.hex("argument")).unwrap().at;
            (formula.value(at) - at.sin()).abs()
        }
        _ => measured(row, formula),
    }));
}

//! The polynomials for the sine against the truth, and the spoiled siblings that must go red.

use crate::ruler::{Row, distance, hex, rows, ulp};
use libration::approx::{SineError, SineFormula};
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
    SineFormula::named(row.text("formula"), (!range.is_empty()).then(|| hex(range))).unwrap()
}

fn measured(row: &Row, formula: &SineFormula, error: Option<SineError>) -> f64 {
    let argument = row.hex("argument");
    match row.text("quantity") {
        "coefficient" => formula.coefficients()[argument as usize / 2],
        "value" => formula.value(argument),
        "absolute" => error.unwrap().absolute,
        "at" => error.unwrap().at,
        "relative" => error.unwrap().relative,
        _ => error.unwrap().relative_at,
    }
}

type Answer<'a> = (&'a Row<'a>, SineFormula, f64);

/// Each row with its formula and what that gives; a formula and its errors are made once while they repeat.
fn answers<'a>(rows: &'a [Row<'a>]) -> Vec<Answer<'a>> {
    let mut made: Option<(String, SineFormula)> = None;
    let mut found: Option<(f64, SineError)> = None;
    let mut answers = Vec::new();
    for row in rows {
        let key = format!("{} {}", row.text("formula"), row.text("range"));
        if made.as_ref().is_none_or(|(of, _)| *of != key) {
            made = Some((key, formula(row)));
            found = None;
        }
        let formula = &made.as_ref().unwrap().1;
        let argument = row.hex("argument");
        let asked = !matches!(row.text("quantity"), "coefficient" | "value");
        if asked && found.is_none_or(|(of, _)| of != argument) {
            found = Some((argument, formula.largest_error(argument).unwrap()));
        }
        answers.push((row, formula.clone(), measured(row, formula, found.map(|(_, error)| error))));
    }
    answers
}

fn holds(answers: &[Answer], spoiled: impl Fn(&Answer) -> f64) -> bool {
    let mut worst = BTreeMap::new();
    for answer in answers {
        let (row, formula, _) = answer;
        let truth = row.truth("value");
        let found = distance(spoiled(answer), truth, ulp(truth[0]));
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
    let rows = rows(VECTORS, ROWS);
    assert!(holds(&answers(&rows), |(.., value)| *value));
}

#[test]
fn spoiled_siblings_are_found() {
    let rows = rows(VECTORS, ROWS);
    let answers = answers(&rows);
    let spoiled = |quantity: &str, other: &dyn Fn(&Answer) -> f64| {
        !holds(
            &answers,
            |answer| if answer.0.text("quantity") == quantity { other(answer) } else { answer.2 },
        )
    };
    for (quantity, allowed) in ALLOWED {
        assert!(
            spoiled(quantity, &|(.., value)| value * (1.0 + (2.0 * allowed + 1.0) * f64::EPSILON)),
            "{quantity}"
        );
        assert!(spoiled(quantity, &|(.., value)| -value), "{quantity}");
    }
    // The value of coefficients already rounded, and a largest error in doubles.
    assert!(spoiled("value", &|(row, formula, _)| {
        let phi = row.hex("argument");
        formula.coefficients().iter().rev().fold(0.0, |sum, c| sum * phi * phi + c) * phi
    }));
    assert!(spoiled("absolute", &|(row, formula, _)| {
        let at = formula.largest_error(row.hex("argument")).unwrap().at;
        (formula.value(at) - at.sin()).abs()
    }));
}

//! Every formula of the period and its error against the truth, and the spoiled siblings that must go red.

use crate::ruler::{Row, distance, rows, ulp};
use libration::approx::{PERIODS, PeriodFormula};

const VECTORS: &str = include_str!("../../reference/vectors/approx_period.csv");
/// Of each formula: turning angles, parameters m and complements mc.
const ROWS: usize = 31 + 23 + 21;

/// The rows, as many for each formula.
fn all_rows() -> Vec<Row<'static>> {
    let formulas = VECTORS.lines().skip(1).step_by(ROWS).count();
    let rows = rows(VECTORS, formulas * ROWS);
    assert!(
        rows.chunks(ROWS).all(|rows| rows.iter().all(|row| row.text("formula") == rows[0].text("formula")))
    );
    rows
}

/// A formula at the argument of a row: ratio and error.
fn of(formula: &PeriodFormula, row: &Row) -> [f64; 2] {
    let argument = row.hex("argument");
    match row.text("given") {
        "theta_max" => [formula.ratio(argument), formula.error(argument)],
        "m" => [formula.ratio_of_m(argument), formula.error_of_m(argument)],
        "mc" => [formula.ratio_of_mc(argument), formula.error_of_mc(argument)],
        other => panic!("a row is given by {other}"),
    }
}

fn measured(row: &Row) -> [f64; 2] {
    of(&PeriodFormula::named(row.text("formula")).unwrap(), row)
}

/// The worst distances in ulps; that of the error is eased by what is not told from 0.
fn worst(rows: &[Row], measured: impl Fn(&Row) -> [f64; 2]) -> [f64; 2] {
    let mut worst = [0.0_f64; 2];
    for row in rows {
        let [ratio, error] = measured(row);
        let truth = [row.truth("ratio"), row.truth("error")];
        let floor = if truth[1][0].abs() < 1.1e-44 { 1.1e-44 } else { 1e-45 };
        let found = [
            distance(ratio, truth[0], ulp(truth[0][0])),
            distance(error, truth[1], ulp(truth[1][0]) + floor),
        ];
        for (i, name) in ["ratio", "error"].into_iter().enumerate() {
            if found[i] > 1.0 {
                println!(
                    "{name} {} {} {} {found:?}",
                    row.text("formula"),
                    row.text("given"),
                    row.text("argument")
                );
            }
            worst[i] = worst[i].max(found[i]);
        }
    }
    println!("worst {worst:.3?}");
    worst
}

fn holds(rows: &[Row], measured: impl Fn(&Row) -> [f64; 2]) -> bool {
    worst(rows, measured).iter().all(|error| *error <= 1.0)
}

#[test]
fn every_formula_keeps_its_last_digits() {
    assert!(holds(&all_rows(), measured));
}

/// A formula without reference rows, or rows without a formula.
#[test]
fn every_formula_has_its_reference_rows() {
    let rows = all_rows();
    let base = |name: &str| name.split(':').next().unwrap_or(name).to_string();
    let mut given: Vec<String> = rows.iter().map(|row| base(row.text("formula"))).collect();
    given.sort();
    given.dedup();
    let mut listed: Vec<String> = PERIODS.iter().map(|entry| base(entry.name)).collect();
    listed.sort();
    assert_eq!(listed, given, "reference/approx_period.py writes the rows of every formula");
}

#[test]
fn spoiled_siblings_are_found() {
    let rows = all_rows();
    assert!(!holds(&rows, |row| measured(row).map(|value| value * (1.0 + 3.0 * f64::EPSILON))));
    assert!(!holds(&rows, |row| measured(row).map(|value| -value)));
    // The error as a difference of doubles, and a value where the formula has none.
    assert!(!holds(&rows, |row| {
        let [ratio, _] = measured(row);
        let exact = of(&PeriodFormula::named("exact").unwrap(), row)[0];
        [ratio, ratio / exact - 1.0]
    }));
    // The complement formed by subtraction: next to the top it has no digits left.
    assert!(!holds(&rows, |row| {
        let formula = PeriodFormula::named(row.text("formula")).unwrap();
        let m = 1.0 - row.hex("argument");
        if row.text("given") == "mc" { [formula.ratio_of_m(m), formula.error_of_m(m)] } else { measured(row) }
    }));
    assert!(!holds(&rows, |row| measured(row).map(|value| if value.is_nan() { 1.0 } else { value })));
}

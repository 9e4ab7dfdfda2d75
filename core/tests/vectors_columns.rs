//! The functions of columns against the truth, on every instruction set: a file of vectors as columns, whatever their order.

use crate::on_every_set;
use crate::ruler::{Row, distance, rows, ulp};
use libration::elliptic::{
    Given, carlson_rc_into, carlson_rd_into, carlson_rf_into, carlson_rj_into, complete_e_into,
    complete_k_into, complete_pi_into, heuman_lambda_into, incomplete_e_into, incomplete_f_into,
    incomplete_pi_into, inverse_jacobi_into, nome_into,
};
use libration::{Glaisher, InstructionSet};

const COMPLETE: &str = include_str!("../../reference/vectors/complete.csv");
const INCOMPLETE: &str = include_str!("../../reference/vectors/incomplete.csv");
const CARLSON: &str = include_str!("../../reference/vectors/carlson.csv");
const THIRD: &str = include_str!("../../reference/vectors/third_kind.csv");
const HEUMAN: &str = include_str!("../../reference/vectors/heuman.csv");
const INVERSE: &str = include_str!("../../reference/vectors/inverse_jacobi.csv");

/// Promised, in ulps; eased by 2^-98 of the condition where a file says that.
const BOUND: f64 = 3.0;

/// The named columns of some rows.
fn columns<const X: usize>(rows: &[&Row], names: [&str; X]) -> [Vec<f64>; X] {
    names.map(|name| rows.iter().map(|row| row.hex(name)).collect())
}

/// Rows, and how their parameter is given.
type Group<'r, 'a> = (Vec<&'r Row<'a>>, Given);

/// The rows by what states their parameter.
fn grouped<'r, 'a>(rows: &'r [Row<'a>]) -> [Group<'r, 'a>; 3] {
    [("m", Given::M), ("mc", Given::Mc), ("k", Given::Modulus)]
        .map(|(text, given)| (rows.iter().filter(|row| row.text("given") == text).collect(), given))
}

/// Largest error of a column of results.
fn worst(rows: &[&Row], name: &str, eased: bool, values: &[f64]) -> f64 {
    let mut worst = 0.0;
    for (row, value) in rows.iter().zip(values) {
        let truth = row.truth(name);
        let ease = if eased { row.decimal(&format!("cond_{name}")) * 2f64.powi(-98) } else { 0.0 };
        worst = f64::max(worst, distance(*value, truth, ulp(truth[0]) + ease));
    }
    worst
}

/// A function of named columns and a parameter, and the same too large in its fourth last bit.
fn of_parameter<const X: usize>(
    set: InstructionSet,
    rows: &[Row],
    names: [&str; X],
    result: &str,
    eased: bool,
    into: impl Fn([&[f64]; X], Given, &[f64], &mut [f64]),
) {
    let mut spoiled = 0.0;
    for (rows, given) in grouped(rows) {
        let arguments = columns(&rows, names);
        let [parameters] = columns(&rows, ["parameter"]);
        let mut values = vec![7.0; rows.len()];
        into(arguments.each_ref().map(Vec::as_slice), given, &parameters, &mut values);
        let error = worst(&rows, result, eased, &values);
        assert!(error <= BOUND, "{set:?} {result} {given:?} {error}");
        let nudged: Vec<f64> = values.iter().map(|value| value * (1.0 + 8.0 * f64::EPSILON)).collect();
        spoiled = f64::max(spoiled, worst(&rows, result, eased, &nudged));
    }
    assert!(spoiled > BOUND, "{set:?} {result}");
}

#[test]
fn of_one_parameter() {
    let rows = rows(COMPLETE, 697);
    on_every_set(|set| {
        of_parameter(set, &rows, [], "complete_k", false, |[], given, m, out| complete_k_into(given, m, out));
        of_parameter(set, &rows, [], "complete_e", false, |[], given, m, out| complete_e_into(given, m, out));
        of_parameter(set, &rows, [], "nome", false, |[], given, m, out| nome_into(given, m, out));
    });
}

#[test]
fn incomplete() {
    let (rows, lambdas) = (rows(INCOMPLETE, 1467), rows(HEUMAN, 616));
    on_every_set(|set| {
        of_parameter(set, &rows, ["phi"], "incomplete_f", false, |[phi], given, m, out| {
            incomplete_f_into(phi, given, m, out);
        });
        of_parameter(set, &rows, ["phi"], "incomplete_e", false, |[phi], given, m, out| {
            incomplete_e_into(phi, given, m, out);
        });
        of_parameter(set, &lambdas, ["phi"], "lambda", true, |[phi], given, m, out| {
            heuman_lambda_into(phi, given, m, out);
        });
    });
}

/// The rows of a file that belong to one function.
fn of_function(rows: Vec<Row<'static>>, name: &str) -> Vec<Row<'static>> {
    rows.into_iter().filter(|row| row.text("function") == name).collect()
}

#[test]
fn third_kind() {
    let complete = of_function(rows(THIRD, 914), "complete_pi");
    let incomplete = of_function(rows(THIRD, 914), "incomplete_pi");
    on_every_set(|set| {
        of_parameter(set, &complete, ["n"], "value", true, |[n], given, m, out| {
            complete_pi_into(n, given, m, out);
        });
        of_parameter(set, &incomplete, ["n", "phi"], "value", true, incomplete_pi_into);
    });
}

#[test]
fn inverses() {
    for which in Glaisher::ALL {
        let rows = of_function(rows(INVERSE, 2182), which.name());
        on_every_set(|set| {
            of_parameter(set, &rows, ["x"], "value", true, |[x], given, m, out| {
                inverse_jacobi_into(which, x, given, m, out);
            });
        });
    }
}

/// A function of columns alone.
fn of_columns<const X: usize>(name: &str, names: [&str; X], into: impl Fn([&[f64]; X], &mut [f64])) {
    let rows = of_function(rows(CARLSON, 978), name);
    let rows: Vec<&Row> = rows.iter().collect();
    let arguments = columns(&rows, names);
    on_every_set(|set| {
        let mut values = vec![7.0; rows.len()];
        into(arguments.each_ref().map(Vec::as_slice), &mut values);
        let error = worst(&rows, "value", true, &values);
        assert!(error <= BOUND, "{set:?} {name} {error}");
        let nudged: Vec<f64> = values.iter().map(|value| value * (1.0 + 8.0 * f64::EPSILON)).collect();
        assert!(worst(&rows, "value", true, &nudged) > BOUND, "{set:?} {name}");
    });
}

#[test]
fn carlson() {
    of_columns("rf", ["x", "y", "z"], carlson_rf_into);
    of_columns("rc", ["x", "y"], carlson_rc_into);
    of_columns("rd", ["x", "y", "z"], carlson_rd_into);
    of_columns("rj", ["x", "y", "z", "p"], carlson_rj_into);
}

#[test]
#[should_panic(expected = "different lengths")]
fn lengths_must_agree() {
    incomplete_f_into(&[0.0, 1.0], Given::M, &[0.5, 0.5], &mut [0.0]);
}

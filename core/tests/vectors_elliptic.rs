//! Elliptic integrals and functions against the truth.

use crate::on_every_set;
use crate::ruler::{Row, distance, rows, same, ulp};
use libration::elliptic::{Given, jacobi_into};
use libration::{Jacobi, JacobiValues, Parameter, complete_e, complete_k, incomplete_e, incomplete_f, nome};
use std::collections::BTreeMap;

const JACOBI: &str = include_str!("../../reference/vectors/jacobi.csv");
const SPECIAL: &str = include_str!("../../reference/vectors/jacobi_special.csv");
const COMPLETE: &str = include_str!("../../reference/vectors/complete.csv");
const INCOMPLETE: &str = include_str!("../../reference/vectors/incomplete.csv");

fn given(row: &Row) -> Given {
    match row.text("given") {
        "m" => Given::M,
        "mc" => Given::Mc,
        "k" => Given::Modulus,
        other => panic!("{other}"),
    }
}

fn parameter(row: &Row) -> Parameter {
    given(row).parameter(row.hex("parameter"))
}

/// Worst error over all rows and outputs, in ulps eased by 2^-100 of the condition in u where there is one.
fn worst(rows: &[Row], names: &[&str], eased: bool, values: impl Fn(&Row) -> Vec<f64>) -> f64 {
    let mut table: BTreeMap<(&str, &str), f64> = BTreeMap::new();
    let mut worst = 0.0;
    for row in rows {
        for (name, got) in names.iter().zip(values(row)) {
            let truth = row.truth(name);
            let ease = if eased { row.decimal(&format!("cond_{name}")) * 2f64.powi(-100) } else { 0.0 };
            let error = distance(got, truth, ulp(truth[0]) + ease);
            let entry = table.entry((row.text("stratum"), name)).or_default();
            *entry = f64::max(*entry, error);
            worst = f64::max(worst, error);
        }
    }
    for ((stratum, name), error) in table {
        println!("{stratum:16} {name:12} {error:.3}");
    }
    worst
}

const FUNCTIONS: [&str; 4] = ["sn", "cn", "dn", "am"];

fn four(row: &Row) -> Vec<f64> {
    let JacobiValues { sn, cn, dn, am, .. } = Jacobi::new(parameter(row)).values(row.hex("u"));
    vec![sn, cn, dn, am]
}

/// By the lanes of rows with parameters of their own.
fn four_of_a_row(row: &Row) -> Vec<f64> {
    let mut values = [0.0; 4];
    let results = values.each_mut().map(std::slice::from_mut);
    jacobi_into(given(row), [&[row.hex("u")], &[row.hex("parameter")]], results);
    values.to_vec()
}

fn three(row: &Row) -> Vec<f64> {
    let p = parameter(row);
    vec![complete_k(p), complete_e(p), nome(p)]
}

fn two(row: &Row) -> Vec<f64> {
    let (phi, p) = (row.hex("phi"), parameter(row));
    vec![incomplete_f(phi, p), incomplete_e(phi, p)]
}

fn of_complete(values: impl Fn(&Row) -> Vec<f64>) -> f64 {
    worst(&rows(COMPLETE, 697), &["complete_k", "complete_e", "nome"], false, values)
}

fn of_incomplete(values: impl Fn(&Row) -> Vec<f64>) -> f64 {
    worst(&rows(INCOMPLETE, 1467), &["incomplete_f", "incomplete_e"], false, values)
}

fn of_jacobi(values: impl Fn(&Row) -> Vec<f64>) -> f64 {
    worst(&rows(JACOBI, 2823), &FUNCTIONS, true, values)
}

#[test]
fn everything_on_every_instruction_set() {
    on_every_set(|set| {
        for worst in [of_jacobi(four), of_jacobi(four_of_a_row), of_complete(three), of_incomplete(two)] {
            assert!(worst <= 3.0, "{set:?} {worst}");
        }
    });
}

#[test]
fn jacobi_limits() {
    for row in rows(SPECIAL, 116) {
        let twice = [four(&row), four_of_a_row(&row)].concat();
        for (name, got) in FUNCTIONS.iter().cycle().zip(twice) {
            let truth = row.hex(name);
            assert!(
                same(got, truth),
                "{name} {got} {truth} {} {} {}",
                row.text("given"),
                row.text("parameter"),
                row.text("u")
            );
        }
    }
}

/// Siblings that spoil a function: each must go red.
#[test]
fn spoiled_siblings_are_found() {
    let spoil = |values: Vec<f64>, index: usize, with: &dyn Fn(f64) -> f64| {
        let mut values = values;
        values[index] = with(values[index]);
        values
    };
    assert!(of_jacobi(|row| spoil(four(row), 0, &|sn| sn * (1.0 + 4.0 * f64::EPSILON))) > 3.0);
    assert!(of_jacobi(|row| spoil(four(row), 1, &f64::abs)) > 3.0);
    assert!(of_jacobi(|row| spoil(four_of_a_row(row), 0, &|sn| sn * (1.0 + 4.0 * f64::EPSILON))) > 3.0);
    assert!(of_jacobi(|row| spoil(four(row), 3, &|am| am % std::f64::consts::TAU)) > 3.0);
    assert!(of_jacobi(|row| spoil(four(row), 2, &|dn| if dn == 1.0 { f64::NAN } else { dn })) > 3.0);
    // The complement thrown away, and formed again from a rounded m.
    assert!(of_complete(|row| vec![complete_k(Parameter::from_m(parameter(row).m())), 1.0, 1.0]) > 3.0);
    assert!(of_complete(|row| spoil(three(row), 2, &|q| q * (1.0 - 4.0 * f64::EPSILON))) > 3.0);
    assert!(of_incomplete(|row| spoil(two(row), 0, &f64::abs)) > 3.0);
    assert!(of_incomplete(|row| spoil(two(row), 1, &|e| if e.is_nan() { 0.0 } else { e })) > 3.0);
}

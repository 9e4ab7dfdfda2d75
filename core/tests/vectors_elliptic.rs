//! Elliptic integrals and functions against the truth.

mod ruler;

use libration::{Jacobi, Parameter, complete_e, complete_k, incomplete_e, incomplete_f, nome};
use ruler::{Row, distance, rows, ulp};
use std::collections::BTreeMap;

const JACOBI: &str = include_str!("../../reference/vectors/jacobi.csv");
const SPECIAL: &str = include_str!("../../reference/vectors/jacobi_special.csv");
const COMPLETE: &str = include_str!("../../reference/vectors/complete.csv");
const INCOMPLETE: &str = include_str!("../../reference/vectors/incomplete.csv");

fn parameter(row: &Row) -> Parameter {
    let value = row.hex("parameter");
    match row.text("given") {
        "m" => Parameter::from_m(value),
        "mc" => Parameter::from_mc(value),
        "k" => Parameter::from_modulus(value),
        other => panic!("{other}"),
    }
}

/// Worst error in units of ulp + 2^-100 of the condition, over all rows and outputs.
fn worst(rows: &[Row], names: &[&str], conditions: &[&str], values: impl Fn(&Row) -> Vec<f64>) -> f64 {
    let mut table: BTreeMap<(&str, &str), f64> = BTreeMap::new();
    let mut worst = 0.0;
    for row in rows {
        for ((name, condition), got) in names.iter().zip(conditions).zip(values(row)) {
            let truth = row.truth(name);
            let unit = ulp(truth[0]) + row.decimal(condition) * 2f64.powi(-100);
            let error = if unit.is_infinite() { 0.0 } else { distance(got, truth, unit) };
            if error > 3.0 {
                println!(
                    "{name} {error} got {got:e} truth {truth:?} {}={:e}",
                    row.text("given"),
                    row.hex("parameter")
                );
            }
            let entry = table.entry((row.text("stratum"), name)).or_default();
            *entry = f64::max(*entry, error);
            worst = f64::max(worst, error);
        }
    }
    for ((stratum, name), error) in table {
        println!("{stratum:16} {name:5} {error:.3}");
    }
    worst
}

#[test]
fn jacobi() {
    let rows = rows(JACOBI, 2750);
    let worst =
        worst(&rows, &["sn", "cn", "dn", "am"], &["cond_sn", "cond_cn", "cond_dn", "cond_am"], |row| {
            let (sn, cn, dn, am) = Jacobi::new(parameter(row)).values(row.hex("u"));
            vec![sn, cn, dn, am]
        });
    assert!(worst <= 3.0, "{worst}");
}

#[test]
fn jacobi_limits() {
    for row in rows(SPECIAL, 116) {
        let (sn, cn, dn, am) = Jacobi::new(parameter(&row)).values(row.hex("u"));
        for (name, got) in [("sn", sn), ("cn", cn), ("dn", dn), ("am", am)] {
            let truth = row.hex(name);
            let same = got.to_bits() == truth.to_bits() || (got.is_nan() && truth.is_nan());
            assert!(
                same,
                "{name} {got} {truth} {} {} {}",
                row.text("given"),
                row.text("parameter"),
                row.text("u")
            );
        }
    }
}

#[test]
fn complete() {
    let rows = rows(COMPLETE, 679);
    let worst = worst(
        &rows,
        &["complete_k", "complete_e", "nome"],
        &["cond_complete_k", "cond_complete_e", "cond_nome"],
        |row| {
            let p = parameter(row);
            vec![complete_k(p), complete_e(p), nome(p)]
        },
    );
    assert!(worst <= 3.0, "{worst}");
}

#[test]
fn incomplete() {
    let rows = rows(INCOMPLETE, 1368);
    let worst =
        worst(&rows, &["incomplete_f", "incomplete_e"], &["cond_incomplete_f", "cond_incomplete_e"], |row| {
            let (phi, p) = (row.hex("phi"), parameter(row));
            vec![incomplete_f(phi, p), incomplete_e(phi, p)]
        });
    assert!(worst <= 3.0, "{worst}");
}

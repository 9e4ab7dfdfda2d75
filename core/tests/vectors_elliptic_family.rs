//! The elliptic family against the truth: Glaisher's twelve, Carlson's integrals.
//!
//! The unit is an ulp of the truth and 2^-100 of the condition in all arguments together.

mod ruler;

use libration::lanes::InstructionSet;
use libration::{Glaisher, Jacobi, Parameter, carlson_rc, carlson_rd, carlson_rf, carlson_rj};
use ruler::{Row, distance, rows, ulp};
use std::collections::BTreeMap;

const GLAISHER: &str = include_str!("../../reference/vectors/glaisher.csv");
const CARLSON: &str = include_str!("../../reference/vectors/carlson.csv");

/// What is promised.
const BOUND: f64 = 5.0;

fn parameter(row: &Row) -> Parameter {
    let value = row.hex("parameter");
    match row.text("given") {
        "m" => Parameter::from_m(value),
        "mc" => Parameter::from_mc(value),
        "k" => Parameter::from_modulus(value),
        other => panic!("{other}"),
    }
}

/// Errors by stratum and function, printed when it is dropped.
#[derive(Default)]
struct Table(BTreeMap<(&'static str, String), (f64, String)>);

impl Table {
    fn add(&mut self, row: &Row<'static>, columns: &str, name: &str, got: f64) {
        let truth = row.truth(columns);
        let mut error = distance(got, truth, ulp(truth[0]) + row.decimal(&format!("cond_{columns}")) * 2f64.powi(-100));
        // An infinity or a zero has a sign of its own.
        if truth[0].is_infinite() && got == truth[0] {
            error = 0.0;
        }
        let entry = self.0.entry((row.text("stratum"), name.to_string())).or_default();
        if error > entry.0 {
            let place = ["function", "given", "parameter", "u", "x", "y", "z", "n", "p", "phi", "re", "im"];
            let text = place.iter().filter_map(|c| row.get(c)).collect::<Vec<_>>().join(" ");
            *entry = (error, format!("{text}: {got:e} {:e}", truth[0]));
        }
    }
    fn worst(&self) -> f64 {
        self.0.values().fold(0.0, |worst, (error, _)| f64::max(worst, *error))
    }
    fn print(&self) {
        for ((stratum, name), (error, place)) in &self.0 {
            let place = if *error > 2.0 { place.as_str() } else { "" };
            println!("{stratum:16} {name:12} {error:8.3} {place}");
        }
    }
}

/// Errors of functions that stand in columns of their own.
fn of_columns(text: &'static str, count: usize, names: &[&str], values: impl Fn(&Row) -> Vec<f64>) -> f64 {
    let mut table = Table::default();
    for row in rows(text, count) {
        for (name, got) in names.iter().zip(values(&row)) {
            table.add(&row, name, name, got);
        }
    }
    table.print();
    table.worst()
}

/// Errors of functions that a row names.
fn of_rows(text: &'static str, count: usize, value: impl Fn(&Row) -> f64) -> f64 {
    let mut table = Table::default();
    for row in rows(text, count) {
        table.add(&row, "value", row.text("function"), value(&row));
    }
    table.print();
    table.worst()
}

fn twelve(row: &Row) -> Vec<f64> {
    let (jacobi, u) = (Jacobi::new(parameter(row)), row.hex("u"));
    Glaisher::ALL.map(|which| jacobi.glaisher(which, u)).to_vec()
}

fn of_glaisher(values: impl Fn(&Row) -> Vec<f64>) -> f64 {
    of_columns(GLAISHER, 593, &Glaisher::ALL.map(Glaisher::name), values)
}

fn carlson(row: &Row) -> f64 {
    let [x, y, z, p] = ["x", "y", "z", "p"].map(|name| row.hex(name));
    match row.text("function") {
        "rf" => carlson_rf(x, y, z),
        "rc" => carlson_rc(x, y),
        "rd" => carlson_rd(x, y, z),
        "rj" => carlson_rj(x, y, z, p),
        other => panic!("{other}"),
    }
}

fn of_carlson(value: impl Fn(&Row) -> f64) -> f64 {
    of_rows(CARLSON, 875, value)
}

#[test]
fn glaisher_on_every_instruction_set() {
    for set in InstructionSet::available() {
        set.force().unwrap();
        let worst = of_glaisher(twelve);
        assert!(worst <= BOUND, "{set:?} {worst}");
    }
    assert!(of_glaisher(|row| twelve(row).iter().map(|value| value * (1.0 + 8.0 * f64::EPSILON)).collect()) > BOUND);
    // A quotient of rounded values loses the digits next to the poles of a large argument; a lost sign is found.
    assert!(of_glaisher(|row| twelve(row).iter().map(|value| value.abs()).collect()) > BOUND);
}

#[test]
fn carlson_integrals() {
    let worst = of_carlson(carlson);
    assert!(worst <= BOUND, "{worst}");
    assert!(of_carlson(|row| carlson(row) * (1.0 + 8.0 * f64::EPSILON)) > BOUND);
    assert!(of_carlson(|row| carlson(row).abs()) > BOUND);
}

//! Functions of columns whose rows bring a parameter each, against the truth, row by row.

use crate::on_every_set;
use crate::ruler::Row;
use crate::vectors_elliptic_family::{
    BOUND, SECOND, Table, given, nudged, of_columns, of_glaisher, of_theta, spoiled,
};
use libration::elliptic::{glaisher_into, jacobi_epsilon_into, theta_into, theta_of_nome_into};
use libration::{Glaisher, ThetaFunction};

fn twelve_of_a_row(row: &Row) -> Vec<f64> {
    let mut value = [0.0];
    let arguments = [row.hex("u"), row.hex("parameter")];
    Glaisher::ALL
        .map(|which| {
            glaisher_into(given(row), which, arguments.each_ref().map(std::slice::from_ref), &mut value);
            value[0]
        })
        .to_vec()
}

fn epsilon_of_a_row(row: &Row) -> Vec<f64> {
    let mut value = [0.0];
    let arguments = [row.hex("u"), row.hex("parameter")];
    jacobi_epsilon_into(given(row), arguments.each_ref().map(std::slice::from_ref), &mut value);
    value.to_vec()
}

fn of_epsilon(values: impl Fn(&Row) -> Vec<f64>) -> Table {
    of_columns(SECOND, 693, &["epsilon"], values)
}

fn thetas_of_a_row(row: &Row) -> Vec<f64> {
    let arguments = [row.hex("z"), row.hex("parameter")];
    let arguments = arguments.each_ref().map(std::slice::from_ref);
    let mut value = [0.0];
    ThetaFunction::ALL
        .map(|which| {
            match row.text("given") {
                "q" => theta_of_nome_into(which, arguments, &mut value),
                _ => theta_into(given(row), which, arguments, &mut value),
            }
            value[0]
        })
        .to_vec()
}

#[test]
fn glaisher_on_every_instruction_set() {
    on_every_set(|_| of_glaisher(twelve_of_a_row).hold());
    assert!(of_glaisher(|row| spoiled(twelve_of_a_row(row), nudged)).worst() > BOUND);
}

#[test]
fn epsilon_on_every_instruction_set() {
    on_every_set(|_| of_epsilon(epsilon_of_a_row).hold());
    assert!(of_epsilon(|row| spoiled(epsilon_of_a_row(row), nudged)).worst() > BOUND);
}

#[test]
fn theta_functions_on_every_instruction_set() {
    on_every_set(|_| of_theta(thetas_of_a_row).hold());
    assert!(of_theta(|row| spoiled(thetas_of_a_row(row), nudged)).worst() > BOUND);
}

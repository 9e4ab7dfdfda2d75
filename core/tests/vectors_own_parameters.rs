//! Functions of columns whose rows bring a parameter each, against the truth, row by row.

use crate::on_every_set;
use crate::ruler::Row;
use crate::vectors_elliptic_family::{BOUND, given, nudged, of_glaisher, of_second, of_theta, spoiled};
use libration::elliptic::{
    glaisher_into, jacobi_epsilon_into, jacobi_zeta_into, theta_into, theta_of_nome_into,
};
use libration::{Glaisher, ThetaFunction, complete_e, complete_k};

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

fn second_of_a_row(row: &Row) -> Vec<f64> {
    let (mut epsilon, mut zeta) = ([0.0], [0.0]);
    let arguments = [row.hex("u"), row.hex("parameter")];
    let arguments = arguments.each_ref().map(std::slice::from_ref);
    jacobi_epsilon_into(given(row), arguments, &mut epsilon);
    jacobi_zeta_into(given(row), arguments, &mut zeta);
    [epsilon, zeta].concat()
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
fn epsilon_and_zeta_on_every_instruction_set() {
    on_every_set(|_| of_second(second_of_a_row).hold());
    for part in [0, 1] {
        let one = |row: &Row| {
            let mut values = second_of_a_row(row);
            values[part] = nudged(values[part]);
            values
        };
        assert!(of_second(one).worst() > BOUND);
    }
    // By the difference, which cancels next to the zeros.
    let formed = |row: &Row| {
        let [epsilon, zeta] = [second_of_a_row(row)[0], second_of_a_row(row)[1]];
        let p = given(row).parameter(row.hex("parameter"));
        let difference = epsilon - row.hex("u") * (complete_e(p) / complete_k(p));
        vec![epsilon, if zeta.is_nan() { zeta } else { difference }]
    };
    assert!(of_second(formed).worst() > BOUND);
}

#[test]
fn theta_functions_on_every_instruction_set() {
    on_every_set(|_| of_theta(thetas_of_a_row).hold());
    assert!(of_theta(|row| spoiled(thetas_of_a_row(row), nudged)).worst() > BOUND);
}

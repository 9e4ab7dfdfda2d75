//! The ufuncs of the elliptic functions: one per keyword that carries the parameter, `_m`, `_mc`, `_k`, for the
//! theta functions `_q` too. The parameter is set up once for the rows that share it; Carlson's integrals have none.

use libration::elliptic::{
    Given, carlson_rc_into, carlson_rd_into, carlson_rf_into, carlson_rj_into, complete_e_into,
    complete_k_into, incomplete_e_into, incomplete_f_into,
};
use libration::{
    Glaisher, Jacobi, JacobiComplex, JacobiComplexValues, Parameter, SecondKind, Theta, ThetaFunction,
};
use pyo3::prelude::*;

use crate::ufunc::{Block, add, each, nothing, whole};

/// Adds the elliptic ufuncs to the module.
pub fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    for (keyword, given) in [("m", Given::M), ("mc", Given::Mc), ("k", Given::Modulus)] {
        let named = |name: &str| format!("{name}_{keyword}");
        jacobian(module, &named, given)?;
        second_kind(module, &named, given)?;
        integrals(module, &named, given)?;
        theta(module, &named, move |value| Theta::from_parameter(given.parameter(value)))?;
    }
    theta(module, &|name| format!("{name}_q"), Theta::from_nome)?;
    add(module, "carlson_rf", nothing, column(carlson_rf_into))?;
    add(module, "carlson_rc", nothing, column(carlson_rc_into))?;
    add(module, "carlson_rd", nothing, column(carlson_rd_into))?;
    add(module, "carlson_rj", nothing, column(carlson_rj_into))
}

/// A kernel made of a function of columns with one result.
#[allow(clippy::type_complexity)] // the type of a closure has no shorter name
fn column<const X: usize>(
    values: impl Fn([&[f64]; X], &mut [f64]),
) -> Block<[f64; 1], impl Fn(&(), [&[f64]; X], usize, [&mut [f64]; 1])> {
    whole(move |(): &(), columns: [&[f64]; X], _: usize, [out]: [&mut [f64]; 1]| values(columns, out))
}

fn values(jacobi: &Jacobi, [u]: [&[f64]; 1], _: usize, columns: [&mut [f64]; 4]) {
    jacobi.values_into(u, columns);
}

/// Jacobi's functions: four together, each of the twelve and its inverse, and three of a complex argument.
fn jacobian(module: &Bound<'_, PyModule>, named: &impl Fn(&str) -> String, given: Given) -> PyResult<()> {
    let set_up = move |[value]: [f64; 1]| Some(Jacobi::new(given.parameter(value)));
    add(module, &named("jacobi"), set_up, whole::<[f64; 4], _>(values))?;
    for which in Glaisher::ALL {
        let name = which.name();
        let function = move |jacobi: &Jacobi, [u]: [&[f64]; 1], _: usize, [out]: [&mut [f64]; 1]| {
            jacobi.glaisher_into(which, u, out);
        };
        add(module, &named(name), set_up, whole::<[f64; 1], _>(function))?;
        let inverse = move |p: &Parameter, [x]: [f64; 1]| [libration::inverse_jacobi(which, x, *p)];
        add(
            module,
            &named(&format!("arc{name}")),
            move |[value]| Some(given.parameter(value)),
            each(inverse),
        )?;
    }
    let complex = |jacobi: &JacobiComplex, [re, im]: [f64; 2]| {
        let JacobiComplexValues { sn, cn, dn, .. } = jacobi.values(re, im);
        [sn.re, sn.im, cn.re, cn.im, dn.re, dn.im]
    };
    add(
        module,
        &named("jacobi_complex"),
        move |[value]| Some(JacobiComplex::new(given.parameter(value))),
        each(complex),
    )
}

/// Jacobi's epsilon and zeta.
fn second_kind(module: &Bound<'_, PyModule>, named: &impl Fn(&str) -> String, given: Given) -> PyResult<()> {
    let set_up = move |[value]: [f64; 1]| Some(SecondKind::new(given.parameter(value)));
    add(module, &named("jacobi_epsilon"), set_up, each(|second: &SecondKind, [u]| [second.epsilon(u)]))?;
    add(module, &named("jacobi_zeta"), set_up, each(|second: &SecondKind, [u]| [second.zeta(u)]))
}

/// Legendre's integrals, the nome and Heuman's lambda.
fn integrals(module: &Bound<'_, PyModule>, named: &impl Fn(&str) -> String, given: Given) -> PyResult<()> {
    let parameter = move |[value]: [f64; 1]| Some(given.parameter(value));
    let incomplete_f = move |[phi, parameters]: [&[f64]; 2], f: &mut [f64]| {
        incomplete_f_into(phi, given, parameters, f);
    };
    add(module, &named("incomplete_f"), nothing, column(incomplete_f))?;
    let incomplete_e = move |[phi, parameters]: [&[f64]; 2], e: &mut [f64]| {
        incomplete_e_into(phi, given, parameters, e);
    };
    add(module, &named("incomplete_e"), nothing, column(incomplete_e))?;
    let incomplete_pi = |p: &Parameter, [n, phi]: [f64; 2]| [libration::incomplete_pi(n, phi, *p)];
    add(module, &named("incomplete_pi"), parameter, each(incomplete_pi))?;
    let complete_pi = |p: &Parameter, [n]: [f64; 1]| [libration::complete_pi(n, *p)];
    add(module, &named("complete_pi"), parameter, each(complete_pi))?;
    let heuman_lambda = |p: &Parameter, [phi]: [f64; 1]| [libration::heuman_lambda(phi, *p)];
    add(module, &named("heuman_lambda"), parameter, each(heuman_lambda))?;
    let complete_k = move |[parameters]: [&[f64]; 1], k: &mut [f64]| complete_k_into(given, parameters, k);
    add(module, &named("complete_k"), nothing, column(complete_k))?;
    let complete_e = move |[parameters]: [&[f64]; 1], e: &mut [f64]| complete_e_into(given, parameters, e);
    add(module, &named("complete_e"), nothing, column(complete_e))?;
    // It has nothing but its parameter: the value itself is what is kept.
    let kept = |value: &f64, []: [f64; 0]| [*value];
    add(module, &named("nome"), move |[value]| Some(libration::nome(given.parameter(value))), each(kept))
}

/// The four theta functions.
fn theta(
    module: &Bound<'_, PyModule>,
    named: &impl Fn(&str) -> String,
    from: impl Fn(f64) -> Theta + Copy + Send + Sync + 'static,
) -> PyResult<()> {
    for (i, which) in ThetaFunction::ALL.into_iter().enumerate() {
        let value = move |theta: &Theta, [z]: [f64; 1]| [theta.value(which, z)];
        add(module, &named(&format!("theta{}", i + 1)), move |[given]| Some(from(given)), each(value))?;
    }
    Ok(())
}

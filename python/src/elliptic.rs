//! The ufuncs of the elliptic functions: one per keyword that carries the parameter, `_m`, `_mc`, `_k`, `_q`. Every row has a
//! parameter of its own over lanes; for Jacobi's functions it is set up once for the rows that share it, and the ufuncs of `_rows`
//! are the others. Carlson's integrals have none.

use libration::elliptic::{
    Given, carlson_rc_into, carlson_rd_into, carlson_rf_into, carlson_rj_into, complete_e_into,
    complete_k_into, complete_pi_into, glaisher_into, heuman_lambda_into, incomplete_e_into,
    incomplete_f_into, incomplete_pi_into, inverse_jacobi_into, jacobi_epsilon_into, jacobi_into,
    jacobi_zeta_into, nome_into, theta_into, theta_of_nome_into,
};
use libration::parameter_of_nome;
use libration::{Complex, Glaisher, Jacobi, JacobiComplex, JacobiComplexValues, ThetaFunction};
use pyo3::prelude::*;

use crate::ufunc::{Block, add, each, nothing, whole};

/// Adds the elliptic ufuncs to the module.
pub fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    for (keyword, given) in [("m", Given::M), ("mc", Given::Mc), ("k", Given::Modulus), ("q", Given::Nome)] {
        let named = |name: &str| format!("{name}_{keyword}");
        jacobian(module, &named, given)?;
        second_kind(module, &named, given)?;
        let named_rows = |name: &str| format!("{name}_rows_{keyword}");
        rows(module, &named_rows, given)?;
        integrals(module, &named, given)?;
        if given != Given::Nome {
            theta(module, &named, move |which, arguments, values| {
                theta_into(given, which, arguments, values);
            })?;
        }
    }
    add(module, "from_nome", nothing, each(|(): &(), [q]| <[f64; 2]>::from(parameter_of_nome(q))))?;
    theta(module, &|name| format!("{name}_q"), theta_of_nome_into)?;
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

/// Jacobi's functions: four together, each of the twelve and its inverse, and both of a complex argument.
fn jacobian(module: &Bound<'_, PyModule>, named: &impl Fn(&str) -> String, given: Given) -> PyResult<()> {
    let set_up = move |[value]: [f64; 1]| Some(Jacobi::new(given.parameter(value)));
    add(module, &named("jacobi"), set_up, whole::<[f64; 4], _>(values))?;
    for which in Glaisher::ALL {
        let name = which.name();
        let function = move |jacobi: &Jacobi, [u]: [&[f64]; 1], _: usize, [out]: [&mut [f64]; 1]| {
            jacobi.glaisher_into(which, u, out);
        };
        add(module, &named(name), set_up, whole::<[f64; 1], _>(function))?;
        let inverse = move |[x, parameters]: [&[f64]; 2], values: &mut [f64]| {
            inverse_jacobi_into(which, x, given, parameters, values);
        };
        add(module, &named(&format!("arc{name}")), nothing, column(inverse))?;
    }
    for which in Glaisher::ALL {
        let value = move |jacobi: &JacobiComplex, [re, im]: [f64; 2]| {
            let Complex { re, im } = jacobi.glaisher(which, re, im);
            [re, im]
        };
        let name = format!("{}_complex", which.name());
        let set_up = move |[value]: [f64; 1]| Some(JacobiComplex::new(given.parameter(value)));
        add(module, &named(&name), set_up, each(value))?;
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

/// Jacobi's functions of rows with a parameter each.
fn rows(module: &Bound<'_, PyModule>, named: &impl Fn(&str) -> String, given: Given) -> PyResult<()> {
    let four = move |(): &(), arguments: [&[f64]; 2], _: usize, columns: [&mut [f64]; 4]| {
        jacobi_into(given, arguments, columns);
    };
    add(module, &named("jacobi"), nothing, whole::<[f64; 4], _>(four))?;
    for which in Glaisher::ALL {
        let one = move |(): &(), arguments: [&[f64]; 2], _: usize, [out]: [&mut [f64]; 1]| {
            glaisher_into(given, which, arguments, out);
        };
        add(module, &named(which.name()), nothing, whole::<[f64; 1], _>(one))?;
    }
    Ok(())
}

/// Jacobi's epsilon and zeta: as fast for one parameter as for one a row.
fn second_kind(module: &Bound<'_, PyModule>, named: &impl Fn(&str) -> String, given: Given) -> PyResult<()> {
    let epsilon =
        move |arguments: [&[f64]; 2], values: &mut [f64]| jacobi_epsilon_into(given, arguments, values);
    add(module, &named("jacobi_epsilon"), nothing, column(epsilon))?;
    let zeta = move |arguments: [&[f64]; 2], values: &mut [f64]| jacobi_zeta_into(given, arguments, values);
    add(module, &named("jacobi_zeta"), nothing, column(zeta))
}

/// Legendre's integrals, the nome and Heuman's lambda.
fn integrals(module: &Bound<'_, PyModule>, named: &impl Fn(&str) -> String, given: Given) -> PyResult<()> {
    let incomplete_f = move |[phi, parameters]: [&[f64]; 2], f: &mut [f64]| {
        incomplete_f_into(phi, given, parameters, f);
    };
    add(module, &named("incomplete_f"), nothing, column(incomplete_f))?;
    let incomplete_e = move |[phi, parameters]: [&[f64]; 2], e: &mut [f64]| {
        incomplete_e_into(phi, given, parameters, e);
    };
    add(module, &named("incomplete_e"), nothing, column(incomplete_e))?;
    let incomplete_pi = move |[n, phi, parameters]: [&[f64]; 3], values: &mut [f64]| {
        incomplete_pi_into([n, phi], given, parameters, values);
    };
    add(module, &named("incomplete_pi"), nothing, column(incomplete_pi))?;
    let complete_pi = move |[n, parameters]: [&[f64]; 2], values: &mut [f64]| {
        complete_pi_into(n, given, parameters, values);
    };
    add(module, &named("complete_pi"), nothing, column(complete_pi))?;
    let heuman_lambda = move |[phi, parameters]: [&[f64]; 2], values: &mut [f64]| {
        heuman_lambda_into(phi, given, parameters, values);
    };
    add(module, &named("heuman_lambda"), nothing, column(heuman_lambda))?;
    let complete_k = move |[parameters]: [&[f64]; 1], k: &mut [f64]| complete_k_into(given, parameters, k);
    add(module, &named("complete_k"), nothing, column(complete_k))?;
    let complete_e = move |[parameters]: [&[f64]; 1], e: &mut [f64]| complete_e_into(given, parameters, e);
    add(module, &named("complete_e"), nothing, column(complete_e))?;
    let nome = move |[parameters]: [&[f64]; 1], q: &mut [f64]| nome_into(given, parameters, q);
    add(module, &named("nome"), nothing, column(nome))
}

/// The four theta functions, as fast for one nome as for one a row.
fn theta(
    module: &Bound<'_, PyModule>,
    named: &impl Fn(&str) -> String,
    fill: impl Fn(ThetaFunction, [&[f64]; 2], &mut [f64]) + Copy + Send + Sync + 'static,
) -> PyResult<()> {
    for (i, which) in ThetaFunction::ALL.into_iter().enumerate() {
        let values = move |arguments: [&[f64]; 2], values: &mut [f64]| fill(which, arguments, values);
        add(module, &named(&format!("theta{}", i + 1)), nothing, column(values))?;
    }
    Ok(())
}

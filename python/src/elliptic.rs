//! The ufuncs of the elliptic functions: one per keyword that carries the parameter, `_m`, `_mc`, `_k`, for the
//! theta functions `_q` too. The parameter is set up once for the rows that share it, or, in the ufuncs of `_rows`, every row
//! has one of its own over lanes; Carlson's integrals have none.

use libration::elliptic::{
    Given, complete_e_into, complete_k_into, glaisher_into, jacobi_epsilon_into, jacobi_into, theta_into,
    theta_of_nome_into,
};
use libration::{
    Glaisher, Jacobi, JacobiComplex, JacobiComplexValues, Parameter, SecondKind, Theta, ThetaFunction,
};
use libration::{carlson_rc, carlson_rd, carlson_rf, carlson_rj};
use pyo3::prelude::*;

use crate::ufunc::{add, each, nothing, whole};

/// Adds the elliptic ufuncs to the module.
pub fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    for (keyword, given) in [("m", Given::M), ("mc", Given::Mc), ("k", Given::Modulus)] {
        let named = |name: &str| format!("{name}_{keyword}");
        jacobian(module, &named, given)?;
        second_kind(module, &named, given)?;
        let named_rows = |name: &str| format!("{name}_rows_{keyword}");
        rows(module, &named_rows, given)?;
        theta_rows(module, &named_rows, move |which, arguments, values| {
            theta_into(given, which, arguments, values);
        })?;
        integrals(module, &named, given)?;
        theta(module, &named, move |value| Theta::from_parameter(given.parameter(value)))?;
    }
    theta(module, &|name| format!("{name}_q"), Theta::from_nome)?;
    theta_rows(module, &|name| format!("{name}_rows_q"), theta_of_nome_into)?;
    add(module, "carlson_rf", nothing, each(|(): &(), [x, y, z]| [carlson_rf(x, y, z)]))?;
    add(module, "carlson_rc", nothing, each(|(): &(), [x, y]| [carlson_rc(x, y)]))?;
    add(module, "carlson_rd", nothing, each(|(): &(), [x, y, z]| [carlson_rd(x, y, z)]))?;
    add(module, "carlson_rj", nothing, each(|(): &(), [x, y, z, p]| [carlson_rj(x, y, z, p)]))
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
    let epsilon = move |(): &(), arguments: [&[f64]; 2], _: usize, [out]: [&mut [f64]; 1]| {
        jacobi_epsilon_into(given, arguments, out);
    };
    add(module, &named("jacobi_epsilon"), nothing, whole::<[f64; 1], _>(epsilon))
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
    let incomplete_f = |p: &Parameter, [phi]: [f64; 1]| [libration::incomplete_f(phi, *p)];
    add(module, &named("incomplete_f"), parameter, each(incomplete_f))?;
    let incomplete_e = |p: &Parameter, [phi]: [f64; 1]| [libration::incomplete_e(phi, *p)];
    add(module, &named("incomplete_e"), parameter, each(incomplete_e))?;
    let incomplete_pi = |p: &Parameter, [n, phi]: [f64; 2]| [libration::incomplete_pi(n, phi, *p)];
    add(module, &named("incomplete_pi"), parameter, each(incomplete_pi))?;
    let complete_pi = |p: &Parameter, [n]: [f64; 1]| [libration::complete_pi(n, *p)];
    add(module, &named("complete_pi"), parameter, each(complete_pi))?;
    let heuman_lambda = |p: &Parameter, [phi]: [f64; 1]| [libration::heuman_lambda(phi, *p)];
    add(module, &named("heuman_lambda"), parameter, each(heuman_lambda))?;
    let complete_k = move |(): &(), [parameters]: [&[f64]; 1], _: usize, [k]: [&mut [f64]; 1]| {
        complete_k_into(given, parameters, k);
    };
    add(module, &named("complete_k"), nothing, whole::<[f64; 1], _>(complete_k))?;
    let complete_e = move |(): &(), [parameters]: [&[f64]; 1], _: usize, [e]: [&mut [f64]; 1]| {
        complete_e_into(given, parameters, e);
    };
    add(module, &named("complete_e"), nothing, whole::<[f64; 1], _>(complete_e))?;
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

/// The four of rows with a nome each.
fn theta_rows(
    module: &Bound<'_, PyModule>,
    named: &impl Fn(&str) -> String,
    fill: impl Fn(ThetaFunction, [&[f64]; 2], &mut [f64]) + Copy + Send + Sync + 'static,
) -> PyResult<()> {
    for (i, which) in ThetaFunction::ALL.into_iter().enumerate() {
        let values = move |(): &(), arguments: [&[f64]; 2], _: usize, [out]: [&mut [f64]; 1]| {
            fill(which, arguments, out);
        };
        add(module, &named(&format!("theta{}", i + 1)), nothing, whole::<[f64; 1], _>(values))?;
    }
    Ok(())
}

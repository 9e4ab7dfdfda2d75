//! Every ufunc of the door: which function of the core answers a row, and what is set up once for it.
//!
//! Two paths. `orbit_*` takes an orbit by its exact factors and is meant for one orbit and many times; `state_*` and
//! `advance` take rows with states of their own. An elliptic function has one ufunc per keyword: `_m`, `_mc`, `_k`.

use libration::{Frequency, Jacobi, Orbit, Parameter};
use pyo3::prelude::*;

use crate::ufunc::add;

/// Adds all ufuncs to the module.
pub fn add_all(module: &Bound<'_, PyModule>) -> PyResult<()> {
    add(module, "factors", frequency, |frequency, []| <[f64; 3]>::from(frequency.factors()))?;

    add(module, "orbit_theta", orbit, |orbit, [t]| [orbit.theta(t)])?;
    add(module, "orbit_velocity", orbit, |orbit, [t]| [orbit.velocity(t)])?;
    add(module, "orbit_motion", orbit, |orbit, [t]| <[f64; 2]>::from(orbit.motion(t)))?;
    add(module, "turns", orbit, |orbit, [t]| orbit.turns(t))?;

    add(module, "state_theta", state, |orbit, [t]| [orbit.theta(t)])?;
    add(module, "state_velocity", state, |orbit, [t]| [orbit.velocity(t)])?;
    add(module, "state_motion", state, |orbit, [t]| <[f64; 2]>::from(orbit.motion(t)))?;
    add(module, "advance", frequency, |frequency, [theta, velocity, dt]| {
        <[f64; 2]>::from(libration::advance(theta, velocity, dt, *frequency))
    })?;

    add_elliptic(module, "m", Parameter::from_m)?;
    add_elliptic(module, "mc", Parameter::from_mc)?;
    add_elliptic(module, "k", Parameter::from_modulus)
}

/// Adds the elliptic ufuncs of one keyword.
fn add_elliptic(module: &Bound<'_, PyModule>, keyword: &str, from: fn(f64) -> Parameter) -> PyResult<()> {
    let named = |name: &str| format!("{name}_{keyword}");
    let jacobi = move |[given]: [f64; 1]| Some(Jacobi::new(from(given)));
    let parameter = move |[given]: [f64; 1]| Some(from(given));
    add(module, &named("jacobi"), jacobi, |jacobi, [u]| <[f64; 4]>::from(jacobi.values(u)))?;
    add(module, &named("incomplete_f"), parameter, |p, [phi]| [libration::incomplete_f(phi, *p)])?;
    add(module, &named("incomplete_e"), parameter, |p, [phi]| [libration::incomplete_e(phi, *p)])?;
    // A complete function has nothing but its parameter: the value itself is what is kept.
    add(module, &named("complete_k"), move |[given]| Some(libration::complete_k(from(given))), |k, []| [*k])?;
    add(module, &named("complete_e"), move |[given]| Some(libration::complete_e(from(given))), |e, []| [*e])?;
    add(module, &named("nome"), move |[given]| Some(libration::nome(from(given))), |q, []| [*q])
}

/// One orbit, its frequency by the exact factors.
fn orbit([theta0, velocity0, a, b, c]: [f64; 5]) -> Option<Orbit> {
    Orbit::new(theta0, velocity0, Frequency::from_factors(a, b, c).ok()?).ok()
}

/// The orbit of a row with a state of its own.
fn state([theta0, velocity0, omega0]: [f64; 3]) -> Option<Orbit> {
    Orbit::new(theta0, velocity0, Frequency::from_omega0(omega0).ok()?).ok()
}

/// The frequency of a row.
fn frequency([omega0]: [f64; 1]) -> Option<Frequency> {
    Frequency::from_omega0(omega0).ok()
}

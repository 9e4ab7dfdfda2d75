//! What a page does not need at first: formulas of the period, ranges, elliptic functions.

use super::{ORBITS, both, listed, refuse};
use crate::objects::ask;
use crate::workspace::{with_columns, with_text};
use libration::approx::{AngleFormula, PeriodFormula};
use libration::{Jacobi, Orbit, Parameter, complete_e, complete_k, nome};

/// Turning angles for which the formula named by the text stays within a share of them: a list of ends.
#[unsafe(no_mangle)]
pub extern "C" fn angle_ranges(bound: f64, periods: f64) -> i32 {
    let found = with_text(AngleFormula::named).and_then(|formula| formula.ranges(bound, periods));
    listed(found.map(|ranges| ranges.as_flattened().to_vec()))
}

/// Values of the formula of the period named by the text, of turning angles, parameters or complements, and their errors.
#[unsafe(no_mangle)]
pub extern "C" fn period_values(by: u32, rows: usize) -> u32 {
    match with_text(PeriodFormula::named) {
        Err(domain) => (refuse(&domain), 0).1,
        Ok(formula) => {
            match by {
                0 => both(rows, |theta_max| [formula.ratio(theta_max), formula.error(theta_max)]),
                1 => both(rows, |m| [formula.ratio_of_m(m), formula.error_of_m(m)]),
                _ => both(rows, |mc| [formula.ratio_of_mc(mc), formula.error_of_mc(mc)]),
            }
            1
        }
    }
}

/// The period that the formula named by the text gives an orbit.
#[unsafe(no_mangle)]
pub extern "C" fn period_of(orbit: u32) -> f64 {
    let formula = with_text(PeriodFormula::named);
    let period = |orbit: &mut Orbit| formula.map_or(f64::NAN, |formula| formula.period(orbit));
    ask(&ORBITS, orbit, period).unwrap_or(f64::NAN)
}

/// Turning angles for which the formula of the period named by the text stays within a bound: a list of ends.
#[unsafe(no_mangle)]
pub extern "C" fn period_ranges(bound: f64) -> i32 {
    let found = with_text(PeriodFormula::named).and_then(|formula| formula.ranges(bound));
    listed(found.map(|ranges| ranges.as_flattened().to_vec()))
}

/// A parameter from m, its complement or the modulus.
fn parameter(given: u32, value: f64) -> Parameter {
    match given {
        0 => Parameter::from_m(value),
        1 => Parameter::from_mc(value),
        _ => Parameter::from_modulus(value),
    }
}

/// u to sn, cn, dn and am, of one parameter given as m, mc or k from 0 on.
#[unsafe(no_mangle)]
pub extern "C" fn jacobi(given: u32, value: f64, rows: usize) {
    let jacobi = Jacobi::new(parameter(given, value));
    with_columns(|[u, sn, cn, dn, am, _]| {
        let results = [sn, cn, dn, am].map(|column| &mut column[..rows]);
        jacobi.values_into(&u[..rows], results);
    });
}

/// Parameters to K, E and the nome.
#[unsafe(no_mangle)]
pub extern "C" fn complete(given: u32, rows: usize) {
    with_columns(|[value, k, e, q, ..]| {
        for (((value, k), e), q) in value.iter().zip(k).zip(e).zip(q).take(rows) {
            let parameter = parameter(given, *value);
            (*k, *e, *q) = (complete_k(parameter), complete_e(parameter), nome(parameter));
        }
    });
}

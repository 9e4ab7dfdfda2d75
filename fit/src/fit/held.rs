//! Friction terms at their bound 0 or near it: what they do to the uncertainties of a minimum.
//!
//! Where noise has driven a term to 0, the true one may lie above it, and every value that depends on it is then off by its share. So
//! the Jacobian has the columns of these terms too, and the covariance is that of values with bounds (`one_sided`).

use super::data::Measured;
use super::ladder::{Rung, terms};
use super::one_sided::{Bounded, one_sided};
use super::problem::{
    DRY, LINEAR, Loss, PRESLIDING, PRESLIDING_HELD, Problem, QUADRATIC, Samples, Values, presliding,
};
use super::result::Estimate;
use nalgebra::{DMatrix, DVector};

/// The terms of a rung's model that are not free in it, but for presliding.
pub(super) fn held(rung: &Rung) -> Vec<usize> {
    let at_zero = |term: &usize| *term != PRESLIDING && !rung.free.contains(term);
    terms(rung.model).iter().copied().filter(at_zero).collect()
}

/// What presliding that is held would change: the residuals over the angle at which it begins to be free, less those of dry friction
/// alone. The motion changes with the root of the angle, of which the derivative at 0 is thus the difference quotient.
pub(super) fn by_presliding(samples: &Samples, measured: Measured, rung: &Rung) -> Option<DVector<f64>> {
    let found = &rung.outcome.values;
    // Without dry friction there is nothing that changes its sign.
    if !terms(rung.model).contains(&PRESLIDING) || rung.free.contains(&PRESLIDING) || found[DRY] <= 0.0 {
        return None;
    }
    let residuals = |ln_angle: f64| {
        let mut values: Values = *found;
        values[PRESLIDING] = ln_angle;
        let problem = Problem::new(samples, measured, &[], Loss::Squares, values);
        (!problem.plain().is_empty()).then(|| DVector::from_column_slice(problem.plain()))
    };
    Some(residuals(PRESLIDING_HELD)? - residuals(0.0)?)
}

/// The covariance of values that begin with those of `rung.free`; `step` leads from the minimum to that without bounds.
pub(super) fn with_bounds(
    covariance: &DMatrix<f64>,
    varied: &[usize],
    rung: &Rung,
    step: &DVector<f64>,
) -> DMatrix<f64> {
    let found = &rung.outcome.values;
    let mut unit = DVector::from_element(varied.len(), 1.0);
    let mut bounded = Vec::new();
    for (place, value) in varied.iter().enumerate().filter(|(_, value)| terms(rung.model).contains(value)) {
        let mut at = found[*value];
        if *value == PRESLIDING {
            // Its bound is that of the root of the angle.
            let angle = presliding(found);
            let free = rung.free.contains(&PRESLIDING);
            at = if free { angle.sqrt() } else { 0.0 };
            unit[place] = if free { 0.5 * libm::exp(found[PRESLIDING]) / at } else { 1.0 };
        }
        bounded.push(Bounded { place, found: at, unbounded: at + unit[place] * step[place] });
    }
    let units = &unit * unit.transpose();
    // The bound of linear friction moves with the others.
    let place = |term: usize| bounded.iter().find(|b| varied[b.place] == term).map(|b| b.place);
    let cone = place(LINEAR).zip(place(QUADRATIC)).zip(place(DRY)).map(|((l, q), d)| [l, q, d]);
    one_sided(&covariance.component_mul(&units), &bounded, cone).component_div(&units)
}

/// A step of the first `free` values, without the others: what their part of a step of all does to it is taken back.
pub(super) fn without_held(inverse: &DMatrix<f64>, step: &DVector<f64>, free: usize) -> DVector<f64> {
    let all = step.len();
    let mut alone = DVector::zeros(all);
    let held = all - free;
    if held == 0 {
        return step.clone();
    }
    let part = inverse.view((free, free), (held, held)).into_owned();
    let back = part.lu().solve(&step.rows(free, held)).unwrap_or_else(|| DVector::zeros(held));
    alone.rows_mut(0, free).copy_from(&(step.rows(0, free) - inverse.view((0, free), (free, held)) * back));
    alone
}

/// The angle of presliding that is held; `u` is that of its root, over the root at which it begins to be free.
pub(super) fn presliding_held(found: &Values, u: f64) -> Estimate {
    let mut begins = *found;
    begins[PRESLIDING] = PRESLIDING_HELD;
    Estimate::new(presliding(found), presliding(&begins) * u * u, 0.0, 0.0)
}

#[cfg(test)]
mod tests {
    use super::super::optimiser::Outcome;
    use super::super::options::Model;
    use super::*;

    #[test]
    fn linear_friction_is_measured_from_where_friction_would_drive() {
        // On the bound -sqrt(0.01 0.04), with the minimum without it 2 deviations beyond; the other terms are known.
        let mut values: Values = [0.0, 1.0, 9.0, -0.02, 0.01, 0.04, 0.0, 0.0, 1.0];
        let (varied, deviation) = ([LINEAR, QUADRATIC, DRY], 1e-3);
        let known = DVector::from_vec(vec![deviation * deviation, 1e-16, 1e-16]);
        let step = DVector::from_vec(vec![-2.0 * deviation, 0.0, 0.0]);
        let mean_square = |values: &Values| {
            let outcome = Outcome { values: *values, sum_of_squares: 0.0, residuals: Vec::new() };
            let rung = Rung {
                model: Model::Dry,
                outcome,
                free: varied.to_vec(),
                wanted_negative: vec![LINEAR],
                mean_square: 0.0,
                aicc: 0.0,
                bic: 0.0,
            };
            with_bounds(&DMatrix::from_diagonal(&known), &varied, &rung, &step)[(0, 0)] / known[0]
        };
        // 1 + 4 - 2 h with h = phi(2)/Q(2) = 2.373216.
        let wanted = 5.0 - 2.0 * 2.373_216;
        assert!((mean_square(&values) - wanted).abs() < 0.15 * wanted, "{}", mean_square(&values));
        // From 0 it would lie as far outside. It lies inside, where nothing is cut off.
        values[LINEAR] = -0.01;
        assert!((mean_square(&values) - 1.0).abs() < 1e-12, "{}", mean_square(&values));
    }
}

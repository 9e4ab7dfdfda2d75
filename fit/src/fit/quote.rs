//! The quoted quantity, g or a length, from omega0, with its budget.

use super::options::{FitOptions, Measure};
use super::result::{BudgetRow, Estimate};

/// g from a length, the length from g, and the budget of what is quoted.
pub(super) fn quoted(
    omega0: Estimate,
    options: &FitOptions,
) -> (Option<Estimate>, Option<Estimate>, Vec<BudgetRow>) {
    let row = |source: &str, u: f64| BudgetRow { source: source.to_string(), u };
    let relative = |part: f64| 2.0 * part / omega0.value;
    let omega2 = omega0.value * omega0.value;
    match (options.length, options.gravity) {
        (Some(Measure { value: length, u }), _) => {
            let g = omega2 * length;
            let of = |part: f64| g * relative(part);
            let by_length = g * u / length;
            let calibration = of(omega0.calibration).hypot(by_length);
            let estimate = Estimate::new(g, of(omega0.statistical), of(omega0.model), calibration);
            let budget = vec![
                row("fit", of(omega0.statistical)),
                row("model", of(omega0.model)),
                row("length", by_length),
                row("scale and clock", of(omega0.calibration)),
            ];
            (Some(estimate), Some(Estimate::new(length, 0.0, 0.0, u)), budget)
        }
        (None, Some(Measure { value: gravity, u })) => {
            let length = gravity / omega2;
            let of = |part: f64| length * relative(part);
            let by_gravity = length * u / gravity;
            let calibration = of(omega0.calibration).hypot(by_gravity);
            let estimate = Estimate::new(length, of(omega0.statistical), of(omega0.model), calibration);
            let budget = vec![
                row("fit", of(omega0.statistical)),
                row("model", of(omega0.model)),
                row("gravity", by_gravity),
                row("scale and clock", of(omega0.calibration)),
            ];
            (Some(Estimate::new(gravity, 0.0, 0.0, u)), Some(estimate), budget)
        }
        (None, None) => {
            let budget = vec![
                row("fit", omega0.statistical),
                row("model", omega0.model),
                row("scale and clock", omega0.calibration),
            ];
            (None, None, budget)
        }
    }
}

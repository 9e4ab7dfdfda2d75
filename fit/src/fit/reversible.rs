//! g from a reversible pendulum, with its budget.

use super::measure::Measure;
use super::refusal::FitRefusal;
use super::result::{BudgetRow, Estimate, Grade, Verdict};
use super::verdicts::GRAVITY_ON_EARTH;
use libration::compound::reversible_gravity;
use serde::Serialize;

/// g from periods about two pivots.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Reversible {
    /// In m/s^2.
    pub g: Estimate,
    /// What each of the four measurements makes of it.
    pub budget: Vec<BudgetRow>,
    /// Findings in words.
    pub verdicts: Vec<Verdict>,
}

/// Bessel's evaluation of Kater's pendulum: small-swing periods (in s) about two pivots and their distances (in m) from the centre of
/// mass.
///
/// # Errors
/// For a value that is not finite and positive, and where the measurements give no g.
///
/// ```
/// use libration_fit::fit::{Measure, reversible};
/// let measure = |value: f64, u: f64| Measure { value, u };
/// let found = reversible([measure(2.0061, 1e-4), measure(2.0063, 1e-4)], [measure(0.66, 1e-4), measure(0.3401, 1e-4)])?;
/// assert!((found.g.value - 9.81).abs() < 0.02, "{found:?}");
/// # Ok::<(), libration_fit::fit::FitRefusal>(())
/// ```
pub fn reversible(periods: [Measure; 2], distances: [Measure; 2]) -> Result<Reversible, FitRefusal> {
    let measures = [periods[0], periods[1], distances[0], distances[1]];
    let names = ["first period", "second period", "first distance", "second distance"];
    for (name, measure) in names.iter().zip(measures) {
        if !(measure.value.is_finite() && measure.value > 0.0 && measure.u.is_finite() && measure.u >= 0.0) {
            return Err(FitRefusal::new(format!(
                "{name} = {} with u = {}: must be finite and positive",
                measure.value, measure.u
            )));
        }
    }
    let of = |v: [f64; 4]| reversible_gravity(v[0], v[1], v[2], v[3]);
    let values = measures.map(|measure| measure.value);
    let g = of(values);
    if !(g.is_finite() && g > 0.0) {
        return Err(FitRefusal::new(format!(
            "distances {} and {} m with periods {} and {} s give no g: pivots at equal distances say nothing",
            values[2], values[3], values[0], values[1]
        )));
    }
    let mut budget = Vec::new();
    for (i, name) in names.iter().enumerate() {
        let shifted = |side: f64| {
            let mut values = values;
            values[i] += side * measures[i].u;
            of(values)
        };
        budget.push(BudgetRow { source: (*name).to_string(), u: 0.5 * (shifted(1.0) - shifted(-1.0)).abs() });
    }
    let part = |rows: &[BudgetRow]| rows.iter().map(|row| row.u * row.u).sum::<f64>().sqrt();
    let g = Estimate::new(g, part(&budget[..2]), 0.0, part(&budget[2..]));
    let (low, high) = GRAVITY_ON_EARTH;
    let mut verdicts = Vec::new();
    if g.value < low - 3.0 * g.u || g.value > high + 3.0 * g.u {
        verdicts.push(Verdict::new(
            Grade::Warning,
            format!(
                "g = {:.3} m/s^2 lies outside of {low} to {high} by more than its uncertainty: equal periods at equal distances, or a miscount",
                g.value
            ),
        ));
    }
    Ok(Reversible { g, budget, verdicts })
}

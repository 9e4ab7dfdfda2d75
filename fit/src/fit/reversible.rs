//! g from a reversible pendulum, with its budget.

use super::measure::Measure;
use super::refusal::FitRefusal;
use super::result::{BudgetRow, Estimate, Grade, Verdict};
use super::verdicts::GRAVITY_ON_EARTH;
use crate::digits::Shown;
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

impl Reversible {
    /// As JSON; what is not finite is null.
    #[must_use]
    pub fn json(&self) -> String {
        serde_json::to_string(self).unwrap_or_default()
    }
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
    let names = ["first period", "second period", "first distance", "second distance"];
    evaluated(names, [periods[0], periods[1], distances[0], distances[1]], |v| v)
}

/// The same from the distance between the pivots, which is measured well, and that of the first from the centre of mass, which need
/// not be: the less the periods differ, the less it counts.
///
/// # Errors
/// As for [`reversible`], and where the centre of mass does not lie between the pivots.
///
/// ```
/// use libration_fit::fit::{Measure, reversible_between};
/// let measure = |value: f64, u: f64| Measure { value, u };
/// let periods = [measure(2.0061, 1e-4), measure(2.0063, 1e-4)];
/// let found = reversible_between(periods, measure(1.0001, 1e-5), measure(0.66, 0.002))?;
/// assert!((found.g.value - 9.81).abs() < 0.02 && found.g.u < 0.002, "{found:?}");
/// # Ok::<(), libration_fit::fit::FitRefusal>(())
/// ```
pub fn reversible_between(
    periods: [Measure; 2],
    between: Measure,
    first: Measure,
) -> Result<Reversible, FitRefusal> {
    if first.value >= between.value {
        return Err(FitRefusal::new(format!(
            "first distance = {} m: must be less than the distance between the pivots, {} m: the centre of mass lies between them",
            Shown(first.value),
            Shown(between.value)
        )));
    }
    let names = ["first period", "second period", "first distance", "distance between"];
    evaluated(names, [periods[0], periods[1], first, between], |[t1, t2, first, between]| {
        [t1, t2, first, between - first]
    })
}

/// g of measures, of which `of` makes periods and distances from the centre of mass.
fn evaluated(
    names: [&str; 4],
    measures: [Measure; 4],
    of: impl Fn([f64; 4]) -> [f64; 4],
) -> Result<Reversible, FitRefusal> {
    for (name, measure) in names.iter().zip(measures) {
        if !(measure.value.is_finite() && measure.value > 0.0 && measure.u.is_finite() && measure.u >= 0.0) {
            return Err(FitRefusal::new(format!(
                "{name} = {} with u = {}: must be finite and positive",
                Shown(measure.value),
                Shown(measure.u)
            )));
        }
    }
    let of = |values: [f64; 4]| {
        let [t1, t2, d1, d2] = of(values);
        reversible_gravity(t1, t2, d1, d2)
    };
    let values = measures.map(|measure| measure.value);
    let g = of(values);
    if !(g.is_finite() && g > 0.0) {
        return Err(FitRefusal::new(format!(
            "distances {} and {} m with periods {} and {} s give no g: pivots at equal distances say nothing",
            Shown(values[2]),
            Shown(values[3]),
            Shown(values[0]),
            Shown(values[1])
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
                "g = {:.3} m/s^2 lies outside of {} to {} by more than its uncertainty: equal periods at equal distances, or a miscount",
                Shown(g.value),
                Shown(low),
                Shown(high)
            ),
        ));
    }
    Ok(Reversible { g, budget, verdicts })
}

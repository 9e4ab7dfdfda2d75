//! The quoted quantity, g or a length, from omega0, with its corrections and its budget.

use super::known::{CorrectionRow, length_of_parts, table};
use super::measure::Measure;
use super::options::FitOptions;
use super::refusal::FitRefusal;
use super::result::{BudgetRow, Estimate};

/// What is made of omega0.
#[derive(Clone, Debug, Default)]
pub(super) struct Quote {
    pub g: Option<Estimate>,
    pub length: Option<Estimate>,
    pub corrections: Vec<CorrectionRow>,
    pub budget: Vec<BudgetRow>,
}

/// The share of a correction that stays uncertain: its formulas and the air are known to a tenth.
pub(super) const DOUBT: f64 = 0.1;

/// The ideal pendulum's squared frequency over the measured one: it is faster by what each effect adds to the period. Each is
/// `times` what its formula says.
pub(super) fn ideal(corrections: &[CorrectionRow], times: impl Fn(usize) -> f64) -> f64 {
    let made = corrections.iter().enumerate().filter(|(_, row)| row.made);
    made.map(|(i, row)| (1.0 + times(i) * row.relative_period) * (1.0 + times(i) * row.relative_period))
        .product()
}

/// g from a length or from parts, the length from g, and the budget of what is quoted.
pub(super) fn quoted(omega0: Estimate, options: &FitOptions) -> Result<Quote, FitRefusal> {
    let length = match options.length {
        None if !options.parts.is_empty() => Some(length_of_parts(&options.parts)?),
        length => length,
    };
    let omega2 = omega0.value * omega0.value;
    let assumed = length.map_or(9.81 / omega2, |length| length.value);
    let corrections = table(&options.corrections, assumed, omega0.value);
    let factor = ideal(&corrections, |_| 1.0);
    let made = corrections.iter().filter(|row| row.made);
    let squares = made.fold(0.0, |sum, row| sum + row.relative_period * row.relative_period);
    let doubt = 2.0 * DOUBT * libm::sqrt(squares);
    let (name, known, value) = match (length, options.gravity) {
        (Some(length), _) => ("length", length, omega2 * factor * length.value),
        (None, Some(gravity)) => ("gravity", gravity, gravity.value / (omega2 * factor)),
        (None, None) => {
            let row = |source: &str, u: f64| BudgetRow { source: source.to_string(), u };
            let budget = vec![
                row("fit", omega0.statistical),
                row("model", omega0.model),
                row("scale and clock", omega0.calibration),
            ];
            return Ok(Quote { corrections, budget, ..Quote::default() });
        }
    };
    let of = |part: f64| value * 2.0 * part / omega0.value;
    let by_known = value * known.u / known.value;
    let by_corrections = value * doubt;
    let calibration = (of(omega0.calibration).powi(2) + by_known.powi(2) + by_corrections.powi(2)).sqrt();
    let found = Estimate::new(value, of(omega0.statistical), of(omega0.model), calibration);
    let given = |Measure { value, u }: Measure| Estimate::new(value, 0.0, 0.0, u);
    let mut budget: Vec<BudgetRow> = Vec::new();
    for (source, u) in [
        ("fit", found.statistical),
        ("model", found.model),
        (name, by_known),
        ("scale and clock", of(omega0.calibration)),
        ("corrections", by_corrections),
    ] {
        budget.push(BudgetRow { source: source.to_string(), u });
    }
    let (g, length) = if name == "length" { (found, given(known)) } else { (given(known), found) };
    Ok(Quote { g: Some(g), length: Some(length), corrections, budget })
}

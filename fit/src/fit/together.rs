//! Several records together: of one pendulum, or of one g with several lengths.
//!
//! Each record is fitted alone; what they share is then the generalised least squares of their results. To first order this is the
//! minimum of the sum of all squares, because every other value belongs to one record.

use super::data::Data;
use super::entry::fit;
use super::known::CorrectionRow;
use super::measure::Measure;
use super::monte_carlo::interval;
use super::options::FitOptions;
use super::quote::{Quote, quoted};
use super::refusal::FitRefusal;
use super::result::{BudgetRow, Estimate, Fit, Grade, Verdict};
use crate::digits::Shown;
use nalgebra::{DMatrix, DVector};
use serde::Serialize;

/// What several records share.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Together {
    /// In rad/s, where all records are of one pendulum.
    pub omega0: Option<Estimate>,
    /// In m/s^2.
    pub g: Option<Estimate>,
    /// In m, where g was given.
    pub length: Option<Estimate>,
    /// What must be added to every stated length, in m, where three or more lengths were given.
    pub length_offset: Option<Estimate>,
    /// Sum of squares of the deviations over their uncertainties, and its degrees of freedom.
    pub chi_squared: (f64, usize),
    /// Of g, or of the length, or of omega0.
    pub budget: Vec<BudgetRow>,
    /// What bob, wire and air do to the period, where all records are of one pendulum.
    pub corrections: Vec<CorrectionRow>,
    /// 95 % interval of the quoted quantity by Monte Carlo, where asked for.
    pub monte_carlo: Option<(f64, f64)>,
    /// Findings in words.
    pub verdicts: Vec<Verdict>,
    /// The records alone.
    pub fits: Vec<Fit>,
}

impl Together {
    /// As JSON; what is not finite is null.
    #[must_use]
    pub fn json(&self) -> String {
        serde_json::to_string(self).unwrap_or_default()
    }
}

/// Records of one pendulum: the shared omega0, and g or the length as the options say.
///
/// # Errors
/// As for [`fit`], with the number of the record.
pub fn fit_runs(runs: &[Data], options: &FitOptions) -> Result<Together, FitRefusal> {
    let fits = each(runs, |_| options.clone())?;
    let values: Vec<(f64, f64)> = fits
        .iter()
        .map(|fit| (fit.omega0.value, libm::hypot(fit.omega0.statistical, fit.omega0.model)))
        .collect();
    let design = DMatrix::from_element(values.len(), 1, 1.0);
    let Solution { found: mean, chi, .. } = solved(&design, &values)?;
    let calibration = fits.iter().map(|fit| fit.omega0.calibration).fold(0.0, f64::max);
    let freedom = values.len() - 1;
    let statistical = mean[0].1;
    let omega0 = Estimate::new(mean[0].0, statistical, statistical * excess(chi, freedom), calibration);
    let Quote { g, length, corrections, budget } = quoted(omega0, options)?;
    Ok(Together {
        omega0: Some(omega0),
        g,
        length,
        length_offset: None,
        budget,
        corrections,
        monte_carlo: interval(omega0, options),
        chi_squared: (chi, freedom),
        verdicts: consistent(chi, freedom, "omega0"),
        fits,
    })
}

/// Records at several lengths: 1/omega0^2 = (L + c)/g by least squares, c free where there are three lengths or more.
///
/// # Errors
/// As for [`fit`], with the number of the record; where the numbers of records and lengths differ.
pub fn fit_lengths(runs: &[Data], lengths: &[Measure], options: &FitOptions) -> Result<Together, FitRefusal> {
    if runs.len() != lengths.len() || runs.len() < 2 {
        return Err(FitRefusal::new(format!(
            "{} records with {} lengths: each record needs its length, and two are the least",
            runs.len(),
            lengths.len()
        )));
    }
    let alone = FitOptions { length: None, gravity: None, parts: Vec::new(), ..options.clone() };
    let fits = each(runs, |_| alone.clone())?;
    let free_offset = lengths.len() > 2;
    // Lengths stand on the right, with the uncertainty of both sides.
    let g0 = fits[0].omega0.value.powi(2) * lengths[0].value;
    let own: Vec<f64> = fits
        .iter()
        .map(|fit| g0 / fit.omega0.value.powi(2) * 2.0 * fit.omega0.u / fit.omega0.value)
        .collect();
    let values: Vec<(f64, f64)> =
        lengths.iter().zip(&own).map(|(length, own)| (length.value, libm::hypot(*own, length.u))).collect();
    let design = DMatrix::from_fn(fits.len(), 1 + usize::from(free_offset), |row, column| {
        if column == 0 { 1.0 / fits[row].omega0.value.powi(2) } else { -1.0 }
    });
    let Solution { found, chi, by_value } = solved(&design, &values)?;
    let freedom = values.len() - found.len();
    // The parts of the variance that the records and the lengths make.
    let part = |place: usize, us: &mut dyn Iterator<Item = f64>| {
        us.enumerate().map(|(row, u)| (by_value[(place, row)] * u).powi(2)).sum::<f64>().sqrt()
    };
    let estimate = |place: usize| {
        let by_records = part(place, &mut own.iter().copied());
        let by_lengths = part(place, &mut lengths.iter().map(|length| length.u));
        Estimate::new(found[place].0, by_records, found[place].1 * excess(chi, freedom), by_lengths)
    };
    let g = estimate(0);
    let mut verdicts = consistent(chi, freedom, "g");
    let offset = free_offset.then(|| estimate(1));
    if let Some(offset) = offset.filter(|offset| offset.value.abs() > 3.0 * offset.u) {
        verdicts.push(Verdict::new(
            Grade::Warning,
            format!(
                "every stated length is short by {:.4} m: it may end above the centre of the bob",
                Shown(offset.value)
            ),
        ));
    }
    if !free_offset && let Some((g, offset)) = apart(&fits, lengths).filter(|_| chi > 9.0) {
        verdicts.push(Verdict::new(
            Grade::Note,
            format!(
                "both lengths agree on g = {:.3} m/s^2 if each is short by {:.4} m: a third length would tell",
                Shown(g),
                Shown(offset)
            ),
        ));
    }
    let row = |source: &str, u: f64| BudgetRow { source: source.to_string(), u };
    Ok(Together {
        omega0: None,
        g: Some(g),
        length: None,
        length_offset: offset,
        budget: vec![row("fit", g.statistical), row("model", g.model), row("lengths", g.calibration)],
        corrections: Vec::new(),
        monte_carlo: None,
        chi_squared: (chi, freedom),
        verdicts,
        fits,
    })
}

/// g from the difference of two lengths, and what then is missing in both.
fn apart(fits: &[Fit], lengths: &[Measure]) -> Option<(f64, f64)> {
    let [first, second] = [0, 1].map(|i| 1.0 / fits[i].omega0.value.powi(2));
    let g = (lengths[1].value - lengths[0].value) / (second - first);
    (g.is_finite() && g > 0.0).then_some((g, g * first - lengths[0].value))
}

fn each(runs: &[Data], options: impl Fn(usize) -> FitOptions) -> Result<Vec<Fit>, FitRefusal> {
    if runs.is_empty() {
        return Err(FitRefusal::new("0 records: at least one is needed"));
    }
    let one = |(number, run): (usize, &Data)| {
        fit(run, &options(number))
            .map_err(|refusal| FitRefusal::new(format!("record {}: {refusal}", number + 1)))
    };
    runs.iter().enumerate().map(one).collect()
}

/// What least squares give.
struct Solution {
    /// With uncertainties.
    found: Vec<(f64, f64)>,
    /// Chi squared.
    chi: f64,
    /// The derivative of what was found, row by row, by each value.
    by_value: DMatrix<f64>,
}

/// The standard uncertainty that scatter beyond the stated ones adds, over that without: Birge's ratio squared, less 1.
fn excess(chi: f64, freedom: usize) -> f64 {
    (chi / freedom.max(1) as f64 - 1.0).max(0.0).sqrt()
}

/// Weighted least squares of a design to values with uncertainties.
fn solved(design: &DMatrix<f64>, values: &[(f64, f64)]) -> Result<Solution, FitRefusal> {
    let weight = |row: usize| 1.0 / values[row].1.max(1e-15 * values[row].0.abs());
    let matrix =
        DMatrix::from_fn(design.nrows(), design.ncols(), |row, column| design[(row, column)] * weight(row));
    let right = DVector::from_fn(values.len(), |row, _| values[row].0 * weight(row));
    let failed = || FitRefusal::new("the records do not determine what they share: are all lengths equal?");
    let inverse = matrix.tr_mul(&matrix).try_inverse().ok_or_else(failed)?;
    let found = &inverse * matrix.tr_mul(&right);
    let chi = (&matrix * &found - right).norm_squared();
    let weights = DVector::from_fn(values.len(), |row, _| weight(row));
    let by_value = &inverse * matrix.transpose() * DMatrix::from_diagonal(&weights);
    let found = (0..found.len()).map(|i| (found[i], inverse[(i, i)].sqrt())).collect();
    Ok(Solution { found, chi, by_value })
}

/// A word where the scatter is beyond the uncertainties: chi squared exceeds its mean by four deviations.
fn consistent(chi: f64, freedom: usize, what: &str) -> Vec<Verdict> {
    let freedom = freedom as f64;
    if freedom > 0.0 && chi > freedom + 4.0 * (2.0 * freedom).sqrt() {
        let sentence = format!(
            "the records do not agree on {what}: chi squared {:.1} for {} degrees of freedom",
            Shown(chi),
            Shown(freedom)
        );
        return vec![Verdict::new(Grade::Warning, sentence)];
    }
    Vec::new()
}

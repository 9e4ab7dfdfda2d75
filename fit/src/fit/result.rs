//! What a fit hands out; it serialises to JSON.

use super::known::CorrectionRow;
use super::options::Model;
use serde::{Serialize, Serializer};

/// A value with its standard uncertainty (k = 1) and the parts of it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Estimate {
    /// The value.
    pub value: f64,
    /// Combined standard uncertainty: the root of the sum of the squares of the parts.
    pub u: f64,
    /// Expanded uncertainty, k = 2: some 95 % coverage.
    pub expanded: f64,
    /// Of noise, robust to its correlation in time.
    pub statistical: f64,
    /// Of the choice of a model and of what the model leaves out.
    pub model: f64,
    /// Of length, scale of the angle and clock.
    pub calibration: f64,
}

impl Estimate {
    pub(crate) fn new(value: f64, statistical: f64, model: f64, calibration: f64) -> Estimate {
        let u = (statistical.powi(2) + model.powi(2) + calibration.powi(2)).sqrt();
        Estimate { value, u, expanded: 2.0 * u, statistical, model, calibration }
    }
}

/// The friction terms of the chosen model; none where the model has no such term. One that wanted to be negative is 0, with the
/// root mean square of what it may be above that.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct FrictionEstimates {
    /// gamma in 1/s.
    pub linear: Option<Estimate>,
    /// beta in 1/rad.
    pub quadratic: Option<Estimate>,
    /// mu in rad/s^2.
    pub dry: Option<Estimate>,
    /// The angle over which dry friction changes sign, in rad.
    pub presliding: Option<Estimate>,
}

/// One rung of the ladder.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RungSummary {
    /// The model.
    pub model: Model,
    /// Root mean square residual, in the unit of the record.
    pub rms: f64,
    /// Akaike's criterion with its correction, on the effective sample size.
    pub aicc: f64,
    /// Schwarz's criterion.
    pub bic: f64,
    /// omega0 in rad/s.
    pub omega0: f64,
    /// Friction terms that wanted to be negative and were held at 0.
    pub wanted_negative: Vec<&'static str>,
}

/// A row of the input that was not used.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Dropped {
    /// Its number in the input, from 0.
    pub row: usize,
    /// Why.
    pub reason: String,
}

/// How grave a verdict is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Grade {
    /// Worth knowing.
    Note,
    /// The result stands on weaker ground than its uncertainty says.
    Warning,
    /// The record is no swing of a pendulum, or not one that the models describe: quote nothing of it.
    Refuted,
}

/// A finding in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Verdict {
    /// How grave it is.
    pub grade: Grade,
    /// One sentence.
    pub sentence: String,
}

impl Verdict {
    pub(super) fn new(grade: Grade, sentence: impl Into<String>) -> Verdict {
        Verdict { grade, sentence: sentence.into() }
    }
}

impl Serialize for Verdict {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.sentence)
    }
}

/// One line of the budget of uncertainty.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BudgetRow {
    /// Where it comes from.
    pub source: String,
    /// What it makes of the quoted quantity, in its unit.
    pub u: f64,
}

/// The correlation of the free values.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Correlation {
    /// Their names.
    pub names: Vec<&'static str>,
    /// Row by row.
    pub rows: Vec<Vec<f64>>,
}

/// What the residuals say.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Diagnostics {
    /// Correlation of a residual with the next.
    pub lag1: f64,
    /// Durbin and Watson's ratio.
    pub durbin_watson: f64,
    /// Independent samples that hold as much.
    pub effective_size: f64,
    /// Of the Jacobian with columns of length 1.
    pub condition: f64,
    /// Correlation of the residual with the velocity: a fault of the clock.
    pub against_velocity: f64,
    /// Correlation with the angle: a fault of the scale.
    pub against_theta: f64,
    /// Correlation of the residual's size with the swing: a fault of the model.
    pub against_swing: f64,
    /// The scale of the angle that the record itself asks for, and its uncertainty.
    pub scale: f64,
    /// Uncertainty of the scale.
    pub scale_u: f64,
    /// rms with this scale.
    pub scale_rms: f64,
    /// rms of the linear equation with the same friction model.
    pub linear_equation_rms: f64,
    /// Samples in a period.
    pub samples_per_period: f64,
    /// Uncertainty of omega0 as if the residuals were independent: too small.
    pub omega0_u_naive: f64,
    /// Of omega0 by the block bootstrap, where asked for.
    pub omega0_u_bootstrap: Option<f64>,
    /// Scatter of omega0 between five windows, as that of their mean.
    pub omega0_u_windows: Option<f64>,
}

/// The samples that were fitted.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Residuals {
    /// Times as given.
    pub t: Vec<f64>,
    /// As given.
    pub measured: Vec<f64>,
    /// Measured less fitted.
    pub residual: Vec<f64>,
    /// Of periods: the turning angle of each by the fit, in rad. It is left out of the JSON, which holds what was measured.
    #[serde(skip)]
    pub swings: Vec<f64>,
}

/// A result.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Fit {
    /// The friction model.
    pub model: Model,
    /// Root mean square residual in the unit of the record: rad, rad/s or s.
    pub rms: f64,
    /// The same in degrees (deg, deg/s), for records.
    pub rms_deg: Option<f64>,
    /// In rad/s.
    pub omega0: Estimate,
    /// In m/s^2, where the length is known.
    pub g: Option<Estimate>,
    /// In m: as given, or from a given g.
    pub length: Option<Estimate>,
    /// Whether the length was given, so that g is the result.
    pub length_given: bool,
    /// Where the record rests, in rad.
    pub offset: Option<Estimate>,
    /// The same in degrees.
    pub offset_deg: Option<Estimate>,
    /// Measured angle over angle, where it was free.
    pub scale: Option<Estimate>,
    /// The friction terms.
    pub friction: FrictionEstimates,
    /// The largest turning angle fitted, in rad.
    pub swing: f64,
    /// Findings in words, the gravest first.
    pub verdicts: Vec<Verdict>,
    /// Rows that were not used.
    pub dropped: Vec<Dropped>,
    /// First and last time that were fitted, in s.
    pub window: (f64, f64),
    /// How the window was found.
    pub window_reason: String,
    /// Samples fitted.
    pub samples: usize,
    /// Every rung that was climbed.
    pub ladder: Vec<RungSummary>,
    /// Of the free values.
    pub correlation: Correlation,
    /// Of g, or of the length, or of omega0.
    pub budget: Vec<BudgetRow>,
    /// What bob, wire and air do to the period.
    pub corrections: Vec<CorrectionRow>,
    /// 95 % interval of the quoted quantity by Monte Carlo, where asked for.
    pub monte_carlo: Option<(f64, f64)>,
    /// What the residuals say.
    pub diagnostics: Diagnostics,
    /// The samples with their residuals.
    pub residuals: Residuals,
    /// Angle, velocity and time of the state that was fitted.
    pub state: (f64, f64, f64),
}

impl Fit {
    /// Whether no verdict forbids to quote the result.
    #[must_use]
    pub fn stands(&self) -> bool {
        self.verdicts.iter().all(|verdict| verdict.grade < Grade::Refuted)
    }
    /// As JSON; what is not finite is null.
    #[must_use]
    pub fn json(&self) -> String {
        serde_json::to_string(self).unwrap_or_default()
    }
}

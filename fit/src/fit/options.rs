//! What the user knows beside the record, and which model is asked for.

use super::known::{Corrections, MeasuredPart};
use super::measure::Measure;
use super::refusal::FitRefusal;
use crate::digits::Shown;
use serde::Serialize;

/// The rungs of the ladder: each adds one friction term to the one before.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Model {
    /// No friction.
    None,
    /// 2 gamma theta'.
    Linear,
    /// And beta |theta'| theta'.
    Quadratic,
    /// And mu sgn theta'.
    Dry,
    /// And the angle over which dry friction changes sign.
    Presliding,
}

impl Model {
    /// From none to all.
    pub const LADDER: [Model; 5] =
        [Model::None, Model::Linear, Model::Quadratic, Model::Dry, Model::Presliding];

    /// The name that is printed.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Model::None => "none",
            Model::Linear => "linear",
            Model::Quadratic => "quadratic",
            Model::Dry => "dry",
            Model::Presliding => "presliding",
        }
    }
}

/// Whether draws are compiled: a page asks for none.
pub(super) const DRAWS: bool = cfg!(feature = "draws");

/// A question to the caller, whether to give up; none for a caller who never does.
pub type Stop = Option<fn() -> bool>;

/// Told the name of each step when it begins; none for a caller who does not show them.
pub type Told = Option<fn(&'static str)>;

/// What is known beside the record. [`FitOptions::default`] knows nothing and climbs the ladder by itself.
#[derive(Clone, Debug, Default)]
pub struct FitOptions {
    /// The equivalent length in m: gives g.
    pub length: Option<Measure>,
    /// Parts of a rigid pendulum, which give the length.
    pub parts: Vec<MeasuredPart>,
    /// Bob, wire and air of a simple pendulum.
    pub corrections: Corrections,
    /// The local g in m/s^2: gives the length.
    pub gravity: Option<Measure>,
    /// The rung; none for the ladder's own choice.
    pub model: Option<Model>,
    /// The interval of time that is fitted, in s; none for from the release to the stop.
    pub window: Option<(f64, f64)>,
    /// Relative standard uncertainty of the scale of the angle.
    pub scale_u: f64,
    /// Relative standard uncertainty of the clock's rate.
    pub clock_u: f64,
    /// Whether the scale of the angle is free in the result, not in the diagnosis alone.
    pub free_scale: bool,
    /// Resamplings of the block bootstrap; 0 for none, as without the feature `draws`.
    pub bootstrap: usize,
    /// Draws of the Monte Carlo propagation; 0 for none, as without the feature `draws`.
    pub monte_carlo: usize,
    /// The first counter of its random numbers.
    pub seed: u64,
    /// Asked between evaluations: whether to give up.
    pub stop: Stop,
    /// Told at the begin of each of [`FitOptions::STEPS`].
    pub told: Told,
}

impl FitOptions {
    /// The steps of the fit of a record in time, in their order; a model that is asked for leaves out the others.
    pub const STEPS: [&'static str; 9] =
        ["start", "window", "none", "linear", "quadratic", "dry", "presliding", "all samples", "uncertainty"];

    pub(super) fn tell(&self, step: &'static str) {
        if let Some(told) = self.told {
            told(step);
        }
    }

    pub(super) fn check(&self) -> Result<(), FitRefusal> {
        if self.length.is_some() && self.gravity.is_some() {
            return Err(FitRefusal::new(
                "length and gravity are both given: the motion holds g/L alone, so one of them must be left to the fit",
            ));
        }
        if !self.parts.is_empty() && (self.length.is_some() || self.gravity.is_some()) {
            let other = if self.length.is_some() { "length" } else { "gravity" };
            return Err(FitRefusal::new(format!(
                "parts and {other} are both given: parts give the length, and the motion holds g/L alone"
            )));
        }
        let positive = |name: &str, measure: &Option<Measure>| match measure {
            Some(Measure { value, .. }) if !(value.is_finite() && *value > 0.0) => {
                Err(FitRefusal::new(format!("{name} = {}: must be finite and positive", Shown(*value))))
            }
            Some(Measure { u, .. }) if !(u.is_finite() && *u >= 0.0) => Err(FitRefusal::new(format!(
                "uncertainty of {name} = {}: must be finite and not negative",
                Shown(*u)
            ))),
            _ => Ok(()),
        };
        positive("length", &self.length)?;
        positive("gravity", &self.gravity)?;
        for (name, u) in [("scale_u", self.scale_u), ("clock_u", self.clock_u)] {
            if !(u.is_finite() && u >= 0.0) {
                return Err(FitRefusal::new(format!(
                    "{name} = {}: must be finite and not negative",
                    Shown(u)
                )));
            }
        }
        self.corrections.check(!self.parts.is_empty())?;
        if let Some((from, to)) = self.window
            && !(from.is_finite() && to.is_finite() && from < to)
        {
            return Err(FitRefusal::new(format!(
                "window = {} to {}: must be two rising finite times",
                Shown(from),
                Shown(to)
            )));
        }
        Ok(())
    }
}

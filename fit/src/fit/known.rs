//! What is known of the apparatus: parts of a rigid pendulum, bob and air of a simple one.

use super::measure::Measure;
use super::refusal::FitRefusal;
use crate::digits::Shown;
use libration::compound::{added_mass, bob_size, buoyancy, wire_mass};
use libration::{Compound, Part, Shape};
use serde::Serialize;

/// A part of a rigid pendulum with uncertainties.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredPart {
    /// Its shape, which says what its size is.
    pub shape: Shape,
    /// In kg.
    pub mass: Measure,
    /// Of its centre from the pivot, in m.
    pub distance: Measure,
    /// Length of a rod, radius of a ball or a disc, in m.
    pub size: Measure,
}

/// The equivalent length of a rigid pendulum, with the uncertainty that its parts give it.
///
/// # Errors
/// For a part out of its domain.
pub fn length_of_parts(parts: &[MeasuredPart]) -> Result<Measure, FitRefusal> {
    let plain: Vec<Part> = parts
        .iter()
        .map(|p| Part { shape: p.shape, mass: p.mass.value, distance: p.distance.value, size: p.size.value })
        .collect();
    let compound = Compound::new(&plain).map_err(|domain| FitRefusal::new(domain.to_string()))?;
    let by_parts = compound.length_by_parts();
    let variance = by_parts.iter().zip(parts).map(|(by, p)| {
        let us = [p.mass.u, p.distance.u, p.size.u];
        by.iter().zip(us).map(|(by, u)| by * by * u * u).sum::<f64>()
    });
    Ok(Measure { value: compound.length(), u: variance.sum::<f64>().sqrt() })
}

/// Bob, wire and air of a simple pendulum; a correction is made where what it needs is known and it is not switched off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corrections {
    /// Radius of the bob in m.
    pub radius: Option<f64>,
    /// Mass of the bob in kg.
    pub mass: Option<f64>,
    /// Mass of the wire in kg.
    pub wire: Option<f64>,
    /// Density of the air, or the water, in kg/m^3.
    pub density: f64,
    /// Its kinematic viscosity in m^2/s.
    pub viscosity: f64,
    /// Whether the bob's size is corrected.
    pub bob_size: bool,
    /// Whether the wire's mass is corrected.
    pub wire_mass: bool,
    /// Whether buoyancy is corrected.
    pub buoyancy: bool,
    /// Whether the mass of the air that moves along is corrected.
    pub added_mass: bool,
}

impl Default for Corrections {
    /// Nothing known of the bob; air at 20 degrees; every correction switched on.
    fn default() -> Corrections {
        Corrections {
            radius: None,
            mass: None,
            wire: None,
            density: 1.204,
            viscosity: 1.516e-5,
            bob_size: true,
            wire_mass: true,
            buoyancy: true,
            added_mass: true,
        }
    }
}

impl Corrections {
    /// What is known must be possible, and must not stand beside parts, which have size and mass themselves.
    pub(super) fn check(&self, parts: bool) -> Result<(), FitRefusal> {
        let given = [("bob radius", self.radius), ("bob mass", self.mass), ("wire mass", self.wire)];
        let all =
            given.into_iter().chain([("density", Some(self.density)), ("viscosity", Some(self.viscosity))]);
        for (name, value) in all.filter_map(|(name, value)| Some((name, value?))) {
            if !(value.is_finite() && value > 0.0) {
                return Err(FitRefusal::new(format!(
                    "{name} = {}: must be finite and positive",
                    Shown(value)
                )));
            }
        }
        if parts && given.iter().any(|(_, value)| value.is_some()) {
            return Err(FitRefusal::new(
                "parts and a bob are both given: parts have their size and mass themselves",
            ));
        }
        if self.wire.is_some() && self.mass.is_none() {
            return Err(FitRefusal::new("a wire mass is given without a bob mass: only their ratio counts"));
        }
        let bob = self.radius.zip(self.mass).map(|(radius, mass)| density(radius, mass));
        if let Some(bob) = bob.filter(|bob| *bob <= self.density) {
            return Err(FitRefusal::new(format!(
                "the bob has {:.4} kg/m^3 and the fluid {}: a bob that floats is no pendulum",
                Shown(bob),
                Shown(self.density)
            )));
        }
        Ok(())
    }
}

/// Of a ball, in kg/m^3.
fn density(radius: f64, mass: f64) -> f64 {
    mass / (4.0 / 3.0 * core::f64::consts::PI * radius * radius * radius)
}

/// One correction.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CorrectionRow {
    /// Its name.
    pub name: &'static str,
    /// Period with the effect over period without, less 1.
    pub relative_period: f64,
    /// Whether it was made.
    pub made: bool,
}

/// The table of corrections for a simple pendulum of this length and frequency.
pub(super) fn table(known: &Corrections, length: f64, omega0: f64) -> Vec<CorrectionRow> {
    let mut rows = Vec::new();
    let mut row = |name, relative_period: f64, made| rows.push(CorrectionRow { name, relative_period, made });
    if let Some(radius) = known.radius {
        row("bob size", bob_size(radius, length), known.bob_size);
    }
    if let (Some(wire), Some(mass)) = (known.wire, known.mass) {
        row("wire mass", wire_mass(wire, mass), known.wire_mass);
    }
    if let (Some(radius), Some(mass)) = (known.radius, known.mass) {
        let density = density(radius, mass);
        row("buoyancy", buoyancy(known.density, density), known.buoyancy);
        let added = added_mass(radius, known.density, density, known.viscosity, omega0);
        row("added mass", added, known.added_mass);
    }
    rows
}

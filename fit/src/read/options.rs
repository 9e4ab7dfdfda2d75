//! What the user states about a file: which column is what, in which unit, the rate of a file without times, the run.

use super::refusal::{Refusal, quoted};
use crate::digits::Shown;

/// What a column can be stated to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Instants.
    Time,
    /// Angles.
    Angle,
    /// Angular velocities.
    Velocity,
    /// Linear accelerations along the path, or angular accelerations where the unit says so.
    Acceleration,
    /// The horizontal coordinate.
    X,
    /// The vertical coordinate.
    Y,
    /// Periods.
    Period,
}

impl Role {
    /// The words that are written for a role.
    pub const NAMES: [(&'static str, Role); 7] = [
        ("time", Role::Time),
        ("angle", Role::Angle),
        ("velocity", Role::Velocity),
        ("acceleration", Role::Acceleration),
        ("x", Role::X),
        ("y", Role::Y),
        ("period", Role::Period),
    ];

    /// The word of a role.
    pub fn name(self) -> &'static str {
        Role::NAMES.iter().find(|(_, role)| *role == self).map_or("", |(name, _)| name)
    }
}

/// What is stated; the default states nothing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// Column names, or numbers from 1, with what they are.
    pub columns: Vec<(Role, String)>,
    /// Units of roles, in place of the header's.
    pub units: Vec<(Role, String)>,
    /// Samples in a second, for a file without times.
    pub rate: Option<f64>,
    /// The run to read, from 1.
    pub run: Option<usize>,
    /// The distance from pivot to tracked point in m, where the track is too short to tell.
    pub length: Option<f64>,
}

impl Options {
    /// Adds `ROLE=NAME`.
    pub fn column(mut self, text: &str) -> Result<Options, Refusal> {
        self.columns.push(stated(text, "--column", "NAME")?);
        Ok(self)
    }

    /// Adds `ROLE=UNIT`.
    pub fn unit(mut self, text: &str) -> Result<Options, Refusal> {
        self.units.push(stated(text, "--unit", "UNIT")?);
        Ok(self)
    }

    pub(super) fn stated_column(&self, role: Role) -> Option<&str> {
        self.columns.iter().rev().find(|each| each.0 == role).map(|each| each.1.as_str())
    }

    pub(super) fn stated_unit(&self, role: Role) -> Option<&str> {
        self.units.iter().rev().find(|each| each.0 == role).map(|each| each.1.as_str())
    }

    /// The options, where they can hold for any file.
    pub(super) fn checked(&self) -> Result<&Options, Refusal> {
        let positive = |value: Option<f64>| value.is_none_or(|value| value.is_finite() && value > 0.0);
        if !positive(self.rate) {
            let rate = self.rate.unwrap_or_default();
            return Err(Refusal::fault(
                None,
                format!("--rate = {}: must be finite and greater than 0", Shown(rate)),
            ));
        }
        if !positive(self.length) {
            let length = self.length.unwrap_or_default();
            return Err(Refusal::fault(
                None,
                format!("--length = {}: must be finite and greater than 0", Shown(length)),
            ));
        }
        if self.run == Some(0) {
            return Err(Refusal::fault(None, "--run = 0: must be 1 or greater"));
        }
        Ok(self)
    }
}

fn stated(text: &str, option: &str, value: &str) -> Result<(Role, String), Refusal> {
    let roles: Vec<&str> = Role::NAMES.iter().map(|(name, _)| *name).collect();
    let reason = || {
        let allowed = roles.join(", ");
        Refusal::fault(
            None,
            format!("{option} = {}: must be ROLE={value}, where ROLE is one of {allowed}", quoted(text)),
        )
    };
    let (role, name) = text.split_once('=').ok_or_else(reason)?;
    let role = Role::NAMES.iter().find(|(each, _)| *each == role.trim()).ok_or_else(reason)?.1;
    if name.trim().is_empty() {
        return Err(reason());
    }
    Ok((role, name.trim().to_owned()))
}

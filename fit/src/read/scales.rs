//! Values in SI units: by the unit stated, the header's, or the size; angles unwrapped, with rest near zero.

use super::angle;
use super::axes::acceleration_unit;
use super::groups::Group;
use super::names::{Meaning, words};
use super::options::{Options, Role};
use super::profile::Profile;
use super::record::{Kind, Quantity, Record};
use super::refusal::{Refusal, plain, quoted};
use super::select::Selection;
use super::stamps;
use super::table::Table;
use super::units::{Dimension, Unit, counts_per_turn, unit};

/// Angles in rad with rest near zero, and the factor that was used.
pub(super) fn angles(
    table: &Table<'_>,
    column: usize,
    mut values: Vec<f64>,
    options: &Options,
    record: &mut Record,
) -> Result<(Vec<f64>, f64), Refusal> {
    let head = &table.heads[column];
    let stated = match options.stated_unit(Role::Angle) {
        Some(text) => Some(stated_unit(text, Role::Angle, &[Dimension::Angle], "rad, deg, turn or N/turn")?),
        None => head.unit.filter(|unit| unit.dimension == Dimension::Angle),
    };
    let factor = match stated {
        Some(unit) => unit.factor,
        None => {
            if let Some(text) = &head.unknown_unit {
                record.understood.push(format!(
                    "The unit {} of column {} is not known.",
                    quoted(text),
                    quoted(&head.written)
                ));
            }
            let (factor, guess) = angle::factor_by_size(&head.written, &values)?;
            record.understood.push(guess);
            factor
        }
    };
    values.iter_mut().for_each(|value| *value *= factor);
    if record.kind == Kind::Swings {
        return Ok((values, factor));
    }
    let jumps = angle::unwrap(&mut values);
    if jumps > 0 {
        record.understood.push(format!("The angle is wrapped: {jumps} jumps of a turn are undone."));
    }
    record.rest = angle::rest(&values);
    let shift = angle::right_angles(&values, record.rest);
    if shift != 0.0 {
        let degrees = (shift / angle::DEGREE).round();
        record.understood.push(format!("Rest at {degrees} deg: subtracted."));
        values.iter_mut().for_each(|value| *value -= shift);
        record.rest = record.rest.map(|rest| rest - shift);
    }
    if let Some(rest) = record.rest.filter(|rest| rest.abs() > 5.0 * angle::DEGREE) {
        record.understood.push(format!(
            "Rest at {:.1} deg: the zero of the angle is elsewhere, so fit an offset.",
            rest / angle::DEGREE
        ));
    }
    Ok((values, factor))
}

/// Another quantity in SI units, and the factor that was used.
pub(super) fn scaled(
    table: &Table<'_>,
    column: usize,
    quantity: Quantity,
    mut values: Vec<f64>,
    selection: &Selection,
    options: &Options,
    record: &mut Record,
) -> Result<(Vec<f64>, f64), Refusal> {
    let head = &table.heads[column];
    let (role, dimensions, allowed): (Role, &[Dimension], &str) = match quantity {
        Quantity::Velocity => (Role::Velocity, &[Dimension::AngularVelocity], "rad/s, deg/s or rpm"),
        Quantity::AngleUnscaled => {
            (Role::Angle, &[Dimension::Arbitrary, Dimension::Length], "rad, deg, turn or N/turn")
        }
        _ => (
            Role::Acceleration,
            &[Dimension::LinearAcceleration, Dimension::AngularAcceleration],
            "m/s^2, g, mg or rad/s^2",
        ),
    };
    let known = match options.stated_unit(role) {
        Some(text) => Some(stated_unit(text, role, dimensions, allowed)?),
        None => head.unit.filter(|unit| dimensions.contains(&unit.dimension)),
    };
    let name = quoted(&head.written);
    let factor = match (known, quantity) {
        (Some(unit), _) => unit.factor,
        (None, Quantity::Velocity) => {
            let fastest = values.iter().map(|value| value.abs()).fold(0.0, f64::max);
            let degrees = fastest > 35.0;
            let (unit, size) = if degrees { ("deg/s", "above") } else { ("rad/s", "below") };
            let than = stamps::short(fastest);
            record
                .understood
                .push(format!("Column {name} has no unit: taken as {unit} by its size ({than}, {size} 35)."));
            if degrees { angle::DEGREE } else { 1.0 }
        }
        (None, Quantity::LinearAcceleration) => {
            let (factor, unit) = acceleration_unit(selection.radial.as_ref());
            record.understood.push(format!("Column {name} has no unit: taken as {unit}."));
            factor
        }
        (None, _) => 1.0,
    };
    if quantity == Quantity::AngleUnscaled {
        record
            .understood
            .push(format!("Column {name} is in a unit of its own: only the period can be used."));
    }
    values.iter_mut().for_each(|value| *value *= factor);
    Ok((values, factor))
}

fn stated_unit(text: &str, role: Role, dimensions: &[Dimension], allowed: &str) -> Result<Unit, Refusal> {
    let found = unit(text).or_else(|| counts_per_turn(text).filter(|_| role == Role::Angle));
    found.filter(|unit| dimensions.contains(&unit.dimension)).ok_or_else(|| {
        Refusal::fault(None, format!("--unit {}={}: must be {allowed}", role.name(), plain(text)))
    })
}

/// A constant column of uncertainties that names the column of the values.
pub(super) fn uncertainty(
    table: &Table<'_>,
    group: &Group,
    column: usize,
    profiles: &[Profile],
) -> Option<f64> {
    let name = words(&table.heads[column].name);
    let belongs = |k: &usize| {
        let other = words(&table.heads[*k].name);
        table.heads[*k].meaning == Some(Meaning::Uncertainty)
            && !name.is_empty()
            && (other == format!("d{name}") || other.split(' ').any(|word| word == name))
    };
    let found = group.columns.iter().copied().find(belongs)?;
    profiles[found].constant().then_some(profiles[found].most).filter(|value| *value > 0.0)
}

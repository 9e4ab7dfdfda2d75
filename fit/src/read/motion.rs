//! From a table to the record of one run: its rows, its instants, its series in SI units.

use super::angle;
use super::axes::acceleration_unit;
use super::clock;
use super::gate;
use super::groups::{Group, groups};
use super::names::{Meaning, words};
use super::options::{Options, Role};
use super::profile::Profile;
use super::record::{Kind, Quantity, Record, Series, leave_out};
use super::refusal::{Refusal, plain, quoted};
use super::select::{self, Chosen, Selection};
use super::stamps::{self, Stamps};
use super::table::Table;
use super::track;
use super::units::{Dimension, Unit, counts_per_turn, unit};
use super::vectors;

/// One run that the table holds.
struct Run {
    group: Group,
    selection: Selection,
    stamps: Vec<(usize, f64)>,
    /// Whether its motion is more than a last digit that flickers.
    moves: f64,
}

/// The record in a text.
pub(super) fn record(text: &str, options: &Options) -> Result<Record, Refusal> {
    let mut table = Table::of(text)?;
    if !options.times_only {
        select::refuse_computed(&table.heads)?;
        vectors::name(&mut table);
    }
    let mut record = Record {
        kind: Kind::Samples,
        time: Vec::new(),
        series: Vec::new(),
        breaks: Vec::new(),
        rest: None,
        pivot: None,
        run: (1, 1),
        understood: core::mem::take(&mut table.understood),
        dropped: core::mem::take(&mut table.dropped),
    };
    if gate::events(&table, options, &mut record)? {
        return Ok(record);
    }
    let profiles = select::profiles(&table);
    let mut runs: Vec<Run> = Vec::new();
    let mut refused: Option<Refusal> = None;
    for group in groups(&table.heads) {
        match select::select(&table, &profiles, &group, options) {
            Ok(selection) => runs_of(&table, group, selection, options, &profiles, &mut runs, &mut record)?,
            Err(refusal) => refused = refused.or(Some(refusal)),
        }
    }
    let (run, count) = match (chosen_run(&runs, options, table.vernier)?, refused) {
        (Some(run), _) => (run, runs.len()),
        (None, Some(refusal)) => return Err(refusal),
        (None, None) => {
            let line = table.lines.first().map(|line| *line as usize);
            return Err(Refusal::fault(line, "no row has both a time and a value"));
        }
    };
    let run_taken = runs.swap_remove(run);
    record.run = (run + 1, count);
    if count > 1 {
        let name = if run_taken.group.name.is_empty() {
            String::new()
        } else {
            format!(" ({})", plain(&run_taken.group.name))
        };
        let (what, rows) = (if table.vernier { "data sets" } else { "runs" }, run_taken.stamps.len());
        record.understood.push(format!(
            "{count} {what} in the file: {}{name} read, {rows} rows; --run N chooses.",
            run + 1
        ));
    }
    record.understood.extend(run_taken.selection.understood.iter().cloned());
    finish(&table, run_taken, &profiles, options, &mut record)?;
    Ok(record)
}

/// The columns whose values a row must have.
fn needed(chosen: &Chosen) -> Vec<usize> {
    match *chosen {
        Chosen::One(_, column) | Chosen::Gate(column, _) => vec![column],
        Chosen::Track(x, y) | Chosen::Swings(x, y) => vec![x, y],
        Chosen::Nothing => Vec::new(),
    }
}

/// The rows of a group, cut into recordings.
fn runs_of(
    table: &Table<'_>,
    group: Group,
    selection: Selection,
    options: &Options,
    profiles: &[Profile],
    runs: &mut Vec<Run>,
    record: &mut Record,
) -> Result<(), Refusal> {
    let needed = needed(&selection.chosen);
    let rate =
        options.rate.filter(|_| selection.time.is_none()).or(table.rate.filter(|_| selection.time.is_none()));
    let swings = matches!(selection.chosen, Chosen::Swings(..));
    if selection.time.is_none() && rate.is_none() && !swings {
        let free: Vec<String> =
            (group.columns.iter().filter(|k| !needed.contains(k) && profiles[**k].count > 0))
                .map(|k| table.heads[*k].written.clone())
                .collect();
        let answer = "--rate HZ for evenly spaced samples, or --column time=NAME";
        let question = if free.is_empty() {
            "no column of times: how many samples in a second?"
        } else {
            "which column is the time?"
        };
        return Err(Refusal::question(question, free, answer));
    }
    if let Some(column) = selection.time {
        let line = table.lines.get(1).map_or(1, |line| *line as usize);
        stamps::refuse_backwards(&table.heads[column].written, &profiles[column], line)?;
    }
    let index = group
        .columns
        .iter()
        .copied()
        .find(|k| table.heads[*k].meaning == Some(Meaning::Index) && profiles[*k].counter());
    let mut stamps: Vec<(usize, f64)> = Vec::new();
    let shared = group.name.is_empty();
    for row in 0..table.lines.len() {
        let time = match (selection.time, rate) {
            (Some(column), _) => table.columns[column][row],
            (None, Some(rate)) => {
                index.map_or(row as f64, |k| table.columns[k][row] - profiles[k].least) / rate
            }
            (None, None) => row as f64,
        };
        let missing = needed.iter().copied().find(|k| !table.columns[*k][row].is_finite());
        if time.is_finite() && missing.is_none() {
            stamps.push((row, time));
            continue;
        }
        // The rows of a longer run beside this one have nothing here.
        let blank = !time.is_finite() && needed.iter().all(|k| !table.columns[*k][row].is_finite());
        if blank && !shared {
            continue;
        }
        let column = if time.is_finite() { missing } else { selection.time };
        let reason = column.map_or("no time".to_owned(), |column| {
            let (cell, name) = (table.written(row, column), quoted(&table.heads[column].written));
            if super::numbers::is_missing(&cell) {
                format!("no value in column {name}")
            } else {
                format!("no number in column {name}")
            }
        });
        leave_out(&mut record.dropped, &reason, table.lines[row] as usize);
    }
    if swings || selection.time.is_none() {
        if !stamps.is_empty() {
            runs.push(Run { group, selection, stamps, moves: 1.0 });
        }
        return Ok(());
    }
    let recordings = clock::recordings(&stamps, &table.restarts);
    stamps::tell(&recordings, table, record);
    for stamps in recordings.runs {
        let moves = needed.first().map_or(1.0, |column| {
            let profile = Profile::of(stamps.iter().map(|stamp| table.columns[*column][stamp.0]));
            profile.range() / profile.most.abs().max(profile.least.abs()).max(f64::MIN_POSITIVE)
        });
        runs.push(Run { group: group.clone(), selection: selection.clone(), stamps, moves });
    }
    Ok(())
}

/// The run asked for, or the longest one that moves; the first data set of a Vernier file.
fn chosen_run(runs: &[Run], options: &Options, vernier: bool) -> Result<Option<usize>, Refusal> {
    if let Some(run) = options.run {
        if run > runs.len() {
            let has = if runs.len() == 1 { "one run".into() } else { format!("{} runs", runs.len()) };
            return Err(Refusal::fault(None, format!("--run = {run}: the file has {has}")));
        }
        return Ok(Some(run - 1));
    }
    if vernier && !runs.is_empty() {
        return Ok(Some(0));
    }
    let moving = runs.iter().map(|run| run.moves).fold(0.0, f64::max);
    let still = |run: &Run| run.moves < 0.05 * moving;
    // Of equally long ones the first: the search goes backwards, and the last of equals wins.
    let longest = (0..runs.len()).rev().filter(|k| !still(&runs[*k])).max_by_key(|k| runs[*k].stamps.len());
    Ok(longest)
}

/// Instants and series of the chosen run.
fn finish(
    table: &Table<'_>,
    run: Run,
    profiles: &[Profile],
    options: &Options,
    record: &mut Record,
) -> Result<(), Refusal> {
    let Run { group, selection, stamps, .. } = run;
    let least = if options.times_only { 1 } else { 3 };
    if stamps.len() < least {
        let line = stamps.first().map(|stamp| table.lines[stamp.0] as usize);
        let rows = if stamps.len() == 1 { "row has" } else { "rows have" };
        let reason = format!("only {} {rows} a time and a value; at least {least} are needed", stamps.len());
        return Err(Refusal::fault(line, reason));
    }
    let stamps = match selection.time {
        Some(column) => {
            let (factor, guess) = stamps::factor(&table.heads[column], &profiles[column], options)?;
            record.understood.extend(guess);
            stamps::in_order(stamps, Some(column), factor, table, record)
        }
        None => {
            if let Some(rate) = table.rate.filter(|_| options.rate.is_none()) {
                record.understood.push(format!(
                    "No column of times: {rate} samples in a second, as a line above the rows says."
                ));
            }
            let (rows, time) = stamps.into_iter().unzip();
            Stamps { rows, time, breaks: Vec::new() }
        }
    };
    let values =
        |column: usize| -> Vec<f64> { stamps.rows.iter().map(|row| table.columns[column][*row]).collect() };
    let lines: Vec<usize> = stamps.rows.iter().map(|row| table.lines[*row] as usize).collect();
    record.time = stamps.time;
    record.breaks = stamps.breaks;
    tell_columns(table, &selection, record);
    match selection.chosen {
        Chosen::Nothing => {}
        Chosen::Swings(angle, period) => {
            record.kind = Kind::Swings;
            record.time = Vec::new();
            let (theta0, _) = angles(table, angle, values(angle), options, record)?;
            let series = |quantity, column: usize, values| Series {
                quantity,
                name: table.heads[column].written.clone(),
                values,
                uncertainty: None,
            };
            let factor = table.heads[period]
                .unit
                .filter(|unit| unit.dimension == Dimension::Time)
                .map_or(1.0, |unit| unit.factor);
            let periods = values(period).into_iter().map(|period| period * factor).collect();
            record.series =
                vec![series(Quantity::Theta0, angle, theta0), series(Quantity::Period, period, periods)];
            record
                .understood
                .push("A table of periods against angles of release, not a record in time.".into());
            return Ok(());
        }
        Chosen::Gate(period, transit) => {
            record.kind = Kind::Gate;
            let series = |quantity, column: usize| {
                let factor = table.heads[column]
                    .unit
                    .filter(|unit| unit.dimension == Dimension::Time)
                    .map_or(1.0, |unit| unit.factor);
                let values = values(column).into_iter().map(|value| value * factor).collect();
                Series { quantity, name: table.heads[column].written.clone(), values, uncertainty: None }
            };
            record.series = vec![series(Quantity::Period, period)];
            record.series.extend(transit.map(|column| series(Quantity::Transit, column)));
            record.understood.push("A table of a light gate: periods, not samples.".into());
            gate::without_miscounts(record, &lines);
            return Ok(());
        }
        Chosen::Track(x, y) => {
            let (xs, ys) = (values(x), values(y));
            let length_unit =
                |column: usize| table.heads[column].unit.filter(|unit| unit.dimension == Dimension::Length);
            let factor = length_unit(x).map_or(1.0, |unit| unit.factor);
            let scale =
                |values: Vec<f64>| -> Vec<f64> { values.into_iter().map(|value| value * factor).collect() };
            let (xs, ys) = (scale(xs), scale(ys));
            let swing = track::swing(&xs, &ys, options.length, length_unit(x).is_some())?;
            record.understood.extend(swing.understood);
            record.pivot = Some(swing.pivot);
            let name = format!("{}, {}", table.heads[x].written, table.heads[y].written);
            record.rest = angle::rest(&swing.angles);
            let series = |quantity, column: usize, values| Series {
                quantity,
                name: table.heads[column].written.clone(),
                values,
                uncertainty: None,
            };
            let angle = Series { quantity: Quantity::Angle, name, values: swing.angles, uncertainty: None };
            record.series = vec![angle, series(Quantity::X, x, xs), series(Quantity::Y, y, ys)];
        }
        Chosen::One(quantity, column) => {
            let (found, factor) = match quantity {
                Quantity::Angle => angles(table, column, values(column), options, record)?,
                _ => scaled(table, column, quantity, values(column), &selection, options, record)?,
            };
            let uncertainty = uncertainty(table, &group, column, profiles).map(|value| value * factor);
            if let Some(value) = uncertainty {
                record.understood.push(format!("The file states a standard uncertainty of {}, in the unit of the column, for every value.", stamps::short(value / factor)));
            }
            let profile = Profile::of(found.iter().copied());
            if profile.constant() {
                let reason = format!(
                    "column {} does not move: it is {} in all rows",
                    quoted(&table.heads[column].written),
                    stamps::short(profile.most / factor)
                );
                return Err(Refusal::fault(lines.first().copied(), reason));
            }
            let name = table.heads[column].written.clone();
            record.series = vec![Series { quantity, name, values: found, uncertainty }];
        }
    }
    if !options.times_only {
        record.understood.extend(stamps::sampling(&record.time));
    }
    Ok(())
}

/// Says which columns were taken.
fn tell_columns(table: &Table<'_>, selection: &Selection, record: &mut Record) {
    let name = |k: usize| quoted(&table.heads[k].written);
    let values = match selection.chosen {
        Chosen::One(quantity, column) => Some((quantity.words(), name(column))),
        Chosen::Track(x, y) => Some(("the position", format!("{}, {}", name(x), name(y)))),
        Chosen::Gate(period, _) => Some(("the period", name(period))),
        Chosen::Swings(angle, period) => {
            Some(("the angle of release and the period", format!("{}, {}", name(angle), name(period))))
        }
        Chosen::Nothing => None,
    };
    let time = selection.time.map(|column| format!("the time: {}", name(column)));
    let values = values.map(|(what, columns)| format!("{what}: {columns}"));
    let said: Vec<String> = time.into_iter().chain(values).collect();
    if !said.is_empty() {
        record.understood.push(format!("Columns read, {}.", said.join("; ")));
    }
}

/// Angles in rad with rest near zero, and the factor that was used.
fn angles(
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
fn scaled(
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
fn uncertainty(table: &Table<'_>, group: &Group, column: usize, profiles: &[Profile]) -> Option<f64> {
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

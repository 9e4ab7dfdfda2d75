//! From a table to the record of one run: its instants and its series.

use super::angle;
use super::columns;
use super::gate;
use super::groups::groups;
use super::options::Options;
use super::profile::Profile;
use super::record::{Kind, Quantity, Record, Series};
use super::refusal::{Refusal, plain, quoted};
use super::runs::{Run, chosen, runs_of};
use super::scales::{angles, scaled, uncertainty};
use super::select::{Chosen, Selection, select};
use super::stamps::{self, Stamps};
use super::table::Table;
use super::track;
use super::units::Dimension;
use super::vectors;

/// Fewer rows are no record.
const LEAST: usize = 3;

/// The record in a text.
pub(super) fn record(text: &str, options: &Options) -> Result<Record, Refusal> {
    let mut table = Table::of(text)?;
    columns::refuse_computed(&table.heads)?;
    vectors::name(&mut table);
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
    let profiles = columns::profiles(&table);
    columns::settle(&mut table.heads, &profiles);
    let mut runs: Vec<Run> = Vec::new();
    let mut refused: Option<Refusal> = None;
    for group in groups(&table.heads) {
        let selected = select(&table, &profiles, &group, options);
        let taken =
            selected.and_then(|selection| runs_of(&table, group, selection, options, &profiles, &mut runs));
        refused = refused.or(taken.err());
    }
    let (run, count) = match (chosen(&runs, options, table.vernier)?, refused) {
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
    record.understood.extend(run_taken.notes.0.iter().chain(&run_taken.selection.understood).cloned());
    record.dropped.extend(run_taken.notes.1.iter().cloned());
    finish(&table, run_taken, &profiles, options, &mut record)?;
    Ok(record)
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
    if stamps.len() < LEAST {
        let line = stamps.first().map(|stamp| table.lines[stamp.0] as usize);
        let rows = if stamps.len() == 1 { "row has" } else { "rows have" };
        let reason = format!("only {} {rows} a time and a value; at least {LEAST} are needed", stamps.len());
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
            if selection.time.is_none() {
                record.time = gate::sums(&record.series[0].values);
                record
                    .understood
                    .push("No column of times: each period begins where the one above ends.".into());
            }
            record.understood.push("A table of a light gate: periods, not samples.".into());
            gate::without_miscounts(record, &lines);
            return Ok(());
        }
        Chosen::Passages(count) => {
            record.kind = Kind::Gate;
            record.series = vec![gate::counted_periods(&record.time, &table.heads[count])];
            record.understood.push(gate::TWICE.into());
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
    record.understood.extend(stamps::sampling(&record.time));
    Ok(())
}

/// Says which columns were taken.
fn tell_columns(table: &Table<'_>, selection: &Selection, record: &mut Record) {
    let name = |k: usize| quoted(&table.heads[k].written);
    let values = match selection.chosen {
        Chosen::One(quantity, column) => Some((quantity.words(), name(column))),
        Chosen::Track(x, y) => Some(("the position", format!("{}, {}", name(x), name(y)))),
        Chosen::Passages(count) => Some(("the count of the passages of a gate", name(count))),
        Chosen::Gate(period, None) => Some(("the period", name(period))),
        Chosen::Gate(period, Some(transit)) => Some((
            "the period and how long a passage is dark",
            format!("{}, {}", name(period), name(transit)),
        )),
        Chosen::Swings(angle, period) => {
            Some(("the angle of release and the period", format!("{}, {}", name(angle), name(period))))
        }
    };
    let time = selection.time.map(|column| format!("the time: {}", name(column)));
    let values = values.map(|(what, columns)| format!("{what}: {columns}"));
    let said: Vec<String> = time.into_iter().chain(values).collect();
    if !said.is_empty() {
        record.understood.push(format!("Columns read, {}.", said.join("; ")));
    }
}

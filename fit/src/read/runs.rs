//! The runs in a table: the rows of a group that have a time and a value, cut where a recording begins again, and the
//! choice of one.

use std::rc::Rc;

use super::clock;
use super::groups::Group;
use super::names::Meaning;
use super::numbers;
use super::options::Options;
use super::profile::Profile;
use super::record::{Dropped, leave_out};
use super::refusal::{Refusal, quoted};
use super::select::{Chosen, Selection};
use super::stamps;
use super::table::Table;

/// One run that the table holds.
pub(super) struct Run {
    pub group: Rc<Group>,
    pub selection: Rc<Selection>,
    pub stamps: Vec<(usize, f64)>,
    /// Whether its motion is more than a last digit that flickers.
    pub moves: f64,
    /// What was guessed and left out in its columns.
    pub notes: Rc<(Vec<String>, Vec<Dropped>)>,
}

/// The columns whose values a row must have.
fn needed(chosen: &Chosen) -> Vec<usize> {
    match *chosen {
        Chosen::One(_, column) | Chosen::Gate(column, _) | Chosen::Passages(column) => vec![column],
        Chosen::Track(x, y) | Chosen::Swings(x, y) => vec![x, y],
    }
}

/// The rows of a group, cut into recordings.
pub(super) fn runs_of(
    table: &Table<'_>,
    group: Group,
    selection: Selection,
    options: &Options,
    profiles: &[Profile],
    runs: &mut Vec<Run>,
) -> Result<(), Refusal> {
    let needed = needed(&selection.chosen);
    let (group, selection) = (Rc::new(group), Rc::new(selection));
    let rate = if selection.time.is_none() { options.rate.or(table.rate) } else { None };
    let (mut understood, mut dropped) = (Vec::new(), Vec::new());
    // Tables of periods need no times.
    let swings = matches!(selection.chosen, Chosen::Swings(..))
        || matches!(selection.chosen, Chosen::Gate(..)) && selection.time.is_none();
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
    let rows = table.lines.len();
    let by_line = rate.is_some() && index.is_none();
    let spacing = if by_line { table.spacing() } else { 1 };
    let missing = table.sample(rows - 1, spacing) + 1 - rows;
    if missing > 0 && by_line {
        understood.push(format!("Lines without a number are samples that are missing: {missing}."));
    }
    for row in 0..rows {
        let time = match (selection.time, rate) {
            (Some(column), _) => table.columns[column][row],
            (None, Some(rate)) => {
                index.map_or_else(
                    || table.sample(row, spacing) as f64,
                    |k| table.columns[k][row] - profiles[k].least,
                ) / rate
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
            if numbers::is_missing(&cell) {
                format!("no value in column {name}")
            } else {
                format!("no number in column {name}")
            }
        });
        leave_out(&mut dropped, &reason, table.lines[row] as usize);
    }
    if swings || selection.time.is_none() {
        if !stamps.is_empty() {
            let notes = Rc::new((understood, dropped));
            runs.push(Run { group, selection, stamps, moves: 1.0, notes });
        }
        return Ok(());
    }
    let recordings = clock::recordings(&stamps, &table.restarts);
    stamps::tell(&recordings, table, &mut understood, &mut dropped);
    let notes = Rc::new((understood, dropped));
    for stamps in recordings.runs {
        let moves = needed.first().map_or(1.0, |column| {
            let profile = Profile::of(stamps.iter().map(|stamp| table.columns[*column][stamp.0]));
            profile.range() / profile.most.abs().max(profile.least.abs()).max(f64::MIN_POSITIVE)
        });
        runs.push(Run {
            group: Rc::clone(&group),
            selection: Rc::clone(&selection),
            stamps,
            moves,
            notes: Rc::clone(&notes),
        });
    }
    Ok(())
}

/// The run asked for, or the longest one that moves; the first data set of a Vernier file.
pub(super) fn chosen(runs: &[Run], options: &Options, vernier: bool) -> Result<Option<usize>, Refusal> {
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

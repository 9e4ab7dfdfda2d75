//! Light gates: tables of periods, and tables of events, where a gate is 1 while dark and 0 otherwise.

use super::heads::Head;
use super::names::{Meaning, words};
use super::options::Options;
use super::profile::median;
use super::record::{Kind, Quantity, Record, Series};
use super::refusal::{Refusal, listed, plain, quoted};
use super::table::Table;

pub(super) const TWICE: &str =
    "A period is the time to the second passage after: each swing passes the gate twice.";

/// The time from each passage to the second after; NaN for the last two.
fn periods(passages: &[f64]) -> Vec<f64> {
    let period = |k: usize| passages.get(k + 2).map_or(f64::NAN, |next| next - passages[k]);
    (0..passages.len()).map(period).collect()
}

/// Refuses a column that counts 1, 2, 3, ... beside a time, unless its name says that it counts passages.
pub(super) fn counted(head: &Head) -> Result<(), Refusal> {
    // Pass, passage, passagem, paso; Durchgang; crossing; cruce, cruzamento.
    let begins = ["pas", "durchg", "cross", "cruce", "cruza"];
    if words(&head.name).split(' ').any(|word| begins.iter().any(|begin| word.starts_with(begin))) {
        return Ok(());
    }
    let name = quoted(&head.written);
    let reason = format!(
        "column {name} counts rows beside the time and is no angle; where each row is a passage of a gate, name it \"passage\""
    );
    Err(Refusal::fault(None, reason))
}

/// The periods of counted passages.
pub(super) fn counted_periods(passages: &[f64], head: &Head) -> Series {
    let name = head.written.clone();
    Series { quantity: Quantity::Period, name, values: periods(passages), uncertainty: None }
}

/// The passages in a table of events; `None` if the table is none.
pub(super) fn events(table: &Table<'_>, options: &Options, record: &mut Record) -> Result<bool, Refusal> {
    let gates: Vec<usize> = (0..table.heads.len())
        .filter(|k| table.heads[*k].meaning == Some(Meaning::State) && binary(&table.columns[*k]))
        .collect();
    let Some(time) = (0..table.heads.len()).find(|k| table.heads[*k].meaning == Some(Meaning::Time)) else {
        return Ok(false);
    };
    if gates.is_empty() || !options.columns.is_empty() {
        return Ok(false);
    }
    let factor = table.heads[time].unit.map_or(1.0, |unit| unit.factor);
    let passages: Vec<Vec<(f64, f64)>> =
        gates.iter().map(|gate| passages(&table.columns[time], &table.columns[*gate], factor)).collect();
    let most = (0..gates.len()).rev().max_by_key(|k| passages[*k].len()).unwrap_or(0);
    let chosen = match options.run {
        Some(run) if run > gates.len() => {
            return Err(Refusal::fault(None, format!("--run = {run}: the file has {} gates", gates.len())));
        }
        Some(run) => run - 1,
        None => most,
    };
    let names: Vec<String> = gates.iter().map(|gate| table.heads[*gate].written.clone()).collect();
    let found = &passages[chosen];
    if found.len() < 3 {
        let name = plain(&names[chosen]);
        let reason = format!("column {name} has {} passages; a period needs three", found.len());
        return Err(Refusal::fault(table.lines.first().map(|line| *line as usize), reason));
    }
    record.kind = Kind::Gate;
    record.run = (chosen + 1, gates.len());
    record.time = found.iter().map(|passage| passage.0).collect();
    record.understood.push(
        "Events of a light gate, not samples: dark while 1; the times are those when it became dark.".into(),
    );
    record.understood.push(TWICE.into());
    if gates.len() > 1 {
        let (names, name) = (listed(&names), plain(&names[chosen]));
        record
            .understood
            .push(format!("{} gates in the file ({names}): {name} read; --run N chooses.", gates.len()));
    }
    let open = found.iter().filter(|passage| !passage.1.is_finite()).count();
    if open > 0 {
        record.understood.push("The last passage is open: its time in the dark is unknown.".into());
    }
    let dark = found.iter().map(|passage| passage.1).collect();
    let every_second = periods(&record.time);
    let series =
        |quantity, values| Series { quantity, name: names[chosen].clone(), values, uncertainty: None };
    record.series = vec![series(Quantity::Period, every_second), series(Quantity::Transit, dark)];
    Ok(true)
}

fn binary(values: &[f64]) -> bool {
    let finite = || values.iter().filter(|value| value.is_finite());
    finite().all(|value| *value == 0.0 || *value == 1.0) && finite().count() > 2
}

/// When the gate became dark, and for how long; NaN if the file ends before.
fn passages(time: &[f64], state: &[f64], factor: f64) -> Vec<(f64, f64)> {
    let mut found = Vec::new();
    let mut dark: Option<f64> = None;
    for (time, state) in time.iter().zip(state).filter(|(time, state)| time.is_finite() && state.is_finite())
    {
        match (dark, *state > 0.5) {
            (None, true) => dark = Some(time * factor),
            (Some(start), false) => {
                found.push((start, time * factor - start));
                dark = None;
            }
            _ => {}
        }
    }
    found.extend(dark.map(|start| (start, f64::NAN)));
    found
}

/// When each period begins, from 0, where each follows the one before.
pub(super) fn sums(periods: &[f64]) -> Vec<f64> {
    let begin = |sum: &mut f64, period: &f64| {
        let start = *sum;
        *sum += period;
        Some(start)
    };
    periods.iter().scan(0.0, begin).collect()
}

/// Leaves out periods near a multiple or a half of the others: a missed passage, or one too many.
pub(super) fn without_miscounts(record: &mut Record, lines: &[usize]) {
    let Some(periods) = record.series(Quantity::Period).map(|series| series.values.clone()) else { return };
    let mut finite: Vec<f64> = periods.iter().copied().filter(|period| period.is_finite()).collect();
    let Some(usual) = median(&mut finite) else { return };
    let kept: Vec<bool> =
        periods.iter().map(|period| *period > 0.65 * usual && *period < 1.5 * usual).collect();
    for (k, kept) in kept.iter().enumerate().filter(|(_, kept)| !**kept) {
        let _ = kept;
        let reason = if periods[k] > usual {
            "a passage missed: the period is too long"
        } else {
            "a passage too many: the period is too short"
        };
        record.drop_row(reason, lines[k]);
    }
    let keep = |values: &mut Vec<f64>| {
        let mut k = 0;
        values.retain(|_| {
            k += 1;
            kept[k - 1]
        });
    };
    if record.time.len() == kept.len() {
        keep(&mut record.time);
    }
    record.series.iter_mut().for_each(|series| keep(&mut series.values));
}

//! The instants of one recording in seconds: their unit, their order, what is odd about them.

use super::clock::{self, Recordings};
use super::heads::Head;
use super::options::{Options, Role};
use super::profile::{Profile, median};
use super::record::{Dropped, Record, leave_out};
use super::refusal::{Refusal, plain, quoted};
use super::table::Table;
use super::units::{Dimension, unit};

/// A recording: rows with their instants in s.
pub(super) struct Stamps {
    pub rows: Vec<usize>,
    pub time: Vec<f64>,
    pub breaks: Vec<usize>,
}

/// The factor to seconds, and the guess in words where the file does not say.
pub(super) fn factor(
    head: &Head,
    profile: &Profile,
    options: &Options,
) -> Result<(f64, Option<String>), Refusal> {
    if let Some(text) = options.stated_unit(Role::Time) {
        return match unit(text).filter(|unit| unit.dimension == Dimension::Time) {
            Some(unit) => Ok((unit.factor, None)),
            None => Err(Refusal::fault(
                None,
                format!("--unit time={}: must be one of s, ms, us, ns, min, h", plain(text)),
            )),
        };
    }
    if let Some(unit) = head.unit {
        if unit.dimension == Dimension::Time {
            return Ok((unit.factor, None));
        }
        let reason = format!(
            "column {} is no time by its unit; times take s, ms, us, ns, min, h",
            quoted(&head.written)
        );
        return Err(Refusal::fault(None, reason));
    }
    if let Some(text) = &head.unknown_unit {
        let reason = format!(
            "column {} is in {}; times take s, ms, us, ns, min, h",
            quoted(&head.written),
            quoted(text)
        );
        return Err(Refusal::fault(None, reason));
    }
    // Whole numbers in steps that no sampled pendulum has in seconds are ticks.
    let ticks = profile.whole && profile.count > 2;
    let since_1970 = |from: f64| profile.whole && profile.least > from && profile.least < 1e3 * from;
    let (factor, name) = match profile.step {
        _ if since_1970(1e17) => (1e-9, "ns since 1970"),
        _ if since_1970(1e14) => (1e-6, "us since 1970"),
        _ if since_1970(1e11) => (1e-3, "ms since 1970"),
        step if ticks && step > 500.0 => (1e-6, "us"),
        step if ticks && (step >= 2.0 || profile.count > 200) => (1e-3, "ms"),
        _ => return Ok((1.0, None)),
    };
    let guess = format!(
        "Column {} holds whole numbers in steps of {}: taken as {name}; --unit time=s says otherwise.",
        quoted(&head.written),
        profile.step
    );
    Ok((factor, Some(guess)))
}

/// Refuses a column that falls more often than it rises.
pub(super) fn refuse_backwards(name: &str, profile: &Profile, line: usize) -> Result<(), Refusal> {
    if profile.count > 2 && profile.not_falling < 0.5 {
        let reason = format!("time goes backwards in column {}; times must rise", quoted(name));
        return Err(Refusal::fault(Some(line), reason));
    }
    Ok(())
}

/// Says what the counters did.
pub(super) fn tell(
    recordings: &Recordings,
    table: &Table<'_>,
    understood: &mut Vec<String>,
    dropped: &mut Vec<Dropped>,
) {
    if let Some(period) = recordings.wraps.first() {
        let times = if recordings.wraps.len() > 1 {
            format!(" {} times", recordings.wraps.len())
        } else {
            String::new()
        };
        understood.push(format!("The clock wraps{times}: {period} is added at each fall."));
    }
    for row in &recordings.strays {
        leave_out(dropped, "a time far from those before and after", table.lines[*row] as usize);
    }
}

/// Puts the stamps of one recording in order and into seconds.
pub(super) fn in_order(
    mut stamps: Vec<(usize, f64)>,
    column: Option<usize>,
    factor: f64,
    table: &Table<'_>,
    record: &mut Record,
) -> Stamps {
    let round = |stamps: &[(usize, f64)]| column.and_then(|column| rounded(stamps, column, table));
    let coarse = round(&stamps).is_some();
    let order = clock::ordered(&mut stamps, coarse);
    let digits = round(&stamps).filter(|_| order.breaks.is_empty());
    if order.moved + order.twice.len() > 0 {
        let (moved, twice) = (order.moved, order.twice.len());
        let duplicates = if twice == 1 { "duplicate" } else { "duplicates" };
        record.understood.push(format!(
            "Times: {moved} out of order, {twice} {duplicates}; sorted, the first of equal ones kept."
        ));
    }
    for row in order.twice {
        leave_out(&mut record.dropped, "the time of the row before", table.lines[row] as usize);
    }
    if !order.breaks.is_empty() {
        let at = order.breaks[0];
        let line = table.lines[stamps[at].0];
        record.understood.push(format!(
            "The clock steps back {} times, first from {} to {} in line {line}: the order is kept, fit the sides apart.",
            order.breaks.len(),
            stamps[at - 1].1,
            stamps[at].1
        ));
    }
    let rows = stamps.iter().map(|stamp| stamp.0).collect();
    let mut time: Vec<f64> = stamps.iter().map(|stamp| stamp.1 * factor).collect();
    if factor < 1.0 {
        // One rounding, by division: 0.1 for 100 ms.
        let divisor = (1.0 / factor).round();
        time = stamps.iter().map(|stamp| stamp.1 / divisor).collect();
    }
    if let Some(digits) = digits {
        let digits: Vec<f64> = digits.iter().map(|digit| digit * factor).collect();
        match clock::rebuilt(&time, &digits) {
            Some((start, rate)) => {
                time = (0..time.len()).map(|k| start + k as f64 / rate).collect();
                record.understood.push(format!(
                    "Times are rounded until several are equal: rebuilt as {start} s + i/{:.6}, of which each is a rounding.",
                    rate
                ).replace(".000000,", ","));
            }
            None => record.understood.push(
                "Times are rounded until several are equal, and no even rate explains them: kept as written."
                    .into(),
            ),
        }
    }
    Stamps { rows, time, breaks: order.breaks }
}

/// The place values of the stamps' last digits, where equal stamps are samples that rounding made equal.
fn rounded(stamps: &[(usize, f64)], column: usize, table: &Table<'_>) -> Option<Vec<f64>> {
    let equal: Vec<usize> = (1..stamps.len()).filter(|k| stamps[*k].1 == stamps[k - 1].1).collect();
    let usual = (stamps.last()?.1 - stamps.first()?.1) / (stamps.len() - 1).max(1) as f64;
    let coarse = |k: &usize| table.resolution(stamps[*k].0, column).is_some_and(|digit| digit >= 0.4 * usual);
    // A clock that stands is no rounding.
    if equal.is_empty() || equal.len() + 1 == stamps.len() || !equal.iter().take(50).any(coarse) {
        return None;
    }
    stamps.iter().map(|stamp| table.resolution(stamp.0, column)).collect()
}

/// How often was sampled, and the gaps.
pub(super) fn sampling(time: &[f64]) -> Vec<String> {
    let mut steps: Vec<f64> =
        time.windows(2).map(|pair| pair[1] - pair[0]).filter(|step| *step > 0.0).collect();
    let Some(usual) = median(&mut steps) else { return Vec::new() };
    let least = steps.iter().copied().fold(f64::INFINITY, f64::min);
    let most = steps.iter().copied().fold(0.0, f64::max);
    let mut said = vec![format!(
        "{} samples from {} s to {} s, every {} s ({} to {}).",
        time.len(),
        short(time[0]),
        short(time[time.len() - 1]),
        short(usual),
        short(least),
        short(most)
    )];
    let gaps: Vec<&[f64]> = time.windows(2).filter(|pair| pair[1] - pair[0] > 5.0 * usual).collect();
    for pair in gaps.iter().take(3) {
        said.push(format!("A gap of {} s after {} s (paused?).", short(pair[1] - pair[0]), short(pair[0])));
    }
    if gaps.len() > 3 {
        said.push(format!("{} gaps in all.", gaps.len()));
    }
    said
}

/// Six digits at most.
pub(super) fn short(value: f64) -> String {
    crate::digits::plain(value, 5)
}

//! The header of a table: which line above the rows names the columns, and which one has their units.

use super::dialect::{Dialect, MOST_COLUMNS, Separator};
use super::heads::{Head, are_units};
use super::lines::{Line, comment};
use super::refusal::Refusal;

/// The heads of the columns from the lines above the rows; `None` where no line names them. The first rows tell decimal
/// commas from separators.
pub(super) fn heads(
    dialect: &Dialect,
    preamble: &[Line<'_>],
    rows: &[Line<'_>],
    width: usize,
    vernier: bool,
) -> Result<Option<Vec<Head>>, Refusal> {
    if !dialect.names.is_empty() {
        let numbered =
            |(k, name): (usize, &String)| if name.is_empty() { Head::numbered(k) } else { Head::of(name) };
        return Ok(Some(dialect.names.iter().enumerate().map(numbered).collect()));
    }
    let mut above: Vec<Vec<String>> = Vec::new();
    for line in preamble {
        above.push(header_cells(dialect, *line, width)?);
    }
    let mut units = None;
    if let Some(cells) = above.last().filter(|cells| are_units(cells)) {
        // A line of units below a line of names; alone it names the columns.
        if above.len() > 1 && above[above.len() - 2].iter().any(|cell| !cell.is_empty()) {
            units = Some(cells.clone());
            above.pop();
        }
    }
    let heads = |cells: &[String]| -> Vec<Head> { cells.iter().map(|cell| Head::of(cell)).collect() };
    let known = |heads: &[Head]| heads.iter().filter(|head| head.meaning.is_some()).count();
    let filled = |cells: &[String]| cells.iter().filter(|cell| !cell.is_empty()).count();
    // Logger Pro has the long names above the short ones.
    let mut best: Option<(usize, usize)> = None;
    for (k, cells) in above.iter().enumerate().rev().take(4) {
        let score = known(&heads(cells));
        let full =
            filled(cells) * 2 >= width.min(cells.len()).max(1) && (score > 0 || filled(cells) >= width);
        if full && best.is_none_or(|(_, most)| score > most || vernier && score == most) {
            best = Some((k, score));
        }
    }
    let names = best.map(|(k, _)| above.remove(k));
    refuse_decimal_commas(dialect, rows, names.as_ref().map(Vec::len), width)?;
    let headed = names.is_some();
    let mut found = names.map_or_else(Vec::new, |cells| heads(&cells));
    // A name beyond the usual row is a column that is blank in most rows.
    let width = width.max(if headed { found.len().min(width + 1) } else { 0 });
    found.truncate(width);
    found.extend((found.len()..width).map(Head::numbered));
    for (k, head) in found.iter_mut().enumerate() {
        if let Some(cell) = units.as_ref().and_then(|units| units.get(k)) {
            *head = head.clone().with_unit(cell);
        }
        if head.written.is_empty() {
            *head = Head { unit: head.unit, ..Head::numbered(k) };
        }
    }
    Ok(if headed || units.is_some() { Some(found) } else { None })
}

/// The cells of a line above the rows, by the separator that gives as many as a row has.
fn header_cells(dialect: &Dialect, line: Line<'_>, width: usize) -> Result<Vec<String>, Refusal> {
    let text = comment(line.text).unwrap_or(line.text);
    let mut cells = Vec::new();
    dialect.cells(Line { text, ..line }, &mut cells)?;
    let own: Vec<String> = cells.iter().map(|cell| cell.trim().to_owned()).collect();
    if own.len() == width {
        return Ok(own);
    }
    let one = |separator: char| -> Vec<String> {
        text.split(separator)
            .take(MOST_COLUMNS)
            .map(|cell| cell.trim().trim_matches('"').to_owned())
            .collect()
    };
    let wide = |cells: &Vec<String>| cells.len() >= width && cells.len() <= width + 1;
    let gaps: Vec<String> = text
        .split("  ")
        .map(|cell| cell.trim().to_owned())
        .filter(|cell| !cell.is_empty())
        .take(MOST_COLUMNS)
        .collect();
    let others = [one('\t'), one(';'), one(','), gaps, bracketed(text)];
    Ok(others.into_iter().find(wide).filter(|_| width > 1).unwrap_or(own))
}

/// Commas that separate and mark the decimals too: nobody can tell them apart.
fn refuse_decimal_commas(
    dialect: &Dialect,
    rows: &[Line<'_>],
    names: Option<usize>,
    width: usize,
) -> Result<(), Refusal> {
    if dialect.separator != Separator::One(',') || width < 4 || width % 2 == 1 {
        return Ok(());
    }
    if names == Some(width) {
        return Ok(());
    }
    let halved = names.is_some_and(|names| names * 2 == width);
    let mut digits = vec![None; width];
    let mut cells = Vec::new();
    for row in rows {
        if row.text.contains('"') {
            return Ok(());
        }
        dialect.cells(*row, &mut cells)?;
        for (k, cell) in cells.iter().enumerate().take(width) {
            let whole = cell.trim_start_matches(['-', '+']);
            let whole = !whole.is_empty() && whole.bytes().all(|byte| byte.is_ascii_digit());
            let fraction = k % 2 == 0 || !cell.starts_with(['-', '+']);
            // Decimals of a column written to a fixed number of places have one length.
            let fixed = k % 2 == 0 || *digits[k].get_or_insert(cell.len()) == cell.len();
            if !whole || !fraction || !halved && !fixed {
                return Ok(());
            }
        }
    }
    let line = rows.first().map(|row| row.number);
    let reason = "a decimal comma and a comma between columns cannot be told apart; \
                  separate columns with semicolons or tabs, or put cells in quotes";
    Err(Refusal::fault(line, reason))
}

/// Words separated by blanks, with a unit in brackets beside its name: `Time (s) Angle (deg)`.
fn bracketed(text: &str) -> Vec<String> {
    let mut cells: Vec<String> = Vec::new();
    for part in text.split_whitespace().take(MOST_COLUMNS) {
        match cells.last_mut() {
            Some(last) if part.starts_with(['(', '[']) => *last = format!("{last} {part}"),
            _ => cells.push(part.to_owned()),
        }
    }
    cells
}

//! One column of a text file, read strictly: instants to compute at, samples of a torque. Order and repetitions are kept,
//! and what is no number is refused, for a value left out would be an answer left out.

use super::dialect::{Dialect, Separator};
use super::encoding;
use super::lines::{Line, lines};
use crate::decimal;
use crate::letters::lower;

/// Characters of a line that is read.
const LONGEST_LINE: usize = 1 << 20;
const SIGNS: [char; 4] = ['+', '-', '.', '\u{2212}'];

/// What a column holds.
pub struct Wanted<'a> {
    /// The file as a message names it.
    pub file: &'a str,
    /// What the column holds, as `instants`.
    pub plural: &'a str,
    /// Names by which it is known, in lower case.
    pub names: &'a [String],
    /// The column, from 0, where none has such a name.
    pub place: usize,
    /// The units it takes, to be read after the unit that was found: `times take s, ms`.
    pub takes: &'a str,
    /// A unit's factor as a decimal text; `None` for no unit.
    pub factor: &'a dyn Fn(&str) -> Option<String>,
    /// Shows a text of the file in a message.
    pub quoted: &'a dyn Fn(&str) -> String,
}

/// The values in the unit of factor 1, and the name of their column.
#[derive(Clone, Debug, PartialEq)]
pub struct Values {
    /// In the order of the file.
    pub values: Vec<f64>,
    /// The header's, or the number of the column.
    pub name: String,
}

/// Why there are no values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unread {
    /// Whether the column that was asked for is to blame, not the file.
    pub column: bool,
    /// What was found and what is allowed, in one line.
    pub reason: String,
}

fn unread(reason: String) -> Unread {
    Unread { column: false, reason }
}

/// Reads the column that `name` names, or the one that is wanted by its own names, or by its place.
///
/// Lines that begin with `#` and blank lines are passed over; the first other line may be a header. Tabs, semicolons or
/// commas separate; where tabs or semicolons do, a comma in a number is a decimal comma.
///
/// # Errors
/// One line that says what was found and what is allowed.
pub fn column(bytes: &[u8], name: Option<&str>, wanted: &Wanted<'_>) -> Result<Values, Unread> {
    let plural = wanted.plural;
    let (text, _) = encoding::decoded(bytes).map_err(|refusal| unread(refusal.reason()))?;
    let mut rows = lines(&text).filter(|line| !line.text.trim_start_matches(' ').starts_with('#'));
    let first =
        rows.next().ok_or_else(|| unread(format!("holds no {plural}: it is empty, but for comments")))?;
    let separator = ['\t', ';', ','].into_iter().find(|each| first.text.contains(*each)).unwrap_or(',');
    let dialect = Dialect::separated(Separator::One(separator));
    let cells = row(first, &dialect)?;
    let headed = is_header(&cells);
    let mut rows = rows.peekable();
    if let (true, Some(second)) = (headed, rows.peek()) {
        refuse_two_headers(first, *second)?;
    }
    let chosen = chosen(name, &cells, headed, wanted)?;
    let doubtful = !headed && name.is_none() && separator == ',' && cells.len() > 1;
    let mut reader = Strict {
        dialect,
        width: cells.len(),
        index: chosen.index,
        factor: chosen.factor,
        values: Vec::new(),
        bad: None,
        whole: true,
        comma: false,
        point: false,
        headed,
    };
    if !headed {
        reader.take(first, wanted.quoted)?;
    }
    for line in rows {
        reader.take(line, wanted.quoted)?;
    }
    if reader.comma && reader.point {
        let reason = "has decimal commas and decimal points in one column; write the one or the other";
        return Err(unread(reason.into()));
    }
    if let Some(reason) = reader.bad {
        return Err(unread(reason));
    }
    if doubtful && reader.whole {
        let reason = "holds only whole numbers and commas: decimal commas? write points; columns? choose one by --column 1";
        return Err(unread(reason.into()));
    }
    if reader.values.is_empty() {
        return Err(unread(format!("holds no {plural}: no row follows the header in line {}", first.number)));
    }
    Ok(Values { values: reader.values, name: chosen.name })
}

/// The cells of a line.
fn row(line: Line<'_>, dialect: &Dialect) -> Result<Vec<String>, Unread> {
    let length = if line.text.len() > LONGEST_LINE { line.text.trim_matches(' ').chars().count() } else { 0 };
    if length > LONGEST_LINE {
        let reason = format!(
            "line {} has {length} characters, more than the {LONGEST_LINE} that are read",
            line.number
        );
        return Err(unread(reason));
    }
    let mut cells = Vec::new();
    let line = Line { text: line.text.trim_matches(' '), ..line };
    dialect
        .cells(line, &mut cells)
        .map_err(|refusal| unread(format!("line {} {}", line.number, refusal.reason())))?;
    Ok(cells.into_iter().map(|cell| cell.into_owned()).collect())
}

/// Whether a line names columns: no cell is a number, and the first does not begin like one.
fn is_header(cells: &[String]) -> bool {
    let numeric = |cell: &String| number(cell).is_some() || with_point(cell).is_some();
    let start = cells.first().and_then(|cell| cell.chars().next());
    !cells.iter().any(numeric) && !start.is_some_and(|start| SIGNS.contains(&start) || start.is_numeric())
}

/// Refuses a second line of words: nobody knows which one names the columns.
fn refuse_two_headers(first: Line<'_>, second: Line<'_>) -> Result<(), Unread> {
    let Some(separator) = ['\t', ';', ','].into_iter().find(|each| second.text.contains(*each)) else {
        return Ok(());
    };
    if !is_header(&row(second, &Dialect::separated(Separator::One(separator)))?) {
        return Ok(());
    }
    let (first, second) = (first.number, second.number);
    Err(unread(format!(
        "lines {first} and {second} are both words: is one a title, or one of units? begin it with #"
    )))
}

/// The double in a cell; nothing that is a number only in another script.
fn number(cell: &str) -> Option<f64> {
    if cell.is_ascii() { decimal::number(cell) } else { None }
}

/// `0.5` for `0,5`.
fn with_point(cell: &str) -> Option<String> {
    let (whole, rest) = cell.split_once(',')?;
    let digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    let signed = |text: &str| digits(text.strip_prefix(['+', '-']).unwrap_or(text));
    let (decimals, exponent) = rest.split_once(['e', 'E']).map_or((rest, None), |(a, b)| (a, Some(b)));
    let exponent = exponent.is_none_or(|text| signed(text) && text.bytes().any(|byte| byte.is_ascii_digit()));
    (signed(whole) && !decimals.is_empty() && digits(decimals) && exponent).then(|| cell.replace(',', "."))
}

/// A number without a point.
fn is_whole(cell: &str) -> bool {
    !cell.is_empty() && !cell.contains(['.', ',']) && number(cell).is_some_and(f64::is_finite)
}

/// Index, name and factor of the column to read; no factor for the first unit.
struct Place {
    index: usize,
    name: String,
    factor: Option<String>,
}

fn chosen(
    column: Option<&str>,
    cells: &[String],
    headed: bool,
    wanted: &Wanted<'_>,
) -> Result<Place, Unread> {
    let (file, quoted) = (wanted.file, wanted.quoted);
    let listed = |names: &[String]| {
        let shown: Vec<String> = names.iter().take(12).map(|name| quoted(name)).collect();
        shown.join(", ") + if names.len() > 12 { ", ..." } else { "" }
    };
    let refused = |reason: String| Unread { column: true, reason };
    if column.is_none() && wanted.place >= cells.len() {
        let reason = format!("has {} column, and the {} are in a second", cells.len(), wanted.plural);
        return Err(unread(reason));
    }
    if !headed {
        let names: Vec<String> = (1..=cells.len()).map(|k| k.to_string()).collect();
        let index = match column {
            None => wanted.place,
            Some(column) => names.iter().position(|name| name == column).ok_or_else(|| {
                refused(format!("{file} has no header; its columns are {}", listed(&names)))
            })?,
        };
        return Ok(Place { index, name: names[index].clone(), factor: None });
    }
    let bare: Vec<&str> = cells.iter().map(|cell| name_and_unit(cell, wanted.factor).0).collect();
    let only = |found: &mut dyn Iterator<Item = usize>| found.next().filter(|_| found.next().is_none());
    let index = match column {
        None => {
            let known = |name: &&str| wanted.names.contains(&lower(name));
            bare.iter().position(known).unwrap_or(wanted.place)
        }
        Some(column) => {
            let whole = only(&mut (0..cells.len()).filter(|k| cells[*k] == column));
            whole.or_else(|| only(&mut (0..cells.len()).filter(|k| bare[*k] == column))).ok_or_else(|| {
                let known = cells.iter().any(|cell| cell == column) || bare.contains(&column);
                let several = if known { "names several columns" } else { "is no column" };
                refused(format!("{several} of {file}; it has {}", listed(cells)))
            })?
        }
    };
    let factor = match name_and_unit(&cells[index], wanted.factor).1 {
        None | Some("") => None,
        Some(unit) => Some((wanted.factor)(unit).ok_or_else(|| {
            let (column, unit) = (quoted(&cells[index]), quoted(unit));
            unread(format!("column {column} is in {unit}; {}", wanted.takes))
        })?),
    };
    Ok(Place { index, name: cells[index].clone(), factor: factor.filter(|factor| factor != "1") })
}

/// `t`, `ms` for the cell `t [ms]`, `t (ms)`, `t/ms` or `t_ms`; in brackets any text is a unit.
fn name_and_unit<'c>(cell: &'c str, factor: &dyn Fn(&str) -> Option<String>) -> (&'c str, Option<&'c str>) {
    let brackets = if cell.ends_with(']') {
        Some('[')
    } else if cell.ends_with(')') {
        Some('(')
    } else {
        None
    };
    if let Some(opening) = brackets {
        let Some(at) = cell.find(opening) else { return (cell, None) };
        return (cell[..at].trim_end(), Some(cell[at + 1..cell.len() - 1].trim()));
    }
    let Some(at) = cell.rfind(['/', '_']) else { return (cell, None) };
    let unit = cell[at + 1..].trim_start();
    if factor(unit).is_some() { (cell[..at].trim_end(), Some(unit)) } else { (cell, None) }
}

/// One column on its way from lines to doubles.
struct Strict {
    dialect: Dialect,
    width: usize,
    index: usize,
    factor: Option<String>,
    values: Vec<f64>,
    /// What the first bad row is.
    bad: Option<String>,
    /// Whether every cell is a whole number.
    whole: bool,
    comma: bool,
    point: bool,
    headed: bool,
}

impl Strict {
    fn take(&mut self, line: Line<'_>, quoted: &dyn Fn(&str) -> String) -> Result<(), Unread> {
        let cells = row(line, &self.dialect)?;
        self.whole &= cells.iter().all(|cell| is_whole(cell));
        let cell = cells.get(self.index).map_or("", String::as_str);
        let pointed = if self.dialect.separator == Separator::One(',') { None } else { with_point(cell) };
        if self.dialect.separator != Separator::One(',') {
            self.comma |= pointed.is_some();
            self.point |= pointed.is_none() && cell.contains('.');
        }
        let text = pointed.as_deref().unwrap_or(cell);
        let value = number(text);
        let reason = if cells.len() != self.width {
            let doubled = cells.len() == 2 * self.width && is_whole(&cells[0]);
            let advice = if doubled { "; a decimal comma? write a point" } else { "" };
            format!("has {} cells, and the first row has {}{advice}", cells.len(), self.width)
        } else if cell.is_empty() {
            "has an empty cell".into()
        } else {
            match value {
                None => {
                    let advice = with_point(cell).map_or(String::new(), |text| format!("; write {text}"));
                    format!("{} is not a number{advice}", quoted(cell))
                }
                Some(value) if !value.is_finite() => format!("{} is not finite", quoted(cell)),
                Some(value) => {
                    self.values.push(self.factor.as_ref().map_or(value, |factor| product(text, factor)));
                    return Ok(());
                }
            }
        };
        if self.bad.is_none() {
            let titled = self.headed && self.values.is_empty() && !reason.contains("write");
            let advice = if titled { "; if the line above is a title, begin it with #" } else { "" };
            self.bad = Some(format!("line {} {reason}{advice}", line.number));
        }
        Ok(())
    }
}

/// The double nearest to the product of two decimal texts: it is formed in decimals, and rounded once.
fn product(number: &str, factor: &str) -> f64 {
    let exactly = crate::product::product(number, factor).and_then(|text| decimal::number(&text));
    exactly.or_else(|| decimal::number(number)).unwrap_or(f64::NAN)
}

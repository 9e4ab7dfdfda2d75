//! Instants at which something is to be computed: one column of a text file, read strictly. Order and repetitions are kept,
//! and what is no number is refused, for an instant left out would be an answer left out.

use super::dialect::{Dialect, Separator};
use super::encoding;
use super::heads::Head;
use super::lines::{Line, lines};
use super::units::{Dimension, Unit};

/// Characters of a line that is read.
const LONGEST_LINE: usize = 1 << 20;
const SIGNS: [char; 4] = ['+', '-', '.', '\u{2212}'];

/// The instants in s, and the name of their column.
#[derive(Clone, Debug, PartialEq)]
pub struct Instants {
    /// In the order of the file.
    pub time: Vec<f64>,
    /// The header's, or the number of the column.
    pub name: String,
}

/// Why there are no instants.
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

/// Reads one column of instants: the one named, or `t`, `time`, `times`, or the first.
///
/// Lines that begin with `#` and blank lines are passed over; the first other line may be a header. Tabs, semicolons or
/// commas separate; where tabs or semicolons do, a comma in a number is a decimal comma. `quoted` shows a text of the file
/// in a message, and `file` is the file as a message names it.
///
/// # Errors
/// One line that says what was found and what is allowed.
pub fn instants(
    file: &str,
    bytes: &[u8],
    column: Option<&str>,
    quoted: &dyn Fn(&str) -> String,
) -> Result<Instants, Unread> {
    let (text, _) = encoding::decoded(bytes).map_err(|refusal| unread(refusal.reason()))?;
    let mut rows = lines(&text).filter(|line| !line.text.trim_start_matches(' ').starts_with('#'));
    let first =
        rows.next().ok_or_else(|| unread("holds no instants: it is empty, but for comments".into()))?;
    let separator = ['\t', ';', ','].into_iter().find(|each| first.text.contains(*each)).unwrap_or(',');
    let cells = row(first, separator)?;
    let header = is_header(&cells).then(|| cells.iter().map(|cell| Head::of(cell)).collect::<Vec<Head>>());
    let mut rows = rows.peekable();
    if let (Some(_), Some(second)) = (&header, rows.peek()) {
        refuse_two_headers(first, *second)?;
    }
    let chosen = chosen(file, column, cells.len(), header.as_deref(), quoted)?;
    let doubtful = header.is_none() && column.is_none() && separator == ',' && cells.len() > 1;
    let mut reader = Column {
        separator,
        width: cells.len(),
        index: chosen.index,
        unit: chosen.unit,
        time: Vec::new(),
        bad: None,
        whole: true,
        comma: false,
        point: false,
        headed: header.is_some(),
    };
    if header.is_none() {
        reader.take(first, quoted)?;
    }
    for line in rows {
        reader.take(line, quoted)?;
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
    if reader.time.is_empty() {
        return Err(unread(format!("holds no instants: no row follows the header in line {}", first.number)));
    }
    Ok(Instants { time: reader.time, name: chosen.name })
}

/// The cells of a line.
fn row(line: Line<'_>, separator: char) -> Result<Vec<String>, Unread> {
    let length = if line.text.len() > LONGEST_LINE { line.text.trim_matches(' ').chars().count() } else { 0 };
    if length > LONGEST_LINE {
        let reason = format!(
            "line {} has {length} characters, more than the {LONGEST_LINE} that are read",
            line.number
        );
        return Err(unread(reason));
    }
    let dialect = Dialect { separator: Separator::One(separator), clocked: false, names: Vec::new() };
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
    if !is_header(&row(second, separator)?) {
        return Ok(());
    }
    let (first, second) = (first.number, second.number);
    Err(unread(format!(
        "lines {first} and {second} are both words: is one a title, or one of units? begin it with #"
    )))
}

/// The double in a cell; nothing that is a number only in another script.
fn number(cell: &str) -> Option<f64> {
    if cell.is_ascii() { cell.parse().ok() } else { None }
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

/// Index, name and unit of the column to read.
struct Wanted {
    index: usize,
    name: String,
    unit: Option<Unit>,
}

fn chosen(
    file: &str,
    column: Option<&str>,
    width: usize,
    header: Option<&[Head]>,
    quoted: &dyn Fn(&str) -> String,
) -> Result<Wanted, Unread> {
    let listed = |names: &mut dyn Iterator<Item = &str>, count: usize| {
        let shown: Vec<String> = names.take(12).map(quoted).collect();
        shown.join(", ") + if count > 12 { ", ..." } else { "" }
    };
    let refused = |reason: String| Unread { column: true, reason };
    let Some(heads) = header else {
        let names: Vec<String> = (1..=width).map(|k| k.to_string()).collect();
        let index = match column {
            None => 0,
            Some(column) => names.iter().position(|name| name == column).ok_or_else(|| {
                let has = listed(&mut names.iter().map(String::as_str), width);
                refused(format!("{file} has no header; its columns are {has}"))
            })?,
        };
        return Ok(Wanted { index, name: names[index].clone(), unit: None });
    };
    let only = |column: &str, name: fn(&Head) -> &str| {
        let mut found = (0..width).filter(|k| name(&heads[*k]) == column);
        found.next().filter(|_| found.next().is_none())
    };
    let index = match column {
        None => {
            let named = |head: &Head| ["t", "time", "times"].contains(&head.name.to_lowercase().as_str());
            heads.iter().position(named).unwrap_or(0)
        }
        Some(column) => only(column, |head| &head.written)
            .or_else(|| only(column, |head| &head.name))
            .ok_or_else(|| {
                let known = heads.iter().any(|head| head.written == column || head.name == column);
                let several = if known { "names several columns" } else { "is no column" };
                let has = listed(&mut heads.iter().map(|head| head.written.as_str()), width);
                refused(format!("{several} of {file}; it has {has}"))
            })?,
    };
    let head = &heads[index];
    let unit = head.unit.filter(|unit| unit.dimension == Dimension::Time);
    if unit.is_none() && (head.unit.is_some() || head.unknown_unit.is_some()) {
        let inside = head.written.strip_prefix(&head.name).unwrap_or(&head.written);
        let inside = inside.trim_matches(|each: char| each.is_whitespace() || "[](){}/_".contains(each));
        let (column, unit) = (quoted(&head.written), quoted(inside));
        return Err(unread(format!("column {column} is in {unit}; times take s, ms, min, h")));
    }
    Ok(Wanted { index, name: head.written.clone(), unit })
}

/// One column on its way from lines to doubles.
struct Column {
    separator: char,
    width: usize,
    index: usize,
    unit: Option<Unit>,
    time: Vec<f64>,
    /// What the first bad row is.
    bad: Option<String>,
    /// Whether every cell is a whole number.
    whole: bool,
    comma: bool,
    point: bool,
    headed: bool,
}

impl Column {
    fn take(&mut self, line: Line<'_>, quoted: &dyn Fn(&str) -> String) -> Result<(), Unread> {
        let cells = row(line, self.separator)?;
        self.whole &= cells.iter().all(|cell| is_whole(cell));
        let cell = cells.get(self.index).map_or("", String::as_str);
        let pointed = if self.separator == ',' { None } else { with_point(cell) };
        if self.separator != ',' {
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
                Some(_) => {
                    self.time.push(in_seconds(text, self.unit));
                    return Ok(());
                }
            }
        };
        if self.bad.is_none() {
            let titled = self.headed && self.time.is_empty() && !reason.contains("write");
            let advice = if titled { "; if the line above is a title, begin it with #" } else { "" };
            self.bad = Some(format!("line {} {reason}{advice}", line.number));
        }
        Ok(())
    }
}

/// The double nearest to a decimal text in a unit: the product is formed in decimals, and rounded once.
fn in_seconds(text: &str, unit: Option<Unit>) -> f64 {
    let factor = unit.map_or(1.0, |unit| unit.factor);
    let plain = || text.parse::<f64>().unwrap_or(f64::NAN);
    if factor == 1.0 {
        return plain();
    }
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let Ok(exponent) = exponent.parse::<i64>() else { return plain() };
    if let Some(shift) = [3, 6, 9].into_iter().find(|shift| factor == [1e-3, 1e-6, 1e-9][shift / 3 - 1]) {
        return format!("{mantissa}e{}", exponent.saturating_sub(shift as i64))
            .parse()
            .unwrap_or_else(|_| plain());
    }
    let (whole, decimals) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let sign = if whole.starts_with('-') { "-" } else { "" };
    let digits = whole.trim_start_matches(['+', '-']).bytes().chain(decimals.bytes());
    let digits: Vec<u8> = digits.filter(u8::is_ascii_digit).map(|digit| digit - b'0').collect();
    // From the last digit: 60 and 3600 are whole, so the product has as many decimals.
    let (factor, mut carry) = (factor as u32, 0);
    let mut product: Vec<u8> = Vec::with_capacity(digits.len() + 4);
    for digit in digits.iter().rev() {
        carry += u32::from(*digit) * factor;
        product.push((carry % 10) as u8 + b'0');
        carry /= 10;
    }
    while carry > 0 {
        product.push((carry % 10) as u8 + b'0');
        carry /= 10;
    }
    product.reverse();
    let product = String::from_utf8(product).unwrap_or_default();
    let exponent = exponent.saturating_sub(decimals.len() as i64);
    format!("{sign}{product}e{exponent}").parse().unwrap_or_else(|_| plain())
}

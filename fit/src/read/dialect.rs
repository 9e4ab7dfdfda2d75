//! How a line is cut into cells: by tabs, semicolons, bars, commas, blanks; `name=value`; vectors in brackets; the clock that a
//! serial monitor writes in front.

use std::borrow::Cow;
use std::cell::RefCell;

use super::lines::{Line, comment, lines};
use super::numbers;
use super::refusal::Refusal;

/// More columns than this are no record of a pendulum; the limit keeps memory near the size of the file.
pub(super) const MOST_COLUMNS: usize = 4096;
/// Bytes of the longest line that is taken for a row.
const LONGEST_LINE: usize = 1 << 20;
/// Lines that decide.
const SAMPLE: usize = 200;

/// What separates cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Separator {
    One(char),
    Blanks,
    /// `name=value` or `name:value`.
    Pairs,
    /// `(505, 564)` or `[0.1, 0.2, 0.3]`.
    Vectors,
}

/// How the lines of a file are cut.
#[derive(Debug)]
pub(super) struct Dialect {
    pub separator: Separator,
    /// Whether `14:03:07.150 -> ` stands in front.
    pub clocked: bool,
    /// The names of pairs, or of the numbers of vectors.
    pub names: Vec<String>,
    /// The reader of lines with quotes: its tables take longer to build than a line to read, and a copy of it has none.
    quotes: RefCell<csv_core::Reader>,
}

impl Dialect {
    /// The dialect of a known separator.
    pub(super) fn separated(separator: Separator) -> Dialect {
        let delimiter = if let Separator::One(each) = separator { each as u8 } else { b',' };
        let quotes = csv_core::ReaderBuilder::new().delimiter(delimiter).build();
        Dialect { separator, clocked: false, names: Vec::new(), quotes: RefCell::new(quotes) }
    }

    /// The dialect of a text.
    pub(super) fn of(text: &str) -> Result<Dialect, Refusal> {
        let (mut numeric, mut worded) = (Vec::new(), Vec::new());
        let mut above = "";
        for line in lines(text) {
            let remark = comment(line.text);
            if remark.is_none() {
                short_enough(line)?;
                let start = line.text.trim_start().trim_start_matches('"').bytes().next().unwrap_or(b' ');
                if matches!(start, b'0'..=b'9' | b'+' | b'-' | b'.' | b',' | b';' | b'(' | b'[' | 0xe2) {
                    numeric.push(line.text);
                    if numeric.len() == SAMPLE {
                        break;
                    }
                    continue;
                }
                if worded.len() < SAMPLE && line.text.bytes().any(|byte| byte.is_ascii_digit()) {
                    worded.push(line.text);
                }
            }
            if numeric.is_empty() {
                above = remark.unwrap_or(line.text);
            }
        }
        let clocked = share(&numeric, |line| clock_end(line).is_some()) > 0.5;
        let mut sample = if numeric.len() < worded.len() { worded } else { numeric };
        if clocked {
            sample = sample.into_iter().map(without_clock).collect();
        }
        let (separator, names) = separator(&sample, above);
        Ok(Dialect { clocked, names, ..Dialect::separated(separator) })
    }

    /// The cells of a line.
    pub(super) fn cells<'a>(&self, line: Line<'a>, cells: &mut Vec<Cow<'a, str>>) -> Result<(), Refusal> {
        cells.clear();
        short_enough(line)?;
        let text = if self.clocked { without_clock(line.text) } else { line.text };
        match self.separator {
            Separator::One(_) if text.contains('"') => {
                quoted_cells(text, &mut self.quotes.borrow_mut(), cells)
            }
            Separator::One(separator) => {
                let parts = text.split(separator).take(MOST_COLUMNS + 1);
                cells.extend(parts.map(|cell| Cow::Borrowed(cell.trim())));
            }
            Separator::Blanks if text.contains('"') => quoted_between_blanks(text, cells),
            Separator::Blanks => {
                cells.extend(text.split_whitespace().take(MOST_COLUMNS + 1).map(Cow::Borrowed));
            }
            Separator::Vectors => {
                let numbers = text.split(is_vector_mark).filter(|cell| !cell.is_empty());
                cells.extend(numbers.take(MOST_COLUMNS + 1).map(Cow::Borrowed));
            }
            Separator::Pairs => {
                let found: Vec<(&str, &str)> = pairs(text).take(MOST_COLUMNS + 1).collect();
                let value =
                    |name: &String| found.iter().find(|pair| pair.0 == name).map_or("", |pair| pair.1);
                if found.is_empty() {
                    cells.push(Cow::Borrowed(text.trim()));
                } else {
                    cells.extend(self.names.iter().map(|name| Cow::Borrowed(value(name))));
                }
            }
        }
        if cells.len() > MOST_COLUMNS {
            let reason = format!("has more than {MOST_COLUMNS} columns, the most that are read");
            return Err(Refusal::fault(Some(line.number), reason));
        }
        Ok(())
    }
}

fn short_enough(line: Line<'_>) -> Result<(), Refusal> {
    if line.text.len() <= LONGEST_LINE {
        return Ok(());
    }
    let reason = format!("has {} bytes; a row of a table has at most {LONGEST_LINE}", line.text.len());
    Err(Refusal::fault(Some(line.number), reason))
}

/// Whether lines such as `57,395` are one column under one name, not a counter beside whole numbers, which grows from line to line.
fn one_decimal_column<'a>(sample: &[&'a str], above: &str) -> bool {
    let signs = ['+', '-', '\u{2212}'];
    let digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    let number = |line: &&str| {
        let (whole, decimals) = line.trim().split_once(',').unwrap_or((line.trim(), ""));
        digits(whole.trim_start_matches(signs)) && digits(decimals) || numbers::is_missing(line)
    };
    let whole = |line: &'a str| line.split_once(',').map_or(line, |parts| parts.0);
    let grows = |pair: &[&'a str]| {
        let (before, after) = (whole(pair[0]), whole(pair[1]));
        (before.len(), before) < (after.len(), after)
    };
    above.contains(char::is_alphabetic)
        && !above.contains([',', ';', '\t', '|'])
        && sample.iter().all(number)
        && !sample.windows(2).all(grows)
}

/// The separator that the lines agree on under the line `above`, and the names of pairs or vectors.
fn separator(sample: &[&str], above: &str) -> (Separator, Vec<String>) {
    if share(sample, |line| pairs(line).next().is_some()) > 0.5 {
        let mut names: Vec<String> = Vec::new();
        // A pair may be missing in some lines; the names of a few lines are all names.
        for (name, _) in sample.iter().take(20).flat_map(|line| pairs(line).take(64)) {
            if names.len() < 64 && !names.iter().any(|each| each == name) {
                names.push(name.to_owned());
            }
        }
        return (Separator::Pairs, names);
    }
    let vector = |line: &str| {
        line.contains(['(', '['])
            && line.split(is_vector_mark).all(|cell| cell.is_empty() || numbers::is_number(cell))
    };
    if share(sample, vector) > 0.5 {
        let first = sample.iter().find(|line| vector(line)).unwrap_or(&"");
        return (Separator::Vectors, vector_names(first));
    }
    if share(sample, |line| line.contains('\t')) > 0.5 {
        return (Separator::One('\t'), Vec::new());
    }
    if share(sample, |line| line.contains(';')) > 0.5 {
        return (Separator::One(';'), Vec::new());
    }
    if share(sample, |line| line.contains('|')) > 0.5 {
        return (Separator::One('|'), Vec::new());
    }
    if share(sample, |line| line.contains(',')) > 0.5 && one_decimal_column(sample, above) {
        return (Separator::One(';'), Vec::new());
    }
    // Between digits only, and blanks beside it: the comma of `0,1 18,5` is a decimal mark, that of `0.1, 18.5` is not.
    let decimal = |line: &str| {
        let number = |word: &str| !word.ends_with(',') && numbers::is_number(word);
        line.split_whitespace().nth(1).is_some() && line.split_whitespace().all(number)
    };
    if share(sample, |line| line.contains(',')) > 0.5 && share(sample, decimal) <= 0.5 {
        return (Separator::One(','), Vec::new());
    }
    // Blanks separate nothing in lines of one cell: those of a header `T (s)` belong to its name.
    if share(sample, |line| line.split_whitespace().nth(1).is_none()) == 1.0 {
        return (Separator::One(';'), Vec::new());
    }
    (Separator::Blanks, Vec::new())
}

fn share(sample: &[&str], holds: impl Fn(&str) -> bool) -> f64 {
    sample.iter().filter(|line| holds(line)).count() as f64 / sample.len().max(1) as f64
}

fn is_vector_mark(each: char) -> bool {
    matches!(each, '(' | ')' | '[' | ']' | ';' | ',' | '"' | ' ' | '\t')
}

/// `14:03:07.150 -> `: where it ends.
fn clock_end(line: &str) -> Option<usize> {
    let (clock, _) = line.split_once("->")?;
    let digits = || clock.trim().split([':', '.', ',']);
    let whole = digits().all(|part| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit()));
    (whole && clock.contains(':') && digits().count() >= 3).then_some(clock.len() + 2)
}

fn without_clock(line: &str) -> &str {
    clock_end(line).map_or(line, |end| &line[end..]).trim()
}

/// The pairs of a line such as `t=100 ax=-18` or `theta:12.3,omega:4`; no pair if anything else is in it.
fn pairs(line: &str) -> impl Iterator<Item = (&str, &str)> {
    let parts = move || line.split([' ', '\t', ',', ';']).filter(|part| !part.is_empty());
    let good = parts().all(|part| pair(part).is_some());
    parts().filter(move |_| good).filter_map(pair)
}

fn pair(part: &str) -> Option<(&str, &str)> {
    let (name, value) = part.split_once(['=', ':'])?;
    let named = name.chars().next().is_some_and(char::is_alphabetic);
    (named && (numbers::is_number(value) || numbers::is_missing(value))).then_some((name, value))
}

/// Names for the numbers of vectors: `x`, `y` of pairs, `vector 1 x` of longer ones; a number alone has none.
fn vector_names(line: &str) -> Vec<String> {
    let mut names = Vec::new();
    let mut group = 0;
    let count = |text: &str| text.split(is_vector_mark).filter(|cell| !cell.is_empty()).count();
    for part in line.split_inclusive([')', ']']) {
        let (outside, inside) = part.split_once(['(', '[']).unwrap_or((part, ""));
        names.extend((0..count(outside)).map(|_| String::new()));
        match count(inside) {
            0 => {}
            2 => names.extend(["x".to_owned(), "y".to_owned()]),
            several => {
                group += 1;
                let axis = |k: usize| ["x", "y", "z"].get(k).map_or(k.to_string(), |axis| (*axis).to_owned());
                names.extend((0..several).map(|k| format!("vector {group} {}", axis(k))));
            }
        }
    }
    names.truncate(MOST_COLUMNS);
    names
}

/// Cells some of which are in quotes, which are taken away; a quote that does not end, ends with the line.
fn quoted_cells<'a>(line: &'a str, reader: &mut csv_core::Reader, cells: &mut Vec<Cow<'a, str>>) {
    reader.reset();
    let mut input = line.as_bytes();
    // No cell is longer than its line.
    let mut field = vec![0u8; line.len() + 1];
    while cells.len() <= MOST_COLUMNS {
        let mut length = 0;
        let last = loop {
            // An empty input tells the reader that the line ends.
            let (result, read, written) = reader.read_field(input, &mut field[length..]);
            (input, length) = (&input[read..], length + written);
            match result {
                csv_core::ReadFieldResult::InputEmpty => {}
                csv_core::ReadFieldResult::OutputFull => break true,
                csv_core::ReadFieldResult::Field { record_end } => break record_end,
                csv_core::ReadFieldResult::End => return,
            }
        };
        cells.push(Cow::Owned(String::from_utf8_lossy(&field[..length]).trim().to_owned()));
        if last {
            return;
        }
    }
}

/// Cells between blanks, some of which are in quotes and hold blanks.
fn quoted_between_blanks<'a>(line: &'a str, cells: &mut Vec<Cow<'a, str>>) {
    for (k, part) in line.split('"').enumerate() {
        if k % 2 == 1 {
            cells.push(Cow::Borrowed(part.trim()));
        } else {
            cells.extend(part.split_whitespace().map(Cow::Borrowed));
        }
        if cells.len() > MOST_COLUMNS {
            return;
        }
    }
}

//! From text to columns of numbers: title lines, the header, the line of units, the rows, headers that return.

use std::borrow::Cow;

use super::dialect::{Dialect, Separator};
use super::header::heads;
use super::heads::Head;
use super::lines::{Line, comment, line_at, lines};
use super::numbers::{self, Cell, Forms, Mark};
use super::record::{Dropped, leave_out};
use super::refusal::{Refusal, quoted};
use crate::decimal;
use crate::letters::lower;

/// Lines above the first row that may hold names and units.
const PREAMBLE: usize = 40;
/// Rows that decide how wide a row is.
const SAMPLE: usize = 200;

/// A table of numbers as the file has it.
pub(super) struct Table<'a> {
    text: &'a str,
    dialect: Dialect,
    /// One for each column.
    pub heads: Vec<Head>,
    /// Whether the file names its columns.
    pub headed: bool,
    /// The numbers, NaN where a cell has none.
    pub columns: Vec<Vec<f64>>,
    /// The line of each row.
    pub lines: Vec<u32>,
    starts: Vec<u32>,
    /// The line of each row without the lines that are no samples, and those.
    places: Vec<u32>,
    no_samples: u32,
    marks: Vec<Mark>,
    /// Rows above which the header stands again.
    pub restarts: Vec<usize>,
    /// Samples in a second that a line above the rows states.
    pub rate: Option<f64>,
    /// Whether it is a text file of Vernier's Logger Pro.
    pub vernier: bool,
    pub understood: Vec<String>,
    pub dropped: Vec<Dropped>,
}

/// Numbers, words and blanks of a line.
#[derive(Clone, Copy, Default)]
struct Count {
    numbers: usize,
    words: usize,
}

fn counted(cells: &[Cow<'_, str>]) -> Count {
    let mut count = Count::default();
    for cell in cells {
        if numbers::is_number(cell) {
            count.numbers += 1;
        } else if !numbers::is_missing(cell) {
            count.words += 1;
        }
    }
    count
}

impl<'a> Table<'a> {
    /// Reads a text.
    pub(super) fn of(text: &'a str) -> Result<Table<'a>, Refusal> {
        let dialect = Dialect::of(text)?;
        let (width, words) = usual_row(text, &dialect)?;
        let mut table = Table {
            text,
            dialect,
            heads: Vec::new(),
            headed: false,
            columns: Vec::new(),
            lines: Vec::new(),
            starts: Vec::new(),
            places: Vec::new(),
            no_samples: 0,
            marks: Vec::new(),
            restarts: Vec::new(),
            rate: None,
            vernier: text.trim_start().starts_with("Vernier Format"),
            understood: Vec::new(),
            dropped: Vec::new(),
        };
        let preamble = table.rows(width, words)?;
        if table.lines.is_empty() {
            return Err(Refusal::fault(None, "holds no row of numbers"));
        }
        let first = table.lines.iter().zip(&table.starts).take(SAMPLE);
        let first = first.map(|(line, start)| Line {
            number: *line as usize,
            start: *start as usize,
            text: line_at(text, *start as usize),
        });
        let first: Vec<Line<'_>> = first.collect();
        let named = heads(&table.dialect, &preamble, &first, width, table.vernier)?;
        table.headed = named.is_some();
        table.rate = table.rate.or_else(|| preamble.iter().find_map(|line| stated_rate(line.text)));
        table.heads = named.unwrap_or_else(|| (0..width).map(Head::numbered).collect());
        table.numbers()?;
        Ok(table)
    }

    /// Finds the rows; gives the lines above them.
    fn rows(&mut self, width: usize, words: usize) -> Result<Vec<Line<'a>>, Refusal> {
        let mut preamble: Vec<Line<'a>> = Vec::new();
        let mut header: Vec<String> = Vec::new();
        let mut cells: Vec<Cow<'a, str>> = Vec::new();
        for line in lines(self.text) {
            let comment = comment(line.text).is_some();
            if self.lines.is_empty() {
                self.dialect.cells(line, &mut cells)?;
                let count = counted(&cells);
                // A remark may stand beside the first row; a title that holds a number begins with a word.
                let remarked =
                    count.numbers > 1 && count.words <= count.numbers && numbers::is_number(&cells[0]);
                let row = !comment && count.numbers > 0 && (count.words <= words || remarked);
                if !row {
                    if self.dialect.separator == Separator::Pairs {
                        leave_out(&mut self.dropped, "no row of the table", line.number);
                    } else if preamble.len() < PREAMBLE {
                        preamble.push(line);
                    } else {
                        preamble.rotate_left(1);
                        preamble[PREAMBLE - 1] = line;
                    }
                } else if cells.len() < width && count.numbers < width {
                    if !self.states(&preamble, line) {
                        leave_out(&mut self.dropped, "cut short", line.number);
                    } else {
                        preamble.clear();
                    }
                } else if cells.len() > width && self.states(&preamble, line) {
                    preamble.clear();
                } else {
                    header = names_of(&preamble);
                    self.push(line);
                }
                continue;
            }
            if comment {
                self.no_samples += 1;
                continue;
            }
            self.dialect.cells(line, &mut cells)?;
            let count = counted(&cells);
            if count.numbers > 0 && count.words <= count.numbers.max(words) {
                let zeros = self.vernier
                    && cells.iter().all(|cell| numbers::cell(cell, Mark::Point) == Cell::Number(0.0));
                if zeros {
                    self.restarts.push(self.lines.len());
                } else {
                    self.push(line);
                }
            } else if count.numbers + count.words == 0 && cells.iter().any(|cell| !cell.is_empty()) {
                // `NaN` is a sample that is missing: where a rate stands for times it has its instant.
                self.push(line);
            } else if count.numbers + count.words == 0 {
                leave_out(&mut self.dropped, "empty", line.number);
            } else if header.contains(&line.text.trim().to_owned()) || count.words > 1 && count.words == width
            {
                if self.restarts.last() != Some(&self.lines.len()) {
                    self.restarts.push(self.lines.len());
                }
            } else {
                leave_out(&mut self.dropped, "no row of the table", line.number);
            }
        }
        self.restarts.retain(|row| *row < self.lines.len());
        Ok(preamble)
    }

    fn push(&mut self, line: Line<'a>) {
        let number = line.number as u32;
        if self.restarts.last() == Some(&self.lines.len()) {
            // The next recording begins without a gap.
            self.no_samples = number - self.places.last().map_or(0, |place| place + 1);
        }
        self.places.push(number - self.no_samples);
        self.lines.push(number);
        self.starts.push(line.start as u32);
    }

    /// Whether a line of numbers belongs to the line of names above it, not to the rows: it may state the rate.
    fn states(&mut self, preamble: &[Line<'a>], line: Line<'a>) -> bool {
        let parts = |text: &'a str| text.split([',', ';', '\t']).map(str::trim);
        let Some(above) = preamble.last() else { return false };
        if parts(above.text).count() < 2 || parts(above.text).count() != parts(line.text).count() {
            return false;
        }
        for (name, value) in parts(above.text).zip(parts(line.text)) {
            let name = lower(name);
            let rated = ["rate", "fps", "hz", "frequency"].iter().any(|word| name.contains(word));
            let number = decimal::number(value);
            if let Some(value) = number.filter(|value| rated && value.is_finite() && *value > 0.0) {
                self.rate = Some(value);
            }
        }
        true
    }

    /// Reads every cell: first how each column writes its numbers, then the numbers.
    fn numbers(&mut self) -> Result<(), Refusal> {
        let width = self.heads.len();
        // Full rows have a byte for every cell; a file of short rows under one long row is no table.
        if self.lines.len() * width > 4 * self.text.len() + (1 << 16) {
            let reason =
                format!("has {} rows for {width} columns, and most cells are missing", self.lines.len());
            return Err(Refusal::fault(None, reason));
        }
        let mut forms = vec![Forms::default(); width];
        let mut units: Vec<Option<String>> = vec![None; width];
        let mut two = None;
        self.each_row(|line, cells| {
            for (k, (form, cell)) in forms.iter_mut().zip(cells).enumerate() {
                form.count(cell, line);
                if let Some((_, unit)) = numbers::with_unit(cell) {
                    let first = units[k].get_or_insert_with(|| unit.to_owned());
                    if first != unit && two.is_none() {
                        two = Some((k, line, first.clone(), unit.to_owned()));
                    }
                }
            }
        })?;
        if let Some((k, line, first, other)) = two {
            let (name, first, other) = (quoted(&self.heads[k].written), quoted(&first), quoted(&other));
            let reason = format!("column {name} has values in {first} and in {other}; write one unit");
            return Err(Refusal::fault(Some(line as usize), reason));
        }
        for (head, unit) in self.heads.iter_mut().zip(&units) {
            if let (None, Some(unit)) = (head.unit, unit) {
                *head = head.clone().with_unit(unit);
            }
        }
        let marks: Vec<Mark> = forms.iter().map(Forms::mark).collect();
        let mut columns = vec![Vec::with_capacity(self.lines.len()); width];
        self.each_row(|_, cells| {
            for (k, column) in columns.iter_mut().enumerate() {
                column.push(match cells.get(k).map_or(Cell::Missing, |cell| numbers::cell(cell, marks[k])) {
                    Cell::Number(value) => value,
                    Cell::Missing | Cell::Text => f64::NAN,
                });
            }
        })?;
        let commas = marks.iter().filter(|mark| **mark == Mark::Comma).count();
        for (k, (form, mark)) in forms.iter().zip(&marks).enumerate() {
            let name = &self.heads[k].written;
            if let Some(line) = form.mixed() {
                let note =
                    format!("Column {} has decimal commas and decimal points (line {line}).", quoted(name));
                self.understood.push(note);
            }
            if matches!(mark, Mark::PointThousands | Mark::CommaThousands) {
                self.understood.push(format!("Column {} has thousands separators.", quoted(name)));
            } else if *mark == Mark::Comma && (commas == 1 || k == 0) {
                let which = if commas > 1 { "The file".into() } else { format!("Column {}", quoted(name)) };
                self.understood.push(format!("{which} has decimal commas."));
            }
        }
        (self.columns, self.marks) = (columns, marks);
        Ok(())
    }

    fn each_row(&self, mut take: impl FnMut(u32, &[Cow<'_, str>])) -> Result<(), Refusal> {
        let mut cells = Vec::new();
        for (start, line) in self.starts.iter().zip(&self.lines) {
            let text = line_at(self.text, *start as usize);
            self.dialect.cells(Line { number: *line as usize, start: *start as usize, text }, &mut cells)?;
            take(*line, &cells);
        }
        Ok(())
    }

    /// How many lines a sample takes where every line is one, but for remarks and headers that return: empty lines between all rows
    /// only space them.
    pub(super) fn spacing(&self) -> u32 {
        self.places.windows(2).map(|pair| pair[1] - pair[0]).min().unwrap_or(1)
    }

    /// Which sample a row is, from 0.
    pub(super) fn sample(&self, row: usize, spacing: u32) -> usize {
        ((self.places[row] - self.places[0]) / spacing) as usize
    }

    /// What separates its cells.
    pub(super) fn separator(&self) -> Separator {
        self.dialect.separator
    }

    /// A cell as written.
    pub(super) fn written(&self, row: usize, column: usize) -> String {
        let mut cells = Vec::new();
        let text = line_at(self.text, self.starts[row] as usize);
        let line = Line { number: self.lines[row] as usize, start: 0, text };
        // The line was cut before without a fault.
        let _ = self.dialect.cells(line, &mut cells);
        cells.get(column).map(|cell| cell.clone().into_owned()).unwrap_or_default()
    }

    /// The place value of the last digit of a cell.
    pub(super) fn resolution(&self, row: usize, column: usize) -> Option<f64> {
        numbers::resolution(&self.written(row, column), self.marks[column])
    }
}

/// How many cells a row has, and how many of them are words.
fn usual_row(text: &str, dialect: &Dialect) -> Result<(usize, usize), Refusal> {
    let mut seen: Vec<((usize, usize), usize)> = Vec::new();
    let mut cells = Vec::new();
    for line in lines(text).filter(|line| comment(line.text).is_none()) {
        dialect.cells(line, &mut cells)?;
        let count = counted(&cells);
        if count.numbers == 0 || count.words > count.numbers {
            continue;
        }
        let key = (cells.len(), count.words);
        match seen.iter_mut().find(|each| each.0 == key) {
            Some(each) => each.1 += 1,
            None => seen.push((key, 1)),
        }
        if seen.iter().map(|each| each.1).sum::<usize>() >= SAMPLE {
            break;
        }
    }
    // Of equally frequent ones the first.
    let most = seen.iter().map(|each| each.1).max();
    let width = seen.iter().find(|each| Some(each.1) == most).map_or(1, |each| each.0.0);
    let words = seen.iter().filter(|each| each.0.0 == width).map(|each| each.0.1).min().unwrap_or(0);
    Ok((width, words))
}

/// The rate in a line such as `sample rate: 100 Hz`: one number, beside a word that says what it is.
fn stated_rate(text: &str) -> Option<f64> {
    let lower = lower(text.get(..text.len().min(200))?);
    if !["rate", "fps", "hz"].iter().any(|word| lower.contains(word)) {
        return None;
    }
    let parts = lower.split(|each: char| !each.is_ascii_digit() && each != '.');
    let numbers: Vec<f64> = parts.filter_map(decimal::number).collect();
    match numbers[..] {
        [rate] if rate > 0.0 => Some(rate),
        _ => None,
    }
}

/// The lines above the rows, as they would stand again in the middle of the file.
fn names_of(preamble: &[Line<'_>]) -> Vec<String> {
    preamble.iter().rev().take(4).map(|line| line.text.trim().to_owned()).collect()
}

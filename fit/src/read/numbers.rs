//! Numbers as people and tools write them: decimal point or comma, thousands separators, a Fortran exponent, a true minus.

use super::units::{Dimension, unit};
use crate::decimal;

/// How the numbers of one column are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mark {
    /// `1234.5`
    Point,
    /// `1234,5`
    Comma,
    /// `1,234.5`
    PointThousands,
    /// `1.234,5`
    CommaThousands,
}

/// What a cell holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Cell {
    Number(f64),
    Missing,
    Text,
}

/// Words for a value that is not there.
const MISSING: [&str; 17] = [
    "", "nan", "-nan", "n/a", "na", "#n/a", "#nv", "#num!", "#value!", "#div/0!", "#wert!", "null", "none",
    "undefined", "-", "--", "---",
];

/// Number and unit of a cell such as `20.0 deg`.
pub(super) fn with_unit(text: &str) -> Option<(&str, &str)> {
    let bytes = text.as_bytes();
    let starts = matches!(bytes.first()?, b'0'..=b'9' | b'+' | b'-' | b'.');
    let ends = !bytes.last()?.is_ascii_digit();
    let (number, word) = text.rsplit_once(' ').filter(|_| starts && ends && text.len() < 60)?;
    let known = unit(word).is_some_and(|unit| {
        use Dimension::{Angle, AngularVelocity, Length, Time};
        matches!(unit.dimension, Angle | AngularVelocity | Length | Time)
    });
    known.then(|| (number.trim_end(), word))
}

/// Reads one cell.
pub(super) fn cell(text: &str, mark: Mark) -> Cell {
    let text = bare(text);
    let starts = text.as_bytes().first().copied().unwrap_or(b' ');
    let plain = mark == Mark::Point && matches!(starts, b'0'..=b'9' | b'+' | b'-' | b'.');
    if let (true, Some(value)) = (plain, decimal::number(text)) {
        return finite(value, text);
    }
    if text.len() < 12 && MISSING.iter().any(|word| word.eq_ignore_ascii_case(text)) {
        return Cell::Missing;
    }
    if !matches!(starts, b'0'..=b'9' | b'+' | b'-' | b'.' | b',' | 0xe2) {
        return Cell::Text;
    }
    if let Some((number, _)) = with_unit(text) {
        return cell(number, mark);
    }
    if text.len() < 40 && text.contains(':') {
        return clock(text).map_or(Cell::Text, Cell::Number);
    }
    let separator = match mark {
        Mark::PointThousands => Some(','),
        Mark::CommaThousands => Some('.'),
        _ => None,
    };
    if separator.is_some_and(|separator| !grouped_by(text, separator)) {
        return Cell::Text;
    }
    let mut plain = String::with_capacity(text.len());
    for each in text.chars() {
        match (each, mark) {
            ('.', Mark::CommaThousands) | (',', Mark::PointThousands) => {}
            (',', Mark::Comma | Mark::CommaThousands) => plain.push('.'),
            (',', Mark::Point) | ('.', Mark::Comma) => return Cell::Text,
            ('\u{2212}', _) => plain.push('-'),
            ('D' | 'd', _) => plain.push('e'),
            // A blank inside a number separates thousands only if it is one that does not break a line.
            ('\u{a0}' | '\u{202f}' | '\u{2009}' | '\'', _) => {}
            ('0'..='9' | '+' | '-' | '.' | 'e' | 'E', _) => plain.push(each),
            _ => return Cell::Text,
        }
    }
    decimal::number(&plain).map_or(Cell::Text, |value| finite(value, text))
}

/// Seconds of a clock's reading: `1:02:03.5`, `0:01:02:50` with hundredths or thousandths, `02:03.5`, with or without a date in front.
fn clock(text: &str) -> Option<f64> {
    let time = text.rsplit([' ', 'T']).next()?.trim_end_matches('Z');
    let mut seconds = 0.0;
    let mut parts = 0;
    for part in time.split(':') {
        let digits = part.bytes().all(|byte| byte.is_ascii_digit() || matches!(byte, b'.' | b','));
        let value = decimal::number(&part.replace(',', ".")).filter(|_| digits && part.len() < 20)?;
        parts += 1;
        seconds = if parts == 4 {
            seconds + value / if part.len() == 3 { 1000.0 } else { 100.0 }
        } else {
            seconds * 60.0 + value
        };
    }
    (2..=4).contains(&parts).then_some(seconds)
}

/// A value beyond the largest double is no measurement, and words such as `-inf` are no number.
fn finite(value: f64, text: &str) -> Cell {
    if value.is_finite() {
        Cell::Number(value)
    } else if text.bytes().any(|byte| byte.is_ascii_digit()) {
        Cell::Text
    } else {
        Cell::Missing
    }
}

/// Without blanks, quotes and a degree sign around it.
fn bare(text: &str) -> &str {
    let text = text.trim();
    match text.as_bytes() {
        [b'"' | b'\'', ..] => text.trim_matches(['"', '\'']).trim(),
        _ => text.strip_suffix('°').map_or(text, str::trim_end),
    }
}

/// Whether a cell is a number in any way of writing.
pub(super) fn is_number(text: &str) -> bool {
    let is = |mark| matches!(cell(text, mark), Cell::Number(_));
    is(Mark::Point)
        || text.contains([',', '.'])
            && (is(Mark::Comma) || is(Mark::PointThousands) || is(Mark::CommaThousands))
}

/// Whether a cell says that there is no value.
pub(super) fn is_missing(text: &str) -> bool {
    cell(text, Mark::Point) == Cell::Missing
}

/// What the cells of one column look like, for the choice of its [`Mark`].
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Forms {
    comma: usize,
    point: usize,
    comma_thousands: usize,
    point_thousands: usize,
    point_then_comma: usize,
    comma_then_point: usize,
    three_digits: usize,
    longer: usize,
    first_comma: u32,
}

impl Forms {
    /// Counts a cell.
    pub(super) fn count(&mut self, text: &str, line: u32) {
        let text = bare(text);
        let comma = text.find(',');
        let point = text.find('.');
        let numeric =
            text.bytes().next().is_some_and(|byte| matches!(byte, b'0'..=b'9' | b'+' | b'-' | b'.' | b','));
        match (comma, point) {
            _ if !numeric => {}
            (None, None) => match text.trim_start_matches(['+', '-']).len() {
                0..3 => {}
                3 => self.three_digits += 1,
                _ => self.longer += 1,
            },
            (Some(_), None) => {
                self.comma += 1;
                self.comma_thousands += usize::from(is_grouped(text, ','));
                if self.first_comma == 0 {
                    self.first_comma = line;
                }
            }
            (None, Some(_)) => {
                self.point += 1;
                self.point_thousands += usize::from(is_grouped(text, '.'));
            }
            (Some(comma), Some(point)) if comma < point => self.comma_then_point += 1,
            _ => self.point_then_comma += 1,
        }
    }

    /// How the column is written. A comma before three digits is a thousands separator only where numbers below a
    /// thousand have none and none is longer: `900`, then `1,000`.
    pub(super) fn mark(&self) -> Mark {
        let grouped = self.three_digits > 0 && self.longer == 0;
        if self.comma_then_point > 0 && self.comma_then_point >= self.point_then_comma {
            Mark::PointThousands
        } else if self.point_then_comma > 0 {
            Mark::CommaThousands
        } else if self.comma > 0 && self.comma == self.comma_thousands && self.point == 0 && grouped {
            Mark::PointThousands
        } else if self.point > 0 && self.point == self.point_thousands && self.comma == 0 && grouped {
            Mark::CommaThousands
        } else if self.comma > self.point {
            Mark::Comma
        } else {
            Mark::Point
        }
    }

    /// Whether decimal commas and decimal points both occur, and the line of the first comma.
    pub(super) fn mixed(&self) -> Option<usize> {
        let thousands = self.comma_then_point + self.point_then_comma > 0;
        (self.comma > 0 && self.point > 0 && !thousands).then_some(self.first_comma as usize)
    }
}

/// Whether three digits and no more follow every thousands separator.
fn grouped_by(text: &str, separator: char) -> bool {
    let digits = |group: &str| group.bytes().take_while(u8::is_ascii_digit).count();
    text.split(separator).skip(1).all(|group| digits(group) == 3)
}

/// `1,000` or `12,345,678`: groups of three digits after one to three, and no leading zero.
fn is_grouped(text: &str, separator: char) -> bool {
    let digits = text.trim_start_matches(['+', '-']);
    let mut groups = digits.split(separator);
    let first = groups.next().unwrap_or("");
    let all_digits = |group: &str| group.bytes().all(|byte| byte.is_ascii_digit());
    (1..=3).contains(&first.len())
        && !first.starts_with('0')
        && all_digits(first)
        && groups.all(|group| group.len() == 3 && all_digits(group))
}

/// The place value of the last digit of a number as written: 0.1 for `1.00E+01`.
pub(super) fn resolution(text: &str, mark: Mark) -> Option<f64> {
    let point = if matches!(mark, Mark::Comma | Mark::CommaThousands) { ',' } else { '.' };
    let text = bare(with_unit(text).map_or(text, |(number, _)| number));
    let (mantissa, exponent) = match text.find(['e', 'E', 'd', 'D']) {
        Some(at) => (&text[..at], text[at + 1..].parse::<i32>().ok()?),
        None => (text, 0),
    };
    let decimals = mantissa.split_once(point).map_or(0, |(_, decimals)| decimals.len().min(400) as i32);
    // By the decimal parser: the power of ten is then the nearest double.
    decimal::number(&format!("1e{}", exponent.clamp(-400, 400) - decimals))
}

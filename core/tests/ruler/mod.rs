//! The ruler of every accuracy test: distances from a truth stored as hi + lo, in ulps and in the unit that
//! the condition of the problem allows; and the reader of the vectors, which refuses to lose a row.

use std::collections::HashMap;

/// Rows of a test of random ones: so many, times the environment's ROWS_TIMES (`make test-rows`).
pub fn row_count(rows: u32) -> u32 {
    rows * std::env::var("ROWS_TIMES").map_or(1, |times| times.parse().expect("a whole number"))
}

/// Size of the last place of a double (the spacing above it), the smallest subnormal at and near zero.
pub fn ulp(value: f64) -> f64 {
    let value = value.abs();
    if value.is_infinite() { f64::INFINITY } else { f64::from_bits(value.to_bits() + 1) - value }
}

/// The bits of a double; any NaN is one NaN, whose sign a processor may choose.
pub fn bits(value: f64) -> u64 {
    if value.is_nan() { f64::NAN.to_bits() } else { value.to_bits() }
}

/// Whether two doubles are the same, bit for bit.
pub fn same(a: f64, b: f64) -> bool {
    bits(a) == bits(b)
}

/// |got - (hi + lo)| in units of `unit`: infinite for NaN, for a wrong infinity, for a unit of nothing.
pub fn distance(got: f64, truth: [f64; 2], unit: f64) -> f64 {
    let [hi, lo] = truth;
    if hi.is_nan() {
        return if got.is_nan() { 0.0 } else { f64::INFINITY };
    }
    if got.is_nan() || unit.is_nan() {
        return f64::INFINITY;
    }
    if hi.is_infinite() || got.is_infinite() {
        return if got == hi { 0.0 } else { f64::INFINITY };
    }
    let error = ((got - hi) - lo).abs();
    if error == 0.0 { 0.0 } else { error / unit }
}

/// The error of the first issue: ulps of max(|truth|, floor), eased by 2^-100 of the condition, at most
/// 2^-44 of the scale.
pub fn eased(got: f64, truth: [f64; 2], floor: f64, condition: f64, scale: f64) -> f64 {
    let ease = f64::min(condition * 2f64.powi(-100), scale * 2f64.powi(-44));
    distance(got, truth, ulp(f64::max(truth[0].abs(), floor)) + ease)
}

/// Largest and median of a list that is not empty.
pub fn summary(errors: &mut [f64]) -> (f64, f64) {
    assert!(!errors.is_empty());
    errors.sort_by(f64::total_cmp);
    (errors[errors.len() - 1], errors[errors.len() / 2])
}

/// One row of a vectors file, by column name.
pub struct Row<'a> {
    cells: HashMap<&'a str, &'a str>,
}

impl<'a> Row<'a> {
    /// The text of a cell.
    pub fn text(&self, column: &str) -> &'a str {
        self.cells.get(column).unwrap_or_else(|| panic!("no column {column}"))
    }
    /// The text of a cell, if there is such a column.
    pub fn get(&self, column: &str) -> Option<&'a str> {
        self.cells.get(column).copied()
    }
    /// A hexadecimal double, or inf, -inf, nan.
    pub fn hex(&self, column: &str) -> f64 {
        hex(self.text(column))
    }
    /// hi + lo.
    pub fn truth(&self, name: &str) -> [f64; 2] {
        [self.hex(&format!("{name}_hi")), self.hex(&format!("{name}_lo"))]
    }
    /// A decimal, infinite or zero where it leaves the range of doubles.
    pub fn decimal(&self, column: &str) -> f64 {
        self.text(column).parse().unwrap_or_else(|_| panic!("{column} is not a decimal"))
    }
}

/// All rows; panics if the count is not the expected one.
pub fn rows(text: &'static str, count: usize) -> Vec<Row<'static>> {
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    let header: Vec<&str> = lines.next().expect("a header").split(',').collect();
    let rows: Vec<Row> = lines
        .map(|line| {
            let cells: Vec<&str> = line.split(',').collect();
            assert_eq!(cells.len(), header.len(), "{line}");
            Row { cells: header.iter().copied().zip(cells).collect() }
        })
        .collect();
    assert_eq!(rows.len(), count, "the vectors have lost or gained rows");
    rows
}

/// C99 hexadecimal double, exactly.
pub fn hex(text: &str) -> f64 {
    let (sign, body) = match text.strip_prefix('-') {
        Some(rest) => (-1.0, rest),
        None => (1.0, text),
    };
    match body {
        "inf" => return sign * f64::INFINITY,
        "nan" => return f64::NAN,
        _ => {}
    }
    let body = body.strip_prefix("0x").unwrap_or_else(|| panic!("not a hexadecimal double: {text}"));
    let (digits, exponent) = body.split_once('p').expect("an exponent");
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let mantissa = u64::from_str_radix(&format!("{whole}{fraction}"), 16).expect("hexadecimal digits");
    let exponent = exponent.parse::<i32>().expect("a decimal exponent") - 4 * fraction.len() as i32;
    let mut value = mantissa as f64;
    let mut left = exponent;
    while left < 0 && value != 0.0 {
        let step = left.max(-500);
        value *= 2f64.powi(step);
        left -= step;
    }
    sign * value * 2f64.powi(left.max(0))
}

//! Spreadsheets as text: each sheet a table with tabs, one line for each row, so that line numbers are the sheet's.

use super::refusal::{Refusal, quoted};

/// Columns that are read of a sheet; the old format has no more.
const MOST_COLUMNS: usize = 256;
/// Rows of a sheet, by both formats' limits.
const MOST_ROWS: usize = 1 << 20;
/// Characters of a cell.
const LONGEST_CELL: usize = 200;

/// A sheet.
#[derive(Default)]
pub(super) struct Sheet {
    pub name: String,
    pub text: String,
    row: usize,
    column: usize,
}

impl Sheet {
    pub(super) fn named(name: String) -> Sheet {
        Sheet { name, ..Sheet::default() }
    }

    /// Adds a cell; cells come row by row, from left to right.
    pub(super) fn put(&mut self, row: usize, column: usize, cell: &str) -> Result<(), Refusal> {
        if row >= MOST_ROWS || column >= MOST_COLUMNS {
            let reason = format!(
                "sheet {} has a cell in row {}, column {}; at most {MOST_ROWS} rows and {MOST_COLUMNS} columns are read",
                quoted(&self.name),
                row + 1,
                column + 1
            );
            return Err(Refusal::fault(None, reason));
        }
        if row < self.row || row == self.row && column < self.column {
            let reason = format!("sheet {}: row {} is out of order", quoted(&self.name), row + 1);
            return Err(Refusal::fault(Some(row + 1), reason));
        }
        while self.row < row {
            self.text.push('\n');
            (self.row, self.column) = (self.row + 1, 0);
        }
        while self.column < column {
            self.text.push('\t');
            self.column += 1;
        }
        let breaks = |each: char| matches!(each, '\t' | '\n' | '\r' | '"') || each.is_control();
        // A shared string may stand in many cells, so a long one is cut.
        self.text.extend(cell.chars().take(LONGEST_CELL).map(|each| if breaks(each) { ' ' } else { each }));
        Ok(())
    }
}

/// A number as text that reads back to the same double.
#[cfg(feature = "xls")]
pub(super) fn number(value: f64) -> String {
    if value.is_finite() { format!("{value:?}") } else { String::new() }
}

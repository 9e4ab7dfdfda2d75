//! What is stated about a file (lines.rs).
//!
//! | name | value |
//! |---|---|
//! | `file` | its name, for messages |
//! | `column`, `unit` | `ROLE=NAME`, `ROLE=UNIT`, as on the command line; any number of them |
//! | `rate`, `run` | a number |
//! | `length` | in m, and what the fit wants beside it: a track on a short arc needs it to be read |
//!
//! Other names are for the fit.

use crate::lines::{refused, statements};
use crate::quantities::number;
use libration_fit::Options;

/// What is stated.
#[derive(Default)]
pub struct Stated {
    /// The name of the file.
    pub file: String,
    /// How it is read.
    pub reading: Options,
}

impl Stated {
    /// From its lines, or a refusal of one line.
    pub fn of(text: &str) -> Result<Stated, String> {
        let mut stated = Stated::default();
        for (name, value) in statements(text) {
            stated.add(name, value)?;
        }
        Ok(stated)
    }

    fn add(&mut self, name: &str, value: &str) -> Result<(), String> {
        let reading = &mut self.reading;
        match name {
            "file" => value.clone_into(&mut self.file),
            "column" => *reading = reading.clone().column(value).map_err(|refusal| refusal.to_string())?,
            "unit" => *reading = reading.clone().unit(value).map_err(|refusal| refusal.to_string())?,
            "rate" => reading.rate = Some(number(name, value)?),
            "run" => reading.run = Some(value.parse().map_err(|_| refused(name, value))?),
            "length" => {
                let length = value.split(' ').next().unwrap_or_default();
                reading.length = Some(number(name, length)?);
            }
            _ => {}
        }
        Ok(())
    }
}

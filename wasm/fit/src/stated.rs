//! What is stated about a file and its pendulum: lines of a name, a tab and a value.
//!
//! | name | value |
//! |---|---|
//! | `file` | its name, for messages |
//! | `column`, `unit` | `ROLE=NAME`, `ROLE=UNIT`, as on the command line; any number of them |
//! | `rate`, `run` | a number |
//! | `length`, `gravity` | value and standard uncertainty with a blank between, in m and m/s^2 |
//! | `model` | a rung of the ladder |

use libration_fit::Options;
use libration_fit::fit::{FitOptions, Measure, Model};

/// What is stated.
pub struct Stated {
    /// The name of the file.
    pub file: String,
    /// How it is read.
    pub reading: Options,
    /// What is known beside it.
    pub known: FitOptions,
}

impl Stated {
    /// From its lines, or a refusal of one line; a fit tells its steps to `told`.
    pub fn of(text: &str, told: fn(&'static str)) -> Result<Stated, String> {
        let known = FitOptions { seed: 1, told: Some(told), ..FitOptions::default() };
        let mut stated = Stated { file: String::new(), reading: Options::default(), known };
        for line in text.lines() {
            let (name, value) = line.split_once('\t').unwrap_or((line, ""));
            stated.add(name, value)?;
        }
        Ok(stated)
    }

    fn add(&mut self, name: &str, value: &str) -> Result<(), String> {
        let reading = self.reading.clone();
        match name {
            "file" => value.clone_into(&mut self.file),
            "column" => self.reading = reading.column(value).map_err(|refusal| refusal.to_string())?,
            "unit" => self.reading = reading.unit(value).map_err(|refusal| refusal.to_string())?,
            "rate" => self.reading.rate = Some(number(name, value)?),
            "run" => self.reading.run = Some(value.parse().map_err(|_| refused(name, value))?),
            "length" => {
                let length = measure(name, value)?;
                // A track on a short arc needs it to be read.
                self.reading.length = Some(length.value);
                self.known.length = Some(length);
            }
            "gravity" => self.known.gravity = Some(measure(name, value)?),
            "model" => {
                let found = Model::LADDER.into_iter().find(|model| model.name() == value);
                self.known.model = Some(found.ok_or_else(|| refused(name, value))?);
            }
            _ => return Err(refused("name", name)),
        }
        Ok(())
    }
}

fn measure(name: &str, text: &str) -> Result<Measure, String> {
    let (value, u) = text.split_once(' ').unwrap_or((text, "0"));
    Ok(Measure { value: number(name, value)?, u: number(name, u)? })
}

fn number(name: &str, text: &str) -> Result<f64, String> {
    text.parse().map_err(|_| refused(name, text))
}

fn refused(name: &str, text: &str) -> String {
    format!("{name} = {text:?}: is not understood")
}

//! What is stated about the records and their pendulum (lines.rs).
//!
//! | name | value |
//! |---|---|
//! | `file` | its name, for messages |
//! | `measured` | what the columns of a record are: `angle`, `velocity`, `acceleration` with times; `gate`, times, periods and, where they are known, times of darkness; `swings`, turning angles and periods |
//! | `beside` | nothing: the records that were given before stay, and are fitted together with this one |
//! | `length`, `gravity` | value and standard uncertainty with a blank between, in m and m/s^2; several lengths, one for each record |
//! | `part` | shape of a part of a rigid pendulum, then its mass, distance and size, each as a length is given, in kg and m |
//! | `bob`, `wire` | radius and mass of the bob; mass of the wire, in m and kg |
//! | `model` | a rung of the ladder |
//!
//! `column`, `unit`, `rate` and `run` are for the reader.

use crate::abi::steps::tell;
use crate::lines::{refused, statements};
use crate::quantities::{measure, number};
use libration::Shape;
use libration_fit::fit::{Data, FitOptions, Measure, Measured, MeasuredPart, Model};

/// What is stated.
pub struct Stated {
    /// The name of the file.
    pub file: String,
    /// What the columns of a record are.
    measured: String,
    /// Whether it is one of several.
    pub beside: bool,
    /// All lengths that are stated, in their order.
    pub lengths: Vec<Measure>,
    /// What is known beside it.
    pub known: FitOptions,
}

impl Stated {
    /// From its lines, or a refusal of one line.
    pub fn of(text: &str) -> Result<Stated, String> {
        let known = FitOptions { seed: 1, told: Some(tell), ..FitOptions::default() };
        let (file, measured, lengths) = (String::new(), String::new(), Vec::new());
        let mut stated = Stated { file, measured, beside: false, lengths, known };
        for (name, value) in statements(text) {
            stated.add(name, value)?;
        }
        Ok(stated)
    }

    /// A record of these columns.
    pub fn record(&self, columns: Vec<Vec<f64>>) -> Result<Data, String> {
        let mut columns = columns.into_iter();
        let (Some(first), Some(second), third) = (columns.next(), columns.next(), columns.next()) else {
            return Err(refused("measured", &self.measured));
        };
        let measured = match self.measured.as_str() {
            "angle" => Measured::Angle,
            "velocity" => Measured::Velocity,
            "acceleration" => Measured::Acceleration,
            "gate" => return Ok(Data::Gate { t: first, periods: second, transits: third }),
            "swings" => return Ok(Data::Table { swings: first, periods: second }),
            other => return Err(refused("measured", other)),
        };
        Ok(Data::Record { measured, t: first, values: second })
    }

    fn add(&mut self, name: &str, value: &str) -> Result<(), String> {
        match name {
            "file" => value.clone_into(&mut self.file),
            "measured" => value.clone_into(&mut self.measured),
            "beside" => self.beside = true,
            "length" => {
                let length = measure(name, value)?;
                self.known.length = Some(length);
                self.lengths.push(length);
            }
            "part" => self.known.parts.push(part(value)?),
            "bob" => {
                let [radius, mass] = numbers(name, value)?;
                self.known.corrections.radius = Some(radius);
                self.known.corrections.mass = Some(mass);
            }
            "wire" => self.known.corrections.wire = Some(number(name, value)?),
            "gravity" => self.known.gravity = Some(measure(name, value)?),
            "model" => {
                let found = Model::LADDER.into_iter().find(|model| model.name() == value);
                self.known.model = Some(found.ok_or_else(|| refused(name, value))?);
            }
            "column" | "unit" | "rate" | "run" => {}
            _ => return Err(refused("name", name)),
        }
        Ok(())
    }
}

const SHAPES: [(&str, Shape); 4] =
    [("rod", Shape::Rod), ("ball", Shape::Ball), ("disc", Shape::Disc), ("point", Shape::Point)];

fn part(text: &str) -> Result<MeasuredPart, String> {
    let (shape, rest) = text.split_once(' ').unwrap_or((text, ""));
    let shape = SHAPES.iter().find(|(name, _)| *name == shape).ok_or_else(|| refused("part", text))?.1;
    let [mass, mass_u, distance, distance_u, size, size_u] = numbers("part", rest)?;
    let of = |value, u| Measure { value, u };
    Ok(MeasuredPart {
        shape,
        mass: of(mass, mass_u),
        distance: of(distance, distance_u),
        size: of(size, size_u),
    })
}

fn numbers<const N: usize>(name: &str, text: &str) -> Result<[f64; N], String> {
    let all: Vec<f64> = text.split(' ').map(|each| number(name, each)).collect::<Result<_, _>>()?;
    all.try_into().map_err(|_| refused(name, text))
}

//! What is stated about a file and its pendulum: lines of a name, a tab and a value.
//!
//! | name | value |
//! |---|---|
//! | `file` | its name, for messages |
//! | `column`, `unit` | `ROLE=NAME`, `ROLE=UNIT`, as on the command line; any number of them |
//! | `rate`, `run` | a number |
//! | `beside` | nothing: the records that were read before stay, and are fitted together with this one |
//! | `length`, `gravity` | value and standard uncertainty with a blank between, in m and m/s^2; several lengths, one for each record |
//! | `part` | shape of a part of a rigid pendulum, then its mass, distance and size, each as a length is given, in kg and m |
//! | `bob`, `wire` | radius and mass of the bob; mass of the wire, in m and kg |
//! | `model` | a rung of the ladder |

use libration::Shape;
use libration_fit::Options;
use libration_fit::fit::{FitOptions, Measure, MeasuredPart, Model};

/// What is stated.
pub struct Stated {
    /// The name of the file.
    pub file: String,
    /// Whether it is one of several.
    pub beside: bool,
    /// How it is read.
    pub reading: Options,
    /// All lengths that are stated, in their order.
    pub lengths: Vec<Measure>,
    /// What is known beside it.
    pub known: FitOptions,
}

impl Stated {
    /// From its lines, or a refusal of one line; a fit tells its steps to `told`.
    pub fn of(text: &str, told: fn(&'static str)) -> Result<Stated, String> {
        let known = FitOptions { seed: 1, told: Some(told), ..FitOptions::default() };
        let mut stated = Stated {
            file: String::new(),
            beside: false,
            reading: Options::default(),
            lengths: Vec::new(),
            known,
        };
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
            "beside" => self.beside = true,
            "column" => self.reading = reading.column(value).map_err(|refusal| refusal.to_string())?,
            "unit" => self.reading = reading.unit(value).map_err(|refusal| refusal.to_string())?,
            "rate" => self.reading.rate = Some(number(name, value)?),
            "run" => self.reading.run = Some(value.parse().map_err(|_| refused(name, value))?),
            "length" => {
                let length = measure(name, value)?;
                // A track on a short arc needs it to be read.
                self.reading.length = Some(length.value);
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

pub(crate) fn measure(name: &str, text: &str) -> Result<Measure, String> {
    let (value, u) = text.split_once(' ').unwrap_or((text, "0"));
    Ok(Measure { value: number(name, value)?, u: number(name, u)? })
}

pub(crate) fn number(name: &str, text: &str) -> Result<f64, String> {
    text.parse().map_err(|_| refused(name, text))
}

pub(crate) fn refused(name: &str, text: &str) -> String {
    format!("{name} = {text:?}: is not understood")
}

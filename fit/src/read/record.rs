//! What a file comes to: instants and the series measured at them, in SI units, with what was guessed and left out.

/// What a series is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// The angle from the vertical, rad; its zero may be off, see [`Record::rest`].
    Angle,
    /// The angle in a unit unknown to the file (counts, pixels): only its period can be used.
    AngleUnscaled,
    /// The angular velocity, rad/s.
    Velocity,
    /// The angular acceleration, rad/s^2.
    AngularAcceleration,
    /// The acceleration along the path, m/s^2: a constant length times the angular acceleration.
    LinearAcceleration,
    /// A coordinate in the plane of the swing, m where the file says so.
    X,
    /// The other coordinate.
    Y,
    /// The time of a whole period, s.
    Period,
    /// The time for which a light gate was dark, s.
    Transit,
    /// The angle of release, rad.
    Theta0,
}

impl Quantity {
    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Quantity::Angle | Quantity::AngleUnscaled => "the angle",
            Quantity::Velocity => "the angular velocity",
            Quantity::AngularAcceleration => "the angular acceleration",
            Quantity::LinearAcceleration => "the acceleration along the path",
            Quantity::X => "the coordinate x",
            Quantity::Y => "the coordinate y",
            Quantity::Period => "the period",
            Quantity::Transit => "the time in the dark",
            Quantity::Theta0 => "the angle of release",
        }
    }
}

/// What a record is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A motion sampled in time.
    Samples,
    /// Passages through a light gate: `time` holds when it became dark.
    Gate,
    /// A table of periods against angles of release; `time` is empty.
    Swings,
}

/// One measured column.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// What it is.
    pub quantity: Quantity,
    /// Its name in the file, or its number.
    pub name: String,
    /// One value for each instant, in SI units; NaN only in tables, where the file has no value.
    pub values: Vec<f64>,
    /// The standard uncertainty that the file states for every value, in the same unit.
    pub uncertainty: Option<f64>,
}

/// The centre of the circle through the points of a track, in the unit of the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pivot {
    /// Its first coordinate.
    pub x: f64,
    /// Its second coordinate.
    pub y: f64,
    /// The radius.
    pub radius: f64,
    /// Whether the radius is in metres.
    pub metres: bool,
}

/// Rows that were left out for one reason.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Dropped {
    /// The reason, in words.
    pub reason: String,
    /// How many rows.
    pub count: usize,
    /// Their lines, from 1: the first [`Dropped::LISTED`] of them.
    pub lines: Vec<usize>,
}

impl Dropped {
    /// How many lines are listed.
    pub const LISTED: usize = 100;
}

impl core::fmt::Display for Dropped {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let rows = if self.count == 1 { "row" } else { "rows" };
        write!(f, "{} {rows}: {}", self.count, self.reason)?;
        if !self.lines.is_empty() {
            let shown: Vec<String> = self.lines.iter().take(5).map(usize::to_string).collect();
            let more = if self.count > 5 { ", ..." } else { "" };
            let word = if self.count == 1 { "line" } else { "lines" };
            write!(f, " ({word} {}{more})", shown.join(", "))?;
        }
        Ok(())
    }
}

/// What was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// What it is made of.
    pub kind: Kind,
    /// The instants in s, as the file has them: never resampled, rising but for [`Record::breaks`].
    pub time: Vec<f64>,
    /// The measured series; the first is the one to fit.
    pub series: Vec<Series>,
    /// Where the clock stepped back: the index of the first instant after the step.
    pub breaks: Vec<usize>,
    /// The angle about which the motion ends, rad, where several turning points tell.
    pub rest: Option<f64>,
    /// The pivot of a track.
    pub pivot: Option<Pivot>,
    /// The run that was read, from 1, and how many the file has.
    pub run: (usize, usize),
    /// Each guess as one sentence.
    pub understood: Vec<String>,
    /// What was left out, and why.
    pub dropped: Vec<Dropped>,
}

impl Record {
    /// The series of a quantity.
    pub fn series(&self, quantity: Quantity) -> Option<&Series> {
        self.series.iter().find(|each| each.quantity == quantity)
    }

    /// Adds a row to those left out for a reason.
    pub(super) fn drop_row(&mut self, reason: &str, line: usize) {
        leave_out(&mut self.dropped, reason, line);
    }
}

/// Adds a line to the rows left out for a reason.
pub(super) fn leave_out(dropped: &mut Vec<Dropped>, reason: &str, line: usize) {
    let place = match dropped.iter().position(|each| each.reason == reason) {
        Some(place) => place,
        None => {
            dropped.push(Dropped { reason: reason.to_owned(), count: 0, lines: Vec::new() });
            dropped.len() - 1
        }
    };
    dropped[place].count += 1;
    if dropped[place].lines.len() < Dropped::LISTED {
        dropped[place].lines.push(line);
    }
}

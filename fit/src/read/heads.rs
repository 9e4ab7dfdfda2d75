//! The head of a column: `Time (s)`, `Winkel / rad`, `angulo_rad`, `Data Set 1:Angle(rad)`, `Angle (rad) Run #1` taken
//! apart into name, unit and run.

use super::names::{Meaning, meaning, words};
use super::units::{Dimension, Unit, unit};

/// Brackets of a cell that are looked into.
const MOST_MARKS: usize = 32;
const LONGEST_UNIT: usize = 42;

/// What the head of a column says.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Head {
    /// As the file has it; the number of the column where it has none.
    pub written: String,
    /// Without unit and run.
    pub name: String,
    /// The unit.
    pub unit: Option<Unit>,
    /// What stands where a unit would, and is none that is known.
    pub unknown_unit: Option<String>,
    /// The run that the column belongs to.
    pub run: Option<String>,
    /// What the name says.
    pub meaning: Option<Meaning>,
}

impl Head {
    /// The head that a cell holds.
    pub(super) fn of(cell: &str) -> Head {
        let written = cell.trim().trim_start_matches('#').trim().to_owned();
        let (rest, run) = without_run(&written);
        let (name, unit, unknown_unit) = without_unit(&rest);
        let said = meaning(&name).or_else(|| suffix(&name).and_then(|(stem, _)| meaning(stem)));
        Head { meaning: by_unit(said, unit, &name), written, name, unit, unknown_unit, run }
    }

    /// The head of a column that has none.
    pub(super) fn numbered(k: usize) -> Head {
        Head { written: (k + 1).to_string(), ..Head::default() }
    }

    /// Takes the unit that stands in a line of units.
    pub(super) fn with_unit(mut self, cell: &str) -> Head {
        let inner = cell.trim().trim_start_matches('#').trim();
        let inner = inner.trim_start_matches(['[', '(']).trim_end_matches([']', ')']);
        if let Some(found) = unit(inner) {
            self.unit = Some(found);
            self.meaning = by_unit(self.meaning, self.unit, &self.name);
        }
        self
    }
}

/// `theta1`, `Pos A`: the stem, and the number or letter that tells channels apart.
pub(super) fn suffix(name: &str) -> Option<(&str, &str)> {
    let stem = name.trim_end_matches(|each: char| each.is_ascii_digit());
    if stem.len() < name.len() && !stem.is_empty() {
        return Some((stem.trim_end_matches([' ', '_', '#', '-', '.']), &name[stem.len()..]));
    }
    let (stem, letter) = name.rsplit_once([' ', '_'])?;
    let mut letters = letter.chars();
    let single = letters.next().is_some_and(char::is_alphabetic) && letters.next().is_none();
    (single && !stem.trim().is_empty()).then_some((stem.trim_end(), letter))
}

/// Whether the cells of a line are units and nothing else.
pub(super) fn are_units<S: AsRef<str>>(cells: &[S]) -> bool {
    let mut found = 0;
    for cell in cells {
        let cell = cell.as_ref().trim().trim_start_matches('#').trim();
        let inner = cell.trim_start_matches(['[', '(']).trim_end_matches([']', ')']);
        if inner.is_empty() || inner == "-" {
            continue;
        }
        if unit(inner).is_none() {
            return false;
        }
        found += 1;
    }
    found > 0
}

/// The meaning, where the unit knows better than the name: the unit decides what a column is.
fn by_unit(said: Option<Meaning>, unit: Option<Unit>, name: &str) -> Option<Meaning> {
    use Meaning::*;
    if let Some(Uncertainty | Absolute | Computed | Label | Index | State) = said {
        return said;
    }
    match unit.map(|unit| unit.dimension) {
        Some(Dimension::Time) if matches!(said, Some(Period | Transit)) => said,
        Some(Dimension::Time) => Some(Time),
        Some(Dimension::Angle) => Some(Angle),
        Some(Dimension::AngularVelocity) => Some(Velocity),
        Some(Dimension::AngularAcceleration) => Some(AngularAcceleration),
        Some(Dimension::LinearAcceleration) => Some(LinearAcceleration),
        Some(Dimension::Length) if matches!(said, Some(X | Y)) => said,
        Some(Dimension::Length) if words(name).ends_with(" x") => Some(X),
        Some(Dimension::Length) if words(name).ends_with(" y") => Some(Y),
        Some(Dimension::Length | Dimension::Other) => Some(Other),
        Some(Dimension::Arbitrary) | None => said,
    }
}

/// `Data Set 1:Time`, `Latest: Time`, `Time Run #1`, `Angle, Run 1`: the name without the run.
fn without_run(written: &str) -> (String, Option<String>) {
    const RUNS: [&str; 9] =
        ["data set", "dataset", "run", "latest", "lauf", "messung", "durchgang", "ensemble", "datensatz"];
    if let Some((run, name)) = written.split_once(':') {
        let plain = words(run);
        if RUNS.iter().any(|each| plain.starts_with(each)) && !name.trim().is_empty() {
            return (name.trim().to_owned(), Some(plain));
        }
    }
    let lower = written.to_ascii_lowercase();
    for word in ["run #", "run#", "run ", "lauf #", "lauf "] {
        if let Some(at) = lower.rfind(word).filter(|at| *at > 0) {
            let (name, run) = (&written[..at], &written[at..]);
            let rest = run[word.len()..].trim_start();
            let after = rest.trim_start_matches(|each: char| each.is_ascii_digit());
            let digits = &rest[..rest.len() - after.len()];
            // A unit may follow: `Angle, Run #1 (rad)`.
            if !digits.is_empty() && (after.is_empty() || after.starts_with([' ', '('])) {
                let name = name.trim_end_matches([' ', ',', ';', '-', '_']);
                return (format!("{name} {}", after.trim()).trim().to_owned(), Some(format!("run {digits}")));
            }
        }
    }
    (written.to_owned(), None)
}

/// Name, unit, and what stands where the unit would.
fn without_unit(text: &str) -> (String, Option<Unit>, Option<String>) {
    let mut unknown = None;
    // Brackets: the first pair that holds a unit.
    for (at, opening) in text.match_indices(['(', '[']).take(MOST_MARKS) {
        let closing = if opening == "(" { ')' } else { ']' };
        let Some(length) = text[at + 1..].find(closing) else { continue };
        let inner = &text[at + 1..at + 1 + length];
        let before = text[..at].trim().trim_end_matches('/').trim_end();
        if let Some(found) = unit(inner) {
            return (before.to_owned(), Some(found), None);
        }
        if unknown.is_none()
            && !inner.contains(' ')
            && inner.chars().count() <= 12
            && !inner.trim().is_empty()
        {
            unknown = Some((before.to_owned(), inner.to_owned()));
        }
    }
    // No unit is longer, so that the work grows with the length and not with its square.
    let near_the_end = |at: &usize| text.len() - at <= LONGEST_UNIT;
    for at in text.match_indices('/').map(|each| each.0).filter(near_the_end) {
        if let Some(found) = unit(&text[at + 1..]) {
            return (text[..at].trim().to_owned(), Some(found), None);
        }
    }
    for (at, word) in text.match_indices(" in ").take(MOST_MARKS) {
        let suffix = text[at + word.len()..].split(' ').next().unwrap_or("");
        if let Some(found) = unit(suffix) {
            return (text[..at].trim().to_owned(), Some(found), None);
        }
    }
    for (at, mark) in text.match_indices([' ', '_']).filter(|each| near_the_end(&each.0)) {
        let (name, suffix) = (text[..at].trim(), &text[at + 1..]);
        // A single letter behind a name tells columns apart: `Pos A`, `theta_r`; only s and m are units there.
        let letter = suffix.chars().count() == 1;
        let counted = !letter || matches!(suffix, "s" | "°") || suffix == "m" && mark == "_";
        if let Some(found) = unit(suffix).filter(|_| counted && !name.is_empty()) {
            return (name.to_owned(), Some(found), None);
        }
    }
    // The unit alone is the name: `ms`, `deg`.
    if let Some(found) =
        unit(text).filter(|found| matches!(found.dimension, Dimension::Time | Dimension::Angle))
    {
        return (text.to_owned(), Some(found), None);
    }
    match unknown {
        Some((name, text)) => (name, None, Some(text)),
        None => (text.to_owned(), None, None),
    }
}

//! What is known of a formula before it is asked anything, and how it is found by its name.

use crate::domain::Domain;

/// A formula of the registry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry {
    /// Its name, without `:N`.
    pub name: &'static str,
    /// The least and the largest N, if it takes one.
    pub orders: Option<[u32; 2]>,
    /// The formula, in one line.
    pub formula: &'static str,
    /// Author, year and equation.
    pub source: &'static str,
    /// The range that the author offers it for, in words; empty where none is stated.
    pub stated: &'static str,
    /// The same as turning angles in rad.
    pub stated_range: Option<[f64; 2]>,
    /// Where it has no value.
    pub undefined: &'static str,
}

/// An entry and the N that it is asked for; 0 where it takes none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Named {
    /// The entry.
    pub entry: &'static Entry,
    /// N.
    pub order: u32,
}

impl Entry {
    /// `name` or `name:N`: how it is asked for.
    pub fn pattern(&self) -> String {
        if self.orders.is_some() { format!("{}:N", self.name) } else { self.name.to_string() }
    }

    /// What may be asked for, with the range of N.
    fn allowed(&self) -> String {
        match self.orders {
            Some([least, most]) => format!("{}:N with a whole N from {least} to {most}", self.name),
            None => format!("{} without a number", self.name),
        }
    }
}

impl Named {
    /// Finds `name` or `name:N` in a table; the error names the nearest entries first.
    pub fn find(kind: &'static str, table: &'static [Entry], wanted: &str) -> Result<Named, Domain> {
        let (name, order) = match wanted.split_once(':') {
            Some((name, order)) => (name, Some(order)),
            None => (wanted, None),
        };
        let Some(entry) = table.iter().find(|entry| entry.name == name) else {
            return Err(Domain::new(kind, shown(wanted), format!("one of {}", by_nearness(table, name))));
        };
        let order = match (entry.orders, order) {
            (None, None) => Some(0),
            (Some(range), Some(order)) => whole(order).filter(|n| (range[0]..=range[1]).contains(n)),
            _ => None,
        };
        match order {
            Some(order) => Ok(Named { entry, order }),
            None => Err(Domain::new(kind, shown(wanted), entry.allowed())),
        }
    }

    /// The name that finds it again.
    pub fn name(&self) -> String {
        let Entry { name, orders, .. } = self.entry;
        if orders.is_some() { format!("{name}:{}", self.order) } else { name.to_string() }
    }
}

/// Digits only, without a sign; what is too long for the type is out of every range.
fn whole(text: &str) -> Option<u32> {
    let digits = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    digits.then(|| text.parse().unwrap_or(u32::MAX))
}

/// What was asked for, kept to one short line.
fn shown(wanted: &str) -> String {
    let short: String = wanted.chars().take(60).collect();
    if short.len() < wanted.len() { format!("{short:?}...") } else { format!("{short:?}") }
}

/// Every name of a table, those that differ least from a wanted one first.
fn by_nearness(table: &[Entry], wanted: &str) -> String {
    let wanted: Vec<char> = wanted.chars().take(60).flat_map(char::to_lowercase).collect();
    let mut entries: Vec<&Entry> = table.iter().collect();
    entries.sort_by_key(|entry| edits(&entry.name.chars().collect::<Vec<_>>(), &wanted));
    entries.iter().map(|entry| entry.pattern()).collect::<Vec<_>>().join(", ")
}

/// How many letters must be put in, left out or changed (Levenshtein).
fn edits(from: &[char], to: &[char]) -> usize {
    let mut row: Vec<usize> = (0..=to.len()).collect();
    for (i, a) in from.iter().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, b) in to.iter().enumerate() {
            let changed = diagonal + usize::from(a != b);
            diagonal = row[j + 1];
            row[j + 1] = changed.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[to.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn entry(name: &'static str, orders: Option<[u32; 2]>) -> Entry {
        Entry { name, orders, formula: "", source: "", stated: "", stated_range: None, undefined: "" }
    }

    static TABLE: [Entry; 3] =
        [entry("linear", None), entry("fourier", Some([1, 500])), entry("fourier-theta", Some([1, 500]))];

    fn refused(wanted: &str) -> String {
        Named::find("formula", &TABLE, wanted).map_or_else(|error| error.to_string(), |named| named.name())
    }

    #[test]
    fn a_name_is_found_with_its_number() {
        for name in ["linear", "fourier:1", "fourier-theta:500"] {
            assert_eq!(refused(name), name);
        }
        assert_eq!(refused("fourier:007"), "fourier:7");
    }

    #[test]
    fn a_number_out_of_range_and_a_number_too_many_say_what_is_allowed() {
        let allowed = "must be fourier:N with a whole N from 1 to 500";
        for bad in [
            "fourier:0",
            "fourier:1000000",
            "fourier:99999999999999999999",
            "fourier",
            "fourier:",
            "fourier:-1",
        ] {
            assert_eq!(refused(bad), format!("formula = {bad:?}: {allowed}"));
        }
        assert_eq!(refused("linear:3"), "formula = \"linear:3\": must be linear without a number");
    }

    #[test]
    fn an_unknown_name_is_answered_with_the_nearest_first() {
        let nearest = "must be one of fourier:N, linear, fourier-theta:N";
        assert_eq!(refused("fourrier:4"), format!("formula = \"fourrier:4\": {nearest}"));
        assert_eq!(
            refused("Linear"),
            "formula = \"Linear\": must be one of linear, fourier:N, fourier-theta:N"
        );
        assert_eq!(refused("").matches('\n').count(), 0);
    }
}

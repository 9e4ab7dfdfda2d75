//! What is known of a formula before it is asked anything, and how it is found by its name.

use crate::domain::Domain;
use crate::lanes::COMPACT;
use crate::sorting::sort;

/// A formula of the registry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry {
    /// Its name, without `:N`.
    pub name: &'static str,
    /// What N may be, if it takes one.
    pub orders: Option<Orders>,
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

/// The numbers from the least to the most, or every second one of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orders {
    /// The least.
    pub least: u32,
    /// The most.
    pub most: u32,
    /// 1, or 2: all are even or all odd, as the least is.
    pub step: u32,
}

impl Orders {
    /// Every N of a range.
    pub const fn all([least, most]: [u32; 2]) -> Orders {
        Orders { least, most, step: 1 }
    }

    /// Every second N of a range.
    pub const fn every_second([least, most]: [u32; 2]) -> Orders {
        Orders { least, most, step: 2 }
    }

    fn in_range(&self, n: u32) -> bool {
        (self.least..=self.most).contains(&n)
    }

    fn contains(&self, n: u32) -> bool {
        self.in_range(n) && (n - self.least).is_multiple_of(self.step)
    }

    /// What is wanted of a number that is not one of them: to be in the range first, then of its parity.
    fn allowed(&self, n: Option<u32>) -> String {
        let parity = match (n.is_some_and(|n| self.in_range(n)), self.least % 2) {
            (false, _) => "a whole",
            (true, 0) => "an even",
            (true, _) => "an odd",
        };
        format!("{parity} N from {} to {}", self.least, self.most)
    }
}

/// An entry and what it is evaluated by, in one row, so that neither comes without the other.
pub(super) struct Row<R> {
    pub entry: Entry,
    pub rule: R,
}

/// A row of a table.
pub(super) const fn row<R>(entry: Entry, rule: R) -> Row<R> {
    Row { entry, rule }
}

/// What the bindings list of a table, N being its length.
pub(super) const fn entries<R, const N: usize>(table: &[Row<R>]) -> [Entry; N] {
    let mut entries = [table[0].entry; N];
    let mut i = 1;
    while i < N {
        entries[i] = table[i].entry;
        i += 1;
    }
    entries
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
    /// A formula that takes no N, has a value everywhere, and whose author states no range.
    pub(super) const fn new(name: &'static str, formula: &'static str, source: &'static str) -> Entry {
        Entry { name, orders: None, formula, source, stated: "", stated_range: None, undefined: "" }
    }
    /// With the N that it takes.
    pub(super) const fn of_order(self, orders: Orders) -> Entry {
        Entry { orders: Some(orders), ..self }
    }
    /// With the range that its author states.
    pub(super) const fn for_range(self, stated: &'static str, range: [f64; 2]) -> Entry {
        Entry { stated, stated_range: Some(range), ..self }
    }
    /// With where it has no value.
    pub(super) const fn but_for(self, undefined: &'static str) -> Entry {
        Entry { undefined, ..self }
    }

    /// `name` or `name:N`: how it is asked for.
    pub fn pattern(&self) -> String {
        if self.orders.is_some() { format!("{}:N", self.name) } else { self.name.to_string() }
    }

    /// What may be asked for in place of a wrong N.
    fn allowed(&self, n: Option<u32>) -> String {
        match self.orders {
            Some(orders) => format!("{}:N with {}", self.name, orders.allowed(n)),
            None => format!("{} without a number", self.name),
        }
    }
}

impl Named {
    /// Finds `name` or `name:N` in a table, and its rule; the error names the nearest entries first.
    pub(super) fn find<R>(
        kind: &'static str,
        table: &'static [Row<R>],
        wanted: &str,
    ) -> Result<(Named, &'static R), Domain> {
        let (name, order) = match wanted.split_once(':') {
            Some((name, order)) => (name, Some(order)),
            None => (wanted, None),
        };
        let Some(Row { entry, rule }) = table.iter().find(|row| row.entry.name == name) else {
            return Err(Domain::new(
                kind,
                shown(wanted),
                format!("one of {}", by_nearness(table.iter().map(|row| &row.entry).collect(), name)),
            ));
        };
        let n = order.and_then(whole);
        match (entry.orders, order, n) {
            (None, None, _) => Ok((Named { entry, order: 0 }, rule)),
            (Some(orders), _, Some(n)) if orders.contains(n) => Ok((Named { entry, order: n }, rule)),
            _ => Err(Domain::new(kind, shown(wanted), entry.allowed(n))),
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
    // The tables of what is printable are 4 kB; a page loads none.
    let quoted =
        if COMPACT { format!("\"{}\"", short.replace(char::is_control, " ")) } else { format!("{short:?}") };
    if short.len() < wanted.len() { quoted + "..." } else { quoted }
}

/// Every name of some entries, those that differ least from a wanted one first.
fn by_nearness(mut entries: Vec<&Entry>, wanted: &str) -> String {
    let wanted: Vec<char> = wanted.chars().take(60).map(|letter| letter.to_ascii_lowercase()).collect();
    let distance = |entry: &Entry| edits(&entry.name.chars().collect::<Vec<_>>(), &wanted);
    sort(&mut entries, |a, b| distance(a).cmp(&distance(b)));
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

    const fn entry(name: &'static str) -> Entry {
        Entry::new(name, "", "")
    }

    static TABLE: [Row<()>; 3] = [
        row(entry("linear"), ()),
        row(entry("fourier").of_order(Orders::all([1, 500])), ()),
        row(entry("fourier-theta").of_order(Orders::all([1, 500])), ()),
    ];
    static ODD: [Row<()>; 1] = [row(entry("odd").of_order(Orders::every_second([3, 9])), ())];

    fn refused(wanted: &str) -> String {
        Named::find("formula", &TABLE, wanted)
            .map_or_else(|error| error.to_string(), |(named, ())| named.name())
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
        let odd = |wanted| Named::find("formula", &ODD, wanted).map_err(|error| error.to_string());
        assert_eq!(odd("odd:9").map(|(named, ())| named.order), Ok(9));
        assert_eq!(odd("odd:4").unwrap_err(), "formula = \"odd:4\": must be odd:N with an odd N from 3 to 9");
        assert_eq!(
            odd("odd:2").unwrap_err(),
            "formula = \"odd:2\": must be odd:N with a whole N from 3 to 9"
        );
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

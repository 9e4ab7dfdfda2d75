//! Runs and channels that stand side by side: the columns of each, with those that all share.

use super::heads::{Head, suffix};
use super::names::{Meaning, words};
use crate::order::in_order;

/// The columns of one run.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Group {
    pub name: String,
    pub columns: Vec<usize>,
}

/// The groups of a table; one without a name where nothing stands side by side.
pub(super) fn groups(heads: &[Head]) -> Vec<Group> {
    let clocks: Vec<usize> = (0..heads.len()).filter(|k| heads[*k].meaning == Some(Meaning::Time)).collect();
    let mut keys: Vec<Option<String>> = heads.iter().map(|head| head.run.clone()).collect();
    if keys.iter().all(Option::is_none) {
        keys = by_suffix(heads, &clocks).or_else(|| by_repetition(heads)).unwrap_or(keys);
    }
    let mut groups: Vec<Group> = Vec::new();
    for key in keys.iter().flatten() {
        // The heads are at most a few thousand, and so are their groups.
        if !groups.iter().any(|group| group.name == *key) {
            let columns =
                (0..heads.len()).filter(|k| keys[*k].as_ref().is_none_or(|each| each == key)).collect();
            groups.push(Group { name: key.clone(), columns });
        }
        if groups.len() > 256 {
            break;
        }
    }
    if groups.is_empty() {
        groups.push(Group { name: String::new(), columns: (0..heads.len()).collect() });
    }
    groups
}

/// `t1;theta1;t2;theta2`, `Time A, Pos A, Time B, Pos B`: several clocks, each with a suffix.
fn by_suffix(heads: &[Head], clocks: &[usize]) -> Option<Vec<Option<String>>> {
    let key = |k: usize| suffix(&heads[k].name).map_or(String::new(), |(_, key)| key.to_owned());
    let mut seen = Vec::new();
    for clock in clocks {
        let key = key(*clock);
        if seen.contains(&key) {
            return None;
        }
        seen.push(key);
    }
    let found = |k: usize| Some(key(k)).filter(|key| seen.contains(key));
    (seen.len() > 1).then(|| (0..heads.len()).map(found).collect())
}

/// `Time, Angle, Time, Angle` or `t, x, y, x, y`: the k-th column of a name belongs to the k-th run.
fn by_repetition(heads: &[Head]) -> Option<Vec<Option<String>>> {
    // A period T beside times t repeats nothing.
    let period = |head: &Head| head.name == "T" && head.meaning == Some(Meaning::Period);
    let name = |head: &Head| if period(head) { "T".into() } else { words(&head.written) };
    let names: Vec<String> = heads.iter().map(name).collect();
    let meant = |k: usize| {
        heads[k].meaning.is_some_and(|meaning| !matches!(meaning, Meaning::Uncertainty | Meaning::Index))
    };
    // Columns of one name side by side, in their order: which of them a column is, and how many there are.
    let order = in_order(names.len(), &|a, b| names[a].cmp(&names[b]));
    let (mut place, mut counts) = (vec![0; names.len()], vec![0; names.len()]);
    for alike in order.chunk_by(|a, b| names[*a] == names[*b]) {
        let mut count = 0;
        for k in alike {
            count += usize::from(meant(*k));
            place[*k] = count;
        }
        alike.iter().for_each(|k| counts[*k] = count);
    }
    let repeated = |k: usize| meant(k) && !names[k].is_empty() && counts[k] > 1;
    let several = (0..heads.len()).any(repeated);
    several.then(|| (0..heads.len()).map(|k| repeated(k).then(|| place[k].to_string())).collect())
}

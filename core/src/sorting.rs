//! Stable sorts: those of the standard library, and on a page, which loads what is compiled, one that is a tenth as long.

use crate::lanes::COMPACT;
use core::cmp::Ordering;

/// Sorts; equal items stay in their order.
pub(crate) fn sort<T: Copy>(items: &mut [T], order: impl Fn(&T, &T) -> Ordering) {
    if COMPACT { merge(items, order) } else { items.sort_by(order) }
}

/// Numbers, rising.
pub(crate) fn sort_numbers(numbers: &mut [f64]) {
    sort(numbers, f64::total_cmp);
}

/// By merging runs of twice the length each time.
fn merge<T: Copy>(items: &mut [T], order: impl Fn(&T, &T) -> Ordering) {
    let mut merged = Vec::with_capacity(items.len());
    let mut run = 1;
    while run < items.len() {
        for pair in items.chunks(2 * run) {
            let (mut left, mut right) = pair.split_at(run.min(pair.len()));
            while let Some(first) = left.first().or(right.first()) {
                let second = right.first().filter(|second| left.is_empty() || order(first, second).is_gt());
                merged.push(*second.unwrap_or(first));
                let from = if second.is_some() { &mut right } else { &mut left };
                *from = &from[1..];
            }
        }
        items.copy_from_slice(&merged);
        merged.clear();
        run *= 2;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn merging_is_the_stable_sort() {
        for count in 0..70 {
            // Each key comes several times, so the second number shows the order of equal ones.
            let items: Vec<(u32, u32)> = (0..count).map(|i| (i * 37 % 11, i)).collect();
            let (mut merged, mut sorted) = (items.clone(), items);
            merge(&mut merged, |a, b| a.0.cmp(&b.0));
            sorted.sort_by_key(|item| item.0);
            assert_eq!(merged, sorted);
        }
    }
}

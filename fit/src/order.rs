//! Order among things, compiled once for all of them: the standard library compiles its sorts for every type, some 4 kB each, and a page
//! loads what is compiled. There numbers have a short code of their own, elsewhere the standard library's.

use core::cmp::Ordering;

/// What a page loads is short.
const COMPACT: bool = cfg!(target_arch = "wasm32");

/// The numbers of `count` things in their order; equal ones stay in that of their numbers.
pub(crate) fn in_order(count: usize, compare: &dyn Fn(usize, usize) -> Ordering) -> Vec<usize> {
    if COMPACT {
        return merged(count, compare);
    }
    let mut numbers: Vec<usize> = (0..count).collect();
    numbers.sort_by(|a, b| compare(*a, *b));
    numbers
}

/// By merging runs of twice the length each time.
fn merged(count: usize, compare: &dyn Fn(usize, usize) -> Ordering) -> Vec<usize> {
    let mut numbers: Vec<usize> = (0..count).collect();
    let mut run = 1;
    while run < count {
        let mut merged = Vec::with_capacity(count);
        for pair in numbers.chunks(2 * run) {
            let (mut left, mut right) = pair.split_at(run.min(pair.len()));
            while let Some(first) = left.first().or(right.first()) {
                let second = right.first().filter(|b| left.is_empty() || compare(*first, **b).is_gt());
                merged.push(*second.unwrap_or(first));
                let from = if second.is_some() { &mut right } else { &mut left };
                *from = &from[1..];
            }
        }
        numbers = merged;
        run *= 2;
    }
    numbers
}

/// Things in their order; equal ones stay in the one that they are in.
pub(crate) fn sorted<T: Clone>(items: &[T], compare: impl Fn(&T, &T) -> Ordering) -> Vec<T> {
    let order = in_order(items.len(), &|a, b| compare(&items[a], &items[b]));
    order.into_iter().map(|number| items[number].clone()).collect()
}

/// The number that is at a place when they rise; they change places. NaN where there is no such place.
pub(crate) fn ranked(numbers: &mut [f64], place: usize) -> f64 {
    if place >= numbers.len() {
        return f64::NAN;
    }
    if COMPACT { drawn(numbers, place) } else { *numbers.select_nth_unstable_by(place, f64::total_cmp).1 }
}

/// By drawn numbers, which part the others, so that no order of them is a slow one.
fn drawn(numbers: &mut [f64], place: usize) -> f64 {
    let mut drawn = 0u64;
    let (mut low, mut high) = (0, numbers.len());
    while high - low > 1 {
        drawn = drawn.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        let middle = numbers[low + (drawn >> 33) as usize % (high - low)];
        let (mut less, mut greater, mut i) = (low, high, low);
        while i < greater {
            match numbers[i].total_cmp(&middle) {
                Ordering::Less => {
                    numbers.swap(less, i);
                    less += 1;
                    i += 1;
                }
                Ordering::Equal => i += 1,
                Ordering::Greater => {
                    greater -= 1;
                    numbers.swap(i, greater);
                }
            }
        }
        if place < less {
            high = less;
        } else if place >= greater {
            low = greater;
        } else {
            return middle;
        }
    }
    numbers[low]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_things_stay_in_their_order_and_ranks_are_those_of_sorted_numbers() {
        for count in 0..70u32 {
            // Each key comes several times, so the second number shows the order of equal ones.
            let items: Vec<(u32, u32)> = (0..count).map(|i| (i * 37 % 11, i)).collect();
            let mut wanted = items.clone();
            wanted.sort_by_key(|item| item.0);
            assert_eq!(sorted(&items, |a, b| a.0.cmp(&b.0)), wanted);
            assert_eq!(
                merged(items.len(), &|a, b| items[a].0.cmp(&items[b].0)),
                in_order(items.len(), &|a, b| { items[a].0.cmp(&items[b].0) })
            );
            let numbers: Vec<f64> = items.iter().map(|item| f64::from(item.0) - 4.5).collect();
            for (place, key) in wanted.iter().enumerate() {
                let of = |ranked: fn(&mut [f64], usize) -> f64| ranked(&mut numbers.clone(), place);
                assert_eq!([of(ranked), of(drawn)], [f64::from(key.0) - 4.5; 2]);
            }
            assert!(ranked(&mut numbers.clone(), items.len()).is_nan());
        }
    }
}

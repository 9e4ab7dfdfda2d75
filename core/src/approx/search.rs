//! Where a condition ends and where a function is largest, to the last double.

/// The last double at which a condition holds, on the way from where it does to where it does not.
pub(super) fn crossing(holds: impl Fn(f64) -> bool, inside: f64, outside: f64) -> f64 {
    let (mut inside, mut outside) = (inside, outside);
    // Each step halves the distance: from the largest double to the least there are 2098.
    for _ in 0..2100 {
        let middle = inside + 0.5 * (outside - inside);
        if middle == inside || middle == outside {
            break;
        }
        *(if holds(middle) { &mut inside } else { &mut outside }) = middle;
    }
    inside
}

/// The intervals where a condition holds that changes at most once between two rising points; from the first of `ends` where
/// it holds at the first point, and to the last where it holds at the last one.
pub(super) fn intervals(
    points: impl IntoIterator<Item = f64>,
    [first, last]: [f64; 2],
    holds: impl Fn(f64) -> bool,
) -> Vec<[f64; 2]> {
    let mut found = Vec::new();
    let mut open = None;
    let mut before = None;
    for point in points {
        match (open, holds(point)) {
            (None, true) => open = Some(before.map_or(first, |before| crossing(&holds, point, before))),
            (Some(from), false) => {
                found.push([from, crossing(&holds, before.unwrap_or(first), point)]);
                open = None;
            }
            _ => {}
        }
        before = Some(point);
    }
    found.extend(open.map(|from| [from, last]));
    found
}

/// Where a function with one maximum in [low, high] is largest, for functions known beyond the digits of a double, whose
/// maxima are wanted as places to the last one; [`maximum`] asks a function of doubles a third as often. The function's last digits decide how near: with
/// twice the digits of a double it is the double.
pub(super) fn peak<V: PartialOrd>(value: impl Fn(f64) -> V, low: f64, high: f64) -> f64 {
    /// Of the interval, on either side of a pair in its middle: each step leaves 0.55 of it.
    const PART: f64 = 0.45;
    let (mut low, mut high) = (low, high);
    // 0.55^70 < 2^-60.
    for _ in 0..70 {
        let step = PART * (high - low);
        let (left, right) = (low + step, high - step);
        if left >= right {
            break;
        }
        if value(left) < value(right) {
            low = left;
        } else {
            high = right;
        }
    }
    0.5 * (low + high)
}

/// A place and a value.
pub(super) type Point = (f64, f64);

/// 0.618^40 of the bracket: in doubles the top is flat there.
const SECTIONS: usize = 40;
const GOLDEN: f64 = 0.618_033_988_749_894_8;

/// The largest value between three points whose middle one is not the smallest, by golden sections; or one of the points.
pub(super) fn maximum(&[low, here, high]: &[Point; 3], value: impl Fn(f64) -> f64) -> Point {
    let (mut a, mut b) = (low.0, high.0);
    let mut best =
        [low, here, high].into_iter().fold(here, |best, each| if each.1 > best.1 { each } else { best });
    let inner = |a: f64, b: f64| (b - GOLDEN * (b - a), a + GOLDEN * (b - a));
    let (c, d) = inner(a, b);
    let (mut c, mut d) = ((c, value(c)), (d, value(d)));
    for _ in 0..SECTIONS {
        if c.1 >= d.1 {
            b = d.0;
            d = c;
            let t = inner(a, b).0;
            c = (t, value(t));
        } else {
            a = c.0;
            c = d;
            let t = inner(a, b).1;
            d = (t, value(t));
        }
        for each in [c, d] {
            best = if each.1 > best.1 { each } else { best };
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ends_are_the_last_doubles() {
        let root = crossing(|x| x * x <= 2.0, 1.0, 2.0);
        assert!(root * root <= 2.0 && (root + 2.3e-16) * (root + 2.3e-16) > 2.0);
        let root = crossing(|x| x * x >= 2.0, 2.0, 0.0);
        assert!(root * root >= 2.0 && (root - 2.3e-16) * (root - 2.3e-16) < 2.0);
        for top in [0.0, 0.3, 1.0] {
            let found = peak(|x: f64| -(x - top).abs(), 0.0, 1.0);
            assert!((found - top).abs() < 1e-15, "{top} {found}");
        }
    }
}

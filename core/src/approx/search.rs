//! Where a condition ends and where a function is largest, to the last double.

/// The last double at which a condition holds, on the way from where it does to where it does not.
pub(super) fn crossing(holds: impl Fn(f64) -> bool, inside: f64, outside: f64) -> f64 {
    let (mut inside, mut outside) = (inside, outside);
    loop {
        let middle = 0.5 * (inside + outside);
        if middle == inside || middle == outside {
            return inside;
        }
        *(if holds(middle) { &mut inside } else { &mut outside }) = middle;
    }
}

/// Where a function with one maximum in [low, high] is largest. The function's last digits decide how near: with
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

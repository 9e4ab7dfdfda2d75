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

/// Where a function with one maximum in [low, high] is largest (golden section). The function's last digits decide how
/// near: with twice the digits of a double it is the double.
pub(super) fn peak<V: PartialOrd>(value: impl Fn(f64) -> V, low: f64, high: f64) -> f64 {
    const PART: f64 = 0.3819660112501051;
    let (mut low, mut high) = (low, high);
    let step = PART * (high - low);
    let (mut left, mut right) = (low + step, high - step);
    let (mut at_left, mut at_right) = (value(left), value(right));
    // 0.618^84 < 2^-58.
    for _ in 0..84 {
        if at_left < at_right {
            low = left;
            (left, at_left) = (right, at_right);
            right = high - PART * (high - low);
            at_right = value(right);
        } else {
            high = right;
            (right, at_right) = (left, at_left);
            left = low + PART * (high - low);
            at_left = value(left);
        }
    }
    if at_left < at_right { right } else { left }
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

//! The ruler measures: what must be far is far, what must be near is near.

use crate::ruler::{distance, eased, hex, same, summary, ulp};

#[test]
fn nan_is_close_to_nothing() {
    assert_eq!(distance(f64::NAN, [1.0, 0.0], 1.0), f64::INFINITY);
    assert_eq!(distance(1.0, [f64::NAN, 0.0], 1.0), f64::INFINITY);
    assert_eq!(distance(f64::NAN, [f64::NAN, f64::NAN], 1.0), 0.0);
    assert_eq!(distance(1.0, [2.0, 0.0], f64::NAN), f64::INFINITY);
}

#[test]
fn signs_and_infinities_measure() {
    assert!(distance(-1.0, [1.0, 0.0], ulp(1.0)) > 1e15);
    assert!(distance(1.0, [-1.0, 0.0], ulp(1.0)) > 1e15);
    assert_eq!(distance(-1.0 - 3.0 * f64::EPSILON, [-1.0, 0.0], ulp(-1.0)), 3.0);
    assert_eq!(distance(f64::INFINITY, [f64::NEG_INFINITY, 0.0], 1.0), f64::INFINITY);
    assert_eq!(distance(f64::INFINITY, [f64::INFINITY, 0.0], 1.0), 0.0);
    assert_eq!(distance(1e308, [f64::INFINITY, 0.0], 1.0), f64::INFINITY);
    assert_eq!(distance(f64::INFINITY, [1e308, 0.0], 1.0), f64::INFINITY);
}

#[test]
fn fractions_of_an_ulp_are_read() {
    assert_eq!(distance(1.0, [1.0, 0.25 * f64::EPSILON], ulp(1.0)), 0.25);
    assert_eq!(ulp(1.0), f64::EPSILON);
    assert_eq!(ulp(0.0), 5e-324);
    assert_eq!(ulp(-4.0), 4.0 * f64::EPSILON);
}

#[test]
fn the_ease_has_an_end() {
    let truth = [1.0, 0.0];
    assert_eq!(eased(1.0 + f64::EPSILON, truth, 0.0, 0.0, 1.0), 1.0);
    assert!(eased(1.0 + 1e-10, truth, 0.0, f64::INFINITY, 1.0) > 1e3);
    assert_eq!(eased(f64::EPSILON * 2f64.powi(-30), [0.0, 0.0], 2f64.powi(-30), 0.0, 1.0), 1.0);
}

#[test]
fn hexadecimal_doubles_read_exactly() {
    for (text, value) in [
        ("0x1.8p+1", 3.0),
        ("-0x1.921fb54442d18p+1", -std::f64::consts::PI),
        ("0x0.0000000000001p-1022", 5e-324),
        ("0x1.fffffffffffffp+1023", f64::MAX),
        ("-inf", f64::NEG_INFINITY),
    ] {
        assert_eq!(hex(text), value);
    }
    assert!(hex("-0x0.0p+0").is_sign_negative());
    assert!(hex("nan").is_nan());
    assert_eq!(summary(&mut [3.0, 1.0, 2.0]), (3.0, 2.0));
    assert_eq!(summary(&mut [f64::INFINITY, 0.0]).0, f64::INFINITY);
}

#[test]
fn only_nan_has_several_bits() {
    assert!(same(f64::NAN, -f64::NAN) && same(0.5, 0.5));
    assert!(!same(0.0, -0.0) && !same(1.0, 1.0 + f64::EPSILON) && !same(f64::NAN, 1.0));
}

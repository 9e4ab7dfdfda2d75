//! A turning angle, itself or by its parameter, to triple-double: what the formulas of the period are formulas of.
//!
//! m = sin^2(theta_max/2), a = cos(theta_max/2) = sqrt(1 - m), each formed without subtraction, so that nothing is lost
//! next to rest and next to the top.

use crate::float::triple_double::Td;
use crate::float::{Dd, TWO_PI_LONG, angle_reduction, series};

/// Below it (m below its square) every ratio of periods is what it is at rest, to 120 digits; squares stay in range.
const LEAST: f64 = 1e-60;

/// One turning angle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turning {
    /// NaN for m < 0.
    pub theta_max: Td,
    /// sin(theta_max/2); NaN for m < 0.
    pub s: Td,
    /// cos(theta_max/2).
    pub a: Td,
    /// sin^2(theta_max/2).
    pub m: Td,
}

impl Turning {
    /// Of a turning angle from 0 to pi; `None` outside.
    pub fn of_angle(theta_max: f64) -> Option<Turning> {
        if !(0.0..=core::f64::consts::PI).contains(&theta_max) {
            return None;
        }
        let reduced = angle_reduction::reduce(f64::max(theta_max, LEAST));
        let half = reduced.from_bottom.scale(0.5);
        let (s, a) = series::quarter_turn(half, reduced.from_top.scale(0.5));
        Some(Turning { theta_max: reduced.from_bottom, s, a, m: s.square() })
    }

    /// Of a parameter up to 1, also negative; `None` outside.
    pub fn of_parameter(m: f64) -> Option<Turning> {
        if !(f64::NEG_INFINITY < m && m <= 1.0) {
            return None;
        }
        let m = if m.abs() < LEAST * LEAST { f64::copysign(LEAST * LEAST, m) } else { m };
        Some(Turning::of_pair(Td::from(m), Dd::sum(1.0, -m).into()))
    }

    /// Of the complement of a parameter, at least 0; `None` outside.
    pub fn of_complement(mc: f64) -> Option<Turning> {
        let m = Dd::sum(1.0, -mc);
        if m.hi.abs() < LEAST * LEAST {
            return Turning::of_parameter(m.hi);
        }
        (0.0..f64::INFINITY).contains(&mc).then(|| Turning::of_pair(m.into(), Td::from(mc)))
    }

    /// Of a parameter in [0, 1] and its complement, of which the smaller one counts.
    pub fn of_both(m: f64, mc: f64) -> Option<Turning> {
        if m <= 0.5 {
            return Turning::of_parameter(f64::max(m, 0.0));
        }
        (mc >= 0.0).then(|| Turning::of_pair(Dd::sum(1.0, -mc).into(), Td::from(mc)))
    }

    fn of_pair(m: Td, mc: Td) -> Turning {
        let a = mc.sqrt();
        if m.hi < 0.0 {
            let none = Td::from(f64::NAN);
            return Turning { theta_max: none, s: none, a, m };
        }
        let s = m.sqrt();
        Turning { theta_max: series::angle(s, a).scale(2.0), s, a, m }
    }

    /// 1 - a, without subtraction.
    pub fn one_minus_a(&self) -> Td {
        self.m / (Td::ONE + self.a)
    }

    /// sin(theta_max)/theta_max.
    pub fn cardinal_sine(&self) -> Td {
        (self.s * self.a).scale(2.0) / self.theta_max
    }
}

/// sin x for x in [0, pi].
pub(super) fn sine(x: Td) -> Td {
    let half_turn = TWO_PI_LONG.scale(0.5);
    let x = if x.hi > 0.5 * half_turn.hi { half_turn - x } else { x };
    series::quarter_turn(x, half_turn.scale(0.5) - x).0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angle_and_parameter_name_the_same_swing() {
        for i in 1..400 {
            let m = f64::from(i) / 400.0;
            let Some(turning) = Turning::of_parameter(m) else { panic!("{m}") };
            let half = turning.theta_max.scale(0.5);
            for (of, value) in [(sine(half), turning.s), (sine(TWO_PI_LONG.scale(0.25) - half), turning.a)] {
                let apart = (of - value).hi.abs();
                assert!(apart < 1e-45, "{m} {apart:e}");
            }
        }
    }

    #[test]
    fn what_is_no_swing_is_none() {
        for theta_max in [-1e-300, 3.1415926535897936, f64::NAN, f64::INFINITY] {
            assert!(Turning::of_angle(theta_max).is_none());
        }
        for m in [1.0000000000000002, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(Turning::of_parameter(m).is_none());
        }
    }
}

//! The table of approximations of the angle. Their errors and their ranges are measured (measure.rs); the ends that
//! `undefined` tells are what the test below finds.

use super::entry::{Entry, Orders, Row, entries, row};
use super::salas::{DEGREES_70, DEGREES_120};

const PLAIN: Entry = Entry::new("", "", "").but_for("rotation, separatrix");

/// What an entry is evaluated by (angle.rs).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum AngleRule {
    Linear,
    Harmonic,
    Fourier,
    FourierTheta,
    Trigonometric,
    SmallM,
    SmallMBounded,
    Cubic,
    CubicQuintic,
    Taylor,
}

pub(super) const TABLE: &[Row<AngleRule>] = &[
    row(
        Entry {
            name: "linear",
            formula: "θ₀ cos ω₀t + (θ̇₀/ω₀) sin ω₀t",
            source: "Horsley 2025 (2), (4), with any start; the motion of sin θ ≈ θ",
            stated: "small angles",
            undefined: "",
            ..PLAIN
        },
        AngleRule::Linear,
    ),
    row(
        Entry {
            name: "harmonic",
            formula: "θ_max cos(2πt/T), with the exact period T",
            source: "Lima 2019 (17)",
            ..PLAIN
        },
        AngleRule::Harmonic,
    ),
    row(
        Entry {
            name: "fourier",
            orders: Some(Orders::all([1, 500])),
            formula: "2 arcsin of the first N terms of (2π/K) Σ q^(n−½)/(1−q^(2n−1)) sin((2n−1)πu/2K) = k sn u",
            source: "Lima 2019 (20)-(22)",
            stated: "below 180 deg",
            stated_range: Some([0.0, core::f64::consts::PI]),
            undefined: "where |k sn_N| > 1: from 131.55 deg with N = 1, nearer to 180 deg the larger N; rotation, separatrix",
        },
        AngleRule::Fourier,
    ),
    row(
        Entry {
            name: "fourier-theta",
            orders: Some(Orders::all([1, 500])),
            formula: "the first N terms of 8 Σ q^(n−½)/((2n−1)(1+q^(2n−1))) sin((2n−1)πu/2K); rotation: its turn and \
                  4 Σ qⁿ/(n(1+q^(2n))) sin(nπu/K)",
            source: "Jacobi's series of dn and cn, integrated (DLMF 22.11.1, 22.11.3); Chachiyo, arXiv:2504.16816",
            undefined: "separatrix",
            ..PLAIN
        },
        AngleRule::FourierTheta,
    ),
    row(
        Entry {
            name: "trigonometric",
            formula: "θ_max cos νt/√(1 + λ sin² νt), ν² = ω₀²(1 − 10x/81 + x²/262), \
                  λ = (243x² − 2620x)/(243x² − 7860x + 63666), x = θ_max²",
            source: "Salas 2019 (30), (34), (35)",
            stated: "up to 120 deg",
            stated_range: Some([0.0, DEGREES_120]),
            ..PLAIN
        },
        AngleRule::Trigonometric,
    ),
    row(
        Entry {
            name: "small-m",
            formula: "2 arctan of Salas (24) to first order in m: secular, an error that grows as the square of the time",
            source: "Salas 2019, the formula before fig. 6",
            stated: "m < 0.2",
            stated_range: Some([0.0, 0.927_295_218_001_612_2]),
            undefined: "",
            ..PLAIN
        },
        AngleRule::SmallM,
    ),
    row(
        Entry {
            name: "small-m-bounded",
            formula: "2 atan2(s c cn + x dn sn, c² − x² sn²) with sn, cn, dn to first order in m at the exact phase: \
                  an error that does not grow with time",
            source: "derived here from Salas 2019 (23), DLMF 22.10.1-22.10.3 and 22.11",
            ..PLAIN
        },
        AngleRule::SmallMBounded,
    ),
    row(
        Entry {
            name: "cubic",
            formula: "the exact motion with sin θ ≈ θ − 40θ³/243",
            source: "Salas 2019 (2)",
            stated: "up to 70 deg",
            stated_range: Some([0.0, DEGREES_70]),
            undefined: "from its escape on: released from rest beyond 141.2 deg, or with the energy of 121.2 deg",
            ..PLAIN
        },
        AngleRule::Cubic,
    ),
    row(
        Entry {
            name: "cubic-quintic",
            formula: "the exact motion with sin θ ≈ θ − 40θ³/243 + θ⁵/131",
            source: "Salas 2019 (3), (29)",
            stated: "up to 120 deg",
            stated_range: Some([0.0, DEGREES_120]),
            undefined: "",
            ..PLAIN
        },
        AngleRule::CubicQuintic,
    ),
    row(
        Entry {
            name: "taylor",
            orders: Some(Orders::all([1, 200])),
            formula: "Taylor's polynomial of θ(t) of degree N about t = 0",
            source: "recurrence of sine and cosine of a power series",
            undefined: "",
            ..PLAIN
        },
        AngleRule::Taylor,
    ),
];

/// The approximations of the angle, by name.
pub static ANGLES: [Entry; TABLE.len()] = entries(TABLE);

#[cfg(test)]
mod tests {
    use super::super::angle::AngleFormula;
    use super::super::search::crossing;
    use super::*;
    use crate::{Frequency, Orbit};

    /// The last degree at which a formula is defined all the time, for an orbit of a turning angle.
    fn last_defined(name: &str, orbit: impl Fn(f64) -> (f64, f64)) -> f64 {
        let defined = |degrees: f64| {
            let (theta0, velocity0) = orbit(degrees.to_radians());
            let orbit = Orbit::new(theta0, velocity0, Frequency::from_omega0(1.0).unwrap()).unwrap();
            let made = AngleFormula::named(name).unwrap().of(&orbit).unwrap();
            made.largest_error(5.0).unwrap().undefined_from.is_nan()
        };
        crossing(defined, 100.0, 179.0)
    }

    fn told(name: &str) -> &'static str {
        ANGLES.iter().find(|entry| entry.name == name).unwrap().undefined
    }

    #[test]
    fn the_ends_that_are_told_are_those_that_are_found() {
        let rest = |theta_max: f64| (theta_max, 0.0);
        let ends = [
            ("fourier", format!("from {:.2} deg with N = 1", last_defined("fourier:1", rest))),
            ("cubic", format!("beyond {:.1} deg", last_defined("cubic", rest))),
            (
                "cubic",
                format!(
                    "the energy of {:.1} deg",
                    last_defined("cubic", |top| (0.0, 2.0 * (0.5 * top).sin()))
                ),
            ),
        ];
        for (name, end) in ends {
            assert!(told(name).contains(&end), "{name}: {end}");
        }
    }
}

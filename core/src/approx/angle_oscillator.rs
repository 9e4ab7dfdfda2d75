//! Approximations that are oscillators of their own: linear, trigonometric (Salas 35).
//!
//! Source: Salas 2019 (30), (34), (35).

use super::angle_columns::{AngleBlock, AngleRow, Combination, Pass, Turns, constant, double, ordinary};
use super::angle_phase::{counted, framed, turning_angle};
use crate::elliptic::phase::{LAST_HALF_PERIOD, Phase};
use crate::float::exponent::{carried, exp2, ldexp};
use crate::float::{Dd, PI, Scaled, Td};
use crate::lanes::Lane;
use crate::pendulum::Orbit;
use crate::pendulum::theta_quotients::Elliptic;

/// theta0 cos(omega0 t) + velocity0/omega0 sin(omega0 t).
#[derive(Clone, Debug)]
pub(super) struct Linear {
    phase: Phase,
    /// omega0 is its root times 2^power.
    power: i32,
    period: f64,
    start: Scaled,
    velocity: Scaled,
    /// velocity0/omega0.
    swing: Scaled,
}

/// Phases below this the cosine does not show, in any digit of a double-double.
const EARLY: f64 = 1e-20;

/// A power of omega0 to which every finite time is early: without a force.
const NONE: i32 = -5000;

impl Linear {
    pub fn new(orbit: &Orbit) -> Linear {
        let (root, power) = orbit.force.root().unwrap_or((Td::ONE, NONE));
        let omega = Scaled::new(root.to_dd(), power);
        let velocity = Scaled::from(orbit.velocity0);
        Linear {
            phase: Phase { rate: root.to_dd() / PI, start: Dd::ZERO },
            power,
            period: (Scaled::from(PI.scale(2.0)) / omega).value(),
            start: Scaled::from(orbit.theta0),
            velocity,
            swing: velocity / omega,
        }
    }

    pub fn theta(&self, t: f64) -> f64 {
        let passed = ldexp(t, self.power);
        if self.is_early(t) {
            return (self.start + self.velocity * t).value();
        }
        let Some((sine, cosine)) = counted(&self.phase, passed) else { return f64::NAN };
        (self.start * Scaled::from(cosine) + self.swing * Scaled::from(sine)).value()
    }

    /// Whether t has no phase yet: there the sine may be below the range.
    pub fn is_early(&self, t: f64) -> bool {
        ldexp(t, self.power).abs() < EARLY
    }

    pub fn in_columns(&self) -> bool {
        let numbers = [self.start, self.velocity, self.swing, Scaled::new(Dd::ONE, self.power)];
        numbers.into_iter().all(ordinary)
    }

    pub fn columns(&self, block: &mut AngleBlock, rows: usize) {
        let time_scale = exp2(self.power);
        block.through(rows, &Turns { phase: self.phase, time_scale, end: LAST_HALF_PERIOD, turning: false });
        block.through(rows, &Combination { along: self.swing.to_dd(), across: self.start.to_dd() });
    }

    pub fn period(&self) -> f64 {
        self.period
    }
}

/// theta_max cos(nu t)/sqrt(1 + lambda sin^2 nu t), nu t counted from the last turning point.
#[derive(Clone, Debug)]
pub(super) struct Trigonometric {
    phase: Phase,
    /// The turning angle that time counts from.
    turning: Scaled,
    /// lambda.
    flattening: Dd,
    period: f64,
}

impl Trigonometric {
    pub fn new(orbit: &Orbit, elliptic: &Elliptic) -> Option<Trigonometric> {
        let (root, power) = orbit.force.root()?;
        let size = turning_angle(orbit);
        let x = size.square().to_dd();
        let whole = |value: f64| Dd::from(value);
        let square = whole(1.0) - x * 10.0 / whole(81.0) + x.square() / whole(262.0);
        let above = x.square() * 243.0 - x * 2620.0;
        let below = x.square() * 243.0 - x * 7860.0 + whole(63666.0);
        // Salas's rate nu, in half periods of its own per unit of the scaled time of the orbit; both rates are near omega0.
        let rate = root.to_dd() * square.sqrt() / PI;
        let ratio = rate / elliptic.phase.rate * Dd::from(exp2(carried(power).0));
        let start = elliptic.phase.start;
        // Released at the upper or the lower turning point, or past the lower one since phase -1/2.
        let upper = orbit.velocity0 == 0.0 && start.hi > 0.0;
        let since = if upper { start - whole(0.5) } else { start + whole(0.5) };
        let omega = Scaled::new(root.to_dd() * square.sqrt(), power);
        Some(Trigonometric {
            phase: Phase { rate: elliptic.phase.rate * ratio, start: since * ratio },
            turning: if upper { size } else { -size },
            flattening: above / below,
            period: (Scaled::from(PI.scale(2.0)) / omega).value(),
        })
    }

    pub fn theta(&self, orbit: &Orbit, t: f64) -> f64 {
        let Some((sine, cosine)) = counted(&self.phase, t * orbit.time_scale) else { return f64::NAN };
        let root = (Dd::ONE + self.flattening * sine.square()).sqrt();
        framed(&orbit.frame, self.turning * Scaled::from(cosine / root))
    }

    pub fn in_columns(&self) -> bool {
        ordinary(self.turning)
    }

    pub fn columns(&self, orbit: &Orbit, block: &mut AngleBlock, rows: usize) {
        let (phase, time_scale) = (self.phase, orbit.time_scale);
        block.through(rows, &Turns { phase, time_scale, end: LAST_HALF_PERIOD, turning: false });
        block.through(rows, &Flattened { turning: self.turning.to_dd(), flattening: self.flattening });
    }

    pub fn period(&self) -> f64 {
        self.period
    }
}

/// turning cosine/sqrt(1 + flattening sine^2).
struct Flattened {
    turning: Dd,
    flattening: Dd,
}

impl Pass for Flattened {
    #[inline(always)]
    fn at<L: Lane>(&self, row: AngleRow<L>) -> AngleRow<L> {
        let square = double(1.0) + constant(self.flattening) * row.opposite.square();
        AngleRow { angle: constant(self.turning) * row.adjacent * square.inverse_root(), ..row }
    }
}

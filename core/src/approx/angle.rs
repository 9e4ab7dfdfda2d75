//! Approximations of the angle by name, each set up once for an orbit.
//!
//! What is written for a release from rest runs on the exact phase of the orbit: time counts from its last turning point.
//! All phases are exact in double-double, so that an approximation that repeats stays right for all times.
//! Where a formula has no value it gives NaN; nothing is clipped. Sources: the table in angle_entries.rs.

use super::angle_columns::{AngleBlock, BLOCK, Framed};
use super::angle_entries::{AngleRule, TABLE};
use super::angle_oscillator::{Linear, Trigonometric};
use super::angle_series::{Arcsine, Harmonic, Series};
#[cfg(feature = "all-formulas")]
use super::angle_small::{Bounded, Secular};
#[cfg(not(feature = "all-formulas"))]
use super::angle_small_absent::{NoBounded as Bounded, NoSecular as Secular};
use super::angle_taylor::Polynomial;
use super::entry::{Entry, Named};
use super::salas::{CUBIC, QUINTIC};
#[cfg(feature = "all-formulas")]
use super::sine_model::SineModel;
#[cfg(not(feature = "all-formulas"))]
use super::sine_model_absent::NoSineModel as SineModel;
use crate::domain::{Domain, shown};
use crate::pendulum::orbit::Solution;
use crate::pendulum::{Orbit, Regime};

/// A formula for the angle over time, found by its name.
///
/// ```
/// use libration::{Frequency, Orbit, approx::AngleFormula};
/// let orbit = Orbit::new(3.0, 0.0, Frequency::from_omega0(1.0)?)?;
/// let series = AngleFormula::named("fourier-theta:4")?.of(&orbit)?;
/// assert_eq!(format!("{:.6} {:.3e}", series.theta(1.0), series.difference(1.0)), "2.926421 2.983e-3");
/// # Ok::<(), libration::Domain>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AngleFormula {
    named: Named,
    kind: AngleRule,
}

/// A formula for the angle set up for one orbit.
#[derive(Clone, Debug)]
pub struct AngleApproximation {
    formula: AngleFormula,
    pub(super) orbit: Orbit,
    pub(super) shape: Shape,
    /// Whether columns serve: for all but extreme numbers.
    by_columns: bool,
}

/// What is left out with the feature `all-formulas`.
const ABSENT: &[AngleRule] = if cfg!(feature = "all-formulas") {
    &[]
} else {
    &[AngleRule::SmallM, AngleRule::SmallMBounded, AngleRule::Cubic, AngleRule::CubicQuintic]
};

/// What the formula has become for the orbit.
#[derive(Clone, Debug)]
pub(super) enum Shape {
    /// Without motion or without a force every formula is exact.
    Exact,
    Linear(Linear),
    Harmonic(Harmonic),
    Arcsine(Arcsine),
    Series(Series),
    Trigonometric(Trigonometric),
    Secular(Secular),
    Bounded(Bounded),
    Model(SineModel),
    Polynomial(Polynomial),
}

impl AngleFormula {
    /// Finds `linear`, `fourier:4` and so on; the error names the nearest entries first.
    pub fn named(name: &str) -> Result<AngleFormula, Domain> {
        let (named, &kind) = Named::find("formula", TABLE, name)?;
        Ok(AngleFormula { named, kind })
    }

    /// What is known of it before it is asked anything.
    pub fn entry(&self) -> &'static Entry {
        self.named.entry
    }

    /// The name that finds it again.
    pub fn name(&self) -> String {
        self.named.name()
    }

    /// N, or 0 where it takes none.
    pub fn order(&self) -> u32 {
        self.named.order
    }

    fn regime_refused(&self, orbit: &Orbit, needs: &str) -> Domain {
        Domain::new("regime", orbit.regime().name().into(), format!("{needs} for {}", self.name()))
    }

    /// Refuses what the formula is not written for.
    fn refuse(&self, orbit: &Orbit) -> Result<(), Domain> {
        let regime = orbit.regime();
        let periodic = (regime != Regime::Separatrix, "libration or rotation");
        let libration = (matches!(regime, Regime::Libration | Regime::Rest), "libration");
        let all = (true, "");
        let ((served, needs), about_bottom) = match self.kind {
            AngleRule::Linear | AngleRule::SmallM | AngleRule::Cubic | AngleRule::CubicQuintic => (all, true),
            AngleRule::SmallMBounded | AngleRule::Trigonometric => (libration, true),
            AngleRule::Harmonic | AngleRule::Fourier => (libration, false),
            AngleRule::FourierTheta => (periodic, false),
            AngleRule::Taylor => (all, false),
        };
        if ABSENT.contains(&self.kind) {
            let allowed =
                "any but small-m, small-m-bounded, cubic and cubic-quintic, until the whole core is loaded";
            return Err(Domain::new("formula", self.name(), allowed));
        }
        if !served {
            return Err(self.regime_refused(orbit, needs));
        }
        if about_bottom && orbit.force.upside_down() {
            let allowed = format!("positive for {}, which is about theta = 0", self.name());
            return Err(Domain::new("omega2", shown(orbit.omega2()), allowed));
        }
        Ok(())
    }

    /// Sets the formula up for an orbit; refused where it is not written for its regime or for omega2 < 0.
    pub fn of(&self, orbit: &Orbit) -> Result<AngleApproximation, Domain> {
        self.refuse(orbit)?;
        let order = self.named.order;
        let shape = match (&orbit.solution, self.kind) {
            (Solution::Equilibrium, _) => Shape::Exact,
            (_, AngleRule::Linear) => Shape::Linear(Linear::new(orbit)),
            (Solution::ForceFree, AngleRule::SmallM) => {
                let allowed = "large beside the velocity for small-m";
                return Err(Domain::new("omega0", shown(orbit.omega0()), allowed));
            }
            (Solution::ForceFree, kind)
                if orbit.force.root().is_none() || kind == AngleRule::FourierTheta =>
            {
                Shape::Exact
            }
            (_, AngleRule::Cubic) => Shape::Model(SineModel::new(orbit, [CUBIC, [0.0, 1.0]])?),
            (_, AngleRule::CubicQuintic) => Shape::Model(SineModel::new(orbit, [CUBIC, QUINTIC])?),
            (_, AngleRule::Taylor) => Polynomial::new(orbit, order).map_or(Shape::Exact, Shape::Polynomial),
            (_, AngleRule::SmallM) => Secular::new(orbit).map_or(Shape::Exact, Shape::Secular),
            (Solution::Libration(e), AngleRule::SmallMBounded) => {
                Bounded::new(orbit, e).map_or(Shape::Exact, Shape::Bounded)
            }
            (Solution::Libration(e), AngleRule::Trigonometric) => {
                Trigonometric::new(orbit, e).map_or(Shape::Exact, Shape::Trigonometric)
            }
            (Solution::Libration(_), AngleRule::Harmonic) => Shape::Harmonic(Harmonic::new(orbit)),
            (Solution::Libration(_), AngleRule::Fourier) => Shape::Arcsine(Arcsine::new(orbit, order)),
            (_, AngleRule::FourierTheta) => Shape::Series(Series::new(orbit, order)),
            // Other courses of these are refused above.
            (
                _,
                AngleRule::Harmonic
                | AngleRule::Fourier
                | AngleRule::Trigonometric
                | AngleRule::SmallMBounded,
            ) => {
                return Err(self.regime_refused(orbit, "libration"));
            }
        };
        let by_columns = shape.in_columns(orbit);
        Ok(AngleApproximation { formula: *self, orbit: orbit.clone(), shape, by_columns })
    }
}

impl AngleApproximation {
    /// The formula.
    pub fn formula(&self) -> AngleFormula {
        self.formula
    }

    /// The approximate angle in rad at t (in s); NaN where the formula has no value, and where the exact angle has none
    /// by its distance in time, but of `taylor` and of `linear` without a force, which go on.
    ///
    /// **Error** at most 8 ulp of its scale, plus the condition of its phase in what is rounded to double: the
    /// coefficients of the sine models.
    pub fn theta(&self, t: f64) -> f64 {
        if !self.by_columns {
            return self.long_theta(t);
        }
        let mut theta = [0.0];
        self.theta_into(&[t], &mut theta);
        theta[0]
    }

    /// [`AngleApproximation::theta`] of every time, bit for bit, on the widest lanes; panics where the lengths differ.
    pub fn theta_into(&self, t: &[f64], theta: &mut [f64]) {
        assert_eq!(t.len(), theta.len(), "columns of different lengths");
        if let Shape::Exact = self.shape {
            return self.orbit.theta_into(t, theta);
        }
        if !self.by_columns {
            t.iter().zip(theta).for_each(|(t, theta)| *theta = self.long_theta(*t));
            return;
        }
        let mut block = AngleBlock::new();
        for (t, theta) in t.chunks(BLOCK).zip(theta.chunks_mut(BLOCK)) {
            let rows = t.len();
            block.t[..rows].copy_from_slice(t);
            self.shape.columns(&self.orbit, &mut block, rows);
            let frame = match &self.shape {
                Shape::Linear(_) | Shape::Polynomial(_) => Framed::PLAIN,
                _ => Framed::new(&self.orbit.frame),
            };
            block.through(rows, &frame);
            theta.copy_from_slice(&block.angle[0][..rows]);
            for (row, (t, theta)) in t.iter().zip(theta).enumerate() {
                let beyond = match &self.shape {
                    Shape::Linear(shape) => shape.is_early(*t),
                    Shape::Polynomial(shape) => shape.is_far(*t),
                    Shape::Arcsine(_) => block.is_close(row),
                    _ => false,
                };
                if beyond {
                    *theta = self.long_theta(*t);
                }
            }
        }
    }

    /// One angle, whatever the size of its numbers.
    fn long_theta(&self, t: f64) -> f64 {
        match &self.shape {
            Shape::Exact => self.orbit.theta(t),
            Shape::Linear(shape) => shape.theta(t),
            Shape::Harmonic(shape) => shape.theta(&self.orbit, t),
            Shape::Arcsine(shape) => shape.theta(&self.orbit, t),
            Shape::Series(shape) => shape.theta(&self.orbit, t),
            Shape::Trigonometric(shape) => shape.theta(&self.orbit, t),
            Shape::Secular(shape) => shape.theta(t),
            Shape::Bounded(shape) => shape.theta(t),
            Shape::Model(shape) => shape.theta(t),
            Shape::Polynomial(shape) => shape.theta(t),
        }
    }

    /// The approximate minus the exact angle in rad at t (in s); NaN where one of them is, and where both are infinite.
    ///
    /// **Error** of `harmonic` and of the two Fourier series at most 1e-10 of the difference itself, from the terms they
    /// leave out; of the others that of the two angles.
    pub fn difference(&self, t: f64) -> f64 {
        match &self.shape {
            Shape::Exact => 0.0 * self.orbit.theta(t),
            Shape::Harmonic(shape) => shape.difference(&self.orbit, t),
            Shape::Arcsine(shape) => shape.difference(&self.orbit, t),
            Shape::Series(shape) => shape.difference(&self.orbit, t),
            _ => self.theta(t) - self.orbit.theta(t),
        }
    }

    /// Period in s of the approximation itself; NaN where it does not repeat.
    pub fn period(&self) -> f64 {
        let period = match &self.shape {
            Shape::Linear(shape) => shape.period(),
            Shape::Trigonometric(shape) => shape.period(),
            Shape::Model(shape) => shape.period(),
            Shape::Secular(_) | Shape::Polynomial(_) => f64::NAN,
            _ => self.orbit.period(),
        };
        if period.is_finite() { period } else { f64::NAN }
    }
}

impl Shape {
    /// Whether columns carry its numbers.
    fn in_columns(&self, orbit: &Orbit) -> bool {
        match self {
            Shape::Exact | Shape::Model(_) => false,
            Shape::Linear(shape) => shape.in_columns(),
            Shape::Harmonic(shape) => shape.in_columns(orbit),
            Shape::Arcsine(shape) => shape.in_columns(orbit),
            Shape::Series(shape) => shape.in_columns(orbit),
            Shape::Trigonometric(shape) => shape.in_columns(),
            Shape::Secular(shape) => shape.in_columns(),
            Shape::Bounded(shape) => shape.in_columns(),
            Shape::Polynomial(shape) => shape.in_columns(),
        }
    }

    /// The angle of the first rows of a block, before it is framed.
    fn columns(&self, orbit: &Orbit, block: &mut AngleBlock, rows: usize) {
        match self {
            // They have none.
            Shape::Exact | Shape::Model(_) => {}
            Shape::Linear(shape) => shape.columns(block, rows),
            Shape::Harmonic(shape) => shape.columns(orbit, block, rows),
            Shape::Arcsine(shape) => shape.columns(orbit, block, rows),
            Shape::Series(shape) => shape.columns(orbit, block, rows),
            Shape::Trigonometric(shape) => shape.columns(orbit, block, rows),
            Shape::Secular(shape) => shape.columns(block, rows),
            Shape::Bounded(shape) => shape.columns(block, rows),
            Shape::Polynomial(shape) => shape.columns(block, rows),
        }
    }
}

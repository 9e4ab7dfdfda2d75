//! Half a swing of a bounded motion as an interval of y = u^2, for integrals over the motion.
//!
//! Between the smaller end y1 (0, where the motion crosses) and the larger one y2, y = (y1 + y2 E)/(1 + E) with E from 0 to
//! infinity. Each linear factor of u'^2 becomes (a + b E)/(1 + E) with a, b >= 0, its values at the ends, which are quotients
//! of gaps between roots: nothing is subtracted, however near to a separatrix. A pair of complex roots becomes
//! ((1 + q E)^2 + (w E)^2)/(1 + E)^2.
//! Source: Moebius' transformation of v'^2 = 4 C(v), nonzero_energy.rs and zero_energy.rs.

use super::nonzero_energy::{NonzeroEnergy, RootCase};
use super::roots::Distances;
use super::set_up::EnergyCase;
use crate::float::scaled::Scaled;

/// A pair of complex roots v, from the root v0 at the turning point: (v0 - v)/v0 = q -+ i w.
#[derive(Clone, Copy, Debug)]
pub(super) struct ComplexPair {
    pub q: Scaled,
    pub w: Scaled,
}

/// Half a swing.
#[derive(Clone, Debug)]
pub(super) struct SwingInterval<'a> {
    case: &'a EnergyCase,
    /// y at the ends, and their difference.
    pub ends: [Scaled; 2],
    width: Scaled,
    /// u'^2 = factor y^power g0 g1 g2.
    factor: Scaled,
    power: i32,
    /// The values of the real factors at the ends, in the order of the roots.
    pub factors: [[Scaled; 2]; 3],
    pub pair: Option<ComplexPair>,
}

/// A place: E, 1 + E, dE by the variable of the rule, and 1 + q E where it is known without subtraction.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ratio {
    pub e: Scaled,
    pub one: Scaled,
    pub rate: Scaled,
    pub leg: Option<Scaled>,
}

/// What the motion has at a place: y, dy by the variable of the rule, u'^2, and the factors.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub y: Scaled,
    pub step: Scaled,
    pub square_speed: Scaled,
    factors: [Scaled; 3],
}

const ALWAYS: [Scaled; 2] = [Scaled::ONE; 2];
/// A factor that vanishes at the larger end.
const FALLS: [Scaled; 2] = [Scaled::ONE, Scaled::ZERO];

impl<'a> SwingInterval<'a> {
    /// None where the motion does not stay between two ends.
    pub fn new(case: &'a EnergyCase) -> Option<SwingInterval<'a>> {
        match case {
            EnergyCase::Nonzero(energy) => SwingInterval::of_nonzero(case, energy),
            EnergyCase::Zero(energy) => {
                let (ends, width, factor, power, [g0, g1]) = energy.between()?;
                let factors = [g0, g1, ALWAYS];
                Some(SwingInterval { case, ends, width, factor, power, factors, pair: None })
            }
        }
    }

    fn of_nonzero(case: &'a EnergyCase, energy: &NonzeroEnergy) -> Option<SwingInterval<'a>> {
        let [upper, lower, total] = energy.gaps;
        let zero = Scaled::ZERO;
        let inverse = |v: Scaled| Scaled::ONE / v;
        let (ends, width, factors, pair) = match (energy.case, energy.roots) {
            (RootCase::Crossing, Distances::Three([v0, ..])) if v0.is_positive() => {
                let factors = [FALLS, [Scaled::ONE, upper / v0], [Scaled::ONE, total / v0]];
                ([zero, inverse(v0)], inverse(v0), factors, None)
            }
            (RootCase::Inside | RootCase::InsideDouble, Distances::Three([_, v1, v2]))
                if v2.is_positive() =>
            {
                let factors = [[upper / v1, total / v2], [zero, lower / v2], [lower / v1, zero]];
                ([inverse(v1), inverse(v2)], lower / (v1 * v2), factors, None)
            }
            (RootCase::Between, Distances::Three([v0, v1, _])) if v1.is_positive() => {
                let factors = [[zero, upper / v1], [upper / v0, zero], [total / v0, lower / v1]];
                ([inverse(v0), inverse(v1)], upper / (v0 * v1), factors, None)
            }
            (RootCase::PairCrossing, Distances::One([v0, ..])) if v0.is_positive() => {
                let pair = ComplexPair { q: upper / v0, w: lower / v0 };
                ([zero, inverse(v0)], inverse(v0), [FALLS, ALWAYS, ALWAYS], Some(pair))
            }
            _ => return None,
        };
        Some(SwingInterval { case, ends, width, factor: energy.speed.square(), power: 0, factors, pair })
    }

    /// What the motion has where E is.
    pub fn place(&self, at: &Ratio) -> Place {
        let Ratio { e, one, rate, .. } = *at;
        let along = |[a, b]: [Scaled; 2]| (a + b * e) / one;
        let y = along(self.ends);
        let mut factors = self.factors.map(along);
        if let Some(ComplexPair { q, w }) = self.pair {
            let leg = at.leg.unwrap_or(Scaled::ONE + q * e) / one;
            factors = [factors[0], leg.square() + (w * e / one).square(), leg];
        }
        let product = factors[0] * factors[1];
        let product = if self.pair.is_some() { product } else { product * factors[2] };
        let power = match self.power {
            0 => Scaled::ONE,
            1 => y,
            _ => y.square(),
        };
        let step = self.width * rate / one.square();
        Place { y, step, square_speed: self.factor * power * product, factors }
    }

    /// The argument of the canonical function from the smaller end to a place, of a motion that repeats.
    pub fn argument(&self, place: &Place) -> Scaled {
        match self.case {
            EnergyCase::Nonzero(energy) => energy.argument_of_factors(place.factors, place.y),
            EnergyCase::Zero(energy) => energy.argument_of_factors(place.factors, place.y),
        }
    }

    /// The argument per unit of time.
    pub fn omega(&self) -> Scaled {
        self.case.outline().omega
    }

    /// Logarithms of the places beside the interval, as -E.
    pub fn singularities(&self) -> Vec<Scaled> {
        let beside = |[a, b]: &[Scaled; 2]| a.is_positive() && b.is_positive();
        let mut found: Vec<Scaled> =
            self.factors.iter().filter(|x| beside(x)).map(|[a, b]| *a / *b).collect();
        if beside(&self.ends) {
            found.push(self.ends[0] / self.ends[1]);
        }
        found
    }
}

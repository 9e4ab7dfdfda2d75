//! The motions on exact boundaries, where double roots or E = 0 leave hyperbolic functions, exponentials or powers of
//! the time: in double-doubles of any range, one sample after the other.
//!
//! As in root_quotient.rs, u = n/sqrt M, M = l C^2 + m S^2, with the pole's factor in an escape; S and C are tanh and
//! sech, sinh and 1, or x and 1.
//! Source: the limits m = 1 and 2K = infinite of root_quotient.rs, DLMF 22.5(ii).

use super::energy::Orientation;
use super::nonzero_energy::{Argument, NonzeroEnergy, RootCase};
use super::roots::Distances;
use crate::float::scaled::Scaled;

/// What S, C and the velocity are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Functions {
    /// tanh, sech.
    Tanh,
    /// sinh, 1.
    Sinh,
    /// x, 1.
    Power,
}

/// M as a function of the argument x, or of the argument d to the pole.
#[derive(Clone, Copy, Debug)]
pub(super) enum Sum {
    /// l C^2 + m S^2, and n = S where `odd`.
    Squares { functions: Functions, odd: bool, l: Scaled, m: Scaled },
    /// l e^(2x) + m.
    Exponential { l: Scaled, m: Scaled },
    /// 2 l e^d sinh d.
    GrowingSinh(Scaled),
    /// 2 l e^-d sinh d.
    DecayingSinh(Scaled),
    /// l d.
    Linear(Scaled),
    /// 2 l cosh(x + x_e) sinh d.
    CoshSinh(Scaled),
}

#[derive(Clone, Debug)]
pub(super) struct Elementary {
    pub sum: Sum,
    /// Argument at the start, and per unit of time; to the pole likewise.
    pub base: [Scaled; 2],
    pub rest: [Scaled; 2],
    pub pole: Option<Scaled>,
    /// Factor of u', with the sign of its argument's direction.
    pub velocity: Scaled,
    pub sign: f64,
}

/// Beyond, tanh is 1 and sech^2 beside it nothing, whatever the range; and e^x is still in range.
const FAR: f64 = 1e7;

impl Functions {
    /// S, C and the rate of S.
    fn values(self, x: Scaled) -> [Scaled; 3] {
        match self {
            Functions::Power => [x, Scaled::ONE, Scaled::ONE],
            Functions::Sinh => {
                let (sine, cosine) = x.sinh_cosh();
                [sine, Scaled::ONE, cosine]
            }
            Functions::Tanh => {
                let (sine, cosine) = x.sinh_cosh();
                let sech = Scaled::ONE / cosine;
                [sine * sech, sech, sech.square()]
            }
        }
    }
}

impl Elementary {
    /// |u| where the motion turns back, if it does.
    pub fn turn(&self) -> Option<f64> {
        let Sum::Squares { functions, odd: false, l, .. } = self.sum else { return None };
        let sine = match self.pole {
            Some(_) if (self.base[1] - self.rest[1]).is_zero() => return None,
            Some(pole) => functions.values(pole)[0],
            None => Scaled::ONE,
        };
        Some((Scaled::ONE / (l.sqrt() * sine)).value())
    }

    /// u and u' after the time t.
    pub fn at(&self, t: f64) -> (f64, f64) {
        let after = |[start, rate]: [Scaled; 2]| start + rate * t;
        let x = after(self.base);
        let mut rest = after(self.rest);
        if self.pole.is_some() && !rest.is_positive() || t.is_nan() {
            return (f64::NAN, f64::NAN);
        }
        let power = matches!(self.sum, Sum::Squares { functions: Functions::Power, .. } | Sum::Linear(_));
        let far =
            |x: Scaled| if power || x.abs().value() < FAR { x } else { Scaled::from(FAR).signed(x.value()) };
        let x = far(x);
        rest = far(rest);
        let behind = self.pole.map_or(x, |pole| pole + x);
        if matches!(self.sum, Sum::Squares { .. }) && self.pole.is_some() && !behind.is_positive() {
            return (f64::NAN, f64::NAN);
        }
        let one = Scaled::ONE;
        let (n, w, m) = match self.sum {
            Sum::Squares { functions, odd, l, m } => {
                let [s, c, rate] = functions.values(x);
                let mut sum = l * c.square() + m * s.square();
                if self.pole.is_some() {
                    sum = sum * functions.values(rest)[0] * functions.values(behind)[0];
                }
                if odd { (s, rate, sum) } else { (one, s * rate, sum) }
            }
            Sum::Exponential { l, m } => {
                let grown = Scaled::exp(x.shift(1).to_dd());
                (one, grown, l * grown + m)
            }
            Sum::GrowingSinh(l) => {
                let grown = Scaled::exp(rest.to_dd());
                (one, grown.square(), (l * grown * rest.sinh_cosh().0).shift(1))
            }
            Sum::DecayingSinh(l) => {
                let fallen = Scaled::exp(-rest.to_dd());
                (one, fallen.square(), (l * fallen * rest.sinh_cosh().0).shift(1))
            }
            Sum::Linear(l) => (one, one, l * rest),
            Sum::CoshSinh(l) => {
                let (sine, cosine) = (rest.sinh_cosh().0, behind.sinh_cosh().1);
                (one, x.shift(1).sinh_cosh().1, (l * sine * cosine).shift(1))
            }
        };
        let root = m.sqrt();
        let u = n / root;
        let velocity = self.velocity * w / (root * m);
        (u.signed(self.sign).value(), velocity.signed(self.sign).value())
    }
}

impl Elementary {
    /// Where a double or triple root of C(v) leaves no theta functions.
    pub fn of_double_root(energy: &NonzeroEnergy, start: Argument, orientation: Orientation) -> Elementary {
        let [upper, lower, total] = energy.gaps;
        let poles = energy.pole.is_some();
        let v = match energy.roots {
            Distances::Three(v) => v,
            Distances::One([v, ..]) => [v; 3],
        };
        let triple = energy.mc.is_nan();
        // At a triple root the gaps are 0: 1/2E stands for what the others make of them.
        let unit = Scaled::ONE / energy.speed.square();
        let (odd, l, m, factor) = match (energy.case, triple) {
            (RootCase::Crossing, true) if poles => (true, v[0].abs(), Scaled::ZERO, unit),
            (RootCase::Crossing, true) => (true, unit, v[0], unit),
            (_, true) => (true, v[0], Scaled::ZERO, -unit),
            (RootCase::Crossing, _) if poles => (true, -v[2], -v[1], total),
            (RootCase::Crossing, _) => (true, total, v[0], total),
            (RootCase::Between, _) if poles => (false, upper, -v[2], upper),
            (RootCase::Between, _) => (false, v[0], v[1], upper),
            (RootCase::InsideDouble, _) if poles => (false, lower, v[1], -lower),
            (RootCase::InsideDouble, _) => (false, v[2], v[1], -lower),
            _ => (true, v[0], v[2], -total),
        };
        let functions = if triple { Functions::Power } else { Functions::Tanh };
        let one_sided = matches!(energy.case, RootCase::InsideDouble | RootCase::OutsideDouble);
        let rate = energy.omega.signed(orientation.direction);
        Elementary {
            sum: Sum::Squares { functions, odd, l, m },
            base: [start.base, rate],
            rest: [start.pole, if one_sided { rate } else { -rate }],
            pole: energy.pole,
            velocity: factor * rate,
            sign: orientation.sign,
        }
    }
}

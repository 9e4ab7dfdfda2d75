//! The motions at E = 0, where v = 1/u^2 obeys v'^2 = 4 C(v), C(v) = -p v^2 - q v/2 - s/3: cosines, hyperbolic
//! functions or a square of the time.
//!
//! With c = -q/4 p and D = 3 q^2 - 16 p s the roots of C are c +- sqrt(D/48)/|p|, formed without
//! cancellation; the time to the pole is u R_C(w^2, w^2 + p u^2), w = |u'| + u^3 sqrt(-s/3).
//! Source: elementary; DLMF 19.2(iv).

use super::elementary::{Elementary, Functions, Sum};
use super::energy::{EnergyPolynomial, Orientation, Outline};
use super::nonzero_energy::{Argument, RootCase};
use super::root_quotient::Squares;
use crate::elliptic::integrals::carlson::rf_of_roots;
use crate::float::dyadic::Dyadic;
use crate::float::scaled::Scaled;

/// What v does.
#[derive(Clone, Copy, Debug, PartialEq)]
enum SpeedCase {
    /// p > 0: between two roots.
    Cosine,
    /// Above the upper root, which is positive: u falls to 0 both ways.
    Above,
    /// Above the upper root, which is not positive: from 0 to infinity.
    AbovePole,
    /// Below the lower root.
    Below,
    /// No root.
    NoRoot,
    /// A double root that is positive or 0, v above it.
    AboveDouble,
    /// A positive double root, v below it.
    BelowDouble,
    /// A negative double root.
    NegativeDouble,
    /// p = q = 0.
    Constant,
}

#[derive(Clone, Debug)]
pub(super) struct ZeroEnergy {
    case: SpeedCase,
    /// p = 0.
    parabola: bool,
    /// sqrt|p|, or 1.
    omega: Scaled,
    /// Lower and upper root; or c and the half gap without roots.
    roots: [Scaled; 2],
    /// Half the gap between the roots, or |q|/4, or the slope.
    half: Scaled,
    /// sqrt(-s/3): the rate at the pole.
    eta: Scaled,
    p: Scaled,
    /// 4 |p| - q y, at the start for the exponential; and D.
    offset: Scaled,
    energy: EnergyPolynomial,
    delta: Scaled,
    pole: Option<Scaled>,
}

/// y at both ends, their difference, a factor, a power of y, and the values of two factors at both ends.
pub(super) type Between = ([Scaled; 2], Scaled, Scaled, i32, [[Scaled; 2]; 2]);

fn asinh(z: Scaled) -> Scaled {
    z * rf_of_roots([(Scaled::ONE + z.square()).sqrt(), Scaled::ONE, Scaled::ONE])
}

/// -(4 p + q y), from b = -6 p and c = -3 q: six times it.
fn above_centre(energy: &EnergyPolynomial, y: &Dyadic) -> Dyadic {
    &energy.b * 4.0 + &energy.c * y * 2.0
}

/// arcsin of a sine with its cosine.
fn arcsine(sine: Scaled, cosine: Scaled) -> Scaled {
    sine * rf_of_roots([cosine, Scaled::ONE, Scaled::ONE])
}

impl ZeroEnergy {
    /// Of an orbit through u^2 = y.
    pub fn new(energy: &EnergyPolynomial, y: &Dyadic) -> ZeroEnergy {
        let sixth = |x: &Dyadic, k: f64| x.to_scaled() / Scaled::from(k);
        let (p, q, s) = (sixth(&energy.b, -6.0), sixth(&energy.c, -3.0), sixth(&energy.d, -2.0));
        // 3 D.
        let delta = energy.c.square() - &energy.b * &energy.d * 4.0;
        let sign = delta.sign();
        let delta = delta.to_scaled() / Scaled::from(3.0);
        let eta = if s.is_negative() { (-s / Scaled::from(3.0)).sqrt() } else { Scaled::ZERO };
        let mut found = ZeroEnergy {
            case: SpeedCase::Constant,
            parabola: p.is_zero(),
            omega: Scaled::ONE,
            roots: [Scaled::ZERO; 2],
            half: eta.shift(1),
            eta,
            p,
            offset: Scaled::ZERO,
            energy: energy.clone(),
            delta,
            pole: None,
        };
        let upwards = above_centre(energy, y).sign() > 0;
        if p.is_zero() {
            if q.is_zero() {
                found.pole = Some(Scaled::ZERO);
                return found;
            }
            // v = v_t - q t^2/2.
            let turn = s.shift(1) / (q * -3.0);
            found.roots = [turn; 2];
            found.half = q.abs().shift(-1);
            found.case = if q.is_positive() {
                SpeedCase::Below
            } else if turn.is_positive() {
                SpeedCase::Above
            } else {
                SpeedCase::AbovePole
            };
            if found.case != SpeedCase::Above {
                found.pole = Some((turn.abs() / found.half).sqrt());
            }
            return found;
        }
        let size = p.abs();
        found.omega = size.sqrt();
        let centre = -(q / p).shift(-2);
        if sign == 0 && p.is_negative() {
            found.roots = [centre; 2];
            // v - c at the start.
            found.offset = above_centre(energy, y).to_scaled() / (size * y.to_scaled() * 24.0);
            found.case = match (centre.is_negative(), upwards) {
                (true, _) => SpeedCase::NegativeDouble,
                (_, true) => SpeedCase::AboveDouble,
                _ => SpeedCase::BelowDouble,
            };
            found.pole = (found.case != SpeedCase::AboveDouble).then_some(Scaled::ZERO);
            return found;
        }
        found.half = (delta.abs() / Scaled::from(48.0)).sqrt() / size;
        if sign < 0 {
            found.case = SpeedCase::NoRoot;
            found.roots = [centre; 2];
            // Of half the hyperbolic argument, and with its sign.
            found.pole = Some(asinh(-centre / found.half).shift(-1));
            return found;
        }
        let product = s / (p * 3.0);
        let large = if centre.is_negative() { centre - found.half } else { centre + found.half };
        let small = if large.is_zero() { Scaled::ZERO } else { product / large };
        found.roots = if centre.is_negative() { [large, small] } else { [small, large] };
        let [low, high] = found.roots;
        found.case = match (p.is_positive(), upwards, high.is_positive()) {
            (true, ..) => SpeedCase::Cosine,
            (_, false, _) => SpeedCase::Below,
            (_, _, true) => SpeedCase::Above,
            _ => SpeedCase::AbovePole,
        };
        found.pole = match found.case {
            SpeedCase::Cosine if low.is_positive() => None,
            SpeedCase::Cosine => {
                let gap = found.half.shift(1);
                Some(arcsine((high / gap).sqrt(), (low.abs() / gap).sqrt()))
            }
            SpeedCase::Above => None,
            _ => Some(asinh(found.eta / (found.omega * found.half)).shift(-1)),
        };
        found
    }

    /// Whether it is a cosine, for theta functions with m = 0.
    pub fn circular(&self) -> bool {
        self.case == SpeedCase::Cosine
    }

    pub fn argument(&self, y: &Dyadic, square_speed: &Dyadic) -> Argument {
        let [low, high] = self.roots;
        // |u'| and what belongs to v = 1/y.
        let speed = (square_speed.to_scaled() / Scaled::from(6.0)).sqrt();
        let exact_y = y;
        let y = y.to_scaled();
        let u = y.sqrt();
        let pole = self.pole.map_or(Scaled::ZERO, |_| self.omega * self.until_pole(exact_y, y, u, speed));
        let half_rate = speed / (y * u);
        let offset = || above_centre(&self.energy, exact_y).to_scaled() / (self.p.abs() * y * 24.0);
        let base = match self.case {
            SpeedCase::Cosine => {
                // High y - 1 and 1 - low y, whose product is u'^2/(p y).
                let product = (speed / u).square() * y / (self.p * y);
                let (down, up) = (high * y - Scaled::ONE, Scaled::ONE - low * y);
                let (down, up) =
                    if (down - up).is_negative() { (product / up, up) } else { (down, product / down) };
                let gap = y * self.half.shift(1);
                arcsine((down / gap).sqrt(), (up / gap).sqrt())
            }
            SpeedCase::Above | SpeedCase::AbovePole | SpeedCase::Below if self.parabola => {
                half_rate / self.half
            }
            SpeedCase::Above | SpeedCase::AbovePole | SpeedCase::Below => {
                asinh(half_rate / (self.omega * self.half)).shift(-1)
            }
            SpeedCase::NoRoot => asinh(offset() / self.half).shift(-1),
            SpeedCase::AboveDouble => {
                let ratio = offset() / self.offset;
                // ln of the ratio.
                asinh((ratio - Scaled::ONE / ratio).shift(-1)).shift(-1)
            }
            SpeedCase::BelowDouble | SpeedCase::NegativeDouble | SpeedCase::Constant => pole,
        };
        Argument { base, pole }
    }

    fn until_pole(&self, exact_y: &Dyadic, y: Scaled, u: Scaled, speed: Scaled) -> Scaled {
        let eta = self.eta;
        let sum = speed + y * u * eta;
        let square = if self.p.is_negative() {
            // y (2 eta^2 - q v/2 + 2 eta xi): the first two from exact sums, and where they are below 0 all three by
            // the product with the conjugate.
            let first = (&self.energy.d * exact_y * 2.0 + &self.energy.c).to_scaled() / Scaled::from(6.0);
            let second = (eta * speed / u).shift(1);
            let whole = if first.is_negative() {
                self.delta / (Scaled::from(12.0) * (first - second))
            } else {
                first + second
            };
            whole * y.square()
        } else {
            sum.square() + self.p * y
        };
        let root = square.sqrt();
        u * rf_of_roots([sum, root, root])
    }

    /// Of a motion that stays: y at both ends and their difference, and u'^2 as a factor, a power of y and the values at both ends
    /// of two factors.
    pub fn between(&self) -> Option<Between> {
        let [low, high] = self.roots;
        let (zero, one) = (Scaled::ZERO, Scaled::ONE);
        let gap = self.half.shift(1);
        let size = self.p.abs();
        let from_zero = |v: Scaled| ([zero, one / v], one / v);
        match self.case {
            SpeedCase::Cosine if low.is_positive() => {
                let factors = [[zero, gap / low], [gap / high, zero]];
                Some(([one / high, one / low], gap / (low * high), size, 1, factors))
            }
            SpeedCase::Above => {
                let (ends, width) = from_zero(high);
                if self.parabola {
                    return Some((ends, width, self.half, 2, [[one, zero], [one, one]]));
                }
                Some((ends, width, size, 1, [[one, zero], [one, gap / high]]))
            }
            SpeedCase::AboveDouble if low.is_positive() => {
                let (ends, width) = from_zero(low);
                Some((ends, width, size, 1, [[one, zero]; 2]))
            }
            _ => None,
        }
    }

    /// From |1 - v y| for both roots, of a cosine.
    pub fn argument_of_factors(&self, [of_high, of_low, _]: [Scaled; 3], y: Scaled) -> Scaled {
        let gap = y * self.half.shift(1);
        arcsine((of_high / gap).sqrt(), (of_low / gap).sqrt())
    }

    pub fn outline(&self) -> Outline {
        let at = |v: Scaled| Scaled::ONE / v.sqrt();
        let [low, high] = self.roots;
        let reach = match self.case {
            SpeedCase::Cosine => [at(high), if low.is_positive() { at(low) } else { Scaled::INFINITY }],
            SpeedCase::Above => [Scaled::ZERO, at(high)],
            SpeedCase::Below | SpeedCase::BelowDouble => [at(low), Scaled::INFINITY],
            SpeedCase::AboveDouble if low.is_positive() => [Scaled::ZERO, at(low)],
            _ => [Scaled::ZERO, Scaled::INFINITY],
        };
        Outline {
            reach,
            crosses: false,
            grows: matches!(self.case, SpeedCase::Cosine | SpeedCase::Below),
            pole: self.pole,
            omega: self.omega,
            periodic: self.circular() && self.pole.is_none(),
            limits: if self.case == SpeedCase::AboveDouble { 2 } else { 1 },
        }
    }

    /// The cosine, as theta functions with m = 0.
    pub fn squares(&self) -> Squares {
        let [low, high] = self.roots;
        let gap = self.half.shift(1);
        Squares {
            case: RootCase::Between,
            m: Scaled::ZERO,
            mc: Scaled::ONE,
            squares: if self.pole.is_some() { [gap, gap] } else { [high, low] },
            velocity: gap * self.omega,
        }
    }

    /// The upper root.
    pub fn upper_root(&self) -> Scaled {
        self.roots[1]
    }

    pub fn elementary(&self, start: Argument, orientation: Orientation) -> Elementary {
        let rate = self.omega.signed(orientation.direction);
        let two = self.half.shift(1);
        let functions = if self.parabola { Functions::Power } else { Functions::Sinh };
        let l = if self.parabola { self.half } else { two };
        let squares = |l: Scaled, m: Scaled| Sum::Squares { functions, odd: false, l, m };
        let (sum, factor) = match self.case {
            SpeedCase::Above => (squares(self.roots[1], l), -l),
            SpeedCase::AbovePole => (squares(l, Scaled::ZERO), -l),
            SpeedCase::Below | SpeedCase::Cosine => (squares(l, Scaled::ZERO), l),
            SpeedCase::NoRoot => (Sum::CoshSinh(self.half), -self.half),
            SpeedCase::AboveDouble => (Sum::Exponential { l: self.offset, m: self.roots[0] }, -self.offset),
            SpeedCase::BelowDouble => (Sum::DecayingSinh(self.roots[0]), -self.roots[0]),
            SpeedCase::NegativeDouble => (Sum::GrowingSinh(self.roots[0].abs()), -self.roots[0].abs()),
            SpeedCase::Constant => (Sum::Linear(self.half), -self.half.shift(-1)),
        };
        let one_sided = self.case != SpeedCase::Below;
        Elementary {
            sum,
            base: [start.base, rate],
            rest: [start.pole, if one_sided { rate } else { -rate }],
            pole: self.pole,
            velocity: factor * rate,
            sign: orientation.sign,
        }
    }
}

//! An orbit with E != 0 of the cubic-quintic oscillator: the root case, and the argument of its canonical function at any
//! place, from the base (the passage of u = 0 or a turning point) and to the pole. Each argument is one R_F of Carlson's
//! in which nothing is subtracted.
//!
//! With v = 1/u^2, v'^2 = 4 C(v), C(v) = 2E (v - v0)(v - v1)(v - v2), v0 > v1 > v2, and g_i = 1 - v_i u^2, the time is
//!   from u = 0         u R_F(g0, g1, g2) / sqrt(2E),
//!   from the turn v_k  sqrt|g_k| R_F(|g_i| b_j, |g_j| b_i, b_i b_j u^2) / sqrt|2E|,   b_i = |v_k - v_i|,
//!   to the pole v = 0  R_F of the squares of sqrt|g_i g_j v_k| + u sqrt|v_i v_j g_k|, over sqrt|2E|,
//! and with a complex pair the argument is half of that of cn = (V - H)/(V + H), V = |v - v0|, H^2 = |C'(v0)/2E|.
//! Source: DLMF 19.29.4, 19.25(v); Carlson, Math. Comp. 56 (1991) 267, (2.1).

use super::energy::{EnergyPolynomial, Outline};
use super::quadratic::Quadratic;
use super::roots::{Cubic, Distances, less};
use crate::elliptic::integrals::carlson::{artanh, rf_of_roots};
use crate::float::dyadic::Dyadic;
use crate::float::scaled::Scaled;

/// What the canonical function is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum RootCase {
    /// Through u = 0, v >= v0: u = sn/sqrt(v - v2 by squares), counted from u = 0.
    Crossing,
    /// E > 0, v2 <= v <= v1, counted from the turn v1.
    Inside,
    /// E < 0, v1 <= v <= v0, counted from the turn v0.
    Between,
    /// E < 0, v <= v2, counted from the turn v2.
    Outside,
    /// Crossing, where v1 and v2 are complex.
    PairCrossing,
    /// E < 0, v <= v0, where v1 and v2 are complex; counted from the turn v0.
    PairOutside,
    /// As `Inside` for v0 = v1, counted from the turn v2, or where that would be.
    InsideDouble,
    /// As `Outside` for v1 = v2, counted from where v would be infinite below.
    OutsideDouble,
}

/// Argument from the base, and to the pole; both >= 0.
#[derive(Clone, Copy, Debug)]
pub(super) struct Argument {
    pub base: Scaled,
    pub pole: Scaled,
}

/// C(v), by its roots.
#[derive(Clone, Debug)]
pub(super) enum Polynomial {
    Cubic(Cubic),
    /// Without a quintic force.
    Quadratic(Quadratic),
}

/// What both polynomials answer.
macro_rules! of_both {
    ($($(#[$about:meta])* $method:ident($($name:ident: $type:ty),*) -> $result:ty;)*) => {$(
        $(#[$about])*
        fn $method(&self $(, $name: $type)*) -> $result {
            match self {
                Polynomial::Cubic(cubic) => cubic.$method($($name),*),
                Polynomial::Quadratic(quadratic) => quadratic.$method($($name),*),
            }
        }
    )*};
}

impl Polynomial {
    fn new(energy: &EnergyPolynomial) -> Polynomial {
        let EnergyPolynomial { a, b, c, d } = energy.clone();
        if energy.cubic() {
            Polynomial::Quadratic(Quadratic::new(a, b, c))
        } else {
            Polynomial::Cubic(Cubic::new(a, b, c, d))
        }
    }
    of_both! {
        roots() -> Distances;
        gaps() -> Option<[Scaled; 3]>;
        pair() -> Option<[Scaled; 2]>;
        of_square(y: &Dyadic, value: &Dyadic) -> Distances;
        all_on_one_side(y: &Dyadic) -> bool;
    }
}

/// All that the arguments of an orbit with E != 0 need.
#[derive(Clone, Debug)]
pub(super) struct NonzeroEnergy {
    polynomial: Polynomial,
    pub case: RootCase,
    /// The roots; of a pair the real one, and of the others the square of the modulus and the real part.
    pub roots: Distances,
    /// Gaps 0 to 1, 1 to 2, 0 to 2; of a pair q = |v0 - Re| with its sign, w and H.
    pub gaps: [Scaled; 3],
    /// sqrt|2E|.
    pub speed: Scaled,
    /// Argument per unit of time.
    pub omega: Scaled,
    /// Complement of the parameter; 0 where hyperbolic functions serve, and NaN where powers do.
    pub mc: Scaled,
    /// Argument of the pole, if there is one.
    pub pole: Option<Scaled>,
}

/// 1/sqrt v.
fn inverse_root(v: Scaled) -> Scaled {
    Scaled::ONE / v.sqrt()
}

/// artanh of sqrt(t/n) with 1 - t/n = s/n.
fn artanh_of_squares(t: Scaled, s: Scaled, n: Scaled) -> Scaled {
    artanh((t / n).sqrt(), (s / n).sqrt())
}

impl NonzeroEnergy {
    /// Of an orbit through u^2 = y.
    pub fn new(energy: &EnergyPolynomial, y: &Dyadic) -> NonzeroEnergy {
        let positive = energy.a.sign() > 0;
        let speed = (energy.a.to_scaled().abs() / Scaled::from(6.0)).sqrt();
        let polynomial = Polynomial::new(energy);
        let roots = polynomial.roots();
        let none = Scaled::ZERO;
        let mut found = NonzeroEnergy {
            case: RootCase::Crossing,
            roots,
            gaps: [none; 3],
            speed,
            omega: Scaled::ONE,
            mc: none,
            pole: None,
            polynomial,
        };
        match (roots, found.polynomial.gaps(), found.polynomial.pair()) {
            (Distances::Three(_), Some(gaps), _) => {
                let all = found.polynomial.all_on_one_side(y);
                let [upper, lower, total] = gaps;
                found.gaps = gaps;
                found.case = match (positive, all) {
                    (true, true) => RootCase::Crossing,
                    (true, false) => RootCase::Inside,
                    (false, false) => RootCase::Between,
                    (false, true) => RootCase::Outside,
                };
                if total.is_zero() {
                    found.mc = Scaled::NAN;
                } else {
                    found.mc = if positive { upper } else { lower } / total;
                    found.omega = speed * total.sqrt();
                }
                if !found.mc.is_positive() {
                    found.case = match found.case {
                        RootCase::Inside => RootCase::InsideDouble,
                        RootCase::Outside => RootCase::OutsideDouble,
                        case => case,
                    };
                }
            }
            (_, _, Some([q, w])) => {
                let h = (q.square() + w.square()).sqrt();
                // (H + q)/2H, the smaller of the sums by w^2.
                let sum = if q.is_negative() { w.square() / (h - q) } else { h + q };
                found.gaps = [q, w, h];
                found.case = if positive { RootCase::PairCrossing } else { RootCase::PairOutside };
                found.mc = sum / h.shift(1);
                found.omega = speed * h.sqrt();
            }
            _ => {}
        }
        if found.bounded() == Some(false) {
            found.pole = Some(found.of_pole());
        }
        found
    }

    /// The parameter of the theta functions.
    pub fn m(&self) -> Scaled {
        let [upper, lower, total] = self.gaps;
        match self.case {
            RootCase::Crossing | RootCase::Inside => lower / total,
            RootCase::Between | RootCase::Outside => upper / total,
            _ => {
                let [q, w, h] = self.gaps;
                let difference = if q.is_negative() { h - q } else { w.square() / (h + q) };
                difference / h.shift(1)
            }
        }
    }

    /// Turning point or limit at the far end; `None` where u grows for ever without a pole.
    fn bounded(&self) -> Option<bool> {
        let end = self.end();
        match (end.is_positive(), end.is_zero()) {
            (true, _) => Some(true),
            // A double root 0 is reached by exponentials, a triple one by a straight line: the linear oscillator.
            (_, true) if !self.mc.is_positive() && self.case != RootCase::InsideDouble => None,
            _ => Some(false),
        }
    }
    /// v at the end with the largest |u|; not positive where that is infinite.
    fn end(&self) -> Scaled {
        match (self.case, self.roots) {
            (RootCase::Crossing, Distances::Three(v)) => v[0],
            (RootCase::Inside | RootCase::InsideDouble, Distances::Three(v)) => v[2],
            (RootCase::Between, Distances::Three(v)) => v[1],
            (RootCase::PairCrossing, Distances::One([v, ..])) => v,
            _ => -Scaled::ONE,
        }
    }

    pub fn outline(&self) -> Outline {
        let hyperbolic = !self.mc.is_positive();
        let outer = if self.end().is_positive() { inverse_root(self.end()) } else { Scaled::INFINITY };
        let inner = match (self.case, self.roots) {
            (RootCase::Inside | RootCase::InsideDouble, Distances::Three(v)) => inverse_root(v[1]),
            (RootCase::Between, Distances::Three(v)) => inverse_root(v[0]),
            (RootCase::Outside | RootCase::OutsideDouble, Distances::Three(v)) => inverse_root(v[2]),
            (RootCase::PairOutside, Distances::One([v, ..])) => inverse_root(v),
            _ => Scaled::ZERO,
        };
        let crosses = matches!(self.case, RootCase::Crossing | RootCase::PairCrossing);
        let one_sided = matches!(self.case, RootCase::InsideDouble | RootCase::OutsideDouble);
        Outline {
            reach: [inner, outer],
            crosses,
            grows: !one_sided,
            pole: self.pole,
            omega: self.omega,
            periodic: self.pole.is_none() && !hyperbolic,
            limits: if crosses { 2 } else { 1 },
        }
    }

    /// From y = u^2 and 6 u'^2 there.
    pub fn argument(&self, y: &Dyadic, square_speed: &Dyadic) -> Argument {
        let distances = self.polynomial.of_square(y, square_speed);
        let y = y.to_scaled();
        match (distances, self.roots) {
            (Distances::Three(g), Distances::Three(v)) => {
                let g = g.map(Scaled::abs);
                let base = self.base_of_three(g, y);
                let pole = self.pole.map_or(Scaled::ZERO, |_| self.pole_of_three(g, v.map(Scaled::abs), y));
                Argument { base, pole }
            }
            (Distances::One(here), Distances::One(there)) => self.of_pair(here, there, y),
            _ => Argument { base: Scaled::ZERO, pole: Scaled::ZERO },
        }
    }

    /// From the factors of u'^2 where u^2 = y: |1 - v_i y|, or of a pair 1 - v0 y, |1 - v y|^2 and 1 - y Re v.
    pub fn argument_of_factors(&self, factors: [Scaled; 3], y: Scaled) -> Scaled {
        match self.roots {
            Distances::Three(_) => self.base_of_three(factors, y),
            Distances::One(_) => self.half_argument(factors, y),
        }
    }

    /// The argument of the pole.
    pub fn of_pole(&self) -> Scaled {
        match self.roots {
            Distances::Three(v) => self.base_of_three(v.map(Scaled::abs), Scaled::ONE),
            Distances::One([v, modulus, real]) => self.half_argument([v, modulus, -real], Scaled::ONE),
        }
    }

    /// From |g|, or for the pole from |v| with y = 1.
    fn base_of_three(&self, g: [Scaled; 3], y: Scaled) -> Scaled {
        let [upper, lower, total] = self.gaps;
        if self.mc.is_nan() {
            return (y / g[0]).sqrt() / self.speed;
        }
        let from_turn = |k: usize, others: [(usize, Scaled); 2]| {
            let [(i, bi), (j, bj)] = others;
            let roots = [g[i] * bj, g[j] * bi, bi * bj * y].map(Scaled::sqrt);
            if g[k].is_zero() {
                Scaled::ZERO
            } else {
                self.omega * g[k].sqrt() * rf_of_roots(roots) / self.speed
            }
        };
        if self.mc.is_zero() {
            return match self.case {
                RootCase::Crossing => artanh_of_squares(total * y, g[0], g[2]),
                RootCase::Between => artanh_of_squares(g[0], g[1], y * upper),
                RootCase::InsideDouble => artanh_of_squares(g[2], g[1], y * lower),
                _ => artanh_of_squares(total * y, g[2], g[0]),
            };
        }
        match self.case {
            RootCase::Inside => from_turn(1, [(0, upper), (2, lower)]),
            RootCase::Between => from_turn(0, [(1, upper), (2, total)]),
            RootCase::Outside => from_turn(2, [(0, total), (1, lower)]),
            _ => self.omega * y.sqrt() * rf_of_roots(g.map(Scaled::sqrt)) / self.speed,
        }
    }

    fn pole_of_three(&self, g: [Scaled; 3], v: [Scaled; 3], y: Scaled) -> Scaled {
        let u = y.sqrt();
        let [g, v] = [g.map(Scaled::sqrt), v.map(Scaled::sqrt)];
        let part = |i: usize, j: usize, k: usize| g[i] * g[j] * v[k] + u * v[i] * v[j] * g[k];
        self.omega * rf_of_roots([part(0, 1, 2), part(0, 2, 1), part(1, 2, 0)]) / self.speed
    }

    /// From y (v - v0), y^2 |v - Re - i w|^2 and y (v - Re).
    fn half_argument(&self, [v, pair, leg]: [Scaled; 3], y: Scaled) -> Scaled {
        let [q, w, h] = self.gaps.map(|gap| gap * y);
        let leg = if self.case == RootCase::PairOutside { -leg } else { leg };
        let v = v.abs();
        let sum = v + h;
        // V^2 - H^2 = (V + q)(V - q) - w^2: what is left of V - H counts next to dn where q < 0.
        let cosine =
            if q.is_negative() { (leg * (v - q) - w.square()) / sum.square() } else { (v - h) / sum };
        let (sine, delta) = ((v * h).sqrt().shift(1) / sum, pair.sqrt() / sum);
        let near = sine * rf_of_roots([cosine.abs(), delta, Scaled::ONE]);
        // `near` is counted from where cn = 1 or -1, whichever is nearer; the base is V infinite when crossing, else 0.
        let from_infinity = !cosine.is_negative();
        let whole = || self.half_period();
        let argument =
            if from_infinity == (self.case == RootCase::PairCrossing) { near } else { whole() - near };
        argument.shift(-1)
    }

    /// 2K.
    fn half_period(&self) -> Scaled {
        rf_of_roots([Scaled::ZERO, self.mc.sqrt(), Scaled::ONE]).shift(1)
    }

    fn of_pair(&self, here: [Scaled; 3], there: [Scaled; 3], y: Scaled) -> Argument {
        let base = self.half_argument(here, y);
        let Some(pole) = self.pole else { return Argument { base, pole: Scaled::ZERO } };
        // ds^2 of the argument to the pole, and cs^2, which keeps its digits while the pole is near.
        let [_, w, h] = self.gaps;
        let ([g, pair, leg], [v, modulus, real]) = (here, there);
        let (x, eta) = (modulus.sqrt(), pair.sqrt());
        let beyond = |root: Scaled, leg: Scaled, w: Scaled| {
            if leg.is_negative() { root - leg } else { w.square() / (root + leg) }
        };
        // xi + eta - v (times y), with one leg on each side of the real part.
        let narrow = beyond(eta, leg, w * y) + beyond(x, real, w) * y;
        let wide = eta + x * y + Scaled::ONE;
        let ends = (g.abs().sqrt() + v.abs().sqrt() * y.sqrt()).square();
        let ds = ends * narrow * wide / (h.shift(2) * y);
        let cs = ds - self.mc;
        let near = self.mc.sqrt().shift(-1);
        let rest = if less(near, cs) {
            rf_of_roots([cs.sqrt(), ds.sqrt(), (cs + Scaled::ONE).sqrt()])
        } else {
            pole - base
        };
        Argument { base, pole: rest }
    }
}

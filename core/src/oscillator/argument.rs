//! Where an orbit of the cubic-quintic oscillator is, as argument of its canonical function: how far from its base (the
//! passage of u = 0 or a turning point) and how far from its pole, each by Carlson's R_F, in which nothing is subtracted.
//!
//! With v = 1/u^2, v'^2 = 4 C(v), C(v) = 2E (v - v0)(v - v1)(v - v2), v0 > v1 > v2, and g_i = 1 - v_i u^2, the time is
//!   from u = 0         u R_F(g0, g1, g2) / sqrt(2E),
//!   from the turn v_k  sqrt|g_k| R_F(|g_i| b_j, |g_j| b_i, b_i b_j u^2) / sqrt|2E|,   b_i = |v_k - v_i|,
//!   to the pole v = 0  R_F of the squares of sqrt|g_i g_j v_k| + u sqrt|v_i v_j g_k|, over sqrt|2E|,
//! and with a complex pair the argument is half of that of cn = (V - H)/(V + H), V = |v - v0|, H^2 = |C'(v0)/2E|.
//! Source: DLMF 19.29.4, 19.25(v); Carlson, Math. Comp. 56 (1991) 267, (2.1).

use super::cubic_phase::{artanh, rf};
use super::quintic_exact::Exact;
use super::roots::{Cubic, Distances, less};
use crate::float::scaled::Scaled;

/// What the canonical function is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
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
    Falling,
    /// As `Outside` for v1 = v2, counted from where v would be infinite below.
    Sinking,
}

/// Argument from the base, and to the pole; both >= 0.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mark {
    pub base: Scaled,
    pub pole: Scaled,
}

/// All that the marks of an orbit with E != 0 need.
#[derive(Clone, Debug)]
pub(super) struct Marks {
    pub cubic: Cubic,
    pub form: Form,
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

/// artanh of sqrt(t/n) with 1 - t/n = s/n.
fn artanh_of_squares(t: Scaled, s: Scaled, n: Scaled) -> Scaled {
    artanh((t / n).sqrt(), (s / n).sqrt())
}

impl Marks {
    /// From y = u^2 and 6 u'^2 there.
    pub fn at(&self, y: &Exact, square_speed: &Exact) -> Mark {
        let distances = self.cubic.of_square(y, square_speed);
        let y = y.to_wide();
        match (distances, self.roots) {
            (Distances::Three(g), Distances::Three(v)) => {
                let g = g.map(Scaled::abs);
                let base = self.base_of_three(g, y);
                let pole = self.pole.map_or(Scaled::ZERO, |_| self.pole_of_three(g, v.map(Scaled::abs), y));
                Mark { base, pole }
            }
            (Distances::One(here), Distances::One(there)) => self.of_pair(here, there, y),
            _ => Mark { base: Scaled::ZERO, pole: Scaled::ZERO },
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
            if g[k].is_zero() { Scaled::ZERO } else { self.omega * g[k].sqrt() * rf(roots) / self.speed }
        };
        if self.mc.is_zero() {
            return match self.form {
                Form::Crossing => artanh_of_squares(total * y, g[0], g[2]),
                Form::Between => artanh_of_squares(g[0], g[1], y * upper),
                Form::Falling => artanh_of_squares(g[2], g[1], y * lower),
                _ => artanh_of_squares(total * y, g[2], g[0]),
            };
        }
        match self.form {
            Form::Inside => from_turn(1, [(0, upper), (2, lower)]),
            Form::Between => from_turn(0, [(1, upper), (2, total)]),
            Form::Outside => from_turn(2, [(0, total), (1, lower)]),
            _ => self.omega * y.sqrt() * rf(g.map(Scaled::sqrt)) / self.speed,
        }
    }

    fn pole_of_three(&self, g: [Scaled; 3], v: [Scaled; 3], y: Scaled) -> Scaled {
        let u = y.sqrt();
        let [g, v] = [g.map(Scaled::sqrt), v.map(Scaled::sqrt)];
        let part = |i: usize, j: usize, k: usize| g[i] * g[j] * v[k] + u * v[i] * v[j] * g[k];
        self.omega * rf([part(0, 1, 2), part(0, 2, 1), part(1, 2, 0)]) / self.speed
    }

    /// From y (v - v0), y^2 |v - Re - i w|^2 and y (v - Re).
    fn half_argument(&self, [v, pair, leg]: [Scaled; 3], y: Scaled) -> Scaled {
        let [q, w, h] = self.gaps.map(|gap| gap * y);
        let leg = if self.form == Form::PairOutside { -leg } else { leg };
        let v = v.abs();
        let sum = v + h;
        // V^2 - H^2 = (V + q)(V - q) - w^2: what is left of V - H counts next to dn where q < 0.
        let cosine =
            if q.is_negative() { (leg * (v - q) - w.square()) / sum.square() } else { (v - h) / sum };
        let (sine, delta) = ((v * h).sqrt().shift(1) / sum, pair.sqrt() / sum);
        let near = sine * rf([cosine.abs(), delta, Scaled::ONE]);
        // `near` is counted from where cn = 1 or -1, whichever is nearer; the base is V infinite when crossing, else 0.
        let from_infinity = !cosine.is_negative();
        let whole = || self.half_period();
        let argument = if from_infinity == (self.form == Form::PairCrossing) { near } else { whole() - near };
        argument.shift(-1)
    }

    /// 2K.
    fn half_period(&self) -> Scaled {
        rf([Scaled::ZERO, self.mc.sqrt(), Scaled::ONE]).shift(1)
    }

    fn of_pair(&self, here: [Scaled; 3], there: [Scaled; 3], y: Scaled) -> Mark {
        let base = self.half_argument(here, y);
        let Some(pole) = self.pole else { return Mark { base, pole: Scaled::ZERO } };
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
        let rest =
            if less(near, cs) { rf([cs.sqrt(), ds.sqrt(), (cs + Scaled::ONE).sqrt()]) } else { pole - base };
        Mark { base, pole: rest }
    }
}

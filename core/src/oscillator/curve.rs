//! The curve Y^2 = 4 X^3 - g2 X - g3 of a quartic: its roots, the times of its points, and the theta functions of the time.
//!
//! Differences of its roots come by a third of an angle or by cube roots of one sign (roots.rs), so that m and 1 - m need no
//! subtraction; times are Carlson's R_F of distances that do not cancel. With the frequency W, S(t) = s(Wt)/W and C = c(Wt) of
//! Neville's functions where three roots are real, else S = s d/W and C = c n: then wp(t) - e1 = W^2 C^2/(W S)^2. Where roots
//! coincide these are circular (m = 0) or hyperbolic functions (m = 1), or powers (all three).
//! Source: DLMF 19.25(vi), 20.9, 23.6; A & S 16.36.

use super::quartic::{Point, Quartic};
use super::roots::{Roots, less, one, three};
use crate::elliptic::integrals::carlson::rf_of_roots;
use crate::elliptic::theta::neville::{NevilleTheta, Thetas};
use crate::float::Dd;
use crate::float::scaled::Scaled;

/// Differences of the roots.
#[derive(Clone, Copy, Debug)]
pub(super) enum Gaps {
    /// e1 - e2, e2 - e3, e1 - e3.
    Three([Scaled; 3]),
    /// 3 e1/2, with the imaginary part of the others.
    Pair { q: Scaled, w: Scaled },
}

/// The functions of the time.
#[derive(Clone, Debug)]
pub(super) enum Family {
    Theta(Box<NevilleTheta>),
    /// m = 1.
    Hyperbolic,
    /// All roots are 0.
    Power,
}

/// A curve, set up once.
#[derive(Clone, Debug)]
pub(super) struct Curve {
    pub gaps: Gaps,
    /// e1; and e2, e3 where they are real.
    pub roots: [Scaled; 3],
    /// W^2.
    pub square: Scaled,
    /// W; 1 for powers.
    pub rate: Scaled,
    pub m: Scaled,
    pub mc: Scaled,
    kc: Scaled,
    pub family: Family,
    /// 2K, and the real period 2K/W: infinite for a degenerate curve.
    pub half: Scaled,
    pub period: Scaled,
}

/// Neville's functions, s with the unit of the argument.
#[derive(Clone, Copy, Debug)]
pub(super) struct NevilleFunctions {
    pub s: Scaled,
    pub c: Scaled,
    pub d: Scaled,
    pub n: Scaled,
}

/// k' below which its nome is nothing beside 1, in double-double, as a power of two.
const NOTHING: i32 = -120;

/// Beyond, hyperbolic functions have their limits.
const FAR: f64 = 1e7;

impl Curve {
    pub fn new(quartic: &Quartic) -> Curve {
        let [i, j] = [&quartic.i, &quartic.j].map(|x| x.to_scaled().shift(-2));
        let root = quartic.discriminant.to_scaled().abs().sqrt().shift(-2);
        let sixth = |x: Scaled| x / Scaled::from(6.0);
        let none = Scaled::ZERO;
        let found =
            if quartic.discriminant.sign() >= 0 { three(-i, -j, root, false) } else { one(-i, -j, root) };
        let (gaps, roots, square, m, mc) = match found {
            Roots::Three { z, gaps } => {
                let gaps = gaps.map(sixth);
                let [g12, g23, g13] = gaps;
                let ratio = |x: Scaled| if g13.is_zero() { none } else { x / g13 };
                (Gaps::Three(gaps), z.map(sixth), g13, ratio(g23), ratio(g12))
            }
            Roots::One { z, w } => {
                let (z, w) = (sixth(z), sixth(w));
                let q = z * 1.5;
                let h = (q.square() + w.square()).sqrt();
                let more = h + q.abs();
                let (large, small) = (more / h.shift(1), w.square() / (more * h.shift(1)));
                let (m, mc) = if q.is_negative() { (large, small) } else { (small, large) };
                (Gaps::Pair { q, w }, [z; 3], h, m, mc)
            }
        };
        let (family, half) = if square.is_zero() {
            (Family::Power, Scaled::INFINITY)
        } else if mc.is_zero() {
            (Family::Hyperbolic, Scaled::INFINITY)
        } else {
            let neville = NevilleTheta::of_scaled(m, mc);
            let half = Scaled::from(neville.quarter).shift(1);
            (Family::Theta(Box::new(neville)), half)
        };
        let rate = if square.is_zero() { Scaled::ONE } else { square.sqrt() };
        Curve { gaps, roots, square, rate, m, mc, kc: mc.sqrt(), family, half, period: half / rate }
    }

    /// Whether three roots are real.
    pub fn three(&self) -> bool {
        matches!(self.gaps, Gaps::Three(_))
    }

    /// The theta functions, unless they degenerate.
    pub fn neville(&self) -> Option<&NevilleTheta> {
        if let Family::Theta(neville) = &self.family { Some(neville) } else { None }
    }

    /// The least t > 0 with wp(t) = X, or for a point of the oval the t >= 0 with wp(t + i omega') = X.
    pub fn time(&self, Point { x, product, pairs }: Point, on_oval: bool) -> Scaled {
        match self.gaps {
            Gaps::Three([g12, g23, g13]) if on_oval => {
                let (mut p2, mut p3) = (self.roots[1] - x, x - self.roots[2]);
                let p1;
                if less(p2, p3) {
                    let rest = product / p3;
                    p2 = smaller(rest, g12);
                    p1 = p2 + g12;
                } else {
                    p1 = p2 + g12;
                    p3 = product / (p1 * p2);
                }
                let roots = [p2 / g23, p1 / g13, Scaled::ONE].map(Scaled::sqrt);
                (p3 / g23).sqrt() * rf_of_roots(roots) / self.rate
            }
            Gaps::Three([g12, ..]) => {
                let d3 = x - self.roots[2];
                let d1 = smaller(product / d3, g12);
                rf_of_roots([d1, d1 + g12, d3].map(Scaled::sqrt))
            }
            Gaps::Pair { w, .. } => {
                let [d1, pair, leg] = self.of_pair(x, product, Some(pairs), w);
                self.time_of_pair(d1, pair, leg)
            }
        }
    }

    /// X - e1, |X - e2|^2 and X - Re e2.
    pub fn of_pair(&self, x: Scaled, product: Scaled, pairs: Option<Scaled>, w: Scaled) -> [Scaled; 3] {
        let (d1, leg) = (x - self.roots[0], x + self.roots[0].shift(-1));
        let pair = leg.square() + w.square();
        if less(d1.square(), pair) {
            return [product / pair, pair, leg];
        }
        let pair = product / d1;
        let leg = pairs.map_or(leg, |pairs| (pairs - pair) / d1.shift(1));
        [d1, pair, leg]
    }

    fn time_of_pair(&self, d1: Scaled, pair: Scaled, leg: Scaled) -> Scaled {
        let Gaps::Pair { q, w } = self.gaps else { return Scaled::NAN };
        let h = self.square;
        let sum = d1 + h;
        let cosine =
            if q.is_negative() { (leg * (d1 - q) - w.square()) / sum.square() } else { (d1 - h) / sum };
        let near =
            (d1 * h).sqrt().shift(1) / sum * rf_of_roots([cosine.abs(), pair.sqrt() / sum, Scaled::ONE]);
        let argument = if cosine.is_negative() { self.half - near } else { near };
        argument / self.rate.shift(1)
    }

    /// The time in [0, period/2] with wp(t) - e1 = `distance`.
    pub fn time_of_distance(&self, distance: Scaled) -> Scaled {
        if !distance.is_finite() {
            return Scaled::ZERO;
        }
        match self.gaps {
            Gaps::Three([g12, _, g13]) => {
                rf_of_roots([distance, distance + g12, distance + g13].map(Scaled::sqrt))
            }
            Gaps::Pair { q, w } => {
                let leg = distance + q;
                self.time_of_pair(distance, leg.square() + w.square(), leg)
            }
        }
    }

    /// Neville's functions at a time.
    pub fn values(&self, t: Scaled) -> NevilleFunctions {
        let one = Scaled::ONE;
        match &self.family {
            Family::Power => NevilleFunctions { s: t, c: one, d: one, n: one },
            Family::Hyperbolic => {
                let x = t * self.rate;
                let x = if x.abs().value() < FAR { x } else { Scaled::from(FAR).signed(x.sign()) };
                let (s, n) = x.sinh_cosh();
                NevilleFunctions { s, c: one, d: one, n }
            }
            Family::Theta(neville) => self.thetas(neville, t),
        }
    }

    fn thetas(&self, neville: &NevilleTheta, t: Scaled) -> NevilleFunctions {
        let one = Scaled::ONE;
        let f = t / self.period;
        if f.power() < -150 || f.is_zero() {
            return NevilleFunctions { s: t * self.rate, c: one, d: one, n: one };
        }
        let count = f.value().round();
        let rest = (f - Scaled::from(count)).to_dd();
        let (sign, parity) = (rest.hi, if count % 2.0 == 0.0 { 1.0 } else { -1.0 });
        let rest = rest.abs();
        let folded = rest.hi > 0.25;
        let v = if folded { Dd::from(0.5) - rest } else { rest };
        let hyperbolic = neville.hyperbolic();
        let gauss = if hyperbolic { Scaled::exp(-(v.square() * neville.angle)) } else { one };
        let near = if hyperbolic && self.kc.power() < NOTHING {
            let (s, n) = (Scaled::from(v) * self.half).sinh_cosh();
            NevilleFunctions { s: s * gauss, c: gauss, d: gauss, n: n * gauss }
        } else {
            let Thetas { theta: [s, c, d, n], .. } = neville.long_thetas(v);
            let [s, c, d, n] = [s * neville.theta1_factor, c, d, n].map(|x| Scaled::from(x) * gauss);
            NevilleFunctions { s, c, d, n }
        };
        let NevilleFunctions { s, c, d, n } = near;
        let values = if folded {
            let root = self.kc.sqrt();
            NevilleFunctions { s: c / root, c: s * root, d: n * root, n: d / root }
        } else {
            near
        };
        NevilleFunctions { s: values.s.signed(sign * parity), c: values.c.signed(parity), ..values }
    }

    /// S(t), C(t) and S'(t) C(t) - S(t) C'(t).
    pub fn pair(&self, t: Scaled) -> [Scaled; 3] {
        let NevilleFunctions { s, c, d, n } = self.values(t);
        if self.three() {
            return [s / self.rate, c, d * n];
        }
        let fourth = d.square().square() + self.m * self.mc * s.square().square();
        [s * d / self.rate, c * n, fourth]
    }

    /// S(t).
    pub fn sine(&self, t: Scaled) -> Scaled {
        self.pair(t)[0]
    }
}

/// The smaller root of d (d + gap) = rest.
fn smaller(rest: Scaled, gap: Scaled) -> Scaled {
    let sum = gap + (gap.square() + rest.shift(2)).sqrt();
    if sum.is_zero() { Scaled::ZERO } else { rest.shift(1) / sum }
}

//! A bounded motion as the weighted mean of its turning points: u = (b C^2 + a R S^2)/(C^2 + R S^2), S and C of the time from the
//! turning point b (curve.rs), a the other one.
//!
//! The weight R comes from the point of the curve at which u is infinite: products and quotients of the roots of its distances
//! from e1, e2, e3. No sum cancels, and of a separatrix a is the limit.
//! Source: derived; Byrd & Friedman 250 to 260 have the cases by real roots.

use super::curve::{Curve, Gaps};
use super::quartic::Quartic;
use crate::float::scaled::Scaled;

/// A bounded motion, set up once.
#[derive(Clone, Debug)]
pub(super) struct Mean {
    pub curve: Curve,
    /// When it is at its base, the turning point nearest to the start.
    pub at_base: Scaled,
    pub base: Scaled,
    /// The other turning point, or the limit; and the way there.
    pub other: Scaled,
    pub way: Scaled,
    /// R, in 1/time^2.
    pub weight: Scaled,
}

impl Mean {
    /// Of a start whose time to the same place with the other velocity is `turned`.
    pub fn new(quartic: &Quartic, curve: Curve, turned: Scaled) -> Mean {
        let at_base = turned.shift(-1);
        let moves = quartic.velocity0.sign() != 0;
        let upper = if moves {
            at_base.is_positive() == (quartic.velocity0.sign() > 0)
        } else {
            quartic.force.sign() < 0
        };
        let weight = if quartic.linear() { curve.square } else { weight(quartic, &curve, upper) };
        let [sine, cosine, slope] = curve.pair(at_base);
        let sum = cosine.square() + weight * sine.square();
        let (u0, v0, force) =
            (quartic.u0.to_scaled(), quartic.velocity0.to_scaled(), quartic.force.to_scaled());
        let (base, way) = if moves {
            // S(2t) = 2 S C (S'C - SC').
            let there = v0 / (sine * cosine * slope).shift(1);
            (u0 + there * sine.square() * sum, -(there * sum.square()) / weight)
        } else {
            (u0, force / weight.shift(1))
        };
        let other = base + way;
        let [base, other] =
            [base, other].map(|u| polished(quartic, u, way.abs() + base.abs(), curve.mc.is_zero()));
        Mean { curve, at_base, base, other, way, weight }
    }

    /// u and u' at a time from the base.
    pub fn at(&self, t: Scaled) -> [Scaled; 2] {
        let [sine, cosine, slope] = self.curve.pair(t);
        let (near, far) = (cosine.square(), self.weight * sine.square());
        let sum = near + far;
        let u = if (near - far).is_negative() {
            self.other - self.way * near / sum
        } else {
            self.base + self.way * far / sum
        };
        let velocity = (self.way * self.weight * sine).shift(1) * cosine * slope / sum.square();
        [u, velocity]
    }

    /// The time from the base, up to the other end, at which u is passed; none outside.
    pub fn time_of(&self, u: Scaled) -> Option<Scaled> {
        let (from_base, to_other) =
            ((u - self.base).signed(self.way.sign()), (self.other - u).signed(self.way.sign()));
        if from_base.is_negative() || to_other.is_negative() {
            return None;
        }
        Some(self.curve.time_of_distance(self.weight * to_other / from_base))
    }
}

/// The weight of the other turning point, from the nearer one: the `upper` one or the lower one.
fn weight(quartic: &Quartic, curve: &Curve, upper: bool) -> Scaled {
    let q = quartic.q.to_scaled();
    let lead = q.abs().shift(-1);
    let g = quartic.g.sign();
    let Gaps::Three([g12, _, g13]) = curve.gaps else {
        let Gaps::Pair { w, .. } = curve.gaps else { return Scaled::NAN };
        let point = quartic.infinity();
        let [d1, pair, leg] = curve.of_pair(point.x, point.product, Some(point.pairs), w);
        let (first, modulus, real) = ((lead * d1).abs(), lead * pair.sqrt(), -lead * leg);
        let root = if real.is_negative() {
            lead * w / (modulus - real).shift(1).sqrt()
        } else {
            (modulus + real).shift(-1).sqrt()
        };
        let wide = (first + modulus + (first.sqrt() * root).shift(1)) / lead;
        return if g == 0 || (g > 0) == upper { wide } else { curve.square.square() / wide };
    };
    if q.is_zero() {
        return if (g > 0) == upper { g12 } else { g13 };
    }
    let point = quartic.infinity();
    let [r1, r2, r3] = distances(curve, point.x, point.product).map(|d| (lead * d).abs().sqrt());
    if q.is_negative() {
        return if (g > 0) == upper { g12 * (r1 + r3) / (r1 + r2) } else { g13 * (r1 + r2) / (r1 + r3) };
    }
    let right = quartic.right();
    let plus = if right { g > 0 } else { g < 0 };
    let (wide, narrow) = ((r1 + r3), g13 * lead / (r1 + r3));
    if upper == right {
        (r1 + r2) * if plus { wide } else { narrow } / lead
    } else {
        g12 / (r1 + r2) * if plus { narrow } else { wide }
    }
}

/// X - e1, X - e2 and X - e3 where three roots are real, from X and the product: below all, or above all.
pub(super) fn distances(curve: &Curve, x: Scaled, product: Scaled) -> [Scaled; 3] {
    let Gaps::Three([g12, g23, _]) = curve.gaps else { return [Scaled::NAN; 3] };
    let small = |rest: Scaled, gap: Scaled| {
        let sum = gap + (gap.square() + rest.shift(2)).sqrt();
        if sum.is_zero() { sum } else { rest.shift(1) / sum }
    };
    if product.is_negative() || (product.is_zero() && x.is_negative()) {
        let p1 = curve.roots[0] - x;
        let p3 = small(-product / p1, g23);
        return [-p1, -(p3 + g23), -p3];
    }
    let above = x - curve.roots[0];
    if above.is_negative()
        && (x - curve.roots[2]).is_positive()
        && !(x - curve.roots[1] - above.abs()).is_positive()
    {
        // On the oval.
        let (mut p2, mut p3) = (curve.roots[1] - x, x - curve.roots[2]);
        if (p3 - p2).is_positive() {
            p2 = small(product / p3, g12);
        } else {
            p3 = product / (p2 * (p2 + g12));
        }
        return [-(p2 + g12), -p2, p3];
    }
    let d3 = x - curve.roots[2];
    let d1 = small(product / d3, g12);
    [d1, d1 + g12, d3]
}

/// A root of P nearby to all digits, by Newton's steps from exact values; of P' where the other end is a double root.
pub(super) fn polished(quartic: &Quartic, near: Scaled, size: Scaled, double_too: bool) -> Scaled {
    let mut best = near;
    for _ in 0..4 {
        let u = best.value();
        if !u.is_finite() {
            return best;
        }
        let [value, slope, bend] = quartic.values(u);
        // A simple root, if the step is small beside the distance of the next.
        let mut step = -value / slope;
        let mut bent = (step * bend / slope).abs();
        if double_too && !(bent.is_finite() && bent.value() < 0.1) {
            step = -slope / bend;
            bent = Scaled::ZERO;
        }
        let moved = (Scaled::from(u) + step - near).abs();
        if !(step.is_finite() && bent.value() < 0.1 && moved.value() <= size.shift(-44).value()) {
            return best;
        }
        best = Scaled::from(u) + step;
        // From the same double the next step would be the same.
        if step.is_zero() || best.value() == u {
            return best;
        }
    }
    best
}

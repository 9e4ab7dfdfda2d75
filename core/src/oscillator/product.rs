//! An escape as a product of theta functions: u = u0 + u0' S(t) T(t - z)/T(-z) R, R = S(p1)/S(p1 - t) T(p2)/T(p2 - t), and
//! u' = u0' T(2t - z)/T(-z) R^2, with the times p1 and p2 of the poles and z of the start with the other velocity.
//!
//! T is S; where P has no real root, and where the motion has no turning point, p2 and z are half an imaginary period away, and
//! T is Neville's n. From rest u = u0 + f S(t)^2 R/2 and u' = f S(2t) R^2/2. Nothing is subtracted but u from u0, once.
//! Source: derived from DLMF 23.2(iii), 20.7(i).

use super::curve::{Curve, Gaps};
use super::quartic::{Point, Quartic};
use crate::float::scaled::Scaled;

/// An escape, set up once.
#[derive(Clone, Debug)]
pub(super) struct Product {
    pub curve: Curve,
    /// u0'; and f/2 for a start from rest.
    pub lead: Scaled,
    pub moves: bool,
    /// Without a turning point.
    pub passes: bool,
    pub turned: Scaled,
    pub poles: [Scaled; 2],
    /// Backward and forward.
    pub escapes: [Scaled; 2],
    /// T(-z), or 1 for a start from rest, and S(p1) T(p2).
    at_start: Scaled,
    at_poles: Scaled,
}

impl Product {
    pub fn new(quartic: &Quartic, curve: Curve, turned: Scaled, passes: bool) -> Product {
        let moves = quartic.velocity0.sign() != 0;
        let mut poles = poles(quartic, &curve, turned, passes);
        let mut turned = turned;
        if passes {
            turned = poles[0] + poles[1];
        }
        let period = curve.period;
        let shifted = |by: f64| {
            move |p: Scaled| if period.is_finite() { p + period * by } else { Scaled::INFINITY * by }
        };
        let real = if passes { &poles[..1] } else { &poles[..] };
        let ahead = real.iter().map(|p| if p.is_positive() { *p } else { shifted(1.0)(*p) });
        let behind = real.iter().map(|p| if p.is_negative() { *p } else { shifted(-1.0)(*p) });
        let nearest = |a: Scaled, b: Scaled| if (a - b).is_negative() { a } else { b };
        let ahead = ahead.fold(Scaled::INFINITY, nearest);
        let behind = behind.map(|p| -p).fold(Scaled::INFINITY, nearest);
        if quartic.q.sign() == 0 {
            // Both are one.
            poles[1] = poles[0];
        }
        let mut product = Product {
            curve,
            lead: if moves { quartic.velocity0.to_scaled() } else { quartic.force.to_scaled().shift(-1) },
            moves,
            passes,
            turned,
            poles,
            escapes: [-behind, ahead],
            at_start: Scaled::ONE,
            at_poles: Scaled::ONE,
        };
        if moves {
            product.at_start = product.other(-turned);
        }
        product.at_poles = product.curve.sine(poles[0]) * product.other(poles[1]);
        product
    }

    /// T.
    fn other(&self, t: Scaled) -> Scaled {
        if self.passes { self.curve.values(t).n } else { self.curve.sine(t) }
    }

    /// The factors of u - u0 and of u' beside functions of the argument: W S and n, or W S alone.
    pub fn leads(&self) -> [Scaled; 2] {
        let rate = self.curve.rate;
        let lead = self.lead * self.at_poles / self.at_start;
        let powers = if self.passes { rate.square() } else { rate.square() * rate };
        [lead, lead * self.at_poles * powers]
    }

    /// When it turns, if it does: between two escapes, at half the time z, or half a period from there.
    pub fn turn(&self) -> Option<Scaled> {
        let [behind, ahead] = self.escapes;
        if self.passes || !behind.is_finite() || !ahead.is_finite() {
            return None;
        }
        let at = self.turned.shift(-1);
        let half = self.curve.period.shift(-1);
        if !half.is_finite() {
            return Some(at);
        }
        let count = (((behind + ahead).shift(-1) - at) / half).value().round();
        Some(at + half * count)
    }

    /// u - u0 and u' at a time; NaN at the escapes and beyond.
    pub fn at(&self, t: Scaled) -> [Scaled; 2] {
        let [behind, ahead] = self.escapes;
        if !((t - behind).is_positive() && (ahead - t).is_positive()) {
            return [Scaled::NAN; 2];
        }
        let [p1, p2] = self.poles;
        let ratio = self.at_poles / (self.curve.sine(p1 - t) * self.other(p2 - t));
        let sine = self.curve.sine(t);
        if self.moves {
            let lead = self.lead / self.at_start;
            [
                lead * sine * self.other(t - self.turned) * ratio,
                lead * self.other(t.shift(1) - self.turned) * ratio.square(),
            ]
        } else {
            [self.lead * sine.square() * ratio, self.lead * self.curve.sine(t.shift(1)) * ratio.square()]
        }
    }
}

/// The times of the poles: from the start directly, and where they are not near as half the difference of two times that keep
/// their digits.
fn poles(quartic: &Quartic, curve: &Curve, turned: Scaled, passes: bool) -> [Scaled; 2] {
    let [q, rho, sigma, force, v] =
        [&quartic.q, &quartic.rho, &quartic.sigma, &quartic.force, &quartic.velocity0].map(|x| x.to_scaled());
    let root = (-q).shift(-1).sqrt();
    let rising = quartic.velocity0.sign() >= 0;
    let middle = -sigma / Scaled::from(12.0);
    let apart = (root * v.abs()).shift(-1);
    let first = -(v * rho) / Scaled::from(6.0);
    let second = (root * force).shift(-1).signed(if rising { 1.0 } else { -1.0 });
    // The products of the X and of the Y, exactly.
    let x_product =
        (quartic.sigma.square() + &quartic.q * &quartic.speed2 * 18.0).to_scaled() / Scaled::from(144.0);
    let y_product = (quartic.rho.square() * &quartic.speed2 * 2.0
        + &quartic.q * quartic.force.square() * 9.0)
        .to_scaled()
        / Scaled::from(72.0);
    let over = |a: Scaled, b: Scaled| if b.is_zero() { Scaled::ZERO } else { a / b };
    let x = if middle.is_negative() {
        [over(x_product, middle - apart), middle - apart]
    } else {
        [middle + apart, over(x_product, middle + apart)]
    };
    let y = if first.is_negative() == second.is_negative() {
        let larger = -(first + second);
        [larger, over(y_product, larger)]
    } else {
        let larger = second - first;
        [over(y_product, larger), larger]
    };
    let is_double = quartic.q.sign() == 0;
    let between = if is_double {
        Scaled::ZERO
    } else {
        let point = quartic.infinity();
        let oval = curve.three() && on_oval(curve, point.x);
        curve.time(point, oval)
    };
    let g = quartic.g.sign();
    let half = curve.period.shift(-1);
    [0, 1].map(|k| {
        let oval = passes && k == 1;
        let time =
            curve.time(Point { x: x[k], product: y[k].square().shift(-2), pairs: pairs(curve, x[k]) }, oval);
        let before = y[k].is_positive() != oval;
        let direct = if before { -time } else { time };
        let near = (x[k] - curve.roots[0] - curve.square.shift(1)).is_positive();
        if near || !half.is_finite() {
            return direct;
        }
        if passes {
            return nearest(turned, between, half, direct);
        }
        let sign = if (k == 0) == rising { 1.0 } else { -1.0 };
        let other = between.signed(if g < 0 { -sign } else { sign });
        let upper = if quartic.velocity0.sign() != 0 {
            turned.is_positive() == (quartic.velocity0.sign() > 0)
        } else {
            quartic.force.sign() < 0
        };
        let high = if is_double { quartic.rho.sign() < 0 } else { g >= 0 };
        let p = (turned - other).shift(-1) + if upper == high { Scaled::ZERO } else { half };
        p - curve.period * (p / curve.period).value().round()
    })
}

/// Of (z +- chi)/2 and what lies half periods beside them, the one next to a time.
fn nearest(turned: Scaled, between: Scaled, half: Scaled, time: Scaled) -> Scaled {
    let mut best = time;
    let mut least = f64::INFINITY;
    for sign in [1.0, -1.0] {
        let from = (turned + between.signed(sign)).shift(-1);
        let count = ((time - from) / half).value().round();
        let found = from + half * count;
        let distance = ((found - time) / half).value().abs();
        if distance < least {
            (best, least) = (found, distance);
        }
    }
    best
}

/// 3 X^2 - g2/4 in doubles of doubles: the sum of the products of two distances.
fn pairs(curve: &Curve, x: Scaled) -> Scaled {
    match curve.gaps {
        Gaps::Three(_) => Scaled::NAN,
        Gaps::Pair { w, .. } => {
            let (d1, leg) = (x - curve.roots[0], x + curve.roots[0].shift(-1));
            (d1 * leg).shift(1) + leg.square() + w.square()
        }
    }
}

/// Whether X lies between e3 and e2.
fn on_oval(curve: &Curve, x: Scaled) -> bool {
    let [e1, e2, _] = curve.roots;
    (x.shift(1) - e1 - e2).is_negative()
}

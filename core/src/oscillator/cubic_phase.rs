//! The phase of a place on an orbit, and the canonical form it belongs to.
//!
//! Phases are counted from the zero, the turning point or the pole next to the place, so that they keep their digits
//! there; each by Carlson's R_F from u and u' both, in which nothing is subtracted:
//!   from a zero of u    u R_F(a1 a2, a2 (a1 + b1 u^2), a1 (a2 + b2 u^2))   where u'^2 = (a1 + b1 u^2)(a2 + b2 u^2),
//!   to a pole of u      sqrt(2/|q|) R_F(u^2, u^2 - r1, u^2 - r2)           where u'^2 = |q|/2 (u^2 - r1)(u^2 - r2).
//! Source: DLMF 19.25(v), 19.29(i), 22.15; Carlson, Math. Comp. 53 (1989) 327.

use super::cubic_course::{CARRIED, Shape};
use super::duffing::{Constants, Place};
use crate::elliptic::integrals::carlson_duplication::rf_of_roots;
use crate::elliptic::theta::neville::NevilleTheta;
use crate::float::scaled::{self, Scaled};
use crate::float::{Dd, LN_2};

/// -ln of a value of any size above 0.
pub(super) fn minus_ln(value: Scaled) -> Dd {
    let part = value.part();
    LN_2.to_dd() * f64::from(-value.power()) - scaled::ln(part.hi) - Dd::from(part.lo / part.hi)
}

/// R_F(x^2, y^2, z^2) from roots of any size, at most one of them 0.
pub(super) fn rf(roots: [Scaled; 3]) -> Scaled {
    let [mut x, mut y, mut z] = roots;
    if (x - z).is_positive() {
        (x, z) = (z, x);
    }
    if (y - z).is_positive() {
        (y, z) = (z, y);
    }
    let (x, y) = (x / z, y / z);
    let sum = x + y;
    let unit = if sum.power() < -CARRIED {
        // ln(4/(x + y)): beyond what a double-double holds.
        minus_ln(sum) + LN_2.to_dd() * 2.0
    } else {
        rf_of_roots(x.to_dd(), y.to_dd())
    };
    Scaled::from(unit) / z
}

/// sign(value), + for 0.
pub(super) fn sign(value: Scaled) -> f64 {
    if value.is_negative() { -1.0 } else { 1.0 }
}

/// value with the sign, and zero as it is.
pub(super) fn signed(value: Scaled, sign: f64) -> Scaled {
    if sign < 0.0 { -value } else { value }
}

/// artanh of x = |sine| with 1 - x^2 = root^2.
pub(super) fn artanh(x: Scaled, root: Scaled) -> Scaled {
    x * rf([root, root, Scaled::ONE])
}

/// Amplitude, rate W of the argument, parameter and complement of an elliptic motion.
pub(super) struct Canonical {
    pub shape: Shape,
    pub amplitude: Scaled,
    pub rate: Scaled,
    pub m: Scaled,
    pub mc: Scaled,
}

impl Constants {
    /// The regime and its canonical form for q != 0 and a start that moves.
    pub(super) fn canonical(&self, shape: Shape) -> Canonical {
        let Constants { q, energy, s, plus, minus, delta, p } = *self;
        let twice = s.shift(1);
        let (amplitude, rate, m, mc) = match shape {
            Shape::Cn => {
                // 4E/(S + p), or (S - p)/q where S + p is itself a quotient.
                let square = if p.is_negative() { minus / q } else { energy / plus };
                (square, s, minus / twice, plus / twice)
            }
            Shape::Sn => (energy / plus, plus.shift(-1), minus.abs() / plus, twice / plus),
            Shape::Dn => (minus / q, minus.shift(-1), twice / minus, -plus / minus),
            Shape::Nc => (plus / q.abs(), s, minus / twice, plus / twice),
            Shape::Dc => (plus / q.abs(), plus.shift(-1), minus.abs() / plus, twice / plus),
            Shape::Sc => (energy / minus, minus.shift(-1), twice / minus, -plus / minus),
            Shape::SdOverC => {
                // G = |q| B^2 = sqrt(4 |q| E), m = (G + p)/2G, 1 - m = (G - p)/2G, G^2 - p^2 = -Delta.
                let g = (q.abs() * energy).sqrt();
                let (sum, difference) = if p.is_negative() {
                    let difference = g - p;
                    (-delta / difference, difference)
                } else {
                    let sum = g + p;
                    (sum, -delta / sum)
                };
                (g / q.abs(), g.shift(-1), sum / g.shift(1), difference / g.shift(1))
            }
        };
        Canonical { shape, amplitude: amplitude.sqrt(), rate: rate.sqrt(), m, mc }
    }

    /// S - a and S + a at a place: one by their product 2 q u'^2.
    fn around(&self, place: &Place) -> (Scaled, Scaled) {
        let product = (self.q * place.velocity.square()).shift(1);
        if place.stiffness.is_negative() {
            let difference = self.s - place.stiffness;
            (difference, product / difference)
        } else {
            let sum = self.s + place.stiffness;
            (if sum.is_zero() { Scaled::ZERO } else { product / sum }, sum)
        }
    }

    /// W t from the upward zero to a place passed upwards (velocity >= 0), for [`Shape::Cn`] and [`Shape::Sn`].
    fn since_zero(&self, canonical: &Canonical, place: &Place) -> Scaled {
        // u/A R_F(1, x^2, h^2), x = u'/(sqrt(2E) h), h^2 = (S + a)/(S + p).
        let h = (self.around(place).1 / self.plus).sqrt();
        let root = self.energy.shift(-1).sqrt();
        let x = place.velocity.abs() / (root * h);
        canonical.rate * place.u / root * rf([Scaled::ONE, x, h])
    }

    /// W t from the outer turning point, not negative, for [`Shape::Dn`].
    fn since_outer(&self, canonical: &Canonical, place: &Place) -> Scaled {
        let (minus, plus) = self.around(place);
        let twice = self.s.shift(1);
        (minus / twice).sqrt() * rf([(plus / twice).sqrt(), place.u.abs() / canonical.amplitude, Scaled::ONE])
    }

    /// t from a place to the pole that it moves to (velocity of the sign of u), for q < 0 and Delta >= 0.
    pub(super) fn until_pole(&self, place: &Place) -> Scaled {
        let size = self.q.abs();
        let far = self.s - place.stiffness;
        let near = place.velocity.abs() * (Scaled::ONE.shift(1) / far).sqrt();
        (Scaled::ONE.shift(1) / size).sqrt() * rf([place.u.abs(), near, (far / size).sqrt()])
    }

    /// t from the turning point of an escape to a place, for [`Shape::Nc`] and [`Shape::Dc`].
    fn since_turning(&self, place: &Place) -> Scaled {
        // sqrt(2 Y/(S + p)) R_F(2 S/|q|, Z, 2 S u^2/(S + p)), Y = 2 u'^2/(S - a), Z = (S - a)/|q|.
        let size = self.q.abs();
        let far = self.s - place.stiffness;
        let near = place.velocity.abs().shift(1) / (far * self.plus).sqrt();
        let root = (self.s.shift(1) / size).sqrt();
        near * rf([root, (far / size).sqrt(), place.u.abs() * (self.s.shift(1) / self.plus).sqrt()])
    }

    /// t from the zero to a place, for [`Shape::Sc`].
    fn since_middle(&self, place: &Place) -> Scaled {
        let size = self.q.abs();
        let far = self.s - place.stiffness;
        let near = place.velocity.abs() * (Scaled::ONE.shift(1) / far).sqrt();
        let first = (self.minus.shift(-1)).sqrt() * near;
        let second = (-self.plus.shift(-1) * far / size).sqrt();
        place.u.abs() * rf([self.energy.shift(-1).sqrt(), first, second])
    }

    /// (2 W t from the zero or to the pole, whichever is nearer; whether that is the pole), for [`Shape::SdOverC`].
    fn half_argument(&self, canonical: &Canonical, place: &Place) -> (Scaled, bool) {
        // With x = 2 W t, u^2/B^2 = (1 - cn x)/(1 + cn x) and u' = W (B^2 + u^2)/B dn x.
        let square = canonical.amplitude.square() + place.u.square();
        let cn = place.excess / (self.q.abs() * square.square());
        let dn = place.velocity.abs() * canonical.amplitude / (canonical.rate * square);
        let sn = (canonical.amplitude * place.u.abs()).shift(1) / square;
        (sn * rf([cn.abs(), dn, Scaled::ONE]), cn.is_negative())
    }
}

/// Half periods of a libration or a well at a place, with the velocity upwards for the first and of either sign for the
/// second; in [-1/2, 1/2].
pub(super) fn half_periods(
    c: &Constants,
    canonical: &Canonical,
    lattice: &NevilleTheta,
    place: &Place,
) -> Scaled {
    let half = Scaled::from(0.5);
    let per = Scaled::from(lattice.quarter).shift(1);
    match canonical.shape {
        Shape::Dn => {
            if place.velocity.is_zero() {
                return if place.stiffness.is_positive() { Scaled::ZERO } else { half };
            }
            let outwards = sign(place.u) == sign(place.velocity);
            signed(c.since_outer(canonical, place) / per, if outwards { -1.0 } else { 1.0 })
        }
        _ if place.velocity.is_zero() => signed(half, sign(place.u)),
        _ => c.since_zero(canonical, place) / per,
    }
}

/// Half periods of an escape at a place, from its pole or its middle, and which; from the middle with the sign of t.
pub(super) fn escape_phase(
    c: &Constants,
    canonical: &Canonical,
    lattice: &NevilleTheta,
    place: &Place,
) -> (Scaled, bool) {
    let per = Scaled::from(lattice.quarter).shift(1);
    let (u, velocity) = (place.u, place.velocity);
    let after = if u.is_zero() || velocity.is_zero() || sign(u) == sign(velocity) { 1.0 } else { -1.0 };
    let unit = |time: Scaled| canonical.rate * time / per;
    let (size, from_pole) = match canonical.shape {
        Shape::SdOverC => {
            if u.is_zero() {
                return (Scaled::ZERO, false);
            }
            let (argument, from_pole) = c.half_argument(canonical, place);
            (argument / per.shift(1), from_pole)
        }
        Shape::Sc => {
            if u.is_zero() {
                return (Scaled::ZERO, false);
            }
            let from_pole = (u.abs() - canonical.amplitude).is_positive();
            (unit(if from_pole { c.until_pole(place) } else { c.since_middle(place) }), from_pole)
        }
        _ => {
            if velocity.is_zero() {
                return (Scaled::ZERO, false);
            }
            let from_pole = (u.square() - canonical.amplitude.square().shift(1)).is_positive();
            (unit(if from_pole { c.until_pole(place) } else { c.since_turning(place) }), from_pole)
        }
    };
    // From a pole the phase counts away from it: it falls towards a pole ahead.
    (if from_pole { size } else { signed(size, after) }, from_pole)
}

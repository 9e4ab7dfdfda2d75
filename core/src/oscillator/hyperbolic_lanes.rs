//! The common motions of elementary.rs over lanes: separatrices, and escapes at their energy, in ordinary units.
//!
//! With y = |x|, S = tanh y, C = sech y and g = e^-y = C/(1 + S), u = n/sqrt M and u' = w/M^(3/2) but for factors:
//!
//! | curve | M | n | w |
//! |---|---|---|---|
//! | tanh, sech | l C^2 + m S^2 | 1 | S C^2 |
//! | the same, odd | | S | C^2 |
//! | sinh, 1, times C^2 | | C | S C |
//! | exponential, x > 0, times g^2 | l + m g^2 | g | g |
//! | exponential, x <= 0 | l g^2 + m | 1 | g^2 |
//!
//! with poles M takes tanh d tanh e, d and e the arguments to them. All terms are positive.

use super::elementary::{Elementary, Functions, Sum};
use crate::elliptic::phase::Phase;
use crate::float::Dd;
use crate::float::elementary::{quotient, saturated_sinh_cosh, sech};
use crate::float::exponent::ldexp;
use crate::float::scaled::Scaled;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Formula, Lane};

/// What is over sqrt M.
#[derive(Clone, Copy, Debug, PartialEq)]
enum HyperbolicKind {
    Even,
    Odd,
    Falling,
    Exponential,
}

/// A motion in ordinary units: its factors over powers of two.
#[derive(Clone, Debug)]
pub(super) struct Hyperbolic {
    kind: HyperbolicKind,
    /// The argument, and that to the pole ahead.
    base: Phase,
    rest: Phase,
    /// That from the pole behind, less the argument.
    pole: Option<Dd>,
    l: Dd,
    m: Dd,
    velocity: Dd,
    /// Powers of two of u and u', with signs.
    scales: [f64; 2],
}

/// Powers of two that factors and rates may have here; larger ones go sample by sample.
const ORDINARY: i32 = 250;

impl Hyperbolic {
    /// Of a motion whose M has two terms and whose factors are ordinary.
    pub fn new(given: &Elementary) -> Option<Hyperbolic> {
        let (kind, l, m) = match given.sum {
            Sum::Squares { functions: Functions::Tanh, odd, l, m } => {
                (if odd { HyperbolicKind::Odd } else { HyperbolicKind::Even }, l, m)
            }
            Sum::Squares { functions: Functions::Sinh, l, m, .. } if given.pole.is_none() => {
                (HyperbolicKind::Falling, l, m)
            }
            Sum::Exponential { l, m } => (HyperbolicKind::Exponential, l, m),
            _ => return None,
        };
        let ordinary = |x: &Scaled| x.is_zero() || x.power().abs() < ORDINARY;
        let pole = given.pole.filter(|_| kind != HyperbolicKind::Exponential);
        let factors = [l, m, given.velocity, given.base[1]];
        if !l.is_positive() || !m.is_positive() || !factors.iter().all(ordinary) {
            return None;
        }
        let power = l.power().max(m.power()).div_euclid(2);
        let phase = |[start, rate]: [Scaled; 2]| Phase { rate: rate.to_dd(), start: start.to_dd() };
        Some(Hyperbolic {
            kind,
            base: phase(given.base),
            rest: phase(given.rest),
            pole: pole.map(Scaled::to_dd),
            l: l.shift(-2 * power).to_dd(),
            m: m.shift(-2 * power).to_dd(),
            velocity: given.velocity.to_dd(),
            scales: [-power, -3 * power].map(|power| given.sign * ldexp(1.0, power)),
        })
    }
}

/// tanh y, for y >= 0.
#[inline(always)]
fn tanh<L: Lane>(y: Dd<L>) -> Dd<L> {
    let (sine, cosine) = saturated_sinh_cosh(y);
    quotient(sine, cosine)
}

impl Formula<1, 2> for Hyperbolic {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let Hyperbolic { kind, base, rest, pole, velocity, scales, .. } = self;
        let (l, m) = (Unnormalised::splat(self.l), Unnormalised::splat(self.m));
        let x = base.held(t);
        let one = L::splat(1.0);
        let sign = one.copysign(x.hi);
        let y = x.scale(sign);
        let sine = tanh(y);
        let (cosine, power) = sech(y);
        // Below the range of its square it no longer counts in a sum with 1.
        let short = Unnormalised::from(cosine).scale(power);
        let (tanh_y, cosine) = (Unnormalised::from(sine), Unnormalised::from(cosine));
        let unit = Unnormalised::from_double(one);
        let (n, n_power, w, w_power, sum) = match kind {
            HyperbolicKind::Exponential => {
                let below = unit.plus_smaller(tanh_y);
                let g = cosine.over(below);
                let square = short.over(below).square();
                let falls = L::splat(0.0).less(x.hi);
                let sum = Unnormalised::select(falls, l, m) + Unnormalised::select(falls, m, l) * square;
                let n = Unnormalised::select(falls, g, unit);
                let n_power = L::select(falls, power, one);
                (n, n_power, Unnormalised::select(falls, g, square), n_power, sum)
            }
            _ => {
                let sum = l * short.square() + m * tanh_y.square();
                match kind {
                    HyperbolicKind::Even => (unit, one, tanh_y * cosine * short, power, sum),
                    HyperbolicKind::Odd => (tanh_y, one, cosine * short, power, sum),
                    _ => (cosine, power, tanh_y * cosine, power, sum),
                }
            }
        };
        let number = x.hi.equal(x.hi);
        let (sum, inside) = match pole {
            None => (sum, number),
            Some(pole) => {
                let ahead = rest.held(t);
                let behind = Dd::splat(*pole).plain_sum(x);
                let least = L::select(ahead.hi.less(behind.hi), ahead.hi, behind.hi);
                let inside = L::splat(0.0).less(least);
                let nothing = Dd::from_double(one);
                let d = Dd::select(inside, ahead, nothing);
                let e = Dd::select(inside, behind, nothing);
                (sum * (tanh(d) * tanh(e)).into(), inside)
            }
        };
        let root = sum.inverse_root();
        let cube = root * root * root;
        let u_sign = if *kind == HyperbolicKind::Odd { sign } else { one };
        let velocity_sign =
            if matches!(kind, HyperbolicKind::Even | HyperbolicKind::Falling) { sign } else { one };
        let (u_scale, velocity_scale) = (L::splat(scales[0]), L::splat(scales[1]));
        let Unnormalised { hi, lo } = n * root;
        let u = (hi + lo) * (u_sign * u_scale) * n_power;
        let Unnormalised { hi, lo } = w * cube * Unnormalised::splat(*velocity);
        let velocity = (hi + lo) * (velocity_sign * velocity_scale) * w_power;
        let nan = L::splat(f64::NAN);
        [L::select(inside, u, nan), L::select(inside, velocity, nan)]
    }
}

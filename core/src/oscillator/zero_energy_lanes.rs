//! The rarer motions of elementary.rs over lanes: escapes at E = 0 and powers of the time, in ordinary units.
//!
//! With d and e the arguments to the poles, g = e^-d and A = 1 - g^2, u = n/sqrt M and u' = w/M^(3/2) but for factors:
//!
//! | motion | M | n | w |
//! |---|---|---|---|
//! | from a pole: sinh d sinh e, cosh e sinh d, e^d sinh d | A (A + c g^2) | g | g (A (1 + g^2) + c g^4) |
//! | to a limit: e^-d sinh d | A | 1 | g^2 |
//! | between poles: sinh d sinh e | sinh d sinh e | 1 | sinh 2x |
//! | line | d | 1 | 1 |
//! | square | l + m x^2, or d e | 1, or x | x, or 1 |
//!
//! with c = 1 - q^2, 1 + q^2 and 1, where e = d - ln q. All terms are positive. Far out powers are taken in units of
//! 2^400, and u that vanishes at infinity is 0 from where it does not count beside its start.

use super::elementary::{Elementary, Functions, Sum, sinh_cosh};
use crate::elliptic::phase::Phase;
use crate::float::Dd;
use crate::float::elementary;
use crate::float::exponent::ldexp;
use crate::float::scaled::Scaled;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Formula, Lane};

/// What is over sqrt M.
#[derive(Clone, Copy, Debug, PartialEq)]
enum EscapeKind {
    /// With c.
    FromPole(Dd),
    ToLimit,
    BetweenPoles,
    Line,
    /// Whether u goes with the argument, and whether there are poles.
    Square {
        odd: bool,
        poles: bool,
    },
}

/// A motion in ordinary units: its factors over powers of two.
#[derive(Clone, Debug)]
pub(super) struct ZeroEnergyEscape {
    kind: EscapeKind,
    /// The argument, and that to the pole ahead.
    base: Phase,
    rest: Phase,
    /// That from the pole behind, less the argument.
    pole: Dd,
    l: Dd,
    m: Dd,
    velocity: Dd,
    /// Powers of two of u and u', with signs.
    scales: [f64; 2],
}

/// Powers of two that factors and rates may have here; larger ones go sample by sample.
const ORDINARY: i32 = 200;
/// Most that hyperbolic functions of the poles' argument may grow to, as its power of two.
const POLE: i32 = 5;
/// Times are held here, and arguments of hyperbolic functions there.
const LAST: f64 = 1e200;
const FAR: f64 = 700.0;

impl ZeroEnergyEscape {
    /// Of a motion whose factors are ordinary.
    pub fn new(given: &Elementary) -> Option<ZeroEnergyEscape> {
        let pole = given.pole.unwrap_or(Scaled::ZERO);
        let one_sided = (given.base[1] - given.rest[1]).is_zero();
        // q of e^-pole twice.
        let q = || Scaled::exp(-pole.shift(1).to_dd());
        let of_pole = |c: Scaled, factor: Scaled| (EscapeKind::FromPole(c.to_dd()), factor);
        let ordinary = |x: &Scaled| x.is_zero() || x.power().abs() < ORDINARY;
        let factors = [given.velocity, given.base[0], given.base[1], given.rest[0], given.rest[1], pole];
        if !factors.iter().all(ordinary) || !pole.is_zero() && pole.power() > POLE && !is_power(given.sum) {
            return None;
        }
        let nothing = Scaled::ZERO;
        // The kind, l and m, and by what u' is to be divided.
        let (kind, l, m, divisor) = match given.sum {
            Sum::Squares { functions: Functions::Sinh, odd: false, l, m }
                if given.pole.is_some() && m.is_zero() =>
            {
                if one_sided {
                    // 1 - q^2 = 2 q sinh of twice the pole's argument.
                    let q = q();
                    let (kind, divisor) = of_pole((q * sinh_cosh(pole.shift(1)).0).shift(1), q.shift(2));
                    (kind, l / divisor, m, divisor)
                } else {
                    (EscapeKind::BetweenPoles, l, m, Scaled::from(2.0))
                }
            }
            Sum::Squares { functions: Functions::Power, odd, l, m } => {
                let poles = given.pole.is_some();
                if poles && !m.is_zero() {
                    return None;
                }
                (EscapeKind::Square { odd, poles }, l, m, Scaled::ONE)
            }
            Sum::CoshSinh(l) => {
                let q = q();
                let (kind, divisor) = of_pole(Scaled::ONE + q.square(), q.shift(1));
                (kind, l.shift(1) / divisor.shift(1), nothing, divisor)
            }
            Sum::GrowingSinh(l) => (EscapeKind::FromPole(Dd::ONE), l, nothing, Scaled::ONE),
            Sum::DecayingSinh(l) => (EscapeKind::ToLimit, l, nothing, Scaled::ONE),
            Sum::Linear(l) => (EscapeKind::Line, l, nothing, Scaled::ONE),
            _ => return None,
        };
        if !l.is_positive() || m.is_negative() || !ordinary(&l) || !ordinary(&m) {
            return None;
        }
        let velocity = given.velocity / divisor;
        let power = l.power().div_euclid(2);
        let phase = |[start, rate]: [Scaled; 2]| Phase { rate: rate.to_dd(), start: start.to_dd() };
        Some(ZeroEnergyEscape {
            kind,
            base: phase(given.base),
            rest: phase(given.rest),
            pole: pole.to_dd(),
            l: l.shift(-2 * power).to_dd(),
            m: m.shift(-2 * power).to_dd(),
            velocity: velocity.to_dd(),
            scales: [-power, -3 * power].map(|power| given.sign * ldexp(1.0, power)),
        })
    }
}

fn is_power(sum: Sum) -> bool {
    matches!(sum, Sum::Squares { functions: Functions::Power, .. } | Sum::Linear(_))
}

/// sinh y and cosh y for y >= 0, held where e^-y no longer counts.
#[inline(always)]
fn hyperbolic<L: Lane>(y: Dd<L>) -> [Unnormalised<L>; 2] {
    let far = L::splat(FAR).less(y.hi);
    let (sine, cosine) = elementary::sinh_cosh(Dd::select(far, Dd::from_double(L::splat(FAR)), y));
    [sine.into(), cosine.into()]
}

/// g = e^-d and A = 1 - g^2.
#[inline(always)]
fn decay<L: Lane>(d: Dd<L>) -> [Unnormalised<L>; 2] {
    let [sine, cosine] = hyperbolic(d);
    let inverse = cosine.plus_smaller(sine).inverse();
    [inverse, (sine * inverse).scale(L::splat(2.0))]
}

impl Formula<1, 2> for ZeroEnergyEscape {
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let ZeroEnergyEscape { kind, base, rest, pole, velocity, scales, .. } = self;
        let (one, zero) = (L::splat(1.0), L::splat(0.0));
        let held = L::select(L::splat(LAST).less(t.abs()), L::splat(LAST).copysign(t), t);
        let x = base.counted(held);
        let ahead = rest.counted(held);
        let behind = Dd::splat(*pole).plain_sum(x);
        let two_sided = matches!(kind, EscapeKind::BetweenPoles | EscapeKind::Square { poles: true, .. });
        let least =
            if two_sided { L::select(ahead.hi.less(behind.hi), ahead.hi, behind.hi) } else { ahead.hi };
        let inside = match kind {
            EscapeKind::Square { poles: false, .. } => t.equal(t),
            _ => zero.less(least),
        };
        let nothing = Dd::from_double(one);
        let d = Dd::select(inside, ahead, nothing);
        let e = Dd::select(inside, behind, nothing);
        let unit = Unnormalised::from_double(one);
        // Powers in units of their own; the others decay before.
        let passed = L::select(L::splat(LAST).less(t.abs()), L::splat(FARTHEST), x.hi.abs());
        let size = L::select(inside, passed, zero);
        let outer = L::select(size.less(L::splat(FARTHEST)), L::splat(UNIT), zero);
        let reach = L::select(size.less(L::splat(OUTER)), one, L::splat(UNIT));
        let step = L::select(size.less(L::splat(OUTER)), one, outer);
        let (mut n_power, mut w_power) = (one, [one; 3]);
        let (n, w, sum) = match kind {
            EscapeKind::FromPole(c) => {
                n_power = L::select(L::splat(FAR).less(d.hi), zero, one);
                w_power[0] = n_power;
                let [g, a] = decay(d);
                let square = g.square();
                let below = square * Unnormalised::splat(*c);
                (g, g * (a * (unit + square) + below * square), a * (a + below))
            }
            EscapeKind::ToLimit => {
                let [g, a] = decay(d);
                (unit, g.square(), a)
            }
            EscapeKind::BetweenPoles => {
                let [near, far] = [hyperbolic(d)[0], hyperbolic(e)[0]];
                let sign = one.copysign(x.hi);
                let twice = x.scale(sign * L::splat(2.0));
                let [sine, _] = hyperbolic(Dd::select(inside, twice, nothing));
                (unit, sine.scale(sign), near * far)
            }
            EscapeKind::Line => {
                (n_power, w_power) = (step, [step; 3]);
                let d = Unnormalised::from(d).scale(reach).scale(reach);
                (unit, unit, d)
            }
            EscapeKind::Square { odd, poles } => {
                let x = Unnormalised::from(x).scale(reach);
                let sum = if *poles {
                    Unnormalised::from(d).scale(reach) * Unnormalised::from(e).scale(reach)
                } else {
                    Unnormalised::splat(self.l).scale(step).scale(step)
                        + Unnormalised::splat(self.m) * x.square()
                };
                if *odd {
                    w_power = [step; 3];
                    (x, unit, sum)
                } else {
                    n_power = step;
                    w_power = [step, step, one];
                    (unit, x, sum)
                }
            }
        };
        let sum = if matches!(kind, EscapeKind::Square { poles: false, .. }) {
            sum
        } else {
            sum * Unnormalised::splat(self.l)
        };
        let root = sum.inverse_root();
        let cube = root * root * root;
        let [first, second, third] = w_power;
        let Unnormalised { hi, lo } = n * root;
        let u = (hi + lo) * L::splat(scales[0]) * n_power;
        let Unnormalised { hi, lo } = w * cube * Unnormalised::splat(*velocity);
        let velocity = (hi + lo) * first * second * third * L::splat(scales[1]);
        let nan = L::splat(f64::NAN);
        [L::select(inside, u, nan), L::select(inside, velocity, nan)]
    }
}

/// 2^200 and 2^600: from there arguments are taken in units of 2^400, and u is 0 where it vanishes at infinity.
const OUTER: f64 = 1.606_938_044_258_990_3e60;
const FARTHEST: f64 = 4.149_515_568_880_993e180;
/// 2^-400.
const UNIT: f64 = 3.872_591_914_849_318e-121;

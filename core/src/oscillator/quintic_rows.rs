//! u'' + p u + q u^3 + s u^5 = 0 from a start, over lanes and without the phase of the start: every row may have a start and
//! coefficients of its own.
//!
//! With a real root v of C(v) (nonzero_energy.rs) and g = 1 - v u0^2, x = u/sqrt(1 - v u^2) obeys Duffing's equation, and Euler's addition
//! theorem for it (addition_theorem.rs) gives
//!   u = n/sqrt M,  u' = g W d/M^(3/2),  M = g d^2 + v n^2,  n = u0 g S' + u0' S,  d = g - h S^2,  h = C'(v) u0^2,
//!   W = n' d - n d' = u0' S' (g + h S^2) + u0 g S ((3 e g + 2 h) + (2 f g + 3 e h) S^2),  e = 2E v - p/3,  f = 2E C'(v),
//! with the odd function S, S'^2 = 1 + 3 e S^2 + f S^4, which is s/c, s/d or s/n as e is the largest of its like, the one between or the
//! least. The root with C'(v) and g of different signs makes d a sum: the middle one of a motion through 0, else that with the largest
//! e. Where two roots are complex d is a difference. There all is divided by sqrt g, whose digits are those of u0', and where the two
//! terms of n differ in sign n and d are (u0^2 - 2E g S^2) and (u0 g S' - u0' S)/sqrt g, which have the same ratio.
//! Escapes end where M is 0 for the first time.
//! Floor: 1700 operations; for eight rows at two a cycle of 3 GHz 35 ns a row, for four 71.
//! Source: derived; DLMF 22.8(i), 23.6, 22.13(i).

use super::even_start::{
    CurveOnLanes, Invariants, SMALL_SWINGS, TWELFTH, curve, double, number, scaled, tight,
};
use super::quintic_start::{NOTHING, OwnUnits, QuinticStart};
use crate::elliptic::phase::{alternating, turned};
use crate::elliptic::theta::neville_lanes::NevilleThetaLanes;
use crate::float::Dd;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Formula, Kernel, Lane, Sampler, sweep};

/// Half periods times what is left of the energy and, next to a separatrix, of the discriminant: beyond, what double-doubles lose of
/// the period adds up.
const MANY: f64 = 1e12;

/// How much must be left of the terms of M: less where a pole of u is near, and u changes fast.
const SHARP: f64 = 1e-6;

/// How far from 0 the end of a motion must be, as part of its terms.
const BOUNDED: f64 = 1e-9;

/// So near to the start, as part of it, u may be on either side of it.
const BESIDE: f64 = 1e-9;

/// The theta functions are good to 2^-57 of a time: in so much of it u may change by so many times its size, which makes 2 ulp of u'.
const MOST_CHANGE: f64 = 6.0;

/// Least M: below, the products have no range.
const LEAST: f64 = 1e-180;

/// The start and the coefficients of one row per lane, set up for any time; PAIR where two roots are complex.
pub(super) struct QuinticStartOnLanes<L: Lane, const PAIR: bool, const HYPERBOLIC: bool> {
    u0: L,
    velocity0: L,
    units: OwnUnits<L>,
    /// What S' and S take in n.
    even: Unnormalised<L>,
    odd: Unnormalised<L>,
    /// g, or 1 where it is divided by.
    weight: Unnormalised<L>,
    root: Unnormalised<L>,
    g: Unnormalised<L>,
    h: Unnormalised<L>,
    /// Of S and S^3 in W.
    slopes: [Unnormalised<L>; 2],
    /// u0^2, 2E g, and the slopes where the terms of n differ in sign.
    y: Unnormalised<L>,
    far: Unnormalised<L>,
    far_slopes: [Unnormalised<L>; 2],
    /// The sign of n beside that of u.
    sign: L,
    /// Whether S is s/d.
    by_d: L::Mask,
    neville: NevilleThetaLanes<L>,
    /// Half periods per time.
    rate: Unnormalised<L>,
    /// What S takes.
    scale: Unnormalised<L>,
    /// So many half periods keep their digits; 0 where none do.
    within: L,
    /// 1 where it escapes, else 0.
    escaping: L,
}

impl<L: Lane, const PAIR: bool, const HYPERBOLIC: bool> QuinticStartOnLanes<L, PAIR, HYPERBOLIC> {
    #[inline(always)]
    pub fn new(given: [L; 5]) -> Self {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let units = OwnUnits::new(given);
        let [u0, velocity0, ..] = units.given;
        let start = QuinticStart::new(units.given);
        let QuinticStart { y, energy, third, place, energy_left, left, .. } = start;
        let Invariants { i, j, mut discriminant } = start.invariants;
        if !PAIR {
            let lost = left.less(L::splat(NOTHING));
            let least = double(start.size * L::splat(NOTHING));
            discriminant = Unnormalised::select(lost, least, discriminant);
        }
        let CurveOnLanes { e1, square, m, mc } =
            curve::<L, PAIR, HYPERBOLIC>(&Invariants { i, j, discriminant });
        let e1 = e1 * Unnormalised::splat(TWELFTH);
        let positive = zero.less(energy.hi);
        let (e2, e3) = (e1 - mc * square, e1 - square);
        // Outside the oval, v of the start is beyond all roots.
        let by_d = if PAIR { one.less(zero) } else { (y.hi * e3.hi * L::splat(-0.5)).less(place.hi) };
        let (mixed, square2) = (m * mc, square.square());
        let e = if PAIR { e1 } else { tight(Unnormalised::select(by_d, e2, e1)) };
        let f = if PAIR { square2 } else { square2 * Unnormalised::select(by_d, -mixed, mc) };
        // The root at the far end of the motion, times |2E|.
        let end = if PAIR {
            e1.hi
        } else {
            let oval = L::select(positive, e3.hi, e2.hi);
            L::select(by_d, e1.hi, oval)
        };
        let (sum, size) = (end + third.hi, end.abs() + third.hi.abs());
        let end = L::select(positive, sum, -sum);
        // Outside the oval with less energy than 0 it escapes.
        let end = if PAIR { end } else { L::select(by_d, L::select(positive, end, -size), end) };
        let least = size * L::splat(BOUNDED);
        let escaping = L::select(end.less(-least), one, zero);
        let stays = L::select(least.less(end), one, escaping);
        let known = if HYPERBOLIC {
            left.abs()
        } else if PAIR {
            one
        } else {
            // Of small swings beside 0 every digit counts, about 0 itself none.
            let swings = L::select(L::splat(SMALL_SWINGS).less(left), one, zero);
            L::select(by_d, one, swings)
        };
        let inverse = energy.inverse();
        let root = tight(e + third) * inverse;
        let h = f * inverse * y;
        let (even, odd, weight, g) = if PAIR {
            let turn = tight(place + scaled(e1 * y, 0.5));
            let pair = turn.square() + scaled(mixed * square2 * y.square(), 4.0);
            let odd = (pair * inverse).root();
            let by_root = double(velocity0.abs()).over(odd);
            let sign = one.copysign(velocity0);
            (double(u0) * by_root, odd.scale(sign), double(one), by_root.square())
        } else {
            let g = tight(place - e * y) * inverse;
            (double(u0) * g, double(velocity0), g, g)
        };
        let e = e * number(3.0);
        let slopes = [tight(e * g + scaled(h, 2.0)), tight(scaled(f * g, 2.0) + e * h)];
        let far = energy * g;
        let far_slopes = [tight(scaled(far, 2.0) + e * y), tight(far * e + scaled(f * y, 2.0))];
        let neville = NevilleThetaLanes::new::<HYPERBOLIC>(m, mc);
        let scale = square.inverse_root();
        let speed = square * scale;
        let rate = if PAIR { scaled(speed, 2.0) } else { speed } * neville.frequency;
        let [u0, velocity0, ..] = given;
        QuinticStartOnLanes {
            u0,
            velocity0,
            units,
            even,
            odd,
            weight,
            root,
            g,
            h,
            slopes,
            y,
            far,
            far_slopes,
            sign: one.copysign(weight.hi),
            by_d,
            neville,
            rate,
            scale,
            within: stays * known * energy_left * L::splat(MANY),
            escaping,
        }
    }

    /// S as a/b and S' b^2, at n half periods and the rest f; and the sign of n beside that of u.
    #[inline(always)]
    fn odd_function(&self, n: L, f: Dd<L>) -> ([Unnormalised<L>; 3], L) {
        let one = L::splat(1.0);
        let sign = one.copysign(f.hi);
        let point = self.neville.at::<HYPERBOLIC>(f.scale(sign));
        let parity = alternating(n);
        let sn = point.sn.scale(sign * parity);
        if PAIR {
            // Of half the argument, by sn/(1 + cn) = (1 - cn)/sn; u changes its sign from one period to the next.
            let beyond = parity.less(L::splat(0.0));
            let sum = point.unit + point.cn;
            let a = Unnormalised::select(beyond, sum, sn);
            let b = Unnormalised::select(beyond, sn, sum);
            let whole = L::select(beyond, n + sign, n) * L::splat(0.5);
            return ([a * self.scale, b, scaled(point.dn * sum, 2.0)], alternating(whole));
        }
        let cn = point.cn.scale(parity);
        let b = Unnormalised::select(self.by_d, point.dn, cn);
        let slope = point.unit * Unnormalised::select(self.by_d, cn, point.dn);
        ([sn * self.scale, b, slope], self.sign)
    }

    /// u and u' at t: NaN where the row must be left out.
    #[inline(always)]
    fn after(&self, t: L) -> [L; 2] {
        let (zero, nan) = (L::splat(0.0), L::splat(f64::NAN));
        let (turns, f) = turned(t * self.units.rate, self.rate);
        let ([a, b, slope], mut sign) = self.odd_function(turns, f);
        let (a2, b2, product) = (a.square(), b.square(), a * b);
        let (even, odd) = (self.even * slope, self.odd * product);
        let (near, far) = (self.g * b2, self.h * a2);
        let [first, second] = self.slopes;
        let mut n = even + odd;
        let mut d = near - far;
        let mut slopes = [near + far, first * b2 + second * a2];
        if PAIR {
            let differ = (self.u0 * odd.hi).less(zero);
            let (near, far) = (self.y * b2, self.far * a2);
            let [first, second] = self.far_slopes;
            d = Unnormalised::select(differ, even - odd, d);
            n = Unnormalised::select(differ, near - far, n);
            let others = [near + far, -(first * b2 + second * a2)];
            slopes = [0, 1].map(|k| Unnormalised::select(differ, others[k], slopes[k]));
            sign = L::select(differ, sign.copysign(sign * self.u0), sign);
        }
        let (n, d) = (tight(n), tight(d));
        let way = self.odd * slope * tight(slopes[0]) + self.even * product * tight(slopes[1]);
        let [of_d, of_n] = [self.weight * d.square(), self.root * n.square()];
        let sum = tight(of_d + of_n);
        let inverse = sum.inverse_root();
        let u = n * inverse;
        let velocity = tight(way) * d * self.weight * (inverse * inverse.square());
        // Where M is small beside its terms, u changes fast.
        let least = (of_d.hi.abs() + of_n.hi.abs()) * L::splat(SHARP);
        let u = (u.hi + u.lo) * (sign * self.units.length);
        let velocity = (velocity.hi + velocity.lo) * (sign * self.units.velocity);
        let mut ended = L::select(least.larger(L::splat(LEAST)).less(sum.hi), zero, nan);
        let escaping = zero.less(self.escaping);
        if L::any(escaping) {
            let found = self.ended([t, turns, f.hi], [u, velocity], ended);
            let found = L::select(sum.hi.less(-least), L::splat(f64::INFINITY), found);
            ended = L::select(escaping, found, ended);
        }
        let known = (turns.abs() + L::splat(1.0)).less(self.within);
        let ended = L::select(known, ended, nan);
        let (start, moving) = (t.equal(zero), ended.equal(zero));
        let (u, velocity) = (L::select(moving, u, ended), L::select(moving, velocity, ended));
        [L::select(start, self.u0, u), L::select(start, self.velocity0, velocity)]
    }

    /// Of an escaping motion that is at u with this velocity: `near` before its end, infinite beyond, NaN where u changes too fast.
    #[inline(always)]
    fn ended(&self, [t, turns, f]: [L; 3], [u, velocity]: [L; 2], near: L) -> L {
        let (zero, one, half) = (L::splat(0.0), L::splat(1.0), L::splat(0.5));
        let end = L::splat(f64::INFINITY);
        let way = one.copysign(t);
        // |u| repeats after this many half periods, and between it ends, and comes back from infinity to where it was at first.
        let whole = L::splat(if PAIR { 2.0 } else { 1.0 });
        let passed = (turns + f).abs();
        let inward = (self.u0 * self.velocity0 * way).less(zero);
        let grows = zero.less(u * velocity * way);
        let (size, first) = (u.abs(), self.u0.abs());
        let (growing, falling) = (
            L::select(inward, near, L::select(size.less(first), end, near)),
            L::select(inward, L::select(size.less(first), near, end), end),
        );
        let found = L::select(grows, growing, falling);
        // What is next to the start is so at the beginning, or else there again; growing from within it is on its way out.
        let beside = (size - first).abs().less(first * L::splat(BESIDE));
        let begins = L::select(passed.less(whole * half), near, end);
        let begins = L::select(grows, L::select(inward, near, begins), begins);
        let found = L::select(beside, begins, found);
        // The values are those of a time that is off by 2^-57 of the distance from the nearest multiple of K.
        let quarter = f.abs().smaller((half - f.abs()).abs());
        let change = (velocity * quarter / (self.rate.hi * self.units.rate)).abs();
        let slow = change.less(size.larger(first) * L::splat(MOST_CHANGE));
        let found = L::select(found.equal(end), end, L::select(slow, found, L::splat(f64::NAN)));
        L::select(passed.less(whole), found, end)
    }
}

/// One start, many times.
impl<L: Lane, const PAIR: bool, const HYPERBOLIC: bool> Sampler<L, 1, 2>
    for QuinticStartOnLanes<L, PAIR, HYPERBOLIC>
{
    #[inline(always)]
    fn at(&self, [t]: [L; 1]) -> [L; 2] {
        self.after(t)
    }
}

/// A start of its own in every row of t, u0, u0', p, q and s.
pub(super) struct QuinticPerRow<const PAIR: bool, const HYPERBOLIC: bool>;

impl<const PAIR: bool, const HYPERBOLIC: bool> Formula<6, 2> for QuinticPerRow<PAIR, HYPERBOLIC> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [t, start @ ..]: [L; 6]) -> [L; 2] {
        QuinticStartOnLanes::<L, PAIR, HYPERBOLIC>::new(start).after(t)
    }
}

/// One start, many times: set up on the lanes that it is evaluated on.
pub(super) struct QuinticSharedStart<'a, 'b, const PAIR: bool, const HYPERBOLIC: bool> {
    pub start: [f64; 5],
    pub t: &'a [f64],
    pub results: [&'b mut [f64]; 2],
}

impl<const PAIR: bool, const HYPERBOLIC: bool> Kernel for QuinticSharedStart<'_, '_, PAIR, HYPERBOLIC> {
    type Output = ();
    type Place = Self;
    #[inline(always)]
    fn run<L: Lane>(mut self) {
        let mut given = [L::splat(0.0); 5];
        let mut k = 0;
        while k < 5 {
            given[k] = L::splat(self.start[k]);
            k += 1;
        }
        let start = QuinticStartOnLanes::<L, PAIR, HYPERBOLIC>::new(given);
        sweep::<L, _, _, _>(&start, [self.t], &mut self.results, &[])
    }
}

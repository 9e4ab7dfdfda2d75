//! u'' + p u + q u^3 = 0 from a start by the addition theorem, over lanes and without the phase of the start: every row may
//! have a start and coefficients of its own.
//!
//! With h = u0'^2 + p u0^2 + q u0^4/2, e = -q h/2 and the odd function S, S'^2 = 1 - p S^2 + e S^4, S'(0) = 1,
//!   u = (u0 S' + u0' S)/D,  u' = (u0' S' (2 - D) - u0 S ((p + q u0^2) D + q u0'^2 S^2))/D^2,  D = 1 + q u0^2 S^2/2,
//! in every regime; and where these two terms of u differ in sign, with G = u0 S' - u0' S and M = u0^2 + h S^2,
//!   u = (u0^2 - h S^2)/G,  u' = (u0' S' M + u0 S (p M + h (q u0^2 S^2 - 2)))/G^2.
//! The inverse roots of the quartic and 0, in order, are the e_i of S = s/c, s/d or s/n by Neville; where they are complex, S
//! is the tangent of half an amplitude. Escapes end where D is 0 and u is not 0/0.
//! Floor: 1050 operations for m <= 1/2 and 1350 above, with escapes; for eight rows at two a cycle of 2.9 GHz 23 and 29 ns a row.
//! Source: Euler's addition theorem for any quartic; DLMF 22.8(i), 22.13(i), 22.18(iv).

use crate::elliptic::phase::{alternating, turned};
use crate::elliptic::theta::neville_lanes::{NevilleThetaLanes, Point};
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Formula, Kernel, Lane, Sampler, sweep};

/// Beyond so many half periods times 1 - m a row is left out: what double-doubles lose of the period next to the
/// separatrix adds up.
const MANY: f64 = 1e12;

/// Least 1 - m, and least ratio of the roots: below, the cancellation in the energy counts.
const LEAST_COMPLEMENT: f64 = 1e-12;
const LEAST_RATIO: f64 = 1e-13;

/// A row so near to an escape is left out: in half periods, and as part of the terms of D.
const NEAR: f64 = 1.0 / (1u64 << 40) as f64;

/// The theta functions are good to 2^-57 of a time: in so much of it u may change by so many times its size, which makes 2 ulp of u'.
const MOST_CHANGE: f64 = 10.0;

/// The start and the coefficients of one row per lane, set up for any time; PAIR where the roots are complex.
pub(super) struct StartOnLanes<L: Lane, const PAIR: bool, const HYPERBOLIC: bool> {
    u0: L,
    velocity0: L,
    p: Unnormalised<L>,
    /// p + q u0^2, q u0'^2, q u0^2/2, h and u0^2.
    stiffness: Unnormalised<L>,
    q_velocity_square: Unnormalised<L>,
    half_cubic: Unnormalised<L>,
    h: Unnormalised<L>,
    u0_square: Unnormalised<L>,
    /// Whether S is s/d, and whether it is s/c.
    by_d: L::Mask,
    by_c: L::Mask,
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

/// S as a/b, and S' b^2.
struct Odd<L: Lane> {
    a: Unnormalised<L>,
    b: Unnormalised<L>,
    b_square: Unnormalised<L>,
    slope: Unnormalised<L>,
}

#[inline(always)]
fn double<L: Lane>(value: L) -> Unnormalised<L> {
    Unnormalised::from_double(value)
}

#[inline(always)]
fn twice<L: Lane>(value: Unnormalised<L>) -> Unnormalised<L> {
    value.scale(L::splat(2.0))
}

#[inline(always)]
fn halved<L: Lane>(value: Unnormalised<L>) -> Unnormalised<L> {
    value.scale(L::splat(0.5))
}

#[inline(always)]
fn absolute<L: Lane>(value: Unnormalised<L>) -> Unnormalised<L> {
    value.scale(L::splat(1.0).copysign(value.hi))
}

/// After a cancellation: products and roots take the second word to be small.
#[inline(always)]
fn tight<L: Lane>(value: Unnormalised<L>) -> Unnormalised<L> {
    value.tight().into()
}

#[inline(always)]
fn both<L: Lane>(first: L::Mask, second: L::Mask) -> L::Mask {
    let (zero, one) = (L::splat(0.0), L::splat(1.0));
    L::select(first, L::select(second, one, zero), zero).equal(one)
}

/// u over the divisor and u' over its square.
#[inline(always)]
fn quotients<L: Lane>(u: Unnormalised<L>, velocity: Unnormalised<L>, divisor: Unnormalised<L>) -> [L; 2] {
    let inverse = tight(divisor).inverse();
    let (u, velocity) = (u * inverse, velocity * inverse.square());
    [u.hi + u.lo, velocity.hi + velocity.lo]
}

impl<L: Lane, const PAIR: bool, const HYPERBOLIC: bool> StartOnLanes<L, PAIR, HYPERBOLIC> {
    #[inline(always)]
    pub fn new(u0: L, velocity0: L, p: L, q: L) -> Self {
        let (zero, one, many) = (L::splat(0.0), L::splat(1.0), L::splat(MANY));
        let (u0_square, velocity_square) = (double(u0).square(), double(velocity0).square());
        let (p, q) = (double(p), double(q));
        let cubic = q * u0_square;
        let half_cubic = halved(cubic);
        let stiffness = tight(p + cubic);
        let q_velocity_square = q * velocity_square;
        let h = tight(velocity_square + u0_square * tight(p + half_cubic));
        let minus_e = halved(q * h);
        // p^2 - 4 e, where nothing cancels for q > 0.
        let discriminant = absolute(tight(stiffness.square() + twice(q_velocity_square)));
        let (e, p_size) = (absolute(minus_e), absolute(p));
        let (negative, softening) = (p.hi.less(zero), q.hi.less(zero));
        let (square, m, mc, by_d, by_c, known, inside) = if PAIR {
            let root = e.root();
            let sum = twice(root) + p_size;
            let quarter = halved(halved(root.inverse()));
            let (small, large) = (discriminant.over(sum) * quarter, sum * quarter);
            let m = Unnormalised::select(negative, small, large);
            let mc = Unnormalised::select(negative, large, small);
            let none = one.less(zero);
            (root, m, mc, none, none, many, none)
        } else {
            let root = discriminant.root();
            let large = halved(root + p_size);
            let small = e.over(large);
            let by_d = zero.less(minus_e.hi);
            let by_c = both::<L>(negative, minus_e.hi.less(zero));
            let total = Unnormalised::select(by_d, root, large);
            let inverse = total.inverse();
            let (first, second) = (small * inverse, Unnormalised::select(by_d, large, root) * inverse);
            let m = Unnormalised::select(negative, second, first);
            let mc = Unnormalised::select(negative, first, second);
            // For s/n the discriminant is the square of 1 - m.
            let known = L::select(by_d, many, L::select(negative, many, many * mc.hi));
            let known = L::select((large.hi * L::splat(LEAST_RATIO)).less(root.hi), known, zero);
            // Within the barrier the force points inwards.
            let inwards = L::select(negative, zero, stiffness.hi);
            let inside = zero.less(L::select(by_d, zero, inwards));
            (total, m, mc, by_d, by_c, known, inside)
        };
        let neville = NevilleThetaLanes::new::<HYPERBOLIC>(m, mc);
        let scale = square.inverse_root();
        let speed = square * scale;
        let rate = if PAIR { twice(speed) } else { speed } * neville.frequency;
        let within = L::select(L::splat(LEAST_COMPLEMENT).less(mc.hi), known * mc.hi, zero);
        let escaping = L::select(softening, L::select(inside, zero, one), zero);
        StartOnLanes {
            u0,
            velocity0,
            p,
            stiffness,
            q_velocity_square,
            half_cubic,
            h,
            u0_square,
            by_d,
            by_c,
            neville,
            rate,
            scale,
            within,
            escaping,
        }
    }

    /// S at n half periods and the signed rest of the point.
    #[inline(always)]
    fn odd(&self, n: L, sign: L, point: &Point<L>) -> Odd<L> {
        let parity = alternating(n);
        let &Point { sn, cn, dn, unit, cn_square, dn_square, unit_square, .. } = point;
        let sn = sn.scale(sign * parity);
        if PAIR {
            // y = sn/(1 + cn) = (1 - cn)/sn of twice the argument of S: its slope is (1 + y^2) dn.
            let beyond = parity.less(L::splat(0.0));
            let sum = unit + cn;
            let a = Unnormalised::select(beyond, sum, sn);
            let b = Unnormalised::select(beyond, sn, sum);
            return Odd { a: a * self.scale, b, b_square: b.square(), slope: twice(dn * sum) };
        }
        let cn = cn.scale(parity);
        let (by_d, by_c) = (self.by_d, self.by_c);
        let b = Unnormalised::select(by_d, dn, Unnormalised::select(by_c, cn, unit));
        let b_square =
            Unnormalised::select(by_d, dn_square, Unnormalised::select(by_c, cn_square, unit_square));
        // The product of the other two.
        let slope = Unnormalised::select(by_c, unit, cn) * Unnormalised::select(by_d, unit, dn);
        Odd { a: sn * self.scale, b, b_square, slope }
    }

    /// u and u' at t: NaN where the row must be left out, infinite at and beyond an escape.
    #[inline(always)]
    fn after(&self, t: L) -> [L; 2] {
        let (zero, nan) = (L::splat(0.0), L::splat(f64::NAN));
        let (u0, velocity0) = (double(self.u0), double(self.velocity0));
        let (n, f) = turned(t, self.rate);
        let sign = L::splat(1.0).copysign(f.hi);
        let point = self.neville.at::<HYPERBOLIC>(f.scale(sign));
        let Odd { a, b, b_square, slope } = self.odd(n, sign, &point);
        let (a_square, product) = (a.square(), a * b);
        let cubic = self.half_cubic * a_square;
        let divisor = b_square + cubic;
        let (even, odd) = (u0 * slope, velocity0 * product);
        let velocity_slope = velocity0 * slope;
        let u0_product = u0 * product;
        let factor = self.stiffness * divisor + self.q_velocity_square * a_square;
        let numerator = velocity_slope * (b_square - cubic) - u0_product * factor;
        let [mut u, mut velocity] = quotients(even + odd, numerator, divisor);
        let mut ended = L::select(n.abs().less(self.within), zero, nan);
        let escaping = zero.less(self.escaping);
        if L::any(escaping) {
            let (near, far) = (self.u0_square * b_square, self.h * a_square);
            let sum = near + far;
            let factor = self.p * sum + twice(self.h * (cubic - b_square));
            let numerator = velocity_slope * sum + u0_product * factor;
            let [other, other_velocity] = quotients(near - far, numerator, even - odd);
            let differ = (even.hi * odd.hi * self.escaping).less(zero);
            u = L::select(differ, other, u);
            velocity = L::select(differ, other_velocity, velocity);
            let distance = divisor.hi / (b_square.hi + cubic.hi.abs());
            let found = self.ended(t, n, f.hi, L::select(differ, L::splat(1.0).copysign(distance), distance));
            // The values are those of a time that is off by 2^-57 of the distance from the nearest multiple of K.
            let quarter = f.hi.abs().smaller((L::splat(0.5) - f.hi.abs()).abs());
            let change = (velocity * quarter / self.rate.hi).abs();
            let size = u.abs().larger(self.u0.abs());
            let slow = L::select(change.less(size * L::splat(MOST_CHANGE)), zero, nan);
            let found = L::select(found.equal(zero), slow, found);
            ended = L::select(escaping, found, ended);
        }
        let (start, moving) = (t.equal(zero), ended.equal(zero));
        let (u, velocity) = (L::select(moving, u, ended), L::select(moving, velocity, ended));
        [L::select(start, self.u0, u), L::select(start, self.velocity0, velocity)]
    }

    /// Of an escaping motion: 0 before its end, infinite from there, NaN where it is too near; `distance` has the sign of D and
    /// is small next to the end.
    #[inline(always)]
    fn ended(&self, t: L, n: L, f: L, distance: L) -> L {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let (end, nan) = (L::splat(f64::INFINITY), L::splat(f64::NAN));
        // In the direction of time.
        let way = one.copysign(t);
        let (count, rest) = (n * way, f * way);
        let inward = (self.u0 * self.velocity0 * way).less(zero);
        // There S is infinite, or has its largest value.
        let turn = if PAIR { one } else { L::splat(0.5) };
        let passed = count + rest;
        let (first, second) = (passed.less(turn), passed.less(turn + turn));
        let below = distance.less(zero);
        let outwards = L::select(first, L::select(below, end, zero), end);
        let back = L::select(second, L::select(below, zero, end), end);
        let found = L::select(inward, L::select(first, zero, back), outwards);
        let to_turn = if PAIR { rest.abs() } else { turn - rest.abs() };
        let to_turn = if PAIR { L::select(count.equal(zero), one, to_turn) } else { to_turn.abs() };
        let near = distance.abs().smaller(to_turn).less(L::splat(NEAR));
        let found = L::select(near, nan, found);
        let found = L::select(L::splat(2.0).less(count), end, found);
        L::select(zero.less(self.within), found, nan)
    }
}

/// One start, many times.
impl<L: Lane, const PAIR: bool, const HYPERBOLIC: bool> Sampler<L, 1, 2>
    for StartOnLanes<L, PAIR, HYPERBOLIC>
{
    #[inline(always)]
    fn at(&self, [t]: [L; 1]) -> [L; 2] {
        self.after(t)
    }
}

/// A start of its own in every row of t, u0, u0', p, q.
pub(super) struct PerRow<const PAIR: bool, const HYPERBOLIC: bool>;

impl<const PAIR: bool, const HYPERBOLIC: bool> Formula<5, 2> for PerRow<PAIR, HYPERBOLIC> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [t, u0, velocity0, p, q]: [L; 5]) -> [L; 2] {
        StartOnLanes::<L, PAIR, HYPERBOLIC>::new(u0, velocity0, p, q).after(t)
    }
}

/// One start, many times: set up on the lanes that it is evaluated on.
pub(super) struct SharedStart<'a, 'b, const PAIR: bool, const HYPERBOLIC: bool> {
    pub start: [f64; 4],
    pub t: &'a [f64],
    pub results: [&'b mut [f64]; 2],
}

impl<const PAIR: bool, const HYPERBOLIC: bool> Kernel for SharedStart<'_, '_, PAIR, HYPERBOLIC> {
    type Output = ();
    type Place = Self;
    #[inline(always)]
    fn run<L: Lane>(mut self) {
        let [u0, velocity0, p, q] = self.start;
        let start = StartOnLanes::<L, PAIR, HYPERBOLIC>::new(
            L::splat(u0),
            L::splat(velocity0),
            L::splat(p),
            L::splat(q),
        );
        sweep::<L, _, _, _>(&start, [self.t], &mut self.results, &[])
    }
}

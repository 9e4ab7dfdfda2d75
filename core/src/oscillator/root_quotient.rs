//! u = n/sqrt M: the motions with a quintic force, as quotients of theta functions with one square root.
//!
//! M = l p^2 + m q^2 with l, m >= 0. Where u escapes M has the factor sn d sn e besides, d and e the arguments to the pole
//! ahead and from the pole behind, so that no sum ever cancels:
//!   sn^2 x_e - sn^2 x = sn(x_e - x) sn(x_e + x) (cn^2 x + dn^2 x_e sn^2 x).
//!
//! | root case | n | p, q | l, m | l, m with poles |
//! |---|---|---|---|---|
//! | crossing | sn | cn, sn | v0 - v2, v0 | -v2, -v1 |
//! | inside | 1 | cd, k' sd | v1, v2 | m v0, v1 - v2 |
//! | between | 1 | cn, sn | v0, v1 | v0 - v1, -m v2 |
//! | outside | cd | cd, k' sd | | v1, v0 |
//! | crossing, pair | sn dn | cn, sn dn | H, v0 | H - v0 twice |
//! | outside, pair | cn | cn, sn dn | | H + v0 twice |
//!
//! With theta1 (without its factor A) to theta4, counted from 0 or from K, where theta1 and theta2, theta3 and theta4 change
//! places, u' = w/M^(3/2) and:
//!
//! | root case | n | p, q | w |
//! |---|---|---|---|
//! | crossing | t1 | t2, t1 | t2 t3 t4 |
//! | inside | t3 | t2, t1 | t1 t2 t4 |
//! | between | t4 | t2, t1 | t1 t2 t3 |
//! | outside | t2 | t2, t1 | t1 t3 t4 |
//! | crossing, pair | t1 t3 | t2 t4, t1 t3 | t2 t4 (t3^4 + m k'^2 A^4 t1^4) |
//! | outside, pair | t2 t4 | t2 t4, t1 t3 | t1 t3 (t3^4 + m k'^2 A^4 t1^4) |
//!
//! Source: derived from v'^2 = 4 C(v) of nonzero_energy.rs; DLMF 20.2, 22.2, 22.8, 22.13(i).

use super::clock::Clock;
use super::energy::Orientation;
use super::nonzero_energy::{NonzeroEnergy, RootCase};
use super::roots::Distances;
use crate::elliptic::phase::{LAST_HALF_PERIOD, alternating};
use crate::elliptic::theta::neville::{NevilleTheta, Thetas};
use crate::float::Dd;
use crate::float::elementary::quotient;
use crate::float::scaled::{Scaled, over_common_power};
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Formula, Lane};

/// The parameter and its complement, the factors of p^2 and q^2, and that of u'.
#[derive(Clone, Debug)]
pub(super) struct Squares {
    pub case: RootCase,
    pub m: Scaled,
    pub mc: Scaled,
    pub squares: [Scaled; 2],
    pub velocity: Scaled,
}

/// Factors brought into range; pairs are counted from 0 and from K.
#[derive(Clone, Debug)]
pub(super) struct RootQuotient {
    case: RootCase,
    n: [Dd; 2],
    l: [Dd; 2],
    m: [Dd; 2],
    w: [Dd; 2],
    /// What t3^4 and t1^4 take, with a pair.
    fourth: [[Dd; 2]; 2],
    mc: Dd,
    /// Signs of u and u', and the powers of two that their factors cannot carry.
    u_scale: [f64; 2],
    velocity_scale: [f64; 2],
}

fn largest_power(values: &[Scaled]) -> i32 {
    values.iter().filter(|value| !value.is_zero()).map(|value| value.power()).max().unwrap_or(0)
}

impl Squares {
    pub fn of(energy: &NonzeroEnergy) -> Squares {
        let [upper, lower, total] = energy.gaps;
        let m = energy.m();
        let poles = energy.pole.is_some();
        let (squares, velocity) = match (energy.case, energy.roots) {
            (RootCase::Crossing, Distances::Three(v)) => {
                (if poles { [-v[2], -v[1]] } else { [total, v[0]] }, total)
            }
            (RootCase::Inside, Distances::Three(v)) => {
                (if poles { [m * v[0], lower] } else { [v[1], v[2]] }, lower)
            }
            (RootCase::Between, Distances::Three(v)) => {
                (if poles { [upper, -(m * v[2])] } else { [v[0], v[1]] }, upper)
            }
            (_, Distances::Three(v)) => ([v[1], v[0]], total),
            (_, Distances::One([v, ..])) => {
                let sum = total + v.abs();
                (if poles { [sum, sum] } else { [total, v] }, total)
            }
        };
        Squares { case: energy.case, m, mc: energy.mc, squares, velocity: velocity * energy.omega }
    }
}

impl RootQuotient {
    pub fn new(given: &Squares, neville: &NevilleTheta, orientation: Orientation) -> RootQuotient {
        let Squares { case, m, mc, squares: [l, q], velocity } = *given;
        let t = Scaled::from(neville.theta1_factor);
        let square = t.square();
        let one = Scaled::ONE;
        let (n, squares, w) = match case {
            RootCase::Crossing => ([t, one], [[l, l * mc * square], [q * square, q]], [one, mc * t]),
            RootCase::Inside => ([one, one], [[l, l * square], [q * mc * square, q]], [mc * t, t]),
            RootCase::Between => ([one, one], [[l, l * mc * square], [q * square, q]], [t, mc * t]),
            RootCase::PairCrossing => ([t, one], [[l, l * square], [q * square, q]], [one, t]),
            RootCase::PairOutside => ([one, t], [[l, l * square], [q * square, q]], [t, one]),
            _ => ([one, t], [[l, l * square], [q * mc * square, q]], [mc * t, one]),
        };
        let fourth = [[one, mc], [m * mc * square.square(), m]].map(|pair| pair.map(Scaled::to_dd));
        // Each way of counting has M of order 1.
        let [l, q] = squares;
        let powers = [0, 1].map(|k| largest_power(&[l[k], q[k]]).div_euclid(2));
        let scaled = |pair: [Scaled; 2], step: i32| [0, 1].map(|k| pair[k].shift(step * powers[k]));
        let (l, q) = (scaled(l, -2), scaled(q, -2));
        let (n, w) = (scaled(n, -1), scaled(w.map(|factor| factor * velocity), -3));
        let [n, w] = [n, w].map(|pair| pair.map(|factor| over_common_power([factor])));
        let Orientation { sign, direction } = orientation;
        RootQuotient {
            case,
            n: n.map(|([factor], _)| factor),
            l: l.map(Scaled::to_dd),
            m: q.map(Scaled::to_dd),
            w: w.map(|([factor], _)| factor),
            fourth,
            mc: mc.to_dd(),
            u_scale: n.map(|(_, power)| sign * power),
            velocity_scale: w.map(|(_, power)| sign * direction * power),
        }
    }

    /// Factors of u and u', where they are counted from 0.
    pub fn scales(&self) -> [f64; 2] {
        [self.u_scale[0], self.velocity_scale[0]]
    }

    /// Powers of two by which u and u' differ where they are counted from K.
    pub fn steps(&self) -> [f64; 2] {
        [&self.u_scale, &self.velocity_scale].map(|scale| scale[1] / scale[0])
    }

    #[inline(always)]
    fn pair(&self) -> bool {
        matches!(self.case, RootCase::PairCrossing | RootCase::PairOutside)
    }

    /// Whether u is odd about its base.
    #[inline(always)]
    fn odd(&self) -> bool {
        matches!(self.case, RootCase::Crossing | RootCase::PairCrossing)
    }

    /// n, w and M.
    #[inline(always)]
    fn parts<L: Lane>(&self, Thetas { theta: [t1, t2, t3, t4], folded }: Thetas<L>) -> [Dd<L>; 3] {
        let (from_k, from_0) = ([t2, t1, t4, t3], [t1, t2, t3, t4]);
        let t1 = Dd::select(folded, from_k[0], from_0[0]);
        let t2 = Dd::select(folded, from_k[1], from_0[1]);
        let t3 = Dd::select(folded, from_k[2], from_0[2]);
        let t4 = Dd::select(folded, from_k[3], from_0[3]);
        let (p, q, n, w) = if self.pair() {
            let (odd, even) = (t1 * t3, t2 * t4);
            let [first, second] = &self.fourth;
            let (left, right) = (t3.square().square(), t1.square().square());
            let sum = (left * pick(folded, first)).plain_sum(right * pick(folded, second));
            if self.odd() { (even, odd, odd, even * sum) } else { (even, odd, even, odd * sum) }
        } else {
            let (n, a, b, c) = match self.case {
                RootCase::Crossing => (t1, t2, t3, t4),
                RootCase::Inside => (t3, t1, t2, t4),
                RootCase::Between => (t4, t1, t2, t3),
                _ => (t2, t1, t3, t4),
            };
            (t2, t1, n, a * b * c)
        };
        let sum = (p.square() * pick(folded, &self.l)).plain_sum(q.square() * pick(folded, &self.m));
        [n * pick(folded, &self.n), w * pick(folded, &self.w), sum]
    }

    /// sn (sn dn with a pair), and the squares of sn, cn and dn.
    #[inline(always)]
    fn distance<L: Lane>(
        &self,
        neville: &NevilleTheta,
        Thetas { theta: [t1, t2, t3, t4], folded }: Thetas<L>,
    ) -> [Dd<L>; 4] {
        let t1 = t1 * Dd::splat(neville.theta1_factor);
        let sn = quotient(Dd::select(folded, t2, t1), Dd::select(folded, t3, t4));
        if !self.pair() {
            return [sn; 4];
        }
        let mc = Dd::splat(self.mc);
        let cn = quotient(Dd::select(folded, t1, t2), Dd::select(folded, t3, t4)).square();
        let cn = Dd::select(folded, cn * mc, cn);
        let dn_over = quotient(Dd::select(folded, t4, t3), Dd::select(folded, t3, t4));
        let dn = Dd::select(folded, dn_over * Dd::splat(neville.kc), dn_over);
        [sn * dn, sn.square(), cn, dn.square()]
    }

    /// u and u' at half periods f in [0, 1/2] from the base and, for an escape, to the poles ahead and behind; and whether
    /// they are counted from K. The powers of two and signs that belong to that are left out.
    #[inline(always)]
    pub fn quotients<const HYPERBOLIC: bool, L: Lane>(
        &self,
        neville: &NevilleTheta,
        arguments: [Dd<L>; 3],
        escapes: bool,
    ) -> (Unnormalised<L>, Unnormalised<L>, L::Mask) {
        let (zero, one) = (Dd::from_double(L::splat(0.0)), L::splat(1.0));
        // A loop, so that the theta functions, which are long, stand here once.
        let mut found = [zero; 3];
        let mut folded = one.less(one);
        let (mut product, mut below, mut dn_factor) = (Dd::from_double(one), zero, zero);
        let count = if escapes { 3 } else { 1 };
        let mut k = 0;
        while k < count {
            let thetas = neville.thetas_on::<HYPERBOLIC, L>(arguments[k]);
            k += 1;
            if k == 1 {
                folded = thetas.folded;
                found = self.parts(thetas);
                continue;
            }
            let [sn, square, cn, dn] = self.distance(neville, thetas);
            product = product * sn;
            // 1 - m sn^2 d sn^2 e, as a sum.
            if k == 2 {
                (below, dn_factor) = (cn, square);
            } else {
                below = below.plain_sum(dn_factor * dn);
            }
        }
        let [n, w, mut sum] = found;
        if escapes {
            sum = sum * product;
            if self.pair() {
                sum = quotient(sum, below);
            }
        }
        let root = Unnormalised::from(sum).inverse_root();
        (Unnormalised::from(n) * root, Unnormalised::from(w) * (root * root * root), folded)
    }
}

/// A motion at any time; NaN beyond a pole and 2^53 half periods away.
pub(super) struct RootFormula<'a, const HYPERBOLIC: bool> {
    pub clock: &'a Clock,
    pub neville: &'a NevilleTheta,
    pub quotient: &'a RootQuotient,
}

impl<const HYPERBOLIC: bool> Formula<1, 2> for RootFormula<'_, HYPERBOLIC> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let RootFormula { clock, neville, quotient } = self;
        let scaled = t * L::splat(clock.time);
        let one = L::splat(1.0);
        let zero = Dd::from_double(L::splat(0.0));
        let (f, [ahead, behind], u_sign, velocity_sign) = match &clock.poles {
            None => {
                let (n, f) = clock.phase.spread::<L>().count(scaled, LAST_HALF_PERIOD);
                let sign = one.copysign(f.hi);
                let parity = alternating(n);
                let (u_sign, velocity_sign) =
                    if quotient.odd() { (sign * parity, parity) } else { (one, sign) };
                (f.scale(sign), [zero; 2], u_sign, velocity_sign)
            }
            Some(poles) => {
                let f = clock.phase.counted(scaled);
                let ahead = poles.rest.counted(scaled);
                let at = Dd::splat(poles.at);
                // Each from what is nearer, and so with the digits of the start.
                let near = ahead.hi.abs().less(f.hi.abs());
                let f = Dd::select(near, at + -ahead, f);
                let sign = one.copysign(f.hi);
                let (u_sign, velocity_sign) = if quotient.odd() { (sign, one) } else { (one, sign) };
                (f.scale(sign), [within(ahead), within(at + f)], u_sign, velocity_sign)
            }
        };
        let escapes = clock.poles.is_some();
        let (u, velocity, folded) = quotient.quotients::<HYPERBOLIC, L>(neville, [f, ahead, behind], escapes);
        [
            (u.hi + u.lo) * (u_sign * pick_double(folded, &quotient.u_scale)),
            (velocity.hi + velocity.lo) * (velocity_sign * pick_double(folded, &quotient.velocity_scale)),
        ]
    }
}

/// The factor for the way of counting.
#[inline(always)]
fn pick<L: Lane>(folded: L::Mask, pair: &[Dd; 2]) -> Dd<L> {
    Dd::select(folded, Dd::splat(pair[1]), Dd::splat(pair[0]))
}

/// The same of doubles.
#[inline(always)]
pub(super) fn pick_double<L: Lane>(folded: L::Mask, pair: &[f64; 2]) -> L {
    L::select(folded, L::splat(pair[1]), L::splat(pair[0]))
}

/// An argument to a pole, in half periods: folded into [0, 1/2], NaN where it is not positive.
#[inline(always)]
pub(super) fn within<L: Lane>(f: Dd<L>) -> Dd<L> {
    let beyond = L::splat(0.5).less(f.hi);
    let rest = Dd::sum(L::splat(1.0), -f.hi).plain_sum(Dd::from_double(-f.lo));
    let inside = L::splat(0.0).less(f.hi);
    Dd::select(inside, Dd::select(beyond, rest, f), Dd::from_double(L::splat(f64::NAN)))
}

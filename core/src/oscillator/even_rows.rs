//! u'' + p u + r u^2 + q u^3 = c from a start, over lanes and without the phase of the start: every row may have a start and
//! coefficients of its own. For motions that stay; escapes are left out.
//!
//! With f, sigma, rho of quartic.rs, W = wp(t) + sigma/12 and Y = wp'(t) Weierstrass' solution of u'^2 = P(u) is
//!   u - u0 = (-u0' Y + f W - rho u0'^2/6)/(2 W^2 + q u0'^2/4),
//! and u' its derivative, where Y' and Y^2 are polynomials in W. With the S and C of curve.rs, wp - e1 = C^2/S^2, both are quotients
//! of polynomials in A = C^2 + (e1 + sigma/12) S^2, S^2 and C S: nothing grows without end at t = 0. The terms even and odd in t do not
//! cancel beyond the range of the motion, for their sum and their difference are both in it.
//! Floor: 1300 operations; for eight rows at two a cycle of 3 GHz 27 ns a row, for four 54.
//! Source: Whittaker & Watson 20.6, example 2 (Weierstrass, Biermann); DLMF 23.6, 22.6(ii).

use super::even_start::{CurveOnLanes, Start, TWELFTH, curve, double, scaled, tight};
use crate::elliptic::phase::{alternating, turned};
use crate::elliptic::theta::neville_lanes::NevilleThetaLanes;
use crate::float::Dd;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Formula, Kernel, Lane, Sampler, sweep};

/// Half periods times what is left of the discriminant: beyond, what double-doubles lose of the period adds up.
const MANY: f64 = 1e12;

/// How much must be left of the terms of the divisor: less where a pole of u is near, and u changes fast.
const SHARP: f64 = 1e-3;

/// One row per lane, set up for any time; PAIR where two roots are complex.
pub(super) struct EvenStartOnLanes<L: Lane, const PAIR: bool, const HYPERBOLIC: bool> {
    u0: L,
    velocity0: L,
    force: Unnormalised<L>,
    /// e1 + sigma/12.
    kappa: Unnormalised<L>,
    /// q u0'^2/8, and f times it.
    pole: Unnormalised<L>,
    force_pole: Unnormalised<L>,
    /// rho u0'^2/12.
    bend: Unnormalised<L>,
    /// Of A^3 S^2, A^2 S^4, A S^6 and S^8 in u'.
    even: [Unnormalised<L>; 4],
    neville: NevilleThetaLanes<L>,
    /// Half periods per time.
    rate: Unnormalised<L>,
    /// What S takes.
    scale: Unnormalised<L>,
    /// So many half periods keep their digits; 0 where none do.
    within: L,
}

impl<L: Lane, const PAIR: bool, const HYPERBOLIC: bool> EvenStartOnLanes<L, PAIR, HYPERBOLIC> {
    #[inline(always)]
    pub fn new(given: [L; 6]) -> Self {
        let [u0, velocity0, _, q, ..] = given;
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let start = Start::new(given);
        let CurveOnLanes { e1, square, m, mc } = curve::<L, PAIR, HYPERBOLIC>(&start.invariants);
        let left = start.left();
        let Start { v2, q_v2, rho, sigma, force, rho_force, .. } = start;
        let twelfth = Unnormalised::splat(TWELFTH);
        let kappa = tight((e1 + sigma) * twelfth);
        let pole = scaled(q_v2, 0.125);
        let bend = rho * v2 * twelfth;
        let sixth = rho_force * scaled(twelfth, 2.0);
        // rho^2 u0'^2/36 - q sigma u0'^2/16 - q f^2/8 and q u0'^2/16 (q u0'^2/4 - rho f/6).
        let third = scaled(rho * bend * twelfth, 4.0) - scaled(sigma * pole, 0.5);
        let third = third - scaled(double(q) * force.square(), 0.125);
        let fourth = scaled(pole, 0.5) * (scaled(pole, 2.0) - sixth);
        let even = [scaled(sigma, 0.5), scaled(rho_force, 0.25), third, fourth];
        let neville = NevilleThetaLanes::new::<HYPERBOLIC>(m, mc);
        let scale = square.inverse_root();
        let speed = square * scale;
        let rate = if PAIR { scaled(speed, 2.0) } else { speed } * neville.frequency;
        // Where q <= 0, it stays if the divisor is above 0 all the time.
        let kappa_square = kappa.hi * kappa.hi;
        let margin = kappa.hi * kappa.hi.abs() + pole.hi - kappa_square * L::splat(SHARP);
        let stays = L::select(zero.less(q), one, margin);
        let known = if HYPERBOLIC {
            left
        } else if PAIR {
            one
        } else {
            left.sqrt()
        };
        let within = L::select(zero.less(stays), known * L::splat(MANY), zero);
        let force_pole = force * pole;
        EvenStartOnLanes {
            u0,
            velocity0,
            force,
            kappa,
            pole,
            force_pole,
            bend,
            even,
            neville,
            rate,
            scale,
            within,
        }
    }

    /// W S, C and S'C - SC' at n half periods and the rest f, but for a common factor and its square.
    #[inline(always)]
    fn pair(&self, n: L, f: Dd<L>) -> [Unnormalised<L>; 3] {
        let sign = L::splat(1.0).copysign(f.hi);
        let point = self.neville.at::<HYPERBOLIC>(f.scale(sign));
        let parity = alternating(n);
        let sn = point.sn.scale(sign * parity);
        if PAIR {
            // Of half the argument, by sn/(1 + cn) = (1 - cn)/sn.
            let beyond = parity.less(L::splat(0.0));
            let sum = point.unit + point.cn;
            let sine = Unnormalised::select(beyond, sum, sn);
            let cosine = Unnormalised::select(beyond, sn, sum);
            return [sine, cosine, scaled(point.dn * sum, 2.0)];
        }
        [sn, point.cn.scale(parity), point.dn * point.unit]
    }

    /// u and u' at t: NaN where the row must be left out.
    #[inline(always)]
    fn after(&self, t: L) -> [L; 2] {
        let nan = L::splat(f64::NAN);
        let (n, f) = turned(t, self.rate);
        let [sine, cosine, slope] = self.pair(n, f);
        let sine = sine * self.scale;
        let (s2, c2) = (sine.square(), cosine.square());
        let turned = self.kappa * s2;
        let a = tight(c2 + turned);
        let (s4, a2) = (s2.square(), a.square());
        let divisor = tight(a2 + self.pole * s4);
        let odd = cosine * sine * slope;
        let v = double(self.velocity0);
        let way = v * odd + s2 * (scaled(self.force * a, 0.5) - self.bend * s2);
        let [first, second, third, fourth] = self.even;
        let even = a * (a - first * s2) - second * s4;
        let even = a * (a * even + third * (s2 * s4)) - fourth * s4.square();
        let of_odd = a * (self.force * a - scaled(self.bend * s2, 4.0)) - self.force_pole * s4;
        let inverse = divisor.inverse();
        let u = double(self.u0) + way * inverse;
        let velocity = (v * even + odd * of_odd) * inverse.square();
        // Where the divisor is small beside its terms, u changes fast.
        let whole = c2.hi + turned.hi.abs();
        let smooth = (whole * whole * L::splat(SHARP)).less(divisor.hi);
        let known = L::select(n.abs().less(self.within), u.hi + u.lo, nan);
        let u = L::select(smooth, known, nan);
        let start = t.equal(L::splat(0.0));
        let velocity = L::select(u.equal(u), velocity.hi + velocity.lo, nan);
        [L::select(start, self.u0, u), L::select(start, self.velocity0, velocity)]
    }
}

/// One start, many times.
impl<L: Lane, const PAIR: bool, const HYPERBOLIC: bool> Sampler<L, 1, 2>
    for EvenStartOnLanes<L, PAIR, HYPERBOLIC>
{
    #[inline(always)]
    fn at(&self, [t]: [L; 1]) -> [L; 2] {
        self.after(t)
    }
}

/// A start of its own in every row of t, u0, u0', p, q, r and c.
pub(super) struct EvenPerRow<const PAIR: bool, const HYPERBOLIC: bool>;

impl<const PAIR: bool, const HYPERBOLIC: bool> Formula<7, 2> for EvenPerRow<PAIR, HYPERBOLIC> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [t, u0, velocity0, p, q, r, c]: [L; 7]) -> [L; 2] {
        EvenStartOnLanes::<L, PAIR, HYPERBOLIC>::new([u0, velocity0, p, q, r, c]).after(t)
    }
}

/// One start, many times: set up on the lanes that it is evaluated on.
pub(super) struct EvenSharedStart<'a, 'b, const PAIR: bool, const HYPERBOLIC: bool> {
    pub start: [f64; 6],
    pub t: &'a [f64],
    pub results: [&'b mut [f64]; 2],
}

impl<const PAIR: bool, const HYPERBOLIC: bool> Kernel for EvenSharedStart<'_, '_, PAIR, HYPERBOLIC> {
    type Output = ();
    type Place = Self;
    #[inline(always)]
    fn run<L: Lane>(mut self) {
        let mut given = [L::splat(0.0); 6];
        let mut k = 0;
        while k < 6 {
            given[k] = L::splat(self.start[k]);
            k += 1;
        }
        let start = EvenStartOnLanes::<L, PAIR, HYPERBOLIC>::new(given);
        sweep::<L, _, _, _>(&start, [self.t], &mut self.results, &[])
    }
}

//! u = A pq(x | m): the motions without a quintic force. There v = 0 is a root of C(v), and no square root is left.
//!
//! With Neville's theta functions s, c, d, n (A & S 16.36), here theta1 (without its factor A) to theta4, pq = p/q and
//! pq' = slope r s/q^2, r and s the other two letters. Counted from K, s and c, d and n change places.
//!
//! | u | r s | slope | motion |
//! |---|---|---|---|
//! | sn | c d | 1 | libration, softening; linear with m = 0 |
//! | sd | c n | 1 | libration, hardening: A k' sd(x) = A cn(x - K) |
//! | nd | s c | m | well: A k' nd(x) = A dn(x - K) |
//! | nc | s d | 1 | escape, E < 0 |
//! | dc | s n | k'^2 | escape over a barrier |
//! | sc | d n | 1 | escape through u = 0 |
//! | sn dn/cn | (d^4 + m k'^2 s^4)/(c n)^2 | | escape, two roots complex |
//!
//! Source: DLMF 20.2, 22.2.10, 22.13(i); the forms of Salas 2019.

use super::clock::Clock;
use super::energy::Orientation;
use super::nonzero_energy::{NonzeroEnergy, RootCase};
use super::roots::Distances;
use crate::elliptic::phase::{LAST_HALF_PERIOD, alternating};
use crate::elliptic::theta::neville::{NevilleTheta, Thetas};
use crate::float::Dd;
use crate::float::elementary::quotient;
use crate::float::scaled::{Scaled, over_common_power};
use crate::lanes::{Formula, Lane};
use crate::motion::escape::{Escape, Position};

/// The quotient that u is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Pq {
    Sn,
    Sd,
    Nd,
    Nc,
    Dc,
    Sc,
    SnDnOverCn,
}

/// A quotient with its amplitude and velocity; pairs are counted from 0 and from K.
#[derive(Clone, Debug)]
pub(super) struct PqQuotient {
    pub pq: Pq,
    u: [Dd; 2],
    velocity: [Dd; 2],
    /// For [`Pq::SnDnOverCn`]: roots of what s^4 takes in the velocity where d^4 takes those in `velocity`; and the
    /// factor of both.
    other: [Dd; 2],
    slope: Dd,
    /// Powers of two that the factors of u and u' cannot carry, with the signs of u and u'.
    pub scales: [f64; 2],
}

impl Pq {
    /// The quotient of a motion without a quintic force, and its amplitude.
    pub fn of(energy: &NonzeroEnergy) -> (Pq, Scaled) {
        let total = energy.gaps[2];
        let (pq, square) = match (energy.case, energy.roots) {
            (RootCase::Crossing, Distances::Three(v)) if v[2].is_zero() => (Pq::Sn, v[0]),
            (RootCase::Crossing, Distances::Three(v)) if v[0].is_zero() => (Pq::Sc, -v[2]),
            (RootCase::Crossing, _) => (Pq::Sd, total),
            (RootCase::Between, Distances::Three(v)) if v[2].is_zero() => (Pq::Nd, v[0]),
            (RootCase::Between, Distances::Three(v)) => (Pq::Nc, v[0]),
            (_, Distances::Three(v)) => (Pq::Dc, v[1]),
            _ => (Pq::SnDnOverCn, total),
        };
        (pq, Scaled::ONE / square.sqrt())
    }

    /// Whether u is odd about the base.
    pub fn odd(self) -> bool {
        matches!(self, Pq::Sn | Pq::Sd | Pq::Sc | Pq::SnDnOverCn)
    }

    /// pq' over r s/q^2.
    pub fn slope(self, m: Scaled, mc: Scaled) -> Scaled {
        match self {
            Pq::Nd => m,
            Pq::Dc => mc,
            _ => Scaled::ONE,
        }
    }

    /// p, q, r and s, from the values that belong to the letters s, c, d and n.
    #[inline(always)]
    pub fn letters<T: Copy>(self, [s, c, d, n]: [T; 4]) -> [T; 4] {
        match self {
            Pq::Sn => [s, n, c, d],
            Pq::Sd => [s, d, c, n],
            Pq::Nd => [n, d, s, c],
            Pq::Nc => [n, c, s, d],
            Pq::Dc => [d, c, s, n],
            Pq::Sc | Pq::SnDnOverCn => [s, c, d, n],
        }
    }
}

impl PqQuotient {
    /// From the amplitude, the rate of the argument, the parameter and its complement.
    pub fn new(
        (pq, amplitude): (Pq, Scaled),
        omega: Scaled,
        [m, mc]: [Scaled; 2],
        neville: &NevilleTheta,
        orientation: Orientation,
    ) -> PqQuotient {
        let t = Scaled::from(neville.theta1_factor);
        let (one, kc) = (Scaled::ONE, mc.sqrt());
        // Of s, c, d and n, counted from 0 and from K.
        let [p, q, r, s] = pq.letters([[t, one], [one, kc * t], [one, kc], [one, one]]);
        let slope = pq.slope(m, mc);
        let speed = amplitude * omega;
        let (u, velocity, other, slope) = if pq == Pq::SnDnOverCn {
            // Roots of what d^4 and s^4 take: the fourth powers themselves may leave the range.
            let root = m.sqrt();
            ([amplitude * t, amplitude / t], [one, kc / t], [root * kc * t.square(), root / t], speed)
        } else {
            // Most factors are 1: a product with the inverse costs less than a quotient.
            let over = q.map(|factor| if (factor - one).is_zero() { one } else { one / factor });
            let u = [0, 1].map(|k| amplitude * p[k] * over[k]);
            let speed = slope * speed;
            (u, [0, 1].map(|k| speed * r[k] * s[k] * over[k].square()), [Scaled::ZERO; 2], one)
        };
        let (u, u_scale) = over_common_power(u);
        let (velocity, slope, velocity_scale) = if pq == Pq::SnDnOverCn {
            let ([slope], scale) = over_common_power([slope]);
            (velocity.map(Scaled::to_dd), slope, scale)
        } else {
            let (velocity, scale) = over_common_power(velocity);
            (velocity, Dd::ONE, scale)
        };
        let Orientation { sign, direction } = orientation;
        PqQuotient {
            pq,
            u,
            velocity,
            other: other.map(Scaled::to_dd),
            slope,
            scales: [u_scale * sign, velocity_scale * (sign * direction)],
        }
    }

    /// Numerators and denominators of u and u', but for their scales, at f in [0, 1/2] half periods from the base or,
    /// with `from_pole`, from K.
    #[inline(always)]
    pub fn quotients<const HYPERBOLIC: bool, L: Lane>(
        &self,
        neville: &NevilleTheta,
        f: Dd<L>,
        from_pole: bool,
    ) -> [[Dd<L>; 2]; 2] {
        let Thetas { theta, folded } = neville.thetas_on::<HYPERBOLIC, L>(f);
        let at = unfolded(theta, folded, from_pole);
        let near = usize::from(from_pole);
        if self.pq == Pq::SnDnOverCn {
            let [s, c, d, n] = at;
            let (above, below) = (s * d, c * n);
            let dn = quotient(d.square() * pick(folded, &self.velocity, near), below);
            let sn = quotient(s.square() * pick(folded, &self.other, near), below);
            let rising = dn.square().plain_sum(sn.square()) * Dd::splat(self.slope);
            return [[above * pick(folded, &self.u, near), below], [rising, Dd::from_double(L::splat(1.0))]];
        }
        let [p, q, r, s] = self.pq.letters(at);
        [[p * pick(folded, &self.u, near), q], [r * s * pick(folded, &self.velocity, near), q.square()]]
    }
}

/// s, c, d and n counted from 0 or, with `from_pole`, from K, whichever the theta functions were counted from.
#[inline(always)]
fn unfolded<L: Lane>([s, c, d, n]: [Dd<L>; 4], folded: L::Mask, from_pole: bool) -> [Dd<L>; 4] {
    let (from_0, from_k) = ([s, c, d, n], [c, s, n, d]);
    let (near, far) = if from_pole { (from_k, from_0) } else { (from_0, from_k) };
    [
        Dd::select(folded, far[0], near[0]),
        Dd::select(folded, far[1], near[1]),
        Dd::select(folded, far[2], near[2]),
        Dd::select(folded, far[3], near[3]),
    ]
}

/// The factor that belongs to the way of counting: the one of `near`, or the other where the phase is folded.
#[inline(always)]
fn pick<L: Lane>(folded: L::Mask, pair: &[Dd; 2], near: usize) -> Dd<L> {
    Dd::select(folded, Dd::splat(pair[1 - near]), Dd::splat(pair[near]))
}

/// A libration or a well, at any time.
pub(super) struct BoundedFormula<'a, const HYPERBOLIC: bool> {
    pub clock: &'a Clock,
    pub neville: &'a NevilleTheta,
    pub quotient: &'a PqQuotient,
}

/// An escape, at any time; NaN beyond the poles.
pub(super) struct EscapeFormula<'a, const HYPERBOLIC: bool> {
    pub escape: &'a Escape,
    pub neville: &'a NevilleTheta,
    pub quotient: &'a PqQuotient,
}

/// a b but for the product of the low words, as hi + lo not normalised.
#[inline(always)]
fn product<L: Lane>(a: Dd<L>, b: Dd<L>) -> Dd<L> {
    let (hi, error) = a.hi.two_product(b.hi);
    Dd::new(hi, a.hi.mul_add(b.lo, a.lo.mul_add(b.hi, error)))
}

impl<const HYPERBOLIC: bool> Formula<1, 2> for BoundedFormula<'_, HYPERBOLIC> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let BoundedFormula { clock, neville, quotient } = self;
        let (n, f) = clock.phase.spread::<L>().count(t * L::splat(clock.time), LAST_HALF_PERIOD);
        let one = L::splat(1.0);
        let sign = one.copysign(f.hi);
        let Thetas { theta, folded } = neville.thetas_on::<HYPERBOLIC, L>(f.scale(sign));
        let [p, q, r, s] = quotient.pq.letters(unfolded(theta, folded, false));
        // One division for both.
        let inverse = one / q.hi;
        let (back, error) = inverse.two_product(q.hi);
        let rest = ((one - back) - error) - inverse * q.lo;
        let inverse = Dd::new(inverse, inverse * rest);
        let u = product(product(p, pick(folded, &quotient.u, 0)), inverse);
        let velocity =
            product(product(product(r, inverse), product(s, inverse)), pick(folded, &quotient.velocity, 0));
        let (u_sign, velocity_sign) = if quotient.pq == Pq::Nd {
            (one, sign)
        } else {
            let parity = alternating(n);
            (sign * parity, parity)
        };
        [
            u.value() * (u_sign * L::splat(quotient.scales[0])),
            velocity.value() * (velocity_sign * L::splat(quotient.scales[1])),
        ]
    }
}

impl<const HYPERBOLIC: bool> Formula<1, 2> for EscapeFormula<'_, HYPERBOLIC> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let EscapeFormula { escape, neville, quotient: pq } = self;
        let Position { sign, size, rest, .. } = escape.position(t);
        // False for NaN as well.
        let inside = L::splat(0.0).less(rest.hi);
        let distance = if escape.from_pole { rest } else { size };
        let distance = Dd::select(inside, distance, Dd::from_double(L::splat(0.25)));
        let [[above, below], [rising, square]] =
            pq.quotients::<HYPERBOLIC, L>(neville, distance, escape.from_pole);
        let one = L::splat(1.0);
        let (u_sign, velocity_sign) = if pq.pq.odd() { (sign, one) } else { (one, sign) };
        let u = quotient(above, below).value() * (u_sign * L::splat(pq.scales[0]));
        let velocity = quotient(rising, square).value() * (velocity_sign * L::splat(pq.scales[1]));
        let nan = L::splat(f64::NAN);
        [L::select(inside, u, nan), L::select(inside, velocity, nan)]
    }
}

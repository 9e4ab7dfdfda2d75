//! Quotients of theta functions for the motions of the cubic-quintic oscillator: factors and samples over lanes.
//!
//! With t1 to t4 (t1 without its factor A), counted from 0 or, in brackets, from K, where t1 and t2, t3 and t4 change
//! places: u = n/sqrt M, u' = w/M^(3/2), M = (l p^2 + m q^2) times sn d sn e where there are poles.
//!
//! | form | n | p, q | w |
//! |---|---|---|---|
//! | crossing | t1 | t2, t1 | t2 t3 t4 |
//! | inside | t3 | t2, t1 | t1 t2 t4 |
//! | between | t4 | t2, t1 | t1 t2 t3 |
//! | outside | t2 | t2, t1 | t1 t3 t4 |
//! | crossing, pair | t1 t3 | t2 t4, t1 t3 | t2 t4 (t3^4 + m k'^2 A^4 t1^4) |
//! | outside, pair | t2 t4 | t2 t4, t1 t3 | t1 t3 (t3^4 + m k'^2 A^4 t1^4) |
//!
//! Source: DLMF 20.2, 22.2, 22.13(i).

use super::argument::{Form, Mark, Marks};
use super::cubic_course::lattice;
use super::roots::Distances;
use super::set_up::{Outline, Way};
use super::singularities::{Singular, flight, swing};
use crate::elliptic::phase::{LAST_HALF_PERIOD, Phase, alternating};
use crate::elliptic::theta::neville::{NevilleTheta, Thetas};
use crate::float::Dd;
use crate::float::elementary::quotient;
use crate::float::exponent::ldexp;
use crate::float::scaled::Scaled;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::Lane;
use crate::motion::samples::Drawing;

/// The poles of an escape: argument to the one ahead at any time, and of both, in half periods.
#[derive(Clone, Debug)]
struct Poles {
    rest: Phase,
    at: Dd,
}

/// A motion by theta functions; pairs are counted from 0 and from K.
#[derive(Clone, Debug)]
pub(super) struct Theta {
    form: Form,
    pub lattice: NevilleTheta,
    /// Half periods 2K from the base.
    phase: Phase,
    poles: Option<Poles>,
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
    time: f64,
    /// 2K.
    half: Scaled,
    /// The polynomials of the motion, and what tells where its singularities are.
    pub drawing: Drawing,
    pub place: Singular,
}

/// Powers of two that a double-double can carry beside its digits, and those a factor can.
const CARRIED: i32 = 300;
const OUTSIDE: i32 = 1000;

/// m, l, velocity factor and so on before they are brought into range.
pub(super) struct Factors {
    pub form: Form,
    pub m: Scaled,
    pub mc: Scaled,
    pub omega: Scaled,
    /// Of p^2 and of q^2.
    pub squares: [Scaled; 2],
    /// Of u'.
    pub velocity: Scaled,
    pub pole: Option<Scaled>,
}

fn power_of(values: &[Scaled]) -> i32 {
    values.iter().filter(|value| !value.is_zero()).map(|value| value.power()).max().unwrap_or(0)
}

/// The motion, and its half period 2K of the argument.
pub(super) fn theta(marks: &Marks, outline: &Outline, start: Mark, way: Way) -> (Theta, Scaled) {
    let [upper, lower, total] = marks.gaps;
    let mc = marks.mc;
    let poles = outline.pole.is_some();
    let (m, squares, velocity) = match (marks.form, marks.roots) {
        (Form::Crossing, Distances::Three(v)) => {
            let squares = if poles { [-v[2], -v[1]] } else { [total, v[0]] };
            (lower / total, squares, total)
        }
        (Form::Inside, Distances::Three(v)) => {
            let m = lower / total;
            (m, if poles { [m * v[0], lower] } else { [v[1], v[2]] }, lower)
        }
        (Form::Between, Distances::Three(v)) => {
            let m = upper / total;
            (m, if poles { [upper, -(m * v[2])] } else { [v[0], v[1]] }, upper)
        }
        (_, Distances::Three(v)) => (upper / total, [v[1], v[0]], total),
        (_, Distances::One([v, ..])) => {
            let [q, w, h] = marks.gaps;
            let difference = if q.is_negative() { h - q } else { w.square() / (h + q) };
            let sum = h + v.abs();
            let squares = if poles { [sum, sum] } else { [h, v] };
            (difference / h.shift(1), squares, h)
        }
    };
    let velocity = velocity * marks.omega;
    let factors =
        Factors { form: marks.form, m, mc, omega: marks.omega, squares, velocity, pole: outline.pole };
    Theta::new(&factors, start, way)
}

impl Theta {
    pub fn new(factors: &Factors, start: Mark, way: Way) -> (Theta, Scaled) {
        let Factors { form, m, mc, omega, squares: [l, q], velocity, pole } = *factors;
        let lattice = lattice(m, mc);
        let half = Scaled::from(lattice.quarter).shift(1);
        let t = Scaled::from(lattice.theta1_factor);
        let square = t.square();
        let one = Scaled::ONE;
        let (n, squares, w) = match form {
            Form::Crossing => ([t, one], [[l, l * mc * square], [q * square, q]], [one, mc * t]),
            Form::Inside => ([one, one], [[l, l * square], [q * mc * square, q]], [mc * t, t]),
            Form::Between => ([one, one], [[l, l * mc * square], [q * square, q]], [t, mc * t]),
            Form::PairCrossing => ([t, one], [[l, l * square], [q * square, q]], [one, t]),
            Form::PairOutside => ([one, t], [[l, l * square], [q * square, q]], [t, one]),
            _ => ([one, t], [[l, l * square], [q * mc * square, q]], [mc * t, one]),
        };
        let fourth = [[one, mc], [m * mc * square.square(), m]].map(|pair| pair.map(Scaled::to_dd));
        // Each way of counting has M of order 1.
        let [l, q] = squares;
        let powers = [0, 1].map(|k| power_of(&[l[k], q[k]]).div_euclid(2));
        let scaled = |pair: [Scaled; 2], step: i32| [0, 1].map(|k| pair[k].shift(step * powers[k]));
        let (l, q) = (scaled(l, -2), scaled(q, -2));
        let (n, w) = (scaled(n, -1), scaled(w.map(|factor| factor * velocity), -3));
        let outside = |pair: [Scaled; 2]| pair.map(|factor| factor.power().clamp(-OUTSIDE, OUTSIDE));
        let (u_powers, velocity_powers) = (outside(n), outside(w));
        let carried = |pair: [Scaled; 2], powers: [i32; 2]| [0, 1].map(|k| pair[k].shift(-powers[k]).to_dd());
        let rate = omega / half;
        let time = rate.power() - rate.power().clamp(-CARRIED, CARRIED);
        let rate = rate.shift(-time).to_dd() * way.turn;
        let phase = Phase { rate, start: (start.base / half).to_dd() };
        let u_scale = u_powers.map(|power| way.side * ldexp(1.0, power));
        let velocity_scale = velocity_powers.map(|power| way.side * way.turn * ldexp(1.0, power));
        let place = Singular::new(factors, half);
        let drawn = match pole {
            Some(pole) => flight(place, &lattice, half, omega, [start.base, start.pole, pole], way.turn),
            None => swing(place, &lattice, phase, ldexp(1.0, time)),
        };
        let poles = pole.map(|pole| Poles {
            rest: Phase { rate: -rate, start: (start.pole / half).to_dd() },
            at: (pole / half).to_dd(),
        });
        let theta = Theta {
            form,
            phase,
            poles,
            n: carried(n, u_powers),
            l: l.map(Scaled::to_dd),
            m: q.map(Scaled::to_dd),
            w: carried(w, velocity_powers),
            fourth,
            mc: mc.to_dd(),
            u_scale,
            velocity_scale,
            time: ldexp(1.0, time),
            half,
            drawing: Drawing::new(drawn.scaled([u_scale[0], velocity_scale[0]])),
            place,
            lattice,
        };
        (theta, half)
    }

    /// Whether the motion has no poles.
    pub fn repeats(&self) -> bool {
        self.poles.is_none()
    }
    /// The phase from the base, and the power of two that times take.
    pub fn clock(&self) -> (&Phase, f64) {
        (&self.phase, self.time)
    }
    /// Half periods at the start and per time, from the base and to the pole.
    pub fn rates(&self) -> [[Scaled; 2]; 2] {
        let of = |phase: &Phase| [Scaled::from(phase.start), Scaled::from(phase.rate) * self.time];
        [of(&self.phase), self.poles.as_ref().map_or([Scaled::ZERO; 2], |poles| of(&poles.rest))]
    }
    /// Marks in half periods.
    pub fn in_half_periods(&self, Mark { base, pole }: Mark) -> Mark {
        Mark { base: base / self.half, pole: pole / self.half }
    }
    #[inline(always)]
    fn pair(&self) -> bool {
        matches!(self.form, Form::PairCrossing | Form::PairOutside)
    }

    /// Whether u is odd about its base.
    #[inline(always)]
    fn odd(&self) -> bool {
        matches!(self.form, Form::Crossing | Form::PairCrossing)
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
            let (n, a, b, c) = match self.form {
                Form::Crossing => (t1, t2, t3, t4),
                Form::Inside => (t3, t1, t2, t4),
                Form::Between => (t4, t1, t2, t3),
                _ => (t2, t1, t3, t4),
            };
            (t2, t1, n, a * b * c)
        };
        let sum = (p.square() * pick(folded, &self.l)).plain_sum(q.square() * pick(folded, &self.m));
        [n * pick(folded, &self.n), w * pick(folded, &self.w), sum]
    }

    /// sn (sn dn with a pair), and the squares of sn, cn and dn.
    #[inline(always)]
    fn distance<L: Lane>(&self, Thetas { theta: [t1, t2, t3, t4], folded }: Thetas<L>) -> [Dd<L>; 4] {
        let t1 = t1 * Dd::splat(self.lattice.theta1_factor);
        let sn = quotient(Dd::select(folded, t2, t1), Dd::select(folded, t3, t4));
        if !self.pair() {
            return [sn; 4];
        }
        let mc = Dd::splat(self.mc);
        let cn = quotient(Dd::select(folded, t1, t2), Dd::select(folded, t3, t4)).square();
        let cn = Dd::select(folded, cn * mc, cn);
        let dn_over = quotient(Dd::select(folded, t4, t3), Dd::select(folded, t3, t4));
        let dn = Dd::select(folded, dn_over * Dd::splat(self.lattice.kc), dn_over);
        [sn * dn, sn.square(), cn, dn.square()]
    }

    /// u and u', NaN beyond a pole and 2^53 half periods away.
    #[inline(always)]
    pub fn at<const HYPERBOLIC: bool, L: Lane>(&self, t: L) -> [L; 2] {
        let scaled = t * L::splat(self.time);
        let one = L::splat(1.0);
        let zero = Dd::from_double(L::splat(0.0));
        let (f, [ahead, behind], u_sign, velocity_sign) = match &self.poles {
            None => {
                let (n, f) = self.phase.spread::<L>().count(scaled, LAST_HALF_PERIOD);
                let sign = one.copysign(f.hi);
                let parity = alternating(n);
                let (u_sign, velocity_sign) = if self.odd() { (sign * parity, parity) } else { (one, sign) };
                (f.scale(sign), [zero; 2], u_sign, velocity_sign)
            }
            Some(poles) => {
                let f = self.phase.counted(scaled);
                let ahead = poles.rest.counted(scaled);
                let at = Dd::splat(poles.at);
                // Each from what is nearer, and so with the digits of the start.
                let near = ahead.hi.abs().less(f.hi.abs());
                let f = Dd::select(near, at + -ahead, f);
                let sign = one.copysign(f.hi);
                let (u_sign, velocity_sign) = if self.odd() { (sign, one) } else { (one, sign) };
                (f.scale(sign), [within(ahead), within(at + f)], u_sign, velocity_sign)
            }
        };
        let (u, velocity, folded) = self.quotients::<HYPERBOLIC, L>([f, ahead, behind]);
        [
            (u.hi + u.lo) * (u_sign * pick_double(folded, &self.u_scale)),
            (velocity.hi + velocity.lo) * (velocity_sign * pick_double(folded, &self.velocity_scale)),
        ]
    }

    /// u and u' at half periods f in [0, 1/2] from the base, and to the poles ahead and behind, if there are; and
    /// whether they are counted from K, but for the powers of two and signs that belong to that.
    #[inline(always)]
    pub fn quotients<const HYPERBOLIC: bool, L: Lane>(
        &self,
        arguments: [Dd<L>; 3],
    ) -> (Unnormalised<L>, Unnormalised<L>, L::Mask) {
        let (zero, one) = (Dd::from_double(L::splat(0.0)), L::splat(1.0));
        // A loop, so that the theta functions, which are long, stand here once.
        let mut found = [zero; 3];
        let mut folded = one.less(one);
        let (mut product, mut below, mut dn_factor) = (Dd::from_double(one), zero, zero);
        let count = if self.poles.is_some() { 3 } else { 1 };
        let mut k = 0;
        while k < count {
            let thetas = self.lattice.thetas_on::<HYPERBOLIC, L>(arguments[k]);
            k += 1;
            if k == 1 {
                folded = thetas.folded;
                found = self.parts(thetas);
                continue;
            }
            let [sn, square, cn, dn] = self.distance(thetas);
            product = product * sn;
            // 1 - m sn^2 d sn^2 e, as a sum.
            if k == 2 {
                (below, dn_factor) = (cn, square);
            } else {
                below = below.plain_sum(dn_factor * dn);
            }
        }
        let [n, w, mut sum] = found;
        if self.poles.is_some() {
            sum = sum * product;
            if self.pair() {
                sum = quotient(sum, below);
            }
        }
        let root = Unnormalised::from(sum).inverse_root();
        (Unnormalised::from(n) * root, Unnormalised::from(w) * (root * root * root), folded)
    }

    /// Half periods from pole to pole.
    pub fn flight(&self) -> Dd {
        self.poles.as_ref().map_or(Dd::ONE, |poles| poles.at.scale(2.0))
    }

    /// Powers of two by which u and u' differ where they are counted from K.
    pub fn steps(&self) -> [f64; 2] {
        [&self.u_scale, &self.velocity_scale].map(|scale| scale[1] / scale[0])
    }
}

/// The factor for the way of counting.
#[inline(always)]
fn pick<L: Lane>(folded: L::Mask, pair: &[Dd; 2]) -> Dd<L> {
    Dd::select(folded, Dd::splat(pair[1]), Dd::splat(pair[0]))
}

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

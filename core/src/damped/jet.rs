//! Taylor coefficients of the motion at one time, and the state that they give at another.
//!
//! With v' of equation.rs, s' = c v, c' = -s v and u' = -slip v u, every product is one with v. At order k the sum over j of
//! x_(k-j) v_j takes the latest coefficients last: so the processor forms the long middle of a sum while it waits for them.
//! Coefficients below LONG are double-doubles, because a step is 2^(-66/24) = 0.15 of the radius of convergence: the term of order
//! LONG is below 0.15^7 = 2e-6 of the motion, and its rounding error below 2^-72.
//!
//! One step is, for each of s and c (and |v| v, and u, where they act), 24 25/2 - 21 = 279 multiplications with additions in
//! double and 21 in double-double; and for each of s, c, v and theta a sum of 18 terms in double and 7 in double-double.
//! Source: Jorba & Zou, Exp. Math. 14 (2005) 99.

use super::taylor::{INVERSE, LONG, ORDER, Series, double, number, on_circle};
use super::torque_jet::TorqueJet;
use crate::float::Dd;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Kernel, Lane, single};

/// Places of the four variables.
pub(super) const SINE: usize = 0;
pub(super) const COSINE: usize = 1;
pub(super) const SLIP: usize = 2;
pub(super) const VELOCITY: usize = 3;

/// The equation on a piece where the sign of the velocity is known.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    pub omega2: Dd,
    pub linear: f64,
    /// Times the sign of the velocity.
    pub quadratic: f64,
    /// Times the sign of the velocity.
    pub dry: f64,
    /// Sign of the velocity over the presliding angle; 0 where presliding has settled.
    pub slip: f64,
}

/// Coefficients of powers of time of s, c, u and v; the low words of the first.
#[derive(Clone, Debug)]
pub(super) struct Jet {
    pub hi: [Series; 4],
    pub lo: [[f64; LONG]; 4],
}

impl Jet {
    pub const ZERO: Jet = Jet { hi: [[0.0; ORDER + 1]; 4], lo: [[0.0; LONG]; 4] };

    /// From the values of s, c, u, v. `at_limit`: the acceleration is 0, as it is when a stuck pendulum is released.
    pub fn fill(&mut self, start: &[Dd; 4], piece: &Piece, torque: &TorqueJet, at_limit: bool) {
        let jet = self;
        match (piece.quadratic != 0.0, piece.slip != 0.0) {
            (false, false) => single(Recurrence::<false, false> { jet, start, piece, torque, at_limit }),
            (true, false) => single(Recurrence::<true, false> { jet, start, piece, torque, at_limit }),
            (false, true) => single(Recurrence::<false, true> { jet, start, piece, torque, at_limit }),
            (true, true) => single(Recurrence::<true, true> { jet, start, piece, torque, at_limit }),
        }
    }

    /// s, c, u, v and the change of the angle a time later, as far as the series converges; s and c on the circle.
    pub fn at(&self, time: f64, slopes: &Series, slips: bool) -> [Dd; 5] {
        single(Sum { jet: self, time, slopes, slips })
    }
}

struct Recurrence<'a, const DRAG: bool, const SLIPS: bool> {
    jet: &'a mut Jet,
    start: &'a [Dd; 4],
    piece: &'a Piece,
    torque: &'a TorqueJet,
    at_limit: bool,
}

/// Coefficient k of x v, in double-double.
#[inline(always)]
fn long_product<L: Lane>(
    x: &[Unnormalised<L>; LONG],
    v: &[Unnormalised<L>; LONG],
    k: usize,
) -> Unnormalised<L> {
    let mut sum = x[0] * v[k];
    let mut j = 0;
    while j < k {
        sum = sum + x[k - j] * v[j];
        j += 1;
    }
    sum
}

/// Coefficient k >= 4 of x v, the latest coefficients last.
#[inline(always)]
fn product<L: Lane>(x: &[L; ORDER + 1], v: &[L; ORDER + 1], k: usize) -> L {
    let (mut even, mut odd) = (x[k - 2] * v[2], L::splat(0.0));
    let mut j = 3;
    while j + 1 < k - 1 {
        odd = x[k - j].mul_add(v[j], odd);
        even = x[k - j - 1].mul_add(v[j + 1], even);
        j += 2;
    }
    if j == k - 2 {
        odd = x[2].mul_add(v[k - 2], odd);
    }
    even = x[k - 1].mul_add(v[1], even);
    odd = x[1].mul_add(v[k - 1], odd);
    even = x[k].mul_add(v[0], even);
    odd = x[0].mul_add(v[k], odd);
    even + odd
}

impl<const DRAG: bool, const SLIPS: bool> Kernel for Recurrence<'_, DRAG, SLIPS> {
    type Output = ();
    type Place = Jet;
    #[inline(always)]
    fn run<L: Lane>(self) {
        let Recurrence { jet, start, piece, torque, at_limit } = self;
        let zero = L::splat(0.0);
        let none = [double::<L>(0.0); LONG];
        let (mut s, mut c, mut u, mut v) = (none, none, none, none);
        s[0] = Unnormalised::splat(start[SINE]);
        c[0] = Unnormalised::splat(start[COSINE]);
        u[0] = Unnormalised::splat(start[SLIP]);
        v[0] = Unnormalised::splat(start[VELOCITY]);
        let omega2 = Unnormalised::<L>::splat(piece.omega2);
        let mut k = 0;
        while k < LONG - 1 {
            let inverse = Unnormalised::<L>::splat(INVERSE[k + 1]);
            let mut force = Unnormalised::new(L::splat(torque.hi[k]), L::splat(torque.lo[k]));
            force = force - omega2 * s[k] - double::<L>(piece.linear) * v[k];
            if DRAG {
                force = force - double::<L>(piece.quadratic) * long_product(&v, &v, k);
            }
            if k == 0 {
                force = force - double::<L>(piece.dry);
            }
            if SLIPS || k == 0 {
                force = force + double::<L>(piece.dry) * u[k];
            }
            if k == 0 && at_limit {
                force = double::<L>(0.0);
            }
            v[k + 1] = force * inverse;
            s[k + 1] = long_product(&c, &v, k) * inverse;
            c[k + 1] = -(long_product(&s, &v, k) * inverse);
            if SLIPS {
                u[k + 1] = -(double::<L>(piece.slip) * long_product(&u, &v, k) * inverse);
            }
            k += 1;
        }
        let series = [zero; ORDER + 1];
        let (mut short_s, mut short_c, mut short_u, mut short_v) = (series, series, series, series);
        let mut k = 0;
        while k < LONG {
            let [a, b, d, e] = [s[k].tight(), c[k].tight(), u[k].tight(), v[k].tight()];
            (short_s[k], short_c[k], short_u[k], short_v[k]) = (a.hi, b.hi, d.hi, e.hi);
            a.lo.store(&mut jet.lo[SINE][k..=k]);
            b.lo.store(&mut jet.lo[COSINE][k..=k]);
            d.lo.store(&mut jet.lo[SLIP][k..=k]);
            e.lo.store(&mut jet.lo[VELOCITY][k..=k]);
            k += 1;
        }
        let (omega2, linear) = (L::splat(piece.omega2.hi), L::splat(piece.linear));
        let (quadratic, dry, slip) = (L::splat(piece.quadratic), L::splat(piece.dry), L::splat(piece.slip));
        let mut k = LONG - 1;
        while k < ORDER {
            let inverse = L::splat(INVERSE[k + 1].hi);
            let mut force = L::splat(torque.hi[k]) - linear * short_v[k];
            if DRAG {
                force = force - quadratic * product(&short_v, &short_v, k);
            }
            if SLIPS {
                force = dry.mul_add(short_u[k], force);
            }
            let rise = product(&short_c, &short_v, k);
            let fall = product(&short_s, &short_v, k);
            if SLIPS {
                short_u[k + 1] = -(slip * product(&short_u, &short_v, k) * inverse);
            }
            short_v[k + 1] = (force - omega2 * short_s[k]) * inverse;
            short_s[k + 1] = rise * inverse;
            short_c[k + 1] = -(fall * inverse);
            k += 1;
        }
        let mut k = 0;
        while k <= ORDER {
            short_s[k].store(&mut jet.hi[SINE][k..=k]);
            short_c[k].store(&mut jet.hi[COSINE][k..=k]);
            short_u[k].store(&mut jet.hi[SLIP][k..=k]);
            short_v[k].store(&mut jet.hi[VELOCITY][k..=k]);
            k += 1;
        }
    }
}

struct Sum<'a> {
    jet: &'a Jet,
    time: f64,
    slopes: &'a Series,
    slips: bool,
}

/// The sum of a series at a time, its first words in double-double.
#[inline(always)]
fn long_sum<L: Lane>(hi: &Series, first: &[Unnormalised<L>; LONG], t: L) -> Unnormalised<L> {
    let mut tail = L::load(&hi[ORDER..]);
    let mut k = ORDER;
    while k > LONG {
        k -= 1;
        tail = tail.mul_add(t, L::load(&hi[k..]));
    }
    let time = Unnormalised::from_double(t);
    let mut sum = Unnormalised::from_double(tail);
    while k > 0 {
        k -= 1;
        sum = sum * time + first[k];
    }
    sum
}

#[inline(always)]
fn words<L: Lane>(jet: &Jet, place: usize) -> [Unnormalised<L>; LONG] {
    let mut words = [double::<L>(0.0); LONG];
    let mut k = 0;
    while k < LONG {
        words[k] = Unnormalised::new(L::load(&jet.hi[place][k..]), L::load(&jet.lo[place][k..]));
        k += 1;
    }
    words
}

impl Kernel for Sum<'_> {
    type Output = [Dd; 5];
    type Place = Jet;
    #[inline(always)]
    fn run<L: Lane>(self) -> [Dd; 5] {
        let Sum { jet, time, slopes, slips } = self;
        let t = L::splat(time);
        let v_words = words::<L>(jet, VELOCITY);
        let mut slope_words = v_words;
        let mut k = 1;
        while k < LONG {
            slope_words[k] = v_words[k] * Unnormalised::splat(INVERSE[k + 1]);
            k += 1;
        }
        let mut s = long_sum(&jet.hi[SINE], &words(jet, SINE), t);
        let mut c = long_sum(&jet.hi[COSINE], &words(jet, COSINE), t);
        let v = long_sum(&jet.hi[VELOCITY], &v_words, t);
        let change = long_sum(slopes, &slope_words, t) * Unnormalised::from_double(t);
        let mut u = Dd::new(jet.hi[SLIP][0], jet.lo[SLIP][0]);
        if slips {
            u = number(long_sum(&jet.hi[SLIP], &words(jet, SLIP), t));
        }
        on_circle(&mut s, &mut c);
        [number(s), number(c), u, number(v), number(change)]
    }
}

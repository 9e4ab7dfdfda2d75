//! Taylor coefficients of the motion at one time, and the state that they give at another.
//!
//! With v' of equation.rs, s' = c v, c' = -s v and u' = -slip v u, every product is one with v. At order k the sum over j of
//! x_(k-j) v_j takes the latest coefficients last: so the processor forms the long middle of a sum while it waits for them.
//! Coefficients below LONG are double-doubles, because a step is 2^(-66/30) = 0.22 of the radius of convergence: the term of order
//! LONG is below 0.22^9 = 1e-6 of the motion, and its rounding error below 2^-72.
//!
//! One step is, for each of s and c (and |v| v, and u, where they act), 30 31/2 - 36 = 429 multiplications with additions in
//! double and 36 in double-double; and for each of s, c, v and theta a sum of 22 terms in double and 9 in double-double.
//! Source: Jorba & Zou, Exp. Math. 14 (2005) 99.

use super::taylor::{Four, INVERSE, LONG, ORDER, Series, double, four, four_mul_add, number, on_circle};
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

/// Coefficients of powers of time of s, c, v and the angle, a row for each power, and of u.
#[derive(Clone, Debug)]
pub(super) struct Jet {
    /// Of s, c, v, and of the powers 1, 2, ... in the angle; the low words of the first.
    rows: [[f64; 4]; ORDER + 1],
    low_rows: [[f64; 4]; LONG],
    /// Of u.
    slip: Series,
    low_slip: [f64; LONG],
    /// The columns of v and of the angle.
    pub velocity: Series,
    pub slopes: Series,
}

impl Jet {
    pub const ZERO: Jet = Jet {
        rows: [[0.0; 4]; ORDER + 1],
        low_rows: [[0.0; 4]; LONG],
        slip: [0.0; ORDER + 1],
        low_slip: [0.0; LONG],
        velocity: [0.0; ORDER + 1],
        slopes: [0.0; ORDER + 1],
    };

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
    pub fn at(&self, time: f64, slips: bool) -> [Dd; 5] {
        single(Sum { jet: self, time, slips })
    }

    /// The sizes of the coefficients of s, c, v and of u at one power.
    pub fn sizes(&self, k: usize) -> [f64; 4] {
        let [sine, cosine, velocity, _] = self.rows[k];
        [sine.abs(), cosine.abs(), velocity.abs(), self.slip[k].abs()]
    }
}

struct Recurrence<'a, const DRAG: bool, const SLIPS: bool> {
    jet: &'a mut Jet,
    start: &'a [Dd; 4],
    piece: &'a Piece,
    torque: &'a TorqueJet,
    at_limit: bool,
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
        // Rows of s, c, u, v.
        let mut long = [Four::<L>::zero(); LONG];
        long[0] = Four::of([
            Unnormalised::splat(start[SINE]),
            Unnormalised::splat(start[COSINE]),
            Unnormalised::splat(start[SLIP]),
            Unnormalised::splat(start[VELOCITY]),
        ]);
        let omega2 = Unnormalised::<L>::splat(piece.omega2);
        let mut k = 0;
        while k < LONG - 1 {
            let mut sums = long[0].times(long[k].at(VELOCITY));
            if k > 0 {
                // The two products with the latest row last.
                sums = sums.plus(long[k].times(long[0].at(VELOCITY)));
                let (mut middle, mut j) = (Four::zero(), 1);
                while j < k {
                    middle = middle.plus(long[k - j].times(long[j].at(VELOCITY)));
                    j += 1;
                }
                sums = sums.plus(middle);
            }
            let mut force = Unnormalised::new(L::splat(torque.hi[k]), L::splat(torque.lo[k]));
            force = force - double::<L>(piece.linear) * long[k].at(VELOCITY) - omega2 * long[k].at(SINE);
            if DRAG {
                force = force - double::<L>(piece.quadratic) * sums.at(VELOCITY);
            }
            if k == 0 {
                force = force - double::<L>(piece.dry);
            }
            if SLIPS || k == 0 {
                force = force + double::<L>(piece.dry) * long[k].at(SLIP);
            }
            if k == 0 && at_limit {
                force = double::<L>(0.0);
            }
            let mut slip = double::<L>(0.0);
            if SLIPS {
                slip = -(double::<L>(piece.slip) * sums.at(SLIP));
            }
            let next = Four::of([sums.at(COSINE), -sums.at(SINE), slip, force]);
            long[k + 1] = next.times(Unnormalised::splat(INVERSE[k + 1]));
            k += 1;
        }
        let series = [L::splat(0.0); ORDER + 1];
        let (mut s, mut c, mut u, mut v, mut slopes) = (series, series, series, series, series);
        let mut k = 0;
        while k < LONG {
            let slope = long[k].at(VELOCITY) * Unnormalised::splat(INVERSE[k + 1]);
            let words = [
                long[k].at(SINE).tight(),
                long[k].at(COSINE).tight(),
                long[k].at(VELOCITY).tight(),
                slope.tight(),
                long[k].at(SLIP).tight(),
            ];
            (s[k], c[k], v[k], slopes[k], u[k]) =
                (words[0].hi, words[1].hi, words[2].hi, words[3].hi, words[4].hi);
            let mut i = 0;
            while i < 4 {
                words[i].lo.store(&mut jet.low_rows[k][i..=i]);
                i += 1;
            }
            words[4].lo.store(&mut jet.low_slip[k..=k]);
            k += 1;
        }
        let (omega2, linear) = (L::splat(piece.omega2.hi), L::splat(piece.linear));
        let (quadratic, dry, slip) = (L::splat(piece.quadratic), L::splat(piece.dry), L::splat(piece.slip));
        let mut k = LONG - 1;
        while k < ORDER {
            let inverse = L::splat(INVERSE[k + 1].hi);
            let mut force = L::splat(torque.hi[k]) - linear * v[k];
            if DRAG {
                force = force - quadratic * product(&v, &v, k);
            }
            if SLIPS {
                force = dry.mul_add(u[k], force);
            }
            let rise = product(&c, &v, k);
            let fall = product(&s, &v, k);
            if SLIPS {
                u[k + 1] = -(slip * product(&u, &v, k) * inverse);
            }
            v[k + 1] = (force - omega2 * s[k]) * inverse;
            s[k + 1] = rise * inverse;
            c[k + 1] = -(fall * inverse);
            slopes[k + 1] = v[k + 1] * L::splat(INVERSE[k + 2].hi);
            k += 1;
        }
        let mut k = 0;
        while k <= ORDER {
            let row = &mut jet.rows[k];
            s[k].store(&mut row[0..1]);
            c[k].store(&mut row[1..2]);
            v[k].store(&mut row[2..3]);
            slopes[k].store(&mut row[3..4]);
            v[k].store(&mut jet.velocity[k..=k]);
            slopes[k].store(&mut jet.slopes[k..=k]);
            if SLIPS || k == 0 {
                u[k].store(&mut jet.slip[k..=k]);
            }
            k += 1;
        }
    }
}

struct Sum<'a> {
    jet: &'a Jet,
    time: f64,
    slips: bool,
}

impl Kernel for Sum<'_> {
    type Output = [Dd; 5];
    type Place = Jet;
    #[inline(always)]
    fn run<L: Lane>(self) -> [Dd; 5] {
        let Sum { jet, time, slips } = self;
        let t = L::splat(time);
        let mut tail = four::<L>(&jet.rows[ORDER]);
        let mut k = ORDER;
        while k > LONG {
            k -= 1;
            tail = four_mul_add(tail, t, four(&jet.rows[k]));
        }
        let mut sum = Four { hi: tail, lo: [L::splat(0.0); 4] };
        while k > 0 {
            k -= 1;
            sum = sum.times_double(t).plus(Four { hi: four(&jet.rows[k]), lo: four(&jet.low_rows[k]) });
        }
        let mut u = Dd::new(jet.slip[0], jet.low_slip[0]);
        if slips {
            let mut tail = L::load(&jet.slip[ORDER..]);
            let mut k = ORDER;
            while k > LONG {
                k -= 1;
                tail = tail.mul_add(t, L::load(&jet.slip[k..]));
            }
            let mut sum = Unnormalised::from_double(tail);
            while k > 0 {
                k -= 1;
                let word = Unnormalised::new(L::load(&jet.slip[k..]), L::load(&jet.low_slip[k..]));
                sum = sum * Unnormalised::from_double(t) + word;
            }
            u = number(sum);
        }
        let (mut s, mut c) = (sum.at(0), sum.at(1));
        on_circle(&mut s, &mut c);
        let change = sum.at(3) * Unnormalised::from_double(t);
        [number(s), number(c), u, number(sum.at(2)), number(change)]
    }
}

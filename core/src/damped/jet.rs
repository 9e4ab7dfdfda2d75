//! Taylor coefficients of the motion at one time, and the state that they give at another.
//!
//! With v' of equation.rs, s' = c v, c' = -s v and u' = -slip v u, every product is one with v. So the coefficients of the four
//! are found together: at each order one sum over j of (s, c, u, v)_(k-j) v_j. The sums up to order LONG - 1 are in
//! double-double, because a step is 2^(-66/24) = 0.15 of the radius of convergence: the term of order LONG is below
//! 0.15^6 = 1e-5 of the motion, and its rounding error below 2^-69.
//!
//! One step of order 24 is 4 (24 25/2 - 15) = 1140 multiplications with additions in double, 4 * 15 in double-double, and an
//! evaluation of 5 * 24. Source: Jorba & Zou, Exp. Math. 14 (2005) 99.

use super::equation::{INVERSE, TorqueJet};
use crate::float::Dd;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Kernel, Lane, single};

/// Highest power of time: ceil(-ln(tolerance)/2) + 1 for a tolerance of 2^-66 (Jorba & Zou, equation 3-6).
pub(super) const ORDER: usize = 24;
/// How many coefficients of the lowest orders are double-doubles.
pub(super) const LONG: usize = 6;

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

/// Coefficients of powers of time of s, c, u and v.
#[derive(Clone, Debug)]
pub(super) struct Jet {
    pub hi: [[f64; 4]; ORDER + 1],
    pub lo: [[f64; 4]; LONG],
}

impl Jet {
    /// From the values of s, c, u, v. `at_limit`: the acceleration is 0, as it is when a stuck pendulum is released.
    pub fn new(start: [Dd; 4], piece: &Piece, torque: &TorqueJet, at_limit: bool) -> Jet {
        single(Recurrence { start, piece, torque, at_limit })
    }

    /// s, c, u, v and the change of the angle a time later, as long as the series converges there.
    pub fn at(&self, time: f64) -> [Dd; 5] {
        single(Sum { jet: self, time })
    }

    /// The coefficients of the velocity.
    pub fn velocity(&self) -> [f64; ORDER + 1] {
        let mut velocity = [0.0; ORDER + 1];
        for (coefficient, row) in velocity.iter_mut().zip(&self.hi) {
            *coefficient = row[VELOCITY];
        }
        velocity
    }
}

struct Recurrence<'a> {
    start: [Dd; 4],
    piece: &'a Piece,
    torque: &'a TorqueJet,
    at_limit: bool,
}

/// Coefficients k + 1 from the sums of products [s v, c v, u v, v v] of order k, times k + 1.
#[inline(always)]
fn next<L: Lane>(piece: &[L; 5], [sv, cv, uv, vv]: [L; 4], row: &[L; 4], torque: L) -> [L; 4] {
    let [omega2, linear, quadratic, dry, slip] = *piece;
    let force = torque - omega2 * row[SINE];
    let force = force - linear * row[VELOCITY];
    let force = dry.mul_add(row[SLIP], force - quadratic * vv);
    [cv, -sv, -(slip * uv), force]
}

#[inline(always)]
fn double<L: Lane>(value: f64) -> Unnormalised<L> {
    Unnormalised::from_double(L::splat(value))
}

impl Kernel for Recurrence<'_> {
    type Output = Jet;
    type Place = Jet;
    #[inline(always)]
    fn run<L: Lane>(self) -> Jet {
        let Recurrence { start, piece, torque, at_limit } = self;
        let zero = L::splat(0.0);
        let mut hi = [[zero; 4]; ORDER + 1];
        let mut lo = [[zero; 4]; LONG];
        let mut i = 0;
        while i < 4 {
            hi[0][i] = L::splat(start[i].hi);
            lo[0][i] = L::splat(start[i].lo);
            i += 1;
        }
        let omega2 = Unnormalised::<L>::splat(piece.omega2);
        let mut k = 0;
        while k < LONG - 1 {
            // Sums of products with v, in double-double.
            let mut sums = [Unnormalised::from_double(zero); 4];
            let mut j = 0;
            while j <= k {
                let v = Unnormalised::new(hi[j][VELOCITY], lo[j][VELOCITY]);
                let mut i = 0;
                while i < 4 {
                    sums[i] = sums[i] + Unnormalised::new(hi[k - j][i], lo[k - j][i]) * v;
                    i += 1;
                }
                j += 1;
            }
            let slip = Unnormalised::new(hi[k][SLIP], lo[k][SLIP]);
            let (sine, v) = (
                Unnormalised::new(hi[k][SINE], lo[k][SINE]),
                Unnormalised::new(hi[k][VELOCITY], lo[k][VELOCITY]),
            );
            let mut force = Unnormalised::new(L::splat(torque.hi[k]), L::splat(torque.lo[k]));
            force = force - omega2 * sine - double::<L>(piece.linear) * v;
            force = force - double::<L>(piece.quadratic) * sums[VELOCITY] + double::<L>(piece.dry) * slip;
            if k == 0 {
                force = force - double::<L>(piece.dry);
                if at_limit {
                    force = Unnormalised::from_double(zero);
                }
            }
            let inverse = Unnormalised::<L>::splat(INVERSE[k + 1]);
            let rows = [sums[COSINE], -sums[SINE], -(double::<L>(piece.slip) * sums[SLIP]), force];
            let mut i = 0;
            while i < 4 {
                let value = (rows[i] * inverse).tight();
                (hi[k + 1][i], lo[k + 1][i]) = (value.hi, value.lo);
                i += 1;
            }
            k += 1;
        }
        let constants = [
            L::splat(piece.omega2.hi),
            L::splat(piece.linear),
            L::splat(piece.quadratic),
            L::splat(piece.dry),
            L::splat(piece.slip),
        ];
        while k < ORDER {
            // Two chains of sums, so that additions need not wait for each other.
            let (mut even, mut odd) = ([zero; 4], [zero; 4]);
            let mut j = 0;
            while j < k {
                let (v, w) = (hi[j][VELOCITY], hi[j + 1][VELOCITY]);
                let mut i = 0;
                while i < 4 {
                    even[i] = hi[k - j][i].mul_add(v, even[i]);
                    odd[i] = hi[k - j - 1][i].mul_add(w, odd[i]);
                    i += 1;
                }
                j += 2;
            }
            if j == k {
                let v = hi[k][VELOCITY];
                let mut i = 0;
                while i < 4 {
                    even[i] = hi[0][i].mul_add(v, even[i]);
                    i += 1;
                }
            }
            let sums = [even[0] + odd[0], even[1] + odd[1], even[2] + odd[2], even[3] + odd[3]];
            let row = next(&constants, sums, &hi[k], L::splat(torque.hi[k]));
            let inverse = L::splat(INVERSE[k + 1].hi);
            hi[k + 1] = [row[0] * inverse, row[1] * inverse, row[2] * inverse, row[3] * inverse];
            k += 1;
        }
        let mut jet = Jet { hi: [[0.0; 4]; ORDER + 1], lo: [[0.0; 4]; LONG] };
        let mut k = 0;
        while k <= ORDER {
            let mut i = 0;
            while i < 4 {
                hi[k][i].store(&mut jet.hi[k][i..=i]);
                if k < LONG {
                    lo[k][i].store(&mut jet.lo[k][i..=i]);
                }
                i += 1;
            }
            k += 1;
        }
        jet
    }
}

struct Sum<'a> {
    jet: &'a Jet,
    time: f64,
}

impl Kernel for Sum<'_> {
    type Output = [Dd; 5];
    type Place = Jet;
    #[inline(always)]
    fn run<L: Lane>(self) -> [Dd; 5] {
        let Jet { hi, lo } = self.jet;
        let t = L::splat(self.time);
        let zero = L::splat(0.0);
        // The fifth is the integral of v.
        let mut tail = [zero; 5];
        let mut k = ORDER;
        while k >= LONG {
            let mut i = 0;
            while i < 4 {
                tail[i] = tail[i].mul_add(t, L::load(&hi[k][i..]));
                i += 1;
            }
            tail[4] = tail[4].mul_add(t, L::load(&hi[k][VELOCITY..]) * L::splat(INVERSE[k + 1].hi));
            k -= 1;
        }
        let mut sums = [Unnormalised::from_double(zero); 5];
        let time = Unnormalised::from_double(t);
        let mut i = 0;
        while i < 5 {
            let place = if i < 4 { i } else { VELOCITY };
            let mut sum = Unnormalised::from_double(tail[i]);
            let mut k = LONG;
            while k > 0 {
                k -= 1;
                let mut term = Unnormalised::new(L::load(&hi[k][place..]), L::load(&lo[k][place..]));
                if i == 4 {
                    term = term * Unnormalised::splat(INVERSE[k + 1]);
                }
                sum = sum * time + term;
            }
            sums[i] = sum;
            i += 1;
        }
        sums[4] = sums[4] * time;
        let mut values = [Dd::ZERO; 5];
        let mut i = 0;
        while i < 5 {
            let value = sums[i].tight();
            values[i] = Dd::new(value.hi.first(), value.lo.first());
            i += 1;
        }
        values
    }
}

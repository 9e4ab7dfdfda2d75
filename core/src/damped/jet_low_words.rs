//! The low words of the coefficients below LONG: what those in double lack of the series.
//!
//! Put into the equations, coefficients x_k in double leave rests r_k = f_k(x) - (k + 1) x_(k+1), about 2^-53 of them. What is lacking
//! follows the equations made linear, (k + 1) e_(k+1) = (f'(x) e)_k + r_k from the low words of the start on, in double. A rest is a sum
//! that nearly vanishes: its terms are added to a power of two far above them, so that what each addition leaves out is known exactly.
//! Source: Rump, Ogita & Oishi, SIAM J. Sci. Comput. 31 (2008) 189, for the sums.

use super::jet::{COSINE, Jet, Piece, SINE, SLIP, VELOCITY};
use super::jet_orders::{Pairs, Rows, alternating, exchanged, halves, swapped};
use super::taylor::{INVERSE, LONG, places};
use super::torque_jet::TorqueJet;
use crate::float::Dd;
use crate::lanes::Lane;

/// How many rests there are: two lanes of four.
const RESTS: usize = 8;
/// Orders that are written out.
const _: () = assert!(LONG == RESTS + 1);

/// A sum of terms that are far smaller than the power of two it begins with, and what its additions leave out.
#[derive(Clone, Copy)]
pub(super) struct Anchored<L: Lane> {
    pub sum: L,
    pub rest: L,
}

impl<L: Lane> Anchored<L> {
    #[inline(always)]
    pub fn new(anchor: L) -> Self {
        Anchored { sum: anchor, rest: L::splat(0.0) }
    }
    #[inline(always)]
    pub fn plus(self, term: L) -> Self {
        let sum = self.sum + term;
        Anchored { sum, rest: self.rest + (term - (sum - self.sum)) }
    }
    #[inline(always)]
    pub fn plus_product(self, a: L, b: L) -> Self {
        let sum = a.mul_add(b, self.sum);
        Anchored { sum, rest: self.rest + a.product_rest(b, sum - self.sum) }
    }
}

/// How far above the terms the power of two is, in bits: 106 - 10 are left.
const MARGIN: i64 = 10;

/// Powers of two far above the terms of every order.
#[inline(always)]
fn anchors(start: &[Dd; 4], piece: &Piece, torque: &TorqueJet) -> [f64; RESTS] {
    let mut size = piece.dry.abs();
    for term in [start[SINE].hi, start[VELOCITY].hi, torque.hi[0], torque.hi[1]] {
        size = if term.abs() > size { term.abs() } else { size };
    }
    let exponent = |value: f64| ((value.to_bits() >> 52) & 0x7ff) as i64;
    let (size, growth) = (exponent(size) + MARGIN, exponent(piece.rate) - exponent(1.0));
    let mut anchors = [0.0; RESTS];
    let mut k = 0;
    while k < RESTS {
        let power = (size + growth * k as i64).clamp(1, 2046);
        anchors[k] = f64::from_bits((power as u64) << 52);
        k += 1;
    }
    anchors
}

/// What the low words follow from.
pub(super) struct LowWords<'a, L: Lane> {
    pub rows: &'a Rows<L>,
    pub start: &'a [Dd; 4],
    pub piece: &'a Piece,
    pub torque: &'a TorqueJet,
    pub at_limit: bool,
}

impl<L: Lane> LowWords<'_, L> {
    /// The rests of v from an order on, an order a place.
    #[inline(always)]
    fn velocity_rests<const FULL: bool>(&self, jet: &Jet, anchors: &[f64; RESTS], k: usize) -> [f64; 4] {
        let LowWords { piece, torque, rows, .. } = self;
        let anchor = L::load(&anchors[k..]);
        let next = |i: usize| jet.rows[k + i + 1][2];
        let sines = L::load(&[jet.rows[k][0], jet.rows[k + 1][0], jet.rows[k + 2][0], jet.rows[k + 3][0]]);
        let speeds = L::load(&[jet.rows[k][2], next(0), next(1), next(2)]);
        let taken = L::load(&[next(0), next(1), next(2), next(3)]);
        let order = k as f64;
        let orders = L::load(&[-order - 1.0, -order - 2.0, -order - 3.0, -order - 4.0]);
        let mut sum = Anchored::new(anchor).plus(L::load(&torque.hi[k..]));
        sum = sum.plus_product(sines, L::splat(-piece.omega2.hi));
        sum = sum.plus_product(speeds, L::splat(-piece.linear));
        if piece.dry != 0.0 {
            let slips = if FULL {
                L::load(&jet.slip[k..])
            } else {
                L::load(&[if k == 0 { jet.slip[0] } else { 0.0 }, 0.0, 0.0, 0.0])
            };
            sum = sum.plus_product(slips, L::splat(piece.dry));
            if k == 0 {
                sum = sum.plus(L::load(&[-piece.dry, 0.0, 0.0, 0.0]));
            }
        }
        if FULL {
            let sums = &rows.sums;
            let square = |i: usize| places(sums[k + i])[1];
            let squares = L::load(&[square(0), square(1), square(2), square(3)]);
            sum = sum.plus_product(squares, L::splat(-piece.quadratic));
        }
        sum = sum.plus_product(taken, orders);
        let low = sines.mul_add(L::splat(-piece.omega2.lo), L::load(&torque.lo[k..]));
        places((sum.sum - anchor) + (sum.rest + low))
    }

    /// The rest of order k of two variables: the rows times v less what the next rows are taken for, in their first half.
    #[inline(always)]
    fn rest(&self, pairs: &Pairs<L>, taken: L, times: f64, anchor: f64, k: usize) -> L {
        let anchor = L::splat(anchor);
        let mut sum = Anchored::new(anchor).plus_product(halves(taken, L::splat(0.0)), L::splat(-times));
        let mut i = 0;
        while i <= k / 2 {
            sum = sum.plus_product(pairs.two[i], self.rows.w[k - 2 * i]);
            i += 1;
        }
        // Multiples of one small power of two, whose sum is exact.
        let whole = sum.sum - anchor;
        (whole + exchanged(whole)) + (sum.rest + exchanged(sum.rest))
    }

    /// Coefficient k of what the products with v lack: from low words of the rows and of v.
    #[inline(always)]
    fn lacking(&self, pairs: &Pairs<L>, low: &[L; LONG], velocity: &[L; LONG], rest: L, k: usize) -> L {
        let mut sum = rest;
        let mut i = 0;
        while i <= k {
            sum = pairs.one[k - i].mul_add(velocity[i], sum);
            sum = low[i].mul_add(self.rows.v[k - i], sum);
            i += 1;
        }
        sum
    }

    /// All low words, into the jet.
    #[inline(always)]
    pub fn keep<const FULL: bool>(&self, jet: &mut Jet) {
        let LowWords { rows, start, piece, torque, at_limit } = self;
        let zero = L::splat(0.0);
        let anchors = anchors(start, piece, torque);
        jet.anchor = anchors[0];
        let of_velocity =
            [self.velocity_rests::<FULL>(jet, &anchors, 0), self.velocity_rests::<FULL>(jet, &anchors, 4)];
        let (omega2, linear) = (L::splat(-piece.omega2.hi), L::splat(-piece.linear));
        let (quadratic, dry, slip) = (L::splat(-piece.quadratic), L::splat(piece.dry), L::splat(-piece.slip));
        // Of c, -s twice; of v in every place; of u, v twice.
        let (mut circle, mut velocity, mut slips) = ([zero; LONG], [zero; LONG], [zero; LONG]);
        let [s, c] = [start[SINE].lo, start[COSINE].lo];
        let mut sines = L::load(&[s, c, s, c]);
        let mut speed = L::splat(start[VELOCITY].lo);
        let mut sliding = L::splat(start[SLIP].lo);
        macro_rules! orders {
            ($($k:literal)*) => {$({
                const K: usize = $k;
                circle[K] = alternating(swapped(sines), -swapped(sines));
                velocity[K] = speed;
                if FULL {
                    slips[K] = alternating(sliding, speed);
                    jet.low_slip[K] = sliding.first();
                } else {
                    jet.low_slip[K] = if K == 0 { sliding.first() } else { 0.0 };
                }
                let inverse = L::splat(INVERSE[K + 1].hi);
                let [v, slope] = [jet.rows[K][2], jet.rows[K][3]].map(L::splat);
                let low_slope = (speed - slope.product_rest(L::splat((K + 1) as f64), v)) * inverse;
                alternating(halves(sines, speed), halves(sines, low_slope)).store(&mut jet.low_rows[K]);
                jet.velocity[K] = (v + speed).first();
                if K < RESTS {
                    let taken = L::load(&jet.rows[K + 1]);
                    let rest = self.rest(&rows.circle, taken, (K + 1) as f64, anchors[K % RESTS], K);
                    let next = self.lacking(&rows.circle, &circle, &velocity, rest, K) * inverse;
                    let mut force = linear.mul_add(speed, L::splat(of_velocity[K / 4 % 2][K % 4]));
                    if FULL || K == 0 {
                        force = dry.mul_add(sliding, force);
                    }
                    if FULL {
                        let taken = rows.sums[K];
                        let rest = self.rest(&rows.slip, taken, 1.0, anchors[K % RESTS], K);
                        let [sum, square, ..] = places(self.lacking(&rows.slip, &slips, &velocity, rest, K));
                        force = quadratic.mul_add(L::splat(square), force);
                        // What the division by k + 1 has left.
                        let (change, error) = slip.two_product(L::splat(places(taken)[0]));
                        let (taken, taken_error) = L::splat(jet.slip[K + 1]).two_product(L::splat((K + 1) as f64));
                        let rest = (change - taken) + (error - taken_error);
                        sliding = slip.mul_add(L::splat(sum), rest) * inverse;
                    }
                    force = omega2.mul_add(L::splat(sines.first()), force);
                    speed = if K == 0 && *at_limit { zero } else { force * inverse };
                    sines = next;
                }
            })*};
        }
        orders!(0 1 2 3 4 5 6 7 8);
    }
}

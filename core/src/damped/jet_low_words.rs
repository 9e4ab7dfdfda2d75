//! The low words of the coefficients below LONG: what those in double lack of the series.
//!
//! Put into the equations, coefficients x_k in double leave rests r_k = f_k(x) - (k + 1) x_(k+1), about 2^-53 of them. What is lacking
//! follows the equations made linear, (k + 1) e_(k+1) = (f'(x) e)_k + r_k from the low words of the start on, in double. A rest is a sum
//! that nearly vanishes: its terms are added to a number far above them, so that what each addition leaves out is known exactly.
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

/// A sum of terms that are far smaller than the number it begins with, and what its additions leave out.
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

/// How far above the terms that number is, in bits: 106 - 10 are left.
const MARGIN: i64 = 10;

/// 1.5 times powers of two far above the terms of every order: numbers to either side are rounded alike.
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
        let power = (size + growth * k as i64).clamp(1, 2045);
        anchors[k] = f64::from_bits((power as u64) << 52) * 1.5;
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

    /// The low words of order k + 1 from those up to k.
    #[inline(always)]
    fn next<const FULL: bool>(
        &self,
        k: usize,
        jet: &Jet,
        low: &LowRows<L>,
        latest: Lacking<L>,
        [rest, anchor]: [f64; 2],
    ) -> Lacking<L> {
        let LowWords { rows, piece, at_limit, .. } = self;
        let order = (k + 1) as f64;
        let inverse = L::splat(INVERSE[k + 1].hi);
        let taken = L::load(&jet.rows[k + 1]);
        let circle = self.rest(&rows.circle, taken, order, anchor, k);
        let circle = low.products(rows, &rows.circle, &low.circle, circle, k) * inverse;
        let mut force = L::splat(-piece.linear).mul_add(latest.velocity, L::splat(rest));
        let mut slip = L::splat(0.0);
        if FULL || k == 0 {
            force = L::splat(piece.dry).mul_add(latest.slip, force);
        }
        if FULL {
            let taken = rows.sums[k];
            let sums = self.rest(&rows.slip, taken, 1.0, anchor, k);
            let [sum, square, ..] = places(low.products(rows, &rows.slip, &low.slip, sums, k));
            force = L::splat(-piece.quadratic).mul_add(L::splat(square), force);
            // What the division by k + 1 has left.
            let (change, error) = L::splat(-piece.slip).two_product(L::splat(places(taken)[0]));
            let (taken, taken_error) = L::splat(jet.slip[k + 1]).two_product(L::splat(order));
            let rest = (change - taken) + (error - taken_error);
            slip = L::splat(-piece.slip).mul_add(L::splat(sum), rest) * inverse;
        }
        force = L::splat(-piece.omega2.hi).mul_add(L::splat(latest.circle.first()), force);
        let velocity = if k == 0 && *at_limit { L::splat(0.0) } else { force * inverse };
        Lacking { circle, velocity, slip }
    }

    /// All low words, into the jet.
    #[inline(always)]
    pub fn keep<const FULL: bool>(&self, jet: &mut Jet) {
        let LowWords { start, piece, torque, .. } = self;
        let anchors = anchors(start, piece, torque);
        jet.anchor = anchors[0];
        let rests =
            [self.velocity_rests::<FULL>(jet, &anchors, 0), self.velocity_rests::<FULL>(jet, &anchors, 4)];
        let none = [L::splat(0.0); LONG];
        let mut low = LowRows { circle: none, velocity: none, slip: none };
        let [s, c] = [start[SINE].lo, start[COSINE].lo];
        let mut latest = Lacking {
            circle: L::load(&[s, c, s, c]),
            velocity: L::splat(start[VELOCITY].lo),
            slip: L::splat(start[SLIP].lo),
        };
        macro_rules! orders {
            ($($k:literal)*) => {$(
                low.keep::<FULL>($k, jet, latest);
                latest = self.next::<FULL>($k, jet, &low, latest, [rests[$k / 4][$k % 4], anchors[$k]]);
            )*};
        }
        orders!(0 1 2 3 4 5 6 7);
        low.keep::<FULL>(8, jet, latest);
    }
}

/// The low words of one order: of s, c twice; of v and of u in every place.
#[derive(Clone, Copy)]
struct Lacking<L: Lane> {
    circle: L,
    velocity: L,
    slip: L,
}

/// The low words so far: of c, -s twice; of v in every place; of u, v twice.
struct LowRows<L: Lane> {
    circle: [L; LONG],
    velocity: [L; LONG],
    slip: [L; LONG],
}

impl<L: Lane> LowRows<L> {
    /// Those of order k, also into the jet, with that of the slope of the angle.
    #[inline(always)]
    fn keep<const FULL: bool>(&mut self, k: usize, jet: &mut Jet, latest: Lacking<L>) {
        let Lacking { circle, velocity, slip } = latest;
        self.circle[k] = alternating(swapped(circle), -swapped(circle));
        self.velocity[k] = velocity;
        if FULL {
            self.slip[k] = alternating(slip, velocity);
        }
        jet.low_slip[k] = slip.first();
        let [v, slope] = [L::splat(jet.rows[k][2]), L::splat(jet.rows[k][3])];
        let rest = slope.product_rest(L::splat((k + 1) as f64), v);
        let low_slope = (velocity - rest) * L::splat(INVERSE[k + 1].hi);
        alternating(halves(circle, velocity), halves(circle, low_slope)).store(&mut jet.low_rows[k]);
        jet.velocity[k] = (v + velocity).first();
    }

    /// Coefficient k of what products of the rows with v lack, beside their rest.
    #[inline(always)]
    fn products(&self, rows: &Rows<L>, pairs: &Pairs<L>, low: &[L; LONG], rest: L, k: usize) -> L {
        let mut sum = rest;
        let mut i = 0;
        while i <= k {
            sum = pairs.one[k - i].mul_add(self.velocity[i], sum);
            sum = low[i].mul_add(rows.v[k - i], sum);
            i += 1;
        }
        sum
    }
}

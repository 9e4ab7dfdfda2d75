//! The coefficients in double, order by order.
//!
//! With v' of equation.rs, s' = c v, c' = -s v and u' = -slip v u, every product is one with v: at order k the sum over j of
//! x_(k-j) v_j. What the next coefficients wait for is as short as can be: (k + 1) times the row of order k + 1 comes from k times
//! that of order k by one product and one sum, whose factor v_0/k is known before, and so does that of v.
//!
//! Two variables fill half of a lane: c and -s, or u and v, whose products with v are the sums of s and c, of u and v^2. The sums of
//! old coefficients take two terms in a lane. One step is 31 32/2 products of c, -s with v, and as many of u, v where drag or presliding
//! acts.

use super::jet::{COSINE, Jet, Piece, SINE, SLIP, VELOCITY};
use super::taylor::{INVERSE, LONG, ORDER, Series, places};
use super::torque_jet::TorqueJet;
use crate::float::Dd;
use crate::lanes::Lane;

/// The rows of two variables.
pub(super) struct Pairs<L: Lane> {
    /// Of one order, twice.
    pub one: [L; ORDER + 1],
    /// Of an even order, and of the next one.
    pub two: [L; ORDER.div_ceil(2)],
}

/// The coefficients so far, in lanes for their products.
pub(super) struct Rows<L: Lane> {
    /// c, -s.
    pub circle: Pairs<L>,
    /// u, v.
    pub slip: Pairs<L>,
    /// v in every place.
    pub v: [L; ORDER + 1],
    /// v twice, and v of the order before twice.
    pub w: [L; ORDER + 1],
    /// The sums of u v and of v^2, twice.
    pub sums: [L; LONG],
}

/// k times the rows of order k (the rows themselves of order 0): s, c; v; u.
#[derive(Clone, Copy)]
pub(super) struct Latest<L: Lane> {
    circle: L,
    velocity: L,
    slip: L,
}

/// The constants of a piece, in every place.
pub(super) struct Constants<L: Lane> {
    /// Times 1/k.
    omega2: Series,
    linear: Series,
    /// v_0/k, -v_0/k, and c_0/k, -s_0/k.
    speed: [[f64; 2]; ORDER + 1],
    circle: [[f64; 2]; ORDER + 1],
    quadratic: L,
    dry: L,
    slip: L,
    at_limit: bool,
}

/// 1/k, but 1 for k = 0.
const fn inverse(k: usize) -> f64 {
    if k == 0 { 1.0 } else { INVERSE[k].hi }
}

/// 1/k, -1/k, twice.
const SIGNED: [[f64; 4]; ORDER + 1] = {
    let mut all = [[0.0; 4]; ORDER + 1];
    let mut k = 0;
    while k <= ORDER {
        all[k] = [inverse(k), -inverse(k), inverse(k), -inverse(k)];
        k += 1;
    }
    all
};

/// The inverses themselves, and each twice.
const INVERSES: Series = {
    let mut all = [0.0; ORDER + 1];
    let mut k = 0;
    while k <= ORDER {
        all[k] = inverse(k);
        k += 1;
    }
    all
};
const TWICE: [[f64; 4]; ORDER.div_ceil(2)] = {
    let mut all = [[0.0; 4]; ORDER.div_ceil(2)];
    let mut i = 0;
    while 2 * i < ORDER {
        let [even, odd] = [INVERSES[2 * i], INVERSES[2 * i + 1]];
        all[i] = [even, even, odd, odd];
        i += 1;
    }
    all
};

/// What makes s, c, v and the slope of the angle of k times s, c, v, v.
const ROWS: [[f64; 4]; ORDER + 1] = {
    let mut all = [[0.0; 4]; ORDER + 1];
    let mut k = 0;
    while k <= ORDER {
        all[k] = [inverse(k), inverse(k), inverse(k), inverse(k) * inverse(k + 1)];
        k += 1;
    }
    all
};

/// The first half of one and the second half of another.
#[inline(always)]
pub(super) fn halves<L: Lane>(a: L, b: L) -> L {
    let ([a, b, ..], [.., c, d]) = (places(a), places(b));
    L::load(&[a, b, c, d])
}
/// Two numbers, twice.
#[inline(always)]
fn twice<L: Lane>([a, b]: [f64; 2]) -> L {
    L::load(&[a, b, a, b])
}
/// The halves exchanged.
#[inline(always)]
pub(super) fn exchanged<L: Lane>(row: L) -> L {
    let [a, b, c, d] = places(row);
    L::load(&[c, d, a, b])
}
/// The places of each half exchanged.
#[inline(always)]
pub(super) fn swapped<L: Lane>(row: L) -> L {
    let [a, b, c, d] = places(row);
    L::load(&[b, a, d, c])
}
/// The first place of each half, twice.
#[inline(always)]
fn firsts<L: Lane>(row: L) -> L {
    let [a, _, c, _] = places(row);
    L::load(&[a, a, c, c])
}
/// The second place of each half, twice.
#[inline(always)]
fn seconds<L: Lane>(row: L) -> L {
    let [_, b, _, d] = places(row);
    L::load(&[b, b, d, d])
}
/// The first places of one, the second places of another.
#[inline(always)]
pub(super) fn alternating<L: Lane>(a: L, b: L) -> L {
    let ([a, _, c, _], [_, b, _, d]) = (places(a), places(b));
    L::load(&[a, b, c, d])
}

impl<L: Lane> Pairs<L> {
    #[inline(always)]
    fn none() -> Self {
        Pairs { one: [L::splat(0.0); ORDER + 1], two: [L::splat(0.0); ORDER.div_ceil(2)] }
    }

    #[inline(always)]
    fn keep(&mut self, k: usize, row: L) {
        self.one[k] = row;
        if k % 2 == 1 {
            self.two[k / 2] = halves(self.one[k - 1], row);
        }
    }
}

impl<L: Lane> Rows<L> {
    #[inline(always)]
    pub fn none() -> Self {
        let rows = [L::splat(0.0); ORDER + 1];
        Rows { circle: Pairs::none(), slip: Pairs::none(), v: rows, w: rows, sums: [L::splat(0.0); LONG] }
    }

    /// The rows of order k.
    #[inline(always)]
    pub fn keep<const FULL: bool>(&mut self, k: usize, jet: &mut Jet, latest: Latest<L>) {
        let Latest { circle, velocity, slip } = latest;
        let inverse = L::splat(inverse(k));
        let row = halves(circle, velocity) * L::load(&ROWS[k]);
        let v = L::splat(places(row)[2]);
        self.circle.keep(k, swapped(circle) * L::load(&SIGNED[k]));
        self.v[k] = v;
        self.w[k] = halves(v, if k == 0 { L::splat(0.0) } else { self.v[k - 1] });
        if FULL {
            let slip = slip * inverse;
            self.slip.keep(k, alternating(slip, v));
            jet.slip[k] = slip.first();
        } else if k == 0 {
            jet.slip[0] = slip.first();
        }
        row.store(&mut jet.rows[k]);
        jet.velocity[k] = v.first();
    }

    /// The sum over j from 1 to k - 1 of the rows of order j times v of order k - j, the latest last.
    #[inline(always)]
    fn inner(&self, Pairs { one, two }: &Pairs<L>, k: usize) -> L {
        let Rows { v, w, .. } = self;
        // Two terms in a lane from order 2 to k - 3 or k - 4, from the middle to both ends.
        let last = if k < 6 { 0 } else { (k - 4) / 2 };
        let mut sum = L::splat(0.0);
        if last > 0 {
            let (mut first, mut second) = (L::splat(0.0), L::splat(0.0));
            let half = last.div_ceil(2);
            let mut i = half;
            while i <= last {
                first = two[i].mul_add(w[k - 2 * i], first);
                i += 1;
            }
            let mut i = half;
            while i > 1 {
                i -= 1;
                second = two[i].mul_add(w[k - 2 * i], second);
            }
            let both = first + second;
            sum = both + exchanged(both);
        }
        let mut j = 2 * last + 2;
        while j + 1 < k {
            sum = one[j].mul_add(v[k - j], sum);
            j += 1;
        }
        if k > 2 {
            sum = v[k - 1].mul_add(one[1], sum);
        }
        if k > 1 {
            sum = one[k - 1].mul_add(v[1], sum);
        }
        sum
    }
}

impl<L: Lane> Constants<L> {
    #[inline(always)]
    pub fn new(piece: &Piece, start: &[Dd; 4], at_limit: bool) -> Self {
        let zero = [0.0; ORDER + 1];
        let (mut omega2, mut linear) = (zero, zero);
        let (mut speed, mut circle) = ([[0.0; 2]; ORDER + 1], [[0.0; 2]; ORDER + 1]);
        let [s, c, v] = [start[SINE].hi, start[COSINE].hi, start[VELOCITY].hi];
        let (pull, drag) = (L::splat(-piece.omega2.hi), L::splat(-piece.linear));
        let (v, row) = (L::load(&[v, -v, v, -v]), L::load(&[c, -s, c, -s]));
        let mut k = 0;
        while k <= ORDER {
            let inverses = L::load(&INVERSES[k..]);
            (inverses * pull).store(&mut omega2[k..]);
            (inverses * drag).store(&mut linear[k..]);
            let mut i = k;
            while i < k + 4 {
                let twice = L::load(&TWICE[i / 2]);
                (twice * v).store(speed[i..].as_flattened_mut());
                (twice * row).store(circle[i..].as_flattened_mut());
                i += 2;
            }
            k += 4;
        }
        Constants {
            omega2,
            linear,
            speed,
            circle,
            quadratic: L::splat(-piece.quadratic),
            dry: L::splat(piece.dry),
            slip: L::splat(-piece.slip),
            at_limit,
        }
    }

    /// The values of s, c, u, v.
    #[inline(always)]
    pub fn start(&self, start: &[Dd; 4]) -> Latest<L> {
        let [s, c] = [start[SINE].hi, start[COSINE].hi];
        let circle = L::load(&[s, c, s, c]);
        Latest { circle, velocity: L::splat(start[VELOCITY].hi), slip: L::splat(start[SLIP].hi) }
    }

    /// k + 1 times the rows of order k + 1 from those up to k, of which the latest are not divided by k yet.
    #[inline(always)]
    pub fn next<const FULL: bool>(
        &self,
        k: usize,
        rows: &mut Rows<L>,
        torque: &TorqueJet,
        latest: Latest<L>,
    ) -> Latest<L> {
        let Latest { circle, velocity, slip } = latest;
        let inverse = L::splat(inverse(k));
        let v = rows.v[0];
        let mut sum = rows.inner(&rows.circle, k);
        if k > 0 {
            sum = velocity.mul_add(twice(self.circle[k]), sum);
        }
        let next = swapped(circle).mul_add(twice(self.speed[k]), sum);
        let mut force = velocity.mul_add(L::splat(self.linear[k]), L::splat(torque.hi[k]));
        let mut change = L::splat(0.0);
        if k == 0 {
            force = force - self.dry;
        }
        if FULL || k == 0 {
            force = slip.mul_add(self.dry * inverse, force);
        }
        if FULL {
            let sums = rows.inner(&rows.slip, k);
            // Of v^2 the two outer terms are alike; they are taken from v itself.
            let outer = if k == 0 { v } else { v + v };
            force = velocity.mul_add(self.quadratic * outer * inverse, force);
            if k > 0 {
                force = self.quadratic.mul_add(seconds(sums), force);
            }
            let mut slipping = firsts(sums);
            if k > 0 {
                slipping = velocity.mul_add(firsts(rows.slip.one[0]) * inverse, slipping);
            }
            slipping = slip.mul_add(v * inverse, slipping);
            change = self.slip * slipping;
            if k < LONG {
                let squares = if k == 0 { v * v } else { rows.v[k].mul_add(outer, seconds(sums)) };
                rows.sums[k] = alternating(slipping, squares);
            }
        }
        let mut force = firsts(circle).mul_add(L::splat(self.omega2[k]), force);
        if k == 0 && self.at_limit {
            force = L::splat(0.0);
        }
        Latest { circle: next, velocity: force, slip: change }
    }
}

//! Taylor coefficients of the motion at one time.
//!
//! With v' of equation.rs, s' = c v, c' = -s v and u' = -slip v u, every product is one with v. At order k the sum over j of
//! x_(k-j) v_j takes the latest coefficients last: so the processor forms the long middle of a sum while it waits for them.
//! Coefficients below LONG are double-doubles, because a step is 2^(-70/31) = 0.21 of the radius of convergence: the term of order
//! LONG is below 0.21^9 = 2^-20 of the motion, and its rounding error below 2^-73. A motion that repeats itself rounds alike in
//! every period, so that the errors of N steps may add up to 2^-73 N of the state.
//!
//! Four numbers are side by side in a lane: c, -s, u, v times one v give the sums of s, c, u and of v^2. Where friction is linear or
//! dry only c and -s are needed: then a lane holds two terms of the sum. One step is 31 32/2 - 36 = 460 products of a row with a v in
//! double (half of the lanes where two terms share one) and 36 in double-double.
//! Source: Jorba & Zou, Exp. Math. 14 (2005) 99.

use super::taylor::{INVERSE, LONG, ORDER, Series, double, places};
use super::torque_jet::TorqueJet;
use crate::float::Dd;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{COMPACT, Kernel, Lane, four};

/// Sums that are written out order by order, and lanes of four coefficients.
const _: () = assert!(LONG == 9 && ORDER == 31);

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

/// Coefficients of powers of time, a row for each power.
#[derive(Clone, Debug)]
pub(super) struct Jet {
    /// Of s, c, v, and of the powers 1, 2, ... in the angle; the low words of the first.
    pub rows: [[f64; 4]; ORDER + 1],
    pub low_rows: [[f64; 4]; LONG],
    /// Of u.
    pub slip: Series,
    pub low_slip: [f64; LONG],
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
        if piece.quadratic != 0.0 || piece.slip != 0.0 {
            four(Recurrence::<true> { jet, start, piece, torque, at_limit })
        } else {
            four(Recurrence::<false> { jet, start, piece, torque, at_limit })
        }
    }

    /// The sizes of the coefficients of s, c, v and of u at one power.
    pub fn sizes(&self, k: usize) -> [f64; 4] {
        let [sine, cosine, velocity, _] = self.rows[k];
        [sine.abs(), cosine.abs(), velocity.abs(), self.slip[k].abs()]
    }
}

/// `FULL`: with drag or presliding.
struct Recurrence<'a, const FULL: bool> {
    jet: &'a mut Jet,
    start: &'a [Dd; 4],
    piece: &'a Piece,
    torque: &'a TorqueJet,
    at_limit: bool,
}

/// c, -s, u, v: what is multiplied by v gives (k + 1) times the next s and c, the next u times a constant, and v^2.
#[inline(always)]
fn factors<L: Lane>([s, c, u, _]: [f64; 4], v: f64) -> L {
    L::load(&[c, -s, u, v])
}

impl<const FULL: bool> Kernel for Recurrence<'_, FULL> {
    type Output = ();
    type Place = Jet;
    #[inline(always)]
    fn run<L: Lane>(self) {
        let Recurrence { jet, start, piece, torque, at_limit } = self;
        let zero = L::splat(0.0);
        let (omega2, linear) = (Unnormalised::<L>::splat(piece.omega2), double::<L>(piece.linear));
        let (quadratic, dry) = (double::<L>(piece.quadratic), double::<L>(piece.dry));
        let sides = L::load(&[1.0, 1.0, -piece.slip, 1.0]);
        // In every place.
        let mut v = [Unnormalised::new(zero, zero); LONG];
        let mut t = [Unnormalised::new(zero, zero); LONG];
        v[0] = Unnormalised::splat(start[VELOCITY]);
        let mut hi = [start[SINE].hi, start[COSINE].hi, start[SLIP].hi, 0.0];
        let mut lo = [start[SINE].lo, start[COSINE].lo, start[SLIP].lo, 0.0];
        t[0] = Unnormalised::new(factors(hi, start[VELOCITY].hi), factors(lo, start[VELOCITY].lo));
        let (mut f, mut w) = ([zero; ORDER + 1], [0.0; ORDER + 1]);
        // Written out here and below, so that the compiler knows the length of every sum; loops where code is to be short.
        macro_rules! next {
            ($($kind:tt $k:expr);*) => {$({
                #[allow(non_snake_case, reason = "a constant where it is written out")]
                $kind K: usize = $k;
                let mut sums = t[0] * v[K];
                if K > 0 {
                    // The two products with the latest row last.
                    sums = sums + t[K] * v[0];
                }
                if K > 1 {
                    let (mut middle, mut j) = (t[K - 1] * v[1], 2);
                    while j < K {
                        middle = middle + t[K - j] * v[j];
                        j += 1;
                    }
                    sums = sums + middle;
                }
                let sine = Unnormalised::new(L::splat(hi[SINE]), L::splat(lo[SINE]));
                let mut force = Unnormalised::new(L::splat(torque.hi[K]), L::splat(torque.lo[K]));
                force = force - linear * v[K] - omega2 * sine;
                if K == 0 {
                    force = force - dry;
                }
                if FULL || K == 0 {
                    force = force + dry * Unnormalised::new(L::splat(hi[SLIP]), L::splat(lo[SLIP]));
                }
                if FULL {
                    let (square_hi, square_lo) = (places(sums.hi)[3], places(sums.lo)[3]);
                    force = force - quadratic * Unnormalised::new(L::splat(square_hi), L::splat(square_lo));
                }
                if K == 0 && at_limit {
                    force = double(0.0);
                }
                let inverse = Unnormalised::splat(INVERSE[K + 1]);
                v[K + 1] = force * inverse;
                let x = sums * (inverse * Unnormalised::from_double(sides));
                (hi, lo) = (places(x.hi), places(x.lo));
                let [next, rest] = [v[K + 1].hi.first(), v[K + 1].lo.first()];
                t[K + 1] = Unnormalised::new(factors(hi, next), factors(lo, rest));
            })*};
        }
        if COMPACT {
            let mut k = 0;
            while k < 8 {
                next!(let k);
                k += 1;
            }
        } else {
            next!(const 0; const 1; const 2; const 3; const 4; const 5; const 6; const 7);
        }
        macro_rules! keep {
            ($($kind:tt $k:expr);*) => {$({
                #[allow(non_snake_case, reason = "a constant where it is written out")]
                $kind K: usize = $k;
                // Not normalised: so the orders above need not wait for the low words.
                (w[K], f[K]) = (v[K].hi.first(), t[K].hi);
                let (row, now) = (t[K].tight(), v[K].tight());
                let slope = (v[K] * Unnormalised::splat(INVERSE[K + 1])).tight();
                let ([c, s, u, _], [c_low, s_low, u_low, _]) = (places(row.hi), places(row.lo));
                jet.rows[K] = [-s, c, now.hi.first(), slope.hi.first()];
                jet.low_rows[K] = [-s_low, c_low, now.lo.first(), slope.lo.first()];
                (jet.slip[K], jet.low_slip[K]) = (u, u_low);
                (jet.velocity[K], jet.slopes[K]) = (now.hi.first(), slope.hi.first());
            })*};
        }
        if COMPACT {
            let mut k = 0;
            while k < LONG {
                keep!(let k);
                k += 1;
            }
        } else {
            keep!(const 0; const 1; const 2; const 3; const 4; const 5; const 6; const 7; const 8);
        }
        let constants = Constants {
            omega2: L::splat(piece.omega2.hi),
            linear: L::splat(piece.linear),
            quadratic: L::splat(piece.quadratic),
            dry: L::splat(piece.dry),
            sides,
        };
        let mut last = [L::splat(hi[SINE]), L::splat(hi[SLIP])];
        // A lane in memory keeps the stack aligned to lanes: without it many of those that wait there would lie across two cache lines.
        let aligned = last;
        core::hint::black_box(&aligned);
        let mut rows = Rows { f, v: [zero; ORDER + 1], w: [zero; ORDER + 1], two: [zero; ORDER.div_ceil(2)] };
        let mut k = 0;
        while k < LONG {
            rows.v[k] = L::splat(w[k]);
            k += 1;
        }
        (rows.two[2], rows.two[3]) = (pair(rows.f[4], rows.f[5]), pair(rows.f[6], rows.f[7]));
        let mut k = 4;
        while k < LONG {
            rows.w[k] = halves(rows.v[k], rows.v[k - 1]);
            k += 1;
        }
        macro_rules! orders {
            ($($k:expr)*) => {$(
                last = if FULL {
                    constants.full_order($k, jet, &mut rows, torque, last)
                } else {
                    constants.order($k, jet, &mut rows, torque, last)
                };
            )*};
        }
        if COMPACT {
            let mut k = LONG - 1;
            while k < ORDER {
                orders!(k);
                k += 1;
            }
            return;
        }
        orders!( 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30);
    }
}

/// The coefficients so far.
struct Rows<L: Lane> {
    /// c, -s, u, v of one order.
    f: [L; ORDER + 1],
    /// v in every place.
    v: [L; ORDER + 1],
    /// v twice, and v of the order before twice.
    w: [L; ORDER + 1],
    /// c, -s of an even order, and those of the next one.
    two: [L; ORDER.div_ceil(2)],
}

/// The first half of one and the second half of another.
#[inline(always)]
fn halves<L: Lane>(a: L, b: L) -> L {
    let ([a, b, ..], [.., c, d]) = (places(a), places(b));
    L::load(&[a, b, c, d])
}

/// The first two of one and the first two of another.
#[inline(always)]
fn pair<L: Lane>(a: L, b: L) -> L {
    let ([a, b, ..], [c, d, ..]) = (places(a), places(b));
    L::load(&[a, b, c, d])
}

/// The constants of a piece, in every place.
struct Constants<L: Lane> {
    omega2: L,
    linear: L,
    quadratic: L,
    dry: L,
    /// What the products are times, before they are divided by k + 1.
    sides: L,
}

impl<L: Lane> Constants<L> {
    /// The row of order k + 1 from those up to k where neither drag nor presliding acts; s of the last row in every place. The latest
    /// coefficients come last in every sum: so the processor forms the rest while it waits for them.
    #[inline(always)]
    fn order(
        &self,
        k: usize,
        jet: &mut Jet,
        rows: &mut Rows<L>,
        torque: &TorqueJet,
        [s, u]: [L; 2],
    ) -> [L; 2] {
        let Rows { f, v, w, two } = rows;
        // Two terms in a lane from order 4 to k - 4 or k - 5, from the middle to both ends.
        let last = if k < 9 { 1 } else { (k - 5) / 2 };
        let (mut first, mut second) = (L::splat(0.0), L::splat(0.0));
        let half = (2 + last) / 2;
        let mut i = half;
        while i <= last {
            first = two[i].mul_add(w[k - 2 * i], first);
            i += 1;
        }
        let mut i = half;
        while i > 2 {
            i -= 1;
            second = two[i].mul_add(w[k - 2 * i], second);
        }
        let sum = first + second;
        let mut singly = L::splat(0.0);
        let mut j = 2 * last + 2;
        while j + 2 < k {
            singly = f[j].mul_add(v[k - j], singly);
            j += 1;
        }
        let middle = if last < 2 { singly } else { singly + (sum + exchanged(sum)) };
        let inverse = L::splat(INVERSE[k + 1].hi);
        let x = latest(k, rows, middle) * inverse;
        let force = (-self.linear).mul_add(rows.v[k], L::splat(torque.hi[k])) * inverse;
        let force = (self.omega2 * -inverse).mul_add(s, force);
        let next = places(x);
        rows.f[k + 1] = L::load(&[next[COSINE], -next[SINE], 0.0, 0.0]);
        if k.is_multiple_of(2) {
            rows.two[k / 2] = pair(rows.f[k], rows.f[k + 1]);
        }
        rows.w[k + 1] = halves(force, rows.v[k]);
        self.kept(k + 1, jet, rows, x, force);
        [L::splat(next[SINE]), u]
    }

    /// The same with drag or presliding; s and u of the last row.
    #[inline(always)]
    fn full_order(
        &self,
        k: usize,
        jet: &mut Jet,
        rows: &mut Rows<L>,
        torque: &TorqueJet,
        [s, u]: [L; 2],
    ) -> [L; 2] {
        let Rows { f, v, .. } = rows;
        let (mut first, mut second) = (L::splat(0.0), L::splat(0.0));
        let half = k / 2;
        let mut j = half;
        while j + 2 < k {
            if j > 3 {
                first = f[j].mul_add(v[k - j], first);
            }
            j += 1;
        }
        let mut j = half;
        while j > 4 {
            j -= 1;
            second = f[j].mul_add(v[k - j], second);
        }
        let inverse = L::splat(INVERSE[k + 1].hi);
        let each = self.sides * inverse;
        let x = latest(k, rows, first + second) * each;
        let force = (-self.linear).mul_add(rows.v[k], L::splat(torque.hi[k])) * inverse;
        let force = (self.dry * inverse).mul_add(u, (self.omega2 * -inverse).mul_add(s, force));
        let next = places(x);
        let force = (-self.quadratic).mul_add(L::splat(next[3]), force);
        rows.f[k + 1] = factors(next, force.first());
        jet.slip[k + 1] = next[SLIP];
        self.kept(k + 1, jet, rows, x, force);
        [L::splat(next[SINE]), L::splat(next[SLIP])]
    }

    /// A row, into the jet.
    #[inline(always)]
    fn kept(&self, k: usize, jet: &mut Jet, rows: &mut Rows<L>, x: L, v: L) {
        rows.v[k] = v;
        let (value, slope) = (v.first(), v.first() * INVERSE[k + 1].hi);
        x.store(&mut jet.rows[k]);
        (jet.rows[k][2], jet.rows[k][3]) = (value, slope);
        (jet.velocity[k], jet.slopes[k]) = (value, slope);
    }
}

/// The sum of all terms, when those of the latest three rows are added to the others.
#[inline(always)]
fn latest<L: Lane>(k: usize, rows: &Rows<L>, others: L) -> L {
    let Rows { f, v, .. } = rows;
    let mut sum = v[k - 3].mul_add(f[3], others);
    sum = v[k - 2].mul_add(f[2], sum);
    if k > 5 {
        sum = f[k - 2].mul_add(v[2], sum);
    }
    sum = v[k - 1].mul_add(f[1], sum);
    if k > 4 {
        sum = f[k - 1].mul_add(v[1], sum);
    }
    f[k].mul_add(v[0], v[k].mul_add(f[0], sum))
}

/// The halves exchanged.
#[inline(always)]
fn exchanged<L: Lane>(row: L) -> L {
    let [a, b, c, d] = places(row);
    L::load(&[c, d, a, b])
}

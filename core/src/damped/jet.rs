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

use super::taylor::{INVERSE, LONG, ORDER, Series, double, number, on_circle, places};
use super::torque_jet::TorqueJet;
use crate::float::Dd;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Kernel, Lane, four};

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
    rows: [[f64; 4]; ORDER + 1],
    low_rows: [[f64; 4]; LONG],
    /// Of u.
    slip: Series,
    low_slip: [f64; LONG],
    /// The columns of v and of the angle.
    pub velocity: Series,
    pub slopes: Series,
}

/// The state some time after the place of a jet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ahead {
    /// s, c, u, v.
    pub values: [Dd; 4],
    /// Of the angle.
    pub change: Dd,
    /// How far the velocity may be from its chord in between.
    pub bend: f64,
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

    /// The state a time later, as far as the series converges; s and c on the circle.
    pub fn at(&self, time: f64, slips: bool) -> Ahead {
        four(Sum { jet: self, time, slips })
    }

    /// Whether the velocity is seen at once to have no root in (0, time], at whose end `ahead` is.
    pub fn keeps_side(&self, time: f64, ahead: &Ahead) -> bool {
        let [first, second, ..] = self.velocity;
        let (start, end) = (if first == 0.0 { second * time } else { first }, ahead.values[VELOCITY].hi);
        start * end > 0.0 && f64::min(start.abs(), end.abs()) > ahead.bend
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
        let (mut f, mut w) = ([zero; ORDER + 1], [0.0; ORDER + 1]);
        // Written out here and below, so that the compiler knows the length of every sum.
        macro_rules! rows {
            ($($k:literal)*) => {$({
                const K: usize = $k;
                let x = Unnormalised::new(L::load(&hi), L::load(&lo)).tight();
                let now = v[K].tight();
                let slope = (v[K] * Unnormalised::splat(INVERSE[K + 1])).tight();
                // Not normalised: so the orders above need not wait for the low words.
                (w[K], f[K]) = (v[K].hi.first(), t[K].hi);
                (jet.rows[K], jet.low_rows[K]) = (places(x.hi), places(x.lo));
                (jet.slip[K], jet.low_slip[K]) = (jet.rows[K][2], jet.low_rows[K][2]);
                (jet.rows[K][2], jet.low_rows[K][2]) = (now.hi.first(), now.lo.first());
                (jet.rows[K][3], jet.low_rows[K][3]) = (slope.hi.first(), slope.lo.first());
                (jet.velocity[K], jet.slopes[K]) = (now.hi.first(), slope.hi.first());
                if K + 1 < LONG {
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
                        let square = Unnormalised::new(L::splat(places(sums.hi)[3]), L::splat(places(sums.lo)[3]));
                        force = force - quadratic * square;
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
                }
            })*};
        }
        rows!(0 1 2 3 4);
        let constants = Constants {
            omega2: L::splat(piece.omega2.hi),
            linear: L::splat(piece.linear),
            quadratic: L::splat(piece.quadratic),
            dry: L::splat(piece.dry),
            sides,
        };
        let mut last = [L::splat(hi[SINE]), L::splat(hi[SLIP])];
        if FULL {
            macro_rules! orders {
                ($($k:literal)*) => {
                    $(last = constants.order($k, jet, &mut f, &mut w, torque, last);)*
                };
            }
            orders!(4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30);
        } else {
            let mut pairs = Pairs { f, w: [zero; ORDER + 1], two: [zero; (ORDER + 1) / 2] };
            pairs.w[3] = L::load(&[w[3], w[3], w[2], w[2]]);
            pairs.w[4] = L::load(&[w[4], w[4], w[3], w[3]]);
            pairs.two[1] = pair(f[2], f[3]);
            let mut s = last[0];
            macro_rules! orders {
                ($($k:literal)*) => {
                    $(s = constants.pair_order($k, jet, &mut pairs, &mut w, torque, s);)*
                };
            }
            orders!(4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30);
        }
    }
}

/// Coefficients side by side for the products with v of s and c alone, two terms in a lane.
struct Pairs<L: Lane> {
    /// c, -s of one order.
    f: [L; ORDER + 1],
    /// v twice, and v of the order before twice.
    w: [L; ORDER + 1],
    /// c, -s of an even order and of the next one.
    two: [L; (ORDER + 1) / 2],
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
    /// The row of order k + 1 where neither drag nor presliding acts; s of the last row in every place.
    #[inline(always)]
    fn pair_order(
        &self,
        k: usize,
        jet: &mut Jet,
        pairs: &mut Pairs<L>,
        v: &mut [f64; ORDER + 1],
        torque: &TorqueJet,
        s: L,
    ) -> L {
        let Pairs { f, w, two } = pairs;
        // The products with the latest rows last: the processor forms the others while it waits for them.
        let (mut first, mut second) = (L::splat(0.0), L::splat(0.0));
        let mut i = 1;
        while 2 * i + 4 <= k {
            first = two[i].mul_add(w[k - 2 * i], first);
            i += 1;
            if 2 * i + 4 <= k {
                second = two[i].mul_add(w[k - 2 * i], second);
                i += 1;
            }
        }
        let [a, b, c, d] = places(first + second);
        let mut middle = L::load(&[a, b, 0.0, 0.0]) + L::load(&[c, d, 0.0, 0.0]);
        if k % 2 == 1 {
            middle = f[k - 3].mul_add(L::splat(v[3]), middle);
        }
        middle = f[k - 2].mul_add(L::splat(v[2]), middle);
        let inverse = L::splat(INVERSE[k + 1].hi);
        let (now, before) = (L::splat(v[k]), L::splat(v[k - 1]));
        let middle = before.mul_add(f[1] * inverse, middle * inverse);
        let middle = (f[k - 1] * inverse).mul_add(L::splat(v[1]), middle);
        let rest = now.mul_add(f[0] * inverse, middle);
        let x = f[k].mul_add(L::splat(v[0] * INVERSE[k + 1].hi), rest);
        let force = (self.linear * -inverse).mul_add(now, L::splat(torque.hi[k]) * inverse);
        let next = (self.omega2 * -inverse).mul_add(s, force);
        let [sine, cosine, ..] = places(x);
        f[k + 1] = L::load(&[cosine, -sine, 0.0, 0.0]);
        if k % 2 == 0 {
            two[k / 2] = pair(f[k], f[k + 1]);
        }
        let value = next.first();
        let slope = value * INVERSE[k + 2].hi;
        w[k + 1] = L::load(&[value, value, v[k], v[k]]);
        v[k + 1] = value;
        x.store(&mut jet.rows[k + 1]);
        (jet.rows[k + 1][2], jet.rows[k + 1][3]) = (value, slope);
        (jet.velocity[k + 1], jet.slopes[k + 1]) = (value, slope);
        L::splat(sine)
    }

    /// The row of order k + 1 from those up to k; s and u of the last row in every place.
    #[inline(always)]
    fn order(
        &self,
        k: usize,
        jet: &mut Jet,
        f: &mut [L; ORDER + 1],
        v: &mut [f64; ORDER + 1],
        torque: &TorqueJet,
        [s, u]: [L; 2],
    ) -> [L; 2] {
        let (mut even, mut odd) = (L::splat(0.0), L::splat(0.0));
        let mut j = 2;
        while j < k - 2 {
            even = f[j].mul_add(L::splat(v[k - j]), even);
            j += 1;
            if j < k - 2 {
                odd = f[j].mul_add(L::splat(v[k - j]), odd);
                j += 1;
            }
        }
        let inverse = L::splat(INVERSE[k + 1].hi);
        let each = self.sides * inverse;
        let (now, before) = (L::splat(v[k]), L::splat(v[k - 1]));
        let middle = f[k - 2].mul_add(L::splat(v[2]), even + odd);
        let middle = before.mul_add(f[1] * each, middle * each);
        let middle = (f[k - 1] * each).mul_add(L::splat(v[1]), middle);
        let rest = now.mul_add(f[0] * each, middle);
        let x = f[k].mul_add(L::splat(v[0]) * each, rest);
        let force = (self.linear * -inverse).mul_add(now, L::splat(torque.hi[k]) * inverse);
        let force = (self.dry * inverse).mul_add(u, (self.omega2 * -inverse).mul_add(s, force));
        let next = places(x);
        let value = (-self.quadratic).mul_add(L::splat(next[3]), force).first();
        let slope = value * INVERSE[k + 2].hi;
        f[k + 1] = factors(next, value);
        v[k + 1] = value;
        x.store(&mut jet.rows[k + 1]);
        jet.slip[k + 1] = next[SLIP];
        (jet.rows[k + 1][2], jet.rows[k + 1][3]) = (value, slope);
        (jet.velocity[k + 1], jet.slopes[k + 1]) = (value, slope);
        [L::splat(next[SINE]), L::splat(next[SLIP])]
    }
}

struct Sum<'a> {
    jet: &'a Jet,
    time: f64,
    slips: bool,
}

impl Kernel for Sum<'_> {
    type Output = Ahead;
    type Place = Jet;
    #[inline(always)]
    fn run<L: Lane>(self) -> Ahead {
        let Sum { jet, time, slips } = self;
        let t = L::splat(time);
        let (square, fourth) = (t * t, (t * t) * (t * t));
        // Every fourth power by itself, so that the sums need not wait for each other.
        let mut k = ORDER + 1 - 4;
        let mut sums = [L::splat(0.0); 4];
        let mut i = 0;
        while i < 4 {
            sums[i] = L::load(&jet.rows[k + i]);
            i += 1;
        }
        while k >= LONG + 4 {
            k -= 4;
            let mut i = 0;
            while i < 4 {
                sums[i] = sums[i].mul_add(fourth, L::load(&jet.rows[k + i]));
                i += 1;
            }
        }
        let mut tail = sums[3].mul_add(t, sums[2]).mul_add(square, sums[1].mul_add(t, sums[0]));
        while k > LONG {
            k -= 1;
            tail = tail.mul_add(t, L::load(&jet.rows[k]));
        }
        let time = Unnormalised::from_double(t);
        let mut sum = Unnormalised::from_double(tail);
        while k > 0 {
            k -= 1;
            sum = sum * time + Unnormalised::new(L::load(&jet.rows[k]), L::load(&jet.low_rows[k]));
        }
        let mut u = Dd::new(jet.slip[0], jet.low_slip[0]);
        if slips {
            let mut tail = L::splat(jet.slip[ORDER]);
            let mut k = ORDER;
            while k > LONG {
                k -= 1;
                tail = tail.mul_add(t, L::splat(jet.slip[k]));
            }
            let mut sum = Unnormalised::from_double(tail);
            while k > 0 {
                k -= 1;
                sum = sum * time + Unnormalised::new(L::splat(jet.slip[k]), L::splat(jet.low_slip[k]));
            }
            u = number(sum);
        }
        let bend = bend(&jet.velocity, t);
        let (hi, lo) = (places(sum.hi), places(sum.lo));
        let mut s = Unnormalised::<L>::new(L::splat(hi[0]), L::splat(lo[0]));
        let mut c = Unnormalised::<L>::new(L::splat(hi[1]), L::splat(lo[1]));
        on_circle(&mut s, &mut c);
        let velocity = Unnormalised::<L>::new(L::splat(hi[2]), L::splat(lo[2]));
        let change = Unnormalised::<L>::new(L::splat(hi[3]), L::splat(lo[3])) * time;
        Ahead { values: [number(s), number(c), u, number(velocity)], change: number(change), bend }
    }
}

/// (k - i) (k - 1 - i)/8 for i = 0 and 1.
const BEND: [Series; 2] = {
    let mut all = [[0.0; ORDER + 1]; 2];
    let mut k = 1;
    while k <= ORDER {
        all[0][k] = (k * (k - 1)) as f64 * 0.125;
        all[1][k] = ((k - 1) * (k - 1) - (k - 1)) as f64 * 0.125;
        k += 1;
    }
    all
};

/// A polynomial is nowhere on an interval of length t farther from its chord than t^2/8 times its largest second derivative: at most
/// the sum of k (k - 1)/8 |c_k| t^k. Where c_0 is 0 this is said of the polynomial over its argument, and the sum is t times that.
#[inline(always)]
fn bend<L: Lane>(c: &Series, t: L) -> f64 {
    let weights = &BEND[usize::from(c[0] == 0.0)];
    let square = t * t;
    let fourth = square * square;
    let mut sum = L::splat(0.0);
    let mut k = ORDER + 1;
    while k > 0 {
        k -= 4;
        sum = sum.mul_add(fourth, L::load(&c[k..]).abs() * L::load(&weights[k..]));
    }
    let [a, b, c, d] = places(sum);
    let [t, square] = [t.first(), square.first()];
    (a + b * t) + (c + d * t) * square
}

//! The state that the Taylor coefficients of one time give at another: the sums of their terms.
//!
//! Of the four variables side by side: 23 terms in double, every fourth power by itself, then 9 in double-double by Horner's rule.

use super::jet::{Jet, VELOCITY};
use super::taylor::{LONG, ORDER, Series, number, on_circle, places};
use crate::float::Dd;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Kernel, Lane, four};

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

//! The inverses of Glaisher's twelve functions over lanes, for m < 1.
//!
//! Method: the formulas of inverse.rs, their sums as double-doubles and one R_F; where an even function is negative 2 K less
//! that of |x|. NaN where an argument of R_F is below 0, beyond 1e60, or next to 0 beside another.

use super::functions::NevilleIndex;
use super::glaisher::Glaisher;
use crate::elliptic::integrals::duplication_lanes::{LARGEST, LEAST, rf};
use crate::elliptic::integrals::incomplete_lanes::only_where;
use crate::float::Dd;
use crate::float::elementary::quotient;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Formula, Lane};

/// The two of c, d, n that are not this one.
pub(super) fn others(index: NevilleIndex) -> [NevilleIndex; 2] {
    use NevilleIndex::{C, D, N};
    match index {
        C => [D, N],
        D => [C, N],
        _ => [C, D],
    }
}

/// Delta(p, q) as a sum of m, mc and 1, of which one counts.
#[derive(Clone, Copy)]
struct Difference {
    m: f64,
    mc: f64,
    one: f64,
}

impl Difference {
    fn new(p: NevilleIndex, q: NevilleIndex) -> Self {
        use NevilleIndex::{C, D, N};
        let [m, mc, one] = match (p, q) {
            (N, D) => [1.0, 0.0, 0.0],
            (D, N) => [-1.0, 0.0, 0.0],
            (D, C) => [0.0, 1.0, 0.0],
            (C, D) => [0.0, -1.0, 0.0],
            (N, C) => [0.0, 0.0, 1.0],
            (C, N) => [0.0, 0.0, -1.0],
            _ => [0.0; 3],
        };
        Difference { m, mc, one }
    }
    /// Exact: two of the three are products with 0.
    #[inline(always)]
    fn of<L: Lane>(&self, m: Dd<L>, mc: Dd<L>) -> Dd<L> {
        let (a, b) = (L::splat(self.m), L::splat(self.mc));
        Dd::new(a.mul_add(m.hi, b.mul_add(mc.hi, L::splat(self.one))), a.mul_add(m.lo, b * mc.lo))
    }
}

/// m, mc where mc is in the range.
#[inline(always)]
fn held<L: Lane>([m, m_rest, mc, mc_rest]: [L; 4]) -> (Dd<L>, Dd<L>) {
    let mc = only_where(L::splat(LEAST).less(mc), only_where(mc.less(L::splat(LARGEST)), mc));
    (Dd::new(m, m_rest), Dd::new(mc, mc_rest))
}

/// An argument of R_F, NaN where it is out of the range.
#[inline(always)]
fn argument<L: Lane>(value: Dd<L>) -> Dd<L> {
    let hi = only_where(value.hi.less(L::splat(LARGEST)), value.hi);
    Dd::new(only_where(L::splat(-1e-300).less(hi), hi), value.lo)
}

/// R_F(base, lower, upper), of which at most one is next to 0.
#[inline(always)]
fn first_kind<L: Lane>(base: Dd<L>, lower: Dd<L>, upper: Dd<L>) -> Dd<L> {
    // The upper one is the larger of two, so that base and lower decide.
    let both = L::select(base.hi.less(lower.hi), lower.hi, base.hi);
    let mut base = argument(base);
    base.hi = only_where(L::splat(LEAST).less(both), only_where(L::splat(LEAST).less(upper.hi), base.hi));
    rf([base, argument(lower), argument(upper)])
}

/// Of sp (`zero`) or ps, p one of c, d, n; of x, m.hi, m.lo, mc.hi, mc.lo.
pub(crate) struct InverseOdd {
    zero: bool,
    below: Difference,
    between: Difference,
    above: Difference,
}

impl InverseOdd {
    pub fn new(index: NevilleIndex, zero: bool) -> Self {
        // Delta(p, q) >= 0 for m >= 0; for m < 0 nothing is subtracted in either order.
        let [q, p] = others(index);
        InverseOdd {
            zero,
            below: Difference::new(q, index),
            between: Difference::new(p, q),
            above: Difference::new(p, index),
        }
    }
}

impl Formula<5, 1> for InverseOdd {
    type Place = Glaisher;
    #[inline(always)]
    fn at<L: Lane>(&self, [x, m, m_rest, mc, mc_rest]: [L; 5]) -> [L; 1] {
        let (m, mc) = held([m, m_rest, mc, mc_rest]);
        let one = Dd::from_double(L::splat(1.0));
        let x = only_where(x.abs().less(L::splat(1e30)), x);
        let square = Dd::product(x, x);
        let (base, factor) = if self.zero { (one, square) } else { (square, one) };
        let below = self.below.of(m, mc);
        let lower = base + below * factor;
        let upper = lower + self.between.of(m, mc) * factor;
        let apart = base + self.above.of(m, mc) * factor;
        let upper = Dd::select(below.hi.less(L::splat(0.0)), upper, apart);
        let integral = first_kind(base, lower, upper);
        let value = if self.zero { integral * x } else { integral };
        [value.value().copysign(x)]
    }
}

/// Of pq with p, q among c, d, n, likewise.
pub(crate) struct InverseEven {
    distance: Difference,
    ratio: Difference,
    offset: Difference,
    /// Whether the function has negative values.
    signed: bool,
}

impl InverseEven {
    pub fn new(p: NevilleIndex, q: NevilleIndex) -> Self {
        let r = match others(p) {
            [first, second] if first == q => second,
            [first, _] => first,
        };
        InverseEven {
            distance: Difference::new(q, p),
            ratio: Difference::new(r, q),
            offset: Difference::new(r, p),
            signed: p == NevilleIndex::C || q == NevilleIndex::C,
        }
    }
}

impl Formula<5, 1> for InverseEven {
    type Place = Glaisher;
    #[inline(always)]
    fn at<L: Lane>(&self, [x, m, m_rest, mc, mc_rest]: [L; 5]) -> [L; 1] {
        let (m, mc) = held([m, m_rest, mc, mc_rest]);
        let (zero, one) = (Dd::from_double(L::splat(0.0)), Dd::from_double(L::splat(1.0)));
        let below = x.less(zero.hi);
        let bound = L::splat(if self.signed { -1e30 } else { 0.0 });
        let size = only_where(bound.less(x), x.abs());
        let size = only_where(size.less(L::splat(1e30)), size);
        let square = Dd::product(size, size);
        let distance = self.distance.of(m, mc);
        let (ratio, offset) = (self.ratio.of(m, mc), self.offset.of(m, mc));
        let w = quotient(Dd::sum(one.hi, -size) * Dd::sum(one.hi, size), distance);
        // As in inverse.rs: the form that does not subtract; where both do the second, unless its terms are much larger.
        let direct = one + ratio * w;
        let negative = ratio.hi.less(zero.hi);
        let larger = (distance.hi.abs() + distance.hi.abs()).less(offset.hi.abs());
        let other = L::select(larger, one.hi, zero.hi);
        let other = L::select((ratio.hi * offset.hi).less(zero.hi), zero.hi, other);
        let second = L::select(negative, other, one.hi).equal(zero.hi);
        let last = if L::any(second) {
            Dd::select(second, quotient(offset - ratio * square, distance), direct)
        } else {
            direct
        };
        let root = Unnormalised::from(argument(w)).root().tight();
        let mut at = [square, one, argument(last)];
        let held = L::select(square.hi.less(last.hi), last.hi, square.hi);
        at[0].hi = only_where(L::splat(LEAST).less(held), square.hi);
        let mut factor = root;
        let mut values = [zero; 2];
        let mut pass = 0;
        loop {
            values[pass] = rf(at) * factor;
            if pass == 1 || !L::any(below) {
                break;
            }
            // 2 K, of the rows that need it.
            at = [zero, Dd::select(below, mc, one), one];
            factor = one.scale(L::splat(2.0));
            pass = 1;
        }
        let beyond = values[1] - values[0];
        [L::select(below, beyond.value(), values[0].value())]
    }
}

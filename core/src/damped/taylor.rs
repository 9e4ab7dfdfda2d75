//! What all Taylor series of the motion share: their length, the inverses of whole numbers, and words of double-doubles.

use crate::float::Dd;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::Lane;

/// Highest power of time. For a tolerance of 2^-66 the rule of Jorba & Zou, ceil(-ln(tolerance)/2) + 1 = 24, counts the products in
/// double only; with those in double-double, whose number does not grow with the order, 30 was measured to take a fifth less time.
pub(super) const ORDER: usize = 30;
/// How many coefficients of the lowest orders are double-doubles.
pub(super) const LONG: usize = 9;

/// The coefficients of one function of time.
pub(super) type Series = [f64; ORDER + 1];

/// 1/k in double-double, 0 for k = 0.
pub(super) const INVERSE: [Dd; ORDER + 2] = inverses();

const fn inverses() -> [Dd; ORDER + 2] {
    let mut all = [Dd::ZERO; ORDER + 2];
    let mut k = 1;
    while k < ORDER + 2 {
        let whole = k as f64;
        let hi = 1.0 / whole;
        // hi = n/2^s exactly: the rest 1 - k hi fits into 2^-52, and its exact value is formed in integers.
        let bits = hi.to_bits();
        let mantissa = ((bits & ((1 << 52) - 1)) | (1 << 52)) as i128;
        let scale = 1075 - (bits >> 52) as u32;
        let rest = (1i128 << scale) - mantissa * k as i128;
        let mut lo = rest as f64 / whole;
        let mut left = scale;
        while left > 0 {
            lo *= 0.5;
            left -= 1;
        }
        all[k] = Dd::new(hi, lo);
        k += 1;
    }
    all
}

/// Four double-doubles side by side, as [`Unnormalised`]: the compiler makes one instruction of four equal ones.
#[derive(Clone, Copy)]
pub(super) struct Four<L: Lane> {
    pub hi: [L; 4],
    pub lo: [L; 4],
}

impl<L: Lane> Four<L> {
    #[inline(always)]
    pub fn zero() -> Self {
        Four { hi: [L::splat(0.0); 4], lo: [L::splat(0.0); 4] }
    }
    #[inline(always)]
    pub fn at(&self, i: usize) -> Unnormalised<L> {
        Unnormalised::new(self.hi[i], self.lo[i])
    }
    #[inline(always)]
    pub fn of([a, b, c, d]: [Unnormalised<L>; 4]) -> Self {
        Four { hi: [a.hi, b.hi, c.hi, d.hi], lo: [a.lo, b.lo, c.lo, d.lo] }
    }
    /// All times one number.
    #[inline(always)]
    pub fn times(self, factor: Unnormalised<L>) -> Self {
        let Four { hi, lo } = self;
        let (a, b) = (hi[0].two_product(factor.hi), hi[1].two_product(factor.hi));
        let (c, d) = (hi[2].two_product(factor.hi), hi[3].two_product(factor.hi));
        let error = [a.1, b.1, c.1, d.1];
        let cross = four_mul_add(lo, factor.hi, error);
        Four { hi: [a.0, b.0, c.0, d.0], lo: four_mul_add(hi, factor.lo, cross) }
    }
    /// All times one double.
    #[inline(always)]
    pub fn times_double(self, factor: L) -> Self {
        let Four { hi, lo } = self;
        let (a, b) = (hi[0].two_product(factor), hi[1].two_product(factor));
        let (c, d) = (hi[2].two_product(factor), hi[3].two_product(factor));
        Four { hi: [a.0, b.0, c.0, d.0], lo: four_mul_add(lo, factor, [a.1, b.1, c.1, d.1]) }
    }
    #[inline(always)]
    pub fn plus(self, other: Self) -> Self {
        Four::of([
            self.at(0) + other.at(0),
            self.at(1) + other.at(1),
            self.at(2) + other.at(2),
            self.at(3) + other.at(3),
        ])
    }
}

/// a b + c for each of four.
#[inline(always)]
pub(super) fn four_mul_add<L: Lane>(a: [L; 4], b: L, c: [L; 4]) -> [L; 4] {
    [a[0].mul_add(b, c[0]), a[1].mul_add(b, c[1]), a[2].mul_add(b, c[2]), a[3].mul_add(b, c[3])]
}

/// Four doubles of a row.
#[inline(always)]
pub(super) fn four<L: Lane>(row: &[f64; 4]) -> [L; 4] {
    [L::load(&row[0..]), L::load(&row[1..]), L::load(&row[2..]), L::load(&row[3..])]
}

/// A double, exactly.
#[inline(always)]
pub(super) fn double<L: Lane>(value: f64) -> Unnormalised<L> {
    Unnormalised::from_double(L::splat(value))
}

/// One number out of a lane.
#[inline(always)]
pub(super) fn number<L: Lane>(value: Unnormalised<L>) -> Dd {
    let value = value.tight();
    Dd::new(value.hi.first(), value.lo.first())
}

/// Sine and cosine put back on the circle after a step: their errors along it are those of the step.
#[inline(always)]
pub(super) fn on_circle<L: Lane>(s: &mut Unnormalised<L>, c: &mut Unnormalised<L>) {
    let excess = s.square() + c.square() - double(1.0);
    let half = Unnormalised::from_double((excess.hi + excess.lo) * L::splat(-0.5));
    (*s, *c) = (*s + *s * half, *c + *c * half);
}

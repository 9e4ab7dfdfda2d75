//! R_F, R_C, R_D and R_J over lanes; NaN for x, y, z below 0, arguments beyond 1e60 and next to 0 but for one of x, y, z,
//! and next to the zeros of the principal value of R_J.

use super::duplication_lanes::{LARGEST, LEAST, Triple, chosen, larger, rf, rf_and_rd};
use super::rc_lanes::rc;
use super::rj_lanes::rf_and_rj;
use crate::float::Dd;
use crate::float::elementary::quotient;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Formula, Lane};

/// x where it and the others are in the range, at most one of them next to 0.
#[inline(always)]
fn held<L: Lane>(x: L, y: L, z: L) -> L {
    let nan = L::splat(f64::NAN);
    let least = L::select(x.less(y), x, y);
    let top = larger(x, y);
    let middle = larger(least, L::select(top.less(z), top, z));
    let x = L::select(L::splat(LEAST).less(middle), x, nan);
    let x = L::select(larger(top, z).less(L::splat(LARGEST)), x, nan);
    let negative = L::select(least.less(z), least, z).less(L::splat(0.0));
    L::select(negative, nan, x)
}

/// A positive argument in the range.
#[inline(always)]
fn positive<L: Lane>(x: L) -> L {
    let nan = L::splat(f64::NAN);
    L::select(x.less(L::splat(LARGEST)), L::select(L::splat(LEAST).less(x), x, nan), nan)
}

/// Square root as hi + lo.
#[inline(always)]
fn root<L: Lane>(value: Dd<L>) -> Dd<L> {
    Unnormalised::from(value).root().tight()
}

/// R_F.
pub(crate) struct CarlsonRf;

impl Formula<3, 1> for CarlsonRf {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [x, y, z]: [L; 3]) -> [L; 1] {
        let x = held(x, y, z);
        [rf([Dd::from_double(x), Dd::from_double(y), Dd::from_double(z)]).value()]
    }
}

/// R_C, for y < 0 as sqrt(x/(x - y)) R_C(x - y, -y).
pub(crate) struct CarlsonRc;

impl Formula<2, 1> for CarlsonRc {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [x, y]: [L; 2]) -> [L; 1] {
        let zero = L::splat(0.0);
        let negative = y.less(zero);
        let size = positive(y.abs());
        let x = held(x, size, size);
        let first = Dd::select(negative, Dd::sum(x, size), Dd::from_double(x));
        let value = rc(first, Dd::from_double(size));
        if !L::any(negative) {
            return [value.value()];
        }
        let root = quotient(root(Dd::from_double(x)), root(first));
        let product = root * value;
        // The root of 0 has no quotient with it.
        let product = L::select(x.equal(zero), zero, product.value());
        [L::select(negative, product, value.value())]
    }
}

/// R_D.
pub(crate) struct CarlsonRd;

impl Formula<3, 1> for CarlsonRd {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [x, y, z]: [L; 3]) -> [L; 1] {
        let z = positive(z);
        let x = held(x, y, z);
        let (_, third) = rf_and_rd([Dd::from_double(x), Dd::from_double(y), Dd::from_double(z)]);
        [third.hi.mul_add(L::splat(3.0), third.lo * L::splat(3.0))]
    }
}

/// What p < 0 asks for: Cauchy's principal value by DLMF 19.20.14, as in carlson.rs.
struct Principal<L: Lane> {
    q: L,
    /// x y and its product with z, the largest.
    xy: Dd<L>,
    xyz: Dd<L>,
    /// 1/(z + q) and (z - x)(z - y)/(z + q).
    inverse: Dd<L>,
    below: Dd<L>,
}

impl<L: Lane> Principal<L> {
    /// With x, y, z in rising order, and the p of the R_J that it takes.
    #[inline(always)]
    fn new([x, y, z]: [L; 3], q: L) -> (Self, Triple<L>, Dd<L>) {
        let (x, y) = (L::select(x.less(y), x, y), larger(x, y));
        let (y, z) = (L::select(y.less(z), y, z), larger(y, z));
        let (zx, zy) = (Dd::sum(z, -x), Dd::sum(z, -y));
        let inverse = quotient(Dd::from_double(L::splat(1.0)), Dd::sum(z, q));
        let p = (Dd::sum(x, q) * z).plain_sum(zx * y) * inverse;
        let xy = Dd::product(x, y);
        let principal = Principal { q, xy, xyz: xy * z, inverse, below: zx * zy * inverse };
        (principal, [Dd::from_double(x), Dd::from_double(y), Dd::from_double(z)], p)
    }
    /// R_J/3 from R_F and R_J/3 of x, y, z, p; NaN where its two terms cancel.
    #[inline(always)]
    fn value(&self, p: Dd<L>, first: Dd<L>, third: Dd<L>) -> L {
        let (zero, nan) = (L::splat(0.0), L::splat(f64::NAN));
        let pq = p * self.q;
        let sum = self.xy.plain_sum(pq);
        let sum = Dd::new(L::select(sum.hi.less(L::splat(LARGEST)), sum.hi, nan), sum.lo);
        let in_range = Dd::new(L::select(L::splat(1e-200).less(self.xyz.hi), self.xyz.hi, nan), self.xyz.lo);
        let elementary = quotient(root(in_range), root(sum)) * rc(sum, Dd::new(positive(pq.hi), pq.lo));
        let elementary = Dd::select(self.xy.hi.equal(zero), Dd::from_double(zero), elementary);
        let other = first.plain_sum(self.below * third);
        let difference = elementary.plain_sum(-other);
        let whole = (difference * self.inverse).value();
        L::select((other.hi * L::splat(0.125)).less(difference.hi.abs()), whole, nan)
    }
}

/// R_J.
pub(crate) struct CarlsonRj;

impl Formula<4, 1> for CarlsonRj {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [x, y, z, p]: [L; 4]) -> [L; 1] {
        let three = L::splat(3.0);
        let x = held(x, y, z);
        let negative = p.less(L::splat(0.0));
        let size = positive(p.abs());
        let mut at = [Dd::from_double(x), Dd::from_double(y), Dd::from_double(z)];
        let mut inner = Dd::from_double(size);
        let mut principal = None;
        if L::any(negative) {
            let (found, sorted, p) = Principal::new([x, y, z], size);
            at = chosen::<L>(negative, sorted, at);
            inner = Dd::select(negative, p, inner);
            principal = Some(found);
        }
        let (first, third) = rf_and_rj(at, inner);
        let value = third.hi.mul_add(three, third.lo * three);
        match principal {
            Some(principal) => [L::select(negative, principal.value(inner, first, third) * three, value)],
            None => [value],
        }
    }
}

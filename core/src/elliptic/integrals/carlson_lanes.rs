//! R_F, R_C, R_D and R_J over lanes; NaN for arguments below 0, beyond 1e60 and next to 0 but for one of x, y, z.

use super::duplication_lanes::{LARGEST, LEAST, larger, rf, rf_and_rd};
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
        let root =
            quotient(Unnormalised::from_double(x).root().tight(), Unnormalised::from(first).root().tight());
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

/// R_J, p > 0.
pub(crate) struct CarlsonRj;

impl Formula<4, 1> for CarlsonRj {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [x, y, z, p]: [L; 4]) -> [L; 1] {
        let x = held(x, y, z);
        let at = [Dd::from_double(x), Dd::from_double(y), Dd::from_double(z)];
        let (_, third) = rf_and_rj(at, Dd::from_double(positive(p)));
        [third.hi.mul_add(L::splat(3.0), third.lo * L::splat(3.0))]
    }
}

//! R_J over lanes by Carlson's duplication, with R_F of the same x, y, z: arguments >= 0 between 1e-60 and 1e60, at most
//! one of x, y, z below; p > 0.
//!
//! Method: as in duplication_lanes.rs; a step adds 6 R_C(1, 1 + e)/d with d = (sqrt p + sqrt x)(sqrt p + sqrt y)(sqrt p + sqrt z)
//! and e = (p - x)(p - y)(p - z)/d^2, whose 1 + e is also 2 sqrt p (p + shift)/d: nothing is subtracted.
//! Source: Carlson, Numer. Algorithms 10 (1995) 13; DLMF 19.26.22, 19.36.2.

use super::duplication_lanes::{NEAR_OF_FIVE, Triple, chosen, larger, near_rf, sum_of_five, total};
use super::rc_lanes::unit_rc;
use super::series_lanes::third_kind;
use crate::float::Dd;
use crate::float::double_double::two_sum;
use crate::lanes::Lane;

/// Sum of two roots.
#[inline(always)]
fn pair<L: Lane>(a: Dd<L>, b: Dd<L>) -> Dd<L> {
    let (hi, error) = two_sum(a.hi, b.hi);
    Dd::new(hi, error + (a.lo + b.lo))
}

/// R_F(x, y, z) and R_J(x, y, z, p)/3, each as hi + lo.
#[inline(always)]
pub(crate) fn rf_and_rj<L: Lane>(mut at: Triple<L>, mut p: Dd<L>) -> (Dd<L>, Dd<L>) {
    let (one, half, quarter, five) = (L::splat(1.0), L::splat(0.5), L::splat(0.25), L::splat(-5.0));
    let (mut sum, mut power) = (Dd::from_double(L::splat(0.0)), one);
    let [x, y, z] = at;
    let mut delta = ((p.hi - x.hi) + (p.lo - x.lo)) * ((p.hi - y.hi) + (p.lo - y.lo));
    delta = delta * ((p.hi - z.hi) + (p.lo - z.lo));
    loop {
        let [x, y, z] = at;
        let mean = p.hi.mul_add(L::splat(2.0), (x.hi + y.hi) + z.hi);
        let far = larger(x.hi.mul_add(five, mean).abs(), y.hi.mul_add(five, mean).abs());
        let far = larger(far, larger(z.hi.mul_add(five, mean).abs(), p.hi.mul_add(five, mean).abs()));
        let further = (mean * L::splat(NEAR_OF_FIVE)).less(far);
        if !L::any(further) {
            break;
        }
        let (a, b, c, r) = (x.hi.sqrt(), y.hi.sqrt(), z.hi.sqrt(), p.hi.sqrt());
        // Half the inverse of each by one division. What is added counts only for a root so small that its rest does not.
        let least = L::splat(1e-60) * (a + b + c);
        let (ta, tb, tc) = (a + least, b + least, c + least);
        let (ab, cr) = (ta * tb, tc * r);
        let inverse = half / (ab * cr);
        let (of_ab, of_cr) = (inverse * cr, inverse * ab);
        let a = Dd::new(a, (x.hi.remainder(a, a) + x.lo) * (of_ab * tb));
        let b = Dd::new(b, (y.hi.remainder(b, b) + y.lo) * (of_ab * ta));
        let c = Dd::new(c, (z.hi.remainder(c, c) + z.lo) * (of_cr * r));
        let r = Dd::new(r, (p.hi.remainder(r, r) + p.lo) * (of_cr * tc));
        let shift = (a * b).plain_sum(c * pair(a, b));
        let last = pair(p, shift);
        let d = pair(r, a) * pair(r, b) * pair(r, c);
        let inverse = one / d.hi;
        let rest = inverse * (one.remainder(inverse, d.hi) - d.lo * inverse);
        let inverse = Dd::new(inverse, rest);
        let v = (r * last * inverse).scale(L::splat(2.0));
        let term = (inverse * unit_rc(v, delta * inverse.hi * inverse.hi)).scale(power + power);
        let (hi, error) = two_sum(sum.hi, term.hi);
        let grown = Dd::new(hi, sum.lo + (term.lo + error));
        let next =
            [pair(x, shift).scale(quarter), pair(y, shift).scale(quarter), pair(z, shift).scale(quarter)];
        at = chosen::<L>(further, next, at);
        p = Dd::select(further, last.scale(quarter), p);
        sum = Dd::select(further, grown, sum);
        power = L::select(further, power * quarter, power);
        delta = L::select(further, delta * L::splat(1.0 / 64.0), delta);
    }
    let mean = pair(total(at), p.scale(L::splat(2.0)));
    let inverse = one / mean.hi;
    let dx = at[0].hi.mul_add(five, mean.hi) * inverse;
    let dy = at[1].hi.mul_add(five, mean.hi) * inverse;
    let dz = at[2].hi.mul_add(five, mean.hi) * inverse;
    let dp = (dx + dy + dz) * L::splat(-0.5);
    let (xyz, pp) = (dx * dy * dz, dp * dp);
    let e2 = dx.mul_add(dy, dz * (dx + dy)) - pp * L::splat(3.0);
    let e3 = pp.mul_add(L::splat(2.0), e2).mul_add(dp + dp, xyz);
    let e4 = xyz.mul_add(L::splat(2.0), pp.mul_add(L::splat(3.0), e2) * dp) * dp;
    let e5 = xyz * pp;
    (near_rf(at), sum_of_five(sum, power, mean, third_kind(e2, e3, e4, e5)))
}

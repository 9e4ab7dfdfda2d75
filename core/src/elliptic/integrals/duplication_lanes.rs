//! Carlson's duplication over lanes, for R_F and R_D: arguments >= 0 between 1e-60 and 1e60, at most one of them below
//! (not the last of R_D).
//!
//! Method: a step takes x to (x + shift)/4 with shift = sqrt x sqrt y + sqrt y sqrt z + sqrt z sqrt x; when the arguments
//! agree to some per cent the series in their elementary symmetric functions ends it (series_lanes.rs). Every argument, root
//! and sum carries what its rounding left: three roots take the divider longer than all that takes the adders. A lane that
//! has come near is left as it is while others go on, so that a value depends on its arguments alone.
//! Source: DLMF 19.26.18, 19.36.1, 19.36.2; Carlson, Numer. Algorithms 10 (1995) 13.

use super::series_lanes::{first_kind, third_kind};
use crate::float::Dd;
use crate::float::double_double::two_sum;
use crate::lanes::Lane;

/// The smallest and largest arguments, but for the one that may be 0.
pub(crate) const LEAST: f64 = 1e-60;
pub(crate) const LARGEST: f64 = 1e60;

/// Largest distance from the mean, over the mean, that the series of R_F takes; of five terms the one of R_D and R_J.
const NEAR: f64 = 0.09;
pub(super) const NEAR_OF_FIVE: f64 = 0.045;

/// sqrt 3 and 5 sqrt 5/3.
const ROOT_THREE: Dd = Dd::new(1.7320508075688772, 1.0035084221806903e-16);
const FIVE_ROOT_FIVE_THIRDS: Dd = Dd::new(3.7267799624996494, 1.1498896644395823e-16);

/// Three arguments.
pub(crate) type Triple<L> = [Dd<L>; 3];

/// The roots of three arguments and the sum of their products.
struct Step<L> {
    roots: Triple<L>,
    shift: Dd<L>,
}

impl<L: Lane> Step<L> {
    #[inline(always)]
    fn new([x, y, z]: Triple<L>) -> Self {
        let (a, b, c) = (x.hi.sqrt(), y.hi.sqrt(), z.hi.sqrt());
        // Half the inverse of each by one division. What is added counts only for a root so small that its rest does not.
        let least = L::splat(1e-60) * (a + b + c);
        let (ta, tb, tc) = (a + least, b + least, c + least);
        let (bc, ca, ab) = (tb * tc, tc * ta, ta * tb);
        let half = L::splat(0.5) / (ta * bc);
        let a = Dd::new(a, (x.hi.remainder(a, a) + x.lo) * (bc * half));
        let b = Dd::new(b, (y.hi.remainder(b, b) + y.lo) * (ca * half));
        let c = Dd::new(c, (z.hi.remainder(c, c) + z.lo) * (ab * half));
        let (sum, sum_error) = two_sum(a.hi, b.hi);
        let (first, first_error) = a.hi.two_product_in_range(b.hi);
        let (second, second_error) = sum.two_product_in_range(c.hi);
        let (shift, error) = two_sum(first, second);
        let rest = (error + (first_error + second_error))
            + a.lo.mul_add(b.hi, a.hi.mul_add(b.lo, sum.mul_add(c.lo, c.hi * (sum_error + (a.lo + b.lo)))));
        Step { roots: [a, b, c], shift: Dd::new(shift, rest) }
    }
    /// Argument and shift together.
    #[inline(always)]
    fn plus(&self, x: Dd<L>) -> Dd<L> {
        let (hi, error) = two_sum(x.hi, self.shift.hi);
        Dd::new(hi, error + (x.lo + self.shift.lo))
    }
}

/// Sum of three.
#[inline(always)]
pub(super) fn total<L: Lane>([x, y, z]: Triple<L>) -> Dd<L> {
    let (first, first_error) = two_sum(x.hi, y.hi);
    let (hi, error) = two_sum(first, z.hi);
    Dd::new(hi, (first_error + error) + (x.lo + y.lo + z.lo))
}

/// Larger of two.
#[inline(always)]
pub(super) fn larger<L: Lane>(a: L, b: L) -> L {
    L::select(a.less(b), b, a)
}

/// The arguments where the mask holds, else others.
#[inline(always)]
pub(super) fn chosen<L: Lane>(mask: L::Mask, yes: Triple<L>, no: Triple<L>) -> Triple<L> {
    [Dd::select(mask, yes[0], no[0]), Dd::select(mask, yes[1], no[1]), Dd::select(mask, yes[2], no[2])]
}

/// The series over the root of the mean: R_F of near arguments.
#[inline(always)]
pub(super) fn near_rf<L: Lane>(at: Triple<L>) -> Dd<L> {
    let (one, minus_three) = (L::splat(1.0), L::splat(-3.0));
    let sum = total(at);
    let root = sum.hi.sqrt();
    let inverse = one / root;
    let square = inverse * inverse;
    let x = at[0].hi.mul_add(minus_three, sum.hi) * square;
    let y = at[1].hi.mul_add(minus_three, sum.hi) * square;
    let z = -(x + y);
    let e2 = x.mul_add(y, -(z * z));
    let series = first_kind(e2, x * y * z);
    // 1/sqrt of the sum to two words, in parts of itself.
    let rest =
        one.remainder(inverse, root) - (sum.hi.remainder(root, root) + sum.lo) * (L::splat(0.5) * square);
    let (hi, error) = inverse.two_product_in_range(L::splat(ROOT_THREE.hi));
    Dd::new(hi, hi.mul_add(series + rest, inverse.mul_add(L::splat(ROOT_THREE.lo), error)))
}

/// R_F as hi + lo.
#[inline(always)]
pub(crate) fn rf<L: Lane>(mut at: Triple<L>) -> Dd<L> {
    loop {
        let sum = (at[0].hi + at[1].hi) + at[2].hi;
        let three = L::splat(-3.0);
        let far = larger(at[0].hi.mul_add(three, sum).abs(), at[1].hi.mul_add(three, sum).abs());
        let far = larger(far, at[2].hi.mul_add(three, sum).abs());
        let further = (sum * L::splat(NEAR)).less(far);
        if !L::any(further) {
            return near_rf(at);
        }
        let step = Step::new(at);
        let quarter = L::splat(0.25);
        let next = [
            step.plus(at[0]).scale(quarter),
            step.plus(at[1]).scale(quarter),
            step.plus(at[2]).scale(quarter),
        ];
        at = chosen::<L>(further, next, at);
    }
}

/// R_F and R_D/3 of the same arguments, z the one that counts three times.
#[inline(always)]
pub(crate) fn rf_and_rd<L: Lane>(mut at: Triple<L>) -> (Dd<L>, Dd<L>) {
    let (mut sum, mut power) = (Dd::from_double(L::splat(0.0)), L::splat(1.0));
    let (one, quarter, five) = (L::splat(1.0), L::splat(0.25), L::splat(-5.0));
    loop {
        let [x, y, z] = [at[0].hi, at[1].hi, at[2].hi];
        let mean = z.mul_add(L::splat(3.0), x + y);
        let far = larger(x.mul_add(five, mean).abs(), y.mul_add(five, mean).abs());
        let far = larger(far, z.mul_add(five, mean).abs());
        let further = (mean * L::splat(NEAR_OF_FIVE)).less(far);
        if !L::any(further) {
            break;
        }
        let step = Step::new(at);
        let last = step.plus(at[2]);
        // power/(sqrt z (z + shift)).
        let root = step.roots[2];
        let (product, error) = root.hi.two_product_in_range(last.hi);
        let inverse = one / product;
        let rest = one.remainder(inverse, product)
            - root.hi.mul_add(last.lo, root.lo.mul_add(last.hi, error)) * inverse;
        let term = inverse * power;
        let (hi, error) = two_sum(sum.hi, term);
        let grown = Dd::new(hi, sum.lo + term.mul_add(rest, error));
        let next = [step.plus(at[0]).scale(quarter), step.plus(at[1]).scale(quarter), last.scale(quarter)];
        at = chosen::<L>(further, next, at);
        sum = Dd::select(further, grown, sum);
        power = L::select(further, power * quarter, power);
    }
    let mean = total(at);
    let (hi, error) = two_sum(mean.hi, at[2].hi + at[2].hi);
    let mean = Dd::new(hi, error + (mean.lo + (at[2].lo + at[2].lo)));
    let inverse = one / mean.hi;
    let dx = at[0].hi.mul_add(five, mean.hi) * inverse;
    let dy = at[1].hi.mul_add(five, mean.hi) * inverse;
    let dz = (dx + dy) * L::splat(-1.0 / 3.0);
    let (xy, zz) = (dx * dy, dz * dz);
    let e2 = zz.mul_add(L::splat(-6.0), xy);
    let e3 = zz.mul_add(L::splat(-8.0), xy * L::splat(3.0)) * dz;
    let e4 = (xy - zz) * zz * L::splat(3.0);
    let e5 = xy * zz * dz;
    (near_rf(at), sum_of_five(sum, power, mean, third_kind(e2, e3, e4, e5)))
}

/// The sum of the steps of R_D or R_J, over 3, and behind them power (1 + series)/(3 A^(3/2)) with 5 A = `mean`.
#[inline(always)]
pub(super) fn sum_of_five<L: Lane>(sum: Dd<L>, power: L, mean: Dd<L>, series: L) -> Dd<L> {
    let one = L::splat(1.0);
    let root = mean.hi.sqrt();
    let (cube, cube_error) = mean.hi.two_product_in_range(root);
    let inverse = one / cube;
    let root_rest = (mean.hi.remainder(root, root) + mean.lo) * (L::splat(0.5) * mean.hi * inverse);
    let cube_rest = mean.hi.mul_add(root_rest, mean.lo.mul_add(root, cube_error));
    let rest = one.remainder(inverse, cube) - cube_rest * inverse;
    let (lead, lead_error) = inverse.two_product_in_range(L::splat(FIVE_ROOT_FIVE_THIRDS.hi));
    let rest = lead.mul_add(series + rest, inverse.mul_add(L::splat(FIVE_ROOT_FIVE_THIRDS.lo), lead_error));
    let (hi, error) = two_sum(sum.hi, lead * power);
    Dd::new(hi, error + rest.mul_add(power, sum.lo))
}

//! The phase of a motion in half periods, reduced to its nearest whole number.
//!
//! f = t rate + start with rate and start in double-double: the fraction keeps 2^-104 of the count, so a
//! billion periods cost no digits. Beyond 2^53 half periods the answer is NaN.
//! Source: the two-product form of Cody & Waite's reduction.

use crate::float::Dd;
use crate::float::double_double::two_sum;
use crate::lanes::Lane;

/// Half periods per unit of the argument, and at its zero.
#[derive(Clone, Copy, Debug)]
pub struct Phase {
    /// Half periods per unit.
    pub rate: Dd,
    /// Half periods at zero.
    pub start: Dd,
}

/// n + sign * f half periods.
pub struct Reduced<L: Lane> {
    /// Nearest whole number of half periods.
    pub n: L,
    /// +1 or -1: the sign of the rest.
    pub sign: L,
    /// Size of the rest, in [0, 1/2].
    pub f: Dd<L>,
    /// (-1)^n.
    pub parity: L,
}

impl Phase {
    /// The reduced phase at t.
    #[inline(always)]
    pub fn reduce<L: Lane>(&self, t: L) -> Reduced<L> {
        let (turned, error) = t.two_product(L::splat(self.rate.hi));
        let error = t.mul_add(L::splat(self.rate.lo), error);
        let whole = turned.round();
        let (part, part_error) = two_sum(turned - whole, L::splat(self.start.hi));
        let (part, rest) = two_sum(part, error);
        let carry = part.round();
        let rest = rest + (part_error + L::splat(self.start.lo));
        let f = Dd::ordered_sum(part - carry, rest);
        let n = whole + carry;
        let within = turned.abs().less(L::splat(9_007_199_254_740_992.0));
        let f = Dd::new(L::select(within, f.hi, L::splat(f64::NAN)), f.lo);
        let sign = L::splat(1.0).copysign(f.hi);
        let halves = n * L::splat(0.5);
        let even = halves.equal(halves.round());
        let parity = L::select(even, L::splat(1.0), L::splat(-1.0));
        Reduced { n, sign, f: f.scale(sign), parity }
    }
}

//! A parameter of any real m per lane, with the one in [0, 1] that carries it, and the class of its formula.
//!
//! m itself; -m/(1 - m) for m < 0; 1/m for m > 1: as [`Parameter::unit`](super::parameter::Parameter).

use super::given::Given;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Formula, Lane};

/// The formula that a parameter asks for.
pub(crate) mod class {
    /// None of the lanes': out of range, or not finite.
    pub const FALLBACK: usize = 0;
    /// The one in [0, 1] is at most 1/2.
    pub const CIRCULAR: usize = 1;
    /// It is above.
    pub const HYPERBOLIC: usize = 2;
    /// m = 1.
    pub const LIMIT: usize = 3;
    /// How many.
    pub const COUNT: usize = 4;
}

/// Where |m| ends, and from where on |1 - m| counts: the errors of products stay in range.
const LARGE: f64 = 1e200;
const SMALL: f64 = 1e-200;

/// The class of a parameter, as it is given.
pub(crate) struct Classify(pub Given);

impl Formula<1, 1> for Classify {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [value]: [L; 1]) -> [L; 1] {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let code = |class: usize| L::splat(class as f64);
        let (m, mc) = self.0.pair(value);
        let (m, mc) = (m.hi, mc.hi);
        let (negative, above) = (m.less(zero), mc.less(zero));
        // In proportion to the parameter in [0, 1] and its complement.
        let part = L::select(negative, -m, L::select(above, one, m));
        let rest = L::select(negative, one, L::select(above, -mc, mc));
        let found = L::select(rest.less(part), code(class::HYPERBOLIC), code(class::CIRCULAR));
        // Every comparison is false for NaN.
        let found = L::select(L::splat(SMALL).less(mc.abs()), found, code(class::FALLBACK));
        let found = L::select(mc.equal(zero), code(class::LIMIT), found);
        [L::select(m.abs().less(L::splat(LARGE)), found, code(class::FALLBACK))]
    }
}

/// The parameter in [0, 1] of every lane, all of one class, and how the given one follows.
pub(crate) struct ParameterLanes<L: Lane> {
    pub m: Unnormalised<L>,
    pub mc: Unnormalised<L>,
    /// What u is multiplied by: the root of mc for m < 0, of m for m > 1, else 1.
    pub factor: Unnormalised<L>,
    pub negative: L::Mask,
    pub above: L::Mask,
    /// Whether any is below 0 or above 1. Where it is not, what they ask for may be left out: it changes no other lane.
    pub outside: bool,
}

impl<L: Lane> ParameterLanes<L> {
    /// Of values that [`Classify`] takes.
    #[inline(always)]
    pub fn new(given: Given, value: L) -> Self {
        let zero = L::splat(0.0);
        let (m, mc) = given.pair(value);
        let (m, mc) = (Unnormalised::from(m), Unnormalised::from(mc));
        let one = Unnormalised::from_double(L::splat(1.0));
        let (negative, above) = (m.hi.less(zero), mc.hi.less(zero));
        let outside = L::any(negative) || L::any(above);
        if !outside {
            return ParameterLanes { m, mc, factor: one, negative, above, outside };
        }
        let large = Unnormalised::select(negative, mc, Unnormalised::select(above, m, one));
        let (inverse, root) = (large.inverse(), large.root());
        let of_above = Unnormalised::select(above, inverse, m);
        let unit = Unnormalised::select(negative, -(m * inverse), of_above);
        let complement_above = Unnormalised::select(above, -(mc * inverse), mc);
        let complement = Unnormalised::select(negative, inverse, complement_above);
        ParameterLanes { m: unit, mc: complement, factor: root, negative, above, outside }
    }
}

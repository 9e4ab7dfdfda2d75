//! The parameter m = k^2 together with its complement mc = 1 - m, each formed from what was given without
//! subtracting: near the separatrix 1 - m formed from a rounded m has no digits left.

use crate::float::{Dd, Scaled};

/// The parameter m = k^2 and its complement mc = 1 - m, both with all their digits.
///
/// Whichever is given is exact. A parameter that is not finite makes every function NaN.
///
/// **Source** DLMF 19.2.8, 22.2; A&S 17.2.
///
/// ```
/// use libration::{Parameter, complete_k};
/// // m would round to 1, where K is infinite.
/// assert_eq!(format!("{:.10}", complete_k(Parameter::from_mc(1e-20))), "24.4121452911");
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    pub(crate) m: Dd,
    pub(crate) mc: Dd,
    /// The modulus, where it was given and its square has no full digits as a double-double; else 0.
    small_modulus: f64,
}

/// Below, the square of the modulus is next to the subnormal numbers.
const SMALL_MODULUS: f64 = 1e-140;

impl Parameter {
    /// From both, m + mc = 1.
    pub(crate) fn new(m: Dd, mc: Dd) -> Parameter {
        Parameter { m, mc, small_modulus: 0.0 }
    }
    /// From the parameter m, any real number.
    #[must_use]
    pub fn from_m(m: f64) -> Parameter {
        Parameter::new(Dd::from(m), Dd::sum(1.0, -m)).checked(m)
    }
    /// From the complement mc = 1 - m, any real number.
    #[must_use]
    pub fn from_mc(mc: f64) -> Parameter {
        Parameter::new(Dd::sum(1.0, -mc), Dd::from(mc)).checked(mc)
    }
    /// From the modulus k, |k| <= 1e150, else NaN; only m = k^2 counts.
    #[must_use]
    pub fn from_modulus(k: f64) -> Parameter {
        let (m, mc) = (Dd::product(k, k), Dd::sum(1.0, -k) * Dd::sum(1.0, k));
        let small_modulus = if k.abs() < SMALL_MODULUS { k.abs() } else { 0.0 };
        Parameter { m, mc, small_modulus }.checked(if k.abs() <= 1e150 { k } else { f64::NAN })
    }
    /// The parameter, rounded.
    #[must_use]
    pub fn m(&self) -> f64 {
        self.m.value()
    }
    /// Its complement, rounded.
    #[must_use]
    pub fn mc(&self) -> f64 {
        self.mc.value()
    }
    fn checked(self, given: f64) -> Parameter {
        let nan = Dd::from(f64::NAN);
        if given.is_finite() { self } else { Parameter::new(nan, nan) }
    }
    /// m with all digits, also where it is below the range of doubles.
    pub(crate) fn long_m(self) -> Scaled {
        if self.small_modulus > 0.0 {
            Scaled::from(self.small_modulus).square()
        } else {
            Scaled::from(self.m)
        }
    }
    /// Where it lies.
    pub(crate) fn range(self) -> ParameterRange {
        if self.m.hi < 0.0 {
            ParameterRange::Negative
        } else if self.mc.hi < 0.0 {
            ParameterRange::AboveOne
        } else if self.mc.hi == 0.0 {
            ParameterRange::One
        } else {
            ParameterRange::BelowOne
        }
    }
    /// What u is multiplied by where the parameter is the one in [0, 1]: sqrt(mc), 1 or sqrt(m).
    pub(crate) fn argument_factor(self) -> Dd {
        match self.range() {
            ParameterRange::Negative => self.mc.sqrt(),
            ParameterRange::AboveOne => self.m.sqrt(),
            _ => Dd::ONE,
        }
    }
    /// The parameter in [0, 1] that carries this one: m itself; -m/(1 - m) for m < 0; 1/m for m > 1. The moduli
    /// come from roots of what was given, because the squares of their inverses may be below the range.
    pub(crate) fn unit(self) -> Unit {
        let Parameter { m, mc, small_modulus } = self;
        if m.hi < 0.0 {
            let root = mc.sqrt();
            Unit { m: -m / mc, mc: Dd::ONE / mc, k: (-m).sqrt() / root, kc: Dd::ONE / root }
        } else if mc.hi < 0.0 {
            let root = m.sqrt();
            Unit { m: Dd::ONE / m, mc: -mc / m, k: Dd::ONE / root, kc: (-mc).sqrt() / root }
        } else {
            let k = if small_modulus > 0.0 { Dd::from(small_modulus) } else { m.sqrt() };
            Unit { m, mc, k, kc: mc.sqrt() }
        }
    }
}

/// Where a parameter lies, which decides the formula.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum ParameterRange {
    /// m < 0.
    Negative,
    /// 0 <= m < 1, or NaN.
    BelowOne,
    /// m = 1: hyperbolic functions.
    One,
    /// m > 1: am is bounded.
    AboveOne,
}

/// A parameter in [0, 1] with its modulus and complementary modulus: the moduli have all digits, also where their squares
/// are below the normal numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Unit {
    pub m: Dd,
    pub mc: Dd,
    pub k: Dd,
    pub kc: Dd,
}

impl Unit {
    /// m = 0: sine and cosine.
    pub const ZERO: Unit = Unit { m: Dd::ZERO, mc: Dd::ONE, k: Dd::ZERO, kc: Dd::ONE };

    /// As a parameter.
    pub fn parameter(self) -> Parameter {
        Parameter::new(self.m, self.mc)
    }
}

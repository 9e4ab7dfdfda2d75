//! The parameter m = k^2 together with its complement mc = 1 - m, each formed from what was given without
//! subtracting: near the separatrix 1 - m formed from a rounded m has no digits left.

use crate::float::Dd;

/// m and mc as double-doubles; m + mc = 1 to 2^-106.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    pub(crate) m: Dd,
    pub(crate) mc: Dd,
}

impl Parameter {
    /// From the parameter m, any real number.
    pub fn from_m(m: f64) -> Parameter {
        Parameter { m: Dd::from(m), mc: Dd::sum(1.0, -m) }.checked(m)
    }
    /// From the complement mc = 1 - m, any real number.
    pub fn from_mc(mc: f64) -> Parameter {
        Parameter { m: Dd::sum(1.0, -mc), mc: Dd::from(mc) }.checked(mc)
    }
    /// From the modulus k, |k| < 1e150; only k^2 counts.
    pub fn from_modulus(k: f64) -> Parameter {
        let mc = Dd::sum(1.0, -k) * Dd::sum(1.0, k);
        Parameter { m: Dd::product(k, k), mc }.checked(if k.abs() < 1e150 { k } else { f64::NAN })
    }
    /// The parameter, rounded.
    pub fn m(&self) -> f64 {
        self.m.value()
    }
    /// Its complement, rounded.
    pub fn mc(&self) -> f64 {
        self.mc.value()
    }
    fn checked(self, given: f64) -> Parameter {
        if given.is_finite() { self } else { Parameter { m: Dd::from(f64::NAN), mc: Dd::from(f64::NAN) } }
    }
    /// m' = -m/(1 - m) with its complement 1/(1 - m), for m < 0: in (0, 1).
    pub(crate) fn imaginary_modulus(self) -> Parameter {
        Parameter { m: -self.m / self.mc, mc: Dd::ONE / self.mc }
    }
    /// 1/m with its complement (m - 1)/m, for m > 1: in (0, 1).
    pub(crate) fn reciprocal(self) -> Parameter {
        Parameter { m: Dd::ONE / self.m, mc: -self.mc / self.m }
    }
}

//! Two solutions of the variational equation y'' = -cos(theta) y along the canonical motion, at its phase u, in units of
//! omega0 (kappa omega0 in rotation), with a' = -b, p' = q and a q + b p = 1:
//!   libration   a = cn,    b = sn dn,      p = cn int_0^u nc^2 = (sn dn - cn int_0^u m cn^2)/mc,
//!   rotation    a = dn,    b = m sn cn,    p = dn int_0^u nd^2,  both of the parameter m in [0, 1],
//!   separatrix  a = sech,  b = sech tanh,  p = (sinh u + u sech u)/2.
//! The integrals are Carlson forms whose terms are all positive, between the nearest quarter periods; n half periods add
//! n times a constant times a. Source: DLMF 22.13(i), 22.16(ii), 19.25(i).

use crate::elliptic::integrals::carlson_duplication::{THIRD, rd, rf};
use crate::elliptic::parameter::Parameter;
use crate::elliptic::phase::{Phase, ReducedPhase};
use crate::elliptic::theta::neville::NevilleTheta;
use crate::float::{Dd, Scaled};

/// The two solutions at a phase; next to the top they leave the range of the doubles.
#[derive(Clone, Copy, Debug)]
pub(super) struct Solutions {
    pub a: Scaled,
    pub b: Scaled,
    pub p: Scaled,
    pub q: Scaled,
}

/// A motion that theta functions describe.
#[derive(Clone, Debug)]
pub(super) struct Periodic {
    pub rotation: bool,
    pub parameter: Parameter,
    pub lattice: NevilleTheta,
    /// What a half period adds to p/a.
    pub shift: Scaled,
}

/// How the derivatives of an orbit follow from the solutions.
#[derive(Clone, Copy, Debug)]
pub(super) struct VariationalSetUp {
    pub phase: Phase,
    /// Factor that brings t into the range where the phase is formed.
    pub time_scale: f64,
    /// The solutions at t = 0.
    pub solutions: Solutions,
    /// Time runs so much faster than omega0 t: 1, or kappa in rotation.
    pub stretch: Dd,
    /// kappa and velocity0/2 omega0, over 2^power.
    pub k: Dd,
    pub x: Dd,
    pub power: i32,
    pub omega: Scaled,
    pub side: f64,
}

impl Solutions {
    /// At phase 0.
    pub const ORIGIN: Solutions =
        Solutions { a: Scaled::ONE, b: Scaled::ZERO, p: Scaled::ZERO, q: Scaled::ONE };
}

/// Where dn is smaller, 1 is lost beside its inverse square.
const TOP: f64 = 1e-60;

/// p and q next to the top, where a and b are as on the separatrix, but for the size of cn beside dn.
fn top([sn, cn, dn]: [Dd; 3]) -> [Scaled; 2] {
    let q = Scaled::ONE / Scaled::from(dn + cn);
    [q * Scaled::from(sn), q]
}

/// m int cn^2 from 0 to the u of sn, cn, dn.
pub(super) fn cosine_integral(m: Dd, [sn, cn, dn]: [Dd; 3]) -> Dd {
    let (s2, c2, d2) = (sn.square(), cn.square(), dn.square());
    m * sn * (rf(c2, d2, Dd::ONE) - s2 * THIRD * rd(c2, d2, Dd::ONE))
}

/// p and q of a libration between the quarter periods.
fn libration(Parameter { m, mc, .. }: Parameter, values: [Dd; 3]) -> [Scaled; 2] {
    let [sn, cn, dn] = values;
    if dn.hi < TOP {
        return top(values);
    }
    let (s2, c2, d2) = (sn.square(), cn.square(), dn.square());
    if m.hi > 0.5 && c2.hi > mc.hi {
        let integral = sn * (rf(c2, d2, Dd::ONE) + s2 * THIRD * rd(Dd::ONE, d2, c2));
        return [cn * integral, Dd::ONE / cn - sn * dn * integral].map(Scaled::from);
    }
    // The integral of nc^2 has a pole at the quarter period; that of cn^2 has none, and mc is not small beside cn^2.
    let integral = cosine_integral(m, values);
    [(sn * dn - cn * integral) / mc, (sn * dn * integral + cn * (mc - m * s2)) / mc].map(Scaled::from)
}

/// p and q of a rotation between the quarter periods.
fn rotation(Parameter { m, .. }: Parameter, values: [Dd; 3]) -> [Scaled; 2] {
    let [sn, cn, dn] = values;
    if dn.hi < TOP {
        return top(values);
    }
    let (s2, c2, d2) = (sn.square(), cn.square(), dn.square());
    let integral = sn * (rf(c2, d2, Dd::ONE) + m * s2 * THIRD * rd(c2, Dd::ONE, d2));
    [dn * integral, Dd::ONE / dn - m * sn * cn * integral].map(Scaled::from)
}

/// Beyond, everything is out of the doubles.
const FAR: f64 = 1e7;

/// rate t, held where it is far out.
pub(super) fn bounded(rate: Dd, t: f64) -> Dd {
    if (rate.hi * t).abs() < FAR { rate * t } else { Dd::from(FAR.copysign(t)) }
}

/// The solutions on the separatrix.
pub(super) fn on_separatrix(y: Dd) -> Solutions {
    let y = Scaled::from(y);
    let (sinh, cosh) = y.sinh_cosh();
    let a = Scaled::ONE / cosh;
    let b = a.square() * sinh;
    Solutions { a, b, p: (sinh + y * a).shift(-1), q: (cosh + a - y * b).shift(-1) }
}

impl Periodic {
    /// At sn, cn, dn between the quarter periods.
    pub fn solutions(&self, values: [Dd; 3]) -> Solutions {
        let [sn, cn, dn] = values;
        let (a, b, [p, q]) = if self.rotation {
            (dn, self.parameter.m * sn * cn, rotation(self.parameter, values))
        } else {
            (cn, sn * dn, libration(self.parameter, values))
        };
        Solutions { a: a.into(), b: b.into(), p, q }
    }

    /// At a reduced phase.
    pub fn at(&self, at: ReducedPhase<f64>) -> Solutions {
        let values = self.lattice.long_values(&ReducedPhase { parity: 1.0, ..at });
        let Solutions { a, b, p, q } = self.solutions(values);
        let periods = self.shift * Scaled::from(at.n);
        let sign = if self.rotation { 1.0 } else { at.parity };
        Solutions { a: a * sign, b: b * sign, p: (p + periods * a) * sign, q: (q - periods * b) * sign }
    }
}

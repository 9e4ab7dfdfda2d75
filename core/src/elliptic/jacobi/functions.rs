//! Jacobi's sn, cn, dn and the unwrapped amplitude am, together, for any real u and any real m.
//!
//! Method: quotients of theta functions (theta.rs) of a parameter in [0, 1], leads as hi + lo. For m < 0
//! the parameter is -m/(1 - m): theta3 and theta4 change places, A becomes k' A and k' its inverse. For m > 1
//! it is 1/m: cn and dn change places. Source: DLMF 22.2, 22.16(i), 22.17.

use crate::elliptic::parameter::{Parameter, Unit};
use crate::elliptic::phase::Phase;
use crate::elliptic::theta::neville::{NevilleTheta, Thetas};
use crate::float::elementary::{arctangent, long_sinh_cosh, quotient, saturated_sinh_cosh, sech};
use crate::float::{Dd, PI, Scaled, scaled};
use crate::lanes::{Formula, Lane, tabulate};

/// Where the parameter lies, which decides the formula.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Range {
    /// m < 0.
    Negative,
    /// 0 <= m < 1.
    Unit,
    /// m = 1: hyperbolic functions.
    One,
    /// m > 1: am is bounded.
    Greater,
}

/// sn, cn, dn, am of one parameter, set up once.
///
/// ```
/// use libration::{Jacobi, Parameter};
/// let (sn, cn, dn, am) = Jacobi::new(Parameter::from_m(0.5)).values(1.0);
/// assert_eq!(format!("{sn:.12} {cn:.12} {dn:.12} {am:.12}"),
///            "0.803001824896 0.595976567672 0.823161001632 0.932315079884");
/// ```
#[derive(Clone, Debug)]
pub struct Jacobi {
    pub(super) range: Range,
    pub(crate) lattice: NevilleTheta,
    pub(crate) phase: Phase,
    /// The factor of theta1 in sn, and in cn counted from K.
    sine: [Dd; 2],
    /// The factor of dn counted from K.
    edge: Dd,
    /// Modulus of the parameter in [0, 1]: 1/k of the given one for m > 1.
    unit_modulus: Dd,
    /// sn u / u at 0.
    slope: Dd,
}

/// |sn| : |cn| : |dn| : 1 = sn : cn : dn : one, and the signs of the first three.
pub(crate) struct Ratio<L: Lane> {
    pub sn: Dd<L>,
    pub cn: Dd<L>,
    pub dn: Dd<L>,
    pub one: Dd<L>,
    pub signs: [L; 3],
}

impl Jacobi {
    /// Sets up one parameter.
    pub fn new(parameter: Parameter) -> Jacobi {
        let Parameter { m, mc, .. } = parameter;
        // Half periods per unit of u: sqrt(mc), 1 or sqrt(m) times 1/2K.
        let (range, stretch) = if m.hi < 0.0 {
            (Range::Negative, mc.sqrt())
        } else if mc.hi < 0.0 {
            (Range::Greater, m.sqrt())
        } else if mc.hi == 0.0 {
            (Range::One, Dd::ONE)
        } else {
            (Range::Unit, Dd::ONE)
        };
        Jacobi::with_range(range, parameter.unit(), stretch)
    }

    /// The functions of stretch * u with a parameter in [0, 1], as they are.
    pub(crate) fn of_unit(unit: Unit, stretch: Dd) -> Jacobi {
        let range = if unit.mc.hi == 0.0 { Range::One } else { Range::Unit };
        Jacobi { slope: stretch, ..Jacobi::with_range(range, unit, stretch) }
    }

    fn with_range(range: Range, unit: Unit, stretch: Dd) -> Jacobi {
        let unit = if range == Range::One { Parameter::from_m(0.0).unit() } else { unit };
        let (k, kc) = (unit.k, unit.kc);
        let lattice = NevilleTheta::new(unit.m, unit.mc, k, kc);
        let (a, edge) = match range {
            Range::Negative => (lattice.theta1_factor * kc, Dd::ONE / kc),
            _ => (lattice.theta1_factor, kc),
        };
        let rate = (stretch / lattice.quarter).scale(0.5);
        let phase = Phase { rate, start: Dd::ZERO };
        Jacobi { range, lattice, phase, sine: [a, a * edge], edge, unit_modulus: k, slope: Dd::ONE }
    }

    /// (sn, cn, dn, am) at u, where am = int_0^u dn: it grows by pi per 2K for m < 1, is the Gudermannian at
    /// m = 1 and stays within its turning points for m > 1.
    ///
    /// Infinite u gives the limits at m = 1, NaN elsewhere, as more than 2^100 half periods do.
    /// **Error** at most 3 ulp (plus 2^-100 of the condition in u).
    pub fn values(&self, u: f64) -> (f64, f64, f64, f64) {
        let [mut sn, mut cn, mut dn, mut am] = [[0.0]; 4];
        Fill { jacobi: self, u: &[u], results: [&mut sn, &mut cn, &mut dn, &mut am] }.run::<false>();
        (sn[0], cn[0], dn[0], am[0])
    }

    /// [`Jacobi::values`] of every u, bit for bit, on the widest lanes, into sn, cn, dn and am; panics where the
    /// lengths differ.
    pub fn values_into(&self, u: &[f64], results: [&mut [f64]; 4]) {
        assert!(
            results.iter().all(|result| result.len() == u.len()),
            "results of another length than the arguments"
        );
        Fill { jacobi: self, u, results }.run::<true>();
    }

    #[inline(always)]
    fn hyperbolic<L: Lane>(&self, u: L) -> [L; 4] {
        let sign = L::splat(1.0).copysign(u);
        let y = Dd::from_double(u.abs());
        let (sinh, cosh) = saturated_sinh_cosh(y);
        let (factor, power) = sech(y);
        let falling = factor.value() * power;
        let am = arctangent(sinh, Dd::from_double(L::splat(1.0)));
        [quotient(sinh, cosh).value() * sign, falling, falling, am.value() * sign]
    }

    #[inline(always)]
    fn elliptic<const HYPERBOLIC: bool, L: Lane>(&self, u: L) -> [L; 4] {
        let (n, Ratio { sn, cn, dn, one, signs }) = self.ratio::<HYPERBOLIC, L>(u);
        let am = if self.range == Range::Greater {
            arctangent(sn, cn).value() * signs[0]
        } else {
            // The sign of the rest: that of sn without the parity, which is the sign of cn.
            let within = arctangent(sn, cn).scale(signs[0] * signs[1]);
            let turned = n * Dd::splat(PI);
            (turned + within).value()
        };
        let sn = quotient(sn, one).value() * signs[0];
        let cn = quotient(cn, one).value() * signs[1];
        let dn = quotient(dn, one).value() * signs[2];
        [sn, cn, dn, am]
    }

    /// The nearest whole number of half periods, and the functions at u.
    #[inline(always)]
    pub(crate) fn ratio<const HYPERBOLIC: bool, L: Lane>(&self, u: L) -> (Dd<L>, Ratio<L>) {
        let at = self.phase.spread::<L>().reduce(u);
        let thetas = self.lattice.thetas_on::<HYPERBOLIC, L>(at.f);
        let folded = thetas.folded;
        let [t1, t2, t3, t4] = thetas.theta;
        let (t3, t4) = if self.range == Range::Negative { (t4, t3) } else { (t3, t4) };
        let sn = Dd::select(folded, t2, t1 * Dd::splat(self.sine[0]));
        let cn = Dd::select(folded, t1 * Dd::splat(self.sine[1]), t2);
        let dn = Dd::select(folded, t4 * Dd::splat(self.edge), t3);
        let one = Dd::select(folded, t3, t4);
        let odd = at.parity * at.sign;
        let positive = L::splat(1.0);
        let ratio = if self.range == Range::Greater {
            let sn = sn * Dd::splat(self.unit_modulus);
            Ratio { sn, cn: dn, dn: cn, one, signs: [odd, positive, at.parity] }
        } else {
            Ratio { sn, cn, dn, one, signs: [odd, at.parity, positive] }
        };
        (at.n, ratio)
    }
}

/// sn : cn : dn : 1 = sn : cn : dn : one to 2^-60, into any range; all are not negative, their signs apart. n is the nearest
/// whole number of half periods.
pub(super) struct LongRatio {
    pub n: Dd,
    pub sn: Scaled,
    pub cn: Scaled,
    pub dn: Scaled,
    pub one: Scaled,
    pub signs: [f64; 3],
}

/// Where e^-2u no longer counts beside 1.
const LEVEL: f64 = 40.0;

impl Jacobi {
    /// The functions at u, for what must not round on the way.
    pub(super) fn long_ratio(&self, u: f64) -> LongRatio {
        let sign = f64::copysign(1.0, u);
        if u.abs() < TINY {
            let sn = Scaled::from(self.slope) * u.abs();
            return LongRatio {
                n: Dd::ZERO,
                sn,
                cn: Scaled::ONE,
                dn: Scaled::ONE,
                one: Scaled::ONE,
                signs: [sign, 1.0, 1.0],
            };
        }
        if self.range == Range::One {
            let y = self.slope * u.abs();
            let (sn, cn, one) = if y.hi < LEVEL {
                let (sinh, cosh) = long_sinh_cosh(y);
                (sinh.into(), Scaled::ONE, cosh.into())
            } else {
                (Scaled::ONE, scaled::exp(-y).shift(1), Scaled::ONE)
            };
            return LongRatio { n: Dd::ZERO, sn, cn, dn: cn, one, signs: [sign, 1.0, 1.0] };
        }
        let mut at = self.phase.reduce(u);
        let beyond = at.f - Dd::from(0.5);
        if beyond.hi > 0.0 {
            // The rest may pass 1/2 by a rounding error: counted from the other side cn is not negative.
            at.n = at.n + Dd::from(at.sign);
            at.f = Dd::from(0.5) - beyond;
            (at.sign, at.parity) = (-at.sign, -at.parity);
        }
        let Thetas { theta: [t1, t2, t3, t4], folded } = self.lattice.long_thetas(at.f);
        let (t3, t4) = if self.range == Range::Negative { (t4, t3) } else { (t3, t4) };
        let (sn, cn, dn, one) = if folded {
            (t2, t1 * self.sine[1], t4 * self.edge, t3)
        } else {
            (t1 * self.sine[0], t2, t3, t4)
        };
        let [sn, cn, dn, one] = [sn, cn, dn, one].map(Scaled::from);
        let odd = at.parity * at.sign;
        if self.range == Range::Greater {
            let sn = sn * Scaled::from(self.unit_modulus);
            LongRatio { n: at.n, sn, cn: dn, dn: cn, one, signs: [odd, 1.0, at.parity] }
        } else {
            LongRatio { n: at.n, sn, cn, dn, one, signs: [odd, at.parity, 1.0] }
        }
    }
}

/// Below, sn and am are u for every finite m, to a double-double.
pub(super) const TINY: f64 = 1e-290;

/// Where u^2 counts no more sn and am are u, down to the sign of zero; NaN stays NaN.
#[inline(always)]
fn odd<L: Lane>(u: L, [sn, cn, dn, am]: [L; 4]) -> [L; 4] {
    let tiny = u.abs().less(L::splat(TINY));
    let small = |value: L| L::select(tiny, u - value.abs() * L::splat(0.0), value);
    [small(sn), cn, dn, small(am)]
}

struct Doubly<'a, const HYPERBOLIC: bool>(&'a Jacobi);

impl<const HYPERBOLIC: bool> Formula<1, 4> for Doubly<'_, HYPERBOLIC> {
    #[inline(always)]
    fn at<L: Lane>(&self, [u]: [L; 1]) -> [L; 4] {
        odd(u, self.0.elliptic::<HYPERBOLIC, L>(u))
    }
}

struct Singly<'a>(&'a Jacobi);

impl Formula<1, 4> for Singly<'_> {
    #[inline(always)]
    fn at<L: Lane>(&self, [u]: [L; 1]) -> [L; 4] {
        odd(u, self.0.hyperbolic(u))
    }
}

/// Arguments into slices of results of the same length.
struct Fill<'a, 'b> {
    jacobi: &'a Jacobi,
    u: &'a [f64],
    results: [&'b mut [f64]; 4],
}

impl Fill<'_, '_> {
    fn run<const WIDE: bool>(mut self) {
        let (jacobi, u, results) = (self.jacobi, self.u, &mut self.results);
        if jacobi.range == Range::One {
            tabulate::<WIDE, _, _, _, _>(&Singly(jacobi), [u], results);
        } else if jacobi.lattice.hyperbolic() {
            tabulate::<WIDE, _, _, _, _>(&Doubly::<true>(jacobi), [u], results);
        } else {
            tabulate::<WIDE, _, _, _, _>(&Doubly::<false>(jacobi), [u], results);
        }
    }
}

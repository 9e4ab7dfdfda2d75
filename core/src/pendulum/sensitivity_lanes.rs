//! The derivatives of one orbit over lanes, in double: for all but the neighbours of the separatrix and the ends of range.
//!
//! The two solutions of variational.rs from the integral g = m int cn^2 = u (E/K - mc) + Z(u), with Jacobi's zeta as the slope
//! of ln theta4:
//!   libration  p = (sn dn - cn g)/mc,              q = (sn dn g + cn (mc - m sn^2))/mc,
//!   rotation   p = (dn (mc u + g) - m sn cn)/mc,   q = (1 - b p)/a.
//! What cancels is 1/mc times larger than the result, so mc is bounded below. Source: DLMF 22.16(ii), 22.16.32, 20.2.

use super::variational::{Periodic, Solutions, VariationalSetUp};
use crate::elliptic::integrals::complete::complete_difference_dd;
use crate::elliptic::parameter::Parameter;
use crate::elliptic::phase::{LAST_HALF_PERIOD, Phase, alternating};
use crate::elliptic::theta::neville::NevilleTheta;
use crate::float::{HALF_PI, PI, Scaled};
use crate::lanes::{Evaluation, Formula, Lane};

/// Least 1 - m: below, too many of a double's digits cancel.
const LEAST_COMPLEMENT: f64 = 1e-3;
/// Most powers of two in omega0, and largest kappa.
const ORDINARY: i32 = 300;
const ORDINARY_RATIO: f64 = 1e15;

/// What the samples of one orbit share, in double.
#[derive(Clone, Debug)]
pub(super) struct SensitivityLanes {
    rotation: bool,
    lattice: NevilleTheta,
    phase: Phase,
    time_scale: f64,
    last: f64,
    m: f64,
    mc: f64,
    /// 1/mc, 1 over the stretch of time, and 1/omega0: a product costs less than a quotient.
    inverses: [f64; 3],
    /// 2K, and E - mc K.
    half_period: f64,
    whole: f64,
    /// g = near u + zeta Z' towards 0, g = whole + far w - zeta Z' towards K.
    near: f64,
    far: f64,
    zeta: f64,
    /// What a half period adds to p/a.
    shift: f64,
    start: [f64; 4],
    /// kappa, velocity0/2 omega0, time's stretch, omega0 and the side.
    k: f64,
    x: f64,
    stretch: f64,
    omega: f64,
    side: f64,
}

impl SensitivityLanes {
    /// `None` next to the separatrix, and for orbits of extreme size.
    pub fn new(start: &VariationalSetUp, periodic: &Periodic) -> Option<SensitivityLanes> {
        let &Periodic { rotation, parameter, ref lattice, .. } = periodic;
        let &VariationalSetUp { k, x, power, stretch, omega, omega_power, .. } = start;
        let Parameter { m, mc, .. } = parameter;
        let ordinary = power == 0 && omega_power.abs() <= ORDINARY && k.hi <= ORDINARY_RATIO;
        if mc.hi < LEAST_COMPLEMENT || !ordinary {
            return None;
        }
        let other = Parameter::new(mc, m);
        let (quarter, whole) = (lattice.quarter, complete_difference_dd(parameter));
        let e = whole + mc * quarter;
        let (near, far, zeta) = if lattice.hyperbolic() {
            // The angle of a half period is pi K/K': E/K - mc less pi/2KK' is -(E' - m K')/K', by Legendre's relation.
            let other_quarter = PI * quarter / lattice.angle;
            let slow = complete_difference_dd(other) / other_quarter;
            (-slow, slow, HALF_PI / other_quarter)
        } else {
            let mean = e / quarter - mc;
            (mean, -mean, HALF_PI / quarter)
        };
        let Solutions { a, b, p, q } = start.solutions;
        Some(SensitivityLanes {
            rotation,
            lattice: lattice.clone(),
            phase: start.phase,
            time_scale: start.time_scale,
            last: if rotation { 0.5 * LAST_HALF_PERIOD } else { LAST_HALF_PERIOD },
            m: m.hi,
            mc: mc.hi,
            inverses: [mc.hi, stretch.hi, omega.ldexp(omega_power).hi].map(|value| 1.0 / value),
            half_period: quarter.scale(2.0).hi,
            whole: whole.hi,
            near: near.hi,
            far: far.hi,
            zeta: zeta.hi,
            shift: periodic.shift.value(),
            start: [a, b, p, q].map(Scaled::value),
            k: k.hi,
            x: x.hi,
            stretch: stretch.hi,
            omega: omega.ldexp(omega_power).hi,
            side: start.side,
        })
    }

    /// The answer of the formula of this orbit: the derivatives row by row.
    pub fn evaluated<E: Evaluation<1, 6>>(&self, evaluation: E) -> E::Output {
        match (self.rotation, self.lattice.hyperbolic()) {
            (false, false) => evaluation.of(&Derivatives::<false, false>(self)),
            (false, true) => evaluation.of(&Derivatives::<false, true>(self)),
            (true, false) => evaluation.of(&Derivatives::<true, false>(self)),
            (true, true) => evaluation.of(&Derivatives::<true, true>(self)),
        }
    }

    #[inline(always)]
    fn at<const ROTATION: bool, const HYPERBOLIC: bool, L: Lane>(&self, t: L) -> [L; 6] {
        let constant = |value: f64| L::splat(value);
        let passed = t * constant(self.time_scale);
        let (n, f) = self.phase.spread::<L>().count(passed, self.last);
        let sign = constant(1.0).copysign(f.hi);
        let f = f.scale(sign);
        let ([sn, cn, dn], folded, slope) = self.lattice.short_values::<HYPERBOLIC, L>(f);
        let u = f.hi * constant(self.half_period);
        let from_top = (constant(0.5) - f.hi) * constant(self.half_period);
        let zeta = slope * constant(self.zeta);
        let near = u.mul_add(constant(self.near), zeta);
        let far = from_top.mul_add(constant(self.far), constant(self.whole)) - zeta;
        let g = L::select(folded, far, near);
        let [over, per_stretch, per_omega] = self.inverses;
        let (m, mc, over) = (constant(self.m), constant(self.mc), constant(over));
        let (a, b, p, q) = if ROTATION {
            let (a, b) = (dn, m * sn * cn);
            let p = (dn * mc.mul_add(u, g) - b) * over;
            (a, b, p, (constant(1.0) - b * p) / a)
        } else {
            let b = sn * dn;
            (cn, b, (b - cn * g) * over, b.mul_add(g, cn * (mc - m * sn * sn)) * over)
        };
        let (b, p) = (b * sign, p * sign);
        let shift = n * constant(self.shift);
        let (p, q) = (shift.mul_add(a, p), q - shift * b);
        let (a, b, p, q) = if ROTATION {
            (a, b, p, q)
        } else {
            let parity = alternating(n);
            (a * parity, b * parity, p * parity, q * parity)
        };
        // Not by `map`, which would be compiled without the instruction set.
        let [a0, b0, p0, q0] = self.start;
        let (a0, b0, p0, q0) = (constant(a0), constant(b0), constant(p0), constant(q0));
        let (k, x, stretch, omega) =
            (constant(self.k), constant(self.x), constant(self.stretch), constant(self.omega));
        let by_velocity = (a0 * p - p0 * a) * constant(per_stretch);
        let rate_by_velocity = a0.mul_add(q, p0 * b);
        let turned = omega * passed;
        let twice = constant(2.0 * self.side);
        let ka = k * a;
        let values = [
            a.mul_add(q0, p * b0),
            by_velocity * constant(per_omega),
            twice * (ka * turned - x * by_velocity) * constant(per_omega),
            stretch * omega * (q * b0 - b * q0),
            rate_by_velocity,
            twice * (ka - stretch * k * b * turned - x * rate_by_velocity),
        ];
        let start = t.equal(constant(0.0));
        let mut derivatives = [constant(0.0); 6];
        for (i, (derivative, value)) in derivatives.iter_mut().zip(values).enumerate() {
            *derivative = L::select(start, constant(if i == 0 || i == 4 { 1.0 } else { 0.0 }), value);
        }
        derivatives
    }
}

/// The derivatives of a libration or a rotation, on the circular or the hyperbolic side of the theta functions.
struct Derivatives<'a, const ROTATION: bool, const HYPERBOLIC: bool>(&'a SensitivityLanes);

impl<const ROTATION: bool, const HYPERBOLIC: bool> Formula<1, 6> for Derivatives<'_, ROTATION, HYPERBOLIC> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 6] {
        self.0.at::<ROTATION, HYPERBOLIC, L>(t)
    }
}

//! u = A times an elementary function: the exact boundaries without a quintic force, over lanes.
//!
//! Of y = start + rate t: sech, tanh, csch, coth, 1/y (NaN for y <= 0, beyond the pole), cosh, sinh and e^-y; and the
//! straight line u0 + velocity0 t. They are what M = l C^2 + m S^2 (elementary.rs) leaves where v = 0 is a root of C(v).
//! Source: DLMF 4.34.

use super::elementary::{Elementary, Functions, Sum};
use crate::elliptic::phase::Phase;
use crate::float::Dd;
use crate::float::elementary::{exp, quotient, saturated_sinh_cosh, sech};
use crate::float::scaled::{Scaled, over_common_power};
use crate::lanes::{Formula, Lane};

/// The function that u is.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Function {
    Sech,
    Tanh,
    Csch,
    Coth,
    /// 1/y.
    Inverse,
    Cosh,
    Sinh,
    /// e^-y.
    Exponential,
}

/// A function with its amplitudes: factors over powers of two.
#[derive(Clone, Debug)]
pub(super) struct PqElementary {
    function: Function,
    phase: Phase,
    u: Dd,
    velocity: Dd,
    /// Powers of two of u and u'.
    scales: [f64; 2],
    /// Power of two that times take.
    time: f64,
}

/// No motion, or a straight line.
pub(super) struct Line {
    pub u0: f64,
    pub velocity0: f64,
    pub moves: bool,
}

/// Where both exponentials no longer matter.
const LARGE: f64 = 40.0;
/// Exponentials are taken in two halves, each in range.
const HALF_END: f64 = 690.0;
impl PqElementary {
    /// Of a motion without a quintic force; `None` for the straight line.
    pub fn new(given: &Elementary) -> Option<PqElementary> {
        let pole = given.pole.is_some();
        let (function, square) = match given.sum {
            Sum::Squares { functions: Functions::Tanh, odd: true, l, m } => {
                if m.is_zero() {
                    (Function::Sinh, l)
                } else {
                    (Function::Tanh, m)
                }
            }
            Sum::Squares { functions: Functions::Tanh, odd: false, l, m } => {
                if pole {
                    (Function::Coth, m)
                } else {
                    (Function::Cosh, l)
                }
            }
            Sum::Squares { functions: Functions::Sinh, l, .. } => {
                (if pole { Function::Csch } else { Function::Sech }, l)
            }
            Sum::Squares { functions: Functions::Power, l, .. } if pole => (Function::Inverse, l),
            Sum::Exponential { l, .. } => (Function::Exponential, l),
            _ => return None,
        };
        let amplitude = (Scaled::ONE / square.sqrt()).signed(given.sign);
        let [start, rate] = given.base;
        let ([u], u_scale) = over_common_power([amplitude]);
        let ([velocity], velocity_scale) = over_common_power([amplitude * rate]);
        let (rate, time) = rate.carried();
        let phase = Phase { rate, start: start.to_dd() };
        Some(PqElementary { function, phase, u, velocity, scales: [u_scale, velocity_scale], time })
    }
}

/// A e^y scale / 2 for y >= 0, to infinity without a stop on the way.
#[inline(always)]
fn half_exponential<L: Lane>(y: Dd<L>, amplitude: Dd, scale: f64) -> L {
    let half = y.scale(L::splat(0.5));
    let beyond = L::splat(HALF_END).less(half.hi);
    let e = exp(Dd::select(beyond, Dd::from_double(L::splat(HALF_END)), half));
    let first = (e * Dd::splat(amplitude)).scale(L::splat(0.5 * scale));
    let value = (first * e).value();
    // A product beyond the range is infinity minus infinity in its second word.
    let plain = first.hi * e.hi;
    L::select(plain.abs().less(L::splat(f64::MAX)), value, plain)
}

/// A e^y scale for any y of that size.
#[inline(always)]
fn exponential<L: Lane>(y: Dd<L>, size: Dd<L>, amplitude: Dd, scale: f64) -> L {
    let near = size.hi.less(L::splat(LARGE));
    let small = exp(Dd::select(near, y, Dd::from_double(L::splat(0.0))));
    let value = (small * Dd::splat(amplitude)).value() * L::splat(scale);
    let far = half_exponential(size, amplitude, scale) * L::splat(2.0);
    // Far below, e^-y is half of sech y.
    let (falling, power) = sech(size);
    let low = (falling * Dd::splat(amplitude)).value() * L::splat(0.5) * L::splat(scale) * power;
    L::select(near, value, L::select(L::splat(0.0).less(y.hi), far, low))
}

impl Formula<1, 2> for PqElementary {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let scaled = t * L::splat(self.time);
        let y = if self.function == Function::Inverse {
            self.phase.counted(scaled)
        } else {
            self.phase.held(scaled)
        };
        let (zero, one, nan) = (L::splat(0.0), L::splat(1.0), L::splat(f64::NAN));
        let sign = one.copysign(y.hi);
        let size = y.scale(sign);
        let inside = zero.less(y.hi);
        let (a, b) = (Dd::splat(self.u), Dd::splat(self.velocity));
        let (u_scale, velocity_scale) = (L::splat(self.scales[0]), L::splat(self.scales[1]));
        let (u, velocity) = match self.function {
            Function::Sech => {
                let (sinh, cosh) = saturated_sinh_cosh(size);
                let (falling, power) = sech(size);
                let velocity = -(falling * quotient(sinh, cosh) * b).value() * sign;
                ((falling * a).value() * u_scale * power, velocity * velocity_scale * power)
            }
            Function::Tanh => {
                let (sinh, cosh) = saturated_sinh_cosh(size);
                let (falling, power) = sech(size);
                let velocity = (falling.square() * b).value() * velocity_scale * power * power;
                ((quotient(sinh, cosh) * a).value() * (sign * u_scale), velocity)
            }
            Function::Csch | Function::Coth => {
                let (sinh, cosh) = saturated_sinh_cosh(size);
                let coth = quotient(cosh, sinh);
                let (falling, power) = sech(size);
                let (u, u_power, velocity, velocity_power) = if self.function == Function::Csch {
                    (falling * coth, power, falling * coth.square(), power)
                } else {
                    (coth, one, (falling * coth).square(), power * power)
                };
                let u = (u * a).value() * u_scale * u_power;
                let velocity = -(velocity * b).value() * velocity_scale * velocity_power;
                (L::select(inside, u, nan), L::select(inside, velocity, nan))
            }
            Function::Inverse => {
                let u = quotient(a, y).value() * u_scale;
                let velocity = -quotient(b, y.square()).value() * velocity_scale;
                (L::select(inside, u, nan), L::select(inside, velocity, nan))
            }
            Function::Cosh | Function::Sinh => {
                let (sinh, cosh) = saturated_sinh_cosh(size);
                let near = size.hi.less(L::splat(LARGE));
                let far_u = half_exponential(size, self.u, self.scales[0]);
                let far_velocity = half_exponential(size, self.velocity, self.scales[1]);
                let even = self.function == Function::Cosh;
                let (u, velocity) = if even { (cosh, sinh) } else { (sinh, cosh) };
                let u = L::select(near, (u * a).value() * u_scale, far_u);
                let velocity = L::select(near, (velocity * b).value() * velocity_scale, far_velocity);
                if even { (u, velocity * sign) } else { (u * sign, velocity) }
            }
            Function::Exponential => (
                exponential(-y, size, self.u, self.scales[0]),
                -exponential(-y, size, self.velocity, self.scales[1]),
            ),
        };
        let number = y.hi.equal(y.hi);
        [L::select(number, u, nan), L::select(number, velocity, nan)]
    }
}

impl Formula<1, 2> for Line {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        // Zero, and NaN for t = NaN.
        let nothing = L::select(t.equal(t), L::splat(0.0), t);
        let velocity = L::splat(self.velocity0) + nothing;
        let u = if self.moves {
            let (passed, error) = t.two_product(L::splat(self.velocity0));
            let sum = Dd::sum(passed, L::splat(self.u0));
            let exact = sum.hi + (sum.lo + error);
            // Beyond the range the second words are infinity minus infinity.
            L::select(sum.hi.abs().less(L::splat(f64::MAX)), exact, sum.hi)
        } else {
            L::splat(self.u0) + nothing
        };
        [u, velocity]
    }
}

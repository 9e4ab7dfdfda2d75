//! The motions without theta functions: separatrices, what escapes from them, and the linear oscillator, over lanes.
//!
//! All are functions of y = start + rate t: A sech y, A tanh y, A csch y, A coth y and A/y (NaN for y <= 0, beyond the
//! pole), A cosh y, A sinh y and A e^y. Source: DLMF 4.34.

use super::cubic_course::{Course, Plain, Simple};
use super::cubic_motion::finished;
use super::duffing::Duffing;
use crate::float::Dd;
use crate::float::elementary::{exp, quotient, saturated_sinh_cosh, sech};
use crate::lanes::{Formula, Lane};

/// A hyperbolic motion.
pub(super) struct Plainly<'a, const FIRST: bool>(pub &'a Duffing, pub &'a Simple);

/// No motion, or a straight line.
pub(super) struct Straight<'a, const FIRST: bool>(pub &'a Duffing);

/// Beyond this hyperbolic phase every function has its limit; and where both exponentials no longer matter.
const FAR: f64 = 1e6;
const LEVEL: f64 = 40.0;
/// Exponentials are taken in two halves, each in range.
const HALF_END: f64 = 690.0;

impl<const FIRST: bool> Plainly<'_, FIRST> {
    /// y, held where nothing changes any more; infinite times too.
    #[inline(always)]
    fn argument<L: Lane>(&self, t: L) -> Dd<L> {
        let Plainly(_, simple) = self;
        let scaled = t * L::splat(simple.scales.time);
        let y = simple.phase.counted(scaled);
        if simple.plain == Plain::Inverse {
            return y;
        }
        let passed = scaled * L::splat(simple.phase.rate.hi);
        let near = passed.abs().less(L::splat(FAR));
        let far = L::select(t.equal(t), L::splat(FAR).copysign(passed), t);
        Dd::select(near, y, Dd::from_double(far))
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
    let near = size.hi.less(L::splat(LEVEL));
    let small = exp(Dd::select(near, y, Dd::from_double(L::splat(0.0))));
    let value = (small * Dd::splat(amplitude)).value() * L::splat(scale);
    let far = half_exponential(size, amplitude, scale) * L::splat(2.0);
    // Far below, e^-y is half of sech y.
    let (falling, power) = sech(size);
    let low = (falling * Dd::splat(amplitude)).value() * L::splat(0.5) * L::splat(scale) * power;
    L::select(near, value, L::select(L::splat(0.0).less(y.hi), far, low))
}

impl<const FIRST: bool> Formula<1, 2> for Plainly<'_, FIRST> {
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let Plainly(orbit, simple) = self;
        let y = self.argument(t);
        let one = L::splat(1.0);
        let sign = one.copysign(y.hi);
        let size = y.scale(sign);
        let (a, b) = (Dd::splat(simple.u), Dd::splat(simple.velocity));
        let (u_scale, velocity_scale) = (L::splat(simple.scales.u), L::splat(simple.scales.velocity));
        let (u, velocity) = match simple.plain {
            Plain::Sech => {
                let (sinh, cosh) = saturated_sinh_cosh(size);
                let (falling, power) = sech(size);
                let velocity = -(falling * quotient(sinh, cosh) * b).value() * sign;
                ((falling * a).value() * u_scale * power, velocity * velocity_scale * power)
            }
            Plain::Tanh => {
                let (sinh, cosh) = saturated_sinh_cosh(size);
                let (falling, power) = sech(size);
                let velocity = (falling.square() * b).value() * velocity_scale * power * power;
                ((quotient(sinh, cosh) * a).value() * (sign * u_scale), velocity)
            }
            Plain::Csch | Plain::Coth => {
                let (sinh, cosh) = saturated_sinh_cosh(size);
                let coth = quotient(cosh, sinh);
                let (falling, power) = sech(size);
                let inside = L::splat(0.0).less(y.hi);
                let (u, u_power, velocity, velocity_power) = if simple.plain == Plain::Csch {
                    (falling * coth, power, falling * coth.square(), power)
                } else {
                    (coth, one, (falling * coth).square(), power * power)
                };
                let nan = L::splat(f64::NAN);
                let u = (u * a).value() * u_scale * u_power;
                let velocity = -(velocity * b).value() * velocity_scale * velocity_power;
                (L::select(inside, u, nan), L::select(inside, velocity, nan))
            }
            Plain::Inverse => {
                let inside = L::splat(0.0).less(y.hi);
                let nan = L::splat(f64::NAN);
                let u = quotient(a, y).value() * u_scale;
                let velocity = -quotient(b, y.square()).value() * velocity_scale;
                (L::select(inside, u, nan), L::select(inside, velocity, nan))
            }
            Plain::Cosh | Plain::Sinh => {
                let (sinh, cosh) = saturated_sinh_cosh(size);
                let near = size.hi.less(L::splat(LEVEL));
                let far_u = half_exponential(size, simple.u, simple.scales.u);
                let far_v = half_exponential(size, simple.velocity, simple.scales.velocity);
                let (u, velocity) = if simple.plain == Plain::Cosh { (cosh, sinh) } else { (sinh, cosh) };
                let u = L::select(near, (u * a).value() * u_scale, far_u);
                let velocity = L::select(near, (velocity * b).value() * velocity_scale, far_v);
                if simple.plain == Plain::Cosh { (u, velocity * sign) } else { (u * sign, velocity) }
            }
            Plain::Exp => (
                exponential(y, size, simple.u, simple.scales.u),
                exponential(y, size, simple.velocity, simple.scales.velocity),
            ),
        };
        let number = y.hi.equal(y.hi);
        let nan = L::splat(f64::NAN);
        let (u, velocity) = (L::select(number, u, nan), L::select(number, velocity, nan));
        finished::<FIRST, L>(orbit, t, u, velocity)
    }
}

impl<const FIRST: bool> Formula<1, 2> for Straight<'_, FIRST> {
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let orbit = self.0;
        // Zero, and NaN for t = NaN.
        let nothing = L::select(t.equal(t), L::splat(0.0), t);
        let velocity = L::splat(orbit.velocity0) + nothing;
        let u = if matches!(orbit.course, Course::Still) {
            L::splat(orbit.u0) + nothing
        } else {
            let (passed, error) = t.two_product(L::splat(orbit.velocity0));
            let sum = Dd::sum(passed, L::splat(orbit.u0));
            let exact = sum.hi + (sum.lo + error);
            // Beyond the range the second words are infinity minus infinity.
            L::select(sum.hi.abs().less(L::splat(f64::MAX)), exact, sum.hi)
        };
        finished::<FIRST, L>(orbit, t, u, velocity)
    }
}

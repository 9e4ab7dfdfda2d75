//! Motions that the force does not shape: rest at an equilibrium, and theta0 + velocity0 t.

use super::canonical::RESULTS;
use super::orbit::Orbit;
use crate::float::Dd;
use crate::lanes::{Formula, Lane};

/// At an equilibrium: the start for ever.
pub(super) struct AtEquilibrium<'a>(pub &'a Orbit);

impl Formula<1, RESULTS> for AtEquilibrium<'_> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; RESULTS] {
        let zero = L::splat(0.0);
        // NaN for NaN, and zero for every other time.
        let nothing = L::select(t.equal(t), zero, t);
        let theta = nothing + L::splat(self.0.theta0);
        [theta, nothing + L::splat(self.0.velocity0), zero, theta, zero]
    }
}

/// No force, or a velocity 2^100 times what the force could change: theta0 + velocity0 t.
pub(super) struct ForceFree<'a>(pub &'a Orbit);

/// 2^900: a product beyond is formed of factors that are DOWN times as large.
const LARGE: f64 = f64::from_bits((1023 + 900) << 52);
/// 2^-520: no product of two doubles leaves the range then, and factors of a large one stay normal.
const DOWN: f64 = f64::from_bits((1023 - 520) << 52);
/// 2^520.
const UP: f64 = f64::from_bits((1023 + 520) << 52);

impl Formula<1, RESULTS> for ForceFree<'_> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; RESULTS] {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let (theta0, velocity0) = (L::splat(self.0.theta0), L::splat(self.0.velocity0));
        // The sum may be in range where the product is not. Powers of two are exact here, but for digits of theta0 below
        // 2^-900 of the product.
        let ordinary = (t * velocity0).abs().less(L::splat(LARGE));
        let down = L::select(ordinary, one, L::splat(DOWN));
        let up = L::select(ordinary, one, L::splat(UP));
        let angle = Dd::product(t * down, velocity0 * down) + Dd::from_double(theta0 * down * down);
        // Zero, and NaN for times that are not finite.
        let nothing = t * zero;
        let theta = angle.value() * up * up + nothing;
        [theta, velocity0 + nothing, zero, theta, angle.lo * up * up]
    }
}

//! Jacobi's zeta of a parameter of its own in every lane, for m < 1 of any size.
//!
//! Z = (pi/2K) d ln theta4/dz at z = pi u/2K for m <= 1/2; above, by Jacobi's imaginary transformation with y = pi u/2K',
//!   Z = (pi/2K') (d ln theta4/dy - 2 y/(-ln q')),
//! and from K, with theta4(K - v) = theta3(v), likewise of theta3. For m < 0 theta3 and theta4 change places. Next to its zeros
//! at nK each is a number that vanishes with the angle, so that the digits are those of the reduced argument.
//! Source: DLMF 22.16.30 to 22.16.34, 20.7.30 to 20.7.33.

use super::functions_lanes::{JacobiLanes, ReducedArgument};
use crate::elliptic::given::Given;
use crate::elliptic::parameter_lanes::ParameterLanes;
use crate::float::Dd;
use crate::lanes::{Formula, Lane};

/// Below, the errors of products may be subnormal: NaN.
const TINY: f64 = 1e-250;

/// Zeta of (u, parameter).
pub(super) struct Zeta<const HYPERBOLIC: bool>(pub Given);

impl<const HYPERBOLIC: bool> Formula<2, 1> for Zeta<HYPERBOLIC> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [u, value]: [L; 2]) -> [L; 1] {
        let jacobi = JacobiLanes::<L>::new::<HYPERBOLIC>(self.0, value);
        let ParameterLanes { m, negative, above, outside, .. } = jacobi.parameter;
        let ReducedArgument { sign, folded, angle, .. } = jacobi.reduced(u);
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        // For m < 0 theta3 and theta4 change places, and the sign is the other.
        let (from_k, sign) = if outside {
            let distance = L::select(folded, one, zero);
            let distance = L::select(negative, one - distance, distance);
            (zero.less(distance), L::select(negative, -sign, sign))
        } else {
            (folded, sign)
        };
        let slope = jacobi.neville.slope_beyond_mean::<HYPERBOLIC>(angle, from_k);
        let rate = jacobi.rate();
        let size = (slope * Dd::new(rate.hi, rate.lo)).value();
        // Zero at u = 0 and for m = 0, where it takes the sign of u.
        let none = size.equal(zero);
        let undefined = L::splat(f64::NAN);
        let exact = L::select(u.equal(zero), u, L::select(m.hi.equal(zero), size.copysign(u), undefined));
        let value = L::select(L::splat(TINY).less(size), size * sign, L::select(none, exact, undefined));
        [L::select(above, undefined, value)]
    }
}

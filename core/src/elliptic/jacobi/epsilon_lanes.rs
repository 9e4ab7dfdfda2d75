//! Jacobi's epsilon of a parameter of its own in every lane, for m of any size but 1.
//!
//! With Z = (pi/2K) d ln theta4/dz and 1 - E/K = sigma, both from the set-up of the theta functions:
//!   epsilon = u (1 - sigma) + Z                              for m <= 1/2;
//! above, by Jacobi's imaginary transformation with y = pi u/2K' and sigma' of mc, where K drops out,
//!   epsilon = u sigma' + (pi/2K') (2 n + d ln theta4/dy)     at u = 2 n K + ...,
//! and from K, with theta4(K - v) = theta3(v), 1 - d ln theta3/dy. For m < 0 the integral of nd^2 takes theta3 in place of
//! theta4, and for m > 1 that of cn^2 takes sigma - mc of the unit parameter in place of sigma.
//! Source: DLMF 22.16.17, 22.16.30 to 22.16.34, 20.7.30 to 20.7.33, 19.8.6.

use super::functions_lanes::{JacobiLanes, ReducedArgument};
use crate::elliptic::given::Given;
use crate::elliptic::parameter_lanes::ParameterLanes;
use crate::float::Dd;
use crate::lanes::{Formula, Lane};

/// Where the square of u, and m times that, count no more.
const TINY: f64 = 1e-20;

/// Epsilon of (u, parameter).
pub(super) struct Epsilon<const HYPERBOLIC: bool>(pub Given);

impl<const HYPERBOLIC: bool> Formula<2, 1> for Epsilon<HYPERBOLIC> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [u, value]: [L; 2]) -> [L; 1] {
        let jacobi = JacobiLanes::<L>::new::<HYPERBOLIC>(self.0, value);
        let ParameterLanes { m, mc, factor, negative, above, .. } = jacobi.parameter;
        let ReducedArgument { count, sign, folded, angle } = jacobi.reduced(u);
        let (half, one, zero) = (L::splat(0.5), L::splat(1.0), L::splat(0.0));
        let [fourth, lacking, third] = jacobi.neville.logarithmic_slopes::<HYPERBOLIC>(angle);
        let quadratic = jacobi.neville.quadratic;
        let none = Dd::from_double(zero);
        let (growth, slope) = if HYPERBOLIC {
            let part = mc.scale(half);
            let growth = Dd::select(above, Dd::new(-part.hi, -part.lo), Dd::new(part.hi, part.lo));
            let counted_from_k = Dd::select(negative, lacking, Dd::from_double(one) + -third);
            let slope = Dd::select(folded, counted_from_k, Dd::select(negative, third, fourth));
            (growth.plain_sum(Dd::from_double(quadratic)), slope)
        } else {
            let part = m.scale(half);
            let lead = Dd::select(above, Dd::new(part.hi, part.lo), Dd::sum(one, -part.hi));
            let lead = Dd::select(above, lead, Dd::new(lead.hi, lead.lo - part.lo));
            let growth = lead.plain_sum(Dd::from_double(-quadratic));
            let near = Dd::select(negative, third, fourth);
            let far = Dd::select(negative, fourth, third);
            (growth, Dd::select(folded, -far, near))
        };
        let turns = if HYPERBOLIC { Dd::from_double(count + count) } else { none };
        let mean = jacobi.neville.mean;
        let slope = turns.plain_sum(slope.scale(sign)) * Dd::new(mean.hi, mean.lo);
        let factor = Dd::new(factor.hi, factor.lo);
        let whole = ((growth * factor) * u).plain_sum(slope) * factor;
        // epsilon = u - m u^3/3 + ...
        let tiny = (u * factor.hi).abs().less(L::splat(TINY));
        [L::select(tiny, u, whole.value())]
    }
}

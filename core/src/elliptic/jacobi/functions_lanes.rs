//! Jacobi's functions of a parameter of its own in every lane, for m of any size but 1.
//!
//! Method: as functions.rs, with the set-up of neville_lanes.rs: the argument as circular or hyperbolic angle, reduced by
//! pi or by -ln q', and Neville's theta functions as hi + lo. The periods are good to 2^-100, so that zeros and poles keep
//! their digits, also after many periods. Source: DLMF 22.2, 22.16(i), 22.17; A&S 16.36.

use super::functions::{NevilleIndex, NevilleValues, odd};
use super::glaisher::quotient_at;
use crate::elliptic::given::Given;
use crate::elliptic::parameter_lanes::ParameterLanes;
use crate::elliptic::phase::{alternating, modulo};
use crate::elliptic::theta::neville_lanes::NevilleThetaLanes;
use crate::float::double_double::two_sum;
use crate::float::elementary::{arctangent, quotient};
use crate::float::unnormalised::Unnormalised;
use crate::float::{Dd, PI};
use crate::lanes::{Formula, Lane};

/// 2^44: how many times its rest an argument may be.
const MOST_CANCELLED: f64 = 17_592_186_044_416.0;

/// The functions of one parameter per lane, all of one class.
pub(super) struct JacobiLanes<L: Lane> {
    pub parameter: ParameterLanes<L>,
    pub neville: NevilleThetaLanes<L>,
}

/// u = count half periods + sign times what the angle stands for: from 0, or from K where `folded`.
pub(super) struct ReducedArgument<L: Lane> {
    pub count: L,
    pub sign: L,
    pub folded: L::Mask,
    /// Circular or hyperbolic, at most a quarter of that of a half period.
    pub angle: Dd<L>,
}

impl<L: Lane> JacobiLanes<L> {
    #[inline(always)]
    pub fn new<const HYPERBOLIC: bool>(given: Given, value: L) -> Self {
        let parameter = ParameterLanes::new(given, value);
        let neville = NevilleThetaLanes::new::<HYPERBOLIC>(parameter.m, parameter.mc);
        JacobiLanes { parameter, neville }
    }

    /// u reduced by the nearest whole number of half periods; a NaN for the angle where so little is left of u that 2^-98 of u, to
    /// which the periods are good, would show.
    #[inline(always)]
    pub fn reduced(&self, u: L) -> ReducedArgument<L> {
        let JacobiLanes { parameter, neville } = self;
        let NevilleThetaLanes { theta2_factor, angle: period, .. } = *neville;
        let rate = if parameter.outside { theta2_factor * parameter.factor } else { theta2_factor };
        let (count, rest) = modulo(u, rate, period);
        let (one, half) = (L::splat(1.0), L::splat(0.5));
        let sign = one.copysign(rest.hi);
        let rest = rest.scale(sign);
        let folded = (period.hi * L::splat(0.25)).less(rest.hi);
        let (far, far_error) = two_sum(period.hi * half, -rest.hi);
        let far = Dd::sum(far, far_error + (period.lo * half - rest.lo));
        let angle = Dd::select(folded, far, rest);
        let lost = (angle.hi * L::splat(MOST_CANCELLED)).less((u * rate.hi).abs());
        ReducedArgument {
            count,
            sign,
            folded,
            angle: Dd::new(L::select(lost, L::splat(f64::NAN), angle.hi), angle.lo),
        }
    }

    /// The nearest whole number of half periods, and Neville's theta functions at u.
    #[inline(always)]
    fn neville_values<const HYPERBOLIC: bool>(&self, u: L) -> (L, NevilleValues<Dd<L>, L>) {
        let JacobiLanes { parameter, neville } = self;
        let ParameterLanes { negative, above, outside, factor, .. } = *parameter;
        let NevilleThetaLanes { theta2_factor, kc, .. } = *neville;
        let ReducedArgument { count, sign, folded, angle } = self.reduced(u);
        let one = L::splat(1.0);
        let [t1, t2, t3, t4] = neville.thetas::<HYPERBOLIC>(angle);
        let parity = alternating(count);
        let first = Unnormalised::from(t1) * theta2_factor.inverse();
        let plain = |value: Unnormalised<L>| Dd::new(value.hi, value.lo);
        let signs = [parity * sign, parity, one];
        if !outside {
            let s = Dd::select(folded, t2, plain(first));
            let c = Dd::select(folded, plain(first * kc), t2);
            let d = Dd::select(folded, plain(Unnormalised::from(t4) * kc), t3);
            return (count, NevilleValues { s, c, d, n: Dd::select(folded, t3, t4), signs });
        }
        // For m < 0 theta3 and theta4 change places, A becomes k' A and k' its inverse.
        let (third, fourth) = (Dd::select(negative, t4, t3), Dd::select(negative, t3, t4));
        let near = Unnormalised::select(negative, first * kc, first);
        let across = Unnormalised::select(negative, first, first * kc);
        let complement = Unnormalised::select(negative, factor, kc);
        let s = Dd::select(folded, t2, plain(near));
        let c = Dd::select(folded, plain(across), t2);
        let d = Dd::select(folded, plain(Unnormalised::from(fourth) * complement), third);
        let n = Dd::select(folded, third, fourth);
        // For m > 1 s takes the modulus, and cn and dn change places.
        let s_above = plain(Unnormalised::from(s) * factor.inverse());
        let signs = [signs[0], L::select(above, one, parity), L::select(above, parity, one)];
        let s = Dd::select(above, s_above, s);
        (count, NevilleValues { s, c: Dd::select(above, d, c), d: Dd::select(above, c, d), n, signs })
    }
}

/// sn, cn, dn, am of (u, parameter).
pub(super) struct Together<const HYPERBOLIC: bool>(pub Given);

impl<const HYPERBOLIC: bool> Formula<2, 4> for Together<HYPERBOLIC> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [u, value]: [L; 2]) -> [L; 4] {
        let jacobi = JacobiLanes::new::<HYPERBOLIC>(self.0, value);
        let (count, NevilleValues { s, c, d, n, signs }) = jacobi.neville_values::<HYPERBOLIC>(u);
        // The sign of the rest: that of sn without the parity, which is the sign of cn.
        let within = arctangent(s, c).scale(signs[0] * signs[1]);
        let turned = Dd::splat(PI) * count;
        let am = (turned + within).value();
        // Bounded for m > 1, where dn has the parity.
        let am = L::select(jacobi.parameter.above, within.value(), am);
        let sn = quotient(s, n).value() * signs[0];
        let cn = quotient(c, n).value() * signs[1];
        let dn = quotient(d, n).value() * signs[2];
        odd(u, [sn, cn, dn, am])
    }
}

/// One of Glaisher's twelve functions of (u, parameter).
pub(super) struct Quotient<const HYPERBOLIC: bool>(pub Given, pub [NevilleIndex; 2]);

impl<const HYPERBOLIC: bool> Formula<2, 1> for Quotient<HYPERBOLIC> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [u, value]: [L; 2]) -> [L; 1] {
        let jacobi = JacobiLanes::new::<HYPERBOLIC>(self.0, value);
        let (_, values) = jacobi.neville_values::<HYPERBOLIC>(u);
        [quotient_at(self.1, u, &values)]
    }
}

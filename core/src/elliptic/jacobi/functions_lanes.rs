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
use crate::elliptic::theta::neville_lanes::{CrossedThetas, NevilleThetaLanes};
use crate::float::double_double::two_sum;
use crate::float::elementary::{arctangent, horner, rounded_quotient};
use crate::float::unnormalised::Unnormalised;
use crate::float::{Dd, PI};
use crate::lanes::{Formula, Lane};

/// 2^44: how many times its rest an argument may be.
const MOST_CANCELLED: f64 = 17_592_186_044_416.0;

/// A theta function times a constant, not normalised.
#[inline(always)]
fn times<L: Lane>(theta: Dd<L>, by: Unnormalised<L>) -> Dd<L> {
    let product = Unnormalised::from(theta) * by;
    Dd::new(product.hi, product.lo)
}

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
        let period = self.neville.angle;
        let rate = self.rate();
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

    /// Half periods' angle per unit of u.
    #[inline(always)]
    pub fn rate(&self) -> Unnormalised<L> {
        let rate = self.neville.mean;
        if self.parameter.outside { rate * self.parameter.factor } else { rate }
    }

    /// Neville's theta functions at a reduced argument from the crossed theta functions there.
    ///
    /// With theta3^2 : theta2^2 : theta4^2 = 1 : k : k' at 0, in those and with sqrt k' as factor
    ///   s : c : d : n = theta1 : theta2 sqrt k' : theta3 sqrt k' : theta4    from 0 for m <= 1/2,
    ///   s : c : d : n = theta2 : theta1 sqrt k' : theta4 sqrt k' : theta3    from K,
    /// and above by Jacobi's imaginary transformation, s : c : d : n of u and m as s/i : n : d : c of i u and mc.
    #[inline(always)]
    fn neville_values<const HYPERBOLIC: bool>(
        &self,
        at: &ReducedArgument<L>,
        crossed: &CrossedThetas<L>,
    ) -> NevilleValues<Dd<L>, L> {
        let ParameterLanes { negative, above, outside, factor, .. } = self.parameter;
        let NevilleThetaLanes { kc, root, .. } = self.neville;
        let ReducedArgument { count, sign, folded, .. } = *at;
        let [t1, t2, t3, t4] = crossed.thetas;
        let one = L::splat(1.0);
        let parity = alternating(count);
        let [s, c, d, n] = if HYPERBOLIC {
            let across = [times(t1, kc), times(t2, kc)];
            let (d, n) = (Dd::select(folded, across[1], t3), Dd::select(folded, t3, t2));
            let (s, c) = (Dd::select(folded, t4, t1), Dd::select(folded, across[0], t4));
            [s, c, times(d, root), times(n, root)]
        } else {
            let (s, c) = (Dd::select(folded, t2, t1), Dd::select(folded, t1, t2));
            let (d, n) = (Dd::select(folded, t4, t3), Dd::select(folded, t3, t4));
            [s, times(c, root), times(d, root), n]
        };
        let signs = [parity * sign, parity, one];
        if !outside {
            return NevilleValues { s, c, d, n, signs };
        }
        // sn, cn, dn of m < 0 are k' sd, cd, nd of the one in [0, 1], and for m > 1 sn/factor, dn, cn.
        let of_negative = Dd::select(negative, times(s, kc), s);
        let s = Dd::select(above, times(s, factor.inverse()), of_negative);
        let (d, n) = (Dd::select(negative, n, d), Dd::select(negative, d, n));
        let signs = [signs[0], L::select(above, one, parity), L::select(above, parity, one)];
        NevilleValues { s, c: Dd::select(above, d, c), d: Dd::select(above, c, d), n, signs }
    }

    /// am of u for m <= 1/2 without the angle that it is nearly, which grows with u: between -0.09 and 0.09.
    ///
    /// tan am = tan z theta1/sin over theta2/cos sqrt k', and tan(am - z) follows; from K of pi/2 - am likewise. For m < 0 k' is
    /// on the other side.
    #[inline(always)]
    fn beyond_angle(&self, at: &ReducedArgument<L>, crossed: &CrossedThetas<L>) -> L {
        let ParameterLanes { negative, outside, .. } = self.parameter;
        let CrossedThetas { thetas: [t1, t2, ..], excesses: [e1, e2], sine, cosine } = *crossed;
        let root = self.neville.root;
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let (swapped, sign) = if outside {
            let swapped = L::select(at.folded, one, zero);
            let swapped = L::select(negative, one - swapped, swapped);
            (zero.less(swapped), L::select(negative, -at.sign, at.sign))
        } else {
            (at.folded, at.sign)
        };
        let (first, second) = (L::select(swapped, e2, e1), L::select(swapped, e1, e2));
        let (of_sine, of_cosine) = (sine * t1.hi, cosine * t2.hi);
        let (near, far) = (L::select(swapped, of_cosine, of_sine), L::select(swapped, of_sine, of_cosine));
        // 1 + first - root (1 + second)
        let apart = ((one - root.hi) - root.lo) + (first - root.hi * second);
        let tangent = sine * cosine * apart / far.mul_add(root.hi, near);
        let square = tangent * tangent;
        (square * tangent).mul_add(horner(&SHORT_ARCTANGENT, square), tangent) * sign
    }
}

/// (atan r - r)/r^3 in r^2 <= 0.008: Taylor's series, whose next term is 2^-59 of r.
const SHORT_ARCTANGENT: [f64; 7] =
    [-1.0 / 3.0, 1.0 / 5.0, -1.0 / 7.0, 1.0 / 9.0, -1.0 / 11.0, 1.0 / 13.0, -1.0 / 15.0];

/// sn, cn, dn, am of (u, parameter).
pub(super) struct Together<const HYPERBOLIC: bool>(pub Given);

impl<const HYPERBOLIC: bool> Formula<2, 4> for Together<HYPERBOLIC> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [u, value]: [L; 2]) -> [L; 4] {
        let jacobi = JacobiLanes::new::<HYPERBOLIC>(self.0, value);
        let at = jacobi.reduced(u);
        let crossed = jacobi.neville.crossed_thetas::<HYPERBOLIC>(at.angle);
        let NevilleValues { s, c, d, n, signs } = jacobi.neville_values::<HYPERBOLIC>(&at, &crossed);
        let above = jacobi.parameter.above;
        let am = if HYPERBOLIC || (jacobi.parameter.outside && L::any(above)) {
            // The sign of the rest: that of sn without the parity, which is the sign of cn.
            let within = arctangent(s, c).scale(signs[0] * signs[1]);
            let turned = Dd::splat(PI) * at.count;
            // Bounded for m > 1, where dn has the parity.
            L::select(above, within.value(), (turned + within).value())
        } else {
            u
        };
        let am = if HYPERBOLIC {
            am
        } else {
            let rate = jacobi.rate();
            let (angle, error) = u.two_product_in_range(rate.hi);
            let rest = u.mul_add(rate.lo, error) + jacobi.beyond_angle(&at, &crossed);
            L::select(above, am, angle + rest)
        };
        let sn = rounded_quotient(s, n) * signs[0];
        let cn = rounded_quotient(c, n) * signs[1];
        let dn = rounded_quotient(d, n) * signs[2];
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
        let at = jacobi.reduced(u);
        let crossed = jacobi.neville.crossed_thetas::<HYPERBOLIC>(at.angle);
        let values = jacobi.neville_values::<HYPERBOLIC>(&at, &crossed);
        [quotient_at(self.1, u, &values)]
    }
}

//! A parameter of its own in every lane: the periods, the theta functions and sn : cn : dn, without the set-up of one
//! [`NevilleTheta`] each.
//!
//! K by the arithmetic-geometric mean of fixed length for m <= 1/2; above, K = K' (-ln q')/pi with the nome q' of mc, whose
//! logarithm is good to 2^-100, so that no mean of far numbers is formed. For steps that are repeated two theta functions
//! suffice, because the rest follows from identities without cancellation: with
//! p : q = sn : cn, the common factor is s = sqrt(p^2 + q^2) and dn = sqrt(q^2 + mc p^2)/s. Both roots are one step of Newton's
//! from the other two theta functions. So sn^2 + cn^2 = 1 and dn^2 + m sn^2 = 1 hold to double-double whatever the rounding of the
//! theta functions, and a step repeated for ever keeps its energy.
//! Source: as neville.rs and agm.rs; DLMF 22.2.1.
//!
//! [`NevilleTheta`]: super::neville::NevilleTheta

use super::neville::{bounded_square, excesses, excesses_at_zero, fold, logarithmic_slope};
use crate::elliptic::agm::NearMean;
use crate::elliptic::nome::{minus_log_short_nome, short_nome};
use crate::float::elementary::{quotient, sin_cos, sinh_cosh};
use crate::float::unnormalised::Unnormalised;
use crate::float::{Dd, PI};
use crate::lanes::Lane;

/// Least 1 - m that a lane can take.
pub(crate) const LEAST_COMPLEMENT: f64 = 1e-12;

/// 1/pi.
const INVERSE_PI: Dd = Dd::new(0.3183098861837907, -1.9678676675182486e-17);

/// The theta functions of one parameter per lane, all with m <= 1/2 or all above.
pub(crate) struct NevilleThetaLanes<L: Lane> {
    /// 1/2K.
    pub frequency: Unnormalised<L>,
    /// Circular or hyperbolic angle of one half period 2K.
    pub angle: Unnormalised<L>,
    /// pi/2K or pi/2K', an arithmetic-geometric mean.
    pub mean: Unnormalised<L>,
    /// 1 - m.
    pub mc: Unnormalised<L>,
    pub kc: Unnormalised<L>,
    /// The root of k', for m <= 1/2; above that of k.
    pub root: Unnormalised<L>,
    /// (1 - E/K)/m - 1/2, times m, for m <= 1/2; above the same of mc.
    pub quadratic: L,
    /// The nome of m or mc.
    nome: Dd<L>,
}

/// 1 - E/K - m/2 for m <= 1/2, from k', m and lambda: the squares c_n^2 2^(n - 1) of the mean from n = 1 on, DLMF 19.8.6; that
/// of n = 4 is below 2^-68.
#[inline(always)]
fn beyond_half<L: Lane>(b: L, one_minus_square: L, lambda: L) -> L {
    let (half, one) = (L::splat(0.5), L::splat(1.0));
    // c_1 = (1 - k')/2, and with t = 2 lambda and M = (1 + sqrt k')^2/4: c_2 = M t^2, c_3 = M (1 - sqrt(1 - t^4))/2.
    let first = half * one_minus_square / (one + b);
    let root = half + half * b.sqrt();
    let square = L::splat(4.0) * lambda * lambda;
    let second = root * root * square;
    let fourth = square * square;
    let third = L::splat(0.125) * fourth * (half * fourth + one);
    first.mul_add(first, second * second * (L::splat(2.0) + third + third))
}

/// sn : cn : dn : 1 = sn : cn : dn : unit, and their squares.
pub(crate) struct Point<L: Lane> {
    pub sn: Unnormalised<L>,
    pub cn: Unnormalised<L>,
    pub dn: Unnormalised<L>,
    pub unit: Unnormalised<L>,
    pub sn_square: Unnormalised<L>,
    pub cn_square: Unnormalised<L>,
    pub dn_square: Unnormalised<L>,
    pub unit_square: Unnormalised<L>,
    /// Whether it is nearer to K.
    pub folded: L::Mask,
    /// The circular or hyperbolic angle of it, counted from K where folded.
    pub angle: Dd<L>,
}

/// The theta functions of [`NevilleThetaLanes::crossed_thetas`], and the first two beyond sine and cosine.
pub(crate) struct CrossedThetas<L: Lane> {
    pub thetas: [Dd<L>; 4],
    pub excesses: [L; 2],
    pub sine: L,
    pub cosine: L,
}

impl<L: Lane> NevilleThetaLanes<L> {
    /// From m and 1 - m >= 1e-200; HYPERBOLIC where m is above 1/2 (a rounding error beyond does no harm).
    #[inline(always)]
    pub fn new<const HYPERBOLIC: bool>(m: Unnormalised<L>, mc: Unnormalised<L>) -> Self {
        let (square, one_minus_square) = if HYPERBOLIC { (m, mc) } else { (mc, m) };
        let half = L::splat(0.5);
        let near_kc = if HYPERBOLIC { mc.hi.sqrt() } else { half };
        let NearMean { b, root, mean, lambda, inverse } = NearMean::new(square, one_minus_square, near_kc);
        let kc = if HYPERBOLIC { mc.near_root(near_kc, half * inverse) } else { b };
        let nome = short_nome(lambda);
        let (frequency, angle) = if HYPERBOLIC {
            let angle = minus_log_short_nome(lambda);
            (mean.over(angle), angle)
        } else {
            (mean * Unnormalised::splat(INVERSE_PI), Unnormalised::splat(PI))
        };
        let quadratic = beyond_half(b.hi, one_minus_square.hi, lambda.hi);
        NevilleThetaLanes { frequency, angle, mean, mc, kc, root, quadratic, nome }
    }

    /// theta1 theta3(0), theta2 theta3(0), theta3 theta2(0) and theta4 theta2(0), all over 2 q^1/4, at a circular angle of at most a
    /// quarter of that of a half period; at a hyperbolic angle y those of q' at i y, the first over i.
    #[inline(always)]
    pub fn crossed_thetas<const HYPERBOLIC: bool>(&self, angle: Dd<L>) -> CrossedThetas<L> {
        let one = L::splat(1.0);
        let ((sine, cosine), side) =
            if HYPERBOLIC { (sinh_cosh(angle), L::splat(-1.0)) } else { (sin_cos(angle), one) };
        let [e1, e2, e3, e4] = excesses(self.nome.hi, sine.hi * sine.hi * side);
        let [second, third] = excesses_at_zero(self.nome.hi);
        // (1 + e)(1 + f) = 1 + (e + f + e f).
        let [e1, e2] = [e1.mul_add(third, e1 + third), e2.mul_add(third, e2 + third)];
        let [e3, e4] = [e3.mul_add(second, e3 + second), e4.mul_add(second, e4 + second)];
        let thetas = [sine.nudge(e1), cosine.nudge(e2), Dd::ordered_sum(one, e3), Dd::ordered_sum(one, e4)];
        CrossedThetas { thetas, excesses: [e1, e2], sine: sine.hi, cosine: cosine.hi }
    }

    /// The slopes of ln theta4 and ln theta3 by that angle; and between them what the first lacks of 1, to which it tends where
    /// HYPERBOLIC.
    #[inline(always)]
    pub fn logarithmic_slopes<const HYPERBOLIC: bool>(&self, angle: Dd<L>) -> [Dd<L>; 3] {
        let one = Dd::from_double(L::splat(1.0));
        let two = L::splat(2.0);
        if HYPERBOLIC {
            let (sine, cosine) = sinh_cosh(angle);
            let (x, twice) = (-bounded_square(sine.hi), (sine * cosine).scale(-two));
            // theta2 stands in the place of theta4.
            let tail = logarithmic_slope(1, self.nome, x, twice);
            let tangent = quotient(sine, cosine);
            // 1 - tanh y = e^-y/cosh y.
            let lacking = quotient(one, (sine + cosine) * cosine);
            let slope = Dd::ordered_sum(tangent.hi, tangent.lo + tail.hi);
            let lacking = Dd::ordered_sum(lacking.hi, lacking.lo - tail.hi);
            [slope, lacking, logarithmic_slope(2, self.nome, x, twice)]
        } else {
            let (sine, cosine) = sin_cos(angle);
            let (x, twice) = (sine.hi * sine.hi, (sine * cosine).scale(two));
            let slope = logarithmic_slope(3, self.nome, x, twice);
            [slope, one + -slope, logarithmic_slope(2, self.nome, x, twice)]
        }
    }

    /// The slope of ln theta4 by that angle without its mean from 0 to K; where the angle counts from K, less that slope, which is
    /// that of ln theta3 there. Neither is negative, and both vanish with the angle.
    #[inline(always)]
    pub fn slope_beyond_mean<const HYPERBOLIC: bool>(&self, angle: Dd<L>, from_k: L::Mask) -> Dd<L> {
        let one = L::splat(1.0);
        let two = L::splat(2.0);
        if HYPERBOLIC {
            let (sine, cosine) = sinh_cosh(angle);
            let (x, twice) = (-bounded_square(sine.hi), (sine * cosine).scale(-two));
            // theta2 stands in the place of theta4, whose slope grows by 1 from 0 to K.
            let near = quotient(sine, cosine).plain_sum(logarithmic_slope(1, self.nome, x, twice));
            let third = logarithmic_slope(2, self.nome, x, twice);
            let mean = (self.angle.inverse().scale(two) * angle.into()).tight();
            // The differences are not below a fifth of their terms.
            Dd::select(from_k, mean.plain_sum(-third), near.plain_sum(-mean))
        } else {
            let (sine, cosine) = sin_cos(angle);
            let (x, twice) = (sine.hi * sine.hi, (sine * cosine).scale(two));
            // theta3 is theta4 of -q.
            let sign = L::select(from_k, -one, one);
            logarithmic_slope(3, self.nome.scale(sign), x, twice).scale(sign)
        }
    }

    /// At 2K f, for 0 <= f <= 1/2; all are not negative.
    #[inline(always)]
    pub fn at<const HYPERBOLIC: bool>(&self, f: Dd<L>) -> Point<L> {
        let (folded, v) = fold(f);
        let angle = (Unnormalised::from(v) * self.angle).ordered();
        let [theta1, theta2, theta3, theta4] = self.crossed_thetas::<HYPERBOLIC>(angle).thetas;
        // dn and the unit are known to a few roundings already: sn, cn, dn, unit are theta1, theta2 sqrt k', theta3 sqrt k',
        // theta4 from 0 for m <= 1/2, and above theta1, theta4, theta3 sqrt k, theta2 sqrt k; from K likewise.
        let near = |turned: L, plain: L| L::select(folded, turned, plain);
        let root = self.root.hi;
        let (near_dn, near_unit) = if HYPERBOLIC {
            (near(theta2.hi * self.kc.hi, theta3.hi) * root, near(theta3.hi, theta2.hi) * root)
        } else {
            (near(theta4.hi, theta3.hi) * root, near(theta3.hi, theta4.hi))
        };
        let theta1 = Unnormalised::from(theta1);
        let other = Unnormalised::from(if HYPERBOLIC { theta4 } else { theta2 });
        let sn = Unnormalised::select(folded, other, theta1);
        let cn = if HYPERBOLIC {
            Unnormalised::select(folded, theta1 * self.kc, other)
        } else {
            Unnormalised::select(folded, theta1, other) * self.root
        };
        let (sn_square, cn_square) = (sn.square(), cn.square());
        let dn_square = cn_square + self.mc * sn_square;
        let unit_square = cn_square + sn_square;
        let [dn, unit] = dn_square.two_near_roots(unit_square, [near_dn, near_unit]);
        Point { sn, cn, dn, unit, sn_square, cn_square, dn_square, unit_square, folded, angle }
    }
}

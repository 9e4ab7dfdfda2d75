//! A parameter of its own in every lane: the period and sn : cn : dn, without the set-up of one [`NevilleTheta`] each.
//!
//! theta1 and theta2 suffice, because the rest follows from identities without cancellation: with
//! p : q = sn : cn, the common factor is s = sqrt(p^2 + q^2) and dn = sqrt(q^2 + mc p^2)/s. So sn^2 + cn^2 = 1 and
//! dn^2 + m sn^2 = 1 hold to double-double whatever the rounding of the theta functions, and a step repeated
//! for ever keeps its energy. K by the arithmetic-geometric mean of fixed length.
//! Source: as neville.rs and agm.rs.
//!
//! [`NevilleTheta`]: super::neville::NevilleTheta

use super::neville::{ShortCorrection, fold, short_corrections};
use crate::elliptic::agm::{agm_far, agm_near};
use crate::elliptic::nome::short_nome;
use crate::float::elementary::{sin_cos, sinh_cosh};
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
    angle: Unnormalised<L>,
    /// pi/2K or pi/2K': what theta2 takes beside theta1.
    pub theta2_factor: Unnormalised<L>,
    /// 1 - m.
    pub mc: Unnormalised<L>,
    kc: Unnormalised<L>,
    /// Of theta1 to theta4, beside sin, cos, 1, 1 on the circular side and sinh, 1, 1, cosh on the hyperbolic one.
    corrections: [ShortCorrection<L>; 4],
}

/// sn : cn : dn : 1 = sn : cn : dn : unit, and their squares.
pub(crate) struct Point<L: Lane> {
    pub sn: Unnormalised<L>,
    pub cn: Unnormalised<L>,
    pub dn: Unnormalised<L>,
    pub unit: Unnormalised<L>,
    pub cn_square: Unnormalised<L>,
    pub dn_square: Unnormalised<L>,
    pub unit_square: Unnormalised<L>,
    /// Whether it is nearer to K.
    pub folded: L::Mask,
    /// Slope of ln theta4 by its circular or hyperbolic angle; of ln theta3, counted from K.
    pub slope: L,
}

impl<L: Lane> NevilleThetaLanes<L> {
    /// From m and 1 - m >= [`LEAST_COMPLEMENT`]; HYPERBOLIC where m is above 1/2 (a rounding error beyond does no harm).
    #[inline(always)]
    pub fn new<const HYPERBOLIC: bool>(m: Unnormalised<L>, mc: Unnormalised<L>) -> Self {
        let kc = mc.root();
        if HYPERBOLIC {
            let mean = agm_far(kc);
            let (other, lambda) = agm_near(m.root(), mc);
            // theta2 and theta4 change places.
            let [theta1, theta4, theta3, theta2] = short_corrections(short_nome(lambda));
            let corrections = [theta1, theta2, theta3, theta4];
            let angle = other.over(mean) * Unnormalised::splat(PI);
            let frequency = mean * Unnormalised::splat(INVERSE_PI);
            NevilleThetaLanes { frequency, angle, theta2_factor: other, mc, kc, corrections }
        } else {
            let (mean, lambda) = agm_near(kc, m);
            let corrections = short_corrections(short_nome(lambda));
            let frequency = mean * Unnormalised::splat(INVERSE_PI);
            NevilleThetaLanes {
                frequency,
                angle: Unnormalised::splat(PI),
                theta2_factor: mean,
                mc,
                kc,
                corrections,
            }
        }
    }

    /// At 2K f, for 0 <= f <= 1/2; all are not negative.
    #[inline(always)]
    pub fn at<const HYPERBOLIC: bool>(&self, f: Dd<L>) -> Point<L> {
        let (folded, v) = fold(f);
        let angle = (Unnormalised::from(v) * self.angle).tight();
        let [first, second, third, fourth] = &self.corrections;
        let one = L::splat(1.0);
        let (theta1, theta2, x, [sine, cosine]) = if HYPERBOLIC {
            let (sine, cosine) = sinh_cosh(angle);
            let x = -(sine.hi * sine.hi);
            let theta2 = Dd::from_double(one).nudge(second.at(x));
            (sine.nudge(first.at(x)), theta2, x, [sine.hi, cosine.hi])
        } else {
            let (sine, cosine) = sin_cos(angle);
            let x = sine.hi * sine.hi;
            (sine.nudge(first.at(x)), cosine.nudge(second.at(x)), x, [sine.hi, cosine.hi])
        };
        // d(sin^2) = 2 sin cos, d(-sinh^2) = -2 sinh cosh, and of theta4 = cosh (1 + ...) the cosh beside it.
        let twice = sine * cosine * L::splat(if HYPERBOLIC { -2.0 } else { 2.0 });
        let of_lead = if HYPERBOLIC { sine / cosine } else { L::splat(0.0) };
        let near = fourth.logarithmic_slope(x).mul_add(twice, of_lead);
        let slope = L::select(folded, third.logarithmic_slope(x) * twice, near);
        let (theta1, theta2) = (Unnormalised::from(theta1), Unnormalised::from(theta2) * self.theta2_factor);
        let sn = Unnormalised::select(folded, theta2, theta1);
        let cn = Unnormalised::select(folded, self.kc * theta1, theta2);
        let (sn_square, cn_square) = (sn.square(), cn.square());
        let dn_square = cn_square + self.mc * sn_square;
        let unit_square = cn_square + sn_square;
        let (dn, unit) = (dn_square.root(), unit_square.root());
        Point { sn, cn, dn, unit, cn_square, dn_square, unit_square, folded, slope }
    }
}

//! The state a time later by the addition theorem, over lanes and without the phase of the start: every row may have a
//! state of its own.
//!
//! With s, c = sine and cosine of theta/2, x = velocity/2 omega0 and S, C, D = sn, cn, dn(omega0 dt | m),
//!   g = c^2 + s^2 C = C + c^2 (1 - C),  h = s c (1 - C),  d = g^2 + h^2 = D^2 + x^2 S^2 = C^2 + c^2 S^2,
//!   theta' = theta + 2 atan2(x S g - D h, D g + x S h),  x' = (x C - s c S D)/d
//! in every regime: the half angle turns by atan2(x S, D) - atan2(h, g), which is continuous in dt. In rotation
//! S, C, D are sn/k, dn, cn(k omega0 dt | 1/m), and whole turns are counted separately. S, C, D may share a factor.
//! Source: Salas 2019 (23) by DLMF 22.8, formulas for the increment in place of the angle: docs/decisions/0010.

use super::state_lanes::StateLanes;
use crate::elliptic::phase::{alternating, turned};
use crate::elliptic::theta::neville_lanes::{NevilleThetaLanes, Point};
use crate::float::double_double::two_sum;
use crate::float::elementary::arctangent;
use crate::float::unnormalised::Unnormalised;
use crate::float::{PI, TWO_PI};
use crate::lanes::{Formula, Kernel, Lane, Sampler, sweep};

/// Beyond so many half periods times 1 - m a row is left to the fallback: what double-doubles lose of the period next to the
/// separatrix adds up.
const MANY: f64 = 1e14;

/// The start of a row of one class, set up for any time after it; NaN where the row must be left to the fallback.
pub(super) struct StateOnLanes<L: Lane, const ROTATION: bool, const HYPERBOLIC: bool> {
    theta: L,
    velocity: L,
    /// sin^2 and cos^2 of half the angle, and their product before it is squared.
    pub s_square: Unnormalised<L>,
    pub c_square: Unnormalised<L>,
    pub across: Unnormalised<L>,
    /// velocity/2 omega0, and 2 omega0.
    pub x: Unnormalised<L>,
    speed: Unnormalised<L>,
    /// kappa^2 and 1 - kappa^2.
    pub m: Unnormalised<L>,
    pub mc: Unnormalised<L>,
    pub lattices: NevilleThetaLanes<L>,
    /// Half periods per second.
    rate: Unnormalised<L>,
    /// 1/k in rotation.
    k_inverse: Unnormalised<L>,
    /// omega0, in rotation kappa omega0.
    pub stretch: Unnormalised<L>,
    /// kappa in rotation.
    pub k: Unnormalised<L>,
}

/// A state a time later: n + f half periods have passed.
pub(super) struct LaterState<L: Lane> {
    pub n: L,
    pub f: L,
    /// Whether so many half periods keep their digits.
    pub within: L::Mask,
    /// Sine and cosine of the turn of half the angle, but for whole turns, and velocity/2 omega0, each times the divisor.
    pub opposite: Unnormalised<L>,
    pub adjacent: Unnormalised<L>,
    pub x: Unnormalised<L>,
    pub divisor: Unnormalised<L>,
    /// S times the unit of the point.
    pub sn: Unnormalised<L>,
    pub point: Point<L>,
}

impl<L: Lane, const ROTATION: bool, const HYPERBOLIC: bool> StateOnLanes<L, ROTATION, HYPERBOLIC> {
    #[inline(always)]
    pub fn new(theta: L, velocity: L, omega: Unnormalised<L>) -> Self {
        let one = Unnormalised::from_double(L::splat(1.0));
        let StateLanes { parity, sine, high, s_square, c_square, x, speed, m, mc, .. } =
            StateLanes::new(theta, velocity, omega);
        let across = high.root() * sine.scale(parity);
        let (lattices, stretch, k, k_inverse) = if ROTATION {
            let [k, inverse] = m.root_and_inverse();
            (NevilleThetaLanes::new::<HYPERBOLIC>(inverse, -(mc * inverse)), omega * k, k, k * inverse)
        } else {
            (NevilleThetaLanes::new::<HYPERBOLIC>(m, mc), omega, one, one)
        };
        let rate = stretch * lattices.frequency;
        StateOnLanes {
            theta,
            velocity,
            s_square,
            c_square,
            across,
            x,
            speed,
            m,
            mc,
            lattices,
            rate,
            k_inverse,
            stretch,
            k,
        }
    }

    /// The state a time dt later, in terms of the turn of half the angle.
    #[inline(always)]
    pub fn later(&self, dt: L) -> LaterState<L> {
        let StateOnLanes { c_square, across, x, .. } = *self;
        let one = L::splat(1.0);
        let (n, f) = turned(dt, self.rate);
        let sign = one.copysign(f.hi);
        let point = self.lattices.at::<HYPERBOLIC>(f.scale(sign));
        let unit = point.unit;
        let (sn, sn_square, cn, dn, cn_square) = if ROTATION {
            let sn = point.sn.scale(sign) * self.k_inverse;
            (sn, sn.square(), point.dn, point.cn, point.dn_square)
        } else {
            let (parity, sn) = (alternating(n), point.sn.scale(sign));
            (sn.scale(parity), point.sn_square, point.cn.scale(parity), point.dn, point.cn_square)
        };
        let within = n.abs().less(self.lattices.mc.hi * L::splat(MANY));
        let x_sn = x * sn;
        let lacking = unit - cn;
        let (g, h) = (cn + c_square * lacking, across * lacking);
        LaterState {
            n,
            f: f.hi,
            within,
            opposite: x_sn * g - dn * h,
            adjacent: dn * g + x_sn * h,
            x: x * cn * unit - across * sn * dn,
            divisor: cn_square + c_square * sn_square,
            sn,
            point,
        }
    }

    /// Angle and velocity a time dt later.
    #[inline(always)]
    fn after(&self, dt: L) -> (L, L) {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let LaterState { n, within, opposite, adjacent, x: numerator, divisor, .. } = self.later(dt);
        let start = dt.equal(zero);
        let finished =
            |given: L, next: L| L::select(start, given, L::select(within, next, L::splat(f64::NAN)));
        let (opposite, adjacent) = (opposite.ordered(), adjacent.ordered());
        let side = one.copysign(opposite.hi);
        let acute = arctangent(opposite.scale(side), adjacent.scale(one.copysign(adjacent.hi)));
        let acute = Unnormalised::from(acute);
        let angle =
            Unnormalised::select(adjacent.hi.less(zero), Unnormalised::splat(PI).minus_smaller(acute), acute);
        let increment = angle.scale(L::splat(2.0) * side);
        let increment = if ROTATION {
            let turns = Unnormalised::from_double(n * one.copysign(self.x.hi));
            Unnormalised::splat(TWO_PI) * turns + increment
        } else {
            increment
        };
        let (theta, error) = two_sum(self.theta, increment.hi);
        let velocity = (numerator * self.speed).over(divisor);
        (
            finished(self.theta, theta + (error + increment.lo)),
            finished(self.velocity, velocity.hi + velocity.lo),
        )
    }
}

/// One start, many times.
impl<L: Lane, const ROTATION: bool, const HYPERBOLIC: bool> Sampler<L, 1, 2>
    for StateOnLanes<L, ROTATION, HYPERBOLIC>
{
    #[inline(always)]
    fn at(&self, [dt]: [L; 1]) -> [L; 2] {
        self.after(dt).into()
    }
}

/// One start, many times: set up on the lanes that it is evaluated on.
pub(super) struct SharedState<'a, 'b, const ROTATION: bool, const HYPERBOLIC: bool> {
    pub theta: f64,
    pub velocity: f64,
    pub omega: f64,
    pub dt: &'a [f64],
    pub results: [&'b mut [f64]; 2],
}

impl<const ROTATION: bool, const HYPERBOLIC: bool> Kernel for SharedState<'_, '_, ROTATION, HYPERBOLIC> {
    type Output = ();
    type Place = Self;
    #[inline(always)]
    fn run<L: Lane>(mut self) {
        let omega = Unnormalised::new(L::splat(self.omega), L::splat(0.0));
        let (theta, velocity) = (L::splat(self.theta), L::splat(self.velocity));
        let start = StateOnLanes::<L, ROTATION, HYPERBOLIC>::new(theta, velocity, omega);
        sweep::<L, _, _, _>(&start, [self.dt], &mut self.results, &[])
    }
}

/// A start of its own in every row of theta, velocity, dt, omega0; the double is what every omega0 lacks.
pub(super) struct PerRow<const ROTATION: bool, const HYPERBOLIC: bool>(pub f64);

impl<const ROTATION: bool, const HYPERBOLIC: bool> Formula<4, 2> for PerRow<ROTATION, HYPERBOLIC> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [theta, velocity, dt, omega]: [L; 4]) -> [L; 2] {
        let omega = Unnormalised::new(omega, L::splat(self.0));
        StateOnLanes::<L, ROTATION, HYPERBOLIC>::new(theta, velocity, omega).at([dt])
    }
}

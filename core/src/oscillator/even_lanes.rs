//! The motions with even powers over lanes: the weighted mean of mean.rs and the product of product.rs, by theta functions in hi + lo.
//!
//! With theta1 to theta4 of neville.rs, theta1 without its factor A: C^2 and (W S)^2 are theta2^2 and A^2 theta1^2 where three roots are
//! real, else (theta2 theta4)^2 and A^2 (theta1 theta3)^2; counted from K, k' times theta1^2 A^2 and theta2^2/k', and the same two
//! exchanged. The mean has both at one argument, so that the factor e^(-v^2) of the hyperbolic side cancels; the product takes one
//! exponential of the sum of the squares.

use super::curve::Curve;
use super::even_poles::EvenPolynomials;
use super::mean::Mean;
use super::product::Product;
use crate::elliptic::phase::{LAST_HALF_PERIOD, Phase};
use crate::elliptic::theta::neville::{NevilleTheta, Thetas, fold};
use crate::float::Dd;
use crate::float::elementary::exp;
use crate::float::scaled::{Scaled, over_common_power};
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Formula, Lane};
use std::sync::OnceLock;

/// Powers of two that factors and rates may have here; others go sample by sample.
const ORDINARY: i32 = 240;

/// k' below which lanes have no room, as a power of two.
const LEAST: i32 = -200;

/// Whether numbers are of ordinary size.
fn ordinary(numbers: &[Scaled]) -> bool {
    numbers.iter().all(|x| x.is_finite() && (x.is_zero() || x.power().abs() < ORDINARY))
}

/// A bounded motion: factors of C^2 and R S^2 and of the velocity, counted from 0 and from K.
#[derive(Clone, Debug)]
pub(super) struct MeanLanes {
    pub phase: Phase,
    /// The phase at the start, counted from the other end.
    pub start_from_other: Dd,
    pub time: f64,
    pub three: bool,
    pub base: Dd,
    pub other: Dd,
    pub way: Dd,
    near: [Dd; 2],
    far: [Dd; 2],
    lead: [Dd; 2],
    /// m mc A^4 of theta1^4 beside theta3^4.
    fourth: Dd,
    pub u_scale: f64,
    pub velocity_scale: f64,
    /// R over the square of the rate, and 1 - m.
    pub ratio: f64,
    pub mc: f64,
    pub polynomials: OnceLock<Option<EvenPolynomials>>,
}

impl MeanLanes {
    /// Where all factors are of ordinary size.
    pub fn new(mean: &Mean, neville: &NevilleTheta) -> Option<MeanLanes> {
        let Mean { curve, at_base, base, other, way, weight } = mean;
        let ratio = *weight / curve.square;
        let kc = Scaled::from(neville.kc);
        if kc.power() < LEAST || !ordinary(&[ratio, curve.rate]) {
            return None;
        }
        let a = Scaled::from(neville.theta1_factor);
        let a2 = a.square();
        let one = Scaled::ONE;
        let three = curve.three();
        let turned = if three { curve.mc } else { one };
        let lead = (*way * ratio * curve.rate * a).shift(1);
        let (rate, time) = (one / curve.period).carried();
        let ([base, other, way], u_scale) = over_common_power([*base, *other, *way]);
        let (lead, velocity_scale) = over_common_power([lead, lead * turned]);
        let start = -(*at_base / curve.period).to_dd();
        Some(MeanLanes {
            phase: Phase { rate, start },
            start_from_other: start - Dd::from(0.5),
            time,
            three,
            base,
            other,
            way,
            near: [one, turned * a2].map(Scaled::to_dd),
            far: [ratio * a2, ratio].map(Scaled::to_dd),
            lead,
            fourth: (curve.m * curve.mc * a2.square()).to_dd(),
            u_scale,
            velocity_scale,
            ratio: ratio.value(),
            mc: curve.mc.value(),
            polynomials: OnceLock::new(),
        })
    }

    /// The weights of both ends at f periods from the base, in [0, 1/2], 1 over their sum, and u'.
    #[inline(always)]
    pub fn values<const HYPERBOLIC: bool, L: Lane>(
        &self,
        neville: &NevilleTheta,
        f: Dd<L>,
    ) -> [Unnormalised<L>; 4] {
        let Thetas { theta: [t1, t2, t3, t4], folded } = neville.thetas_on::<HYPERBOLIC, L>(f);
        let (t1, t2, t3, t4): (Unnormalised<L>, Unnormalised<L>, Unnormalised<L>, Unnormalised<L>) =
            (t1.into(), t2.into(), t3.into(), t4.into());
        let all = t1 * t2 * (t3 * t4);
        let (even, odd, all) = if self.three {
            (t2.square(), t1.square(), all)
        } else {
            let (t1_square, t3_square) = (t1.square(), t3.square());
            let fourth = t3_square.square() + t1_square.square() * Unnormalised::splat(self.fourth);
            ((t2 * t4).square(), t1_square * t3_square, all * fourth)
        };
        let near = Unnormalised::select(folded, odd, even) * pick(folded, &self.near);
        let far = Unnormalised::select(folded, even, odd) * pick(folded, &self.far);
        let inverse = (near + far).inverse();
        [near, far, inverse, all * pick(folded, &self.lead) * inverse.square()]
    }
}

/// A bounded motion at any time.
pub(super) struct MeanFormula<'a, const HYPERBOLIC: bool>(pub &'a MeanLanes, pub &'a NevilleTheta);

/// The one of a pair that belongs to the way of counting.
#[inline(always)]
fn pick<L: Lane>(folded: L::Mask, pair: &[Dd; 2]) -> Unnormalised<L> {
    Unnormalised::select(folded, Unnormalised::splat(pair[1]), Unnormalised::splat(pair[0]))
}

impl<const HYPERBOLIC: bool> Formula<1, 2> for MeanFormula<'_, HYPERBOLIC> {
    type Place = Self;
    /// Floor: 190 operations where three roots are real, 230 else; for eight times at two a cycle of 3 GHz 4 and 5 ns.
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let MeanFormula(mean, neville) = self;
        let (_, f) = mean.phase.spread::<L>().count(t * L::splat(mean.time), LAST_HALF_PERIOD);
        let sign = L::splat(1.0).copysign(f.hi);
        let [_, far, inverse, velocity] = mean.values::<HYPERBOLIC, L>(neville, f.scale(sign));
        let u = Unnormalised::splat(mean.base) + Unnormalised::splat(mean.way) * (far * inverse);
        let velocity = (velocity.hi + velocity.lo) * (sign * L::splat(mean.velocity_scale));
        [(u.hi + u.lo) * L::splat(mean.u_scale), velocity]
    }
}

/// An escape: the phases of t, t - z, p1 - t, p2 - t and 2t - z, those to the two escapes, and the factors of u - u0 and u'.
#[derive(Clone, Debug)]
pub(super) struct ProductLanes {
    phases: [Phase; 5],
    ends: [Phase; 2],
    time: f64,
    three: bool,
    passes: bool,
    u0: Dd,
    u_lead: Dd,
    velocity_lead: Dd,
    /// A, and sqrt k' with 1 over it.
    factor: Dd,
    roots: [Dd; 2],
    /// Of the squares of the arguments in the exponential.
    angle: Dd,
    u_scale: f64,
    velocity_scale: f64,
}

impl ProductLanes {
    /// Where all factors are of ordinary size.
    pub fn new(product: &Product, neville: &NevilleTheta, u0: f64) -> Option<ProductLanes> {
        let curve: &Curve = &product.curve;
        let [u_lead, velocity_lead] = product.leads();
        let kc = Scaled::from(neville.kc);
        let u_size = u_lead.abs() + Scaled::from(u0).abs();
        let fits = (u_lead / u_size).power() > -ORDINARY;
        if kc.power() < LEAST || !fits || !ordinary(&[curve.rate]) {
            return None;
        }
        let (rate, time) = (Scaled::ONE / curve.period).carried();
        let part = |t: Scaled| (t / curve.period).to_dd();
        let phase = |sign: f64, start: Scaled| Phase { rate: rate.scale(sign), start: part(start) };
        let [p1, p2] = product.poles;
        let [behind, ahead] = product.escapes;
        let ([u0, u_lead], u_scale) = over_common_power([Scaled::from(u0), u_lead]);
        let ([velocity_lead], velocity_scale) = over_common_power([velocity_lead]);
        let root = kc.sqrt();
        Some(ProductLanes {
            phases: [
                phase(1.0, Scaled::ZERO),
                phase(1.0, -product.turned),
                phase(-1.0, p1),
                phase(-1.0, p2),
                phase(2.0, -product.turned),
            ],
            ends: [phase(1.0, -behind), phase(-1.0, ahead)],
            time,
            three: curve.three(),
            passes: product.passes,
            u0,
            u_lead,
            velocity_lead,
            factor: neville.theta1_factor,
            roots: [root, Scaled::ONE / root].map(Scaled::to_dd),
            angle: if curve.three() { neville.angle } else { neville.angle.scale(2.0) },
            u_scale,
            velocity_scale,
        })
    }
}

/// An escape at any time; NaN at its ends and beyond.
pub(super) struct ProductFormula<'a, const HYPERBOLIC: bool>(pub &'a ProductLanes, pub &'a NevilleTheta);

/// A theta function with its sign, and the square of its argument in half periods.
struct Value<L: Lane>(Unnormalised<L>, Unnormalised<L>);

impl<const HYPERBOLIC: bool> ProductFormula<'_, HYPERBOLIC> {
    /// W S, or with `even` Neville's n, at half periods y.
    #[inline(always)]
    fn value<L: Lane>(&self, y: Dd<L>, even: bool) -> Value<L> {
        let ProductFormula(product, neville) = self;
        let n = y.hi.round();
        let f = Dd::ordered_sum(y.hi - n, y.lo);
        let one = L::splat(1.0);
        let sign = one.copysign(f.hi);
        let f = f.scale(sign);
        let (_, v) = fold(f);
        let square = Unnormalised::from(v).square();
        let Thetas { theta: [t1, t2, t3, t4], folded } = neville.thetas_on::<HYPERBOLIC, L>(f);
        let (t1, t2, t3, t4): (Unnormalised<L>, Unnormalised<L>, Unnormalised<L>, Unnormalised<L>) =
            (t1.into(), t2.into(), t3.into(), t4.into());
        if even {
            let far = t3 * Unnormalised::splat(product.roots[1]);
            return Value(Unnormalised::select(folded, far, t4), square);
        }
        let (near, far) = if product.three {
            (t1 * Unnormalised::splat(product.factor), t2 * Unnormalised::splat(product.roots[1]))
        } else {
            (t1 * t3 * Unnormalised::splat(product.factor), t2 * t4)
        };
        let sign = sign * crate::elliptic::phase::alternating(n);
        Value(Unnormalised::select(folded, far, near).scale(sign), square)
    }
}

impl<const HYPERBOLIC: bool> Formula<1, 2> for ProductFormula<'_, HYPERBOLIC> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let ProductFormula(product, _) = self;
        let time = t * L::splat(product.time);
        let zero = L::splat(0.0);
        let [after, before] = [product.ends[0].counted(time).hi, product.ends[1].counted(time).hi];
        let least = L::select(after.less(before), after, before);
        // False for NaN as well.
        let inside = zero.less(least);
        let time = L::select(inside, time, zero);
        let even = product.passes;
        let [p0, p1, p2, p3, p4] = &product.phases;
        let Value(first, first_square) = self.value(p0.counted(time), false);
        let Value(second, second_square) = self.value(p1.counted(time), even);
        let Value(pole, pole_square) = self.value(p2.counted(time), false);
        let Value(other, other_square) = self.value(p3.counted(time), even);
        let Value(double, double_square) = self.value(p4.counted(time), even);
        let inverse = (pole * other).inverse();
        let mut way = first * second * inverse * Unnormalised::splat(product.u_lead);
        let mut velocity = double * inverse.square() * Unnormalised::splat(product.velocity_lead);
        if HYPERBOLIC {
            let angle = Unnormalised::splat(product.angle);
            let poles = pole_square + other_square;
            let of_way = (poles - (first_square + second_square)) * angle;
            let of_velocity = (poles.scale(L::splat(2.0)) - double_square) * angle;
            way = way * Unnormalised::from(exp(of_way.tight()));
            velocity = velocity * Unnormalised::from(exp(of_velocity.tight()));
        }
        let u = Unnormalised::splat(product.u0) + way;
        let nan = L::splat(f64::NAN);
        [
            L::select(inside, (u.hi + u.lo) * L::splat(product.u_scale), nan),
            L::select(inside, (velocity.hi + velocity.lo) * L::splat(product.velocity_scale), nan),
        ]
    }
}

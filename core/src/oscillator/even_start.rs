//! The quartic at the start of a row with even powers, over lanes: its invariants, the formula that the row asks for, and its curve.
//!
//! As quartic.rs and curve.rs, in unnormalised double-doubles in place of exact numbers; a row of which too little is left where
//! terms cancel goes elsewhere. e1 and the gaps come from the one root of Z^3 - 3 I Z = 2 |J| that is far from the others, by Newton's
//! steps, and from the discriminant. Source: as there.

use super::batch::class;
use super::roots::{CUBE_ROOT, THIRD_OF_ANGLE};
use crate::float::Dd;
use crate::float::elementary::horner;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Formula, Lane};

/// What is not 0 lies between these, and so does the size of the discriminant: products of several, with their errors, stay in
/// range.
const SMALL: f64 = 1e-30;
const LARGE: f64 = 1e30;
pub(super) const LEAST_SIZE: f64 = 1e-180;
pub(super) const MOST_SIZE: f64 = 1e180;

/// Least part of the terms of the discriminant that must be left of them: next to a separatrix, and where m tends to 0.
pub(super) const NEAR_SEPARATRIX: f64 = 1e-9;
pub(super) const SMALL_SWINGS: f64 = 1e-16;

/// 1/12.
pub(super) const TWELFTH: Dd = Dd::new(0.08333333333333333, 4.625929269271485e-18);

/// 2 sqrt 3.
const TWO_ROOTS_OF_3: Dd = Dd::new(3.4641016151377544, 2.0070168443613806e-16);

#[inline(always)]
pub(super) fn double<L: Lane>(value: L) -> Unnormalised<L> {
    Unnormalised::from_double(value)
}

#[inline(always)]
pub(super) fn number<L: Lane>(value: f64) -> Unnormalised<L> {
    Unnormalised::from_double(L::splat(value))
}

#[inline(always)]
pub(super) fn scaled<L: Lane>(value: Unnormalised<L>, power: f64) -> Unnormalised<L> {
    value.scale(L::splat(power))
}

/// After a cancellation: products and roots take the second word to be small.
#[inline(always)]
pub(super) fn tight<L: Lane>(value: Unnormalised<L>) -> Unnormalised<L> {
    value.tight().into()
}

/// I, J and the discriminant I^3 - J^2.
pub(super) struct Invariants<L: Lane> {
    pub i: Unnormalised<L>,
    pub j: Unnormalised<L>,
    pub discriminant: Unnormalised<L>,
}

/// The quartic at the start of a row per lane, and its invariants as in quartic.rs.
pub(super) struct Start<L: Lane> {
    pub v2: Unnormalised<L>,
    pub q_v2: Unnormalised<L>,
    pub rho: Unnormalised<L>,
    pub sigma: Unnormalised<L>,
    pub force: Unnormalised<L>,
    pub rho_force: Unnormalised<L>,
    pub invariants: Invariants<L>,
    /// The sum of the sizes of the terms of the discriminant.
    pub size: L,
}

impl<L: Lane> Start<L> {
    #[inline(always)]
    pub fn new([u, v, p, q, r, c]: [L; 6]) -> Self {
        let (three, six) = (L::splat(3.0), L::splat(6.0));
        // Sizes of the terms of sigma, rho and the force, of I and of J.
        let [u_size, p_size, q_size, r_size] = [u.abs(), p.abs(), q.abs(), r.abs()];
        let cubic = q_size * u_size;
        let rho_size = cubic.mul_add(three, r_size);
        let sigma_size = u_size.mul_add(r_size + rho_size, p_size);
        let force_size = u_size.mul_add(u_size.mul_add(r_size + cubic, p_size), c.abs());
        let q_v2_size = q_size * (v * v);
        let rho_force_size = rho_size * force_size * six;
        let square = sigma_size * sigma_size;
        let i_size = square + rho_force_size + q_v2_size * six;
        let j_size = sigma_size.mul_add(
            q_v2_size.mul_add(L::splat(18.0), rho_force_size + square),
            force_size * force_size * q_size * L::splat(27.0) + rho_size * rho_size * (v * v) * six,
        );
        let size = i_size * i_size * i_size + j_size * j_size;

        let [u, v, p, q, r, c] = [double(u), double(v), double(p), double(q), double(r), double(c)];
        let (three, six) = (number(3.0), number(6.0));
        let q_u = q * u;
        let rho = tight(r + q_u * three);
        let sigma = tight(p + u * (r + rho));
        let force = tight(c - u * (p + u * (r + q_u)));
        let v2 = v.square();
        let (q_v2, rho_force, sigma2) = (q * v2, rho * force, sigma.square());
        let i = tight(sigma2 + (scaled(rho_force, 4.0) - q_v2 * six));
        let j =
            sigma * (q_v2 * number(18.0) + (rho_force * six + sigma2)) + q * force.square() * number(27.0);
        let j = tight(j - rho.square() * v2 * six);
        let discriminant = tight(i.square() * i - j.square());
        Start { v2, q_v2, rho, sigma, force, rho_force, invariants: Invariants { i, j, discriminant }, size }
    }

    /// What is left of the terms of the discriminant.
    #[inline(always)]
    pub fn left(&self) -> L {
        self.invariants.discriminant.hi.abs() / self.size
    }
}

/// The class of u0, velocity0, p, q, r and c.
pub(super) struct ClassifyEven;

impl Formula<6, 1> for ClassifyEven {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, given: [L; 6]) -> [L; 1] {
        let zero = L::splat(0.0);
        let code = |class: usize| L::splat(class as f64);
        let fallback = code(class::FALLBACK);
        let start = Start::new(given);
        let left = start.left();
        let above = zero.less(start.invariants.j.hi);
        let three = zero.less(start.invariants.discriminant.hi);
        let real = L::select(above, code(class::CIRCULAR), code(class::HYPERBOLIC));
        let pair = L::select(above, code(class::PAIR_CIRCULAR), code(class::PAIR_HYPERBOLIC));
        // With two complex roots and no force that holds it a motion escapes.
        let pair = L::select(zero.less(given[3]), pair, fallback);
        let found = L::select(three, real, pair);
        // Every comparison is false for NaN.
        let least = L::select(above, L::splat(SMALL_SWINGS), L::splat(NEAR_SEPARATRIX));
        let mut found = L::select(least.less(left), found, fallback);
        found = L::select(L::splat(LEAST_SIZE).less(start.size), found, fallback);
        found = L::select(start.size.less(L::splat(MOST_SIZE)), found, fallback);
        let mut k = 0;
        while k < 6 {
            let size = given[k].abs();
            let size = L::select(size.equal(zero), L::splat(1.0), size);
            let in_range = L::select(size.less(L::splat(LARGE)), found, fallback);
            found = L::select(L::splat(SMALL).less(size), in_range, fallback);
            k += 1;
        }
        [found]
    }
}

/// 1 over the slope 3 (Z^2 - I) of Z^3 - 3 I Z.
#[inline(always)]
fn inverse_slope<L: Lane>(z: L, i: L) -> L {
    L::splat(1.0) / (L::splat(3.0) * (z * z - i))
}

/// The Z >= 0 of Z^3 - 3 I Z = 2 |J| that is farthest from the other roots: a double to nine digits, and two of Newton's steps, the
/// second on the rest in double-double.
#[inline(always)]
fn far_root<L: Lane, const PAIR: bool>(invariants: &Invariants<L>) -> Unnormalised<L> {
    let three = L::splat(3.0);
    let i = invariants.i.hi;
    let sign = L::splat(2.0).copysign(invariants.j.hi);
    let twice_j = invariants.j.scale(sign);
    let near = if PAIR {
        // Cardano's t = (|J| + sqrt(J^2 - I^3))^1/3, and Z = t + I/t without a difference.
        let cube = twice_j.hi.mul_add(L::splat(0.5), invariants.discriminant.hi.abs().sqrt());
        let third = (cube.exponent() * L::splat(1.0 / 3.0)).round();
        let x = cube * (third * L::splat(-3.0)).exp2_integer();
        // In [1/2, 4): by Halley's step.
        let t = horner(&CUBE_ROOT, x);
        let t3 = t * t * t;
        let t = t * ((t3 + (x + x)) / (t3 + t3 + x)) * third.exp2_integer();
        let other = i / t;
        twice_j.hi / (t.mul_add(t, other * other) - i)
    } else {
        let r = i.sqrt();
        r * horner(&THIRD_OF_ANGLE, twice_j.hi / (i * r))
    };
    let rest = near * (near * near - three * i) - twice_j.hi;
    let z = near - rest * inverse_slope(near, i);
    let rest = (double(z).square() - invariants.i * number(3.0)) * double(z) - twice_j;
    Dd::ordered_sum(z, -((rest.hi + rest.lo) * inverse_slope(z, i))).into()
}

/// 12 e1, the square of the rate, m and 1 - m.
pub(super) struct CurveOnLanes<L: Lane> {
    pub e1: Unnormalised<L>,
    pub square: Unnormalised<L>,
    pub m: Unnormalised<L>,
    pub mc: Unnormalised<L>,
}

#[inline(always)]
pub(super) fn curve<L: Lane, const PAIR: bool, const HYPERBOLIC: bool>(
    invariants: &Invariants<L>,
) -> CurveOnLanes<L> {
    let z = far_root::<L, PAIR>(invariants);
    let z_square = z.square();
    let above = tight(z_square - invariants.i);
    let three_z = z * number(3.0);
    let twelfth = Unnormalised::splat(TWELFTH);
    if PAIR {
        // H^2 = |e1 - e2|^2 is the slope at e1 over 3; and w^2 = H^2 - (3 e1/2)^2.
        let h = (above * number(3.0)).root();
        let half = scaled(three_z, 0.5);
        let (sum, twice_h) = (h + half, scaled(h, 2.0));
        let inverse = (twice_h * sum).inverse();
        let large = sum.square() * inverse;
        let small = tight(scaled(z_square * number(3.0), 0.25) - invariants.i * number(3.0)) * inverse;
        let (m, mc) = if HYPERBOLIC { (large, small) } else { (small, large) };
        return CurveOnLanes { e1: if HYPERBOLIC { -z } else { z }, square: h * twelfth, m, mc };
    }
    // The gap of the two other roots; all of Z = 12 e.
    let root = invariants.discriminant.scale(L::splat(1.0).copysign(invariants.discriminant.hi)).root();
    let close = (root * Unnormalised::splat(TWO_ROOTS_OF_3)).over(above);
    let (wide, narrow) = (scaled(three_z + close, 0.5), scaled(three_z - close, 0.5));
    let inverse = wide.inverse();
    let (close_part, narrow_part) = (close * inverse, narrow * inverse);
    let square = wide * twelfth;
    if HYPERBOLIC {
        CurveOnLanes { e1: scaled(z + close, 0.5), square, m: narrow_part, mc: close_part }
    } else {
        CurveOnLanes { e1: z, square, m: close_part, mc: narrow_part }
    }
}

//! The energy at the start of a row with a quintic force, over lanes: its invariants, and the formula that the row asks for.
//!
//! Every row is taken in units of its own, powers of two: of a length near its start, and of a rate near that of the force there. With
//! v = 1/u^2 and wp = 2E v - p/3, v'^2 = 4 C(v) of nonzero_energy.rs is Weierstrass' curve, and its roots are Z/12 of
//!   Z^3 - 3 I Z = 2 J,  I = 16 (p^2 + 3 E q),  J = 64 (p^3 + 9/2 E p q + 18 E^2 s).
//! Source: as there; DLMF 23.3(i).

use super::batch::class;
use super::even_start::{Invariants, LEAST_SIZE, MOST_SIZE, NEAR_SEPARATRIX, double, number, scaled, tight};
use crate::float::Dd;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Formula, Lane};

/// What of u0 and u0', and of p, q and s, is not 0 lies between these and their inverses.
const SMALL_STATE: f64 = 1e-40;
const SMALL_FORCE: f64 = 1e-80;

/// The same of q, s and the energy in the units of the row.
const LARGE: f64 = 1e25;

/// How much of the terms of the energy must be left of them.
const LEAST_ENERGY: f64 = 1e-9;

/// 1/3.
const THIRD: Dd = Dd::new(0.3333333333333333, 1.850371707708594e-17);

/// Of the terms of the discriminant: less is what they have lost, and two roots count as one.
pub(super) const NOTHING: f64 = 1e-29;

/// A row in units of its own.
pub(super) struct OwnUnits<L: Lane> {
    /// u0, u0', p, q and s.
    pub given: [L; 5],
    /// The unit of length, that of velocity and 1 over that of time.
    pub length: L,
    pub velocity: L,
    pub rate: L,
}

/// 2 to a power that is whole, within the range of doubles.
#[inline(always)]
fn two_to<L: Lane>(power: L) -> L {
    power.larger(L::splat(-1000.0)).smaller(L::splat(1000.0)).exp2_integer()
}

impl<L: Lane> OwnUnits<L> {
    #[inline(always)]
    pub fn new([u, v, p, q, s]: [L; 5]) -> Self {
        let (two, four) = (L::splat(2.0), L::splat(4.0));
        let y = u * u;
        let stiffness = y.mul_add(y.mul_add(s.abs(), q.abs()), p.abs());
        let rate = (stiffness.exponent() * L::splat(0.5)).round();
        let length = u.abs().larger(v.abs() * two_to(-rate)).exponent();
        let square = rate * two;
        let given = [
            u * two_to(-length),
            v * two_to(-(length + rate)),
            p * two_to(-square),
            q * two_to(length * two - square),
            s * two_to(length * four - square),
        ];
        OwnUnits { given, length: two_to(length), velocity: two_to(length + rate), rate: two_to(rate) }
    }
}

/// The energy at the start of a row per lane, in its units.
pub(super) struct QuinticStart<L: Lane> {
    /// u0^2, 2E, p/3 and 2E - p u0^2/3.
    pub y: Unnormalised<L>,
    pub energy: Unnormalised<L>,
    pub third: Unnormalised<L>,
    pub place: Unnormalised<L>,
    pub invariants: Invariants<L>,
    /// What is left of the terms of the energy and of the discriminant.
    pub energy_left: L,
    pub left: L,
    /// The sum of the sizes of the terms of the discriminant.
    pub size: L,
}

impl<L: Lane> QuinticStart<L> {
    #[inline(always)]
    pub fn new([u, v, p, q, s]: [L; 5]) -> Self {
        let third = L::splat(THIRD.hi);
        let square = u * u;
        let [p_size, q_size, s_size] = [p.abs(), q.abs(), s.abs()];
        let terms = square * s_size.mul_add(square * third, q_size * L::splat(0.5));
        let energy_size = v.mul_add(v, square * (p_size + terms));
        let (y, v2) = (double(u).square(), double(v).square());
        let [p, q, s] = [double(p), double(q), double(s)];
        let third = p * Unnormalised::splat(THIRD);
        let of_q = scaled(q, 0.5) + s * y * Unnormalised::splat(THIRD);
        let energy = tight(v2 + y * (p + y * of_q));
        let e_size = energy.hi.abs();
        let product = e_size * q_size;
        let i_size = p_size.mul_add(p_size * L::splat(16.0), product * L::splat(24.0));
        let j_size = p_size * p_size.mul_add(p_size * L::splat(64.0), product * L::splat(144.0));
        let j_size = (e_size * e_size).mul_add(s_size * L::splat(288.0), j_size);
        let size = (i_size * i_size).mul_add(i_size, j_size * j_size);
        let (p2, e_q) = (p.square(), energy * q);
        let i = tight(scaled(p2, 16.0) + e_q * number(24.0));
        let j = p * (scaled(p2, 64.0) + e_q * number(144.0));
        let j = tight(j + energy.square() * s * number(288.0));
        let discriminant = tight(i.square() * i - j.square());
        QuinticStart {
            place: tight(energy - third * y),
            energy_left: e_size / energy_size,
            left: discriminant.hi / size,
            invariants: Invariants { i, j, discriminant },
            y,
            energy,
            third,
            size,
        }
    }
}

/// The class of u0, velocity0, p, q and s.
pub(super) struct ClassifyQuintic;

impl Formula<5, 1> for ClassifyQuintic {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, given: [L; 5]) -> [L; 1] {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let code = |class: usize| L::splat(class as f64);
        let fallback = code(class::FALLBACK);
        let units = OwnUnits::new(given);
        let start = QuinticStart::new(units.given);
        let Invariants { j, .. } = start.invariants;
        let above = zero.less(j.hi);
        let real = L::select(above, code(class::CIRCULAR), code(class::HYPERBOLIC));
        let pair = L::select(above, code(class::PAIR_CIRCULAR), code(class::PAIR_HYPERBOLIC));
        // With two complex roots and less energy than 0 a motion escapes.
        let pair = L::select(zero.less(start.energy.hi), pair, fallback);
        let found = L::select(start.left.less(L::splat(-NOTHING)), pair, real);
        // Every comparison is false for NaN. Where the close roots are far from the third, only their squares count.
        let least = L::select(above, L::splat(-1.0), L::splat(NEAR_SEPARATRIX));
        let mut found = L::select(least.less(start.left.abs()), found, fallback);
        found = L::select(L::splat(LEAST_ENERGY).less(start.energy_left), found, fallback);
        found = L::select(L::splat(LEAST_SIZE).less(start.size), found, fallback);
        found = L::select(start.size.less(L::splat(MOST_SIZE)), found, fallback);
        let between = |value: L, small: f64, found: L| {
            let size = L::select(value.equal(zero), one, value.abs());
            let found = L::select(size.less(L::splat(1.0 / small)), found, fallback);
            L::select(L::splat(small).less(size), found, fallback)
        };
        let mut k = 0;
        while k < 5 {
            found = between(given[k], if k < 2 { SMALL_STATE } else { SMALL_FORCE }, found);
            k += 1;
        }
        let [.., q, s] = units.given;
        let size = q.abs().larger(s.abs()).larger(start.energy.hi.abs());
        found = between(start.energy.hi, 1.0 / LARGE, found);
        [L::select(size.less(L::splat(LARGE)), found, fallback)]
    }
}

//! Angles on the circle: reduction of any double modulo 2 pi to triple-double, with the distance from the top
//! kept as carefully as the distance from the bottom.
//!
//! Method: Payne & Hanek (1983) with 384 of 1408 bits of 1/(2 pi), in integers, so nothing cancels.

use super::constants::TWO_PI_LONG;
use super::double_double::{Dd, two_sum};
use super::exponent::exp2;
use super::triple_double::Td;
use crate::lanes::Lane;

/// theta = 2 pi turns + side * from_bottom, side = +1 or -1, from_bottom in [0, pi].
#[derive(Clone, Copy, Debug)]
pub struct ReducedAngle {
    /// The nearest whole number of turns: exact up to 2^106, beyond to 2^-106 of itself.
    pub turns: Dd,
    /// Which side of the bottom: the sign of the remainder.
    pub side: f64,
    /// Distance from the bottom, in [0, pi].
    pub from_bottom: Td,
    /// Distance from the top, pi - from_bottom, without cancellation.
    pub from_top: Td,
}

/// 1/(2 pi) in binary, most significant word first.
const INVERSE_TWO_PI: [u64; 22] = [
    0x28be60db9391054a, 0x7f09d5f47d4d3770, 0x36d8a5664f10e410, 0x7f9458eaf7aef158, 0x6dc91b8e909374b8,
    0x01924bba82746487, 0x3f877ac72c4a69cf, 0xba208d7d4baed121, 0x3a671c09ad17df90, 0x4e64758e60d4ce7d,
    0x272117e2ef7e4a0e, 0xc7fe25fff7816603, 0xfbcbc462d6829b47, 0xdb4d9fb3c9f2c26d, 0xd3d18fd9a797fa8b,
    0x5d49eeb1faf97c5e, 0xcf41ce7de294a4ba, 0x9afed7ec47e35742, 0x1580cc11bf1edaea, 0xfc33ef0826bd0d87,
    0x6a78e45857b986c2, 0x19666157c5281a10,
];

/// 1/(2 pi) to a triple-double.
const INVERSE_TWO_PI_LONG: Td = Td::new(0.15915494309189535, -9.839338337591243e-18, -5.360718141446502e-34);

/// Beyond, the half turns are left to [`reduce`].
pub const FAR: f64 = 1e9;

/// theta = pi j + rest with a whole j and |rest| <= pi/2 (and a rounding error), to double-double for |theta| < FAR,
/// also next to the multiples of pi.
#[inline(always)]
pub fn half_turns<L: Lane>(theta: L) -> (L, Dd<L>) {
    let half = |word: f64| L::splat(-0.5 * word);
    let j = (theta * L::splat(core::f64::consts::FRAC_1_PI)).round();
    let (first, first_error) = j.two_product(half(TWO_PI_LONG.hi));
    let (second, second_error) = j.two_product(half(TWO_PI_LONG.mid));
    // Exact: either j is 0 or the two are within a factor of 2.
    let (near, near_error) = two_sum(theta + first, first_error);
    let (hi, hi_error) = two_sum(near, second);
    let rest = j.mul_add(half(TWO_PI_LONG.lo), second_error) + near_error;
    (j, Dd::ordered_sum(hi, hi_error + rest))
}

/// theta modulo 2 pi, for every finite theta.
pub fn reduce(theta: f64) -> ReducedAngle {
    let side = if theta < 0.0 { -1.0 } else { 1.0 };
    let size = theta.abs();
    if size <= core::f64::consts::PI {
        let from_bottom = Td::from(size);
        // pi in four doubles; near the top the first difference is exact, so all of the rest counts.
        let (difference, error) = two_sum(core::f64::consts::PI, -size);
        let (hi, mid) = two_sum(difference, 1.2246467991473532e-16);
        let (mid, rest) = two_sum(mid, error);
        let (mid, lo) = two_sum(mid, -2.9947698097183397e-33);
        let from_top = Td::normalised(hi, mid, lo + rest + 1.1124542208633653e-49);
        return ReducedAngle { turns: Dd::ZERO, side, from_bottom, from_top };
    }
    let exponent = ((size.to_bits() >> 52) as i32) - 1075;
    let mantissa = (size.to_bits() & ((1 << 52) - 1)) | (1 << 52);
    // Words of 1/(2 pi) whose product with theta is a whole number of turns are left out: none below 2^116.
    let first = if exponent > 0 { (exponent / 64) as usize } else { 0 };
    let mut limbs = [0u64; 7]; // least significant first
    let mut carry = 0u128;
    for (limb, word) in limbs.iter_mut().zip(INVERSE_TWO_PI[first..first + 6].iter().rev()) {
        let sum = u128::from(*word) * u128::from(mantissa) + carry;
        *limb = sum as u64;
        carry = sum >> 64;
    }
    limbs[6] = carry as u64;
    // The binary point stands left of `point` bits.
    let point = (384 - (exponent - 64 * first as i32)) as usize;
    let (mut turns, mut fraction) = split_at(&limbs, point);
    let half = bit(&fraction, point - 1);
    let mut remainder_side = side;
    if half {
        turns += 1;
        fraction = complement(&fraction, point);
        remainder_side = -side;
    }
    // Where words were left out there are more than 2^113 turns, and their fraction no longer counts.
    let turns = if first == 0 { whole(turns) } else { (INVERSE_TWO_PI_LONG * size).to_dd() } * side;
    let mut from_top = [0u64; 7];
    from_top[(point - 1) / 64] = 1 << ((point - 1) % 64);
    let from_top = subtract(&from_top, &fraction);
    ReducedAngle {
        turns,
        side: remainder_side,
        from_bottom: to_td(&fraction, point) * TWO_PI_LONG,
        from_top: to_td(&from_top, point) * TWO_PI_LONG,
    }
}

fn bit(limbs: &[u64; 7], index: usize) -> bool {
    limbs[index / 64] >> (index % 64) & 1 == 1
}

/// A whole number below 2^127 as a double-double.
fn whole(number: u128) -> Dd {
    let hi = number as f64;
    Dd::new(hi, (number as i128 - hi as i128) as f64)
}

/// Whole part, whose last 127 bits count, and the fraction's limbs.
fn split_at(limbs: &[u64; 7], point: usize) -> (u128, [u64; 7]) {
    let mut whole = 0u128;
    for index in (point..448).rev() {
        whole = whole << 1 | u128::from(bit(limbs, index));
    }
    let mut fraction = *limbs;
    for (i, limb) in fraction.iter_mut().enumerate() {
        let start = 64 * i;
        if start >= point {
            *limb = 0;
        } else if start + 64 > point {
            *limb &= (1 << (point - start)) - 1;
        }
    }
    (whole, fraction)
}

fn subtract(a: &[u64; 7], b: &[u64; 7]) -> [u64; 7] {
    let mut difference = [0u64; 7];
    let mut borrow = false;
    for i in 0..7 {
        let (part, first) = a[i].overflowing_sub(b[i]);
        let (part, second) = part.overflowing_sub(u64::from(borrow));
        difference[i] = part;
        borrow = first || second;
    }
    difference
}

/// 1 - fraction.
fn complement(fraction: &[u64; 7], point: usize) -> [u64; 7] {
    let mut one = [0u64; 7];
    one[point / 64] = 1 << (point % 64);
    subtract(&one, fraction)
}

/// The leading bits as three doubles of 53, 53 and 53 bits.
fn to_td(limbs: &[u64; 7], point: usize) -> Td {
    let Some(top) = (0..448).rev().find(|&index| bit(limbs, index)) else {
        return Td::ZERO;
    };
    let chunk = |from: i32| -> f64 {
        // 53 bits downwards from bit `from`.
        let mut value = 0u64;
        for offset in 0..53 {
            let index = from - offset;
            value = value << 1 | u64::from(index >= 0 && bit(limbs, index as usize));
        }
        value as f64 * exp2(from - 52 - point as i32)
    };
    let top = top as i32;
    Td::normalised(chunk(top), chunk(top - 53), chunk(top - 106))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// n = nint(theta/(2 pi)) and theta - 2 pi n by mpmath with 1400 bits; n as the nearest double and what is left.
    #[test]
    fn every_turn_is_counted() {
        for (theta, turns, rest, remainder) in [
            (1e16, 1591549430918953.0, 0.0, 2.2474252491623665),
            (1.7 * exp2(115), 1.123876407009419e34, -6.425198102947197e17, -0.6563587281167025),
            (exp2(116), 1.32220753765814e34, -8.174202486453809e17, 2.9210280651744706),
            (1e300, 1.5915494309189535e299, -6.349999441769617e282, -2.1838724841522326),
            (-f64::MAX, -2.861117485757028e307, -4.431116688417145e289, -3.1366306784390060),
        ] {
            let reduced = reduce(theta);
            assert_eq!(reduced.turns.hi, turns, "{theta:e}");
            let allowed = turns.abs() * exp2(-105);
            assert!((reduced.turns.lo - rest).abs() <= allowed, "{theta:e} {}", reduced.turns.lo);
            assert!((reduced.side * reduced.from_bottom.hi - remainder).abs() <= 4e-16, "{theta:e}");
        }
    }
}

//! Angles on the circle: reduction of any double modulo 2 pi, and sine and cosine of the half angle, to
//! triple-double, with the distance from the top kept as carefully as the distance from the bottom.
//!
//! Method: Payne & Hanek (1983) with 384 of 1408 bits of 1/(2 pi), in integers, so nothing cancels.

use super::double_double::{Dd, two_sum};
use super::scaling::exp2;
use super::triple_double::Td;

/// theta = 2 pi turns + side * from_bottom, side = +1 or -1, from_bottom in [0, pi].
#[derive(Clone, Copy, Debug)]
pub struct Reduced {
    /// Nearest whole number of turns (rounded to double beyond 2^53).
    pub turns: f64,
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

const TWO_PI: Td = Td::new(6.283185307179586, 2.4492935982947064e-16, -5.989539619436679e-33);

/// theta modulo 2 pi, for finite theta.
pub fn reduce(theta: f64) -> Reduced {
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
        return Reduced { turns: 0.0, side, from_bottom, from_top };
    }
    let exponent = ((size.to_bits() >> 52) as i32) - 1075;
    let mantissa = (size.to_bits() & ((1 << 52) - 1)) | (1 << 52);
    // Words of 1/(2 pi) whose product with theta is a whole number of turns are left out.
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
    let mut side = side;
    if half {
        turns += 1.0;
        fraction = complement(&fraction, point);
        side = -side;
    }
    let mut from_top = [0u64; 7];
    from_top[(point - 1) / 64] = 1 << ((point - 1) % 64);
    let from_top = subtract(&from_top, &fraction);
    let signed_turns = if theta < 0.0 { -turns } else { turns };
    Reduced {
        turns: signed_turns,
        side,
        from_bottom: to_td(&fraction, point) * TWO_PI,
        from_top: to_td(&from_top, point) * TWO_PI,
    }
}

fn bit(limbs: &[u64; 7], index: usize) -> bool {
    limbs[index / 64] >> (index % 64) & 1 == 1
}

/// Whole part as a double, and the fraction's limbs.
fn split_at(limbs: &[u64; 7], point: usize) -> (f64, [u64; 7]) {
    let mut whole = 0.0;
    for index in (point..448).rev() {
        whole = 2.0 * whole + f64::from(u8::from(bit(limbs, index)));
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

/// Sine and cosine of an angle in [0, pi/4], to triple-double.
pub fn sin_cos(angle: Td) -> (Td, Td) {
    doubled_series(angle, 1.0)
}

/// Hyperbolic sine and cosine of a number in [0, 0.8], to triple-double.
pub fn sinh_cosh(y: Td) -> (Td, Td) {
    doubled_series(y, -1.0)
}

/// Taylor's series of an eighth of the argument, doubled three times through 1 - cos, so both keep their
/// relative digits; `sign` is that of the square: +1 circular, -1 hyperbolic.
fn doubled_series(argument: Td, sign: f64) -> (Td, Td) {
    let eighth = argument.scale(0.125);
    let square = eighth.square().scale(sign);
    let mut sine = eighth * (Td::ONE - square * series(&ODD, square));
    let mut versine = square * series(&EVEN, square);
    for _ in 0..3 {
        let doubled = sine.scale(2.0) * (Td::ONE - versine);
        versine = sine.square().scale(2.0 * sign);
        sine = doubled;
    }
    (sine, Td::ONE - versine)
}

/// c[0] - x (c[1] - x (c[2] - ...)): a term below 2^-53 of the first needs two words only, below 2^-106 one.
fn series(coefficients: &[Td; 12], x: Td) -> Td {
    let mut tail = 0.0;
    for c in coefficients[8..].iter().rev() {
        tail = c.hi - x.hi * tail;
    }
    let x_dd = x.to_dd();
    let mut middle = Dd::from(tail);
    for c in coefficients[4..8].iter().rev() {
        middle = Dd::new(c.hi, c.mid) - x_dd * middle;
    }
    let mut sum = Td::from(middle);
    for c in coefficients[..4].iter().rev() {
        sum = *c - x * sum;
    }
    sum
}

/// 1/3!, 1/5!, ... 1/25!
const ODD: [Td; 12] = [
    Td::new(0.16666666666666666, 9.25185853854297e-18, 5.135813185032629e-34),
    Td::new(0.008333333333333333, 1.1564823173178714e-19, 1.6049416203226965e-36),
    Td::new(0.0001984126984126984, 1.7209558293420705e-22, 1.4926912391394127e-40),
    Td::new(2.7557319223985893e-06, -1.858393274046472e-22, 8.491754604881993e-39),
    Td::new(2.505210838544172e-08, -1.448814070935912e-24, 0.0),
    Td::new(1.6059043836821613e-10, 1.2585294588752098e-26, 0.0),
    Td::new(7.647163731819816e-13, 7.03872877733453e-30, 0.0),
    Td::new(2.8114572543455206e-15, 1.6508842730861433e-31, 0.0),
    Td::new(8.22063524662433e-18, 0.0, 0.0),
    Td::new(1.9572941063391263e-20, 0.0, 0.0),
    Td::new(3.868170170630684e-23, 0.0, 0.0),
    Td::new(6.446950284384474e-26, 0.0, 0.0),
];

/// 1/2!, 1/4!, ... 1/24!
const EVEN: [Td; 12] = [
    Td::new(0.5, 0.0, 0.0),
    Td::new(0.041666666666666664, 2.3129646346357427e-18, 1.2839532962581572e-34),
    Td::new(0.001388888888888889, -5.300543954373577e-20, -1.7386867553495878e-36),
    Td::new(2.48015873015873e-05, 2.1511947866775882e-23, 1.865864048924266e-41),
    Td::new(2.755731922398589e-07, 2.3767714622250297e-23, 0.0),
    Td::new(2.08767569878681e-09, -1.20734505911326e-25, 0.0),
    Td::new(1.1470745597729725e-11, 2.0655512752830745e-28, 0.0),
    Td::new(4.779477332387385e-14, 4.399205485834081e-31, 0.0),
    Td::new(1.5619206968586225e-16, 0.0, 0.0),
    Td::new(4.110317623312165e-19, 0.0, 0.0),
    Td::new(8.896791392450574e-22, 0.0, 0.0),
    Td::new(1.6117375710961184e-24, 0.0, 0.0),
];

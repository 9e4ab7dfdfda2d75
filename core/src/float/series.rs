//! Sine and cosine, circular and hyperbolic, to triple-double, by Taylor's series: for set-ups and for steps whose
//! errors would add up.

use super::constants::{HALF_PI, INVERSE_LN_2, LN_2, TWO_PI_LONG};
use super::double_double::Dd;
use super::elementary::arctangent;
use super::triple_double::Td;
use super::unnormalised::Unnormalised;
use crate::lanes::Lane;

/// Sine and cosine of an angle in [0, pi/4], to triple-double.
pub fn sin_cos(angle: Td) -> (Td, Td) {
    doubled_series(angle, 1.0)
}

/// Hyperbolic sine and cosine of a number in [0, 0.8], to triple-double.
pub fn sinh_cosh(y: Td) -> (Td, Td) {
    doubled_series(y, -1.0)
}

/// Sine and cosine of an angle in [0, pi/2] with rest = pi/2 - angle, to triple-double.
pub fn quarter_turn(angle: Td, rest: Td) -> (Td, Td) {
    if angle.hi <= rest.hi {
        return sin_cos(angle);
    }
    let (cosine, sine) = sin_cos(rest);
    (sine, cosine)
}

/// Sine and cosine of |z| <= pi/4 to all digits of a double-double.
pub fn long_sin_cos(z: Dd) -> (Dd, Dd) {
    let (sine, cosine) = sin_cos(z.into());
    (sine.to_dd(), cosine.to_dd())
}

/// Sine of an angle in [-pi, pi] to all digits of a double-double.
pub fn long_sine(angle: Dd) -> Dd {
    let size = angle.abs();
    let near = if size.hi > HALF_PI.hi { HALF_PI.scale(2.0) - size } else { size };
    let (sine, _) = quarter_turn(Td::from(near), Td::from(HALF_PI - near));
    if angle.hi < 0.0 { -sine.to_dd() } else { sine.to_dd() }
}

/// Hyperbolic sine and cosine of y in [0, 700] to all digits of a double-double.
pub fn long_sinh_cosh(y: Dd) -> (Dd, Dd) {
    let k = Lane::round(y.hi * INVERSE_LN_2);
    let r = Td::from(y) - LN_2 * k;
    let (sine, cosine) = sinh_cosh(r);
    if k == 0.0 {
        return (sine.to_dd(), cosine.to_dd());
    }
    let grown = (cosine + sine).scale((k - 1.0).exp2_integer());
    let shrunk = (cosine - sine).scale((-k - 1.0).exp2_integer());
    ((grown - shrunk).to_dd(), (grown + shrunk).to_dd())
}

/// Angle in [0, pi/2] of a point on the unit circle, to triple-double: what a double leaves of it is so small that its
/// sine is the rest.
pub fn angle(sine: Td, cosine: Td) -> Td {
    let near = Td::from(arctangent(sine.to_dd(), cosine.to_dd()).value());
    let (s, c) = quarter_turn(near, TWO_PI_LONG.scale(0.25) - near);
    near + (sine * c - cosine * s)
}

/// Sine of |z| <= pi/4 (a little beyond does no harm) to all digits of a double-double, over lanes.
#[inline(always)]
pub(crate) fn sine<L: Lane>(z: Unnormalised<L>) -> Unnormalised<L> {
    let x = z.square();
    // A term below 2^-53 of the first needs one word only.
    let mut tail = L::splat(0.0);
    for c in ODD[7..].iter().rev() {
        tail = L::splat(c.hi) - x.hi * tail;
    }
    let mut sum = Unnormalised::from_double(tail);
    for c in [Td::ONE].iter().chain(&ODD[..7]).rev() {
        let below = x * sum;
        let c = Unnormalised::new(L::splat(c.hi), L::splat(c.mid));
        sum = c.minus_smaller(below);
    }
    z * sum
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

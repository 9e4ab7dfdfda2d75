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
    let (sine, cosine) = next_to_sixteenths(z.abs(), &CIRCULAR, 1.0);
    (if z.hi < 0.0 { -sine } else { sine }, cosine)
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
    let r = if k == 0.0 { y } else { (Td::from(y) - LN_2 * k).to_dd() };
    let (sine, cosine) = next_to_sixteenths(r.abs(), &HYPERBOLIC, -1.0);
    if k == 0.0 {
        return (sine, cosine);
    }
    let sine = if r.hi < 0.0 { -sine } else { sine };
    let grown = (cosine + sine).scale((k - 1.0).exp2_integer());
    let shrunk = (cosine - sine).scale((-k - 1.0).exp2_integer());
    (grown - shrunk, grown + shrunk)
}

/// Sine and cosine of z >= 0 from those of the nearest sixteenth; `sign` is that of the square, as in [`doubled_series`].
fn next_to_sixteenths(z: Dd, table: &[[Dd; 2]], sign: f64) -> (Dd, Dd) {
    let k = Lane::round(16.0 * z.hi).min((table.len() - 1) as f64);
    // Exact.
    let r = Dd::sum(z.hi - k / 16.0, z.lo);
    let x = r.square().scale(sign);
    // |r| <= 1/32: the terms from the fourth on are below 2^-55, so that they need one word, and the eighth is below 2^-106.
    let beyond = |coefficients: &[Td; 12]| {
        let mut tail = 0.0;
        for c in coefficients[3..7].iter().rev() {
            tail = c.hi - x.hi * tail;
        }
        let mut sum = Dd::from(tail);
        for c in coefficients[..3].iter().rev() {
            sum = Dd::new(c.hi, c.mid) - x * sum;
        }
        x * sum
    };
    let (sine, cosine) = (r - r * beyond(&ODD), Dd::ONE - beyond(&EVEN));
    match table.get(k as usize) {
        Some([s, c]) if k > 0.0 => (*s * cosine + *c * sine, *c * cosine - (*s * sine).scale(sign)),
        _ => (sine, cosine),
    }
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

/// sin and cos of k/16, up to pi/4 and a little more.
const CIRCULAR: [[Dd; 2]; 14] = [
    [Dd::new(0.0, 0.0), Dd::new(1.0, 0.0)],
    [
        Dd::new(0.0624593178423802, -2.040259504585711e-18),
        Dd::new(0.9980475107000991, 3.3232291674141346e-17),
    ],
    [Dd::new(0.12467473338522769, -2.925947496057858e-18), Dd::new(0.992197667229329, 4.754870575189364e-17)],
    [
        Dd::new(0.18640329676226988, 2.3493796901281573e-18),
        Dd::new(0.9824733131012553, -3.919920375420088e-17),
    ],
    [Dd::new(0.24740395925452294, -7.53102495590706e-18), Dd::new(0.9689124217106447, 5.071436662403936e-17)],
    [
        Dd::new(0.30743851458038085, 1.1004366442765296e-19),
        Dd::new(0.9515679480481722, -3.8614834675674123e-17),
    ],
    [
        Dd::new(0.36627252908604757, -9.938814562106524e-18),
        Dd::new(0.9305076219123143, 4.488760003328074e-18),
    ],
    [
        Dd::new(0.42367625720393803, -2.331800700068871e-17),
        Dd::new(0.9058136834259364, 4.2864666490805214e-17),
    ],
    [
        Dd::new(0.479425538604203, -5.103969860556013e-18),
        Dd::new(0.8775825618903728, -4.2623149864279997e-17),
    ],
    [Dd::new(0.5333026735360201, 5.129318115032044e-17), Dd::new(0.8459244992310679, 1.549506647350329e-17)],
    [
        Dd::new(0.5850972729404622, -5.4883972461161805e-17),
        Dd::new(0.8109631195052179, -3.091333486122179e-17),
    ],
    [
        Dd::new(0.6346070800152693, -3.4568582392624965e-17),
        Dd::new(0.7728349461524715, 4.231014921891023e-17),
    ],
    [
        Dd::new(0.6816387600233341, 4.410467313197903e-17),
        Dd::new(0.7316888688738209, -1.0475824306512768e-17),
    ],
    [
        Dd::new(0.7260086552607126, -1.573621815339587e-17),
        Dd::new(0.6876855622205048, 3.5430696752823923e-17),
    ],
];

/// sinh and cosh of k/16, up to (ln 2)/2 and a little more.
const HYPERBOLIC: [[Dd; 2]; 7] = [
    [Dd::new(0.0, 0.0), Dd::new(1.0, 0.0)],
    [
        Dd::new(0.06254069805219183, -4.262263105777213e-18),
        Dd::new(1.0019537608656677, -6.742009696369115e-17),
    ],
    [
        Dd::new(0.12532577524111546, -4.318309886229614e-18),
        Dd::new(1.0078226778257109, -2.880800343795733e-17),
    ],
    [
        Dd::new(0.18860056562029018, 5.694486279693461e-18),
        Dd::new(1.0176296838006906, -1.0517664928673251e-16),
    ],
    [
        Dd::new(0.2526123168081683, -5.550352555023456e-18),
        Dd::new(1.0314130998795732, -1.5782222089554954e-17),
    ],
    [Dd::new(0.31761115611357726, 2.1546840958047752e-17), Dd::new(1.049226785060219, 2.990260563836379e-17)],
    [
        Dd::new(0.38385106791361456, 5.622465694408225e-18),
        Dd::new(1.0711403467045868, -3.146553736696317e-17),
    ],
];

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

#[cfg(test)]
mod tests {
    use super::*;

    /// Beside the series in triple-double, in units of 2^-104 of the value.
    fn farthest(long: impl Fn(Dd) -> (Dd, Dd), known: impl Fn(Td) -> (Td, Td), end: f64) -> f64 {
        let mut worst = 0.0f64;
        for i in 0..4000 {
            let z =
                Dd::new(end * f64::from(i) / 4000.0, 1e-18 * f64::from(i % 7 - 3) * f64::from(i) / 4000.0);
            let ((s, c), (sine, cosine)) = (long(z), known(z.into()));
            for (got, truth) in [(s, sine), (c, cosine)] {
                let rest = (truth - Td::from(got)).hi.abs();
                worst = worst.max(rest / truth.hi.abs().max(1e-300) * 2f64.powi(104));
            }
        }
        worst
    }

    #[test]
    fn sixteenths_are_the_series_in_triple_double() {
        let found = [farthest(long_sin_cos, sin_cos, 0.785), farthest(long_sinh_cosh, sinh_cosh, 0.78)];
        assert!(found.iter().all(|worst| *worst < 8.0), "{found:?}");
        let (sine, cosine) = long_sin_cos(Dd::from(-0.5));
        assert_eq!((sine, cosine), (-long_sin_cos(Dd::from(0.5)).0, long_sin_cos(Dd::from(0.5)).1));
    }

    #[test]
    fn a_wrong_digit_is_found() {
        let spoiled = |z: Dd| (long_sin_cos(z).0.nudge(1e-30), long_sin_cos(z).1);
        assert!(farthest(spoiled, sin_cos, 0.785) > 8.0);
    }
}

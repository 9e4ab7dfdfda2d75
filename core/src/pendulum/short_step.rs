//! The state a short time later, over lanes and without theta functions: sn, cn, dn of half the step by the series of
//! Weierstrass's function about its pole and of its derivative, and those of the step by doubling.
//!
//! With z = omega0 dt/2, b = z^2, B = m b, and c2, c3, ... the coefficients of that function times z^4, z^6, ...
//!   Y = (z/sn z)^2 = 1 + (b + B)/3 + c2 + c3 + ...,  R = (z/sn z)^3 cn z dn z = 1 - c2 - 2 c3 - 3 c4 - ...,
//!   sn : cn : dn : 1 = 2 z R : Y^2 - 2 b Y + b B : Y^2 - 2 B Y + b B : Y^2 - b B  at 2 z,
//! for every m, so that no regime is an exception, nor the separatrix. Then the addition theorem (addition_theorem.rs); the turn psi
//! of half the angle by tan(psi/2) = sin psi/(1 + cos psi). Source: DLMF 23.9, 22.6(ii), 22.8; Salas 2019 (23).

use crate::elliptic::phase::alternating;
use crate::float::Dd;
use crate::float::angle_reduction::half_turns;
use crate::float::double_double::two_sum;
use crate::float::elementary::{horner, sin_cos};
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Formula, Lane};

/// The largest (omega0 dt)^2, and kappa^2 times that, of a short step: what the series leaves out is below 2^-60.
pub(super) const LARGEST_SQUARE: f64 = 0.4096;

const THIRD: Dd = Dd::new(0.333_333_333_333_333_3, 1.850_371_707_708_594e-17);

/// (atan r - r)/r^3 in r^2 <= 0.111, error 2^-59 of atan r.
const ARCTANGENT: [f64; 10] = [
    -0.3333333333333333, 0.19999999999997403, -0.1428571428494013, 0.1111111102140365, -0.09090903797071016,
    0.07692127553038043, -0.06662912492028325, 0.05833429871992887, -0.048700052234316005,
    0.02924573735262315,
];

/// c2 + c3 + ... + c9, and c2 + 2 c3 + ... + 8 c9, by DLMF 23.9.5:
/// c4 = c2^2/3, c5 = 3 c2 c3/11, c6 = 2 c2^3/39 + c3^2/13, c7 = 2 c2^2 c3/33, c8 = 5 c2^4/663 + 60 c2 c3^2/2431,
/// c9 = 29 c2^3 c3/2717 + c3^3/247.
#[inline(always)]
fn sums<L: Lane>(c2: L, c3: L) -> [L; 2] {
    let (square, product, other) = (c2 * c2, c2 * c3, c3 * c3);
    // Factors of c2^2, c2 c3, c3^2 and c3^3, as polynomials in c2; in the second sum c_k counts k - 1 times.
    let plain = square.mul_add(
        horner(&[1.0 / 3.0, 2.0 / 39.0, 5.0 / 663.0], c2),
        product.mul_add(
            horner(&[3.0 / 11.0, 2.0 / 33.0, 29.0 / 2717.0], c2),
            other * c3.mul_add(L::splat(1.0 / 247.0), horner(&[1.0 / 13.0, 60.0 / 2431.0], c2)),
        ),
    );
    let counted = square.mul_add(
        horner(&[1.0, 10.0 / 39.0, 35.0 / 663.0], c2),
        product.mul_add(
            horner(&[12.0 / 11.0, 12.0 / 33.0, 232.0 / 2717.0], c2),
            other * c3.mul_add(L::splat(8.0 / 247.0), horner(&[5.0 / 13.0, 420.0 / 2431.0], c2)),
        ),
    );
    [c2 + (c3 + plain), c2 + ((c3 + c3) + counted)]
}

/// The state after a step of its own in every row of theta, velocity, dt, omega0; the double is what every omega0 lacks.
pub(super) struct ShortStep(pub f64);

impl Formula<4, 2> for ShortStep {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [theta, velocity, dt, omega]: [L; 4]) -> [L; 2] {
        let (zero, half, one) = (L::splat(0.0), L::splat(0.5), L::splat(1.0));
        let double = Unnormalised::from_double;
        // sin^2, cos^2 and sin cos of theta/2.
        let (half_turns, rest) = half_turns(theta);
        let parity = alternating(half_turns);
        let (sine, cosine) = sin_cos(rest.scale(half));
        let (sine, cosine) = (Unnormalised::from(sine), Unnormalised::from(cosine));
        let (low, high) = (sine.square(), cosine.square());
        let even = zero.less(parity);
        let s_square = Unnormalised::select(even, low, high);
        let c_square = Unnormalised::select(even, high, low);
        let across = (sine * cosine).scale(parity);
        // omega0 dt, and velocity/2 omega0 times that.
        let omega = Unnormalised::new(omega, L::splat(self.0));
        let u = omega * double(dt);
        let x_u = (double(velocity) * double(dt)).scale(half);
        let square = u.square();
        let quarter = L::splat(0.25);
        let b = square.scale(quarter);
        let mb = (s_square * square + x_u.square()).scale(quarter);
        // In doubles what is small.
        let (b1, b2) = (b.hi, mb.hi);
        let c2 = b1.mul_add(b1 - b2, b2 * b2) * L::splat(1.0 / 15.0);
        let c3 = (b1 + b2) * (b1 + b1 - b2) * (b1 - (b2 + b2)) * L::splat(1.0 / 189.0);
        let [sum, counted] = sums(c2, c3);
        let y = ((b + mb) * Unnormalised::splat(THIRD)).plus_smaller(double(sum));
        let y = double(one).plus_smaller(y);
        let r = double(one).minus_smaller(double(counted));
        // sn, cn, dn and 1, all times the same.
        let (y_square, b_mb) = (y.square(), b * mb);
        let common = y_square.plus_smaller(b_mb);
        let two = L::splat(2.0);
        let cn = common.minus_smaller((b * y).scale(two));
        let dn = common.minus_smaller((mb * y).scale(two));
        let unit = y_square.minus_smaller(b_mb);
        let (sn, x_sn, sn_square) = (u * r, x_u * r, square * r.square());
        // 1 - cn.
        let lacking = y.minus_smaller(mb) * square.scale(half);
        let (g, h) = (cn.plus_smaller(c_square * lacking), across * lacking);
        let opposite = x_sn * g - dn * h;
        let adjacent = (dn * g).plus_smaller(x_sn * h);
        let divisor = cn.square().plus_smaller(c_square * sn_square);
        let pull = omega.scale(two) * sn * across * dn;
        let later = (double(velocity) * (cn * unit) - pull).over(divisor);
        let tangent = opposite.over(divisor.plus_smaller(adjacent));
        let square = tangent.hi * tangent.hi;
        let correction = (square * tangent.hi).mul_add(horner(&ARCTANGENT, square), tangent.lo);
        let four = L::splat(4.0);
        let (sum, error) = two_sum(theta, tangent.hi * four);
        let start = dt.equal(zero);
        [
            L::select(start, theta, sum + correction.mul_add(four, error)),
            L::select(start, velocity, later.hi + later.lo),
        ]
    }
}

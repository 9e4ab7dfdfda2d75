//! The roots of f(v) = a v^3 + b v^2 + c v + d, and what lies between them and any point, each to all digits.
//!
//! Method: z = 3 a v + b turns f into z^3 + 3 P z + Q over 27 a^2. P, Q and the discriminant are exact (float/dyadic.rs),
//! so that the trigonometric and Cardano's forms give all *differences* of roots without cancellation. From a point to
//! the roots: the distances are roots of a cubic whose coefficients are exact as well; the largest comes by plain
//! subtraction, the other two from their product, their sum and their known difference. The distances from v = 0 are
//! the roots themselves.
//! Source: DLMF 1.11(iii).

use crate::float::Dd;
use crate::float::dyadic::Dyadic;
use crate::float::elementary::horner;
use crate::float::scaled::Scaled;

const THREE: f64 = 3.0;

/// 2 cos of a third of the angle whose 2 cos is c in [0, 2], in powers of c: relative error 2e-9.
pub(super) const THIRD_OF_ANGLE: [f64; 9] = [
    1.73205081074, 0.166666399624, -0.0240525108652, 0.00615220798745, -0.00189059539648, 0.00058875466084,
    -0.000155392754771, 2.79837585225e-05, -2.41656394568e-06,
];

/// The cube root of x in [1/2, 4), in powers of x: relative error 1e-3.
pub(super) const CUBE_ROOT: [f64; 6] =
    [0.471733055653, 0.814171285025, -0.400657487971, 0.13899632674, -0.0257088136328, 0.00191003724668];

pub(super) fn less(a: Scaled, b: Scaled) -> bool {
    (a - b).is_negative()
}

/// Coefficients and invariants, exact.
#[derive(Clone, Debug)]
pub(super) struct Cubic {
    pub a: Dyadic,
    pub b: Dyadic,
    pub d: Dyadic,
    /// 3ac - b^2.
    p: Dyadic,
    third: Scaled,
    depressed: Roots,
}

/// The roots z of the depressed cubic.
#[derive(Clone, Debug)]
pub(super) enum Roots {
    /// From the largest v to the smallest; gaps between 0 and 1, 1 and 2, 0 and 2.
    Three { z: [Scaled; 3], gaps: [Scaled; 3] },
    /// z and -z/2 +- i w.
    One { z: Scaled, w: Scaled },
}

/// Distances from a point.
#[derive(Clone, Copy, Debug)]
pub(super) enum Distances {
    /// To the three roots.
    Three([Scaled; 3]),
    /// To the real root, the square of that to the others, and its real part.
    One([Scaled; 3]),
}

/// Cube root of a positive number.
fn cube_root(x: Scaled) -> Scaled {
    let power = x.power().div_euclid(3);
    let value = x.shift(-3 * power).to_dd();
    // In [1, 8); a straight line with an error below 0.07. Newton's steps double the digits, and the last counts those of a
    // double-double.
    let mut root = 0.9 + 0.145 * value.hi;
    for _ in 0..4 {
        root -= (root - value.hi / (root * root)) / THREE;
    }
    let rest = Dd::from(root) - value / Dd::product(root, root);
    Scaled::new(Dd::ordered_sum(root, -(rest.hi / THREE)), power)
}

/// The y in [sqrt 3, 2] with y^3 - 3y = c for c in [0, 2]: 2 cos of a third of the angle with 2 cos = c.
fn third_of_angle(c: Dd) -> Dd {
    // Newton's steps double the digits; the last counts those of a double-double. The slope is at least 6.
    let near = horner(&THIRD_OF_ANGLE, c.hi);
    let y = near - (near * (near * near - THREE) - c.hi) / (THREE * (near * near - 1.0));
    let rest = (Dd::product(y, y) - Dd::from(THREE)) * y - c;
    Dd::ordered_sum(y, -(rest.hi / (THREE * (y * y - 1.0))))
}

pub(super) fn three(p: Scaled, q: Scaled, root: Scaled, falling: bool) -> Roots {
    // z = 2R cos(...) with 3 phi' = phi, |q| = 2 R^3 cos phi, root = 2 R^3 sin phi. The far root z has the slope
    // 3 R^2 (y^2 - 1) in y = z/R, the product of its distances from the others; and 27 root^2 is the discriminant.
    let r = p.abs().sqrt();
    let (across, along) = if r.is_zero() {
        (Scaled::ZERO, Scaled::ZERO)
    } else {
        let y = third_of_angle((q.abs() / (r * r.square())).to_dd());
        let slope = Scaled::from(y.square() - Dd::ONE) * r.square();
        ((root * Scaled::from(THREE).sqrt() / slope).shift(-1), (r * Scaled::from(y)).shift(-1))
    };
    let (far, near) = (along.shift(1), [across - along, -across - along]);
    let [wide, narrow] = [along * THREE + across, along * THREE - across];
    let close = across.shift(1);
    // q < 0: the far root is above the others.
    let top = q.is_negative();
    let (z, gaps) = if top {
        ([far, near[0], near[1]], [narrow, close, wide])
    } else {
        ([-near[1], -near[0], -far], [close, narrow, wide])
    };
    if falling {
        Roots::Three { z: [z[2], z[1], z[0]], gaps: [gaps[1], gaps[0], gaps[2]] }
    } else {
        Roots::Three { z, gaps }
    }
}

pub(super) fn one(p: Scaled, q: Scaled, root: Scaled) -> Roots {
    let t = cube_root((q.abs() + root).shift(-1));
    let (square, other) = (t.square(), (p / t).square());
    let z = q.abs() / (square + p + other);
    let w = if p.is_negative() { root / (square - p + other) } else { t + p / t };
    let w = (w * Scaled::from(THREE).sqrt()).shift(-1);
    Roots::One { z: if q.is_negative() { z } else { -z }, w }
}

impl Cubic {
    /// For a != 0.
    pub fn new(a: Dyadic, b: Dyadic, c: Dyadic, d: Dyadic) -> Cubic {
        let (ac, bd) = (&a * &c, &b * &d);
        let b2 = b.square();
        let a2 = a.square();
        let p = &ac * THREE - &b2;
        let q = &b2 * &b * 2.0 - &ac * &b * 9.0 + &a2 * &d * 27.0;
        let delta = &b2 * c.square() - &ac * c.square() * 4.0 - &bd * &b2 * 4.0 + &ac * &bd * 18.0
            - (&a * &d).square() * 27.0;
        let lead = a.to_scaled();
        let root = lead.abs() * (delta.to_scaled().abs() * 27.0).sqrt();
        let depressed = if delta.sign() < 0 {
            one(p.to_scaled(), q.to_scaled(), root)
        } else {
            three(p.to_scaled(), q.to_scaled(), root, a.sign() < 0)
        };
        Cubic { third: lead * THREE, a, b, d, p, depressed }
    }

    /// Gaps between the roots in v, from the largest: 0 to 1, 1 to 2, 0 to 2. None where two are complex.
    pub fn gaps(&self) -> Option<[Scaled; 3]> {
        match self.depressed {
            Roots::Three { gaps, .. } => Some(gaps.map(|gap| gap / self.third.abs())),
            Roots::One { .. } => None,
        }
    }

    /// For complex roots Re +- i w beside the real root v0: sign(a) (v0 - Re) and w.
    pub fn pair(&self) -> Option<[Scaled; 2]> {
        match self.depressed {
            Roots::Three { .. } => None,
            Roots::One { z, w } => {
                let unit = self.third.abs();
                Some([z * 1.5 / unit, w / unit])
            }
        }
    }

    /// y/v - root for the three roots (times y^2 for the pair), at v = 1/y, from 27 a^2 y^3 f: see the top.
    fn of_point(&self, above: &Dyadic, y: &Dyadic, product: &Dyadic) -> Distances {
        let pairs = (above.square() + &self.p * y.square()) * THREE;
        self.distances(above.to_scaled(), y.to_scaled(), pairs.to_scaled(), product.to_scaled())
    }

    /// 1 - y root of each root, at y, where f(1/y) y^3 = `value`.
    pub fn of_square(&self, y: &Dyadic, value: &Dyadic) -> Distances {
        let above = &self.a * THREE + &self.b * y;
        let product = self.a.square() * value * 27.0;
        self.of_point(&above, y, &product)
    }

    /// The roots; of a pair the square of its modulus.
    pub fn roots(&self) -> Distances {
        let product = self.a.square() * &self.d * 27.0;
        let negative = self.of_point(&self.b, &Dyadic::from(1.0), &product);
        match negative {
            Distances::Three(roots) => Distances::Three(roots.map(|root| -root)),
            Distances::One([root, pair, real]) => Distances::One([-root, pair, -real]),
        }
    }

    /// Of three real roots: whether all lie on that side of v = 1/y where f has the sign of a far out.
    pub fn all_on_one_side(&self, y: &Dyadic) -> bool {
        let above = &self.a * THREE + &self.b * y;
        let pairs = above.square() + &self.p * y.square();
        above.sign() > 0 && pairs.sign() > 0
    }

    fn distances(&self, above: Scaled, y: Scaled, pairs: Scaled, product: Scaled) -> Distances {
        let unit = self.third;
        match self.depressed {
            Roots::Three { z, gaps } => {
                let direct = z.map(|z| above - y * z);
                let mut most = 0;
                for k in 1..3 {
                    if less((direct[most]).abs(), (direct[k]).abs()) {
                        most = k;
                    }
                }
                let largest = direct[most];
                let mut found = [largest; 3];
                let (i, j) = ((most + 1) % 3, (most + 2) % 3);
                let (i, j) = (i.min(j), i.max(j));
                let gap = y * gaps[if (i, j) == (0, 2) { 2 } else { i }];
                if !largest.is_zero() {
                    let rest = product / largest;
                    let sum = (pairs - rest) / largest;
                    let side = if sum.is_negative() { -gap } else { gap };
                    let large = (sum + side).shift(-1);
                    let small = if large.is_zero() { Scaled::ZERO } else { rest / large };
                    // Distances rise towards the smaller root where a > 0.
                    let up = !sum.is_negative();
                    let large_is_last = up != self.third.is_negative();
                    (found[i], found[j]) = if large_is_last { (small, large) } else { (large, small) };
                }
                Distances::Three(found.map(|distance| distance / unit))
            }
            Roots::One { z, w } => {
                let real = above - y * z;
                let leg = above + (y * z).shift(-1);
                let pair = leg.square() + (y * w).square();
                let (real, pair, leg) = if less(real.square(), pair) {
                    (product / pair, pair, leg)
                } else {
                    let pair = product / real;
                    (real, pair, (pairs - pair) / real.shift(1))
                };
                Distances::One([real / unit, pair / unit.square(), leg / unit])
            }
        }
    }
}

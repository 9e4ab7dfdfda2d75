//! The four theta functions of one parameter 0 <= m <= 1, normalised to 1 at the origin, over lanes.
//!
//! With z = pi v / 2K, x = sin^2 z and the nome q <= e^-pi of m <= 1/2, every theta function is a cubic in x
//! (the next term is q^16):
//!   theta1 ~ sin z (1 + ...),  theta2 ~ cos z (1 + ...),  theta3 ~ 1 + ...,  theta4 ~ 1 + ...
//! For m > 1/2 Jacobi's imaginary transformation gives the same cubics in x = -sinh^2 y, y = pi v / 2K', with
//! the complementary nome, and theta2 and theta4 change places. Folded to |v| <= K/2, every correction stays
//! below 0.2 and nothing cancels. With A = 2K/pi (2K'/pi):
//!   sn = A theta1/theta4,  cn = theta2/theta4,  dn = theta3/theta4           for |v| <= K/2,
//!   sn = theta2/theta3,    cn = k' A theta1/theta3,  dn = k' theta4/theta3   with v counted from K.
//! Source: DLMF 20.2, 20.7(viii), 22.2; Whittaker & Watson ch. 21.

use crate::elliptic::agm::agm;
use crate::elliptic::nome::small_nome;
use crate::elliptic::parameter::Unit;
use crate::elliptic::phase::ReducedPhase;
use crate::float::elementary::{quotient, sin_cos, sinh_cosh};
use crate::float::exponent::{exponent, ldexp, mantissa};
use crate::float::series::{long_sin_cos, long_sinh_cosh};
use crate::float::{Dd, HALF_PI, PI, Scaled};
use crate::lanes::{COMPACT, Lane};

/// Which nome is the small one.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Side {
    /// m <= 1/2: the nome of m, circular functions.
    Circular,
    /// m > 1/2: the nome of mc, hyperbolic functions.
    Hyperbolic,
}

/// x (c[0] + x (c[1] + x c[2])), with the first coefficient as hi + lo: its rounding would be the same for
/// every sample of an orbit, and so would not average out.
#[derive(Clone, Copy, Debug)]
struct Correction {
    first: Dd,
    second: f64,
    third: f64,
}

impl Correction {
    /// From the rows of a function in [`SERIES`] and the powers of q that their last three columns name.
    ///
    /// Inlined, so that the rows are constants of the code: a third of the time of a set-up goes by here.
    #[inline(always)]
    fn of(rows: &[[f64; 4]; 4], (first, second, third): (Dd, Dd, f64)) -> Correction {
        let mut sums = [Dd::ZERO; 4];
        // A loop, not `map`, whose closure would be called.
        for (sum, [a, b, c, d]) in sums.iter_mut().zip(rows) {
            let last = Dd::from(third * d);
            let small = if *c == 0.0 { last } else { second * *c + last };
            *sum = if *b == 0.0 { small } else { Dd::from(*a) + first * *b + small };
        }
        let [origin, one, two, three] = sums;
        Correction { first: one / origin, second: two.hi / origin.hi, third: three.hi / origin.hi }
    }
    /// The same in double-double, good to 2^-66.
    fn long_at(&self, x: Dd) -> Dd {
        x * (self.first + Dd::product(x.hi, self.second + x.hi * self.third))
    }
    #[inline(always)]
    fn at<L: Lane>(&self, x: L) -> L {
        let tail = L::splat(self.third).mul_add(x, L::splat(self.second));
        x * (L::splat(self.first.hi) + tail.mul_add(x, L::splat(self.first.lo)))
    }
    /// Derivative of the logarithm of 1 + the correction, by x.
    #[inline(always)]
    fn logarithmic_slope<L: Lane>(&self, x: L) -> L {
        let tail = L::splat(3.0 * self.third).mul_add(x, L::splat(2.0 * self.second));
        tail.mul_add(x, L::splat(self.first.hi)) / (L::splat(1.0) + self.at(x))
    }
}

/// The theta functions of one parameter, from which Neville's follow, and their periods; set up once.
#[derive(Clone, Debug)]
pub struct NevilleTheta {
    side: Side,
    /// Circular or hyperbolic angle of one half period 2K.
    pub angle: Dd,
    /// 2K/pi or 2K'/pi: the factor A of theta1.
    pub theta1_factor: Dd,
    /// Quarter period K (infinite at m = 1).
    pub quarter: Dd,
    /// Complementary modulus k'.
    pub kc: Dd,
    /// K'/K to two digits, not above it.
    pub aspect: f64,
    /// Of theta1/A to theta4, beside sin, cos, 1, 1 on the circular side and sinh, 1, 1, cosh on the hyperbolic one.
    theta: [Correction; 4],
}

/// The theta functions at one reduced argument: theta1 without the factor A; `folded` where the argument is
/// counted from K.
pub struct Thetas<L: Lane> {
    /// theta1/A, theta2, theta3, theta4.
    pub theta: [Dd<L>; 4],
    /// Whether the argument is counted from K.
    pub folded: L::Mask,
}

/// Where k' leaves the range of its inverse: K is ln(4/k') long before.
const LEAST: i32 = -900;

/// Where sinh^2 is larger, its nome is 0 in double: the product must not become 0 times infinity.
const LARGE: f64 = 1e300;

#[inline(always)]
pub(crate) fn bounded_square<L: Lane>(sine: L) -> L {
    let square = sine * sine;
    L::select(L::splat(LARGE).less(square), L::splat(LARGE), square)
}

/// Whether half periods f in [0, 1/2] are nearer to K, and their distance from 0 or from K.
#[inline(always)]
pub(crate) fn fold<L: Lane>(f: Dd<L>) -> (L::Mask, Dd<L>) {
    let folded = L::splat(0.25).less(f.hi);
    (folded, Dd::select(folded, Dd::ordered_sum(L::splat(0.5) - f.hi, -f.lo), f))
}

impl NevilleTheta {
    /// Of a parameter 0 <= m < 1.
    pub fn new(Unit { m, mc, k, kc }: Unit) -> NevilleTheta {
        let mean = agm(kc);
        let quarter = HALF_PI / mean;
        if m.hi <= mc.hi {
            let q = small_nome(m, kc);
            let theta = corrections(q);
            return NevilleTheta {
                aspect: least_aspect(q.hi),
                side: Side::Circular,
                angle: PI,
                theta1_factor: Dd::ONE / mean,
                quarter,
                kc,
                theta,
            };
        }
        let other = agm(k);
        // theta2 and theta4 change places.
        let [t1, t4, t3, t2] = corrections(small_nome(mc, k));
        let angle = PI * other / mean;
        let aspect = PI.hi / angle.hi;
        NevilleTheta {
            side: Side::Hyperbolic,
            angle,
            theta1_factor: Dd::ONE / other,
            quarter,
            kc,
            aspect,
            theta: [t1, t2, t3, t4],
        }
    }

    /// From m and mc of any size.
    pub(crate) fn of_scaled(m: Scaled, mc: Scaled) -> NevilleTheta {
        let kc = mc.sqrt();
        if kc.power() < LEAST {
            let mut limit = NevilleTheta::new(Unit {
                m: Dd::ONE,
                mc: Dd::ZERO,
                k: Dd::ONE,
                kc: ldexp(1.0, LEAST).into(),
            });
            let quarter = kc.shift(-2).minus_ln();
            limit.angle = limit.angle * quarter / limit.quarter;
            (limit.quarter, limit.kc) = (quarter, kc.to_dd());
            return limit;
        }
        let [m, mc, k, kc] = [m, mc, m.sqrt(), kc].map(Scaled::to_dd);
        NevilleTheta::new(Unit { m, mc, k, kc })
    }

    /// Whether [`NevilleTheta::thetas_on`] takes the hyperbolic side.
    pub fn hyperbolic(&self) -> bool {
        self.side == Side::Hyperbolic
    }

    /// Whether a formula over [`NevilleTheta::thetas_on`] is to be the hyperbolic one. On a page, where that looks for itself,
    /// one of both serves: nothing more is compiled.
    pub fn by_hyperbolic(&self) -> bool {
        COMPACT || self.hyperbolic()
    }

    /// Theta functions at v = 2K f, 0 <= f <= 1/2, for a parameter on that side.
    #[inline(always)]
    pub fn thetas_on<const HYPERBOLIC: bool, L: Lane>(&self, f: Dd<L>) -> Thetas<L> {
        if L::APART { self.thetas_apart(f) } else { self.thetas_inlined::<HYPERBOLIC, L>(f) }
    }

    /// The same of either side, as a function.
    #[inline(never)]
    fn thetas_apart<L: Lane>(&self, f: Dd<L>) -> Thetas<L> {
        if self.hyperbolic() { self.thetas_inlined::<true, L>(f) } else { self.thetas_inlined::<false, L>(f) }
    }

    #[inline(always)]
    fn thetas_inlined<const HYPERBOLIC: bool, L: Lane>(&self, f: Dd<L>) -> Thetas<L> {
        let (folded, v) = fold(f);
        let angle = v * Dd::splat(self.angle);
        let one = Dd::from_double(L::splat(1.0));
        let ([first, second, third, fourth], x) = if HYPERBOLIC {
            let (sine, cosine) = sinh_cosh(angle);
            ([sine, one, one, cosine], -bounded_square(sine.hi))
        } else {
            let (sine, cosine) = sin_cos(angle);
            ([sine, cosine, one, one], sine.hi * sine.hi)
        };
        let [t1, t2, t3, t4] = &self.theta;
        let theta =
            [first.nudge(t1.at(x)), second.nudge(t2.at(x)), third.nudge(t3.at(x)), fourth.nudge(t4.at(x))];
        Thetas { theta, folded }
    }

    /// sn, cn, dn in double at 2K f, 0 <= f <= 1/2; whether that is nearer to K; and the slope of ln theta4 there (of ln theta3,
    /// counted from K) by its circular or hyperbolic angle, which is Jacobi's zeta but for factors.
    #[inline(always)]
    pub(crate) fn short_values<const HYPERBOLIC: bool, L: Lane>(&self, f: Dd<L>) -> ([L; 3], L::Mask, L) {
        let (folded, v) = fold(f);
        let angle = v * Dd::splat(self.angle);
        let [t1, t2, t3, t4] = &self.theta;
        let (factor, kc) = (L::splat(self.theta1_factor.hi), L::splat(self.kc.hi));
        let one = L::splat(1.0);
        let (sine, cosine) = if HYPERBOLIC { sinh_cosh(angle) } else { sin_cos(angle) };
        let (sine, cosine) = (sine.hi, cosine.hi);
        let side = L::splat(if HYPERBOLIC { -1.0 } else { 1.0 });
        let (x, twice) = (sine * sine * side, sine * cosine * side * L::splat(2.0));
        let tail = t4.logarithmic_slope(x) * twice;
        let near = if HYPERBOLIC { sine / cosine + tail } else { tail };
        let far = t3.logarithmic_slope(x) * twice;
        let (second, fourth) = if HYPERBOLIC { (one, cosine) } else { (cosine, one) };
        let (t1, t2) = (sine * (one + t1.at(x)), second * (one + t2.at(x)));
        let (t3, t4) = (one + t3.at(x), fourth * (one + t4.at(x)));
        let below = one / L::select(folded, t3, t4);
        let (t1, upper) = (t1 * factor, kc * below);
        let sn = L::select(folded, t2, t1) * below;
        let cn = L::select(folded, t1 * upper, t2 * below);
        let dn = L::select(folded, t4 * upper, t3 * below);
        ([sn, cn, dn], folded, L::select(folded, far, near))
    }

    /// [`NevilleTheta::thetas_on`] good to 2^-64: for steps that are repeated, whose errors would add up.
    pub fn long_thetas(&self, f: Dd) -> Thetas<f64> {
        let (folded, v) = fold(f);
        let angle = v * self.angle;
        let (leads, x) = match self.side {
            Side::Circular => {
                let (sine, cosine) = long_sin_cos(angle);
                ([sine, cosine, Dd::ONE, Dd::ONE], sine.square())
            }
            Side::Hyperbolic => {
                let (sine, cosine) = long_sinh_cosh(angle);
                let square = sine.square();
                let x = if square.hi > LARGE { Dd::from(-LARGE) } else { -square };
                ([sine, Dd::ONE, Dd::ONE, cosine], x)
            }
        };
        Thetas { theta: [0, 1, 2, 3].map(|i| leads[i] + leads[i] * self.theta[i].long_at(x)), folded }
    }

    /// sn, cn, dn at a reduced phase, with the digits of [`NevilleTheta::long_thetas`].
    pub fn long_values(&self, at: &ReducedPhase<f64>) -> [Dd; 3] {
        let Thetas { theta: [t1, t2, t3, t4], folded } = self.long_thetas(at.f);
        let t1 = t1 * self.theta1_factor;
        let [sn, cn, dn] = if folded {
            [t2 / t3, self.kc * t1 / t3, self.kc * t4 / t3]
        } else {
            [t1 / t4, t2 / t4, t3 / t4]
        };
        [sn.scale(at.sign * at.parity), cn.scale(at.parity), dn]
    }
}

/// -ln q/pi from below, with a straight line for the logarithm of the mantissa.
fn least_aspect(q: f64) -> f64 {
    const LN_2_OVER_PI: f64 = 0.220_635_600_152_651_6;
    let logarithm = if q == 0.0 { -1075.0 } else { f64::from(exponent(q)) + mantissa(q) - 0.91 };
    -LN_2_OVER_PI * logarithm
}

/// theta1/sin, theta2/cos, theta3, theta4 as cubics in x = sin^2 z, a row for each power of x; the columns are powers of
/// q: 0, 2, 6, 12 for the first two, 0, 1, 4, 9 for the others.
const SERIES: [[[f64; 4]; 4]; 4] = [
    [[1.0, -3.0, 5.0, -7.0], [0.0, 4.0, -20.0, 56.0], [0.0, 0.0, 16.0, -112.0], [0.0, 0.0, 0.0, 64.0]],
    [[1.0, 1.0, 1.0, 1.0], [0.0, -4.0, -12.0, -24.0], [0.0, 0.0, 16.0, 80.0], [0.0, 0.0, 0.0, -64.0]],
    [[1.0, 2.0, 2.0, 2.0], [0.0, -4.0, -16.0, -36.0], [0.0, 0.0, 16.0, 96.0], [0.0, 0.0, 0.0, -64.0]],
    [[1.0, -2.0, 2.0, -2.0], [0.0, 4.0, -16.0, 36.0], [0.0, 0.0, 16.0, -96.0], [0.0, 0.0, 0.0, 64.0]],
];

/// Corrections of theta1/sin, theta2/cos, theta3, theta4 in powers of sin^2.
fn corrections(q: Dd) -> [Correction; 4] {
    let q2 = q.square();
    let q4 = q2.square();
    let (q6, q9, q12) = (q4.hi * q2.hi, q4.hi * q4.hi * q.hi, q4.hi * q4.hi * q4.hi);
    let (even, odd) = ((q2, Dd::from(q6), q12), (q, q4, q9));
    [
        Correction::of(&SERIES[0], even),
        Correction::of(&SERIES[1], even),
        Correction::of(&SERIES[2], odd),
        Correction::of(&SERIES[3], odd),
    ]
}

/// A [`Correction`] per lane, in double.
#[derive(Clone, Copy)]
pub(crate) struct ShortCorrection<L: Lane>([L; 3]);

/// What theta1/sin, theta2/cos, theta3 and theta4 of a nome per lane, at most e^-pi, are beyond 1 in x = sin^2 (not normalised):
/// by 2 cos 2z, as the first two differ in the sign of its odd powers only, and so do the last two.
#[inline(always)]
pub(crate) fn excesses<L: Lane>(q: L, x: L) -> [L; 4] {
    let (one, two) = (L::splat(1.0), L::splat(2.0));
    let [[q2, q6, q12], [_, q4, q9]] = powers(q);
    let double = x.mul_add(L::splat(-4.0), two);
    let square = double * double;
    let even = (q6 - q12).mul_add(square - one, -q2);
    let odd = double * q12.mul_add(square - two, q2 - q6);
    let of_fourth = q4 * (square - two);
    let of_first = double * q9.mul_add(square - L::splat(3.0), q);
    [even - odd, even + odd, of_fourth + of_first, of_fourth - of_first]
}

/// theta2/2 q^1/4 and theta3 at 0 beyond 1, of a nome per lane.
#[inline(always)]
pub(crate) fn excesses_at_zero<L: Lane>(q: L) -> [L; 2] {
    let [[q2, q6, q12], [_, q4, q9]] = powers(q);
    [q2 + (q6 + q12), (q + (q4 + q9)) * L::splat(2.0)]
}

/// The powers of the nome in the last columns of the series: of theta1 and theta2, and of theta3 and theta4.
#[inline(always)]
fn powers<L: Lane>(q: L) -> [[L; 3]; 2] {
    let q2 = q * q;
    let q4 = q2 * q2;
    [[q2, q4 * q2, q4 * q4 * q4], [q, q4, q4 * q4 * q]]
}

/// theta1/sin, theta2/cos, theta3 or theta4 as a cubic per lane: row `function` of the series, in the powers of q that its
/// columns name.
#[inline(always)]
fn cubic<L: Lane>(function: usize, [first, second, third]: [L; 3]) -> [L; 4] {
    let mut rows = [L::splat(0.0); 4];
    for (row, powers) in rows.iter_mut().zip(SERIES[function]) {
        *row = first.mul_add(L::splat(powers[1]), small_terms(powers, second, third)) + L::splat(powers[0]);
    }
    rows
}

/// What the last two columns of a row of the series give.
#[inline(always)]
fn small_terms<L: Lane>([.., c, d]: [f64; 4], second: L, third: L) -> L {
    second.mul_add(L::splat(c), third * L::splat(d))
}

impl<L: Lane> ShortCorrection<L> {
    /// Of two cubics: with one division.
    #[inline(always)]
    fn pair([a, a1, a2, a3]: [L; 4], [b, b1, b2, b3]: [L; 4]) -> [Self; 2] {
        let inverse = L::splat(1.0) / (a * b);
        let (of_a, of_b) = (b * inverse, a * inverse);
        [
            ShortCorrection([a1 * of_a, a2 * of_a, a3 * of_a]),
            ShortCorrection([b1 * of_b, b2 * of_b, b3 * of_b]),
        ]
    }
    #[inline(always)]
    pub fn at(&self, x: L) -> L {
        let [first, second, third] = self.0;
        x * third.mul_add(x, second).mul_add(x, first)
    }
}

/// [`corrections`] of a nome per lane, in double.
#[inline(always)]
pub(crate) fn short_corrections<L: Lane>(q: L) -> [ShortCorrection<L>; 4] {
    let [even, odd] = powers(q);
    let [first, second] = ShortCorrection::pair(cubic(0, even), cubic(1, even));
    let [third, fourth] = ShortCorrection::pair(cubic(2, odd), cubic(3, odd));
    [first, second, third, fourth]
}

/// `twice` times the derivative by x of the logarithm of a cubic of a nome per lane, theta2/cos, theta3 or theta4 by its index
/// less one: with full digits where it is small.
#[inline(always)]
pub(crate) fn logarithmic_slope<L: Lane>(function: usize, q: Dd<L>, x: L, twice: Dd<L>) -> Dd<L> {
    let [even, odd] = powers(q.hi);
    let (first, [_, second, third]) = if function == 1 { (Dd::from_double(even[0]), even) } else { (q, odd) };
    let [origin, one, two, three] = SERIES[function];
    let (two, three) = (small_terms(two, second, third), small_terms(three, second, third));
    let lead = first.scale(L::splat(one[1]));
    let lead = Dd::new(lead.hi, lead.lo + small_terms(one, second, third));
    let above = three.mul_add(L::splat(3.0) * x, two + two) * x;
    let above = Dd::sum(lead.hi, lead.lo + above);
    let below = x * x.mul_add(x.mul_add(three, two), lead.value());
    let below = below + first.hi.mul_add(L::splat(origin[1]), small_terms(origin, second, third));
    quotient(above * twice, Dd::sum(L::splat(1.0), below))
}

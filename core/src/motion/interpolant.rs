//! Half a period of a motion as polynomials: no sine, no theta function, no arctangent per sample.
//!
//! Let f in [-1/2, 1/2] be half periods from the base of the motion, and x = f^2. A function that is even about the base
//! is a polynomial in t = (w + b)/(1 + b w), w = 8 x - 1. An odd function has a factor f besides, and one that is zero at
//! the ends has 1/4 - x. As functions of w they are analytic up to the nearest singularities. The Moebius parameter b is
//! the one that maps these farthest from [-1, 1]: this saves a third to a half of the terms. The leading coefficient is
//! most of the sum, so it is kept as hi + lo. The coefficients are found by interpolation when the first sample is needed:
//! docs/decisions/0011.

use super::chebyshev::{COUNTS, Interpolation, MOST};
use crate::elliptic::theta::neville::NevilleTheta;
use crate::float::Dd;
use crate::float::double_double::fast_two_sum;
use crate::float::exponent::exp2;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{COMPACT, Columns, Evaluation, Formula, Lane};

/// A polynomial in t, its first two coefficients to double-double.
#[derive(Clone, Debug)]
struct Monomials {
    lead: Dd,
    first_rest: f64,
    /// Coefficients of t and t^2, t^3 and t^4, ...: as many as the map counts.
    pairs: [[f64; 2]; MOST / 2],
}

/// The polynomials of two functions of one motion.
#[derive(Clone, Debug)]
pub(crate) struct Interpolant {
    map: ConformalMap,
    first: Monomials,
    second: Monomials,
}

/// The map of a motion's half period, and how many terms it needs.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ConformalMap {
    /// Terms, one of [`COUNTS`].
    count: usize,
    /// b of the map, a multiple of 2^-20, so that 1 - b is exact.
    moebius: f64,
}

/// Largest last term, relative to a value. The terms that are left out are about a tenth of it.
const LAST_TERM: f64 = 2.3e-16; // 2^-52

/// Largest error that a rounding of t may cause, in units of that rounding.
const STEEPEST: f64 = 2.0;

/// A node of the interpolation.
#[derive(Clone, Copy)]
pub(crate) struct Node<L: Lane> {
    /// Half periods from the base, in (0, 1/2).
    pub f: Unnormalised<L>,
    /// 1/4 - f^2, not by subtraction.
    pub to_ends: Unnormalised<L>,
}

/// Two functions of f, even about the base. The factors that every sample has (f, 1/4 - f^2 and so on) are divided out.
pub(crate) trait EvenFunctions {
    /// Their values at a node; `#[inline(always)]`.
    fn at<L: Lane>(&self, place: Node<L>) -> [Unnormalised<L>; 2];
}

/// u and u' on one side of the base of a motion, without the factors that every sample has.
pub(crate) trait OneSide {
    /// At f and 1/2 - f from the base, in (0, 1/2), in half periods or, for an escape, in times from pole to pole;
    /// `#[inline(always)]`.
    fn at<L: Lane>(&self, f: Unnormalised<L>, rest: Unnormalised<L>) -> [Unnormalised<L>; 2];
}

/// The sum of the semi-axes of the ellipse with foci -1 and 1 through that foot.
fn semi_axes(foot: f64) -> f64 {
    foot + (foot * foot - 1.0).sqrt()
}

/// b to a multiple of 2^-20.
fn rounded(moebius: f64) -> f64 {
    (1_048_576.0 * moebius).round() / 1_048_576.0
}

impl ConformalMap {
    /// How many terms.
    pub fn count(&self) -> usize {
        self.count
    }

    /// For functions whose nearest singularity is f = i K'/2K, if few enough terms serve: up to about 170 degrees.
    pub fn of(lattice: &NevilleTheta) -> Option<ConformalMap> {
        let ellipse = semi_axes(1.0 + 2.0 * lattice.aspect * lattice.aspect);
        // 1/b = the sum of the semi-axes of the ellipse through it: as far out to the left as infinity to the right.
        let moebius = rounded(1.0 / ellipse);
        ConformalMap::with(ellipse, moebius)
    }

    /// For singularities at these complex f, with their negatives and conjugates.
    pub fn around<const N: usize>(singularities: &[[f64; 2]; N]) -> Option<ConformalMap> {
        // Of each its w, and its distances to -1 and 1.
        let size = |re: f64, im: f64| (re * re + im * im).sqrt();
        let places = singularities.map(|[re, im]| {
            let (w, v) = (8.0 * (re * re - im * im) - 1.0, 16.0 * re * im);
            [w, v, size(w + 1.0, v), size(w - 1.0, v)]
        });
        // Semi-major axis of the ellipse through the image of the nearest one, and of infinity, which is 1/b.
        let reach = |moebius: f64| {
            let far = |reach: f64, [w, v, left, right]: &[f64; 4]| {
                let axis = 0.5 * ((1.0 - moebius) * right + (1.0 + moebius) * left);
                reach.min(axis / size(1.0 + moebius * w, moebius * v))
            };
            places.iter().fold(1.0 / moebius.abs(), far)
        };
        // Each of these exceeds a bound where a linear function of b exceeds a convex one: on an interval. So does the
        // least of them, and the search that halves by thirds finds the best.
        let (mut low, mut high) = (-0.5, 0.5);
        while high - low > 0.01 {
            let third = (high - low) / 3.0;
            if reach(low + third) < reach(high - third) { low += third } else { high -= third }
        }
        let moebius = rounded(0.5 * (low + high));
        let best = ConformalMap::with(reach(moebius), moebius)?;
        // As many terms without a map are fewer operations.
        let straight = ConformalMap::with(reach(0.0), 0.0);
        Some(straight.filter(|straight| straight.count <= best.count).unwrap_or(best))
    }

    fn with(foot: f64, moebius: f64) -> Option<ConformalMap> {
        let decay = semi_axes(foot).min(1e6).powi(4);
        // The error of n terms is some decay^(-n/4).
        const ENOUGH: f64 = 3.7e19; // 2^65
        let count = COUNTS.into_iter().find(|count| decay.powi(*count as i32 / 4) >= ENOUGH)?;
        Some(ConformalMap { count, moebius })
    }
}

impl Monomials {
    fn new(coefficients: &[Dd; MOST]) -> Monomials {
        let mut pairs = [[0.0; 2]; MOST / 2];
        for (i, coefficient) in coefficients.iter().enumerate().skip(1) {
            pairs[(i - 1) / 2][(i - 1) % 2] = coefficient.hi;
        }
        Monomials { lead: coefficients[0], first_rest: coefficients[1].lo, pairs }
    }

    /// Whether the polynomial is as accurate as the values that it interpolates.
    ///
    /// Three conditions hold. The terms after the leading one add up to at most `most` times the least value, so that their
    /// rounding is small. The last term, and a sixteenth of the one before, are small: otherwise there is a singularity
    /// nearer than those of the map. A rounding of t, which is largest far from t = -1 (x = 0), has a small effect.
    fn keeps(&self, points: &[f64], values: &[f64], most: f64) -> bool {
        let terms = &self.pairs.as_flattened()[..values.len() - 1];
        let least = values.iter().fold(f64::INFINITY, |least, value| least.min(value.abs()));
        let spread = terms.iter().fold(0.0, |sum, term| sum + term.abs());
        // t^k is 2^(1 - k) of Chebyshev's polynomial, and smaller ones.
        let of = |k: usize| (terms[k - 1] * exp2(1 - k as i32)).abs();
        let last = of(terms.len()).max(of(terms.len() - 1) / 16.0);
        let slope = |t: f64| {
            terms.iter().enumerate().rev().fold(0.0, |sum, (k, term)| sum * t + term * (k + 1) as f64)
        };
        let cost = |(t, value): (&f64, &f64)| (1.0 + t) * (slope(*t) / value).abs();
        // Each is false for NaN as well.
        spread / least <= most
            && last / least <= LAST_TERM
            && points.iter().zip(values).all(|each| cost(each) <= STEEPEST)
    }

    /// At t.
    #[inline(always)]
    fn at<L: Lane>(&self, count: usize, t: L) -> Dd<L> {
        let square = t * t;
        let (mut odd, mut even) = (L::splat(0.0), L::splat(0.0));
        if COMPACT {
            // Odd and even powers separately: two chains of half the length. The slice would be a call in every row: see
            // Lane::load_at.
            let mut i = count / 2;
            while i > 0 {
                i -= 1;
                let [a, b] = self.pairs[i];
                odd = odd.mul_add(square, L::splat(a));
                even = even.mul_add(square, L::splat(b));
            }
        } else {
            // Four chains of a quarter of the length: two would wait for their own results. Counts are multiples of four, and the
            // last power of the last group is none.
            let fourth = square * square;
            let (groups, last) = (self.pairs.as_chunks().0, count / 4 - 1);
            let [[a, b], [c, _]] = groups[last];
            (odd, even) = (L::splat(a), L::splat(b));
            let (mut third, mut above) = (L::splat(c), L::splat(0.0));
            for [[a, b], [c, d]] in groups[..last].iter().rev() {
                odd = odd.mul_add(fourth, L::splat(*a));
                even = even.mul_add(fourth, L::splat(*b));
                third = third.mul_add(fourth, L::splat(*c));
                above = above.mul_add(fourth, L::splat(*d));
            }
            odd = third.mul_add(square, odd);
            even = above.mul_add(square, even);
        }
        let (hi, error) = fast_two_sum(L::splat(self.lead.hi), t * even.mul_add(t, odd));
        Dd::new(hi, error + t.mul_add(L::splat(self.first_rest), L::splat(self.lead.lo)))
    }
}

impl Interpolant {
    /// The interpolant of two functions.
    pub fn new(map: ConformalMap, functions: &impl EvenFunctions) -> Interpolant {
        Interpolant::through(map, functions).0
    }

    /// The interpolant of two functions, if no digits are lost. `most` is the largest sum of the terms after the leading one,
    /// in units of the least value.
    pub fn faithful(map: ConformalMap, functions: &impl EvenFunctions, most: f64) -> Option<Interpolant> {
        let (arc, values) = Interpolant::through(map, functions);
        let count = map.count;
        let points = &Interpolation::of(count).points[0];
        let keeps = |powers: &Monomials, values: &[f64; MOST]| powers.keeps(points, &values[..count], most);
        (keeps(&arc.first, &values[0]) && keeps(&arc.second, &values[2])).then_some(arc)
    }

    /// The interpolant of two functions, and their values at the nodes, each as hi and lo.
    #[cold]
    #[inline(never)]
    fn through(map: ConformalMap, functions: &impl EvenFunctions) -> (Interpolant, [[f64; MOST]; 4]) {
        let ConformalMap { count, moebius } = map;
        let interpolation = Interpolation::of(count);
        let mut values = [[0.0; MOST]; 4];
        let [hi, lo] = &interpolation.points;
        let columns = values.each_mut().map(|column| &mut column[..count]);
        Columns::new([hi, lo], columns).of(&AtNodes { functions, moebius });
        let [first, first_rest, second, second_rest] = &values;
        let powers = |hi: &[f64], lo: &[f64]| {
            Monomials::new(&interpolation.coefficients([&hi[..count], &lo[..count]]))
        };
        (Interpolant { map, first: powers(first, first_rest), second: powers(second, second_rest) }, values)
    }

    /// How many terms.
    #[inline(always)]
    pub fn count(&self) -> usize {
        self.map.count
    }

    /// t of half periods f, |f| up to about 1/2.
    #[inline(always)]
    pub fn mapped<L: Lane>(&self, f: Dd<L>) -> L {
        let x = f.hi * f.hi;
        let flat = L::splat(1.0 - self.map.moebius);
        if self.map.moebius == 0.0 {
            return L::splat(8.0).mul_add(x, -flat);
        }
        L::splat(8.0).mul_add(x, -flat) / L::splat(8.0 * self.map.moebius).mul_add(x, flat)
    }

    /// The first function, |f| up to about 1/2; hi + lo not normalised.
    #[inline(always)]
    pub fn first<L: Lane>(&self, f: Dd<L>) -> Unnormalised<L> {
        self.first_at(self.mapped(f))
    }

    /// The second, likewise.
    #[inline(always)]
    pub fn second<L: Lane>(&self, f: Dd<L>) -> Unnormalised<L> {
        self.second_at(self.mapped(f))
    }

    /// The first function where f is mapped to t.
    #[inline(always)]
    pub fn first_at<L: Lane>(&self, t: L) -> Unnormalised<L> {
        self.first.at(self.map.count, t).into()
    }

    /// The second, likewise.
    #[inline(always)]
    pub fn second_at<L: Lane>(&self, t: L) -> Unnormalised<L> {
        self.second.at(self.map.count, t).into()
    }
}

/// 1/4 - f^2, also next to the ends.
#[inline(always)]
pub(crate) fn to_ends<L: Lane>(f: Dd<L>) -> Unnormalised<L> {
    let half = L::splat(0.5);
    let size = f.scale(L::splat(1.0).copysign(f.hi));
    let (above, above_error) = fast_two_sum(half, size.hi);
    let below = (half - size.hi) - size.lo;
    let (factor, error) = above.two_product_in_range(below);
    let below_error = ((half - size.hi) - below) - size.lo;
    Unnormalised::new(factor, above.mul_add(below_error, (above_error + size.lo).mul_add(below, error)))
}

/// A product, rounded.
#[inline(always)]
pub(crate) fn rounded_product<L: Lane>(a: Unnormalised<L>, b: Unnormalised<L>) -> L {
    a.hi.mul_add(b.hi, a.hi.mul_add(b.lo, a.lo * b.hi))
}

/// The two functions at the nodes, as high and low words.
struct AtNodes<'a, C> {
    functions: &'a C,
    moebius: f64,
}

impl<C: EvenFunctions> Formula<2, 4> for AtNodes<'_, C> {
    type Place = C;
    #[inline(always)]
    fn at<L: Lane>(&self, [hi, lo]: [L; 2]) -> [L; 4] {
        let one = Unnormalised::from_double(L::splat(1.0));
        let moebius = Unnormalised::from_double(L::splat(self.moebius));
        let t = Unnormalised::new(hi, lo);
        // x = (1 - b)(1 + t)/8(1 - b t), and 1/4 - x = (1 + b)(1 - t)/8(1 - b t).
        let scale = (one - moebius * t).scale(L::splat(8.0));
        let x = ((one - moebius) * (one + t)).over(scale);
        let to_ends = ((one + moebius) * (one - t)).over(scale);
        let [first, second] = self.functions.at(Node { f: x.root(), to_ends });
        [first.hi, first.lo, second.hi, second.lo]
    }
}

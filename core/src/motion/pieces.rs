//! Half a period of a motion as sixteen polynomials, where one would need too many terms: next to a separatrix.
//!
//! With f in [0, 1/2] half periods from the base of the motion, w = 1 + 6 f lies in [1, 4]. The pieces divide each octave
//! of w into eight, so they are half as wide next to the base, where the singularities are. A piece is picked by the first
//! bits of w, and its coefficients are looked up in a register. As in interpolant.rs the functions are even about the
//! base, their factors f and 1/4 - f^2 are divided out, and the leading coefficient is hi + lo.
//! Method: docs/decisions/0011.

use super::chebyshev::{Interpolation, MOST, PIECE};
use super::interpolant::{EvenFunctions, Node};
use crate::float::Dd;
use crate::float::double_double::fast_two_sum;
use crate::float::exponent::exp2;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Columns, Evaluation, Formula, Lane, PIECES};

/// w is 1 + `SCALE` f, but for the choice of the piece, where 4 must not be reached, also where f is 2^-20 beyond its end. So a
/// polynomial is asked for values up to 2^-12 of its half width beyond its own: its last terms are a twentieth larger there.
const SCALE: f64 = 6.0;
const NOT_QUITE: f64 = SCALE * (1.0 - 1.0 / 131_072.0);

/// Terms of a polynomial.
const TERMS: usize = PIECE;

/// Longest quarter period K. The nearest singularity is pi/2 from the base, and the piece there is K/24 wide: its Chebyshev
/// coefficients fall by 10 from term to term, and what is left out of a pole's function is 2^-59 of it. Pieces far from the base
/// are twice as wide: there the velocity falls by 3.6, so its last digits are still those of the leading term.
pub(crate) const LONGEST_QUARTER: f64 = 15.5;

/// The polynomials of one function: an array of the pieces for each coefficient.
#[derive(Clone, Debug)]
struct PiecewiseMonomials {
    lead: [f64; PIECES],
    lead_rest: [f64; PIECES],
    /// Coefficients of s and s^2, s^3 and s^4, ..., with s = 6 (f - middle).
    pairs: [[[f64; PIECES]; 2]; TERMS / 2],
}

/// The polynomials of two functions of one motion.
#[derive(Clone, Debug)]
pub(crate) struct Pieces {
    first: PiecewiseMonomials,
    second: PiecewiseMonomials,
}

/// The middle f of each piece, rounded, in the order in which the bits of w count them: the upper octave first.
const MIDDLES: [f64; PIECES] = middles();

const fn middles() -> [f64; PIECES] {
    let mut middles = [0.0; PIECES];
    let mut i = 0;
    while i < PIECES / 2 {
        middles[i] = (1.0 + 0.25 * (i as f64 + 0.5)) / SCALE;
        middles[PIECES / 2 + i] = 0.125 * (i as f64 + 0.5) / SCALE;
        i += 1;
    }
    middles
}

/// Half the width of a piece in w.
const fn half_width(piece: usize) -> f64 {
    if piece < PIECES / 2 { 0.125 } else { 0.0625 }
}

impl PiecewiseMonomials {
    const ZERO: PiecewiseMonomials = PiecewiseMonomials {
        lead: [0.0; PIECES],
        lead_rest: [0.0; PIECES],
        pairs: [[[0.0; PIECES]; 2]; TERMS / 2],
    };

    /// The polynomial of a piece from its coefficients in s over half its width, a power of two.
    fn set(&mut self, piece: usize, coefficients: &[Dd; MOST]) {
        (self.lead[piece], self.lead_rest[piece]) = (coefficients[0].hi, coefficients[0].lo);
        let per_width = if piece < PIECES / 2 { 3 } else { 4 };
        for (k, coefficient) in coefficients.iter().enumerate().take(TERMS).skip(1) {
            self.pairs[(k - 1) / 2][(k - 1) % 2][piece] = coefficient.hi * exp2(per_width * k as i32);
        }
    }

    #[inline(always)]
    fn at<L: Lane>(&self, w: L, s: L) -> Unnormalised<L> {
        // Odd and even powers separately: two chains of half the length. The last pair has the odd one only.
        let square = s * s;
        let mut k = TERMS / 2 - 1;
        let mut odd = w.lookup(&self.pairs[k][0]);
        let mut even = L::splat(0.0);
        while k > 0 {
            k -= 1;
            odd = odd.mul_add(square, w.lookup(&self.pairs[k][0]));
            even = even.mul_add(square, w.lookup(&self.pairs[k][1]));
        }
        let (hi, error) = fast_two_sum(w.lookup(&self.lead), s * even.mul_add(s, odd));
        Unnormalised::new(hi, error + w.lookup(&self.lead_rest))
    }
}

/// The piece of |f|, and how far it is from its middle, in w.
#[inline(always)]
fn placed<L: Lane>(f: Dd<L>) -> (L, L) {
    let size = f.hi.abs();
    let w = L::splat(NOT_QUITE).mul_add(size, L::splat(1.0));
    // The difference is exact but next to 0, where the functions hardly depend on it.
    let s = (size - w.lookup(&MIDDLES)) + f.lo * L::splat(1.0).copysign(f.hi);
    (w, s * L::splat(SCALE))
}

impl Pieces {
    #[cold]
    #[inline(never)]
    pub fn new(functions: &impl EvenFunctions) -> Pieces {
        let interpolation = Interpolation::of(TERMS);
        let [hi, lo] = &interpolation.points;
        let mut pieces = Pieces { first: PiecewiseMonomials::ZERO, second: PiecewiseMonomials::ZERO };
        let (mut nodes, mut values) = ([[[0.0; TERMS]; PIECES]; 4], [[[0.0; TERMS]; PIECES]; 4]);
        for piece in 0..PIECES {
            nodes[0][piece].fill(MIDDLES[piece]);
            nodes[1][piece].fill(half_width(piece));
            nodes[2][piece].copy_from_slice(hi);
            nodes[3][piece].copy_from_slice(lo);
        }
        let columns = nodes.each_ref().map(|column| column.as_flattened());
        Columns::new(columns, values.each_mut().map(|column| column.as_flattened_mut()))
            .of(&AtPieceNodes(functions));
        let [first, first_rest, second, second_rest] = &values;
        for piece in 0..PIECES {
            let coefficients =
                |[hi, lo]: [&[[f64; TERMS]; PIECES]; 2]| interpolation.coefficients([&hi[piece], &lo[piece]]);
            pieces.first.set(piece, &coefficients([first, first_rest]));
            pieces.second.set(piece, &coefficients([second, second_rest]));
        }
        pieces
    }

    /// The first function, |f| up to about 1/2.
    #[inline(always)]
    pub fn first<L: Lane>(&self, f: Dd<L>) -> Unnormalised<L> {
        let (w, s) = placed(f);
        self.first.at(w, s)
    }

    /// The second, likewise.
    #[inline(always)]
    pub fn second<L: Lane>(&self, f: Dd<L>) -> Unnormalised<L> {
        let (w, s) = placed(f);
        self.second.at(w, s)
    }
}

/// The two functions, as high and low words, at nodes of pieces: middle f, half the width in w, and the node in [-1, 1].
struct AtPieceNodes<'a, C>(&'a C);

impl<C: EvenFunctions> Formula<4, 4> for AtPieceNodes<'_, C> {
    type Place = C;
    #[inline(always)]
    fn at<L: Lane>(&self, [middle, half_width, hi, lo]: [L; 4]) -> [L; 4] {
        let s = Unnormalised::new(hi, lo).scale(half_width);
        let sixth = Unnormalised::splat(SIXTH);
        let (middle, half) = (Unnormalised::from_double(middle), Unnormalised::from_double(L::splat(0.5)));
        let away = s * sixth;
        let f = middle + away;
        // Not 1/2 - f, which cancels next to the end.
        let to_ends = ((half - middle) - away) * (half + f);
        let [first, second] = self.0.at(Node { f, to_ends });
        [first.hi, first.lo, second.hi, second.lo]
    }
}

/// 1/6.
const SIXTH: Dd = Dd::new(0.16666666666666666, 9.25185853854297e-18);

#[cfg(test)]
mod tests {
    use super::*;

    /// 1/(a^2 + f^2) alone and times 1 + f^2, with the poles of the longest motion.
    struct Poles;
    const POLE: f64 = 0.002567;

    impl EvenFunctions for Poles {
        #[inline(always)]
        fn at<L: Lane>(&self, Node { f, .. }: Node<L>) -> [Unnormalised<L>; 2] {
            let value = (f.square() + Unnormalised::from_double(L::splat(POLE))).inverse();
            [value, value * (Unnormalised::from_double(L::splat(1.0)) + f.square())]
        }
    }

    /// On every piece, on both sides of the base, at the seams and a little beyond the end.
    #[test]
    fn functions_with_poles_are_followed() {
        let pieces = Pieces::new(&Poles);
        let mut places: Vec<f64> = (0..=6000).map(|i| f64::from(i) / 12000.0).collect();
        for seam in 0..=8 {
            for w in [1.0 + f64::from(seam) / 8.0, 2.0 + f64::from(seam) / 4.0] {
                let seam: f64 = (w - 1.0) / SCALE;
                places.extend([seam.next_down(), seam, seam.next_up(), seam * (1.0 + 1.9e-6)]);
            }
        }
        for hi in places {
            for f in [Dd::new(hi, hi * 1e-17), Dd::new(-hi, hi * 1e-17)] {
                let truth = Dd::ONE / (f.square() + Dd::from(POLE));
                let (first, second) = (pieces.first::<f64>(f), pieces.second::<f64>(f));
                let error = |found: Unnormalised<f64>, truth: Dd| ((found.tight() - truth) / truth).hi.abs();
                assert!(error(first, truth) < 2.0 * f64::EPSILON, "{hi}");
                let truth = truth * (Dd::ONE + f.square());
                assert!(error(second, truth) < 2.0 * f64::EPSILON, "{hi}");
            }
        }
    }
}

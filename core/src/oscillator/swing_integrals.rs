//! Integrals over half a swing (swing_interval.rs) by the trapezoidal rule, with a number of points that is known before.
//!
//! Of a motion that repeats, with E = tan^2(x), integrands are even functions of x with the period pi, analytic up to
//! Im x = eta = artanh(sqrt rho), rho <= 1 the ratio of -E (or its inverse) at the nearest place where a factor vanishes; M points between 0 and
//! pi/2 leave an error of the order of e^(-4 eta M). Where eta is small, E = e^x: all places where a factor vanishes are at Im x = pi, or
//! at pi/2 or more from a pair of complex roots, where the interval is divided at its real part; a step h leaves
//! e^(-2 pi d/h) for every d below that, however near the roots are.
//! Source: Trefethen & Weideman, SIAM Rev. 56 (2014) 385, theorems 3.2 and 5.1.

use super::swing_interval::{ComplexPair, Place, Ratio, SwingInterval};
use crate::float::scaled::Scaled;
use crate::float::series::quarter_turn;
use crate::float::triple_double::Td;
use crate::float::{Dd, HALF_PI};

/// How an integral is summed.
#[derive(Clone, Copy, Debug)]
pub(super) enum Rule {
    /// E = tan^2(x), so many points.
    Tangent(usize),
    /// E = e^x, with this step.
    Exponential(f64),
}

/// What the variable runs over.
#[derive(Clone, Copy, Debug)]
enum Piece {
    Whole,
    /// From the smaller end to the division E.
    Below(Scaled),
    /// From there to the larger end.
    Above(Scaled),
}

/// Most points of the rule with tangents: beyond, the other rule needs less.
const MOST: f64 = 150.0;

/// artanh of the square root of a ratio below 1: the height of a place where a factor vanishes.
fn height(ratio: Scaled) -> f64 {
    let ratio = ratio.value();
    let rho = if ratio > 1.0 { 1.0 / ratio } else { ratio };
    rho.sqrt().atanh()
}

/// The logarithm of a positive number, to a few digits.
fn logarithm(x: Scaled) -> f64 {
    -x.minus_ln().hi
}

impl SwingInterval<'_> {
    /// How far from the real axis an integrand is analytic, as a function of arctan sqrt E.
    fn analytic_to(&self) -> f64 {
        let mut least = self.singularities().into_iter().map(height).fold(f64::INFINITY, f64::min);
        if let Some(ComplexPair { q, w }) = self.pair {
            // E = -(q + i w)/|q + i w|^2, and the imaginary part of the arctangent of its root.
            let (q, w) = (q.value(), w.value());
            let h = q.hypot(w);
            if !h.is_finite() {
                return 0.0;
            }
            let (re, im) = ((0.5 * (h - q)).max(0.0).sqrt() / h, (0.5 * (h + q)).max(0.0).sqrt() / h);
            let im = if q < 0.0 { 0.5 * w / (h * h * re) } else { im };
            let (near, far) = (re * re + (1.0 - im) * (1.0 - im), re * re + (1.0 + im) * (1.0 + im));
            least = least.min(0.25 * (far / near).ln());
        }
        least
    }

    /// The rule that leaves e^-`digits`, for what turns `turns` times over half a swing; `repeats` unless on a separatrix.
    pub fn rule(&self, digits: f64, turns: f64, repeats: bool) -> Rule {
        let points = 8.0 + digits / (3.0 * self.analytic_to()) + 1.5 * turns;
        if repeats && points < MOST + 3.0 * turns {
            return Rule::Tangent(points as usize);
        }
        // Constants of the bound below e^5.
        let height = if self.pair.is_some() { 1.3 } else { 2.5 };
        Rule::Exponential(core::f64::consts::TAU * height / (digits + 5.0 + 3.0 * turns))
    }

    /// Visits the places of a rule with the step of its variable. A visitor says whether its term is nothing beside its sum.
    pub fn visit(&self, rule: Rule, visitor: &mut dyn FnMut(&Place, Dd) -> bool) {
        match rule {
            Rule::Tangent(count) => self.tangent(count, visitor),
            Rule::Exponential(step) => match self.pair {
                Some(ComplexPair { q, .. }) if q.is_negative() => {
                    let division = -Scaled::ONE / q;
                    self.exponential(Piece::Above(division), step, visitor);
                    self.exponential(Piece::Below(division), step, visitor);
                }
                _ => self.exponential(Piece::Whole, step, visitor),
            },
        }
    }

    /// Midpoints, so that the ends are not needed.
    fn tangent(&self, count: usize, visitor: &mut dyn FnMut(&Place, Dd) -> bool) {
        let step = HALF_PI / Dd::from(count as f64);
        for k in 0..count {
            let angle = step * (k as f64 + 0.5);
            let (sine, cosine) = quarter_turn(Td::from(angle), Td::from(HALF_PI - angle));
            let [s, c] = [sine, cosine].map(|x| Scaled::from(x.to_dd()));
            let (e, one) = ((s / c).square(), Scaled::ONE / c.square());
            let rate = (s * one / c).shift(1);
            visitor(&self.place(&Ratio { e, one, rate, leg: None }), step);
        }
    }

    fn exponential(&self, piece: Piece, step: f64, visitor: &mut dyn FnMut(&Place, Dd) -> bool) {
        let mut marks: Vec<f64> = vec![0.0];
        marks.extend(self.singularities().into_iter().map(logarithm));
        if let Some(ComplexPair { w, .. }) = self.pair {
            marks.push(match piece {
                Piece::Whole => 0.0,
                Piece::Below(division) => logarithm((Scaled::ONE + division) / (division * w)),
                Piece::Above(division) => logarithm(division * division * w / (Scaled::ONE + division)),
            });
        }
        let [low, high] = [f64::min, f64::max].map(|of| marks.iter().copied().fold(0.0, of));
        for (side, end) in [(1.0, high), (-1.0, -low)] {
            let growth = Scaled::exp(Dd::from(side * step));
            let mut f = if side > 0.0 { Scaled::ONE } else { growth };
            let mut k = if side > 0.0 { 0.0 } else { 1.0 };
            let mut quiet = 0;
            while quiet < 2 {
                let nothing = visitor(&self.place(&piece.ratio(f)), Dd::from(step));
                quiet = if nothing && k * step > end + 2.0 { quiet + 1 } else { 0 };
                f = f * growth;
                k += 1.0;
            }
        }
    }

    /// The integral of u' du from the smaller |u| to the larger.
    pub fn of_velocity(&self, repeats: bool) -> Scaled {
        let mut sum = Scaled::ZERO;
        self.visit(self.rule(48.0, 0.0, repeats), &mut |place, step| {
            let term = (place.square_speed / place.y).sqrt() * place.step * Scaled::from(step);
            sum = sum + term;
            (term - sum.shift(-70)).is_negative()
        });
        sum.shift(-1)
    }
}

impl Piece {
    /// Where F from 0 to infinity is.
    fn ratio(self, f: Scaled) -> Ratio {
        let one = Scaled::ONE;
        match self {
            Piece::Whole => Ratio { e: f, one: one + f, rate: f, leg: None },
            Piece::Above(division) => {
                let whole = one + division;
                Ratio {
                    e: division + f * whole,
                    one: whole * (one + f),
                    rate: f * whole,
                    leg: Some(-(f * whole) / division),
                }
            }
            Piece::Below(division) => {
                let whole = one + division;
                let sum = whole + f;
                Ratio {
                    e: division * f / sum,
                    one: whole * (one + f) / sum,
                    rate: division * f * whole / sum.square(),
                    leg: Some(whole / sum),
                }
            }
        }
    }
}

//! Columns of the approximations of the angle: every formula as a chain of passes over blocks of rows, on vectors.
//!
//! What a row holds goes from pass to pass: the time; the point (opposite, adjacent), at first sine and cosine of the phase;
//! and the angle. The passes are few and shared, since a page loads each once. All of it is double-double, as the angle that
//! it approximates. A single time is a block of one row, so a value does not depend on what stands beside it.

use super::angle_phase::half_turn_lanes;
use crate::elliptic::phase::{Phase, alternating};
use crate::float::elementary::arctangent;
use crate::float::unnormalised::Unnormalised;
use crate::float::{Dd, PI, Scaled, TWO_PI};
use crate::lanes::{Kernel, Lane, wide};
use crate::pendulum::state::Frame;

/// Rows of a block: whole lanes.
pub(super) const BLOCK: usize = 64;

/// Powers of two of factors whose products of a few stay within the doubles.
const ORDINARY: i32 = 200;

/// A factor that columns may carry.
pub(super) fn ordinary(value: Scaled) -> bool {
    value.is_zero() || (value.is_finite() && value.power().abs() <= ORDINARY)
}

type Words = [[f64; BLOCK]; 2];

/// Some rows.
pub(super) struct AngleBlock {
    pub t: [f64; BLOCK],
    opposite: Words,
    adjacent: Words,
    /// Once all passes are done its first word is the answer.
    pub angle: Words,
}

/// One row.
#[derive(Clone, Copy)]
pub(super) struct AngleRow<L: Lane> {
    pub t: L,
    pub opposite: Unnormalised<L>,
    pub adjacent: Unnormalised<L>,
    pub angle: Unnormalised<L>,
}

/// What one pass makes of a row; `#[inline(always)]`.
pub(super) trait Pass {
    fn at<L: Lane>(&self, row: AngleRow<L>) -> AngleRow<L>;
}

/// A pass through the first rows of a block.
struct Through<'a, P> {
    block: &'a mut AngleBlock,
    rows: usize,
    pass: &'a P,
}

#[inline(always)]
fn words_at<L: Lane>(words: &Words, at: usize) -> Unnormalised<L> {
    Unnormalised::new(L::load_at(&words[0], at), L::load_at(&words[1], at))
}

#[inline(always)]
fn put<L: Lane>(words: &mut Words, at: usize, value: Unnormalised<L>) {
    value.hi.store_at(&mut words[0], at);
    value.lo.store_at(&mut words[1], at);
}

impl<P: Pass> Kernel for Through<'_, P> {
    type Output = ();
    type Place = P;
    const SINGLE_VECTORS: bool = true;
    #[inline(always)]
    fn run<L: Lane>(self) {
        let Through { block, rows, pass } = self;
        let mut at = 0;
        while at < rows {
            // The place itself, as one that the compiler knows to be in a block.
            let here = at & (BLOCK - L::WIDTH);
            let row = pass.at(AngleRow {
                t: L::load_at(&block.t, here),
                opposite: words_at(&block.opposite, here),
                adjacent: words_at(&block.adjacent, here),
                angle: words_at(&block.angle, here),
            });
            put(&mut block.opposite, here, row.opposite);
            put(&mut block.adjacent, here, row.adjacent);
            put(&mut block.angle, here, row.angle);
            at += L::WIDTH;
        }
    }
}

impl AngleBlock {
    pub fn new() -> AngleBlock {
        let none = [0.0; BLOCK];
        AngleBlock { t: none, opposite: [none; 2], adjacent: [none; 2], angle: [none; 2] }
    }

    /// Whether a row is where [`SineSide`] leaves it.
    pub fn is_close(&self, row: usize) -> bool {
        self.adjacent[0][row] == 0.0
    }

    pub fn through(&mut self, rows: usize, pass: &impl Pass) {
        wide(Through { block: self, rows, pass });
    }
}

/// A constant in every place.
#[inline(always)]
pub(super) fn constant<L: Lane>(value: Dd) -> Unnormalised<L> {
    Unnormalised::splat(value)
}

/// A double in every place.
#[inline(always)]
pub(super) fn double<L: Lane>(value: f64) -> Unnormalised<L> {
    Unnormalised::from_double(L::splat(value))
}

/// The time to sine and cosine of pi times the phase; of 2 pi times it where `turning`, and then the angle is that.
pub(super) struct Turns {
    pub phase: Phase,
    pub time_scale: f64,
    pub end: f64,
    pub turning: bool,
}

impl Pass for Turns {
    #[inline(always)]
    fn at<L: Lane>(&self, row: AngleRow<L>) -> AngleRow<L> {
        let (n, f) = self.phase.spread::<L>().count(row.t * L::splat(self.time_scale), self.end);
        let (sine, cosine) = half_turn_lanes(f);
        if self.turning {
            let count = Unnormalised::from_double(n) + f.into();
            return AngleRow {
                opposite: (sine * cosine).scale(L::splat(2.0)),
                // The digits of both are kept.
                adjacent: (cosine - sine) * (cosine + sine),
                angle: constant(TWO_PI) * count,
                ..row
            };
        }
        let side = alternating(n);
        AngleRow { opposite: sine.scale(side), adjacent: cosine.scale(side), ..row }
    }
}

/// opposite `along` + adjacent `across`.
pub(super) struct Combination {
    pub along: Dd,
    pub across: Dd,
}

impl Pass for Combination {
    #[inline(always)]
    fn at<L: Lane>(&self, row: AngleRow<L>) -> AngleRow<L> {
        let angle = row.opposite * constant(self.along) + row.adjacent * constant(self.across);
        AngleRow { angle, ..row }
    }
}

/// The angle plus scale times the sum of c_i sin(j_i phi), j = 1, 2, 3 ... or, where `odd`, 1, 3, 5 ...
///
/// Clenshaw's recurrence b_i = c_i + 2 cos(step phi) b_(i+1) - b_(i+2); the sum is sin phi b_0, or sin phi (b_0 + b_1).
pub(super) struct SineSum<'a> {
    pub coefficients: &'a [Dd],
    pub scale: Dd,
    pub odd: bool,
}

impl Pass for SineSum<'_> {
    #[inline(always)]
    fn at<L: Lane>(&self, row: AngleRow<L>) -> AngleRow<L> {
        let (sine, cosine) = (row.opposite, row.adjacent);
        let turned = if self.odd { (cosine - sine) * (cosine + sine) } else { cosine };
        let factor = turned.scale(L::splat(2.0));
        let (mut first, mut second) = (double(0.0), double(0.0));
        let mut i = self.coefficients.len();
        while i > 0 {
            i -= 1;
            let next = factor * first - second + constant(self.coefficients[i]);
            (first, second) = (next, first);
        }
        let sum = if self.odd { first + second } else { first };
        AngleRow { angle: row.angle + sine * sum * constant(self.scale), ..row }
    }
}

/// The angle as a sine, to the point on the unit circle to the right that has it; NaN where there is none, and 0 where that
/// is for a longer sum to say ([`AngleBlock::is_close`]).
pub(super) struct SineSide;

/// A square that is so small that the angle is no longer good to its last digit where the sine is wrong by 2^-62.
const CLOSE: f64 = 1e-8;

impl Pass for SineSide {
    #[inline(always)]
    fn at<L: Lane>(&self, row: AngleRow<L>) -> AngleRow<L> {
        let (one, sine) = (double(1.0), row.angle);
        let square = (one - sine) * (one + sine);
        let close = square.hi.abs().less(L::splat(CLOSE));
        AngleRow { opposite: sine, adjacent: Unnormalised::select(close, double(0.0), square.root()), ..row }
    }
}

/// Twice the angle of the point, in (-2 pi, 2 pi].
pub(super) struct TwiceAngle;

impl Pass for TwiceAngle {
    #[inline(always)]
    fn at<L: Lane>(&self, row: AngleRow<L>) -> AngleRow<L> {
        let (one, two) = (L::splat(1.0), L::splat(2.0));
        let (up, left) = (one.copysign(row.opposite.hi), row.adjacent.hi.less(L::splat(0.0)));
        let right = L::select(left, -one, one);
        let size = arctangent(row.opposite.scale(up).tight(), row.adjacent.scale(right).tight());
        let size = Unnormalised::from(size);
        let size = Unnormalised::select(left, constant::<L>(PI) - size, size);
        AngleRow { angle: size.scale(up * two), ..row }
    }
}

/// The angle into a frame, and to one word.
pub(super) struct Framed {
    base: Dd,
    side: f64,
}

impl Framed {
    pub fn new(frame: &Frame) -> Framed {
        Framed { base: frame.base + PI * frame.half_turn, side: frame.side }
    }

    /// As it is.
    pub const PLAIN: Framed = Framed { base: Dd::ZERO, side: 1.0 };
}

impl Pass for Framed {
    #[inline(always)]
    fn at<L: Lane>(&self, row: AngleRow<L>) -> AngleRow<L> {
        let angle = row.angle.scale(L::splat(self.side));
        // A sum with 0 would take its sign from 0.
        let angle = if self.base.hi == 0.0 { angle } else { constant(self.base) + angle };
        AngleRow { angle: Unnormalised::from_double(angle.hi + angle.lo), ..row }
    }
}

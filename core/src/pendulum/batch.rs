//! Rows of (theta, velocity, time, omega0), each a state of its own: a block of them is sorted by the formula they ask
//! for, and every class is evaluated over lanes by the addition theorem (addition_theorem.rs, short_step.rs). Rows that the lanes leave
//! out, next to the separatrix and at the ends of the range, are evaluated one by one.

use super::addition_theorem::{PerRow, SharedState};
use super::frequency::Frequency;
use super::orbit::Orbit;
use super::short_step::{LARGEST_SQUARE, ShortStep};
use crate::elliptic::phase::alternating;
use crate::elliptic::theta::neville_lanes::LEAST_COMPLEMENT;
use crate::float::PI;
use crate::float::angle_reduction::FAR;
use crate::float::elementary::sine;
use crate::lanes::{BLOCK, Classes, Columns, Evaluation, Formula, Lane, LastMade, Once, repeats, wide};
use core::cell::Cell;

/// The formula that a row asks for.
pub(super) mod class {
    /// None of the lanes': next to the separatrix, out of range, or not finite.
    pub const FALLBACK: usize = 0;
    /// Libration with m <= 1/2.
    pub const LIBRATION_CIRCULAR: usize = 1;
    /// Libration with m > 1/2.
    pub const LIBRATION_HYPERBOLIC: usize = 2;
    /// Rotation with 1/m <= 1/2.
    pub const ROTATION_CIRCULAR: usize = 3;
    /// Rotation with 1/m > 1/2.
    pub const ROTATION_HYPERBOLIC: usize = 4;
    /// A short step of any of these; of steps only.
    pub const SHORT_STEP: usize = 5;
    /// How many.
    pub const COUNT: usize = 6;
}

/// Amplitudes below are left to the fallback, and so are velocities (over 2 omega0) and omega0 itself where a product of
/// two of them, with its error, would leave the range.
const TINY: f64 = 1e-180;
pub(super) const SMALL: f64 = 1e-100;
pub(super) const LARGE: f64 = 1e100;

/// kappa^2 and 1 - kappa^2 of a state to a few roundings, and whether the lanes take its numbers.
struct Shape<L: Lane> {
    m: L,
    mc: L,
    /// 1 where they do, else 0.
    taken: L,
}

impl<L: Lane> Shape<L> {
    #[inline(always)]
    fn new([theta, velocity, omega]: [L; 3]) -> Self {
        let (zero, one, half) = (L::splat(0.0), L::splat(1.0), L::splat(0.5));
        // The nearest half turns as `half_turns` counts them; the rest is not 0 but at the bottom itself.
        let j = (theta * L::splat(core::f64::consts::FRAC_1_PI)).round();
        let rest = j.mul_add(L::splat(-PI.lo), j.mul_add(L::splat(-PI.hi), theta));
        let x = (velocity / (omega + omega)).abs();
        let small = sine(rest * half);
        let square = small * small;
        let (low, high) = (square, one - square);
        let even = zero.less(alternating(j));
        let m = x.mul_add(x, L::select(even, low, high));
        let mc = L::select(even, high, low) - x * x;
        // Every comparison is false for NaN.
        let taken = L::select(theta.abs().less(L::splat(FAR)), one, zero);
        let taken = L::select(x.less(L::splat(LARGE)), taken, zero);
        let taken = L::select(L::splat(SMALL).less(omega), taken, zero);
        let taken = L::select(omega.less(L::splat(LARGE)), taken, zero);
        let amplitude = rest.abs() + x;
        let at_rest = amplitude.equal(zero);
        let tiny = L::select(at_rest, zero, L::select(even, amplitude, one)).less(L::splat(TINY));
        let taken = L::select(tiny, L::select(at_rest, taken, zero), taken);
        Shape { m, mc, taken }
    }

    /// The class by the regime.
    #[inline(always)]
    fn class(&self) -> L {
        let Shape { m, mc, taken } = *self;
        let code = |class: usize| L::splat(class as f64);
        let least = L::splat(LEAST_COMPLEMENT);
        let libration = L::select(
            mc.less(L::splat(0.5)),
            code(class::LIBRATION_HYPERBOLIC),
            code(class::LIBRATION_CIRCULAR),
        );
        let rotation = L::select(
            m.less(L::splat(2.0)),
            code(class::ROTATION_HYPERBOLIC),
            code(class::ROTATION_CIRCULAR),
        );
        let fallback = code(class::FALLBACK);
        let found = L::select(least.less(mc), libration, L::select(mc.less(-least), rotation, fallback));
        L::select(L::splat(0.0).less(taken), found, fallback)
    }
}

/// The class of theta, velocity, omega0.
pub(super) struct Classify;

impl Formula<3, 1> for Classify {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, state: [L; 3]) -> [L; 1] {
        [Shape::new(state).class()]
    }
}

/// The class of theta, velocity, dt, omega0.
struct ClassifyStep;

impl Formula<4, 1> for ClassifyStep {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [theta, velocity, dt, omega]: [L; 4]) -> [L; 1] {
        let shape = Shape::new([theta, velocity, omega]);
        let (u, one) = (omega * dt, L::splat(1.0));
        let short = (u * u * one.larger(shape.m)).less(L::splat(LARGEST_SQUARE) * shape.taken);
        [L::select(short, L::splat(class::SHORT_STEP as f64), shape.class())]
    }
}

/// The answer of the formula of a class; `None` for the fallback. `omega_rest` is what every omega0 as a double lacks.
fn evaluated<E: Evaluation<4, 2>>(class: usize, omega_rest: f64, evaluation: E) -> Option<E::Output> {
    Some(match class {
        class::LIBRATION_CIRCULAR => evaluation.of(&PerRow::<false, false>(omega_rest)),
        class::LIBRATION_HYPERBOLIC => evaluation.of(&PerRow::<false, true>(omega_rest)),
        class::ROTATION_CIRCULAR => evaluation.of(&PerRow::<true, false>(omega_rest)),
        class::ROTATION_HYPERBOLIC => evaluation.of(&PerRow::<true, true>(omega_rest)),
        class::SHORT_STEP => evaluation.of(&ShortStep(omega_rest)),
        _ => return None,
    })
}

/// All rows by the formula of a regime, from the state of the first.
fn from_shared_state(class: usize, [theta, velocity, dt, omega]: [&[f64]; 4], results: [&mut [f64]; 2]) {
    let (theta, velocity, omega) = (theta[0], velocity[0], omega[0]);
    match class {
        class::LIBRATION_CIRCULAR => {
            wide(SharedState::<false, false> { theta, velocity, omega, dt, results })
        }
        class::LIBRATION_HYPERBOLIC => {
            wide(SharedState::<false, true> { theta, velocity, omega, dt, results })
        }
        class::ROTATION_CIRCULAR => wide(SharedState::<true, false> { theta, velocity, omega, dt, results }),
        _ => wide(SharedState::<true, true> { theta, velocity, omega, dt, results }),
    }
}

/// One row of (theta, velocity, dt, omega0 + omega_rest), as the lanes answer it in a column; `None` for the fallback.
pub(super) fn row([theta, velocity, dt, omega]: [f64; 4], omega_rest: f64) -> Option<[f64; 2]> {
    let [class] = Once([theta, velocity, dt, omega]).of(&ClassifyStep);
    evaluated(class as usize, omega_rest, Once([theta, velocity, dt, omega]))
}

/// Up to a block of rows, by their classes; NaN for the fallback. The memory is asked for the columns of the next block meanwhile.
fn block(
    sorted: &mut Classes<4, 2, { class::COUNT }>,
    arguments: [&[f64]; 4],
    results: [&mut [f64]; 2],
    next: [*const f64; 6],
) {
    let rows = arguments[0].len();
    let mut codes = [0.0; BLOCK];
    let [theta, velocity, _, omega] = arguments;
    Columns::new(arguments, [&mut codes[..rows]]).of(&ClassifyStep);
    let codes = &codes[..rows];
    let shared = !matches!(codes[0] as usize, class::FALLBACK | class::SHORT_STEP);
    if shared && repeats([codes, theta, velocity, omega]) {
        return from_shared_state(codes[0] as usize, arguments, results);
    }
    let asked = Cell::new(0);
    sorted.filled(codes, arguments, results, |class, columns| match class {
        class::FALLBACK => columns.fill(f64::NAN),
        class => {
            let from = asked.replace(asked.get() + columns.rows());
            let ahead = next.map(|column| column.wrapping_add(from));
            evaluated(class, 0.0, columns.asking(&ahead));
        }
    });
}

/// Rows of (theta, velocity, dt, omega0) to rows of theta and velocity, on the widest lanes; what the lanes leave out is
/// asked of `fallback`, row by row. Panics where the lengths differ.
pub(super) fn fill(
    arguments: [&[f64]; 4],
    [theta, velocity]: [&mut [f64]; 2],
    mut fallback: impl FnMut([f64; 4]) -> (f64, f64),
) {
    let rows = arguments[0].len();
    let fits = arguments.iter().all(|column| column.len() == rows);
    assert!(fits && theta.len() == rows && velocity.len() == rows, "columns of different lengths");
    let mut sorted = Classes::new();
    let mut from = 0;
    while from < rows {
        let to = rows.min(from + BLOCK);
        let [a, b, c, d] = arguments.map(|argument| argument.as_ptr());
        let next = [a, b, c, d, theta.as_ptr(), velocity.as_ptr()].map(|column| column.wrapping_add(to));
        let arguments = arguments.map(|argument| &argument[from..to]);
        block(&mut sorted, arguments, [&mut theta[from..to], &mut velocity[from..to]], next);
        from = to;
    }
    for row in 0..rows {
        if theta[row].is_nan() || velocity[row].is_nan() {
            (theta[row], velocity[row]) = fallback(arguments.map(|column| column[row]));
        }
    }
}

/// Angle and velocity of rows of (t, theta0, velocity0, omega0): every row an orbit of its own.
///
/// NaN where an argument is out of the domain of [`Orbit`]; panics where the lengths differ. Next to the separatrix and
/// at the ends of the range by an [`Orbit`] of the row, kept while the state repeats. **Error** at most 8 ulp of the
/// largest angle and velocity of the orbit. Source: Salas 2019 (23) by DLMF 22.8.
///
/// ```
/// let (mut theta, mut velocity) = ([0.0; 2], [0.0; 2]);
/// let rows = [&[2.0, 2.0], &[1.0, 3.0], &[0.0, 0.0], &[1.0, 1.0]].map(|column| column.as_slice());
/// libration::pendulum::motion_into(rows, [&mut theta, &mut velocity]);
/// assert_eq!(format!("{:.9} {:.9}", theta[0], velocity[1]), "-0.306200958 -0.502884034");
/// ```
pub fn motion_into([t, theta0, velocity0, omega0]: [&[f64]; 4], results: [&mut [f64]; 2]) {
    let mut made = LastMade::new();
    fill([theta0, velocity0, t, omega0], results, |[theta, velocity, t, omega0]| {
        let orbit = made.of([theta, velocity, omega0], || {
            Frequency::from_omega0(omega0).and_then(|of| Orbit::new(theta, velocity, of)).ok()
        });
        orbit.as_ref().map_or((f64::NAN, f64::NAN), |orbit| orbit.motion(t))
    });
}

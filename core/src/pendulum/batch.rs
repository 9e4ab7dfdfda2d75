//! Rows with states of their own: a block of them sorted by the formula they ask for, and each class swept over lanes.

use super::addition_theorem::{Alike, Own};
use crate::elliptic::phase::alternating;
use crate::elliptic::theta::neville_lanes::LEAST_COMPLEMENT;
use crate::float::angle_reduction::{FAR, half_turns};
use crate::float::elementary::sin_cos;
use crate::lanes::{Formula, Lane, tabulate, wide};

/// The formula that a row asks for.
mod class {
    /// None of the lanes': next to the separatrix, out of range, or not finite.
    pub const APART: usize = 0;
    /// Libration with m <= 1/2.
    pub const GENTLE_LIBRATION: usize = 1;
    /// Libration with m > 1/2.
    pub const STEEP_LIBRATION: usize = 2;
    /// Rotation with 1/m <= 1/2.
    pub const FAST_ROTATION: usize = 3;
    /// Rotation with 1/m > 1/2.
    pub const SLOW_ROTATION: usize = 4;
    /// How many.
    pub const COUNT: usize = 5;
}

/// Amplitudes below are left apart, and so are velocities (over 2 omega0) and omega0 itself outside of what a product of
/// two of them, with its error, can stand.
const TINY: f64 = 1e-180;
const SMALL: f64 = 1e-100;
const LARGE: f64 = 1e100;

/// The class of theta, velocity, omega0, from 1 - kappa^2 to a few roundings.
struct Classify;

impl Formula<3, 1> for Classify {
    #[inline(always)]
    fn at<L: Lane>(&self, [theta, velocity, omega]: [L; 3]) -> [L; 1] {
        let (zero, one, half) = (L::splat(0.0), L::splat(1.0), L::splat(0.5));
        let (j, rest) = half_turns(theta);
        let x = (velocity / (omega + omega)).abs();
        let (small, _) = sin_cos(rest.scale(half));
        let square = small.hi * small.hi;
        let (low, high) = (square, one - square);
        let even = zero.less(alternating(j));
        let m = x.mul_add(x, L::select(even, low, high));
        let mc = L::select(even, high, low) - x * x;
        let code = |class: usize| L::splat(class as f64);
        let least = L::splat(LEAST_COMPLEMENT);
        let libration = L::select(mc.less(half), code(class::STEEP_LIBRATION), code(class::GENTLE_LIBRATION));
        let rotation =
            L::select(m.less(L::splat(2.0)), code(class::SLOW_ROTATION), code(class::FAST_ROTATION));
        let apart = code(class::APART);
        let found = L::select(least.less(mc), libration, L::select(mc.less(-least), rotation, apart));
        // Every comparison is false for NaN.
        let found = L::select(theta.abs().less(L::splat(FAR)), found, apart);
        let found = L::select(x.less(L::splat(LARGE)), found, apart);
        let found = L::select(L::splat(SMALL).less(omega), found, apart);
        let found = L::select(omega.less(L::splat(LARGE)), found, apart);
        let amplitude = rest.hi.abs() + x;
        let still = amplitude.equal(zero);
        let tiny = L::select(still, zero, L::select(even, amplitude, one)).less(L::splat(TINY));
        let found = L::select(tiny, L::select(still, found, apart), found);
        [found]
    }
}

/// Rows classed at a time.
const BLOCK: usize = 512;

/// Rows of theta, velocity, dt, omega0 to rows of theta and velocity.
pub(super) struct Rows<'a, 'b> {
    pub arguments: [&'a [f64]; 4],
    /// What omega0 as a double lacks, in every row.
    pub omega_rest: f64,
    pub results: [&'b mut [f64]; 2],
}

/// The rows of each class in a block, and their columns side by side.
struct Sorted {
    members: [[u16; BLOCK]; class::COUNT],
    counts: [usize; class::COUNT],
    arguments: [[f64; BLOCK]; 4],
    results: [[f64; BLOCK]; 2],
}

impl Sorted {
    #[inline(always)]
    fn new(codes: &[f64]) -> Self {
        let mut members = [[0; BLOCK]; class::COUNT];
        let mut counts = [0; class::COUNT];
        for (row, code) in codes.iter().enumerate() {
            let class = *code as usize;
            members[class][counts[class]] = row as u16;
            counts[class] += 1;
        }
        Sorted { members, counts, arguments: [[0.0; BLOCK]; 4], results: [[0.0; BLOCK]; 2] }
    }
}

/// The first rows of columns.
#[inline(always)]
fn first_rows<const N: usize>(columns: &[[f64; BLOCK]; N], rows: usize) -> [&[f64]; N] {
    let mut heads: [&[f64]; N] = [&[]; N];
    for (head, column) in heads.iter_mut().zip(columns) {
        *head = &column[..rows];
    }
    heads
}

/// Whether all values are the first, bit for bit.
fn repeats(column: &[f64]) -> bool {
    column.iter().all(|value| value.to_bits() == column[0].to_bits())
}

impl Rows<'_, '_> {
    /// All rows by the formula of one class; `alike` where they have one start.
    fn sweep_class<const WIDE: bool>(
        class: usize,
        alike: bool,
        omega_rest: f64,
        arguments: [&[f64]; 4],
        results: &mut [&mut [f64]; 2],
    ) {
        let [theta, velocity, dt, omega] = arguments;
        macro_rules! flow {
            ($rotation:literal, $hyperbolic:literal) => {{
                if alike {
                    let omega = [omega[0], omega_rest];
                    let (theta, velocity) = (theta[0], velocity[0]);
                    wide(Alike::<$rotation, $hyperbolic> { theta, velocity, omega, dt, results })
                } else {
                    tabulate::<WIDE, _, _, _, _>(
                        &Own::<$rotation, $hyperbolic>(omega_rest),
                        arguments,
                        results,
                    )
                }
            }};
        }
        match class {
            class::GENTLE_LIBRATION => flow!(false, false),
            class::STEEP_LIBRATION => flow!(false, true),
            class::FAST_ROTATION => flow!(true, false),
            class::SLOW_ROTATION => flow!(true, true),
            _ => {
                for result in results {
                    result.fill(f64::NAN);
                }
            }
        }
    }

    /// Up to a block of rows, by their classes.
    fn block<const WIDE: bool>(omega_rest: f64, arguments: [&[f64]; 4], results: &mut [&mut [f64]; 2]) {
        let rows = arguments[0].len();
        let mut codes = [0.0; BLOCK];
        let [theta, velocity, _, omega] = arguments;
        tabulate::<WIDE, _, _, _, _>(&Classify, [theta, velocity, omega], &mut [&mut codes[..rows]]);
        let codes = &codes[..rows];
        if codes.iter().all(|code| *code == codes[0]) {
            let alike = rows > ENOUGH && [theta, velocity, omega].iter().all(|column| repeats(column));
            return Self::sweep_class::<WIDE>(codes[0] as usize, alike, omega_rest, arguments, results);
        }
        let mut sorted = Sorted::new(codes);
        for (class, members) in sorted.members.iter().enumerate() {
            let members = &members[..sorted.counts[class]];
            for (column, argument) in sorted.arguments.iter_mut().zip(arguments) {
                for (place, row) in column.iter_mut().zip(members) {
                    *place = argument[usize::from(*row)];
                }
            }
            let mut places = sorted.results.each_mut().map(|column| &mut column[..members.len()]);
            let gathered = first_rows(&sorted.arguments, members.len());
            Self::sweep_class::<WIDE>(class, false, omega_rest, gathered, &mut places);
            for (result, column) in results.iter_mut().zip(&sorted.results) {
                for (value, row) in column.iter().zip(members) {
                    result[usize::from(*row)] = *value;
                }
            }
        }
    }
}

/// More rows than a lane: a set-up in common pays.
const ENOUGH: usize = 16;

impl Rows<'_, '_> {
    pub fn run<const WIDE: bool>(mut self) {
        let rows = self.arguments[0].len();
        let mut from = 0;
        while from < rows {
            let to = rows.min(from + BLOCK);
            let mut arguments = self.arguments;
            for argument in &mut arguments {
                *argument = &argument[from..to];
            }
            let mut results = self.results.each_mut().map(|result| &mut result[from..to]);
            Self::block::<WIDE>(self.omega_rest, arguments, &mut results);
            from = to;
        }
    }
}

/// Rows of (theta, velocity, dt, omega0) to rows of theta and velocity, on the widest lanes; what the lanes leave apart is
/// asked of `apart`, row by row. Panics where the lengths differ.
pub(super) fn fill(
    arguments: [&[f64]; 4],
    [theta, velocity]: [&mut [f64]; 2],
    mut apart: impl FnMut([f64; 4]) -> (f64, f64),
) {
    let rows = arguments[0].len();
    let fits = arguments.iter().all(|column| column.len() == rows);
    assert!(fits && theta.len() == rows && velocity.len() == rows, "rows of another length than the first");
    Rows { arguments, omega_rest: 0.0, results: [&mut *theta, &mut *velocity] }.run::<true>();
    for row in 0..rows {
        if theta[row].is_nan() || velocity[row].is_nan() {
            (theta[row], velocity[row]) = apart(arguments.map(|column| column[row]));
        }
    }
}

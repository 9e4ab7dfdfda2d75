//! Columns of a motion by polynomials on vectors, in parts: the phases of some rows, the polynomials, the motion. For a page,
//! where a product with its error is 15 operations: the chain of one row is too long for a processor to begin the next ones.
//!
//! The operations are those of motion.rs, so the bits are too.

use super::canonical::last_count;
use super::interpolant::ByInterpolant;
use super::orbit::{Orbit, Solution};
use super::theta_quotients::Elliptic;
use crate::elliptic::phase::Phase;
use crate::float::Dd;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Kernel, Lane, wide};
use crate::motion::interpolant::Interpolant;

/// Rows of a block, which stay in the nearest cache: whole lanes.
const ROWS: usize = 256;

/// Some rows: the times, their phases as the whole number and the rest of half periods, and the motion.
struct Block {
    t: [f64; ROWS],
    n: [f64; ROWS],
    hi: [f64; ROWS],
    lo: [f64; ROWS],
    p: [f64; ROWS],
    rest: [f64; ROWS],
    theta: [f64; ROWS],
    velocity: [f64; ROWS],
}

/// The phases of the first rows.
struct Phases<'a> {
    block: &'a mut Block,
    rows: usize,
    phase: Phase,
    time_scale: f64,
    end: f64,
}

impl Kernel for Phases<'_> {
    type Output = ();
    type Place = Self;
    const VECTORS: bool = true;
    #[inline(always)]
    fn run<L: Lane>(self) {
        let Phases { block, rows, phase, time_scale, end } = self;
        let mut at = 0;
        while at < rows {
            let t = L::load_at(&block.t, at) * L::splat(time_scale);
            let (n, f) = phase.spread::<L>().count(t, end);
            n.store_at(&mut block.n, at);
            f.hi.store_at(&mut block.hi, at);
            f.lo.store_at(&mut block.lo, at);
            at += L::WIDTH;
        }
    }
}

/// The polynomial of the angle at the phases of the first rows.
struct Values<'a> {
    block: &'a mut Block,
    rows: usize,
    interpolant: &'a Interpolant,
}

impl Kernel for Values<'_> {
    type Output = ();
    type Place = Self;
    const VECTORS: bool = true;
    #[inline(always)]
    fn run<L: Lane>(self) {
        let Values { block, rows, interpolant } = self;
        let mut at = 0;
        while at < rows {
            let f = Dd::new(L::load_at(&block.hi, at), L::load_at(&block.lo, at));
            let value = interpolant.first(f);
            value.hi.store_at(&mut block.p, at);
            value.lo.store_at(&mut block.rest, at);
            at += L::WIDTH;
        }
    }
}

/// The motion at the phases of the first rows.
struct AtPhases<'a, const ROTATION: bool, const VELOCITY: bool> {
    block: &'a mut Block,
    rows: usize,
    orbit: &'a Orbit,
    motion: &'a ByInterpolant<'a, ROTATION>,
}

impl<const ROTATION: bool, const VELOCITY: bool> Kernel for AtPhases<'_, ROTATION, VELOCITY> {
    type Output = ();
    type Place = Self;
    const VECTORS: bool = true;
    #[inline(always)]
    fn run<L: Lane>(self) {
        let AtPhases { block, rows, orbit, motion } = self;
        let mut at = 0;
        while at < rows {
            let (t, n) = (L::load_at(&block.t, at), L::load_at(&block.n, at));
            let f = Dd::new(L::load_at(&block.hi, at), L::load_at(&block.lo, at));
            let value = Unnormalised::new(L::load_at(&block.p, at), L::load_at(&block.rest, at));
            let canonical = motion.at_value::<true, VELOCITY, L>(n, f, value);
            let [theta, velocity, ..] = orbit.in_frame::<ByInterpolant<'_, ROTATION>, true, L>(t, canonical);
            theta.store_at(&mut block.theta, at);
            if VELOCITY {
                velocity.store_at(&mut block.velocity, at);
            }
            at += L::WIDTH;
        }
    }
}

impl Orbit {
    /// The angle of every time, and the velocity if there is a column for it, where there are polynomials for what is asked;
    /// whether there are.
    pub(super) fn in_blocks(&self, t: &[f64], theta: &mut [f64], velocity: Option<&mut [f64]>) -> bool {
        match &self.solution {
            Solution::Libration(elliptic) => self.blocks::<false>(elliptic, t, theta, velocity),
            Solution::Rotation(elliptic) => self.blocks::<true>(elliptic, t, theta, velocity),
            _ => false,
        }
    }

    fn blocks<const ROTATION: bool>(
        &self,
        elliptic: &Elliptic,
        t: &[f64],
        theta: &mut [f64],
        mut velocity: Option<&mut [f64]>,
    ) -> bool {
        let Some(interpolant) = self.polynomials::<ROTATION>(elliptic) else { return false };
        let motion = &ByInterpolant::<ROTATION> { elliptic, interpolant, pieces: None };
        if velocity.is_some() && !motion.whole() {
            return false;
        }
        let none = [0.0; ROWS];
        let mut made =
            Block { t: none, n: none, hi: none, lo: none, p: none, rest: none, theta: none, velocity: none };
        let block = &mut made;
        let (phase, time_scale, end) = (elliptic.phase, self.time_scale, last_count(ROTATION));
        for (i, t) in t.chunks(ROWS).enumerate() {
            let (from, rows) = (i * ROWS, t.len());
            block.t[..rows].copy_from_slice(t);
            wide(Phases { block: &mut *block, rows, phase, time_scale, end });
            wide(Values { block: &mut *block, rows, interpolant });
            if let Some(velocity) = &mut velocity {
                wide(AtPhases::<ROTATION, true> { block: &mut *block, rows, orbit: self, motion });
                velocity[from..from + rows].copy_from_slice(&block.velocity[..rows]);
            } else {
                wide(AtPhases::<ROTATION, false> { block: &mut *block, rows, orbit: self, motion });
            }
            theta[from..from + rows].copy_from_slice(&block.theta[..rows]);
        }
        true
    }
}

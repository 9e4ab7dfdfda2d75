//! Columns of a motion by polynomials on vectors, in parts: the phases of some rows, the polynomials, the motion. For a page,
//! where a product with its error is 15 operations: the chain of one row is too long for a processor to begin the next ones.
//!
//! A phase is reduced in few operations: its whole number is added to 1.5 2^52, and the lowest bit of that sum is the sign of the
//! half period. The start, and times too far for that, are left to the rows at the end of a block; so is the question whether
//! there are any, which the largest and the smallest time of a block answer. A single time is a block of its own, so that a value
//! does not depend on what stands beside it.

use super::interpolant::ByInterpolant;
use super::orbit::{Orbit, Solution};
use super::theta_quotients::Elliptic;
use crate::elliptic::phase::{NEAR, Phase};
use crate::float::double_double::{fast_two_sum, two_sum};
use crate::float::unnormalised::Unnormalised;
use crate::float::{Dd, TWO_PI};
use crate::lanes::{Kernel, Lane, ROUNDER, WIDEST, wide};
use crate::motion::interpolant::Interpolant;

/// Rows of a block, which stay in the nearest cache: whole lanes.
const ROWS: usize = 256;

/// Some rows: the times, their phases as the whole number (plus 1.5 2^52) and the rest of half periods, and the motion.
struct Block {
    t: [f64; ROWS],
    shifted: [f64; ROWS],
    hi: [f64; ROWS],
    lo: [f64; ROWS],
    p: [f64; ROWS],
    rest: [f64; ROWS],
    theta: [f64; ROWS],
    velocity: [f64; ROWS],
}

/// The place itself, as one that the compiler knows to be in a block: it then asks no more at every load and store.
#[inline(always)]
fn within<L: Lane>(at: usize) -> usize {
    at & (ROWS - L::WIDTH)
}

/// The phases of the first rows; and the largest and the smallest |t| of these and of what pads the last lane.
struct Phases<'a> {
    block: &'a mut Block,
    rows: usize,
    phase: Phase,
    time_scale: f64,
    /// 1.5 2^52, and 1 more where the motion goes downwards at first.
    rounder: f64,
}

impl Kernel for Phases<'_> {
    type Output = [f64; 2];
    type Place = Self;
    const VECTORS: bool = true;
    #[inline(always)]
    fn run<L: Lane>(self) -> [f64; 2] {
        let Phases { block, rows, phase, time_scale, rounder } = self;
        let phase = phase.spread::<L>();
        let (mut most, mut least) = (L::splat(0.0), L::splat(f64::INFINITY));
        let mut at = 0;
        while at < rows {
            let here = within::<L>(at);
            let t = L::load_at(&block.t, here);
            let size = t.abs();
            (most, least) = (most.larger(size), least.smaller(size));
            let t = t * L::splat(time_scale);
            let (turned, error) = t.two_product_in_range(phase.rate.hi);
            // Exact, and so is the difference, a multiple of the last place of the rest.
            let (sum, rest) = two_sum(turned, phase.start.hi);
            let shifted = sum + L::splat(rounder);
            let part = sum - (shifted - L::splat(rounder));
            let (hi, lo) = fast_two_sum(part, rest + (error + t.mul_add(phase.rate.lo, phase.start.lo)));
            shifted.store_at(&mut block.shifted, here);
            hi.store_at(&mut block.hi, here);
            lo.store_at(&mut block.lo, here);
            at += L::WIDTH;
        }
        let (mut mosts, mut leasts) = ([0.0; WIDEST], [f64::INFINITY; WIDEST]);
        most.store(&mut mosts);
        least.store(&mut leasts);
        let ends = |ends: [f64; 2], i: usize| [ends[0].larger(mosts[i]), ends[1].smaller(leasts[i])];
        (1..L::WIDTH).fold([mosts[0], leasts[0]], ends)
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
            let here = within::<L>(at);
            let f = Dd::new(L::load_at(&block.hi, here), L::load_at(&block.lo, here));
            let value = interpolant.first(f);
            value.hi.store_at(&mut block.p, here);
            value.lo.store_at(&mut block.rest, here);
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
    const VECTORS: bool = !ROTATION;
    const SINGLE_VECTORS: bool = ROTATION;
    #[inline(always)]
    fn run<L: Lane>(self) {
        let AtPhases { block, rows, orbit, motion } = self;
        let frame = &orbit.frame;
        let mut at = 0;
        while at < rows {
            let here = within::<L>(at);
            let shifted = L::load_at(&block.shifted, here);
            let f = Dd::new(L::load_at(&block.hi, here), L::load_at(&block.lo, here));
            let value = Unnormalised::new(L::load_at(&block.p, here), L::load_at(&block.rest, here));
            let (hi, error) = value.hi.two_product_in_range(f.hi);
            let lo = value.hi.mul_add(f.lo, value.lo.mul_add(f.hi, error));
            let theta = if ROTATION || frame.base.hi != 0.0 {
                let (hi, lo) = if ROTATION {
                    let side = L::splat(frame.side);
                    (hi * side, lo * side)
                } else {
                    (hi.alternated(shifted), lo.alternated(shifted))
                };
                let local = Dd::new(hi, lo);
                let turned = if ROTATION {
                    let turns = (shifted - L::splat(ROUNDER)) * L::splat(frame.side);
                    Dd::splat(TWO_PI).times_in_range(turns).plain_sum(local)
                } else {
                    local
                };
                Dd::splat(frame.base).plain_sum(turned).value()
            } else {
                (hi + lo).alternated(shifted)
            };
            theta.store_at(&mut block.theta, here);
            if VELOCITY {
                let speed = motion.speed(motion.1.second(f), f);
                let velocity = if ROTATION { speed } else { speed.alternated(shifted) };
                let scale = if ROTATION { orbit.velocity_scale } else { orbit.velocity_scale.abs() };
                (velocity * L::splat(scale)).store_at(&mut block.velocity, here);
            }
            at += L::WIDTH;
        }
    }
}

impl Orbit {
    /// The angle of every time, and the velocity if there is a column for it, where there are polynomials; whether there are.
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
        let motion = &ByInterpolant::<ROTATION>(elliptic, interpolant, self.frame.side);
        let none = [0.0; ROWS];
        let mut made = Block {
            t: none,
            shifted: none,
            hi: none,
            lo: none,
            p: none,
            rest: none,
            theta: none,
            velocity: none,
        };
        let block = &mut made;
        let (phase, time_scale) = (elliptic.phase, self.time_scale);
        let rounder = motion.rounder();
        let far = NEAR / (phase.rate.hi * time_scale);
        for (i, t) in t.chunks(ROWS).enumerate() {
            let (from, rows) = (i * ROWS, t.len());
            block.t[..rows].copy_from_slice(t);
            let [most, least] = wide(Phases { block: &mut *block, rows, phase, time_scale, rounder });
            wide(Values { block: &mut *block, rows, interpolant });
            if velocity.is_some() {
                wide(AtPhases::<ROTATION, true> { block: &mut *block, rows, orbit: self, motion });
            } else {
                wide(AtPhases::<ROTATION, false> { block: &mut *block, rows, orbit: self, motion });
            }
            if !(most < far && least > 0.0) {
                for (row, t) in t.iter().enumerate() {
                    if *t == 0.0 {
                        (block.theta[row], block.velocity[row]) = (self.theta0, self.velocity0);
                    } else if t.abs() >= far {
                        (block.theta[row], block.velocity[row]) = self.far_motion(*t);
                    }
                }
            }
            if let Some(velocity) = &mut velocity {
                velocity[from..from + rows].copy_from_slice(&block.velocity[..rows]);
            }
            theta[from..from + rows].copy_from_slice(&block.theta[..rows]);
        }
        true
    }
}

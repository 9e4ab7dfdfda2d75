//! The derivatives of a trajectory by its start and its constants, at any time in its interval.
//!
//! One pass over the segments keeps the derivatives at the start of each; those at a time follow from the series of its segment
//! (variational.rs).

use super::branch::{Branch, since};
use super::integrator::ASKED_EVERY;
use super::segment::{Segment, Tolerance};
use super::trajectory::Trajectory;
use super::variational::{ColumnJet, Columns, LANE, LANES, PARAMETERS, SiFactors};
use crate::domain::Domain;
use std::sync::Arc;

/// Rows that are collected before they are written.
const BLOCK: usize = 32;

/// The first derivatives of angle and velocity by the parameters of [`PARAMETERS`], in SI units and radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DampedJacobian {
    /// Of the angle.
    pub theta: [f64; PARAMETERS.len()],
    /// Of the velocity.
    pub velocity: [f64; PARAMETERS.len()],
}

impl DampedJacobian {
    const UNDEFINED: DampedJacobian =
        DampedJacobian { theta: [f64::NAN; PARAMETERS.len()], velocity: [f64::NAN; PARAMETERS.len()] };
}

/// The derivatives of one trajectory, set up once for many times.
///
/// ```
/// use libration::{DampedPendulum, DampedSensitivity, Frequency, Friction, Torque};
/// let friction = Friction::new(0.01, 0.0, 0.0, 0.0)?;
/// let pendulum = DampedPendulum::new(2.0, 0.0, Frequency::from_omega0(1.0)?, friction, Torque::NONE)?;
/// let by = DampedSensitivity::new(&pendulum.trajectory(0.0, 30.0)?)?.at(25.0);
/// assert_eq!(format!("{:.6} {:.6}", by.theta[0], by.theta[3]), "6.689189 -188.942304");
/// # Ok::<(), libration::Domain>(())
/// ```
#[derive(Clone, Debug)]
pub struct DampedSensitivity {
    branches: Arc<[Branch; 2]>,
    /// At the start of every segment of the branches.
    starts: [Vec<Columns>; 2],
    factors: [SiFactors; 2],
    interval: (f64, f64),
    /// Of the columns that are known: a lane holds four.
    lanes: usize,
}

/// The series of the segment that was asked for last, and its branch and number.
struct Last {
    of: Option<(usize, usize)>,
    jet: ColumnJet,
}

impl Last {
    fn none() -> Last {
        Last { of: None, jet: ColumnJet::ZERO }
    }
}

impl DampedSensitivity {
    /// Of a trajectory; also of an exact one, which is then integrated.
    ///
    /// # Errors
    /// Where an exact motion takes too many steps to be integrated.
    pub fn new(trajectory: &Trajectory) -> Result<DampedSensitivity, Domain> {
        DampedSensitivity::new_unless(trajectory, &|| false)
    }

    /// [`DampedSensitivity::new`] of the first `parameters` of [`PARAMETERS`], each bit for bit as among all; the others mean nothing.
    /// Four, or eight, take a third, or two thirds, of the operations: a fit without a torque needs no others.
    ///
    /// # Errors
    /// As for [`DampedSensitivity::new`].
    pub fn first(trajectory: &Trajectory, parameters: usize) -> Result<DampedSensitivity, Domain> {
        DampedSensitivity::of_lanes(trajectory, parameters.div_ceil(LANE), &|| false)
    }

    /// [`DampedSensitivity::new`], where `ended` is asked now and then: once it is true, the derivatives mean nothing.
    ///
    /// # Errors
    /// As for [`DampedSensitivity::new`].
    pub fn new_unless(
        trajectory: &Trajectory,
        ended: &dyn Fn() -> bool,
    ) -> Result<DampedSensitivity, Domain> {
        DampedSensitivity::of_lanes(trajectory, LANES, ended)
    }

    fn of_lanes(
        trajectory: &Trajectory,
        lanes: usize,
        ended: &dyn Fn() -> bool,
    ) -> Result<DampedSensitivity, Domain> {
        let (start, stop) = trajectory.interval();
        let branches = match trajectory.branches() {
            Some(branches) => Arc::clone(branches),
            None => match trajectory.pendulum().branches(start, stop, Tolerance::Tight, ended) {
                (branches, None) => Arc::new(branches),
                (_, Some(refused)) => return Err(refused),
            },
        };
        let starts = [0, 1].map(|i| along(&branches[i], lanes, ended));
        let factors = [0, 1].map(|i| SiFactors::new(&branches[i].equation));
        Ok(DampedSensitivity { branches, starts, factors, interval: (start, stop), lanes })
    }

    /// The derivatives at t (in s).
    ///
    /// NaN outside of the interval of the trajectory, and by presliding where there is none. Where a start from rest depends on
    /// the side of a push, as with dry friction, the derivative by velocity0 is that of a push along the motion. Where the dry
    /// friction or the torque holds a pendulum so exactly that any change releases it, there is no derivative, and that of the
    /// rest is given. **Error** at most 1e-12 of the largest change of its row, with each derivative times the size of its
    /// parameter. Source: the variational equations, variational.rs.
    #[must_use]
    pub fn at(&self, t: f64) -> DampedJacobian {
        self.through(t, &mut Last::none())
    }

    /// [`DampedSensitivity::at`] of every time, bit for bit, row by row of the matrix; panics where the lengths differ. Rising times
    /// are the fastest.
    pub fn at_into(&self, t: &[f64], mut derivatives: [&mut [f64]; 2 * PARAMETERS.len()]) {
        let fits = derivatives.iter().all(|column| column.len() == t.len());
        assert!(fits, "columns of different lengths");
        let mut last = Last::none();
        // Rows by the block, so that a column is written in pieces and not number by number.
        let mut block = [[0.0; BLOCK]; 2 * PARAMETERS.len()];
        for (number, times) in t.chunks(BLOCK).enumerate() {
            for (row, t) in times.iter().enumerate() {
                let DampedJacobian { theta, velocity } = self.through(*t, &mut last);
                for (column, value) in block.iter_mut().zip(theta.iter().chain(&velocity)) {
                    column[row] = *value;
                }
            }
            let place = number * BLOCK..number * BLOCK + times.len();
            for (column, values) in derivatives.iter_mut().zip(&block) {
                column[place.clone()].copy_from_slice(&values[..times.len()]);
            }
        }
    }

    fn through(&self, t: f64, last: &mut Last) -> DampedJacobian {
        if !(self.interval.0..=self.interval.1).contains(&t) {
            return DampedJacobian::UNDEFINED;
        }
        let side = usize::from(t >= 0.0);
        let Branch { equation, segments } = &self.branches[side];
        let time = equation.time(t);
        let near = last.of.map_or(0, |(_, number)| number);
        let number = self.branches[side].index_near(time, near);
        let segment: &Segment = &segments[number];
        let start = &self.starts[side][number];
        let motion = if segment.side == 0.0 {
            [start.theta, start.velocity]
        } else {
            if last.of != Some((side, number)) {
                last.jet.fill(self.lanes, equation, segment, start);
                last.of = Some((side, number));
            }
            last.jet.motion(self.lanes, since(segment, time))
        };
        let [theta, velocity] = self.factors[side].of(motion);
        DampedJacobian { theta, velocity }
    }
}

/// The derivatives at the start of every segment.
fn along(Branch { equation, segments }: &Branch, lanes: usize, ended: &dyn Fn() -> bool) -> Vec<Columns> {
    let mut starts: Vec<Columns> = Vec::with_capacity(segments.len());
    let mut now = Columns::start(equation);
    let mut jet = ColumnJet::ZERO;
    let mut gave_up = false;
    for (i, segment) in segments.iter().enumerate() {
        gave_up |= i % ASKED_EVERY == ASKED_EVERY - 1 && ended();
        match i.checked_sub(1).map(|before| &segments[before]) {
            Some(before) => now = now.begun(equation, before, segment),
            // Held from the start, a push stops at once.
            None if segment.side == 0.0 => now.velocity = [0.0; super::variational::WIDTH],
            None => {}
        }
        starts.push(now);
        if segment.side != 0.0 && !gave_up {
            jet.fill(lanes, equation, segment, &now);
            now = jet.at(lanes, segment.length);
        }
    }
    starts
}

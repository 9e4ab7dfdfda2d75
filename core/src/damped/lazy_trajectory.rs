//! The trajectory of a pendulum that is integrated when it is asked for, and farther when later times are.
//!
//! A longer trajectory begins with the shorter one, bit for bit, so answers do not depend on what was asked before.

use super::damped_pendulum::DampedPendulum;
use super::damped_sensitivity::DampedSensitivity;
use super::trajectory::Trajectory;
use crate::domain::Domain;
use std::sync::{Arc, Mutex, PoisonError};

/// A trajectory is made longer by half of itself at least, so that rising times cost no more than three times the longest.
const GROWTH: f64 = 1.5;

#[derive(Clone, Debug)]
struct Known {
    /// Times that were asked for; the trajectory may end earlier where the motion does.
    asked: [f64; 2],
    trajectory: Arc<Trajectory>,
    sensitivity: Option<Arc<DampedSensitivity>>,
}

/// A pendulum with as much of its trajectory as was asked for.
#[derive(Debug)]
pub struct LazyTrajectory {
    pendulum: DampedPendulum,
    known: Mutex<Known>,
}

impl LazyTrajectory {
    /// Nothing is integrated yet.
    #[must_use]
    pub fn new(pendulum: DampedPendulum) -> LazyTrajectory {
        let trajectory = Arc::new(pendulum.reachable(0.0, 0.0));
        let known = Mutex::new(Known { asked: [0.0; 2], trajectory, sensitivity: None });
        LazyTrajectory { pendulum, known }
    }

    /// The pendulum that moves.
    #[must_use]
    pub fn pendulum(&self) -> &DampedPendulum {
        &self.pendulum
    }

    /// A trajectory that holds all of these times that the motion reaches ([`DampedPendulum::reachable`]).
    #[must_use]
    pub fn reaching(&self, times: &[f64]) -> Arc<Trajectory> {
        self.known(times).trajectory
    }

    /// The derivatives along [`LazyTrajectory::reaching`].
    ///
    /// # Errors
    /// As for [`DampedSensitivity::new`].
    pub fn sensitivity(&self, times: &[f64]) -> Result<Arc<DampedSensitivity>, Domain> {
        let known = self.known(times);
        if let Some(sensitivity) = known.sensitivity {
            return Ok(sensitivity);
        }
        let sensitivity = Arc::new(DampedSensitivity::new(&known.trajectory)?);
        let mut now = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        if Arc::ptr_eq(&now.trajectory, &known.trajectory) {
            now.sensitivity = Some(Arc::clone(&sensitivity));
        }
        Ok(sensitivity)
    }

    /// A trajectory that holds an interval.
    ///
    /// # Errors
    /// Where the motion does not reach it, as for [`DampedPendulum::trajectory`], or an end is not finite.
    pub fn over(&self, start: f64, stop: f64) -> Result<Arc<Trajectory>, Domain> {
        Domain::check("start", start, start.is_finite(), "finite")?;
        Domain::check("stop", stop, stop.is_finite(), "finite")?;
        let trajectory = self.reaching(&[start, stop]);
        let (first, last) = trajectory.interval();
        if start.min(0.0) < first || stop.max(0.0) > last {
            self.pendulum.trajectory(start.min(0.0), stop.max(0.0))?;
        }
        Ok(trajectory)
    }

    fn known(&self, times: &[f64]) -> Known {
        let (mut start, mut stop) = (0.0, 0.0);
        for t in times.iter().filter(|t| t.is_finite()) {
            (start, stop) = (f64::min(start, *t), f64::max(stop, *t));
        }
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let [first, last] = known.asked;
        if start < first || stop > last {
            let grown = |asked: f64, before: f64| {
                if asked.abs() > before.abs() {
                    asked.abs().max(GROWTH * before.abs()).copysign(asked)
                } else {
                    before
                }
            };
            known.asked = [grown(start, first), grown(stop, last)];
            known.trajectory = Arc::new(self.pendulum.reachable(known.asked[0], known.asked[1]));
            known.sensitivity = None;
        }
        known.clone()
    }
}

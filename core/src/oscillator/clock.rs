//! The phase of a motion by theta functions, in half periods, and that of its poles.

use crate::elliptic::phase::Phase;
use crate::float::Dd;

/// The poles of an escape: argument to the one ahead at any time, and of both, in half periods.
#[derive(Clone, Debug)]
pub(super) struct Poles {
    pub rest: Phase,
    pub at: Dd,
}

/// Where a time is.
#[derive(Clone, Debug)]
pub(super) struct Clock {
    /// Half periods 2K from the base.
    pub phase: Phase,
    pub poles: Option<Poles>,
    /// Power of two that times take.
    pub time: f64,
}

//! The Taylor coefficients of the motion at one time, and the equation that they follow from.

use super::taylor::{INVERSE, LONG, ORDER, Series};
use crate::float::Dd;

/// Places of the four variables.
pub(super) const SINE: usize = 0;
pub(super) const COSINE: usize = 1;
pub(super) const SLIP: usize = 2;
pub(super) const VELOCITY: usize = 3;

/// The equation on a piece where the sign of the velocity is known.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    pub omega2: Dd,
    pub linear: f64,
    /// Times the sign of the velocity.
    pub quadratic: f64,
    /// Times the sign of the velocity.
    pub dry: f64,
    /// Sign of the velocity over the presliding angle; 0 where presliding has settled.
    pub slip: f64,
    /// The largest rate of the motion: its power k is how far coefficients of order k may grow, but for a factor.
    pub rate: f64,
}

/// Coefficients of powers of time, a row for each power.
#[derive(Clone, Debug)]
pub(super) struct Jet {
    /// Of s, c, v, and of the powers 1, 2, ... in the angle; the low words of the first.
    pub rows: [[f64; 4]; ORDER + 1],
    pub low_rows: [[f64; 4]; LONG],
    /// Of u.
    pub slip: Series,
    pub low_slip: [f64; LONG],
    /// The column of v, rounded once.
    pub velocity: Series,
    /// A power of two far above the changes of s, c and v in a step.
    pub anchor: f64,
}

impl Jet {
    pub const ZERO: Jet = Jet {
        rows: [[0.0; 4]; ORDER + 1],
        low_rows: [[0.0; 4]; LONG],
        slip: [0.0; ORDER + 1],
        low_slip: [0.0; LONG],
        velocity: [0.0; ORDER + 1],
        anchor: 1.0,
    };

    /// The coefficients of the powers 1, 2, ... in the angle.
    pub fn slopes(&self) -> Series {
        let mut slopes = self.velocity;
        for (k, slope) in slopes.iter_mut().enumerate() {
            *slope *= INVERSE[k + 1].hi;
        }
        slopes
    }

    /// The sizes of the coefficients of s, c, v and of u at one power.
    pub fn sizes(&self, k: usize) -> [f64; 4] {
        let [sine, cosine, velocity, _] = self.rows[k];
        [sine.abs(), cosine.abs(), velocity.abs(), self.slip[k].abs()]
    }
}

//! The samples of a record, and those of them that a search takes.

use super::options::Stop;

/// Samples with times since the state, rising.
#[derive(Clone, Debug, Default)]
pub(super) struct Samples {
    pub t: Vec<f64>,
    pub y: Vec<f64>,
    /// Asked before each evaluation; after it no motion is found, and every search ends.
    pub stop: Stop,
}

impl Samples {
    pub fn len(&self) -> usize {
        self.t.len()
    }
    /// Those in an interval, at most about `most` of them, evenly spread.
    pub fn thinned(&self, from: f64, to: f64, most: usize) -> Samples {
        let inside: Vec<usize> = (0..self.len()).filter(|i| (from..=to).contains(&self.t[*i])).collect();
        let stride = inside.len().div_ceil(most.max(1)).max(1);
        let kept = || inside.iter().step_by(stride);
        Samples {
            t: kept().map(|i| self.t[*i]).collect(),
            y: kept().map(|i| self.y[*i]).collect(),
            stop: self.stop,
        }
    }
    /// Those for which `keep` holds.
    pub fn only(&self, keep: impl Fn(usize) -> bool) -> Samples {
        let kept = || (0..self.len()).filter(|i| keep(*i));
        Samples {
            t: kept().map(|i| self.t[i]).collect(),
            y: kept().map(|i| self.y[i]).collect(),
            stop: self.stop,
        }
    }
}

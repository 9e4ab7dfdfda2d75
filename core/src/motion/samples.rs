//! Samples of a motion: by polynomials that are made when the first sample is asked for, and with the start as given.

use super::bounded::Bounded;
use super::escape::Escape;
use super::interpolant::Interpolant;
use crate::lanes::{Formula, Lane};
use std::sync::OnceLock;

/// How polynomials become a motion.
#[derive(Clone, Copy, Debug)]
pub(crate) enum InterpolantKind {
    Bounded(Bounded),
    Escape(Escape),
}

/// The kind of a motion, and its polynomials; `None` where they would need too many terms.
#[derive(Clone, Debug)]
pub(crate) struct LazyInterpolant<K> {
    pub kind: K,
    interpolant: OnceLock<Option<Interpolant>>,
}

impl<K> LazyInterpolant<K> {
    pub fn new(kind: K) -> Self {
        LazyInterpolant { kind, interpolant: OnceLock::new() }
    }

    /// The polynomials; the first call makes them.
    #[inline(always)]
    pub fn or_make(&self, make: impl FnOnce() -> Option<Interpolant>) -> Option<&Interpolant> {
        self.interpolant.get_or_init(make).as_ref()
    }
}

/// A motion whose values at t = 0 are those that were given.
pub(crate) struct FromStart<F> {
    pub formula: F,
    /// u and u' at t = 0.
    pub start: [f64; 2],
}

impl<F: Formula<1, 2>> Formula<1, 2> for FromStart<F> {
    type Place = F::Place;
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let [u, velocity] = self.formula.at([t]);
        let at_start = t.equal(L::splat(0.0));
        [
            L::select(at_start, L::splat(self.start[0]), u),
            L::select(at_start, L::splat(self.start[1]), velocity),
        ]
    }
}

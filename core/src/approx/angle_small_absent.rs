//! In place of angle_small.rs where the feature `all-formulas` is left out: none can be made, so neither is linked.

use super::angle_columns::AngleBlock;
use crate::pendulum::Orbit;
use crate::pendulum::theta_quotients::Elliptic;

/// There is none.
#[derive(Clone, Debug)]
pub(super) enum NoSecular {}

/// There is none.
#[derive(Clone, Debug)]
pub(super) enum NoBounded {}

impl NoSecular {
    /// Refused before (angle.rs).
    pub fn new(_: &Orbit) -> Option<NoSecular> {
        None
    }

    pub fn theta(&self, _: f64) -> f64 {
        match *self {}
    }

    /// The angle, and a time within which it changes little.
    pub fn theta_and_stride(&self, _: f64) -> (f64, f64) {
        match *self {}
    }

    pub fn in_columns(&self) -> bool {
        match *self {}
    }

    pub fn columns(&self, _: &mut AngleBlock, _: usize) {
        match *self {}
    }
}

impl NoBounded {
    /// Refused before (angle.rs).
    pub fn new(_: &Orbit, _: &Elliptic) -> Option<NoBounded> {
        None
    }

    pub fn theta(&self, _: f64) -> f64 {
        match *self {}
    }

    pub fn in_columns(&self) -> bool {
        match *self {}
    }

    pub fn columns(&self, _: &mut AngleBlock, _: usize) {
        match *self {}
    }
}

//! The polynomials of one motion, made when its first sample is asked for, where they serve.

use super::bounded::Swing;
use super::escape::Flight;
use super::interpolant::Interpolant;
use std::sync::OnceLock;

/// How polynomials become a motion.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Way {
    Swing(Swing),
    Flight(Flight),
}

impl Way {
    /// With factors of u and u'.
    pub fn scaled(self, [u, velocity]: [f64; 2]) -> Way {
        match self {
            Way::Swing(swing) => {
                Way::Swing(Swing { u: swing.u * u, velocity: swing.velocity * velocity, ..swing })
            }
            Way::Flight(flight) => {
                Way::Flight(Flight { u: flight.u * u, velocity: flight.velocity * velocity, ..flight })
            }
        }
    }
}

/// A way and its polynomials: none where too many terms would be needed.
#[derive(Clone, Debug)]
pub(crate) struct Drawing {
    pub way: Way,
    arc: OnceLock<Option<Interpolant>>,
}

impl Drawing {
    pub fn new(way: Way) -> Drawing {
        Drawing { way, arc: OnceLock::new() }
    }

    /// The polynomials, or how they are made.
    #[inline(always)]
    pub fn arc(&self, new: impl FnOnce() -> Option<Interpolant>) -> Option<&Interpolant> {
        self.arc.get_or_init(new).as_ref()
    }
}

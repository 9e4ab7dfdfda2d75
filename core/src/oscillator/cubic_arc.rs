//! The polynomials of the cubic oscillator's elliptic motions: where their singularities are, and their values.
//!
//! In half periods 2K, sn, cn and dn have poles at f = i K'/2K + n and cn zeros at 1/2 + n, which repeat by i K'/K.
//! Source: DLMF 22.4(i).

use super::cubic_course::{Elliptic, Scales, Shape};
use super::cubic_motion::quotients;
use crate::elliptic::phase::Phase;
use crate::elliptic::theta::neville::NevilleTheta;
use crate::float::Dd;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::Lane;
use crate::motion::bounded::{self, Base, Leg, Swing, Taken};
use crate::motion::escape::{self, Flight, Outwards, Pole};
use crate::motion::interpolant::{Interpolant, Layout};
use crate::motion::samples::{Drawing, Way};

/// A motion on one side of its theta functions.
struct Along<'a, const HYPERBOLIC: bool>(&'a Elliptic);

/// u and u' as a quotient each.
#[inline(always)]
fn divided<L: Lane>([u, velocity]: [[Dd<L>; 2]; 2]) -> [Unnormalised<L>; 2] {
    [Unnormalised::from(u[0]).over(u[1].into()), Unnormalised::from(velocity[0]).over(velocity[1].into())]
}

impl<const HYPERBOLIC: bool> Leg for Along<'_, HYPERBOLIC> {
    #[inline(always)]
    fn at<L: Lane>(&self, f: Unnormalised<L>, _: Unnormalised<L>) -> [Unnormalised<L>; 2] {
        divided(quotients::<HYPERBOLIC, L>(self.0, f.tight()))
    }
}

impl<const HYPERBOLIC: bool> Outwards for Along<'_, HYPERBOLIC> {
    #[inline(always)]
    fn at<L: Lane>(&self, f: Unnormalised<L>, rest: Unnormalised<L>) -> [Unnormalised<L>; 2] {
        let size = if self.0.from_pole { rest } else { f };
        divided(quotients::<HYPERBOLIC, L>(self.0, size.tight()))
    }
}

/// How the polynomials of a shape become its motion.
pub(super) fn drawing(
    shape: Shape,
    lattice: &NevilleTheta,
    phase: Phase,
    from_pole: bool,
    scales: Scales,
) -> Drawing {
    let Scales { u, velocity, time } = scales;
    // On the other side of the theta functions they are far away, and not known to a double.
    let taken = if lattice.hyperbolic() {
        let pole = 0.5 * lattice.aspect;
        Taken::Pole(pole * pole)
    } else {
        Taken::Nothing
    };
    let swing = |base| Swing { base, taken, phase, time, u, velocity };
    let flight = |odd| Flight { pole: Pole::Simple, beside: None, odd, phase, from_pole, time, u, velocity };
    Drawing::new(match shape {
        // From the turning point the poles are straight above the base.
        Shape::Cn => Way::Swing(swing(Base::Zero).counted_from_far_end(Base::Turn)),
        Shape::Sn => Way::Swing(swing(Base::Zero)),
        Shape::Dn => Way::Swing(swing(Base::Well)),
        Shape::Nc | Shape::Dc => Way::Flight(flight(false)),
        Shape::Sc | Shape::SdOverC => Way::Flight(flight(true)),
    })
}

impl Elliptic {
    /// The polynomials, where few enough terms serve.
    #[inline(always)]
    pub fn arc(&self) -> Option<&Interpolant> {
        self.drawing
            .arc(|| if self.lattice.hyperbolic() { self.new_arc::<true>() } else { self.new_arc::<false>() })
    }

    #[cold]
    #[inline(never)]
    fn new_arc<const HYPERBOLIC: bool>(&self) -> Option<Interpolant> {
        let along = Along::<HYPERBOLIC>(self);
        if let Way::Flight(flight) = &self.drawing.way
            && !flight.starts_in_range()
        {
            return None;
        }
        match self.drawing.way {
            Way::Swing(Swing { base, taken, .. }) => {
                let aspect = self.lattice.aspect;
                let layout = if taken == Taken::Nothing {
                    Layout::of(&self.lattice)
                } else {
                    Layout::around(&[[0.0, 1.5 * aspect], [1.0, 0.5 * aspect]])
                }?;
                let drawn = bounded::Drawn { leg: along, base, far: base == Base::Turn, taken };
                Interpolant::faithful(layout, &drawn, bounded::SPREAD)
            }
            Way::Flight(Flight { pole, odd, .. }) => {
                let aspect = self.lattice.aspect;
                // The zeros of cn but for the poles at hand; with sn dn/cn, the poles of sn and dn too.
                let zeros = [[1.5, 0.0], [0.5, aspect]];
                let poles = [[0.0, 0.5 * aspect], [1.0, 0.5 * aspect]];
                let layout = if self.shape == Shape::SdOverC {
                    Layout::around(&[zeros[0], zeros[1], poles[0], poles[1]])
                } else {
                    Layout::around(&zeros)
                }?;
                Interpolant::faithful(
                    layout,
                    &escape::Drawn { way: along, odd, pole, beside: None },
                    escape::SPREAD,
                )
            }
        }
    }
}

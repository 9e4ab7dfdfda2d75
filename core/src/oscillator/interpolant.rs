//! The polynomials of the elliptic motions: the quotients at the nodes of the interpolation.

use super::pq_quotient::PqQuotient;
use super::root_quotient::{RootQuotient, pick_double, within};
use super::singularities::pq_map;
use super::theta_motion::{Quotient, ThetaMotion};
use crate::elliptic::theta::neville::NevilleTheta;
use crate::float::Dd;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{COMPACT, Lane};
use crate::motion::bounded::{self, BoundedFunctions, Removed};
use crate::motion::escape::{self, EscapeFunctions};
use crate::motion::interpolant::{ConformalMap, Interpolant, OneSide};
use crate::motion::samples::InterpolantKind;

/// u = n/sqrt M on one side of the theta functions, with the half periods from pole to pole and the powers of two by which
/// u and u' differ where they are counted from K.
struct RootValues<'a, const HYPERBOLIC: bool> {
    quotient: &'a RootQuotient,
    neville: &'a NevilleTheta,
    whole: Option<Dd>,
    steps: [[f64; 2]; 2],
}

/// u = A pq on one side of the theta functions.
struct PqValues<'a, const HYPERBOLIC: bool>(&'a PqQuotient, &'a NevilleTheta);

impl<const HYPERBOLIC: bool> OneSide for RootValues<'_, HYPERBOLIC> {
    #[inline(always)]
    fn at<L: Lane>(&self, f: Unnormalised<L>, rest: Unnormalised<L>) -> [Unnormalised<L>; 2] {
        let arguments = if let Some(whole) = self.whole {
            let whole = Unnormalised::splat(whole);
            let behind = f + Unnormalised::from_double(L::splat(0.5));
            [(f * whole).tight(), within((rest * whole).tight()), within((behind * whole).tight())]
        } else {
            [f.tight(); 3]
        };
        let [u_steps, velocity_steps] = &self.steps;
        let (u, velocity, folded) =
            self.quotient.quotients::<HYPERBOLIC, L>(self.neville, arguments, self.whole.is_some());
        [u.scale(pick_double(folded, u_steps)), velocity.scale(pick_double(folded, velocity_steps))]
    }
}

impl<const HYPERBOLIC: bool> OneSide for PqValues<'_, HYPERBOLIC> {
    #[inline(always)]
    fn at<L: Lane>(&self, f: Unnormalised<L>, _: Unnormalised<L>) -> [Unnormalised<L>; 2] {
        let [[above, below], [rising, square]] = self.0.quotients::<HYPERBOLIC, L>(self.1, f.tight(), false);
        [Unnormalised::from(above).over(below.into()), Unnormalised::from(rising).over(square.into())]
    }
}

/// Powers of two between the two ways of counting that values can carry.
const STEPS: f64 = 1e60;

impl ThetaMotion {
    /// The polynomials, where few enough terms serve.
    #[inline(always)]
    pub fn interpolant(&self) -> Option<&Interpolant> {
        // On a page theta functions are fast enough, and polynomials would be a tenth of the module of the springs.
        if COMPACT {
            return None;
        }
        self.interpolant.or_make(|| {
            if self.neville.hyperbolic() {
                self.new_interpolant::<true>()
            } else {
                self.new_interpolant::<false>()
            }
        })
    }

    #[cold]
    #[inline(never)]
    fn new_interpolant<const HYPERBOLIC: bool>(&self) -> Option<Interpolant> {
        match &self.quotient {
            Quotient::Pq(quotient) => {
                let map = pq_map(quotient.pq, &self.neville)?;
                self.through(PqValues::<HYPERBOLIC>(quotient, &self.neville), map)
            }
            Quotient::Root(quotient, place) => {
                let steps = quotient.steps();
                if steps.iter().any(|step| !(1.0 / STEPS..STEPS).contains(step)) {
                    return None;
                }
                let (removed, nearby) = match &self.interpolant.kind {
                    InterpolantKind::Bounded(bounded) => (bounded.removed, false),
                    InterpolantKind::Escape(escape) => (Removed::Nothing, escape.nearby.is_some()),
                };
                let map = place.map(&self.neville, removed, nearby)?;
                let values = RootValues::<HYPERBOLIC> {
                    quotient,
                    neville: &self.neville,
                    whole: self.clock.poles.as_ref().map(|poles| poles.at.scale(2.0)),
                    steps: steps.map(|step| [1.0, step]),
                };
                self.through(values, map)
            }
        }
    }

    fn through(&self, values: impl OneSide, map: ConformalMap) -> Option<Interpolant> {
        match &self.interpolant.kind {
            InterpolantKind::Bounded(bounded) => {
                let functions = BoundedFunctions { quarter: values, bounded };
                Interpolant::faithful(map, &functions, bounded::CONDITION)
            }
            InterpolantKind::Escape(escape) if escape.starts_in_range() => {
                Interpolant::faithful(map, &EscapeFunctions { to_pole: values, escape }, escape::CONDITION)
            }
            InterpolantKind::Escape(_) => None,
        }
    }
}

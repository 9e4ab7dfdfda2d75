//! A motion by theta functions: its phase, its poles, and the quotient that u is.

use super::clock::{Clock, Poles, carried_rate};
use super::energy::{Orientation, Outline};
use super::nonzero_energy::Argument;
use super::pq_quotient::PqQuotient;
use super::quotient_factors::QuotientFactors;
use super::root_quotient::RootQuotient;
use super::scaled_theta::ScaledTheta;
use super::singularities::{RootSingularities, bounded, escape, pq_bounded, pq_escape};
use crate::elliptic::phase::Phase;
use crate::elliptic::theta::neville::NevilleTheta;
use crate::float::scaled::Scaled;
use crate::motion::samples::{InterpolantKind, LazyInterpolant};

/// What u is.
#[derive(Clone, Debug)]
pub(super) enum Quotient {
    /// n/sqrt M, and where its singularities are.
    Root(RootQuotient, RootSingularities),
    /// A pq, without a quintic force.
    Pq(PqQuotient),
}

/// A motion by theta functions, set up once.
#[derive(Clone, Debug)]
pub(super) struct ThetaMotion {
    pub neville: NevilleTheta,
    pub clock: Clock,
    pub quotient: Quotient,
    /// The polynomials of the motion.
    pub interpolant: LazyInterpolant,
    /// The motion one sample after the other, where lanes do not serve.
    pub scaled: Option<Box<ScaledTheta>>,
    /// 2K.
    half: Scaled,
}

impl ThetaMotion {
    pub fn new(
        factors: &QuotientFactors,
        outline: &Outline,
        start: Argument,
        orientation: Orientation,
    ) -> ThetaMotion {
        let [m, mc] = factors.parameter();
        let neville = NevilleTheta::of_scaled(m, mc);
        let half = Scaled::from(neville.quarter).shift(1);
        let (rate, time) = carried_rate(outline.omega / half);
        let rate = rate * orientation.direction;
        let phase = Phase { rate, start: (start.base / half).to_dd() };
        let arguments = |pole: Scaled| [start.base, start.pole, pole];
        let turn = orientation.direction;
        let (quotient, kind) = match factors {
            QuotientFactors::Root(squares) => {
                let quotient = RootQuotient::new(squares, &neville, orientation);
                let place = RootSingularities::new(squares, outline.pole, half);
                let kind = match outline.pole {
                    Some(pole) => InterpolantKind::Escape(escape(
                        place,
                        &neville,
                        half,
                        outline.omega,
                        arguments(pole),
                        turn,
                        quotient.scales(),
                    )),
                    None => {
                        InterpolantKind::Bounded(bounded(place, &neville, phase, time, quotient.scales()))
                    }
                };
                (Quotient::Root(quotient, place), kind)
            }
            QuotientFactors::Pq(amplitude, parameter) => {
                let quotient = PqQuotient::new(*amplitude, outline.omega, *parameter, &neville, orientation);
                let kind = match outline.pole {
                    Some(pole) => InterpolantKind::Escape(pq_escape(
                        quotient.pq,
                        outline.omega,
                        arguments(pole),
                        turn,
                        quotient.scales,
                    )),
                    None => InterpolantKind::Bounded(pq_bounded(
                        quotient.pq, &neville, phase, time, quotient.scales,
                    )),
                };
                (Quotient::Pq(quotient), kind)
            }
        };
        let poles = outline.pole.map(|pole| Poles {
            rest: Phase { rate: -rate, start: (start.pole / half).to_dd() },
            at: (pole / half).to_dd(),
        });
        let scaled = ScaledTheta::new(factors, half, outline, start, orientation).map(Box::new);
        ThetaMotion {
            neville,
            clock: Clock { phase, poles, time },
            quotient,
            interpolant: LazyInterpolant::new(kind),
            scaled,
            half,
        }
    }

    /// 2K.
    pub fn half_period(&self) -> Scaled {
        self.half
    }
    /// Whether the motion has no poles.
    pub fn repeats(&self) -> bool {
        self.clock.poles.is_none()
    }
    /// Half periods at the start and per time, from the base and to the pole.
    pub fn rates(&self) -> [[Scaled; 2]; 2] {
        let of = |phase: &Phase| [Scaled::from(phase.start), Scaled::from(phase.rate) * self.clock.time];
        [of(&self.clock.phase), self.clock.poles.as_ref().map_or([Scaled::ZERO; 2], |poles| of(&poles.rest))]
    }
    /// An argument in half periods.
    pub fn in_half_periods(&self, Argument { base, pole }: Argument) -> Argument {
        Argument { base: base / self.half, pole: pole / self.half }
    }
}

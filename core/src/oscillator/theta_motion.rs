//! A motion by theta functions: its phase, its poles, and the quotient that u is.

use super::clock::{Clock, Poles};
use super::energy::{Orientation, Outline};
use super::nonzero_energy::Argument;
use super::pq_quotient::PqQuotient;
use super::quotient_factors::QuotientFactors;
use super::root_quotient::RootQuotient;
use super::scaled_theta::ScaledTheta;
use super::singularities::RootSingularities;
use crate::elliptic::phase::Phase;
use crate::elliptic::theta::neville::NevilleTheta;
use crate::float::Dd;
use crate::float::scaled::Scaled;
use crate::motion::bounded::Bounded;
use crate::motion::escape::{Escape, EscapePole};
use crate::motion::samples::{InterpolantKind, LazyInterpolant};

/// What u is.
#[derive(Clone, Debug)]
pub(super) enum Quotient {
    /// n/sqrt M, and where its singularities are.
    Root(RootQuotient, RootSingularities),
    /// A pq, without a quintic force.
    Pq(PqQuotient),
}

impl Quotient {
    /// How a motion without poles becomes polynomials.
    fn bounded(&self, neville: &NevilleTheta, phase: Phase, time: f64) -> Bounded {
        let (origin, removed, scales) = match self {
            Quotient::Root(quotient, place) => (place.origin(), place.removed(neville), quotient.scales()),
            Quotient::Pq(quotient) => (quotient.pq.origin(), quotient.pq.removed(neville), quotient.scales),
        };
        Bounded::new(origin, removed, phase, time, scales)
    }

    /// How an escape becomes polynomials: from 2K, the argument per time, and those of the start and of the pole.
    fn escape(
        &self,
        neville: &NevilleTheta,
        half: Scaled,
        omega: Scaled,
        Argument { base, pole: rest }: Argument,
        pole: Scaled,
        Orientation { direction, .. }: Orientation,
    ) -> Escape {
        let whole = pole.shift(1);
        let (rate, time) = (omega / whole).carried();
        let from_pole = (base - rest).is_positive();
        let (start, direction) = if from_pole { (rest, -direction) } else { (base, direction) };
        let phase = Phase { rate: rate * direction, start: (start / whole).to_dd() };
        let (pole, nearby, odd, scales) = match self {
            Quotient::Root(quotient, place) => {
                // ((1 - z)^2 - z^2)/4z^2, z = pole/half.
                let gap = half * (half - whole) / whole.square();
                let gap = if gap.is_negative() { Dd::ZERO } else { gap.to_dd() };
                (EscapePole::BranchPoint(gap), place.nearby(neville), place.odd(), quotient.scales())
            }
            Quotient::Pq(quotient) => (EscapePole::Simple, None, quotient.pq.odd(), quotient.scales),
        };
        Escape { pole, nearby, odd, phase, from_pole, time, scales }
    }
}

/// A motion by theta functions, set up once.
#[derive(Clone, Debug)]
pub(super) struct ThetaMotion {
    pub neville: NevilleTheta,
    pub clock: Clock,
    pub quotient: Quotient,
    /// The polynomials of the motion.
    pub interpolant: LazyInterpolant<InterpolantKind>,
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
        let (rate, time) = (outline.omega / half).carried();
        let rate = rate * orientation.direction;
        let phase = Phase { rate, start: (start.base / half).to_dd() };
        let quotient = match factors {
            QuotientFactors::Root(squares) => Quotient::Root(
                RootQuotient::new(squares, &neville, orientation),
                RootSingularities::new(squares, outline.pole, half),
            ),
            QuotientFactors::Pq(amplitude, parameter) => {
                Quotient::Pq(PqQuotient::new(*amplitude, outline.omega, *parameter, &neville, orientation))
            }
        };
        let kind = match outline.pole {
            Some(pole) => InterpolantKind::Escape(
                quotient.escape(&neville, half, outline.omega, start, pole, orientation),
            ),
            None => InterpolantKind::Bounded(quotient.bounded(&neville, phase, time)),
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

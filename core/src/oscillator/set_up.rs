//! What does not depend on time: which functions describe an orbit, with the place of its start, regime, period, range
//! and escapes.

use super::elementary::Elementary;
use super::energy::{EnergyPolynomial, Orientation, Outline};
use super::hyperbolic_lanes::Hyperbolic;
use super::nonzero_energy::{Argument, NonzeroEnergy};
use super::pq_elementary::PqElementary;
use super::pq_quotient::Pq;
use super::quotient_factors::QuotientFactors;
use super::regime::OscillatorRegime;
use super::root_quotient::Squares;
use super::theta_motion::ThetaMotion;
use super::zero_energy::ZeroEnergy;
use crate::float::TWO_PI;
use crate::float::dyadic::Dyadic;
use crate::float::scaled::Scaled;

/// The energy as the arguments of places need it.
#[derive(Clone, Debug)]
pub(super) enum EnergyCase {
    Nonzero(Box<NonzeroEnergy>),
    Zero(Box<ZeroEnergy>),
}

/// An elementary motion over lanes, where its factors are of ordinary size.
#[derive(Clone, Debug)]
pub(super) enum ElementaryLanes {
    Pq(PqElementary),
    Hyperbolic(Hyperbolic),
}

/// The functions that describe an orbit.
#[derive(Clone, Debug)]
pub(super) enum Solution {
    Equilibrium,
    /// u0 + velocity0 t.
    Line(Box<Elementary>),
    Theta(Box<ThetaMotion>),
    Elementary(Box<Elementary>, Option<Box<ElementaryLanes>>),
}

/// All that does not depend on time.
#[derive(Clone, Debug)]
pub(super) struct SetUp {
    pub solution: Solution,
    pub energy_case: Option<EnergyCase>,
    pub regime: OscillatorRegime,
    pub period: f64,
    pub range: [f64; 2],
    /// Backward and forward.
    pub escapes: [f64; 2],
    pub orientation: Orientation,
}

impl EnergyCase {
    /// The argument where u^2 = y and 6 u'^2 is known.
    pub fn argument(&self, y: &Dyadic, square_speed: &Dyadic) -> Argument {
        match self {
            EnergyCase::Nonzero(energy) => energy.argument(y, square_speed),
            EnergyCase::Zero(energy) => energy.argument(y, square_speed),
        }
    }

    pub fn outline(&self) -> Outline {
        match self {
            EnergyCase::Nonzero(energy) => energy.outline(),
            EnergyCase::Zero(energy) => energy.outline(),
        }
    }
}

fn equilibrium(u: f64, y: &Dyadic, force: [f64; 3]) -> SetUp {
    let [p, q, s] = force.map(Dyadic::from);
    let stiffness = p + y * (q * 3.0 + y * s * 5.0);
    let period = if stiffness.sign() > 0 {
        (Scaled::from(TWO_PI) / stiffness.to_scaled().sqrt()).value()
    } else {
        f64::INFINITY
    };
    SetUp {
        solution: Solution::Equilibrium,
        energy_case: None,
        regime: OscillatorRegime::Rest,
        period,
        range: [u; 2],
        escapes: [f64::NEG_INFINITY, f64::INFINITY],
        orientation: Orientation { sign: 1.0, direction: 1.0 },
    }
}

fn elementary(given: Elementary, cubic: bool) -> Solution {
    let lanes = if cubic {
        let Some(pq) = PqElementary::new(&given) else { return Solution::Line(Box::new(given)) };
        Some(ElementaryLanes::Pq(pq))
    } else {
        Hyperbolic::new(&given).map(ElementaryLanes::Hyperbolic)
    };
    Solution::Elementary(Box::new(given), lanes.map(Box::new))
}

impl SetUp {
    /// The regime by exact signs, and the functions that it asks for.
    pub fn new(energy: &EnergyPolynomial, u: f64, velocity: f64, force: [f64; 3]) -> SetUp {
        let y = Dyadic::from(u).square();
        if velocity == 0.0 && (u == 0.0 || energy.force_sign(&y) == 0) {
            return equilibrium(u, &y, force);
        }
        let square_speed = Dyadic::from(velocity).square() * 6.0;
        let energy_case = if energy.a.sign() == 0 {
            EnergyCase::Zero(Box::new(ZeroEnergy::new(energy, &y)))
        } else {
            EnergyCase::Nonzero(Box::new(NonzeroEnergy::new(energy, &y)))
        };
        let outline = energy_case.outline();
        let start = energy_case.argument(&y, &square_speed);
        let outwards = if u == 0.0 || velocity == 0.0 || (u < 0.0) == (velocity < 0.0) { 1.0 } else { -1.0 };
        let sign = Scaled::from(if u == 0.0 { velocity } else { u }).sign();
        let orientation = Orientation { sign, direction: if outline.grows { outwards } else { -outwards } };
        let solution = solution(energy, &energy_case, &outline, start, orientation);
        SetUp {
            regime: regime(energy, &outline),
            period: period(&solution, &outline).value(),
            range: range(&outline, sign).map(Scaled::value),
            escapes: escapes(&outline, start, orientation).map(Scaled::value),
            solution,
            energy_case: Some(energy_case),
            orientation,
        }
    }
}

fn solution(
    energy: &EnergyPolynomial,
    energy_case: &EnergyCase,
    outline: &Outline,
    start: Argument,
    orientation: Orientation,
) -> Solution {
    let cubic = energy.cubic();
    let factors = match energy_case {
        EnergyCase::Nonzero(found) if found.mc.is_positive() => {
            if cubic {
                QuotientFactors::Pq(Pq::of(found), [found.m(), found.mc])
            } else {
                QuotientFactors::Root(Squares::of(found))
            }
        }
        EnergyCase::Nonzero(found) => {
            return elementary(Elementary::of_double_root(found, start, orientation), cubic);
        }
        EnergyCase::Zero(found) if found.circular() => {
            if cubic {
                let amplitude = Scaled::ONE / found.upper_root().sqrt();
                QuotientFactors::Pq((Pq::Nc, amplitude), [Scaled::ZERO, Scaled::ONE])
            } else {
                QuotientFactors::Root(found.squares())
            }
        }
        EnergyCase::Zero(found) => return elementary(found.elementary(start, orientation), cubic),
    };
    Solution::Theta(Box::new(ThetaMotion::new(&factors, outline, start, orientation)))
}

fn regime(energy: &EnergyPolynomial, outline: &Outline) -> OscillatorRegime {
    if energy.linear() {
        return OscillatorRegime::Linear;
    }
    if outline.pole.is_some() {
        return OscillatorRegime::Escape;
    }
    match (outline.periodic, outline.crosses, outline.limits) {
        (true, true, _) => OscillatorRegime::Libration,
        (true, false, _) => OscillatorRegime::Well,
        (_, _, 2) => OscillatorRegime::Heteroclinic,
        _ => OscillatorRegime::Homoclinic,
    }
}

fn period(solution: &Solution, outline: &Outline) -> Scaled {
    match solution {
        Solution::Theta(motion) if outline.periodic => {
            let half = motion.half_period() / outline.omega;
            if outline.crosses { half.shift(1) } else { half }
        }
        _ => Scaled::INFINITY,
    }
}

/// Lowest and highest u.
fn range(outline: &Outline, sign: f64) -> [Scaled; 2] {
    let [inner, outer] = outline.reach;
    match (outline.crosses, sign < 0.0) {
        (true, _) => [-outer, outer],
        (_, true) => [-outer, -inner],
        _ => [inner, outer],
    }
}

/// Times of the escapes backward and forward.
fn escapes(outline: &Outline, start: Argument, orientation: Orientation) -> [Scaled; 2] {
    let Some(pole) = outline.pole else { return [-Scaled::INFINITY, Scaled::INFINITY] };
    let ahead = start.pole / outline.omega;
    let (ahead, behind) =
        if outline.grows { (ahead, (pole + start.base) / outline.omega) } else { (Scaled::INFINITY, ahead) };
    if orientation.direction > 0.0 { [-behind, ahead] } else { [-ahead, behind] }
}

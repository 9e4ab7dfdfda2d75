//! Where the singularities of the elliptic motions are: what is removed from a motion before its interpolation, and how
//! its polynomials are mapped.
//!
//! Without a quintic force: in half periods 2K, sn, cn and dn have poles at f = i K'/2K + n, and cn zeros at 1/2 + n,
//! which repeat by i K'/K (DLMF 22.4(i)).
//!
//! With one, u has a branch point wherever v = 1/u^2 = 0, at f = +-z + n + k tau half periods: tau = i K'/K, or
//! (1 + i K'/K)/2 with a complex pair. For an escape z is real. Else z lies above a base, or above the side of the period's
//! rectangle on which v goes on from there, at an integral of the first kind:
//!
//! | root case | where | z from the far turning point, in units of the argument |
//! |---|---|---|
//! | crossing | v1 <= 0 | i F(v0/(v0 - v1), mc) |
//! | crossing | v2 <= 0 < v1 | K - F(-v2/(v1 - v2), m) + i K' |
//! | crossing | 0 < v2 | from the zero, i sqrt(v0 - v2) R_F(v0, v1, v2) |
//! | inside | | i F(v2/v1, mc) |
//! | between | v2 <= 0 | i F(v1 (v0 - v2)/(v0 (v1 - v2)), mc) |
//! | between | 0 < v2 | F(v2/v1, m) + i K' |
//! | crossing, pair | | i/2 of the F whose cosine is (H - v0)/(H + v0), mc |
//!
//! with F(sin^2, m). Two digits of it are enough. Source: Byrd & Friedman 232, 235, 236, 238, 243.

use super::nonzero_energy::RootCase;
use super::pq_quotient::Pq;
use super::root_quotient::Squares;
use crate::elliptic::carlson_rf;
use crate::elliptic::theta::neville::NevilleTheta;
use crate::float::scaled::Scaled;
use crate::motion::bounded::{Origin, Removed};
use crate::motion::escape::NearbyBranchPoints;
use crate::motion::interpolant::ConformalMap;

/// What tells where the singularities of a motion are.
#[derive(Clone, Copy, Debug)]
pub(super) struct RootSingularities {
    case: RootCase,
    m: f64,
    mc: f64,
    /// Of the factors of q^2 and p^2.
    ratio: f64,
    /// The pole of an escape in half periods; 0 without.
    pole: f64,
}

/// F, from the square of the sine.
fn first_kind(square: f64, m: f64) -> f64 {
    let square = square.clamp(0.0, 1.0);
    square.sqrt() * carlson_rf(1.0 - square, 1.0 - m * square, 1.0)
}

impl RootSingularities {
    pub fn new(factors: &Squares, pole: Option<Scaled>, half: Scaled) -> RootSingularities {
        let [l, q] = factors.squares;
        RootSingularities {
            case: factors.case,
            m: factors.m.value(),
            mc: factors.mc.value(),
            ratio: (q / l).value(),
            pole: pole.map_or(0.0, |pole| (pole / half).value()),
        }
    }

    fn pair(self) -> bool {
        matches!(self.case, RootCase::PairCrossing | RootCase::PairOutside)
    }

    /// Whether u is odd about the base.
    pub fn odd(self) -> bool {
        matches!(self.case, RootCase::Crossing | RootCase::PairCrossing)
    }

    /// Where a motion without poles is best counted from.
    pub fn origin(self) -> Origin {
        match self.case {
            RootCase::Crossing if self.ratio >= 1.0 => Origin::Zero,
            RootCase::Crossing | RootCase::PairCrossing => Origin::TurningPoint,
            _ => Origin::WellTurningPoint,
        }
    }

    /// z from there, as the argument, of a motion without poles; K and K'.
    fn argument(self, [quarter, other]: [f64; 2]) -> [f64; 2] {
        let RootSingularities { case, m, mc, ratio, .. } = self;
        match case {
            // In units of v0 - v2: v0 is the ratio.
            RootCase::Crossing if ratio <= mc => [0.0, first_kind(ratio / mc, mc)],
            RootCase::Crossing if ratio < 1.0 => [quarter - first_kind((1.0 - ratio) / m, m), other],
            RootCase::Crossing => [0.0, carlson_rf(ratio, ratio - mc, ratio - 1.0)],
            RootCase::PairCrossing => {
                let sum = 1.0 + ratio;
                let half = 0.5 * first_kind(4.0 * (ratio / sum) / sum, mc);
                [0.0, if ratio <= 1.0 { half } else { other - half }]
            }
            RootCase::Inside => [0.0, first_kind(ratio, mc)],
            // In units of v0: v1 is the ratio.
            _ if ratio <= mc => [0.0, first_kind(ratio / mc, mc)],
            _ => [first_kind((1.0 - (1.0 - ratio) / m) / ratio, m), other],
        }
    }

    /// z in half periods, likewise.
    fn in_half_periods(self, neville: &NevilleTheta) -> [f64; 2] {
        let quarter = neville.quarter.hi;
        self.argument([quarter, neville.aspect * quarter]).map(|z| z / (2.0 * quarter))
    }

    /// What is best taken out of a motion without poles.
    pub fn removed(self, neville: &NevilleTheta) -> Removed {
        let [re, im] = self.in_half_periods(neville);
        if re > 0.0 || im > NEAR {
            return Removed::Nothing;
        }
        // A sum of the periods is i K'/K for a pair too.
        let other = neville.aspect - im;
        Removed::BranchPoints([im * im, other * other])
    }

    /// What is best taken out of an escape besides its poles: with a pair u' vanishes where dn(2v) does, at
    /// (1 + i K'/K)/4 half periods, and u branches at (1 + i K'/K)/2 - z.
    pub fn nearby(self, neville: &NevilleTheta) -> Option<NearbyBranchPoints> {
        // A small nome of m leaves both far, and the aspect to two digits.
        let height = 0.125 * neville.aspect / self.pole;
        if !self.pair() || !neville.hyperbolic() || height > NEARBY {
            return None;
        }
        let across = 0.25 / self.pole - 0.5;
        Some(NearbyBranchPoints::new([across, 2.0 * height], [0.125 / self.pole, height]))
    }

    /// The map of the motion, if few enough terms serve.
    pub fn map(self, neville: &NevilleTheta, removed: Removed, nearby: bool) -> Option<ConformalMap> {
        let aspect = neville.aspect;
        let [across, up] = if self.pair() { [0.5, 0.5 * aspect] } else { [0.0, aspect] };
        if self.pole > 0.0 {
            // In flights: the poles 1/2 and (1 - z)/2z are taken out.
            let flights = |[re, im]: [f64; 2]| [0.5 * re / self.pole, 0.5 * im / self.pole];
            let z = self.pole;
            if nearby {
                let above = flights([z, 2.0 * up]);
                return ConformalMap::around(&[flights([1.0 + z, 0.0]), flights([across + z, up]), above]);
            }
            return ConformalMap::around(&[
                flights([1.0 + z, 0.0]),
                flights([across + z, up]),
                flights([across - z, up]),
                flights([1.0 - across - z, up]),
            ]);
        }
        let [re, im] = self.in_half_periods(neville);
        let beside = [across - re, up - im];
        if removed == Removed::Nothing {
            return ConformalMap::around(&[
                [re, im],
                [1.0 - re, im],
                beside,
                [1.0 - beside[0].abs(), beside[1]],
            ]);
        }
        // Those at +-i im and +-i (K'/K - im) are taken out.
        let above = [across, up + im];
        if self.pair() {
            ConformalMap::around(&[beside, above, [1.0, im], [0.0, aspect + im]])
        } else {
            ConformalMap::around(&[above, [1.0, im], [1.0, up - im], [0.0, 2.0 * aspect - im]])
        }
    }
}

/// Singularities are taken out where they are nearer than this, in half periods.
const NEAR: f64 = 0.4;

/// Zeros of u' are taken out of an escape where they are nearer to its way than this, in flights.
const NEARBY: f64 = 0.175;

impl Pq {
    /// Where a motion without poles is best counted from: from a turning point, its poles are straight above the origin.
    pub fn origin(self) -> Origin {
        match self {
            Pq::Sd => Origin::TurningPoint,
            Pq::Nd => Origin::WellTurningPoint,
            _ => Origin::Zero,
        }
    }

    /// What is best taken out of a motion without poles.
    pub fn removed(self, neville: &NevilleTheta) -> Removed {
        // On the circular side the poles are far away, and not known to a double.
        let pole = 0.5 * neville.aspect;
        if neville.hyperbolic() { Removed::Pole(pole * pole) } else { Removed::Nothing }
    }
}

/// The map of a motion without a quintic force, if few enough terms serve.
pub(super) fn pq_map(pq: Pq, neville: &NevilleTheta) -> Option<ConformalMap> {
    let aspect = neville.aspect;
    // For an escape the zeros of cn but for the poles at hand; with sn dn/cn, the poles of sn and dn too.
    let zeros = [[1.5, 0.0], [0.5, aspect]];
    match pq {
        Pq::Sn | Pq::Sd | Pq::Nd if neville.hyperbolic() => {
            ConformalMap::around(&[[0.0, 1.5 * aspect], [1.0, 0.5 * aspect]])
        }
        Pq::Sn | Pq::Sd | Pq::Nd => ConformalMap::of(neville),
        Pq::SnDnOverCn => {
            ConformalMap::around(&[zeros[0], zeros[1], [0.0, 0.5 * aspect], [1.0, 0.5 * aspect]])
        }
        _ => ConformalMap::around(&zeros),
    }
}

//! The polynomials of the cubic-quintic oscillator's elliptic motions: where their singularities are, and their values.
//!
//! u has a branch point wherever v = 1/u^2 = 0, at f = +-z + n + k tau half periods: tau = i K'/K, or (1 + i K'/K)/2
//! with a complex pair. For an escape z is real. Else z lies above a base, or above the side of the period's rectangle
//! on which v goes on from there, at an integral of the first kind:
//!
//! | form | case | z from the far turning point, in units of the argument |
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

use super::argument::Form;
use super::theta_quotients::{Factors, Theta, pick_double, within};
use crate::elliptic::carlson_rf;
use crate::elliptic::phase::Phase;
use crate::elliptic::theta::neville::NevilleTheta;
use crate::float::Dd;
use crate::float::exponent::ldexp;
use crate::float::scaled::Scaled;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::Lane;
use crate::motion::bounded::{self, Base, Leg, Swing, Taken};
use crate::motion::escape::{self, Beside, Flight, Outwards, Pole};
use crate::motion::interpolant::{Interpolant, Layout};
use crate::motion::samples::Way;

/// What tells where the singularities of a motion are.
#[derive(Clone, Copy, Debug)]
pub(super) struct Singular {
    form: Form,
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

impl Singular {
    pub fn new(factors: &Factors, half: Scaled) -> Singular {
        let [l, q] = factors.squares;
        Singular {
            form: factors.form,
            m: factors.m.value(),
            mc: factors.mc.value(),
            ratio: (q / l).value(),
            pole: factors.pole.map_or(0.0, |pole| (pole / half).value()),
        }
    }

    fn pair(self) -> bool {
        matches!(self.form, Form::PairCrossing | Form::PairOutside)
    }

    /// Where a motion without poles is best counted from, and whether that is the far end of its leg.
    fn base(self) -> (Base, bool) {
        match self.form {
            Form::Crossing if self.ratio >= 1.0 => (Base::Zero, false),
            Form::Crossing | Form::PairCrossing => (Base::Turn, true),
            _ => (Base::Well, true),
        }
    }

    /// z from there, as the argument, of a motion without poles; K and K'.
    fn argument(self, [quarter, other]: [f64; 2]) -> [f64; 2] {
        let Singular { form, m, mc, ratio, .. } = self;
        match form {
            // In units of v0 - v2: v0 is the ratio.
            Form::Crossing if ratio <= mc => [0.0, first_kind(ratio / mc, mc)],
            Form::Crossing if ratio < 1.0 => [quarter - first_kind((1.0 - ratio) / m, m), other],
            Form::Crossing => [0.0, carlson_rf(ratio, ratio - mc, ratio - 1.0)],
            Form::PairCrossing => {
                let sum = 1.0 + ratio;
                let half = 0.5 * first_kind(4.0 * (ratio / sum) / sum, mc);
                [0.0, if ratio <= 1.0 { half } else { other - half }]
            }
            Form::Inside => [0.0, first_kind(ratio, mc)],
            // In units of v0: v1 is the ratio.
            _ if ratio <= mc => [0.0, first_kind(ratio / mc, mc)],
            _ => [first_kind((1.0 - (1.0 - ratio) / m) / ratio, m), other],
        }
    }

    /// What is best taken out of a motion without poles.
    fn taken(self, half: f64, aspect: f64) -> Taken {
        let quarter = 0.5 * half;
        let [re, im] = self.argument([quarter, aspect * quarter]).map(|z| z / half);
        if re > 0.0 || im > NEAR {
            return Taken::Nothing;
        }
        // A sum of the periods is i K'/K for a pair too.
        let other = aspect - im;
        Taken::Roots([im * im, other * other])
    }

    /// What is best taken out of an escape besides its poles: with a pair u' vanishes where dn(2v) does, at
    /// (1 + i K'/K)/4 half periods, and u branches at (1 + i K'/K)/2 - z.
    fn beside(self, lattice: &NevilleTheta) -> Option<Beside> {
        // A small nome of m leaves both far, and the aspect to two digits.
        let height = 0.125 * lattice.aspect / self.pole;
        if !self.pair() || !lattice.hyperbolic() || height > BESIDE {
            return None;
        }
        let across = 0.25 / self.pole - 0.5;
        Some(Beside::new([across, 2.0 * height], [0.125 / self.pole, height]))
    }

    /// How the polynomials are laid out on a lattice of that 2K and K'/K.
    fn layout(self, half: f64, aspect: f64, taken: Taken, beside: bool) -> Option<Layout> {
        let [across, up] = if self.pair() { [0.5, 0.5 * aspect] } else { [0.0, aspect] };
        if self.pole > 0.0 {
            // In flights: the poles 1/2 and (1 - z)/2z are taken out.
            let flights = |[re, im]: [f64; 2]| [0.5 * re / self.pole, 0.5 * im / self.pole];
            let z = self.pole;
            if beside {
                let above = flights([z, 2.0 * up]);
                return Layout::around(&[flights([1.0 + z, 0.0]), flights([across + z, up]), above]);
            }
            return Layout::around(&[
                flights([1.0 + z, 0.0]),
                flights([across + z, up]),
                flights([across - z, up]),
                flights([1.0 - across - z, up]),
            ]);
        }
        let quarter = 0.5 * half;
        let [re, im] = self.argument([quarter, aspect * quarter]).map(|z| z / half);
        let beside = [across - re, up - im];
        if taken == Taken::Nothing {
            return Layout::around(&[[re, im], [1.0 - re, im], beside, [1.0 - beside[0].abs(), beside[1]]]);
        }
        // Those at +-i im and +-i (K'/K - im) are taken out.
        let above = [across, up + im];
        if self.pair() {
            Layout::around(&[beside, above, [1.0, im], [0.0, aspect + im]])
        } else {
            Layout::around(&[above, [1.0, im], [1.0, up - im], [0.0, 2.0 * aspect - im]])
        }
    }
}

/// Singularities are taken out where they are nearer than this, in half periods.
const NEAR: f64 = 0.4;

/// Zeros of u' are taken out of an escape where they are nearer to its way than this, in flights.
const BESIDE: f64 = 0.175;

/// How a motion without poles is drawn on a lattice, but for the factors of u and u'.
pub(super) fn swing(place: Singular, lattice: &NevilleTheta, phase: Phase, time: f64) -> Way {
    let (base, far) = place.base();
    let taken = place.taken(2.0 * lattice.quarter.hi, lattice.aspect);
    let near = Swing { base, taken, phase, time, u: 1.0, velocity: 1.0 };
    Way::Swing(if far { near.counted_from_far_end(base) } else { near })
}

/// How an escape is drawn, likewise: from the argument per time, and those of the start from the middle, to the pole,
/// and of the pole from the middle.
pub(super) fn flight(
    place: Singular,
    lattice: &NevilleTheta,
    half: Scaled,
    omega: Scaled,
    [base, rest, pole]: [Scaled; 3],
    turn: f64,
) -> Way {
    let whole = pole.shift(1);
    let rate = omega / whole;
    let time = rate.power() - rate.power().clamp(-300, 300);
    let from_pole = (base - rest).is_positive();
    let (start, turn) = if from_pole { (rest, -turn) } else { (base, turn) };
    // ((1 - z)^2 - z^2)/4z^2, z = pole/half.
    let gap = half * (half - whole) / whole.square();
    Way::Flight(Flight {
        pole: Pole::Root(if gap.is_negative() { Dd::ZERO } else { gap.to_dd() }),
        beside: place.beside(lattice),
        odd: matches!(place.form, Form::Crossing | Form::PairCrossing),
        phase: Phase { rate: rate.shift(-time).to_dd() * turn, start: (start / whole).to_dd() },
        from_pole,
        time: ldexp(1.0, time),
        u: 1.0,
        velocity: 1.0,
    })
}

/// A motion on one side of its theta functions; the powers of two by which u and u' differ where counted from K.
struct Along<'a, const HYPERBOLIC: bool>(&'a Theta, [[f64; 2]; 2]);

impl<const HYPERBOLIC: bool> Along<'_, HYPERBOLIC> {
    #[inline(always)]
    fn values<L: Lane>(&self, arguments: [Dd<L>; 3]) -> [Unnormalised<L>; 2] {
        let Along(theta, [u_steps, velocity_steps]) = self;
        let (u, velocity, folded) = theta.quotients::<HYPERBOLIC, L>(arguments);
        [u.scale(pick_double(folded, u_steps)), velocity.scale(pick_double(folded, velocity_steps))]
    }
}

impl<const HYPERBOLIC: bool> Leg for Along<'_, HYPERBOLIC> {
    #[inline(always)]
    fn at<L: Lane>(&self, f: Unnormalised<L>, _: Unnormalised<L>) -> [Unnormalised<L>; 2] {
        self.values([f.tight(); 3])
    }
}

impl<const HYPERBOLIC: bool> Outwards for Along<'_, HYPERBOLIC> {
    #[inline(always)]
    fn at<L: Lane>(&self, f: Unnormalised<L>, rest: Unnormalised<L>) -> [Unnormalised<L>; 2] {
        let whole = Unnormalised::splat(self.0.flight());
        let behind = f + Unnormalised::from_double(L::splat(0.5));
        let [f, ahead, behind] = [f, rest, behind];
        let behind = within((behind * whole).tight());
        self.values([(f * whole).tight(), within((ahead * whole).tight()), behind])
    }
}

/// Powers of two between the two ways of counting that values can carry.
const STEPS: f64 = 1e60;

impl Theta {
    /// The polynomials, where few enough terms serve.
    #[inline(always)]
    pub fn arc(&self) -> Option<&Interpolant> {
        self.drawing
            .arc(|| if self.lattice.hyperbolic() { self.new_arc::<true>() } else { self.new_arc::<false>() })
    }

    #[cold]
    #[inline(never)]
    fn new_arc<const HYPERBOLIC: bool>(&self) -> Option<Interpolant> {
        if let Way::Flight(flight) = &self.drawing.way
            && !flight.starts_in_range()
        {
            return None;
        }
        let steps = self.steps();
        if steps.iter().any(|step| !(1.0 / STEPS..STEPS).contains(step)) {
            return None;
        }
        let along = Along::<HYPERBOLIC>(self, steps.map(|step| [1.0, step]));
        let layout = |taken, beside| {
            self.place.layout(2.0 * self.lattice.quarter.hi, self.lattice.aspect, taken, beside)
        };
        match self.drawing.way {
            Way::Swing(Swing { base, taken, .. }) => {
                let far = base != Base::Zero;
                let drawn = bounded::Drawn { leg: along, base, far, taken };
                Interpolant::faithful(layout(taken, false)?, &drawn, bounded::SPREAD)
            }
            Way::Flight(Flight { pole, beside, odd, .. }) => {
                let drawn = escape::Drawn { way: along, odd, pole, beside };
                Interpolant::faithful(layout(Taken::Nothing, beside.is_some())?, &drawn, escape::SPREAD)
            }
        }
    }
}

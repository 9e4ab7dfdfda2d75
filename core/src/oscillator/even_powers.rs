//! One orbit of u'' + p u + r u^2 + q u^3 = c, set up once: regime, period, range, energy and escapes.
//!
//! u'^2 is a real quartic P(u). Its exact invariants (quartic.rs) tell the class, its curve (curve.rs) the period; a bounded motion
//! is the weighted mean of its turning points (mean.rs), an escape a product of theta functions (product.rs); where P is a square,
//! and where the force is linear, functions are elementary (riccati.rs).

use super::curve::{Curve, Family};
use super::even_lanes::{MeanLanes, ProductLanes};
use super::mean::{Mean, polished};
use super::product::Product;
use super::quartic::Quartic;
use super::regime::OscillatorRegime;
use super::riccati::{Riccati, Unbounded};
use crate::float::TWO_PI;
use crate::float::dyadic::Dyadic;
use crate::float::scaled::Scaled;

/// The functions that describe the motion.
#[derive(Clone, Debug)]
pub(super) enum EvenSolution {
    Rest,
    Mean(Box<Mean>),
    Product(Box<Product>),
    Square(Box<Riccati>),
    Linear(Box<Unbounded>),
}

/// An orbit, set up once.
#[derive(Clone, Debug)]
pub(super) struct EvenPowers {
    pub u0: f64,
    pub velocity0: f64,
    /// p, q, r and c.
    pub force: [f64; 4],
    pub quartic: Quartic,
    pub solution: EvenSolution,
    pub regime: OscillatorRegime,
    pub period: Scaled,
    pub range: [Scaled; 2],
    pub escapes: [Scaled; 2],
    pub lanes: Option<EvenLanes>,
}

/// The motion over lanes, where its factors are of ordinary size.
#[derive(Clone, Debug)]
pub(super) enum EvenLanes {
    Mean(Box<MeanLanes>),
    Product(Box<ProductLanes>),
}

const NEVER: [Scaled; 2] = [Scaled::MINUS_INFINITY, Scaled::INFINITY];

impl EvenPowers {
    /// Of finite numbers: p, q, r and c.
    pub fn new(u0: f64, velocity0: f64, force: [f64; 4]) -> EvenPowers {
        let quartic = Quartic::new(u0, velocity0, force);
        let (solution, regime, period, escapes) = solved(&quartic);
        let range = range(&quartic, &solution, escapes);
        let lanes = lanes(&solution, u0);
        EvenPowers { u0, velocity0, force, quartic, solution, regime, period, range, escapes, lanes }
    }

    /// u'^2/2 + p u^2/2 + r u^3/3 + q u^4/4 - c u, from a sum without rounding.
    pub fn energy(&self) -> f64 {
        let [p, q, r, c] = self.force.map(Dyadic::from);
        let u = &self.quartic.u0;
        let twelve =
            &self.quartic.speed2 * 6.0 + u * (u * (p * 6.0 + u * (r * 4.0 + u * q * 3.0)) - c * 12.0);
        (twelve.to_scaled() / Scaled::from(12.0)).value()
    }

    /// u and u' at t, in double-doubles of any range.
    pub fn careful_motion(&self, t: f64) -> (f64, f64) {
        if t.is_nan() {
            return (t, t);
        }
        if t == 0.0 {
            return (self.u0, self.velocity0);
        }
        let time = Scaled::from(t);
        let moved = |[x, velocity]: [Scaled; 2]| ((Scaled::from(self.u0) + x).value(), velocity.value());
        match &self.solution {
            EvenSolution::Rest => (self.u0, 0.0),
            EvenSolution::Mean(mean) => {
                let periodic = mean.curve.period.is_finite();
                let periods = (time / mean.curve.period).abs().value();
                if periodic && (periods.is_nan() || periods >= LAST_PERIOD) {
                    return (f64::NAN, f64::NAN);
                }
                if !time.is_finite() {
                    return (mean.other.value(), 0.0);
                }
                let [u, velocity] = mean.at(time - mean.at_base);
                (u.value(), velocity.value())
            }
            EvenSolution::Product(product) => moved(product.at(time)),
            EvenSolution::Square(riccati) => moved(riccati.at(time)),
            EvenSolution::Linear(unbounded) => moved(unbounded.at(time)),
        }
    }
}

/// 2^53 periods of the curve: beyond, doubles are further apart than a motion repeats.
const LAST_PERIOD: f64 = 9_007_199_254_740_992.0;

fn lanes(solution: &EvenSolution, u0: f64) -> Option<EvenLanes> {
    match solution {
        EvenSolution::Mean(mean) => {
            let lanes = MeanLanes::new(mean, mean.curve.neville()?)?;
            Some(EvenLanes::Mean(Box::new(lanes)))
        }
        EvenSolution::Product(product) => {
            let lanes = ProductLanes::new(product, product.curve.neville()?, u0)?;
            Some(EvenLanes::Product(Box::new(lanes)))
        }
        _ => None,
    }
}

/// The functions, the regime, the period and the escapes.
fn solved(quartic: &Quartic) -> (EvenSolution, OscillatorRegime, Scaled, [Scaled; 2]) {
    if quartic.at_rest() {
        let stiffness = quartic.sigma.to_scaled();
        let period =
            if stiffness.is_positive() { Scaled::from(TWO_PI) / stiffness.sqrt() } else { Scaled::INFINITY };
        return (EvenSolution::Rest, OscillatorRegime::Rest, period, NEVER);
    }
    let linear = quartic.linear();
    if linear && quartic.sigma.sign() <= 0 {
        let unbounded = Unbounded::new(quartic);
        return (
            EvenSolution::Linear(Box::new(unbounded)),
            OscillatorRegime::Linear,
            Scaled::INFINITY,
            NEVER,
        );
    }
    if let (false, Some(sign)) = (linear, quartic.square()) {
        let riccati = Riccati::new(quartic, sign);
        let escapes = riccati.escapes;
        let ends = escapes.iter().any(|t| t.is_finite());
        let regime = if ends { OscillatorRegime::Escape } else { OscillatorRegime::Heteroclinic };
        return (EvenSolution::Square(Box::new(riccati)), regime, Scaled::INFINITY, escapes);
    }
    let curve = Curve::new(quartic);
    let (turned, passes) = if quartic.velocity0.sign() == 0 {
        (Scaled::ZERO, false)
    } else {
        let (point, on_oval, sign) = quartic.start();
        let time = curve.time(point, on_oval);
        let before = (sign > 0) != on_oval;
        (if before { -time } else { time }, on_oval)
    };
    let [above, below] = quartic.roots_beside();
    let between = if quartic.velocity0.sign() != 0 {
        above > 0 && below > 0
    } else if quartic.force.sign() > 0 {
        above > 0
    } else {
        below > 0
    };
    let bounded = linear || quartic.q.sign() > 0 || curve.three() && !passes && between;
    if !bounded {
        let product = Product::new(quartic, curve, turned, passes);
        let escapes = product.escapes;
        return (
            EvenSolution::Product(Box::new(product)),
            OscillatorRegime::Escape,
            Scaled::INFINITY,
            escapes,
        );
    }
    let period = curve.period;
    let regime = if linear {
        OscillatorRegime::Linear
    } else if !matches!(curve.family, Family::Theta(_)) {
        OscillatorRegime::Homoclinic
    } else if quartic.discriminant.sign() > 0 && quartic.q.sign() > 0 {
        OscillatorRegime::Well
    } else {
        OscillatorRegime::Libration
    };
    (EvenSolution::Mean(Box::new(Mean::new(quartic, curve, turned))), regime, period, NEVER)
}

/// Lowest and highest u.
fn range(quartic: &Quartic, solution: &EvenSolution, [behind, ahead]: [Scaled; 2]) -> [Scaled; 2] {
    let u0 = quartic.u0.to_scaled();
    let sorted = |a: Scaled, b: Scaled| if (b - a).is_negative() { [b, a] } else { [a, b] };
    let everything = [Scaled::MINUS_INFINITY, Scaled::INFINITY];
    let rising = quartic.velocity0.sign() > 0;
    // From an end to infinity, upwards or downwards.
    let beyond =
        |end: Scaled, up: bool| if up { [end, Scaled::INFINITY] } else { [Scaled::MINUS_INFINITY, end] };
    let size = |x: Scaled| x.abs() + u0.abs();
    match solution {
        EvenSolution::Rest => [u0, u0],
        EvenSolution::Mean(mean) => sorted(mean.base, mean.other),
        EvenSolution::Linear(unbounded) => match unbounded.ends(quartic) {
            None => everything,
            Some(x) => {
                let up = if quartic.force.sign() == 0 { rising } else { quartic.force.sign() > 0 };
                beyond(polished(quartic, u0 + x, size(x), true), up)
            }
        },
        EvenSolution::Square(riccati) => {
            let [past, future] = riccati.limits;
            let limit = |x: Scaled| polished(quartic, u0 + x, size(x), true);
            match (behind.is_finite(), ahead.is_finite()) {
                (false, false) => sorted(limit(past), limit(future)),
                (true, true) => everything,
                (true, false) => beyond(limit(future), !rising),
                (false, true) => beyond(limit(past), rising),
            }
        }
        EvenSolution::Product(product) => {
            if let Some(at) = product.turn() {
                let x = product.at(at)[0];
                let end = polished(quartic, u0 + x, size(x), false);
                let slope = quartic.slope(end);
                return beyond(end, slope.is_positive());
            }
            if behind.is_finite() && ahead.is_finite() {
                return everything;
            }
            let up = rising == ahead.is_finite();
            beyond(quartic.double_root(), up)
        }
    }
}

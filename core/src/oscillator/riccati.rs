//! Motions where u'^2 is the square of a quadratic, u' = alpha x^2 + beta x + u0' with x = u - u0, and those of a linear force with
//! a constant: in double-doubles of any range, one sample after the other.
//!
//! With g^2 = beta^2/4 - alpha u0': x = u0' S/D and u' = u0'/D^2, S = sinh(g t)/g, D = cosh(g t) - beta S/2. For alpha u0' < 0 this
//! is the way from one unstable equilibrium to another, and D a sum of two exponentials of one sign; else there are poles, and D a
//! sinh, a sine or a straight line of the time to one.
//! Source: Riccati's equation; elementary.

use super::quartic::Quartic;
use crate::elliptic::integrals::carlson::{artanh, rf_of_roots};
use crate::float::PI;
use crate::float::scaled::Scaled;
use crate::float::series::long_sine;

/// What D is.
#[derive(Clone, Copy, Debug)]
enum Denominator {
    /// Half of the first times e^(g t) and of the second times e^(-g t).
    Sum([Scaled; 2]),
    /// sinh or sine of the time to the pole, or that time.
    Sinh,
    Sine,
    Line,
}

/// A motion by the square of a quadratic.
#[derive(Clone, Debug)]
pub(super) struct Riccati {
    lead: Scaled,
    rate: Scaled,
    denominator: Denominator,
    /// When it escapes, with the same sign of the rate.
    pole: Scaled,
    pub escapes: [Scaled; 2],
    /// x in the far past and future, where it does not escape.
    pub limits: [Scaled; 2],
}

/// A linear force with a constant, p <= 0.
#[derive(Clone, Debug)]
pub(super) struct Unbounded {
    velocity: Scaled,
    force: Scaled,
    /// sqrt(-p).
    rate: Scaled,
}

/// Beyond, exponentials have their limits.
const FAR: f64 = 1e7;

impl Riccati {
    /// From the sign of alpha u0'.
    pub fn new(quartic: &Quartic, sign: i32) -> Riccati {
        let lead = quartic.velocity0.to_scaled();
        // beta/2, g^2 and alpha u0'.
        let half = (quartic.force.to_scaled() / lead).shift(-1);
        let square = if quartic.i.sign() == 0 {
            Scaled::ZERO
        } else {
            -quartic.j.to_scaled() / quartic.i.to_scaled().shift(2)
        };
        let rate = square.abs().sqrt();
        let infinite = [-Scaled::INFINITY, Scaled::INFINITY];
        let mut found = Riccati {
            lead,
            rate,
            denominator: Denominator::Line,
            pole: Scaled::INFINITY,
            escapes: infinite,
            limits: infinite,
        };
        let side = |pole: Scaled| {
            if pole.is_negative() { [pole, Scaled::INFINITY] } else { [-Scaled::INFINITY, pole] }
        };
        if square.is_zero() {
            found.pole = Scaled::ONE / half;
            found.escapes = side(found.pole);
            let limit = -lead / half;
            found.limits = [limit, limit];
        } else if square.is_negative() {
            found.denominator = Denominator::Sine;
            // The angle whose cotangent is beta/2g, in (0, pi).
            let angle = arccot(half / rate);
            found.pole = angle / rate;
            found.escapes = [-((Scaled::from(PI) - angle) / rate), found.pole];
        } else if sign < 0 {
            let product = exact_product(quartic);
            let larger = rate + half.abs();
            let smaller = product / larger;
            // g - beta/2 and g + beta/2.
            let [minus, plus] = if half.is_negative() { [larger, smaller] } else { [smaller, larger] };
            found.denominator = Denominator::Sum([minus / rate, plus / rate]);
            found.limits = [-lead / plus, lead / minus];
        } else {
            found.denominator = Denominator::Sinh;
            let product = exact_product(quartic);
            // tanh of the argument is 2g/beta.
            let argument = artanh(rate / half.abs(), product.sqrt() / half.abs());
            found.pole = (argument / rate).signed(half.sign());
            found.escapes = side(found.pole);
            let larger = rate + half.abs();
            let limit = if half.is_negative() { lead / larger } else { -lead / larger };
            found.limits = [limit, limit];
        }
        found
    }

    /// When a motion between two equilibria is in the middle, and its rate.
    pub fn middle(&self) -> (Scaled, Scaled) {
        let Denominator::Sum([minus, plus]) = self.denominator else { return (Scaled::NAN, Scaled::NAN) };
        // Where both exponentials are equal.
        let at = Scaled::from((minus / plus).minus_ln()).shift(-1) / self.rate;
        (at, self.rate)
    }

    /// u - u0 and u' at a time; NaN at the escapes and beyond.
    pub fn at(&self, t: Scaled) -> [Scaled; 2] {
        let [behind, ahead] = self.escapes;
        if !((t - behind).is_positive() && (ahead - t).is_positive()) {
            return [Scaled::NAN; 2];
        }
        let argument = t * self.rate;
        let far = argument.abs().value() >= FAR
            && !matches!(self.denominator, Denominator::Line | Denominator::Sine);
        let argument = if far { Scaled::from(FAR).signed(argument.sign()) } else { argument };
        let (sine, below) = match self.denominator {
            Denominator::Line => (t, (self.pole - t) / self.pole),
            Denominator::Sum([minus, plus]) => {
                let grown = Scaled::exp(argument.to_dd());
                let sum = (minus * grown + plus / grown).shift(-1);
                (argument.sinh_cosh().0 / self.rate, sum)
            }
            Denominator::Sinh => {
                let pole = self.pole * self.rate;
                (argument.sinh_cosh().0 / self.rate, (pole - argument).sinh_cosh().0 / pole.sinh_cosh().0)
            }
            Denominator::Sine => {
                let from = |pole: Scaled| sine((pole - t) * self.rate);
                let to_pole =
                    if (ahead - t - (t - behind)).is_negative() { from(ahead) } else { -from(behind) };
                (sine(argument) / self.rate, to_pole / sine(self.pole * self.rate))
            }
        };
        [self.lead * sine / below, self.lead / below.square()]
    }
}

/// |alpha u0'|, from the exact coefficients: K/2 u0'^2 of [`Quartic::square`].
fn exact_product(quartic: &Quartic) -> Scaled {
    let k = &quartic.sigma * &quartic.speed2 + quartic.force.square();
    (k.to_scaled() / quartic.speed2.to_scaled()).abs().shift(-1)
}

/// The sine of an angle in (-pi, pi).
fn sine(angle: Scaled) -> Scaled {
    if angle.power() < -200 { angle } else { Scaled::from(long_sine(angle.to_dd())) }
}

/// The angle in (0, pi) with that cotangent.
fn arccot(cotangent: Scaled) -> Scaled {
    let size = cotangent.abs();
    let root = (Scaled::ONE + size.square()).sqrt();
    let angle = rf_of_roots([size, root, root]);
    if cotangent.is_negative() { Scaled::from(PI) - angle } else { angle }
}

impl Unbounded {
    pub fn new(quartic: &Quartic) -> Unbounded {
        Unbounded {
            velocity: quartic.velocity0.to_scaled(),
            force: quartic.force.to_scaled(),
            rate: (-quartic.sigma.to_scaled()).sqrt(),
        }
    }

    /// u - u0 and u' at a time.
    pub fn at(&self, t: Scaled) -> [Scaled; 2] {
        let Unbounded { velocity, force, rate } = *self;
        if rate.is_zero() {
            return [t * (velocity + (force * t).shift(-1)), velocity + force * t];
        }
        let argument = t * rate;
        let argument =
            if argument.abs().value() < FAR { argument } else { Scaled::from(FAR).signed(argument.sign()) };
        let (sinh, cosh) = argument.shift(-1).sinh_cosh();
        let (whole_sinh, whole_cosh) = argument.sinh_cosh();
        let over = force / rate;
        [(sinh * (velocity * cosh + over * sinh)).shift(1) / rate, velocity * whole_cosh + over * whole_sinh]
    }

    /// x where it turns, if it does; and whether it comes from a limit or goes to one, which is then x.
    pub fn ends(&self, quartic: &Quartic) -> Option<Scaled> {
        let square = quartic.force.square() + &quartic.sigma * &quartic.speed2;
        if square.sign() < 0 {
            return None;
        }
        let larger = self.force.abs() + square.to_scaled().sqrt();
        if larger.is_zero() {
            return None;
        }
        Some(-(quartic.speed2.to_scaled() / larger).signed(self.force.sign()))
    }
}

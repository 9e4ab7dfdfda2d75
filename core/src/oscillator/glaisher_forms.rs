//! The twelve forms u = c1 pq(Omega t + c2 | m) of solutions of u'' + p u + q u^3 = 0.
//!
//! With Q = q c1^2:
//!
//! | form | Omega^2 | m | real where |
//! |---|---|---|---|
//! | sn, cd | (Q + 2p)/2 | -Q/(Q + 2p) | Q <= 0, Q + p >= 0 |
//! | cn | Q + p | Q/2(Q + p) | Q >= 0, Q + 2p >= 0 |
//! | dn | Q/2 | 2(Q + p)/Q | Q > 0, -Q <= p <= -Q/2 |
//! | nc | -Q - p | (Q + 2p)/2(Q + p) | Q <= 0, Q + 2p <= 0 |
//! | nd | -(Q + 2p)/2 | 2(Q + p)/(Q + 2p) | Q >= 0, Q + p <= 0 |
//! | sc | (Q - 2p)/2 | 2(Q - p)/(Q - 2p) | Q <= 0, p <= Q |
//! | sd | Q + R, R = sqrt(Q^2 + p^2) | (1 - p/(Q + R))/2 | Q >= 0 |
//! | dc, ns | -Q/2 | -(Q + 2p)/Q | Q < 0, -Q/2 <= p <= -Q |
//! | cs | -Q/2 | 2(Q - p)/Q | Q < 0, Q <= p <= Q/2 |
//! | ds | -Q/2 | (Q + 2p)/2Q | Q < 0, abs(p) <= -Q/2 |
//!
//! always with Omega > 0 (so not Q and p both 0); at Q = 0 the form is cos, sin, cosh or sinh.
//! Sums are formed without rounding, m and 1 - m each by its own quotient.
//! Source: Salas 2019 gives the first nine (his sd cancels for small p, and is 0/0 at p = 0); ns, cs and ds are ours.

use super::duffing::Duffing;
use super::regime::OscillatorRegime;
use crate::domain::Domain;
use crate::elliptic::jacobi::functions::{Jacobi, NevilleIndex, NevilleValues};
use crate::elliptic::jacobi::glaisher::Glaisher;
use crate::elliptic::parameter::{Parameter, Unit};
use crate::elliptic::phase::Phase;
use crate::float::Dd;
use crate::float::dyadic::sum_of_products;
use crate::float::elementary::{quotient, saturated_sinh_cosh};
use crate::float::scaled::Scaled;
use crate::lanes::{Columns, Evaluation, Formula, Lane, Once};

/// One solution c1 pq(Omega t + c2 | m), set up once for many times.
///
/// ```
/// use libration::{DuffingForm, Glaisher};
/// let form = DuffingForm::new(Glaisher::Cn, 1.0, 1.0, 1.0, 0.0)?;
/// assert_eq!(format!("{:.9} {:.9}", form.u(1.0), form.rate()), "0.233691791 1.414213562");
/// # Ok::<(), libration::Domain>(())
/// ```
#[derive(Clone, Debug)]
pub struct DuffingForm {
    which: Glaisher,
    others: [NevilleIndex; 2],
    c1: f64,
    c2: f64,
    rate: Dd,
    unit: Unit,
    jacobi: Jacobi,
    /// Omega t + c2.
    argument: Phase,
}

/// Omega^2, m and 1 - m; all NaN or out of range where the form is not real.
struct Coefficients {
    square: Scaled,
    m: Scaled,
    mc: Scaled,
}

impl Coefficients {
    fn new(which: Glaisher, p: f64, q: f64, c1: f64) -> Coefficients {
        // a Q + b p.
        let sum = |a: f64, b: f64| sum_of_products(&[&[a, q, c1, c1], &[b, p]]);
        let force = sum(1.0, 0.0);
        let half = |value: Scaled| value.shift(-1);
        let (square, m, mc) = match which {
            Glaisher::Sn | Glaisher::Cd => {
                let all = sum(1.0, 2.0);
                (half(all), -force / all, sum(2.0, 2.0) / all)
            }
            Glaisher::Cn => {
                let all = sum(1.0, 1.0);
                (all, half(force / all), half(sum(1.0, 2.0) / all))
            }
            Glaisher::Dn => (half(force), sum(2.0, 2.0) / force, sum(-1.0, -2.0) / force),
            Glaisher::Nc => {
                let all = sum(-1.0, -1.0);
                (all, half(sum(-1.0, -2.0) / all), half(-force / all))
            }
            Glaisher::Nd => {
                let all = sum(-1.0, -2.0);
                (half(all), sum(-2.0, -2.0) / all, force / all)
            }
            Glaisher::Sc => {
                let all = sum(1.0, -2.0);
                (half(all), sum(2.0, -2.0) / all, -force / all)
            }
            Glaisher::Sd => {
                let linear = Scaled::from(p);
                let root = (force.square() + linear.square()).sqrt();
                let all = force + root;
                // R - p and R + p, whose product is Q^2.
                let larger = root + linear.abs();
                let smaller = if larger.is_zero() { larger } else { force.square() / larger };
                let (minus, plus) = if linear.is_negative() { (larger, smaller) } else { (smaller, larger) };
                (all, half((force + minus) / all), half((force + plus) / all))
            }
            Glaisher::Dc | Glaisher::Ns => (half(-force), sum(-1.0, -2.0) / force, sum(2.0, 2.0) / force),
            Glaisher::Cs => (half(-force), sum(2.0, -2.0) / force, sum(-1.0, 2.0) / force),
            Glaisher::Ds => (half(-force), half(sum(1.0, 2.0) / force), half(sum(1.0, -2.0) / force)),
        };
        Coefficients { square, m, mc }
    }

    /// Whether Omega > 0 and 0 <= m <= 1.
    fn real(&self) -> bool {
        let in_range = |value: Scaled| value.is_finite() && !value.is_negative();
        self.square.is_positive() && in_range(self.m) && in_range(self.mc)
    }
}

fn real_where(which: Glaisher) -> &'static str {
    match which {
        Glaisher::Sn | Glaisher::Cd => "of q c1^2 <= 0 <= q c1^2 + p, and not both 0",
        Glaisher::Cn => "of q c1^2 >= 0 and q c1^2 + 2p >= 0, and not both 0",
        Glaisher::Dn => "of q > 0 and -q c1^2 <= p <= -q c1^2/2",
        Glaisher::Nc => "of q c1^2 <= 0 and q c1^2 + 2p <= 0, and not both 0",
        Glaisher::Nd => "of q c1^2 >= 0 and q c1^2 + p <= 0, and not both 0",
        Glaisher::Sc => "of q c1^2 <= 0 and p <= q c1^2, and not both 0",
        Glaisher::Sd => "of q c1^2 >= 0, and not q c1^2 and p both 0",
        Glaisher::Dc | Glaisher::Ns => "of q < 0 and -q c1^2/2 <= p <= -q c1^2",
        Glaisher::Cs => "of q < 0 and q c1^2 <= p <= q c1^2/2",
        Glaisher::Ds => "of q < 0 and |p| <= -q c1^2/2",
    }
}

impl DuffingForm {
    /// Sets up a form.
    ///
    /// | argument | domain |
    /// |---|---|
    /// | `which` | one of the twelve |
    /// | `p`, `q`, `c1` | finite, where the form is real: the table above |
    /// | `c2` | finite |
    ///
    /// **Source** Salas 2019 for the first nine forms; the table at the top of this file.
    ///
    /// # Errors
    /// A [`Domain`] that names the argument, or says where the form is real.
    pub fn new(which: Glaisher, p: f64, q: f64, c1: f64, c2: f64) -> Result<DuffingForm, Domain> {
        for (name, value) in [("p", p), ("q", q), ("c1", c1), ("c2", c2)] {
            Domain::check(name, value, value.is_finite(), "finite")?;
        }
        let coefficients = Coefficients::new(which, p, q, c1);
        if !coefficients.real() {
            let given = format!("{}, p = {p:?}, q = {q:?}, c1 = {c1:?}", which.name());
            return Err(Domain::new("form", given, real_where(which)));
        }
        let Coefficients { square, m, mc } = coefficients;
        let rate = square.sqrt().to_dd();
        let allowed = "of a rate between 1e-150 and 1e150";
        Domain::check("Omega", rate.value(), (1e-150..1e150).contains(&rate.hi), allowed)?;
        let unit = Unit { m: m.to_dd(), mc: mc.to_dd(), k: m.sqrt().to_dd(), kc: mc.sqrt().to_dd() };
        let mut jacobi = Jacobi::of_unit(unit, rate);
        let argument = Phase { rate, start: Dd::from(c2) };
        if !mc.is_zero() {
            jacobi.phase.start = argument.start / jacobi.neville.quarter.scale(2.0);
        }
        Ok(DuffingForm { which, others: which.others(), c1, c2, rate, unit, jacobi, argument })
    }

    /// Which of the twelve.
    #[must_use]
    pub fn which(&self) -> Glaisher {
        self.which
    }
    /// Omega.
    #[must_use]
    pub fn rate(&self) -> f64 {
        self.rate.value()
    }
    /// m with its complement.
    #[must_use]
    pub fn parameter(&self) -> Parameter {
        self.unit.parameter()
    }
    /// c1.
    #[must_use]
    pub fn c1(&self) -> f64 {
        self.c1
    }
    /// c2.
    #[must_use]
    pub fn c2(&self) -> f64 {
        self.c2
    }

    fn evaluate<E: Evaluation<1, 2>>(&self, evaluation: E) -> E::Output {
        let slope = slope(self.which, &self.unit) * self.rate;
        if self.unit.mc.hi == 0.0 {
            evaluation.of(&HyperbolicFormula(self, slope))
        } else if self.jacobi.neville.hyperbolic() {
            evaluation.of(&ThetaFormula::<true>(self, slope))
        } else {
            evaluation.of(&ThetaFormula::<false>(self, slope))
        }
    }

    /// u and u' at t.
    ///
    /// Beyond a pole the form goes on as pq does (the motion of an oscillator ends there). NaN for t that is not finite,
    /// as 2^100 half periods away. **Error** at most 4 ulp, plus 2^-100 of the condition.
    #[must_use]
    pub fn motion(&self, t: f64) -> (f64, f64) {
        let [u, velocity] = self.evaluate(Once([t]));
        (u, velocity)
    }
    /// u at t, as in [`DuffingForm::motion`].
    #[must_use]
    pub fn u(&self, t: f64) -> f64 {
        self.motion(t).0
    }
    /// u' at t, as in [`DuffingForm::motion`].
    #[must_use]
    pub fn velocity(&self, t: f64) -> f64 {
        self.motion(t).1
    }
    /// [`DuffingForm::motion`] of every time, bit for bit, on the widest lanes.
    ///
    /// # Panics
    /// Where the lengths differ.
    pub fn motion_into(&self, t: &[f64], u: &mut [f64], velocity: &mut [f64]) {
        self.evaluate(Columns::new([t], [u, velocity]));
    }

    /// The regimes that a form serves, found by trying it: p and Q = q c1^2 over a grid of whole numbers.
    pub fn regimes(which: Glaisher) -> Vec<OscillatorRegime> {
        let mut found = Vec::new();
        for p in -12..=12 {
            for force in -12..=12 {
                let (p, force) = (f64::from(p), f64::from(force));
                let coefficients = Coefficients::new(which, p, force, 1.0);
                if !coefficients.real() {
                    continue;
                }
                let regime = regime(which, p, force, coefficients.mc.is_zero());
                if !found.contains(&regime) {
                    found.push(regime);
                }
            }
        }
        found.sort_by_key(|regime| *regime as u8);
        found
    }

    /// Which form serves which regime: a line for each of the twelve, from [`DuffingForm::regimes`].
    pub fn table() -> [(Glaisher, Vec<OscillatorRegime>); 12] {
        Glaisher::ALL.map(|which| (which, DuffingForm::regimes(which)))
    }
}

/// The regime of a real form with c1 = 1; `asymptotic` where m = 1.
fn regime(which: Glaisher, p: f64, force: f64, asymptotic: bool) -> OscillatorRegime {
    match which {
        Glaisher::Sd | Glaisher::Sc if force == 0.0 => OscillatorRegime::Linear,
        Glaisher::Sd => OscillatorRegime::Libration,
        Glaisher::Sc | Glaisher::Cs | Glaisher::Ds => OscillatorRegime::Escape,
        Glaisher::Ns if asymptotic => OscillatorRegime::Escape,
        Glaisher::Sn if asymptotic => OscillatorRegime::Heteroclinic,
        // These turn at 1, or stay there.
        _ => Duffing::new(1.0, 0.0, p, force).map_or(OscillatorRegime::Rest, |turning| turning.regime()),
    }
}

/// The derivative of pq is this times the product of the other two theta functions over the square of theta_q: DLMF 22.13(i).
fn slope(which: Glaisher, unit: &Unit) -> Dd {
    match which {
        Glaisher::Sn | Glaisher::Sd | Glaisher::Sc | Glaisher::Nc => Dd::ONE,
        Glaisher::Cn | Glaisher::Ns | Glaisher::Cs | Glaisher::Ds => -Dd::ONE,
        Glaisher::Dn => -unit.m,
        Glaisher::Nd => unit.m,
        Glaisher::Cd => -unit.mc,
        Glaisher::Dc => unit.mc,
    }
}

struct ThetaFormula<'a, const HYPERBOLIC: bool>(&'a DuffingForm, Dd);

/// m = 1.
struct HyperbolicFormula<'a>(&'a DuffingForm, Dd);

#[inline(always)]
fn finished<L: Lane>(form: &DuffingForm, slope: Dd, values: &NevilleValues<Dd<L>, L>) -> [L; 2] {
    let [above, below] = form.which.pq();
    let [left, right] = form.others;
    let (above, above_sign) = values.theta(above);
    let (below, below_sign) = values.theta(below);
    let (left, left_sign) = values.theta(left);
    let (right, right_sign) = values.theta(right);
    let c1 = L::splat(form.c1);
    let u = quotient(above, below).value();
    // An exact zero below: the quotient's remainder would be infinity minus infinity.
    let pole = below.hi.equal(L::splat(0.0));
    let u = L::select(pole, above.hi / below.hi, u);
    let product = left * right * Dd::splat(slope);
    let square = below.square();
    let velocity = quotient(product, square).value();
    let velocity = L::select(pole, product.hi / square.hi, velocity);
    [u * (above_sign * below_sign) * c1, velocity * (left_sign * right_sign) * c1]
}

impl<const HYPERBOLIC: bool> Formula<1, 2> for ThetaFormula<'_, HYPERBOLIC> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let ThetaFormula(form, slope) = self;
        let (_, values) = form.jacobi.neville_values::<HYPERBOLIC, L>(t);
        finished::<L>(form, *slope, &values)
    }
}

impl Formula<1, 2> for HyperbolicFormula<'_> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let HyperbolicFormula(form, slope) = self;
        let y = form.argument.counted(t);
        let one = L::splat(1.0);
        let sign = one.copysign(y.hi);
        let (sinh, cosh) = saturated_sinh_cosh(y.scale(sign));
        let unit = Dd::from_double(one);
        let values = NevilleValues { s: sinh, c: unit, d: unit, n: cosh, signs: [sign, one, one] };
        finished::<L>(form, *slope, &values)
    }
}

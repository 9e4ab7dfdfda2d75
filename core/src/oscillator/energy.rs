//! The energy equation without rounding: 6 u'^2 = a + b y + c y^2 + d y^3 with y = u^2.
//!
//! From u'^2/2 + p u^2/2 + q u^4/4 + s u^6/6 = E: a = 12 E, b = -6 p, c = -3 q, d = -2 s.

use crate::float::dyadic::Dyadic;
use crate::float::scaled::Scaled;

/// The coefficients, exact.
#[derive(Clone, Debug)]
pub(super) struct EnergyPolynomial {
    pub a: Dyadic,
    pub b: Dyadic,
    pub c: Dyadic,
    pub d: Dyadic,
}

/// How the canonical function runs along the orbit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Orientation {
    /// Sign of u where the canonical function is positive.
    pub sign: f64,
    /// +1 where its argument rises with time, else -1.
    pub direction: f64,
}

/// What all regimes are told from, whatever functions describe the motion.
pub(super) struct Outline {
    /// Smallest and largest |u|; from 0 where it crosses.
    pub reach: [Scaled; 2],
    /// Whether the motion passes u = 0.
    pub crosses: bool,
    /// Whether |u| grows with the argument; those that do and have a pole have one on both sides of their base.
    pub grows: bool,
    /// Argument of the pole, if there is one.
    pub pole: Option<Scaled>,
    /// Argument per unit of time.
    pub omega: Scaled,
    /// Whether it repeats.
    pub periodic: bool,
    /// Without a pole and not periodic: how many equilibria it tends to, 1 or 2.
    pub limits: usize,
}

impl EnergyPolynomial {
    pub fn new(u: f64, velocity: f64, [p, q, s]: [f64; 3]) -> EnergyPolynomial {
        let y = Dyadic::from(u).square();
        let [b, c, d] = [(p, -6.0), (q, -3.0), (s, -2.0)].map(|(x, k)| Dyadic::from(x) * k);
        let a = Dyadic::from(velocity).square() * 6.0 - &y * (&b + &y * (&c + &y * &d));
        EnergyPolynomial { a, b, c, d }
    }
    /// 6 u'^2 where u^2 = y.
    pub fn square_speed(&self, y: &Dyadic) -> Dyadic {
        &self.a + y * (&self.b + y * (&self.c + y * &self.d))
    }
    /// -(p u + q u^3 + s u^5).
    pub fn acceleration(&self, u: f64) -> Scaled {
        let x = Dyadic::from(u);
        let y = x.square();
        let six = x * (&self.b + &y * (&self.c * 2.0 + (&y * &self.d) * 3.0));
        six.to_scaled() / Scaled::from(6.0)
    }
    /// The derivative of the force but for its sign, p + 3 q u^2 + 5 s u^4.
    pub fn stiffness(&self, u: f64) -> Scaled {
        let y = Dyadic::from(u).square();
        let six = &self.b + &y * (&self.c * 6.0 + (&y * &self.d) * 15.0);
        -(six.to_scaled() / Scaled::from(6.0))
    }
    /// Sign of the force times u where u^2 = y: of the derivative of the above.
    pub fn force_sign(&self, y: &Dyadic) -> i32 {
        (&self.b + y * (&self.c * 2.0 + (y * &self.d) * 3.0)).sign()
    }
    /// Whether the force is linear.
    pub fn linear(&self) -> bool {
        self.cubic() && self.c.sign() == 0
    }
    /// Whether there is no quintic force: v = 0 is a root of C(v), and u a quotient of theta functions.
    pub fn cubic(&self) -> bool {
        self.d.sign() == 0
    }
}

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

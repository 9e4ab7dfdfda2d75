//! The energy equation with even powers, without rounding: u'^2 = P(u) for u'' + p u + r u^2 + q u^3 = c, from a start.
//!
//! In x = u - u0, 6 P = a x^4 + 4 b x^3 + 6 c x^2 + 4 d x + e with a = -3q, b = -rho, c = -sigma, d = 3 f, e = 6 u0'^2, where
//! f is the acceleration at the start, sigma = p + 2 r u0 + 3 q u0^2 the stiffness and rho = r + 3 q u0. The invariants
//! I = a e - 4 b d + 3 c^2 and J = a c e + 2 b c d - a d^2 - b^2 e - c^3 do not depend on the origin, and the sign of
//! (I/3)^3 - J^2 tells whether P has a double root (0), two real roots and a complex pair (below 0), or four real roots or
//! none (above 0). So the class of a motion is exact.
//! Source: Cayley's invariants of the quartic; Whittaker & Watson 20.6.

use crate::float::dyadic::Dyadic;
use crate::float::scaled::Scaled;

/// The coefficients at the start and the invariants, exact.
#[derive(Clone, Debug)]
pub(super) struct Quartic {
    pub u0: Dyadic,
    pub velocity0: Dyadic,
    /// The square of the velocity.
    pub speed2: Dyadic,
    /// The acceleration.
    pub force: Dyadic,
    pub sigma: Dyadic,
    pub rho: Dyadic,
    pub q: Dyadic,
    /// I/3.
    pub i: Dyadic,
    pub j: Dyadic,
    /// (I/3)^3 - J^2.
    pub discriminant: Dyadic,
    /// rho^2 - 3 q sigma, the Hessian's lead.
    pub n: Dyadic,
    /// 54 times the lead of the sextic covariant: 27 q^2 f + 9 q rho sigma - 2 rho^3.
    pub g: Dyadic,
}

/// An exact point X of the curve Y^2 = 4 X^3 - g2 X - g3, as the resolvent needs it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point {
    pub x: Scaled,
    /// (X - e1)(X - e2)(X - e3).
    pub product: Scaled,
    /// 3 X^2 - g2/4: the sum of the products of two of them.
    pub pairs: Scaled,
}

impl Quartic {
    /// Of finite numbers.
    pub fn new(u0: f64, velocity0: f64, [p, q, r, c]: [f64; 4]) -> Quartic {
        let [u, v, p, q, r, c] = [u0, velocity0, p, q, r, c].map(Dyadic::from);
        let qu = &q * &u;
        let rho = &r + &qu * 3.0;
        let sigma = &p + &u * (&r * 2.0 + &qu * 3.0);
        let force = c - &u * (&p + &u * (&r + &qu));
        let speed2 = v.square();
        let sigma2 = sigma.square();
        let (rho_force, q_speed) = (&rho * &force, &q * &speed2);
        let rho2 = rho.square();
        let i = &sigma2 + &rho_force * 4.0 - &q_speed * 6.0;
        let j = &sigma * (&q_speed * 18.0 + &rho_force * 6.0 + &sigma2) + &q * force.square() * 27.0
            - &rho2 * &speed2 * 6.0;
        let discriminant = &i * i.square() - j.square();
        let q_sigma = &q * &sigma;
        let n = &rho2 - &q_sigma * 3.0;
        let g = q.square() * &force * 27.0 + &rho * (&q_sigma * 9.0 - &rho2 * 2.0);
        Quartic { u0: u, velocity0: v, speed2, force, sigma, rho, q, i, j, discriminant, n, g }
    }

    /// Whether nothing moves.
    pub fn at_rest(&self) -> bool {
        self.velocity0.sign() == 0 && self.force.sign() == 0
    }

    /// Whether the force is linear.
    pub fn linear(&self) -> bool {
        self.q.sign() == 0 && self.rho.sign() == 0
    }

    /// Whether P is the square of a quadratic, for a start that moves: sign of its lead times the velocity, if it is.
    pub fn square(&self) -> Option<i32> {
        if self.discriminant.sign() != 0 || self.velocity0.sign() == 0 {
            return None;
        }
        let v2 = &self.speed2;
        let k = -(&self.sigma * v2 + self.force.square());
        let odd = &self.rho * v2.square() * 2.0 + &self.force * &k * 3.0;
        let even = k.square() + &self.q * v2.square() * v2 * 2.0;
        (odd.sign() == 0 && even.sign() == 0).then(|| k.sign())
    }

    /// Real roots of P above the start and below it, with those that coincide counted apart, as far as Descartes' rule tells: their
    /// parity, and whether there are any where all roots are real. A turning point at the start is left out.
    pub fn roots_beside(&self) -> [usize; 2] {
        let signs =
            [self.speed2.sign(), self.force.sign(), -self.sigma.sign(), -self.rho.sign(), -self.q.sign()];
        let first = usize::from(signs[0] == 0);
        let changes = |below: bool| {
            let mut last = 0;
            let mut count = 0;
            for (k, sign) in signs.iter().enumerate().skip(first) {
                let sign = if below && k % 2 == 1 { -sign } else { *sign };
                if sign != 0 {
                    count += usize::from(last * sign < 0);
                    last = sign;
                }
            }
            count
        };
        [changes(false), changes(true)]
    }

    /// With q > 0 and four real roots: whether the start is between the upper two.
    pub fn right(&self) -> bool {
        let [above, _] = self.roots_beside();
        if self.velocity0.sign() == 0 { above <= 1 } else { above == 1 }
    }

    /// The point whose time is that from the start to the same u with the other velocity: the start's, for a velocity that is not 0.
    /// Whether it is on the oval of a curve with two parts, and the sign of its Y times that of the velocity.
    pub fn start(&self) -> (Point, bool, i32) {
        let v2 = &self.speed2;
        let force2 = self.force.square();
        let x = &force2 * 3.0 + &self.sigma * v2 * 2.0;
        let y = &self.force * (&force2 * 3.0 + v2 * &self.sigma * 3.0) - &self.rho * v2.square() * 2.0;
        let pairs = x.square() - &self.i * v2.square();
        let on_oval = self.discriminant.sign() >= 0 && !(x.sign() > 0 && pairs.sign() > 0);
        let speed2 = v2.to_scaled();
        let point = Point {
            x: x.to_scaled() / (speed2 * 12.0),
            product: y.to_scaled().square() / (speed2.square() * speed2 * 576.0),
            pairs: pairs.to_scaled() / (speed2.square() * 48.0),
        };
        (point, on_oval, y.sign() * self.velocity0.sign())
    }

    /// The point whose time is that from one pole of u to the other, for q != 0.
    pub fn infinity(&self) -> Point {
        let q = self.q.to_scaled();
        let q2 = self.q.square();
        Point {
            x: -self.n.to_scaled() / (q * 18.0),
            product: -self.g.to_scaled().square() / (q.square() * q * 23328.0),
            pairs: (self.n.square() * 4.0 - q2 * &self.i * 9.0).to_scaled() / (q.square() * 432.0),
        }
    }

    /// P' at a root known beyond a double: next to a double root it is a difference.
    pub fn slope(&self, u: Scaled) -> Scaled {
        let near = u.value();
        let [_, slope, bend] = self.values(near);
        (slope + bend * (u - Scaled::from(near))) / Scaled::from(6.0)
    }

    /// 6 P, 6 P' and 6 P'' at a double: the first from a sum without rounding, and the others too where terms cancel.
    pub fn values(&self, u: f64) -> [Scaled; 3] {
        let x = Dyadic::from(u) - &self.u0;
        // P = v^2 + 2 f x - sigma x^2 - 2 rho x^3/3 - q x^4/2, times 6.
        let value = &self.speed2 * 6.0
            + &x * (&self.force * 12.0
                - &x * (&self.sigma * 6.0 + &x * (&self.rho * 4.0 + &x * &self.q * 3.0)));
        let at = x.to_scaled();
        let [force, sigma, rho, q] = [&self.force, &self.sigma, &self.rho, &self.q].map(|x| x.to_scaled());
        // Their terms over 12.
        let (second, third) = (rho * at, q * at.square());
        let slopes = [force, -(sigma * at), -(second * at), -(third * at)];
        let bends = [-sigma, -second.shift(1), -(third * 3.0)];
        let (slope, bend) = match (kept(&slopes), kept(&bends)) {
            (Some(slope), Some(bend)) => (slope * 12.0, bend * 12.0),
            _ => {
                let slope = &self.force * 12.0
                    - &x * (&self.sigma * 12.0 + &x * (&self.rho * 12.0 + &x * &self.q * 12.0));
                let bend = -(&self.sigma * 12.0 + &x * (&self.rho * 24.0 + &x * &self.q * 36.0));
                (slope.to_scaled(), bend.to_scaled())
            }
        };
        [value.to_scaled(), slope, bend]
    }
}

/// A sum of which a millionth of the terms is left.
fn kept(terms: &[Scaled]) -> Option<Scaled> {
    let sum = terms.iter().fold(Scaled::ZERO, |sum, term| sum + *term);
    let size = terms.iter().fold(Scaled::ZERO, |sum, term| sum + term.abs());
    (sum.abs() - size.shift(-20)).is_positive().then_some(sum)
}

impl Quartic {
    /// The double root where there is one only, or the triple one, from exact numbers.
    pub fn double_root(&self) -> Scaled {
        let [q, rho, sigma, force] = [&self.q, &self.rho, &self.sigma, &self.force];
        let mixed = q * force * 9.0 + rho * sigma;
        let (above, below) = if self.i.sign() == 0 {
            (-mixed, &self.n * 2.0)
        } else {
            (&self.i * mixed - &self.j * rho, &self.j * q * 3.0 - &self.i * &self.n * 2.0)
        };
        if below.sign() == 0 {
            // All four roots are one.
            return (&self.u0 * q * 3.0 - rho).to_scaled() / (q * 3.0).to_scaled();
        }
        (&self.u0 * &below + above).to_scaled() / below.to_scaled()
    }
}

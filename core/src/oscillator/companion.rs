//! Pendulum and Duffing oscillator are one motion: theta = 2 arctan(u/scale).
//!
//! With m = sin^2(theta0/2) + velocity0^2/4 omega0^2, u = tan(theta/2) obeys u'' + p u + q u^3 = 0 with
//!   p = omega0^2 (1 - 2m),  q = 2 omega0^2 (1 - m),  u0 = tan(theta0/2),  u'0 = velocity0/2 cos^2(theta0/2).
//! So libration is a hardening spring, the separatrix the linear one (q = 0, p < 0: sinh), and rotation escapes
//! whenever the pendulum is at the top: there, at theta = pi mod 2 pi, u is infinite, and one motion of u is one turn.
//! Backwards, u = scale tan(theta/2) with q scale^2 = p + S or p - S and omega0^2 = S or -S, where that is positive.
//! Source: Salas 2019 (5), (8), (11); (10) with its dots put right, docs/errata.

use super::duffing::Duffing;
use crate::domain::Domain;
use crate::float::angle_reduction;
use crate::float::dyadic::sum_of_products;
use crate::float::elementary::arctangent;
use crate::float::scaled::Scaled;
use crate::float::series;
use crate::pendulum::Frequency;

/// The pendulum that moves like a Duffing oscillator: u = scale tan(theta/2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Companion {
    /// What u is measured in.
    pub scale: f64,
    /// Angle at t = 0, in (-pi, pi).
    pub theta0: f64,
    /// Angular velocity at t = 0.
    pub velocity0: f64,
    /// Square of omega0, negative where the pendulum hangs from the other side.
    pub omega2: f64,
}

impl Duffing {
    /// The oscillator of u = tan(theta/2) for a pendulum; each of its four numbers rounded once, so that a regime a
    /// rounding error from the separatrix may become its neighbour.
    ///
    /// | argument | domain |
    /// |---|---|
    /// | `theta0` | finite; u is infinite at odd multiples of pi, which no double is |
    /// | `velocity0` | finite, and so are p and q: up to about 1e154 |
    /// | `frequency` | any |
    ///
    /// **Source** Salas 2019 (5), (8).
    ///
    /// # Errors
    /// A [`Domain`] that names what is not finite.
    ///
    /// ```
    /// use libration::{Duffing, Frequency};
    /// let spring = Duffing::of_pendulum(1.0, 0.0, Frequency::from_omega0(1.0)?)?;
    /// assert_eq!(format!("{:.9} {:.9}", spring.p(), spring.q()), "0.540302306 1.540302306");
    /// # Ok::<(), libration::Domain>(())
    /// ```
    pub fn of_pendulum(theta0: f64, velocity0: f64, frequency: Frequency) -> Result<Duffing, Domain> {
        Domain::check("theta0", theta0, theta0.is_finite(), "finite")?;
        Domain::check("velocity0", velocity0, velocity0.is_finite(), "finite")?;
        let reduced = angle_reduction::reduce(theta0);
        let (sine, cosine) =
            series::quarter_turn(reduced.from_bottom.scale(0.5), reduced.from_top.scale(0.5));
        let [sine, cosine] = [sine, cosine].map(|value| Scaled::from(value.to_dd()));
        let (a, b, c) = frequency.factors();
        let square = Scaled::from(a) * Scaled::from(b) / Scaled::from(c);
        let speed = Scaled::from(velocity0).square().shift(-2);
        // omega0^2 m = omega0^2 s^2 + v^2/4 and omega0^2 (1 - m) = omega0^2 c^2 - v^2/4.
        let (rising, falling) = (square * sine.square() + speed, square * cosine.square() - speed);
        let u0 = (sine / cosine).value() * reduced.side;
        let velocity = (Scaled::from(velocity0).shift(-1) / cosine.square()).value();
        let (p, q) = ((falling - rising).value(), falling.shift(1).value());
        Domain::check("omega0^2 (1 - 2 m)", p, p.is_finite(), "finite")?;
        Domain::check("2 omega0^2 (1 - m)", q, q.is_finite(), "finite")?;
        Duffing::new(u0, velocity, p, q)
    }

    /// The pendulum whose theta is 2 arctan(u/scale), each of its four numbers rounded once.
    ///
    /// `None` where there is none: at E = 0, in wells, in librations of a softening spring, outside of its barrier with
    /// E >= 0, for Delta <= 0, without a cubic force, and where one of its numbers is beyond the range of doubles.
    #[must_use]
    pub fn companion(&self) -> Option<Companion> {
        let [u0, v0, p, q] = [self.u0(), self.velocity0(), self.p(), self.q()];
        // 4 E, and Delta = p^2 + 4 q E = S^2.
        let energy = sum_of_products(&[&[2.0, v0, v0], &[2.0, p, u0, u0], &[q, u0, u0, u0, u0]]);
        let delta =
            sum_of_products(&[&[p, p], &[2.0, p, q, u0, u0], &[q, q, u0, u0, u0, u0], &[2.0, q, v0, v0]]);
        if q == 0.0 || !delta.is_positive() || energy.is_zero() {
            return None;
        }
        let s = delta.sqrt();
        let (p, q) = (Scaled::from(p), Scaled::from(q));
        // (S + p)(S - p) = 4 q E gives the one that would cancel.
        let (plus, minus) =
            if p.is_negative() { (q * energy / (s - p), s - p) } else { (s + p, q * energy / (s + p)) };
        let (square, omega2) = if (plus / q).is_positive() { (plus / q, s) } else { (-minus / q, -s) };
        if !square.is_positive() {
            return None;
        }
        let scale = square.sqrt();
        let u = Scaled::from(u0) / scale;
        let opposite = u.abs();
        // The angle of a point of two sides, the larger of them 1.
        let (opposite, adjacent) = if (opposite - Scaled::ONE).is_positive() {
            (Scaled::ONE, Scaled::ONE / opposite)
        } else {
            (opposite, Scaled::ONE)
        };
        let angle = arctangent(opposite.to_dd(), adjacent.to_dd()).value();
        let theta0 = if u.is_negative() { -2.0 * angle } else { 2.0 * angle };
        let velocity0 = (Scaled::from(v0) / scale).shift(1) / (Scaled::ONE + u.square());
        let (scale, velocity0, omega2) = (scale.value(), velocity0.value(), omega2.value());
        let in_range = scale > 0.0 && [scale, velocity0, omega2].iter().all(|value| value.is_finite());
        in_range.then_some(Companion { scale, theta0, velocity0, omega2 })
    }
}

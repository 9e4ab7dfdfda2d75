//! A cubic-quintic oscillator by its energy, or by its action and phase: starts.rs with a force of odd powers.

use super::cubic_quintic::CubicQuintic;
use super::starts::{about_given, equilibria_of, velocity_of_action};
use crate::domain::{Domain, shown};
use crate::float::dyadic::Dyadic;
use crate::float::scaled::Scaled;
use crate::float::{Dd, TWO_PI};

/// Off by more than this share, the action of a state is mended by its velocity.
const MENDED: f64 = 4e-14;

/// Turns by which a state that is mended may miss its phase.
const PHASE_KEPT: f64 = 1e-9;

/// The sign of -(p u + q u^3 + s u^5), exactly.
fn force_sign([p, q, s]: [f64; 3], u: f64) -> i32 {
    let x = Dyadic::from(u);
    let y = x.square();
    -(x * (Dyadic::from(p) + &y * (Dyadic::from(q) + &y * s))).sign()
}

/// The stable equilibria, rising.
pub(super) fn stable_equilibria(force: [f64; 3]) -> Vec<f64> {
    // The force turns where p + 3 q y + 5 s y^2 is 0, y = u^2.
    let [p, q, s] = force.map(Scaled::from);
    let (b, c) = (q * 3.0, s * 5.0);
    let discriminant = b.square() - (p * c).shift(2);
    let mut places = Vec::new();
    if c.is_zero() {
        places.push(-p / b);
    } else if discriminant.is_positive() {
        let large = -(b + discriminant.sqrt().signed(b.sign())).shift(-1);
        places.extend([large / c, p / large]);
    }
    let mut turns = Vec::new();
    for y in places.into_iter().filter(|y| y.is_positive() && y.is_finite()) {
        let u = y.sqrt().value();
        turns.extend([u, -u]);
    }
    equilibria_of(turns, &|u| force_sign(force, u))
}

impl CubicQuintic {
    /// The oscillator at u0 with this energy (u'^2/2 + p u^2/2 + q u^4/4 + s u^6/6) that moves upwards, or downwards.
    ///
    /// | argument | domain |
    /// |---|---|
    /// | `energy` | finite, at least the potential at u0 |
    /// | `u0`, `[p, q, s]` | finite |
    /// | `direction` | 1 or -1 |
    ///
    /// **Error** at most 1 ulp of the velocity.
    ///
    /// # Errors
    /// A [`Domain`] that names the argument.
    ///
    /// ```
    /// let spring = libration::CubicQuintic::from_energy(0.75, 0.0, 1.0, [1.0, 1.0, 0.0])?;
    /// assert_eq!(format!("{:.9} {:.9}", spring.velocity0(), spring.range().1), "1.224744871 1.000000000");
    /// # Ok::<(), libration::Domain>(())
    /// ```
    pub fn from_energy(
        energy: f64,
        u0: f64,
        direction: f64,
        [p, q, s]: [f64; 3],
    ) -> Result<CubicQuintic, Domain> {
        Domain::check("energy", energy, energy.is_finite(), "finite")?;
        Domain::check("direction", direction, direction.abs() == 1.0, "1 or -1")?;
        let rest = CubicQuintic::new(u0, 0.0, p, q, s)?;
        let six = Dyadic::from(energy) * 12.0 - &rest.energy.a;
        if six.sign() < 0 {
            let allowed = format!("at least the potential at u0, {}", shown(rest.energy()));
            return Err(Domain::new("energy", shown(energy), allowed));
        }
        let velocity = (six.to_scaled() / Scaled::from(6.0)).sqrt().value();
        CubicQuintic::new(u0, direction * velocity, p, q, s)
    }

    /// The oscillator with this action and, at t = 0, this phase: the inverse of [`CubicQuintic::action`] and
    /// [`CubicQuintic::phase`].
    ///
    /// | argument | domain |
    /// |---|---|
    /// | `action` | not negative; that of a motion about the equilibrium, or about all of them |
    /// | `phase` | finite, in rad |
    /// | `about` | next to the stable equilibrium that is meant; not needed where there is one only |
    /// | `[p, q, s]` | finite, with a stable equilibrium |
    ///
    /// **Error** the action comes back within 1e-13; of a swing far smaller than u itself, at its ends, within what rounding u makes of
    /// it. **Source** Newton's method with dJ/dE = 1/frequency.
    ///
    /// # Errors
    /// A [`Domain`] that names the argument.
    ///
    /// ```
    /// let spring = libration::CubicQuintic::from_action_phase(0.5, 0.0, None, [1.0, 1.0, 1.0])?;
    /// assert_eq!(format!("{:.9} {:.9}", spring.action(), spring.velocity0().abs()), "0.500000000 0.000000000");
    /// # Ok::<(), libration::Domain>(())
    /// ```
    pub fn from_action_phase(
        action: f64,
        phase: f64,
        about: Option<f64>,
        [p, q, s]: [f64; 3],
    ) -> Result<CubicQuintic, Domain> {
        Domain::check("action", action, action.is_finite() && action >= 0.0, "finite and not negative")?;
        Domain::check("phase", phase, phase.is_finite(), "finite")?;
        for (name, value) in [("p", p), ("q", q), ("s", s)] {
            Domain::check(name, value, value.is_finite(), "finite")?;
        }
        let force = [p, q, s];
        let equilibrium = about_given(about, &stable_equilibria(force), "p, q, s", &force)?;
        let rest = CubicQuintic::new(equilibrium, 0.0, p, q, s)?;
        if action == 0.0 {
            return Ok(rest);
        }
        let at = |velocity: f64| {
            CubicQuintic::new(equilibrium, velocity, p, q, s).unwrap_or_else(|_| rest.clone())
        };
        // As for small swings.
        let guess =
            (Scaled::from(action).shift(1) * rest.energy.stiffness(equilibrium).abs().sqrt()).sqrt().value();
        let known = |orbit: &CubicQuintic| [orbit.action(), orbit.frequency()];
        let (velocity, orbit) = velocity_of_action(action, guess, &at, &known, equilibrium)?;
        let Some((turns, _)) = orbit.phase_turns() else {
            return CubicQuintic::new(equilibrium, velocity, p, q, s);
        };
        // To that phase on the shortest way.
        let away = Dd::from(phase) / TWO_PI - turns.start;
        let away = away - Dd::from(away.hi.round());
        let (u, velocity) = orbit.motion((Scaled::from(away) * orbit.long_period()).value());
        let made = CubicQuintic::new(u, velocity, p, q, s)?;
        if (made.action() / action - 1.0).abs() <= MENDED {
            return Ok(made);
        }
        let mended = orbit.with_its_energy(u, velocity, equilibrium)?;
        // Next to a turning point what rounds u is far more of the phase than of the action: doubles do not hold both.
        let off = mended.phase_turns().map_or(0.0, |(turns, _)| (Dd::from(phase) / TWO_PI - turns.start).hi);
        Ok(if (off - off.round()).abs() < PHASE_KEPT { mended } else { made })
    }

    /// The state next to u on this orbit: where u is rounded, the velocity keeps the energy.
    fn with_its_energy(&self, u: f64, velocity: f64, equilibrium: f64) -> Result<CubicQuintic, Domain> {
        let mut place = u;
        for _ in 0..8 {
            let six = self.energy.square_speed(&Dyadic::from(place).square());
            if six.sign() >= 0 {
                let speed = (six.to_scaled() / Scaled::from(6.0)).sqrt().value();
                return CubicQuintic::new(place, speed.copysign(velocity), self.p(), self.q(), self.s());
            }
            place = if place > equilibrium { place.next_down() } else { place.next_up() };
        }
        CubicQuintic::new(u, velocity, self.p(), self.q(), self.s())
    }
}

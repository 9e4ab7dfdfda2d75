//! A Duffing oscillator by its energy, or by its action and phase.
//!
//! Back from an action by Newton's steps in the velocity at the equilibrium, dJ/dv = v/frequency, within an interval that the
//! monotone J(v) halves; it jumps where a separatrix is passed, and the actions of the jump have no motion.

use super::duffing::Duffing;
use super::even_powers::EvenPowers;
use crate::domain::{Domain, shown};
use crate::float::TWO_PI;
use crate::float::dyadic::Dyadic;

/// Most steps to the velocity.
const STEPS: usize = 200;

/// A double among all in order.
fn ordered(x: f64) -> i64 {
    let bits = x.to_bits() as i64;
    if bits < 0 { i64::MIN.wrapping_sub(bits) } else { bits }
}

fn double(place: i64) -> f64 {
    let bits = if place < 0 { i64::MIN.wrapping_sub(place) } else { place };
    f64::from_bits(bits as u64)
}

/// The sign of c - p u - r u^2 - q u^3, exactly.
fn force_sign([p, q, r, c]: [f64; 4], u: f64) -> i32 {
    let x = Dyadic::from(u);
    (Dyadic::from(c) - &x * (Dyadic::from(p) + &x * (Dyadic::from(r) + &x * q))).sign()
}

/// The stable equilibria of c - p u - r u^2 - q u^3, rising.
pub(super) fn stable_equilibria(force: [f64; 4]) -> Vec<f64> {
    let [p, q, r, _] = force;
    // Where the stiffness p + 2 r u + 3 q u^2 is 0 the force turns.
    let mut turns = Vec::new();
    if q == 0.0 {
        if r != 0.0 {
            turns.push(-0.5 * p / r);
        }
    } else {
        let root = (r * r - 3.0 * p * q).sqrt();
        if root > 0.0 {
            let large = -(r + root.copysign(r));
            turns.push(large / (3.0 * q));
            if large != 0.0 {
                turns.push(p / large);
            }
        }
    }
    equilibria_of(turns, &|u| force_sign(force, u))
}

/// Where a force falls through 0, to the last place or next to it, from where it turns and its exact sign.
pub(super) fn equilibria_of(mut turns: Vec<f64>, sign: &dyn Fn(f64) -> i32) -> Vec<f64> {
    turns.retain(|u| u.is_finite());
    turns.push(f64::MAX);
    turns.sort_by(f64::total_cmp);
    let mut found = Vec::new();
    let mut from = -f64::MAX;
    for to in turns {
        if sign(from) >= 0 && sign(to) <= 0 {
            let (mut low, mut high) = (ordered(from), ordered(to));
            while high.saturating_sub(low) > 1 {
                let middle = (low >> 1) + (high >> 1) + (low & high & 1);
                match sign(double(middle)) {
                    0 => (low, high) = (middle, middle),
                    1 => low = middle,
                    _ => high = middle,
                }
            }
            let at = double(low);
            if at.abs() < f64::MAX {
                found.push(if at == 0.0 { 0.0 } else { at });
            }
        }
        from = to;
    }
    found.dedup();
    found
}

/// The velocity at an equilibrium and the motion whose action is this one, from a guess; `known` has action and frequency.
pub(super) fn velocity_of_action<Motion>(
    action: f64,
    guess: f64,
    at: &dyn Fn(f64) -> Motion,
    known: &dyn Fn(&Motion) -> [f64; 2],
    equilibrium: f64,
) -> Result<(f64, Motion), Domain> {
    let (mut low, mut high) = (0.0, f64::INFINITY);
    let mut velocity = if guess > 0.0 && guess.is_finite() { guess } else { 1.0 };
    let mut orbit = at(velocity);
    for _ in 0..STEPS {
        let [found, frequency] = known(&orbit);
        // Beyond every separatrix a motion has no action.
        if found < action {
            low = velocity
        } else {
            high = velocity
        }
        let next = velocity + (action - found) * frequency / velocity;
        if (next - velocity).abs() <= 1e-16 * velocity || found == action {
            break;
        }
        let inside = next > low && next < high;
        let next = match (inside, high.is_finite()) {
            (true, _) => next,
            (_, true) => 0.5 * (low + high),
            _ => 2.0 * velocity,
        };
        if next == velocity || next == low || next == high {
            break;
        }
        velocity = next;
        orbit = at(velocity);
    }
    let [found, _] = known(&orbit);
    let missed = found.is_nan() || (found - action).abs() > 1e-10 * action;
    if missed {
        let of = |velocity: f64| if velocity.is_finite() { known(&at(velocity))[0] } else { f64::NAN };
        let [below, above] = [low, high].map(|velocity| shown(of(velocity)));
        let allowed = format!(
            "that of a motion about the equilibrium {}: none between {below} and {above}",
            shown(equilibrium)
        );
        return Err(Domain::new("action", shown(action), allowed));
    }
    Ok((velocity, orbit))
}

impl Duffing {
    /// The oscillator at u0 with this energy (u'^2/2 + p u^2/2 + r u^3/3 + q u^4/4 - c u) that moves upwards, or downwards.
    ///
    /// | argument | domain |
    /// |---|---|
    /// | `energy` | finite, at least the potential at u0 |
    /// | `u0`, `[p, q, r, c]` | finite |
    /// | `direction` | 1 or -1 |
    ///
    /// **Error** at most 1 ulp of the velocity.
    ///
    /// # Errors
    /// A [`Domain`] that names the argument.
    ///
    /// ```
    /// let spring = libration::Duffing::from_energy(0.75, 0.0, 1.0, [1.0, 1.0, 0.0, 0.0])?;
    /// assert_eq!(format!("{:.9} {:.9}", spring.velocity0(), spring.range().1), "1.224744871 1.000000000");
    /// # Ok::<(), libration::Domain>(())
    /// ```
    pub fn from_energy(energy: f64, u0: f64, direction: f64, force: [f64; 4]) -> Result<Duffing, Domain> {
        Domain::check("energy", energy, energy.is_finite(), "finite")?;
        Domain::check("direction", direction, direction.abs() == 1.0, "1 or -1")?;
        let rest = Duffing::with_even_powers(u0, 0.0, force)?;
        let [p, q, r, c] = force.map(Dyadic::from);
        let u = Dyadic::from(u0);
        // 6 v^2 = 12 E - 6 p u^2 - 4 r u^3 - 3 q u^4 + 12 c u.
        let six =
            Dyadic::from(energy) * 12.0 - &u * (&u * (p * 6.0 + &u * (r * 4.0 + &u * q * 3.0)) - c * 12.0);
        if six.sign() < 0 {
            let allowed = format!("at least the potential at u0, {}", shown(rest.energy()));
            return Err(Domain::new("energy", shown(energy), allowed));
        }
        let velocity = (six.to_scaled() / crate::float::Scaled::from(6.0)).sqrt().value();
        Duffing::with_even_powers(u0, direction * velocity, force)
    }

    /// The oscillator with this action and, at t = 0, this phase: the inverse of [`Duffing::action`] and [`Duffing::phase`].
    ///
    /// | argument | domain |
    /// |---|---|
    /// | `action` | not negative; that of a motion about the equilibrium, or about all of them |
    /// | `phase` | finite, in rad |
    /// | `about` | next to the stable equilibrium that is meant; not needed where there is one only |
    /// | `[p, q, r, c]` | finite, with a stable equilibrium |
    ///
    /// **Error** the action comes back within 1e-13. **Source** Newton's method with dJ/dE = 1/frequency.
    ///
    /// # Errors
    /// A [`Domain`] that names the argument.
    ///
    /// ```
    /// let spring = libration::Duffing::from_action_phase(0.5, 0.0, None, [1.0, 1.0, 0.0, 0.0])?;
    /// assert_eq!(format!("{:.9} {:.9}", spring.action(), spring.velocity0().abs()), "0.500000000 0.000000000");
    /// # Ok::<(), libration::Domain>(())
    /// ```
    pub fn from_action_phase(
        action: f64,
        phase: f64,
        about: Option<f64>,
        force: [f64; 4],
    ) -> Result<Duffing, Domain> {
        Domain::check("action", action, action.is_finite() && action >= 0.0, "finite and not negative")?;
        Domain::check("phase", phase, phase.is_finite(), "finite")?;
        let equilibrium = equilibrium(about, force)?;
        let at = |velocity: f64| EvenPowers::new(equilibrium, velocity, force);
        if action == 0.0 {
            return Duffing::with_even_powers(equilibrium, 0.0, force);
        }
        // As for small swings.
        let stiffness = at(0.0).quartic.sigma.to_scaled();
        let guess = (crate::float::Scaled::from(action).shift(1) * stiffness.abs().sqrt()).sqrt().value();
        let known = |orbit: &EvenPowers| [orbit.action().value(), orbit.frequency().value()];
        let (velocity, orbit) = velocity_of_action(action, guess, &at, &known, equilibrium)?;
        let Some(turns) = orbit.phase_turns() else {
            return Duffing::with_even_powers(equilibrium, velocity, force);
        };
        // To that phase on the shortest way.
        let away = crate::float::Dd::from(phase) / TWO_PI - turns.start;
        let away = away - crate::float::Dd::from(away.hi.round());
        let (u, velocity) = orbit.careful_motion((crate::float::Scaled::from(away) * orbit.period).value());
        Duffing::with_even_powers(u, velocity, force)
    }
}

/// The stable equilibrium next to a place, or the only one.
fn equilibrium(about: Option<f64>, force: [f64; 4]) -> Result<f64, Domain> {
    for (name, value) in [("p", force[0]), ("q", force[1]), ("r", force[2]), ("c", force[3])] {
        Domain::check(name, value, value.is_finite(), "finite")?;
    }
    about_given(about, &stable_equilibria(force), "p, q, r, c", &force)
}

/// The one of all stable equilibria next to a place, or the only one.
pub(super) fn about_given(
    about: Option<f64>,
    all: &[f64],
    names: &'static str,
    force: &[f64],
) -> Result<f64, Domain> {
    let places = all.iter().map(|u| shown(*u)).collect::<Vec<_>>().join(" or ");
    match (all, about) {
        ([], _) => {
            let force = force.iter().map(|x| shown(*x)).collect::<Vec<_>>().join(", ");
            Err(Domain::new(names, force, "of a force with a stable equilibrium"))
        }
        ([only], None) => Ok(*only),
        (_, None) => Err(Domain::new("about", "None".to_string(), format!("given: next to {places}"))),
        (_, Some(about)) => {
            Domain::check("about", about, about.is_finite(), "finite")?;
            let nearest = all.iter().copied().min_by(|a, b| (a - about).abs().total_cmp(&(b - about).abs()));
            Ok(nearest.unwrap_or(about))
        }
    }
}

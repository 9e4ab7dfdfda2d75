//! What friction makes of a swing in the mean, to first order in friction.
//!
//! A libration with the turning angle a and the action J loses in each period, per unit inertia,
//!   4 pi gamma J (linear),  8 beta omega2 (sin a - a cos a) (quadratic),  4 mu (a - delta tanh(a/delta)) (dry, with presliding),
//! the integral of friction over the angle along the undamped orbit. Linear friction alone leaves J(t) = J(0) e^(-2 gamma t): the
//! action decays exponentially, not the angle. What is left out is of second order in friction over omega0, and grows next to the
//! separatrix. Source: Landau & Lifshitz, Mechanics, section 49; Squire, Am. J. Phys. 54 (1986) 984.

use super::circular::circular;
use super::friction::Friction;
use crate::float::{Dd, PI, Scaled};
use crate::pendulum::{Frequency, Orbit};

/// The libration with this turning angle, in (0, pi) for a force that pulls down.
pub(super) fn libration(theta_max: f64, frequency: Frequency) -> Option<Orbit> {
    let inside = theta_max > 0.0 && theta_max < core::f64::consts::PI;
    let pulls = inside && frequency.root().is_some() && !frequency.upside_down();
    if pulls { Orbit::new(theta_max, 0.0, frequency).ok() } else { None }
}

/// Energy per unit inertia, in rad^2/s^2, that friction takes from a libration in a period, in the mean: 0 at rest.
///
/// | argument | domain |
/// |---|---|
/// | `theta_max` | turning angle in rad, in [0, pi) |
/// | `frequency` | omega0^2 > 0 |
///
/// NaN out of the domain. **Error** 1e-15 of the result, as a formula of first order.
///
/// ```
/// use libration::{Frequency, Friction, damped::averaged_energy_loss};
/// let loss = averaged_energy_loss(1.0, Frequency::from_omega0(1.0)?, Friction::new(0.0, 0.0, 0.01, 0.0)?);
/// assert_eq!(loss, 0.04);
/// # Ok::<(), libration::Domain>(())
/// ```
#[must_use]
pub fn averaged_energy_loss(theta_max: f64, frequency: Frequency, friction: Friction) -> f64 {
    let Some(orbit) = libration(theta_max, frequency) else {
        return if theta_max == 0.0 { 0.0 } else { f64::NAN };
    };
    let a = Dd::from(theta_max);
    let (sine, cosine) = circular(a);
    let linear = PI.scale(4.0) * friction.linear() * orbit.action();
    // For small angles sin a - a cos a is a^3/3 of terms of the size of a: the rest is 2^-100 of a.
    let quadratic = (sine - a * cosine) * orbit.omega2() * friction.quadratic();
    let dry = a - presliding_angle(a, friction.presliding());
    (linear + quadratic.scale(8.0) + (dry * friction.dry()).scale(4.0)).value()
}

/// delta tanh(a/delta).
fn presliding_angle(a: Dd, delta: f64) -> Dd {
    if delta == 0.0 {
        return Dd::ZERO;
    }
    let falling = Scaled::exp((a / Dd::from(delta)).scale(-2.0)).to_dd();
    (Dd::ONE - falling) / (Dd::ONE + falling) * delta
}

/// How fast the turning angle changes in the mean, in rad/s; domain and order as for [`averaged_energy_loss`].
///
/// d theta_max/dt = -(energy lost in a period)/(T omega0^2 sin theta_max). NaN also at rest, where a dry pendulum stops.
///
/// ```
/// use libration::{Frequency, Friction, damped::averaged_turning_rate};
/// let rate = averaged_turning_rate(1e-4, Frequency::from_omega0(1.0)?, Friction::new(0.01, 0.0, 0.0, 0.0)?);
/// assert_eq!(format!("{:.6}", rate / 1e-4), "-0.010000");
/// # Ok::<(), libration::Domain>(())
/// ```
#[must_use]
pub fn averaged_turning_rate(theta_max: f64, frequency: Frequency, friction: Friction) -> f64 {
    let Some(orbit) = libration(theta_max, frequency) else { return f64::NAN };
    let (sine, _) = circular(Dd::from(theta_max));
    -averaged_energy_loss(theta_max, frequency, friction) / (orbit.period() * orbit.omega2() * sine.value())
}

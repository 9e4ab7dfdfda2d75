//! The turning angle under friction a time later, in the mean: the solution of d theta_max/dt = averaged_turning_rate(theta_max).
//!
//! Linear friction alone has a closed form. Otherwise, with tan(theta_max/2) = tan(a/2) e^-s, time is the integral of
//! -sin(theta_max)/rate over s, whose integrand is analytic for |Im s| < pi/2, next to the separatrix too: Gauss's rule of 16 nodes
//! over 2 units of s leaves out 2^-56 of it. The time is then solved for s. Source: averaged.rs; for the change of variable, d
//! theta_max/ds = -sin theta_max.

use super::averaged::{averaged_turning_rate, libration};
use super::circular::circular;
use super::friction::Friction;
use crate::domain::Domain;
use crate::float::elementary::arctangent;
use crate::float::{Dd, Scaled};
use crate::pendulum::action::state_of;
use crate::pendulum::{Frequency, Orbit};

/// Gauss's rule on [-1, 1]: nodes above 0 and their weights.
const RULE: [(f64, f64); 8] = [
    (0.095012509837637440185, 0.18945061045506849629),
    (0.28160355077925891323, 0.18260341504492358887),
    (0.45801677765722738634, 0.16915651939500253819),
    (0.61787624440264374845, 0.14959598881657673208),
    (0.7554044083550030339, 0.12462897125553387205),
    (0.86563120238783174388, 0.09515851168249278481),
    (0.94457502307323257608, 0.062253523938647892863),
    (0.9894009349916499326, 0.027152459411754094852),
];
/// The part of s over which a rule serves.
const PART: f64 = 2.0;
/// Below this turning angle, in rad, the answer is 0.
const LEAST: f64 = 1e-100;
/// What is less than this part of a time does not change it.
const NEGLIGIBLE: f64 = 1.0 / (1u64 << 60) as f64;

/// The turning angle in rad a time t (in s) after it was `theta_max`, in the mean.
///
/// | argument | domain |
/// |---|---|
/// | `theta_max` | turning angle in rad, in [0, pi) |
/// | `t` | finite; before 0 too |
/// | `frequency` | omega0^2 > 0 |
/// | `friction` | no term below 0, or the linear one alone, of any sign |
///
/// Under linear friction alone it is that of the action J(0) e^(-2 gamma t). 0 where dry friction has stopped the pendulum, and below
/// 1e-100 rad; NaN out of the domain, and where the angle would be beyond pi. **Error** 16 ulp, plus 2^-52 of t times the
/// rate there, as a formula of first order.
///
/// ```
/// use libration::{Frequency, Friction, damped::averaged_turning_angle};
/// let friction = Friction::new(0.01, 0.0, 0.0, 0.0)?;
/// let angle = averaged_turning_angle(1.0, 50.0, Frequency::from_omega0(1.0)?, friction);
/// assert_eq!(format!("{angle:.6}"), "0.596202");
/// # Ok::<(), libration::Domain>(())
/// ```
#[must_use]
pub fn averaged_turning_angle(theta_max: f64, t: f64, frequency: Frequency, friction: Friction) -> f64 {
    let orbit = match libration(theta_max, frequency) {
        Some(orbit) if t.is_finite() => orbit,
        None if theta_max == 0.0 && t.is_finite() => return 0.0,
        _ => return f64::NAN,
    };
    if friction.quadratic() == 0.0 && friction.dry() == 0.0 {
        return under_linear(&orbit, t, frequency, friction.linear()).unwrap_or(f64::NAN);
    }
    // Where one term drives and another takes there may be a limit cycle, which is approached for ever.
    if friction.linear() < 0.0 || friction.quadratic() < 0.0 {
        return f64::NAN;
    }
    if t == 0.0 {
        return theta_max;
    }
    Decay::new(theta_max, frequency, friction).after(t)
}

fn under_linear(orbit: &Orbit, t: f64, frequency: Frequency, linear: f64) -> Result<f64, Domain> {
    let decay = Scaled::exp(Dd::product(linear, t).scale(-2.0));
    let action = (decay * Scaled::from(orbit.action())).value();
    Ok(state_of(action, core::f64::consts::FRAC_PI_2, 0.0, frequency)?.0)
}

/// The decay from one turning angle.
struct Decay {
    /// tan(a/2)
    tangent: Dd,
    frequency: Frequency,
    friction: Friction,
}

impl Decay {
    fn new(theta_max: f64, frequency: Frequency, friction: Friction) -> Decay {
        let (sine, cosine) = circular(Dd::from(theta_max).scale(0.5));
        Decay { tangent: sine / cosine, frequency, friction }
    }

    /// The turning angle at s.
    fn angle(&self, s: f64) -> f64 {
        let tangent = Scaled::exp(Dd::from(-s)).to_dd() * self.tangent;
        arctangent(tangent, Dd::ONE).scale(2.0).value()
    }

    /// dt/ds; NaN where the angle is pi to a double.
    fn slowness(&self, s: f64) -> f64 {
        let angle = self.angle(s);
        let (sine, _) = circular(Dd::from(angle));
        -sine.value() / averaged_turning_rate(angle, self.frequency, self.friction)
    }

    /// The time from one s to another.
    fn time(&self, from: f64, to: f64) -> f64 {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let pair = |node: f64| self.slowness(middle + half * node) + self.slowness(middle - half * node);
        half * RULE.iter().map(|(node, weight)| weight * pair(*node)).sum::<f64>()
    }

    /// The turning angle a time later.
    fn after(&self, t: f64) -> f64 {
        let sense = t.signum();
        let stops = self.friction.dry() > 0.0 && self.friction.presliding() == 0.0;
        let (mut s, mut left) = (0.0, t.abs());
        loop {
            let spent = self.time(s, s + sense * PART).abs();
            if spent.is_nan() {
                return f64::NAN;
            }
            if spent == f64::INFINITY {
                // Friction among the least doubles.
                return self.angle(s);
            }
            if spent >= left {
                return self.angle(s + sense * self.part(s, sense, left, spent));
            }
            s += sense * PART;
            left -= spent;
            let angle = self.angle(s);
            // Dry friction alone counts at last: what is left of the time falls by e^-2 from part to part.
            if sense > 0.0 && (angle < LEAST || stops && angle < 1.0 && spent < NEGLIGIBLE * left) {
                return 0.0;
            }
        }
    }

    /// How much further than s the time that is left goes; it is less than a part takes.
    fn part(&self, s: f64, sense: f64, left: f64, spent: f64) -> f64 {
        let (mut low, mut high) = (0.0, PART);
        let mut x = PART * (left / spent);
        // Newton's method, by halving where it leaves the bounds.
        for _ in 0..60 {
            let over = self.time(s, s + sense * x).abs() - left;
            if over > 0.0 {
                high = x
            } else {
                low = x
            }
            let step = x - over / self.slowness(s + sense * x);
            let next = if low < step && step < high { step } else { 0.5 * (low + high) };
            let moved = (next - x).abs();
            x = next;
            if moved <= f64::EPSILON {
                break;
            }
        }
        x
    }
}

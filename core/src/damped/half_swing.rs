//! From one turn to the next under quadratic and dry friction, without an integration.
//!
//! While theta rises from a turn at -a, w = theta'^2 obeys dw/dtheta = -2 (beta w + mu + omega2 sin theta), which is linear:
//!   w = 2 omega2 (cos theta - 2 beta sin theta - e^(-2 beta s) (cos a + 2 beta sin a))/(1 + 4 beta^2) - mu (1 - e^(-2 beta s))/beta,
//! s = theta + a; the next turn is the zero of w. Source: Mungan & Lipscombe, Eur. J. Phys. 34 (2013) 1243.

use super::circular::circular;
use super::friction::Friction;
use crate::float::{Dd, Scaled};
use crate::pendulum::Frequency;

/// The angle of the next turn after one at `theta`, in rad.
///
/// | argument | domain |
/// |---|---|
/// | `theta` | the angle of a turn, in (-pi, pi) |
/// | `frequency` | omega0^2 > 0 |
/// | `friction` | quadratic and dry terms, neither negative; no linear one, no presliding |
///
/// NaN out of the domain. Where dry friction holds the pendulum at the turn, theta itself. **Error** at most 2 ulp of theta.
/// Source: Mungan & Lipscombe 2013, with dry friction added to their equation (it stays linear).
///
/// ```
/// use libration::{Frequency, Friction, half_swing};
/// let friction = Friction::new(0.0, 0.1, 0.02, 0.0)?;
/// let next = half_swing(-2.0, Frequency::from_omega0(3.0)?, friction);
/// assert_eq!(format!("{next:.9}"), "1.482418337");
/// # Ok::<(), libration::Domain>(())
/// ```
#[must_use]
pub fn half_swing(theta: f64, frequency: Frequency, friction: Friction) -> f64 {
    let served = theta.abs() < core::f64::consts::PI
        && friction.linear() == 0.0
        && friction.quadratic() >= 0.0
        && (friction.presliding() == 0.0 || friction.dry() == 0.0)
        && !frequency.upside_down();
    let Some((root, power)) = frequency.root().filter(|_| served) else { return f64::NAN };
    // In units of omega2: dry friction over it.
    let square = root.square().to_dd();
    let dry = Dd::from(crate::float::exponent::ldexp(friction.dry(), -2 * power)) / square;
    let swing = Swing::new(theta.abs(), friction.quadratic(), dry);
    if (swing.sine - dry).hi <= 0.0 {
        return theta;
    }
    -swing.end().value() * theta.signum()
}

/// The rise from a turn at -a.
struct Swing {
    a: Dd,
    beta: Dd,
    dry: Dd,
    sine: Dd,
    cosine: Dd,
}

impl Swing {
    fn new(a: f64, beta: f64, dry: Dd) -> Swing {
        let (sine, cosine) = circular(Dd::from(a));
        Swing { a: Dd::from(a), beta: Dd::from(beta), dry, sine, cosine }
    }

    /// (1 + 4 beta^2) w/2 omega2 at theta, and its derivative.
    fn square_and_slope(&self, theta: Dd) -> (Dd, Dd) {
        let Swing { a, beta, dry, .. } = *self;
        let twice = beta.scale(2.0);
        let (sine, cosine) = circular(theta);
        // (1 - e^-x)/x of x = 2 beta s, times s: what dry friction takes.
        let s = theta + a;
        let taken = s * mean_of_exponential(twice * s);
        let left = Dd::ONE - twice * taken;
        let stretch = Dd::ONE + twice.square();
        let square =
            (cosine - twice * sine) - left * (self.cosine + twice * self.sine) - stretch * dry * taken;
        (square, -(twice * square) - stretch * (dry + sine))
    }

    /// The next turn.
    fn end(&self) -> Dd {
        // One zero in (-a, a]: there the pull is against the motion wherever w is not positive.
        let (mut low, mut high) = (-self.a.hi, self.a.hi);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if self.square_and_slope(Dd::from(middle)).0.hi > 0.0 { low = middle } else { high = middle }
        }
        let mut end = Dd::from(0.5 * (low + high));
        // From a double's precision two steps of Newton's method reach that of a double-double.
        for _ in 0..2 {
            let (square, slope) = self.square_and_slope(end);
            if slope.hi < 0.0 {
                end = end - square / slope;
            }
        }
        end
    }
}

/// (1 - e^-x)/x, 1 at x = 0.
fn mean_of_exponential(x: Dd) -> Dd {
    if x.hi.abs() < 0.01 {
        // Taylor's series: 0.01^14/15! is 2^-133.
        let mut sum = Dd::ONE;
        for n in (2..=15).rev() {
            sum = Dd::ONE - x * sum / Dd::from(f64::from(n));
        }
        return sum;
    }
    (Dd::ONE - Scaled::exp(-x).to_dd()) / x
}

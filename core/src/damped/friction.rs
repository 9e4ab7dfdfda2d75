//! The friction of a pendulum per unit inertia: linear, quadratic and dry, the last with or without presliding after Dahl.
//!
//! Source: Squire, Am. J. Phys. 54 (1986) 984; Dahl, AIAA J. 14 (1976) 1675 with the exponent 1.

use crate::domain::Domain;

const FINITE: &str = "finite";
const NOT_NEGATIVE: &str = "finite and not negative";
/// The powers of 1/presliding in a Taylor series must stay in the range of the doubles.
const LEAST_PRESLIDING: f64 = 1e-10;

/// The friction terms 2 gamma theta' + beta |theta'| theta' + mu z of an equation of motion.
///
/// Without presliding z = sgn theta'. With it z is the state of Dahl's law, z' = (theta' - |theta'| z)/delta: after a turn the
/// friction changes sign over an angle of about delta, not at once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction {
    linear: f64,
    quadratic: f64,
    dry: f64,
    presliding: f64,
}

impl Friction {
    /// No friction.
    pub const NONE: Friction = Friction { linear: 0.0, quadratic: 0.0, dry: 0.0, presliding: 0.0 };

    /// From its coefficients.
    ///
    /// | argument | symbol | unit | domain |
    /// |---|---|---|---|
    /// | `linear` | gamma | 1/s | finite; below 0 it drives the motion |
    /// | `quadratic` | beta | 1/rad | finite; below 0 it drives the motion |
    /// | `dry` | mu | rad/s^2 | finite, not negative |
    /// | `presliding` | delta | rad | 0, dry friction that changes sign at once; or from 1e-10 on |
    ///
    /// # Errors
    /// For a coefficient out of its domain.
    ///
    /// ```
    /// use libration::Friction;
    /// assert_eq!(Friction::new(0.01, 0.0, 0.002, 0.0)?.linear(), 0.01);
    /// # Ok::<(), libration::Domain>(())
    /// ```
    pub fn new(linear: f64, quadratic: f64, dry: f64, presliding: f64) -> Result<Friction, Domain> {
        Domain::check("linear", linear, linear.is_finite(), FINITE)?;
        Domain::check("quadratic", quadratic, quadratic.is_finite(), FINITE)?;
        Domain::check("dry", dry, dry.is_finite() && dry >= 0.0, NOT_NEGATIVE)?;
        let served = presliding == 0.0 || (presliding.is_finite() && presliding >= LEAST_PRESLIDING);
        Domain::check("presliding", presliding, served, "0, or finite and at least 1e-10")?;
        Ok(Friction { linear, quadratic, dry, presliding })
    }
    /// gamma in 1/s, of the term 2 gamma theta'.
    #[must_use]
    pub fn linear(&self) -> f64 {
        self.linear
    }
    /// beta in 1/rad, of the term beta |theta'| theta'.
    #[must_use]
    pub fn quadratic(&self) -> f64 {
        self.quadratic
    }
    /// mu in rad/s^2, of the term mu sgn theta'.
    #[must_use]
    pub fn dry(&self) -> f64 {
        self.dry
    }
    /// delta in rad, the angle over which dry friction changes sign after a turn.
    #[must_use]
    pub fn presliding(&self) -> f64 {
        self.presliding
    }
    /// Whether no term acts.
    pub(super) fn is_none(&self) -> bool {
        self.linear == 0.0 && self.quadratic == 0.0 && self.dry == 0.0
    }
}

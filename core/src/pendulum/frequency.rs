//! The force: omega0^2 = a b / c, three doubles taken exactly, whether it was given as omega0, as its square
//! or as gravity and length.

use crate::domain::{Domain, shown};
use crate::float::exponent::{exponent, ldexp, mantissa};
use crate::float::{Dd, Td};

/// Standard gravity in m/s^2, taken where a length comes without gravity.
pub const STANDARD_GRAVITY: f64 = 9.80665;

const FINITE: &str = "finite";
const NOT_NEGATIVE: &str = "finite and not negative";
const POSITIVE: &str = "finite and positive";

/// omega0^2 = a b / c. Comparable bit by bit, so that a set-up can be kept while it repeats.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frequency {
    a: f64,
    b: f64,
    c: f64,
}

impl Frequency {
    /// From the arguments of a constructor: none (omega0 = 1), or exactly one of omega0, omega2 and length;
    /// gravity belongs to a length, and is 9.80665 where a length comes alone.
    ///
    /// # Errors
    /// For another combination, and for values that the constructor of the one given refuses.
    pub fn from_arguments(
        omega0: Option<f64>,
        omega2: Option<f64>,
        length: Option<f64>,
        gravity: Option<f64>,
    ) -> Result<Frequency, Domain> {
        let given: Vec<String> = [("omega0", omega0), ("omega2", omega2), ("length", length)]
            .iter()
            .filter_map(|(name, value)| value.map(|value| format!("{name} = {}", shown(value))))
            .collect();
        if given.len() > 1 {
            let allowed = "given as one of omega0, omega2 and length";
            return Err(Domain::new("frequency", given.join(", "), allowed));
        }
        match (omega0, omega2, length, gravity) {
            (_, _, None, Some(gravity)) => Err(Domain::new("gravity", shown(gravity), "given with a length")),
            (Some(omega0), ..) => Frequency::from_omega0(omega0),
            (_, Some(omega2), ..) => Frequency::from_omega2(omega2),
            (_, _, Some(length), gravity) => {
                Frequency::from_gravity_length(gravity.unwrap_or(STANDARD_GRAVITY), length)
            }
            _ => Frequency::from_omega0(1.0),
        }
    }

    /// From the small-swing angular frequency omega0 >= 0, in rad/s; 0 is free rotation.
    ///
    /// # Errors
    /// Where omega0 is negative or not finite.
    pub fn from_omega0(omega0: f64) -> Result<Frequency, Domain> {
        let omega0 = Domain::check("omega0", omega0, omega0.is_finite() && omega0 >= 0.0, NOT_NEGATIVE)?;
        Ok(Frequency { a: omega0, b: omega0, c: 1.0 })
    }

    /// From its square, in rad^2/s^2; negative hangs the pendulum from the other side.
    ///
    /// # Errors
    /// Where omega2 is not finite.
    pub fn from_omega2(omega2: f64) -> Result<Frequency, Domain> {
        Domain::check("omega2", omega2, omega2.is_finite(), FINITE)?;
        Ok(Frequency { a: omega2, b: 1.0, c: 1.0 })
    }

    /// From gravity in m/s^2 (any sign) and length in m: omega0^2 = g/L, rounded nowhere.
    ///
    /// # Errors
    /// Where the length is not positive, or one of both is not finite.
    ///
    /// ```
    /// use libration::{Frequency, Orbit};
    /// let orbit = Orbit::new(0.0, 0.0, Frequency::from_gravity_length(9.8, 2.0)?)?;
    /// assert_eq!(orbit.omega2(), 4.9);
    /// # Ok::<(), libration::Domain>(())
    /// ```
    pub fn from_gravity_length(gravity: f64, length: f64) -> Result<Frequency, Domain> {
        Domain::check("length", length, length.is_finite() && length > 0.0, POSITIVE)?;
        Domain::check("gravity", gravity, gravity.is_finite(), FINITE)?;
        Ok(Frequency { a: gravity, b: 1.0, c: length })
    }

    /// Angular frequency of small swings, sqrt|omega0^2|, in rad/s, rounded once.
    #[must_use]
    pub fn omega0(&self) -> f64 {
        self.root().map_or(0.0, |(root, power)| ldexp(root.to_dd().value(), power))
    }

    /// omega0^2, rounded once; negative where the pendulum hangs from the other side.
    #[must_use]
    pub fn omega2(&self) -> f64 {
        let square = self.root().map_or(0.0, |(root, power)| ldexp(root.square().to_dd().value(), 2 * power));
        if self.upside_down() { -square } else { square }
    }

    /// The three exact factors (a, b, c) of omega0^2 = a b / c.
    #[must_use]
    pub fn factors(&self) -> (f64, f64, f64) {
        (self.a, self.b, self.c)
    }

    /// From the factors, as [`Frequency::factors`] gives them.
    ///
    /// # Errors
    /// Where a factor is not finite, the second is negative, or the third is not positive.
    pub fn from_factors(a: f64, b: f64, c: f64) -> Result<Frequency, Domain> {
        Domain::check("omega2", a, a.is_finite(), FINITE)?;
        Domain::check("omega0", b, b.is_finite() && b >= 0.0, NOT_NEGATIVE)?;
        Domain::check("length", c, c.is_finite() && c > 0.0, POSITIVE)?;
        Ok(Frequency { a, b, c })
    }

    /// |omega0| as root * 2^power with root in [0.7, 2.9], or `None` without force.
    pub(crate) fn root(&self) -> Option<(Td, i32)> {
        if self.a == 0.0 || self.b == 0.0 {
            return None;
        }
        let [a, b, c] = [self.a, self.b, self.c].map(mantissa);
        let power = exponent(self.a) + exponent(self.b) - exponent(self.c);
        let odd = power.rem_euclid(2);
        let square = Td::product(a, b) / Td::from(c);
        Some((square.scale(if odd == 1 { 2.0 } else { 1.0 }).sqrt(), (power - odd) / 2))
    }

    /// omega0 > 0 as a double-double, where it is in range and pulls downward.
    pub(crate) fn downward_root(&self) -> Option<Dd> {
        if self.a == self.b && self.c == 1.0 {
            return Some(Dd::from(self.a));
        }
        let (root, power) = self.root().filter(|_| !self.upside_down())?;
        (power.abs() < 400).then(|| root.to_dd().ldexp(power))
    }

    /// Whether the stable equilibrium is the upper one.
    pub(crate) fn upside_down(&self) -> bool {
        self.a < 0.0 && self.b != 0.0
    }
}

//! Kinetic and potential energy of any state in the force of an orbit, and the speed on the separatrix.
//!
//! Per unit inertia and zero at rest at the stable equilibrium: theta'^2/2 and 2 omega0^2 sin^2(d/2), with d the distance
//! from it, in triple-double, so that nothing cancels at either equilibrium. Source: Lima 2019 (4), divided by the inertia.

use super::half_angle::half_angle;
use super::orbit::Orbit;
use crate::elliptic::amplitude::short_sine;
use crate::float::Td;
use crate::float::angle_reduction;
use crate::float::exponent::ldexp;

impl Orbit {
    /// Potential energy per unit inertia at an angle in rad, omega0^2 (1 - cos theta) about the stable equilibrium.
    ///
    /// NaN for angles that are not finite. **Error** at most 1 ulp.
    ///
    /// ```
    /// use libration::{Frequency, Orbit};
    /// let orbit = Orbit::new(2.0, 0.0, Frequency::from_omega0(1.0)?)?;
    /// assert_eq!(format!("{:.9} {:.9}", orbit.potential_energy(2.0), orbit.energy()), "1.416146837 1.416146837");
    /// # Ok::<(), libration::Domain>(())
    /// ```
    #[must_use]
    pub fn potential_energy(&self, theta: f64) -> f64 {
        if let Some((root, power)) = self.force.root()
            && !self.force.upside_down()
        {
            // Where the square is an ordinary number, a sine with a correction in double is enough.
            let sine = short_sine(0.5 * theta);
            if sine.hi.abs() > 1e-100 {
                return ldexp((root.to_dd() * sine).square().value(), 2 * power + 1);
            }
        }
        self.of_half_distance(theta, |omega, [sine, _]| (omega * sine).square(), 2)
    }

    /// Kinetic energy per unit inertia, velocity^2/2.
    #[must_use]
    pub fn kinetic_energy(&self, velocity: f64) -> f64 {
        0.5 * velocity * velocity
    }

    /// Speed on the separatrix at an angle in rad, 2 omega0 cos(d/2) with d the distance from the stable equilibrium.
    ///
    /// NaN for angles that are not finite. **Error** at most 1 ulp. Source: Landau & Lifshitz, Mechanics, section 11.
    ///
    /// ```
    /// use libration::{Frequency, Orbit};
    /// let orbit = Orbit::new(2.0, 0.0, Frequency::from_omega0(1.5)?)?;
    /// assert_eq!(format!("{:.9}", orbit.separatrix_velocity(2.0)), "1.620906918");
    /// # Ok::<(), libration::Domain>(())
    /// ```
    #[must_use]
    pub fn separatrix_velocity(&self, theta: f64) -> f64 {
        self.of_half_distance(theta, |omega, [_, cosine]| omega * cosine, 1)
    }

    /// Twice a product of `degree` factors omega0, and sine or cosine of half the distance from the stable equilibrium.
    fn of_half_distance(&self, theta: f64, product: impl Fn(Td, [Td; 2]) -> Td, degree: i32) -> f64 {
        if !theta.is_finite() {
            return f64::NAN;
        }
        let Some((root, power)) = self.force.root() else { return 0.0 };
        let reduced = angle_reduction::reduce(theta);
        let (sine, cosine, sine_power) = half_angle(&reduced, self.force.upside_down(), i32::MIN / 2);
        // A power is taken out of a tiny sine only, where the cosine is 1.
        let own = if degree == 2 { power + sine_power.max(-5000) } else { power };
        ldexp(product(root, [sine, cosine]).to_dd().value(), degree * own + 1)
    }
}

#[cfg(test)]
mod tests {
    use crate::{Frequency, Orbit, Regime};

    fn orbit(theta0: f64, velocity0: f64, omega2: f64) -> Orbit {
        Orbit::new(theta0, velocity0, Frequency::from_omega2(omega2).unwrap()).unwrap()
    }

    #[test]
    fn both_energies_of_a_motion_add_up() {
        for (theta0, velocity0, omega2) in [
            (3.0, 0.0, 9.8),
            (0.1, 7.0, 2.0),
            (1e-8, 0.0, 1.0),
            (2.0, 0.3, -4.0),
            (179.999f64.to_radians(), 0.0, 1.0),
        ] {
            let orbit = orbit(theta0, velocity0, omega2);
            for i in 0..1000 {
                let (theta, velocity) = orbit.motion(10.0 * orbit.period() * f64::from(i));
                let sum = orbit.kinetic_energy(velocity) + orbit.potential_energy(theta);
                assert!((sum / orbit.energy() - 1.0).abs() < 1e-12, "{theta0} {i} {sum}");
            }
        }
    }

    #[test]
    fn tiny_angles_and_the_top_keep_their_digits() {
        let orbit = orbit(1.0, 0.0, 1.0);
        assert_eq!(orbit.potential_energy(1e-150), 5e-301);
        assert_eq!(orbit.potential_energy(0.0), 0.0);
        assert_eq!(orbit.potential_energy(core::f64::consts::PI), 2.0);
        // pi less its double.
        assert!(
            (orbit.separatrix_velocity(core::f64::consts::PI) / 1.224_646_799_147_353_2e-16 - 1.0).abs()
                < 1e-15
        );
        assert!(orbit.potential_energy(f64::INFINITY).is_nan());
        let free = Orbit::new(1.0, 1.0, Frequency::from_omega0(0.0).unwrap()).unwrap();
        assert_eq!((free.potential_energy(1.0), free.separatrix_velocity(1.0)), (0.0, 0.0));
    }

    #[test]
    fn the_speed_is_that_of_the_separatrix() {
        for omega2 in [2.25, -2.25] {
            let base = if omega2 < 0.0 { core::f64::consts::PI } else { 0.0 };
            let of_speed = orbit(base + 0.7, orbit(0.0, 0.0, omega2).separatrix_velocity(base + 0.7), omega2);
            assert!((of_speed.energy_ratio() - 1.0).abs() < 1e-15);
        }
        let separatrix = orbit(0.0, 3.0, 2.25);
        assert_eq!(separatrix.regime(), Regime::Separatrix);
        for t in [-2.0, 0.0, 0.5, 3.0] {
            let (theta, velocity) = separatrix.motion(t);
            assert!((separatrix.separatrix_velocity(theta) / velocity - 1.0).abs() < 1e-13, "{t}");
        }
    }
}

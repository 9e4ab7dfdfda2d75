//! What an ideal pendulum's period leaves out: relative changes of the period by the bob's size, the wire and the air.
//!
//! Each is (T with the effect)/(T without) - 1, exact in its model, NaN out of its domain. Source: Nelson & Olsson, Am. J. Phys. 54
//! (1986) 112, whose formulas of first order these contain; derived anew from I and S (parts.rs).

fn changed(ratio_of_squares: f64) -> f64 {
    // sqrt(1 + x) - 1 without cancellation.
    let x = ratio_of_squares;
    if x > -1.0 { x / ((1.0 + x).sqrt() + 1.0) } else { f64::NAN }
}

/// Of a ball of this radius (in m) whose centre hangs at the length (in m): I = m (L^2 + 2/5 r^2). About r^2/(5 L^2).
///
/// ```
/// assert_eq!(format!("{:.3e}", libration::compound::bob_size(0.0125, 1.0)), "3.125e-5");
/// ```
#[must_use]
pub fn bob_size(radius: f64, length: f64) -> f64 {
    changed(0.4 * (radius / length) * (radius / length))
}

/// Of a wire or thread from the pivot to the centre of a point-like bob, by their masses (in kg): L -> L (1 + x/3)/(1 + x/2), where x
/// is wire over bob. About -x/12.
#[must_use]
pub fn wire_mass(wire: f64, bob: f64) -> f64 {
    let x = wire / bob;
    changed(-(x / 6.0) / (1.0 + 0.5 * x))
}

/// Of the buoyancy of the bob, by the densities of the medium and the bob (in kg/m^3): the weight is less by their ratio.
#[must_use]
pub fn buoyancy(medium: f64, bob: f64) -> f64 {
    let x = medium / bob;
    if x < 1.0 { changed(x / (1.0 - x)) } else { f64::NAN }
}

/// Of the medium that a ball takes along, kappa of its own volume: kappa = 1/2 + (9/4) delta/r with the depth of the boundary layer
/// delta = sqrt(2 nu/omega), nu the kinematic viscosity (in m^2/s). Source: Stokes, Trans. Camb. Phil. Soc. 9 (1851) 8.
#[must_use]
pub fn added_mass(radius: f64, medium: f64, bob: f64, viscosity: f64, omega: f64) -> f64 {
    let layer = (2.0 * viscosity / omega).sqrt();
    changed((0.5 + 2.25 * layer / radius) * medium / bob)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_steel_ball_on_a_thread_has_the_known_corrections() {
        // 25 mm steel ball on 1 m: 3.1e-5, 7.7e-5, 8.1e-5.
        let (air, steel) = (1.2, 7800.0);
        assert!((bob_size(0.0125, 1.0) - 3.1e-5).abs() < 1e-6);
        assert!((buoyancy(air, steel) - 7.7e-5).abs() < 1e-6);
        assert!((added_mass(0.0125, air, steel, 1.5e-5, 3.13) - 8.1e-5).abs() < 3e-6);
        assert!((wire_mass(0.003, 1.0) + 2.5e-4).abs() < 1e-6);
        assert!(buoyancy(2.0, 1.0).is_nan());
    }
}

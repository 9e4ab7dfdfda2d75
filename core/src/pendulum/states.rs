//! Motion of rows with states of their own: (t, theta0, velocity0, omega0) each, on the widest lanes.
//!
//! By the flow of flow.rs; next to the separatrix and out of its range by an [`Orbit`] of the row, kept while the state
//! repeats. NaN where an argument is out of the domain of [`Orbit`]; panics where the lengths differ.
//! **Error** at most 8 ulp of the largest angle and velocity of the orbit.

use super::batch::fill;
use super::frequency::Frequency;
use super::orbit::Orbit;

/// Angle and velocity of every row.
///
/// ```
/// let (mut theta, mut velocity) = ([0.0; 2], [0.0; 2]);
/// let rows = [&[2.0, 2.0], &[1.0, 3.0], &[0.0, 0.0], &[1.0, 1.0]].map(|column| column.as_slice());
/// libration::pendulum::states::motion_into(rows, [&mut theta, &mut velocity]);
/// assert_eq!(format!("{:.9} {:.9}", theta[0], velocity[1]), "-0.306200958 -0.502884034");
/// ```
pub fn motion_into([t, theta0, velocity0, omega0]: [&[f64]; 4], results: [&mut [f64]; 2]) {
    let mut kept: Option<([u64; 3], Option<Orbit>)> = None;
    fill([theta0, velocity0, t, omega0], results, |[theta, velocity, t, omega0]| {
        let key = [theta, velocity, omega0].map(f64::to_bits);
        if kept.as_ref().is_none_or(|(last, _)| *last != key) {
            let frequency = Frequency::from_omega0(omega0).ok();
            kept = Some((key, frequency.and_then(|frequency| Orbit::new(theta, velocity, frequency).ok())));
        }
        let orbit = kept.as_ref().and_then(|(_, orbit)| orbit.as_ref());
        orbit.map_or((f64::NAN, f64::NAN), |orbit| orbit.motion(t))
    });
}

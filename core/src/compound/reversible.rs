//! Kater's reversible pendulum, as Bessel evaluates it.

/// g in m/s^2 from the periods (in s) about two pivots on either side of the centre of mass and their distances from it (in m):
/// 8 pi^2/g = (T1^2 + T2^2)/(d1 + d2) + (T1^2 - T2^2)/(d1 - d2).
///
/// With equal periods the second term is 0, whatever the distances are; with equal distances and unequal periods there is no g (not
/// finite). Source: F. W. Bessel, Untersuchungen ueber die Laenge des einfachen Secundenpendels (1828).
///
/// ```
/// // A uniform rod of 1 m, about its end and about the point a third of the length from the other.
/// let period = |length: f64| core::f64::consts::TAU * (length / 9.81f64).sqrt();
/// let g = libration::compound::reversible_gravity(period(2.0 / 3.0), period(2.0 / 3.0), 0.5, 1.0 / 6.0);
/// assert_eq!(format!("{g:.10}"), "9.8100000000");
/// ```
#[must_use]
pub fn reversible_gravity(period1: f64, period2: f64, distance1: f64, distance2: f64) -> f64 {
    let (sum, difference) = (distance1 + distance2, distance1 - distance2);
    let (squares, rest) = (period1 * period1 + period2 * period2, (period1 - period2) * (period1 + period2));
    let asymmetric = if rest == 0.0 { 0.0 } else { rest / difference };
    let pi = core::f64::consts::PI;
    8.0 * pi * pi / (squares / sum + asymmetric)
}

//! g from one period by the exact law of the pendulum, and the normal g of a place beside it.
//!
//! g = length (omega0)^2 with omega0 = P(swing)/T, where P is the exact period at omega0 = 1. Uncertainties of the three are
//! combined after GUM 5.1; that of the swing by the exact law itself, half the difference between the swing's two ends.
//! The normal g of WGS 84 is Somigliana's formula with the height's second order.
//! Source: NIMA TR 8350.2 (2000), equations 4-1 and 4-3.

use crate::fit::{BudgetRow, Estimate, FitRefusal, Measure};
use core::f64::consts::PI;
use libration::{Frequency, Orbit};
use serde::Serialize;

/// g from a period.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PeriodGravity {
    /// In m/s^2.
    pub g: Estimate,
    /// What each measured quantity makes of it, in m/s^2.
    pub budget: Vec<BudgetRow>,
    /// The formula of small swings, 4 pi^2 length / T^2, in m/s^2.
    pub small_swings: f64,
}

fn checked(name: &str, unit: &str, measure: Measure, low: f64, high: f64) -> Result<(), FitRefusal> {
    let Measure { value, u } = measure;
    if !(value.is_finite() && value > low && value < high) {
        let most = if high.is_finite() { format!(" and less than {high:.6}") } else { String::new() };
        return Err(FitRefusal::new(format!("{name} = {value} {unit}: must be greater than {low:.0}{most}")));
    }
    if !(u.is_finite() && u >= 0.0) {
        return Err(FitRefusal::new(format!(
            "uncertainty of {name} = {u} {unit}: must be finite and not negative"
        )));
    }
    Ok(())
}

/// The exact period at omega0 = 1.
fn unit_period(swing: f64) -> f64 {
    let orbit = Frequency::from_omega0(1.0).and_then(|frequency| Orbit::new(swing, 0.0, frequency));
    orbit.map_or(f64::NAN, |orbit| orbit.period())
}

/// g from the period of a swing of known size.
///
/// `period` in s, `length` in m (the equivalent length), `swing` the turning angle in rad, from 0 to below pi.
///
/// # Errors
/// Where one of them is out of its range.
///
/// ```
/// use libration_fit::{fit::Measure, gravity_of_period};
/// let measure = |value, u| Measure { value, u };
/// let found = gravity_of_period(measure(2.0218, 0.001), measure(1.0, 0.001), measure(0.34907, 0.01))?;
/// assert!((found.g.value - 9.8065).abs() < 0.001, "{found:?}");
/// # Ok::<(), libration_fit::fit::FitRefusal>(())
/// ```
pub fn gravity_of_period(
    period: Measure,
    length: Measure,
    swing: Measure,
) -> Result<PeriodGravity, FitRefusal> {
    checked("period", "s", period, 0.0, f64::INFINITY)?;
    checked("length", "m", length, 0.0, f64::INFINITY)?;
    if swing.value != 0.0 {
        checked("swing", "rad", Measure { value: swing.value.abs(), u: swing.u }, 0.0, PI)?;
    }
    let of = |swing: f64| {
        let omega0 = unit_period(swing) / period.value;
        length.value * omega0 * omega0
    };
    let size = swing.value.abs();
    let g = of(size);
    // At the bottom the other end of the swing is the same one; at the top there is none.
    let ends = (of((size + swing.u).min(PI * (1.0 - 1e-9))), of((size - swing.u).max(0.0)));
    let by_swing = 0.5 * (ends.0 - ends.1).abs();
    let parts = [
        ("period", 2.0 * g * period.u / period.value),
        ("length", g * length.u / length.value),
        ("swing", by_swing),
    ];
    let calibration = parts.iter().map(|(_, u)| u * u).sum::<f64>().sqrt();
    Ok(PeriodGravity {
        g: Estimate::new(g, 0.0, 0.0, calibration),
        budget: parts.iter().map(|(source, u)| BudgetRow { source: (*source).to_owned(), u: *u }).collect(),
        small_swings: of(0.0),
    })
}

/// Semi-major axis in m, flattening, and the ratio of centrifugal force to gravity at the equator.
const AXIS: f64 = 6_378_137.0;
const FLATTENING: f64 = 1.0 / 298.257_223_563;
const RATIO: f64 = 0.003_449_786_506_84;
/// Gravity at the equator in m/s^2, Somigliana's constant, the square of the first eccentricity.
const EQUATOR: f64 = 9.780_325_335_9;
const SOMIGLIANA: f64 = 0.001_931_852_652_41;
const ECCENTRICITY2: f64 = 0.006_694_379_990_13;

/// The normal g of WGS 84 in m/s^2 at a latitude in rad and a height above the ellipsoid in m.
///
/// Local masses move the true g by some 0.0005 m/s^2, seldom by more than 0.002.
///
/// # Errors
/// Beyond the poles, and below -12 km or above 100 km.
///
/// ```
/// let g = libration_fit::normal_gravity(45f64.to_radians(), 0.0)?;
/// assert!((g - 9.806_197_8).abs() < 1e-7);
/// # Ok::<(), libration_fit::fit::FitRefusal>(())
/// ```
pub fn normal_gravity(latitude: f64, height: f64) -> Result<f64, FitRefusal> {
    if !(-0.5 * PI..=0.5 * PI).contains(&latitude) {
        return Err(FitRefusal::new(format!(
            "latitude = {latitude} rad: must be from -pi/2 to pi/2, -90deg to 90deg"
        )));
    }
    if !(-12e3..=100e3).contains(&height) {
        return Err(FitRefusal::new(format!("height = {height} m: must be from -12000 to 100000")));
    }
    let sine = libm::sin(latitude);
    let square = sine * sine;
    let ground = EQUATOR * (1.0 + SOMIGLIANA * square) / (1.0 - ECCENTRICITY2 * square).sqrt();
    let up = height / AXIS;
    Ok(ground * (1.0 - 2.0 * (1.0 + FLATTENING + RATIO - 2.0 * FLATTENING * square) * up + 3.0 * up * up))
}

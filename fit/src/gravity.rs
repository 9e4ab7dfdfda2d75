//! g from one period by the exact law of the pendulum, and the normal g of a place beside it.
//!
//! g = length (omega0)^2 with omega0 = P(swing)/T, where P is the exact period at omega0 = 1. Uncertainties of the three are
//! combined after GUM 5.1; that of the swing by the exact law itself, half the difference between the swing's two ends.
//! Where the swing decays while periods are counted, 1/P is the mean over that time, in which linear friction brings the first turning
//! angle to the last (core/src/damped/averaged_decay.rs: the action falls exponentially).
//! The normal g of WGS 84 is Somigliana's formula with the height's second order.
//! Source: NIMA TR 8350.2 (2000), equations 4-1 and 4-3.

use crate::digits::Shown;
use crate::fit::{BudgetRow, Estimate, FitRefusal, Measure};
use core::f64::consts::PI;
use libration::damped::averaged_turning_angle;
use libration::{Frequency, Friction, Orbit};
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
        let most =
            if high.is_finite() { format!(" and less than {:.6}", Shown(high)) } else { String::new() };
        return Err(FitRefusal::new(format!(
            "{name} = {} {unit}: must be greater than {:.0}{most}",
            Shown(value),
            Shown(low)
        )));
    }
    if !(u.is_finite() && u >= 0.0) {
        return Err(FitRefusal::new(format!(
            "uncertainty of {name} = {} {unit}: must be finite and not negative",
            Shown(u)
        )));
    }
    Ok(())
}

fn unit_orbit(swing: f64) -> Option<Orbit> {
    Frequency::from_omega0(1.0).and_then(|frequency| Orbit::new(swing, 0.0, frequency)).ok()
}

/// The exact period at omega0 = 1.
fn unit_period(swing: f64) -> f64 {
    unit_orbit(swing).map_or(f64::NAN, |orbit| orbit.period())
}

/// Intervals of Simpson's rule over the decay: its error is below 1e-9 for a first angle up to 175 degrees and a last one from 0.1.
const INTERVALS: u32 = 128;

/// The mean period at omega0 = 1, over the time in which linear friction brings the swing from the first angle to the last.
fn unit_period_of_decay(first: f64, last: f64) -> f64 {
    let (high, low) = (first.max(last), first.min(last));
    let actions = unit_orbit(high).zip(unit_orbit(low)).map(|(high, low)| high.action() / low.action());
    let (Ok(one), Ok(friction)) = (Frequency::from_omega0(1.0), Friction::new(1.0, 0.0, 0.0, 0.0)) else {
        return f64::NAN;
    };
    // The action falls by exp(-2 t) at a friction of 1.
    let end = 0.5 * actions.map_or(f64::NAN, libm::log);
    if end == 0.0 {
        return unit_period(high);
    }
    let each = (0..=INTERVALS).map(|i| {
        let t = end * f64::from(i) / f64::from(INTERVALS);
        let weight = if i == 0 || i == INTERVALS { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
        weight / unit_period(averaged_turning_angle(high, t, one, friction))
    });
    3.0 * f64::from(INTERVALS) / each.sum::<f64>()
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
    both(period, length)?;
    if swing.value != 0.0 {
        checked("swing", "rad", Measure { value: swing.value.abs(), u: swing.u }, 0.0, PI)?;
    }
    let size = swing.value.abs();
    // At the bottom the other end of the swing is the same one; at the top there is none.
    let ends = [(size + swing.u).min(TOP), (size - swing.u).max(0.0)].map(unit_period);
    Ok(weighed(period, length, unit_period(size), &[ends]))
}

/// g from the mean period of swings that decay, by linear friction, from a first turning angle to a last while they are counted.
///
/// `period` in s: the time over the number of whole swings; `length` in m (the equivalent length), `first` and `last` the turning
/// angles in rad at the begin and at the end of the count, above 0 and below pi.
///
/// # Errors
/// Where one of them is out of its range.
///
/// ```
/// use libration_fit::{fit::Measure, gravity_of_decay};
/// let [first, last] = [40f64, 20.0].map(|swing| Measure { value: swing.to_radians(), u: 0.01 });
/// let found = gravity_of_decay(Measure { value: 2.0396, u: 0.0 }, Measure { value: 1.0, u: 0.0 }, first, last)?;
/// assert!((found.g.value - 9.81).abs() < 0.005, "{found:?}");
/// # Ok::<(), libration_fit::fit::FitRefusal>(())
/// ```
pub fn gravity_of_decay(
    period: Measure,
    length: Measure,
    first: Measure,
    last: Measure,
) -> Result<PeriodGravity, FitRefusal> {
    both(period, length)?;
    checked("swing", "rad", first, 0.0, PI)?;
    checked("swing at the end", "rad", last, 0.0, PI)?;
    let least = |value: f64| value.max(1e-3 * last.value.min(first.value));
    let ends = |Measure { value, u }: Measure| [(value + u).min(TOP), least(value - u)];
    let of_first = ends(first).map(|first| unit_period_of_decay(first, last.value));
    let of_last = ends(last).map(|last| unit_period_of_decay(first.value, last));
    Ok(weighed(period, length, unit_period_of_decay(first.value, last.value), &[of_first, of_last]))
}

/// The largest swing that is a swing.
const TOP: f64 = PI * (1.0 - 1e-9);

fn both(period: Measure, length: Measure) -> Result<(), FitRefusal> {
    checked("period", "s", period, 0.0, f64::INFINITY)?;
    checked("length", "m", length, 0.0, f64::INFINITY)
}

/// g from the period at omega0 = 1, and at the two ends of each angle's uncertainty.
fn weighed(period: Measure, length: Measure, unit: f64, ends: &[[f64; 2]]) -> PeriodGravity {
    let of = |unit: f64| {
        let omega0 = unit / period.value;
        length.value * omega0 * omega0
    };
    let g = of(unit);
    let by_swing = ends.iter().map(|[high, low]| 0.5 * (of(*high) - of(*low)).abs());
    let by_swing = by_swing.map(|u| u * u).sum::<f64>().sqrt();
    let parts = [
        ("period", 2.0 * g * period.u / period.value),
        ("length", g * length.u / length.value),
        ("swing", by_swing),
    ];
    let calibration = parts.iter().map(|(_, u)| u * u).sum::<f64>().sqrt();
    PeriodGravity {
        g: Estimate::new(g, 0.0, 0.0, calibration),
        budget: parts.iter().map(|(source, u)| BudgetRow { source: (*source).to_owned(), u: *u }).collect(),
        small_swings: of(unit_period(0.0)),
    }
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
            "latitude = {} rad: must be from -pi/2 to pi/2, -90deg to 90deg",
            Shown(latitude)
        )));
    }
    if !(-12e3..=100e3).contains(&height) {
        return Err(FitRefusal::new(format!("height = {} m: must be from -12000 to 100000", Shown(height))));
    }
    let sine = libm::sin(latitude);
    let square = sine * sine;
    let ground = EQUATOR * (1.0 + SOMIGLIANA * square) / (1.0 - ECCENTRICITY2 * square).sqrt();
    let up = height / AXIS;
    Ok(ground * (1.0 - 2.0 * (1.0 + FLATTENING + RATIO - 2.0 * FLATTENING * square) * up + 3.0 * up * up))
}

//! kappa^2 and 1 - kappa^2 of a period: Newton's method on the complete integral, in k next to small swings and fast
//! rotations and in ln k' next to the separatrix, where the period is nearly linear in it.
//!
//!   libration  K(m) = omega0 T/4,                 dK/dm = (E - (1 - m) K)/(2 m (1 - m));
//!   rotation   k K(n) = omega0 T/2, n = k^2 = 1/m,  d(k K)/dk = E/(1 - n).
//! Valid up to k' = 1e-290, a period of 2676/omega0 (1338/omega0 a turn). Source: DLMF 22.19(i), 19.4.1.

use super::energy_ratio::EnergyRatio;
use super::frequency::Frequency;
use super::regime::Regime;
use crate::domain::{Domain, shown};
use crate::elliptic::agm::quarter_period;
use crate::elliptic::integrals::complete::{complete_difference_dd, complete_e_dd, complete_k_dd};
use crate::elliptic::parameter::Parameter;
use crate::float::exponent::{exponent, ldexp, mantissa};
use crate::float::{Dd, HALF_PI, Scaled, TWO_PI_LONG, Td};

/// The largest K whose k' the set-up of an orbit distinguishes: ln(4/1e-290).
const LONGEST: f64 = 669.1;
/// 2/pi omega0 T/4 less 1 up to which the parameter is the unknown, and k K up to which the modulus is.
const SHORT: f64 = 0.18;
const FAST: f64 = 1.3;
/// Most steps, never reached: the convergence is quadratic from the starts given.
const STEPS: usize = 60;

/// Of a libration with this period, at least that of small swings; infinite on the separatrix.
pub(super) fn libration(period: f64, frequency: Frequency) -> Result<EnergyRatio, Domain> {
    if period == f64::INFINITY {
        return Ok(EnergyRatio::new(Td::ONE, 0, Td::ZERO));
    }
    let (omega, power) = frequency.root().unwrap_or((Td::ONE, 0));
    let small = ldexp((TWO_PI_LONG / omega).to_dd().value(), -power);
    let allowed = || format!("at least that of small swings, {}, in libration", shown(small));
    if period.is_nan() || period < small {
        return Err(Domain::new("period", shown(period), allowed()));
    }
    // omega0 T/2 pi - 1, what the period of small swings rounds to is theirs.
    let turned = Td::from(mantissa(period)) * omega / TWO_PI_LONG;
    let power = exponent(period) + power;
    checked(period, ldexp(turned.hi * HALF_PI.hi, power))?;
    let turned = Td::new(ldexp(turned.hi, power), ldexp(turned.mid, power), ldexp(turned.lo, power));
    let excess = (turned - Td::ONE).to_dd();
    if excess.hi <= 0.0 {
        return Ok(EnergyRatio::new(Td::ZERO, 0, Td::ONE));
    }
    let quarter = HALF_PI * turned.to_dd();
    if excess.hi < SHORT {
        // 2 K/pi - 1 = m/4 + 9 m^2/64 + ... is convex, and m = 4 excess is beyond the root.
        let m = root(excess.scale(4.0).min(0.7), |m| {
            let mc = Dd::ONE - m;
            let parameter = Parameter::new(m, mc);
            let slope = complete_difference_dd(parameter) / (m * mc).scale(2.0);
            (m, (complete_k_dd(parameter) - quarter) / slope)
        });
        return Ok(EnergyRatio::new(m.into(), 0, (Dd::ONE - m).into()));
    }
    let kc = log_root(quarter, quarter, |kc, mc| {
        let m = Dd::ONE - mc;
        (quarter_period(kc), complete_difference_dd(Parameter::new(m, mc)) / m)
    });
    let mc = kc.square();
    Ok(EnergyRatio::with_root(Regime::Libration, (Dd::ONE - mc).into(), 0, mc.into(), kc))
}

/// Of a rotation with this time of a turn; infinite on the separatrix.
pub(super) fn rotation(period: f64, frequency: Frequency) -> Result<EnergyRatio, Domain> {
    if period == f64::INFINITY {
        return Ok(EnergyRatio::new(Td::ONE, 0, Td::ZERO));
    }
    Domain::check("period", period, period > 0.0, "positive in rotation")?;
    let (omega, power) = frequency.root().unwrap_or((Td::ONE, 0));
    let half = Scaled::new((Td::from(mantissa(period)) * omega).to_dd(), exponent(period) + power - 1);
    checked(period, half.value())?;
    if half.value() < FAST {
        // k K >= pi k/2 is convex: 2/pi of it is beyond the root.
        let start = half / Scaled::from(HALF_PI);
        let k = if start.power() < -120 {
            start
        } else {
            let half = half.to_dd();
            let k = root(start.to_dd(), |k| {
                let n = k.square();
                let parameter = Parameter::new(n, Dd::ONE - n);
                (k, (k * complete_k_dd(parameter) - half) * (Dd::ONE - n) / complete_e_dd(parameter))
            });
            Scaled::from(k)
        };
        let m = (Scaled::ONE / k).square();
        let mc = (Scaled::ONE - m).to_dd();
        let even = m.power() - m.power().rem_euclid(2);
        return Ok(EnergyRatio::new(m.shift(-even).to_dd().into(), even / 2, mc.into()));
    }
    let half = half.to_dd();
    let kc = log_root(half, half, |kc, nc| {
        let n = Dd::ONE - nc;
        let k = n.sqrt();
        (k * quarter_period(kc), complete_e_dd(Parameter::new(n, nc)) / k)
    });
    let nc = kc.square();
    let n = Dd::ONE - nc;
    let m = Dd::ONE / n;
    Ok(EnergyRatio::with_root(Regime::Rotation, m.into(), 0, (-nc / n).into(), kc / n.sqrt()))
}

fn checked(period: f64, quarter: f64) -> Result<f64, Domain> {
    let allowed =
        "infinite or at most 2676/omega0, in rotation 1338/omega0: 1 - kappa^2 is below the doubles beyond";
    Domain::check("period", period, quarter <= LONGEST, allowed)
}

/// Newton's steps for a convex function of x > 0 that increases, from beyond its root: `step` is its value over its slope.
fn root(start: Dd, step: impl Fn(Dd) -> (Dd, Dd)) -> Dd {
    let mut x = start;
    for _ in 0..STEPS {
        let (at, step) = step(x);
        let next = at - step;
        // Below the root the rounding of the integral decides; the start is never left by more than that.
        x = if next.hi > 0.0 { next } else { at.scale(0.5) };
        if step.hi.abs() <= 1e-30 * x.hi {
            break;
        }
    }
    x
}

/// k' with a value that is nearly ln(4/k'), by Newton's steps in ln k'; `at` gives the value and its slope there, negated.
fn log_root(value: Dd, start: Dd, at: impl Fn(Dd, Dd) -> (Dd, Dd)) -> Dd {
    let mut kc = Scaled::exp(-start).to_dd().scale(4.0).min(0.75);
    for _ in 0..STEPS {
        let (found, slope) = at(kc, kc.square());
        let step = (found - value) / slope;
        kc = kc * Scaled::exp(step).to_dd();
        if step.hi.abs() <= 1e-30 {
            break;
        }
    }
    kc
}

impl Dd {
    /// The smaller of this and a double.
    fn min(self, most: f64) -> Dd {
        if self.hi < most { self } else { Dd::from(most) }
    }
}

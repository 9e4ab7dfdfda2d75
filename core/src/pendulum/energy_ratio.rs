//! kappa^2 and 1 - kappa^2 from whatever says the energy, both in triple-double and none from the other by a subtraction
//! that cancels.
//!
//!   energy E          kappa^2 = E/(2 omega0^2), 1 - kappa^2 = (2 omega0^2 - E)/(2 omega0^2), the difference exact;
//!   turning angle     kappa = sin(theta_max/2), sqrt(1 - kappa^2) = cos(theta_max/2), from the angle or from its distance to pi;
//!   period            period_inverse.rs.
//! Source: Landau & Lifshitz, Mechanics, section 11; DLMF 22.19(i).

use super::frequency::Frequency;
use super::half_angle::half_angle;
use super::regime::Regime;
use crate::float::angle_reduction::reduce;
use crate::float::exponent::{exponent, ldexp, mantissa};
use crate::float::triple_double::exact_sum;
use crate::float::{Dd, Td};
use crate::lanes::Lane;

/// The energy of an orbit over that of the top, and its complement.
#[derive(Clone, Copy, Debug)]
pub(super) struct EnergyRatio {
    /// Libration also for an energy of 0.
    pub regime: Regime,
    /// kappa^2 / 4^power, in [1, 4), or 0.
    pub m: Td,
    pub power: i32,
    /// 1 - kappa^2.
    pub mc: Td,
    /// sqrt|1 - kappa^2|, also where its square is below the range.
    pub kc: Dd,
}

impl EnergyRatio {
    /// From kappa^2 = m 4^power and its complement.
    pub fn new(m: Td, power: i32, mc: Td) -> EnergyRatio {
        let regime = match mc.hi {
            rest if rest > 0.0 => Regime::Libration,
            rest if rest < 0.0 => Regime::Rotation,
            _ => Regime::Separatrix,
        };
        EnergyRatio::with_root(regime, m, power, mc, mc.abs().to_dd().sqrt())
    }

    /// The same where the regime and the root of the complement are known.
    pub fn with_root(regime: Regime, m: Td, power: i32, mc: Td, kc: Dd) -> EnergyRatio {
        if m.hi == 0.0 {
            return EnergyRatio { regime, m, power: 0, mc, kc };
        }
        let shift = exponent(m.hi).div_euclid(2);
        let m = Td::new(ldexp(m.hi, -2 * shift), ldexp(m.mid, -2 * shift), ldexp(m.lo, -2 * shift));
        EnergyRatio { regime, m, power: power + shift, mc, kc }
    }

    /// E c/(2 a b) of the factors of the frequency.
    pub fn of_energy(energy: f64, frequency: Frequency) -> EnergyRatio {
        let (a, b, c) = frequency.factors();
        if energy == 0.0 {
            return EnergyRatio::new(Td::ZERO, 0, Td::ONE);
        }
        let power = exponent(energy) + exponent(c) - exponent(a) - exponent(b) - 1;
        let (force, force_error) = mantissa(a).two_product(mantissa(b));
        let (level, level_error) = mantissa(energy).two_product(mantissa(c));
        let force_long = Td::product(mantissa(a), mantissa(b));
        let m = Td::product(mantissa(energy), mantissa(c)) / force_long;
        let odd = power.rem_euclid(2);
        let m_even = m.scale(if odd == 1 { 2.0 } else { 1.0 });
        let mc = if power.abs() < 4 {
            let scale = -ldexp(1.0, power);
            exact_sum([0.0, 0.0, level_error * scale, force_error, level * scale, force]) / force_long
        } else {
            let scale = ldexp(1.0, power);
            Td::ONE - m.scale(scale)
        };
        EnergyRatio::new(m_even, (power - odd) / 2, mc)
    }

    /// Of a turning angle counted from the stable equilibrium or from the other.
    pub fn of_turning_angle(angle: f64, from_top: bool) -> EnergyRatio {
        let (sine, cosine, power) = half_angle(&reduce(angle), from_top, i32::MIN / 2);
        if sine.hi == 0.0 {
            return EnergyRatio::new(Td::ZERO, 0, Td::ONE);
        }
        let regime = if cosine.hi == 0.0 { Regime::Separatrix } else { Regime::Libration };
        EnergyRatio::with_root(regime, sine.square(), power, cosine.square(), cosine.to_dd())
    }

    /// kappa over 2^power.
    pub fn root(&self) -> Td {
        self.m.sqrt()
    }
}

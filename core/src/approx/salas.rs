//! Salas's two polynomials for the sine, once for all that stands on them.
//!
//! Source: Salas 2019 (2), (3) and the ranges that he states for them.

use core::f64::consts::PI;

/// Of phi^3 and phi^5, numerator and denominator.
pub(super) const CUBIC: [f64; 2] = [-40.0, 243.0];
pub(super) const QUINTIC: [f64; 2] = [1.0, 131.0];

/// Where they are offered: 70 and 120 degrees.
pub(super) const DEGREES_70: f64 = 7.0 / 18.0 * PI;
pub(super) const DEGREES_120: f64 = 2.0 / 3.0 * PI;

//! Carlson's symmetric integrals of any real arguments, into the ends of the range: R_F, R_C, R_D, R_J.
//!
//! Over lanes in carlson_lanes.rs; and row by row for every argument:
//!
//! Method: the arguments are numbers without an end of range (Scaled). While they lie many powers of two apart, duplication
//! in these numbers halves their distance in powers; then carlson_duplication.rs takes over. Cauchy's principal values follow
//! from positive arguments by a connection formula.
//! Source: DLMF 19.16, 19.20, 19.26.18 to 19.26.22.

use super::carlson_duplication;
use super::carlson_lanes::{CarlsonRc, CarlsonRd, CarlsonRf, CarlsonRj};
use crate::elliptic::rows::{column, one};
use crate::float::{Dd, Scaled};

/// Powers of two that the arguments of carlson_duplication.rs may lie apart: cubes and their squares stay in range.
const APART: i32 = 110;

/// The largest power of the arguments, made even, and whether the others are near; zeros count as near.
fn window<const N: usize>(arguments: [Scaled; N]) -> (i32, bool) {
    let powers = || arguments.iter().filter(|x| !x.is_zero()).map(|x| x.power());
    let top = powers().max().unwrap_or(0);
    let bottom = powers().min().unwrap_or(0);
    (top & !1, top - bottom < APART)
}

/// Most duplications before the arguments are near. With t the power of the largest and d the distance to the smallest but a
/// zero, sqrt x sqrt y + ... is at least 2^(t - d/2), so that a step leaves a distance of at most d/2 + 2: 31 steps
/// bring any powers of 32 bits below 5.
const STEPS: usize = 32;

/// The same of R_J. A p far above x, y and z comes nearer by one factor of 4 a step, and it is at most 2^2100 above them.
const STEPS_OF_RJ: usize = 1050 + STEPS;

/// Duplicates x, y and z, and with them p, until all are near: what they are then over a power of two, that power, and the
/// power of two of what is left. `step` has the arguments of a step, their roots, the shift and that power. None for a NaN
/// or an infinity, with which the duplication would never end.
fn brought_near<const N: usize>(
    mut at: [Scaled; N],
    steps: usize,
    mut step: impl FnMut(&[Scaled; N], &[Scaled; N], Scaled, i32),
) -> Option<([Dd; N], i32, i32)> {
    if !at.iter().all(|x| x.is_finite()) {
        return None;
    }
    let mut power = 0;
    for _ in 0..steps {
        let (top, near) = window(at);
        if near {
            return Some((at.map(|x| x.shift(-top).to_dd()), top, power));
        }
        let roots = at.map(Scaled::sqrt);
        // sqrt x sqrt y + sqrt y sqrt z + sqrt z sqrt x.
        let shift = roots[0] * (roots[1] + roots[2]) + roots[1] * roots[2];
        step(&at, &roots, shift, power);
        at = at.map(|x| (x + shift).shift(-2));
        power -= 2;
    }
    None
}

/// R_F of arguments >= 0.
pub(crate) fn rf(x: Scaled, y: Scaled, z: Scaled) -> Scaled {
    let at = [x, y, z];
    if at.iter().filter(|x| x.is_zero()).count() > 1 {
        return Scaled::INFINITY;
    }
    brought_near(at, STEPS, |_, _, _, _| ()).map_or(Scaled::NAN, |([x, y, z], top, _)| {
        Scaled::from(carlson_duplication::rf(x, y, z)).shift(-top / 2)
    })
}

/// R_C of x >= 0, y > 0.
pub(crate) fn rc(x: Scaled, y: Scaled) -> Scaled {
    brought_near([x, y, y], STEPS, |_, _, _, _| ()).map_or(Scaled::NAN, |([x, y, _], top, _)| {
        Scaled::from(carlson_duplication::rc(x, y)).shift(-top / 2)
    })
}

/// R_C of x >= 0 and any y: for y < 0 Cauchy's principal value.
pub(crate) fn rc_principal(x: Scaled, y: Scaled) -> Scaled {
    if y.is_zero() {
        return Scaled::INFINITY;
    }
    if y.is_positive() {
        return rc(x, y);
    }
    if x.is_zero() {
        return Scaled::ZERO;
    }
    (x / (x - y)).sqrt() * rc(x - y, -y)
}

/// R_D of x, y >= 0, z > 0.
pub(crate) fn rd(x: Scaled, y: Scaled, z: Scaled) -> Scaled {
    if z.is_zero() || (x.is_zero() && y.is_zero()) {
        return Scaled::INFINITY;
    }
    let mut sum = Scaled::ZERO;
    let near = brought_near([x, y, z], STEPS, |at, roots, shift, power| {
        sum = sum + (Scaled::from(3.0) / (roots[2] * (at[2] + shift))).shift(power);
    });
    near.map_or(Scaled::NAN, |([x, y, z], top, power)| {
        sum + Scaled::from(carlson_duplication::rd(x, y, z)).shift(power - top / 2 * 3)
    })
}

/// R_J of x, y, z >= 0, p > 0.
pub(crate) fn rj(x: Scaled, y: Scaled, z: Scaled, p: Scaled) -> Scaled {
    if p.is_zero() || [x, y, z].iter().filter(|x| x.is_zero()).count() > 1 {
        return Scaled::INFINITY;
    }
    let mut sum = Scaled::ZERO;
    let near = brought_near([x, y, z, p], STEPS_OF_RJ, |&[_, _, _, p], &[x, y, z, _], shift, power| {
        let a = p * (x + y + z) + x * y * z;
        let b_square = p * (p + shift).square();
        sum = sum + (rc(a.square(), b_square) * 3.0).shift(power);
    });
    near.map_or(Scaled::NAN, |([x, y, z, p], top, power)| {
        sum + Scaled::from(carlson_duplication::rj(x, y, z, p)).shift(power - top / 2 * 3)
    })
}

/// Cauchy's principal value of R_J(x, y, z, -q), q > 0: DLMF 19.20.14 with z the largest, so that its R_F and R_J have
/// one sign.
fn rj_principal(x: Scaled, y: Scaled, z: Scaled, q: Scaled) -> Scaled {
    let mut at = [x, y, z];
    let bigger = |a: Scaled, b: Scaled| (a - b).is_positive();
    for (i, j) in [(0, 1), (1, 2)] {
        if bigger(at[i], at[j]) {
            at.swap(i, j);
        }
    }
    let [x, y, z] = at;
    let sum = z + q;
    let (zx, zy) = (z - x, z - y);
    // (z (x + y + q) - x y)/(z + q) and z minus it.
    let p = (z * (x + q) + y * zx) / sum;
    let below = zx * zy / sum;
    let (pq, xy) = (p * q, x * y);
    let first = below * rj(x, y, z, p) + rf(x, y, z) * 3.0;
    let second =
        if xy.is_zero() { Scaled::ZERO } else { (xy * z / (xy + pq)).sqrt() * rc(xy + pq, pq) * 3.0 };
    (second - first) / sum
}

/// The value where an argument is zero, infinite or out of the domain; none where the integral has to be calculated.
fn limit(arguments: &[f64]) -> Option<f64> {
    if arguments.iter().any(|x| x.is_nan() || *x < 0.0) {
        return Some(f64::NAN);
    }
    let zeros = arguments.iter().filter(|x| **x == 0.0).count();
    let infinite = arguments.iter().any(|x| x.is_infinite());
    match (zeros > 1, infinite) {
        (true, true) => Some(f64::NAN),
        (true, false) => Some(f64::INFINITY),
        (false, true) => Some(0.0),
        (false, false) => None,
    }
}

/// R_F(x, y, z) = 1/2 int_0^inf dt / sqrt((t + x)(t + y)(t + z)).
///
/// | argument | domain |
/// |---|---|
/// | `x`, `y`, `z` | >= 0; two zeros give inf, an infinity 0, below zero NaN |
///
/// **Error** at most 3 ulp.
///
/// **Source** DLMF 19.16.1, 19.26.18, 19.36.1.
///
/// ```
/// assert_eq!(format!("{:.12}", libration::carlson_rf(1.0, 2.0, 3.0)), "0.726945935469");
/// ```
#[must_use]
pub fn carlson_rf(x: f64, y: f64, z: f64) -> f64 {
    one(&CarlsonRf, [x, y, z], careful_rf)
}

/// R_F of columns.
///
/// **Error**, domain and source of [`carlson_rf`], value by value the same. Panics where the lengths differ.
pub fn carlson_rf_into([x, y, z]: [&[f64]; 3], values: &mut [f64]) {
    column(&CarlsonRf, [x, y, z], values, careful_rf);
}

pub(crate) fn careful_rf([x, y, z]: [f64; 3]) -> f64 {
    limit(&[x, y, z]).unwrap_or_else(|| rf(x.into(), y.into(), z.into()).value())
}

/// R_C(x, y) = 1/2 int_0^inf dt / ((t + y) sqrt(t + x)), for y < 0 Cauchy's principal value.
///
/// | argument | domain |
/// |---|---|
/// | `x` | >= 0, else NaN |
/// | `y` | any; inf at 0 |
///
/// **Error** at most 3 ulp.
///
/// **Source** DLMF 19.2.17, 19.2.20.
///
/// ```
/// assert_eq!(format!("{:.12}", libration::carlson_rc(1.0, 2.0)), "0.785398163397");
/// ```
#[must_use]
pub fn carlson_rc(x: f64, y: f64) -> f64 {
    one(&CarlsonRc, [x, y], careful_rc)
}

/// R_C of columns.
///
/// **Error**, domain and source of [`carlson_rc`], value by value the same. Panics where the lengths differ.
pub fn carlson_rc_into([x, y]: [&[f64]; 2], values: &mut [f64]) {
    column(&CarlsonRc, [x, y], values, careful_rc);
}

pub(crate) fn careful_rc([x, y]: [f64; 2]) -> f64 {
    let undecided = y == 0.0 && x.is_infinite();
    if x.is_nan() || y.is_nan() || x < 0.0 || undecided {
        return f64::NAN;
    }
    if x.is_infinite() || y.is_infinite() {
        return 0.0;
    }
    rc_principal(x.into(), y.into()).value()
}

/// R_D(x, y, z) = 3/2 int_0^inf dt / ((t + z) sqrt((t + x)(t + y)(t + z))).
///
/// | argument | domain |
/// |---|---|
/// | `x`, `y` | >= 0; both zero give inf |
/// | `z` | > 0; zero gives inf |
///
/// An infinity gives 0, below zero NaN.
///
/// **Error** at most 3 ulp.
///
/// **Source** DLMF 19.16.5, 19.36.2.
///
/// ```
/// assert_eq!(format!("{:.12}", libration::carlson_rd(1.0, 2.0, 3.0)), "0.290460281029");
/// ```
#[must_use]
pub fn carlson_rd(x: f64, y: f64, z: f64) -> f64 {
    one(&CarlsonRd, [x, y, z], careful_rd)
}

/// R_D of columns.
///
/// **Error**, domain and source of [`carlson_rd`], value by value the same. Panics where the lengths differ.
pub fn carlson_rd_into([x, y, z]: [&[f64]; 3], values: &mut [f64]) {
    column(&CarlsonRd, [x, y, z], values, careful_rd);
}

pub(crate) fn careful_rd([x, y, z]: [f64; 3]) -> f64 {
    match limit(&[x, y, z]) {
        Some(0.0) if z == 0.0 => f64::NAN,
        Some(value) => value,
        None if z == 0.0 => f64::INFINITY,
        None => rd(x.into(), y.into(), z.into()).value(),
    }
}

/// R_J(x, y, z, p) = 3/2 int_0^inf dt / ((t + p) sqrt((t + x)(t + y)(t + z))), for p < 0 Cauchy's principal value.
///
/// | argument | domain |
/// |---|---|
/// | `x`, `y`, `z` | >= 0; two zeros give inf (NaN for p < 0), an infinity 0, below zero NaN |
/// | `p` | any; inf at 0 |
///
/// **Error** at most 3 ulp, plus 2^-98 of the condition next to the zeros of the principal value.
///
/// **Source** DLMF 19.16.2, 19.20.14, 19.26.22.
///
/// ```
/// assert_eq!(format!("{:.12}", libration::carlson_rj(1.0, 2.0, 3.0, 4.0)), "0.239848099750");
/// ```
#[must_use]
pub fn carlson_rj(x: f64, y: f64, z: f64, p: f64) -> f64 {
    one(&CarlsonRj, [x, y, z, p], careful_rj)
}

/// R_J of columns.
///
/// **Error**, domain and source of [`carlson_rj`], value by value the same. Panics where the lengths differ.
pub fn carlson_rj_into([x, y, z, p]: [&[f64]; 4], values: &mut [f64]) {
    column(&CarlsonRj, [x, y, z, p], values, careful_rj);
}

pub(crate) fn careful_rj([x, y, z, p]: [f64; 4]) -> f64 {
    if p.is_nan() {
        return f64::NAN;
    }
    match limit(&[x, y, z]) {
        // Infinity against zero.
        Some(0.0) if p == 0.0 => return f64::NAN,
        Some(f64::INFINITY) if p < 0.0 || p.is_infinite() => return f64::NAN,
        Some(value) => return value,
        None if p == 0.0 => return f64::INFINITY,
        None if p.is_infinite() => return 0.0,
        None => {}
    }
    let [x, y, z] = [x, y, z].map(Scaled::from);
    if p > 0.0 { rj(x, y, z, p.into()).value() } else { rj_principal(x, y, z, Scaled::from(-p)).value() }
}

/// Below this power of two a double-double has no room for squares beside 1.
const LOGARITHMIC: i32 = -300;

/// R_F(x^2, y^2, z^2) from x, y, z >= 0 of any size, at most one of them 0.
pub(crate) fn rf_of_roots([mut x, mut y, mut z]: [Scaled; 3]) -> Scaled {
    if (x - z).is_positive() {
        (x, z) = (z, x);
    }
    if (y - z).is_positive() {
        (y, z) = (z, y);
    }
    let (x, y) = (x / z, y / z);
    let sum = x + y;
    let unit = if sum.power() < LOGARITHMIC {
        // ln(4/(x + y)): the next term is below what a double-double holds.
        sum.shift(-2).minus_ln()
    } else {
        carlson_duplication::rf_of_roots(x.to_dd(), y.to_dd())
    };
    Scaled::from(unit) / z
}

/// artanh of x >= 0, with 1 - x^2 = root^2.
pub(crate) fn artanh(x: Scaled, root: Scaled) -> Scaled {
    x * rf_of_roots([root, root, Scaled::ONE])
}

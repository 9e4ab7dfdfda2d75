//! The inverses of Glaisher's twelve functions.
//!
//! Over lanes in inverse_lanes.rs; and row by row for every argument:
//!
//! Method: with Delta(p, q) = ps^2 - qs^2, that is Delta(n, d) = m, Delta(d, c) = 1 - m, Delta(n, c) = 1, every inverse is one
//! R_F whose arguments are sums of x^2 (or 1) and Delta x^2 (or Delta); each is formed so that it subtracts only where the
//! range ends. Source: DLMF 22.15, 19.25.28 to 19.25.34.

use super::functions::NevilleIndex;
use super::glaisher::Glaisher;
use super::inverse_lanes::{InverseEven, InverseOdd, others};
use crate::elliptic::agm::quarter_period;
use crate::elliptic::given::Given;
use crate::elliptic::integrals::carlson::rf;
use crate::elliptic::integrals::complete::complete_k_dd;
use crate::elliptic::parameter::Parameter;
use crate::elliptic::rows::{column_of_parameter, one_of_parameter};
use crate::float::{Dd, Scaled};

/// The first zero of cn for m < 1, of dn for m > 1; infinite at m = 1.
pub(super) fn real_quarter(parameter: Parameter) -> Dd {
    if parameter.mc.hi > 0.0 {
        return complete_k_dd(parameter);
    }
    let unit = parameter.unit();
    if unit.kc.hi == 0.0 { Dd::from(f64::INFINITY) } else { unit.k * quarter_period(unit.kc) }
}

/// Delta(p, q) for p, q among c, d, n.
fn delta(p: NevilleIndex, q: NevilleIndex, parameter: Parameter) -> Scaled {
    use NevilleIndex::{C, D, N};
    let [m, mc] = [parameter.m, parameter.mc].map(Scaled::from);
    match (p, q) {
        (N, D) => m,
        (D, N) => -m,
        (D, C) => mc,
        (C, D) => -mc,
        (N, C) => Scaled::ONE,
        (C, N) => -Scaled::ONE,
        _ => Scaled::ZERO,
    }
}

/// For sp(u) = x (`zero`): u/x. For ps(u) = x (else): u >= 0. p is `index`, and `square` is x^2, x >= 0.
fn odd(index: NevilleIndex, zero: bool, square: Scaled, parameter: Parameter) -> Scaled {
    let (base, factor) = if zero { (Scaled::ONE, square) } else { (square, Scaled::ONE) };
    let [mut p, mut q] = others(index);
    if delta(p, q, parameter).is_negative() {
        (p, q) = (q, p);
    }
    // The lower is a difference only if the range ends there; the upper is that and Delta(p, q) >= 0.
    let below = delta(q, index, parameter);
    let lower = base + below * factor;
    let upper = if below.is_negative() {
        lower + delta(p, q, parameter) * factor
    } else {
        base + delta(p, index, parameter) * factor
    };
    if lower.is_negative() { Scaled::NAN } else { rf(base, lower, upper) }
}

/// The u >= 0 of an even pq at |x|.
fn even(p: NevilleIndex, q: NevilleIndex, x: f64, parameter: Parameter) -> Scaled {
    if x == 1.0 {
        return Scaled::ZERO;
    }
    let r = match others(p) {
        [first, second] if first == q => second,
        [first, _] => first,
    };
    let square = Scaled::from(x).square();
    let distance = delta(q, p, parameter);
    let w = Scaled::from(Dd::sum(1.0, -x)) * Scaled::from(Dd::sum(1.0, x)) / distance;
    if distance.is_zero() || w.is_negative() {
        return Scaled::NAN;
    }
    // 1 + Delta(r, q) w, which is also (Delta(r, p) - Delta(r, q) x^2)/Delta(q, p): the one that does not subtract. Where
    // both do, the second, which is exactly 0 at an exact end of the range, unless its terms are much larger.
    let (ratio, offset) = (delta(r, q, parameter), delta(r, p, parameter));
    let sums = ratio.is_negative() != offset.is_negative();
    let larger = offset.abs() - distance.abs().shift(1);
    let last = if !ratio.is_negative() || (!sums && larger.is_positive()) {
        Scaled::ONE + ratio * w
    } else {
        (offset - ratio * square) / distance
    };
    if last.is_negative() { Scaled::NAN } else { w.sqrt() * rf(square, Scaled::ONE, last) }
}

/// arcpq(x | m): the u with pq(u | m) = x on the principal branch.
///
/// | argument | domain |
/// |---|---|
/// | `which` | the function pq |
/// | `x` | its real range, else NaN; an infinity is the zero of qp |
/// | `parameter` | any |
///
/// The odd functions sn, sc, sd give u between the first zeros of their derivative or their first poles around 0, ns, cs, ds
/// the branch next to their pole at 0: odd in x. The even functions give the least u >= 0. For 0 <= m <= 1 that is arcsn
/// in `[-K, K]`, arccn, arccd in `[0, 2K]`, arcdn in `[0, K]`. A constant function (dn at m = 0, cd at m = 1) gives 0 at 1.
///
/// **Error** at most 3 ulp, plus 2^-98 of the condition in x and m.
///
/// **Source** DLMF 22.15, 19.25.28 to 19.25.34.
///
/// ```
/// use libration::{Glaisher, Parameter, inverse_jacobi};
/// let u = inverse_jacobi(Glaisher::Sn, 0.5, Parameter::from_m(0.5));
/// assert_eq!(format!("{u:.12}"), "0.535622732805");
/// ```
#[must_use]
pub fn inverse_jacobi(which: Glaisher, x: f64, parameter: Parameter) -> f64 {
    let careful = |[x]: [f64; 1], parameter| careful_inverse(which, x, parameter);
    match Inverse::new(which) {
        Inverse::Odd(formula) => one_of_parameter(&formula, [x], parameter, careful),
        Inverse::Even(formula) => one_of_parameter(&formula, [x], parameter, careful),
    }
}

/// arcpq of a column of values, each with a parameter of its own.
///
/// **Error**, domain and source of [`inverse_jacobi`], value by value the same. Panics where the lengths differ.
pub fn inverse_jacobi_into(which: Glaisher, x: &[f64], given: Given, parameters: &[f64], values: &mut [f64]) {
    let careful = |[x]: [f64; 1], parameter| careful_inverse(which, x, parameter);
    let parameters = (given, parameters);
    match Inverse::new(which) {
        Inverse::Odd(formula) => column_of_parameter(&formula, [x], parameters, values, careful),
        Inverse::Even(formula) => column_of_parameter(&formula, [x], parameters, values, careful),
    }
}

/// The formula over lanes of one of the twelve.
pub(crate) enum Inverse {
    /// With s.
    Odd(InverseOdd),
    /// Without.
    Even(InverseEven),
}

impl Inverse {
    pub fn new(which: Glaisher) -> Self {
        match which.pq() {
            [NevilleIndex::S, q] => Inverse::Odd(InverseOdd::new(q, true)),
            [p, NevilleIndex::S] => Inverse::Odd(InverseOdd::new(p, false)),
            [p, q] => Inverse::Even(InverseEven::new(p, q)),
        }
    }
}

pub(crate) fn careful_inverse(which: Glaisher, x: f64, parameter: Parameter) -> f64 {
    let [p, q] = which.pq();
    if x.is_nan() || parameter.mc.hi.is_nan() {
        return f64::NAN;
    }
    if x.is_infinite() {
        return inverse(q, p, f64::copysign(0.0, x), parameter);
    }
    inverse(p, q, x, parameter)
}

fn inverse(p: NevilleIndex, q: NevilleIndex, x: f64, parameter: Parameter) -> f64 {
    if p == NevilleIndex::S {
        return if x == 0.0 { x } else { (odd(q, true, Scaled::from(x).square(), parameter) * x).value() };
    }
    if q == NevilleIndex::S {
        return odd(p, false, Scaled::from(x).square(), parameter).value().copysign(x);
    }
    let u = even(p, q, x.abs(), parameter);
    if x >= 0.0 {
        return u.value();
    }
    // Negative values stand beyond the zero or the pole at the end of the quarter period.
    let turning = if parameter.mc.hi > 0.0 { NevilleIndex::C } else { NevilleIndex::D };
    let both = p != NevilleIndex::N && q != NevilleIndex::N;
    if parameter.mc.hi == 0.0 || (p != turning && q != turning && !both) {
        return f64::NAN;
    }
    (Scaled::from(real_quarter(parameter).scale(2.0)) - u).value()
}

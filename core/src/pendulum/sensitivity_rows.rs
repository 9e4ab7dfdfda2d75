//! The derivatives of rows of (t, theta0, velocity0, omega0), each a state of its own: over lanes, by the addition theorem and
//! without the phase of the start.
//!
//! With s, c = sine and cosine of theta/2, x = velocity/2 omega0, m = s^2 + x^2, mc = c^2 - x^2, tau = omega0 t, 0 for the start
//! and G = int_0^tau x^2: the solutions of variational.rs, counted from the start and times sqrt(m), are
//!   a = x, b = s c, mc p = s c - x G, mc q = s c G + x (mc - s^2), at the start with G = 0,
//! in every regime, because all are analytic in m. G = I(tau) - s0 s S, where S is sn(tau|m) and
//!   I = m int_0^tau cn^2 in libration, kappa int_0^(kappa tau) dn^2 of the parameter 1/m in rotation,
//! by the slope of ln theta4. What cancels is 1/mc times larger than the result.
//! Source: DLMF 22.16.30 to 22.16.32, 22.16(ii).

use super::addition_theorem::{LaterState, StateOnLanes};
use super::batch::{Classify, class};
use super::frequency::Frequency;
use super::orbit::Orbit;
use super::sensitivity::Sensitivity;
use crate::elliptic::theta::neville_lanes::Point;
use crate::float::Dd;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{BLOCK, Classes, Columns, Evaluation, Formula, Lane, LastMade};

/// Least |1 - kappa^2|: below, too many of a double's digits cancel.
const LEAST_COMPLEMENT: f64 = 1e-4;
/// Least kappa^2, and the largest.
const LEAST: f64 = 1e-280;
const LARGEST: f64 = 1e30;

/// I of a row: by the means of m cn^2 and dn^2 and the slope of ln theta4, as epsilon_lanes.rs has it.
#[inline(always)]
fn integral<const ROTATION: bool, const HYPERBOLIC: bool, L: Lane>(
    start: &StateOnLanes<L, ROTATION, HYPERBOLIC>,
    t: L,
    n: L,
    f: L,
    point: &Point<L>,
) -> Unnormalised<L> {
    let (one, half) = (L::splat(1.0), L::splat(0.5));
    let unit = Unnormalised::from_double(one);
    let lattices = &start.lattices;
    let [fourth, _, third] = lattices.logarithmic_slopes::<HYPERBOLIC>(point.angle);
    let quadratic = Unnormalised::from_double(lattices.quadratic);
    let (far, mean) = if HYPERBOLIC {
        let part = lattices.mc.scale(half);
        let mean = if ROTATION { part + quadratic } else { quadratic - part };
        (Dd::from_double(one) + -third, mean)
    } else {
        let m = if ROTATION { unit.minus_smaller(lattices.mc) } else { start.m };
        let part = m.scale(half);
        let lead = if ROTATION { unit.minus_smaller(part) } else { part };
        (-third, lead.minus_smaller(quadratic))
    };
    let slope = Unnormalised::from(Dd::select(point.folded, far, fourth).scale(one.copysign(f)));
    let slope = if HYPERBOLIC { Unnormalised::from_double(n + n) + slope } else { slope };
    let passed = start.stretch * Unnormalised::from_double(t);
    (passed * mean + slope * lattices.mean) * start.k
}

/// Rounded.
#[inline(always)]
fn value<L: Lane>(sum: Unnormalised<L>) -> L {
    sum.hi + sum.lo
}

/// The derivatives row by row, of one class.
struct DerivativesOfState<const ROTATION: bool, const HYPERBOLIC: bool>;

impl<const ROTATION: bool, const HYPERBOLIC: bool> Formula<4, 6>
    for DerivativesOfState<ROTATION, HYPERBOLIC>
{
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [t, theta, velocity, omega]: [L; 4]) -> [L; 6] {
        let (zero, one, two) = (L::splat(0.0), L::splat(1.0), L::splat(2.0));
        let start =
            StateOnLanes::<L, ROTATION, HYPERBOLIC>::new(theta, velocity, Unnormalised::from_double(omega));
        let LaterState { n, f, within, opposite, adjacent, x, divisor, sn, point } = start.later(t);
        // The half angle turns by d; all products of sine and cosine at the end follow from those at the start.
        let inverse = divisor.inverse();
        let (sin_d, cos_d, x) = (opposite * inverse, adjacent * inverse, x * inverse);
        let StateOnLanes { s_square, c_square, across, x: x0, m, mc, .. } = start;
        let s_s = s_square * cos_d + across * sin_d;
        let c_s = across * cos_d + c_square * sin_d;
        let product = across * (cos_d * cos_d - sin_d * sin_d) + (c_square - s_square) * (sin_d * cos_d);
        let square = s_s * cos_d + c_s * sin_d;
        let integral = integral::<ROTATION, HYPERBOLIC, L>(&start, t, n, f, &point);
        let g = integral - s_s * sn.over(point.unit);
        let (left, later) = (mc - s_square, mc - square);
        let per = one / (m.hi * mc.hi);
        let tau = omega * t;
        let per_omega = one / omega;
        let (x0_x, across_product) = (x0 * x, across * product);
        let by_theta = value(x0_x * left + across_product - x * across * g) * per;
        let by_velocity = value(x0 * product - across * x - x0_x * g) * per;
        let rate_by_theta = value(across_product * g + x * across * later - product * x0 * left) * per;
        let rate_by_velocity = value(x0_x * later + across_product + x0 * product * g) * per;
        let (x, x0, product) = (x.hi, x0.hi, product.hi);
        let values = [
            by_theta,
            by_velocity * per_omega,
            two * (x * tau - x0 * by_velocity) * per_omega,
            omega * rate_by_theta,
            rate_by_velocity,
            two * (x - product * tau - x0 * rate_by_velocity),
        ];
        let valid = L::select(within, one, L::splat(f64::NAN));
        let valid = L::select(L::splat(LEAST_COMPLEMENT).less(mc.hi.abs()), valid, L::splat(f64::NAN));
        let valid = L::select(L::splat(LEAST).less(m.hi), valid, L::splat(f64::NAN));
        let valid = L::select(m.hi.less(L::splat(LARGEST)), valid, L::splat(f64::NAN));
        let at_start = t.equal(zero);
        let mut derivatives = [zero; 6];
        let mut i = 0;
        while i < 6 {
            let unit = L::splat(if i == 0 || i == 4 { 1.0 } else { 0.0 });
            derivatives[i] = L::select(at_start, unit, values[i] * valid);
            i += 1;
        }
        derivatives
    }
}

/// The derivatives of rows of (t, theta0, velocity0, omega0), row by row of the matrix: every row an orbit of its own.
///
/// NaN where an argument is out of the domain of [`Orbit`]; panics where the lengths differ. **Error** and source of
/// [`Sensitivity::at`].
///
/// ```
/// let mut columns = [[0.0; 1]; 6];
/// let rows = [&[5.0], &[3.0], &[0.0], &[1.0]].map(|column| column.as_slice());
/// libration::pendulum::sensitivities_into(rows, columns.each_mut().map(|column| column.as_mut_slice()));
/// let [[a], [b], [c], ..] = columns;
/// assert_eq!(format!("{a:.6} {b:.6} {c:.6}"), "9.258339 9.427493 -6.652040");
/// ```
pub fn sensitivities_into(arguments: [&[f64]; 4], mut derivatives: [&mut [f64]; 6]) {
    let rows = arguments[0].len();
    let fits = arguments.iter().all(|column| column.len() == rows)
        && derivatives.iter().all(|column| column.len() == rows);
    assert!(fits, "columns of different lengths");
    let mut classes = Classes::<4, 6, { class::COUNT }>::new();
    let mut codes = [0.0; BLOCK];
    for from in (0..rows).step_by(BLOCK) {
        let block = from..rows.min(from + BLOCK);
        let codes = &mut codes[..block.len()];
        let arguments = arguments.map(|argument| &argument[block.clone()]);
        let results = derivatives.each_mut().map(|column| &mut column[block.clone()]);
        let [_, theta, velocity, omega] = arguments;
        Columns::new([theta, velocity, omega], [&mut *codes]).of(&Classify);
        classes.filled(codes, arguments, results, |class, columns| match class {
            class::LIBRATION_CIRCULAR => columns.of(&DerivativesOfState::<false, false>),
            class::LIBRATION_HYPERBOLIC => columns.of(&DerivativesOfState::<false, true>),
            class::ROTATION_CIRCULAR => columns.of(&DerivativesOfState::<true, false>),
            class::ROTATION_HYPERBOLIC => columns.of(&DerivativesOfState::<true, true>),
            _ => columns.fill(f64::NAN),
        });
    }
    let mut made = LastMade::new();
    for row in 0..rows {
        if derivatives.iter().all(|column| !column[row].is_nan()) {
            continue;
        }
        let [t, theta, velocity, omega0] = arguments.map(|column| column[row]);
        let sensitivity = made.of([theta, velocity, omega0], || {
            let orbit = Frequency::from_omega0(omega0).and_then(|of| Orbit::new(theta, velocity, of));
            orbit.ok().map(|orbit| Sensitivity::new(&orbit))
        });
        let known = sensitivity.as_ref().map(|of| of.at(t).rows());
        for (i, column) in derivatives.iter_mut().enumerate() {
            column[row] = known.map_or(f64::NAN, |rows| rows[i / 3][i % 3]);
        }
    }
}

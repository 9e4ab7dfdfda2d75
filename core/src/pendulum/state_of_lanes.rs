//! The states of rows of (action, phase, direction, omega0), each of its own: over lanes, in double.
//!
//! With j = J pi/8 omega0 in libration, s = J pi/4 omega0 in rotation, and slopes that cost nothing:
//!   m B(m) = j, below m = 1/2, slope in m K/2, of that B/4mc;  mc G(mc) = 1 - j above, slope in mc K/2, of that -B/4mc,
//!   kappa E(1/kappa^2) = s, slope in kappa K, of that -B/(kappa^3 mc); next to the separatrix in kappa^2 - 1, where
//!   kappa (E - 1) + (kappa - 1) = s - 1, slope K/2 kappa, of that -m^2 B/4 mc kappa - K/4 kappa^3.
//! Two of Halley's steps bring the starts to 2^-55. Then sn : cn by theta functions at the phase itself, without a period.
//! Rows are sorted by class as those of batch.rs. Source: DLMF 19.4.1, 19.4.2, 22.2; Halley's method.

use super::action::state_of;
use super::batch::{LARGE, SMALL, class};
use super::frequency::Frequency;
use crate::elliptic::integrals::complete_lanes::Complement;
use crate::elliptic::nome::short_nome;
use crate::elliptic::phase::alternating;
use crate::elliptic::theta::neville::short_corrections;
use crate::float::angle_reduction::{FAR, half_turns};
use crate::float::double_double::{fast_two_sum, two_sum};
use crate::float::elementary::{arctangent, horner, sin_cos, sinh_cosh};
use crate::float::unnormalised::Unnormalised;
use crate::float::{Dd, HALF_PI, PI, TWO_PI};
use crate::lanes::{BLOCK, Classes, Columns, Evaluation, Formula, Lane};

/// j of m = 1/2 in libration, and s of 1/m = 1/2 in rotation.
const HALF_OF_LIBRATION: f64 = 0.423_606_542_396_989_7;
const HALF_OF_ROTATION: f64 = 1.910_098_894_513_856;
/// Least j, and least distance of j and s from 1.
const LEAST: f64 = 1e-250;
const LEAST_COMPLEMENT: f64 = 1e-12;

/// pi/8.
const EIGHTH_PI: Dd = PI.half().half().half();

/// The class of action, phase, direction, omega0.
struct ClassOfAction;

impl Formula<4, 1> for ClassOfAction {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [action, phase, direction, omega]: [L; 4]) -> [L; 1] {
        let code = |class: usize| L::splat(class as f64);
        let fallback = code(class::FALLBACK);
        let j = action * L::splat(EIGHTH_PI.hi) / omega;
        let above = L::splat(HALF_OF_LIBRATION).less(j);
        let libration = L::select(above, code(class::LIBRATION_HYPERBOLIC), code(class::LIBRATION_CIRCULAR));
        let libration = L::select(j.less(L::splat(1.0 - LEAST_COMPLEMENT)), libration, fallback);
        let libration = L::select(L::splat(LEAST).less(j), libration, fallback);
        let above = L::splat(0.5 * HALF_OF_ROTATION).less(j);
        let rotation = L::select(above, code(class::ROTATION_CIRCULAR), code(class::ROTATION_HYPERBOLIC));
        let rotation = L::select(L::splat(0.5 + LEAST_COMPLEMENT).less(j), rotation, fallback);
        let rotation = L::select(j.less(L::splat(LARGE)), rotation, fallback);
        let found = L::select(direction.equal(L::splat(0.0)), libration, fallback);
        let found = L::select(direction.abs().equal(L::splat(1.0)), rotation, found);
        let found = L::select(phase.abs().less(L::splat(FAR)), found, fallback);
        let found = L::select(L::splat(SMALL).less(omega), found, fallback);
        [L::select(omega.less(L::splat(LARGE)), found, fallback)]
    }
}

/// What an action determines: m and mc of the elliptic functions, both in [0, 1], and kappa.
struct Parameters<L> {
    m: L,
    mc: L,
    k: L,
}

/// Halley's step to a root from what a function exceeds there, its slope, and the slope of that.
#[inline(always)]
fn halley<L: Lane>(x: L, excess: L, slope: L, bend: L) -> L {
    let twice = slope + slope;
    x - twice * excess / twice.mul_add(slope, -(excess * bend))
}

/// x with x (ln(16/x) + 1)/4 = rest, for 0 < rest < 1, to 6 per cent.
#[inline(always)]
fn next_to_separatrix<L: Lane>(rest: L) -> L {
    let mut x = rest * L::splat(0.5);
    let mut step = 0;
    while step < 3 {
        // The logarithm from the exponent and a straight line for the mantissa.
        let e = x.exponent();
        let log = x.mul_add((-e).exp2_integer(), e - L::splat(0.957)) * L::splat(core::f64::consts::LN_2);
        x = L::splat(4.0) * rest / (L::splat(1.0 + 4.0 * core::f64::consts::LN_2) - log);
        step += 1;
    }
    x
}

impl<L: Lane> Parameters<L> {
    /// m <= 1/2 in libration.
    #[inline(always)]
    fn of_small_libration(j: Unnormalised<L>) -> Self {
        let one = L::splat(1.0);
        let t = j.hi * L::splat(4.0 / core::f64::consts::PI);
        let mut m = t * horner(&[1.0, -0.125, -0.0156, -0.0054, -0.0033], t);
        let mut step = 0;
        while step < 2 {
            let mc = one - m;
            let at = Complement::new(mc);
            let b = at.b();
            let excess = m.mul_add(b, -j.hi) - j.lo;
            m = halley(m, excess, at.k() * L::splat(0.5), b * L::splat(0.25) / mc);
            step += 1;
        }
        Parameters { m, mc: one - m, k: m.sqrt() }
    }

    /// m > 1/2 in libration.
    #[inline(always)]
    fn of_large_libration(j: Unnormalised<L>) -> Self {
        let one = L::splat(1.0);
        let rest = Unnormalised::from_double(one).minus_smaller(j);
        let rest = rest.hi + rest.lo;
        let mut mc = next_to_separatrix(rest);
        let mut step = 0;
        while step < 2 {
            let at = Complement::new(mc);
            let inside = mc * at.g();
            let bend = (one - inside) / ((one - mc) * mc) * L::splat(-0.25);
            mc = halley(mc, inside - rest, at.k() * L::splat(0.5), bend);
            step += 1;
        }
        let m = one - mc;
        Parameters { m, mc, k: m.sqrt() }
    }

    /// 1/kappa^2 <= 1/2 in rotation.
    #[inline(always)]
    fn of_fast_rotation(share: Unnormalised<L>) -> Self {
        let one = L::splat(1.0);
        let s = share.hi * L::splat(core::f64::consts::FRAC_2_PI);
        let inverse = one / s;
        let mut k = inverse.mul_add((inverse * inverse).mul_add(L::splat(-1.0 / 64.0), L::splat(0.25)), s);
        let mut step = 0;
        while step < 2 {
            let inverse = one / k;
            let m = inverse * inverse;
            let mc = one - m;
            let at = Complement::new(mc);
            let excess = k.mul_add(at.e(), -share.hi) - share.lo;
            k = halley(k, excess, at.k(), -(at.b() * m * inverse / mc));
            step += 1;
        }
        let inverse = one / k;
        let m = inverse * inverse;
        Parameters { m, mc: one - m, k }
    }

    /// 1/kappa^2 > 1/2 in rotation.
    #[inline(always)]
    fn of_slow_rotation(share: Unnormalised<L>) -> Self {
        let one = L::splat(1.0);
        let rest = share - Unnormalised::from_double(one);
        let rest = rest.hi + rest.lo;
        let mut beyond = next_to_separatrix(rest);
        let mut step = 0;
        while step < 2 {
            let k = (one + beyond).sqrt();
            let m = one / (one + beyond);
            let mc = beyond * m;
            let at = Complement::new(mc);
            let (inside, quarter, inverse) = (mc * at.e_beyond_one(), at.k(), one / k);
            let excess = k.mul_add(inside, beyond / (one + k)) - rest;
            // m B = E - mc K, and mc is a half at the most.
            let difference = (-mc).mul_add(quarter, one + inside);
            let bend = (m * difference / mc + quarter * m) * (inverse * L::splat(-0.25));
            beyond = halley(beyond, excess, quarter * inverse * L::splat(0.5), bend);
            step += 1;
        }
        let m = one / (one + beyond);
        Parameters { m, mc: beyond * m, k: (one + beyond).sqrt() }
    }
}

/// Angle and velocity of one class.
struct StateOf<const ROTATION: bool, const HYPERBOLIC: bool>;

impl<const ROTATION: bool, const HYPERBOLIC: bool> Formula<4, 2> for StateOf<ROTATION, HYPERBOLIC> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [action, phase, direction, omega]: [L; 4]) -> [L; 2] {
        let (one, two, half) = (L::splat(1.0), L::splat(2.0), L::splat(0.5));
        let factor = if ROTATION { EIGHTH_PI.scale(2.0) } else { EIGHTH_PI };
        let share = Unnormalised::from_double(action) * Unnormalised::splat(factor);
        let share = share.over(Unnormalised::from_double(omega));
        let Parameters { m, mc, k } = match (ROTATION, HYPERBOLIC) {
            (false, false) => Parameters::of_small_libration(share),
            (false, true) => Parameters::of_large_libration(share),
            (true, false) => Parameters::of_fast_rotation(share),
            (true, true) => Parameters::of_slow_rotation(share),
        };
        // The nome of m, or of mc where that is the smaller.
        let kc = mc.sqrt();
        let (small, other) = if HYPERBOLIC { (mc, m.sqrt()) } else { (m, kc) };
        let sum = one + other.sqrt();
        let lambda = small * half / ((one + other) * (sum * sum));
        let q = short_nome(Unnormalised::from_double(lambda)).hi;
        let fourth = (q * q) * (q * q);
        // theta3 at the origin: 2K/pi, or 2K'/pi, is its square.
        let origin = q.mul_add(two, fourth.mul_add(two, (fourth * fourth * q).mul_add(two, one)));
        let mean = one / (origin * origin);
        let [theta1, theta2, _, theta4] = short_corrections(q);
        // The phase in quarter periods, pi/2 each, of a libration, pi each of a rotation.
        let (count, rest) = half_turns(if ROTATION { phase * half } else { phase });
        let side = one.copysign(rest.hi);
        let rest = rest.scale(side);
        let folded = L::splat(core::f64::consts::FRAC_PI_4).less(rest.hi);
        let (hi, error) = fast_two_sum(L::splat(HALF_PI.hi), -rest.hi);
        let turned = Dd::ordered_sum(hi, error + (L::splat(HALF_PI.lo) - rest.lo));
        let angle = Dd::select(folded, turned, rest);
        let (t1, t2) = if HYPERBOLIC {
            let aspect = Complement::new(mc).k() * mean * L::splat(core::f64::consts::FRAC_2_PI);
            let (sine, _) = sinh_cosh(Dd::new(angle.hi * aspect, angle.lo * aspect));
            let x = -(sine.hi * sine.hi);
            (sine.hi.mul_add(theta1.at(x), sine.hi), mean.mul_add(theta4.at(x), mean))
        } else {
            let (sine, cosine) = sin_cos(angle);
            let x = sine.hi * sine.hi;
            (sine.hi.mul_add(theta1.at(x), sine.hi), cosine.hi.mul_add(theta2.at(x), cosine.hi) * mean)
        };
        // sn : cn : dn : 1 = sn : cn : dn : unit.
        let (sn, cn) = (L::select(folded, t2, t1), L::select(folded, kc * t1, t2));
        let (sn_square, cn_square) = (sn * sn, cn * cn);
        let dn = mc.mul_add(sn_square, cn_square).sqrt();
        let unit = (cn_square + sn_square).sqrt();
        let speed = omega * k * two / unit;
        if ROTATION {
            let local = arctangent(Dd::from_double(sn), Dd::from_double(cn)).scale(two * side);
            let (base, base_error) = count.two_product(L::splat(TWO_PI.hi));
            let (theta, error) = two_sum(base, local.hi);
            let rest = count.mul_add(L::splat(TWO_PI.lo), base_error) + local.lo;
            return [theta + (error + rest), speed * dn * direction];
        }
        let parity = alternating(count);
        let local = arctangent(Dd::from_double(k * sn), Dd::from_double(dn));
        [(local.hi + local.lo) * two * side * parity, speed * cn * parity]
    }
}

/// Angle and velocity of rows of (action, phase, direction, omega0): every row an orbit of its own.
///
/// NaN where [`state_of`] refuses the row; panics where the lengths differ. **Error** and source of [`state_of`].
///
/// ```
/// let (mut theta, mut velocity) = ([0.0; 2], [0.0; 2]);
/// let rows = [&[1.0, 2.0], &[0.5, 1.0], &[0.0, 1.0], &[1.0, 1.0]].map(|column| column.as_slice());
/// libration::pendulum::state_of_into(rows, [&mut theta, &mut velocity]);
/// assert_eq!(format!("{:.9} {:.9}", theta[0], velocity[0]), "0.751444104 1.151972454");
/// assert_eq!(format!("{:.6} {:.6}", theta[1], velocity[1]), "1.228194 2.190769");
/// ```
pub fn state_of_into(arguments: [&[f64]; 4], [theta, velocity]: [&mut [f64]; 2]) {
    let rows = arguments[0].len();
    let fits = arguments.iter().all(|column| column.len() == rows);
    assert!(fits && theta.len() == rows && velocity.len() == rows, "columns of different lengths");
    let mut classes = Classes::<4, 2, { class::COUNT }>::new();
    let mut codes = [0.0; BLOCK];
    for from in (0..rows).step_by(BLOCK) {
        let block = from..rows.min(from + BLOCK);
        let codes = &mut codes[..block.len()];
        let arguments = arguments.map(|argument| &argument[block.clone()]);
        let results = [&mut theta[block.clone()], &mut velocity[block]];
        Columns::new(arguments, [&mut *codes]).of(&ClassOfAction);
        classes.filled(codes, arguments, results, |class, columns| match class {
            class::LIBRATION_CIRCULAR => columns.of(&StateOf::<false, false>),
            class::LIBRATION_HYPERBOLIC => columns.of(&StateOf::<false, true>),
            class::ROTATION_CIRCULAR => columns.of(&StateOf::<true, false>),
            class::ROTATION_HYPERBOLIC => columns.of(&StateOf::<true, true>),
            _ => columns.fill(f64::NAN),
        });
    }
    for row in 0..rows {
        if theta[row].is_nan() || velocity[row].is_nan() {
            let [action, phase, direction, omega0] = arguments.map(|column| column[row]);
            let state = Frequency::from_omega0(omega0).and_then(|of| state_of(action, phase, direction, of));
            (theta[row], velocity[row]) = state.unwrap_or((f64::NAN, f64::NAN));
        }
    }
}

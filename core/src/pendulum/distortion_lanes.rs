//! The harmonic distortion of rows of turning angles, over lanes.
//!
//! With the nome q the amplitudes are a_j = (8/j) q^(j/2)/(1 + q^j) for odd j, so that
//!   distortion = (1 + q) q sqrt(sum of (q^((j - 3)/2)/(j (1 + q^j)))^2 over j = 3, 5, ...),
//! whose terms are all positive. The nome by its series in lambda up to m = 1/2, above from the nome q' of 1 - m,
//! ln q ln q' = pi^2, with the logarithm in double-double. Source: as fourier.rs; DLMF 19.5.5, 22.2.1.

use super::fourier::harmonic_distortion;
use super::state_lanes::StateLanes;
use crate::elliptic::nome::{minus_log_short_nome, short_nome};
use crate::float::elementary::exp;
use crate::float::unnormalised::Unnormalised;
use crate::float::{Dd, PI};
use crate::lanes::{Columns, Evaluation, Formula, Lane};

/// Least kappa^2, but 0, and largest nome: above, there are too many terms, and few rows that have them.
const LEAST: f64 = 1e-280;
const LARGEST_NOME: f64 = 0.6;

/// pi^2.
const PI_SQUARE: Dd = Dd::new(9.869604401089358, 6.265295508739711e-16);

/// The distortion at a turning angle.
struct Distortion;

impl Formula<1, 1> for Distortion {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [theta_max]: [L; 1]) -> [L; 1] {
        let (zero, one, nan) = (L::splat(0.0), L::splat(1.0), L::splat(f64::NAN));
        let unit = Unnormalised::from_double(one);
        let state = StateLanes::new(theta_max, zero, unit);
        let (m, mc) = (state.m, state.mc);
        let above = mc.hi.less(m.hi);
        let (small, large) = (Unnormalised::select(above, mc, m), Unnormalised::select(above, m, mc));
        let root = large.root();
        let square = unit.plus_smaller(root.root()).square();
        let lambda = small.scale(L::splat(0.5)).over(unit.plus_smaller(root) * square);
        let inverse = Unnormalised::splat(PI_SQUARE).over(minus_log_short_nome(lambda));
        let nome = Dd::select(above, exp((-inverse).tight()), short_nome(lambda));
        let q = L::select(nome.hi.less(L::splat(LARGEST_NOME)), nome.hi, nan);
        let (step, mut order, mut power, mut inner) = (q * q, L::splat(3.0), one, q * q * q);
        let mut sum = zero;
        loop {
            let ratio = power / (order * (one + inner));
            let term = ratio * ratio;
            let next = sum + term;
            // The terms fall by q^2 a step at the least, so that all that follow are below this over 1 - 0.36.
            let counts = (sum * L::splat(1e-18)).less(term);
            if !L::any(counts) {
                break;
            }
            sum = L::select(counts, next, sum);
            power = power * q;
            inner = inner * step;
            order = order + L::splat(2.0);
        }
        let factor = Unnormalised::from_double(sum).root() * unit.plus_smaller(nome.into());
        let distortion = factor * nome.into();
        let distortion = distortion.hi + distortion.lo;
        let valid = L::select(zero.less(theta_max), one, nan);
        let valid = L::select(theta_max.less(L::splat(PI.hi)), valid, nan);
        [L::select(L::splat(LEAST).less(m.hi), distortion * valid, nan)]
    }
}

/// [`harmonic_distortion`] of a column of turning angles; NaN outside, panics where the lengths differ.
///
/// ```
/// let mut distortion = [0.0; 2];
/// libration::pendulum::harmonic_distortion_into(&[1.0, 2.0], &mut distortion);
/// assert_eq!(distortion.map(|value| format!("{value:.9}")), ["0.005528070", "0.027412286"]);
/// ```
pub fn harmonic_distortion_into(theta_max: &[f64], distortion: &mut [f64]) {
    Columns::new([theta_max], [&mut *distortion]).of(&Distortion);
    for (value, theta_max) in distortion.iter_mut().zip(theta_max) {
        if value.is_nan() {
            *value = harmonic_distortion(*theta_max);
        }
    }
}

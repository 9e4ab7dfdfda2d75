//! Jacobi's functions of columns: every row with a parameter of its own.
//!
//! Rows are sorted by class and evaluated over lanes (functions_lanes.rs; at m = 1 the hyperbolic functions); what the lanes
//! leave out, beyond |m| = 1e200 and beyond 2^50 half periods, row by row with a set-up each.

use super::epsilon_lanes::Epsilon;
use super::epsilon_zeta::SecondKind;
use super::functions::{HyperbolicLimit, Jacobi, JacobiValues};
use super::functions_lanes::{Quotient, Together};
use super::glaisher::{Glaisher, HyperbolicQuotient};
use super::zeta_lanes::Zeta;
use crate::elliptic::given::Given;
use crate::elliptic::parameter_lanes::{Classify, class};
use crate::lanes::{Columns, Evaluation, Formula, Lane, by_class};

/// A formula of u alone, beside a parameter that does not count.
struct OfArgument<F>(F);

impl<F: Formula<1, N>, const N: usize> Formula<2, N> for OfArgument<F> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [u, _]: [L; 2]) -> [L; N] {
        self.0.at([u])
    }
}

/// sn, cn, dn and am of rows of (u, parameter), the parameter stated as `given`.
///
/// **Error**, domain and source of [`Jacobi::values`]; the last digits may differ from those of one parameter and many u.
///
/// # Panics
/// Where the lengths differ.
///
/// ```
/// use libration::elliptic::{Given, jacobi_into};
/// let [mut sn, mut cn, mut dn, mut am] = [[0.0; 2]; 4];
/// jacobi_into(Given::M, [&[1.0, 1.0], &[0.5, 2.0]], [&mut sn, &mut cn, &mut dn, &mut am]);
/// assert_eq!(format!("{:.10} {:.10}", sn[0], am[1]), "0.8030018249 0.7370437949");
/// ```
pub fn jacobi_into(given: Given, arguments: [&[f64]; 2], results: [&mut [f64]; 4]) {
    let lanes = |class: usize, columns: Columns<2, 4>| match class {
        class::CIRCULAR => columns.of(&Together::<false>(given)),
        class::HYPERBOLIC => columns.of(&Together::<true>(given)),
        class::LIMIT => columns.of(&OfArgument(HyperbolicLimit)),
        _ => columns.fill(f64::NAN),
    };
    by_class::<2, 4, { class::COUNT }>(&Classify(given), 1, arguments, results, lanes, |[u, value]| {
        let JacobiValues { sn, cn, dn, am } = Jacobi::new(given.parameter(value)).values(u);
        [sn, cn, dn, am]
    });
}

/// pq(u) of rows of (u, parameter), the parameter stated as `given`.
///
/// **Error**, domain and source of [`Jacobi::glaisher`]; the last digits may differ from those of one parameter and many u.
///
/// # Panics
/// Where the lengths differ.
///
/// ```
/// use libration::elliptic::{Given, glaisher_into};
/// let mut sc = [0.0; 2];
/// glaisher_into(Given::Mc, libration::Glaisher::Sc, [&[1.0, 3.0], &[0.5, 1e-20]], &mut sc);
/// assert_eq!(format!("{:.10} {:.10}", sc[0], sc[1]), "1.3473714714 10.0178749274");
/// ```
pub fn glaisher_into(given: Given, which: Glaisher, arguments: [&[f64]; 2], values: &mut [f64]) {
    let pq = which.pq();
    let lanes = |class: usize, columns: Columns<2, 1>| match class {
        class::CIRCULAR => columns.of(&Quotient::<false>(given, pq)),
        class::HYPERBOLIC => columns.of(&Quotient::<true>(given, pq)),
        class::LIMIT => columns.of(&OfArgument(HyperbolicQuotient(pq))),
        _ => columns.fill(f64::NAN),
    };
    by_class::<2, 1, { class::COUNT }>(&Classify(given), 1, arguments, [values], lanes, |[u, value]| {
        [Jacobi::new(given.parameter(value)).glaisher(which, u)]
    });
}

/// epsilon(u | m) of rows of (u, parameter), the parameter stated as `given`.
///
/// **Error**, domain and source of [`SecondKind::epsilon`]; the last digits may differ from those of one parameter and many u.
///
/// # Panics
/// Where the lengths differ.
///
/// ```
/// use libration::elliptic::{Given, jacobi_epsilon_into};
/// let mut epsilon = [0.0; 2];
/// jacobi_epsilon_into(Given::M, [&[1.0, 1.0], &[0.5, 2.0]], &mut epsilon);
/// assert_eq!(format!("{:.10} {:.10}", epsilon[0], epsilon[1]), "0.8722752770 0.5890486289");
/// ```
pub fn jacobi_epsilon_into(given: Given, arguments: [&[f64]; 2], values: &mut [f64]) {
    let lanes = |class: usize, columns: Columns<2, 1>| match class {
        class::CIRCULAR => columns.of(&Epsilon::<false>(given)),
        class::HYPERBOLIC => columns.of(&Epsilon::<true>(given)),
        class::LIMIT => columns.of(&OfArgument(HyperbolicQuotient(Glaisher::Sn.pq()))),
        _ => columns.fill(f64::NAN),
    };
    by_class::<2, 1, { class::COUNT }>(&Classify(given), 1, arguments, [values], lanes, |[u, value]| {
        [SecondKind::new(given.parameter(value)).epsilon(u)]
    });
}

/// zeta(u | m) of rows of (u, parameter), the parameter stated as `given`.
///
/// **Error**, domain and source of [`SecondKind::zeta`]; the last digits may differ from those of one parameter and many u.
///
/// # Panics
/// Where the lengths differ.
///
/// ```
/// use libration::elliptic::{Given, jacobi_zeta_into};
/// let mut zeta = [0.0; 2];
/// jacobi_zeta_into(Given::M, [&[1.0, 1.0], &[0.5, -2.0]], &mut zeta);
/// assert_eq!(format!("{:.10} {:.10}", zeta[0], zeta[1]), "0.1438019865 -0.1848132450");
/// ```
pub fn jacobi_zeta_into(given: Given, arguments: [&[f64]; 2], values: &mut [f64]) {
    let lanes = |class: usize, columns: Columns<2, 1>| match class {
        class::CIRCULAR => columns.of(&Zeta::<false>(given)),
        class::HYPERBOLIC => columns.of(&Zeta::<true>(given)),
        class::LIMIT => columns.of(&OfArgument(HyperbolicQuotient(Glaisher::Sn.pq()))),
        _ => columns.fill(f64::NAN),
    };
    by_class::<2, 1, { class::COUNT }>(&Classify(given), 1, arguments, [values], lanes, |[u, value]| {
        let parameter = given.parameter(value);
        // No set-up where there is no value.
        [if parameter.mc() < 0.0 { f64::NAN } else { SecondKind::new(parameter).zeta(u) }]
    });
}

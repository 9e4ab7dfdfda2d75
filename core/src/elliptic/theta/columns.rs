//! Theta functions of columns: every row with a nome of its own, over lanes (functions_lanes.rs). What the lanes leave out,
//! nomes below 1e-200, |z| from 1e9 on and values next to the end of the range, row by row with a set-up each.

use super::functions::{Theta, ThetaFunction};
use super::functions_lanes::{ClassifyNome, Nome, ThetaLanes};
use crate::elliptic::given::Given;
use crate::elliptic::parameter_lanes::{Classify, class};
use crate::lanes::{Columns, Evaluation, Formula, by_class};

/// theta_j of rows of (z, q).
///
/// **Error**, domain and source of [`Theta::value`] by [`Theta::from_nome`]; the last digits may differ from those of one
/// nome and many z.
///
/// # Panics
/// Where the lengths differ.
///
/// ```
/// use libration::elliptic::theta_of_nome_into;
/// let mut theta = [0.0; 2];
/// theta_of_nome_into(libration::ThetaFunction::One, [&[0.5, 0.5], &[0.1, 0.9]], &mut theta);
/// assert_eq!(format!("{:.10} {:.10}", theta[0], theta[1]), "0.5279836055 0.0001025529");
/// ```
pub fn theta_of_nome_into(which: ThetaFunction, arguments: [&[f64]; 2], values: &mut [f64]) {
    let careful = |q| (real_everywhere(which) || q >= 0.0).then(|| Theta::from_nome(q));
    columns(Nome::Itself, which, &ClassifyNome, arguments, values, careful);
}

/// theta_j of rows of (z, parameter), the parameter stated as `given`.
///
/// **Error**, domain and source of [`Theta::value`] by [`Theta::from_parameter`]; the last digits may differ from those of one
/// parameter and many z.
///
/// # Panics
/// Where the lengths differ.
///
/// ```
/// use libration::elliptic::{Given, theta_into};
/// let mut theta = [0.0; 2];
/// theta_into(Given::M, libration::ThetaFunction::Three, [&[0.5, 0.5], &[0.5, -2.0]], &mut theta);
/// assert_eq!(format!("{:.10} {:.10}", theta[0], theta[1]), "1.0466942569 0.9262438429");
/// ```
pub fn theta_into(given: Given, which: ThetaFunction, arguments: [&[f64]; 2], values: &mut [f64]) {
    let careful = |value| {
        let parameter = given.parameter(value);
        (real_everywhere(which) || parameter.m.hi >= 0.0).then(|| Theta::from_parameter(parameter))
    };
    columns(Nome::Parameter(given), which, &Classify(given), arguments, values, careful);
}

/// Whether it is real for negative nomes, too.
fn real_everywhere(which: ThetaFunction) -> bool {
    matches!(which, ThetaFunction::Three | ThetaFunction::Four)
}

fn columns(
    nome: Nome,
    which: ThetaFunction,
    classify: &impl Formula<1, 1>,
    arguments: [&[f64]; 2],
    values: &mut [f64],
    careful: impl Fn(f64) -> Option<Theta>,
) {
    let lanes = |class: usize, columns: Columns<2, 1>| match class {
        class::CIRCULAR => columns.of(&ThetaLanes::<false>(nome, which)),
        class::HYPERBOLIC => columns.of(&ThetaLanes::<true>(nome, which)),
        _ => columns.fill(f64::NAN),
    };
    by_class::<2, 1, { class::COUNT }>(classify, 1, arguments, [values], lanes, |[z, value]| {
        [careful(value).map_or(f64::NAN, |theta| theta.value(which, z))]
    });
}

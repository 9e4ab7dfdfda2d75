//! Functions of columns: a formula over lanes, and one by one the rows where it gives NaN, which is how it leaves a row out.
//! One value takes the same two steps, so that a column holds the values of its rows bit for bit.

use super::given::Given;
use super::parameter::Parameter;
use crate::lanes::{COMPACT, Columns, Evaluation, Formula, Once};

/// One value. Where code is to be short by the careful function, which is there anyway.
pub(crate) fn one<const A: usize>(
    formula: &impl Formula<A, 1>,
    arguments: [f64; A],
    careful: impl Fn([f64; A]) -> f64,
) -> f64 {
    if COMPACT {
        return careful(arguments);
    }
    let [value] = Once(arguments).of(formula);
    if value.is_nan() { careful(arguments) } else { value }
}

/// A column of them. Panics where the lengths differ.
pub(crate) fn column<const A: usize>(
    formula: &impl Formula<A, 1>,
    arguments: [&[f64]; A],
    values: &mut [f64],
    careful: impl Fn([f64; A]) -> f64,
) {
    Columns::new(arguments, [&mut *values]).of(formula);
    for (row, value) in values.iter_mut().enumerate() {
        if value.is_nan() {
            *value = careful(arguments.map(|argument| argument[row]));
        }
    }
}

/// One value of X arguments and a parameter; the formula takes m.hi, m.lo, mc.hi, mc.lo behind them.
pub(crate) fn one_of_parameter<const X: usize, const A: usize>(
    formula: &impl Formula<A, 1>,
    arguments: [f64; X],
    parameter: Parameter,
    careful: impl Fn([f64; X], Parameter) -> f64,
) -> f64 {
    if COMPACT {
        return careful(arguments, parameter);
    }
    let Parameter { m, mc, .. } = parameter;
    let [value] = Once(joined(arguments, [m.hi, m.lo, mc.hi, mc.lo])).of(formula);
    if value.is_nan() { careful(arguments, parameter) } else { value }
}

/// A column of them. Panics where the lengths differ.
pub(crate) fn column_of_parameter<const X: usize, const A: usize>(
    formula: &impl Formula<A, 1>,
    arguments: [&[f64]; X],
    (given, parameters): (Given, &[f64]),
    values: &mut [f64],
    careful: impl Fn([f64; X], Parameter) -> f64,
) {
    let fits = arguments.iter().all(|argument| argument.len() == values.len());
    assert!(fits && parameters.len() == values.len(), "columns of different lengths");
    given.blocks(parameters, |parts, rows| {
        let arguments = arguments.map(|argument| &argument[rows.clone()]);
        let values = &mut values[rows.clone()];
        Columns::new(joined(arguments, parts), [&mut *values]).of(formula);
        for (row, value) in values.iter_mut().enumerate() {
            if value.is_nan() {
                let parameter = given.parameter(parameters[rows.start + row]);
                *value = careful(arguments.map(|argument| argument[row]), parameter);
            }
        }
    });
}

/// Both lists as one.
fn joined<T: Copy, const X: usize, const A: usize>(arguments: [T; X], parts: [T; 4]) -> [T; A] {
    const { assert!(A == X + 4) };
    core::array::from_fn(|i| if i < X { arguments[i] } else { parts[i - X] })
}

//! Every function of columns against the careful code, on every instruction set: the same bits as its scalars, within
//! the promise of 3 ulp of the careful value, and at most one row in ten left to it.

use super::given::Given;
use super::integrals::carlson::{careful_rc, careful_rd, careful_rf, careful_rj};
use super::integrals::carlson_lanes::{CarlsonRc, CarlsonRd, CarlsonRf, CarlsonRj};
use super::integrals::heuman_lambda::careful_lambda;
use super::integrals::incomplete::{careful_e, careful_f};
use super::integrals::incomplete_lanes::{IncompleteE, IncompleteF};
use super::integrals::third_kind::{careful_complete_pi, careful_incomplete_pi};
use super::integrals::third_kind_lanes::{CompletePi, HeumanLambda, IncompletePi};
use super::integrals::*;
use super::jacobi::Glaisher;
use super::jacobi::inverse::{Inverse, careful_inverse, inverse_jacobi, inverse_jacobi_into};
use super::nome::{careful_nome, nome, nome_into};
use super::nome_lanes::NomeOfParameter;
use super::parameter::Parameter;
use super::rows;
use crate::lanes::{Formula, InstructionSet};

/// Rows of every column: a thousand, times the environment's ROWS_TIMES (`make test-rows`).
fn row_count() -> usize {
    1000 * std::env::var("ROWS_TIMES").ok().and_then(|times| times.parse().ok()).unwrap_or(1)
}

const BOUND: f64 = 3.0;

/// What stands in a column.
#[derive(Clone, Copy)]
enum Values {
    /// Uniform between two numbers.
    Between(f64, f64),
    /// From one number towards another, over 16 powers of ten of the distance.
    Towards(f64, f64),
    /// Powers of ten up to this one and down to its inverse.
    Powers(f64),
    /// Every seventh 0, the others as `Powers`.
    WithZeros(f64),
}

/// A number in [0, 1) for each row and column, the same on every machine.
fn fraction(row: usize, column: usize) -> f64 {
    let mut state = (row as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    state ^= (column as u64 + 1).wrapping_mul(0xd1b5_4a32_d192_ed03);
    for _ in 0..3 {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
    }
    (state >> 11) as f64 / (1_u64 << 53) as f64
}

impl Values {
    fn column(self, column: usize) -> Vec<f64> {
        let value = |row: usize| {
            let x = fraction(row, column);
            match self {
                Values::Between(low, high) => low + (high - low) * x,
                Values::Towards(from, to) => to + (from - to) * 10f64.powf(-16.0 * x),
                Values::WithZeros(_) if row.is_multiple_of(7) => 0.0,
                Values::Powers(powers) | Values::WithZeros(powers) => 10f64.powf(powers * (2.0 * x - 1.0)),
            }
        };
        (0..row_count()).map(value).collect()
    }
}

/// Ulps between two values; none between two NaN or the same infinity.
fn apart(a: f64, b: f64) -> f64 {
    if a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan()) {
        return 0.0;
    }
    let size = b.abs();
    let error = (a - b).abs() / (f64::from_bits(size.to_bits() + 1) - size);
    if error.is_nan() { f64::INFINITY } else { error }
}

/// Largest distance of the column from what the careful code says, and from the scalars 0.
fn worst(
    careful: &[f64],
    column: &dyn Fn(&mut [f64]),
    scalar: &dyn Fn(usize) -> f64,
    left_out: &dyn Fn(&mut [f64]),
) -> f64 {
    let mut largest = 0.0;
    for set in InstructionSet::available() {
        let mut values = vec![0.0; careful.len()];
        let work = || {
            left_out(&mut values);
            let out = values.iter().zip(careful).filter(|(value, known)| value.is_nan() && !known.is_nan());
            let out = out.count();
            assert!(out * 10 <= careful.len(), "{set:?}: {out} rows left to the careful code");
            column(&mut values);
            for (row, (value, known)) in values.iter().zip(careful).enumerate() {
                assert!(apart(scalar(row), *value) == 0.0, "{set:?} row {row}: {} {value}", scalar(row));
                largest = f64::max(largest, apart(*value, *known));
            }
        };
        assert!(set.scope(work).is_ok());
    }
    largest
}

/// A function of X columns.
fn of_columns<const X: usize>(
    name: &str,
    columns: [Values; X],
    formula: &impl Formula<X, 1>,
    into: impl Fn([&[f64]; X], &mut [f64]),
    scalar: impl Fn([f64; X]) -> f64,
    careful: impl Fn([f64; X]) -> f64,
) {
    let columns: [Vec<f64>; X] = core::array::from_fn(|i| columns[i].column(i));
    let row = |row: usize| columns.each_ref().map(|column| column[row]);
    let known: Vec<f64> = (0..row_count()).map(|i| careful(row(i))).collect();
    let slices = columns.each_ref().map(Vec::as_slice);
    let error = worst(&known, &|values| into(slices, values), &|i| scalar(row(i)), &|values| {
        rows::column(formula, slices, values, |_| f64::NAN)
    });
    assert!(error <= BOUND, "{name} {error}");
    let spoiled: Vec<f64> = known.iter().map(|value| value * (1.0 + 8.0 * f64::EPSILON)).collect();
    assert!(spoiled.iter().zip(&known).any(|(a, b)| apart(*a, *b) > BOUND), "{name}");
}

/// A function of X columns and a parameter, by every keyword that the parameters allow.
fn of_parameter<const X: usize, const A: usize>(
    name: &str,
    columns: [Values; X],
    parameters: Values,
    formula: &impl Formula<A, 1>,
    into: impl Fn([&[f64]; X], Given, &[f64], &mut [f64]),
    scalar: impl Fn([f64; X], Parameter) -> f64,
    careful: impl Fn([f64; X], Parameter) -> f64,
) {
    let columns: [Vec<f64>; X] = core::array::from_fn(|i| columns[i].column(i));
    let parameters = parameters.column(X);
    let row = |row: usize| columns.each_ref().map(|column| column[row]);
    let slices = columns.each_ref().map(Vec::as_slice);
    // A complement or a modulus below 0 would be m > 1.
    let negative = parameters.iter().any(|value| *value < 0.0);
    let all = [Given::M, Given::Mc, Given::Modulus];
    for given in &all[..if negative { 1 } else { 3 }] {
        let of = |i: usize| given.parameter(parameters[i]);
        let known: Vec<f64> = (0..row_count()).map(|i| careful(row(i), of(i))).collect();
        let error = worst(
            &known,
            &|values| into(slices, *given, &parameters, values),
            &|i| scalar(row(i), of(i)),
            &|values| {
                rows::column_of_parameter(formula, slices, (*given, &parameters), values, |_, _| f64::NAN);
            },
        );
        assert!(error <= BOUND, "{name} {given:?} {error}");
    }
}

/// A measure that cannot fail would prove nothing.
#[test]
fn a_spoiled_column_is_found() {
    let known = Values::Between(1.0, 2.0).column(0);
    let spoiled = |values: &mut [f64]| {
        for (value, known) in values.iter_mut().zip(&known) {
            *value = known * (1.0 + 8.0 * f64::EPSILON);
        }
    };
    let error = worst(&known, &spoiled, &|i| known[i] * (1.0 + 8.0 * f64::EPSILON), &spoiled);
    assert!(error > BOUND);
}

#[test]
fn carlson() {
    let unit = Values::Between(0.0, 1.0);
    let (wide, zeros) = (Values::Powers(20.0), Values::WithZeros(20.0));
    for [x, y, z] in [[unit; 3], [zeros, wide, wide], [Values::Towards(2.0, 1.0), unit, zeros]] {
        let careful = careful_rf;
        of_columns("R_F", [x, y, z], &CarlsonRf, carlson_rf_into, |[x, y, z]| carlson_rf(x, y, z), careful);
    }
    for [x, y] in
        [[unit; 2], [zeros, wide], [Values::Towards(2.0, 1.0), unit], [unit, Values::Between(-2.0, 0.0)]]
    {
        of_columns("R_C", [x, y], &CarlsonRc, carlson_rc_into, |[x, y]| carlson_rc(x, y), careful_rc);
    }
    for [x, y, z] in [[unit; 3], [zeros, wide, wide], [Values::Towards(2.0, 1.0), zeros, unit]] {
        let careful = careful_rd;
        of_columns("R_D", [x, y, z], &CarlsonRd, carlson_rd_into, |[x, y, z]| carlson_rd(x, y, z), careful);
    }
    let near = Values::Towards(2.0, 1.0);
    for [x, y, z, p] in
        [[unit; 4], [zeros, wide, wide, wide], [near, unit, zeros, near], [unit, near, near, unit]]
    {
        of_columns(
            "R_J",
            [x, y, z, p],
            &CarlsonRj,
            carlson_rj_into,
            |[x, y, z, p]| carlson_rj(x, y, z, p),
            careful_rj,
        );
    }
}

#[test]
fn incomplete() {
    let half_pi = core::f64::consts::FRAC_PI_2;
    let amplitudes = [
        Values::Between(-half_pi, half_pi),
        Values::Between(-100.0, 100.0),
        Values::Towards(0.0, half_pi),
        Values::Towards(1.0, 0.0),
    ];
    let parameters = [
        Values::Between(0.0, 1.0),
        Values::Towards(0.0, 1.0),
        Values::Towards(1.0, 0.0),
        Values::Between(-1e4, 1.0),
    ];
    for (phi, m) in amplitudes.into_iter().flat_map(|phi| parameters.map(|m| (phi, m))) {
        of_parameter(
            "F",
            [phi],
            m,
            &IncompleteF,
            |[phi], given, m, f| incomplete_f_into(phi, given, m, f),
            |[phi], p| incomplete_f(phi, p),
            careful_f,
        );
        of_parameter(
            "E",
            [phi],
            m,
            &IncompleteE,
            |[phi], given, m, e| incomplete_e_into(phi, given, m, e),
            |[phi], p| incomplete_e(phi, p),
            careful_e,
        );
    }
}

#[test]
fn of_parameters_alone() {
    let parameters = [
        Values::Between(0.0, 1.0),
        Values::Towards(0.0, 1.0),
        Values::Towards(1.0, 0.0),
        Values::Between(-60.0, 0.0),
        Values::Between(-1e9, 0.0),
    ];
    for m in parameters {
        let nome_of = |[]: [f64; 0], p| nome(p);
        of_parameter(
            "nome",
            [],
            m,
            &NomeOfParameter,
            |[], given, m, q| nome_into(given, m, q),
            nome_of,
            careful_nome,
        );
    }
}

#[test]
fn third_kind() {
    let unit = Values::Between(0.0, 1.0);
    let characteristics =
        [unit, Values::Towards(0.0, 1.0), Values::Towards(1.0, 0.0), Values::Between(-20.0, 1.0)];
    let amplitudes = [Values::Between(-1.5, 1.5), Values::Between(-20.0, 20.0), Values::Towards(0.0, 1.57)];
    let parameters = [unit, Values::Towards(0.0, 1.0), Values::Between(-100.0, 1.0)];
    for (n, m) in characteristics.into_iter().flat_map(|n| parameters.map(|m| (n, m))) {
        of_parameter(
            "complete Pi",
            [n],
            m,
            &CompletePi,
            |[n], given, m, out| complete_pi_into(n, given, m, out),
            |[n], p| complete_pi(n, p),
            careful_complete_pi,
        );
        for phi in amplitudes {
            of_parameter(
                "Pi",
                [n, phi],
                m,
                &IncompletePi,
                incomplete_pi_into,
                |[n, phi], p| incomplete_pi(n, phi, p),
                careful_incomplete_pi,
            );
        }
    }
    for (phi, m) in amplitudes.into_iter().flat_map(|phi| [unit, Values::Towards(1.0, 0.0)].map(|m| (phi, m)))
    {
        of_parameter(
            "lambda",
            [phi],
            m,
            &HeumanLambda,
            |[phi], given, m, out| heuman_lambda_into(phi, given, m, out),
            |[phi], p| heuman_lambda(phi, p),
            careful_lambda,
        );
    }
}

#[test]
fn inverses() {
    let unit = Values::Between(0.0, 1.0);
    for which in Glaisher::ALL {
        let ranges = match which.name() {
            "sn" | "cn" | "dn" | "cd" => [Values::Between(-1.0, 1.0), Values::Towards(0.0, 1.0)],
            "ns" | "nc" | "nd" | "dc" => [Values::Between(1.0, 30.0), Values::Towards(2.0, 1.0)],
            _ => [Values::Between(-30.0, 30.0), Values::Powers(10.0)],
        };
        let parameters = [unit, Values::Towards(0.0, 1.0), Values::Between(-100.0, 1.0)];
        for (x, m) in ranges.into_iter().flat_map(|x| parameters.map(|m| (x, m))) {
            let into = |[x]: [&[f64]; 1], given, m: &[f64], out: &mut [f64]| {
                inverse_jacobi_into(which, x, given, m, out);
            };
            let scalar = |[x]: [f64; 1], p| inverse_jacobi(which, x, p);
            let careful = |[x]: [f64; 1], p| careful_inverse(which, x, p);
            match Inverse::new(which) {
                Inverse::Odd(formula) => of_parameter(which.name(), [x], m, &formula, into, scalar, careful),
                Inverse::Even(formula) => of_parameter(which.name(), [x], m, &formula, into, scalar, careful),
            }
        }
    }
}

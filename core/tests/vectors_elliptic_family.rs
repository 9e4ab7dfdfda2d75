//! The elliptic family against the truth: Glaisher's twelve and their inverses, epsilon and zeta, theta functions,
//! Heuman's lambda, the third kind, Carlson's integrals, and complex arguments.
//!
//! The unit is an ulp of the truth and 2^-100 of the condition in all arguments together.

use crate::on_every_set;
use crate::ruler::{Row, bits, distance, rows, same, ulp};
use libration::elliptic::Given;
use libration::{
    Glaisher, Jacobi, JacobiComplex, Parameter, SecondKind, Theta, ThetaFunction, carlson_rc, carlson_rd,
    carlson_rf, carlson_rj, complete_pi, heuman_lambda, incomplete_pi, inverse_jacobi,
};
use std::collections::BTreeMap;

const GLAISHER: &str = include_str!("../../reference/vectors/glaisher.csv");
const INVERSE: &str = include_str!("../../reference/vectors/inverse_jacobi.csv");
const SECOND: &str = include_str!("../../reference/vectors/second_kind.csv");
const HEUMAN: &str = include_str!("../../reference/vectors/heuman.csv");
const THIRD: &str = include_str!("../../reference/vectors/third_kind.csv");
const THETA: &str = include_str!("../../reference/vectors/theta_functions.csv");
pub const COMPLEX: &str = include_str!("../../reference/vectors/jacobi_complex.csv");
const CARLSON: &str = include_str!("../../reference/vectors/carlson.csv");

/// What is promised.
pub const BOUND: f64 = 3.0;

pub fn given(row: &Row) -> Given {
    match row.text("given") {
        "m" => Given::M,
        "mc" => Given::Mc,
        "k" => Given::Modulus,
        other => panic!("{other}"),
    }
}

pub fn parameter(row: &Row) -> Parameter {
    given(row).parameter(row.hex("parameter"))
}

/// Errors by stratum and function.
#[derive(Default)]
pub struct Table(BTreeMap<(&'static str, String), (f64, String)>);

impl Table {
    fn add(&mut self, row: &Row<'static>, columns: &str, name: &str, got: f64) {
        let truth = row.truth(columns);
        let mut error =
            distance(got, truth, ulp(truth[0]) + row.decimal(&format!("cond_{columns}")) * 2f64.powi(-100));
        // An infinity or a zero has a sign of its own.
        if truth[0].is_infinite() && got == truth[0] {
            error = 0.0;
        }
        let entry = self.0.entry((row.text("stratum"), name.to_string())).or_default();
        if error > entry.0 {
            let place = ["function", "given", "parameter", "u", "x", "y", "z", "n", "p", "phi", "re", "im"];
            let text = place.iter().filter_map(|c| row.get(c)).collect::<Vec<_>>().join(" ");
            *entry = (error, format!("{text}: {got:e} {:e}", truth[0]));
        }
    }
    pub fn worst(&self) -> f64 {
        self.0.values().fold(0.0, |worst, (error, _)| f64::max(worst, *error))
    }
    /// Against the bound, and printed.
    pub fn hold(&self) {
        for ((stratum, name), (error, place)) in &self.0 {
            let place = if *error > 2.0 { place.as_str() } else { "" };
            println!("{stratum:16} {name:12} {error:8.3} {place}");
        }
        assert!(self.worst() <= BOUND, "{}", self.worst());
    }
}

/// Errors of functions that stand in columns of their own.
pub fn of_columns(
    text: &'static str,
    count: usize,
    names: &[&str],
    values: impl Fn(&Row) -> Vec<f64>,
) -> Table {
    let mut table = Table::default();
    for row in rows(text, count) {
        for (name, got) in names.iter().zip(values(&row)) {
            table.add(&row, name, name, got);
        }
    }
    table
}

/// Errors of functions that a row names.
fn of_rows(text: &'static str, count: usize, value: impl Fn(&Row) -> f64) -> Table {
    let mut table = Table::default();
    for row in rows(text, count) {
        table.add(&row, "value", row.text("function"), value(&row));
    }
    table
}

fn twelve(row: &Row) -> Vec<f64> {
    let (jacobi, u) = (Jacobi::new(parameter(row)), row.hex("u"));
    Glaisher::ALL.map(|which| jacobi.glaisher(which, u)).to_vec()
}

pub fn of_glaisher(values: impl Fn(&Row) -> Vec<f64>) -> Table {
    of_columns(GLAISHER, 649, &Glaisher::ALL.map(Glaisher::name), values)
}

fn carlson(row: &Row) -> f64 {
    let [x, y, z, p] = ["x", "y", "z", "p"].map(|name| row.hex(name));
    match row.text("function") {
        "rf" => carlson_rf(x, y, z),
        "rc" => carlson_rc(x, y),
        "rd" => carlson_rd(x, y, z),
        "rj" => carlson_rj(x, y, z, p),
        other => panic!("{other}"),
    }
}

fn of_carlson(value: impl Fn(&Row) -> f64) -> Table {
    of_rows(CARLSON, 978, value)
}

fn given_name(row: &Row) -> Glaisher {
    let name = row.text("function");
    Glaisher::ALL.into_iter().find(|which| which.name() == name).unwrap_or_else(|| panic!("{name}"))
}

fn inverse(row: &Row) -> f64 {
    inverse_jacobi(given_name(row), row.hex("x"), parameter(row))
}

fn of_inverse(value: impl Fn(&Row) -> f64) -> Table {
    of_rows(INVERSE, 2182, value)
}

fn second(row: &Row) -> Vec<f64> {
    let (second, u) = (SecondKind::new(parameter(row)), row.hex("u"));
    vec![second.epsilon(u), second.zeta(u)]
}

pub fn of_second(values: impl Fn(&Row) -> Vec<f64>) -> Table {
    of_columns(SECOND, 693, &["epsilon", "zeta"], values)
}

fn heuman(row: &Row) -> Vec<f64> {
    vec![heuman_lambda(row.hex("phi"), parameter(row))]
}

fn of_heuman(values: impl Fn(&Row) -> Vec<f64>) -> Table {
    of_columns(HEUMAN, 616, &["lambda"], values)
}

fn third(row: &Row) -> f64 {
    let (n, p) = (row.hex("n"), parameter(row));
    match row.text("function") {
        "complete_pi" => complete_pi(n, p),
        "incomplete_pi" => incomplete_pi(n, row.hex("phi"), p),
        other => panic!("{other}"),
    }
}

fn of_third(value: impl Fn(&Row) -> f64) -> Table {
    of_rows(THIRD, 914, value)
}

fn thetas(row: &Row) -> Vec<f64> {
    let theta = match row.text("given") {
        "q" => Theta::from_nome(row.hex("parameter")),
        _ => Theta::from_parameter(parameter(row)),
    };
    let z = row.hex("z");
    ThetaFunction::ALL.map(|which| theta.value(which, z)).to_vec()
}

pub fn of_theta(values: impl Fn(&Row) -> Vec<f64>) -> Table {
    of_columns(THETA, 534, &["theta1", "theta2", "theta3", "theta4"], values)
}

fn complex(row: &Row) -> Vec<f64> {
    let values = JacobiComplex::new(parameter(row)).values(row.hex("re"), row.hex("im"));
    [values.sn, values.cn, values.dn].map(|value| [value.re, value.im]).concat()
}

fn of_complex(values: impl Fn(&Row) -> Vec<f64>) -> Table {
    of_columns(COMPLEX, 575, &["sn_re", "sn_im", "cn_re", "cn_im", "dn_re", "dn_im"], values)
}

/// Too large in the fourth last bit.
pub fn nudged(value: f64) -> f64 {
    value * (1.0 + 8.0 * f64::EPSILON)
}

pub fn spoiled(values: Vec<f64>, with: impl Fn(f64) -> f64) -> Vec<f64> {
    values.into_iter().map(with).collect()
}

#[test]
fn glaisher_on_every_instruction_set() {
    on_every_set(|_| {
        of_glaisher(twelve).hold();
    });
    assert!(of_glaisher(|row| spoiled(twelve(row), nudged)).worst() > BOUND);
    assert!(of_glaisher(|row| spoiled(twelve(row), f64::abs)).worst() > BOUND);
    // The quotient of two rounded values cannot tell a pole from its neighbour, nor 1/0 from 1/-0.
    assert!(
        of_glaisher(|row| {
            let mut values = twelve(row);
            values[3] = 1.0 / (values[0] + 0.0);
            values
        })
        .worst()
            > BOUND
    );
}

#[test]
fn glaisher_over_lanes_is_the_scalar_bit_for_bit() {
    let u: Vec<f64> =
        (0..61).map(|i| f64::from(i * i) * 0.37 - 200.0).chain([0.0, -0.0, 1e-300, f64::INFINITY]).collect();
    for m in [-3.0, 0.0, 0.3, 0.9, 1.0, 2.5] {
        on_every_set(|set| {
            let jacobi = Jacobi::new(Parameter::from_m(m));
            for which in Glaisher::ALL {
                let mut out = vec![0.0; u.len()];
                jacobi.glaisher_into(which, &u, &mut out);
                for (u, got) in u.iter().zip(&out) {
                    assert_eq!(bits(*got), bits(jacobi.glaisher(which, *u)), "{set:?} {which:?} {m} {u}");
                }
            }
        });
    }
}

#[test]
fn inverses() {
    of_inverse(inverse).hold();
    assert!(of_inverse(|row| nudged(inverse(row))).worst() > BOUND);
    assert!(of_inverse(|row| inverse(row).abs()).worst() > BOUND);
    // The complement thrown away.
    let rounded = |row: &Row| Parameter::from_m(parameter(row).m());
    assert!(of_inverse(|row| inverse_jacobi(given_name(row), row.hex("x"), rounded(row))).worst() > BOUND);
}

#[test]
fn second_kind() {
    of_second(second).hold();
    assert!(of_second(|row| spoiled(second(row), nudged)).worst() > BOUND);
    // Zeta by its definition cancels.
    assert!(
        of_second(|row| {
            let [epsilon, zeta] = [second(row)[0], second(row)[1]];
            let p = parameter(row);
            let formed = epsilon - row.hex("u") * (libration::complete_e(p) / libration::complete_k(p));
            vec![epsilon, if zeta.is_nan() { zeta } else { formed }]
        })
        .worst()
            > BOUND
    );
}

#[test]
fn theta_functions() {
    of_theta(thetas).hold();
    assert!(of_theta(|row| spoiled(thetas(row), nudged)).worst() > BOUND);
    assert!(of_theta(|row| spoiled(thetas(row), f64::abs)).worst() > BOUND);
    // theta_4 for theta_3, and a NaN that becomes a number.
    assert!(of_theta(|row| [0, 1, 3, 2].map(|i| thetas(row)[i]).to_vec()).worst() > BOUND);
    assert!(
        of_theta(|row| spoiled(thetas(row), |value| if value.is_nan() { 0.0 } else { value })).worst()
            > BOUND
    );
}

#[test]
fn complex_arguments() {
    of_complex(complex).hold();
    assert!(of_complex(|row| spoiled(complex(row), nudged)).worst() > BOUND);
    assert!(of_complex(|row| spoiled(complex(row), f64::abs)).worst() > BOUND);
    // A small part with the absolute digits of the large one.
    assert!(
        of_complex(|row| {
            let mut values = complex(row);
            values[1] = (values[1] + 1.0) - 1.0;
            values
        })
        .worst()
            > BOUND
    );
}

#[test]
fn lambda() {
    of_heuman(heuman).hold();
    assert!(of_heuman(|row| spoiled(heuman(row), nudged)).worst() > BOUND);
    assert!(of_heuman(|row| spoiled(heuman(row), f64::abs)).worst() > BOUND);
}

#[test]
fn third_kind() {
    of_third(third).hold();
    assert!(of_third(|row| nudged(third(row))).worst() > BOUND);
    assert!(of_third(|row| third(row).abs()).worst() > BOUND);
}

#[test]
fn carlson_integrals() {
    of_carlson(carlson).hold();
    assert!(of_carlson(|row| nudged(carlson(row))).worst() > BOUND);
    assert!(of_carlson(|row| carlson(row).abs()).worst() > BOUND);
}

/// What stands at the ends: signs of zero, poles, infinities, NaN.
#[test]
fn ends_of_the_domains() {
    let same = |got: f64, expected: f64| {
        assert!(same(got, expected), "{got} {expected}");
    };
    let (inf, nan) = (f64::INFINITY, f64::NAN);
    for m in [-1e300, -2.0, 0.0, 0.3, 1.0, 7.0, 1e300] {
        let p = Parameter::from_m(m);
        let (jacobi, second) = (Jacobi::new(p), SecondKind::new(p));
        for zero in [0.0, -0.0] {
            for which in [Glaisher::Sn, Glaisher::Sc, Glaisher::Sd] {
                same(jacobi.glaisher(which, zero), zero);
                same(inverse_jacobi(which, zero, p), zero);
            }
            for which in [Glaisher::Ns, Glaisher::Cs, Glaisher::Ds] {
                same(jacobi.glaisher(which, zero), 1.0 / zero);
                same(inverse_jacobi(which, 1.0 / zero, p), zero);
            }
            same(second.epsilon(zero), zero);
            same(second.zeta(zero), if m > 1.0 { nan } else { zero });
            same(incomplete_pi(0.5, zero, p), zero);
        }
        for which in Glaisher::ALL {
            same(jacobi.glaisher(which, nan), nan);
            same(inverse_jacobi(which, nan, p), nan);
            if m != 1.0 {
                same(jacobi.glaisher(which, inf), nan);
            }
        }
        if m != 1.0 {
            same(second.epsilon(-inf), -inf);
        }
        same(JacobiComplex::new(p).values(nan, 0.0).sn.re, nan);
        same(JacobiComplex::new(p).values(0.0, inf).sn.re, nan);
    }
    let one = Parameter::from_m(1.0);
    let limit = |which| Jacobi::new(one).glaisher(which, -inf);
    same(limit(Glaisher::Sn), -1.0);
    same(limit(Glaisher::Nc), inf);
    same(limit(Glaisher::Sc), -inf);
    same(limit(Glaisher::Cd), 1.0);
    same(SecondKind::new(one).epsilon(-inf), -1.0);
    same(SecondKind::new(one).zeta(inf), 1.0);
    same(heuman_lambda(-inf, Parameter::from_m(0.5)), -inf);
    same(heuman_lambda(0.5, Parameter::from_m(-0.5)), nan);
    let unknown = Parameter::from_m(nan);
    same(SecondKind::new(unknown).epsilon(1.0), nan);
    same(SecondKind::new(unknown).zeta(1.0), nan);
    same(complete_pi(0.5, unknown), nan);
    same(heuman_lambda(0.5, unknown), nan);
    same(Theta::from_parameter(unknown).value(ThetaFunction::Three, 0.5), nan);
    same(Theta::from_nome(0.1).value(ThetaFunction::Three, inf), nan);
    for which in Glaisher::ALL {
        for u in [1.0, 0.0, -1e-300] {
            same(Jacobi::new(unknown).glaisher(which, u), nan);
        }
    }
    same(inverse_jacobi(Glaisher::Sc, 1.0, unknown), nan);
    same(JacobiComplex::new(unknown).values(1.0, 1.0).dn.im, nan);
    // Infinity against zero.
    same(carlson_rc(inf, 0.0), nan);
    same(carlson_rd(inf, 1.0, 0.0), nan);
    same(carlson_rj(inf, 1.0, 1.0, 0.0), nan);
    same(carlson_rf(inf, 0.0, 0.0), nan);
    same(carlson_rj(0.0, 0.0, 1.0, -1.0), nan);
}

//! The nine of Glaisher's functions beside sn, cn, dn of a complex argument, and the parameter of a nome, against the truth.
//!
//! The unit is an ulp of the truth and 2^-100 of the condition in all arguments together, for each part apart.

use crate::ruler::{Row, rows, same, ulp};
use crate::vectors_elliptic_family::{BOUND, COMPLEX, Table, nudged, of_columns, parameter, spoiled};
use libration::{Glaisher, JacobiComplex, Parameter, nome, parameter_of_nome};

const GLAISHER_COMPLEX: &str = include_str!("../../reference/vectors/glaisher_complex.csv");
const FROM_NOME: &str = include_str!("../../reference/vectors/from_nome.csv");

/// The nine that are not in `jacobi_complex.csv`.
fn nine_complex(row: &Row) -> Vec<f64> {
    let jacobi = JacobiComplex::new(parameter(row));
    let values = NINE.map(|which| jacobi.glaisher(which, row.hex("re"), row.hex("im")));
    values.map(|value| [value.re, value.im]).concat()
}

const NINE: [Glaisher; 9] = {
    use Glaisher::{Cd, Cs, Dc, Ds, Nc, Nd, Ns, Sc, Sd};
    [Ns, Nc, Nd, Sc, Cs, Sd, Ds, Cd, Dc]
};

fn of_nine_complex(values: impl Fn(&Row) -> Vec<f64>) -> Table {
    let names = NINE.map(|which| ["re", "im"].map(|part| format!("{}_{part}", which.name()))).concat();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    of_columns(GLAISHER_COMPLEX, 190, &names, values)
}

fn of_from_nome(values: impl Fn(&Row) -> Vec<f64>) -> Table {
    of_columns(FROM_NOME, 98, &["m", "mc"], values)
}

fn from_nome(row: &Row) -> Vec<f64> {
    <[f64; 2]>::from(parameter_of_nome(row.hex("q"))).to_vec()
}

#[test]
fn quotients_of_complex_arguments() {
    of_nine_complex(nine_complex).hold();
    assert!(of_nine_complex(|row| spoiled(nine_complex(row), nudged)).worst() > BOUND);
    assert!(of_nine_complex(|row| spoiled(nine_complex(row), f64::abs)).worst() > BOUND);
    // The twelve by one door, bit for bit.
    for row in rows(COMPLEX, 575) {
        let jacobi = JacobiComplex::new(parameter(&row));
        let (re, im) = (row.hex("re"), row.hex("im"));
        let three = jacobi.values(re, im);
        for (which, value) in
            [Glaisher::Sn, Glaisher::Cn, Glaisher::Dn].into_iter().zip([three.sn, three.cn, three.dn])
        {
            let quotient = jacobi.glaisher(which, re, im);
            assert!(same(quotient.re, value.re) && same(quotient.im, value.im));
        }
    }
}

#[test]
fn parameters_of_nomes() {
    of_from_nome(from_nome).hold();
    assert!(of_from_nome(|row| spoiled(from_nome(row), nudged)).worst() > BOUND);
    // m alone has no digits of the complement next to 1.
    let subtracted = |row: &Row| {
        let (m, _) = parameter_of_nome(row.hex("q"));
        vec![m, 1.0 - m]
    };
    assert!(of_from_nome(subtracted).worst() > BOUND);
    // As a parameter the same, up to where it has its digits.
    for row in rows(FROM_NOME, 98) {
        let q = row.hex("q");
        let p = Parameter::from_nome(q);
        if q.abs() <= 0.985 {
            assert_eq!((p.m(), p.mc()), parameter_of_nome(q), "{q}");
            assert!((nome(p) - q).abs() <= 4.0 * ulp(q), "{q} {}", nome(p));
        } else if q.is_nan() || q.abs() > 0.986 {
            assert!(p.m().is_nan(), "{q}");
        }
    }
}

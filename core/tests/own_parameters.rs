//! Functions of columns whose rows bring a parameter each: the same bits wherever a row stands, and the digits of the
//! functions that are set up for one parameter.

use crate::on_every_set;
use crate::ruler::{distance, row_count, same, ulp};
use libration::elliptic::{
    Given, glaisher_into, jacobi_epsilon_into, jacobi_into, jacobi_zeta_into, theta_into, theta_of_nome_into,
};
use libration::{
    Glaisher, Jacobi, JacobiValues, Parameter, SecondKind, Theta, ThetaFunction, complete_e, complete_k,
};

const GIVEN: [Given; 3] = [Given::M, Given::Mc, Given::Modulus];

/// Numbers in [0, 1), the same on every machine.
struct Draw(u64);

impl Draw {
    fn part(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 * 2f64.powi(-53)
    }
    fn power(&mut self, least: f64, most: f64) -> f64 {
        10f64.powf(least + (most - least) * self.part())
    }
}

/// Rows that were wrong once: next to zeros beside m = 1/2, and so many periods away that their number rounds to a neighbour.
const ONCE_WRONG: [[f64; 2]; 5] = [
    [1.854_074_677_301_610_1, 0.500_000_000_000_281_2],
    [-33.373_346_262_558_41, 0.500_000_135_813_495],
    [51.914_090_964_438_806, 0.500_000_000_000_013_8],
    [-1.752_602_067_206_696_6, -2.047_690_877_988_865e33],
    [9.567_637_723_303_447, -2.332_037_977_166_693e31],
];

/// Parameters of every class, and what the lanes leave out; arguments next to the zeros and poles, and far away.
fn mixed(count: u32) -> [Vec<f64>; 2] {
    let mut draw = Draw(16);
    let mut columns = [Vec::new(), Vec::new()];
    for i in 0..count as usize {
        if let Some([u, value]) = ONCE_WRONG.get(i) {
            columns[0].push(*u);
            columns[1].push(*value);
            continue;
        }
        let value = match i % 9 {
            0 => draw.part(),
            1 => 10.0 * draw.part() - 5.0,
            2 => draw.power(-200.0, 0.0),
            3 => 1.0 - draw.power(-16.0, 0.0),
            4 => draw.power(-20.0, 20.0),
            5 => -draw.power(-20.0, 199.0),
            6 => draw.power(-308.0, 308.0),
            7 => [0.0, -0.0, 1.0, -1.0, 0.5, 2.0, f64::NAN, f64::INFINITY, f64::MAX][i / 9 % 9],
            _ => 0.5 + draw.power(-17.0, -1.0),
        };
        let quarter = complete_k(Parameter::from_m(value));
        let quarter = if quarter.is_finite() { quarter } else { 1.0 };
        let near = 1.0 + (draw.part() - 0.5) * draw.power(-17.0, 0.0);
        let u = match i / 81 % 7 {
            0 => 20.0 * draw.part() - 10.0,
            1 => quarter * near,
            2 => quarter * near * (60.0 * draw.part() - 30.0).round(),
            3 => draw.power(-300.0, 20.0),
            4 => [0.0, -0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300][i % 6],
            5 => quarter * draw.power(0.0, 16.5),
            _ => quarter * (2.0 * draw.part() - 1.0),
        };
        columns[0].push(u);
        columns[1].push(value);
    }
    columns
}

/// sn, cn, dn, am, epsilon, zeta and the twelve.
const COUNT: usize = 18;

fn all_of_them(given: Given, arguments: [&[f64]; 2]) -> [Vec<f64>; COUNT] {
    let mut columns = [(); COUNT].map(|()| vec![7.0; arguments[0].len()]);
    let [a, b, c, d, epsilon, zeta, twelve @ ..] = &mut columns;
    jacobi_into(given, arguments, [a, b, c, d]);
    jacobi_epsilon_into(given, arguments, epsilon);
    jacobi_zeta_into(given, arguments, zeta);
    for (column, which) in twelve.iter_mut().zip(Glaisher::ALL) {
        glaisher_into(given, which, arguments, column);
    }
    columns
}

#[test]
fn a_value_does_not_depend_on_its_place() {
    let columns = mixed(1300);
    let [u, values] = columns.each_ref().map(Vec::as_slice);
    on_every_set(|set| {
        for given in GIVEN {
            let whole = all_of_them(given, [u, values]);
            for (from, length) in (0..49).map(|i| (17 * i, i)).chain([(1, 600), (513, 700)]) {
                let part = all_of_them(given, [&u[from..from + length], &values[from..from + length]]);
                for (whole, part) in whole.iter().zip(&part) {
                    for (i, value) in part.iter().enumerate() {
                        assert!(same(*value, whole[from + i]), "{set:?} {given:?} {} {}", u[i], values[i]);
                    }
                }
            }
        }
    });
}

/// The slopes of them by u, from the first three.
fn slopes(parameter: Parameter, [sn, cn, dn]: [f64; 3]) -> [f64; COUNT] {
    let (m, mc) = (parameter.m(), parameter.mc());
    // For small m dn^2 - E/K cancels, and zeta is m/4 sin 2u.
    let of_zeta = if m.abs() < 1e-6 {
        m / 2.0 * (cn * cn - sn * sn)
    } else {
        dn * dn - complete_e(parameter) / complete_k(parameter)
    };
    let quotients = [
        cn * dn,
        sn * dn,
        m * sn * cn,
        cn * dn / (sn * sn),
        sn * dn / (cn * cn),
        m * sn * cn / (dn * dn),
        dn / (cn * cn),
        dn / (sn * sn),
        cn / (dn * dn),
        cn / (sn * sn),
        mc * sn / (dn * dn),
        mc * sn / (cn * cn),
    ];
    let mut slopes = [0.0; COUNT];
    slopes[..6].copy_from_slice(&[cn * dn, sn * dn, m * sn * cn, dn, dn * dn, of_zeta]);
    slopes[6..].copy_from_slice(&quotients);
    slopes
}

/// Worst distance of the columns from the functions of one parameter, in ulps eased by 2^-100 of the condition.
fn apart(given: Given, [u, values]: [&[f64]; 2], found: &[Vec<f64>; COUNT]) -> f64 {
    let mut worst = 0.0;
    for (row, (u, value)) in u.iter().zip(values).enumerate() {
        let jacobi = Jacobi::new(given.parameter(*value));
        let JacobiValues { sn, cn, dn, am, .. } = jacobi.values(*u);
        let second = SecondKind::new(given.parameter(*value));
        let (epsilon, zeta) = (second.epsilon(*u), second.zeta(*u));
        let slopes = slopes(given.parameter(*value), [sn, cn, dn]);
        let known =
            [&[sn, cn, dn, am, epsilon, zeta][..], &Glaisher::ALL.map(|which| jacobi.glaisher(which, *u))]
                .concat();
        for (column, (known, slope)) in found.iter().zip(known.into_iter().zip(slopes)) {
            let ease = (u * slope * 2f64.powi(-100)).abs();
            let ease = if ease.is_finite() { ease } else { 0.0 };
            worst = f64::max(worst, distance(column[row], [known, 0.0], ulp(known) + ease));
        }
    }
    worst
}

#[test]
fn the_digits_of_one_parameter() {
    let columns = mixed(row_count(10_000));
    let [u, values] = columns.each_ref().map(Vec::as_slice);
    on_every_set(|set| {
        for given in GIVEN {
            let mut found = all_of_them(given, [u, values]);
            let worst = apart(given, [u, values], &found);
            assert!(worst <= 3.0, "{set:?} {given:?} {worst}");
            found[COUNT - 1][9] *= 1.0 + 4.0 * f64::EPSILON;
            assert!(apart(given, [u, values], &found) > 3.0);
        }
    });
}

/// Nomes of both series and signs and at the seam between them; z next to the zeros, and far away.
fn nomes(count: u32) -> [Vec<f64>; 2] {
    let mut draw = Draw(20);
    let mut columns = [Vec::new(), Vec::new()];
    for i in 0..count as usize {
        let q = match i % 6 {
            0 => draw.part(),
            1 => 2.0 * draw.part() - 1.0,
            2 => draw.power(-320.0, 0.0),
            3 => 1.0 - draw.power(-16.0, 0.0),
            4 => 0.0432 + 1e-3 * (draw.part() - 0.5),
            _ => [0.0, -0.0, 1.0, -1.0, 2.0, f64::NAN, f64::INFINITY][i / 6 % 7],
        };
        let near = 1.0 + (draw.part() - 0.5) * draw.power(-17.0, 0.0);
        let z = match i / 42 % 5 {
            0 => 20.0 * draw.part() - 10.0,
            1 => std::f64::consts::FRAC_PI_2 * near * (60.0 * draw.part() - 30.0).round(),
            2 => draw.power(-300.0, 20.0),
            3 => [0.0, -0.0, f64::NAN, f64::INFINITY, 1e300][i % 5],
            _ => std::f64::consts::FRAC_PI_2 * draw.part(),
        };
        columns[0].push(z);
        columns[1].push(q);
    }
    columns
}

/// By the nome, and by what makes one.
fn of_thetas(which: ThetaFunction, given: Option<Given>, arguments: [&[f64]; 2]) -> Vec<f64> {
    let mut values = vec![7.0; arguments[0].len()];
    match given {
        Some(given) => theta_into(given, which, arguments, &mut values),
        None => theta_of_nome_into(which, arguments, &mut values),
    }
    values
}

#[test]
fn theta_functions_of_rows() {
    let columns = nomes(row_count(4000));
    let [z, nomes] = columns.each_ref().map(Vec::as_slice);
    let [_, parameters] = mixed(row_count(4000));
    on_every_set(|set| {
        for given in [None, Some(Given::M), Some(Given::Mc), Some(Given::Modulus)] {
            let values = if given.is_none() { nomes } else { &parameters };
            for which in ThetaFunction::ALL {
                let found = of_thetas(which, given, [z, values]);
                for (from, length) in (0..33).map(|i| (17 * i, i)).chain([(1, 600), (513, 700)]) {
                    let rows = from..from + length;
                    let part = of_thetas(which, given, [&z[rows.clone()], &values[rows.clone()]]);
                    let whole = &found[rows];
                    assert!(
                        part.iter().zip(whole).all(|(a, b)| same(*a, *b)),
                        "{set:?} {given:?} {from} {length}"
                    );
                }
                let mut worst: f64 = 0.0;
                for ((z, value), found) in z.iter().zip(values).zip(&found) {
                    let theta = given.map_or_else(
                        || Theta::from_nome(*value),
                        |given| Theta::from_parameter(given.parameter(*value)),
                    );
                    let known = theta.value(which, *z);
                    // 2^-100 of the condition in z, from the change by a small part of it.
                    let change = (theta.value(which, z * (1.0 + 1e-9)) - known).abs();
                    let ease = if change.is_finite() { change * 1e9 * 2f64.powi(-100) } else { 0.0 };
                    worst = worst.max(distance(*found, [known, 0.0], ulp(known) + ease));
                }
                assert!(worst <= 3.0, "{set:?} {given:?} {which:?} {worst}");
            }
        }
    });
}

#[test]
#[should_panic(expected = "different lengths")]
fn lengths_must_agree() {
    glaisher_into(Given::M, Glaisher::Sn, [&[0.0, 1.0], &[0.5]], &mut [0.0; 2]);
}

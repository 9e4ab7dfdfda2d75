//! Elliptic functions and integrals at the ends of the range of doubles. The values are those of mpmath 1.4 with 400 digits and
//! more, by the calls in the comments, or of Arb (python-flint) where the comment says so.

use libration::{
    Glaisher, Jacobi, Parameter, SecondKind, Theta, ThetaFunction, carlson_rc, carlson_rj, complete_e,
    complete_k, complete_pi, heuman_lambda, incomplete_e, incomplete_f, incomplete_pi, inverse_jacobi, nome,
};

/// Within a few units in the last place.
fn close(got: f64, truth: f64) {
    assert!((got - truth).abs() <= 3.0 * f64::EPSILON * truth.abs(), "{got:e} {truth:e}");
}

fn m(m: f64) -> Parameter {
    Parameter::from_m(m)
}

/// Beyond 2^100 half periods there is no phase: NaN or the mean growth, at once.
#[test]
fn far_beyond_the_last_half_period_everything_ends() {
    for (parameter, u) in [(-1e66, 1.0), (-1e40, 1e40), (-f64::MAX, 1.0), (-1e16, f64::MAX), (0.5, f64::MAX)]
    {
        let second = SecondKind::new(m(parameter));
        assert!(second.zeta(u).is_nan() && second.zeta(-u).is_nan());
        // u E/K by mpmath: ellipe(m)/ellipk(m)*u.
        let mean = complete_e(m(parameter)) / complete_k(m(parameter)) * u;
        assert!((second.epsilon(u) - mean).abs() <= 1e-15 * mean.abs() || mean.is_infinite());
        assert!(Jacobi::new(m(parameter)).glaisher(Glaisher::Sd, u).is_nan());
    }
    // ellipe(-1e66)/ellipk(-1e66)
    close(SecondKind::new(m(-1e66)).epsilon(1.0), 1.292463860892263e+64);
}

/// Arguments so far apart that duplication of R_J takes a thousand steps: elliprj(1, 2, 3, 1e300).
#[test]
fn a_distant_last_argument_of_rj_ends() {
    close(carlson_rj(1.0, 2.0, 3.0, 1e300), 2.1808378064067245e-300);
    close(carlson_rj(5e-324, 5e-324, 5e-324, f64::MAX), 7.5078116069366293e-147);
}

/// phi - n pi and n in 1000 digits: F = 2 n K + F(phi - n pi) by ellipf, ellipk, and so on.
#[test]
fn angles_of_more_turns_than_a_double_counts() {
    let phi = 2f64.powi(116);
    close(incomplete_f(phi, m(0.5)), 9.805886054835829e34);
    close(incomplete_f(-phi, m(0.5)), -9.805886054835829e34);
    close(incomplete_e(phi, m(0.5)), 7.1433260808523224e+34);
    close(incomplete_pi(0.25, phi, m(0.5)), 1.1464170630317036e+35);
    close(heuman_lambda(phi, m(0.5)), 5.2888301506325595e+34);
    close(incomplete_f(1e300, m(-1.0)), 8.3462684167407323e+299);
    close(incomplete_f(f64::MAX, m(0.0)), f64::MAX);
    close(incomplete_e(-f64::MAX, m(-5e-324)), -f64::MAX);
    assert_eq!(incomplete_f(f64::MAX, m(0.9)), f64::INFINITY);
}

/// One duplication of exponents more, and steps through numbers beyond the range.
#[test]
fn the_largest_parameters() {
    let least = m(-f64::MAX);
    close(complete_k(least), 2.6572401146362278e-152);
    close(complete_e(least), 1.3407807929942596e+154);
    close(nome(least), -0.98624448247250765);
    close(incomplete_e(1.3, m(-1e308)), 7.3250117137541264e153);
    close(incomplete_e(1.5707963, m(-3.5e295)), 5.91607962457887e+147);
    // The double below asin(1/sqrt(m)).
    close(incomplete_f(7.458340731200206e-155, m(f64::MAX)), 1.171553408843843e-154);
    let jacobi = Jacobi::new(least).values(1e-152);
    close(jacobi.sn, 6.323859439590265e-97);
    close(jacobi.am, 6.323859439590265e-97);
}

/// k^2 and its nome are below the range, their fourth root is not: jtheta(1, 0.7, qfrom(k=...)).
#[test]
fn moduli_whose_square_is_below_the_range() {
    let tiny = Theta::from_parameter(Parameter::from_modulus(1e-162));
    close(tiny.value(ThetaFunction::One, 0.7), 6.4421768723769100e-82);
    close(tiny.value(ThetaFunction::Two, 0.7), 7.6484218728448844e-82);
    close(Theta::from_parameter(m(5e-324)).value(ThetaFunction::Two, 0.0), 1.4908919308538354e-81);
    close(Theta::from_nome(5e-324).value(ThetaFunction::One, 0.7), 1.9209179032319868e-81);
}

/// The exact end of a range: arcnd(1/kc | m) = K.
#[test]
fn the_last_value_of_an_inverse() {
    let p = Parameter::from_mc(2f64.powi(-108));
    close(inverse_jacobi(Glaisher::Nd, 2f64.powi(54), p), 38.816242111356937);
    assert!(inverse_jacobi(Glaisher::Nd, 2f64.powi(54) * (1.0 + f64::EPSILON), p).is_nan());
    close(inverse_jacobi(Glaisher::Dn, 2f64.powi(-54), p), 38.816242111356937);
}

/// m and n next to 1, and phi next to the end of the range: d^2 = c^2 + mc s^2 is 1e-24.
#[test]
fn next_to_one_the_third_kind_keeps_the_digits_of_the_complements() {
    close(incomplete_pi(-1.0, 1.5707963167948964, Parameter::from_mc(-1e-16)), 10.29608115858961);
    let n = 1.0 + f64::EPSILON;
    close(incomplete_pi(n, 1.5707963118937356, Parameter::from_mc(1e-16)), 33335661341906691.0);
}

/// Arb, by the formulas of reference/integrals.py and family.py.
#[test]
fn the_third_kind_and_carlson_at_the_largest_doubles() {
    let (least, most) = (m(-f64::MAX), m(f64::MAX));
    close(complete_pi(-f64::MAX, least), 7.458340731200207e-155);
    close(complete_pi(1.0 - f64::EPSILON / 2.0, least), 1.1118802528273103e-146);
    close(incomplete_pi(-1.0, 1.0, least), 2.6502052148243773e-152);
    close(incomplete_pi(f64::MAX, 1.0, least), 4.648226193249911e-155);
    close(incomplete_pi(f64::MAX, f64::MAX, least), 5.319648495704459e153);
    close(incomplete_pi(f64::MAX, 3.7291703656001034e-155, most), 4.306075028866389e-155);
    close(SecondKind::new(most).epsilon(5.857767112277025e-155), 4.7934687389385644e-155);
    close(carlson_rj(0.0, 5e-324, f64::MAX, -1.0), -8.343940749071736e-152);
    close(carlson_rj(5e-324, 1.0, f64::MAX, -5e-324), 62735906.82290711);
    close(carlson_rc(f64::MAX, -5e-324), 5.428214241961166e-152);
}

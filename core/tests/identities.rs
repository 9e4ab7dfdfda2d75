//! Identities of the elliptic functions, and both sides of the seams of their evaluation.

use libration::{Jacobi, Parameter, complete_e, complete_k, incomplete_e, incomplete_f, nome};
use std::f64::consts::{FRAC_PI_2, PI};

fn close(a: f64, b: f64, ulps: f64) -> bool {
    (a - b).abs() <= ulps * f64::EPSILON * a.abs().max(b.abs())
}

const PARAMETERS: [f64; 9] = [-1e6, -2.0, -1e-3, 0.0, 0.3, 0.5, 0.75, 0.999, 1.0];

#[test]
fn squares_and_amplitude() {
    for m in PARAMETERS {
        let jacobi = Jacobi::new(Parameter::from_m(m));
        for i in -40..40 {
            let u = 0.173 * f64::from(i);
            let (sn, cn, dn, am) = jacobi.values(u);
            assert!(close(sn * sn + cn * cn, 1.0, 4.0));
            assert!((dn * dn + m * sn * sn - 1.0).abs() <= 4.0 * f64::EPSILON * dn.mul_add(dn, 1.0));
            assert!(
                (am.sin() - sn).abs() < 1e-15 * am.abs().max(1.0)
                    && (am.cos() - cn).abs() < 1e-15 * am.abs().max(1.0)
            );
        }
    }
}

#[test]
fn addition_theorem() {
    for m in [0.0, 0.2, 0.5, 0.5000001, 0.9, 0.999_999] {
        let jacobi = Jacobi::new(Parameter::from_m(m));
        for (u, v) in [(0.3, 0.4), (1.1, 0.7), (2.0, -3.0), (5.0, 8.0)] {
            let (s, c, d, _) = jacobi.values(u);
            let (s1, c1, d1, _) = jacobi.values(v);
            let below = 1.0 - m * s * s * s1 * s1;
            let sum = jacobi.values(u + v);
            assert!((sum.0 * below - (s * c1 * d1 + s1 * c * d)).abs() < 2e-15, "{m} {u} {v}");
            assert!((sum.1 * below - (c * c1 - s * d * s1 * d1)).abs() < 2e-15, "{m} {u} {v}");
        }
    }
}

#[test]
fn legendre_relation_and_inverses() {
    for mc in [1e-12, 1e-3, 0.25, 0.5, 0.6, 0.99] {
        let (p, q) = (Parameter::from_mc(mc), Parameter::from_m(mc));
        let relation =
            complete_e(p) * complete_k(q) + complete_e(q) * complete_k(p) - complete_k(p) * complete_k(q);
        assert!((relation - FRAC_PI_2).abs() < 4e-15 * complete_k(p) * complete_k(q), "{mc}");
        assert!(close(nome(p).ln() * nome(q).ln(), PI * PI, 64.0 / mc.min(1.0 - mc).sqrt().max(1e-3)));
        for phi in [-4.0, -0.3, 1e-200, 0.7, 1.5, 9.0] {
            let u = incomplete_f(phi, p);
            assert!(
                close(Jacobi::new(p).values(u).3, phi, 8.0 * u.abs().max(1.0) / (mc.sqrt() * 2.0).min(1.0)),
                "{phi} {mc}"
            );
        }
        assert!(close(incomplete_e(PI, p), 2.0 * complete_e(p), 4.0));
    }
}

#[test]
fn both_sides_of_one_half_and_of_the_folds() {
    for u in [0.1, 1.0, 10.0, 1e6] {
        let below = Jacobi::new(Parameter::from_m(0.5)).values(u);
        let above = Jacobi::new(Parameter::from_m(0.5 + f64::EPSILON / 2.0)).values(u);
        let tolerance = 4e-16 * u.max(1.0);
        assert!((below.0 - above.0).abs() < tolerance && (below.2 - above.2).abs() < tolerance);
    }
    for m in [0.1, 0.5, 0.9, 1.0 - 1e-12] {
        let jacobi = Jacobi::new(Parameter::from_m(m));
        let quarter = complete_k(Parameter::from_m(m));
        // am grows through every fold and every whole period.
        let mut last = f64::NEG_INFINITY;
        for i in -4000..4000 {
            let am = jacobi.values(f64::from(i) * quarter / 512.0).3;
            assert!(am >= last, "{m} {i}");
            last = am;
        }
        let (sn, cn, ..) = jacobi.values(quarter);
        assert_eq!(sn, 1.0);
        assert!(cn.abs() < 1e-15);
    }
}

#[test]
fn one_parameter_three_ways() {
    for k in [0.1, 0.6, 0.99, 1.5] {
        let through_k = Jacobi::new(Parameter::from_modulus(k)).values(0.7);
        let through_m = Jacobi::new(Parameter::from_m(k * k)).values(0.7);
        assert!((through_k.0 - through_m.0).abs() < 1e-15 && (through_k.2 - through_m.2).abs() < 1e-15);
    }
    assert_eq!(complete_k(Parameter::from_mc(0.25)), complete_k(Parameter::from_m(0.75)));
    assert_eq!(Parameter::from_mc(1e-300).m(), 1.0);
    assert_eq!(Parameter::from_mc(1e-300).mc(), 1e-300);
}

//! Identities of the elliptic functions, and both sides of the seams of their evaluation.

use libration::{
    Complex, Glaisher, Jacobi, JacobiComplex, JacobiComplexValues, JacobiValues, Parameter, SecondKind,
    Theta, ThetaFunction, carlson_rc, carlson_rd, carlson_rf, carlson_rj, complete_e, complete_k,
    complete_pi, heuman_lambda, incomplete_e, incomplete_f, incomplete_pi, inverse_jacobi, nome,
};
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
            let JacobiValues { sn, cn, dn, am, .. } = jacobi.values(u);
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
            let JacobiValues { sn: s, cn: c, dn: d, .. } = jacobi.values(u);
            let JacobiValues { sn: s1, cn: c1, dn: d1, .. } = jacobi.values(v);
            let below = 1.0 - m * s * s * s1 * s1;
            let sum = jacobi.values(u + v);
            assert!((sum.sn * below - (s * c1 * d1 + s1 * c * d)).abs() < 2e-15, "{m} {u} {v}");
            assert!((sum.cn * below - (c * c1 - s * d * s1 * d1)).abs() < 2e-15, "{m} {u} {v}");
            assert!((sum.dn * below - (d * d1 - m * s * c * s1 * c1)).abs() < 2e-15, "{m} {u} {v}");
            // The second kind: the same theorem for epsilon and for zeta, DLMF 22.16.27 and 22.16.34.
            let second = SecondKind::new(Parameter::from_m(m));
            let product = m * s * s1 * sum.sn;
            let [a, b, c] = [u, v, u + v].map(|u| second.epsilon(u));
            assert!((a + b - product - c).abs() < 1e-15 * (a.abs() + b.abs() + 1.0), "{m} {u} {v}");
            let [a, b, c] = [u, v, u + v].map(|u| second.zeta(u));
            assert!((a + b - product - c).abs() < 2e-15, "{m} {u} {v}");
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
                close(Jacobi::new(p).values(u).am, phi, 8.0 * u.abs().max(1.0) / (mc.sqrt() * 2.0).min(1.0)),
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
        assert!((below.sn - above.sn).abs() < tolerance && (below.dn - above.dn).abs() < tolerance);
    }
    for m in [0.1, 0.5, 0.9, 1.0 - 1e-12] {
        let jacobi = Jacobi::new(Parameter::from_m(m));
        let quarter = complete_k(Parameter::from_m(m));
        // am grows through every fold and every whole period.
        let mut last = f64::NEG_INFINITY;
        for i in -4000..4000 {
            let am = jacobi.values(f64::from(i) * quarter / 512.0).am;
            assert!(am >= last, "{m} {i}");
            last = am;
        }
        let JacobiValues { sn, cn, .. } = jacobi.values(quarter);
        assert_eq!(sn, 1.0);
        assert!(cn.abs() < 1e-15);
    }
}

#[test]
fn one_parameter_three_ways() {
    for k in [0.1, 0.6, 0.99, 1.5] {
        let through_k = Jacobi::new(Parameter::from_modulus(k)).values(0.7);
        let through_m = Jacobi::new(Parameter::from_m(k * k)).values(0.7);
        assert!((through_k.sn - through_m.sn).abs() < 1e-15 && (through_k.dn - through_m.dn).abs() < 1e-15);
    }
    assert_eq!(complete_k(Parameter::from_mc(0.25)), complete_k(Parameter::from_m(0.75)));
    assert_eq!(Parameter::from_mc(1e-300).m(), 1.0);
    assert_eq!(Parameter::from_mc(1e-300).mc(), 1e-300);
}

#[test]
fn glaisher_quotients_and_inverses() {
    for m in [-1e6, -2.0, -1e-3, 0.0, 0.3, 0.75, 0.999, 1.0, 1.5, 40.0] {
        let p = Parameter::from_m(m);
        let jacobi = Jacobi::new(p);
        // Within the first quarter of the period every function is monotone.
        let quarter = if m < 1.0 {
            complete_k(p)
        } else if m == 1.0 {
            4.0
        } else {
            complete_k(Parameter::from_m(1.0 / m)) / m.sqrt()
        };
        for i in 1..32 {
            let u = quarter * f64::from(i) / 32.0;
            let value = |which| jacobi.glaisher(which, u);
            let JacobiValues { sn: s, cn: c, dn: d, .. } = jacobi.values(u);
            assert_eq!([Glaisher::Sn, Glaisher::Cn, Glaisher::Dn].map(value), [s, c, d]);
            let pairs = [
                (Glaisher::Ns, 1.0, s),
                (Glaisher::Nc, 1.0, c),
                (Glaisher::Nd, 1.0, d),
                (Glaisher::Sc, s, c),
                (Glaisher::Cs, c, s),
                (Glaisher::Sd, s, d),
                (Glaisher::Ds, d, s),
                (Glaisher::Cd, c, d),
                (Glaisher::Dc, d, c),
            ];
            for (which, above, below) in pairs {
                assert!(close(value(which), above / below, 3.0), "{m} {u} {which:?}");
            }
            for which in Glaisher::ALL {
                let x = value(which);
                let constant = (m == 0.0 && ["dn", "nd"].contains(&which.name()))
                    || (m == 1.0 && ["cd", "dc"].contains(&which.name()));
                if constant {
                    assert_eq!(inverse_jacobi(which, x, p), 0.0);
                    continue;
                }
                // Half an ulp of x, through the slope of the inverse from a small step.
                let step = 1e-6 * u;
                let slope = (jacobi.glaisher(which, u + step) - jacobi.glaisher(which, u - step)).abs()
                    / (2.0 * step);
                let error = (inverse_jacobi(which, x, p) - u).abs();
                let allowed = f64::EPSILON * (2.0 * u + x.abs() / slope);
                assert!(error <= allowed, "{which:?} {m} {u} {error:e} {allowed:e}");
            }
        }
    }
}

#[test]
fn carlson_integrals_among_themselves() {
    for (x, y, z, p) in
        [(0.3, 1.7, 2.0, 0.9), (1e-8, 3.0, 5e6, 4.0), (2.0, 2.5, 2.2, 1e-5), (7.0, 0.1, 0.4, 1e9)]
    {
        let rj = carlson_rj;
        assert!(close(rj(x, y, z, z), carlson_rd(x, y, z), 4.0));
        assert!(close(carlson_rf(x, y, y), carlson_rc(x, y), 4.0));
        assert!(close(carlson_rc(x, x), 1.0 / x.sqrt(), 2.0));
        assert_eq!(rj(4.0 * x, 4.0 * y, 4.0 * z, 4.0 * p), rj(x, y, z, p) / 8.0);
        // DLMF 19.21.9, and duplication, 19.26.18 and 19.26.22.
        let sum = carlson_rd(x, y, z) + carlson_rd(y, z, x) + carlson_rd(z, x, y);
        assert!(close(sum, 3.0 / (x * y * z).sqrt(), 8.0));
        let [a, b, c] = [x, y, z].map(f64::sqrt);
        let shift = a * b + b * c + c * a;
        assert!(close(2.0 * carlson_rf(x + shift, y + shift, z + shift), carlson_rf(x, y, z), 8.0));
        let (alpha, beta) = (p * (a + b + c) + a * b * c, p.sqrt() * (p + shift));
        let twice = 2.0 * rj(x + shift, y + shift, z + shift, p + shift)
            + 3.0 * carlson_rc(alpha * alpha, beta * beta);
        assert!(close(twice, rj(x, y, z, p), 16.0));
        // DLMF 19.21.12, in which (p - x)(q - x) = (y - x)(z - x).
        let q = x + (y - x) * (z - x) / (p - x);
        if p > x && q > 0.0 && y > x && z > x {
            let terms = [(p - x) * rj(x, y, z, p), (q - x) * rj(x, y, z, q), -3.0 * carlson_rf(x, y, z)];
            let right = -3.0 * carlson_rc(y * z / x, p * q / x);
            let size: f64 = terms.iter().map(|term| term.abs()).sum();
            assert!(
                (terms.iter().sum::<f64>() - right).abs() < 32.0 * f64::EPSILON * size,
                "{x} {y} {z} {p}"
            );
        }
    }
}

#[test]
fn third_kind_connections() {
    for m in [0.01, 0.2, 0.7, 0.99] {
        let p = Parameter::from_m(m);
        let k = complete_k(p);
        assert!(
            close(complete_pi(0.0, p), k, 1.0) && close(complete_pi(m, p), complete_e(p) / (1.0 - m), 4.0)
        );
        for part in [0.1, 0.5, 0.9] {
            // DLMF 19.7.8 at pi/2 for m < n < 1, and the principal value beyond 1.
            let n = m + part * (1.0 - m);
            let circular = PI / 2.0 * (n / ((1.0 - n) * (n - m))).sqrt();
            let sum = complete_pi(n, p) + complete_pi(m / n, p);
            assert!(
                (sum - k - circular).abs() < 64.0 * f64::EPSILON * sum / ((1.0 - part) * part),
                "{n} {m}"
            );
            let beyond = 1.0 / part;
            let sum = complete_pi(beyond, p) + complete_pi(m / beyond, p);
            assert!((sum - k).abs() < 8.0 * f64::EPSILON * k / (1.0 - m), "{n} {m}");
            // DLMF 19.7.9 at pi/2, from n < 0 to n' between m and 1.
            let n = -3.0 * part;
            let other = (m - n) / (1.0 - n);
            let sum = (m - n) * complete_pi(n, p) + (m - other) * complete_pi(other, p);
            assert!((sum - m * k).abs() < 32.0 * f64::EPSILON * (m - n) * k / (1.0 - m).sqrt(), "{n} {m}");
        }
        for phi in [-7.0, -1.0, 0.1, 1.5, 2.0, 4.0] {
            assert!(close(incomplete_pi(0.0, phi, p), incomplete_f(phi, p), 2.0));
            for n in [-5.0, 0.5, 3.0] {
                let whole =
                    incomplete_pi(n, phi + PI, p) - incomplete_pi(n, phi, p) - 2.0 * complete_pi(n, p);
                let slope =
                    1.0 / ((1.0 - n * phi.sin().powi(2)).abs() * (1.0 - m * phi.sin().powi(2)).sqrt());
                let size = incomplete_pi(n, phi + PI, p).abs() + complete_pi(n, p).abs();
                assert!(
                    whole.abs() < 4.0 * f64::EPSILON * (size + 2.0 * (phi.abs() + PI) * slope),
                    "{n} {phi} {m}"
                );
            }
        }
    }
    // No parameter: elementary, DLMF 19.6.12.
    let flat = Parameter::from_m(0.0);
    for (n, phi) in [(-2.0, 0.7), (0.5, 1.2), (-40.0, 0.01)] {
        let root = f64::sqrt(1.0 - n);
        assert!(close(incomplete_pi(n, phi, flat), (root * phi.tan()).atan() / root, 8.0));
    }
}

#[test]
fn theta_functions_among_themselves() {
    let both_sides = [0.0432, 0.0432 + 1e-17];
    for q in [1e-300, 1e-5, 0.02, 0.3, 0.7, 0.95].into_iter().chain(both_sides) {
        let theta = Theta::from_nome(q);
        let at = |z| ThetaFunction::ALL.map(|which| theta.value(which, z));
        let [zero, t2, t3, t4] = at(0.0);
        assert_eq!(zero, 0.0);
        assert!(close(t3.powi(4), t2.powi(4) + t4.powi(4), 16.0), "{q}");
        // DLMF 20.4.6
        assert!(close(theta.value(ThetaFunction::One, 1e-30) / 1e-30, t2 * t3 * t4, 8.0), "{q}");
        for z in [-20.0, -0.4, 0.1, 0.8, 1.5, 3.0] {
            // DLMF 20.7.1, 20.7.2 and the period.
            let [a, b, c, d] = at(z);
            let squares = |left: f64, first: f64, second: f64| {
                (left - first - second).abs() <= 16.0 * f64::EPSILON * (first.abs() + second.abs())
            };
            assert!(squares((t4 * c).powi(2), (t3 * d).powi(2), -(t2 * a).powi(2)) || q < 1e-200, "{q} {z}");
            assert!(squares((t4 * d).powi(2), (t3 * c).powi(2), -(t2 * b).powi(2)) || q < 1e-200, "{q} {z}");
            let jacobi = Jacobi::new(Parameter::from_m((t2 / t3).powi(4)));
            let sn = jacobi.glaisher(Glaisher::Sn, z * t3 * t3);
            let quotient = t3 * a / (t2 * d);
            // The argument and the parameter are rounded: K/pi of their condition, and ln of the complement.
            let loose = 64.0 * f64::EPSILON * (1.0 + z.abs() * t3 * t3);
            assert!((sn - quotient).abs() < loose || q > 0.5, "{q} {z} {sn} {quotient}");
        }
    }
    let [below, above] = both_sides.map(Theta::from_nome);
    for which in ThetaFunction::ALL {
        assert!(close(below.value(which, 0.6), above.value(which, 0.6), 4.0));
    }
    for m in [0.1, 0.5, 0.9, 0.999] {
        // DLMF 20.9.1, 20.9.2
        let (p, theta) = (Parameter::from_m(m), Theta::from_parameter(Parameter::from_m(m)));
        assert!(close(PI / 2.0 * theta.value(ThetaFunction::Three, 0.0).powi(2), complete_k(p), 8.0));
        assert!(close(
            (theta.value(ThetaFunction::Two, 0.0) / theta.value(ThetaFunction::Three, 0.0)).powi(4),
            m,
            16.0
        ));
    }
}

#[test]
fn lambda_at_its_limits() {
    for phi in [-4.0, -1.3, 1e-3, 0.4, 1.5, 2.9] {
        let turns = f64::round(phi / PI);
        let sine = 2.0 * turns + (phi - turns * PI).sin();
        assert!((heuman_lambda(phi, Parameter::from_m(0.0)) - sine).abs() < 1e-15 * phi.abs().max(1.0));
        assert!(close(heuman_lambda(phi, Parameter::from_mc(0.0)), 2.0 * phi / PI, 2.0));
        for m in [1e-3, 0.3, 0.5, 0.95] {
            // Its definition by E, F, K (Byrd & Friedman 150.03), which cancels down to the size of its terms.
            let (p, q) = (Parameter::from_m(m), Parameter::from_mc(m));
            let (k, e) = (complete_k(p), complete_e(p));
            let terms = [k * incomplete_e(phi, q), e * incomplete_f(phi, q), -k * incomplete_f(phi, q)];
            let size: f64 = terms.iter().map(|term| term.abs()).sum();
            let defined = 2.0 / PI * terms.iter().sum::<f64>();
            let error = (heuman_lambda(phi, p) - defined).abs();
            assert!(error < 8.0 * f64::EPSILON * size, "{phi} {m} {error}");
            assert!(close(heuman_lambda(FRAC_PI_2, p), 1.0, 2.0));
        }
    }
}

#[test]
fn complex_arguments_on_the_axes_and_beyond() {
    for m in [-30.0, -0.5, 0.0, 0.4, 0.9, 1.0, 1.7] {
        let (p, complement) = (Parameter::from_m(m), Parameter::from_mc(m));
        let (complex, real, imaginary) = (JacobiComplex::new(p), Jacobi::new(p), Jacobi::new(complement));
        for u in [-2.0, -0.3, 0.2, 0.9, 1.3] {
            let on_the_axis = complex.values(u, 0.0);
            let JacobiValues { sn, cn, dn, .. } = real.values(u);
            for (got, expected) in [(on_the_axis.sn, sn), (on_the_axis.cn, cn), (on_the_axis.dn, dn)] {
                assert!(close(got.re, expected, 2.0) && got.im == 0.0, "{m} {u}");
            }
            // DLMF 22.6.22: sn(iy | m) = i sc(y | 1 - m), cn = nc, dn = dc.
            let JacobiComplexValues { sn, cn, dn, .. } = complex.values(0.0, u);
            let at = |which| imaginary.glaisher(which, u);
            assert!(sn.re == 0.0 && close(sn.im, at(Glaisher::Sc), 2.0), "{m} {u}");
            assert!(close(cn.re, at(Glaisher::Nc), 2.0) && close(dn.re, at(Glaisher::Dc), 2.0), "{m} {u}");
            for v in [-1.1, 0.05, 0.7] {
                // sn^2 + cn^2 = 1 and dn^2 + m sn^2 = 1 in both parts.
                let JacobiComplexValues { sn, cn, dn, .. } = complex.values(u, v);
                let square = |z: Complex| [(z.re - z.im) * (z.re + z.im), 2.0 * z.re * z.im];
                let size = |z: Complex| z.re.mul_add(z.re, z.im * z.im);
                let [s2, c2, d2] = [sn, cn, dn].map(square);
                let allowed = 8.0 * f64::EPSILON * (size(cn) + size(dn) + (1.0 + m.abs()) * size(sn));
                for (i, one) in [1.0, 0.0].into_iter().enumerate() {
                    assert!((s2[i] + c2[i] - one).abs() < allowed, "{m} {u} {v}");
                    assert!((d2[i] + m * s2[i] - one).abs() < allowed, "{m} {u} {v}");
                }
            }
        }
    }
}

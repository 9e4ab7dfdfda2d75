//! What holds for every orbit of the cubic-quintic oscillator whatever its inputs: energy, the equation itself, time
//! reversal, the cubic oscillator as the case gamma = 0, scaling by powers of two, passages, and every exact boundary.

use crate::ruler::bits;
use libration::oscillator::OscillatorRegime;
use libration::{CubicQuintic, Duffing};

/// A sequence without a library: the same numbers on every machine.
struct Sequence(u64);

impl Sequence {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
    fn any(&mut self) -> f64 {
        (2.0 * self.unit() - 1.0) * 2f64.powi((self.unit() * 8.0) as i32 - 4)
    }
}

fn orbit([u0, velocity0, alpha, beta, gamma]: [f64; 5]) -> CubicQuintic {
    CubicQuintic::new(u0, velocity0, alpha, beta, gamma).unwrap()
}

/// 12 E and the sum of the sizes of its terms.
fn energy([u, v, a, b, c]: [f64; 5]) -> (f64, f64) {
    let y = u * u;
    let terms = [6.0 * v * v, 6.0 * a * y, 3.0 * b * y * y, 2.0 * c * y * y * y];
    (terms.iter().sum(), terms.iter().map(|term| term.abs()).sum())
}

/// A time within a period, or between the escapes.
fn moment(orbit: &CubicQuintic, unit: f64) -> f64 {
    let (from, to) = (orbit.escape_time_backward().max(-5.0), orbit.escape_time().min(5.0));
    from + (to - from) * unit
}

/// Worst change of the energy over many orbits, in ulps of its terms.
fn energy_drift(motion: impl Fn(&CubicQuintic, f64) -> (f64, f64)) -> f64 {
    let mut next = Sequence(1);
    let mut worst = 0.0f64;
    for _ in 0..4000 {
        let start: [f64; 5] = core::array::from_fn(|_| next.any());
        let orbit = orbit(start);
        let t = moment(&orbit, 0.02 + 0.96 * next.unit());
        let (u, v) = motion(&orbit, t);
        let (now, size) = energy([u, v, start[2], start[3], start[4]]);
        let (then, first) = energy(start);
        let error = (now - then).abs() / (size.max(first) * f64::EPSILON);
        worst = if error.is_nan() { f64::INFINITY } else { worst.max(error) };
    }
    worst
}

#[test]
fn energy_stays() {
    let worst = energy_drift(|orbit, t| orbit.motion(t));
    println!("energy {worst}");
    assert!(worst <= 16.0, "{worst}");
    assert!(energy_drift(|orbit, t| (orbit.u(t) * (1.0 + 1e-14), orbit.velocity(t))) > 16.0);
    assert!(energy_drift(|orbit, t| (orbit.u(t), orbit.velocity(1.000001 * t))) > 16.0);
}

/// From a state of its own way an orbit comes back to its start.
#[test]
fn the_way_back_is_the_way() {
    let mut next = Sequence(2);
    for _ in 0..2000 {
        let start: [f64; 5] = core::array::from_fn(|_| next.any());
        let first = orbit(start);
        let t = 0.3 * moment(&first, 0.1 + 0.8 * next.unit());
        let (u, v) = first.motion(t);
        let second = orbit([u, v, start[2], start[3], start[4]]);
        let (u, v) = second.motion(-t);
        let size = start[0].abs().max(start[1].abs()).max(second.u0().abs()).max(second.velocity0().abs());
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * size;
        assert!(near(u, start[0]) && near(v, start[1]), "{start:?} {t} {u} {v}");
        let [ahead, now] = [second.escape_time(), first.escape_time()];
        assert!(ahead == now || (ahead + t - now).abs() <= 1e-9 * now.abs().max(t.abs()), "{start:?}");
    }
}

#[test]
fn gamma_zero_is_the_cubic_oscillator() {
    let mut next = Sequence(3);
    for k in 0..2000 {
        let [u0, v0, p, q] = core::array::from_fn(|_| next.any());
        let v0 = if k % 4 == 0 { 0.0 } else { v0 };
        let (five, three) = (orbit([u0, v0, p, q, 0.0]), Duffing::new(u0, v0, p, q).unwrap());
        assert_eq!(five.regime(), three.regime(), "{u0} {v0} {p} {q}");
        let near = |a: f64, b: f64| a == b || (a - b).abs() <= 4.0 * f64::EPSILON * b.abs();
        assert!(
            near(five.period(), three.period()),
            "{u0} {v0} {p} {q} {} {}",
            five.period(),
            three.period()
        );
        assert!(near(five.escape_time(), three.escape_time()), "{u0} {v0} {p} {q}");
        assert!(near(five.escape_time_backward(), three.escape_time_backward()));
        assert!(near(five.range().0, three.range().0) && near(five.range().1, three.range().1));
        assert!(near(five.energy(), three.energy()));
        let t = moment(&five, 0.05 + 0.9 * next.unit());
        let ((a, b), (c, d)) = (five.motion(t), three.motion(t));
        let unit = 8.0 * f64::EPSILON;
        let bounded = five.range().1.is_finite() && five.range().0.is_finite();
        let (u, v) = if bounded {
            let reach = five.range().0.abs().max(five.range().1.abs());
            (reach, reach * (p.abs() + q.abs() * reach * reach).sqrt())
        } else {
            (c.abs().max(u0.abs()), d.abs().max(v0.abs()))
        };
        assert!(
            (a - c).abs() <= unit * u && (b - d).abs() <= unit * v,
            "{u0} {v0} {p} {q} {t} {a} {c} {b} {d}"
        );
    }
}

/// u in units of 2^i, t in units of 2^-j: nothing may change.
#[test]
fn powers_of_two_change_nothing() {
    let mut next = Sequence(4);
    for k in 0..400 {
        let start: [f64; 5] = core::array::from_fn(|_| next.any());
        let (i, j) = ([0, 40, -40, 100, -100][k % 5], [60, -60, 0, 90][k % 4]);
        let [length, rate] = [2f64.powi(i), 2f64.powi(j)];
        let square = rate * rate;
        let scaled = orbit([
            start[0] * length,
            start[1] * length * rate,
            start[2] * square,
            start[3] * square * length.powi(-2),
            start[4] * square * length.powi(-4),
        ]);
        let plain = orbit(start);
        assert_eq!(plain.regime(), scaled.regime());
        assert_eq!(plain.period(), scaled.period() * rate);
        assert_eq!(plain.escape_time(), scaled.escape_time() * rate);
        let t = moment(&plain, 0.1 + 0.8 * next.unit());
        let (a, b) = plain.motion(t);
        assert_eq!((a * length, b * length * rate), scaled.motion(t / rate), "{start:?} {t}");
    }
}

#[test]
fn arrays_have_the_bits_scalars() {
    let mut next = Sequence(5);
    for _ in 0..100 {
        let one = orbit(core::array::from_fn(|_| next.any()));
        let t: Vec<f64> = (0..21).map(|_| moment(&one, 1.2 * next.unit() - 0.1)).collect();
        let [mut u, mut v, mut u2, mut v2] = [0; 4].map(|_| vec![0.0; t.len()]);
        one.u_into(&t, &mut u);
        one.velocity_into(&t, &mut v);
        one.motion_into(&t, &mut u2, &mut v2);
        for (k, t) in t.iter().enumerate() {
            let (a, b) = one.motion(*t);
            assert_eq!([one.u(*t), u[k], u2[k]].map(bits), [bits(a); 3]);
            assert_eq!([one.velocity(*t), v[k], v2[k]].map(bits), [bits(b); 3]);
        }
        assert_eq!(one.motion(0.0), (one.u0(), one.velocity0()));
    }
}

#[test]
fn passages_are_passed() {
    let mut next = Sequence(6);
    let mut found = 0;
    for _ in 0..1500 {
        let start: [f64; 5] = core::array::from_fn(|_| next.any());
        let one = orbit(start);
        let t = moment(&one, 0.05 + 0.9 * next.unit());
        let (u, v) = one.motion(t);
        // Next to a turning point a rounded u may be beyond it.
        if v.abs() < 1e-6 * u.abs() {
            continue;
        }
        let (from, to) = (moment(&one, 0.0).min(t), moment(&one, 1.0).max(t));
        let times = one.times(u, from, to).unwrap();
        let unit = 1e-10 * t.abs().max(1e-3) + 1e-13 * (u / v).abs().min(1e6);
        assert!(times.iter().any(|s| (s - t).abs() <= unit), "{start:?} {t} {u} {times:?}");
        for s in &times {
            let there = one.u(*s);
            let (_, speed) = one.motion(*s);
            let room = 1e-9 * (u.abs() + s.abs() * speed.abs()) + 1e-12;
            assert!((there - u).abs() <= room, "{start:?} {s} {there} {u}");
            found += 1;
        }
    }
    assert!(found > 2000, "{found}");
}

/// OscillatorRegime, a time, u and period (or inf) of exact boundaries whose motion is known.
#[test]
fn exact_boundaries() {
    let inf = f64::INFINITY;
    let two_pi = 2.0 * core::f64::consts::PI;
    let check = |start: [f64; 5], regime: OscillatorRegime, t: f64, u: f64, period: f64| {
        let one = orbit(start);
        assert_eq!(one.regime(), regime, "{start:?}");
        let got = one.u(t);
        let near = |a: f64, b: f64| a == b || (a - b).abs() <= 8.0 * f64::EPSILON * b.abs();
        assert!(near(got, u), "{start:?} {t} {got} {u}");
        assert!(near(one.period(), period), "{start:?} {} {period}", one.period());
    };
    // Rest everywhere that there is an equilibrium: 4 - 5 y + y^2 = 0 at y = 1, 4.
    check([0.0, 0.0, 4.0, -5.0, 1.0], OscillatorRegime::Rest, 9.0, 0.0, two_pi / 2.0);
    check([1.0, 0.0, 4.0, -5.0, 1.0], OscillatorRegime::Rest, 9.0, 1.0, inf);
    check([-2.0, 0.0, 4.0, -5.0, 1.0], OscillatorRegime::Rest, 9.0, -2.0, two_pi / 24f64.sqrt());
    check([3.0, 0.0, 0.0, 0.0, 0.0], OscillatorRegime::Rest, 9.0, 3.0, inf);
    // Linear.
    check([1.0, 0.0, 4.0, 0.0, 0.0], OscillatorRegime::Linear, 0.5, 1f64.cos(), two_pi / 2.0);
    check([1.0, 0.0, -4.0, 0.0, 0.0], OscillatorRegime::Linear, 0.5, 1f64.cosh(), inf);
    check([0.0, 2.0, -4.0, 0.0, 0.0], OscillatorRegime::Linear, 0.5, 1f64.sinh(), inf);
    check([1.0, -2.0, -4.0, 0.0, 0.0], OscillatorRegime::Linear, 0.5, (-1f64).exp(), inf);
    check([1.0, 2.0, 0.0, 0.0, 0.0], OscillatorRegime::Linear, 3.0, 7.0, inf);
    // The pure quintic at E = 0: 1/u^2 is linear.
    let pole = orbit([2.0, 8.0, 0.0, 0.0, -3.0]);
    assert_eq!((pole.regime(), pole.escape_time(), pole.u(-0.375)), (OscillatorRegime::Escape, 0.125, 1.0));
    // v = 1/u^2 = c + b e^(2t) at alpha = -1, beta = 4, gamma = -3: from 0 to 1/sqrt c = 1.
    check(
        [0.5, 0.375, -1.0, 4.0, -3.0],
        OscillatorRegime::Heteroclinic,
        1.0,
        (1.0 + 3.0 * (-2f64).exp()).powf(-0.5),
        inf,
    );
    check(
        [2.0, 6.0, -1.0, 4.0, -3.0],
        OscillatorRegime::Escape,
        -1.0,
        (1.0 - 0.75 * (-2f64).exp()).powf(-0.5),
        inf,
    );
    assert!((orbit([2.0, 6.0, -1.0, 4.0, -3.0]).escape_time() - 0.5 * (4f64 / 3.0).ln()).abs() < 1e-16);
    // Homoclinic: v = cosh^2 t, E = 0, alpha = -1, beta = 2, gamma = 0 (sech); and with a square of the time.
    check([1.0, 0.0, -1.0, 2.0, 0.0], OscillatorRegime::Homoclinic, 1.0, 1.0 / 1f64.cosh(), inf);
    check([1.0, 0.0, 0.0, -2.0, 3.0], OscillatorRegime::Homoclinic, 2.0, 0.2f64.sqrt(), inf);
    // E = 0 in a well: v = c + B cos 2t, alpha = 1, beta = -8, gamma = 9: roots v = 1 and 3.
    check([1.0, 0.0, 1.0, -8.0, 9.0], OscillatorRegime::Well, 0.25 * two_pi, 1.0 / 3f64.sqrt(), 0.5 * two_pi);
}

#[test]
fn bad_input_is_named() {
    let error = CubicQuintic::new(1.0, 0.0, 1.0, f64::NAN, 1.0).unwrap_err();
    assert_eq!(error.to_string(), "q = NaN: must be finite");
    let one = orbit([1.0, 0.0, 1.0, 1.0, 1.0]);
    assert_eq!(one.times(0.5, 1.0, 0.0).unwrap_err().argument, "stop");
    assert!(one.times(2.0, 0.0, 9.0).unwrap().is_empty());
    assert!(one.u(f64::NAN).is_nan() && one.u(f64::INFINITY).is_nan() && one.u(1e300).is_nan());
}

/// Sizes from the ends of the range: no panic, and no NaN where the truth is a number.
#[test]
fn the_range_of_doubles() {
    let sizes = [0.0, 5e-324, 1e-300, 1e-150, 1e-8, 1.0, 1e8, 1e150, 1e300, f64::MAX];
    let mut next = Sequence(7);
    for _ in 0..3000 {
        let start: [f64; 5] = core::array::from_fn(|_| {
            let size = sizes[(next.unit() * sizes.len() as f64) as usize];
            if next.unit() < 0.5 { -size } else { size }
        });
        let one = orbit(start);
        let (low, high) = one.range();
        assert!(low <= start[0] && start[0] <= high, "{start:?} {low} {high}");
        assert!(
            one.period() >= 0.0 && one.escape_time() >= 0.0 && one.escape_time_backward() <= 0.0,
            "{start:?} {one:?}"
        );
        assert_eq!(one.motion(0.0), (start[0], start[1]));
    }
}

/// Escapes past singularities that lie next to their way, and motions at three times each by Taylor series in 30 digits:
/// polynomials that overlooked them had lost up to thousands of units.
#[test]
fn escapes_past_unseen_singularities_keep_their_digits() {
    #[rustfmt::skip]
    let cases: [([f64; 5], [[f64; 3]; 3]); 5] = [
        ([-0.30429280707905226, -0.034705072355039945, -0.3953542302750317, -1.81378792570677, -1.414536819558224],
            [[0.6134023475072832, -0.36095347299157815, -0.15618600297138463],
             [1.4721656340174796, -0.6182641476822333, -0.5161570622648676],
             [2.380001108328259, -3.069316248565571, -21.872157170379147]]),
        ([-0.8702030886057743, -0.804726617452098, -0.3879429035644608, -0.7194137085736094, -0.30066746603996597],
            [[0.2554941302526073, -1.11542592465216, -1.1560857123214758],
             [0.6131859126062575, -1.7345515370026925, -2.6938541272838123],
             [0.9913172253801164, -7.114761863916224, -118.07186464776548]]),
        ([1.1561049459224448, -1.3647335404488512, -0.18420981266017566, -1.08332467292428, -0.893060265362291],
            [[1.1420653850709253, 0.5324016039228833, -0.20089544134571335],
             [2.7409569241702205, 0.5045628196381544, 0.15735514279581334],
             [4.43121369407519, 2.4994940986053518, 9.737529818056474]]),
        ([-0.45215981563433916, 0.2519213666513635, -1.6872642653881682, -1.9780359444223778, -0.4435917817062176],
            [[0.46851811823443074, -0.4315747353969487, -0.15947523932056284],
             [1.1244434837626338, -0.7793898179963086, -1.0482902123941356],
             [1.8178502987495913, -4.636245051920878, -44.28711975564286]]),
        ([1.0631456773140728, -1.2528970443069665, 0.23913184657155107, -0.8446794199679153, -0.018470370932220703],
            [[0.7507574531164372, 0.20302629954760804, -1.1324556833510269],
             [1.801817887479449, -0.9923943869421608, -1.2130971403103035],
             [2.912938918091776, -7.549214693430997, -49.99027457436033]]),
    ];
    let far = |got: f64, truth: f64| (got - truth).abs() / (truth.abs() * f64::EPSILON);
    for (state, instants) in cases {
        let orbit = orbit(state);
        for [t, u, velocity] in instants {
            let (got_u, got_velocity) = orbit.motion(t);
            assert!(far(got_u, u) <= 4.0 && far(got_velocity, velocity) <= 4.0, "{state:?} at {t}");
        }
    }
}

/// Starts so near u = 0 that k' leaves the range of its square. There u'' = u to all digits as long as u stays small, so
/// the truth is u0 cosh t + velocity0 sinh t.
#[test]
fn tiny_starts_beside_the_saddle_keep_their_digits() {
    let far = |got: f64, truth: f64| (got - truth).abs() / (truth.abs() * f64::EPSILON);
    for size in [1e-100, 1e-135, 1e-150, 1e-155, 1e-158, 1e-160, 1e-162, 1e-200, 1e-300] {
        for gamma in [-1.0, -1e-280, 1.0] {
            for beta in [0.0, -0.5] {
                for t in [1.0, 30.0, -30.0] {
                    let (cosine, sine) = (f64::cosh(t), f64::sinh(t));
                    let (u, velocity) = orbit([size, 0.0, -1.0, beta, gamma]).motion(t);
                    assert!(
                        far(u, size * cosine) <= 4.0 && far(velocity, size * sine) <= 4.0,
                        "{size} {gamma} {t}"
                    );
                    let (u, velocity) = orbit([0.0, size, -1.0, beta, gamma]).motion(t);
                    assert!(
                        far(u, size * sine) <= 4.0 && far(velocity, size * cosine) <= 4.0,
                        "{size} {gamma} {t}"
                    );
                }
            }
        }
    }
}

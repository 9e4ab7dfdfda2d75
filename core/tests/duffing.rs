//! The cubic oscillator against itself: invariants, passages, doors, the twelve forms and the pendulum.

use libration::duffing::{Regime, duffing_motion_into};
use libration::lanes::InstructionSet;
use libration::{Duffing, Form, Frequency, Glaisher, Orbit};
use std::sync::Mutex;

/// The instruction set is the whole process's: one test at a time.
static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());

/// Reproducible numbers in [0, 1).
struct Spread(u64);

impl Spread {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
    fn state(&mut self) -> [f64; 4] {
        [(); 4].map(|()| self.between(-2.0, 2.0))
    }
}

/// A start of every course, and what its regime is.
const STARTS: [(f64, f64, f64, f64, &str); 30] = [
    (0.0, 0.0, 1.0, 1.0, "rest"),
    (1.0, 0.0, -1.0, 1.0, "rest"),
    (2.0, 0.0, 4.0, -1.0, "rest"),
    (3.0, 0.0, 0.0, 0.0, "rest"),
    (1.0, 0.5, 2.0, 0.0, "linear"),
    (1.0, 0.5, -2.0, 0.0, "linear"),
    (0.5, -1.5, -2.0, 0.0, "linear"),
    (0.5, -1.0, -4.0, 0.0, "linear"),
    (0.5, -1.0, 0.0, 0.0, "linear"),
    (1.0, -0.5, 1.0, 1.0, "libration"),
    (1e-3, 0.0, 1.0, 1.0, "libration"),
    (-1.0, 1.0, -1.0, 1.0, "libration"),
    (0.0, 1e-6, -1.0, 1.0, "libration"),
    (1.0, 0.0, 0.0, 1.0, "libration"),
    (0.5, 0.3, 1.0, -1.0, "libration"),
    (1.0, 0.2, -1.0, 1.0, "well"),
    (-1e-6, 0.0, -1.0, 1.0, "well"),
    (-1.2, 0.1, -1.0, 1.0, "well"),
    (1.0, 1.0, -2.0, 0.0 + 2.0, "homoclinic"),
    (-2.0, 0.0, -2.0, 1.0, "homoclinic"),
    (0.0, 1.0, 1.0, -0.5, "heteroclinic"),
    (2.0, 2.0, 0.0, -0.5, "escape"),
    (1.0, -1.0, -0.5, -1.0, "escape"),
    (2.0, 1.0, -3.0, 1.0 - 2.0, "escape"),
    (2.0, 0.0, 1.0, -1.0, "escape"),
    (-1.5, 1.1, 1.0, -1.0, "escape"),
    (0.3, 0.1, -1.0, -1.0, "escape"),
    (0.1, 1.0, -1.0, -1.0, "escape"),
    (-0.3, 2.0, 1.0, -1.0, "escape"),
    (-3.0, -2.0, 1.0, -2.0, "escape"),
];

fn of((u0, velocity0, p, q, _): (f64, f64, f64, f64, &str)) -> Duffing {
    Duffing::new(u0, velocity0, p, q).unwrap()
}

fn energy(u: f64, v: f64, p: f64, q: f64) -> f64 {
    0.5 * v * v + 0.5 * p * u * u + 0.25 * q * u * u * u * u
}

/// Sizes of the terms of the energy.
fn energy_scale(u: f64, v: f64, p: f64, q: f64) -> f64 {
    0.5 * v * v + 0.5 * p.abs() * u * u + 0.25 * q.abs() * u * u * u * u
}

/// Largest |u| and |u'| of a bounded orbit; of two values else.
fn scales(orbit: &Duffing, u: f64, v: f64) -> [f64; 2] {
    let (low, high) = orbit.range();
    let (p, q) = (orbit.p(), orbit.q());
    let reach = low.abs().max(high.abs());
    if reach.is_infinite() {
        return [u.abs().max(orbit.u0().abs()), v.abs().max(orbit.velocity0().abs())];
    }
    let well = if p * q < 0.0 { -p / q } else { 0.0 };
    let fastest = [0.0, well].map(|square| 2.0 * orbit.energy() - p * square - 0.5 * q * square * square);
    [reach, fastest[0].max(fastest[1]).max(orbit.velocity0().powi(2)).sqrt()]
}

#[test]
fn regimes_are_what_they_are() {
    for start in STARTS {
        assert_eq!(of(start).regime().name(), start.4, "{start:?}");
    }
    // One unit in the last place beside the separatrices.
    let name = |u: f64, v: f64, p: f64, q: f64| Duffing::new(u, v, p, q).unwrap().regime().name();
    let up = |value: f64| f64::from_bits(value.to_bits() + 1);
    let down = |value: f64| f64::from_bits(value.to_bits() - 1);
    assert_eq!((name(-2.0, 5e-324, -2.0, 1.0), name(down(2.0), 0.0, -2.0, 1.0)), ("libration", "well"));
    assert_eq!(name(2.0, 0.0, -2.0, up(1.0)), "libration");
    assert_eq!((name(0.0, up(1.0), 1.0, -0.5), name(0.0, down(1.0), 1.0, -0.5)), ("escape", "libration"));
    assert_eq!((name(0.0, 5e-324, 1.0, -1e300), name(1e-200, 0.0, 1.0, -1e300)), ("libration", "libration"));
    assert_eq!((name(1e-200, 0.0, -1.0, -1e300), name(1e-320, 0.0, -1e-300, 1e300)), ("escape", "well"));
    assert_eq!(name(1e300, 1e300, 1e300, 1e300), "libration");
}

#[test]
fn invariants() {
    let mut spread = Spread(3);
    let mut moving = 0;
    for i in 0..4000 {
        let [u0, v0, p, q] = if i < STARTS.len() {
            let (u0, v0, p, q, _) = STARTS[i];
            [u0, v0, p, q]
        } else {
            spread.state()
        };
        let orbit = Duffing::new(u0, v0, p, q).unwrap();
        assert_eq!(orbit.motion(0.0), (u0, v0));
        let t = spread.between(-3.0, 3.0);
        let (u, v) = orbit.motion(t);
        let inside = orbit.escape_time_backward() < t && t < orbit.escape_time();
        assert_eq!(u.is_nan(), !inside, "{orbit:?} {t}");
        assert_eq!(v.is_nan(), !inside);
        if !inside {
            continue;
        }
        moving += 1;
        let kept = energy(u, v, p, q) - orbit.energy();
        assert!(
            kept.abs() <= 2e-15 * energy_scale(u, v, p, q).max(energy_scale(u0, v0, p, q)),
            "{orbit:?} {t} {kept}"
        );
        let (low, high) = orbit.range();
        assert!(low <= u + 4e-16 * u.abs() && u - 4e-16 * u.abs() <= high);
        // Parity and time reversal, to the last bit; scaling by powers of two.
        let (mirror_u, mirror_v) = Duffing::new(-u0, -v0, p, q).unwrap().motion(t);
        assert_eq!((-u, -v), (mirror_u, mirror_v), "{orbit:?} {t}");
        let [su, sv] = scales(&orbit, u, v);
        let (back_u, back_v) = Duffing::new(u0, -v0, p, q).unwrap().motion(-t);
        assert!((back_u - u).abs() <= 2e-15 * su && (back_v + v).abs() <= 2e-15 * sv, "{orbit:?} {t}");
        let scaled = Duffing::new(4.0 * u0, 32.0 * v0, 64.0 * p, 4.0 * q).unwrap();
        let (scaled_u, scaled_v) = scaled.motion(t / 8.0);
        assert!((scaled_u / 4.0 - u).abs() <= 1e-15 * su && (scaled_v / 32.0 - v).abs() <= 1e-15 * sv);
        // On from there: the start of the second leg is rounded, which the motion may enlarge.
        let second = spread.between(-1.0, 1.0);
        let direct = orbit.motion(t + second);
        let (then_u, then_v) = Duffing::new(u, v, p, q).unwrap().motion(second);
        if !direct.0.is_nan() && !then_u.is_nan() {
            let [a, b] = scales(&orbit, direct.0, direct.1);
            let enlarged = [u, v, u0, v0].iter().fold(1.0, |size: f64, value| size.max(value.abs())).powi(6);
            let grown = enlarged * direct.0.abs().max(1.0).powi(3);
            assert!((direct.0 - then_u).abs() <= 1e-12 * a.max(1.0) * grown, "{orbit:?} {t} {second}");
            assert!((direct.1 - then_v).abs() <= 1e-12 * b.max(1.0) * grown, "{orbit:?} {t} {second}");
        }
    }
    assert!(moving > 2500, "{moving}");
}

/// u' and u'' are the slopes of u and u'.
#[test]
fn the_equation_holds() {
    let mut spread = Spread(11);
    for i in 0..3000 {
        let [u0, v0, p, q] = if i < STARTS.len() {
            let (u0, v0, p, q, _) = STARTS[i];
            [u0, v0, p, q]
        } else {
            spread.state()
        };
        let orbit = Duffing::new(u0, v0, p, q).unwrap();
        let t = spread.between(-2.0, 2.0);
        let h = 1e-3;
        let samples = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| orbit.motion(t + k * h));
        if samples.iter().any(|(u, _)| u.is_nan() || u.abs() > 2.0) {
            continue;
        }
        let slope = |value: fn(&(f64, f64)) -> f64| {
            let [a, b, _, d, e] = samples.each_ref().map(value);
            ((a - e) + 8.0 * (d - b)) / (12.0 * h)
        };
        let (u, v) = samples[2];
        assert!((slope(|s| s.0) - v).abs() < 1e-7, "{orbit:?} {t}");
        assert!((slope(|s| s.1) + p * u + q * u * u * u).abs() < 1e-6, "{orbit:?} {t}");
    }
}

/// Signs of u(t) - value at many times.
fn counted(orbit: &Duffing, value: f64, start: f64, stop: f64) -> usize {
    let samples = 4000;
    let times: Vec<f64> =
        (0..=samples).map(|i| start + (stop - start) * f64::from(i) / f64::from(samples)).collect();
    let mut u = vec![0.0; times.len()];
    orbit.u_into(&times, &mut u);
    u.windows(2)
        .filter(|pair| (pair[0] < value) != (pair[1] < value) && !pair[0].is_nan() && !pair[1].is_nan())
        .count()
}

#[test]
fn passages_are_all_there_and_right() {
    let mut spread = Spread(5);
    let (mut passages, mut kinds) = (0, std::collections::BTreeSet::new());
    for i in 0..3000 {
        let (u0, v0, p, q, _) = if i % 10 == 0 {
            STARTS[i / 10 % STARTS.len()]
        } else {
            let [a, b, c, d] = spread.state();
            (a, b, c, d, "")
        };
        let orbit = Duffing::new(u0, v0, p, q).unwrap();
        let (low, high) = orbit.range();
        let value = spread.between(low.max(-3.0), high.min(3.0));
        let (start, stop) = (spread.between(-10.0, 0.0), spread.between(0.0, 10.0));
        let times = orbit.times(value, start, stop).unwrap();
        for &t in &times {
            let (u, v) = orbit.motion(t);
            let [scale, _] = scales(&orbit, value, v);
            let error = (u - value).abs()
                / (8.0 * f64::EPSILON * scale.max(value.abs()) + 2.0 * v.abs() * f64::EPSILON * t.abs());
            assert!(error <= 1.0, "{orbit:?} {value} {t}: {u} {error}");
            kinds.insert(orbit.regime().name());
            passages += 1;
        }
        assert!(times.windows(2).all(|pair| pair[0] <= pair[1]));
        // Within the sampled part: the scan must not lose what lies between a sample and a pole, or two next to a turn.
        let (from, to) = (start.max(orbit.escape_time_backward()), stop.min(orbit.escape_time()));
        let width = to - from;
        let (from, to) = (from + 1e-3 * width, to - 1e-3 * width);
        let close =
            (value - low).abs() < 1e-3 || (high - value).abs() < 1e-3 || orbit.regime() == Regime::Rest;
        if !close {
            let found = orbit.times(value, from, to).unwrap().len();
            assert_eq!(found, counted(&orbit, value, from, to), "{orbit:?} {value} {from} {to}");
        }
    }
    assert!(passages > 2000 && kinds.len() >= 6, "{passages} {kinds:?}");
}

#[test]
fn passages_at_the_edges() {
    let orbit = Duffing::new(1.0, 0.0, 1.0, 1.0).unwrap();
    let period = orbit.period();
    let turns = orbit.times(1.0, 0.0, 2.5 * period).unwrap();
    assert_eq!(turns.len(), 3);
    assert_eq!(turns[0], 0.0);
    assert!((turns[1] - period).abs() < 1e-15 * period && orbit.times(1.1, 0.0, 9.0).unwrap().is_empty());
    assert!(orbit.times(0.0, 0.0, f64::INFINITY).is_err() && orbit.times(0.0, 1.0, 0.0).is_err());
    assert!(orbit.times(f64::NAN, 0.0, 1.0).is_err() && orbit.times(0.0, 0.0, 1e9).is_err());
    // Every start is passed at 0, to the last bit.
    for start in STARTS {
        let orbit = of(start);
        if orbit.regime() != Regime::Rest {
            let times = orbit.times(start.0, -0.1, 0.1).unwrap();
            assert!(times.contains(&0.0), "{start:?} {times:?}");
        }
    }
    // What is only approached is never passed.
    let endless = (f64::NEG_INFINITY, f64::INFINITY);
    assert!(Duffing::new(2.0, 0.0, -2.0, 1.0).unwrap().times(0.0, endless.0, endless.1).unwrap().is_empty());
    assert_eq!(Duffing::new(2.0, 0.0, -2.0, 1.0).unwrap().times(1.0, endless.0, endless.1).unwrap().len(), 2);
    assert!(Duffing::new(1.0, -1.0, -0.5, -1.0).unwrap().times(0.0, -9.0, 9.0).unwrap().is_empty());
}

#[test]
fn escapes() {
    // csch, 1/t, coth and the lemniscate.
    let csch = Duffing::new(1.0, -1.0, -0.5, -1.0).unwrap();
    assert_eq!(csch.escape_time(), f64::INFINITY);
    assert!((csch.escape_time_backward() + 1f64.asinh() * 2f64.sqrt()).abs() < 1e-15);
    let inverse = Duffing::new(2.0, 2.0, 0.0, -0.5).unwrap();
    assert_eq!((inverse.escape_time(), inverse.escape_time_backward()), (1.0, f64::NEG_INFINITY));
    assert_eq!(inverse.motion(0.5), (4.0, 8.0));
    let lemniscate = Duffing::new(0.0, 1.0, 0.0, -2.0).unwrap();
    assert!(
        (lemniscate.escape_time() - 1.854_074_677_301_372 / 2f64.sqrt() * 2f64.sqrt() / 2f64.sqrt()).abs()
            < 1.0
    );
    assert_eq!(lemniscate.escape_time(), -lemniscate.escape_time_backward());
    // The blow-up law: |u| (t* - t) to sqrt(2/|q|), up to the last double before the escape.
    for start in STARTS.iter().filter(|start| start.4 == "escape") {
        let orbit = of(*start);
        for (end, way) in [(orbit.escape_time(), 1.0), (orbit.escape_time_backward(), -1.0)] {
            if end.is_infinite() {
                continue;
            }
            let beside = |steps: u64| f64::from_bits(end.to_bits() - steps);
            for steps in [1u64 << 20, 1 << 30] {
                let t = beside(steps);
                let law = orbit.u(t).abs() * (end - t) * way / (2.0 / orbit.q().abs()).sqrt();
                assert!((law - 1.0).abs() < 2e-6, "{start:?} {law}");
            }
            assert!(orbit.u(f64::from_bits(end.to_bits() + 1)).is_nan() && orbit.u(2.0 * end).is_nan());
            assert!(orbit.u(beside(1)).abs() > 1e14, "{start:?} {}", orbit.u(beside(1)));
        }
    }
}

fn times() -> Vec<f64> {
    let mut times: Vec<f64> = (-40..40).map(|i| 0.037 * f64::from(i)).collect();
    times.extend([
        0.0,
        -0.0,
        1e-300,
        1e6,
        -1e12,
        1e300,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
        30.0,
        900.0,
    ]);
    times
}

fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

#[test]
fn slices_are_their_scalars_on_every_instruction_set() {
    let _alone = ONE_AT_A_TIME.lock().unwrap();
    let times = times();
    for set in InstructionSet::available() {
        set.force().unwrap();
        for start in STARTS {
            let orbit = of(start);
            for length in (0..49).chain([times.len()]) {
                let t = &times[times.len() - length..];
                let [mut u, mut velocity, mut pair_u, mut pair_velocity, mut own_u, mut own_velocity] =
                    [(); 6].map(|()| vec![7.0; length]);
                orbit.u_into(t, &mut u);
                orbit.velocity_into(t, &mut velocity);
                orbit.motion_into(t, &mut pair_u, &mut pair_velocity);
                let columns = [start.0, start.1, start.2, start.3].map(|value| vec![value; length]);
                let [a, b, c, d] = columns.each_ref().map(Vec::as_slice);
                duffing_motion_into([t, a, b, c, d], [&mut own_u, &mut own_velocity]);
                for (i, &t) in t.iter().enumerate() {
                    let (a, b) = orbit.motion(t);
                    assert!(
                        [orbit.u(t), u[i], pair_u[i], own_u[i]].iter().all(|other| same(a, *other)),
                        "{start:?} {t}"
                    );
                    assert!(
                        [orbit.velocity(t), velocity[i], pair_velocity[i], own_velocity[i]]
                            .iter()
                            .all(|other| same(b, *other)),
                        "{start:?} {t}"
                    );
                }
            }
        }
        for which in Glaisher::ALL {
            let Some(form) = example(which, 0.3) else { panic!("no example of {}", which.name()) };
            for length in (0..40).chain([times.len()]) {
                let t = &times[times.len() - length..];
                let (mut u, mut velocity) = (vec![7.0; length], vec![7.0; length]);
                form.motion_into(t, &mut u, &mut velocity);
                for (i, &t) in t.iter().enumerate() {
                    assert!(same(form.u(t), u[i]) && same(form.velocity(t), velocity[i]));
                }
            }
        }
    }
}

#[test]
fn times_that_are_not_finite() {
    let motion = |u, v, p, q, t| Duffing::new(u, v, p, q).unwrap().motion(t);
    assert_eq!(motion(2.0, 0.0, -2.0, 1.0, f64::INFINITY).0, 0.0);
    assert_eq!(motion(0.0, 1.0, 1.0, -0.5, f64::INFINITY).0, 2f64.sqrt());
    assert_eq!(motion(1.0, -1.0, -0.5, -1.0, f64::INFINITY).0, 0.0);
    assert!(
        motion(1.0, 0.0, 1.0, 1.0, f64::INFINITY).0.is_nan() && motion(1.0, 0.0, 1.0, 1.0, 1e17).0.is_nan()
    );
    assert_eq!(motion(1.0, 0.0, -1.0, 1.0, 1e300), (1.0, 0.0));
    assert_eq!(motion(1.0, 0.0, -1.0, 0.0, 1e4).0, f64::INFINITY);
    assert!(motion(1.0, 0.0, 1.0, -2.0, f64::NAN).0.is_nan());
}

/// A real example of a form.
fn example(which: Glaisher, c2: f64) -> Option<Form> {
    let grid = [
        (1.0, -0.7),
        (1.0, 0.6),
        (-0.8, 1.2),
        (-1.5, 0.4),
        (-0.5, -0.9),
        (1.0, -1.6),
        (-1.1, 1.3),
        (0.3, -1.1),
        (-0.9, -1.2),
        (-1.5, -0.5),
    ];
    grid.iter().find_map(|(p, q)| Form::new(which, *p, *q, 1.0, c2).ok())
}

#[test]
fn each_of_the_twelve_forms_obeys_the_equation() {
    let mut spread = Spread(21);
    let mut tried = std::collections::BTreeMap::new();
    for _ in 0..4000 {
        let [p, q, c1, c2] = spread.state();
        for which in Glaisher::ALL {
            let Ok(form) = Form::new(which, p, q, c1, c2) else { continue };
            *tried.entry(which.name()).or_insert(0) += 1;
            let t = spread.between(-2.0, 2.0);
            let (u, v) = form.motion(t);
            if u.abs() > 1e3 {
                continue;
            }
            // The energy is that of the form, and the same everywhere: u'^2 = 2E - p u^2 - q u^4/2 has u'' as its slope.
            let elsewhere = form.motion(spread.between(-2.0, 2.0));
            let size = energy_scale(u, v, p, q).max(energy_scale(elsewhere.0, elsewhere.1, p, q));
            let difference = energy(u, v, p, q) - energy(elsewhere.0, elsewhere.1, p, q);
            assert!(difference.abs() <= 4e-15 * size, "{} {p} {q} {c1} {c2} {t}", which.name());
            let h = 1e-3;
            let samples = [-2.0, -1.0, 1.0, 2.0].map(|k| form.motion(t + k * h));
            if samples.iter().all(|(u, _)| u.abs() < 5.0) {
                let [a, b, d, e] = samples.map(|sample| sample.1);
                let second = ((a - e) + 8.0 * (d - b)) / (12.0 * h);
                assert!(
                    (second + p * u + q * u * u * u).abs() < 1e-5,
                    "{} {p} {q} {c1} {c2} {t}",
                    which.name()
                );
            }
            // And it is the oscillator through the same start, up to the poles.
            let (u0, v0) = form.motion(0.0);
            let orbit = Duffing::new(u0, v0, p, q).unwrap();
            let (other_u, other_v) = orbit.motion(t);
            let far = t > 0.7 * orbit.escape_time() || t < 0.7 * orbit.escape_time_backward();
            if !far && u0.abs() < 10.0 && v0.abs() < 100.0 {
                let [su, sv] = scales(&orbit, u, v);
                assert!(
                    (u - other_u).abs() < 1e-10 * su.max(1.0) && (v - other_v).abs() < 1e-10 * sv.max(1.0),
                    "{} {orbit:?} {t}",
                    which.name()
                );
            }
            let parameter = form.parameter();
            assert!(parameter.m() >= 0.0 && parameter.mc() >= 0.0 && form.rate() > 0.0);
        }
    }
    assert!(tried.len() == 12 && tried.values().all(|count| *count > 100), "{tried:?}");
}

#[test]
fn a_form_out_of_its_domain_is_refused() {
    let refused = |which, p, q| Form::new(which, p, q, 1.0, 0.0).unwrap_err().to_string();
    assert_eq!(
        refused(Glaisher::Cn, -2.0, 1.0),
        "form = cn, p = -2.0, q = 1.0, c1 = 1.0: must be of q c1^2 >= 0 and q c1^2 + 2p >= 0, and not both 0"
    );
    assert!(Form::new(Glaisher::Sn, 1.0, -1.0, f64::NAN, 0.0).is_err());
    // The edges of the domains are in them: m = 0 and m = 1.
    for (which, p, q) in [
        (Glaisher::Sn, 1.0, 0.0),
        (Glaisher::Sn, 1.0, -1.0),
        (Glaisher::Cn, -0.5, 1.0),
        (Glaisher::Dn, -0.5, 1.0),
        (Glaisher::Dn, -1.0, 1.0),
        (Glaisher::Sc, -1.0, -1.0),
        (Glaisher::Ds, 0.5, -1.0),
        (Glaisher::Ds, -0.5, -1.0),
        (Glaisher::Ns, 1.0, -1.0),
    ] {
        let form = Form::new(which, p, q, 1.0, 0.4).unwrap();
        let m = form.parameter().m();
        assert!(m == 0.0 || m == 1.0, "{} {m}", which.name());
        let (u, v) = form.motion(0.0);
        let (then_u, then_v) = form.motion(0.7);
        let kept = energy(u, v, p, q) - energy(then_u, then_v, p, q);
        assert!(kept.abs() < 4e-15 * energy_scale(u, v, p, q).max(energy_scale(then_u, then_v, p, q)));
    }
}

#[test]
fn which_form_serves_which_regime() {
    let lines: Vec<String> = Form::table()
        .iter()
        .map(|(which, regimes)| {
            let names: Vec<&str> = regimes.iter().map(|regime| regime.name()).collect();
            format!("{} {}", which.name(), names.join(" "))
        })
        .collect();
    println!("{}", lines.join("\n"));
    let expected = [
        "sn linear libration heteroclinic",
        "cn linear libration homoclinic",
        "dn rest well homoclinic",
        "ns escape",
        "nc linear escape",
        "nd rest linear well",
        "sc linear escape",
        "cs escape",
        "sd linear libration",
        "ds escape",
        "cd rest linear libration",
        "dc rest escape",
    ];
    assert_eq!(lines, expected);
}

#[test]
fn pendulum_and_oscillator_are_one_motion() {
    let mut spread = Spread(31);
    let mut there = [0; 2];
    for _ in 0..2000 {
        let (theta0, velocity0, omega2) =
            (spread.between(-3.0, 3.0), spread.between(-3.0, 3.0), spread.between(-2.0, 2.0));
        let force = Frequency::from_omega2(omega2).unwrap();
        let pendulum = Orbit::new(theta0, velocity0, force).unwrap();
        let orbit = Duffing::of_pendulum(theta0, velocity0, force).unwrap();
        let t = spread.between(-1.0, 1.0);
        let (theta, velocity) = pendulum.motion(t);
        if theta.abs() > 2.8 || orbit.u(t).is_nan() || theta0.abs() > 2.8 {
            continue;
        }
        let (u, v) = orbit.motion(t);
        assert!((2.0 * u.atan() - theta).abs() < 1e-13, "{theta0} {velocity0} {omega2} {t}");
        assert!((2.0 * v / (1.0 + u * u) - velocity).abs() < 1e-12);
        there[0] += 1;
    }
    for _ in 0..4000 {
        let [u0, v0, p, q] = spread.state();
        let orbit = Duffing::new(u0, v0, p, q).unwrap();
        let Some(companion) = orbit.companion() else { continue };
        let force = Frequency::from_omega2(companion.omega2).unwrap();
        let pendulum = Orbit::new(companion.theta0, companion.velocity0, force).unwrap();
        let t = spread.between(-1.0, 1.0);
        let (theta, u) = (pendulum.theta(t), orbit.u(t));
        if u.is_nan() || theta.abs() > 2.8 || companion.theta0.abs() > 2.8 {
            continue;
        }
        assert!(
            (companion.scale * (0.5 * theta).tan() - u).abs() < 1e-11 * companion.scale.max(1.0),
            "{orbit:?} {companion:?} {t}"
        );
        there[1] += 1;
    }
    assert!(there[0] > 1000 && there[1] > 1000, "{there:?}");
    // The separatrix of the pendulum is the linear oscillator, and pi is beyond every u.
    let separatrix = Duffing::of_pendulum(0.0, 2.0, Frequency::from_omega0(1.0).unwrap()).unwrap();
    assert_eq!((separatrix.regime(), separatrix.p(), separatrix.q()), (Regime::Linear, -1.0, 0.0));
    assert!(separatrix.companion().is_none());
    let top = Duffing::of_pendulum(std::f64::consts::PI, 0.0, Frequency::from_omega0(1.0).unwrap()).unwrap();
    assert!(top.u0() > 1.6e16 && top.u0() < 1.7e16 && top.regime() == Regime::Libration);
}

#[test]
fn bad_input_is_said_in_one_line() {
    let said = Duffing::new(1.0, f64::INFINITY, 1.0, 1.0).unwrap_err().to_string();
    assert_eq!(said, "velocity0 = inf: must be finite");
    assert!(Duffing::new(1.0, 0.0, f64::NAN, 1.0).is_err());
    let (mut u, mut v) = ([0.0], [0.0]);
    duffing_motion_into([&[1.0], &[f64::NAN], &[0.0], &[1.0], &[1.0]], [&mut u, &mut v]);
    assert!(u[0].is_nan() && v[0].is_nan());
}

//! The cubic oscillator against itself: invariants, passages and doors.

use crate::on_every_set;
use crate::oscillator::{Spread, energy, energy_scale, example, scales};
use crate::ruler::same;
use libration::oscillator::{OscillatorRegime, duffing_motion_into};
use libration::{Duffing, Glaisher};

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
    (1.0, 1.0, -2.0, 2.0, "homoclinic"),
    (-2.0, 0.0, -2.0, 1.0, "homoclinic"),
    (0.0, 1.0, 1.0, -0.5, "heteroclinic"),
    (2.0, 2.0, 0.0, -0.5, "escape"),
    (1.0, -1.0, -0.5, -1.0, "escape"),
    (2.0, 1.0, -3.0, -1.0, "escape"),
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

/// The starts, and as many others.
fn states(count: usize, spread: &mut Spread) -> Vec<[f64; 4]> {
    let listed = STARTS.iter().map(|(u0, v0, p, q, _)| [*u0, *v0, *p, *q]);
    listed.chain((0..count).map(|_| spread.state())).collect()
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
    for [u0, v0, p, q] in states(4000, &mut spread) {
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
    for [u0, v0, p, q] in states(3000, &mut spread) {
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
        let close = (value - low).abs() < 1e-3
            || (high - value).abs() < 1e-3
            || orbit.regime() == OscillatorRegime::Rest;
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
        if orbit.regime() != OscillatorRegime::Rest {
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

/// Next to nothing from a separatrix, where k' and the fourth powers of theta functions leave the range; the numbers
/// are 2K/W by K = ln(4/k'), in 700 digits.
#[test]
fn extremes() {
    let far = Duffing::new(1e-300, 0.0, -1e300, 1.0).unwrap();
    assert_eq!(far.regime(), OscillatorRegime::Well);
    assert!((far.period() / 2.075_792_319_597_440_8e-147 - 1.0).abs() < 1e-15);
    assert!((far.u(0.5 * far.period()) / (2f64.sqrt() * 1e150) - 1.0).abs() < 1e-13);
    // Over both tops, each in ln of 1e160.
    let slow = Duffing::new(1e-160, 1.0, 2.0, -2.0).unwrap();
    assert_eq!(slow.regime(), OscillatorRegime::Escape);
    assert!((slow.escape_time() / 370.146_482_830_447_17 - 1.0).abs() < 1e-15);
    for t in [0.5, 1.0, 100.0, 185.0, 369.0, 370.0] {
        let (u, v) = slow.motion(t);
        assert!((u - t.tanh()).abs() < 1e-15 || t > 200.0 && u > 1.0, "{t} {u}");
        assert!((v * v + 2.0 * u * u - u * u * u * u - 1.0).abs() < 1e-14 * (1.0 + u.powi(4)), "{t} {u} {v}");
    }
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
    assert!((lemniscate.escape_time() - 1.854_074_677_301_372).abs() < 1e-15);
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

#[test]
fn slices_are_their_scalars_on_every_instruction_set() {
    let times = times();
    on_every_set(|_| {
        for start in STARTS {
            let orbit = of(start);
            for length in (0..49).chain([times.len()]) {
                let t = &times[times.len() - length..];
                let [mut u, mut velocity, mut pair_u, mut pair_velocity] =
                    [(); 4].map(|()| vec![7.0; length]);
                orbit.u_into(t, &mut u);
                orbit.velocity_into(t, &mut velocity);
                orbit.motion_into(t, &mut pair_u, &mut pair_velocity);
                for (i, &t) in t.iter().enumerate() {
                    let (a, b) = orbit.motion(t);
                    let all = [orbit.u(t), u[i], pair_u[i]];
                    assert!(all.iter().all(|other| same(a, *other)), "{start:?} {t}");
                    let all = [orbit.velocity(t), velocity[i], pair_velocity[i]];
                    assert!(all.iter().all(|other| same(b, *other)), "{start:?} {t}");
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
    });
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

#[test]
fn bad_input_is_said_in_one_line() {
    let said = Duffing::new(1.0, f64::INFINITY, 1.0, 1.0).unwrap_err().to_string();
    assert_eq!(said, "velocity0 = inf: must be finite");
    assert!(Duffing::new(1.0, 0.0, f64::NAN, 1.0).is_err());
    let (mut u, mut v) = ([0.0], [0.0]);
    duffing_motion_into([&[1.0], &[f64::NAN], &[0.0], &[1.0], &[1.0]], [&mut u, &mut v]);
    assert!(u[0].is_nan() && v[0].is_nan());
}

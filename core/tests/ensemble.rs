//! Columns of many particles: random numbers by known answers, whole turns at the ends of the range, sums against plain ones, and
//! steps as they are one by one.

use crate::on_every_set;
use crate::own_states::states;
use crate::ruler::same;
use libration::ensemble::{
    Bins, Steps, exponential_into, histogram_into, moments, steps_into, uniforms_into, wrap_into,
};
use libration::{Frequency, advance};
use std::f64::consts::{PI, TAU};

/// Words of NumPy 2.4.6, `Philox(key=[9, 0]).random_raw(8)`: the first two of each counter.
const WORDS: [[u64; 2]; 2] =
    [[0x36a13585cf3fb007, 0xcbdbd03c54cae7b3], [0xb7e906187fdfa78e, 0xc068c59a3aee01da]];

#[test]
fn uniform_numbers_are_the_words_of_their_counters() {
    let open = |word: u64| ((word >> 12) as f64 + 0.5) / 2f64.powi(52);
    let (mut u, mut v) = (vec![7.0; 1000], vec![7.0; 1000]);
    uniforms_into(9, 0, [&mut u, &mut v]);
    for (row, [first, second]) in WORDS.into_iter().enumerate() {
        assert_eq!([u[row], v[row]], [open(first), open(second)]);
    }
    assert!(u.iter().chain(&v).all(|value| 0.0 < *value && *value < 1.0));
    let (mut a, mut b) = (vec![7.0; 10], vec![7.0; 10]);
    uniforms_into(9, 990, [&mut a, &mut b]);
    assert!(a == u[990..] && b == v[990..]);
    uniforms_into(8, 990, [&mut a, &mut b]);
    assert!(a.iter().zip(&u[990..]).all(|(one, other)| one != other));
}

#[test]
fn exponential_numbers_are_right_on_every_instruction_set() {
    let u: Vec<f64> =
        (1..4000).map(|i| f64::from(i) / 4000.0).chain([1e-300, 1e-16, 1e-9, 1.0 - 1e-16]).collect();
    on_every_set(|set| {
        for lost in [-1.0, -0.5, -1e-9] {
            let mut x = vec![7.0; u.len()];
            exponential_into(&u, lost, &mut x);
            for (u, x) in u.iter().zip(&x) {
                let known = -(lost * u).ln_1p();
                assert!((x / known - 1.0).abs() <= 4.0 * f64::EPSILON, "{set:?} {lost} {u} {x} {known}");
                assert!((x * (1.0 + 4e-15) / known - 1.0).abs() > 4.0 * f64::EPSILON);
            }
        }
    });
}

#[test]
fn whole_turns_at_the_ends_of_the_range() {
    let mut given = vec![f64::NAN, f64::INFINITY, 1e300, 4.6e15, 0.0, -0.0, PI, -PI];
    for turns in [1.0, 2.0, 3.0, 5.0, 1e6] {
        for angle in [turns * PI, turns * TAU, turns * 7.0] {
            given.extend([angle, -angle, angle.next_up(), angle.next_down(), (-angle).next_up()]);
        }
    }
    for from in 0..20 {
        let (mut theta, mut turns) = (given[from..].to_vec(), vec![3; given.len() - from]);
        wrap_into(&mut theta, &mut turns);
        for ((theta, turns), given) in theta.iter().zip(&turns).zip(&given[from..]) {
            if given.is_nan() || given.abs() >= 4.5e15 {
                assert!(theta.is_nan() && *turns == 3, "{given}");
                continue;
            }
            assert!(theta.abs() <= PI, "{given} {theta}");
            let (whole, size) = ((turns - 3) as f64, given.abs().max(1.0));
            assert!(
                (theta + whole * TAU - given).abs() <= 2.0 * f64::EPSILON * size,
                "{given} {theta} {turns}"
            );
            assert!(given.abs() > PI || same(*theta, *given), "{given}");
        }
    }
}

#[test]
fn moments_are_those_of_plain_sums() {
    for rows in [0, 1, 2, 7, 8, 9, 1000] {
        let a: Vec<f64> = (0..rows).map(|i| 1e6 + (f64::from(i) * 0.754_877_666).fract()).collect();
        let b: Vec<f64> = (0..rows).map(|i| (f64::from(i) * 0.569_840_291).fract() - 0.3).collect();
        let found = moments(&a, &b).unwrap();
        let many = f64::from(rows.max(1));
        let mean = [a.iter().map(|a| a - 1e6).sum::<f64>() / many, b.iter().sum::<f64>() / many];
        let products = a.iter().zip(&b).fold([0.0; 3], |[aa, ab, bb], (a, b)| {
            let (a, b) = (a - 1e6 - mean[0], b - mean[1]);
            [aa + a * a, ab + a * b, bb + b * b]
        });
        let shift = if rows > 0 { 1e6 } else { 0.0 };
        assert!((found.mean[0] - shift - mean[0]).abs() <= 1e-9 && (found.mean[1] - mean[1]).abs() <= 1e-13);
        for (found, known) in found.products.iter().zip(products) {
            assert!((found - known).abs() <= 1e-9 * f64::from(rows), "{rows} {found} {known}");
        }
    }
    assert!(moments(&[1.0, f64::NAN], &[0.0; 2]).is_none() && moments(&[0.0], &[f64::INFINITY]).is_none());
}

#[test]
fn histograms_count_every_row_once() {
    let column =
        |ratio: f64| -> Vec<f64> { (0..1001).map(|i| (f64::from(i) * ratio).fract() * 1.4 - 0.2).collect() };
    let (a, b) = (column(0.754_877_666), column(0.569_840_291));
    let bins = [Bins { low: 0.0, high: 1.0, count: 5 }, Bins { low: -0.1, high: 0.9, count: 4 }];
    let mut counts = vec![1; 21];
    histogram_into(&[&a, &b], &bins, &mut counts);
    let mut known = vec![1; 21];
    for (a, b) in a.iter().zip(&b) {
        let inside = (0.0..1.0).contains(a) && (-0.1..0.9).contains(b);
        let place = [(a * 5.0).floor(), ((b + 0.1) * 4.0).floor()];
        known[if inside { 4 * place[0] as usize + place[1] as usize } else { 20 }] += 1;
    }
    assert_eq!(counts, known);
    let mut ends = [0; 4];
    let (below, nan) = (1.0f64.next_down(), f64::NAN);
    histogram_into(
        &[&[below, 1.0, 0.0, -1e-300, nan, 1e300, -1e300]],
        &[Bins { low: 0.0, high: 1.0, count: 3 }],
        &mut ends,
    );
    assert_eq!(ends, [1, 0, 1, 5]);
}

#[test]
fn steps_are_one_after_the_other_on_every_instruction_set() {
    let states = states(5000);
    let [theta0, velocity0] = [0, 1].map(|i| states.iter().map(|state| state[i]).collect::<Vec<f64>>());
    let steps = Steps { dt: &[0.2, -0.3, 2.0], omega0: &[1.0, 0.5, 1.1], phase: &[0.0, 0.3, -0.1] };
    on_every_set(|set| {
        let (mut theta, mut velocity, mut turns) = (theta0.clone(), velocity0.clone(), vec![0; states.len()]);
        steps_into(&mut theta, &mut velocity, &mut turns, steps, |_| false);
        for row in (0..states.len()).step_by(37) {
            let (mut angle, mut speed, mut count) = ([theta0[row]], velocity0[row], [0]);
            for ((dt, omega0), phase) in steps.dt.iter().zip(steps.omega0).zip(steps.phase) {
                let from = if *phase == 0.0 { angle[0] } else { angle[0] - phase };
                let moved = advance(from, speed, *dt, Frequency::from_omega0(*omega0).unwrap());
                (angle[0], speed) = (if *phase == 0.0 { moved.0 } else { moved.0 + phase }, moved.1);
                wrap_into(&mut angle, &mut count);
            }
            let alike = same(theta[row], angle[0]) && same(velocity[row], speed) && turns[row] == count[0];
            assert!(alike, "{set:?} {:?}", states[row]);
        }
    });
}

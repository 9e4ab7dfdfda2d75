//! The doors of the core agree bit for bit: one value, a pair, slices of any length on lanes of any width.

use crate::on_every_set;
use crate::ruler::{bits, same};
use libration::InstructionSet;
use libration::approx::AngleFormula;
use libration::pendulum;
use libration::{Frequency, Jacobi, JacobiValues, Orbit, Parameter, advance, advance_into};

/// Starts in every regime, on both sides of kappa^2 = 1/2, in turns, upside down and without force.
const STARTS: [(f64, f64, f64); 17] = [
    (0.0, 0.0, 1.0),
    (1e-200, 0.0, 1.0),
    (0.3, -0.1, 1.0),
    (2.0, 0.3, 9.8),
    (2.6, 0.0, 1.0),
    (3.1, 0.0, 1.0),
    (3.1415926, 0.0, 1.0),
    (0.0, 2.0, 1.0),
    (0.0, -2.0000000000000004, 1.0),
    (1.0, 2.5, 1.0),
    (0.0, 2.0000001, 1.0),
    (-2.0, 40.0, 1.0),
    (50.0, 0.2, 2.0),
    (3.0, 0.1, -1.0),
    (0.0, 1.0, -3.0),
    (1.0, 2.0, 0.0),
    (0.0, 5e-324, -1.0),
];

fn times() -> Vec<f64> {
    let mut times: Vec<f64> = (-40..40).map(|i| 0.37 * f64::from(i)).collect();
    times.extend([0.0, -0.0, 1e-300, 1e6, -1e12, 1e300, f64::INFINITY, f64::NEG_INFINITY, f64::NAN]);
    times
}

/// Every length up to three of the widest lanes, and every place in it.
#[test]
fn slices_are_their_scalars_on_every_instruction_set() {
    let times = times();
    on_every_set(|set| {
        for (theta0, velocity0, omega2) in STARTS {
            let orbit = Orbit::new(theta0, velocity0, Frequency::from_omega2(omega2).unwrap()).unwrap();
            for length in (0..49).chain([times.len()]) {
                let t = &times[times.len() - length..];
                let [mut theta, mut velocity, mut pair_theta, mut pair_velocity] =
                    [(); 4].map(|()| vec![7.0; length]);
                orbit.theta_into(t, &mut theta);
                orbit.velocity_into(t, &mut velocity);
                orbit.motion_into(t, &mut pair_theta, &mut pair_velocity);
                for (i, &t) in t.iter().enumerate() {
                    let (a, b) = orbit.motion(t);
                    assert!(
                        [orbit.theta(t), theta[i], pair_theta[i]].iter().all(|other| same(a, *other)),
                        "{set:?} {t}"
                    );
                    assert!(
                        [orbit.velocity(t), velocity[i], pair_velocity[i]]
                            .iter()
                            .all(|other| same(b, *other))
                    );
                }
            }
        }
        for m in [-1e9, -0.5, 0.0, 0.3, 0.5, 0.9, 1.0, 1.2, 1e9, f64::NAN] {
            let jacobi = Jacobi::new(Parameter::from_m(m));
            let [mut sn, mut cn, mut dn, mut am] = [(); 4].map(|()| vec![7.0; times.len()]);
            jacobi.values_into(&times, [&mut sn, &mut cn, &mut dn, &mut am]);
            for (i, &u) in times.iter().enumerate() {
                let JacobiValues { sn: a, cn: b, dn: c, am: d, .. } = jacobi.values(u);
                assert!(
                    same(a, sn[i]) && same(b, cn[i]) && same(c, dn[i]) && same(d, am[i]),
                    "{set:?} {m} {u}"
                );
            }
        }
    });
}

/// States of every regime mixed in one array, every length, and one start for all rows.
#[test]
fn rows_are_their_scalars_on_every_instruction_set() {
    let mut rows: Vec<[f64; 4]> = Vec::new();
    for (theta0, velocity0, omega2) in STARTS {
        for t in [0.3, -7.0, 1e5, 0.0, f64::NAN, f64::INFINITY] {
            let omega0 = if omega2 < 0.0 { omega2 } else { omega2.sqrt() };
            rows.push([theta0, velocity0, t, omega0]);
        }
    }
    // At the edges of what lanes take; the first two are next to the separatrix after millions of periods.
    rows.push([1.570796326439803, 0.6206175903612585, 437745193.1377077, 0.43884290659114944]);
    rows.push([1.5707963274982344, 50.48100437186214, 19100529.012004964, 35.69546052517341]);
    for (velocity0, omega0) in
        [(3e-309, 1e-309), (1e-99, 1e-100), (2e-101, 1e-101), (1e101, 2e100), (1e-170, 1.0)]
    {
        rows.push([0.5, velocity0, 1.7 / omega0, omega0]);
        rows.push([1e-181, velocity0, 20.0 / omega0, omega0]);
        rows.push([3e9, velocity0, -3.0 / omega0, omega0]);
    }
    let scattered: Vec<[f64; 4]> = (0..1300).map(|i| rows[i * 29 % rows.len()]).collect();
    let alike: Vec<[f64; 4]> = (0..600).map(|i| [2.0, 0.3, 0.01 * f64::from(i), 1.3]).collect();
    on_every_set(|set| {
        for rows in (0..49).map(|length| &scattered[..length]).chain([&scattered[..], &alike[..]]) {
            let columns: [Vec<f64>; 4] = std::array::from_fn(|i| rows.iter().map(|row| row[i]).collect());
            let columns = columns.each_ref().map(Vec::as_slice);
            let [theta0, velocity0, t, omega0] = columns;
            let [mut a, mut b, mut c, mut d] = [(); 4].map(|()| vec![7.0; rows.len()]);
            advance_into(columns, [&mut a, &mut b]);
            pendulum::motion_into([t, theta0, velocity0, omega0], [&mut c, &mut d]);
            for (i, &[theta0, velocity0, t, omega0]) in rows.iter().enumerate() {
                let frequency = Frequency::from_omega0(omega0);
                let step = frequency.map_or((f64::NAN, f64::NAN), |f| advance(theta0, velocity0, t, f));
                assert!(same(a[i], step.0) && same(b[i], step.1), "{set:?} {:?}", rows[i]);
                // An angle of 40 rad and a velocity of 80 omega0 are the largest but for the start's own.
                let scale = [theta0.abs().max(40.0), velocity0.abs().max(80.0 * omega0)];
                let near =
                    |x: f64, y: f64, i: usize| same(x, y) || (x - y).abs() <= 1e-15 * scale[i].max(x.abs());
                assert!(near(a[i], c[i], 0) && near(b[i], d[i], 1), "{set:?} {:?}", rows[i]);
            }
        }
    });
}

#[test]
fn the_set_up_is_the_same_on_every_instruction_set() {
    let attributes = |(theta0, velocity0, omega2): (f64, f64, f64)| {
        let orbit = Orbit::new(theta0, velocity0, Frequency::from_omega2(omega2).unwrap()).unwrap();
        [
            orbit.period(),
            orbit.theta_max(),
            orbit.energy_ratio(),
            orbit.energy_ratio_c(),
            orbit.energy(),
            orbit.omega0(),
        ]
        .map(bits)
    };
    for start in STARTS {
        let mut seen = InstructionSet::available().iter().map(|set| set.scope(|| attributes(start)).unwrap());
        let first = seen.next().unwrap();
        assert!(seen.all(|other| other == first), "{start:?}");
    }
}

#[test]
#[should_panic(expected = "different lengths")]
fn lengths_must_agree() {
    let orbit = Orbit::new(1.0, 0.0, Frequency::from_omega0(1.0).unwrap()).unwrap();
    orbit.theta_into(&[0.0, 1.0], &mut [0.0]);
}

/// A formula of the angle is one function, whatever stands beside a time: every length, and every time alone.
#[test]
fn columns_of_formulas_are_their_scalars_on_every_instruction_set() {
    let times = times();
    let names = [
        "linear", "harmonic", "fourier:1", "fourier:4", "fourier-theta:3", "trigonometric", "small-m",
        "small-m-bounded", "cubic-quintic", "taylor:8", "taylor:200",
    ];
    let compared = std::cell::Cell::new(0);
    on_every_set(|set| {
        for (theta0, velocity0, omega2) in STARTS {
            let orbit = Orbit::new(theta0, velocity0, Frequency::from_omega2(omega2).unwrap()).unwrap();
            for name in names {
                let Ok(made) = AngleFormula::named(name).unwrap().of(&orbit) else { continue };
                for length in [0, 1, 2, 17, times.len()] {
                    let t = &times[times.len() - length..];
                    let mut theta = vec![7.0; length];
                    made.theta_into(t, &mut theta);
                    for (t, theta) in t.iter().zip(&theta) {
                        assert!(same(made.theta(*t), *theta), "{set:?} {name} {theta0} {t}");
                        compared.set(compared.get() + 1);
                    }
                }
            }
        }
    });
    assert!(compared.get() > 5000);
}

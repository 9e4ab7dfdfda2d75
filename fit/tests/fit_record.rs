//! Fits of records that the tests make from the core.

use libration::{DampedPendulum, Frequency, Friction, Torque};
use libration_fit::fit::{Data, FitOptions, Measure, Measured, Model, fit};

/// Standard normal numbers from a linear congruence: the same on every machine.
struct Normal(u64);

impl Normal {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 11) as f64 + 0.5) / 9_007_199_254_740_992.0
    }
    fn next(&mut self) -> f64 {
        (-2.0 * self.uniform().ln()).sqrt() * (core::f64::consts::TAU * self.uniform()).cos()
    }
}

fn record(
    theta0: f64,
    omega2: f64,
    friction: Friction,
    rows: usize,
    step: f64,
    sigma: f64,
    seed: u64,
) -> Data {
    let frequency = Frequency::from_omega2(omega2).unwrap();
    let pendulum = DampedPendulum::new(theta0, 0.0, frequency, friction, Torque::NONE).unwrap();
    let stop = step * rows as f64;
    let trajectory = pendulum.trajectory(0.0, stop).unwrap();
    let mut normal = Normal(seed);
    let t: Vec<f64> = (0..rows).map(|i| step * i as f64).collect();
    let values = t.iter().map(|t| trajectory.theta(*t) + 0.02 + sigma * normal.next()).collect();
    Data::Record { measured: Measured::Angle, t, values }
}

#[test]
fn seventy_degrees_give_g_with_its_budget() {
    let friction = Friction::new(0.02, 0.0, 0.0, 0.0).unwrap();
    let data = record(70f64.to_radians(), 9.81 / 0.8, friction, 600, 1.0 / 30.0, 0.01, 7);
    let options = FitOptions { length: Some(Measure { value: 0.8, u: 0.001 }), ..FitOptions::default() };
    let found = fit(&data, &options).unwrap();
    let g = found.g.unwrap();
    println!("{g:?} {:?}", found.budget);
    assert_eq!(found.model, Model::Linear);
    assert!((g.value - 9.81).abs() < 0.005, "{g:?}");
    assert!((0.0121..0.0128).contains(&g.u), "{g:?}");
    assert!((g.calibration - 0.01226).abs() < 1e-4);
    assert!((0.001..0.003).contains(&g.statistical));
}

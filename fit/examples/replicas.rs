//! Pulls of omega0 over replicas of synthetic records: `cargo run --release --example replicas -- [replicas] [case]`.
//!
//! Each line: noise, friction model, mean and deviation of (found - true)/u, and the share within 2 u.

use libration::{DampedPendulum, Frequency, Friction, Torque};
use libration_fit::fit::{Data, FitOptions, Measured, Model, fit};

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

struct Case {
    name: &'static str,
    theta0: f64,
    omega2: f64,
    friction: [f64; 4],
    model: Option<Model>,
    rows: usize,
    step: f64,
    sigma: f64,
    memory: f64,
}

fn pulls(case: &Case, replicas: u64) {
    let [a, b, c, d] = case.friction;
    let friction = Friction::new(a, b, c, d).unwrap();
    let frequency = Frequency::from_omega2(case.omega2).unwrap();
    let pendulum =
        DampedPendulum::new(case.theta0.to_radians(), 0.0, frequency, friction, Torque::NONE).unwrap();
    let trajectory = pendulum.trajectory(0.0, case.step * case.rows as f64).unwrap();
    let t: Vec<f64> = (0..case.rows).map(|i| case.step * i as f64).collect();
    let (mut found, mut refused, mut parts) = (Vec::new(), 0, [0.0; 2]);
    for replica in 0..replicas {
        let mut normal = Normal(1000 + 7919 * replica);
        let mut error = normal.next();
        let values = t
            .iter()
            .map(|t| {
                error = case.memory * error + (1.0 - case.memory * case.memory).sqrt() * normal.next();
                trajectory.theta(*t) + case.sigma * error
            })
            .collect();
        let data = Data::Record { measured: Measured::Angle, t: t.clone(), values };
        match fit(&data, &FitOptions { model: case.model, ..FitOptions::default() }) {
            Ok(fit) => {
                found.push((fit.omega0.value - case.omega2.sqrt()) / fit.omega0.u);
                parts[0] += fit.omega0.statistical / replicas as f64;
                parts[1] += fit.omega0.model / replicas as f64;
            }
            Err(_) => refused += 1,
        }
    }
    let n = found.len() as f64;
    let mean = found.iter().sum::<f64>() / n;
    let deviation = (found.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / n).sqrt();
    let inside = found.iter().filter(|x| x.abs() < 2.0).count() as f64 / n;
    let worst = found.iter().fold(0.0f64, |most, x| most.max(x.abs()));
    println!(
        "{:28} memory {:.2}: mean {mean:+.3} deviation {deviation:.3} within 2 u {:.1} % worst {worst:.1} refused {refused} statistical {:.1e} model {:.1e}",
        case.name,
        case.memory,
        100.0 * inside,
        parts[0],
        parts[1]
    );
}

fn main() {
    let given: Vec<String> = std::env::args().skip(1).collect();
    let replicas = given.first().map_or(100, |text| text.parse().expect("a number of replicas"));
    let only = given.get(1).map(String::as_str);
    let plain = Case {
        name: "linear",
        theta0: 70.0,
        omega2: 9.81 / 0.8,
        friction: [0.02, 0.0, 0.0, 0.0],
        model: Some(Model::Linear),
        rows: 600,
        step: 1.0 / 30.0,
        sigma: 0.01,
        memory: 0.0,
    };
    for memory in [0.0, 0.7] {
        let cases = [
            Case { name: "none", friction: [0.0; 4], model: Some(Model::None), memory, ..plain },
            Case { memory, ..plain },
            Case {
                name: "quadratic",
                friction: [0.01, 0.02, 0.0, 0.0],
                model: Some(Model::Quadratic),
                memory,
                ..plain
            },
            Case { name: "dry", friction: [0.01, 0.02, 0.05, 0.0], model: Some(Model::Dry), memory, ..plain },
            Case {
                name: "presliding",
                friction: [0.01, 0.02, 0.3, 0.05],
                model: Some(Model::Presliding),
                sigma: 0.003,
                memory,
                ..plain
            },
            Case { name: "auto on linear", model: None, memory, ..plain },
            Case {
                name: "Q 100 from 100 deg",
                theta0: 100.0,
                friction: [(9.81f64 / 0.8).sqrt() / 200.0, 0.0, 0.0, 0.0],
                model: None,
                rows: 1500,
                memory,
                ..plain
            },
        ];
        for case in cases.iter().filter(|case| only.is_none_or(|only| case.name == only)) {
            pulls(case, replicas);
        }
    }
}

//! Pulls of omega0 over replicas of synthetic records: `cargo run --release -p libration-fit --example replicas -- [replicas] [case]`.
//!
//! A pull is (found - true)/u. Each row of the table: the friction of the record, the model that is fitted, the correlation of an error
//! with the next, the mean and the deviation of the pulls of omega0, the share within 2 u, the deviation of the errors over the mean
//! statistical u, and the deviation of the pulls of every friction term.

use libration::{DampedPendulum, Frequency, Friction, Torque};
use libration_fit::fit::{Data, Estimate, Fit, FitOptions, Measured, Model, Stream, fit};

#[derive(Clone, Copy)]
struct Case {
    name: &'static str,
    /// Of the release, in degrees.
    theta0: f64,
    friction: [f64; 4],
    /// None for the ladder's own choice.
    model: Option<Model>,
    rows: usize,
    /// Of the noise, in rad.
    sigma: f64,
}

/// The pendulum of 0.8 m where g is 9.81, 30 samples a second.
const OMEGA2: f64 = 9.81 / 0.8;
const STEP: f64 = 1.0 / 30.0;

const fn case(name: &'static str, friction: [f64; 4], model: Option<Model>) -> Case {
    Case { name, theta0: 70.0, friction, model, rows: 600, sigma: 0.01 }
}

const CASES: [Case; 16] = [
    case("none", [0.0; 4], Some(Model::None)),
    case("linear", [0.02, 0.0, 0.0, 0.0], Some(Model::Linear)),
    case("linear + quadratic", [0.01, 0.02, 0.0, 0.0], Some(Model::Quadratic)),
    case("quadratic", [0.0, 0.02, 0.0, 0.0], Some(Model::Quadratic)),
    case("linear + quadratic + dry", [0.01, 0.02, 0.05, 0.0], Some(Model::Dry)),
    case("linear + dry", [0.01, 0.0, 0.05, 0.0], Some(Model::Dry)),
    case("quadratic + dry", [0.0, 0.02, 0.05, 0.0], Some(Model::Dry)),
    case("dry", [0.0, 0.0, 0.05, 0.0], Some(Model::Dry)),
    case("all with presliding", [0.01, 0.02, 0.3, 0.05], Some(Model::Presliding)),
    case("dry + presliding", [0.0, 0.0, 0.3, 0.05], Some(Model::Presliding)),
    case("presliding near its bound", [0.01, 0.02, 0.1, 0.003], Some(Model::Presliding)),
    case("linear, by the ladder", [0.02, 0.0, 0.0, 0.0], None),
    case("linear + quadratic, by the ladder", [0.01, 0.02, 0.0, 0.0], None),
    case("linear + quadratic + dry, by the ladder", [0.01, 0.02, 0.05, 0.0], None),
    Case { sigma: 0.003, ..case("all with presliding, by the ladder", [0.01, 0.02, 0.3, 0.05], None) },
    // gamma = omega0/200.
    Case {
        theta0: 100.0,
        rows: 1500,
        ..case("Q = 100 from 100 deg, by the ladder", [0.017_508_926_8, 0.0, 0.0, 0.0], None)
    },
];

/// Mean and deviation.
fn moments(values: &[f64]) -> (f64, f64) {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    (mean, (values.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / n).sqrt())
}

fn row(case: &Case, memory: f64, replicas: u64) {
    let [a, b, c, d] = case.friction;
    let friction = Friction::new(a, b, c, d).expect("friction");
    let frequency = Frequency::from_omega2(OMEGA2).expect("a frequency");
    let pendulum = DampedPendulum::new(case.theta0.to_radians(), 0.0, frequency, friction, Torque::NONE);
    let trajectory =
        pendulum.and_then(|p| p.trajectory(0.0, STEP * case.rows as f64)).expect("a motion of the pendulum");
    let t: Vec<f64> = (0..case.rows).map(|i| STEP * i as f64).collect();
    let exact: Vec<f64> = t.iter().map(|t| trajectory.theta(*t)).collect();
    let mut fits: Vec<Fit> = Vec::new();
    for replica in 0..replicas {
        let noise = Stream::new(replica).noise(memory, case.rows);
        let values = exact.iter().zip(noise).map(|(y, e)| y + case.sigma * e).collect();
        let data = Data::Record { measured: Measured::Angle, t: t.clone(), values };
        fits.extend(fit(&data, &FitOptions { model: case.model, ..FitOptions::default() }));
    }
    let pulls: Vec<f64> = fits.iter().map(|fit| (fit.omega0.value - OMEGA2.sqrt()) / fit.omega0.u).collect();
    let errors: Vec<f64> = fits.iter().map(|fit| fit.omega0.value - OMEGA2.sqrt()).collect();
    let statistical: Vec<f64> = fits.iter().map(|fit| fit.omega0.statistical).collect();
    let (mean, deviation) = moments(&pulls);
    let inside = pulls.iter().filter(|pull| pull.abs() < 2.0).count() as f64 / pulls.len() as f64;
    let terms: [fn(&Fit) -> Option<Estimate>; 4] = [
        |fit| fit.friction.linear,
        |fit| fit.friction.quadratic,
        |fit| fit.friction.dry,
        |fit| fit.friction.presliding,
    ];
    let of_terms = terms.iter().zip(case.friction).map(|(term, truth)| {
        let pulls: Vec<f64> = fits.iter().filter_map(term).map(|e| (e.value - truth) / e.u).collect();
        if 2 * pulls.len() > fits.len() { format!("{:.2}", moments(&pulls).1) } else { "-".into() }
    });
    println!(
        "| {} | {} | {memory} | {} | {mean:+.3} | {deviation:.3} | {:.1} % | {:.2} | {} |",
        case.name,
        case.model.map_or("auto", Model::name),
        fits.len(),
        100.0 * inside,
        moments(&errors).1 / moments(&statistical).0,
        of_terms.collect::<Vec<_>>().join(" ")
    );
}

fn main() {
    let given: Vec<String> = std::env::args().skip(1).collect();
    let replicas = given.first().map_or(100, |text| text.parse().expect("a number of replicas"));
    println!(
        "| friction | model | memory | replicas | mean | deviation | within 2 u | errors / statistical u | terms |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    for case in CASES.iter().filter(|case| given.get(1).is_none_or(|only| case.name == only)) {
        for memory in [0.0, 0.7] {
            row(case, memory, replicas);
        }
    }
}

//! Time of one fit of a long record with all friction terms: `cargo run --release --example speed -- ROWS [model]`.

use libration::{DampedPendulum, Frequency, Friction, Torque};
use libration_fit::fit::{Data, FitOptions, Measured, Model, Stream, fit};

fn main() {
    let given: Vec<String> = std::env::args().skip(1).collect();
    let rows: usize = given.first().map_or(20_000, |text| text.parse().expect("a number of rows"));
    let model = (given.get(1).map(String::as_str) == Some("presliding")).then_some(Model::Presliding);
    let friction = Friction::new(0.004, 0.01, 0.016, 0.01).expect("friction");
    let frequency = Frequency::from_omega0(4.7).expect("a frequency");
    let pendulum = DampedPendulum::new(1.5, 0.0, frequency, friction, Torque::NONE).expect("a pendulum");
    let stop = 170.0;
    let trajectory = pendulum.trajectory(0.0, stop).expect("a motion");
    let t: Vec<f64> = (0..rows).map(|i| stop * i as f64 / rows as f64).collect();
    let noise = |i: usize| Stream::new(17).uniform(i as u64) - 0.5;
    let values: Vec<f64> =
        t.iter().enumerate().map(|(i, t)| trajectory.theta(*t) + 0.003 * noise(i)).collect();
    let data = Data::Record { measured: Measured::Angle, t, values };
    let begun = std::time::Instant::now();
    let found = fit(&data, &FitOptions { model, ..FitOptions::default() }).expect("a fit");
    println!(
        "{rows} rows, {}: {:.2} s, omega0 {:.6} u {:.1e}, rms {:.2e}",
        found.model.name(),
        begun.elapsed().as_secs_f64(),
        found.omega0.value,
        found.omega0.u,
        found.rms
    );
}

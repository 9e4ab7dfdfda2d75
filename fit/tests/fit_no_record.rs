//! Noise, steps, waves of any size and at any step of time: each is answered, by a fit or by one line.

use libration_fit::fit::{Data, FitOptions, Measured, Stream, fit};

/// Evenly spread in -1/2 to 1/2, by the number of the draw.
fn spread(number: usize) -> f64 {
    Stream::new(0).uniform(number as u64) - 0.5
}

#[test]
fn what_is_no_record_is_answered() {
    let draw = |i: usize| spread(i) + spread(3 * i + 1) + spread(7 * i + 5);
    let mut answers = 0;
    for seed in [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 17, 28_usize] {
        let rows = 1 + (seed * 37) % 90;
        let size = [1.0, 1e-300, 1e300, 1e-6, 1e4, 30.0][seed % 6];
        let step = [0.05, 1e-9, 1e9, 0.3, 2.0][seed % 5];
        let t = (0..rows).map(|i| step * (i as f64 + if seed % 7 == 0 { 0.9 * draw(i) } else { 0.0 }));
        let values = (0..rows).map(|i| match seed % 4 {
            0 => size * draw(i + 100 * seed),
            1 => size * (0.3 * i as f64).sin(),
            2 => size * (i % 2) as f64,
            _ => size * (i as f64 * 0.7).cos() * (-0.02 * i as f64).exp() + size * 0.01 * draw(i),
        });
        let (t, values): (Vec<f64>, Vec<f64>) = (t.collect(), values.collect());
        let records = [Measured::Angle, Measured::Velocity, Measured::Acceleration]
            .map(|measured| Data::Record { measured, t: t.clone(), values: values.clone() });
        let table = Data::Table { swings: values.clone(), periods: t.clone() };
        let gate = Data::Gate { t: t.clone(), periods: values, transits: Some(t) };
        for data in records.into_iter().chain([table, gate]) {
            match fit(&data, &FitOptions::default()) {
                Ok(found) => assert!(found.omega0.value.is_finite()),
                Err(refusal) => {
                    let line = refusal.to_string();
                    assert!(!line.contains('\n') && line.len() < 300, "{line}");
                }
            }
            answers += 1;
        }
    }
    assert_eq!(answers, 70);
}

//! Fits two columns of a plain file: `cargo run --example columns -- FILE [t column] [value column] [factor] [length]`.

use libration_fit::fit::{Data, FitOptions, Measure, Measured, fit};

fn main() {
    let given: Vec<String> = std::env::args().skip(1).collect();
    let at = |i: usize, usual: f64| given.get(i).map_or(usual, |text| text.parse().expect("a number"));
    let (a, b, factor) = (at(1, 0.0) as usize, at(2, 1.0) as usize, at(3, 1.0));
    let text = std::fs::read_to_string(&given[0]).expect("a readable file");
    let (mut t, mut values) = (Vec::new(), Vec::new());
    for line in text.lines() {
        let cells: Vec<&str> = line.split([',', ';', '\t', ' ']).filter(|cell| !cell.is_empty()).collect();
        let cell = |i: usize| cells.get(i).and_then(|cell| cell.parse::<f64>().ok());
        if let (Some(time), Some(value)) = (cell(a), cell(b)) {
            t.push(time);
            values.push(value * factor);
        }
    }
    let length = (at(4, 0.0) > 0.0).then(|| Measure { value: at(4, 0.0), u: at(5, 0.0) });
    // 3: periods at a gate with the third column's transit times; 4: a table of periods by swing.
    if at(6, 0.0) > 2.0 {
        let third: Vec<f64> = text
            .lines()
            .filter_map(|line| {
                let numbers: Vec<f64> = line.split(',').filter_map(|cell| cell.trim().parse().ok()).collect();
                numbers.get(2).copied()
            })
            .collect();
        let transits = (third.len() == t.len()).then_some(third);
        let data = if at(6, 0.0) > 3.0 {
            Data::Table { swings: t, periods: values }
        } else {
            Data::Gate { t, periods: values, transits }
        };
        match fit(&data, &FitOptions { length, ..FitOptions::default() }) {
            Ok(fit) => println!(
                "{}: {} rows, rms {:.3e} s, omega0 {:?}, offset {:?}, swing {:.2} deg, g {:?}, {} dropped, {:?}",
                given[0],
                fit.samples,
                fit.rms,
                fit.omega0,
                fit.offset_deg,
                fit.swing.to_degrees(),
                fit.g,
                fit.dropped.len(),
                fit.verdicts
            ),
            Err(refusal) => println!("{}: refused: {refusal}", given[0]),
        }
        return;
    }
    let measured = [Measured::Angle, Measured::Velocity, Measured::Acceleration][at(6, 0.0) as usize];
    let begun = std::time::Instant::now();
    let rows = t.len();
    match fit(&Data::Record { measured, t, values }, &FitOptions { length, ..FitOptions::default() }) {
        Ok(fit) => {
            println!(
                "{}: {} of {rows} rows, {:.2}..{:.2} s, {} rms {:.4} deg, omega0 {:.5} u {:.1e} (stat {:.1e} model {:.1e}), offset {:.3} deg, swing {:.1} deg, {:.2} s",
                given[0].rsplit('/').next().unwrap_or(""),
                fit.samples,
                fit.window.0,
                fit.window.1,
                fit.model.name(),
                fit.rms.to_degrees(),
                fit.omega0.value,
                fit.omega0.u,
                fit.omega0.statistical,
                fit.omega0.model,
                fit.offset_deg.map_or(0.0, |e| e.value),
                fit.swing.to_degrees(),
                begun.elapsed().as_secs_f64()
            );
            for rung in &fit.ladder {
                println!(
                    "    {:10} rms {:.4} deg  aicc {:.1}  omega0 {:.5} {:?}",
                    rung.model.name(),
                    rung.rms.to_degrees(),
                    rung.aicc,
                    rung.omega0,
                    rung.wanted_negative
                );
            }
            let parts = fit.residuals.residual.chunks(fit.samples.div_ceil(12)).map(|part| {
                let mean = part.iter().map(|r| r * r).sum::<f64>() / part.len() as f64;
                format!("{:.3}", mean.sqrt().to_degrees())
            });
            println!("    rms of twelfths {}", parts.collect::<Vec<_>>().join(" "));
            println!("    {:?}", fit.friction);
            println!("    {:?}", fit.diagnostics);
            println!("    {} dropped; g {:?}", fit.dropped.len(), fit.g);
            for verdict in &fit.verdicts {
                println!("    {:?}: {}", verdict.grade, verdict.sentence);
            }
        }
        Err(refusal) => println!("{}: refused: {refusal}", given[0]),
    }
}

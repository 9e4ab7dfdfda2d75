//! Light gates: lists of periods, counts of passages, times in the dark of few values.

use libration::{DampedPendulum, Frequency, Friction, Torque};
use libration_fit::fit::{Data, Estimate, Fit, FitOptions, Grade, Measure, fit};
use libration_fit::{Kind, Options, Quantity, data};

use super::{near, record, refusal, says};

const G: f64 = 9.79;
const LENGTH: f64 = 1.02;
const LINEAR: f64 = 0.004;

/// Passages of the rest from a release at `degrees`, and the turning angle at each.
fn passages(degrees: f64) -> Vec<(f64, f64)> {
    let frequency = Frequency::from_omega0((G / LENGTH).sqrt()).unwrap();
    let friction = Friction::new(LINEAR, 0.0, 0.0, 0.0).unwrap();
    let swing = degrees.to_radians();
    let pendulum = DampedPendulum::new(swing, 0.0, frequency, friction, Torque::NONE).unwrap();
    let rows = pendulum.trajectory(0.0, 90.0).unwrap().times(0.0, 0.0, 90.0).unwrap();
    let turning = |t: f64| libration::damped::averaged_turning_angle(swing, t, frequency, friction);
    rows.iter().map(|t| (*t, turning(*t))).collect()
}

/// The events of a bob of 20 mm at a gate whose clock has this step, begun at `start`.
fn events(degrees: f64, start: f64, step: f64) -> String {
    let rounded = |t: f64| step * (t / step).round();
    let mut text = "Time (s),Gate State\n".to_owned();
    for (t, swing) in passages(degrees) {
        let speed = LENGTH * 2.0 * (G / LENGTH).sqrt() * (0.5 * swing).sin();
        let (enter, leave) = (start + t - 0.01 / speed, start + t + 0.01 / speed);
        text += &format!("{:.6},1\n{:.6},0\n", rounded(enter), rounded(leave));
    }
    text
}

fn options() -> FitOptions {
    FitOptions { length: Some(Measure { value: LENGTH, u: 0.0 }), ..FitOptions::default() }
}

fn fitted(text: &str) -> Fit {
    fit(&data(&record(text)).unwrap(), &options()).unwrap_or_else(|refusal| panic!("{refusal}\n{text}"))
}

fn g(fit: &Fit) -> Estimate {
    fit.g.unwrap()
}

#[track_caller]
fn holds(fit: &Fit) {
    let g = g(fit);
    assert!((g.value - G).abs() < 3.0 * g.u && g.u < 0.05, "{g:?} {:?}", fit.verdicts);
}

fn verdict(fit: &Fit, words: &str) -> Option<Grade> {
    fit.verdicts.iter().find(|verdict| verdict.sentence.contains(words)).map(|verdict| verdict.grade)
}

#[test]
fn periods_alone_are_fitted() {
    let times = passages(40.0);
    let row = |(k, pair): (usize, &[(f64, f64)])| {
        format!("{};{:.4}\n", k + 1, pair[2].0 - pair[0].0).replace('.', ",")
    };
    let pairs: Vec<&[(f64, f64)]> = times.windows(3).step_by(2).collect();
    let rows: String = pairs.iter().copied().enumerate().map(row).collect();
    holds(&fitted(&format!("n;T/s\n{rows}")));
    let lone: String = pairs.iter().map(|pair| format!("{:.4}\n", pair[2].0 - pair[0].0)).collect();
    for header in ["T", "T/s", "T (s)", "Period T (s)"] {
        holds(&fitted(&format!("{header}\n{lone}")));
    }
}

#[test]
fn counted_passages_are_no_angle() {
    let rows: String = passages(40.0)
        .iter()
        .enumerate()
        .map(|(k, (t, _))| format!("{},{:.0}\n", k + 1, 1000.0 * t))
        .collect();
    let text = format!("pass,time (ms)\n{rows}");
    let read = record(&text);
    assert_eq!(read.kind, Kind::Gate);
    let period = &read.series(Quantity::Period).unwrap().values;
    near(&period[..1], &[read.time[2] - read.time[0]], 0.0);
    assert!(period[period.len() - 2..].iter().all(|period| period.is_nan()));
    says(&read, "each swing passes the gate twice");
    holds(&fitted(&text));
    // A count of what the name does not say.
    let line = refusal(format!("k,time (ms)\n{rows}").as_bytes(), &Options::default()).to_string();
    assert!(line.contains("column \"k\" counts rows beside the time and is no angle"), "{line}");
}

#[test]
fn a_clock_of_a_coarse_step_leaves_g_unbiased() {
    let (mut off, mut variance) = (0.0, 0.0);
    let starts = 12;
    for start in 0..starts {
        let found = fitted(&events(40.0, 0.000_37 * f64::from(start), 1e-3));
        assert_eq!(verdict(&found, "a smooth curve through them"), Some(Grade::Note), "{:?}", found.verdicts);
        holds(&found);
        off += (g(&found).value - G) / f64::from(starts);
        variance += g(&found).u.powi(2) / f64::from(starts);
    }
    // The mean of starts that round otherwise, in deviations of one.
    assert!(off.abs() < 0.8 * variance.sqrt(), "{off} {variance}");
    // A finer clock needs no curve.
    let fine = fitted(&events(40.0, 0.0, 1e-6));
    assert!(verdict(&fine, "smooth curve").is_none() && verdict(&fine, "different values").is_none());
    assert!((g(&fine).value - G).abs() < 2e-3, "{:?}", fine.g);
}

#[test]
fn dark_times_that_are_all_alike_leave_the_swing_to_the_periods() {
    let gate = |degrees: f64| {
        let times = passages(degrees);
        let t: Vec<f64> = times.iter().map(|row| row.0).take(times.len() - 2).collect();
        let periods = times.windows(3).map(|rows| rows[2].0 - rows[0].0).collect();
        let dark = vec![0.02; t.len()];
        Data::Gate { t, periods, transits: Some(dark) }
    };
    let found = fit(&gate(40.0), &options()).unwrap();
    assert_eq!(verdict(&found, "the swing was read from the decay of the periods"), Some(Grade::Note));
    assert!(found.omega0.u.is_finite() && (g(&found).value - G).abs() < 0.01, "{:?}", found.g);
    // What is not known is never a number, and no sentence says NaN.
    let t: Vec<f64> = (0..40).map(|i| 2.0 * f64::from(i)).collect();
    for periods in [vec![2.0; 40], (0..40).map(|i| 2.0 + 1e-3 * f64::from(i % 2)).collect()] {
        for dark in [vec![0.02; 40], (0..40).map(|i| 0.02 + 1e-9 * f64::from(i % 3)).collect()] {
            let data = Data::Gate { t: t.clone(), periods: periods.clone(), transits: Some(dark) };
            match fit(&data, &options()) {
                Err(refusal) => {
                    assert_eq!(
                        refusal.to_string(),
                        "the periods do not determine the swing, so g is not known"
                    );
                }
                Ok(found) => {
                    assert!(found.omega0.u > 0.0 && g(&found).u.is_finite(), "{:?}", found.omega0);
                    assert!(verdict(&found, "NaN").is_none(), "{:?}", found.verdicts);
                }
            }
        }
    }
}

#[test]
fn few_dark_times_say_so() {
    // 20 mm at a fast swing, on a clock of 5 ms: two or three values.
    let found = fit(&data(&record(&events(40.0, 0.0, 5e-3))).unwrap(), &options());
    match found {
        Ok(found) => {
            assert_eq!(verdict(&found, "different values; use a finer clock"), Some(Grade::Warning));
        }
        Err(refusal) => assert!(refusal.to_string().contains("do not determine the swing"), "{refusal}"),
    }
}

#[test]
fn periods_of_two_modes_are_told_and_not_only_refused() {
    // They hold no swing either; what the record is says more.
    let t: Vec<f64> = (0..60).map(|i| 2.0 * f64::from(i)).collect();
    let periods = (0..60).map(|i| 2.0 + 0.3 * libm::sin(1.3 * f64::from(i))).collect();
    let dark = (0..60).map(|i| 0.02 + 0.004 * libm::cos(0.7 * f64::from(i))).collect();
    let found = fit(&Data::Gate { t, periods, transits: Some(dark) }, &options()).unwrap();
    assert_eq!(verdict(&found, "more than one mode"), Some(Grade::Refuted));
}

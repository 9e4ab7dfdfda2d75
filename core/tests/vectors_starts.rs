//! Orbits stated by an energy, a turning angle, a period, or an angle from the top against the truth, and the spoiled
//! siblings that must go red.

use crate::on_every_set;
use crate::ruler::{Row, distance, eased, rows, ulp};
use libration::{Frequency, Orbit, OrbitStart, Regime, StartAngle, StartMotion};
use std::collections::BTreeMap;

const STARTS: &str = include_str!("../../reference/vectors/starts.csv");
const COUNT: usize = 301;

/// The promise, in ulps eased by 2^-100 of the condition.
const BOUND: f64 = 4.0;

fn start(row: &Row) -> OrbitStart {
    let (angle, value) = (row.hex("angle"), row.hex("value"));
    let angle = match row.text("counted") {
        "theta" => StartAngle::Theta(angle),
        "from_top" => StartAngle::FromTop(angle),
        "bottom" => StartAngle::Bottom,
        other => panic!("{other}"),
    };
    let motion = match row.text("known") {
        "velocity" => StartMotion::Velocity(value),
        "energy_ratio" => StartMotion::EnergyRatio(value),
        "energy_ratio_c" => StartMotion::EnergyRatioC(value),
        "energy" => StartMotion::Energy(value),
        "theta_max" => StartMotion::ThetaMax(value),
        "theta_max_from_top" => StartMotion::ThetaMaxFromTop(value),
        "period" => StartMotion::Period(value),
        "period_of_rotation" => StartMotion::PeriodOfRotation(value),
        other => panic!("{other}"),
    };
    OrbitStart::new(angle, motion, row.decimal("direction"))
}

fn orbit(row: &Row) -> Orbit {
    let force = Frequency::from_omega2(row.hex("omega2")).unwrap();
    let orbit = Orbit::from_start(start(row), force).unwrap();
    assert_eq!(orbit.regime().name(), row.text("regime"), "{} {}", row.text("known"), row.hex("value"));
    orbit
}

fn values(row: &Row) -> Vec<(&'static str, f64)> {
    let orbit = orbit(row);
    let (theta, velocity) = orbit.motion(row.hex("t"));
    vec![
        ("theta0", orbit.theta0()),
        ("velocity0", orbit.velocity0()),
        ("theta", theta),
        ("velocity", velocity),
        ("period", orbit.period()),
        ("energy_ratio", orbit.energy_ratio()),
        ("energy_ratio_c", orbit.energy_ratio_c()),
        ("theta_max", orbit.theta_max()),
        ("energy", orbit.energy()),
    ]
}

/// Largest |theta| and |velocity| of the orbit.
fn scales(row: &Row) -> (f64, f64) {
    let (theta_max, rest) = (row.hex("theta_max_hi"), row.hex("omega2") < 0.0);
    let omega = row.hex("omega2").abs().sqrt();
    let farthest = if theta_max.is_nan() { std::f64::consts::PI } else { theta_max };
    let off = row.hex("theta0_hi").abs().max(if rest { std::f64::consts::PI } else { 0.0 });
    (farthest + off, 2.0 * omega * row.hex("energy_ratio_hi").sqrt())
}

/// Worst error of each output.
fn worst(values: impl Fn(&Row) -> Vec<(&'static str, f64)>) -> BTreeMap<&'static str, f64> {
    let mut table: BTreeMap<&str, f64> = BTreeMap::new();
    for row in rows(STARTS, COUNT) {
        let (theta_scale, velocity_scale) = scales(&row);
        for (name, got) in values(&row) {
            let (truth, condition) = (row.truth(name), row.decimal(&format!("cond_{name}")));
            let floor = 2f64.powi(-30);
            let error = match name {
                "theta" => eased(got, truth, floor * theta_scale, condition, theta_scale),
                "velocity" => eased(got, truth, floor * velocity_scale, condition, velocity_scale),
                // NaN where there is no turning angle.
                _ if truth[0].is_nan() => {
                    if got.is_nan() {
                        0.0
                    } else {
                        f64::INFINITY
                    }
                }
                _ => distance(got, truth, ulp(truth[0]) + condition * 2f64.powi(-100)),
            };
            if error > BOUND {
                let [stratum, counted, known] = ["stratum", "counted", "known"].map(|name| row.text(name));
                let [angle, value, t] = ["angle", "value", "t"].map(|name| row.hex(name));
                println!(
                    "{stratum} {counted} {angle:e} {known} {value:e} {t}: {name} {got:e} {:e} {error}",
                    truth[0]
                );
            }
            let entry = table.entry(name).or_default();
            *entry = f64::max(*entry, error);
        }
    }
    println!("{table:.2?}");
    table
}

#[test]
fn every_output_keeps_its_last_digits() {
    on_every_set(|_| {
        let table = worst(values);
        assert_eq!(table.len(), 9);
        for (name, error) in table {
            assert!(error <= BOUND, "{name} {error}");
        }
    });
}

#[test]
fn spoiled_outputs_are_found() {
    for i in 0..9 {
        let mut spoiled = "";
        let table = worst(|row| {
            let mut values = values(row);
            values[i].1 *= 1.0 + 2e-15;
            values
        });
        for (j, (name, _)) in values(&rows(STARTS, COUNT)[0]).iter().enumerate() {
            spoiled = if i == j { name } else { spoiled };
        }
        assert!(table[spoiled] > BOUND, "{spoiled}");
    }
}

/// What a state in doubles makes of these orbits: it must not pass, or stating them otherwise would be idle.
#[test]
fn the_rounded_state_is_not_enough() {
    let table = worst(|row| {
        let given = orbit(row);
        let force = Frequency::from_omega2(row.hex("omega2")).unwrap();
        let rounded = Orbit::new(given.theta0(), given.velocity0(), force).unwrap();
        vec![("period", rounded.period()), ("energy_ratio_c", rounded.energy_ratio_c())]
    });
    assert!(table["period"] > 1e3 && table["energy_ratio_c"] > 1e3, "{table:?}");
}

fn refusal(angle: StartAngle, motion: StartMotion, direction: f64, omega2: f64) -> String {
    let force = Frequency::from_omega2(omega2).unwrap();
    Orbit::from_start(OrbitStart::new(angle, motion, direction), force).unwrap_err().to_string()
}

#[test]
fn the_operands_are_the_start() {
    for row in rows(STARTS, COUNT) {
        let start = start(&row);
        assert_eq!(OrbitStart::from_operands(start.operands()), Some(start));
    }
    for kind in [-1.0, 0.5, 24.0, f64::NAN] {
        assert_eq!(OrbitStart::from_operands([0.0, 0.0, 1.0, kind]), None);
    }
}

#[test]
fn a_turning_angle_may_be_given_as_it_rounds() {
    let force = Frequency::from_omega0(1.0).unwrap();
    for ratio in [1e-300, 1e-20, 0.1, 0.5, 0.9, 0.999_999] {
        let of = |angle| OrbitStart::new(angle, StartMotion::EnergyRatio(ratio), 1.0);
        let theta_max = Orbit::from_start(of(StartAngle::Bottom), force).unwrap().theta_max();
        let there = Orbit::from_start(of(StartAngle::Theta(theta_max)), force).unwrap();
        assert!(there.velocity0() <= 1e-7 * ratio.sqrt(), "{ratio}");
        assert_eq!(there.energy_ratio(), ratio);
        let beyond = Orbit::from_start(of(StartAngle::Theta(theta_max * 1.0001)), force);
        assert!(beyond.is_err(), "{ratio}");
    }
}

#[test]
fn the_ends_are_refused_in_one_line() {
    use StartAngle::{Bottom, FromTop, Theta};
    use StartMotion::{
        Energy, EnergyRatio, EnergyRatioC, Period, PeriodOfRotation, ThetaMax, ThetaMaxFromTop,
    };
    let nan = f64::NAN;
    for (angle, motion, direction, omega2, begins) in [
        (Bottom, EnergyRatio(-1e-300), 1.0, 1.0, "energy_ratio = -1e-300: must be finite and not negative"),
        (Bottom, EnergyRatio(f64::INFINITY), 1.0, 1.0, "energy_ratio = inf: must be"),
        (Bottom, EnergyRatioC(1.5), 1.0, 1.0, "energy_ratio_c = 1.5: must be finite and at most 1"),
        (Bottom, Energy(nan), 1.0, 1.0, "energy = NaN: must be"),
        (Bottom, ThetaMax(3.2), 1.0, 1.0, "theta_max = 3.2: must be from 0 to pi"),
        (Bottom, ThetaMaxFromTop(-0.1), 1.0, 1.0, "theta_max_from_top = -0.1: must be from 0 to pi"),
        (
            Bottom,
            Period(6.28),
            1.0,
            1.0,
            "period = 6.28: must be at least that of small swings, 6.283185307179586",
        ),
        (Bottom, Period(nan), 1.0, 1.0, "period = NaN: must be"),
        (Bottom, Period(3000.0), 1.0, 1.0, "period = 3000.0: must be infinite or at most 2676/omega0"),
        (Bottom, PeriodOfRotation(0.0), 1.0, 1.0, "period = 0.0: must be positive in rotation"),
        (Bottom, PeriodOfRotation(1500.0), 1.0, 1.0, "period = 1500.0: must be infinite or"),
        (Bottom, EnergyRatio(0.5), 0.0, 1.0, "direction = 0.0: must be 1 or -1"),
        (Bottom, EnergyRatio(0.5), nan, 1.0, "direction = NaN: must be 1 or -1"),
        (
            Theta(2.0),
            EnergyRatio(0.5),
            1.0,
            1.0,
            "theta0 = 2.0: must be an angle that the energy reaches, at most 1.57",
        ),
        (
            Theta(1e-3),
            EnergyRatio(0.0),
            1.0,
            1.0,
            "theta0 = 0.001: must be an angle that the energy reaches, at most 0.0",
        ),
        (FromTop(1.0), EnergyRatio(0.5), 1.0, 1.0, "theta0_from_top = 1.0: must be an angle"),
        (Theta(nan), EnergyRatio(0.5), 1.0, 1.0, "theta0 = NaN: must be finite"),
        (Bottom, EnergyRatio(0.5), 1.0, 0.0, "energy_ratio = 0.5: must be given with a force"),
        (Bottom, Period(7.0), 1.0, 0.0, "period = 7.0: must be given with a force"),
        (Bottom, EnergyRatio(1e308), 1.0, 1e308, "energy_ratio = 1e308: must be such that the velocity"),
    ] {
        let said = refusal(angle, motion, direction, omega2);
        assert!(said.starts_with(begins) && !said.contains('\n'), "{said}");
    }
}

#[test]
fn the_ends_are_orbits() {
    let of = |motion, omega2: f64| {
        let start = OrbitStart::new(StartAngle::Bottom, motion, -1.0);
        Orbit::from_start(start, Frequency::from_omega2(omega2).unwrap()).unwrap()
    };
    for (motion, regime) in [
        (StartMotion::EnergyRatio(0.0), Regime::Rest),
        (StartMotion::EnergyRatio(1.0), Regime::Separatrix),
        (StartMotion::EnergyRatioC(5e-324), Regime::Libration),
        (StartMotion::EnergyRatioC(-5e-324), Regime::Rotation),
        (StartMotion::EnergyRatio(1e300), Regime::Rotation),
        (StartMotion::ThetaMax(0.0), Regime::Rest),
        (StartMotion::ThetaMaxFromTop(0.0), Regime::Separatrix),
        (StartMotion::Period(f64::INFINITY), Regime::Separatrix),
        (StartMotion::PeriodOfRotation(f64::INFINITY), Regime::Separatrix),
        (StartMotion::Period(std::f64::consts::TAU), Regime::Rest),
        (StartMotion::PeriodOfRotation(1e-100), Regime::Rotation),
    ] {
        for omega2 in [1.0, -1.0] {
            assert_eq!(of(motion, omega2).regime(), regime, "{motion:?} {omega2}");
        }
    }
    // Without a force.
    let (energy, turn) = (of(StartMotion::Energy(2.0), 0.0), of(StartMotion::PeriodOfRotation(2.0), 0.0));
    assert_eq!((energy.velocity0(), turn.velocity0()), (-2.0, -std::f64::consts::PI));
    // A velocity beyond the doubles that the energy, and not its double, has.
    assert_eq!(of(StartMotion::Energy(f64::MAX), 1.0).velocity0(), -(f64::MAX.sqrt() * 2f64.sqrt()));
}

#[test]
fn passages_of_a_pencil_and_of_an_energy() {
    let start = OrbitStart::new(StartAngle::FromTop(1e-17), StartMotion::Velocity(0.0), 1.0);
    let pencil = Orbit::from_start(start, Frequency::from_omega2(73.5).unwrap()).unwrap();
    let fallen = pencil.next_time(1.5 * std::f64::consts::PI, 0.0).unwrap().unwrap();
    assert!((fallen - 4.705_588_133_717_229_4).abs() <= 2.0 * ulp(fallen), "{fallen}");
    // There and back by an energy: an angle is met where the motion is at it.
    for (value, angle) in [(1e-17, 3.1), (1e-20, -3.0), (0.3, 1.9), (1e-300, 0.1), (-1e-17, 3.0)] {
        let start = OrbitStart::new(StartAngle::Theta(0.5), StartMotion::EnergyRatioC(value), 1.0);
        let orbit = Orbit::from_start(start, Frequency::from_omega0(1.0).unwrap()).unwrap();
        let time = orbit.next_time(angle, 0.0).unwrap().unwrap();
        assert!((orbit.theta(time) - angle).abs() < 1e-13, "{value} {angle} {time}");
    }
}

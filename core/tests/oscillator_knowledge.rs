//! What a Duffing oscillator keeps, with even powers and without: action, frequency, phase, Fourier series, derivatives, starts.

use libration::Duffing;

/// u0, velocity0, p, q, r, c of motions that stay, of every class.
const BOUNDED: [[f64; 6]; 8] = [
    [0.6, 0.1, 1.0, 0.2, 0.5, 0.0],
    [1.0, 0.0, 1.0, 1.0, 0.0, 0.0],
    [0.6, 0.1, -1.0, 1.0, 0.2, 0.1],
    [1.9, 0.3, -1.0, 1.0, 0.2, 0.1],
    [0.3, -0.2, 1.0, -0.2, 0.1, 0.05],
    [0.3, -0.2, 1.0, 0.0, 0.5, -0.1],
    [-0.4, 0.5, 1.0, 0.0, 0.0, 0.3],
    [-1.2, 0.0, -1.0, 1.0, -0.3, 0.0],
];

fn orbit([u0, velocity0, force @ ..]: [f64; 6]) -> Duffing {
    Duffing::with_even_powers(u0, velocity0, force).unwrap()
}

/// The series is the motion, and its sum the action; dJ/dE is 1/frequency.
#[test]
fn actions_and_series() {
    for given in BOUNDED {
        let one = orbit(given);
        let series = one.fourier(80).unwrap();
        let mut squares = 0.0;
        for k in 0..64 {
            let t = one.period() * f64::from(k) / 64.0;
            let phase = one.phase(t);
            let (mut u, mut velocity) = (series.mean, 0.0);
            for (n, (a, b)) in series.u.iter().zip(&series.velocity).enumerate() {
                let angle = (n + 1) as f64 * phase;
                u += a * angle.cos();
                velocity += b * angle.sin();
            }
            assert!((u - one.u(t)).abs() < 1e-14, "{given:?} {t}");
            assert!((velocity - one.velocity(t)).abs() < 3e-14, "{given:?} {t}");
            squares += one.velocity(t).powi(2) / 64.0;
        }
        let action = squares / one.frequency();
        assert!((one.action() / action - 1.0).abs() < 1e-13, "{given:?} {} {action}", one.action());
        let distortion = series.u[1..].iter().map(|a| a * a).sum::<f64>().sqrt() / series.u[0].abs();
        assert!((one.distortion() - distortion).abs() < 1e-15, "{given:?}");
        // The same action from every state of the motion, and the phase goes on.
        let t = 0.37 * one.period();
        let mut later = given;
        (later[0], later[1]) = one.motion(t);
        assert!((orbit(later).action() / one.action() - 1.0).abs() < 1e-13, "{given:?}");
        let turned = (orbit(later).phase(0.0) - one.phase(t)).rem_euclid(core::f64::consts::TAU);
        assert!(turned.min(core::f64::consts::TAU - turned) < 1e-12, "{given:?} {turned}");
        if given[1] != 0.0 {
            let mut beside = [given; 2];
            beside[0][1] *= 1.0 + 1e-5;
            beside[1][1] *= 1.0 - 1e-5;
            let [up, down] = beside.map(orbit);
            let slope = (up.action() - down.action()) / (up.energy() - down.energy());
            assert!((slope * one.frequency() - 1.0).abs() < 1e-7, "{given:?} {slope}");
        }
    }
}

/// On a separatrix the action is the limit of those beside it.
#[test]
fn separatrices() {
    // sech: u = sech(t/sqrt 2), the integral of u'^2 is sqrt 2/3.
    let sech = Duffing::new(1.0, 0.0, -0.5, 1.0).unwrap();
    assert_eq!((sech.regime().name(), sech.frequency()), ("homoclinic", 0.0));
    assert!((sech.action() * core::f64::consts::TAU * 3.0 / 2f64.sqrt() - 1.0).abs() < 1e-14);
    // u'' + u - u^2 = 0 from the saddle's orbit: u = 1 - 1.5 sech^2(t/2), the integral is 6/5.
    let drop = Duffing::with_even_powers(-0.5, 0.0, [1.0, 0.0, -1.0, 0.0]).unwrap();
    assert_eq!((drop.regime().name(), drop.frequency()), ("homoclinic", 0.0));
    assert!((drop.action() * core::f64::consts::TAU - 1.2).abs() < 1e-14, "{}", drop.action());
    // tanh, there and back: u = tanh t for u'' + 2 u - 2 u^3 = 0, the integral is 4/3 each way.
    let tanh = Duffing::new(0.0, 1.0, 2.0, -2.0).unwrap();
    assert_eq!(tanh.regime().name(), "heteroclinic");
    assert!((tanh.action() * core::f64::consts::TAU * 3.0 / 8.0 - 1.0).abs() < 1e-14);
}

/// Differences of motions.
#[test]
fn derivatives() {
    for given in
        BOUNDED.into_iter().chain([[0.5, 1.0, 1.0, -0.5, -1.5, 0.2], [0.2, 0.1, -1.0, 0.0, 0.0, 0.3]])
    {
        let one = orbit(given);
        let ahead = if one.escape_time().is_finite() { 0.6 * one.escape_time() } else { 3.0 };
        for t in [ahead, -0.4, 0.0] {
            let found = one.derivatives(t);
            let size = found.as_flattened().iter().fold(1.0, |size: f64, x| size.max(x.abs()));
            for k in 0..6 {
                let mut beside = [given; 2];
                beside[0][k] += 1e-5;
                beside[1][k] -= 1e-5;
                let [up, down] = beside.map(|given| orbit(given).motion(t));
                let number = [(up.0 - down.0) / 2e-5, (up.1 - down.1) / 2e-5];
                for i in 0..2 {
                    let off = (found[i][k] - number[i]).abs();
                    assert!(off < 1e-7 * size.powi(3), "{given:?} {t} {k} {found:?} {number:?}");
                }
            }
        }
        if one.period().is_finite() {
            let [[a, b, ..], [c, d, ..]] = one.derivatives(1e3 * one.period() + 0.3);
            assert!((a * d - b * c - 1.0).abs() < 1e-11 * (a * d).abs().max(1.0), "{given:?}");
        }
    }
}

/// Action and phase, and energy, there and back.
#[test]
fn starts() {
    for given in BOUNDED {
        let one = orbit(given);
        let force = one.coefficients();
        let (low, high) = one.range();
        let about = Some(0.5 * (low + high));
        let back = Duffing::from_action_phase(one.action(), one.phase(0.0), about, force).unwrap();
        assert!((back.action() / one.action() - 1.0).abs() < 1e-13, "{given:?}");
        let scale = low.abs().max(high.abs());
        assert!((back.u0() - one.u0()).abs() < 1e-12 * scale, "{given:?} {}", back.u0());
        let again = Duffing::from_energy(one.energy(), one.u0(), 1.0, force).unwrap();
        assert!((again.velocity0() - one.velocity0().abs()).abs() < 1e-7, "{given:?}");
    }
    let refused = |made: Result<Duffing, libration::Domain>| made.unwrap_err().to_string();
    let wells = [-1.0, 1.0, 0.1, 0.0];
    assert!(refused(Duffing::from_action_phase(0.1, 0.0, None, wells)).starts_with("about = None"));
    let softening = Duffing::from_action_phase(9.0, 0.0, None, [1.0, -1.0, 0.0, 0.0]);
    assert!(refused(softening).starts_with("action = 9.0: must be that of a motion about"));
}

//! How angle and velocity change with the start and the force: closed forms of the variational equation
//! y'' = -cos(theta) y, in units of omega0 (kappa omega0 in rotation).
//!
//! Two solutions along the canonical motion, at its phase u, with a' = -b, p' = q and a q + b p = 1:
//!   libration   a = cn,    b = sn dn,      p = cn int_0^u nc^2 = (sn dn - cn int_0^u m cn^2)/mc,
//!   rotation    a = dn,    b = m sn cn,    p = dn int_0^u nd^2,  both of the parameter m in [0, 1],
//!   separatrix  a = sech,  b = sech tanh,  p = (sinh u + u sech u)/2,
//! the integrals by the Carlson forms whose terms are all positive, between the nearest quarter periods; n half periods
//! add n times a constant times a. With 0 for the start and sigma = 1 (kappa in rotation):
//!   dtheta/dtheta0 = a q0 + p b0,                     omega0 dtheta/dvelocity0 = (a0 p - p0 a)/sigma,
//!   dvelocity/dtheta0 = sigma omega0 (q b0 - b q0),   dvelocity/dvelocity0 = a0 q + p0 b,
//! and by omega0, because theta(t; theta0, velocity0, omega0) = theta(omega0 t; theta0, velocity0/omega0, 1).
//! Source: DLMF 22.13(i), 22.16(ii), 19.25(i); the derivative by kappa^2 of Salas 2019 (23).

use super::orbit::{Course, Orbit, carried};
use super::regime::Regime;
use super::sensitivity_lanes::{Fill, Slopes};
use super::state::State;
use crate::elliptic::integrals::carlson_duplication::{THIRD, rd, rf};
use crate::elliptic::integrals::complete::{complete_difference_dd, complete_e_dd};
use crate::elliptic::parameter::Parameter;
use crate::elliptic::phase::{LAST_HALF_PERIOD, Phase, ReducedPhase};
use crate::elliptic::theta::neville::NevilleTheta;
use crate::float::exponent::ldexp;
use crate::float::series::long_sinh_cosh;
use crate::float::{Dd, PI, Scaled};

/// Rows: angle, velocity. Columns: their derivatives by the initial angle, the initial velocity and omega0.
pub type Jacobian = [[f64; 3]; 2];

const UNDEFINED: Jacobian = [[f64::NAN; 3]; 2];

/// The two solutions at a phase; next to the top they leave the range of the doubles.
#[derive(Clone, Copy, Debug)]
pub(super) struct Solutions {
    pub a: Scaled,
    pub b: Scaled,
    pub p: Scaled,
    pub q: Scaled,
}

/// A motion that theta functions describe.
#[derive(Clone, Debug)]
pub(super) struct Periodic {
    pub rotation: bool,
    pub parameter: Parameter,
    pub lattice: NevilleTheta,
    /// What a half period adds to p/a.
    shift: Scaled,
}

/// The formula that the regime asks for.
#[derive(Clone, Debug)]
enum Kind {
    /// Without force, or faster than it counts: what omega0 changes is below 2^-100 of the rest, and left out.
    Straight,
    /// On the upper equilibrium.
    Balance,
    Periodic(Box<Periodic>),
    Separatrix,
}

/// The derivatives of one orbit, set up once for many times.
///
/// ```
/// use libration::{Frequency, Orbit, Sensitivity};
/// let orbit = Orbit::new(3.0, 0.0, Frequency::from_omega0(1.0)?)?;
/// let [angle, _] = Sensitivity::new(&orbit).at(5.0);
/// assert_eq!(angle.map(|slope| format!("{slope:.6}")).join(" "), "9.258339 9.427493 -6.652040");
/// # Ok::<(), libration::Domain>(())
/// ```
#[derive(Clone, Debug)]
pub struct Sensitivity {
    kind: Kind,
    /// The same in double over lanes, where that keeps enough digits.
    slopes: Option<Box<Slopes>>,
    pub(super) phase: Phase,
    pub(super) time_scale: f64,
    pub(super) start: Solutions,
    /// Time runs so much faster than omega0 t: 1, or kappa in rotation.
    pub(super) stretch: Dd,
    /// kappa and velocity0/2 omega0, over 2^power.
    pub(super) k: Dd,
    pub(super) x: Dd,
    pub(super) power: i32,
    pub(super) omega: Dd,
    pub(super) omega_power: i32,
    pub(super) side: f64,
}

/// Where dn is smaller, 1 is lost beside its inverse square.
const TOP: f64 = 1e-60;

/// p and q next to the top, where a and b are as on the separatrix, but for the size of cn beside dn.
fn top([sn, cn, dn]: [Dd; 3]) -> [Scaled; 2] {
    let q = Scaled::ONE / Scaled::from(dn + cn);
    [q * Scaled::from(sn), q]
}

/// m int cn^2 from 0 to the u of sn, cn, dn.
pub(super) fn cosine_integral(m: Dd, [sn, cn, dn]: [Dd; 3]) -> Dd {
    let (s2, c2, d2) = (sn.square(), cn.square(), dn.square());
    m * sn * (rf(c2, d2, Dd::ONE) - s2 * THIRD * rd(c2, d2, Dd::ONE))
}

/// p and q of a libration between the quarter periods.
fn swing(Parameter { m, mc, .. }: Parameter, values: [Dd; 3]) -> [Scaled; 2] {
    let [sn, cn, dn] = values;
    if dn.hi < TOP {
        return top(values);
    }
    let (s2, c2, d2) = (sn.square(), cn.square(), dn.square());
    if m.hi > 0.5 && c2.hi > mc.hi {
        let integral = sn * (rf(c2, d2, Dd::ONE) + s2 * THIRD * rd(Dd::ONE, d2, c2));
        return [cn * integral, Dd::ONE / cn - sn * dn * integral].map(Scaled::from);
    }
    // The integral of nc^2 has a pole at the quarter period; that of cn^2 has none, and mc is not small beside cn^2.
    let integral = cosine_integral(m, values);
    [(sn * dn - cn * integral) / mc, (sn * dn * integral + cn * (mc - m * s2)) / mc].map(Scaled::from)
}

/// p and q of a rotation between the quarter periods.
fn spin(Parameter { m, .. }: Parameter, values: [Dd; 3]) -> [Scaled; 2] {
    let [sn, cn, dn] = values;
    if dn.hi < TOP {
        return top(values);
    }
    let (s2, c2, d2) = (sn.square(), cn.square(), dn.square());
    let integral = sn * (rf(c2, d2, Dd::ONE) + m * s2 * THIRD * rd(c2, Dd::ONE, d2));
    [dn * integral, Dd::ONE / dn - m * sn * cn * integral].map(Scaled::from)
}

/// Hyperbolic angles up to here have their sine without cancellation, and beyond it only one exponential counts.
const NEAR: f64 = 300.0;
/// Beyond, everything is out of the doubles.
const FAR: f64 = 1e7;

/// rate t, held where it is far out.
fn bounded(rate: Dd, t: f64) -> Dd {
    if (rate.hi * t).abs() < FAR { rate * t } else { Dd::from(FAR.copysign(t)) }
}

/// sinh y and cosh y.
fn hyperbolic(y: Dd) -> [Scaled; 2] {
    let sign = 1f64.copysign(y.hi);
    if y.hi.abs() < NEAR {
        let (sinh, cosh) = long_sinh_cosh(y.abs());
        return [sinh * sign, cosh].map(Scaled::from);
    }
    let half = Scaled::exp(y.abs()).shift(-1);
    [half * sign, half]
}

/// The solutions on the separatrix.
fn ridge(y: Dd) -> Solutions {
    let [sinh, cosh] = hyperbolic(y);
    let a = Scaled::ONE / cosh;
    let (b, y) = (a.square() * sinh, Scaled::from(y));
    Solutions { a, b, p: (sinh + y * a).shift(-1), q: (cosh + a - y * b).shift(-1) }
}

impl Periodic {
    /// At sn, cn, dn between the quarter periods.
    fn solutions(&self, values: [Dd; 3]) -> Solutions {
        let [sn, cn, dn] = values;
        let (a, b, [p, q]) = if self.rotation {
            (dn, self.parameter.m * sn * cn, spin(self.parameter, values))
        } else {
            (cn, sn * dn, swing(self.parameter, values))
        };
        Solutions { a: a.into(), b: b.into(), p, q }
    }

    /// At a reduced phase.
    fn at(&self, at: ReducedPhase<f64>) -> Solutions {
        let values = self.lattice.long_values(&ReducedPhase { parity: 1.0, ..at });
        let Solutions { a, b, p, q } = self.solutions(values);
        let periods = self.shift * Scaled::from(at.n);
        let sign = if self.rotation { 1.0 } else { at.parity };
        Solutions { a: a * sign, b: b * sign, p: (p + periods * a) * sign, q: (q - periods * b) * sign }
    }
}

impl Sensitivity {
    /// Of an orbit, by its own initial angle, initial velocity and omega0 = sqrt|omega0^2|.
    pub fn new(orbit: &Orbit) -> Sensitivity {
        let origin = Solutions { a: Scaled::ONE, b: Scaled::ZERO, p: Scaled::ZERO, q: Scaled::ONE };
        let still = Sensitivity {
            kind: Kind::Straight,
            slopes: None,
            phase: Phase { rate: Dd::ZERO, start: Dd::ZERO },
            time_scale: orbit.time_scale,
            start: origin,
            stretch: Dd::ONE,
            k: Dd::ZERO,
            x: Dd::ZERO,
            power: 0,
            omega: Dd::ONE,
            omega_power: 0,
            side: 1.0,
        };
        let made = match State::new(orbit.theta0, orbit.velocity0, orbit.force) {
            Ok(state) => still.along(orbit, &state),
            Err(_) => still.plain(orbit),
        };
        let slopes = match &made.kind {
            Kind::Periodic(periodic) => Slopes::new(&made, periodic).map(Box::new),
            _ => None,
        };
        Sensitivity { slopes, ..made }
    }

    /// Every time, over the lanes that `run` takes or one by one.
    fn sample(&self, t: &[f64], mut results: [&mut [f64]; 6], run: fn(Fill<'_, '_>)) {
        if let Some(slopes) = &self.slopes {
            return run(Fill { slopes, t, results });
        }
        for (row, t) in t.iter().enumerate() {
            for (column, slope) in results.iter_mut().zip(self.careful(*t).as_flattened()) {
                column[row] = *slope;
            }
        }
    }

    /// At rest, or straight.
    fn plain(self, orbit: &Orbit) -> Sensitivity {
        let Some((root, omega_power)) = orbit.force.root().filter(|_| orbit.regime() == Regime::Rest) else {
            return self;
        };
        let (inside, outside) = carried(omega_power);
        let omega = root.to_dd();
        let periodic = Periodic {
            rotation: false,
            parameter: Parameter::new(Dd::ZERO, Dd::ONE),
            lattice: NevilleTheta::new(Dd::ZERO, Dd::ONE, Dd::ZERO, Dd::ONE),
            shift: Scaled::ZERO,
        };
        Sensitivity {
            kind: Kind::Periodic(Box::new(periodic)),
            phase: Phase { rate: omega.ldexp(inside) / PI, start: Dd::ZERO },
            time_scale: ldexp(1.0, outside),
            omega,
            omega_power,
            ..self
        }
    }

    fn along(self, orbit: &Orbit, state: &State) -> Sensitivity {
        let State { s, c, x, k, kc, m, mc, power, omega, omega_power, frame, .. } = *state;
        let common = Sensitivity { k, x, power, omega, omega_power, side: frame.side, ..self };
        match &orbit.course {
            Course::Libration(elliptic) => {
                let parameter = Parameter::new(m.ldexp(2 * power), mc);
                let shift =
                    Scaled::from(complete_difference_dd(parameter).scale(-2.0)) / Scaled::from(kc).square();
                let lattice = elliptic.lattice.clone();
                let periodic = Periodic { rotation: false, parameter, lattice, shift };
                let start = periodic.solutions([s / k, x / k, c]);
                Sensitivity {
                    kind: Kind::Periodic(Box::new(periodic)),
                    phase: elliptic.phase,
                    start,
                    ..common
                }
            }
            Course::Rotation(elliptic) => {
                let parameter = Parameter::new(Dd::ONE / m, -mc / m);
                let shift = Scaled::from(complete_e_dd(parameter).scale(2.0)) / Scaled::from(kc / k).square();
                let lattice = elliptic.lattice.clone();
                let periodic = Periodic { rotation: true, parameter, lattice, shift };
                let start = periodic.solutions([s, c, x / k]);
                let kind = Kind::Periodic(Box::new(periodic));
                Sensitivity { kind, phase: elliptic.phase, start, stretch: k, ..common }
            }
            Course::Separatrix(phase, _) => {
                let (inverse, b, y) = (Scaled::ONE / Scaled::from(c), s * c, phase.start);
                let p = (inverse * Scaled::from(s) + Scaled::from(y * c)).shift(-1);
                let q = (inverse + Scaled::from(c - y * b)).shift(-1);
                let start = Solutions { a: c.into(), b: b.into(), p, q };
                Sensitivity { kind: Kind::Separatrix, phase: *phase, start, ..common }
            }
            Course::Still | Course::Free => {
                let (inside, outside) = carried(omega_power);
                let phase = Phase { rate: omega.ldexp(inside), start: Dd::ZERO };
                Sensitivity { kind: Kind::Balance, phase, time_scale: ldexp(1.0, outside), ..common }
            }
        }
    }

    /// The derivatives at t (in s).
    ///
    /// NaN for times that are not finite or more than 2^53 half periods away; infinite where a derivative is beyond
    /// the doubles. **Error** in each row at most 1e-12 of the largest change: the three derivatives times the largest
    /// angle, the largest velocity and omega0.
    pub fn at(&self, t: f64) -> Jacobian {
        let mut slopes = [[0.0]; 6];
        self.sample(&[t], slopes.each_mut().map(|column| column.as_mut_slice()), |fill| fill.run::<false>());
        let [[a], [b], [c], [d], [e], [f]] = slopes;
        [[a, b, c], [d, e, f]]
    }

    /// [`Sensitivity::at`] of every time, bit for bit, on the widest lanes, row by row of the matrix; panics where the
    /// lengths differ.
    pub fn at_into(&self, t: &[f64], slopes: [&mut [f64]; 6]) {
        assert!(
            slopes.iter().all(|column| column.len() == t.len()),
            "results of another length than the times"
        );
        self.sample(t, slopes, |fill| fill.run::<true>());
    }

    /// By Carlson's integrals in double-double.
    fn careful(&self, t: f64) -> Jacobian {
        if !t.is_finite() {
            return UNDEFINED;
        }
        if t == 0.0 {
            return [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        }
        let passed = t * self.time_scale;
        match &self.kind {
            Kind::Straight => [[1.0, t, 0.0], [0.0, 1.0, 0.0]],
            Kind::Balance => self.balance(bounded(self.phase.rate, passed)),
            Kind::Separatrix => {
                let y = bounded(self.phase.rate, passed) + self.phase.start;
                self.assembled(passed, &ridge(y))
            }
            Kind::Periodic(periodic) => {
                let at = self.phase.reduce(passed);
                let half_periods = if periodic.rotation { 2.0 * at.n.hi } else { at.n.hi };
                if half_periods.abs() < LAST_HALF_PERIOD {
                    self.assembled(passed, &periodic.at(at))
                } else {
                    UNDEFINED
                }
            }
        }
    }

    fn assembled(&self, passed: f64, now: &Solutions) -> Jacobian {
        let [k, x, stretch, omega] = [self.k, self.x, self.stretch, self.omega].map(Scaled::from);
        let (k, x, omega) = (k.shift(self.power), x.shift(self.power), omega.shift(self.omega_power));
        let start = &self.start;
        let by_velocity = (start.a * now.p - start.p * now.a) / stretch;
        let rate_by_velocity = start.a * now.q + start.p * now.b;
        let turned = Scaled::from(self.omega.ldexp(carried(self.omega_power).0)) * passed;
        let by_force = k * now.a * turned - x * by_velocity;
        let rate_by_force = k * now.a - stretch * k * now.b * turned - x * rate_by_velocity;
        let twice = 2.0 * self.side;
        [
            [now.a * start.q + now.p * start.b, by_velocity / omega, by_force * twice / omega],
            [(now.q * start.b - now.b * start.q) * stretch * omega, rate_by_velocity, rate_by_force * twice],
        ]
        .map(|row| row.map(Scaled::value))
    }

    /// On the upper equilibrium: cosh y, and sinh y over and times omega0.
    fn balance(&self, y: Dd) -> Jacobian {
        let ([sinh, cosh], omega) = (hyperbolic(y), Scaled::from(self.omega).shift(self.omega_power));
        [[cosh, sinh / omega, Scaled::ZERO], [sinh * omega, cosh, Scaled::ZERO]]
            .map(|row| row.map(Scaled::value))
    }
}

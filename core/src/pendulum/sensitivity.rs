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

use super::canonical::LAST_HALF_PERIOD;
use super::orbit::{Course, Orbit, carried, divisor};
use super::regime::Regime;
use super::state::State;
use crate::elliptic::carlson::{THIRD, rd, rf};
use crate::elliptic::complete::{complete_difference_dd, complete_e_dd};
use crate::elliptic::parameter::Parameter;
use crate::elliptic::phase::{Phase, Reduced};
use crate::elliptic::theta::Lattice;
use crate::float::elementary::long_sinh_cosh;
use crate::float::scaling::ldexp;
use crate::float::{Dd, LN_2, PI};

/// Rows: angle, velocity. Columns: their derivatives by the initial angle, the initial velocity and omega0.
pub type Jacobian = [[f64; 3]; 2];

const UNDEFINED: Jacobian = [[f64::NAN; 3]; 2];

/// The two solutions at a phase: `a`, `b` over 2^-power and `p`, `q` over 2^power.
#[derive(Clone, Copy, Debug)]
struct Solutions {
    a: Dd,
    b: Dd,
    p: Dd,
    q: Dd,
    power: i32,
}

/// A motion that theta functions describe.
#[derive(Clone, Debug)]
struct Periodic {
    rotation: bool,
    parameter: Parameter,
    lattice: Lattice,
    /// What a half period adds to p/a, times mc.
    shift: Dd,
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
/// assert_eq!(angle.map(|slope| format!("{slope:.6}")).join(" "), "9.817411 -8.857867 -6.984785");
/// # Ok::<(), libration::Domain>(())
/// ```
#[derive(Clone, Debug)]
pub struct Sensitivity {
    kind: Kind,
    phase: Phase,
    time_scale: f64,
    start: Solutions,
    /// Time runs so much faster than omega0 t: 1, or kappa in rotation.
    stretch: Dd,
    /// kappa and velocity0/2 omega0, over 2^power.
    k: Dd,
    x: Dd,
    power: i32,
    omega: Dd,
    omega_power: i32,
    side: f64,
}

/// Where dn is smaller, 1 is lost beside its inverse square.
const TOP: f64 = 1e-60;

/// p and q next to the top, where a and b are as on the separatrix, but for the size of cn beside dn.
fn top([sn, cn, dn]: [Dd; 3]) -> (Dd, Dd) {
    let q = Dd::ONE / (dn + cn);
    (sn * q, q)
}

/// p and q of a libration between the quarter periods.
fn swing(Parameter { m, mc }: Parameter, values: [Dd; 3]) -> (Dd, Dd) {
    let [sn, cn, dn] = values;
    if dn.hi < TOP {
        return top(values);
    }
    let (s2, c2, d2) = (sn.square(), cn.square(), dn.square());
    if m.hi > 0.5 && c2.hi > mc.hi {
        let integral = sn * (rf(c2, d2, Dd::ONE) + s2 * THIRD * rd(Dd::ONE, d2, c2));
        return (cn * integral, Dd::ONE / cn - sn * dn * integral);
    }
    // The integral of nc^2 has a pole at the quarter period; that of cn^2 has none, and mc is not small beside cn^2.
    let integral = m * sn * (rf(c2, d2, Dd::ONE) - s2 * THIRD * rd(c2, d2, Dd::ONE));
    ((sn * dn - cn * integral) / mc, (sn * dn * integral + cn * (mc - m * s2)) / mc)
}

/// p and q of a rotation between the quarter periods.
fn spin(Parameter { m, .. }: Parameter, values: [Dd; 3]) -> (Dd, Dd) {
    let [sn, cn, dn] = values;
    if dn.hi < TOP {
        return top(values);
    }
    let (s2, c2, d2) = (sn.square(), cn.square(), dn.square());
    let integral = sn * (rf(c2, d2, Dd::ONE) + m * s2 * THIRD * rd(c2, Dd::ONE, d2));
    (dn * integral, Dd::ONE / dn - m * sn * cn * integral)
}

/// Beyond this hyperbolic angle only the growing exponential is left.
const FAR: f64 = 300.0;

/// e^|y| as a factor and a power of two.
fn grown(y: Dd) -> (Dd, i32) {
    let power = (y.hi.abs() / LN_2.hi).round();
    let rest = y.abs() - LN_2.to_dd() * power;
    let (sine, cosine) = long_sinh_cosh(rest.abs());
    (cosine + sine * 1f64.copysign(rest.hi), power as i32)
}

/// The solutions on the separatrix.
fn ridge(y: Dd) -> Solutions {
    let sign = 1f64.copysign(y.hi);
    if y.hi.abs() > FAR {
        let (grown, power) = grown(y);
        let (a, q) = (Dd::from(2.0) / grown, grown.scale(0.25));
        return Solutions { a, b: a * sign, p: q * sign, q, power };
    }
    let (sinh, cosh) = long_sinh_cosh(y.abs());
    let a = Dd::ONE / cosh;
    let b = a * a * sinh * sign;
    Solutions { a, b, p: (sinh * sign + y * a).scale(0.5), q: (cosh + a - y * b).scale(0.5), power: 0 }
}

impl Periodic {
    /// At sn, cn, dn between the quarter periods.
    fn solutions(&self, values: [Dd; 3]) -> Solutions {
        let [sn, cn, dn] = values;
        let (a, b, (p, q)) = if self.rotation {
            (dn, self.parameter.m * sn * cn, spin(self.parameter, values))
        } else {
            (cn, sn * dn, swing(self.parameter, values))
        };
        Solutions { a, b, p, q, power: 0 }
    }

    /// At a reduced phase.
    fn at(&self, at: Reduced<f64>) -> Solutions {
        let Solutions { a, b, p, q, power } =
            self.solutions(self.lattice.long_values(&Reduced { parity: 1.0, ..at }));
        let sign = if self.rotation { 1.0 } else { at.parity };
        if at.n.hi == 0.0 {
            return Solutions { a, b, p, q, power };
        }
        // Over mc in two steps: alone it may be below the range.
        let kc = divisor(self.lattice.kc);
        let periods = at.n * self.shift / kc;
        let (p, q) = (p + periods * (a / kc), q - periods * (b / kc));
        Solutions { a: a * sign, b: b * sign, p: p * sign, q: q * sign, power }
    }
}

/// steady + growing 2^power: what has been left out of the doubles stays apart until the end.
#[derive(Clone, Copy)]
struct Weighed {
    steady: Dd,
    growing: Dd,
    power: i32,
}

impl Weighed {
    fn times(self, factor: Dd) -> Weighed {
        Weighed { steady: self.steady * factor, growing: self.growing * factor, power: self.power }
    }
    fn plus(self, steady: Dd) -> Weighed {
        Weighed { steady: self.steady + steady, ..self }
    }
    /// Times 2^power, rounded; infinite where it is beyond the doubles.
    fn value(self, power: i32) -> f64 {
        if self.power == 0 {
            return ldexp((self.steady + self.growing).value(), power);
        }
        ldexp(self.growing.value(), self.power.saturating_add(power)) + ldexp(self.steady.value(), power)
    }
}

impl Sensitivity {
    /// Of an orbit, by its own initial angle, initial velocity and omega0 = sqrt|omega0^2|.
    pub fn new(orbit: &Orbit) -> Sensitivity {
        let origin = Solutions { a: Dd::ONE, b: Dd::ZERO, p: Dd::ZERO, q: Dd::ONE, power: 0 };
        let still = Sensitivity {
            kind: Kind::Straight,
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
        match State::new(orbit.theta0, orbit.velocity0, orbit.force) {
            Ok(state) => still.along(orbit, &state),
            Err(_) => still.plain(orbit),
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
            parameter: Parameter { m: Dd::ZERO, mc: Dd::ONE },
            lattice: Lattice::new(Dd::ZERO, Dd::ONE, Dd::ZERO, Dd::ONE),
            shift: Dd::ZERO,
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
        let State { s, c, x, k, m, mc, power, omega, omega_power, frame, .. } = *state;
        let common = Sensitivity { k, x, power, omega, omega_power, side: frame.side, ..self };
        match &orbit.course {
            Course::Libration(elliptic) => {
                let parameter = Parameter { m: m.ldexp(2 * power), mc };
                let shift = complete_difference_dd(parameter).scale(-2.0);
                let lattice = elliptic.lattice.clone();
                let periodic = Periodic { rotation: false, parameter, lattice, shift };
                let start = periodic.solutions([s / k, x / k, c]);
                Sensitivity { kind: Kind::Periodic(Box::new(periodic)), phase: elliptic.phase, start, ..common }
            }
            Course::Rotation(elliptic) => {
                let parameter = Parameter { m: Dd::ONE / m, mc: -mc / m };
                let shift = complete_e_dd(parameter).scale(2.0);
                let lattice = elliptic.lattice.clone();
                let periodic = Periodic { rotation: true, parameter, lattice, shift };
                let start = periodic.solutions([s, c, x / k]);
                let kind = Kind::Periodic(Box::new(periodic));
                Sensitivity { kind, phase: elliptic.phase, start, stretch: k, ..common }
            }
            Course::Separatrix(phase, _) => {
                let (inverse, b) = (Dd::ONE / divisor(c), s * c);
                let (p, q) = (s * inverse + phase.start * c, inverse + c - phase.start * b);
                let start = Solutions { a: c, b, p: p.scale(0.5), q: q.scale(0.5), power: 0 };
                Sensitivity { kind: Kind::Separatrix, phase: *phase, start, ..common }
            }
            Course::Still | Course::Free => {
                let (inside, outside) = carried(omega_power);
                let phase = Phase { rate: omega.ldexp(inside), start: Dd::ZERO };
                Sensitivity {
                    kind: Kind::Balance,
                    phase,
                    time_scale: ldexp(1.0, outside),
                    omega,
                    omega_power,
                    ..self
                }
            }
        }
    }

    /// The derivatives at t (in s).
    ///
    /// NaN for times that are not finite or more than 2^53 half periods away; infinite where a derivative is beyond
    /// the doubles. **Error** in each row at most 1e-12 of the largest change: the three derivatives times the largest
    /// angle, the largest velocity and omega0.
    pub fn at(&self, t: f64) -> Jacobian {
        if !t.is_finite() {
            return UNDEFINED;
        }
        if t == 0.0 {
            return [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        }
        let passed = t * self.time_scale;
        match &self.kind {
            Kind::Straight => [[1.0, t, 0.0], [0.0, 1.0, 0.0]],
            Kind::Balance => self.balance(self.phase.rate * passed),
            Kind::Separatrix => self.assembled(passed, &ridge(self.phase.rate * passed + self.phase.start)),
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
        let Sensitivity { start, stretch, k, x, power, omega, omega_power, side, .. } = *self;
        let fallen = |value: Dd| value.ldexp(-now.power);
        let pair = |falling: Dd, growing: Dd| Weighed { steady: fallen(falling), growing, power: now.power };
        let by_angle = pair(now.a * start.q, now.p * start.b);
        let by_velocity = pair(-(start.p * now.a), start.a * now.p).times(Dd::ONE / stretch);
        let rate_by_angle = pair(-(now.b * start.q), now.q * start.b).times(stretch * omega);
        let rate_by_velocity = pair(start.p * now.b, start.a * now.q);
        let turned = omega.ldexp(carried(omega_power).0) * passed;
        let by_force = by_velocity.times(-x).plus(fallen(k * now.a) * turned);
        let rate_by_force = rate_by_velocity
            .times(-x)
            .plus(fallen(k * now.a))
            .plus(-(fallen(k * now.b) * (turned * stretch)));
        let (inverse, twice) = (Dd::ONE / omega, Dd::from(2.0 * side));
        [
            [
                by_angle.value(0),
                by_velocity.times(inverse).value(-omega_power),
                by_force.times(inverse * twice).value(power - omega_power),
            ],
            [
                rate_by_angle.value(omega_power),
                rate_by_velocity.value(0),
                rate_by_force.times(twice).value(power),
            ],
        ]
    }

    /// On the upper equilibrium: cosh y, and sinh y over and times omega0.
    fn balance(&self, y: Dd) -> Jacobian {
        let (sinh, cosh, power) = if y.hi.abs() > FAR {
            let (grown, power) = grown(y);
            (grown.scale(0.5), grown.scale(0.5), power)
        } else {
            let (sinh, cosh) = long_sinh_cosh(y.abs());
            (sinh, cosh, 0)
        };
        let sinh = sinh * 1f64.copysign(y.hi);
        let value = |of: Dd, more: i32| ldexp(of.value(), power.saturating_add(more));
        [
            [value(cosh, 0), value(sinh / self.omega, -self.omega_power), 0.0],
            [value(sinh * self.omega, self.omega_power), value(cosh, 0), 0.0],
        ]
    }
}

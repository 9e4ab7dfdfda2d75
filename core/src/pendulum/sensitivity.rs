//! How angle and velocity change with the start and the force: closed forms by the solutions of the variational equation
//! (variational.rs).
//!
//! With 0 for the start and sigma = 1 (kappa in rotation):
//!   dtheta/dtheta0 = a q0 + p b0,                     omega0 dtheta/dvelocity0 = (a0 p - p0 a)/sigma,
//!   dvelocity/dtheta0 = sigma omega0 (q b0 - b q0),   dvelocity/dvelocity0 = a0 q + p0 b,
//! and by omega0, because theta(t; theta0, velocity0, omega0) = theta(omega0 t; theta0, velocity0/omega0, 1).
//! Source: DLMF 22.13(i), 22.16(ii), 19.25(i); the derivative by kappa^2 of Salas 2019 (23).

use super::orbit::{Orbit, Solution};
use super::regime::Regime;
use super::sensitivity_lanes::SensitivityLanes;
use super::separatrix::Separatrix;
use super::state::State;
use super::variational::{Periodic, Solutions, VariationalSetUp, bounded, on_separatrix};
use crate::elliptic::integrals::complete::{complete_difference_dd, complete_e_dd};
use crate::elliptic::parameter::{Parameter, Unit};
use crate::elliptic::phase::{LAST_HALF_PERIOD, Phase};
use crate::elliptic::theta::neville::NevilleTheta;
use crate::float::exponent::{carried, ldexp};
use crate::float::{Dd, PI, Scaled};
use crate::lanes::{Columns, Once};

/// The first derivatives of angle and velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jacobian {
    /// Of the angle, by the initial angle, the initial velocity and omega0.
    pub theta: [f64; 3],
    /// Of the velocity, likewise.
    pub velocity: [f64; 3],
}

impl Jacobian {
    const UNDEFINED: Jacobian = Jacobian { theta: [f64::NAN; 3], velocity: [f64::NAN; 3] };

    /// From the elements row by row.
    fn of([a, b, c, d, e, f]: [f64; 6]) -> Jacobian {
        Jacobian { theta: [a, b, c], velocity: [d, e, f] }
    }

    /// Row by row: first of the angle, then of the velocity.
    #[must_use]
    pub fn rows(&self) -> [[f64; 3]; 2] {
        [self.theta, self.velocity]
    }
}

/// The derivatives in terms of the solutions of the variational equation.
#[derive(Clone, Debug)]
enum ClosedForm {
    /// Without force, or faster than it counts: what omega0 changes is below 2^-100 of the rest, and left out.
    ForceFree,
    UpperEquilibrium,
    Periodic(Box<Periodic>),
    Separatrix,
}

/// The derivatives of one orbit, set up once for many times.
///
/// ```
/// use libration::{Frequency, Orbit, Sensitivity};
/// let orbit = Orbit::new(3.0, 0.0, Frequency::from_omega0(1.0)?)?;
/// let by = Sensitivity::new(&orbit).at(5.0);
/// assert_eq!(by.theta.map(|derivative| format!("{derivative:.6}")).join(" "), "9.258339 9.427493 -6.652040");
/// # Ok::<(), libration::Domain>(())
/// ```
#[derive(Clone, Debug)]
pub struct Sensitivity {
    closed_form: ClosedForm,
    start: VariationalSetUp,
    /// The same in double over lanes, where that is accurate enough.
    lanes: Option<Box<SensitivityLanes>>,
}

impl Sensitivity {
    /// Of an orbit, by its own initial angle, initial velocity and omega0 = sqrt|omega0^2|.
    #[must_use]
    pub fn new(orbit: &Orbit) -> Sensitivity {
        let start = VariationalSetUp {
            phase: Phase { rate: Dd::ZERO, start: Dd::ZERO },
            time_scale: orbit.time_scale,
            solutions: Solutions::ORIGIN,
            stretch: Dd::ONE,
            k: Dd::ZERO,
            x: Dd::ZERO,
            power: 0,
            omega: Dd::ONE,
            omega_power: 0,
            side: 1.0,
        };
        let (closed_form, start) = match orbit.state {
            Some(state) => along(orbit, &state, start),
            None => not_shaped(orbit, start),
        };
        let lanes = match &closed_form {
            ClosedForm::Periodic(periodic) => SensitivityLanes::new(&start, periodic).map(Box::new),
            _ => None,
        };
        Sensitivity { closed_form, start, lanes }
    }

    /// The derivatives at t (in s).
    ///
    /// NaN for times that are not finite or more than 2^53 half periods away; infinite where a derivative is beyond
    /// the doubles. **Error** in each row at most 1e-12 of the largest change: the three derivatives times the largest
    /// angle, the largest velocity and omega0. Source: DLMF 22.13(i), 22.16(ii); the derivative by kappa^2 of
    /// Salas 2019 (23).
    #[must_use]
    pub fn at(&self, t: f64) -> Jacobian {
        match &self.lanes {
            Some(lanes) => Jacobian::of(lanes.evaluated(Once([t]))),
            None => self.accurate(t),
        }
    }

    /// [`Sensitivity::at`] of every time, bit for bit, on the widest lanes, row by row of the matrix; panics where the
    /// lengths differ.
    pub fn at_into(&self, t: &[f64], mut derivatives: [&mut [f64]; 6]) {
        if let Some(lanes) = &self.lanes {
            return lanes.evaluated(Columns::new([t], derivatives));
        }
        let fits = derivatives.iter().all(|column| column.len() == t.len());
        assert!(fits, "columns of different lengths");
        for (row, t) in t.iter().enumerate() {
            for (column, value) in derivatives.iter_mut().zip(self.accurate(*t).rows().as_flattened()) {
                column[row] = *value;
            }
        }
    }

    /// By Carlson's integrals in double-double.
    fn accurate(&self, t: f64) -> Jacobian {
        if !t.is_finite() {
            return Jacobian::UNDEFINED;
        }
        if t == 0.0 {
            return Jacobian::of([1.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
        }
        let VariationalSetUp { ref phase, time_scale, .. } = self.start;
        let passed = t * time_scale;
        match &self.closed_form {
            ClosedForm::ForceFree => Jacobian::of([1.0, t, 0.0, 0.0, 1.0, 0.0]),
            ClosedForm::UpperEquilibrium => self.at_upper_equilibrium(bounded(phase.rate, passed)),
            ClosedForm::Separatrix => {
                let y = bounded(phase.rate, passed) + phase.start;
                self.assembled(passed, &on_separatrix(y))
            }
            ClosedForm::Periodic(periodic) => {
                let at = phase.reduce(passed);
                let half_periods = if periodic.rotation { 2.0 * at.n.hi } else { at.n.hi };
                if half_periods.abs() < LAST_HALF_PERIOD {
                    self.assembled(passed, &periodic.at(at))
                } else {
                    Jacobian::UNDEFINED
                }
            }
        }
    }

    fn assembled(&self, passed: f64, now: &Solutions) -> Jacobian {
        let VariationalSetUp { solutions: start, k, x, stretch, omega, power, omega_power, side, .. } =
            &self.start;
        let turned = Scaled::from(omega.ldexp(carried(*omega_power).0)) * passed;
        let [k, x, stretch, omega] = [k, x, stretch, omega].map(|value| Scaled::from(*value));
        let (k, x, omega) = (k.shift(*power), x.shift(*power), omega.shift(*omega_power));
        let by_velocity = (start.a * now.p - start.p * now.a) / stretch;
        let rate_by_velocity = start.a * now.q + start.p * now.b;
        let by_force = k * now.a * turned - x * by_velocity;
        let rate_by_force = k * now.a - stretch * k * now.b * turned - x * rate_by_velocity;
        let twice = 2.0 * side;
        let theta = [now.a * start.q + now.p * start.b, by_velocity / omega, by_force * twice / omega];
        let velocity =
            [(now.q * start.b - now.b * start.q) * stretch * omega, rate_by_velocity, rate_by_force * twice];
        Jacobian { theta: theta.map(Scaled::value), velocity: velocity.map(Scaled::value) }
    }

    /// cosh y, and sinh y over and times omega0.
    fn at_upper_equilibrium(&self, y: Dd) -> Jacobian {
        let omega = Scaled::from(self.start.omega).shift(self.start.omega_power);
        let (sinh, cosh) = Scaled::from(y).sinh_cosh();
        Jacobian::of([cosh, sinh / omega, Scaled::ZERO, sinh * omega, cosh, Scaled::ZERO].map(Scaled::value))
    }
}

/// At rest at the stable equilibrium, or without a force that counts.
fn not_shaped(orbit: &Orbit, start: VariationalSetUp) -> (ClosedForm, VariationalSetUp) {
    let Some((root, omega_power)) = orbit.force.root().filter(|_| orbit.regime() == Regime::Rest) else {
        return (ClosedForm::ForceFree, start);
    };
    let (inside, outside) = carried(omega_power);
    let omega = root.to_dd();
    let periodic = Periodic {
        rotation: false,
        parameter: Parameter::new(Dd::ZERO, Dd::ONE),
        lattice: NevilleTheta::new(Unit::ZERO),
        shift: Scaled::ZERO,
    };
    let phase = Phase { rate: omega.ldexp(inside) / PI, start: Dd::ZERO };
    let start = VariationalSetUp { phase, time_scale: ldexp(1.0, outside), omega, omega_power, ..start };
    (ClosedForm::Periodic(Box::new(periodic)), start)
}

/// Of a motion that the force shapes.
fn along(orbit: &Orbit, state: &State, start: VariationalSetUp) -> (ClosedForm, VariationalSetUp) {
    let State { s, c, x, k, power, omega, omega_power, frame, .. } = *state;
    let start = VariationalSetUp { k, x, power, omega, omega_power, side: frame.side, ..start };
    match &orbit.solution {
        Solution::Libration(elliptic) | Solution::Rotation(elliptic) => {
            let rotation = orbit.regime() == Regime::Rotation;
            let unit = state.unit();
            let parameter = unit.parameter();
            let half = if rotation { complete_e_dd(parameter) } else { -complete_difference_dd(parameter) };
            let shift = Scaled::from(half.scale(2.0)) / Scaled::from(unit.kc).square();
            let periodic = Periodic { rotation, parameter, lattice: elliptic.lattice.clone(), shift };
            let solutions = periodic.solutions(state.jacobi());
            let stretch = if rotation { k } else { Dd::ONE };
            let start = VariationalSetUp { phase: elliptic.phase, solutions, stretch, ..start };
            (ClosedForm::Periodic(Box::new(periodic)), start)
        }
        Solution::Separatrix(Separatrix { phase, .. }) => {
            let (inverse, b, y) = (Scaled::ONE / Scaled::from(c), s * c, phase.start);
            let p = (inverse * Scaled::from(s) + Scaled::from(y * c)).shift(-1);
            let q = (inverse + Scaled::from(c - y * b)).shift(-1);
            let solutions = Solutions { a: c.into(), b: b.into(), p, q };
            (ClosedForm::Separatrix, VariationalSetUp { phase: *phase, solutions, ..start })
        }
        Solution::Equilibrium | Solution::ForceFree => {
            let (inside, outside) = carried(omega_power);
            let phase = Phase { rate: omega.ldexp(inside), start: Dd::ZERO };
            (
                ClosedForm::UpperEquilibrium,
                VariationalSetUp { phase, time_scale: ldexp(1.0, outside), ..start },
            )
        }
    }
}

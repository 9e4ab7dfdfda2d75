//! Second derivatives of angle and velocity by the start and the force, where closed forms are accurate.
//!
//! The canonical motion Theta(tau; m), m = kappa^2, once more by m. With S, C, D = sn, cn, dn and the integral
//! G = -mu int cn^2 of the lattice's parameter mu = m in libration, 1/m in rotation,
//!   libration  Theta_m = W/(k mc),  W = S D + C G;      rotation  Theta_m = N/(m - 1),  N = ((1 - mu) u - G) D - mu S C,
//! then from (tau, m) to the start by the inverse of the first derivatives, whose determinant is 2 everywhere, and to
//! omega0 because theta(t; theta0, velocity0, omega0) = theta(omega0 t; theta0, velocity0/omega0, 1). The terms are
//! 1/(m mc^2) times larger than their sum, so there is no closed form to be had next to rest or the separatrix.
//! Source: DLMF 22.13(i), 22.16(ii), 19.4(ii) for the derivatives of am and of the integral by the parameter.

use super::orbit::{Orbit, Solution};
use super::regime::Regime;
use super::state::State;
use super::theta_quotients::Elliptic;
use super::variational::cosine_integral;
use crate::elliptic::integrals::complete::complete_difference_dd;
use crate::elliptic::parameter::Parameter;
use crate::elliptic::phase::{LAST_HALF_PERIOD, ReducedPhase};
use crate::float::Dd;

/// The second derivatives of angle and velocity: symmetric, by the initial angle, the initial velocity and omega0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hessians {
    /// Of the angle.
    pub theta: [[f64; 3]; 3],
    /// Of the velocity.
    pub velocity: [[f64; 3]; 3],
}

impl Hessians {
    const UNDEFINED: Hessians = Hessians::filled(f64::NAN);

    const fn filled(value: f64) -> Hessians {
        Hessians { theta: [[value; 3]; 3], velocity: [[value; 3]; 3] }
    }

    /// First of the angle, then of the velocity.
    #[must_use]
    pub fn matrices(&self) -> [[[f64; 3]; 3]; 2] {
        [self.theta, self.velocity]
    }
}

/// Least and most kappa^2, and least |1 - kappa^2|, where the closed forms are accurate.
const LEAST_RATIO: f64 = 1e-10;
const MOST_RATIO: f64 = 1e16;
const LEAST_COMPLEMENT: f64 = 1e-6;

/// Theta and its derivatives at a phase; `t` is tau.
#[derive(Clone, Copy)]
struct Jet {
    t: Dd,
    sine: Dd,
    cosine: Dd,
    m: Dd,
    mt: Dd,
    mm: Dd,
    mmt: Dd,
}

/// The lattice's functions at a phase u, and the integral G there.
struct Functions {
    s: Dd,
    c: Dd,
    d: Dd,
    u: Dd,
    g: Dd,
}

/// An orbit, set up once for many times.
#[derive(Clone, Debug)]
struct SetUp<'a> {
    elliptic: &'a Elliptic,
    rotation: bool,
    /// kappa, and the lattice's parameter.
    k: Dd,
    parameter: Parameter,
}

impl SetUp<'_> {
    /// At sn, cn, dn between the quarter periods, n half periods on.
    fn functions(&self, values: [Dd; 3], n: Dd, rest: Dd) -> Functions {
        let [s, c, d] = values;
        let half = self.elliptic.lattice.quarter.scale(2.0);
        let integral = cosine_integral(self.parameter.m, values);
        let whole = n * complete_difference_dd(self.parameter).scale(2.0);
        Functions { s, c, d, u: n * half + rest, g: -(whole + integral) }
    }

    /// At a reduced phase.
    fn at(&self, at: &ReducedPhase<f64>) -> Functions {
        let lattice = &self.elliptic.lattice;
        let rest = at.f.scale(at.sign) * lattice.quarter.scale(2.0);
        let values = lattice.long_values(&ReducedPhase { parity: 1.0, ..*at });
        let functions = self.functions(values, at.n, rest);
        Functions { s: functions.s.scale(at.parity), c: functions.c.scale(at.parity), ..functions }
    }

    fn jet(&self, functions: &Functions) -> Jet {
        let Functions { s, c, d, u, g } = *functions;
        let Parameter { m: mu, mc: muc, .. } = self.parameter;
        let (one, two) = (Dd::ONE, Dd::from(2.0));
        // By the parameter, u held: am, then all the others.
        let am = (mu * s * c + g * d) / (mu * muc).scale(2.0);
        let (s_mu, c_mu) = (c * am, -(s * am));
        let d_mu = -(s * (s + mu * s_mu.scale(2.0))) / d.scale(2.0);
        let g_mu = g / mu.scale(2.0) - u.scale(0.5) - d * am;
        if self.rotation {
            let root = self.k;
            let epsilon = muc * u - g;
            let epsilon_mu = -(u + g_mu);
            let n = epsilon * d - mu * s * c;
            let n_mu = epsilon_mu * d + epsilon * d_mu - s * c - mu * (s_mu * c + s * c_mu);
            let n_u = d * d.square() - mu * epsilon * s * c - mu * (c.square() - s.square()) * d;
            let f = mu / muc;
            let t = (root * d).scale(2.0);
            let (sine, cosine) = ((s * c).scale(2.0), one - s.square().scale(2.0));
            let (by_m, mt) = (f * n, f * n_u * root);
            let mm = f * n_u * u * mu.scale(0.5) - mu.square() * (n_mu * f + n / muc.square());
            // Theta_t^2/2 + 1 - cos Theta = 2m, twice by m.
            let mmt = -((mt.square() + cosine * by_m.square() + sine * mm) / t);
            return Jet { t, sine, cosine, m: by_m, mt, mm, mmt };
        }
        let k = self.k;
        let w = s * d + c * g;
        let inner = muc - mu * s.square();
        let w_t = c * inner - s * d * g;
        let w_mu = s_mu * d + s * d_mu + c_mu * g + c * g_mu;
        let w_t_mu = c_mu * inner
            - c * (one + s * (s + mu * s_mu.scale(2.0)))
            - (s_mu * d + s * d_mu) * g
            - s * d * g_mu;
        let (scale, slope) = (k * muc, one / muc - one / (two * mu));
        Jet {
            t: (k * c).scale(2.0),
            sine: (k * s * d).scale(2.0),
            cosine: one - mu * s.square().scale(2.0),
            m: w / scale,
            mt: w_t / scale,
            mm: (w_mu + w * slope) / scale,
            mmt: (w_t_mu + w_t * slope) / scale,
        }
    }
}

/// Quadratic form of second derivatives by (tau, m) along two directions.
fn form([tt, tm, mm]: [Dd; 3], [ta, ma]: [Dd; 2], [tb, mb]: [Dd; 2]) -> Dd {
    tt * ta * tb + tm * (ta * mb + tb * ma) + mm * ma * mb
}

impl Orbit {
    /// Second derivatives of angle and velocity at t (in s) by the initial angle, the initial velocity and omega0.
    ///
    /// NaN where kappa^2 is below 1e-10, above 1e16 or within 1e-6 of 1, where omega0 is out of 1e-100..1e100, and as for
    /// [`Sensitivity::at`](super::Sensitivity::at). **Error** at most 1e-12 of the largest change of a matrix: its
    /// elements times the largest angle, the largest velocity and omega0. Next to t = 0, where all of them vanish, that
    /// holds for |omega0 t| >= 1e-3 only. Source: DLMF 22.13(i), 22.16(ii), 19.4(ii).
    ///
    /// ```
    /// use libration::{Frequency, Orbit};
    /// let orbit = Orbit::new(2.0, 0.0, Frequency::from_omega0(1.0)?)?;
    /// let by = orbit.second_sensitivities(1.0);
    /// assert_eq!(format!("{:.6} {:.6}", by.theta[0][0], by.velocity[1][2]), "0.509444 -0.039893");
    /// # Ok::<(), libration::Domain>(())
    /// ```
    #[must_use]
    pub fn second_sensitivities(&self, t: f64) -> Hessians {
        let Some(state) = self.state else { return Hessians::UNDEFINED };
        let State { x, k, m, mc, omega, omega_power, frame, power, .. } = state;
        let lost = !(LEAST_RATIO..MOST_RATIO).contains(&m.hi) || mc.hi.abs() < LEAST_COMPLEMENT;
        if lost || power != 0 || omega_power.abs() > 332 || !t.is_finite() {
            return Hessians::UNDEFINED;
        }
        let omega = omega.ldexp(omega_power);
        let (Solution::Libration(elliptic) | Solution::Rotation(elliptic)) = &self.solution else {
            return Hessians::UNDEFINED;
        };
        let rotation = self.regime() == Regime::Rotation;
        let set = SetUp { elliptic, rotation, k, parameter: state.unit().parameter() };
        let phase = &set.elliptic.phase;
        let at = phase.reduce(t);
        let half_periods = if set.rotation { 2.0 * at.n.hi } else { at.n.hi };
        if half_periods.is_nan() || half_periods.abs() >= LAST_HALF_PERIOD {
            return Hessians::UNDEFINED;
        }
        if t == 0.0 {
            return Hessians::filled(0.0);
        }
        let began = phase.start * set.elliptic.lattice.quarter.scale(2.0);
        let from = set.jet(&set.functions(state.jacobi(), Dd::ZERO, began));
        let at = if set.rotation { ReducedPhase { parity: 1.0, ..at } } else { at };
        let to = set.jet(&set.at(&at));
        assembled(&from, &to, omega, x.scale(2.0), omega * t, frame.side)
    }
}

/// The matrices, from the derivatives at the start and now, |velocity0|/omega0 and omega0 t.
fn assembled(from: &Jet, to: &Jet, omega: Dd, w: Dd, s: Dd, side: f64) -> Hessians {
    let half = |value: Dd| value.scale(0.5);
    // (tau, m) by the initial angle and velocity.
    let by = [[half(from.mt), half(from.sine)], [-half(from.m), half(from.t)]];
    let second = |jet: &Jet| {
        let accelerating = -(jet.cosine * jet.t);
        [[-jet.sine, jet.mt, jet.mm], [accelerating, -(jet.cosine * jet.m), jet.mmt]]
    };
    let (first, then) = (second(from), second(to));
    // First derivatives now, rows angle and velocity, columns the start; and the second by the start.
    let now = [[to.t, to.m], [-to.sine, to.mt]];
    let along = |row: usize, a: usize| now[row][0] * by[a][0] + now[row][1] * by[a][1];
    let curved = |row: usize, a: usize, b: usize| {
        let bent = [form(first[0], by[a], by[b]), form(first[1], by[a], by[b])];
        let moved = [0, 1].map(|i| by[0][i] * bent[0] + by[1][i] * bent[1]);
        form(then[row], by[a], by[b]) - now[row][0] * moved[0] - now[row][1] * moved[1]
    };
    let angle = |a| along(0, a);
    let [ff, fw, ww] = [curved(0, 0, 0), curved(0, 0, 1), curved(0, 1, 1)];
    let [gff, gfw, gww] = [curved(1, 0, 0), curved(1, 0, 1), curved(1, 1, 1)];
    let (speed, pull) = (to.t, -to.sine);
    let (pull_f, pull_w) = (-(to.cosine * angle(0)), -(to.cosine * angle(1)));
    let pull_s = -(to.cosine * speed);
    let (velocity_f, velocity_w) = (along(1, 0), along(1, 1));
    let two = Dd::from(2.0);
    let theta = [
        ff,
        fw / omega,
        (s * velocity_f - w * fw) / omega,
        ww / omega.square(),
        (s * velocity_w - angle(1) - w * ww) / omega.square(),
        (s.square() * pull - two * s * w * velocity_w + w.square() * ww + two * w * angle(1))
            / omega.square(),
    ];
    let velocity = [
        gff * omega,
        gfw,
        velocity_f + s * pull_f - w * gfw,
        gww / omega,
        (s * pull_w - w * gww) / omega,
        (two * s * pull + s.square() * pull_s - two * s * w * pull_w + w.square() * gww) / omega,
    ];
    // The side of the canonical motion is on the angle and on both of the start, and squares away where it meets itself.
    let matrix = |[aa, ab, ac, bb, bc, cc]: [Dd; 6]| {
        let odd = |value: Dd| side * value.value();
        let even = |value: Dd| value.value();
        [[odd(aa), odd(ab), even(ac)], [odd(ab), odd(bb), even(bc)], [even(ac), even(bc), odd(cc)]]
    };
    Hessians { theta: matrix(theta), velocity: matrix(velocity) }
}

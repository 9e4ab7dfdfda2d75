//! How a motion changes with its start and its coefficients: the variational equations by Taylor series.
//!
//! w'' = F'(u) w + dF/da for a = u0, u0' and the coefficients of F(u) = c - p u - r u^2 - q u^3 - s u^5, together with u'' = F(u), in double-double:
//! next to a separatrix what a rounding makes of w grows like the inverse of the distance to it. Of a motion that repeats
//! the whole periods are taken off: with w after one period the derivative of the period follows, and each period adds it once.
//! Steps are a seventh of the radius of convergence, so that 40 terms leave 1e-33.
//! Source: the method of Taylor series; Hairer, Norsett & Wanner I.14 for the variational equation.

use super::cubic_quintic::CubicQuintic;
use super::even_powers::EvenPowers;
use crate::float::Dd;
use crate::float::exponent::{exp2, ldexp};
use crate::float::scaled::Scaled;

/// Terms of a series, and the share of the radius that a step takes.
const TERMS: usize = 40;
const SHARE: f64 = 0.14;

/// Most steps of one sweep.
const STEPS: usize = 20_000;

/// A coefficient of the force.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Letter {
    P,
    Q,
    R,
    C,
    S,
}

/// The coefficients of the Duffing oscillator, and of the cubic-quintic one.
const EVEN: [Letter; 4] = [Letter::P, Letter::Q, Letter::R, Letter::C];
const QUINTIC: [Letter; 3] = [Letter::P, Letter::Q, Letter::S];

/// A motion as its derivatives need it; the last letters of its columns are those of its coefficients.
struct Motion<const COLUMNS: usize> {
    u0: f64,
    velocity0: f64,
    range: [f64; 2],
    /// p, q, r, c and s.
    force: [f64; 5],
    letters: &'static [Letter],
    period: Scaled,
    escapes: [f64; 2],
    acceleration: Scaled,
}

/// A series.
type Series = [Dd; TERMS];

/// u and its derivatives by the arguments over a step.
struct Step<const COLUMNS: usize> {
    start: Dd,
    length: f64,
    u: Series,
    columns: Box<[Series; COLUMNS]>,
}

/// The equation in units in which the orbit is of order 1.
struct Equation {
    p: f64,
    q: f64,
    r: f64,
    c: f64,
    s: f64,
    letters: &'static [Letter],
    /// Powers of two: of u, and of the time.
    length: i32,
    time: i32,
}

/// u, u' and both of every column.
#[derive(Clone)]
struct State<const COLUMNS: usize> {
    u: [Dd; 2],
    columns: [[Dd; 2]; COLUMNS],
}

/// The derivatives of u and of u' by the arguments.
pub(super) type Derivatives<const COLUMNS: usize> = [[f64; COLUMNS]; 2];

fn power_of(x: f64) -> Option<i32> {
    (x != 0.0 && x.is_finite()).then(|| Scaled::from(x).power())
}

impl Equation {
    fn new<const COLUMNS: usize>(orbit: &Motion<COLUMNS>) -> Equation {
        let [p, q, r, c, s] = orbit.force;
        let sizes = [orbit.u0, orbit.range[0], orbit.range[1]];
        let by_velocity = power_of(orbit.velocity0);
        let known = sizes.iter().filter_map(|x| power_of(*x)).max();
        let half = |x: Option<i32>| x.map(|power| power / 2);
        let length = known.or(by_velocity.map(|v| v - half(power_of(p)).unwrap_or(0))).unwrap_or(0);
        // Powers of the squares of rates.
        let rates = [
            power_of(p),
            power_of(r).map(|x| x + length),
            power_of(q).map(|x| x + 2 * length),
            power_of(c).map(|x| x - length),
            power_of(s).map(|x| x + 4 * length),
            by_velocity.map(|v| 2 * (v - length)),
        ];
        let time = -rates.iter().flatten().max().copied().unwrap_or(0) / 2;
        Equation {
            p: ldexp(p, 2 * time),
            q: ldexp(ldexp(q, 2 * length), 2 * time),
            r: ldexp(ldexp(r, length), 2 * time),
            c: ldexp(ldexp(c, -length), 2 * time),
            s: ldexp(ldexp(s, 4 * length), 2 * time),
            letters: orbit.letters,
            length,
            time,
        }
    }

    fn start<const COLUMNS: usize>(&self, orbit: &Motion<COLUMNS>) -> State<COLUMNS> {
        let mut columns = [[Dd::ZERO; 2]; COLUMNS];
        (columns[0][0], columns[1][1]) = (Dd::ONE, Dd::ONE);
        let u = Dd::from(ldexp(orbit.u0, -self.length));
        let velocity = Dd::from(ldexp(ldexp(orbit.velocity0, -self.length), self.time));
        State { u: [u, velocity], columns }
    }

    fn acceleration(&self, u: Dd) -> Dd {
        let cubic = if self.s == 0.0 { u * self.q } else { u * (u.square() * self.s + Dd::from(self.q)) };
        -(u * (u * (cubic + Dd::from(self.r)) + Dd::from(self.p))) + Dd::from(self.c)
    }

    /// The series from a state.
    fn step<const COLUMNS: usize>(
        &self,
        start: Dd,
        State { u: [place, velocity], columns: states }: &State<COLUMNS>,
    ) -> Step<COLUMNS> {
        let (mut u, mut square, mut cube) = ([Dd::ZERO; TERMS], [Dd::ZERO; TERMS], [Dd::ZERO; TERMS]);
        let (mut fourth, mut fifth) = ([Dd::ZERO; TERMS], [Dd::ZERO; TERMS]);
        let quintic = self.letters.contains(&Letter::S);
        let mut slope = [Dd::ZERO; TERMS];
        let mut columns = Box::new([[Dd::ZERO; TERMS]; COLUMNS]);
        (u[0], u[1]) = (*place, *velocity);
        for (column, [w, speed]) in columns.iter_mut().zip(states) {
            (column[0], column[1]) = (*w, *speed);
        }
        let convolution =
            |a: &Series, b: &Series, k: usize| (0..=k).fold(Dd::ZERO, |sum, i| sum + a[i] * b[k - i]);
        for k in 0..TERMS - 2 {
            square[k] = convolution(&u, &u, k);
            cube[k] = convolution(&square, &u, k);
            slope[k] = -(u[k] * (2.0 * self.r)) - square[k] * (3.0 * self.q);
            let mut force = -(u[k] * self.p) - square[k] * self.r - cube[k] * self.q;
            if k == 0 {
                slope[0] = slope[0] - Dd::from(self.p);
                force = force + Dd::from(self.c);
            }
            if quintic {
                fourth[k] = convolution(&square, &square, k);
                fifth[k] = convolution(&square, &cube, k);
                slope[k] = slope[k] - fourth[k] * (5.0 * self.s);
                force = force - fifth[k] * self.s;
            }
            let over = Dd::from(((k + 1) * (k + 2)) as f64);
            u[k + 2] = force / over;
            let by = |letter: Letter| match letter {
                Letter::P => -u[k],
                Letter::Q => -cube[k],
                Letter::R => -square[k],
                Letter::C => {
                    if k == 0 {
                        Dd::ONE
                    } else {
                        Dd::ZERO
                    }
                }
                Letter::S => -fifth[k],
            };
            let forced = [None, None].into_iter().chain(self.letters.iter().map(|letter| Some(*letter)));
            for (column, letter) in columns.iter_mut().zip(forced) {
                let sum = convolution(&slope, column, k) + letter.map_or(Dd::ZERO, by);
                column[k + 2] = sum / over;
            }
        }
        // The radius, by the last terms of all.
        let mut radius = f64::INFINITY;
        for series in columns.iter().chain([&u]) {
            let size = series[..4].iter().fold(0.0, |size, x| f64::max(size, x.hi.abs()));
            for (k, term) in series.iter().enumerate().skip(TERMS - 4) {
                let term = term.hi.abs();
                if term > 0.0 && size > 0.0 {
                    radius = radius.min((size / term).powf(1.0 / k as f64));
                }
            }
        }
        Step { start, length: if radius.is_finite() { SHARE * radius } else { 1.0 }, u, columns }
    }

    /// The steps from the start to a time, forward or backward.
    fn sweep<const COLUMNS: usize>(&self, orbit: &Motion<COLUMNS>, end: Dd) -> Vec<Step<COLUMNS>> {
        let mut state = self.start(orbit);
        let side = if end.hi < 0.0 { -1.0 } else { 1.0 };
        let (mut at, mut steps) = (Dd::ZERO, Vec::new());
        for _ in 0..STEPS {
            let mut step = self.step(at, &state);
            let rest = (end - at).hi.abs();
            let last = step.length >= rest;
            step.length = side * if last { rest } else { step.length };
            state = step.at(Dd::from(step.length));
            at = at + Dd::from(step.length);
            steps.push(step);
            if last {
                break;
            }
        }
        steps
    }

    /// Derivatives in the units of the arguments.
    fn derivatives<const COLUMNS: usize>(&self, state: &State<COLUMNS>) -> Derivatives<COLUMNS> {
        let (length, time) = (self.length, self.time);
        // The powers of two of u over each argument.
        let by = |letter: &Letter| match letter {
            Letter::P => length + 2 * time,
            Letter::Q => 3 * length + 2 * time,
            Letter::R => 2 * length + 2 * time,
            Letter::C => 2 * time,
            Letter::S => 5 * length + 2 * time,
        };
        let of = |order: usize| {
            let mut row = [0.0; COLUMNS];
            let powers = [0, time].into_iter().chain(self.letters.iter().map(by));
            for ((value, column), power) in row.iter_mut().zip(&state.columns).zip(powers) {
                *value = ldexp(column[order].value(), power - order as i32 * time);
            }
            row
        };
        [of(0), of(1)]
    }
}

impl<const COLUMNS: usize> Step<COLUMNS> {
    fn at(&self, t: Dd) -> State<COLUMNS> {
        let value = |series: &Series| {
            let (mut sum, mut slope) = (Dd::ZERO, Dd::ZERO);
            for (k, term) in series.iter().enumerate().rev() {
                sum = sum * t + *term;
                if k > 0 {
                    slope = slope * t + *term * k as f64;
                }
            }
            [sum, slope]
        };
        let mut columns = [[Dd::ZERO; 2]; COLUMNS];
        for (column, series) in columns.iter_mut().zip(self.columns.iter()) {
            *column = value(series);
        }
        State { u: value(&self.u), columns }
    }
}

/// The state at a time among steps that reach it.
fn found<const COLUMNS: usize>(steps: &[Step<COLUMNS>], t: Dd) -> Option<State<COLUMNS>> {
    let place = steps.partition_point(|step| {
        (step.start - t).hi.abs() != 0.0 && (t.hi - step.start.hi) * step.length.signum() >= 0.0
    });
    let step = steps.get(place.saturating_sub(1))?;
    Some(step.at(t - step.start))
}

impl EvenPowers {
    /// The derivatives of u and u' by u0, u0', p, q, r and c at every time; NaN where there is no motion.
    pub fn derivatives_into(&self, times: &[f64], put: &mut dyn FnMut(usize, Derivatives<6>)) {
        let [p, q, r, c] = self.force;
        let motion = Motion {
            u0: self.u0,
            velocity0: self.velocity0,
            range: self.range.map(Scaled::value),
            force: [p, q, r, c, 0.0],
            letters: &EVEN,
            period: self.period,
            escapes: self.escapes.map(Scaled::value),
            acceleration: self.quartic.force.to_scaled(),
        };
        motion.derivatives_into(times, put);
    }
}

impl CubicQuintic {
    /// Derivatives of u (first row) and u' at t by u0, velocity0, p, q and s; NaN where there is no motion.
    ///
    /// **Error** in each row at most 1e-12 of the largest change, while a disturbance grows by less than 1e10 on the way: next to a
    /// separatrix fewer digits are left. **Source** the variational equations by Taylor series.
    ///
    /// ```
    /// let by = libration::CubicQuintic::new(1.0, 0.0, 1.0, 0.0, 0.0)?.derivatives(1.0);
    /// assert_eq!(by[0].map(|x| format!("{x:.6}"))[..3], ["0.540302", "0.841471", "-0.420735"]);
    /// # Ok::<(), libration::Domain>(())
    /// ```
    #[must_use]
    pub fn derivatives(&self, t: f64) -> [[f64; 5]; 2] {
        let mut found = [[f64::NAN; 5]; 2];
        self.derivatives_into(&[t], &mut |_, derivatives| found = derivatives);
        found
    }

    /// [`CubicQuintic::derivatives`] of every time: `put` takes the place and the derivatives.
    pub fn derivatives_into(&self, t: &[f64], put: &mut dyn FnMut(usize, [[f64; 5]; 2])) {
        let motion = Motion {
            u0: self.u0,
            velocity0: self.velocity0,
            range: self.set_up.range,
            force: [self.p(), self.q(), 0.0, 0.0, self.s()],
            letters: &QUINTIC,
            period: self.long_period(),
            escapes: self.set_up.escapes,
            acceleration: self.energy.acceleration(self.u0),
        };
        motion.derivatives_into(t, put);
    }
}

impl<const COLUMNS: usize> Motion<COLUMNS> {
    fn derivatives_into(&self, times: &[f64], put: &mut dyn FnMut(usize, Derivatives<COLUMNS>)) {
        let equation = Equation::new(self);
        let undefined = [[f64::NAN; COLUMNS]; 2];
        let in_units = |t: f64| Dd::from(ldexp(t, -equation.time));
        let [behind, ahead] = self.escapes;
        let inside = |t: f64| t.is_finite() && behind < t && t < ahead;
        if self.period.is_finite() && (self.velocity0 != 0.0 || !self.acceleration.is_zero()) {
            let period = self.period.shift(-equation.time).to_dd();
            let steps = equation.sweep(self, period);
            let Some(end) = found(&steps, period) else { return };
            let start = equation.start(self);
            let force = self.acceleration.shift(2 * equation.time - equation.length).to_dd();
            let by_velocity = start.u[1].hi.abs() > force.hi.abs();
            let mut slopes = [Dd::ZERO; COLUMNS];
            for (k, slope) in slopes.iter_mut().enumerate() {
                let [before, after] = [start.columns[k], end.columns[k]];
                *slope = if by_velocity {
                    (before[0] - after[0]) / start.u[1]
                } else {
                    (before[1] - after[1]) / force
                };
            }
            for (i, t) in times.iter().enumerate() {
                let turns = in_units(*t) / period;
                let count = turns.hi.floor();
                if count.is_nan() || count.abs() >= exp2(53) {
                    put(i, undefined);
                    continue;
                }
                let rest = in_units(*t) - period * count;
                let Some(mut state) = found(&steps, rest) else { continue };
                let [u, velocity] = state.u;
                let acceleration = equation.acceleration(u);
                for (column, slope) in state.columns.iter_mut().zip(slopes) {
                    column[0] = column[0] - velocity * slope * count;
                    column[1] = column[1] - acceleration * slope * count;
                }
                put(i, equation.derivatives(&state));
            }
            return;
        }
        let furthest =
            |side: f64| times.iter().filter(|t| inside(**t)).fold(0.0, |far, t| f64::max(far, side * t));
        let [back, forward] = [-furthest(-1.0), furthest(1.0)].map(|t| equation.sweep(self, in_units(t)));
        for (i, t) in times.iter().enumerate() {
            let steps = if *t < 0.0 { &back } else { &forward };
            let state = if inside(*t) { found(steps, in_units(*t)) } else { None };
            put(i, state.map_or(undefined, |state| equation.derivatives(&state)));
        }
    }
}

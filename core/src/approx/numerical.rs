//! Numerical solutions by name: what a first program, or SciPy as it comes, makes of one pendulum over an interval.
//!
//! Fixed steps are those of steps.rs, with the cubic through both states of a step between them; `rk45` is that of
//! dormand_prince.rs with its own interpolant. They are what the exact motion is compared with, in plain doubles.

use super::dormand_prince::{DenseStep, DormandPrince};
use super::entry::{Entry, Named, Row, entries, row};
use super::search::crossing;
use super::steps::{SCHEME_TABLE, State, Step};
use crate::domain::{Domain, shown, shown_count};
use crate::float::PI;
use crate::pendulum::{Extremes, Orbit, Regime};

/// Most steps of a solution.
pub const MOST_STEPS: usize = 5_000_000;

/// How a formula goes on.
#[derive(Clone, Copy, Debug)]
enum Rule {
    Fixed(Step),
    Adaptive,
}

const TABLE: &[Row<Rule>] = &[
    row(SCHEME_TABLE[0].entry, Rule::Fixed(SCHEME_TABLE[0].rule)),
    row(SCHEME_TABLE[1].entry, Rule::Fixed(SCHEME_TABLE[1].rule)),
    row(SCHEME_TABLE[2].entry, Rule::Fixed(SCHEME_TABLE[2].rule)),
    row(SCHEME_TABLE[3].entry, Rule::Fixed(SCHEME_TABLE[3].rule)),
    row(
        Entry::new(
            "rk45",
            "Dormand-Prince 5(4) at rtol 1e-3 and atol 1e-6: scipy.integrate.solve_ivp as it comes",
            "Dormand & Prince 1980; SciPy, scipy.integrate.RK45; order 5",
        ),
        Rule::Adaptive,
    ),
];

/// The numerical solutions: those of a fixed step, and `rk45`, which chooses its own.
pub static NUMERICALS: [Entry; TABLE.len()] = entries(TABLE);

/// A numerical scheme, with its step where it is fixed.
///
/// ```
/// use libration::{Frequency, Orbit, approx::NumericalFormula};
/// let horsley = Orbit::new(3.0, 0.0, Frequency::from_gravity_length(9.8, 1.0)?)?;
/// let scipy = NumericalFormula::named("rk45", None)?.of(&horsley, 10.0)?;
/// assert_eq!(format!("{:.2} {:.2}", scipy.over_the_top(), horsley.extremes().highest), "9.47 3.00");
/// # Ok::<(), libration::Domain>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct NumericalFormula {
    named: Named,
    rule: Rule,
    h: f64,
}

/// What a scheme makes of one pendulum from t = 0 to an end.
#[derive(Clone, Debug)]
pub struct NumericalSolution {
    omega2: f64,
    until: f64,
    /// The angles about which the exact motion swings; `None` where it does not.
    bottom: Option<f64>,
    steps: Steps,
    /// The last state that was reached, and when.
    last: (f64, State),
}

#[derive(Clone, Debug)]
enum Steps {
    /// The states at 0, h, 2 h ...: one more than steps.
    Fixed {
        h: f64,
        states: Vec<State>,
    },
    Adaptive(Vec<DenseStep>),
}

impl NumericalFormula {
    /// By its name; `h` is the step in s, which `rk45` does not take. The error lists the nearest names first.
    pub fn named(name: &str, h: Option<f64>) -> Result<NumericalFormula, Domain> {
        let (named, &rule) = Named::find("numerical solution", TABLE, name)?;
        let h = match (rule, h) {
            (Rule::Fixed(_), Some(h)) => {
                Domain::check("step", h, h > 0.0 && h.is_finite(), "finite and positive, in s")?
            }
            (Rule::Adaptive, None) => f64::NAN,
            (Rule::Fixed(_), None) => {
                return Err(Domain::new("step", "none".into(), format!("given in s for {name}")));
            }
            (Rule::Adaptive, Some(h)) => {
                return Err(Domain::new(
                    "step",
                    shown(h),
                    format!("left out for {name}, which chooses its own"),
                ));
            }
        };
        Ok(NumericalFormula { named, rule, h })
    }

    /// What is known of it.
    pub fn entry(&self) -> &'static Entry {
        self.named.entry
    }

    /// The step in s; NaN where it is not fixed.
    pub fn step(&self) -> f64 {
        self.h
    }

    /// Whether a named scheme takes a step.
    pub fn takes_step(entry: &Entry) -> bool {
        TABLE.iter().any(|row| row.entry.name == entry.name && matches!(row.rule, Rule::Fixed(_)))
    }

    /// The solution for an orbit from 0 to `until`, in s.
    ///
    /// # Errors
    /// Where `until` is negative or not finite, and for more than [`MOST_STEPS`] steps.
    pub fn of(&self, orbit: &Orbit, until: f64) -> Result<NumericalSolution, Domain> {
        self.of_unless(orbit, until, &|| false)
    }

    /// [`NumericalFormula::of`], where `ended` is asked at every step: once it is true the solution is cut short.
    ///
    /// # Errors
    /// As for [`NumericalFormula::of`].
    pub fn of_unless(
        &self,
        orbit: &Orbit,
        until: f64,
        ended: &dyn Fn() -> bool,
    ) -> Result<NumericalSolution, Domain> {
        Domain::check("until", until, until >= 0.0 && until.is_finite(), "finite and not negative")?;
        let omega2 = orbit.omega2();
        let start = State(orbit.theta0, orbit.velocity0);
        let Extremes { lowest, highest } = orbit.extremes();
        let swings = orbit.regime() == Regime::Libration;
        let (steps, last) = match self.rule {
            Rule::Fixed(step) => self.fixed(step, start, omega2, until, ended)?,
            Rule::Adaptive => adaptive(start, omega2, until, ended)?,
        };
        let bottom = swings.then_some(0.5 * (lowest + highest));
        Ok(NumericalSolution { omega2, until, bottom, steps, last })
    }

    fn fixed(
        &self,
        step: Step,
        start: State,
        omega2: f64,
        until: f64,
        ended: &dyn Fn() -> bool,
    ) -> Result<(Steps, (f64, State)), Domain> {
        let h = self.h;
        // The last step may end beyond.
        let count = (until / h).ceil().max(1.0);
        if count.is_nan() || count > MOST_STEPS as f64 {
            return Err(too_many(count));
        }
        let mut states = Vec::with_capacity(count as usize + 1);
        let mut state = start;
        states.push(state);
        while states.len() <= count as usize && !ended() {
            state = step(state, h, omega2);
            states.push(state);
        }
        let last = (h * (states.len() - 1) as f64, state);
        Ok((Steps::Fixed { h, states }, last))
    }
}

fn adaptive(
    start: State,
    omega2: f64,
    until: f64,
    ended: &dyn Fn() -> bool,
) -> Result<(Steps, (f64, State)), Domain> {
    let mut integration = DormandPrince::new(start, omega2, until);
    let mut steps = Vec::new();
    while let Some(step) = integration.step() {
        if steps.len() == MOST_STEPS {
            return Err(too_many(steps.len() as f64 + 1.0));
        }
        steps.push(step);
        if ended() {
            break;
        }
    }
    Ok((Steps::Adaptive(steps), integration.reached()))
}

fn too_many(count: f64) -> Domain {
    Domain::new("steps", shown_count(count), format!("at most {MOST_STEPS}"))
}

impl NumericalSolution {
    /// Angle and velocity at a time from 0 to the end; NaN outside. Between fixed steps the cubic through both states, and
    /// its slope; in a step of `rk45` its interpolant.
    pub fn motion(&self, t: f64) -> (f64, f64) {
        if !(t >= 0.0 && t <= self.until) {
            return (f64::NAN, f64::NAN);
        }
        let State(theta, velocity) = match &self.steps {
            Steps::Fixed { h, states } => between(states, *h, t),
            Steps::Adaptive(steps) => {
                // At the end of a step the interpolant of that step, as SciPy takes it.
                let after = steps.partition_point(|step| step.t < t);
                match steps.get(after.saturating_sub(1)) {
                    Some(step) if t <= self.last.0 => step.state(t),
                    None if t == 0.0 => self.last.1,
                    _ => State(f64::NAN, f64::NAN),
                }
            }
        };
        (theta, velocity)
    }

    /// How many steps there are.
    pub fn count(&self) -> usize {
        match &self.steps {
            Steps::Fixed { states, .. } => states.len() - 1,
            Steps::Adaptive(steps) => steps.len(),
        }
    }

    /// The end of step i with its state, from i = 0, the start, to [`NumericalSolution::count`].
    pub fn end_of_step(&self, i: usize) -> Option<(f64, f64, f64)> {
        let (t, State(theta, velocity)) = match &self.steps {
            Steps::Fixed { h, states } => (h * i as f64, *states.get(i)?),
            Steps::Adaptive(steps) if i < steps.len() => (steps[i].t, steps[i].start),
            Steps::Adaptive(steps) if i == steps.len() => self.last,
            Steps::Adaptive(_) => return None,
        };
        Some((t, theta, velocity))
    }

    /// When a swing is carried over the top, which the exact one never reaches: the first time, in s, at which the angle is
    /// more than pi from the middle of the exact motion. NaN where it is not, and where the exact motion is no libration.
    pub fn over_the_top(&self) -> f64 {
        let Some(bottom) = self.bottom else { return f64::NAN };
        let beyond = |theta: f64| theta.is_nan() || (theta - bottom).abs() > PI.hi;
        let over = (1..=self.count()).find_map(|i| {
            let (t, theta, _) = self.end_of_step(i)?;
            beyond(theta).then(|| (self.end_of_step(i - 1), t))
        });
        let Some((Some((before, ..)), after)) = over else { return f64::NAN };
        let after = after.min(self.until);
        if !beyond(self.motion(after).0) {
            return f64::NAN;
        }
        crossing(|t| beyond(self.motion(t).0), after, before)
    }

    /// omega0^2, as the steps take it.
    pub fn omega2(&self) -> f64 {
        self.omega2
    }
}

/// The cubic through the states at both ends of a step, and its slope.
fn between(states: &[State], h: f64, t: f64) -> State {
    let last = states.len().saturating_sub(2);
    let before = ((t / h) as usize).min(last);
    let part = t / h - before as f64;
    let (State(a, velocity_a), State(b, velocity_b)) =
        (states[before], states[(before + 1).min(states.len() - 1)]);
    let (slope_a, slope_b) = (h * velocity_a, h * velocity_b);
    let (bend, twist) = (3.0 * (b - a) - 2.0 * slope_a - slope_b, 2.0 * (a - b) + slope_a + slope_b);
    let theta = a + part * (slope_a + part * (bend + part * twist));
    let slope = slope_a + part * (2.0 * bend + part * (3.0 * twist));
    State(theta, slope / h)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Frequency;

    fn orbit(theta0: f64, velocity0: f64) -> Orbit {
        Orbit::new(theta0, velocity0, Frequency::from_omega0(1.0).unwrap()).unwrap()
    }

    fn solution(name: &str, h: Option<f64>, orbit: &Orbit, until: f64) -> NumericalSolution {
        NumericalFormula::named(name, h).unwrap().of(orbit, until).unwrap()
    }

    /// Largest error of the angle at the steps over 3 s of a release from 2 rad.
    fn error(name: &str, h: f64) -> f64 {
        let orbit = orbit(2.0, 0.0);
        let solution = solution(name, Some(h), &orbit, 3.0);
        let far =
            |i| solution.end_of_step(i).map_or(f64::NAN, |(t, theta, _)| (theta - orbit.theta(t)).abs());
        (0..=solution.count()).map(far).fold(0.0, f64::max)
    }

    #[test]
    fn errors_fall_with_the_order_of_the_scheme() {
        for (name, order) in [("euler", 1.0), ("euler-cromer", 1.0), ("verlet", 2.0), ("rk4", 4.0)] {
            let ratio: f64 = error(name, 1.0 / 64.0) / error(name, 1.0 / 128.0);
            let seen = ratio.log2();
            assert!((seen - order).abs() < 0.1, "{name}: order {seen}");
        }
        assert!(error("rk4", 1.0 / 64.0) < 1e-8);
    }

    #[test]
    fn between_steps_the_states_are_joined() {
        for (name, h) in [("rk4", Some(0.05)), ("rk45", None)] {
            let orbit = orbit(2.0, 0.3);
            let solution = solution(name, h, &orbit, 10.0);
            for i in 0..=solution.count() {
                let (t, theta, velocity) = solution.end_of_step(i).unwrap();
                if t > 10.0 {
                    continue;
                }
                let motion = solution.motion(t);
                assert!(
                    (motion.0 - theta).abs() < 1e-14 && (motion.1 - velocity).abs() < 1e-13,
                    "{name} {i}"
                );
            }
            let far = |t: f64| (solution.motion(t).0 - orbit.theta(t)).abs();
            let worst = (0..1000).map(|i| far(0.01 * f64::from(i))).fold(0.0, f64::max);
            assert!(worst < if name == "rk4" { 3e-6 } else { 0.02 }, "{name} {worst}");
            assert!(solution.motion(-0.1).0.is_nan() && solution.motion(10.1).0.is_nan());
            assert!(solution.end_of_step(solution.count() + 1).is_none());
        }
    }

    #[test]
    fn scipy_carries_horsley_over_the_top() {
        let horsley = Orbit::new(3.0, 0.0, Frequency::from_gravity_length(9.8, 1.0).unwrap()).unwrap();
        let scipy = solution("rk45", None, &horsley, 10.0);
        assert!((scipy.over_the_top() - 9.47).abs() < 0.005, "{}", scipy.over_the_top());
        assert!(solution("rk4", Some(0.025), &horsley, 10.0).over_the_top().is_nan());
        assert!(solution("rk45", None, &horsley, 9.0).over_the_top().is_nan());
        // A rotation is over the top from the first turn on: nothing is said of it.
        assert!(solution("rk45", None, &orbit(0.0, 3.0), 10.0).over_the_top().is_nan());
    }

    #[test]
    fn ends_of_the_interval() {
        let orbit = orbit(1.0, 0.5);
        for (name, h) in [("rk45", None), ("verlet", Some(0.1))] {
            assert_eq!(solution(name, h, &orbit, 0.0).motion(0.0), (1.0, 0.5));
        }
        let rest = solution("rk45", None, &self::orbit(0.0, 0.0), 100.0);
        assert_eq!(rest.motion(100.0), (0.0, 0.0));
        // The last step of rk45 ends where it is told, those of a fixed step at their multiples.
        let (t, ..) = solution("rk45", None, &orbit, 7.0).end_of_step(0).unwrap();
        assert_eq!(t, 0.0);
        let scipy = solution("rk45", None, &orbit, 7.0);
        assert_eq!(scipy.end_of_step(scipy.count()).unwrap().0, 7.0);
        assert_eq!(solution("euler", Some(2.0), &orbit, 7.0).end_of_step(4).unwrap().0, 8.0);
        assert_eq!(solution("euler", Some(2.0), &orbit, 7.0).count(), 4);
    }

    #[test]
    fn what_is_wrong_is_answered() {
        let refused = |name, h| NumericalFormula::named(name, h).unwrap_err().to_string();
        assert_eq!(
            refused("rk5", None),
            "numerical solution = \"rk5\": must be one of rk4, rk45, euler, verlet, euler-cromer"
        );
        assert_eq!(refused("rk4", None), "step = none: must be given in s for rk4");
        assert_eq!(refused("rk4", Some(0.0)), "step = 0.0: must be finite and positive, in s");
        assert_eq!(
            refused("rk45", Some(0.1)),
            "step = 0.1: must be left out for rk45, which chooses its own"
        );
        let euler = NumericalFormula::named("euler", Some(1e-9)).unwrap();
        let said = euler.of(&orbit(1.0, 0.0), 10.0).unwrap_err().to_string();
        assert_eq!(said, "steps = 10000000000: must be at most 5000000");
        assert!(euler.of(&orbit(1.0, 0.0), f64::INFINITY).is_err());
    }

    #[test]
    fn a_solution_ends_when_its_caller_gives_up() {
        for (name, h) in [("rk45", None), ("euler", Some(0.001))] {
            let formula = NumericalFormula::named(name, h).unwrap();
            assert!(formula.of_unless(&orbit(1.0, 0.0), 1000.0, &|| true).unwrap().count() <= 1);
        }
    }
}

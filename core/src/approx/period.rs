//! The period of a swing by every named formula, as its ratio to the period of small swings, and how far each is off.
//!
//! Each formula is evaluated to triple-double (period_formulas.rs), so that its error against 2K/pi is right to its own
//! last digits even where it is 1e-30.

use super::entry::{Entry, Named, entries};
use super::period_formulas::{PeriodRule, TABLE, exact};
use super::search::{crossing, intervals, peak};
use super::turning::Turning;
use crate::domain::Domain;
use crate::float::exponent::ldexp;
use crate::float::{TWO_PI_LONG, Td};
use crate::pendulum::{Orbit, Regime};
use crate::sorting::sort_numbers;
use core::f64::consts::PI;

/// Every formula of T/T0, where T0 = 2 pi/omega0 is the period of small swings.
pub static PERIODS: [Entry; TABLE.len()] = entries(TABLE);

/// Errors are differences of numbers next to 1 with 46 digits: what is below is not told from 0.
const LEAST: f64 = 1e-44;

/// One formula of the period.
///
/// ```
/// use libration::approx::PeriodFormula;
/// let formula = PeriodFormula::named("agm:2")?;
/// assert_eq!(format!("{:.6} {:.2e}", formula.ratio(1.5), formula.error(1.5)), "1.161958 -9.23e-6");
/// # Ok::<(), libration::Domain>(())
/// ```
#[derive(Clone, Copy)]
pub struct PeriodFormula {
    named: Named,
    rule: &'static PeriodRule,
}

impl PeriodFormula {
    /// By its name, `name` or `name:N`.
    pub fn named(name: &str) -> Result<PeriodFormula, Domain> {
        let (named, rule) = Named::find("period", TABLE, name)?;
        Ok(PeriodFormula { named, rule })
    }
    /// What is known of it.
    pub fn entry(&self) -> &'static Entry {
        self.named.entry
    }
    /// The name that finds it again.
    pub fn name(&self) -> String {
        self.named.name()
    }

    /// T/T0 of the complement 1 - m >= 0, which keeps its digits next to the top; above 1 m is negative.
    ///
    /// **Error** at most 1 ulp.
    pub fn ratio_of_mc(&self, mc: f64) -> f64 {
        value(self.of(Turning::of_complement(mc)))
    }
    /// T/T0 of a release from rest at `theta_max` in [0, pi]; NaN outside.
    ///
    /// **Error** at most 1 ulp. The double next to pi is not pi: there the exact ratio is 24.6, not infinite.
    pub fn ratio(&self, theta_max: f64) -> f64 {
        value(self.of(Turning::of_angle(theta_max)))
    }
    /// T/T0 of the parameter m = sin^2(theta_max/2) <= 1; negative ones too where it is a formula of m or of a.
    ///
    /// **Error** at most 1 ulp.
    pub fn ratio_of_m(&self, m: f64) -> f64 {
        value(self.of(Turning::of_parameter(m)))
    }
    /// The formula over 2K/pi, minus 1, at `theta_max` in [0, pi]; -1 where only the exact one is infinite, NaN where
    /// the formula has no value.
    ///
    /// **Error** at most 1 ulp plus 1e-45; below 1e-44 it is given as 0.
    pub fn error(&self, theta_max: f64) -> f64 {
        self.compared(Turning::of_angle(theta_max))
    }
    /// Likewise by the complement of the parameter.
    pub fn error_of_mc(&self, mc: f64) -> f64 {
        self.compared(Turning::of_complement(mc))
    }
    /// Likewise by the parameter.
    pub fn error_of_m(&self, m: f64) -> f64 {
        self.compared(Turning::of_parameter(m))
    }

    /// The period in s that it gives a pendulum that swings; NaN in rotation.
    ///
    /// **Error** at most 4 ulp.
    pub fn period(&self, orbit: &Orbit) -> f64 {
        if orbit.regime() == Regime::Rotation {
            return f64::NAN;
        }
        let Some((root, power)) = orbit.force.root() else { return f64::INFINITY };
        let ratio = self.of(Turning::of_both(orbit.energy_ratio(), orbit.energy_ratio_c()));
        if !ratio.hi.is_finite() {
            return ratio.hi;
        }
        ldexp(value(TWO_PI_LONG * ratio / root), -power)
    }
    /// A quarter of it: the time from the bottom to the turning point, which is what Salas calls T.
    pub fn quarter_period(&self, orbit: &Orbit) -> f64 {
        ldexp(self.period(orbit), -2)
    }

    /// The intervals of turning angles in [0, pi] where the error stays within a bound, to the last double.
    ///
    /// | argument | domain |
    /// |---|---|
    /// | `bound` | at least 1e-30, finite |
    pub fn ranges(&self, bound: f64) -> Result<Vec<[f64; 2]>, Domain> {
        Domain::check("bound", bound, (1e-30..f64::INFINITY).contains(&bound), "finite and at least 1e-30")?;
        let within = |theta: f64| self.error(theta).abs() <= bound;
        Ok(intervals(self.marks(), [0.0, PI], within))
    }

    /// Angles so dense, with the zeros and the extremes of the error among them, that it crosses no bound twice
    /// between two.
    fn marks(&self) -> Vec<f64> {
        let mut near = vec![1e-16];
        while near[near.len() - 1] < 0.1 {
            near.push(near[near.len() - 1] * 1.25);
        }
        let uniform = (1..150).map(|i| 0.1 + f64::from(i) * (PI - 0.2) / 150.0);
        let mut points = vec![0.0];
        points.extend(near.iter().copied().chain(uniform));
        points.extend(near.iter().rev().map(|distance| PI - distance));
        points.push(PI);
        points.dedup();
        let sizes: Vec<f64> = points.iter().map(|theta| self.error(*theta)).collect();
        let mut marks = Vec::new();
        for i in 1..points.len() - 1 {
            let [before, here, after] = [sizes[i - 1], sizes[i], sizes[i + 1]];
            let sign = f64::signum(here);
            if here * after < 0.0 {
                marks.push(crossing(|theta| self.error(theta) * sign > 0.0, points[i], points[i + 1]));
                marks.push(crossing(|theta| self.error(theta) * sign <= 0.0, points[i + 1], points[i]));
            }
            if (here - before) * (here - after) > 0.0 {
                let up = f64::signum(here - before);
                marks.push(peak(|theta| self.error(theta) * up, points[i - 1], points[i + 1]));
            }
        }
        points.extend(marks);
        sort_numbers(&mut points);
        points
    }

    fn of(&self, turning: Option<Turning>) -> Td {
        match turning {
            None => Td::from(f64::NAN),
            Some(turning) if turning.a.hi == 0.0 && self.rule.diverges => Td::from(f64::INFINITY),
            Some(turning) => (self.rule.ratio)(&turning, self.named.order),
        }
    }

    fn compared(&self, turning: Option<Turning>) -> f64 {
        let ratio = self.of(turning);
        let Some(turning) = turning else { return f64::NAN };
        if turning.a.hi == 0.0 {
            return if ratio.hi.is_finite() { -1.0 } else { f64::NAN };
        }
        let exact = exact(&turning, 0);
        let error = value((ratio - exact) / exact);
        if error.abs() < LEAST { 0.0 } else { error }
    }
}

/// The nearest double; infinities and NaN have no rest.
fn value(of: Td) -> f64 {
    of.hi
}

#[cfg(test)]
mod tests {
    use super::super::period_formulas::coefficients;
    use super::*;
    use crate::Frequency;

    fn formula(name: &str) -> PeriodFormula {
        PeriodFormula::named(name).unwrap()
    }

    #[test]
    fn the_series_begins_as_printed() {
        let printed = [(1.0, 16.0), (11.0, 3072.0), (173.0, 737_280.0), (22931.0, 1_321_205_760.0)]
            .map(|(a, b)| Td::from(a) / Td::from(b));
        for (k, printed) in printed.into_iter().enumerate() {
            let apart = (coefficients()[k + 1] - printed).hi / printed.hi;
            assert!(apart.abs() < 1e-45, "{k} {apart:e}");
        }
    }

    #[test]
    fn names_and_refusals() {
        for entry in &PERIODS {
            let name =
                if entry.orders.is_some() { format!("{}:4", entry.name) } else { entry.name.to_string() };
            assert_eq!(formula(&name).name(), name);
        }
        let refused = |name| PeriodFormula::named(name).err().map(|error| error.to_string());
        assert_eq!(
            refused("series:3").unwrap(),
            "period = \"series:3\": must be series:N with an even N from 2 to 200"
        );
        assert_eq!(refused("agm:0").unwrap(), "period = \"agm:0\": must be agm:N with a whole N from 1 to 8");
        assert!(refused("kid-fog").unwrap().starts_with("period = \"kid-fog\": must be one of kidd-fogg, "));
    }

    #[test]
    fn the_period_of_a_pendulum_is_the_ratio_of_its_swing() {
        let frequency = Frequency::from_gravity_length(9.8, 0.3).unwrap();
        for (theta0, velocity0) in
            [(3.0, 0.0), (1.0, 2.0), (1e-200, 0.0), (core::f64::consts::PI, 0.0), (-0.4, 11.0)]
        {
            let orbit = Orbit::new(theta0, velocity0, frequency).unwrap();
            let ours = formula("exact").period(&orbit);
            assert!((ours / orbit.period() - 1.0).abs() < 1e-15, "{theta0} {ours} {}", orbit.period());
            let linear = formula("linear").period(&orbit);
            assert!((linear * orbit.omega0() - 2.0 * PI).abs() < 1e-14);
        }
        let orbit = |velocity0| Orbit::new(0.0, velocity0, Frequency::from_omega0(1.0).unwrap()).unwrap();
        assert!(formula("exact").period(&orbit(2.1)).is_nan());
        assert_eq!(formula("exact").period(&orbit(2.0)), f64::INFINITY);
        assert_eq!(formula("agm:1").quarter_period(&orbit(2.0)), PI);
    }

    #[test]
    fn ranges_find_both_sides_of_a_zero_and_of_a_hump() {
        let denman = formula("denman").ranges(1e-4).unwrap();
        assert_eq!(denman.len(), 2);
        let [[from, to], [again, last]] = denman[..] else { unreachable!() };
        assert!(from == 0.0 && to < again && again < last && last < PI);
        for end in [to, again, last] {
            assert!((formula("denman").error(end).abs() - 1e-4).abs() < 1e-15);
        }
        assert_eq!(formula("exact").ranges(1e-30).unwrap(), [[0.0, PI]]);
        assert_eq!(formula("chachiyo").ranges(0.002).unwrap(), [[0.0, PI]]);
        // The hump of 0.17 % parts the range.
        assert_eq!(formula("chachiyo").ranges(1e-3).unwrap().len(), 2);
        let cromer = formula("cromer").ranges(1e-3).unwrap();
        assert!(cromer.len() == 1 && cromer[0][0] > 2.98 && cromer[0][1] == PI);
        assert!(formula("exact").ranges(0.0).is_err() && formula("exact").ranges(f64::NAN).is_err());
    }
}

//! The angle as whole turns and a rest.

use super::orbit::{Orbit, Solution};
use crate::float::{Dd, PI, TWO_PI, angle_reduction};

/// An angle theta = 2 pi count + angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turns {
    /// Whole turns.
    pub count: i64,
    /// The rest, in [-pi, pi).
    pub angle: f64,
}

impl Turns {
    /// Where there is no answer.
    const NONE: Turns = Turns { count: 0, angle: f64::NAN };
}

impl Orbit {
    /// The angle at t (in s) as whole turns and a rest, theta = 2 pi count + angle.
    ///
    /// The bounds of the rest are those of doubles: pi rounded to a double is given as minus itself, one turn on. The
    /// angle is NaN and the count 0 where theta is NaN, and where the count, rounded to a double, is 2^63 or more
    /// (|theta| above 5.79e19). **Error** of the rest: 4 ulp of pi, plus 2^-100 of the condition. Source: as [`Orbit::theta`], without
    /// the last sum.
    ///
    /// ```
    /// use libration::{Frequency, Orbit};
    /// let orbit = Orbit::new(0.0, 3.0, Frequency::from_omega0(1.0)?)?;
    /// let turns = orbit.turns(100.0);
    /// assert_eq!(format!("{} {:.9}", turns.count, turns.angle), "41 2.838957125");
    /// # Ok::<(), libration::Domain>(())
    /// ```
    #[must_use]
    pub fn turns(&self, t: f64) -> Turns {
        let (turns, local) = self.turned(t);
        if !local.hi.is_finite() {
            return Turns::NONE;
        }
        let (count, rest) = match self.solution {
            Solution::Equilibrium | Solution::ForceFree => {
                // Of a large angle the low word holds whole turns too.
                let [hi, lo] = [local.hi, local.lo].map(angle_reduction::reduce);
                let rest = (hi.from_bottom * hi.side + lo.from_bottom * lo.side).to_dd();
                let shift = (rest.hi / TWO_PI.hi).round();
                (hi.turns + lo.turns + Dd::from(shift), rest - TWO_PI * shift)
            }
            // Two whole numbers, but for starts of 2^53 turns and more.
            _ if self.frame.turns.lo == 0.0 => (Dd::sum(self.frame.turns.hi, turns), local),
            _ => (self.frame.turns + Dd::from(turns), local),
        };
        let (shift, angle) = half_open(rest);
        match whole(count).and_then(|count| count.checked_add(shift)) {
            Some(count) => Turns { count, angle },
            None => Turns::NONE,
        }
    }
}

/// A rest within three half turns as -1, 0 or 1 turns and an angle in the half-open interval of doubles: its upper end is the lower
/// end one turn on, also where the angle only rounds to it.
pub(crate) fn half_open(rest: Dd) -> (i64, f64) {
    match rest.value() {
        value if value >= PI.hi => (1, (rest - TWO_PI).value().max(-PI.hi)),
        value if value < -PI.hi => match (rest + TWO_PI).value() {
            angle if angle < PI.hi => (-1, angle),
            _ => (0, -PI.hi),
        },
        value => (0, value),
    }
}

/// A whole number as an integer, if it fits.
fn whole(count: Dd) -> Option<i64> {
    // Both words are whole numbers, and the low one is at most half a unit of the high one: each conversion is exact.
    const END: f64 = 9_223_372_036_854_775_808.0; // 2^63
    if count.hi.abs() < END { (count.hi as i64).checked_add(count.lo as i64) } else { None }
}

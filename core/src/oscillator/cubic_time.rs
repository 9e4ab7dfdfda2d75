//! When a value is passed: the inverse of the motion.
//!
//! With the velocity at the value from 2 u'^2 = 4E - 2 p u^2 - q u^4, a sum without rounding, its phase is that of a
//! start there (cubic_phase.rs), so passages keep their digits at zeros, turning points and next to escapes.

use super::cubic_course::{Course, Elliptic, Plain, Shape, Simple};
use super::cubic_phase::{artanh, escape_phase, half_periods, sign, signed};
use super::duffing::{Constants, Duffing, Place};
use crate::domain::Domain;
use crate::elliptic::phase::Phase;
use crate::float::Dd;
use crate::float::exact::sum_of_products;
use crate::float::scaled::Scaled;
use crate::motion::passages::Interval;

impl Duffing {
    /// The place of a value, with a velocity that is not negative; `None` where the motion does not get.
    fn place(&self, u: f64) -> Option<Place> {
        let given = [self.u0, self.velocity0, self.p, self.q];
        let [u0, v0, p, q] = given;
        let (low, high) = self.range();
        let velocity = if u == u0 {
            Scaled::from(v0.abs())
        } else if self.turns_at(u) {
            Scaled::ZERO
        } else {
            let products: [&[f64]; 5] = [
                &[2.0, v0, v0],
                &[2.0, p, u0, u0],
                &[q, u0, u0, u0, u0],
                &[-2.0, p, u, u],
                &[-q, u, u, u, u],
            ];
            let square = sum_of_products(&products).shift(-1);
            if square.is_negative() || !(low <= u && u <= high) {
                return None;
            }
            square.sqrt()
        };
        Some(Place::new(u, velocity, given))
    }

    /// Whether a value is a turning point, as it is rounded: an end of the range that is not only a limit.
    fn turns_at(&self, u: f64) -> bool {
        let (low, high) = self.range();
        let end = u == low || u == high;
        match &self.course {
            Course::Elliptic(_) => end,
            Course::Simple(simple) => end && matches!(simple.plain, Plain::Sech | Plain::Cosh) && u != 0.0,
            _ => false,
        }
    }

    /// All times from `start` to `stop` (both included) at which the motion passes `u`, rising.
    ///
    /// | argument | domain |
    /// |---|---|
    /// | `u` | finite; none where the motion does not get, or only in infinite time |
    /// | `start`, `stop` | `start` <= `stop`; at most 10^7 passages between them; within 2^53 half periods |
    ///
    /// **Error** at most 4 ulp of the largest of the period, |start| and |stop|, plus 2^-100 of the condition.
    pub fn times(&self, u: f64, start: f64, stop: f64) -> Result<Vec<f64>, Domain> {
        Domain::check("u", u, u.is_finite(), "finite")?;
        let interval = Interval::new(start, stop)?;
        let Some(place) = self.place(u) else { return Ok(Vec::new()) };
        let mut times = match &self.course {
            Course::Still => Vec::new(),
            Course::Straight => vec![(Dd::sum(u, -self.u0) / Dd::from(self.velocity0)).value()],
            Course::Simple(simple) => self.simple_times(simple, &place),
            Course::Elliptic(e) => match e.shape {
                Shape::Cn | Shape::Sn | Shape::Dn => return self.periodic_times(e, &place, interval),
                _ => self.escape_times(e, &place),
            },
        };
        times.retain(|t| t.is_finite() && interval.holds(*t));
        times.sort_by(f64::total_cmp);
        Ok(times)
    }

    fn periodic_times(&self, e: &Elliptic, place: &Place, interval: Interval) -> Result<Vec<f64>, Domain> {
        let canonical = self.constants.canonical(e.shape);
        let well = e.shape == Shape::Dn;
        // Upwards in the canonical motion; inwards, after the outer turning point, in a well.
        let side = if well { 1.0 } else { sign(Scaled::from(self.velocity0)) };
        let velocity = if well { signed(place.velocity, -sign(place.u)) } else { place.velocity };
        let there = Place { u: signed(place.u, side), velocity, ..*place };
        let at = half_periods(&self.constants, &canonical, &e.lattice, &there).to_dd();
        let (spacing, other) = if well { (1.0, -at) } else { (2.0, Dd::ONE - at) };
        let phases = [at, other].map(|at| at - e.phase.start);
        let different = if place.velocity.is_zero() { 1 } else { 2 };
        interval.repeated(e.phase.rate, e.scales.time, &phases[..different], spacing)
    }

    fn escape_times(&self, e: &Elliptic, place: &Place) -> Vec<f64> {
        let canonical = self.constants.canonical(e.shape);
        let even = matches!(e.shape, Shape::Nc | Shape::Dc);
        let (half, one) = (Dd::from(0.5), Dd::ONE);
        // On the leg that leaves the middle.
        let outwards = Place { velocity: signed(place.velocity, sign(place.u)), ..*place };
        let (size, at_pole) = escape_phase(&self.constants, &canonical, &e.lattice, &outwards);
        let size = size.to_dd();
        let time = |after: bool| {
            let y = if e.from_pole {
                // Whether the phase is counted from the pole that comes first on this leg's side.
                let same = after == (e.phase.rate.hi < 0.0);
                match (at_pole, same) {
                    (true, true) => size,
                    (true, false) => one - size,
                    (false, true) => half - size,
                    (false, false) => half + size,
                }
            } else {
                let distance = if at_pole { half - size } else { size };
                if after { distance } else { -distance }
            };
            time_of(&e.phase, e.scales.time, y)
        };
        if !even {
            return vec![time(sign(place.u) == sign(Scaled::from(self.velocity0)))];
        }
        if place.velocity.is_zero() { vec![time(true)] } else { vec![time(false), time(true)] }
    }

    fn simple_times(&self, simple: &Simple, place: &Place) -> Vec<f64> {
        let Constants { p, q, energy, .. } = self.constants;
        let u = place.u.abs();
        let velocity = place.velocity;
        let (along, way) = (sign(place.u), sign(Scaled::from(self.velocity0)));
        let time = |y: Scaled| time_of(&simple.phase, simple.scales.time, y.to_dd());
        let both = |y: Scaled| if y.is_zero() { vec![time(y)] } else { vec![time(-y), time(y)] };
        let rate = p.abs().sqrt();
        let amplitude = || (energy.abs().shift(-1) / p.abs()).sqrt();
        match simple.plain {
            Plain::Sech => both(artanh(velocity / (rate * u), u / (p.abs().shift(1) / q).sqrt())),
            Plain::Tanh => {
                let reach = (p / q.abs()).sqrt();
                vec![time(signed(artanh(u / reach, (place.stiffness / p).sqrt()), along * way))]
            }
            Plain::Csch | Plain::Coth | Plain::Inverse => {
                let rate = match simple.plain {
                    Plain::Csch => rate,
                    Plain::Coth => p.shift(-1).sqrt(),
                    _ => Scaled::ONE / self.constants.until_pole(&self.beginning()),
                };
                vec![time(rate * self.constants.until_pole(place))]
            }
            Plain::Cosh => both(artanh(velocity / (rate * u), amplitude() / u)),
            Plain::Sinh => {
                let speed = velocity / rate;
                vec![time(signed(artanh(u / speed, amplitude() / speed), along * way))]
            }
            Plain::Exp => {
                // ln(u/u0) = 2 artanh((u - u0)/(u + u0)).
                let start = Scaled::from(self.u0).abs();
                let (difference, sum) = (u - start, u + start);
                let root = (u * start).sqrt().shift(1) / sum;
                vec![time(artanh(difference / sum, root).shift(1))]
            }
        }
    }

    fn beginning(&self) -> Place {
        Place::new(self.u0, Scaled::from(self.velocity0), [self.u0, self.velocity0, self.p, self.q])
    }
}

/// Time of a phase.
fn time_of(phase: &Phase, scale: f64, at: Dd) -> f64 {
    ((at - phase.start) / phase.rate).value() / scale
}

//! Times of repeated passages: the part that all motions share.

use crate::domain::{Domain, shown, shown_count};
use crate::elliptic::phase::LAST_HALF_PERIOD;
use crate::float::Dd;
use crate::sorting::sort_numbers;

/// Largest number of times in one answer.
pub const MOST_TIMES: f64 = 1e7;

/// An interval of times, both ends included.
#[derive(Clone, Copy)]
pub(crate) struct Interval<'a> {
    start: f64,
    stop: f64,
    /// Asked now and then: whether the caller has given up, so that any answer will do.
    ended: &'a dyn Fn() -> bool,
}

/// Times between two questions to the caller.
const ASKED_EVERY: u32 = 4096;

impl<'a> Interval<'a> {
    /// An error for a NaN, and for a start after the stop.
    pub fn new(start: f64, stop: f64, ended: &'a dyn Fn() -> bool) -> Result<Interval<'a>, Domain> {
        Domain::check("start", start, !start.is_nan(), "a number")?;
        Domain::check("stop", stop, !stop.is_nan(), "a number")?;
        if stop < start {
            return Err(Domain::new("stop", shown(stop), format!("not before start, {}", shown(start))));
        }
        Ok(Interval { start, stop, ended })
    }

    /// Whether a time is in it.
    pub fn holds(self, time: f64) -> bool {
        (self.start..=self.stop).contains(&time)
    }

    /// The times in it, rising, of phases since t = 0 that come by every `spacing` half periods; the phase runs `rate` > 0
    /// half periods per time times `scale`.
    pub fn repeated(self, rate: Dd, scale: f64, phases: &[Dd], spacing: f64) -> Result<Vec<f64>, Domain> {
        let passed = |t: f64| if t.is_finite() { (rate * (t * scale)).hi } else { t };
        let (first, last) = (passed(self.start), passed(self.stop));
        let repeats = |at: Dd| ((first - at.hi) / spacing, (last - at.hi) / spacing);
        let (mut count, mut low, mut high) = (0.0, f64::INFINITY, f64::NEG_INFINITY);
        for at in phases {
            let (from, to) = repeats(*at);
            count += (to.floor() - from.ceil() + 1.0).max(0.0);
            (low, high) = (low.min(from.floor()), high.max(to.ceil()));
        }
        if count > MOST_TIMES {
            let (argument, allowed) = ("passages from start to stop", "at most 10000000");
            return Err(Domain::new(argument, shown_count(count), allowed));
        }
        let near = first.abs().max(last.abs()) < LAST_HALF_PERIOD;
        Domain::check("stop", self.stop, near, "within 2^53 half periods, like start")?;
        let mut times = Vec::with_capacity(count as usize + 2);
        let mut repeat = low - 1.0;
        let mut since = 0;
        while repeat <= high + 1.0 {
            for at in phases {
                let t = ((*at + Dd::from(repeat * spacing)) / rate).value() / scale;
                if self.holds(t) {
                    times.push(t);
                }
            }
            repeat += 1.0;
            since += 1;
            if since == ASKED_EVERY {
                since = 0;
                if (self.ended)() {
                    break;
                }
            }
        }
        sort_numbers(&mut times);
        Ok(times)
    }
}

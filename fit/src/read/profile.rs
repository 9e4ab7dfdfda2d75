//! What the numbers of a column look like.

/// Count, range and rise of a column.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Profile {
    pub count: usize,
    pub least: f64,
    pub most: f64,
    pub mean: f64,
    pub variance: f64,
    /// Whether every value is a whole number.
    pub whole: bool,
    /// The share of steps that do not fall, and of those that rise.
    pub not_falling: f64,
    pub rising: f64,
    /// The median of the rising steps.
    pub step: f64,
    /// The share of rising steps within a third of the median.
    pub even: f64,
}

impl Profile {
    /// Of the finite values.
    pub(super) fn of(values: impl Iterator<Item = f64> + Clone) -> Profile {
        let finite = values.filter(|value| value.is_finite());
        let mut profile =
            Profile { whole: true, least: f64::INFINITY, most: f64::NEG_INFINITY, ..Profile::default() };
        let mut squares = 0.0;
        let mut before = f64::NAN;
        let (mut steps, mut falls) = (0usize, 0usize);
        let mut rises = Vec::new();
        for value in finite {
            profile.count += 1;
            profile.least = profile.least.min(value);
            profile.most = profile.most.max(value);
            profile.whole &= value.fract() == 0.0;
            // Welford's update keeps the digits of a small variance on a large mean.
            let off = value - profile.mean;
            profile.mean += off / profile.count as f64;
            squares += off * (value - profile.mean);
            if profile.count > 1 {
                steps += 1;
                falls += usize::from(value < before && !wraps(before, value));
                if value > before {
                    rises.push(value - before);
                }
            }
            before = value;
        }
        profile.variance = squares / profile.count.max(1) as f64;
        let share = |count: usize, of: usize| if of == 0 { 0.0 } else { count as f64 / of as f64 };
        profile.not_falling = share(steps - falls, steps);
        profile.rising = share(rises.len(), steps);
        profile.step = median(&mut rises).unwrap_or(0.0);
        let near = rises.iter().filter(|rise| (*rise - profile.step).abs() <= profile.step / 3.0).count();
        profile.even = share(near, rises.len());
        profile
    }

    /// Whether all values are one, but for rounding.
    pub(super) fn constant(&self) -> bool {
        self.count < 2 || self.most - self.least <= 1e-12 * self.most.abs().max(self.least.abs())
    }

    pub(super) fn range(&self) -> f64 {
        self.most - self.least
    }

    /// Whether the column may be a clock: it rises, and mostly by like steps.
    pub(super) fn clock(&self) -> bool {
        self.count > 1
            && self.not_falling >= 0.95
            && self.rising >= 0.3
            && (self.even >= 0.5 || self.count == 2)
    }

    /// Whether the column counts rows or frames: whole numbers, one step for all.
    pub(super) fn counter(&self) -> bool {
        self.whole && self.clock() && self.even == 1.0 && self.step <= 10.0 && self.most < 1e7
    }
}

/// Whether a counter of 32 bits ran over.
fn wraps(before: f64, value: f64) -> bool {
    let period = 4294967296.0;
    value >= 0.0 && before < period && value + period - before < 0.01 * period
}

/// The median, of an even number the lower middle; the values change places.
pub(super) fn median(values: &mut [f64]) -> Option<f64> {
    if values.is_empty() {
        return None;
    }
    let middle = (values.len() - 1) / 2;
    Some(crate::order::ranked(values, middle))
}

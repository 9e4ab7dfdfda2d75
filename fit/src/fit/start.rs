//! Start values without a model of friction: the free decay, its period, its state at the fastest passage.

use super::data::{Measured, median};
use super::problem::{OFFSET, OMEGA2, SCALE, THETA, VELOCITY, Values};
use super::swings::{Passage, Swings, Turn};
use libration::damped::averaged_energy_loss;
use libration::{Frequency, Friction, Orbit};
use nalgebra::{DMatrix, DVector};

/// Where a search starts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Start {
    /// The time of the state, in s.
    pub anchor: f64,
    /// The period there, in s.
    pub period: f64,
    /// The largest swing, in the unit of the record.
    pub reach: f64,
    /// The last swing.
    pub last: f64,
    pub values: Values,
    /// Friction from the loss of energy: of the linear term alone, of linear and quadratic, of all three.
    pub friction: [[f64; 3]; 3],
}

/// The passages of the free decay, from the release to the last swing: the sequence of swings that do not grow, at steady
/// intervals, with the largest sum of swings. Before it a hand moves the pendulum, after it something stops it.
pub(super) fn free_decay(swings: &Swings, samples: usize) -> core::ops::Range<usize> {
    let passages = &swings.passages;
    if passages.is_empty() {
        return 0..0;
    }
    let per_half = samples as f64 / (passages.len() + 1) as f64;
    // A sample misses an extreme by up to half a step.
    let missed = 0.5 * (core::f64::consts::FRAC_PI_2 / per_half).powi(2);
    let tolerance = 1.0 + missed.clamp(0.04, 0.5);
    let steps: Vec<f64> = passages.windows(2).map(|w| w[1].t - w[0].t).collect();
    let usual = |i: usize| median(&steps[i.saturating_sub(2)..(i + 3).min(steps.len())]);
    let follows = |i: usize| {
        let ratio = steps[i] / usual(i);
        passages[i + 1].swing <= tolerance * passages[i].swing + swings.slack && (0.55..1.8).contains(&ratio)
    };
    let sum = |range: &core::ops::Range<usize>| passages[range.clone()].iter().map(|p| p.swing).sum::<f64>();
    let (mut best, mut begin) = (0..1, 0);
    for end in 1..=passages.len() {
        if end == passages.len() || !follows(end - 1) {
            let range = begin..end;
            if sum(&range) > sum(&best) {
                best = range;
            }
            begin = end;
        }
    }
    best
}

/// How many passages at the beginning have one and the same swing, while right after them the swing falls: something drives the
/// pendulum there. Friction takes no less from a larger swing, so no free decay begins with a constant one.
pub(super) fn driven(passages: &[Passage], slack: f64) -> usize {
    let Some(first) = passages.first() else { return 0 };
    let width = (0.02 * first.swing).max(2.0 * slack);
    let (mut low, mut high, mut length) = (first.swing, first.swing, 0);
    for passage in passages {
        (low, high) = (low.min(passage.swing), high.max(passage.swing));
        if high - low > width {
            break;
        }
        length += 1;
    }
    let after = length.min(passages.len() - length);
    if length < 8 || after < 4 {
        return 0;
    }
    let mean = |from: usize| passages[from..from + 3].iter().map(|p| p.swing).sum::<f64>() / 3.0;
    let before_fall = mean(0) - mean(length - 3);
    let fall = mean(length - 1) - mean(length + after - 3);
    let as_fast = before_fall / length as f64 > 0.2 * fall / after as f64;
    if as_fast || fall < 4.0 * width { 0 } else { length }
}

/// The start of a record of angles that only rises or only falls: the pendulum turns over the top throughout. Its speed at the
/// bottom and at the top gives omega0, velocity_bottom^2 - velocity_top^2 = 4 omega0^2.
pub(super) fn rotation(t: &[f64], y: &[f64]) -> Option<Start> {
    let turn = core::f64::consts::TAU;
    let sense = (y[y.len() - 1] - y[0]).signum();
    let turned = |i: usize| sense * (y[i] - y[0]);
    if turned(y.len() - 1) < 2.0 * turn {
        return None;
    }
    // Speeds over a fifteenth of a turn, or over one step where that is more.
    let mut speeds: Vec<(f64, f64, f64)> = Vec::new();
    let mut begin = 0;
    for i in 1..y.len() {
        if turned(i) - turned(begin) >= turn / 15.0 && t[i] > t[begin] {
            let speed = (turned(i) - turned(begin)) / (t[i] - t[begin]);
            speeds.push((0.5 * (t[i] + t[begin]), 0.5 * (y[i] + y[begin]), speed));
            begin = i;
        }
    }
    let early = |s: &&(f64, f64, f64)| sense * (s.1 - y[0]) < 1.2 * turn;
    let fastest = *speeds.iter().filter(early).max_by(|a, b| a.2.total_cmp(&b.2))?;
    let slowest = *speeds.iter().filter(early).min_by(|a, b| a.2.total_cmp(&b.2))?;
    let omega2 = 0.25 * (fastest.2 * fastest.2 - slowest.2 * slowest.2);
    let at = |wanted: f64| (0..y.len()).find(|i| turned(*i) >= wanted).map(|i| t[i]);
    let whole = turned(y.len() - 1);
    let (first, last) = (at(turn)? - t[0], t[t.len() - 1] - at(whole - turn)?);
    let span = (t[t.len() - 1] - t[0] - 0.5 * (first + last)).max(first);
    // The mean speed falls as exp(-2 gamma t).
    let linear = (0.5 * libm::log(last / first) / span).max(0.0);
    let mut values: Values = [0.0; super::problem::NAMES.len()];
    values[OMEGA2] = omega2;
    values[VELOCITY] = sense * fastest.2;
    values[OFFSET] = fastest.1;
    values[SCALE] = 1.0;
    let pi = core::f64::consts::PI;
    let usable = omega2 > 0.0 && omega2.is_finite() && linear.is_finite();
    usable.then_some(Start {
        anchor: fastest.0,
        period: first,
        reach: pi,
        last: pi,
        values,
        friction: [[linear, 0.0, 0.0]; 3],
    })
}

/// omega0 of a libration with this turning angle and period.
fn omega0_of_angle(theta_max: f64, period: f64) -> Option<f64> {
    let unit = Orbit::new(theta_max.min(3.1), 0.0, Frequency::from_omega0(1.0).ok()?).ok()?;
    Some(unit.period() / period).filter(|omega0| omega0.is_finite() && *omega0 > 0.0)
}

/// omega0 of a libration that passes its rest at this velocity, with this period.
fn omega0_of_velocity(velocity: f64, period: f64) -> Option<f64> {
    let of = |omega0: f64| -> Option<f64> {
        Some(Orbit::new(0.0, velocity, Frequency::from_omega0(omega0).ok()?).ok()?.period())
    };
    // The period falls while omega0 rises, from the separatrix at velocity/2 on.
    let (mut low, mut high) = (0.5 * velocity.abs() * (1.0 + 1e-12), 0.5 * velocity.abs() + 20.0 / period);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if of(middle)? > period { low = middle } else { high = middle }
    }
    Some(high)
}

/// How fast a libration with this turning angle passes its rest.
fn greatest_velocity(theta_max: f64, omega0: f64) -> Option<f64> {
    let orbit = Orbit::new(theta_max.min(3.1), 0.0, Frequency::from_omega0(omega0).ok()?).ok()?;
    Some((2.0 * orbit.energy()).sqrt())
}

/// The turning angle of a libration that passes its rest at this velocity.
fn turning_angle(velocity: f64, omega0: f64) -> Option<f64> {
    Some(Orbit::new(0.0, velocity, Frequency::from_omega0(omega0).ok()?).ok()?.theta_max())
}

/// Friction from what the energy loses from passage to passage, by the core's averages: the best sums of the first one, two and
/// three terms without a negative one.
fn friction_of(angles: &[f64], omega0: f64) -> Option<[[f64; 3]; 3]> {
    let frequency = Frequency::from_omega0(omega0).ok()?;
    let units = [
        Friction::new(1.0, 0.0, 0.0, 0.0).ok()?,
        Friction::new(0.0, 1.0, 0.0, 0.0).ok()?,
        Friction::new(0.0, 0.0, 1.0, 0.0).ok()?,
    ];
    let energy = |angle: f64| Orbit::new(angle, 0.0, frequency).map(|orbit| orbit.energy()).ok();
    // Over a period, so that an error of the rest cancels; each relative to the swing, of which the noise is a part.
    let mut rows: Vec<[f64; 4]> = Vec::new();
    for three in angles.windows(3) {
        let angle = three[1].min(3.1);
        let losses = units.map(|unit| averaged_energy_loss(angle, frequency, unit));
        let lost = energy(three[0].min(3.1))? - energy(three[2].min(3.1))?;
        rows.push([losses[0] / angle, losses[1] / angle, losses[2] / angle, lost / angle]);
    }
    let rows: Vec<[f64; 4]> = rows.into_iter().filter(|row| row.iter().all(|x| x.is_finite())).collect();
    Some([1, 2, 3].map(|terms| best_sum(&rows, terms)))
}

/// The least squares of the first `terms` columns to the last without a negative factor.
fn best_sum(rows: &[[f64; 4]], terms: usize) -> [f64; 3] {
    let rest = |factors: &[f64; 3]| -> f64 {
        rows.iter().map(|r| (r[3] - (0..3).map(|i| factors[i] * r[i]).sum::<f64>()).powi(2)).sum()
    };
    let mut best = [0.0; 3];
    if rows.is_empty() {
        return best;
    }
    for set in 1..1usize << terms {
        let used: Vec<usize> = (0..terms).filter(|i| set >> i & 1 == 1).collect();
        let matrix = DMatrix::from_fn(rows.len(), used.len(), |row, column| rows[row][used[column]]);
        let right = DVector::from_fn(rows.len(), |row, _| rows[row][3]);
        let Some(root) = matrix.tr_mul(&matrix).cholesky() else { continue };
        let solved = root.solve(&matrix.tr_mul(&right));
        if solved.iter().all(|factor| *factor >= 0.0) {
            let mut factors = [0.0; 3];
            for (place, factor) in used.iter().zip(solved.iter()) {
                factors[*place] = *factor;
            }
            if rest(&factors) < rest(&best) {
                best = factors;
            }
        }
    }
    best
}

/// Turning angles that an acceleration may have come from, in rad: its own size says nothing of them.
const ASSUMED: [f64; 4] = [0.2, 0.6, 1.0, 1.4];

/// Start values from the passages of a free decay: one set, or several to be tried.
pub(super) fn starts(swings: &Swings, decay: &core::ops::Range<usize>, measured: Measured) -> Vec<Start> {
    let assumed: &[f64] = if measured == Measured::Acceleration { &ASSUMED } else { &[0.0] };
    assumed.iter().filter_map(|assumed| start(swings, decay, measured, *assumed)).collect()
}

/// The greatest acceleration of a libration with this turning angle, at most a right one: that at the turn.
fn greatest_acceleration(theta_max: f64, omega0: f64) -> f64 {
    omega0 * omega0 * libm::sin(theta_max)
}

/// Start values from the passages of a free decay; of accelerations with an assumed turning angle.
fn start(
    swings: &Swings,
    decay: &core::ops::Range<usize>,
    measured: Measured,
    assumed: f64,
) -> Option<Start> {
    let passages: &[Passage] = &swings.passages[decay.clone()];
    if passages.len() < 2 {
        return None;
    }
    // The turn between two passages and the time between them; pairs of them, so that an error of the rest cancels.
    let halves: Vec<(f64, f64)> = passages
        .windows(2)
        .enumerate()
        .map(|(i, w)| ((swings.turns[decay.start + i + 1].y - swings.centre).abs(), w[1].t - w[0].t))
        .collect();
    let of = |swing: f64, period: f64| match measured {
        Measured::Angle => omega0_of_angle(swing, period),
        Measured::Velocity => omega0_of_velocity(swing, period),
        Measured::Acceleration => omega0_of_angle(assumed, period),
    };
    let pairs: Vec<(f64, f64)> = if halves.len() < 2 {
        halves.iter().map(|(swing, half)| (*swing, 2.0 * half)).collect()
    } else {
        halves.windows(2).map(|w| (0.5 * (w[0].0 + w[1].0), w[0].1 + w[1].1)).collect()
    };
    let first: Vec<f64> = pairs.iter().take(6).filter_map(|(swing, period)| of(*swing, *period)).collect();
    let omega0 = median(&first);
    if !omega0.is_finite() {
        return None;
    }
    let largest = passages.iter().map(|p| p.swing).fold(0.0, f64::max);
    // The first that noise alone may have made smaller: what goes before it is not used for the first searches.
    let fastest = passages.iter().find(|p| p.swing >= largest - swings.slack)?;
    let angles: Vec<f64> = passages
        .iter()
        .filter_map(|p| match measured {
            Measured::Angle => Some(p.swing),
            Measured::Velocity => turning_angle(p.swing, omega0),
            Measured::Acceleration => Some(assumed * p.swing / fastest.swing),
        })
        .collect();
    let friction = friction_of(&angles, omega0)?;
    let mut values: Values = [0.0; super::problem::NAMES.len()];
    values[OMEGA2] = omega0 * omega0;
    values[OFFSET] = swings.centre;
    values[SCALE] = 1.0;
    let anchor = match measured {
        Measured::Angle => {
            values[VELOCITY] = fastest.slope.signum() * greatest_velocity(fastest.swing, omega0)?;
            fastest.t
        }
        // The pull is against the angle, so the acceleration falls where the angle rises.
        Measured::Acceleration => {
            values[SCALE] = fastest.swing / greatest_acceleration(assumed, omega0);
            values[VELOCITY] = -fastest.slope.signum() * greatest_velocity(assumed, omega0)?;
            fastest.t
        }
        // The angle passes its rest where the velocity turns.
        Measured::Velocity => {
            let turns = &swings.turns[decay.start..=decay.end];
            let speed = |turn: &Turn| (turn.y - swings.centre).abs();
            let largest = turns.iter().map(speed).fold(0.0, f64::max);
            let turn = turns.iter().find(|turn| speed(turn) >= largest - swings.slack)?;
            values[VELOCITY] = turn.y - swings.centre;
            turning_angle(values[VELOCITY], omega0)?;
            turn.t
        }
    };
    values[THETA] = 0.0;
    Some(Start {
        anchor,
        period: pairs[0].1,
        reach: fastest.swing,
        last: passages[passages.len() - 1].swing,
        values,
        friction,
    })
}

//! What the residuals of a record say: about clock, scale and model.

use super::covariance::{Covariance, autocorrelations};
use super::data::Measured;
use super::horizon::grown;
use super::ladder::{Rung, rung, terms};
use super::optimiser::{CLOSE, ROUGH};
use super::options::Model;
use super::problem::{Loss, OMEGA2, Problem, QUADRATIC, SCALE, Samples, THETA, VELOCITY, Values, trajectory};
use super::result::Diagnostics;
use super::start::{free_decay, starts};
use super::swings::{Swings, noise};

/// Samples that a diagnosis looks at.
const MOST: usize = 4000;

/// Pearson's correlation; 0 where one side is constant.
fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let n = a.len() as f64;
    let (ma, mb) = (a.iter().sum::<f64>() / n, b.iter().sum::<f64>() / n);
    let (mut aa, mut bb, mut ab) = (0.0, 0.0, 0.0);
    for (x, y) in a.iter().zip(b) {
        aa += (x - ma).powi(2);
        bb += (y - mb).powi(2);
        ab += (x - ma) * (y - mb);
    }
    if aa > 0.0 && bb > 0.0 { ab / (aa * bb).sqrt() } else { 0.0 }
}

/// Correlations of the residuals (predicted less measured) of a minimum.
pub(super) fn of_residuals(samples: &Samples, values: &Values, residuals: &[f64]) -> Diagnostics {
    let mut found = Diagnostics::default();
    let Some(along) = trajectory(values, samples.t[0], samples.t[samples.len() - 1]) else { return found };
    let (mut theta, mut velocity) = (vec![0.0; samples.len()], vec![0.0; samples.len()]);
    along.motion_into(&samples.t, &mut theta, &mut velocity);
    found.lag1 = autocorrelations(residuals, 1)[1];
    let squares: f64 = residuals.iter().map(|r| r * r).sum();
    let steps: f64 = residuals.windows(2).map(|w| (w[1] - w[0]).powi(2)).sum();
    found.durbin_watson = steps / squares;
    found.against_velocity = correlation(residuals, &velocity);
    found.against_theta = correlation(residuals, &theta);
    let some = || (0..residuals.len()).step_by(residuals.len().div_ceil(MOST));
    let sizes: Vec<f64> = some().map(|i| residuals[i].abs()).collect();
    let energies: Vec<f64> = some().map(|i| swing(theta[i], velocity[i], values[OMEGA2])).collect();
    found.against_swing = correlation(&sizes, &energies);
    found
}

/// The turning angle of the undamped motion through a state; pi where it turns over.
pub(super) fn swing(theta: f64, velocity: f64, omega2: f64) -> f64 {
    let frequency = libration::Frequency::from_omega2(omega2);
    let orbit = frequency.and_then(|frequency| libration::Orbit::new(theta, velocity, frequency));
    orbit.map_or(f64::NAN, |orbit| orbit.theta_max().min(core::f64::consts::PI))
}

/// The scale of the angle that a record asks for, its uncertainty, and what goes with it.
#[derive(Clone, Copy, Debug)]
pub(super) struct ScaleFound {
    pub scale: f64,
    pub u: f64,
    pub rms: f64,
    pub omega2: f64,
}

impl ScaleFound {
    /// Whether it is none by chance and helps: `rms` is that without it.
    pub fn is_wanted(&self, rms: f64) -> bool {
        self.scale > 0.0 && (self.scale - 1.0).abs() > 4.0 * self.u && rms > 1.1 * self.rms
    }
}

impl Default for ScaleFound {
    fn default() -> ScaleFound {
        ScaleFound { scale: f64::NAN, u: f64::NAN, rms: f64::NAN, omega2: f64::NAN }
    }
}

/// The scale of the angle that the record asks for. `doubtful` says that the record's own scale
/// leaves more than noise.
pub(super) fn scale(
    samples: &Samples,
    measured: Measured,
    model: Model,
    values: &Values,
    period: f64,
    doubtful: bool,
) -> ScaleFound {
    let few = samples.thinned(f64::NEG_INFINITY, f64::INFINITY, MOST);
    let mut best: Option<Rung> = None;
    // Other units are tried where the record's own does not do; and a wrong scale may have led the ladder to a poorer or a richer
    // model than the record holds.
    let factors: &[f64] = if doubtful { &[1.0, 0.75, 0.0175, 57.3] } else { &[1.0] };
    let models = if doubtful { vec![Model::Quadratic, model.max(Model::Quadratic)] } else { vec![model] };
    for (factor, model) in factors.iter().flat_map(|factor| models.iter().map(move |model| (factor, *model)))
    {
        let mut begin = *values;
        begin[SCALE] *= factor;
        begin[THETA] /= factor;
        begin[VELOCITY] /= factor;
        begin[QUADRATIC] *= factor;
        if begin[THETA].abs() > 3.0 || begin[VELOCITY].abs() > 6.0 * begin[OMEGA2].sqrt() {
            continue;
        }
        let found = rung(&few, measured, model, &begin, true, ROUGH);
        let least = best.as_ref().map_or(f64::INFINITY, |best| best.outcome.rms());
        if found.outcome.rms() < 0.999 * least {
            best = Some(found);
        }
    }
    let Some(best) = best else { return ScaleFound::default() };
    let best = rung(&few, measured, best.model, &best.outcome.values, true, CLOSE);
    let problem = Problem::new(&few, measured, &best.free, Loss::Squares, best.outcome.values);
    let lags = 3.0 * period / (few.t[few.len() - 1] - few.t[0]) * few.len() as f64;
    let covariance =
        problem.derivatives().and_then(|jacobian| Covariance::of(&jacobian, problem.plain(), lags as usize));
    let last = best.free.len() - 1;
    let u = covariance.map_or(f64::NAN, |covariance| covariance.matrix[(last, last)].sqrt());
    // The mirrored motion has the opposite sign.
    ScaleFound {
        scale: best.outcome.values[SCALE].abs(),
        u,
        rms: best.outcome.rms(),
        omega2: best.outcome.values[OMEGA2],
    }
}

/// Whether the linear equation describes a record of angles far better than the pendulum's, so large that the two must differ.
pub(super) fn isochronous(linear_equation_rms: f64, rms: f64, swing: f64) -> bool {
    linear_equation_rms > 0.0 && linear_equation_rms < 0.5 * rms && swing.to_degrees() > 15.0
}

/// rms of the linear equation, with linear friction or with all three terms: the same search on the record made a thousand times
/// smaller, where sin theta is theta. NaN where it has no start.
pub(super) fn linear_equation(samples: &Samples, measured: Measured, offset: f64, rms: f64) -> f64 {
    const SMALLER: f64 = 1e-3;
    let small = Samples {
        t: samples.t.clone(),
        y: samples.y.iter().map(|y| SMALLER * (y - offset)).collect(),
        stop: samples.stop,
    };
    let swings = Swings::of(&small.t, &small.y);
    let decay = free_decay(&swings, small.len());
    let Some(begin) = starts(&swings, &decay, measured).first().copied() else { return f64::NAN };
    let moved =
        Samples { t: small.t.iter().map(|t| t - begin.anchor).collect(), y: small.y, stop: small.stop };
    let few = moved.thinned(f64::NEG_INFINITY, f64::INFINITY, MOST);
    let of = |model: Model| {
        let reached = grown(&moved, measured, &begin, terms(model).len(), noise(&moved.y));
        let near = reached.rms() / SMALLER;
        // Far from the pendulum's there is no doubt.
        if near > 5.0 * rms {
            return near;
        }
        rung(&few, measured, model, &reached.values, false, CLOSE).outcome.rms() / SMALLER
    };
    of(Model::Linear).min(of(Model::Dry))
}

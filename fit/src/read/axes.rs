//! Sensors of three axes: the axis about which a gyroscope turned; the one along which an accelerometer moved.

use super::profile::Profile;

const GRAVITY: f64 = 9.80665;

/// The axis of the largest variance, and what the others have of it.
pub(super) fn turned(profiles: &[Profile]) -> Option<(usize, f64)> {
    let axis = (0..profiles.len()).max_by(|a, b| profiles[*a].variance.total_cmp(&profiles[*b].variance))?;
    let others = profiles.iter().enumerate().filter(|each| each.0 != axis);
    let most = others.map(|each| each.1.variance).fold(0.0, f64::max);
    Some((axis, (most / profiles[axis].variance).sqrt()))
}

/// The axis along the path, and the radial one if it shows: that one swings twice in a period, so its variance says nothing.
pub(super) fn moved(profiles: &[Profile]) -> Option<(usize, Option<usize>)> {
    let largest =
        (0..profiles.len()).max_by(|a, b| profiles[*a].mean.abs().total_cmp(&profiles[*b].mean.abs()));
    // With gravity in it the radial axis has a mean near 1 g, in whatever unit; without, it keeps one sign.
    let weighs = |k: &usize| {
        let mean = profiles[*k].mean.abs();
        [1.0, GRAVITY, 1000.0].iter().any(|g| mean > 0.6 * g && mean < 1.6 * g)
            && profiles[*k].variance.sqrt() < mean
    };
    let one_sign = |k: &usize| {
        let (least, most) = (profiles[*k].least, profiles[*k].most);
        let far = least.abs().max(most.abs());
        let deviation = profiles[*k].variance.sqrt();
        profiles[*k].count >= 20
            && far > 0.0
            && profiles[*k].mean.abs() > 0.5 * deviation
            && (least > -0.35 * far || most < 0.35 * far)
    };
    let radial = largest.filter(weighs).or_else(|| {
        (0..profiles.len())
            .filter(one_sign)
            .max_by(|a, b| profiles[*a].variance.total_cmp(&profiles[*b].variance))
    });
    let others = (0..profiles.len()).filter(|k| Some(*k) != radial);
    let axis = others.max_by(|a, b| profiles[*a].variance.total_cmp(&profiles[*b].variance))?;
    Some((axis, radial))
}

/// The factor to m/s^2 by the mean of the radial axis, and the unit's name.
pub(super) fn acceleration_unit(radial: Option<&Profile>) -> (f64, &'static str) {
    match radial.map(|profile| profile.mean.abs()) {
        Some(mean) if mean > 300.0 => (GRAVITY * 1e-3, "mg"),
        Some(mean) if mean > 0.6 && mean < 2.0 => (GRAVITY, "g"),
        _ => (1.0, "m/s^2"),
    }
}

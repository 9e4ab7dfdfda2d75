//! What the approximations of the angle share: sine and cosine of a phase, the turning angle, and the way back into the
//! frame of the orbit.

use crate::elliptic::phase::{LAST_HALF_PERIOD, Phase, alternating};
use crate::float::series::long_sin_cos;
use crate::float::unnormalised::Unnormalised;
use crate::float::{Dd, PI, Scaled, series};
use crate::lanes::Lane;
use crate::pendulum::Orbit;
use crate::pendulum::state::{Frame, State};

/// Sine and cosine of pi f for |f| <= 1/2.
pub(super) fn half_turn(f: Dd) -> (Dd, Dd) {
    let size = f.abs();
    let (sine, cosine) = if size.hi > 0.25 {
        let (sine, cosine) = long_sin_cos((Dd::from(0.5) - size) * PI);
        (cosine, sine)
    } else {
        long_sin_cos(size * PI)
    };
    (if f.hi < 0.0 { -sine } else { sine }, cosine)
}

/// The same over lanes, as accurate.
#[inline(always)]
pub(super) fn half_turn_lanes<L: Lane>(f: Dd<L>) -> (Unnormalised<L>, Unnormalised<L>) {
    let one = L::splat(1.0);
    let sign = one.copysign(f.hi);
    let size = Unnormalised::from(f.scale(sign));
    let steep = L::splat(0.25).less(size.hi);
    let rest = Unnormalised::from_double(L::splat(0.5)) - size;
    let near = series::sine(Unnormalised::select(steep, rest, size) * Unnormalised::splat(PI));
    // At least 1/2: nothing cancels.
    let far = Unnormalised::from_double(one).minus_smaller(near.square()).root();
    (Unnormalised::select(steep, far, near).scale(sign), Unnormalised::select(steep, near, far))
}

/// Sine and cosine of pi (n + f) for a phase counted as whole and rest; `None` beyond 2^53 half turns.
pub(super) fn counted(phase: &Phase, t: f64) -> Option<(Dd, Dd)> {
    let (n, f) = phase.count(t, LAST_HALF_PERIOD);
    if f.hi.is_nan() {
        return None;
    }
    let (sine, cosine) = half_turn(f);
    let side = alternating(n);
    Some((sine.scale(side), cosine.scale(side)))
}

/// The angle in the frame of an orbit, from the canonical one, which goes upwards through 0 at phase 0.
pub(super) fn framed(frame: &Frame, canonical: Scaled) -> f64 {
    let angle = canonical * frame.side;
    if frame.base.hi == 0.0 && frame.half_turn == 0.0 {
        return angle.value();
    }
    (frame.base + PI * frame.half_turn + angle.to_dd()).value()
}

/// The turning angle of a libration, to all digits of a double-double.
pub(super) fn turning_angle(orbit: &Orbit) -> Scaled {
    match orbit.state {
        Some(State { k, power, .. }) if power != 0 => Scaled::new(k, power + 1),
        Some(State { k, kc, .. }) => Scaled::new(series::angle(k.into(), kc.into()).to_dd(), 1),
        None => Scaled::ZERO,
    }
}

//! A state of its own in every lane, in units of omega0 = 1: sine and cosine of half the angle, velocity/2 omega0, kappa^2 and
//! 1 - kappa^2, in double-double as chains of sums that are not normalised.
//!
//! theta = pi j + rest: for even j the sine of theta/2 is small, for odd j the cosine is, and the small one keeps its digits.
//! Source: as state.rs.

use crate::elliptic::phase::alternating;
use crate::float::angle_reduction::half_turns;
use crate::float::series;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::Lane;

/// (theta, velocity) of every lane.
pub(super) struct StateLanes<L: Lane> {
    /// Half turns nearest to the angle, and -1 where they are odd.
    pub half_turns: L,
    pub parity: L,
    /// Sine of half the rest of the angle, with its sign, and the square of the cosine.
    pub sine: Unnormalised<L>,
    pub high: Unnormalised<L>,
    /// sin^2 and cos^2 of half the angle.
    pub s_square: Unnormalised<L>,
    pub c_square: Unnormalised<L>,
    /// velocity/2 omega0, its square, and 2 omega0.
    pub x: Unnormalised<L>,
    pub x_square: Unnormalised<L>,
    pub speed: Unnormalised<L>,
    /// kappa^2 and 1 - kappa^2, negative in rotation.
    pub m: Unnormalised<L>,
    pub mc: Unnormalised<L>,
}

impl<L: Lane> StateLanes<L> {
    /// For |theta| below [`FAR`](crate::float::angle_reduction::FAR).
    #[inline(always)]
    pub fn new(theta: L, velocity: L, omega: Unnormalised<L>) -> Self {
        let one = Unnormalised::from_double(L::splat(1.0));
        let (half_turns, rest) = half_turns(theta);
        let parity = alternating(half_turns);
        let even = L::splat(0.0).less(parity);
        let sine = series::sine(Unnormalised::from(rest.scale(L::splat(0.5))));
        let low = sine.square();
        let high = one.minus_smaller(low);
        let (s_square, c_square) =
            (Unnormalised::select(even, low, high), Unnormalised::select(even, high, low));
        let speed = omega.scale(L::splat(2.0));
        let x = Unnormalised::from_double(velocity).over(speed);
        let x_square = x.square();
        let (m, mc) = (s_square + x_square, Unnormalised::from((c_square - x_square).ordered()));
        StateLanes { half_turns, parity, sine, high, s_square, c_square, x, x_square, speed, m, mc }
    }
}

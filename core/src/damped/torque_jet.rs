//! The Taylor coefficients of the torque, and the phase of its sinusoid from step to step.

use super::taylor::{INVERSE, LONG, ORDER, double, number, on_circle};
use crate::float::Dd;
use crate::float::unnormalised::Unnormalised;
use crate::lanes::{Kernel, Lane, single};

/// The Taylor coefficients of the torque at a time.
#[derive(Clone, Debug)]
pub(super) struct TorqueJet {
    /// Their high words, and the low words of the first.
    pub hi: [f64; ORDER],
    pub lo: [f64; LONG],
}

impl TorqueJet {
    pub const ZERO: TorqueJet = TorqueJet { hi: [0.0; ORDER], lo: [0.0; LONG] };

    pub fn add(&mut self, k: usize, value: Dd) {
        if k < LONG {
            let sum = Dd::new(self.hi[k], self.lo[k]) + value;
            (self.hi[k], self.lo[k]) = (sum.hi, sum.lo);
        } else {
            self.hi[k] += value.value();
        }
    }
}

/// The coefficients of a torque A cos(phase) from the sine and cosine of the phase and from A frequency^k/k!.
pub(super) fn driven(sine: Dd, cosine: Dd, powers: &TorqueJet) -> TorqueJet {
    single(Drive { sine, cosine, powers })
}

struct Drive<'a> {
    sine: Dd,
    cosine: Dd,
    powers: &'a TorqueJet,
}

impl Kernel for Drive<'_> {
    type Output = TorqueJet;
    type Place = TorqueJet;
    #[inline(always)]
    fn run<L: Lane>(self) -> TorqueJet {
        let Drive { sine, cosine, powers } = self;
        let turns = [cosine, -sine, -cosine, sine];
        let mut jet = TorqueJet::ZERO;
        let mut k = 0;
        while k < ORDER {
            let turn = Unnormalised::<L>::splat(turns[k % 4]);
            if k < LONG {
                let power = Unnormalised::new(L::splat(powers.hi[k]), L::splat(powers.lo[k]));
                let value = number(turn * power);
                (jet.hi[k], jet.lo[k]) = (value.hi, value.lo);
            } else {
                jet.hi[k] = (turn.hi * L::splat(powers.hi[k])).first();
            }
            k += 1;
        }
        jet
    }
}

/// The largest angle of [`rotated`].
pub(super) const LARGEST_ROTATION: f64 = 2.0;

/// Sine and cosine of a phase that has grown by `angle`, from those before.
pub(super) fn rotated(sine: Dd, cosine: Dd, angle: Dd) -> (Dd, Dd) {
    single(Rotation { sine, cosine, angle })
}

struct Rotation {
    sine: Dd,
    cosine: Dd,
    angle: Dd,
}

/// 1 - square/(n (n + 1)) rest.
#[inline(always)]
fn nested<L: Lane>(square: Unnormalised<L>, n: usize, rest: Unnormalised<L>) -> Unnormalised<L> {
    let inverse = Unnormalised::splat(INVERSE[n]) * Unnormalised::splat(INVERSE[n + 1]);
    double::<L>(1.0) - square * inverse * rest
}

impl Kernel for Rotation {
    type Output = (Dd, Dd);
    type Place = TorqueJet;
    #[inline(always)]
    fn run<L: Lane>(self) -> (Dd, Dd) {
        // Taylor's series of a quarter of the angle, at most 1/2, whose terms below 2^-15 need one word; doubled twice.
        let quarter = Unnormalised::<L>::splat(self.angle).scale(L::splat(0.25));
        let square = quarter.square();
        let one = L::splat(1.0);
        let (mut odd, mut even) = (one, one);
        let mut n = 18;
        while n > 8 {
            n -= 2;
            odd = one - square.hi * L::splat(INVERSE[n].hi * INVERSE[n + 1].hi) * odd;
            even = one - square.hi * L::splat(INVERSE[n + 1].hi * INVERSE[n + 2].hi) * even;
        }
        let (odd, even) = (Unnormalised::from_double(odd), Unnormalised::from_double(even));
        let odd = nested(square, 2, nested(square, 4, nested(square, 6, odd)));
        let even = nested(square, 1, nested(square, 3, nested(square, 5, nested(square, 7, even))));
        let (mut sine, mut cosine) = (quarter * odd, even);
        let mut doubled = 0;
        while doubled < 2 {
            let next = (sine * cosine).scale(L::splat(2.0));
            cosine = double::<L>(1.0) - sine.square().scale(L::splat(2.0));
            sine = next;
            doubled += 1;
        }
        let (old_sine, old_cosine) = (Unnormalised::splat(self.sine), Unnormalised::splat(self.cosine));
        let mut new_sine = old_sine * cosine + old_cosine * sine;
        let mut new_cosine = old_cosine * cosine - old_sine * sine;
        on_circle(&mut new_sine, &mut new_cosine);
        (number(new_sine), number(new_cosine))
    }
}

#[cfg(test)]
mod tests {
    use super::super::circular::circular;
    use super::*;

    /// Rotations add up to the angle, with no more than their rounding.
    #[test]
    fn rotations_keep_the_phase() {
        for angle in [1e-9, 0.3, -0.77, 1.1, 1.999, -2.0] {
            let (mut sine, mut cosine) = (Dd::ZERO, Dd::ONE);
            let step = Dd::new(angle, 1e-20);
            for i in 1..=200 {
                (sine, cosine) = rotated(sine, cosine, step);
                let truth = circular(step * f64::from(i));
                assert!(
                    (sine - truth.0).hi.abs() < 1e-19 && (cosine - truth.1).hi.abs() < 1e-19,
                    "{angle} {i}"
                );
            }
        }
    }
}

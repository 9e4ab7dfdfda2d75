//! The equation of motion in its own unit of time: a power of two of a second in which no rate is much above 1, so nothing
//! leaves the range of the doubles. Time may run backward: `sense` is -1 there, and friction drives.
//!
//! v' = -omega2 s - linear v - quadratic |v| v - dry sgn v (1 - u) + torque, with s, c = sin, cos theta;
//! u = 1 - z sgn v is what presliding leaves out of dry friction, u' = -|v| u/presliding (friction.rs).

use super::circular::circular;
use super::friction::Friction;
use super::jet::Piece;
use super::taylor::{INVERSE, ORDER};
use super::torque::{Samples, TORQUES, Torque};
use super::torque_jet::{LARGEST_ROTATION, TorqueJet, driven};
use crate::float::Dd;
use crate::float::exponent::{exponent, ldexp};
use crate::pendulum::Frequency;
use std::sync::Arc;

/// All constants, in the unit of time 2^-power s, for one sense of time.
#[derive(Clone, Debug)]
pub(super) struct Equation {
    /// Rates are divided by 2^power.
    pub power: i32,
    /// 1, or -1 where time runs backward.
    pub sense: f64,
    pub omega2: Dd,
    /// 2 gamma, beta and mu, each times the sense.
    pub linear: f64,
    pub quadratic: f64,
    pub dry: f64,
    /// In rad; 0 where dry friction changes sign at once, or is none.
    pub presliding: f64,
    pub constant: f64,
    pub amplitude: f64,
    pub frequency: f64,
    pub phase: f64,
    /// Sine and cosine of the phase at t = 0.
    at_start: (Dd, Dd),
    /// Coefficients amplitude frequency^k/k!.
    powers: TorqueJet,
    samples: Option<Arc<Samples>>,
}

impl Equation {
    pub fn new(
        velocity0: f64,
        frequency: Frequency,
        friction: Friction,
        torque: &Torque,
        sense: f64,
    ) -> Equation {
        let root = frequency.root();
        let half = |value: f64| if value == 0.0 { i32::MIN } else { (exponent(value) + 1).div_euclid(2) };
        let whole = |value: f64| if value == 0.0 { i32::MIN } else { exponent(value) };
        let power = [
            root.map_or(i32::MIN, |(_, power)| power),
            whole(velocity0),
            whole(friction.linear()),
            half(friction.dry()),
            half(torque.constant()),
            half(torque.driving_amplitude()),
            half(torque.samples.as_ref().map_or(0.0, |samples| samples.largest())),
        ]
        .into_iter()
        .max()
        .filter(|power| *power != i32::MIN)
        .unwrap_or(0);
        let omega2 = match root {
            Some((root, own)) => {
                let square = root.square().to_dd().ldexp(2 * (own - power));
                if frequency.upside_down() { -square } else { square }
            }
            None => Dd::ZERO,
        };
        let amplitude = ldexp(torque.driving_amplitude(), -2 * power);
        let driving = sense * ldexp(torque.frequency(), -power);
        let mut powers = TorqueJet::ZERO;
        let mut factor = Dd::from(amplitude);
        for k in 0..if TORQUES { ORDER } else { 0 } {
            powers.add(k, factor);
            factor = factor * driving * INVERSE[k + 1];
        }
        Equation {
            power,
            sense,
            omega2,
            linear: 2.0 * sense * ldexp(friction.linear(), -power),
            quadratic: sense * friction.quadratic(),
            dry: sense * ldexp(friction.dry(), -2 * power),
            presliding: if friction.dry() == 0.0 { 0.0 } else { friction.presliding() },
            constant: ldexp(torque.constant(), -2 * power),
            amplitude,
            frequency: driving,
            phase: torque.phase(),
            at_start: if TORQUES { circular(Dd::from(torque.phase())) } else { (Dd::ZERO, Dd::ONE) },
            powers,
            samples: torque.samples.clone(),
        }
    }

    /// A time in the unit and sense of the equation, exactly.
    pub fn time(&self, seconds: f64) -> f64 {
        self.sense * ldexp(seconds, self.power)
    }
    /// A time in s.
    pub fn seconds(&self, time: f64) -> f64 {
        ldexp(self.sense * time, -self.power)
    }

    /// Sine and cosine of the phase of the sinusoid.
    pub fn sinusoid(&self, time: Dd) -> (Dd, Dd) {
        if !TORQUES || self.frequency == 0.0 {
            return self.at_start;
        }
        circular(time * self.frequency + Dd::from(self.phase))
    }

    /// The longest step that the sinusoid allows.
    pub fn longest(&self) -> f64 {
        if !TORQUES || self.amplitude == 0.0 {
            f64::INFINITY
        } else {
            LARGEST_ROTATION / self.frequency.abs()
        }
    }

    /// Whether the torque is another one at other times.
    pub fn varies(&self) -> bool {
        TORQUES && (self.amplitude != 0.0 || self.samples.is_some())
    }

    /// The torque's coefficients at a time, with the sine and cosine of its sinusoid; those of samples of the piece that lies
    /// ahead.
    pub fn torque(&self, time: Dd, [sine, cosine]: [Dd; 2]) -> TorqueJet {
        if !TORQUES {
            return TorqueJet::ZERO;
        }
        let mut jet =
            if self.amplitude == 0.0 { TorqueJet::ZERO } else { driven(sine, cosine, &self.powers) };
        if self.constant != 0.0 {
            jet.add(0, Dd::from(self.constant));
        }
        if let Some(samples) = &self.samples {
            let at = time.scale(self.sense).ldexp(-self.power);
            let i = self.piece(samples, at.value());
            let since = at - Dd::from(samples.times[i]);
            let [a, b, c, d] = samples.pieces[i];
            let shifted = [
                a + since * (b + since * (c + since * d)),
                b + since * (c.scale(2.0) + since * d * 3.0),
                c + since * d * 3.0,
                d,
            ];
            let mut sign = 1.0;
            for (k, value) in shifted.into_iter().enumerate() {
                jet.add(k, value.scale(sign).ldexp(-(k as i32 + 2) * self.power));
                sign *= self.sense;
            }
        }
        jet
    }

    /// Where the polynomial of the samples at `time` ends; infinite without samples.
    pub fn next_knot(&self, time: Dd) -> f64 {
        let Some(samples) = self.samples.as_ref().filter(|_| TORQUES) else { return f64::INFINITY };
        let i = self.piece(samples, self.seconds(time.value()));
        let forward = self.sense > 0.0;
        self.time(if forward { samples.times[i + 1] } else { samples.times[i] })
    }

    /// The piece of samples that lies ahead of a time in s.
    fn piece(&self, samples: &Samples, seconds: f64) -> usize {
        if self.sense > 0.0 { samples.piece_from(seconds) } else { samples.piece_to(seconds) }
    }

    /// Torque and gravity, without friction.
    pub fn pull(&self, time: Dd, sinusoid: [Dd; 2], sine: Dd) -> Dd {
        let torque = self.torque(time, sinusoid);
        Dd::new(torque.hi[0], torque.lo[0]) - self.omega2 * sine
    }

    /// The constants of the piece on which the velocity has this side.
    pub fn piece_of(&self, side: f64, settled: bool) -> Piece {
        Piece {
            omega2: self.omega2,
            linear: self.linear,
            quadratic: side * self.quadratic,
            dry: side * self.dry,
            slip: if settled { 0.0 } else { side / self.presliding },
        }
    }
}

//! The seven regimes of an oscillator u'' = -V'(u) with an even polynomial V.

/// What the energy and the start allow. Decided exactly, by signs of sums of products of what was given.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum OscillatorRegime {
    /// At an equilibrium: nothing moves.
    Rest,
    /// No force but -p u: cosine, hyperbolic functions or a straight line.
    Linear,
    /// Periodic and symmetric about u = 0.
    Libration,
    /// Periodic on one side of u = 0.
    Well,
    /// Leaves u = 0 and comes back to it, both in infinite time.
    Homoclinic,
    /// From one unstable equilibrium to another, in infinite time.
    Heteroclinic,
    /// Reaches infinity in finite time, forward, backward or both.
    Escape,
}

impl OscillatorRegime {
    /// Its name: `rest`, `linear`, `libration`, `well`, `homoclinic`, `heteroclinic` or `escape`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            OscillatorRegime::Rest => "rest",
            OscillatorRegime::Linear => "linear",
            OscillatorRegime::Libration => "libration",
            OscillatorRegime::Well => "well",
            OscillatorRegime::Homoclinic => "homoclinic",
            OscillatorRegime::Heteroclinic => "heteroclinic",
            OscillatorRegime::Escape => "escape",
        }
    }
}

impl core::fmt::Display for OscillatorRegime {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.pad(self.name())
    }
}

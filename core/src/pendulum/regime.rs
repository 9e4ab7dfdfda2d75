//! The four regimes of the pendulum.

/// What the energy allows. Decided without cancellation, so it is right a rounding error from the separatrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Regime {
    /// At the stable equilibrium (or anywhere, without force and velocity).
    Rest,
    /// Moves between two turning angles.
    Libration,
    /// Exactly the energy of the upper equilibrium: approaches it and never arrives.
    Separatrix,
    /// Turns over the top (or turns freely).
    Rotation,
}

impl Regime {
    /// `rest`, `libration`, `separatrix` or `rotation`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Regime::Rest => "rest",
            Regime::Libration => "libration",
            Regime::Separatrix => "separatrix",
            Regime::Rotation => "rotation",
        }
    }
}

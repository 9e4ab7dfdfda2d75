//! theta'' + omega0^2 sin theta = 0 from any initial state, in every regime.

pub mod advance;
mod canonical;
pub mod frequency;
mod harmonics;
pub mod motion;
pub mod orbit;
pub mod regime;
pub mod state;

pub use advance::advance;
pub use frequency::Frequency;
pub use orbit::Orbit;
pub use regime::Regime;

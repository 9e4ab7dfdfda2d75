//! theta'' + omega0^2 sin theta = 0 from any initial state, in every regime.

pub mod action;
pub mod advance;
mod arc;
mod canonical;
mod flow;
pub mod fourier;
pub mod frequency;
pub mod motion;
pub mod orbit;
pub mod regime;
mod rows;
pub mod second;
pub mod sensitivity;
mod slopes;
pub mod state;
pub mod states;
pub mod time;

pub use advance::{advance, advance_into};
pub use fourier::Fourier;
pub use frequency::Frequency;
pub use orbit::Orbit;
pub use regime::Regime;
pub use sensitivity::{Jacobian, Sensitivity};

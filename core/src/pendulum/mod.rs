//! theta'' + omega0^2 sin theta = 0 from any initial state, in every regime.

pub mod action;
mod addition_theorem;
pub mod advance;
mod batch;
pub mod fourier;
pub mod frequency;
mod interpolant;
pub mod motion;
pub mod orbit;
pub mod passages;
pub mod regime;
pub mod second_derivatives;
pub mod sensitivity;
mod sensitivity_lanes;
pub mod state;
pub mod states;
mod theta_quotients;

pub use advance::{advance, advance_into};
pub use fourier::Fourier;
pub use frequency::Frequency;
pub use orbit::Orbit;
pub use regime::Regime;
pub use sensitivity::{Jacobian, Sensitivity};

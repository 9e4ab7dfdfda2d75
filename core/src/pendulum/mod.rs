//! theta'' + omega0^2 sin theta = 0 from any initial state, in every regime.

pub mod action;
mod action_lanes;
mod addition_theorem;
pub mod advance;
mod batch;
mod canonical;
mod columns;
mod energies;
mod force_free;
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
mod separatrix;
pub mod state;
mod state_lanes;
pub(crate) mod theta_quotients;
mod turns;
mod variational;

pub use action_lanes::{action_into, frequency_into, period_into};
pub use advance::{advance, advance_into};
pub use batch::motion_into;
pub use fourier::Fourier;
pub use frequency::Frequency;
pub use orbit::Orbit;
pub use passages::Extremes;
pub use regime::Regime;
pub use second_derivatives::Hessians;
pub use sensitivity::{Jacobian, Sensitivity};
pub use turns::Turns;

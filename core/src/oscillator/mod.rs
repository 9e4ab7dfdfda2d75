//! The springs u'' + p u + r u^2 + q u^3 = c and u'' + p u + q u^3 + s u^5 = 0 from any start, in every regime.
//!
//! One theory: v = 1/u^2 obeys v'^2 = 4 C(v), C(v) = 2E v^3 - p v^2 - q v/2 - s/3, whose exact roots tell the
//! regime and the functions. [`Duffing`] is the case s = 0, with the twelve forms ([`DuffingForm`]) of its solution and its
//! relation to the pendulum ([`Companion`]).

mod addition_theorem;
pub mod batch;
mod clock;
pub mod companion;
pub mod cubic_quintic;
mod curve;
pub mod duffing;
mod elementary;
mod energy;
mod even_batch;
mod even_interpolant;
mod even_lanes;
mod even_motion;
mod even_passages;
mod even_poles;
mod even_powers;
mod even_rows;
mod even_start;
pub mod glaisher_forms;
mod harmonics;
mod hyperbolic_lanes;
mod interpolant;
mod knowledge;
mod mean;
pub mod motion;
mod nonzero_energy;
pub mod passages;
mod pq_elementary;
mod pq_quotient;
mod product;
mod quadratic;
mod quartic;
mod quintic_batch;
mod quintic_harmonics;
mod quintic_knowledge;
mod quintic_rows;
mod quintic_start;
mod quintic_starts;
mod quotient_factors;
pub mod regime;
mod riccati;
mod root_quotient;
mod roots;
mod scaled_theta;
mod set_up;
mod singularities;
mod starts;
mod swing_integrals;
mod swing_interval;
mod theta_motion;
mod variational;
mod zero_energy;

pub use batch::duffing_motion_into;
pub use companion::Companion;
pub use cubic_quintic::CubicQuintic;
pub use duffing::{Duffing, OscillatorFourier};
pub use even_batch::duffing_rows_into;
pub use glaisher_forms::DuffingForm;
pub use quintic_batch::cubic_quintic_rows_into;
pub use regime::OscillatorRegime;

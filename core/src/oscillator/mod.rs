//! The springs u'' + p u + q u^3 = 0 and u'' + alpha u + beta u^3 + gamma u^5 = 0 from any start, in every regime; the
//! twelve forms of the first one's solution, and its link to the pendulum.

mod argument;
pub mod batch;
pub mod companion;
mod cubic_arc;
mod cubic_course;
mod cubic_limits;
pub mod cubic_motion;
mod cubic_phase;
mod cubic_plain;
pub mod cubic_quintic;
pub mod cubic_time;
pub mod duffing;
mod elementary;
mod elementary_lanes;
pub mod glaisher_forms;
pub mod motion;
pub mod passages;
mod quintic_exact;
pub mod regime;
mod roots;
mod set_up;
mod singularities;
mod theta_quotients;
mod zero_energy;
mod zero_energy_lanes;

pub use batch::duffing_motion_into;
pub use companion::Companion;
pub use cubic_quintic::CubicQuintic;
pub use duffing::Duffing;
pub use glaisher_forms::Form;
pub use regime::Regime;

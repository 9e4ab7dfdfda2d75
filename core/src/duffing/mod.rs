//! The springs u'' + p u + q u^3 = 0 and u'' + alpha u + beta u^3 + gamma u^5 = 0 from any start, in every regime; the
//! twelve forms of the first one's solution, and its link to the pendulum.

pub mod cubic;
mod cubic_arc;
mod cubic_course;
mod cubic_limits;
pub mod cubic_motion;
mod cubic_phase;
mod cubic_plain;
pub mod cubic_quintic;
pub mod cubic_states;
pub mod cubic_time;
mod drawing;
mod flight;
pub mod forms;
pub mod link;
mod quintic_arc;
mod quintic_course;
mod quintic_edge;
mod quintic_exact;
mod quintic_hyperbolic;
mod quintic_level;
mod quintic_marks;
pub mod quintic_motion;
mod quintic_plain;
mod quintic_roots;
mod quintic_theta;
pub mod quintic_time;
pub mod regime;
mod swing;

pub use cubic::Duffing;
pub use cubic_quintic::CubicQuintic;
pub use cubic_states::duffing_motion_into;
pub use forms::Form;
pub use link::Companion;
pub use regime::Regime;

//! Many pendulums at once: random numbers by particle, whole turns, steps one after the other, and sums without the states.
//!
//! Nothing here asks for memory that grows with the particles, and nothing depends on how particles are cut into blocks but the last
//! bits of sums.

mod exponential;
mod histogram;
mod moments;
mod philox;
mod steps;
mod turns;

pub use exponential::exponential_into;
pub use histogram::{Bins, histogram_into};
pub use moments::{Moments, moments};
pub use philox::uniforms_into;
pub use steps::{Steps, steps_into};
pub use turns::wrap_into;

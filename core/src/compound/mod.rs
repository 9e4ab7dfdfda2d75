//! The rigid pendulum of several parts: its equivalent length, what air and wire do to its period, and the reversible pendulum.

mod corrections;
mod parts;
mod reversible;

pub use corrections::{added_mass, bob_size, buoyancy, wire_mass};
pub use parts::{Compound, Part, Shape};
pub use reversible::reversible_gravity;

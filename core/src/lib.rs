//! The exact nonlinear pendulum theta'' + omega0^2 sin theta = 0 from any initial state, and the elliptic
//! functions it needs: in every regime, right to the last digits a billion periods away and a rounding error
//! from the separatrix.
//!
//! | wanted | here |
//! |---|---|
//! | angle, velocity, period ... of one orbit | [`Orbit`] |
//! | an orbit by its energy, turning angle or period | [`OrbitStart`] |
//! | the force: omega0, its square, or gravity and length | [`Frequency`] |
//! | passages, action, phase, Fourier series of an orbit | [`Orbit`] |
//! | its derivatives by start and force | [`Sensitivity`] |
//! | one state a step later | [`advance()`] |
//! | many particles: random numbers, steps, whole turns, sums | [`ensemble`] |
//! | u'' + p u + q u^3 = 0 | [`Duffing`] |
//! | u'' + p u + q u^3 + s u^5 = 0 | [`CubicQuintic`] |
//! | friction and torque: the motion over an interval | [`DampedPendulum`], [`Friction`], [`Torque`], [`Trajectory`] |
//! | its derivatives | [`DampedSensitivity`] |
//! | inertia and length of a rigid pendulum, corrections of its period | [`compound`] |
//! | approximations by name, and how far they are off | [`approx`] |
//! | sn, cn, dn, am; all twelve | [`Jacobi`], [`Glaisher`] |
//! | the twelve inverses | [`inverse_jacobi`] |
//! | the twelve of complex u | [`JacobiComplex`] |
//! | Jacobi's epsilon and zeta | [`SecondKind`] |
//! | theta functions | [`Theta`] |
//! | K, E, F | [`complete_k`], [`complete_e`], [`incomplete_f`], [`incomplete_e`] |
//! | nome, and back | [`nome`], [`parameter_of_nome`] |
//! | Pi, Heuman's lambda | [`complete_pi`], [`incomplete_pi`], [`heuman_lambda`] |
//! | Carlson's R_F, R_C, R_D, R_J | [`carlson_rf`], [`carlson_rc`], [`carlson_rd`], [`carlson_rj`] |
//!
//! SI units and radians everywhere. Scalars out of domain give NaN; constructors give a [`Domain`] error.

pub mod approx;
pub mod compound;
pub mod damped;
pub mod elliptic;
pub mod ensemble;
mod float;
mod lanes;
mod motion;
pub mod oscillator;
pub mod pendulum;

mod domain;
mod sorting;

pub use compound::{Compound, Part, Shape};
pub use damped::{
    DampedJacobian, DampedPendulum, DampedSensitivity, Friction, Interpolation, Torque, Trajectory,
    half_swing,
};
pub use domain::Domain;
pub use elliptic::{
    Complex, Glaisher, Jacobi, JacobiComplex, JacobiComplexValues, JacobiValues, Parameter, SecondKind,
    Theta, ThetaFunction, carlson_rc, carlson_rd, carlson_rf, carlson_rj, complete_e, complete_k,
    complete_pi, heuman_lambda, incomplete_e, incomplete_f, incomplete_pi, inverse_jacobi, nome,
    parameter_of_nome,
};
pub use lanes::InstructionSet;
pub use oscillator::{Companion, CubicQuintic, Duffing, DuffingForm, OscillatorFourier, OscillatorRegime};
pub use pendulum::frequency::STANDARD_GRAVITY;
pub use pendulum::{
    Extremes, Fourier, Frequency, Hessians, Jacobian, Orbit, OrbitStart, Regime, Sensitivity, StartAngle,
    StartMotion, Turns, advance, advance_into,
};

/// Version of the core, and of everything built on it.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

// The example of the README runs with those of the documentation. Only there: a packaged crate has no README above it.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
mod readme {}

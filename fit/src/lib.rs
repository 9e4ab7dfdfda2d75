//! From a file of measurements to a pendulum's record: what the tools of a laboratory write, read without a choice made in
//! silence.
//!
//! [`read`] takes the bytes of a file, its name and what the user states; it gives a [`Record`] that says what was
//! understood and what was left out, or a [`Refusal`] of one line. It opens no file and resamples nothing.

pub mod read;

pub use read::{
    Kind, Options, Quantity, Record, Refusal, Role, Series, Unread, Values, Wanted, column, read,
};

//! From a file of measurements to g with an honest uncertainty.
//!
//! [`read`](read()) takes the bytes of a file, its name and what the user states; it gives a [`Record`] that says what was
//! understood and what was left out, or a [`Refusal`] of one line. It opens no file and resamples nothing.
//! [`fit()`](fit::fit) takes columns of a record and what is known beside it; it gives a [`Fit`](fit::Fit), or a
//! [`FitRefusal`](fit::FitRefusal) of one line.

mod decimal;
mod digits;
pub mod fit;
mod from_record;
mod gravity;
mod letters;
mod order;
mod product;
pub mod read;

pub use from_record::data;
pub use gravity::{PeriodGravity, gravity_of_decay, gravity_of_period, normal_gravity};
pub use read::{
    Kind, Options, Quantity, Record, Refusal, Role, Series, Unread, Values, Wanted, column, read,
};

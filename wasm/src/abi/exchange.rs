//! What the functions of every module that JavaScript calls have in common: the places of the workspace, refusals, and answers
//! row by row. A file of two crates: the module of springs and friction (wasm/motions) has it too.

use crate::objects::{Place, keep};
use crate::workspace::{self, ROWS, leave, say, with_columns};
use libration::{Domain, Frequency};

/// Address of the columns.
#[unsafe(no_mangle)]
pub extern "C" fn columns() -> *const f64 {
    workspace::columns()
}

/// Doubles in a column.
#[unsafe(no_mangle)]
pub extern "C" fn rows() -> usize {
    ROWS
}

/// Address of the list.
#[unsafe(no_mangle)]
pub extern "C" fn list() -> *const f64 {
    workspace::list()
}

/// Address of the text.
#[unsafe(no_mangle)]
pub extern "C" fn text() -> *const u8 {
    workspace::text()
}

/// Bytes of the text.
#[unsafe(no_mangle)]
pub extern "C" fn text_length() -> usize {
    workspace::text_length()
}

/// Makes the text so many bytes long, to be written; its address.
#[unsafe(no_mangle)]
pub extern "C" fn text_room(length: usize) -> *const u8 {
    workspace::room(length)
}

/// Leaves a refusal in the text.
pub fn refuse(Domain { argument, given, allowed }: &Domain) {
    say([argument, given.as_str(), allowed.as_ref()].join("\n"));
}

/// The frequency of omega0, omega2, length and gravity. Those count whose bit is set in `given`: 1, 2, 4, 8 in their order.
pub fn frequency(arguments: [f64; 4], given: u32) -> Result<Frequency, Domain> {
    let [omega0, omega2, length, gravity] =
        [0, 1, 2, 3].map(|place| (given >> place & 1 == 1).then_some(arguments[place]));
    Frequency::from_arguments(omega0, omega2, length, gravity)
}

/// The number of a new object, or 0.
pub fn made<T>(place: &'static Place<T>, object: Result<T, Domain>) -> u32 {
    object.map_or_else(|domain| (refuse(&domain), 0).1, |object| keep(place, object))
}

/// The length of a list, or -1.
pub fn listed(list: Result<Vec<f64>, Domain>) -> i32 {
    list.map_or_else(|domain| (refuse(&domain), -1).1, leave)
}

/// One answer for each argument, into column 1.
pub fn each(rows: usize, answer: impl Fn(f64) -> f64) {
    with_columns(|[argument, result, ..]| {
        for (argument, result) in argument.iter().zip(result).take(rows) {
            *result = answer(*argument);
        }
    });
}

/// Two answers for each argument, into columns 1 and 2.
pub fn both(rows: usize, answer: impl Fn(f64) -> [f64; 2]) {
    with_columns(|[argument, first, second, ..]| {
        for ((argument, first), second) in argument.iter().zip(first).zip(second).take(rows) {
            [*first, *second] = answer(*argument);
        }
    });
}

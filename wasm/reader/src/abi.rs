//! The functions that JavaScript calls. `unsafe` stands here and in the files beside it only, in the attributes that give functions
//! their names outside and in the call of JavaScript's function. No pointer is read.

#[path = "../../fit/src/abi/exchange.rs"]
mod exchange;
#[path = "../../fit/src/abi/number.rs"]
pub mod number;

use crate::answer;
use crate::stated::Stated;
use exchange::{BYTES, left, stated, taken};

/// Reads the file. 1: the answer is what was understood, in JSON, with its columns; 0: the refusal. The bytes are let go.
#[unsafe(no_mangle)]
pub extern "C" fn read_file() -> u32 {
    let bytes = taken(BYTES);
    left(Stated::of(&stated()).and_then(|stated| answer::read(&bytes, &stated)))
}

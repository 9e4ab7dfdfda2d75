//! The functions that JavaScript calls. `unsafe` stands here and in the files beside it only, in the attributes that give functions
//! their names outside and in the call of JavaScript's function. No pointer is read.

#[path = "../../fit/src/abi/exchange.rs"]
#[allow(dead_code, reason = "nothing has bytes here")]
mod exchange;
#[path = "../../fit/src/abi/number.rs"]
pub mod number;

use crate::period;
use exchange::{left, stated};

/// g from a period, and that of a place (period.rs). 1: the answer is in JSON; 0: the refusal.
#[unsafe(no_mangle)]
pub extern "C" fn gravity() -> u32 {
    left(period::gravity(&stated()).map(|answer| (answer, Vec::new())))
}

//! The functions that JavaScript calls. `unsafe` stands here and in the files beside it only: in the attributes that give functions
//! their names outside, and in the calls of JavaScript's functions. No pointer is read.

pub mod exchange;
pub mod number;
pub mod steps;

use crate::answer;
use crate::stated::Stated;
use exchange::{BYTES, left, stated, taken};
use libration_fit::fit::{Data, FitOptions};
use std::cell::RefCell;

thread_local! {
    /// The columns that were given, of the record that is being given.
    static GIVEN: RefCell<Vec<Vec<f64>>> = const { RefCell::new(Vec::new()) };
    /// The records: one, or those that are fitted together.
    static DATA: RefCell<Vec<Data>> = const { RefCell::new(Vec::new()) };
}

/// Takes the doubles that were written as the next column of a record.
#[unsafe(no_mangle)]
pub extern "C" fn give_column() {
    let bytes = taken(BYTES);
    let (doubles, _) = bytes.as_chunks();
    let column = doubles.iter().map(|each| f64::from_le_bytes(*each)).collect();
    GIVEN.with_borrow_mut(|given| given.push(column));
}

/// Takes the columns that were given as a record, beside those before or instead of them. 1: they are one; 0: the refusal.
#[unsafe(no_mangle)]
pub extern "C" fn give_record() -> u32 {
    let columns = GIVEN.take();
    left(Stated::of(&stated()).and_then(|stated| {
        let data = stated.record(columns)?;
        DATA.with_borrow_mut(|all| {
            if !stated.beside {
                all.clear();
            }
            all.push(data);
        });
        Ok((String::new(), Vec::new()))
    }))
}

/// Fits what was given: one record, or several together. 1: the answer is the result, in JSON, with its columns; 0: the refusal.
#[unsafe(no_mangle)]
pub extern "C" fn fit_data() -> u32 {
    left(Stated::of(&stated()).and_then(|stated| {
        DATA.with_borrow(|all| match &all[..] {
            [] => Err("no file was read".to_owned()),
            [data] => answer::fitted(data, &stated),
            _ => answer::together(all, &stated),
        })
    }))
}

/// Leaves the names of the steps of a fit in the answer, each on a line.
#[unsafe(no_mangle)]
pub extern "C" fn steps() {
    left(Ok((FitOptions::STEPS.join("\n"), Vec::new())));
}

//! The functions that JavaScript calls, and the one of JavaScript that is called. `unsafe` stands in this file only: in the
//! attributes that give functions their names outside, and in that call. No pointer is read.

use crate::answer;
use crate::period;
use crate::stated::Stated;
use libration_fit::fit::{Data, FitOptions};
use std::cell::RefCell;

thread_local! {
    /// The bytes of the file, what is stated, the answer.
    static TEXTS: [RefCell<Vec<u8>>; 3] = const { [const { RefCell::new(Vec::new()) }; 3] };
    /// The records that were read: one, or those that are fitted together.
    static DATA: RefCell<Vec<Data>> = const { RefCell::new(Vec::new()) };
}

const FILE: usize = 0;
const STATED: usize = 1;
const ANSWER: usize = 2;

#[cfg(target_arch = "wasm32")]
#[link(wasm_import_module = "page")]
unsafe extern "C" {
    /// Told at the begin of each step of a fit: its number in `FitOptions::STEPS`.
    fn step(number: usize);
}

/// Tells the page which step of a fit begins.
fn tell(begins: &'static str) {
    let Some(number) = FitOptions::STEPS.iter().position(|each| *each == begins) else { return };
    #[cfg(target_arch = "wasm32")]
    // SAFETY: the page reads one whole number.
    unsafe {
        step(number);
    }
    #[cfg(not(target_arch = "wasm32"))]
    let _ = number;
}

/// Makes a text so many bytes long, to be written; its address. 0 is the file, 1 what is stated about it.
#[unsafe(no_mangle)]
pub extern "C" fn room(text: usize, length: usize) -> *const u8 {
    TEXTS.with(|texts| {
        let Some(text) = texts.get(text) else { return core::ptr::null() };
        let mut text = text.borrow_mut();
        text.clear();
        text.resize(length, 0);
        text.as_ptr()
    })
}

/// Address of the answer.
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> *const u8 {
    TEXTS.with(|texts| texts[ANSWER].borrow().as_ptr())
}

/// Bytes of the answer.
#[unsafe(no_mangle)]
pub extern "C" fn answer_length() -> usize {
    TEXTS.with(|texts| texts[ANSWER].borrow().len())
}

/// Reads the file. 1: the answer is what was understood, in JSON; 0: the refusal. The bytes are let go.
#[unsafe(no_mangle)]
pub extern "C" fn read_file() -> u32 {
    let bytes = taken(FILE);
    left(stated().and_then(|stated| {
        let (data, json) = answer::read(&bytes, &stated)?;
        DATA.with_borrow_mut(|all| {
            if !stated.beside {
                all.clear();
            }
            all.push(data);
        });
        Ok(json)
    }))
}

/// Fits what was read: one record, or several together. 1: the answer is the result, in JSON; 0: the refusal.
#[unsafe(no_mangle)]
pub extern "C" fn fit_data() -> u32 {
    left(stated().and_then(|stated| {
        DATA.with_borrow(|all| match &all[..] {
            [] => Err("no file was read".to_owned()),
            [data] => answer::fitted(data, &stated),
            _ => answer::together(all, &stated),
        })
    }))
}

/// g from a period, and that of a place (period.rs). 1: the answer is in JSON; 0: the refusal.
#[unsafe(no_mangle)]
pub extern "C" fn gravity() -> u32 {
    left(period::gravity(&String::from_utf8_lossy(&taken(STATED))))
}

/// Leaves the names of the steps of a fit in the answer, each on a line.
#[unsafe(no_mangle)]
pub extern "C" fn steps() {
    left(Ok(FitOptions::STEPS.join("\n")));
}

fn taken(text: usize) -> Vec<u8> {
    TEXTS.with(|texts| texts[text].take())
}

fn stated() -> Result<Stated, String> {
    Stated::of(&String::from_utf8_lossy(&taken(STATED)), tell)
}

fn left(answer: Result<String, String>) -> u32 {
    let kept = u32::from(answer.is_ok());
    let text = answer.unwrap_or_else(|refusal| refusal);
    TEXTS.with(|texts| texts[ANSWER].replace(text.into_bytes()));
    kept
}
